// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_SHIFT_INVERT_EIGENPAIRS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_SHIFT_INVERT_EIGENPAIRS_H

#include <CGAL/Restricted_laplacian_3/foundation/Sparse_matrix.h>
#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Single_blas_thread.h>
#include <CGAL/Restricted_laplacian_3/spectra/eigenpairs.h>
#include <CGAL/Restricted_laplacian_3/spectra/internal/Inverted_pencil.h>
#include <CGAL/Restricted_laplacian_3/spectra/internal/eigenproblem.h>

#include <Eigen/Core>

#include <Spectra/SymEigsSolver.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <utility>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// A Lanczos iteration of Spectra for the `k` largest eigenvalues \f$\nu\f$, from a random vector.
/// Deflates what it found, and returns the vectors \f$x = R^{-1} y\f$ and the values \f$\nu\f$.
template <class Pencil>
std::pair<Eigen::MatrixXd, Eigen::VectorXd> lanczos(Pencil& pencil, int k, std::uint64_t seed,
                                                    const Eigenpairs_options& options,
                                                    Eigenpairs& pairs) {
  // of the Krylov space; the manual of Spectra recommends twice the number of pairs
  constexpr Eigen::Index smallest_dimension = 20;
  const Eigen::Index n = pencil.rows(),
                     dimension =
                         (std::min)(n, (std::max)(Eigen::Index(2 * k + 1), smallest_dimension));
  std::mt19937_64 generator(seed);
  Eigen::VectorXd start(n);
  for(double& v : start)
    v = std::ldexp(double(generator() >> 11), -52) - 1;
  Spectra::SymEigsSolver<Pencil> solver(pencil, k, dimension);
  solver.init(start.data());
  const Eigen::Index found =
      solver.compute(Spectra::SortRule::LargestAlge, options.maximum_iterations, options.tolerance);
  pairs.iterations += static_cast<int>(solver.num_iterations());
  if(solver.info() != Spectra::CompInfo::Successful || found != k)
    pairs.set_status(Solve_status::iteration_limit);
  const Eigen::MatrixXd y = solver.eigenvectors();
  pencil.deflate(y, solver.eigenvalues());
  Eigen::MatrixXd x(n, y.cols());
  for(Eigen::Index i = 0; i < y.cols(); ++i)
    x.col(i) = pencil.vector(y.col(i));
  return {std::move(x), solver.eigenvalues()};
}

/// The `k` largest \f$\nu\f$ with all copies of multiple eigenvalues, from the second on; the first
/// ones, the eigenvalue 0 of \f$S\f$, are known.
///
/// A Krylov space holds one vector of each eigenspace; other copies enter it by rounding only, and
/// on symmetric surfaces some may still be missing when the iteration has converged. So iterate
/// again, from another vector and with all known pairs deflated: if that finds a value above the
/// smallest known one, it was missed. Repeated until it finds none.
template <class Pencil>
Eigen::MatrixXd all_copies(Pencil& pencil, const Eigen::MatrixXd& constants, double shift, int k,
                           const Eigenpairs_options& options, Eigenpairs& pairs) {
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
/// `smallest_eigenpairs()` with a factorization that the caller chooses. Needs Spectra. Uses the
/// calling thread: until it returns, OpenBLAS and MKL are set to one thread in the whole process.
/// \tparam SparseCholesky a model of `SparseCholesky_3`
///
/// \param s,m full symmetric matrices; an unknown whose rows are empty is 0 in all vectors
/// \param k number of pairs, positive
/// \param options named parameters, or the options themselves:
/// \cgalNamedParamsBegin
///   \named_tolerance{`1e-10`, of the eigenvalues}
///   \named_maximum_iterations{`1000` restarts of the Lanczos iteration}
///   \named_progress
/// \cgalNamedParamsEnd
/// \throws Parameter_error if `k` or a matrix is not as it must be, as in `smallest_eigenpairs()`
/// \throws Numerical_error if no factorization succeeds
/// \throws Canceled if `progress` returned `false`
template <class SparseCholesky>
Eigenpairs shift_invert_eigenpairs(const Sparse_matrix& s, const Sparse_matrix& m, int k,
                                   const Eigenpairs_options& options = {}) {
  if(!s.isCompressed() || !m.isCompressed()) {
    Sparse_matrix compressed_s = s, compressed_m = m;
    compressed_s.makeCompressed();
    compressed_m.makeCompressed();
    return shift_invert_eigenpairs<SparseCholesky>(compressed_s, compressed_m, k, options);
  }
  internal::check_eigenproblem(s, m, k);
  Eigenpairs pairs;
  if(internal::is_solved_densely(s, m, k, pairs))
    return pairs;
  const internal::Single_blas_thread single_thread;
  // Spectra compares with absolute numbers: solve for a surface of area 1.
  const double mass = m.coeffs().sum();
  const Sparse_matrix unit_mass = m / mass;
  internal::Inverted_pencil<SparseCholesky> pencil(s, unit_mass, pairs.shift * mass,
                                                   options.regularization);
  pairs.regularization = pencil.regularization();
  pairs.set_status(Solve_status::converged);
  int operations = 0;
  if(options.progress)
    pencil.on_operation = [&operations, &options, k] {
      // Most problems take two to four times the dimension of the Krylov space.
      if(!options.progress(1 - std::exp(-++operations / (4. * k + 20))))
        throw Canceled();
    };
  Eigen::MatrixXd vectors = internal::all_copies(pencil, internal::constants_in_kernel(s),
                                                 pairs.shift * mass, k, options, pairs);
  internal::finish_eigenpairs(s, m, std::move(vectors), pairs);
  // A pair that is further off is none, whatever Spectra says: the factorization was of no use.
  constexpr double largest_residual = 1e-3;
  if(!(pairs.residuals.array() <= largest_residual).all())
    pairs.set_status(Solve_status::stalled);
  return pairs;
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_SHIFT_INVERT_EIGENPAIRS_H
