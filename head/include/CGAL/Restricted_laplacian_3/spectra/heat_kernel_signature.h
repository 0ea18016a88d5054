// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_HEAT_KERNEL_SIGNATURE_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_HEAT_KERNEL_SIGNATURE_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>
#include <CGAL/Restricted_laplacian_3/spectra/zero_eigenvalues.h>

#include <Eigen/Core>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Descriptors
/// What a heat kernel signature is divided by.
enum class Heat_kernel_scaling {
  /// nothing
  none,
  /// the heat trace: the integral over the surface is then 1 at all times, which weighs times
  /// equally in a comparison of points
  heat_trace
};

/// \ingroup PkgRestrictedLaplacian3Descriptors
/// The times at which \cgalCite{SOG09} takes the heat kernel signature: `number` of them, evenly
/// distributed on a logarithmic scale from
/// \f$4 \ln 10 / \lambda_{\max}\f$ to \f$4 \ln 10 / \lambda_{\min}\f$, with the largest eigenvalue
/// and the first that is not 0 (see `zero_eigenvalue_tolerance`). Before, eigenfunctions that are
/// not known would count; after, hardly any but the constants is left.
/// \param eigenvalues ascending, in units of 1 / area
/// \param number number of times, at least 2
/// \return ascending, in units of area
/// \throws Parameter_error if `number` is less than 2, if eigenvalues are not finite, ascending and
/// not negative, or if all of them are 0
Eigen::VectorXd heat_kernel_times(const Eigen::VectorXd& eigenvalues, int number = 100);

/// \ingroup PkgRestrictedLaplacian3Descriptors
/// The heat kernel signature at the vertices, from a `Laplace_spectrum`.
template <class Spectrum, internal::Require_spectrum<Spectrum> = 0>
Eigen::VectorXd heat_kernel_times(const Spectrum& spectrum, int number = 100) {
  return heat_kernel_times(internal::eigenvalues_of(spectrum), number);
}

/// \ingroup PkgRestrictedLaplacian3Descriptors
/// The heat trace \f$\sum_i e^{-\lambda_i t}\f$ of the given eigenvalues, for each time: the
/// integral of the heat kernel signature over the surface.
/// \throws Parameter_error as `heat_kernel_signature()`
Eigen::VectorXd heat_trace(const Eigen::VectorXd& eigenvalues, const Eigen::VectorXd& times);

/// \ingroup PkgRestrictedLaplacian3Descriptors
/// The heat kernel signature
/// \f[ \mathrm{HKS}(x, t) = k_t(x, x) = \sum_i e^{-\lambda_i t} \phi_i(x)^2 \f]
/// of Sun, Ovsjanikov and Guibas \cgalCite{SOG09}: the share of a unit of heat that is
/// still where it was after the time \f$t\f$, per area. It does not change with the position of the
/// surface in space, nor, but for what the sum leaves out, if the surface is bent without being
/// stretched. Zero eigenvalues take part, with the factor 1: after a long time the signature is 1
/// over the area of the connected component.
///
/// \param eigenvalues \f$\lambda\f$, ascending, in units of 1 / area
/// \param values \f$\phi\f$: a row for each point, a column for each eigenvalue, with
/// \f$\int \phi_i^2 = 1\f$. A row of NaN, as for points that are not on the surface, gives one.
/// \param times \f$t\f$, in units of area, for example `heat_kernel_times()`
/// \param scaling whether columns are divided by the heat trace \f$\sum_i e^{-\lambda_i t}\f$
/// \return a row for each point, a column for each time, in units of 1 / area
/// \throws Parameter_error if sizes do not fit, if eigenvalues are not finite, ascending and not
/// negative, or if a time is not positive and finite
///
/// Takes one product for each point, eigenvalue and time.
Eigen::MatrixXd heat_kernel_signature(const Eigen::VectorXd& eigenvalues,
                                      const Eigen::Ref<const Eigen::MatrixXd>& values,
                                      const Eigen::VectorXd& times,
                                      Heat_kernel_scaling scaling = Heat_kernel_scaling::none);

/// \ingroup PkgRestrictedLaplacian3Descriptors
/// The same at the vertices, for a `Laplace_spectrum`.
template <class Spectrum, internal::Require_spectrum<Spectrum> = 0>
Eigen::MatrixXd heat_kernel_signature(const Spectrum& spectrum, const Eigen::VectorXd& times,
                                      Heat_kernel_scaling scaling = Heat_kernel_scaling::none) {
  return heat_kernel_signature(internal::eigenvalues_of(spectrum), spectrum.vertex_values, times,
                               scaling);
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/spectra/heat_kernel_signature_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_HEAT_KERNEL_SIGNATURE_H
