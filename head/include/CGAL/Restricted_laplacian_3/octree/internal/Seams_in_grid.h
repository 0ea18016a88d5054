// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_INTERNAL_SEAMS_IN_GRID_H
#define CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_INTERNAL_SEAMS_IN_GRID_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/parallel_for.h>
#include <CGAL/Restricted_laplacian_3/foundation/morton_key.h>
#include <CGAL/Restricted_laplacian_3/octree/internal/Finest_sheets.h>
#include <CGAL/Restricted_laplacian_3/octree/internal/Grid_vertices.h>
#include <CGAL/Restricted_laplacian_3/octree/shared/wall_crossings.h>
#include <CGAL/Restricted_laplacian_3/surface/Surface_seams.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// The seams of a surface in the grid of the finest cells: which faces they join in a cell, and
/// where they lie in walls.
class Seams_in_grid {
public:
  using Point = Grid_vertices::Point;

  /// \param surface,seams must outlive this object
  /// \param vertices of the surface
  /// \param width distance, in the same units, that the sides of one seam may be apart if they are
  /// not the same edge
  Seams_in_grid(const Triangulated_surface_3& surface, const Surface_seams& seams,
                const Grid_vertices& vertices, double width)
    : m_surface(surface), m_seams(seams), m_vertices(vertices), m_width((std::min)(width, 0.5)) {}

  /// Joins those fragments, all in one cell, whose faces have sides of the same seam that run
  /// through the closed cell for more than a point.
  void join(const Cell_fragment* fragments, std::uint32_t size, Sheet_scratch& scratch) const {
    scratch.sets.reset(size);
    if(size == 1)
      return;
    const std::array<int, 3> cell = morton_index(fragments->key);
    auto& sides = scratch.sides;
    sides.clear();
    for(std::uint32_t i = 0; i < size; ++i) {
      const std::size_t face = fragments[i].face;
      const std::array<Point, 3> corners = m_vertices.corners(face);
      for(int side = 0; side < 3; ++side)
        if(runs_in_cell(side_of(face, corners, side), cell))
          sides.emplace_back(m_seams.seam(face, side), i);
    }
    std::sort(sides.begin(), sides.end());
    for(std::size_t k = 1; k < sides.size(); ++k)
      if(sides[k].first == sides[k - 1].first)
        scratch.sets.unite(sides[k].second, sides[k - 1].second);
  }

  /// Calls `visit(low, high, faces)` for the pieces, between walls, of all sides that lie in a wall
  /// or belong to a seam of sides that are not the same edge: the smallest and the largest cell
  /// that touch the piece, and the faces of the seam.
  template <class Visitor> void for_each_piece_in_walls(bool is_parallel, Visitor&& visit) const {
    const std::vector<Special_side> sides = special_sides(is_parallel);
    std::vector<std::uint32_t> faces;
    for(std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
      faces.clear();
      for(; end < sides.size() && sides[end].seam == sides[begin].seam; ++end)
        if(faces.empty() || faces.back() != sides[end].face)
          faces.push_back(sides[end].face);
      if(faces.size() == 1)
        continue;
      // the sides of a plain seam are all the same
      const bool is_united = m_seams.is_united(sides[begin].seam);
      for(std::size_t i = begin; i < (is_united ? end : begin + 1); ++i)
        for_each_piece(sides[i].face, sides[i].number, is_united ? m_width : 0,
                       [&](const std::array<int, 3>& low, const std::array<int, 3>& high) {
                         visit(low, high, faces);
                       });
    }
  }

private:
  /// length, in units of the cell width, up to which a piece counts as a point
  static constexpr double shortest_piece = 1e-9;

  struct Segment {
    Point p, q;
  };
  struct Special_side {
    Surface_seams::Key seam;
    std::uint32_t face;
    int number;
  };

  /// from the lower to the upper vertex, so that all faces of an edge see the same
  Segment side_of(std::size_t face, const std::array<Point, 3>& corners, int side) const {
    const auto& t = m_surface.triangle(face);
    const int next = side == 2 ? 0 : side + 1;
    return t[side] < t[next] ? Segment{corners[side], corners[next]}
                             : Segment{corners[next], corners[side]};
  }

