// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_OCTREE_3_H
#define CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_OCTREE_3_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Disjoint_sets.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Number_lists.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parallel_for.h>
#include <CGAL/Restricted_laplacian_3/octree/Cell_3.h>
#include <CGAL/Restricted_laplacian_3/octree/clip_to_cells.h>
#include <CGAL/Restricted_laplacian_3/octree/internal/Finest_sheets.h>
#include <CGAL/Restricted_laplacian_3/octree/internal/Piece_sorter.h>
#include <CGAL/Restricted_laplacian_3/octree/internal/Point_links.h>
#include <CGAL/Restricted_laplacian_3/octree/internal/Point_sites.h>
#include <CGAL/Restricted_laplacian_3/octree/internal/Seams_in_grid.h>
#include <CGAL/Restricted_laplacian_3/octree/internal/element_masks.h>
#include <CGAL/Restricted_laplacian_3/surface/Surface_seams.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>

#include <boost/range/iterator_range.hpp>

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

/// \ingroup PkgRestrictedLaplacian3Dev
/// The sparse octree of the cells that meet a surface, with every level, and the sheets in them.
///
/// The root is the domain cube: axis-aligned, centred on the bounding box of the surface, its side
/// `cube_scale` times the longest side of the box. Level \f$l\f$ is the grid of \f$2^l\f$ cells a
/// side; its cells are stored as a sorted array of Morton keys, so that a neighbour is found by
/// binary search.
///
/// A *sheet* is a connected piece of the surface in one cell. On the finest level fragments of two
/// triangles belong to the same sheet if the triangles are joined along a side (see
/// `Surface_seams`) that runs through the closed cell for more than a point. Sheets of different
/// cells, which are then neighbours, possibly across an edge or corner, are *linked* if a triangle
/// has a fragment in both, or if two triangles are joined along a side that lies in the wall
/// between the cells. A triangle is convex, and so is a box of cells; therefore two fragments of
/// the same triangle are always connected inside of any box that contains both cells. On coarser
/// levels the sheets of the up to 8 children of a cell are one sheet if they are linked inside of
/// the cell, and two sheets are linked if two of their children are. All this depends on the
/// surface, and not on how its flat parts are triangulated.
///
/// Sheets are numbered in Morton order of their cells, so those of a cell are consecutive, and in a
/// cell by the position of their centroid along a fixed direction: numbers belong to the surface as
/// well, and a level of a deep octree has those of a shallow octree. Without splitting all surface
/// in a cell is one sheet, and there are no links.
///
/// The points of a point set are fragments of one cell each. Which of them belong together must be
/// guessed: see `internal::Point_links`.
class Octree_3 {
public:
  /// half-open range of numbers of sheets
  using Sheet_range = boost::iterator_range<const std::uint32_t*>;

  /// Coordinates that are this close to a wall, as a fraction of the side of the domain cube, are
  /// taken to lie on it: some units in the last place of the sums that lead to them.
  static constexpr double relative_wall_tolerance = 1.5e-14;

  /// Faces of at most this height, in units of the width of the finest cells, are bridged by their
  /// neighbours, see `Surface_seams`.
  static constexpr double thin_face_height = 1e-6;

  /// Number of sheets beyond which an octree is refused instead of filling the memory. About 3
  /// elements belong to a sheet and 75 entries to a row, so more sheets would give matrices of more
  /// than \f$2^{31}\f$ entries.
  static constexpr std::size_t maximum_number_of_sheets = std::size_t(1) << 23;
  /// Number of fragments beyond which an octree is refused. A fragment takes 32 bytes while the
  /// octree is built.
  static constexpr std::size_t maximum_number_of_fragments = std::size_t(1) << 26;

  /// \param surface becomes a part of the octree
  /// \param depth \f$d\f$, from 1 to 20
  /// \param cube_scale side of the domain cube over the longest side of the bounding box, from 1 to
  /// 1e6
  /// \param is_split whether the surface in a cell is split into sheets
  /// \param joining_tolerance of `Surface_seams`, in the unit of the coordinates; negative: do not
  /// join
  /// \param is_parallel whether several threads are used, if the program is linked with TBB; the
  /// octree is the same
  /// \throws Parameter_error if `depth` is not from 1 to 20, if `cube_scale` is not from 1 to 1e6,
  /// or if the octree would have more than `maximum_number_of_sheets` sheets or
  /// `maximum_number_of_fragments` fragments
  Octree_3(Triangulated_surface_3 surface, int depth, double cube_scale, bool is_split = true,
           double joining_tolerance = -1, bool is_parallel = false)
    : m_surface(std::move(surface)), m_depth(depth), m_is_split(is_split),
      m_is_parallel(is_parallel) {
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
    limits().refuse_if(!m_surface.is_point_set() &&
                       m_surface.area() / (h * h) > 1.4143 * maximum_number_of_fragments);
    std::vector<internal::Place> places = build_finest_level(joining_tolerance);
    for(int level = depth - 1; level >= 0; --level)
      build_coarser_level(level, places);
  }

