// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_INTERNAL_POINTS_IN_GRID_H
#define CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_INTERNAL_POINTS_IN_GRID_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/parallel_for.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/stable_sort_by_key.h>
#include <CGAL/Restricted_laplacian_3/foundation/morton_key.h>
#include <CGAL/Restricted_laplacian_3/octree/internal/Point_links.h>
#include <CGAL/Restricted_laplacian_3/octree/internal/Surface_in_grid.h>
#include <CGAL/Restricted_laplacian_3/octree/shared/element_masks.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// The points of a point set, each a fragment of its own face. Sheets are points that are linked.
class Points_in_grid : public Surface_in_grid {
public:
  explicit Points_in_grid(Grid_input input) : m_input(std::move(input)) {
    if(m_input.is_split)
      m_links.emplace(m_input.surface, m_input.is_parallel);
  }

  std::size_t estimated_number_of_fragments() const override {
    return m_input.surface.number_of_vertices();
  }

  /// Cells are half-open: a point on a wall belongs to the upper one of its cells, except in the
  /// last wall.
  std::vector<Cell_fragment> fragments(std::size_t /*window*/) const override {
    const int last = m_input.vertices.cells_per_side() - 1;
    const std::array<double, 3> direction = sorting_direction();
    std::vector<Cell_fragment> result(m_input.surface.number_of_vertices());
    const std::size_t grain = 1 << 15;
    parallel_for(
        m_input.is_parallel, 0, m_input.surface.number_of_vertices(), grain,
        [&](std::size_t begin, std::size_t end) {
          for(std::size_t i = begin; i < end; ++i) {
            const Grid_vertices::Point p = m_input.vertices[i];
            std::array<int, 3> cell;
            double position = 0;
            for(int axis = 0; axis < 3; ++axis) {
              cell[axis] = (std::min)(static_cast<int>(p[axis]), last); // no coordinate is negative
              position += direction[axis] * p[axis];
            }
            const std::uint32_t mask = element_mask_of_range(
                [&](int axis) {
                  return std::array<double, 2>{p[axis], p[axis]};
                },
                cell);
            // Areas may be 0: the centroid of a sheet is that of its points, all with the same
            // weight.
            result[i] = {morton_key(cell), static_cast<std::uint32_t>(i), mask, {1, position}};
          }
        });
    if(m_input.filter)
      result.erase(std::remove_if(
                       result.begin(), result.end(),
                       [&](const Cell_fragment& fragment) { return !m_input.wants(fragment.key); }),
                   result.end());
    stable_sort_by_key(result, 3 * m_input.vertices.depth(), m_input.is_parallel,
                       [](const Cell_fragment& fragment) { return fragment.key; });
    return result;
  }

  void join(const Cell_fragment* fragments, std::uint32_t size,
            Sheet_scratch& scratch) const override {
    m_links->join(fragments, size, scratch.sets);
  }

  void link(const Octree_level& finest, Links& links) const override {
    std::vector<std::uint32_t> sheet_of_point(m_input.surface.number_of_vertices());
    for(std::uint32_t sheet = 0; sheet < finest.number_of_sheets(); ++sheet)
      for(std::uint32_t point : finest.faces[sheet])
        sheet_of_point[point] = sheet;
    for(std::size_t i = 0; i < sheet_of_point.size(); ++i)
      for(std::uint32_t j : (*m_links)[i])
        if(sheet_of_point[i] != sheet_of_point[j])
          links.emplace_back(sheet_of_point[i], sheet_of_point[j]);
  }

private:
  Grid_input m_input;
  std::optional<Point_links> m_links; // of a set that is split
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_INTERNAL_POINTS_IN_GRID_H
