// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_ESTIMATE_CURVATURE_H
#define CGAL_RESTRICTED_LAPLACIAN_3_ESTIMATE_CURVATURE_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Progress.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parameters.h>
#include <CGAL/Restricted_laplacian_3/problems/Curvature_field.h>
#include <CGAL/Restricted_laplacian_3/problems/shared/Surface_source.h>
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

template <class Source, class PropertyMap, class NamedParameters>
Fit_report estimate_curvature(const Source& source, PropertyMap curvatures,
                              const NamedParameters& np);

} // namespace internal

/// \ingroup PkgRestrictedLaplacian3Problems
/// Estimates the curvature of a mesh at its vertices.
/// \tparam FaceGraph a model of `FaceListGraph` and `VertexListGraph`, all of whose faces are
/// triangles. The normals are to the side to which the faces are oriented. Or a range of oriented
/// points, which take the place of vertices, see `read_point_set()`
/// \param tm the surface, a mesh or a range of oriented points
/// \param curvatures a model of `WritablePropertyMap` with the vertex descriptor as key and
/// `Surface_curvature` as value; NaN at vertices without a face of positive area
/// \param np optional named parameters:
/// \cgalNamedParamsBegin
///   \named_of_space
///   \named_of_mesh
///   \named_geometry
///   \named_crease_angle
///   \named_edge_is_feature_map
///   \named_of_points
///   \named_method
///   \named_vertex_normal_map
///   \named_of_curvature
/// \cgalNamedParamsEnd
/// \return whether the solver converged, iterations, residuals, errors of the fit, times
/// \throws Input_error one of its derived classes names the face, vertex or parameter
/// \throws Canceled if `progress` returned `false`
template <class FaceGraph, class VertexMap,
          class NamedParameters = parameters::Default_named_parameters,
          internal::Require_named_parameters<NamedParameters> = 0,
          internal::Require_no_named_parameters<VertexMap> = 0,
          std::enable_if_t<!std::is_same_v<FaceGraph, Spline_space_3>, int> = 0>
Fit_report estimate_curvature(const FaceGraph& tm, VertexMap curvatures,
                              const NamedParameters& np = parameters::default_values()) {
  return internal::estimate_curvature(internal::mesh_or_point_source(tm), curvatures, np);
}

/// \ingroup PkgRestrictedLaplacian3Problems
/// Estimates the curvature of a triangle soup, which need not be a manifold, at its points. Its
/// faces must be oriented alike.
/// \param points a range of 3D points
/// \param triangles a range of ranges of three indices into `points`
/// \param curvatures a model of `WritablePropertyMap` with the index of a point as key, a
/// `std::size_t`, and `Surface_curvature` as value; NaN at points without a face of positive area
/// \param np optional named parameters, where property maps have such keys, too:
/// \cgalNamedParamsBegin
///   \named_of_space
///   \named_method
///   \named_vertex_normal_map
///   \named_of_curvature
///   \named_geom_traits
///   \named_geometry
///   \named_crease_angle
/// \cgalNamedParamsEnd
/// \return whether the solver converged, iterations, residuals, errors of the fit, times
/// \throws Input_error one of its derived classes names the face, vertex or parameter
/// \throws Canceled if `progress` returned `false`
template <class PointRange, class TriangleRange, class IndexMap,
          class NamedParameters = parameters::Default_named_parameters,
          internal::Require_named_parameters<NamedParameters> = 0,
          internal::Require_no_named_parameters<IndexMap> = 0,
          std::enable_if_t<!std::is_same_v<PointRange, Spline_space_3>, int> = 0>
Fit_report estimate_curvature(const PointRange& points, const TriangleRange& triangles,
                              IndexMap curvatures,
                              const NamedParameters& np = parameters::default_values()) {
  return internal::estimate_curvature(
      internal::Soup_source<PointRange, TriangleRange>(points, triangles), curvatures, np);
}

namespace internal {

template <class Source, class PropertyMap, class NamedParameters>
Fit_report estimate_curvature(const Source& source, PropertyMap curvatures,
                              const NamedParameters& np) {
  CGAL::Real_timer timer;
  timer.start();
  progress_of(np)(0);
  const Spline_space_3 space = source.space(np);
  const double space_seconds = timer.time();
  const auto estimated = [&] {
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
      return Restricted_laplacian_3::estimate_curvature(
          space, Interpolated_normals(std::move(normals)), np);
    } else
      return Restricted_laplacian_3::estimate_curvature(space, np);
  };
  const Curvature_field field = estimated();
  const std::vector<Surface_curvature> values = field.at_vertices();
  source.for_each_vertex(
      [&](std::size_t i, const auto& v) { put_value_at(curvatures, v, values[i]); });
  Fit_report report = field.report();
  report.space_seconds = space_seconds;
  return report;
}

} // namespace internal

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_ESTIMATE_CURVATURE_H
