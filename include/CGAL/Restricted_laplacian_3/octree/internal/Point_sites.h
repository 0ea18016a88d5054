// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_INTERNAL_POINT_SITES_H
#define CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_INTERNAL_POINT_SITES_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/parallel_for.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/stable_sort_by_key.h>
#include <CGAL/Restricted_laplacian_3/octree/Cell_3.h>
#include <CGAL/Restricted_laplacian_3/octree/internal/Finest_sheets.h>
#include <CGAL/Restricted_laplacian_3/octree/internal/Piece_sorter.h>
#include <CGAL/Restricted_laplacian_3/octree/internal/element_masks.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// The points of a point set, each as a fragment of its own face, sorted by the finest cell that
/// owns it, and by number in a cell: what `cut_faces()` is for triangles. Cells are half-open: a
/// point on a wall belongs to the upper one of its cells, except in the last wall.
/// \param points in the grid of the finest cells, as the clipper has snapped them
inline std::vector<Cell_fragment> sort_points(const std::vector<std::array<double, 3>>& points,
                                              const Octree_limits& limits, bool is_parallel) {
  limits.check_fragments(points.size());
  const int last = (1 << limits.depth) - 1;
  const std::array<double, 3> direction = sorting_direction();
  std::vector<Cell_fragment> result(points.size());
  const std::size_t grain = 1 << 15;
  parallel_for(is_parallel, 0, points.size(), grain, [&](std::size_t begin, std::size_t end) {
    for(std::size_t i = begin; i < end; ++i) {
      const std::array<double, 3>& p = points[i];
      std::array<int, 3> cell;
      double position = 0;
      for(int axis = 0; axis < 3; ++axis) {
        cell[axis] = (std::min)(static_cast<int>(p[axis]), last); // no coordinate is negative
        position += direction[axis] * p[axis];
      }
      // Areas may be 0: the centroid of a sheet is that of its points, all with the same weight.
      result[i] = {
          morton_key(cell), static_cast<std::uint32_t>(i), element_mask(p, cell), {1, position}};
    }
  });
  stable_sort_by_key(result, 3 * limits.depth, is_parallel,
                     [](const Cell_fragment& fragment) { return fragment.key; });
  return result;
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_INTERNAL_POINT_SITES_H
