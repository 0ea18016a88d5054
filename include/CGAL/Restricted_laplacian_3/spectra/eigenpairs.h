// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_EIGENPAIRS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_EIGENPAIRS_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/solvers/internal/connected_components.h>

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#ifdef CGAL_RESTRICTED_LAPLACIAN_3_USE_CHOLMOD
#include <Eigen/CholmodSupport>
#endif

#include <Spectra/SymEigsSolver.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numeric>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Solvers
/// Some eigenpairs \f$S x = \lambda M x\f$.
struct Eigenpairs {
  /// ascending
  Eigen::VectorXd values;
  /// one column for each value, \f$x^T M x = 1\f$; of the two signs the one that makes the entry of
  /// largest absolute value positive
  Eigen::MatrixXd vectors;
  /// \f$ \|S x - \lambda M x\|_2 / \|(S - \sigma M) x\|_2 \f$ for each pair
  Eigen::VectorXd residuals;
  /// whether all requested pairs were found to the tolerance; if not, `values` holds those that
  /// were
  bool converged = false;
  /// restarts of the Lanczos iteration, 0 if the problem was solved densely; of
  /// `multigrid_eigenpairs()`, iterations on the finest level
  int iterations = 0;
  /// \f$\sigma = -4 \pi / \sum_{ij} M_{ij}\f$, see `smallest_eigenpairs()`
  double shift = 0;
  /// \f$\tau\f$, see `smallest_eigenpairs()`; 0 for `multigrid_eigenpairs()`
  double regularization = 0;
};

/// \ingroup PkgRestrictedLaplacian3Solvers
/// What `smallest_eigenpairs()` does unless told otherwise.
struct Eigenpairs_options {
  /// of the eigenvalues, relative
  double tolerance = 1e-10;
  /// restarts of the Lanczos iteration after which it ends, converged or not
  int maximum_iterations = 1000;
  /// \f$\tau\f$ of the first attempt
  double regularization = 1e-12;
  /// is told about which part of the work is done, from 0 to 1; if it returns `false`, the
  /// computation ends with a `Canceled` exception
  std::function<bool(double)> callback;
};

namespace internal {

#ifdef CGAL_RESTRICTED_LAPLACIAN_3_USE_CHOLMOD
/// \f$P K P^T = L L^T\f$ by CHOLMOD. Eigen's interface offers the whole solve only.
class Sparse_cholesky : public Eigen::CholmodSupernodalLLT<Eigen::SparseMatrix<double>> {
public:
  /// By default CHOLMOD writes a warning to the standard output when a factorisation fails.
  Sparse_cholesky() { this->cholmod().print = 0; }

  /// \f$L^{-1} P b\f$
  Eigen::VectorXd solve_lower(const Eigen::VectorXd& b) const {
    return step(CHOLMOD_L, step(CHOLMOD_P, b));
  }
  /// \f$P^T L^{-T} b\f$
  Eigen::VectorXd solve_upper(const Eigen::VectorXd& b) const {
    return step(CHOLMOD_Pt, step(CHOLMOD_Lt, b));
  }

private:
  Eigen::VectorXd step(int system, Eigen::VectorXd b) const {
    // a solve changes only statistics and work space in there
    cholmod_common& common = const_cast<Sparse_cholesky*>(this)->cholmod();
    cholmod_dense view = Eigen::viewAsCholmod(b);
    cholmod_dense* x = cholmod_solve(system, this->m_cholmodFactor, &view, &common);
    if(!x)
      throw Numerical_error("CHOLMOD could not solve a triangular system");
    const Eigen::VectorXd result =
        Eigen::Map<const Eigen::VectorXd>(static_cast<const double*>(x->x), b.size());
    cholmod_free_dense(&x, &common);
    return result;
  }
};
#else
/// \f$P K P^T = L L^T\f$ by Eigen
class Sparse_cholesky : public Eigen::SimplicialLLT<Eigen::SparseMatrix<double>> {
public:
  /// \f$L^{-1} P b\f$
  Eigen::VectorXd solve_lower(const Eigen::VectorXd& b) const {
    return this->matrixL().solve(this->permutationP() * b);
  }
  /// \f$P^T L^{-T} b\f$
  Eigen::VectorXd solve_upper(const Eigen::VectorXd& b) const {
    return this->permutationPinv() * Eigen::VectorXd(this->matrixU().solve(b));
  }
};
#endif

/// The operator \f$C = R^{-T} M R^{-1}\f$ in the form that Spectra takes, where
/// \f$R^T R = K = S - \sigma M + \tau D\f$, \f$D = \mathrm{diag}(S - \sigma M)\f$, is factorised.
///
/// The eigenvalues \f$\nu = 1 / (\lambda - \sigma)\f$ of \f$C\f$ are those of \f$K^{-1} M\f$, the
/// eigenvectors \f$y = R x\f$ are orthogonal in the plain scalar product. An iteration with
/// \f$K^{-1} M\f$ in the scalar product of \f$M\f$ would break down, because \f$M\f$ is singular to
/// rounding: squared norms of near-kernel functions come out negative.
class Inverted_pencil {
public:
  using Scalar = double;

