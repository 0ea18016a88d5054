// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_SHAPE_DNA_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_SHAPE_DNA_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>
#include <CGAL/Restricted_laplacian_3/spectra/zero_eigenvalues.h>

#include <Eigen/Core>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Descriptors
/// What makes a ShapeDNA independent of the size of the surface.
enum class Shape_dna_normalization {
  /// nothing: surfaces of different size are different; units of 1 / area
  none,
  /// eigenvalues are multiplied with the area
  area,
  /// eigenvalues are divided by the first that is not 0
  first_eigenvalue,
  /// Eigenvalues \f$\lambda_i\f$ are divided by the slope of the line
  /// through the points \f$(i, \lambda_i)\f$ that has the least squares of differences. By Weyl's
  /// law it approaches \f$4 \pi / \mathrm{area}\f$ for many eigenvalues.
  weyl_slope
};

/// \ingroup PkgRestrictedLaplacian3Descriptors
/// The ShapeDNA of Reuter, Wolter and Peinecke \cgalCite{RWP06}: the beginning of the spectrum, in
/// a form that does not depend on size. Nor does it depend on position and triangulation of the
/// surface, and little on bending.
///
/// All eigenvalues are returned, also zeros (see `zero_eigenvalue_tolerance`), as exactly 0: the
/// first for a closed or an open surface with the natural condition, and one for each further
/// component.
///
/// \param eigenvalues ascending, in units of 1 / area
/// \param area of the surface; used with `Shape_dna_normalization::area` only
/// \param normalization what makes the result independent of size
/// \throws Parameter_error if eigenvalues are not finite, ascending and not negative; if the area
/// is needed and is not positive and finite; if the first eigenvalue or the slope is needed, and
/// all are 0
Eigen::VectorXd shape_dna(const Eigen::VectorXd& eigenvalues, double area,
                          Shape_dna_normalization normalization = Shape_dna_normalization::area);

/// \ingroup PkgRestrictedLaplacian3Descriptors
/// The Shape-DNA of a `Laplace_spectrum`, which knows the area.
template <class Spectrum, internal::Require_spectrum<Spectrum> = 0>
Eigen::VectorXd shape_dna(const Spectrum& spectrum,
                          Shape_dna_normalization normalization = Shape_dna_normalization::area) {
  return shape_dna(internal::eigenvalues_of(spectrum), spectrum.area, normalization);
}

/// \ingroup PkgRestrictedLaplacian3Descriptors
/// The Euclidean distance of two ShapeDNAs, which is the one that \cgalCite{RWP06} uses. It is a
/// metric on sequences, not on surfaces: some different surfaces have the same spectrum.
/// \throws Parameter_error if they do not have the same positive number of eigenvalues (take
/// `head()` of the longer one), or if an entry is not finite
double shape_dna_distance(const Eigen::VectorXd& a, const Eigen::VectorXd& b);

} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/spectra/shape_dna_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_SHAPE_DNA_H
