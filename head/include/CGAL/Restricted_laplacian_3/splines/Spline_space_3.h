// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_SPLINE_SPACE_3_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_SPLINE_SPACE_3_H

#include <CGAL/Restricted_laplacian_3/basis/Tensor_basis_3.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parameters.h>
#include <CGAL/Restricted_laplacian_3/input/read_surface.h>
#include <CGAL/Restricted_laplacian_3/input/shared/function_on_surface.h>
#include <CGAL/Restricted_laplacian_3/integration/Surface_integration.h>
#include <CGAL/Restricted_laplacian_3/integration/Surface_material.h>
#include <CGAL/Restricted_laplacian_3/octree/Cell_3.h>
#include <CGAL/Restricted_laplacian_3/octree/Octree_3.h>
#include <CGAL/Restricted_laplacian_3/splines/shared/Level_elements.h>

#include <CGAL/assertions.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

class Partial_space;

/// gives `set` a number or a function object among named parameters, and tells the options of a
/// property map
template <class NamedParameters, class Tag, class Options, class Set>
void read_coefficient([[maybe_unused]] const NamedParameters& np, Tag tag,
                      [[maybe_unused]] Options& options, [[maybe_unused]] const Set& set) {
  if constexpr(is_given_v<NamedParameters, Tag>) {
    const auto value = parameters::get_parameter(np, tag);
    using Value = std::decay_t<decltype(value)>;
    if constexpr(std::is_arithmetic_v<Value> ||
                 std::is_invocable_v<const Value&, const Surface_point&>)
      set(value);
    else
      options.has_material_of_maps = true;
  }
}

/// what a caller gives as a coefficient of a material: a number, a function object, or a property
/// map of the source
template <class Source, class Coefficient>
auto coefficient_on_surface(const Source& source, const Coefficient& f,
                            const Vertex_interpolation& interpolation) {
  return function_on_surface(source, f, interpolation, [](const auto& value) {
    using Value = std::decay_t<decltype(value)>;
    if constexpr(Is_matrix<Value>::value)
      return matrix_components(value);
    else
      return Function_components<Value>::read(value);
  });
}

/// the material that named parameters describe
/// \param source such as `Mesh_source`
/// \param surface of the source
template <class Source, class NamedParameters>
Surface_material material_of([[maybe_unused]] const Source& source,
                             [[maybe_unused]] const Triangulated_surface_3& surface,
                             [[maybe_unused]] const NamedParameters& np) {
  constexpr bool has_diffusion = is_given_v<NamedParameters, internal_np::diffusion_t>,
                 has_density = is_given_v<NamedParameters, internal_np::density_t>;
  Surface_material material;
  if constexpr(has_diffusion || has_density) {
    const Vertex_interpolation interpolation = vertex_interpolation(source, surface, np);
    if constexpr(has_diffusion)
      material.set_diffusion(coefficient_on_surface(
          source, parameters::get_parameter(np, internal_np::diffusion), interpolation));
    if constexpr(has_density)
      material.set_density(coefficient_on_surface(
          source, parameters::get_parameter(np, internal_np::density), interpolation));
  }
  return material;
}

} // namespace internal

/// \ingroup PkgRestrictedLaplacian3Functions
/// The depth of the octree for functions that are given no `depth`.
///
/// For a mesh or soup it is the smallest depth from 5 to 8 at which sides of triangles, in the
/// mean, are at least half as long as a cell is wide. That gives about one to four unknowns for
/// each vertex, and errors like those of the cotangent Laplacian on the same triangles, or smaller.
/// See the section on the depth in the User Manual for what speaks for more or less.
///
/// For a set of points it is the largest from 1 to 6 at which the cells that hold points have 50 of
/// them each, on average. With fewer points in a cell the sums do not determine the functions on it
/// any more, and eigenvalues become too small.
///
/// Takes time linear in the number of triangles, or \f$O(n \log n)\f$ for \f$n\f$ points.
/// \param surface triangles, or points
/// \param cube_scale side of the domain cube over the longest side of the bounding box, from 1 to
/// \f$10^6\f$
/// \throws Parameter_error if `cube_scale` is out of range
int default_depth(const Triangulated_surface_3& surface, double cube_scale);

/// \ingroup PkgRestrictedLaplacian3Options
/// How a `Spline_space_3` is made: the named parameters of its constructors.
struct Spline_space_options {
  /// side of the domain cube over the longest side of the bounding box
  static constexpr double default_cube_scale = 1.1;