  /// called at each application of the operator
  std::function<void()> on_operation;

  /// largest \f$\tau\f$ that is tried; beyond, eigenvalues would lose more than half of their
  /// digits
  static constexpr double largest_regularization = 1e-8;

  Inverted_pencil(const Eigen::SparseMatrix<double>& s, const Eigen::SparseMatrix<double>& m,
                  double sigma, double tau)
    : m_mass(m), m_regularization(tau) {
    Eigen::SparseMatrix<double> k = s - sigma * m;
    if(k.diagonal().minCoeff() < -largest_regularization * k.diagonal().maxCoeff())
      throw Numerical_error("the shifted stiffness matrix has a negative diagonal entry");
    m_scale = k.diagonal().unaryExpr([](double d) { return d > 0 ? 1 / std::sqrt(d) : 0.; });
    // Scaled to a unit diagonal, so that tau is relative to each entry; an empty row gets a 1.
    for(int j = 0; j < k.cols(); ++j)
      for(Eigen::SparseMatrix<double>::InnerIterator i(k, j); i; ++i)
        i.valueRef() *= m_scale[i.row()] * m_scale[j];
    Eigen::SparseMatrix<double> identity(k.rows(), k.cols());
    identity.setIdentity();
    Eigen::SparseMatrix<double> empty_rows = identity;
    for(int j = 0; j < k.cols(); ++j)
      empty_rows.valuePtr()[j] = m_scale[j] == 0 ? 1 : 0;
    k += empty_rows;
    for(;; m_regularization *= 100) {
      if(m_regularization > largest_regularization)
        throw Numerical_error("the shifted stiffness matrix cannot be factorized: it is not "
                              "positive semi-definite");
      m_cholesky.compute(k + m_regularization * identity);
      if(m_cholesky.info() == Eigen::Success)
        break;
    }
  }

  Eigen::Index rows() const { return m_scale.size(); }
  Eigen::Index cols() const { return m_scale.size(); }
  double regularization() const { return m_regularization; }

  /// \f$x = R^{-1} y\f$
  Eigen::VectorXd vector(const Eigen::VectorXd& y) const {
    return m_scale.cwiseProduct(m_cholesky.solve_upper(y));
  }

  /// \f$ (C - Y \mathrm{diag}(\nu) Y^T)\, y \f$ with the deflated pairs \f$Y, \nu\f$
  void perform_op(const double* in, double* out) const {
    if(on_operation)
      on_operation();
    const Eigen::Map<const Eigen::VectorXd> y(in, rows());
    Eigen::Map<Eigen::VectorXd> result(out, rows());
    const Eigen::VectorXd mx = m_mass * vector(y);
    result = m_cholesky.solve_lower(m_scale.cwiseProduct(mx));
    if(m_deflated.cols() > 0)
      result -= m_deflated * m_deflated_values.cwiseProduct(m_deflated.transpose() * y);
  }

  /// \f$y = R x = R^{-T} K x\f$ for a vector of the kernel of \f$S\f$ with \f$y^T y = 1\f$, up to
  /// \f$\tau\f$
  Eigen::VectorXd kernel_vector(const Eigen::VectorXd& x) const {
    return m_cholesky.solve_lower(m_scale.cwiseProduct(m_mass * x)).normalized();
  }

