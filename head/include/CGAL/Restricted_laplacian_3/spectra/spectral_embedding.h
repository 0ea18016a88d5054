// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_SPECTRAL_EMBEDDING_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_SPECTRAL_EMBEDDING_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>
#include <CGAL/Restricted_laplacian_3/spectra/zero_eigenvalues.h>

#include <Eigen/Core>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Descriptors
/// The global point signature of Rustamov \cgalCite{Rus07}.
/// \f[ \mathrm{GPS}(x) = \left( \frac{\phi_i(x)}{\sqrt{\lambda_i}} \right)_{\lambda_i > 0} . \f]
/// The scalar product of two rows is Green's function
/// \f$g(x, y) = \sum_i \phi_i(x) \phi_i(y) / \lambda_i\f$ of \f$-\Delta\f$, as far as the sum goes;
/// it grows like a logarithm as \f$y\f$ approaches \f$x\f$, so the distance of two rows does not
/// converge with the number of eigenvalues.
///
/// Zero eigenvalues (see `zero_eigenvalue_tolerance`) are left out. Points on different connected
/// components can be compared, but what they have in common means nothing. The sign of a column,
/// and the basis of a multiple eigenvalue, are arbitrary: scalar products and distances of rows do
/// not depend on them.
///
/// \param eigenvalues \f$\lambda\f$, ascending, in units of 1 / area
/// \param values \f$\phi\f$: a row for each point, a column for each eigenvalue, with
/// \f$\int \phi_i^2 = 1\f$. A row of NaN, as for points that are not on the surface, gives one.
/// \return a row for each point, a column for each eigenvalue that is not 0; without unit
/// \throws Parameter_error if sizes do not fit, if eigenvalues are not finite, ascending and not
/// negative, or if all of them are 0
Eigen::MatrixXd global_point_signature(const Eigen::VectorXd& eigenvalues,
                                       const Eigen::Ref<const Eigen::MatrixXd>& values);

/// \ingroup PkgRestrictedLaplacian3Descriptors
/// The diffusion map of the vertices, from a `Laplace_spectrum`.
template <class Spectrum, internal::Require_spectrum<Spectrum> = 0>
Eigen::MatrixXd global_point_signature(const Spectrum& spectrum) {
  return global_point_signature(internal::eigenvalues_of(spectrum), spectrum.vertex_values);
}

/// \ingroup PkgRestrictedLaplacian3Descriptors
/// Biharmonic coordinates: \f$(\phi_i(x) / \lambda_i)_{\lambda_i > 0}\f$. The Euclidean distance of
/// two rows is the biharmonic distance of Lipman, Rustamov and Funkhouser \cgalCite{LRF10},
/// \f[ d(x, y)^2 = \sum_i \frac{(\phi_i(x) - \phi_i(y))^2}{\lambda_i^2} , \f]
/// a metric on each connected component, as far as the sum goes. What \f$K\f$ eigenvalues leave out
/// of the square is \f$\mathrm{area} / (8 \pi^2 K)\f$ on average, by Weyl's law.
///
/// Zero eigenvalues are left out, and what is said at `global_point_signature()` on components,
/// signs and bases holds here too.
///
/// \param eigenvalues,values as for `global_point_signature()`
/// \return a row for each point, a column for each eigenvalue that is not 0; in units of length
/// \throws Parameter_error as `global_point_signature()`
Eigen::MatrixXd biharmonic_embedding(const Eigen::VectorXd& eigenvalues,
                                     const Eigen::Ref<const Eigen::MatrixXd>& values);

/// \ingroup PkgRestrictedLaplacian3Descriptors
/// The same at the vertices, for a `Laplace_spectrum`.
template <class Spectrum, internal::Require_spectrum<Spectrum> = 0>
Eigen::MatrixXd biharmonic_embedding(const Spectrum& spectrum) {
  return biharmonic_embedding(internal::eigenvalues_of(spectrum), spectrum.vertex_values);
}

/// \ingroup PkgRestrictedLaplacian3Descriptors
/// The diffusion map of Coifman and Lafon \cgalCite{CL06}: \f$(e^{-\lambda_i t} \phi_i(x))_i\f$.
/// The Euclidean distance of two rows is the diffusion distance,
/// \f[ d_t(x, y)^2 = \sum_i e^{-2 \lambda_i t} (\phi_i(x) - \phi_i(y))^2
///                 = \int (k_t(x, z) - k_t(y, z))^2\, dz , \f]
/// how differently heat has spread from both after the time \f$t\f$.
///
/// Zero eigenvalues take part, with the factor 1. On a connected surface their one column is
/// constant, and changes no distance; with several components it keeps points of different ones
/// apart at all times.
///
/// \param eigenvalues,values as for `global_point_signature()`
/// \param time \f$t\f$, in units of area
/// \return a row for each point, a column for each eigenvalue; in units of 1 / length
/// \throws Parameter_error if sizes do not fit, if eigenvalues are not finite, ascending and not
/// negative, or if the time is not positive and finite
Eigen::MatrixXd diffusion_map(const Eigen::VectorXd& eigenvalues,
                              const Eigen::Ref<const Eigen::MatrixXd>& values, double time);

/// \ingroup PkgRestrictedLaplacian3Descriptors
/// The same at the vertices, for a `Laplace_spectrum`.
template <class Spectrum, internal::Require_spectrum<Spectrum> = 0>
Eigen::MatrixXd diffusion_map(const Spectrum& spectrum, double time) {
  return diffusion_map(internal::eigenvalues_of(spectrum), spectrum.vertex_values, time);
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/spectra/spectral_embedding_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_SPECTRAL_EMBEDDING_H
