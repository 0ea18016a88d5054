// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_INTERNAL_DOMAIN_CUBE_H
#define CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_INTERNAL_DOMAIN_CUBE_H

#include <CGAL/Restricted_laplacian_3/surface/Surface_location.h>

#include <array>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// The root of an octree.
struct Domain_cube {
  Point_3 center;
  double side = 0;

  /// coordinates in the grid of a level, in units of the cell width
  std::array<double, 3> grid_coordinates(int level, const Point_3& p) const {
    const double cells_per_side = static_cast<double>(1 << level);
    std::array<double, 3> x;
    for(int axis = 0; axis < 3; ++axis)
      x[axis] = ((p[axis] - center[axis]) / side + 0.5) * cells_per_side;
    return x;
  }
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_INTERNAL_DOMAIN_CUBE_H