  /// depth \f$d\f$, the finest level
  int depth() const { return m_depth; }
  /// the surface, as given to the constructor
  const Triangulated_surface_3& surface() const { return m_surface; }

  /// side of the domain cube
  double side() const { return m_side; }
  /// width \f$h = \mathrm{side} / 2^l\f$ of the cells of a level
  double cell_width(int level) const { return std::ldexp(m_side, -level); }

  /// whether the surface in a cell is split into sheets
  bool is_split() const { return m_is_split; }

  /// number of cells of a level that meet the surface
  std::size_t number_of_cells(int level) const { return m_levels[level].keys.size(); }

  /// number of sheets of a level
  std::size_t number_of_sheets(int level) const { return m_levels[level].cells.size(); }

  /// the cell of a sheet
  Cell_3 cell(int level, std::size_t sheet) const {
    return Cell_3::from_key(level, m_levels[level].keys[m_levels[level].cells[sheet]]);
  }

  /// number, in the next coarser level, of the sheet that contains a sheet
  std::size_t parent(int level, std::size_t sheet) const { return m_levels[level].parents[sheet]; }

  /// numbers, in the next finer level, of the sheets that a sheet consists of, in ascending order
  Sheet_range children(int level, std::size_t sheet) const {
    return m_levels[level].children[sheet];
  }

  /// numbers of the sheets in other cells of the level that a sheet is linked with, in ascending
  /// order
  Sheet_range links(int level, std::size_t sheet) const { return m_levels[level].links[sheet]; }

  /// number of a cell, or `number_of_cells(cell.level)` if it does not meet the surface
  std::size_t find(const Cell_3& cell) const {
    const auto& keys = m_levels[cell.level].keys;
    if(!cell.is_inside_grid())
      return keys.size();
    const std::uint64_t key = cell.key();
    const Level& level = m_levels[cell.level];
    const auto prefix = static_cast<std::size_t>(key >> level.prefix_shift);
    const auto last = keys.begin() + level.first_of_prefix[prefix + 1];
    const auto it = std::lower_bound(keys.begin() + level.first_of_prefix[prefix], last, key);
    return it != last && *it == key ? it - keys.begin() : keys.size();
  }

  /// numbers of the sheets in cell number `i` of a level: a half-open range
  std::array<std::size_t, 2> sheets(int level, std::size_t i) const {
    return {m_levels[level].first_sheets[i], m_levels[level].first_sheets[i + 1]};
  }

  /// Whether the element centred on the neighbour of the cell of a sheet at offset (dx, dy, dz),
  /// each -1, 0 or 1, is not zero on all of the sheet. It is zero on it where the sheet is part of
  /// the wall opposite to the neighbour.
  bool meets_element(int level, std::size_t sheet, int dx, int dy, int dz) const {
    return m_levels[level].element_masks[sheet] >> internal::element_bit(dx, dy, dz) & 1;
  }

  /// the faces that have a fragment in a sheet of the finest level, in ascending order
  boost::iterator_range<const std::uint32_t*> faces(std::size_t sheet) const {
    return {m_faces.data() + m_first_faces[sheet], m_faces.data() + m_first_faces[sheet + 1]};
  }

  /// the sheet in cell number `i` of the finest level that has a fragment of a face, or
  /// `number_of_sheets(depth())` if there is none
  std::size_t sheet_of_face(std::size_t i, std::size_t face) const {
    const auto [first, last] = sheets(m_depth, i);
    for(std::size_t sheet = first; sheet < last; ++sheet) {
      const auto range = faces(sheet);
      if(std::binary_search(range.begin(), range.end(), face))
        return sheet;
    }
    return number_of_sheets(m_depth);
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
    const double cells_per_side = static_cast<double>(1 << level);
    std::array<double, 3> x;
    for(int axis = 0; axis < 3; ++axis)
      x[axis] = ((p[axis] - m_center[axis]) / m_side + 0.5) * cells_per_side;
    return x;
  }