  /// from now on moves further pairs to the far end of the spectrum
  void deflate(const Eigen::MatrixXd& y, const Eigen::VectorXd& nu) {
    m_deflated.conservativeResize(rows(), m_deflated.cols() + y.cols());
    m_deflated.rightCols(y.cols()) = y;
    m_deflated_values.conservativeResize(m_deflated.cols());
    m_deflated_values.tail(y.cols()) = nu;
  }

private:
  const Eigen::SparseMatrix<double>& m_mass;
  Eigen::VectorXd m_scale;
  double m_regularization;
  Sparse_cholesky m_cholesky;
  Eigen::MatrixXd m_deflated;
  Eigen::VectorXd m_deflated_values;
};

/// The largest eigenvalue below 0 that a surface of this area would have, were the distance of
/// two eigenvalues the same everywhere (Weyl's law).
inline double natural_shift(double area) { return -4 * 3.14159265358979323846 / area; }

/// Normalises the vectors, replaces each value by the Rayleigh quotient
/// \f$x^T S x / x^T M x\f$ of its vector, in which the regularisation appears squared only, and
/// sorts.
inline void finish_eigenpairs(const Eigen::SparseMatrix<double>& s,
                              const Eigen::SparseMatrix<double>& m, Eigen::MatrixXd vectors,
                              Eigenpairs& pairs) {
  const Eigen::Index k = vectors.cols();
  Eigen::VectorXd values(k), residuals(k);
  for(Eigen::Index i = 0; i < k; ++i) {
    Eigen::VectorXd x = vectors.col(i);
    Eigen::Index largest;
    x.cwiseAbs().maxCoeff(&largest);
    const double norm = std::sqrt(x.dot(m * x));
    x /= x[largest] < 0 ? -norm : norm;
    const Eigen::VectorXd sx = s * x, mx = m * x;
    values[i] = x.dot(sx);
    residuals[i] = (sx - values[i] * mx).norm() / (sx - pairs.shift * mx).norm();
    vectors.col(i) = x;
  }
  std::vector<int> order(k);
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&values](int i, int j) { return values[i] < values[j]; });
  pairs.values.resize(k);
  pairs.residuals.resize(k);
  pairs.vectors.resize(s.rows(), k);
  for(Eigen::Index i = 0; i < k; ++i) {
    pairs.values[i] = values[order[i]];
    pairs.residuals[i] = residuals[order[i]];
    pairs.vectors.col(i) = vectors.col(order[i]);
  }
}

/// For problems that are too small for an iteration: the span of the eigenvectors of the scaled
/// mass matrix above a relative cut-off, and the dense problem on it.
inline void dense_eigenpairs(const Eigen::SparseMatrix<double>& s,
                             const Eigen::SparseMatrix<double>& m, int k, Eigenpairs& pairs) {
  constexpr double relative_cutoff = 1e-12;
  const Eigen::VectorXd scale =
      m.diagonal().unaryExpr([](double d) { return d > 0 ? 1 / std::sqrt(d) : 0.; });
  const Eigen::MatrixXd dense_m = scale.asDiagonal() * Eigen::MatrixXd(m) * scale.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> of_mass(dense_m);
  const double cutoff = relative_cutoff * of_mass.eigenvalues().maxCoeff();
  const Eigen::Index rank = (of_mass.eigenvalues().array() > cutoff).count();
  if(k > rank)
    throw Parameter_error("k", "is " + std::to_string(k) + ", but the space has only " +
                                   std::to_string(rank) + " independent functions on the surface");
  const Eigen::MatrixXd basis =
      scale.asDiagonal() * of_mass.eigenvectors().rightCols(rank) *
      of_mass.eigenvalues().tail(rank).cwiseSqrt().cwiseInverse().asDiagonal();
  const Eigen::MatrixXd reduced = basis.transpose() * (s * basis);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver((reduced + reduced.transpose()) / 2);
  pairs.converged = true;
  finish_eigenpairs(s, m, basis * solver.eigenvectors().leftCols(k), pairs);
}

