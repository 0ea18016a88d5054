// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_SHAPE_DNA_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_SHAPE_DNA_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/spectra/zero_eigenvalues.h>

#include <Eigen/Core>

#include <string>

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

namespace internal {

/// slope of the line through \f$(i, y_i)\f$ by least squares
inline double fitted_slope(const Eigen::VectorXd& y) {
  const double mean = double(y.size() - 1) / 2;
  double xy = 0, xx = 0;
  for(Eigen::Index i = 0; i < y.size(); ++i) {
    const double x = double(i) - mean;
    xy += x * y[i];
    xx += x * x;
  }
  return xy / xx;
}

} // namespace internal

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
inline Eigen::VectorXd
shape_dna(const Eigen::VectorXd& eigenvalues, double area,
          Shape_dna_normalization normalization = Shape_dna_normalization::area) {
  const Eigen::VectorXd checked = internal::checked_eigenvalues(eigenvalues);
  switch(normalization) {
  case Shape_dna_normalization::area: internal::check_positive("area", area); return checked * area;
  case Shape_dna_normalization::first_eigenvalue:
    return checked / checked[internal::number_of_zeros_before_others(checked)];
  case Shape_dna_normalization::weyl_slope: {
    internal::number_of_zeros_before_others(checked);
    const double slope = checked.size() > 1 ? internal::fitted_slope(checked) : 0;
    if(!(slope > 0))
      throw Parameter_error("eigenvalues", "has no two different entries, so there is no slope");
    return checked / slope;
  }
  case Shape_dna_normalization::none: break;
  }
  return checked;
}

/// \ingroup PkgRestrictedLaplacian3Descriptors
/// The same for a `Laplace_spectrum`, which knows its area.
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
inline double shape_dna_distance(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  if(a.size() != b.size() || a.size() == 0)
    throw Parameter_error("b", "has " + std::to_string(b.size()) +
                                   " eigenvalues, the other ShapeDNA " + std::to_string(a.size()) +
                                   ", but they must have the same positive number");
  if(!a.allFinite() || !b.allFinite())
    throw Parameter_error(a.allFinite() ? "b" : "a", "has an entry that is not a finite number");
  return (a - b).norm();
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_SHAPE_DNA_H
