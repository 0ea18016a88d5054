// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_SHARED_WALL_CROSSINGS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_SHARED_WALL_CROSSINGS_H

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// The parameters, ascending, at which a segment from `p` (0) to `q` (1) begins, crosses walls, and
/// ends. Coordinates are in units of the cell width.
inline std::vector<double> wall_crossings(const std::array<double, 3>& p,
                                          const std::array<double, 3>& q) {
  std::vector<double> result = {0, 1};
  for(int axis = 0; axis < 3; ++axis) {
    const double high = (std::max)(p[axis], q[axis]);
    for(double wall = std::floor((std::min)(p[axis], q[axis])) + 1; wall < high; ++wall)
      result.push_back((wall - p[axis]) / (q[axis] - p[axis]));
  }
  std::sort(result.begin(), result.end());
  return result;
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_SHARED_WALL_CROSSINGS_H
