// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_SPLINE_SPACE_3_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_SPLINE_SPACE_3_H

#include <CGAL/Restricted_laplacian_3/foundation/compiled.h>
#include <CGAL/Restricted_laplacian_3/foundation/parameters.h>
#include <CGAL/Restricted_laplacian_3/octree/Cell_3.h>
#include <CGAL/Restricted_laplacian_3/octree/Octree_3.h>
#include <CGAL/Restricted_laplacian_3/splines/Tensor_basis_3.h>
#include <CGAL/Restricted_laplacian_3/surface/read_point_set.h>

#include <CGAL/assertions.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {
class Element_numbering;
} // namespace internal

/// \ingroup PkgRestrictedLaplacian3Functions
/// The depth that a set of points allows, for functions that are given no `octree_depth`: the
/// largest up to 6 at which the cells that hold points have 50 of them each, on average; at least
/// 1.
///
/// With fewer points in a cell the sums do not determine the functions on it any more, and
/// eigenvalues become too small: see the section on points in the User Manual.
/// \param surface one that is given by points
/// \param cube_scale side of the domain cube over the longest side of the bounding box
int default_octree_depth_of_points(const Triangulated_surface_3& surface, double cube_scale);

/// \ingroup PkgRestrictedLaplacian3Functions
/// Which space a `Spline_space_3` is.
struct Spline_space_options {
  /// depth \f$d\f$ of the octree
  int octree_depth = 6;
  /// side of the domain cube over the longest side of the bounding box; 0 stands for 1.1, or for
  /// 1.2 in the space of the paper
  double cube_scale = 0;
  /// only elements centred inside the grid exist, and they are not split
  bool paper_space = false;
  /// an element is split into one for each connected component of the surface in its support; has
  /// no effect on the space of the paper
  bool split_elements = true;
  /// the same for a point set, in place of `split_elements`: by the components that links between
  /// points form, see `read_point_set()`
  bool split_point_set = false;
  /// distance, in the unit of the coordinates, up to which sides of faces that no other face shares
  /// are joined if they run along each other; negative: they are not
  double joining_tolerance = -1;
  /// whether octree, numbering and assembly use several threads; no effect unless the program is
  /// linked with TBB. The results are the same.
  bool is_parallel = false;
};

/// \ingroup PkgRestrictedLaplacian3Functions
/// The spaces of restricted splines, one for each level of the octree of a surface.
///
/// The element \f$b_o\f$ of a cell \f$o\f$ is the tensor product of B-splines of degree 2 centred
/// on \f$o\f$; its support is the \f$3 \times 3 \times 3\f$ cells around \f$o\f$. The space at
/// level \f$l\f$ is spanned by the restrictions to the surface of all elements whose open support
/// meets the surface, also of those centred one cell outside the \f$2^l\f$ grid: they sum to 1 on
/// the whole surface, so the constants are in the space. The spaces are nested: each element is a
/// combination of elements of the next finer level.
///
/// *Splitting.* If the surface in the support of \f$b_o\f$ has several connected components, there
/// is one element for each of them: \f$b_o\f$ on the component, and 0 elsewhere. So parts of the
/// surface that are near in space, but far along the surface, share no element, however thin the
/// space between them is. All properties above remain: an element of the finer level lies in the
/// support of its coarse ones, and its component in exactly one of theirs.
///
/// With `paper_space(true)` only elements centred inside the grid exist, and they are not split, as
/// in the paper (section 4.4).
///
/// Elements of a level are numbered in Morton order of their cells.
class Spline_space_3 {
public:
  /// stands for an element that does not exist
  static constexpr std::uint32_t no_element = Restricted_laplacian_3::no_element;