  /// distance, in units of the cell width of a level, below which a point counts as lying on a wall
  double wall_tolerance(int level) const { return std::ldexp(m_wall_tolerance, level); }

private:
  struct Level {
    std::vector<std::uint64_t> keys; // of cells
    // First cell whose key without the lowest `prefix_shift` bits is at least the index: there are
    // about as many prefixes as cells, so the search for a cell is short.
    std::vector<std::uint32_t> first_of_prefix;
    int prefix_shift = 0;
    std::vector<std::uint32_t> first_sheets; // of cells, and one more
    std::vector<std::uint32_t> cells;        // of sheets, as all that follows
    std::vector<std::uint32_t> element_masks;
    std::vector<std::uint32_t> parents;
    internal::Number_lists children;
    internal::Number_lists links;
  };

  Cell_clipper clipper() const { return Cell_clipper(1 << m_depth, wall_tolerance(m_depth)); }

  std::array<std::array<double, 3>, 3> grid_triangle(std::size_t face) const {
    return {grid_coordinates(m_depth, m_surface.point(face, 0)),
            grid_coordinates(m_depth, m_surface.point(face, 1)),
            grid_coordinates(m_depth, m_surface.point(face, 2))};
  }

  void index_keys(int level) {
    Level& l = m_levels[level];
    int bits = 0;
    while(bits < 3 * level && std::size_t(1) << bits < l.keys.size())
      ++bits;
    l.prefix_shift = 3 * level - bits;
    l.first_of_prefix.resize((std::size_t(1) << bits) + 1);
    std::size_t i = 0;
    for(std::size_t prefix = 0; prefix < l.first_of_prefix.size(); ++prefix) {
      while(i < l.keys.size() && l.keys[i] >> l.prefix_shift < prefix)
        ++i;
      l.first_of_prefix[prefix] = static_cast<std::uint32_t>(i);
    }
  }

  internal::Octree_limits limits() const {
    return {m_depth, maximum_number_of_sheets, maximum_number_of_fragments};
  }

  /// coordinates of the vertices in the finest grid, as the clipper sees them; unspecified for
  /// those that have no face
  std::vector<std::array<double, 3>> grid_points() const {
    std::vector<std::array<double, 3>> points(m_surface.number_of_vertices());
    const std::array<double, 3> origin = {0, 0, 0};
    internal::parallel_for(
        m_is_parallel, 0, points.size(), 1 << 15, [&](std::size_t begin, std::size_t end) {
          for(std::size_t v = begin; v < end; ++v) {
            const auto x = grid_coordinates(m_depth, m_surface.point(v));
            // Vertices without a face may be anywhere, also at infinity.
            const bool is_inside = std::all_of(x.begin(), x.end(), [this](double c) {
              return c > -1 && c < static_cast<double>(1 << m_depth) + 1;
            });
            points[v] = is_inside ? clipper().snapped(x) : origin;
          }
        });
    return points;
  }

  /// returns the places of the sheets
  std::vector<internal::Place> build_finest_level(double joining_tolerance) {
    const std::vector<std::array<double, 3>> points = grid_points();
    std::vector<internal::Number_lists::Pair> links;
    std::vector<internal::Place> places = !m_is_split ? unite_sheets(points)
                                          : m_surface.is_point_set()
                                              ? split_points(points, links)
                                              : split_triangles(points, joining_tolerance, links);
    m_levels[m_depth].links = internal::Number_lists(number_of_sheets(m_depth), links);
    return places;
  }

  std::vector<internal::Cell_fragment>
  fragments(const std::vector<std::array<double, 3>>& points) const {
    return m_surface.is_point_set() ? internal::sort_points(points, limits(), m_is_parallel)
                                    : internal::cut_faces(m_surface, points, clipper(), m_is_split,
                                                          limits(), m_is_parallel);
  }

  /// one sheet for each cell
  std::vector<internal::Place> unite_sheets(const std::vector<std::array<double, 3>>& points) {
    return make_finest_sheets(points, [](const std::array<int, 3>&, std::uint32_t size, auto&&,
                                         internal::Sheet_scratch& scratch) {
      scratch.sets.reset(size);
      for(std::uint32_t i = 1; i < size; ++i)
        scratch.sets.unite(0, i);
    });
  }

  /// sheets of fragments that are joined along seams
  std::vector<internal::Place> split_triangles(const std::vector<std::array<double, 3>>& points,
                                               double joining_tolerance,
                                               std::vector<internal::Number_lists::Pair>& links) {
    const double h = cell_width(m_depth);
    const Surface_seams seams(m_surface, thin_face_height * h, joining_tolerance);
    const double width = (std::max)(2 * thin_face_height, 1.01 * joining_tolerance / h);
    const internal::Seams_in_grid in_grid(m_surface, seams, points, 1 << m_depth, width);
    std::vector<internal::Place> places =
        make_finest_sheets(points, [&in_grid](const std::array<int, 3>& cell, std::uint32_t size,
                                              auto&& face_of, internal::Sheet_scratch& scratch) {
          in_grid.join(cell, size, face_of, scratch.sides, scratch.sets);
        });
    link_fragments_of_same_face(links);
    link_faces_along_walls(in_grid, links);
    return places;
  }