/// A Lanczos iteration of Spectra for the `k` largest eigenvalues \f$\nu\f$, from a random vector.
/// Deflates what it found, and returns the vectors \f$x = R^{-1} y\f$ and the values \f$\nu\f$.
inline std::pair<Eigen::MatrixXd, Eigen::VectorXd> lanczos(Inverted_pencil& pencil, int k,
                                                           std::uint64_t seed,
                                                           const Eigenpairs_options& options,
                                                           Eigenpairs& pairs) {
  const Eigen::Index n = pencil.rows();
  std::mt19937_64 generator(seed);
  Eigen::VectorXd start(n);
  for(double& v : start)
    v = std::ldexp(double(generator() >> 11), -52) - 1;
  const Eigen::Index subspace =
      (std::min)(n, (std::max)(Eigen::Index(2 * k + 1), Eigen::Index(20)));
  Spectra::SymEigsSolver<Inverted_pencil> solver(pencil, k, subspace);
  solver.init(start.data());
  const Eigen::Index found =
      solver.compute(Spectra::SortRule::LargestAlge, options.maximum_iterations, options.tolerance);
  pairs.iterations += static_cast<int>(solver.num_iterations());
  pairs.converged = pairs.converged && solver.info() == Spectra::CompInfo::Successful && found == k;
  const Eigen::MatrixXd y = solver.eigenvectors();
  pencil.deflate(y, solver.eigenvalues());
  Eigen::MatrixXd x(n, y.cols());
  for(Eigen::Index i = 0; i < y.cols(); ++i)
    x.col(i) = pencil.vector(y.col(i));
  return {std::move(x), solver.eigenvalues()};
}

/// The functions that are constant on one connected component of the graph of \f$S\f$ and 0 on the
/// others, as far as they are in its kernel: columns of 1 and 0.
inline Eigen::MatrixXd constants_in_kernel(const Eigen::SparseMatrix<double>& s) {
  const auto [component, number] = connected_components(s);
  const std::vector<char> is_in_kernel =
      maps_constants_to(Eigen::VectorXd::Zero(s.cols()), s, component, number);
  std::vector<int> column(number, -1);
  int columns = 0;
  for(int c = 0; c < number; ++c)
    if(is_in_kernel[c])
      column[c] = columns++;
  Eigen::MatrixXd constants = Eigen::MatrixXd::Zero(s.cols(), columns);
  for(Eigen::Index i = 0; i < s.cols(); ++i)
    if(column[component[i]] >= 0)
      constants(i, column[component[i]]) = 1;
  return constants;
}

/// The `k` largest \f$\nu\f$ with all copies of multiple eigenvalues, from the second on; the first
/// ones, the eigenvalue 0 of \f$S\f$, are known.
///
/// A Krylov space holds one vector of each eigenspace; other copies enter it by rounding only, and
/// on symmetric surfaces some may still be missing when the iteration has converged. So iterate
/// again, from another vector and with all known pairs deflated: if that finds a value above the
/// smallest known one, it was missed. Repeated until it finds none.
inline Eigen::MatrixXd all_copies(Inverted_pencil& pencil, const Eigen::MatrixXd& constants,
                                  double shift, int k, const Eigenpairs_options& options,
                                  Eigenpairs& pairs) {
  // what is above by less is a copy of the smallest value, of which any number may be cut off
  constexpr double relative_gap = 1e-8;
  const Eigen::Index known = (std::min)(constants.cols(), Eigen::Index(k));
  for(Eigen::Index i = 0; i < known; ++i)
    pencil.deflate(pencil.kernel_vector(constants.col(i)),
                   Eigen::VectorXd::Constant(1, -1 / shift));
  Eigen::MatrixXd result(constants.rows(), k);
  result.leftCols(known) = constants.leftCols(known);
  const int wanted = k - static_cast<int>(known);
  if(wanted == 0)
    return result;
  auto [vectors, values] = lanczos(pencil, wanted, 1, options, pairs);
  for(int pass = 2; pass < wanted + 3 && pairs.converged; ++pass) {
    const auto [vector, value] = lanczos(pencil, 1, pass, options, pairs);
    Eigen::Index smallest;
    const double smallest_value = values.minCoeff(&smallest);
    if(!pairs.converged || !(value[0] > smallest_value * (1 + relative_gap)))
      break;
    vectors.col(smallest) = vector;
    values[smallest] = value[0];
  }
  result.conservativeResize(Eigen::NoChange, known + vectors.cols());
  result.rightCols(vectors.cols()) = vectors;
  return result;
}

} // namespace internal

