// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_SHAPE_DNA_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_SHAPE_DNA_IMPL_H

#include <CGAL/Restricted_laplacian_3/spectra/shape_dna.h>

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>

#include <Eigen/Core>

#include <string>

namespace CGAL {
namespace Restricted_laplacian_3 {
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

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Eigen::VectorXd
shape_dna(const Eigen::VectorXd& eigenvalues, double area, Shape_dna_normalization normalization) {
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

CGAL_RESTRICTED_LAPLACIAN_3_INLINE double shape_dna_distance(const Eigen::VectorXd& a,
                                                             const Eigen::VectorXd& b) {
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

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_SHAPE_DNA_IMPL_H
