// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_HEAT_KERNEL_SIGNATURE_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_HEAT_KERNEL_SIGNATURE_IMPL_H

#include <CGAL/Restricted_laplacian_3/spectra/heat_kernel_signature.h>

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/spectra/internal/filtered_squares.h>

#include <Eigen/Core>

#include <cmath>
#include <string>

namespace CGAL {
namespace Restricted_laplacian_3 {

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Eigen::VectorXd
heat_kernel_times(const Eigen::VectorXd& eigenvalues, int number) {
  if(number < 2)
    throw Parameter_error("number", "is " + std::to_string(number) + ", but must be at least 2");
  const Eigen::VectorXd checked = internal::checked_eigenvalues(eigenvalues);
  const double first = checked[internal::number_of_zeros_before_others(checked)];
  const double last = checked[checked.size() - 1];
  const double numerator = 4 * std::log(10.);
  return Eigen::VectorXd::LinSpaced(number, std::log(numerator / last), std::log(numerator / first))
      .array()
      .exp();
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Eigen::VectorXd heat_trace(const Eigen::VectorXd& eigenvalues,
                                                              const Eigen::VectorXd& times) {
  const Eigen::VectorXd checked = internal::checked_eigenvalues(eigenvalues);
  internal::check_positive("times", times);
  return (-times * checked.transpose()).array().exp().rowwise().sum();
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Eigen::MatrixXd
heat_kernel_signature(const Eigen::VectorXd& eigenvalues,
                      const Eigen::Ref<const Eigen::MatrixXd>& values, const Eigen::VectorXd& times,
                      Heat_kernel_scaling scaling) {
  Eigen::VectorXd checked = internal::checked_eigenvalues(eigenvalues);
  internal::check_columns(checked, values);
  internal::check_positive("times", times);
  // A factor that all terms have cancels, and without it the sum cannot underflow.
  if(scaling == Heat_kernel_scaling::heat_trace)
    checked.array() -= checked[0];
  Eigen::MatrixXd weights = (-checked * times.transpose()).array().exp();
  if(scaling == Heat_kernel_scaling::heat_trace)
    weights.array().rowwise() /= weights.colwise().sum().eval().array();
  return internal::filtered_squares(values, weights);
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_HEAT_KERNEL_SIGNATURE_IMPL_H
