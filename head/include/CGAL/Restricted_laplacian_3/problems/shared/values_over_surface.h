// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_SHARED_VALUES_OVER_SURFACE_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_SHARED_VALUES_OVER_SURFACE_H

#include <CGAL/Restricted_laplacian_3/splines/Spline_functions_3.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>
#include <CGAL/Restricted_laplacian_3/surface/Surface_location.h>
#include <CGAL/Restricted_laplacian_3/surface/sample_surface.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

constexpr std::size_t largest_number_of_places = 20000;

/// Places that are spread over a surface of triangles by area: the same for the same surface and
/// number.
inline std::vector<Surface_location>
places_over_surface(const Triangulated_surface_3& surface,
                    std::size_t number = largest_number_of_places) {
  return sample_surface(surface, number, 1, Sampling::stratified);
}

/// Values of functions at such places, or at all points of a point set: a row for each place, a
/// column for each function.
inline Eigen::MatrixXd values_over_surface(const Spline_space_3& space,
                                           const Eigen::MatrixXd& coefficients,
                                           std::size_t number = largest_number_of_places) {
  const Spline_functions_3 functions(space, coefficients);
  if(space.surface().is_point_set())
    return functions.values_at_vertices();
  return functions.values_at_locations(places_over_surface(space.surface(), number));
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_SHARED_VALUES_OVER_SURFACE_H
