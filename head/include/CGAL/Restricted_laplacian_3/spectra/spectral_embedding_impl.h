// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_SPECTRAL_EMBEDDING_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_SPECTRAL_EMBEDDING_IMPL_H

#include <CGAL/Restricted_laplacian_3/spectra/spectral_embedding.h>

#include <Eigen/Core>

#include <cmath>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// \f$f(\lambda_i)\, \phi_i\f$ for the eigenvalues that are not 0
template <class Function>
Eigen::MatrixXd embedding_without_zeros(const Eigen::VectorXd& eigenvalues,
                                        const Eigen::Ref<const Eigen::MatrixXd>& values,
                                        Function&& f) {
  const Eigen::VectorXd checked = checked_eigenvalues(eigenvalues);
  check_columns(checked, values);
  const Eigen::Index number = checked.size() - number_of_zeros_before_others(checked);
  return values.rightCols(number) * checked.tail(number).unaryExpr(f).asDiagonal();
}

} // namespace internal

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Eigen::MatrixXd
global_point_signature(const Eigen::VectorXd& eigenvalues,
                       const Eigen::Ref<const Eigen::MatrixXd>& values) {
  return internal::embedding_without_zeros(eigenvalues, values,
                                           [](double l) { return 1 / std::sqrt(l); });
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Eigen::MatrixXd
biharmonic_embedding(const Eigen::VectorXd& eigenvalues,
                     const Eigen::Ref<const Eigen::MatrixXd>& values) {
  return internal::embedding_without_zeros(eigenvalues, values, [](double l) { return 1 / l; });
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Eigen::MatrixXd
diffusion_map(const Eigen::VectorXd& eigenvalues, const Eigen::Ref<const Eigen::MatrixXd>& values,
              double time) {
  const Eigen::VectorXd checked = internal::checked_eigenvalues(eigenvalues);
  internal::check_columns(checked, values);
  internal::check_positive("time", time);
  return values * (-time * checked.array()).exp().matrix().asDiagonal();
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_SPECTRAL_EMBEDDING_IMPL_H
