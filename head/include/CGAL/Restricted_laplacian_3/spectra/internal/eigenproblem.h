// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_INTERNAL_EIGENPROBLEM_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_INTERNAL_EIGENPROBLEM_H

#include <CGAL/Restricted_laplacian_3/foundation/Sparse_matrix.h>
#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/symmetric_eigenpairs.h>
#include <CGAL/Restricted_laplacian_3/solvers/shared/connected_components.h>
#include <CGAL/Restricted_laplacian_3/spectra/eigenpairs.h>
#include <CGAL/Restricted_laplacian_3/spectra/shared/nested_iteration.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

/// \file
/// What all ways to solve \f$S x = \lambda M x\f$ share: what is checked before, the dense problem,
/// and what is made of the vectors that were found.

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// whether the entries of a matrix and of its transpose agree, to rounding
inline bool is_symmetric(const Sparse_matrix& a) {
  constexpr double rounding = 1e-10;
  const Sparse_matrix transpose = a.transpose();
  return (a - transpose).norm() <= rounding * a.norm();
}

/// \param s,m compressed
/// \throws Parameter_error see `smallest_eigenpairs()`
inline void check_eigenproblem(const Sparse_matrix& s, const Sparse_matrix& m, int k) {
  if(s.rows() != s.cols() || m.rows() != m.cols() || s.rows() != m.rows())
    throw Parameter_error("m", "does not have the size of s, or they are not square");
  if(k < 1)
    throw Parameter_error("count", "is " + std::to_string(k) + ", but must be positive");
  if(k > s.rows())
    throw Parameter_error("count", "is " + std::to_string(k) + ", but there are only " +
                                       std::to_string(s.rows()) + " unknowns");
  for(const Sparse_matrix* a : {&s, &m})
    if(!a->coeffs().allFinite())
      throw Parameter_error(a == &s ? "s" : "m", "has an entry that is not a finite number");
  if(!(m.coeffs().sum() > 0))
    throw Parameter_error("m", "does not have a positive sum of entries");
  CGAL_precondition(is_symmetric(s));
  CGAL_precondition(is_symmetric(m));
}

/// Normalizes the vectors, replaces each value by the Rayleigh quotient
/// \f$x^T S x / x^T M x\f$ of its vector, in which the regularization appears squared only, and
/// sorts.
inline void finish_eigenpairs(const Sparse_matrix& s, const Sparse_matrix& m,
                              Eigen::MatrixXd vectors, Eigenpairs& pairs) {
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

/// For problems that are too small for an iteration: the largest eigenvalues
/// \f$\mu = 1 / (\lambda - \sigma)\f$ of \f$M x = \mu (S - \sigma M) x\f$ with the shift
/// \f$\sigma < 0\f$, on the span of the eigenvectors of the scaled matrix \f$S - \sigma M\f$
/// above a relative cut-off. Functions that vanish on the surface, which \f$M\f$ maps to 0, have
/// their part in the others.
/// \throws Parameter_error if there are fewer than `k` functions that do not vanish on it
inline void dense_eigenpairs(const Sparse_matrix& s, const Sparse_matrix& m, int k,
                             Eigenpairs& pairs) {
  // below, numbers are rounding errors
  constexpr double relative_cutoff = 1e-12;
  const auto scale_of = [](const Eigen::VectorXd& diagonal) {
    return Eigen::VectorXd(
        diagonal.unaryExpr([](double d) { return d > 0 ? 1 / std::sqrt(d) : 0.; }));
  };
  const auto scaled = [](const Eigen::MatrixXd& a, const Eigen::VectorXd& scale) {
    return Eigen::MatrixXd(scale.asDiagonal() * a * scale.asDiagonal());
  };
  const auto rank_of = [](const Symmetric_eigenpairs& of) {
    return Eigen::Index((of.values.array() > relative_cutoff * of.values.maxCoeff()).count());
  };
  const Eigen::Index independent =
      rank_of(symmetric_eigenpairs(scaled(m, scale_of(m.diagonal())), "the mass matrix"));
  if(k > independent)
    throw Parameter_error("count", "is " + std::to_string(k) + ", but the space has only " +
                                       std::to_string(independent) +
                                       " independent functions on the surface");
  const Eigen::MatrixXd shifted = Eigen::MatrixXd(s) - pairs.shift * Eigen::MatrixXd(m);
  const Eigen::VectorXd scale = scale_of(shifted.diagonal());
  const Symmetric_eigenpairs of_shifted =
      symmetric_eigenpairs(scaled(shifted, scale), "the shifted stiffness matrix");
  const Eigen::Index rank = rank_of(of_shifted);
  const Eigen::MatrixXd basis =
      scale.asDiagonal() * of_shifted.vectors.rightCols(rank) *
      of_shifted.values.tail(rank).cwiseSqrt().cwiseInverse().asDiagonal();
  const Eigen::MatrixXd reduced = basis.transpose() * (m * basis);
  const Symmetric_eigenpairs found =
      symmetric_eigenpairs((reduced + reduced.transpose()) / 2, "the reduced mass matrix");
  pairs.set_status(Solve_status::converged);
  finish_eigenpairs(s, m, basis * found.vectors.rightCols(k), pairs);
}

/// Solves a problem that has passed `check_eigenproblem()`, if it is too small for an iteration,
/// and sets the shift in any case.
/// \return whether it is solved
/// \throws Parameter_error if it is too small for an iteration and too large for dense matrices
inline bool is_solved_densely(const Sparse_matrix& s, const Sparse_matrix& m, int k,
                              Eigenpairs& pairs) {
  // A Krylov space of twice the number of pairs has to fit in, and time grows with its cube.
  constexpr Eigen::Index smallest_iterative_problem = 100, unknowns_of_a_pair = 3,
                         largest_dense_problem = 10000;
  const Eigen::Index n = s.rows();
  pairs.shift = natural_shift(m.coeffs().sum());
  if(n >= smallest_iterative_problem && k <= n / unknowns_of_a_pair)
    return false;
  if(n > largest_dense_problem)
    throw Parameter_error("count", "is more than a third of the " + std::to_string(n) +
                                       " unknowns; that calls for a dense solver");
  dense_eigenpairs(s, m, k, pairs);
  return true;
}

/// The functions that are constant on one connected component of the graph of \f$S\f$ and 0 on the
/// others, as far as they are in its kernel: columns of 1 and 0.
inline Eigen::MatrixXd constants_in_kernel(const Sparse_matrix& s) {
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

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_INTERNAL_EIGENPROBLEM_H
