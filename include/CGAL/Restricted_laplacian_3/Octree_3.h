// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_3_H
#define CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_3_H

#include <CGAL/Restricted_laplacian_3/Cell_3.h>
#include <CGAL/Restricted_laplacian_3/Triangulated_surface_3.h>
#include <CGAL/Restricted_laplacian_3/clip_to_cells.h>
#include <CGAL/Restricted_laplacian_3/exceptions.h>

#include <boost/range/iterator_range.hpp>
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

/// The sparse octree of the cells that meet a surface, with every level.
///
/// The root is the domain cube: axis-aligned, centred on the bounding box of the surface, its side
/// `cube_scale` times the longest side of the box. Level \f$l\f$ is the grid of \f$2^l\f$ cells a
/// side; its cells are stored as a sorted array of Morton keys, so that the children of a cell are
/// consecutive, and a neighbour is found by binary search. The finest level also knows which
/// triangles have a fragment in a cell.
class Octree_3 {
public:
  /// Coordinates that are this close to a wall, as a fraction of the side of the domain cube, are
  /// taken to lie on it: some units in the last place of the sums that lead to them.
  static constexpr double relative_wall_tolerance = 1.5e-14;

  /// Number of cells and number of fragments beyond which an octree is refused instead of filling
  /// the memory. About 3 elements belong to a cell and 75 entries to a row, so more cells would
  /// give matrices of more than \f$2^{31}\f$ entries. A fragment takes 16 bytes while the octree is
  /// built.
  static constexpr std::size_t maximum_number_of_cells = std::size_t(1) << 23;
  static constexpr std::size_t maximum_number_of_fragments = std::size_t(1) << 26;

  /// \throws Parameter_error if `depth` is not in 1 .. 20, if `cube_scale` is not in 1 .. 1e6, or
  /// if the octree would have more than `maximum_number_of_cells` cells or
  /// `maximum_number_of_fragments` fragments
  Octree_3(Triangulated_surface_3 surface, int depth, double cube_scale)
    : m_surface(std::move(surface)), m_depth(depth) {
    if(depth < 1 || depth > maximum_octree_depth)
      throw Parameter_error("octree_depth", "is " + std::to_string(depth) +
                                                ", but must be in 1 .. " +
                                                std::to_string(maximum_octree_depth));
    if(!(cube_scale >= 1 && cube_scale <= 1e6))
      throw Parameter_error("cube_scale",
                            "is " + std::to_string(cube_scale) + ", but must be in 1 .. 1e6");
    m_side = cube_scale * m_surface.extent();
    m_center = m_surface.center();
    double largest = 0;
    for(int axis = 0; axis < 3; ++axis)
      largest = (std::max)({largest, std::abs(m_surface.bounding_box_min()[axis]),
                            std::abs(m_surface.bounding_box_max()[axis])});
    // Far from the origin the coordinates themselves carry a larger rounding error.
    m_wall_tolerance = (std::max)(relative_wall_tolerance,
                                  4 * std::numeric_limits<double>::epsilon() * (largest / m_side));
    m_levels.resize(depth + 1);
    // A plane section of a cube has at most the area sqrt(2) h^2: refuse before any work.
    const double h = cell_width(depth);
    refuse_if(m_surface.area() / (h * h) > 1.4143 * maximum_number_of_fragments);
    build_finest_level();
    for(int level = depth - 1; level >= 0; --level)
      build_coarser_level(level);
  }

  int depth() const { return m_depth; }
  const Triangulated_surface_3& surface() const { return m_surface; }

  /// side of the domain cube
  double side() const { return m_side; }
  /// width \f$h = \mathrm{side} / 2^l\f$ of the cells of a level
  double cell_width(int level) const { return std::ldexp(m_side, -level); }

  /// number of cells of a level that meet the surface
  std::size_t number_of_cells(int level) const { return m_levels[level].keys.size(); }

  /// cell number `i` of a level, in Morton order
  Cell_3 cell(int level, std::size_t i) const {
    return Cell_3::from_key(level, m_levels[level].keys[i]);
  }

  /// number, in the next coarser level, of the cell that contains cell `i`
  std::size_t parent(int level, std::size_t i) const { return m_levels[level].parents[i]; }