  /// \tparam FaceGraph a model of `FaceListGraph` and `VertexListGraph`, all of whose faces are
  /// triangles; or a model of `ConstRange`, for example `CGAL::Point_set_3`, of oriented points
  /// \param tm the surface, a mesh or a range of oriented points
  /// \param np optional named parameters:
  /// - `octree_depth`: depth \f$d\f$ of the octree; default 6, or
  ///   `default_octree_depth_of_points()`
  /// - `cube_scale`: side of the domain cube over the longest side of the bounding box; default
  ///   1.1, or 1.2 with `paper_space(true)`
  /// - `paper_space`: whether only elements centred inside the grid exist, unsplit; default `false`
  /// - `split_elements`: whether elements are split by the components of the surface in their
  ///   support; default `true`, no effect with `paper_space(true)`. For points the default is
  ///   `false`, because their components are guessed, see `read_point_set()`
  /// - `joining_tolerance`: distance up to which open sides of faces are joined, to close duplicate
  ///   vertices and T-junctions, see `Surface_seams`; by default they are not joined
  /// - `concurrency_tag`: `CGAL::Parallel_tag()` to use several threads here and in the assembly of
  ///   operators, which needs TBB; `CGAL::Parallel_if_available_tag()` to do so if the program is
  ///   linked with TBB; default `CGAL::Sequential_tag()`. The results are the same.
  /// - `vertex_point_map`: default `get_const_property_map(CGAL::vertex_point, tm)`
  /// - `geom_traits`: a model of `RestrictedLaplacianTraits_3`, see `read_surface()`
  /// - for points, in its place, all named parameters of `read_point_set()`: `point_map`,
  ///   `normal_map`, `area_map`, `number_of_neighbors`
  /// \throws Input_error one of its derived classes names the face, vertex or parameter
  ///
  /// The mesh is read once, and not needed any more. Time and memory are proportional to the number
  /// of triangles plus the number of cells that meet the surface (times its logarithm for sorting).
  template <class FaceGraph, class NamedParameters = parameters::Default_named_parameters,
            internal::Require_named_parameters<NamedParameters> = 0>
  explicit Spline_space_3(const FaceGraph& tm,
                          const NamedParameters& np = parameters::default_values())
    : Spline_space_3(surface_and_options(tm, np)) {}

  /// The spaces of a triangle soup, which need not be a manifold: two triangles are joined if they
  /// have two indices in common, any number of them at one edge.
  /// \param points a range of 3D points
  /// \param triangles a range of ranges of three indices into `points`
  /// \param np all named parameters of the constructor above but the vertex point map
  template <class PointRange, class TriangleRange,
            class NamedParameters = parameters::Default_named_parameters,
            internal::Require_no_named_parameters<TriangleRange> = 0>
  Spline_space_3(const PointRange& points, const TriangleRange& triangles,
                 const NamedParameters& np = parameters::default_values())
    : Spline_space_3(read_surface(points, triangles, np), spline_space_options(np)) {}

  /// the spaces of a surface given as points and triangles, which need not be a manifold, or as
  /// oriented points
  explicit Spline_space_3(Triangulated_surface_3 surface,
                          const Spline_space_options& options = Spline_space_options());

  /// the options, without defaults that depend on others
  const Spline_space_options& options() const { return m_options; }
  /// depth \f$d\f$ of the octree, the finest level
  int depth() const { return m_octree.depth(); }
  /// the octree, with the sheets of all levels
  const Octree_3& octree() const { return m_octree; }
  /// the surface that the splines are restricted to
  const Triangulated_surface_3& surface() const { return m_octree.surface(); }
  /// whether only elements centred inside the grid exist, unsplit
  bool is_paper_space() const { return m_options.paper_space; }
  /// whether elements are split by the components of the surface in their support
  bool is_split() const { return m_octree.is_split(); }

  /// `level`
  /// \throws Parameter_error if it is not from 0 to depth
  int checked_level(int level) const;

  /// number of elements of a level
  std::size_t dimension(int level) const { return at(level).first_slots.size(); }
  /// number of elements of the finest level
  std::size_t dimension() const { return dimension(depth()); }
  /// number of cells of a level that meet the surface
  std::size_t number_of_cells(int level) const { return m_octree.number_of_cells(level); }
  /// number of connected pieces of the surface in these cells; on level 0 the number of connected
  /// components of the surface. Without splitting all surface in a cell counts as one piece.
  std::size_t number_of_sheets(int level) const { return m_octree.number_of_sheets(level); }
  /// number of elements of a level that are one of several into which an element was split
  std::size_t number_of_split_elements(int level) const {
    return at(level).number_of_split_elements;
  }

