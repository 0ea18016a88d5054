// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_STABILIZATION_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_STABILIZATION_IMPL_H

#include <CGAL/Restricted_laplacian_3/problems/stabilization.h>

#include <algorithm>

namespace CGAL {
namespace Restricted_laplacian_3 {

CGAL_RESTRICTED_LAPLACIAN_3_INLINE double
default_normal_stabilization(const Spline_space_3& space) {
  return space.is_paper_space() ? 0 : 1e-3;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE double
default_spectrum_stabilization(const Spline_space_3& space) {
  return space.is_paper_space() ? 0 : 1e-5;
}

namespace internal {

/// the smoothing weight in units of the squared cell width
inline double smoothing_in_cells(const Spline_space_3& space, double smoothing_weight) {
  const double h = space.octree().cell_width(space.depth());
  return smoothing_weight / (h * h);
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE double default_fit_tolerance(const Spline_space_3& space,
                                                                double smoothing_weight) {
  constexpr double least_smoothing = 1e-3;
  return smoothing_in_cells(space, smoothing_weight) <= least_smoothing ? 0.1 : 0;
}

} // namespace internal

CGAL_RESTRICTED_LAPLACIAN_3_INLINE double default_fit_stabilization(const Spline_space_3& space,
                                                                    double smoothing_weight) {
  constexpr double smallest = 1e-14, largest = 1e-4, of_smoothing = 1e-3;
  return std::clamp(of_smoothing * internal::smoothing_in_cells(space, smoothing_weight), smallest,
                    largest);
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_STABILIZATION_IMPL_H