  /// numbers, in the next finer level, of the cells that cell `i` contains: a half-open range
  std::array<std::size_t, 2> children(int level, std::size_t i) const {
    return {m_levels[level].first_children[i], m_levels[level].first_children[i + 1]};
  }

  /// number of a cell, or `number_of_cells(cell.level)` if it does not meet the surface
  std::size_t find(const Cell_3& cell) const {
    const auto& keys = m_levels[cell.level].keys;
    if(!cell.is_inside_grid())
      return keys.size();
    const std::uint64_t key = cell.key();
    const auto it = std::lower_bound(keys.begin(), keys.end(), key);
    return it != keys.end() && *it == key ? it - keys.begin() : keys.size();
  }

  /// Whether the element centred on the neighbour of cell `i` at offset (dx, dy, dz), each -1, 0 or
  /// 1, is not zero on all of the surface in this cell. It is zero there where the surface in the
  /// cell is part of the wall opposite to the neighbour.
  bool meets_element(int level, std::size_t i, int dx, int dy, int dz) const {
    return m_levels[level].element_masks[i] >> mask_bit(dx, dy, dz) & 1;
  }

  /// the faces that have a fragment in cell `i` of the finest level, in ascending order
  boost::iterator_range<const std::uint32_t*> faces(std::size_t i) const {
    return {m_faces.data() + m_first_faces[i], m_faces.data() + m_first_faces[i + 1]};
  }

  /// whether a face has a fragment in cell `i` of the finest level
  bool has_face(std::size_t i, std::size_t face) const {
    const auto range = faces(i);
    return std::binary_search(range.begin(), range.end(), face);
  }

  /// number of fragments of the finest level
  std::size_t number_of_fragments() const { return m_faces.size(); }

  /// the fragment of a face in a cell of the finest level; its coordinates are in units of the cell
  /// width, the origin is that of the grid
  Fragment fragment(const Cell_3& cell, std::size_t face) const {
    return clipper().fragment(grid_triangle(face), cell.index);
  }

  /// coordinates of a point in the grid of a level, in units of the cell width. The same point has
  /// exactly twice these coordinates on the next finer level.
  std::array<double, 3> grid_coordinates(int level, const Point_3& p) const {
    std::array<double, 3> x;
    for(int axis = 0; axis < 3; ++axis)
      x[axis] = std::ldexp((p[axis] - m_center[axis]) / m_side + 0.5, level);
    return x;
  }

  /// distance, in units of the cell width of a level, below which a point counts as lying on a wall
  double wall_tolerance(int level) const { return std::ldexp(m_wall_tolerance, level); }

private:
  struct Level {
    std::vector<std::uint64_t> keys;
    std::vector<std::uint32_t> element_masks;
    std::vector<std::uint32_t> parents;
    std::vector<std::size_t> first_children;
  };

  struct Key_and_face {
    std::uint64_t key;
    std::uint32_t face;
    std::uint32_t element_mask;
    bool operator<(const Key_and_face& other) const { return key < other.key; }
  };

  static int mask_bit(int dx, int dy, int dz) { return (dx + 1) + 3 * (dy + 1) + 9 * (dz + 1); }

  Cell_clipper clipper() const { return Cell_clipper(1 << m_depth, wall_tolerance(m_depth)); }

  std::array<std::array<double, 3>, 3> grid_triangle(std::size_t face) const {
    return {grid_coordinates(m_depth, m_surface.point(face, 0)),
            grid_coordinates(m_depth, m_surface.point(face, 1)),
            grid_coordinates(m_depth, m_surface.point(face, 2))};
  }

  /// The element pieces of offsets -1, 0, 1 are (1-t)^2/2, 1/2+t-t^2 and t^2/2: with all of a
  /// fragment at t = 0 the last, with all of it at t = 1 the first vanishes on it.
  static std::uint32_t element_mask(const Fragment& fragment, const std::array<int, 3>& cell) {
    std::array<std::array<bool, 3>, 3> meets;
    for(int axis = 0; axis < 3; ++axis) {
      const auto range = internal::range(fragment, axis);
      meets[axis] = {range[0]<cell[axis] + 1, true, range[1]> cell[axis]};
    }
    std::uint32_t mask = 0;
    for(int dz = -1; dz <= 1; ++dz)
      for(int dy = -1; dy <= 1; ++dy)
        for(int dx = -1; dx <= 1; ++dx)
          if(meets[0][dx + 1] && meets[1][dy + 1] && meets[2][dz + 1])
            mask |= 1u << mask_bit(dx, dy, dz);
    return mask;
  }