  /// The elements that act on a sheet of a level; `no_element` where there is none, or where it
  /// vanishes on the sheet. All code above this class reaches elements through this function alone.
  const Cell_elements& elements(int level, std::size_t sheet) const {
    CGAL_precondition(sheet < number_of_sheets(level));
    return m_levels[level].elements[sheet];
  }

  /// a sheet on which an element acts, and its position in `elements()` of that sheet
  std::pair<std::size_t, int> slot(int level, std::size_t element) const {
    CGAL_precondition(element < dimension(level));
    const std::uint32_t slot = m_levels[level].first_slots[element];
    return {slot / Tensor_basis_3::size, static_cast<int>(slot % Tensor_basis_3::size)};
  }

  /// the cell that an element is centred on; it may lie outside the grid
  Cell_3 center(int level, std::size_t element) const {
    const auto [sheet, position] = slot(level, element);
    const auto [dx, dy, dz] = Tensor_basis_3::offset(position);
    return m_octree.cell(level, sheet).neighbor(dx, dy, dz);
  }

  /// The sheet of a level on which a point of a face lies, and its local coordinates in the cell,
  /// in \f$[0,1]^3\f$ up to rounding. A point on a wall may belong to any of the cells that touch
  /// it: the one that is taken owns a fragment of the face, or is an ancestor of one that does. It
  /// has to, because an element that vanishes on a sheet is not listed there, but need not vanish
  /// on another face that touches the cell.
  /// \return the number of sheets of the level as sheet if the point is not on the face
  std::pair<std::size_t, std::array<double, 3>> locate(int level, const Point_3& point,
                                                       std::size_t face) const;

private:
  struct Level {
    std::vector<Cell_elements> elements; // of sheets
    std::vector<std::uint32_t> first_slots;
    std::size_t number_of_split_elements = 0;
  };

  friend class internal::Element_numbering;

  const Level& at(int level) const {
    CGAL_precondition(level >= 0 && level <= depth());
    return m_levels[level];
  }

  struct Surface_and_options {
    Triangulated_surface_3 surface;
    Spline_space_options options;
  };

  explicit Spline_space_3(Surface_and_options&& s)
    : Spline_space_3(std::move(s.surface), s.options) {}

  template <class MeshOrPoints, class NamedParameters>
  static Surface_and_options surface_and_options(const MeshOrPoints& input,
                                                 const NamedParameters& np) {
    Surface_and_options result = {internal::read_mesh_or_points(input, np),
                                  spline_space_options(np)};
    if(result.surface.is_point_set() &&
       !internal::is_given_v<NamedParameters, internal_np::octree_depth_t>)
      result.options.octree_depth =
          default_octree_depth_of_points(result.surface, result.options.cube_scale);
    return result;
  }

  template <class NamedParameters>
  static Spline_space_options spline_space_options(const NamedParameters& np) {
    using parameters::choose_parameter;
    using parameters::get_parameter;
    Spline_space_options o;
    o.octree_depth = choose_parameter(get_parameter(np, internal_np::octree_depth), o.octree_depth);
    o.paper_space = choose_parameter(get_parameter(np, internal_np::paper_space), o.paper_space);
    o.cube_scale = choose_parameter(get_parameter(np, internal_np::cube_scale),
                                    default_cube_scale(o.paper_space));
    o.split_elements =
        choose_parameter(get_parameter(np, internal_np::split_elements), o.split_elements);
    o.split_point_set =
        choose_parameter(get_parameter(np, internal_np::split_elements), o.split_point_set);
    o.joining_tolerance =
        choose_parameter(get_parameter(np, internal_np::joining_tolerance), o.joining_tolerance);
    o.is_parallel = internal::is_parallel(np);
    check_given(o);
    return o;
  }

  static Octree_3 make_octree(Triangulated_surface_3&& surface, const Spline_space_options& o);

  static double default_cube_scale(bool paper_space) { return paper_space ? 1.2 : 1.1; }

  /// of options that may stand for a default, those of named parameters may not
  static void check_given(const Spline_space_options& options);
  static void check_tolerance(double tolerance);

  static Spline_space_options checked(Spline_space_options options);

  Spline_space_options m_options;
  Octree_3 m_octree;
  std::vector<Level> m_levels;
};

} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_SPLINE_SPACE_3_H
