// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_INTERNAL_SEAMS_IN_GRID_H
#define CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_INTERNAL_SEAMS_IN_GRID_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/Number_lists.h>
#include <CGAL/Restricted_laplacian_3/foundation/morton_key.h>
#include <CGAL/Restricted_laplacian_3/octree/internal/Finest_sheets.h>
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
  using Point = std::array<double, 3>;

  /// \param surface,seams,points must outlive this object
  /// \param points of the vertices, in units of the cell width, on the walls if near to them
  /// \param cells_per_side number of cells along an axis
  /// \param width distance, in the same units, that the sides of one seam may be apart if they are
  /// not the same edge
  Seams_in_grid(const Triangulated_surface_3& surface, const Surface_seams& seams,
                const std::vector<Point>& points, int cells_per_side, double width)
    : m_surface(surface), m_seams(seams), m_points(points), m_cells_per_side(cells_per_side),
      m_width((std::min)(width, 0.5)) {}

  /// Joins those fragments, all in one cell, whose faces have sides of the same seam that run
  /// through the closed cell for more than a point.
  void join(const Cell_fragment* fragments, std::uint32_t size, Sheet_scratch& scratch) const {
    scratch.sets.reset(size);
    if(size == 1)
      return;
    const std::array<int, 3> cell = morton_index(fragments->key);
    auto& sides = scratch.sides;
    sides.clear();
    for(std::uint32_t i = 0; i < size; ++i)
      for(int side = 0; side < 3; ++side) {
        const std::size_t face = fragments[i].face;
        const auto [p, q] = ends(face, side);
        if(runs_in_cell(*p, *q, cell))
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
  template <class Visitor> void for_each_piece_in_walls(Visitor&& visit) const {
    const std::size_t number_of_faces = m_surface.number_of_faces();
    std::vector<char> is_wanted(m_seams.number_of_seams(), 0);
    for(std::size_t f = 0; f < number_of_faces; ++f)
      for(int side = 0; side < 3; ++side)
        if(is_special(f, side))
          is_wanted[m_seams.seam(f, side)] = 1;
    std::vector<Number_lists::Pair> pairs;
    for(std::size_t f = 0; f < number_of_faces; ++f)
      for(int side = 0; side < 3; ++side)
        if(is_wanted[m_seams.seam(f, side)])
          pairs.emplace_back(m_seams.seam(f, side), static_cast<std::uint32_t>(f));
    if(pairs.empty())
      return;
    const Number_lists faces(m_seams.number_of_seams(), pairs);
    for(std::size_t f = 0; f < number_of_faces; ++f)
      for(int side = 0; side < 3; ++side) {
        const std::uint32_t seam = m_seams.seam(f, side);
        // the sides of a plain seam are all the same
        if(is_special(f, side) && faces[seam].size() > 1 &&
           (m_seams.is_united(seam) || f == faces[seam].front()))
          for_each_piece(f, side, m_seams.is_united(seam) ? m_width : 0,
                         [&](const std::array<int, 3>& low, const std::array<int, 3>& high) {
                           visit(low, high, faces[seam]);
                         });
      }
  }

private:
  /// length, in units of the cell width, up to which a piece counts as a point
  static constexpr double shortest_piece = 1e-9;

  /// from the lower to the upper vertex, so that all faces of an edge see the same
  std::pair<const Point*, const Point*> ends(std::size_t face, int side) const {
    const auto& t = m_surface.triangle(face);
    const auto [low, high] = std::minmax(t[side], t[(side + 1) % 3]);
    return {&m_points[low], &m_points[high]};
  }

  bool is_special(std::size_t face, int side) const {
    if(m_seams.is_united(m_seams.seam(face, side)))
      return true;
    const auto [p, q] = ends(face, side);
    for(int axis = 0; axis < 3; ++axis)
      if((*p)[axis] == (*q)[axis] && (*p)[axis] == std::floor((*p)[axis]))
        return true;
    return false;
  }

  static bool is_strictly_inside(const Point& p, const std::array<int, 3>& cell) {
    return p[0] > cell[0] && p[0] < cell[0] + 1 && p[1] > cell[1] && p[1] < cell[1] + 1 &&
           p[2] > cell[2] && p[2] < cell[2] + 1;
  }

  /// whether a segment has more than a point in common with a closed cell
  static bool runs_in_cell(const Point& p, const Point& q, const std::array<int, 3>& cell) {
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
    const Point &p = *ends(face, side).first, &q = *ends(face, side).second;
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
        const int last = m_cells_per_side - 1;
        low[axis] = (std::min)((std::max)(static_cast<int>(std::ceil(x - width)) - 1, 0), last);
        high[axis] = (std::min)((std::max)(static_cast<int>(std::floor(x + width)), 0), last);
      }
      visit(low, high);
    }
  }

  const Triangulated_surface_3& m_surface;
  const Surface_seams& m_seams;
  const std::vector<Point>& m_points;
  int m_cells_per_side;
  double m_width;
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_INTERNAL_SEAMS_IN_GRID_H
