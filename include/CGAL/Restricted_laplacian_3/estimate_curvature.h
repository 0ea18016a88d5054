// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_ESTIMATE_CURVATURE_H
#define CGAL_RESTRICTED_LAPLACIAN_3_ESTIMATE_CURVATURE_H

#include <CGAL/Restricted_laplacian_3/assembly/Dirichlet_boundary.h>
#include <CGAL/Restricted_laplacian_3/assembly/assemble.h>
#include <CGAL/Restricted_laplacian_3/fit_function.h>
#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/parameters.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_functions_3.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>
#include <CGAL/Restricted_laplacian_3/surface/vertex_normals.h>

#include <CGAL/Real_timer.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Fits
/// How `estimate_curvature()` works.
enum class Curvature_method {
  /// The derivative of a fit of normals that are given at the vertices and interpolated: the most
  /// accurate on smooth surfaces.
  normals,
  /// The same with the normals of the faces, which are constant on each face.
  face_normals,
  /// The Laplacian of the coordinates, in the weak form: the mean curvature only. Its integral over
  /// a region is that of the triangulation, whose curvature lives on the edges.
  coordinates
};

/// \ingroup PkgRestrictedLaplacian3Fits
/// Factor of the stabilisation for `estimate_curvature()` unless told otherwise: larger than for
/// other fits, because it is the derivatives that count.
constexpr double default_curvature_stabilization = 0.01;

/// \ingroup PkgRestrictedLaplacian3Fits
/// The curvature of a surface at a point.
///
/// *Sign.* \f$\kappa\f$ is the derivative of the unit normal \f$n\f$ along a unit tangent vector
/// \f$t\f$, \f$\kappa = \langle \nabla_t n, t \rangle\f$: a sphere of radius \f$r\f$ has the
/// curvatures \f$+1 / r\f$ if its normals point outward, and \f$-1 / r\f$ if they point inward. The
/// Gaussian curvature does not depend on the orientation.
struct Surface_curvature {
  /// \f$H = (\kappa_1 + \kappa_2) / 2\f$, in units of 1 / length
  double mean = std::numeric_limits<double>::quiet_NaN();
  /// \f$K = \kappa_1 \kappa_2\f$, in units of 1 / area; NaN with `Curvature_method::coordinates`
  double gaussian = std::numeric_limits<double>::quiet_NaN();
  /// \f$\kappa_1 \ge \kappa_2\f$; NaN with `Curvature_method::coordinates`
  std::array<double, 2> principal_values = {std::numeric_limits<double>::quiet_NaN(),
                                            std::numeric_limits<double>::quiet_NaN()};
  /// unit tangent vectors, orthogonal to each other and to `normal`, each with either sign; the
  /// zero vectors with `Curvature_method::coordinates`
  std::array<Vector_3, 2> principal_directions = {Vector_3(0, 0, 0), Vector_3(0, 0, 0)};
  /// the fitted unit normal
  Vector_3 normal = Vector_3(0, 0, 0);
};

