// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_OCTREE_3_H
#define CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_OCTREE_3_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>
#include <CGAL/Restricted_laplacian_3/octree/Cell_3.h>
#include <CGAL/Restricted_laplacian_3/octree/clip_to_cells.h>
#include <CGAL/Restricted_laplacian_3/octree/internal/Domain_cube.h>
#include <CGAL/Restricted_laplacian_3/octree/shared/Octree_level.h>
#include <CGAL/Restricted_laplacian_3/octree/shared/element_masks.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>
#include <CGAL/Restricted_laplacian_3/surface/shared/Divided_surface.h>

#include <CGAL/assertions.h>

#include <boost/range/iterator_range_core.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

namespace internal {
class Octree_builder;

/// \throws Parameter_error if it is not from 1 to 1e6
double checked_cube_scale(double cube_scale);
} // namespace internal

/// \ingroup PkgRestrictedLaplacian3Dev
/// The sparse octree of the cells that meet a surface, with every level, and the sheets in them.
///
/// The root is the domain cube: axis-aligned, centered on the bounding box of the surface, its side
/// `cube_scale` times the longest side of the box. Level \f$l\f$ is the grid of \f$2^l\f$ cells a
/// side; its cells are stored as a sorted array of Morton keys, so that a neighbor is found by
/// binary search.
///
/// A *sheet* is a connected piece of the surface in one cell. On the finest level fragments of two
/// triangles belong to the same sheet if the triangles are joined along a side (see
/// `Surface_seams`) that runs through the closed cell for more than a point. Sheets of different
/// cells, which are then neighbors, possibly across an edge or corner, are *linked* if a triangle
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

  /// Largest `wall_tolerance()` of the finest level. Far from the origin the coordinates themselves
  /// have rounding errors, and the tolerance grows with them; a cell that is less than 64
  /// tolerances wide, 256 units in the last place of the coordinates, holds no surface worth the
  /// name, and points could not be told to lie in one cell or the next.
  static constexpr double largest_wall_tolerance = 1. / 64;

  /// Faces of at most this height, in units of the width of the finest cells, are bridged by their
  /// neighbors, see `Surface_seams`.
  static constexpr double thin_face_height = 1e-6;

  /// Most that a patch of a smooth surface deviates from its pieces, in units of the width of the
  /// finest cells: so little that no node on it is far outside the cell whose polynomials are
  /// evaluated there.
  static constexpr double piece_tolerance = 8e-3;

  /// Number of sheets that cannot be exceeded: each of them has 27 numbers of 32 bits in a
  /// `Spline_space_3`.
  static constexpr std::size_t maximum_number_of_sheets = 0xffffffff / 27;

  /// The octree is built in `Surface_windows` of about so many fragments, of which each takes 140
  /// bytes meanwhile.
  static constexpr std::size_t default_fragments_at_once = std::size_t(1) << 22;

  /// \param surface becomes a part of the octree
  /// \param depth \f$d\f$, from 1 to 20
  /// \param cube_scale side of the domain cube over the longest side of the bounding box, from 1 to
  /// 1e6; the cube of a smooth surface is larger where patches would leave it
  /// \param is_split whether the surface in a cell is split into sheets
  /// \param joining_tolerance of `Surface_seams`, in the unit of the coordinates; negative: do not
  /// join
  /// \param is_parallel whether several threads are used, if the program is linked with TBB; the
  /// octree is the same
  /// \param fragments_at_once about how many fragments of triangles are in memory at once, at least
  /// 1; the octree is the same
  /// \throws Parameter_error if `depth` is not from 1 to 20, if `cube_scale` is not from 1 to 1e6,
  /// if the octree would have more than `maximum_number_of_sheets` sheets, or if the surface is so
  /// far from the origin that its coordinates have too few digits for the depth, see
  /// `largest_wall_tolerance`
  Octree_3(Triangulated_surface_3 surface, int depth, double cube_scale, bool is_split = true,
           double joining_tolerance = -1, bool is_parallel = false,
           std::size_t fragments_at_once = default_fragments_at_once);

  /// depth \f$d\f$, the finest level
  int depth() const { return m_depth; }
  /// the surface, as given to the constructor
  const Triangulated_surface_3& surface() const { return m_surface; }

  /// The flat triangles that are cut by the walls of the cells: the faces of the surface, or, if it
  /// is smooth, the pieces of its patches.
  const Triangulated_surface_3& pieces() const {
    return m_division ? m_division->pieces() : m_surface;
  }
  /// \cond
  // how the patches are divided; null if the surface is not smooth
  const internal::Divided_surface* division() const { return m_division.get(); }
  // cells and sheets of a level
  const internal::Octree_level& level_data(int level) const { return at(level); }
  /// \endcond

  /// side of the domain cube
  double side() const { return m_cube.side; }
  /// width \f$h = \mathrm{side} / 2^l\f$ of the cells of a level
  double cell_width(int level) const { return std::ldexp(side(), -level); }

  /// whether the surface in a cell is split into sheets
  bool is_split() const { return m_is_split; }

  /// whether what is computed with it uses several threads, as its construction did
  bool is_parallel() const { return m_is_parallel; }

  /// number of cells of a level that meet the surface
  std::size_t number_of_cells(int level) const { return at(level).number_of_cells(); }

  /// number of sheets of a level
  std::size_t number_of_sheets(int level) const { return at(level).number_of_sheets(); }

  /// the cell of a sheet
  Cell_3 cell(int level, std::size_t sheet) const {
    CGAL_precondition(sheet < number_of_sheets(level));
    return m_levels[level].cell(sheet);
  }

  /// number, in the next coarser level, of the sheet that contains a sheet; level 0 has none
  std::size_t parent(int level, std::size_t sheet) const {
    CGAL_precondition(level > 0 && sheet < number_of_sheets(level));
    return m_levels[level].parents[sheet];
  }

  /// numbers, in the next finer level, of the sheets that a sheet consists of, in ascending order;
  /// the finest level has none
  Sheet_range children(int level, std::size_t sheet) const {
    CGAL_precondition(level < depth() && sheet < number_of_sheets(level));
    return m_levels[level].children[sheet];
  }

  /// numbers of the sheets in other cells of the level that a sheet is linked with, in ascending
  /// order
  Sheet_range links(int level, std::size_t sheet) const {
    CGAL_precondition(sheet < number_of_sheets(level));
    return m_levels[level].links[sheet];
  }

  /// number of a cell, or `number_of_cells(cell.level)` if it does not meet the surface
  std::size_t find(const Cell_3& cell) const { return at(cell.level).find(cell); }

  /// numbers of the sheets in cell number `i` of a level: a half-open range
  std::array<std::size_t, 2> sheets(int level, std::size_t i) const {
    CGAL_precondition(i < number_of_cells(level));
    return m_levels[level].sheets(i);
  }

  /// Whether the element centered on the neighbor of the cell of a sheet at offset (dx, dy, dz),
  /// each -1, 0 or 1, is not zero on all of the sheet. It is zero on it where the sheet is part of
  /// the wall opposite to the neighbor.
  bool meets_element(int level, std::size_t sheet, int dx, int dy, int dz) const {
    CGAL_precondition(sheet < number_of_sheets(level));
    return m_levels[level].element_masks[sheet] >> internal::element_bit(dx, dy, dz) & 1;
  }

  /// the faces, or pieces, that have a fragment in a sheet of the finest level, in ascending order
  boost::iterator_range<const std::uint32_t*> faces(std::size_t sheet) const {
    CGAL_precondition(sheet < number_of_sheets(depth()));
    return m_levels[m_depth].faces[sheet];
  }

  /// the sheet in cell number `i` of the finest level that has a fragment of a face or piece, or
  /// `number_of_sheets(depth())` if there is none
  std::size_t sheet_of_face(std::size_t i, std::size_t face) const {
    CGAL_precondition(i < number_of_cells(m_depth));
    return m_levels[m_depth].sheet_of_face(i, face);
  }

  /// number of fragments of the finest level
  std::size_t number_of_fragments() const { return m_levels[m_depth].faces.numbers().size(); }

  /// the fragment of a face or piece in a cell of the finest level; its coordinates are in units of
  /// the cell width, the origin is that of the grid
  Fragment fragment(const Cell_3& cell, std::size_t face) const;

  /// coordinates of a point in the grid of a level, in units of the cell width. The same point has
  /// exactly twice these coordinates on the next finer level.
  std::array<double, 3> grid_coordinates(int level, const Point_3& p) const {
    return m_cube.grid_coordinates(level, p);
  }

  /// The sheet of a level on which a point of a face lies, and its local coordinates in the cell,
  /// in \f$[0,1]^3\f$ up to rounding. A point on a wall may belong to any of the cells that touch
  /// it: the one that is taken owns a fragment of the face, or is an ancestor of one that does. It
  /// has to, because an element that vanishes on a sheet is not listed there, but need not vanish
  /// on another face that touches the cell.
  /// \param level of the sheet
  /// \param point on the face
  /// \param face a face, or a piece
  /// \return the number of sheets of the level as sheet if the point is not on the face
  std::pair<std::size_t, std::array<double, 3>> locate(int level, const Point_3& point,
                                                       std::size_t face) const;

  /// The same for a location on the surface. If it is smooth, the sheet is that of the point of the
  /// flat piece, and the coordinates are those of the point of the patch: a little outside of the
  /// cell, perhaps.
  std::pair<std::size_t, std::array<double, 3>> locate(int level,
                                                       const Surface_location& location) const;

  /// distance, in units of the cell width of a level, below which a point counts as lying on a wall
  double wall_tolerance(int level) const { return std::ldexp(m_wall_tolerance, level); }

private:
  friend class internal::Octree_builder;

  /// without levels
  Octree_3(Triangulated_surface_3&& surface, int depth, double cube_scale, bool is_split,
           bool is_parallel);

  const internal::Octree_level& at(int level) const {
    CGAL_precondition(level >= 0 && level <= m_depth);
    return m_levels[level];
  }

  /// makes the domain cube large enough for the pieces
  void fit_pieces();

  /// what cuts the faces into fragments
  Cell_clipper clipper() const;

  Triangulated_surface_3 m_surface;
  std::shared_ptr<const internal::Divided_surface> m_division;
  int m_depth;
  internal::Domain_cube m_cube;
  double m_wall_tolerance;
  bool m_is_split, m_is_parallel;
  std::vector<internal::Octree_level> m_levels;
};

} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/octree/Octree_3_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_OCTREE_3_H
