// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_INTERNAL_GRID_VERTICES_H
#define CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_INTERNAL_GRID_VERTICES_H

#include <CGAL/Restricted_laplacian_3/octree/clip_to_cells.h>
#include <CGAL/Restricted_laplacian_3/octree/internal/Domain_cube.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>

#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// The vertices of a surface in the grid of the finest cells of an octree, in units of the cell
/// width, as the clipper sees them: on the walls that they are near to. They are not stored, but
/// computed when they are asked for.
class Grid_vertices {
public:
  using Point = std::array<double, 3>;

  /// \param surface must outlive this object
  /// \param cube the root of the octree
  /// \param depth of the finest cells
  /// \param clipper that of the octree
  Grid_vertices(const Triangulated_surface_3& surface, const Domain_cube& cube, int depth,
                const Cell_clipper& clipper)
    : m_surface(surface), m_cube(cube), m_depth(depth), m_clipper(clipper) {}

  /// depth of the finest cells
  int depth() const { return m_depth; }
  /// their width, in units of the coordinates of the surface
  double cell_width() const { return std::ldexp(m_cube.side, -m_depth); }
  /// number of cells along an axis
  int cells_per_side() const { return 1 << m_depth; }

  /// a vertex, which must have a face
  Point operator[](std::size_t vertex) const {
    return m_clipper.snapped(m_cube.grid_coordinates(m_depth, m_surface.point(vertex)));
  }
  /// the corners of a face
  std::array<Point, 3> corners(std::size_t face) const {
    const auto& t = m_surface.triangle(face);
    return {(*this)[t[0]], (*this)[t[1]], (*this)[t[2]]};
  }

private:
  const Triangulated_surface_3& m_surface;
  Domain_cube m_cube;
  int m_depth;
  Cell_clipper m_clipper;
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_INTERNAL_GRID_VERTICES_H