  /// depth \f$d\f$ of the octree; without a value `default_depth()`
  std::optional<int> depth;
  /// side of the domain cube over the longest side of the bounding box; without a value
  /// `default_cube_scale`, or 1.2
  /// in the space of the paper
  std::optional<double> cube_scale;
  /// only elements centered inside the grid exist, and they are not split
  bool paper = false;
  /// an element is split into one for each connected component of the surface in its support; has
  /// no effect on the space of the paper
  bool split = true;
  /// the same for a point set, in place of `split`: by the components that links between
  /// points form
  bool split_point_set = false;
  /// distance, in the unit of the coordinates, up to which sides of faces that no other face shares
  /// are joined if they run along each other; without a value they are not
  std::optional<double> joining_tolerance;
  /// diffusion and density of the surface
  Surface_material material;
  /// \cond
  // Whether they are property maps among named parameters, which are read with the surface.
  bool has_material_of_maps = false;
  /// \endcond
  /// bytes that the surface, the space and a Poisson problem or eigenpairs in it may take: what
  /// would take more, see `estimate_memory()`, is refused before any work. Without a value
  /// `memory_of_machine()`
  std::optional<double> maximum_memory;
  /// whether octree, numbering and assembly use several threads; no effect unless the program is
  /// linked with TBB. The results are the same.
  bool is_parallel = false;

  /// the defaults
  Spline_space_options() = default;
  /// what is among named parameters, but property maps of the material, and the defaults else
  template <class NamedParameters, internal::Require_named_parameters<NamedParameters> = 0>
  Spline_space_options(const NamedParameters& np) : is_parallel(internal::is_parallel(np)) {
    internal::read_parameter(np, internal_np::depth, depth);
    internal::read_parameter(np, internal_np::cube_scale, cube_scale);
    internal::read_parameter(np, internal_np::paper, paper);
    internal::read_parameter(np, internal_np::split, split);
    internal::read_parameter(np, internal_np::split, split_point_set);
    internal::read_parameter(np, internal_np::joining_tolerance, joining_tolerance);
    internal::read_parameter(np, internal_np::maximum_memory, maximum_memory);
    internal::read_coefficient(np, internal_np::diffusion, *this, [this](const auto& diffusion) {
      material.set_diffusion(diffusion);
    });
    internal::read_coefficient(np, internal_np::density, *this,
                               [this](const auto& density) { material.set_density(density); });
  }
};

/// \ingroup PkgRestrictedLaplacian3Functions
/// The spaces of restricted splines, one for each level of the octree of a surface.
///
/// The element \f$b_o\f$ of a cell \f$o\f$ is the tensor product of B-splines of degree 2 centered
/// on \f$o\f$; its support is the \f$3 \times 3 \times 3\f$ cells around \f$o\f$. The space at
/// level \f$l\f$ is spanned by the restrictions to the surface of all elements whose open support
/// meets the surface, also of those centered one cell outside the \f$2^l\f$ grid: they sum to 1 on
/// the whole surface, so the constants are in the space. The spaces are nested: each element is a
/// combination of elements of the next finer level.
///
/// *Splitting.* If the surface in the support of \f$b_o\f$ has several connected components, there
/// is one element for each of them: \f$b_o\f$ on the component, and 0 elsewhere. So parts of the
/// surface that are near in space, but far along the surface, share no element, however thin the
/// space between them is. All properties above remain: an element of the finer level lies in the
/// support of its coarse ones, and its component in exactly one of theirs.
///
/// With `paper(true)` only elements centered inside the grid exist, and they are not split,
/// as in the paper (section 4.4).
///
/// Elements of a level are numbered in Morton order of their cells; those centered outside the grid
/// follow those of the nearest cell inside.
///
/// *Integration.* A space knows how functions on its surface are integrated, `integration()`: by
/// `default_integration()`, or as `integrated_by()` says.
///
/// A space does not change, and copies share all that is large: they cost nothing.
class Spline_space_3 {
  using Options = Spline_space_options;

public:
  /// stands for an element that does not exist
  static constexpr std::uint32_t no_element = Restricted_laplacian_3::no_element;

  /// \tparam Surface a model of `RestrictedSurface_3`
  /// \param surface a mesh, a `soup()`, or oriented points
  /// \param np optional named parameters:
  /// \cgalNamedParamsBegin
  ///   \named_of_space
  ///   \named_of_surface
  /// \cgalNamedParamsEnd
  /// \throws Input_error one of its derived classes names the face, vertex or parameter
  ///
  /// The surface is read once, and not needed any more. Time and memory are proportional to the
  /// number of triangles plus the number of cells that meet the surface (times its logarithm for
  /// sorting).
  template <class Surface, class NamedParameters = parameters::Default_named_parameters,
            internal::Require_named_parameters<NamedParameters> = 0,
            std::enable_if_t<!std::is_same_v<Surface, Triangulated_surface_3>, int> = 0>
  explicit Spline_space_3(const Surface& surface,
                          const NamedParameters& np = parameters::default_values())
    : Spline_space_3(made(internal::surface_source(surface), np)) {}

  /// The spaces of a surface given as points and triangles, which need not be a manifold, or as
  /// oriented points.
  /// \param surface becomes a part of the space
  /// \param options named parameters, or the options themselves:
  /// \cgalNamedParamsBegin
  ///   \named_of_space
  /// \cgalNamedParamsEnd
  /// \throws Parameter_error if a parameter is outside its domain
  explicit Spline_space_3(Triangulated_surface_3 surface, const Options& options = Options());

