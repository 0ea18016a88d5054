// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_INTERNAL_REQUIRE_ENOUGH_POINTS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_INTERNAL_REQUIRE_ENOUGH_POINTS_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>

#include <cstddef>
#include <string>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// The least number of points that determine the gradients of functions of a level: three for four
/// functions.
inline std::size_t least_number_of_points(const Spline_space_3& space, int level) {
  return (3 * space.dimension(level) + 3) / 4;
}

/// Refuses a set of points with too many functions for it: gradients are known at the points alone,
/// and then there are functions that change from point to point without a gradient at any of them.
/// What is computed with gradients has no meaning.
/// \throws Input_error says what depth there are enough for, if there is one
inline void require_enough_points(const Spline_space_3& space) {
  const Triangulated_surface_3& surface = space.surface();
  if(!surface.is_point_set())
    return;
  std::size_t points = 0;
  for(std::size_t i = 0; i < surface.number_of_faces(); ++i)
    points += surface.is_degenerate(i) ? 0 : 1;
  const std::size_t least = least_number_of_points(space, space.depth());
  if(points >= least)
    return;
  int possible = space.depth() - 1;
  while(possible > 0 && points < least_number_of_points(space, possible))
    --possible;
  throw Input_error("the " + std::to_string(points) + " points do not determine the " +
                    std::to_string(space.dimension()) + " functions of depth " +
                    std::to_string(space.depth()) + ", which takes " + std::to_string(least) +
                    (possible > 0 ? "; depth " + std::to_string(possible) + " is possible" : ""));
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_INTERNAL_REQUIRE_ENOUGH_POINTS_H
