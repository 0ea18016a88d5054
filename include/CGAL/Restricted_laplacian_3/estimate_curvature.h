// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_ESTIMATE_CURVATURE_H
#define CGAL_RESTRICTED_LAPLACIAN_3_ESTIMATE_CURVATURE_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/parameters.h>
#include <CGAL/Restricted_laplacian_3/problems/Curvature_field.h>
#include <CGAL/Restricted_laplacian_3/problems/Surface_source.h>
#include <CGAL/Restricted_laplacian_3/surface/internal/coordinates.h>
#include <CGAL/Restricted_laplacian_3/surface/vertex_normals.h>

#include <CGAL/Real_timer.h>

#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Problems
/// Estimates the curvature of a surface from a field of normals (paper, section 5.3): the field is
/// fitted by splines, see `Function_fitter`; the derivative of the fit \f$u\f$ is projected to the
/// plane that is orthogonal to \f$u\f$, divided by \f$\lvert u \rvert\f$, and symmetrised.
/// \param space the space in which the normals are fitted
/// \param normals a function object that takes a `const Surface_point&` and returns a `Vector_3` of
/// about unit length
/// \param integration any model of `SurfaceIntegration_3`
/// \param np optional named parameters: those of `fit_function()`, with other defaults:
/// - `normal_stabilization`: default 0.01
/// - `smoothing_weight`: \f$w\f$ in units of length^2; default \f$h^2\f$, or 0 on a surface with a
///   boundary and on points
/// - `refinement_steps`: default 1 if there is smoothing, else 0
/// \throws Parameter_error if a parameter is outside its domain, or if a normal is not finite
template <class NamedParameters = parameters::Default_named_parameters,
          internal::Require_named_parameters<NamedParameters> = 0>
Curvature_field estimate_curvature(const Spline_space_3& space,
                                   const Surface_integration_view& integration,
                                   const Surface_function_view& normals,
                                   const NamedParameters& np = parameters::default_values()) {
  return internal::curvature_of_field(space, integration, normals,
                                      internal::curvature_options(space, true, np),
                                      internal::progress_of(np));
}

/// \ingroup PkgRestrictedLaplacian3Problems
/// Estimates the curvature of the surface of a space.
/// \param space the space in which normals or coordinates are fitted
/// \param integration any model of `SurfaceIntegration_3`
/// \param np optional named parameters: those above, and
/// - `curvature_method`: a `Curvature_method`; default `Curvature_method::normals`, with
///   `vertex_normals()`. With `Curvature_method::coordinates` there is no smoothing unless
///   `smoothing_weight` is given, and no refinement. On points, whose boundary is not known, it
///   takes the surface as closed
template <class NamedParameters = parameters::Default_named_parameters,
          internal::Require_named_parameters<NamedParameters> = 0>
Curvature_field estimate_curvature(const Spline_space_3& space,
                                   const Surface_integration_view& integration,
                                   const NamedParameters& np = parameters::default_values()) {
  const Curvature_method method = parameters::choose_parameter(
      parameters::get_parameter(np, internal_np::curvature_method), Curvature_method::normals);
  if(method == Curvature_method::coordinates)
    return Curvature_field(
        space, internal::fit_coordinate_laplacian(space, integration,
                                                  internal::curvature_options(space, false, np),
                                                  internal::progress_of(np)));
  return internal::curvature_of_surface(
      space, integration, method == Curvature_method::face_normals,
      internal::curvature_options(space, true, np), internal::progress_of(np));
}

/// \ingroup PkgRestrictedLaplacian3Problems
/// The same by `Default_integration`.
template <class NamedParameters = parameters::Default_named_parameters,
          internal::Require_named_parameters<NamedParameters> = 0>
Curvature_field estimate_curvature(const Spline_space_3& space,
                                   const NamedParameters& np = parameters::default_values()) {
  return estimate_curvature(space, Default_integration(space), np);
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
          space, Default_integration(space), Interpolated_normals(std::move(normals)), np);
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

/// \ingroup PkgRestrictedLaplacian3Problems
/// Estimates the curvature of a mesh at its vertices.
/// \tparam FaceGraph a model of `FaceListGraph` and `VertexListGraph`, all of whose faces are
/// triangles. The normals are to the side to which the faces are oriented. Or a range of oriented
/// points, which take the place of vertices, see `read_point_set()`
/// \param tm the surface, a mesh or a range of oriented points
/// \param curvatures a model of `WritablePropertyMap` with the vertex descriptor as key and
/// `Surface_curvature` as value; NaN at vertices without a face of positive area
/// \param np optional named parameters: those of `Spline_space_3` and of the overloads above, and
/// - `vertex_normal_map`: a model of `ReadablePropertyMap` that maps a vertex descriptor to a
///   normal, of any length, to be used by `Curvature_method::normals`; by default those of
///   `vertex_normals()`. Where they cancel or are 0, that of the face is taken
/// \return whether the solver converged, iterations, residuals, errors of the fit, times
/// \throws Input_error one of its derived classes names the face, vertex or parameter
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
/// The same on a triangle soup, which need not be a manifold. Its faces must be oriented alike.
/// \param points a range of 3D points
/// \param triangles a range of ranges of three indices into `points`
/// \param curvatures,np as above, where property maps have the index of a point as key, a
/// `std::size_t`
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

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_ESTIMATE_CURVATURE_H
