// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SPHERICAL_PARAMETERIZATION_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SPHERICAL_PARAMETERIZATION_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/parameters.h>
#include <CGAL/Restricted_laplacian_3/input/shared/Surface_source.h>
#include <CGAL/Restricted_laplacian_3/problems/map_to_sphere.h>
#include <CGAL/Restricted_laplacian_3/problems/shared/put_positions.h>
#include <CGAL/Restricted_laplacian_3/problems/shared/space_of.h>

#include <CGAL/Real_timer.h>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Problems
/// Maps a closed surface without holes and handles to the unit sphere, and keeps angles as well as
/// the report says: by the conformal `Mean_curvature_flow` until it is round \cgalCite{KSBC12},
/// then radially, and then by the Moebius transformation for which the mean of the map over the
/// surface is the center of the sphere \cgalCite{BCK18}. So the map is unique up to rotations.
/// \tparam Surface a model of `RestrictedSurface_3`, but of triangles or polygons
/// \param surface a mesh, a `soup()`, or a `Spline_space_3`
/// \param positions a model of `WritablePropertyMap` with vertices as keys and 3D points of \cgal
/// as values receives the points on the sphere
/// \param np optional named parameters:
/// \cgalNamedParamsBegin
///   \named_of_space
///   \named_of_surface
///   \named_tolerance{`1e-3`, the `Flow_report::sphere_deviation` at which the flow ends}
///   \named_maximum_iterations{`200` steps}
///   \named_usual_stabilization
///   \named_progress
/// \cgalNamedParamsEnd
/// \return whether the flow ended at a sphere, how far the map is from a conformal one, and how
/// many faces are turned over
/// \throws Input_error one of its derived classes names the face, vertex or parameter; or the
/// surface has a boundary, several components, holes or handles
/// \throws Canceled if `progress` returned `false`
template <class Surface, class VertexPointMap,
          class NamedParameters = parameters::Default_named_parameters,
          internal::Require_named_parameters<NamedParameters> = 0,
          internal::Require_property_map<VertexPointMap> = 0>
Sphere_map_report
spherical_parameterization(const Surface& surface, VertexPointMap positions,
                           const NamedParameters& np = parameters::default_values()) {
  CGAL::Real_timer timer;
  timer.start();
  const auto source = internal::surface_source(surface);
  const Spline_space_3 space = internal::space_of(surface, np);
  const double space_seconds = timer.time();
  Sphere_map map = map_to_sphere(space, np);
  map.space_seconds = space_seconds;
  internal::put_positions(source, map.positions, positions);
  return static_cast<const Sphere_map_report&>(map);
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SPHERICAL_PARAMETERIZATION_H