/// \ingroup PkgRestrictedLaplacian3Solvers
/// The `k` smallest eigenvalues of \f$S x = \lambda M x\f$, with multiplicities, and eigenvectors,
/// for symmetric positive semi-definite matrices.
///
/// By Spectra, a restarted Lanczos iteration for \f$K^{-1} M\f$, in the symmetric form
/// \f$R^{-T} M R^{-1}\f$, where \f$ R^T R = K = S - \sigma M + \tau\, \mathrm{diag}(S - \sigma M)
/// \f$ is factorised once, by CHOLMOD if the macro `CGAL_RESTRICTED_LAPLACIAN_3_USE_CHOLMOD` is
/// defined, else by Eigen.
///
/// *Shift.* \f$\sigma = -4 \pi / \sum_{ij} M_{ij}\f$: below the spectrum by about the mean distance
/// of two eigenvalues of a surface of this area (Weyl's law), so \f$K\f$ is positive semi-definite
/// although \f$S\f$ has the constants in its kernel, and all eigenvalues near 0 are well separated.
///
/// *Common near-kernel.* Combinations of elements that nearly vanish on the surface are nearly in
/// the kernel of \f$S\f$ and of \f$M\f$; rounding may make their pivots negative. They are made
/// regular by \f$\tau = 10^{-12}\f$, relative to each diagonal entry. For them \f$K\f$ is then
/// dominated by \f$\tau\f$ while \f$M\f$ is zero to rounding, so \f$K^{-1} M\f$ sends them to 0,
/// the far end of the spectrum. The values returned are Rayleigh quotients with \f$S\f$ itself, in
/// which \f$\tau\f$ enters squared only. Should a factorisation fail, \f$\tau\f$ is multiplied by
/// 100, up to \f$10^{-8}\f$; the result reports the value used.
///
/// *Kernel.* Functions that are constant on a connected component of the graph of \f$S\f$ and in
/// its kernel are recognised and returned as they are.
///
/// *Multiplicity.* A second iteration, with all pairs found so far deflated, looks for copies of a
/// multiple eigenvalue that the first one missed, and is repeated until it finds none.
///
/// Problems with fewer than 100 unknowns, or with `k` more than a third of them, are solved
/// densely.
///
/// \param s,m full symmetric matrices; an unknown whose rows are empty is 0 in all vectors
/// \param k number of pairs, positive
/// \param options tolerance, iterations, regularisation, callback
/// \throws Parameter_error if `k` is not positive, exceeds the number of independent functions, or
/// is more than a third of more than 10,000 unknowns; if the matrices are not square and of the
/// same size, or the entries of `m` do not have a positive sum
/// \throws Numerical_error if no factorisation succeeds
/// \throws Canceled if the callback returned `false`
inline Eigenpairs smallest_eigenpairs(const Eigen::SparseMatrix<double>& s,
                                      const Eigen::SparseMatrix<double>& m, int k,
                                      const Eigenpairs_options& options = Eigenpairs_options()) {
  if(s.rows() != s.cols() || m.rows() != m.cols() || s.rows() != m.rows())
    throw Parameter_error("m", "does not have the size of s, or they are not square");
  if(k < 1)
    throw Parameter_error("k", "is " + std::to_string(k) + ", but must be positive");
  if(k > s.rows())
    throw Parameter_error("k", "is " + std::to_string(k) + ", but there are only " +
                                   std::to_string(s.rows()) + " unknowns");
  const double mass = m.coeffs().sum();
  if(!(mass > 0))
    throw Parameter_error("m", "does not have a positive sum of entries");
  Eigenpairs pairs;
  pairs.shift = internal::natural_shift(mass);
  const Eigen::Index n = s.rows();
  if(n < 100 || k > n / 3) {
    if(n > 10000)
      throw Parameter_error("k", "is more than a third of the " + std::to_string(n) +
                                     " unknowns; that calls for a dense solver");
    internal::dense_eigenpairs(s, m, k, pairs);
    return pairs;
  }
  // Spectra compares with absolute numbers: solve for a surface of area 1.
  const Eigen::SparseMatrix<double> unit_mass = m / mass;
  internal::Inverted_pencil pencil(s, unit_mass, pairs.shift * mass, options.regularization);
  pairs.regularization = pencil.regularization();
  pairs.converged = true;
  int operations = 0;
  if(options.callback)
    pencil.on_operation = [&operations, &options, k] {
      // Most problems take two to four times the dimension of the Krylov space.
      if(!options.callback(1 - std::exp(-++operations / (4. * k + 20))))
        throw Canceled();
    };
  Eigen::MatrixXd vectors = internal::all_copies(pencil, internal::constants_in_kernel(s),
                                                 pairs.shift * mass, k, options, pairs);
  internal::finish_eigenpairs(s, m, std::move(vectors), pairs);
  constexpr double largest_residual = 1e-3;
  pairs.converged = pairs.converged && (pairs.residuals.array() <= largest_residual).all();
  return pairs;
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_EIGENPAIRS_H