namespace internal {

/// \param n fitted normal, not of unit length
/// \param derivatives of its components (rows) along the axes (columns)
inline Surface_curvature curvature_of_normals(const Eigen::Vector3d& n,
                                              const Eigen::Matrix3d& derivatives) {
  Surface_curvature result;
  const double length = n.norm();
  if(!(length > 0) || !std::isfinite(length))
    return result;
  const Eigen::Vector3d normal = n / length;
  Eigen::Index axis;
  normal.cwiseAbs().minCoeff(&axis);
  Eigen::Matrix<double, 3, 2> tangents;
  tangents.col(0) = normal.cross(Eigen::Vector3d::Unit(axis)).normalized();
  tangents.col(1) = normal.cross(tangents.col(0));
  // the derivative of n / |n| has no other tangential part
  const Eigen::Matrix2d shape = tangents.transpose() * derivatives * tangents / length;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver((shape + shape.transpose()) / 2);
  const auto vector = [](const Eigen::Vector3d& v) { return Vector_3(v[0], v[1], v[2]); };
  result.normal = vector(normal);
  for(int i = 0; i < 2; ++i) {
    result.principal_values[i] = solver.eigenvalues()[1 - i];
    result.principal_directions[i] = vector(tangents * solver.eigenvectors().col(1 - i));
  }
  result.mean = (result.principal_values[0] + result.principal_values[1]) / 2;
  result.gaussian = result.principal_values[0] * result.principal_values[1];
  return result;
}

/// \param n fitted normal, not of unit length
/// \param vector the Laplacian of the coordinates, \f$-2 H n\f$
inline Surface_curvature curvature_of_vector(const Eigen::Vector3d& n,
                                             const Eigen::Vector3d& vector) {
  Surface_curvature result;
  const double length = n.norm();
  if(!(length > 0) || !std::isfinite(length))
    return result;
  result.normal = Vector_3(n[0], n[1], n[2]) / length;
  result.mean = -vector.dot(n) / (2 * length);
  return result;
}

} // namespace internal

/// \ingroup PkgRestrictedLaplacian3Fits
/// The curvature of a surface as a function on it, see `estimate_curvature()`.
class Curvature_field {
public:
  /// \param space has to outlive this object
  /// \param fit of normals, three components; or of normals and Laplacians of the coordinates, six
  Curvature_field(const Spline_space_3& space, const Function_fit& fit)
    : m_functions(space, fit.coefficients), m_report(fit) {}

  /// the fitted functions: three components of the normal, not of unit length; with
  /// `Curvature_method::coordinates` followed by three of the Laplacian of the coordinates,
  /// \f$-2 H n\f$
  const Spline_functions_3& functions() const { return m_functions; }
  /// of the fit
  const Fit_report& report() const { return m_report; }

  /// the curvature at a location
  /// \throws Location_error if there is no such face, or if the location is not on the surface
  Surface_curvature operator()(const Surface_location& location) const {
    return at_locations(std::array<Surface_location, 1>{location}).front();
  }

  /// the curvatures at locations
  /// \param locations a range of `Surface_location`
  /// \throws Location_error if there is no such face, or if a location is not on the surface
  template <class LocationRange>
  std::vector<Surface_curvature> at_locations(const LocationRange& locations) const {
    return curvatures(m_functions.jets_at_locations(locations));
  }

  /// The curvatures at all vertices, in the order of `vertices(tm)`; NaN at vertices that have no
  /// face of positive area.
  std::vector<Surface_curvature> at_vertices() const {
    return curvatures(m_functions.jets_at_vertices());
  }

private:
  std::vector<Surface_curvature> curvatures(const Spline_jets& jets) const {
    std::vector<Surface_curvature> result;
    for(Eigen::Index i = 0; i < jets.values.rows(); ++i) {
      const Eigen::Vector3d n = jets.values.row(i).head<3>();
      if(m_functions.number_of_functions() == 6) {
        result.push_back(internal::curvature_of_vector(n, jets.values.row(i).tail<3>()));
        continue;
      }
      Eigen::Matrix3d derivatives;
      for(int axis = 0; axis < 3; ++axis)
        derivatives.col(axis) = jets.derivatives[axis].row(i).head<3>();
      result.push_back(internal::curvature_of_normals(n, derivatives));
    }
    return result;
  }

  Spline_functions_3 m_functions;
  Fit_report m_report;
};

