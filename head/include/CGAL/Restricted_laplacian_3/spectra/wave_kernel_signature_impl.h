// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_WAVE_KERNEL_SIGNATURE_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_WAVE_KERNEL_SIGNATURE_IMPL_H

#include <CGAL/Restricted_laplacian_3/spectra/wave_kernel_signature.h>

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/spectra/internal/filtered_squares.h>

#include <Eigen/Core>

#include <cmath>
#include <string>

namespace CGAL {
namespace Restricted_laplacian_3 {

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Wave_kernel_energies
wave_kernel_energies(const Eigen::VectorXd& eigenvalues, int number) {
  if(number < 1)
    throw Parameter_error("number", "is " + std::to_string(number) + ", but must be positive");
  const Eigen::VectorXd checked = internal::checked_eigenvalues(eigenvalues);
  const double first = checked[internal::number_of_zeros_before_others(checked)];
  const double last = checked[checked.size() - 1];
  constexpr double sigma_over_delta = 7, margin_over_sigma = 2;
  const double delta =
      std::log(last / first) / (number - 1 + 2 * margin_over_sigma * sigma_over_delta);
  if(!(delta > 0))
    throw Parameter_error("eigenvalues", "has no two different entries but zeros");
  Wave_kernel_energies result;
  result.sigma = sigma_over_delta * delta;
  result.energies.resize(number);
  for(int i = 0; i < number; ++i)
    result.energies[i] = std::log(first) + margin_over_sigma * result.sigma + i * delta;
  return result;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Eigen::MatrixXd
wave_kernel_signature(const Eigen::VectorXd& eigenvalues,
                      const Eigen::Ref<const Eigen::MatrixXd>& values,
                      const Wave_kernel_energies& energies) {
  const Eigen::VectorXd checked = internal::checked_eigenvalues(eigenvalues);
  internal::check_columns(checked, values);
  internal::check_positive("sigma", energies.sigma);
  if(!energies.energies.allFinite())
    throw Parameter_error("energies", "has an entry that is not a finite number");
  const Eigen::Index number = checked.size() - internal::number_of_zeros_before_others(checked);
  const Eigen::ArrayXd logarithms = checked.tail(number).array().log();
  Eigen::MatrixXd weights(number, energies.energies.size());
  for(Eigen::Index j = 0; j < weights.cols(); ++j) {
    const Eigen::ArrayXd exponents =
        ((energies.energies[j] - logarithms) / energies.sigma).square() / 2;
    // The largest weight is 1, so the sum cannot underflow.
    weights.col(j) = (exponents.minCoeff() - exponents).exp();
    weights.col(j) /= weights.col(j).sum();
  }
  return internal::filtered_squares(values.rightCols(number), weights);
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_WAVE_KERNEL_SIGNATURE_IMPL_H
