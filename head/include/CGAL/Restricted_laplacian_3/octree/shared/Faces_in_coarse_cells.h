// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_SHARED_FACES_IN_COARSE_CELLS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_SHARED_FACES_IN_COARSE_CELLS_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/parallel_for.h>
#include <CGAL/Restricted_laplacian_3/foundation/morton_key.h>
#include <CGAL/Restricted_laplacian_3/octree/internal/Grid_vertices.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// The coarse cells that faces meet, and how many fragments they have.
class Faces_in_coarse_cells {
public:
  /// faces that a thread takes at once
  static constexpr std::size_t grain = std::size_t(1) << 16;

  /// \param level of the coarse cells
  Faces_in_coarse_cells(const Triangulated_surface_3& surface, const Grid_vertices& vertices,
                        int level, double margin)
    : m_surface(surface), m_vertices(vertices),
      m_cell_width(static_cast<double>(vertices.cells_per_side() >> level)),
      m_cell_area(vertices.cell_width() * vertices.cell_width()),
      m_margin((std::min)(margin, static_cast<double>(vertices.cells_per_side()))),
      m_last((1 << level) - 1) {}

  std::size_t number_of_faces() const { return m_surface.number_of_faces(); }
  std::size_t number_of_chunks() const { return (number_of_faces() - 1) / grain + 1; }
  /// calls `visit(chunk, begin, end)` for chunks of faces, perhaps on several threads
  template <class Visitor> void for_each_chunk(bool is_parallel, Visitor&& visit) const {
    parallel_for(is_parallel, 0, number_of_faces(), grain,
                 [&](std::size_t begin, std::size_t end) { visit(begin / grain, begin, end); });
  }

  /// area of a face over that of a side of the finest cells
  double relative_area(std::size_t face) const { return m_surface.area(face) / m_cell_area; }

  /// Each wall that a small triangle crosses adds a fragment to the first one; the inside of a
  /// large one has 3/2 to the area of a cell in the mean over all directions.
  double estimated_number_of_fragments(std::size_t face) const {
    const Box box = bounding_box(m_vertices.corners(face));
    double number = 1 + 1.5 * relative_area(face);
    for(int axis = 0; axis < 3; ++axis)
      number += box.high[axis] - box.low[axis];
    return number;
  }

  /// Calls `visit(key)` for the cells that a face meets or comes near, and perhaps for others that
  /// its bounding box does, and its plane.
  template <class Visitor> void for_each_cell(std::size_t face, Visitor&& visit) const {
    const std::array<Point, 3> corners = m_vertices.corners(face);
    const Box box = bounding_box(corners);
    std::array<int, 3> low, high, cell;
    std::size_t number = 1;
    for(int axis = 0; axis < 3; ++axis) {
      low[axis] = clamped((box.low[axis] - m_margin) / m_cell_width);
      high[axis] = clamped((box.high[axis] + m_margin) / m_cell_width);
      number *= static_cast<std::size_t>(high[axis] - low[axis] + 1);
    }
    if(number == 1) {
      visit(morton_key(low));
      return;
    }
    for(cell[2] = low[2]; cell[2] <= high[2]; ++cell[2])
      for(cell[1] = low[1]; cell[1] <= high[1]; ++cell[1])
        for(cell[0] = low[0]; cell[0] <= high[0]; ++cell[0])
          if(number <= few || meets_plane(face, corners[0], cell))
            visit(morton_key(cell));
  }

private:
  using Point = Grid_vertices::Point;
  struct Box {
    Point low, high;
  };
  /// so many cells are taken without a look at the plane
  static constexpr std::size_t few = 8;

  static Box bounding_box(const std::array<Point, 3>& p) {
    Box box;
    for(int axis = 0; axis < 3; ++axis) {
      box.low[axis] = (std::min)({p[0][axis], p[1][axis], p[2][axis]});
      box.high[axis] = (std::max)({p[0][axis], p[1][axis], p[2][axis]});
    }
    return box;
  }

  int clamped(double x) const {
    return (std::min)((std::max)(static_cast<int>(std::floor(x)), 0), m_last);
  }

  bool meets_plane(std::size_t face, const Point& p, const std::array<int, 3>& cell) const {
    // far more than rounding errors
    constexpr double reserve = 1e-3;
    if(m_surface.is_degenerate(face))
      return true;
    const Vector_3 n = m_surface.normal(face);
    const double radius = (0.5 + reserve) * m_cell_width + m_margin;
    double distance = 0, reach = 0;
    for(int axis = 0; axis < 3; ++axis) {
      distance += n[axis] * ((cell[axis] + 0.5) * m_cell_width - p[axis]);
      reach += std::abs(n[axis]) * radius;
    }
    return std::abs(distance) <= reach;
  }

  const Triangulated_surface_3& m_surface;
  const Grid_vertices& m_vertices;
  double m_cell_width; // in units of the finest cells
  double m_cell_area;  // of those, in units of the coordinates
  double m_margin;
  int m_last;
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_SHARED_FACES_IN_COARSE_CELLS_H
