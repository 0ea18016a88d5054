// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_WAVE_KERNEL_SIGNATURE_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_WAVE_KERNEL_SIGNATURE_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>
#include <CGAL/Restricted_laplacian_3/spectra/zero_eigenvalues.h>

#include <Eigen/Core>

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
Wave_kernel_energies wave_kernel_energies(const Eigen::VectorXd& eigenvalues, int number = 100);

/// \ingroup PkgRestrictedLaplacian3Descriptors
/// The wave kernel signature at the vertices, from a `Laplace_spectrum`.
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
Eigen::MatrixXd wave_kernel_signature(const Eigen::VectorXd& eigenvalues,
                                      const Eigen::Ref<const Eigen::MatrixXd>& values,
                                      const Wave_kernel_energies& energies);

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

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/spectra/wave_kernel_signature_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_WAVE_KERNEL_SIGNATURE_H
