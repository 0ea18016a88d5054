// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_OCTREE_3_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_OCTREE_3_IMPL_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Disjoint_sets.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Number_lists.h>
#include <CGAL/Restricted_laplacian_3/octree/Octree_3.h>
#include <CGAL/Restricted_laplacian_3/octree/clip_to_cells.h>
#include <CGAL/Restricted_laplacian_3/octree/internal/Finest_sheets.h>
#include <CGAL/Restricted_laplacian_3/octree/internal/Points_in_grid.h>
#include <CGAL/Restricted_laplacian_3/octree/internal/Surface_in_grid.h>
#include <CGAL/Restricted_laplacian_3/octree/internal/Triangles_in_grid.h>
#include <CGAL/Restricted_laplacian_3/octree/shared/Octree_builder.h>
#include <CGAL/Restricted_laplacian_3/octree/shared/Sheet_sorter.h>
#include <CGAL/Restricted_laplacian_3/octree/shared/element_masks.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Octree_3 Octree_builder::without_levels(
    Triangulated_surface_3 surface, int depth, double cube_scale, bool is_split, bool is_parallel) {
  return Octree_3(std::move(surface), depth, cube_scale, is_split, is_parallel);
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void
Octree_builder::set_levels(std::vector<Octree_level> levels) {
  m_octree.m_levels = std::move(levels);
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Grid_vertices
Octree_builder::vertices(const Octree_3& octree, const Triangulated_surface_3& surface) {
  return {surface, octree.m_cube, octree.depth(), octree.clipper()};
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void Octree_builder::build(double joining_tolerance,
                                                              std::size_t fragments_at_once) {
  std::vector<Place> places;
  std::vector<Octree_level> levels(static_cast<std::size_t>(m_octree.depth()) + 1);
  levels.back() = finest_level(joining_tolerance, fragments_at_once, places);
  if(levels.back().number_of_sheets() == 0)
    throw Zero_area_error("the surface has area zero: none of its " +
                          std::to_string(m_octree.pieces().number_of_faces()) +
                          " faces is wider than rounding errors in the octree");
  for(std::size_t level = levels.size() - 1; level > 0; --level)
    levels[level - 1] = coarser_level(levels[level], places, m_octree.is_split());
  set_levels(std::move(levels));
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Octree_level
Octree_builder::finest_level(double joining_tolerance, std::size_t fragments_at_once,
                             std::vector<Place>& places, const Cell_filter* filter) const {
  const std::unique_ptr<Surface_in_grid> surface =
      surface_in_grid(joining_tolerance, fragments_at_once, filter);
  const auto join = [&](const Cell_fragment* fragments, std::uint32_t size,
                        Sheet_scratch& scratch) {
    if(m_octree.is_split())
      return surface->join(fragments, size, scratch);
    scratch.sets.reset(size);
    for(std::uint32_t i = 1; i < size; ++i)
      scratch.sets.unite(0, i);
  };
  Finest_sheets sheets;
  sheets.faces.reserve(surface->estimated_number_of_fragments());
  for(std::size_t window = 0; window < surface->number_of_windows(); ++window) {
    group_into_sheets(surface->fragments(window), join, m_octree.is_parallel(), sheets);
    check_number_of_sheets(sheets.cells.size());
  }
  sheets.first_sheets.push_back(static_cast<std::uint32_t>(sheets.cells.size()));
  sheets.first_faces.push_back(sheets.faces.size());
  places = std::move(sheets.places);
  Octree_level finest;
  finest.level = m_octree.depth();
  finest.keys = std::move(sheets.keys);
  finest.first_sheets = std::move(sheets.first_sheets);
  finest.cells = std::move(sheets.cells);
  finest.element_masks = std::move(sheets.element_masks);
  finest.faces = Number_lists(std::move(sheets.first_faces), std::move(sheets.faces));
  finest.index_keys();
  Surface_in_grid::Links links;
  if(m_octree.is_split() && finest.number_of_sheets() > 0)
    surface->link(finest, links);
  finest.links = Number_lists(finest.cells.size(), links);
  return finest;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE std::unique_ptr<Surface_in_grid>
Octree_builder::surface_in_grid(double joining_tolerance, std::size_t fragments_at_once,
                                const Cell_filter* filter) const {
  Grid_input input = {m_octree.pieces(),
                      m_octree.division(),
                      vertices(m_octree, m_octree.pieces()),
                      m_octree.is_split(),
                      fragments_at_once,
                      m_octree.is_parallel(),
                      filter};
  if(m_octree.surface().is_point_set())
    return std::make_unique<Points_in_grid>(std::move(input));
  return std::make_unique<Triangles_in_grid>(std::move(input), m_octree.clipper(),
                                             Octree_3::thin_face_height, joining_tolerance);
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void
Octree_builder::check_number_of_sheets(std::size_t number) const {
  if(number > Octree_3::maximum_number_of_sheets)
    throw Parameter_error("depth", "is " + std::to_string(m_octree.depth()) +
                                       ", which gives this surface more than " +
                                       std::to_string(Octree_3::maximum_number_of_sheets) +
                                       " sheets");
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Octree_level
Octree_builder::coarser_level(Octree_level& fine, std::vector<Place>& places, bool is_split) {
  Octree_level coarse;
  coarse.level = fine.level - 1;
  const auto number_of_fine_sheets = static_cast<std::uint32_t>(fine.cells.size());
  const auto parent_key = [&fine](std::size_t sheet) { return fine.keys[fine.cells[sheet]] >> 3; };
  Disjoint_sets sets;
  Sheet_sorter sort;
  sets.reset(number_of_fine_sheets);
  for(std::uint32_t sheet = 0; sheet < number_of_fine_sheets; ++sheet) {
    if(!is_split && sheet > 0 && parent_key(sheet - 1) == parent_key(sheet))
      sets.unite(sheet - 1, sheet);
    for(std::uint32_t other : fine.links[sheet])
      if(other < sheet && parent_key(other) == parent_key(sheet))
        sets.unite(other, sheet);
  }
  fine.parents.resize(number_of_fine_sheets);
  std::vector<Place> coarse_places;
  for(std::uint32_t begin = 0, end = 0; begin < number_of_fine_sheets; begin = end) {
    while(end < number_of_fine_sheets && parent_key(end) == parent_key(begin))
      ++end;
    const auto& firsts = sort(
        sets, begin, end, [&places](std::uint32_t sheet) { return places[sheet]; }, coarse_places);
    coarse.keys.push_back(parent_key(begin));
    coarse.first_sheets.push_back(static_cast<std::uint32_t>(coarse.cells.size()));
    for(std::uint32_t first : firsts) {
      fine.parents[first] = static_cast<std::uint32_t>(coarse.cells.size());
      coarse.cells.push_back(static_cast<std::uint32_t>(coarse.keys.size() - 1));
      coarse.element_masks.push_back(0);
    }
    for(std::uint32_t sheet = begin; sheet < end; ++sheet) {
      const std::uint32_t parent = fine.parents[sheet] = fine.parents[sets.find(sheet)];
      coarse.element_masks[parent] |= parent_element_mask(
          fine.element_masks[sheet], static_cast<int>(fine.keys[fine.cells[sheet]] & 7));
    }
  }
  coarse.first_sheets.push_back(static_cast<std::uint32_t>(coarse.cells.size()));
  coarse.index_keys();
  places.swap(coarse_places);

  std::vector<Number_lists::Pair> children, links;
  children.reserve(number_of_fine_sheets);
  for(std::uint32_t sheet = 0; sheet < number_of_fine_sheets; ++sheet) {
    children.emplace_back(fine.parents[sheet], sheet);
    for(std::uint32_t other : fine.links[sheet])
      if(fine.parents[other] != fine.parents[sheet])
        links.emplace_back(fine.parents[sheet], fine.parents[other]);
  }
  coarse.children = Number_lists(coarse.cells.size(), children);
  coarse.links = Number_lists(coarse.cells.size(), links);
  return coarse;
}

/// \throws Parameter_error if the coordinates of a surface are too large, compared with its extent,
/// for the cells of a depth
inline void check_digits(const Octree_3& octree, double distance) {
  const int depth = octree.depth();
  if(octree.wall_tolerance(depth) <= Octree_3::largest_wall_tolerance)
    return;
  std::ostringstream reason;
  int possible = depth - 1;
  while(possible > 0 && octree.wall_tolerance(possible) > Octree_3::largest_wall_tolerance)
    --possible;
  reason << "is " << depth << ", but coordinates up to " << distance
         << " of a surface whose bounding box is " << octree.surface().extent()
         << " long have digits for ";
  if(possible > 0)
    reason << "a depth of at most " << possible;
  else
    reason << "no depth at all";
  reason << ": move the surface to the origin";
  throw Parameter_error("depth", reason.str());
}

} // namespace internal

CGAL_RESTRICTED_LAPLACIAN_3_INLINE double internal::checked_cube_scale(double cube_scale) {
  if(!(cube_scale >= 1 && cube_scale <= 1e6))
    throw Parameter_error("cube_scale",
                          "is " + std::to_string(cube_scale) + ", but must be in 1 .. 1e6");
  return cube_scale;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE
Octree_3::Octree_3(Triangulated_surface_3 surface, int depth, double cube_scale, bool is_split,
                   double joining_tolerance, bool is_parallel, std::size_t fragments_at_once)
  : Octree_3(std::move(surface), depth, cube_scale, is_split, is_parallel) {
  internal::Octree_builder(*this).build(joining_tolerance, fragments_at_once);
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE
Octree_3::Octree_3(Triangulated_surface_3&& surface, int depth, double cube_scale, bool is_split,
                   bool is_parallel)
  : m_surface(std::move(surface)), m_depth(depth), m_is_split(is_split),
    m_is_parallel(is_parallel) {
  if(depth < 1 || depth > maximum_octree_depth)
    throw Parameter_error("depth", "is " + std::to_string(depth) + ", but must be in 1 .. " +
                                       std::to_string(maximum_octree_depth));
  m_cube.side = internal::checked_cube_scale(cube_scale) * m_surface.extent();
  m_cube.center = m_surface.center();
  if(m_surface.is_smooth()) {
    const double h = cell_width(depth);
    m_division = std::make_shared<const internal::Divided_surface>(m_surface, piece_tolerance * h);
    fit_pieces();
  }
  double largest = 0;
  for(int axis = 0; axis < 3; ++axis)
    largest = (std::max)({largest, std::abs(m_surface.bounding_box_min()[axis]),
                          std::abs(m_surface.bounding_box_max()[axis])});
  // Far from the origin the coordinates themselves carry a larger rounding error.
  m_wall_tolerance = (std::max)(relative_wall_tolerance,
                                4 * std::numeric_limits<double>::epsilon() * (largest / side()));
  internal::check_digits(*this, largest);
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Fragment Octree_3::fragment(const Cell_3& cell,
                                                               std::size_t face) const {
  CGAL_precondition(cell.level == m_depth && cell.is_inside_grid());
  CGAL_precondition(face < pieces().number_of_faces());
  return clipper().fragment({grid_coordinates(m_depth, pieces().point(face, 0)),
                             grid_coordinates(m_depth, pieces().point(face, 1)),
                             grid_coordinates(m_depth, pieces().point(face, 2))},
                            cell.index);
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE std::pair<std::size_t, std::array<double, 3>>
Octree_3::locate(int level, const Point_3& point, std::size_t face) const {
  const std::array<double, 3> x = grid_coordinates(m_depth, point);
  // Points come from barycentric coordinates: some digits more than those of a corner are gone.
  const double tolerance = (std::max)(1e-7, 8 * wall_tolerance(m_depth));
  std::array<std::array<int, 2>, 3> range;
  for(int axis = 0; axis < 3; ++axis) {
    const double n = std::ldexp(1., m_depth);
    if(!(x[axis] >= -tolerance && x[axis] <= n + tolerance))
      return {number_of_sheets(level), {0, 0, 0}};
    range[axis] = {static_cast<int>(std::floor(x[axis] - tolerance)),
                   static_cast<int>(std::floor(x[axis] + tolerance))};
  }
  Cell_3 cell{m_depth, {}};
  for(cell.index[2] = range[2][1]; cell.index[2] >= range[2][0]; --cell.index[2])
    for(cell.index[1] = range[1][1]; cell.index[1] >= range[1][0]; --cell.index[1])
      for(cell.index[0] = range[0][1]; cell.index[0] >= range[0][0]; --cell.index[0]) {
        const std::size_t cell_number = find(cell);
        if(cell_number == number_of_cells(m_depth))
          continue;
        std::size_t sheet = sheet_of_face(cell_number, face);
        if(sheet == number_of_sheets(m_depth))
          continue;
        for(int l = m_depth; l > level; --l)
          sheet = parent(l, sheet);
        const Cell_3 ancestor = this->cell(level, sheet);
        std::array<double, 3> t;
        for(int axis = 0; axis < 3; ++axis)
          t[axis] = std::ldexp(x[axis], level - m_depth) - ancestor.index[axis];
        return {sheet, t};
      }
  return {number_of_sheets(level), {0, 0, 0}};
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE std::pair<std::size_t, std::array<double, 3>>
Octree_3::locate(int level, const Surface_location& location) const {
  const Point_3 point = m_surface.surface_point(location).point;
  if(!m_division)
    return locate(level, point, location.face);
  const Surface_location on_piece = m_division->on_pieces(location);
  auto [sheet, t] = locate(level, pieces().surface_point(on_piece).point, on_piece.face);
  if(sheet != number_of_sheets(level)) {
    const Cell_3 cell = this->cell(level, sheet);
    t = grid_coordinates(level, point);
    for(int axis = 0; axis < 3; ++axis)
      t[axis] -= cell.index[axis];
  }
  return {sheet, t};
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void Octree_3::fit_pieces() {
  const Triangulated_surface_3& p = pieces();
  for(int axis = 0; axis < 3; ++axis)
    for(double end : {p.bounding_box_min()[axis], p.bounding_box_max()[axis]})
      m_cube.side = (std::max)(m_cube.side, 2 * std::abs(end - m_cube.center[axis]));
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Cell_clipper Octree_3::clipper() const {
  return Cell_clipper(1 << m_depth, wall_tolerance(m_depth));
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_OCTREE_3_IMPL_H