  /// The mask of a parent follows from those of its children: in the lower child of an axis
  /// (parity 0) the surface is never all at t = 1 of the parent, in the upper one never at t = 0.
  static std::uint32_t parent_mask(std::uint32_t child_mask, int octant) {
    const auto child_offset = [octant](int axis, int offset) {
      const bool upper = octant >> axis & 1;
      return (offset == 1 && upper) || (offset == -1 && !upper) ? 0 : offset;
    };
    std::uint32_t mask = 0;
    for(int dz = -1; dz <= 1; ++dz)
      for(int dy = -1; dy <= 1; ++dy)
        for(int dx = -1; dx <= 1; ++dx)
          if(child_mask >> mask_bit(child_offset(0, dx), child_offset(1, dy), child_offset(2, dz)) &
             1)
            mask |= 1u << mask_bit(dx, dy, dz);
    return mask;
  }

  void refuse_if(bool is_too_large) const {
    if(is_too_large)
      throw Parameter_error("octree_depth", "is " + std::to_string(m_depth) +
                                                ", which gives this surface more than " +
                                                std::to_string(maximum_number_of_cells) +
                                                " cells or too many fragments of triangles");
  }

  void build_finest_level() {
    std::vector<Key_and_face> pairs;
    pairs.reserve(2 * m_surface.number_of_faces());
    const Cell_clipper clip = clipper();
    for(std::size_t face = 0; face < m_surface.number_of_faces(); ++face) {
      if(m_surface.is_degenerate(face))
        continue;
      clip(grid_triangle(face), [&](const std::array<int, 3>& cell, const Fragment& fragment) {
        refuse_if(pairs.size() == maximum_number_of_fragments);
        pairs.push_back(
            {morton_key(cell), static_cast<std::uint32_t>(face), element_mask(fragment, cell)});
      });
    }
    if(pairs.empty())
      throw Zero_area_error(m_surface.number_of_faces());
    boost::sort::spreadsort::integer_sort(
        pairs.begin(), pairs.end(),
        [](const Key_and_face& p, unsigned offset) { return p.key >> offset; });

    Level& finest = m_levels[m_depth];
    m_faces.reserve(pairs.size());
    for(const Key_and_face& p : pairs) {
      if(finest.keys.empty() || finest.keys.back() != p.key) {
        refuse_if(finest.keys.size() == maximum_number_of_cells);
        finest.keys.push_back(p.key);
        finest.element_masks.push_back(0);
        m_first_faces.push_back(m_faces.size());
      }
      finest.element_masks.back() |= p.element_mask;
      m_faces.push_back(p.face);
    }
    m_first_faces.push_back(m_faces.size());
    // The sort is not stable, and the order of summation should not depend on it.
    for(std::size_t i = 0; i + 1 < m_first_faces.size(); ++i)
      std::sort(m_faces.begin() + m_first_faces[i], m_faces.begin() + m_first_faces[i + 1]);
  }

  void build_coarser_level(int level) {
    Level &coarse = m_levels[level], &fine = m_levels[level + 1];
    fine.parents.reserve(fine.keys.size());
    for(std::size_t i = 0; i < fine.keys.size(); ++i) {
      const std::uint64_t key = fine.keys[i] >> 3;
      if(coarse.keys.empty() || coarse.keys.back() != key) {
        coarse.keys.push_back(key);
        coarse.element_masks.push_back(0);
        coarse.first_children.push_back(i);
      }
      coarse.element_masks.back() |=
          parent_mask(fine.element_masks[i], static_cast<int>(fine.keys[i] & 7));
      fine.parents.push_back(static_cast<std::uint32_t>(coarse.keys.size() - 1));
    }
    coarse.first_children.push_back(fine.keys.size());
  }

  Triangulated_surface_3 m_surface;
  int m_depth;
  double m_side;
  Point_3 m_center;
  double m_wall_tolerance;
  std::vector<Level> m_levels;
  std::vector<std::size_t> m_first_faces;
  std::vector<std::uint32_t> m_faces;
};

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_3_H
