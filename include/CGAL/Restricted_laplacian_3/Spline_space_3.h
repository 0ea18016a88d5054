// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SPLINE_SPACE_3_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SPLINE_SPACE_3_H

#include <CGAL/Restricted_laplacian_3/Octree_3.h>
#include <CGAL/Restricted_laplacian_3/exceptions.h>
#include <CGAL/Restricted_laplacian_3/parameters.h>

#include <boost/sort/spreadsort/integer_sort.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// the 27 elements whose support contains a cell, by offset: number \f$i = (d_x + 1) + 3 (d_y + 1)
/// + 9 (d_z + 1)\f$ is centred on the neighbour at offset \f$(d_x, d_y, d_z)\f$
using Cell_elements = std::array<std::uint32_t, 27>;

/// \ingroup PkgRestrictedLaplacian3Ref
/// The spaces of restricted splines, one for each level of the octree of a surface.
///
/// The element \f$b_o\f$ of a cell \f$o\f$ is the tensor product of B-splines of degree 2 centred
/// on \f$o\f$; its support is the \f$3 \times 3 \times 3\f$ cells around \f$o\f$. The space at
/// level \f$l\f$ is spanned by the restrictions to the surface of all elements whose open support
/// meets the surface, also of those centred one cell outside the \f$2^l\f$ grid: they sum to 1 on
/// the whole surface, so the constants are in the space. With `paper_space(true)` only elements
/// centred inside the grid exist, as in the paper. The spaces are nested: each element is a
/// combination of elements of the next finer level.
///
/// Elements of a level are numbered in Morton order of their cells.
///
/// See section 4.4 of the paper.
class Spline_space_3 {
public:
  /// stands for an element that does not exist
  static constexpr std::uint32_t no_element = (std::numeric_limits<std::uint32_t>::max)();

  /// \tparam FaceGraph a model of `FaceListGraph`, all of whose faces are triangles
  /// \param np optional named parameters:
  /// - `octree_depth`: depth \f$d\f$ of the octree; default 6
  /// - `cube_scale`: side of the domain cube over the longest side of the bounding box; default
  ///   1.1, or 1.2 with `paper_space(true)`
  /// - `paper_space`: whether only elements centred inside the grid exist; default `false`
  /// - `vertex_point_map`: default `get_const_property_map(CGAL::vertex_point, tm)`
  /// \throws Input_error one of its derived classes names the face, vertex or parameter
  ///
  /// The mesh is read once, and not needed any more. Time and memory are proportional to the number
  /// of triangles plus the number of cells that meet the surface (times its logarithm for sorting).
  template <class FaceGraph, class NamedParameters = parameters::Default_named_parameters>
  explicit Spline_space_3(const FaceGraph& tm,
                          const NamedParameters& np = parameters::default_values())
    : Spline_space_3(
          read_surface(tm, np),
          parameters::choose_parameter(parameters::get_parameter(np, internal_np::octree_depth), 6),
          parameters::choose_parameter(parameters::get_parameter(np, internal_np::paper_space),
                                       false),
          parameters::choose_parameter(
              parameters::get_parameter(np, internal_np::cube_scale),
              default_cube_scale(parameters::choose_parameter(
                  parameters::get_parameter(np, internal_np::paper_space), false)))) {}

  Spline_space_3(Triangulated_surface_3 surface, int depth, bool paper_space, double cube_scale)
    : m_octree(std::move(surface), depth, cube_scale), m_is_paper_space(paper_space) {
    m_levels.resize(depth + 1);
    for(int level = 0; level <= depth; ++level)
      number_elements(level);
  }

  static double default_cube_scale(bool paper_space) { return paper_space ? 1.2 : 1.1; }

  int depth() const { return m_octree.depth(); }
  const Octree_3& octree() const { return m_octree; }
  const Triangulated_surface_3& surface() const { return m_octree.surface(); }
  bool is_paper_space() const { return m_is_paper_space; }

  /// `level`
  /// \throws Parameter_error if it is not in 0 .. depth
  int checked_level(int level) const {
    if(level < 0 || level > depth())
      throw Parameter_error("level", "is " + std::to_string(level) + ", but must be in 0 .. " +
                                         std::to_string(depth()));
    return level;
  }

  /// number of elements of a level
  std::size_t dimension(int level) const { return m_levels[level].first_slots.size(); }
  /// number of elements of the finest level
  std::size_t dimension() const { return dimension(depth()); }

  /// The elements that act on the surface in cell `i` of a level; `no_element` where there is none,
  /// or where it vanishes on the surface in this cell. All code above this class reaches elements
  /// through this function alone.
  const Cell_elements& elements(int level, std::size_t i) const {
    return m_levels[level].cell_elements[i];
  }

  /// a cell in which an element acts, and its position in `elements()` of that cell
  std::pair<std::size_t, int> slot(int level, std::size_t element) const {
    const std::uint32_t slot = m_levels[level].first_slots[element];
    return {slot / 27, static_cast<int>(slot % 27)};
  }

