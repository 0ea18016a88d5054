// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_MEAN_CURVATURE_FLOW_H
#define CGAL_RESTRICTED_LAPLACIAN_3_MEAN_CURVATURE_FLOW_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Progress.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parameters.h>
#include <CGAL/Restricted_laplacian_3/input/shared/Surface_source.h>
#include <CGAL/Restricted_laplacian_3/problems/Mean_curvature_flow.h>
#include <CGAL/Restricted_laplacian_3/problems/shared/put_positions.h>
#include <CGAL/Restricted_laplacian_3/problems/shared/space_of.h>

#include <CGAL/Real_timer.h>

#include <string>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Problems
/// Moves a surface by mean-curvature flow, see `Mean_curvature_flow`.
/// \tparam Surface a model of `RestrictedSurface_3`, but of triangles or polygons
/// \param surface a mesh, a `soup()`, or a `Spline_space_3`
/// \param time_step \f$\tau\f$, positive, in units of squared length
/// \param number_of_steps at least 1; fewer are made if the surface collapses
/// \param positions a model of `WritablePropertyMap` with vertices as keys and 3D points of \cgal
/// as values receives the moved vertices; it may be the vertex-point map of a mesh
/// \param np optional named parameters:
/// \cgalNamedParamsBegin
///   \named_of_space
///   \named_of_surface
///   \named_of_flow
///   \named_usual_stabilization
///   \named_progress
/// \cgalNamedParamsEnd
/// \return the report of the last step
/// \throws Input_error one of its derived classes names the face, vertex or parameter
/// \throws Canceled if `progress` returned `false`
template <class Surface, class VertexPointMap,
          class NamedParameters = parameters::Default_named_parameters,
          internal::Require_named_parameters<NamedParameters> = 0,
          internal::Require_property_map<VertexPointMap> = 0>
Flow_report mean_curvature_flow(const Surface& surface, double time_step, int number_of_steps,
                                VertexPointMap positions,
                                const NamedParameters& np = parameters::default_values()) {
  CGAL::Real_timer timer;
  timer.start();
  if(number_of_steps < 1)
    throw Parameter_error("number_of_steps",
                          "is " + std::to_string(number_of_steps) + ", but must be at least 1");
  const internal::Progress progress = internal::progress_of(np);
  progress(0);
  const auto source = internal::surface_source(surface);
  Mean_curvature_flow flow(internal::space_of(surface, np), np);
  const double space_seconds = timer.time();
  Flow_report report;
  for(int i = 0; i < number_of_steps && report.collapse.empty(); ++i) {
    report = flow.step(time_step);
    progress(static_cast<double>(i + 1) / number_of_steps);
  }
  report.space_seconds = space_seconds;
  internal::put_positions(source, flow.vertex_positions(), positions);
  return report;
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_MEAN_CURVATURE_FLOW_H