  /// sheets of linked points
  std::vector<internal::Place> split_points(const std::vector<std::array<double, 3>>& points,
                                            std::vector<internal::Number_lists::Pair>& links) {
    const internal::Point_links point_links(m_surface, m_is_parallel);
    std::vector<internal::Place> places =
        make_finest_sheets(points, [&](const std::array<int, 3>&, std::uint32_t size,
                                       auto&& point_of, internal::Sheet_scratch& scratch) {
          point_links.join(size, point_of, scratch.sets);
        });
    std::vector<std::uint32_t> sheet_of_point(m_surface.number_of_faces());
    for(std::uint32_t sheet = 0; sheet < number_of_sheets(m_depth); ++sheet)
      for(std::uint32_t point : faces(sheet))
        sheet_of_point[point] = sheet;
    for(std::size_t i = 0; i < sheet_of_point.size(); ++i)
      for(std::uint32_t j : point_links[i])
        if(sheet_of_point[i] != sheet_of_point[j])
          links.emplace_back(sheet_of_point[i], sheet_of_point[j]);
    return places;
  }

  /// \param join see `internal::group_into_sheets()`
  template <class Join>
  std::vector<internal::Place> make_finest_sheets(const std::vector<std::array<double, 3>>& points,
                                                  Join&& join) {
    internal::Finest_sheets sheets =
        internal::group_into_sheets(fragments(points), join, limits(), m_is_parallel);
    Level& finest = m_levels[m_depth];
    finest.keys = std::move(sheets.keys);
    finest.first_sheets = std::move(sheets.first_sheets);
    finest.cells = std::move(sheets.cells);
    finest.element_masks = std::move(sheets.element_masks);
    m_first_faces = std::move(sheets.first_faces);
    m_faces = std::move(sheets.faces);
    index_keys(m_depth);
    return std::move(sheets.places);
  }

  bool have_common_face(std::size_t sheet, std::size_t other) const {
    const auto a = faces(sheet), b = faces(other);
    for(auto i = a.begin(), j = b.begin(); i != a.end() && j != b.end();) {
      if(*i == *j)
        return true;
      if(*i < *j)
        ++i;
      else
        ++j;
    }
    return false;
  }

  static void add_link(std::size_t sheet, std::size_t other,
                       std::vector<internal::Number_lists::Pair>& links) {
    const auto a = static_cast<std::uint32_t>(sheet), b = static_cast<std::uint32_t>(other);
    links.emplace_back(a, b);
    links.emplace_back(b, a);
  }

  void link_fragments_of_same_face(std::vector<internal::Number_lists::Pair>& links) const {
    const std::size_t number_of_cells = this->number_of_cells(m_depth), grain = 1 << 10;
    std::vector<std::vector<internal::Number_lists::Pair>> of_chunks((number_of_cells - 1) / grain +
                                                                     1);
    internal::parallel_for(m_is_parallel, 0, number_of_cells, grain,
                           [&](std::size_t begin, std::size_t end) {
                             for(std::size_t i = begin; i < end; ++i)
                               link_with_neighbors(i, of_chunks[begin / grain]);
                           });
    for(const auto& of_chunk : of_chunks)
      links.insert(links.end(), of_chunk.begin(), of_chunk.end());
  }

  /// links the sheets of cell number `i` with those of one half of the 26 neighbours
  void link_with_neighbors(std::size_t i, std::vector<internal::Number_lists::Pair>& links) const {
    const Cell_3 cell = Cell_3::from_key(m_depth, m_levels[m_depth].keys[i]);
    const auto [first, last] = sheets(m_depth, i);
    for(int k = 14; k < 27; ++k) {
      const std::size_t j = find(cell.neighbor(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1));
      if(j == number_of_cells(m_depth))
        continue;
      const auto [other_first, other_last] = sheets(m_depth, j);
      for(std::size_t sheet = first; sheet < last; ++sheet)
        for(std::size_t other = other_first; other < other_last; ++other)
          if(have_common_face(sheet, other))
            add_link(sheet, other, links);
    }
  }