  /// the cell that an element is centred on; it may lie outside the grid
  Cell_3 center(int level, std::size_t element) const {
    const auto [cell, position] = slot(level, element);
    return m_octree.cell(level, cell)
        .neighbor(position % 3 - 1, position / 3 % 3 - 1, position / 9 - 1);
  }

  /// The cell of a level in which a point of a face lies, and its local coordinates there, in
  /// \f$[0,1]^3\f$ up to rounding. A point on a wall may belong to any of the cells that touch it:
  /// the one that is taken owns a fragment of the face, or is an ancestor of one that does. It has
  /// to, because an element that vanishes on the surface in a cell is not listed there, but need
  /// not vanish on another face that touches the cell.
  /// \return the number of cells of the level as cell if the point is not on the face
  std::pair<std::size_t, std::array<double, 3>> locate(int level, const Point_3& point,
                                                       std::size_t face) const {
    const int depth = this->depth();
    const std::array<double, 3> x = m_octree.grid_coordinates(depth, point);
    // Points come from barycentric coordinates: some digits more than those of a corner are gone.
    const double tolerance = (std::max)(1e-7, 8 * m_octree.wall_tolerance(depth));
    std::array<std::array<int, 2>, 3> range;
    for(int axis = 0; axis < 3; ++axis) {
      const double n = std::ldexp(1., depth);
      if(!(x[axis] >= -tolerance && x[axis] <= n + tolerance))
        return {m_octree.number_of_cells(level), {0, 0, 0}};
      range[axis] = {static_cast<int>(std::floor(x[axis] - tolerance)),
                     static_cast<int>(std::floor(x[axis] + tolerance))};
    }
    Cell_3 cell{depth, {}};
    for(cell.index[2] = range[2][1]; cell.index[2] >= range[2][0]; --cell.index[2])
      for(cell.index[1] = range[1][1]; cell.index[1] >= range[1][0]; --cell.index[1])
        for(cell.index[0] = range[0][1]; cell.index[0] >= range[0][0]; --cell.index[0]) {
          std::size_t number = m_octree.find(cell);
          if(number == m_octree.number_of_cells(depth) || !m_octree.has_face(number, face))
            continue;
          for(int l = depth; l > level; --l)
            number = m_octree.parent(l, number);
          const Cell_3 ancestor = m_octree.cell(level, number);
          std::array<double, 3> t;
          for(int axis = 0; axis < 3; ++axis)
            t[axis] = std::ldexp(x[axis], level - depth) - ancestor.index[axis];
          return {number, t};
        }
    return {m_octree.number_of_cells(level), {0, 0, 0}};
  }

private:
  struct Level {
    std::vector<Cell_elements> cell_elements;
    std::vector<std::uint32_t> first_slots;
  };

  struct Key_and_slot {
    std::uint64_t key;
    std::uint32_t slot;
    bool operator<(const Key_and_slot& other) const { return key < other.key; }
  };

  /// Sorts the centres of the elements of all cells; equal centres are one element.
  void number_elements(int level) {
    Level& l = m_levels[level];
    const std::size_t number_of_cells = m_octree.number_of_cells(level);
    std::vector<Key_and_slot> slots;
    slots.reserve(27 * number_of_cells);
    for(std::size_t i = 0; i < number_of_cells; ++i) {
      const Cell_3 cell = m_octree.cell(level, i);
      std::uint32_t slot = static_cast<std::uint32_t>(27 * i);
      for(int dz = -1; dz <= 1; ++dz)
        for(int dy = -1; dy <= 1; ++dy)
          for(int dx = -1; dx <= 1; ++dx, ++slot) {
            const Cell_3 center = cell.neighbor(dx, dy, dz);
            if(!m_octree.meets_element(level, i, dx, dy, dz) ||
               (m_is_paper_space && !center.is_inside_grid()))
              continue;
            slots.push_back(
                {morton_key({center.index[0] + 1, center.index[1] + 1, center.index[2] + 1}),
                 slot});
          }
    }
    boost::sort::spreadsort::integer_sort(
        slots.begin(), slots.end(),
        [](const Key_and_slot& s, unsigned offset) { return s.key >> offset; });

    Cell_elements none;
    none.fill(no_element);
    l.cell_elements.assign(number_of_cells, none);
    for(std::size_t i = 0; i < slots.size(); ++i) {
      const auto [key, slot] = slots[i];
      if(i == 0 || key != slots[i - 1].key)
        l.first_slots.push_back(slot);
      else if(slot < l.first_slots.back())
        l.first_slots.back() = slot;
      l.cell_elements[slot / 27][slot % 27] = static_cast<std::uint32_t>(l.first_slots.size() - 1);
    }
  }

  Octree_3 m_octree;
  bool m_is_paper_space;
  std::vector<Level> m_levels;
};

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SPLINE_SPACE_3_H