namespace internal {

/// The smoothing weight: waves about as long as cells are wide are smoothed away, and with them
/// most of the noise of a triangulation. It follows from the space alone: a weight that followed
/// from the faces would make the result depend on them. Nothing near boundaries, where the natural
/// condition would bend the normals, nor for points, whose normals come from no triangulation.
inline double curvature_smoothing_weight(const Spline_space_3& space) {
  if(space.surface().is_point_set() || !boundary_sides(space).empty())
    return 0;
  const double h = space.octree().cell_width(space.depth());
  return h * h;
}

template <class NamedParameters>
Function_fit_options curvature_options(const Spline_space_3& space, bool with_smoothing,
                                       const NamedParameters& np) {
  Function_fit_options options = function_fit_options(np);
  if(!options.normal_stabilization)
    options.normal_stabilization = default_curvature_stabilization;
  if(with_smoothing && !is_given_v<NamedParameters, internal_np::smoothing_weight_t>)
    options.smoothing_weight = curvature_smoothing_weight(space);
  if(!is_given_v<NamedParameters, internal_np::refinement_steps_t>)
    options.refinement_steps = options.smoothing_weight > 0 ? 1 : 0;
  return options;
}

/// Vertex normals interpolated linearly and renormalised: where they cancel, that of the face.
class Interpolated_normals {
public:
  explicit Interpolated_normals(std::vector<Vector_3> normals) : m_normals(std::move(normals)) {}

  Vector_3 operator()(const Surface_point& p) const {
    Vector_3 sum(0, 0, 0);
    for(int i = 0; i < 3; ++i)
      sum += p.barycentric[i] * m_normals[p.vertices[i]];
    const double length = std::sqrt(sum.squared_length());
    return length > smallest_length ? sum / length : p.normal;
  }

private:
  /// below, the direction is that of rounding errors
  static constexpr double smallest_length = 1e-8;
  std::vector<Vector_3> m_normals;
};

/// \f$\int \Delta x_k\, b_i\f$ in the weak form, a column for each coordinate \f$x_k\f$:
/// \f$ -\int \langle \nabla x_k, \nabla b_i \rangle + \int_{\partial \mathcal M} \nu_k\, b_i \f$
template <class SurfaceIntegration>
Eigen::MatrixXd coordinate_laplacian_loads(const Spline_space_3& space,
                                           const SurfaceIntegration& integration) {
  Eigen::MatrixXd loads(static_cast<Eigen::Index>(space.dimension()), 3);
  for(int k = 0; k < 3; ++k) {
    const Vector_3 axis(k == 0, k == 1, k == 2);
    const auto gradient = function_of_degree([axis](const Surface_point&) { return axis; }, 0);
    loads.col(k) = -assemble_gradient_load(space, gradient, space.depth(), integration);
  }
  if(!space.surface().is_point_set() && !boundary_sides(space).empty())
    loads += Dirichlet_boundary(space).conormal_loads();
  return loads;
}

template <class SurfaceIntegration, class NamedParameters>
Function_fit fit_coordinate_laplacian(const Spline_space_3& space,
                                      const SurfaceIntegration& integration,
                                      const NamedParameters& np) {
  const auto normal = function_of_degree([](const Surface_point& p) { return p.normal; }, 0);
  Eigen::MatrixXd loads(static_cast<Eigen::Index>(space.dimension()), 6);
  loads.leftCols(3) = assemble_component_loads(space, normal, space.depth(), integration);
  loads.rightCols(3) = coordinate_laplacian_loads(space, integration);
  return Function_fitter<SurfaceIntegration>(space, integration,
                                             curvature_options(space, false, np))
      .project(loads);
}

} // namespace internal

/// \ingroup PkgRestrictedLaplacian3Problems
/// Estimates the curvature of a surface from a field of normals (paper, section 5.3): the field is
/// fitted by splines, see `Function_fitter`; the derivative of the fit \f$u\f$ is projected to the
/// plane that is orthogonal to \f$u\f$, divided by \f$\lvert u \rvert\f$, and symmetrised.
/// \param space the space in which the normals are fitted
/// \param normals a function object that takes a `const Surface_point&` and returns a `Vector_3` of
/// about unit length
/// \param integration a model of `SurfaceIntegration_3`: `Cubature`, or samples
/// \param np optional named parameters: those of `fit_function()`, with other defaults:
/// - `normal_stabilization`: default 0.01
/// - `smoothing_weight`: \f$w\f$ in units of length^2; default \f$h^2\f$, or 0 on a surface with a
///   boundary and on points
/// - `refinement_steps`: default 1 if there is smoothing, else 0
/// \throws Parameter_error if a parameter is outside its domain, or if a normal is not finite
template <class SurfaceIntegration, class Normals,
          class NamedParameters = parameters::Default_named_parameters,
          internal::Require_named_parameters<NamedParameters> = 0,
          internal::Require_no_named_parameters<Normals> = 0>
