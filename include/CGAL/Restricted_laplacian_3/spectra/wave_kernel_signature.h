// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_WAVE_KERNEL_SIGNATURE_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_WAVE_KERNEL_SIGNATURE_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/spectra/internal/filtered_squares.h>
#include <CGAL/Restricted_laplacian_3/spectra/zero_eigenvalues.h>

#include <Eigen/Core>

#include <cmath>
#include <string>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Descriptors
/// Where a wave kernel signature is taken.
struct Wave_kernel_energies {
  /// \f$e\f$: natural logarithms of eigenvalues
  Eigen::VectorXd energies;
  /// \f$\sigma\f$, the standard deviation of the energy of a particle
  double sigma = 0;
};

/// \ingroup PkgRestrictedLaplacian3Descriptors
/// `number` energies at a constant distance \f$\delta\f$, and \f$\sigma = 7 \delta\f$, as in
/// \cgalCite{ASC11}: from \f$\ln \lambda_{\min} + 2 \sigma\f$ to
/// \f$\ln \lambda_{\max} - 2 \sigma\f$, with the first eigenvalue that is not 0 (see
/// `zero_eigenvalue_tolerance`) and the largest one, so that no energy is cut off by more than two
/// standard deviations. That makes
/// \f$\delta = \ln(\lambda_{\max} / \lambda_{\min}) / (\mathrm{number} + 27)\f$.
/// \param eigenvalues ascending, in units of 1 / area; the paper takes 300
/// \param number number of energies, positive
/// \throws Parameter_error if `number` is less than 1, if eigenvalues are not finite, ascending and
/// not negative, or if there are no two different ones but 0
inline Wave_kernel_energies wave_kernel_energies(const Eigen::VectorXd& eigenvalues,
                                                 int number = 100) {
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

/// \ingroup PkgRestrictedLaplacian3Descriptors
/// The same for a `Laplace_spectrum`.
template <class Spectrum, internal::Require_spectrum<Spectrum> = 0>
Wave_kernel_energies wave_kernel_energies(const Spectrum& spectrum, int number = 100) {
  return wave_kernel_energies(internal::eigenvalues_of(spectrum), number);
}

/// \ingroup PkgRestrictedLaplacian3Descriptors
/// The wave kernel signature
/// \f[ \mathrm{WKS}(x, e) = \frac{\sum_i w_i\, \phi_i(x)^2}{\sum_i w_i}, \qquad
///     w_i = e^{-(e - \ln \lambda_i)^2 / (2 \sigma^2)}, \f]
/// of Aubry, Schlickewei and Cremers \cgalCite{ASC11}: the probability, per area and averaged over
/// time, to find at \f$x\f$ a quantum particle of energy about \f$\exp e\f$. Its integral over the
/// surface is 1 at each energy. Other than the heat kernel signature it looks at few frequencies at
/// once.
///
/// Zero eigenvalues (see `zero_eigenvalue_tolerance`) have no logarithm, and are left out.
///
/// \param eigenvalues \f$\lambda\f$, ascending, in units of 1 / area
/// \param values \f$\phi\f$: a row for each point, a column for each eigenvalue, with
/// \f$\int \phi_i^2 = 1\f$. A row of NaN, as for points that are not on the surface, gives one.
/// \param energies \f$e\f$ and \f$\sigma\f$, for example `wave_kernel_energies()`. An energy may
/// lie outside of the spectrum: the limit of the formula, the nearest eigenvalue, counts there.
/// \return a row for each point, a column for each energy, in units of 1 / area
/// \throws Parameter_error if sizes do not fit, if eigenvalues are not finite, ascending and not
/// negative, if all of them are 0, if an energy is not finite, or if \f$\sigma\f$ is not positive
/// and finite
///
/// Takes one product for each point, eigenvalue and energy.
inline Eigen::MatrixXd wave_kernel_signature(const Eigen::VectorXd& eigenvalues,
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

/// \ingroup PkgRestrictedLaplacian3Descriptors
/// The same at the vertices, for a `Laplace_spectrum`.
template <class Spectrum, internal::Require_spectrum<Spectrum> = 0>
Eigen::MatrixXd wave_kernel_signature(const Spectrum& spectrum,
                                      const Wave_kernel_energies& energies) {
  return wave_kernel_signature(internal::eigenvalues_of(spectrum), spectrum.vertex_values,
                               energies);
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_WAVE_KERNEL_SIGNATURE_H
