// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SMOOTH_SURFACE_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SMOOTH_SURFACE_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/parameters.h>
#include <CGAL/Restricted_laplacian_3/input/shared/Surface_source.h>
#include <CGAL/Restricted_laplacian_3/problems/scale_details.h>
#include <CGAL/Restricted_laplacian_3/problems/shared/put_positions.h>
#include <CGAL/Restricted_laplacian_3/problems/shared/space_of.h>

#include <CGAL/Real_timer.h>

#include <type_traits>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// Details of a surface of the caller are changed by `edit(space)`.
template <class Surface, class VertexPointMap, class NamedParameters, class Edit>
Solve_report change_details(const Surface& surface, VertexPointMap positions,
                            const Editing_options& options, const NamedParameters& np,
                            const Edit& edit) {
  CGAL::Real_timer timer;
  timer.start();
  const auto source = surface_source(surface);
  constexpr bool has_depth =
      std::is_same_v<Surface, Spline_space_3> || is_given_v<NamedParameters, internal_np::depth_t>;
  const Spline_space_3 space = space_for_details(space_of(surface, np), has_depth, options);
  const double space_seconds = timer.time();
  Edited_signal result = edit(space);
  put_positions(source, result.values, positions);
  result.space_seconds = space_seconds;
  return static_cast<const Solve_report&>(result);
}

} // namespace internal

/// \ingroup PkgRestrictedLaplacian3Problems
/// Smooths a surface: what is smaller than a length goes, what is larger remains, whatever the unit
/// of length and the triangles are. Waves of this length are halved, those of twice the length lose
/// a seventeenth, see `scale_details()`; with a `crease_angle` creases are kept, see
/// `smooth_between_creases()`.
/// \tparam Surface a model of `RestrictedSurface_3`, but of triangles or polygons
/// \param surface a mesh, a `soup()`, or a `Spline_space_3`
/// \param length \f$\ell\f$, positive
/// \param positions a model of `WritablePropertyMap` with vertices as keys and 3D points of \cgal
/// as values receives the moved vertices; it may be the vertex-point map of a mesh
/// \param np optional named parameters:
/// \cgalNamedParamsBegin
///   \named_of_space
///   \named_of_surface
///   \named_crease_angle_of_details
///   \named_tolerance{`1e-4`, of the linear systems or of the filter}
///   \named_usual_stabilization
///   \named_progress
/// \cgalNamedParamsEnd
/// With a `crease_angle` and without a `depth` cells are not larger than half of the mean edge.
/// \return whether all converged, the number of linear systems, times
/// \throws Input_error one of its derived classes names the face, vertex or parameter
/// \throws Canceled if `progress` returned `false`
template <class Surface, class VertexPointMap,
          class NamedParameters = parameters::Default_named_parameters,
          internal::Require_named_parameters<NamedParameters> = 0,
          internal::Require_property_map<VertexPointMap> = 0>
Solve_report smooth_surface(const Surface& surface, double length, VertexPointMap positions,
                            const NamedParameters& np = parameters::default_values()) {
  const Editing_options options(np);
  return internal::change_details(
      surface, positions, options, np, [&](const Spline_space_3& space) {
        return options.crease_angle ? smooth_between_creases(space, length, options)
                                    : scale_details(space, length, 0, options);
      });
}

/// \ingroup PkgRestrictedLaplacian3Problems
/// Sharpens a surface: what is smaller than a length is multiplied by a factor, what is larger
/// remains, see `scale_details()`.
/// \tparam Surface a model of `RestrictedSurface_3`, but of triangles or polygons
/// \param surface a mesh, a `soup()`, or a `Spline_space_3`
/// \param length \f$\ell\f$, positive
/// \param factor of details: 2 doubles them, 0 is `smooth_surface()`
/// \param positions as for `smooth_surface()`
/// \param np optional named parameters:
/// \cgalNamedParamsBegin
///   \named_of_space
///   \named_of_surface
///   \named_tolerance{`1e-4`, of the filter}
///   \named_usual_stabilization
///   \named_progress
/// \cgalNamedParamsEnd
/// \return whether all converged, the number of linear systems, times
/// \throws Input_error one of its derived classes names the face, vertex or parameter
/// \throws Canceled if `progress` returned `false`
template <class Surface, class VertexPointMap,
          class NamedParameters = parameters::Default_named_parameters,
          internal::Require_named_parameters<NamedParameters> = 0,
          internal::Require_property_map<VertexPointMap> = 0>
Solve_report sharpen_surface(const Surface& surface, double length, double factor,
                             VertexPointMap positions,
                             const NamedParameters& np = parameters::default_values()) {
  static_assert(!internal::is_given_v<NamedParameters, internal_np::crease_angle_t> ||
                    internal::is_given_v<NamedParameters, internal_np::geometry_t>,
                "sharpening knows no creases");
  Editing_options options(np);
  options.crease_angle.reset(); // it is of the geometry
  return internal::change_details(
      surface, positions, options, np,
      [&](const Spline_space_3& space) { return scale_details(space, length, factor, options); });
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SMOOTH_SURFACE_H