Curvature_field estimate_curvature(const Spline_space_3& space,
                                   const SurfaceIntegration& integration, const Normals& normals,
                                   const NamedParameters& np = parameters::default_values()) {
  return Curvature_field(
      space, Function_fitter<SurfaceIntegration>(space, integration,
                                                 internal::curvature_options(space, true, np))
                 .fit(normals));
}

/// \ingroup PkgRestrictedLaplacian3Problems
/// Estimates the curvature of the surface of a space.
/// \param space the space in which normals or coordinates are fitted
/// \param integration a model of `SurfaceIntegration_3`: `Cubature`, or samples
/// \param np optional named parameters: those above, and
/// - `curvature_method`: a `Curvature_method`; default `Curvature_method::normals`, with
///   `vertex_normals()`. With `Curvature_method::coordinates` there is no smoothing unless
///   `smoothing_weight` is given, and no refinement. On points, whose boundary is not known, it
///   takes the surface as closed
template <class SurfaceIntegration, class NamedParameters = parameters::Default_named_parameters,
          internal::Require_named_parameters<NamedParameters> = 0,
          internal::Require_no_named_parameters<SurfaceIntegration> = 0>
Curvature_field estimate_curvature(const Spline_space_3& space,
                                   const SurfaceIntegration& integration,
                                   const NamedParameters& np = parameters::default_values()) {
  const Curvature_method method = parameters::choose_parameter(
      parameters::get_parameter(np, internal_np::curvature_method), Curvature_method::normals);
  if(method == Curvature_method::coordinates)
    return Curvature_field(space, internal::fit_coordinate_laplacian(space, integration, np));
  if(method == Curvature_method::face_normals)
    return estimate_curvature(
        space, integration, function_of_degree([](const Surface_point& p) { return p.normal; }, 0),
        np);
  return estimate_curvature(space, integration,
                            internal::Interpolated_normals(vertex_normals(space.surface())), np);
}

/// \ingroup PkgRestrictedLaplacian3Problems
/// The same by cubature.
template <class NamedParameters = parameters::Default_named_parameters,
          internal::Require_named_parameters<NamedParameters> = 0>
Curvature_field estimate_curvature(const Spline_space_3& space,
                                   const NamedParameters& np = parameters::default_values()) {
  return estimate_curvature(space, Cubature(space), np);
}

namespace internal {

template <class Source, class PropertyMap, class NamedParameters>
Fit_report estimate_curvature(const Source& source, PropertyMap curvatures,
                              const NamedParameters& np) {
  CGAL::Real_timer timer;
  timer.start();
  const Spline_space_3 space = source.space(np);
  const double space_seconds = timer.time();
  const auto estimated = [&] {
    if constexpr(is_given_v<NamedParameters, internal_np::vertex_normal_map_t>) {
      const auto map = parameters::get_parameter(np, internal_np::vertex_normal_map);
      std::vector<Vector_3> normals;
      source.for_each_vertex([&](std::size_t i, const auto& v) {
        const auto n = value_at(map, v);
        const Vector_3 normal(CGAL::to_double(n.x()), CGAL::to_double(n.y()),
                              CGAL::to_double(n.z()));
        if(!std::isfinite(normal.squared_length()))
          throw Invalid_vertex_error(i, "has a normal that is not finite");
        normals.push_back(unit_or_zero(normal));
      });
      return Restricted_laplacian_3::estimate_curvature(
          space, Cubature(space), Interpolated_normals(std::move(normals)), np);
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
