// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_ESTIMATE_CURVATURE_H
#define CGAL_RESTRICTED_LAPLACIAN_3_ESTIMATE_CURVATURE_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Progress.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parameters.h>
#include <CGAL/Restricted_laplacian_3/problems/Curvature_field.h>
#include <CGAL/Restricted_laplacian_3/problems/shared/space_of.h>
#include <CGAL/Restricted_laplacian_3/surface/shared/coordinates.h>
#include <CGAL/Restricted_laplacian_3/surface/vertex_normals.h>

#include <CGAL/Real_timer.h>

#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

namespace internal {

template <class Surface, class VertexMap, class NamedParameters>
Fit_report estimate_curvature_on_surface(const Surface& surface, VertexMap curvatures,
                                         const NamedParameters& np);

} // namespace internal

/// \ingroup PkgRestrictedLaplacian3Problems
/// Estimates the curvature of a surface at its vertices, with normals to the side to which its
/// faces are oriented: those of a soup must be oriented alike.
/// \tparam Surface a model of `RestrictedSurface_3`
/// \param surface a mesh, a `soup()`, oriented points, or a `Spline_space_3`
/// \param curvatures a model of `WritablePropertyMap` with vertices as keys and `Surface_curvature`
/// as value; NaN at vertices without a face of positive area
/// \param np optional named parameters:
/// \cgalNamedParamsBegin
///   \named_of_space
///   \named_accuracy
///   \named_of_surface
///   \named_method
///   \named_of_curvature
/// \cgalNamedParamsEnd
/// \return whether the solver converged, iterations, residuals, errors of the fit, times
/// \throws Input_error one of its derived classes names the face, vertex or parameter
/// \throws Canceled if `progress` returned `false`
template <class Surface, class VertexMap,
          class NamedParameters = parameters::Default_named_parameters,
          internal::Require_named_parameters<NamedParameters> = 0,
          internal::Require_property_map<VertexMap> = 0>
Fit_report estimate_curvature(const Surface& surface, VertexMap curvatures,
                              const NamedParameters& np = parameters::default_values()) {
  return internal::estimate_curvature_on_surface(surface, curvatures, np);
}

namespace internal {

template <class Surface, class VertexMap, class NamedParameters>
Fit_report estimate_curvature_on_surface(const Surface& surface, VertexMap curvatures,
                                         const NamedParameters& np) {
  CGAL::Real_timer timer;
  timer.start();
  progress_of(np)(0);
  const auto source = surface_source(surface);
  Spline_space_3 space = first_space_of(surface, np);
  const double space_seconds = timer.time();
  const auto estimated = [&](const Surface_function_view* normals) {
    if constexpr(is_given_v<NamedParameters, internal_np::accuracy_t>)
      return estimate_curvature_to_accuracy(space, normals, np,
                                            parameters::get_parameter(np, internal_np::accuracy));
    else
      return normals ? Restricted_laplacian_3::estimate_curvature(space, *normals, np)
                     : Restricted_laplacian_3::estimate_curvature(space, np);
  };
  const auto estimated_by_normals = [&] {
    if constexpr(is_given_v<NamedParameters, internal_np::vertex_normal_map_t>) {
      const auto map = parameters::get_parameter(np, internal_np::vertex_normal_map);
      const auto traits = geom_traits_of(np);
      std::vector<Vector_3> normals;
      source.for_each_vertex([&](std::size_t i, const auto& v) {
        const Vector_3 normal = with_coordinates_of<Vector_3>(value_at(map, v), traits);
        if(!std::isfinite(normal.squared_length()))
          throw Invalid_vertex_error(i, "has a normal that is not finite");
        normals.push_back(unit_or_zero(normal));
      });
      const Interpolated_normals interpolated(std::move(normals));
      const Surface_function_view view(interpolated);
      return estimated(&view);
    } else
      return estimated(nullptr);
  };
  const Curvature_field field = estimated_by_normals();
  const std::vector<Surface_curvature> values = field.at_vertices();
  source.for_each_vertex(
      [&](std::size_t i, const auto& v) { put_value_at(curvatures, v, values[i]); });
  Fit_report report = field.report();
  report.space_seconds += space_seconds;
  return report;
}

} // namespace internal

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_ESTIMATE_CURVATURE_H
