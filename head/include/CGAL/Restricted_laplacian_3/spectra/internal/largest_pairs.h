// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_INTERNAL_LARGEST_PAIRS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_INTERNAL_LARGEST_PAIRS_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/symmetric_eigenpairs.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <cmath>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// Eigenvalues, descending, and a vector for each.
struct Dense_pairs {
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;
};

/// Columns that span \f$\mathbb{R}^n\f$, or all of it but nearly dependent directions, with
/// \f$B^T A B = 1\f$.
/// \param a symmetric positive semi-definite, with diagonal 1
inline Eigen::MatrixXd orthonormal_basis(const Eigen::MatrixXd& a) {
  // A Cholesky factor with a smaller pivot would lose more than three digits.
  constexpr double smallest_pivot = 1e-3;
  // Directions whose squares are shorter consist of the rounding errors of single precision.
  constexpr double relative_cutoff = 1e-6;
  const Eigen::LLT<Eigen::MatrixXd> cholesky(a);
  if(cholesky.info() == Eigen::Success &&
     (cholesky.matrixLLT().diagonal().array() > smallest_pivot).all())
    return cholesky.matrixU().solve(Eigen::MatrixXd::Identity(a.rows(), a.cols()));
  const Symmetric_eigenpairs of_a = symmetric_eigenpairs(a, "a Gram matrix");
  const double cutoff = relative_cutoff * of_a.values.maxCoeff();
  const Eigen::Index rank = (of_a.values.array() > cutoff).count();
  return of_a.vectors.rightCols(rank) *
         of_a.values.tail(rank).cwiseSqrt().cwiseInverse().asDiagonal();
}

/// The `k` largest eigenvalues of \f$M y = \nu A y\f$, and vectors with \f$y^T A y = 1\f$.
/// \param m,a symmetric positive semi-definite
/// \throws Numerical_error if an entry is not finite, or the rank of \f$A\f$ is less than `k`
inline Dense_pairs largest_pairs(const Eigen::MatrixXd& m, const Eigen::MatrixXd& a,
                                 Eigen::Index k) {
  const Eigen::VectorXd scale =
      a.diagonal().unaryExpr([](double d) { return d > 0 ? 1 / std::sqrt(d) : 0.; });
  const Eigen::MatrixXd scaled_a = scale.asDiagonal() * a * scale.asDiagonal(),
                        scaled_m = scale.asDiagonal() * m * scale.asDiagonal();
  if(!scaled_a.allFinite() || !scaled_m.allFinite())
    throw Numerical_error("the eigenvalue iteration gave numbers that are not finite");
  const Eigen::MatrixXd basis = orthonormal_basis(scaled_a);
  if(basis.cols() < k)
    throw Numerical_error("the vectors of the eigenvalue iteration are linearly dependent");
  const Eigen::MatrixXd reduced = basis.transpose() * (scaled_m * basis).eval();
  const Symmetric_eigenpairs found =
      symmetric_eigenpairs((reduced + reduced.transpose()) / 2, "a matrix of Ritz vectors");
  const Eigen::MatrixXd y = found.vectors.rightCols(k).rowwise().reverse();
  return {found.values.tail(k).reverse(), scale.asDiagonal() * (basis * y).eval()};
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_INTERNAL_LARGEST_PAIRS_H