  void link_faces_along_walls(const internal::Seams_in_grid& seams,
                              std::vector<internal::Number_lists::Pair>& links) const {
    std::vector<std::size_t> touching;
    seams.for_each_piece_in_walls(
        [&](const std::array<int, 3>& low, const std::array<int, 3>& high, const auto& faces) {
          touching.clear();
          Cell_3 cell{m_depth, {}};
          for(cell.index[2] = low[2]; cell.index[2] <= high[2]; ++cell.index[2])
            for(cell.index[1] = low[1]; cell.index[1] <= high[1]; ++cell.index[1])
              for(cell.index[0] = low[0]; cell.index[0] <= high[0]; ++cell.index[0]) {
                const std::size_t i = find(cell);
                if(i == number_of_cells(m_depth))
                  continue;
                for(std::uint32_t face : faces) {
                  const std::size_t sheet = sheet_of_face(i, face);
                  if(sheet != number_of_sheets(m_depth))
                    touching.push_back(sheet);
                }
              }
          std::sort(touching.begin(), touching.end());
          touching.erase(std::unique(touching.begin(), touching.end()), touching.end());
          for(std::size_t a = 0; a < touching.size(); ++a)
            for(std::size_t b = 0; b < a; ++b)
              add_link(touching[b], touching[a], links);
        });
  }

  /// \param places of the sheets of the next finer level; on return of those of this level
  void build_coarser_level(int level, std::vector<internal::Place>& places) {
    Level &coarse = m_levels[level], &fine = m_levels[level + 1];
    const auto number_of_fine_sheets = static_cast<std::uint32_t>(fine.cells.size());
    const auto parent_key = [&fine](std::size_t sheet) {
      return fine.keys[fine.cells[sheet]] >> 3;
    };
    internal::Disjoint_sets sets;
    internal::Piece_sorter sort;
    sets.reset(number_of_fine_sheets);
    for(std::uint32_t sheet = 0; sheet < number_of_fine_sheets; ++sheet) {
      if(!m_is_split && sheet > 0 && parent_key(sheet - 1) == parent_key(sheet))
        sets.unite(sheet - 1, sheet);
      for(std::uint32_t other : fine.links[sheet])
        if(other < sheet && parent_key(other) == parent_key(sheet))
          sets.unite(other, sheet);
    }
    fine.parents.resize(number_of_fine_sheets);
    std::vector<internal::Place> coarse_places;
    for(std::uint32_t begin = 0, end = 0; begin < number_of_fine_sheets; begin = end) {
      while(end < number_of_fine_sheets && parent_key(end) == parent_key(begin))
        ++end;
      const auto& firsts = sort(
          sets, begin, end, [&places](std::uint32_t sheet) { return places[sheet]; },
          coarse_places);
      coarse.keys.push_back(parent_key(begin));
      coarse.first_sheets.push_back(static_cast<std::uint32_t>(coarse.cells.size()));
      for(std::uint32_t first : firsts) {
        fine.parents[first] = static_cast<std::uint32_t>(coarse.cells.size());
        coarse.cells.push_back(static_cast<std::uint32_t>(coarse.keys.size() - 1));
        coarse.element_masks.push_back(0);
      }
      for(std::uint32_t sheet = begin; sheet < end; ++sheet) {
        const std::uint32_t parent = fine.parents[sheet] = fine.parents[sets.find(sheet)];
        coarse.element_masks[parent] |= internal::parent_element_mask(
            fine.element_masks[sheet], static_cast<int>(fine.keys[fine.cells[sheet]] & 7));
      }
    }
    coarse.first_sheets.push_back(static_cast<std::uint32_t>(coarse.cells.size()));
    index_keys(level);
    places.swap(coarse_places);

    std::vector<internal::Number_lists::Pair> children, links;
    children.reserve(number_of_fine_sheets);
    for(std::uint32_t sheet = 0; sheet < number_of_fine_sheets; ++sheet) {
      children.emplace_back(fine.parents[sheet], sheet);
      for(std::uint32_t other : fine.links[sheet])
        if(fine.parents[other] != fine.parents[sheet])
          links.emplace_back(fine.parents[sheet], fine.parents[other]);
    }
    coarse.children = internal::Number_lists(coarse.cells.size(), children);
    coarse.links = internal::Number_lists(coarse.cells.size(), links);
  }

  Triangulated_surface_3 m_surface;
  int m_depth;
  double m_side;
  Point_3 m_center;
  double m_wall_tolerance;
  bool m_is_split;
  bool m_is_parallel;
  std::vector<Level> m_levels;
  std::vector<std::size_t> m_first_faces;
  std::vector<std::uint32_t> m_faces;
};

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_OCTREE_3_H