  /// The same space with another integration: samples, weights, a diffusion tensor, a curved
  /// surface; for example `space.integrated_by(Monte_carlo(space.octree(), 100000, 1))`.
  /// \param integration any model of `SurfaceIntegration_3`, which is copied
  Spline_space_3 integrated_by(const Surface_integration& integration) const {
    Spline_space_3 result(*this);
    result.set_integration(integration);
    return result;
  }
  /// The same space for another material: its octree and elements are shared, so only matrices have
  /// to be assembled again.
  Spline_space_3 with_material(const Surface_material& material) const {
    Spline_space_3 result(*this);
    result.m_options.material = material;
    result.set_integration(m_integration);
    return result;
  }
  /// \cond
  // the same with the material: of all matrices and loads
  const Surface_integration& integration_with_material() const { return m_with_material; }
  /// \endcond
  /// diffusion and density of the surface
  const Surface_material& material() const { return m_options.material; }
  /// how functions on the surface are integrated, without its material
  const Surface_integration& integration() const { return m_integration; }

  /// the values of the named parameters, with defaults in place of those that were not given
  const Options& options() const { return m_options; }
  /// depth \f$d\f$ of the octree, the finest level
  int depth() const { return m_octree->depth(); }
  /// the octree, with the sheets of all levels; shared by copies of the space
  const Octree_3& octree() const { return *m_octree; }
  /// the surface that the splines are restricted to
  const Triangulated_surface_3& surface() const { return m_octree->surface(); }
  /// whether only elements centered inside the grid exist, unsplit
  bool is_paper_space() const { return m_options.paper; }
  /// whether elements are split by the components of the surface in their support
  bool is_split() const { return m_octree->is_split(); }

  /// `level`, the finest one if it has no value
  /// \throws Parameter_error if it is not from 0 to depth
  int checked_level(std::optional<int> level) const;

  /// number of elements of a level
  std::size_t dimension(int level) const { return at(level).first_slots.size(); }
  /// number of elements of the finest level
  std::size_t dimension() const { return dimension(depth()); }
  /// number of cells of a level that meet the surface
  std::size_t number_of_cells(int level) const { return m_octree->number_of_cells(level); }
  /// number of connected pieces of the surface in these cells; on level 0 the number of connected
  /// components of the surface. Without splitting all surface in a cell counts as one piece.
  std::size_t number_of_sheets(int level) const { return m_octree->number_of_sheets(level); }
  /// number of elements of a level that are one of several into which an element was split
  std::size_t number_of_split_elements(int level) const {
    return at(level).number_of_split_elements;
  }

  /// The elements that act on a sheet of a level; `no_element` where there is none, or where it
  /// vanishes on the sheet. All code above this class reaches elements through this function alone.
  const Cell_elements& elements(int level, std::size_t sheet) const {
    CGAL_precondition(sheet < number_of_sheets(level));
    return (*m_levels)[level].elements[sheet];
  }

  /// a sheet on which an element acts, and its position in `elements()` of that sheet
  std::pair<std::size_t, int> slot(int level, std::size_t element) const {
    CGAL_precondition(element < dimension(level));
    const std::uint32_t slot = (*m_levels)[level].first_slots[element];
    return {slot / Tensor_basis_3::size, static_cast<int>(slot % Tensor_basis_3::size)};
  }

  /// the cell that an element is centered on; it may lie outside the grid
  Cell_3 center(int level, std::size_t element) const {
    const auto [sheet, position] = slot(level, element);
    const auto [dx, dy, dz] = Tensor_basis_3::offset(position);
    return m_octree->cell(level, sheet).neighbor(dx, dy, dz);
  }

private:
  friend class internal::Partial_space;

  /// a part of a space, whose octree and elements were made elsewhere
  Spline_space_3(const Options& options, Octree_3&& octree,
                 std::vector<internal::Level_elements>&& levels);

  template <class Source, class NamedParameters>
  static Spline_space_3 made(const Source& source, const NamedParameters& np) {
    Triangulated_surface_3 surface = internal::read_source(source, np);
    Options options(np);
    options.material = internal::material_of(source, surface, np);
    return Spline_space_3(std::move(surface), options);
  }

  /// \param integration without a material
  void set_integration(const Surface_integration& integration) {
    m_with_material =
        internal::integration_with_material(integration, m_options.material, surface());
    m_integration = integration;
  }

  const internal::Level_elements& at(int level) const {
    CGAL_precondition(level >= 0 && level <= depth());
    return (*m_levels)[level];
  }

  internal::Level_elements number_elements(const internal::Octree_level& level) const;

  static Octree_3 make_octree(Triangulated_surface_3&& surface, const Options& o);

  /// whether elements are split, by checked options
  static bool splits(const Triangulated_surface_3& surface, const Options& o) {
    return surface.is_point_set() ? o.split_point_set : o.split;
  }

  /// with defaults, also those that depend on the surface
  static Options checked(const Triangulated_surface_3& surface, Options options);

  Options m_options;
  std::shared_ptr<const Octree_3> m_octree;
  std::shared_ptr<const std::vector<internal::Level_elements>> m_levels;
  Surface_integration m_integration, m_with_material;
};

} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_SPLINE_SPACE_3_H