  static bool is_in_wall(const Segment& s) {
    for(int axis = 0; axis < 3; ++axis)
      if(s.p[axis] == s.q[axis] && s.p[axis] == std::floor(s.p[axis]))
        return true;
    return false;
  }

  /// those that lie in a wall or belong to a united seam, sorted by seam and face
  std::vector<Special_side> special_sides(bool is_parallel) const {
    const std::size_t number_of_faces = m_surface.number_of_faces(), grain = 1 << 15;
    std::vector<std::vector<Special_side>> of_chunks((number_of_faces - 1) / grain + 1);
    parallel_for(is_parallel, 0, number_of_faces, grain, [&](std::size_t begin, std::size_t end) {
      for(std::size_t face = begin; face < end; ++face) {
        const std::array<Point, 3> corners = m_vertices.corners(face);
        for(int side = 0; side < 3; ++side) {
          const Surface_seams::Key seam = m_seams.seam(face, side);
          if(is_in_wall(side_of(face, corners, side)) || m_seams.is_united(seam))
            of_chunks[begin / grain].push_back({seam, static_cast<std::uint32_t>(face), side});
        }
      }
    });
    std::vector<Special_side> sides;
    for(const auto& of_chunk : of_chunks)
      sides.insert(sides.end(), of_chunk.begin(), of_chunk.end());
    std::stable_sort(sides.begin(), sides.end(),
                     [](const Special_side& a, const Special_side& b) { return a.seam < b.seam; });
    return sides;
  }

  static bool is_strictly_inside(const Point& p, const std::array<int, 3>& cell) {
    return p[0] > cell[0] && p[0] < cell[0] + 1 && p[1] > cell[1] && p[1] < cell[1] + 1 &&
           p[2] > cell[2] && p[2] < cell[2] + 1;
  }

  /// whether a segment has more than a point in common with a closed cell
  static bool runs_in_cell(const Segment& segment, const std::array<int, 3>& cell) {
    const auto& [p, q] = segment;
    if(is_strictly_inside(p, cell) || is_strictly_inside(q, cell))
      return true;
    double t0 = 0, t1 = 1, length = 0;
    for(int axis = 0; axis < 3; ++axis) {
      const double low = cell[axis], high = low + 1, d = q[axis] - p[axis];
      if(d == 0) {
        if(p[axis] < low || p[axis] > high)
          return false;
        continue;
      }
      const double u = (low - p[axis]) / d, v = (high - p[axis]) / d;
      t0 = (std::max)(t0, (std::min)(u, v));
      t1 = (std::min)(t1, (std::max)(u, v));
      if(!(t0 < t1))
        return false;
      length = (std::max)(length, std::abs(d));
    }
    return (t0 == 0 && t1 == 1) || (t1 - t0) * length > shortest_piece;
  }

  template <class Visitor>
  void for_each_piece(std::size_t face, int side, double width, Visitor&& visit) const {
    const auto [p, q] = side_of(face, m_vertices.corners(face), side);
    const std::vector<double> cuts = wall_crossings(p, q);
    double length = 0;
    for(int axis = 0; axis < 3; ++axis)
      length = (std::max)(length, std::abs(q[axis] - p[axis]));
    for(std::size_t i = 1; i < cuts.size(); ++i) {
      if(cuts.size() > 2 && (cuts[i] - cuts[i - 1]) * length <= shortest_piece)
        continue;
      const double t = (cuts[i] + cuts[i - 1]) / 2;
      std::array<int, 3> low, high;
      for(int axis = 0; axis < 3; ++axis) {
        const double x = p[axis] + t * (q[axis] - p[axis]);
        const int last = m_vertices.cells_per_side() - 1;
        low[axis] = (std::min)((std::max)(static_cast<int>(std::ceil(x - width)) - 1, 0), last);
        high[axis] = (std::min)((std::max)(static_cast<int>(std::floor(x + width)), 0), last);
      }
      visit(low, high);
    }
  }

  const Triangulated_surface_3& m_surface;
  const Surface_seams& m_seams;
  Grid_vertices m_vertices;
  double m_width;
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_INTERNAL_SEAMS_IN_GRID_H
