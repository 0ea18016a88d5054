// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_CURVATURE_FIELD_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_CURVATURE_FIELD_IMPL_H

#include <CGAL/Restricted_laplacian_3/assembly/Boundary_integration.h>
#include <CGAL/Restricted_laplacian_3/assembly/assemble.h>
#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Progress.h>
#include <CGAL/Restricted_laplacian_3/integration/Surface_material.h>
#include <CGAL/Restricted_laplacian_3/problems/Curvature_field.h>
#include <CGAL/Restricted_laplacian_3/problems/internal/require_enough_points.h>
#include <CGAL/Restricted_laplacian_3/problems/shared/search_depth.h>
#include <CGAL/Restricted_laplacian_3/problems/shared/values_over_surface.h>
#include <CGAL/Restricted_laplacian_3/surface/vertex_normals.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

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
  const auto vector = [](const Eigen::Vector3d& v) { return Vector_3(v[0], v[1], v[2]); };
  const auto [u, v] = tangent_axes(vector(normal));
  Eigen::Matrix<double, 3, 2> tangents;
  tangents << u.x(), v.x(), u.y(), v.y(), u.z(), v.z();
  // the derivative of n / |n| has no other tangential part
  const Eigen::Matrix2d shape = tangents.transpose() * derivatives * tangents / length;
  const Eigen::Matrix2d symmetric = (shape + shape.transpose()) / 2;
  result.normal = vector(normal);
  if(!symmetric.allFinite())
    return result; // NaN
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver;
  solver.computeDirect(symmetric);
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

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Curvature_field::Curvature_field(const Spline_space_3& space,
                                                                    const Function_fit& fit)
  : m_functions(space, fit.coefficients), m_report(fit) {}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE std::vector<Surface_curvature>
Curvature_field::at_vertices() const {
  return curvatures(m_functions.jets_at_vertices());
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE std::vector<Surface_curvature>
Curvature_field::curvatures(const Spline_jets& jets) const {
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

namespace internal {

/// what the options say, with what follows from the space where they say nothing
inline Function_fit_options curvature_fit_options(const Spline_space_3& space,
                                                  const Curvature_options& given,
                                                  bool with_smoothing) {
  Function_fit_options options;
  options.solver = given.solver;
  options.stabilization = given.stabilization.value_or(default_curvature_stabilization);
  options.energy_tolerance = given.energy_tolerance.value_or(default_curvature_tolerance);
  // A weight that followed from the faces would make the result depend on them.
  const double h = space.octree().cell_width(space.depth());
  const bool smooths =
      with_smoothing && !space.surface().is_point_set() && boundary_sides(space).empty();
  options.smoothing = given.smoothing.value_or(smooths ? h * h : 0);
  options.refinements = given.refinements.value_or(options.smoothing > 0 ? 1 : 0);
  return options;
}

/// \f$\int \Delta x_k\, b_i\f$ in the weak form, a column for each coordinate \f$x_k\f$:
/// \f$ -\int \langle \nabla x_k, \nabla b_i \rangle + \int_{\partial \mathcal M} \nu_k\, b_i \f$
inline Eigen::MatrixXd coordinate_laplacian_loads(const Spline_space_3& space) {
  Eigen::MatrixXd loads(static_cast<Eigen::Index>(space.dimension()), 3);
  for(int k = 0; k < 3; ++k) {
    const Vector_3 axis(k == 0, k == 1, k == 2);
    const auto gradient = function_of_degree([axis](const Surface_point&) { return axis; }, 0);
    loads.col(k) = -assemble_gradient_load(space, gradient, space.depth());
  }
  if(!space.surface().is_point_set() && !boundary_sides(space).empty())
    loads += Boundary_integration(space).conormal_loads();
  return loads;
}

/// the normal of the surface: constant on faces, unless they have patches
inline auto surface_normal(const Triangulated_surface_3& surface) {
  return function_of_degree([](const Surface_point& p) { return p.normal; },
                            surface.is_smooth() ? default_degree_on_triangles : 0);
}

/// the curvature by the Laplacian of the coordinates, in the weak form
inline Function_fit fit_coordinate_laplacian(const Spline_space_3& space,
                                             const Function_fit_options& options,
                                             const Progress& progress) {
  progress(0);
  const auto normal = surface_normal(space.surface());
  Eigen::MatrixXd loads(static_cast<Eigen::Index>(space.dimension()), 6);
  loads.leftCols(3) = assemble_component_loads(space, normal, space.depth());
  loads.rightCols(3) = coordinate_laplacian_loads(space);
  return Function_fitter(space, options).project(loads, progress.part(0.2, 1).callback());
}

/// fits normals
inline Function_fit fit_normals(const Spline_space_3& space, const Surface_function_view& normals,
                                const Curvature_options& options) {
  Function_fitter fitter(space, curvature_fit_options(space, options, true));
  return fitter.fit(normals, options.progress);
}

/// fits what the curvature follows from
/// \param normals in place of those of the surface; may be null
inline Function_fit fit_for_curvature(const Spline_space_3& space,
                                      const Surface_function_view* normals,
                                      const Curvature_options& options) {
  require_enough_points(space);
  if(normals)
    return fit_normals(space, *normals, options);
  if(options.method == Curvature_method::coordinates)
    // the coordinates know no material
    return fit_coordinate_laplacian(space.with_material({}),
                                    curvature_fit_options(space, options, false),
                                    Progress(options.progress));
  if(options.method == Curvature_method::face_normals || space.surface().is_smooth())
    return fit_normals(space, surface_normal(space.surface()), options);
  return fit_normals(space, Interpolated_normals(vertex_normals(space.surface())), options);
}

/// the curvature that follows from a fit, whose error is another one
inline Curvature_field curvature_of_fit(const Spline_space_3& space, Function_fit&& fit) {
  fit.estimated_error = std::numeric_limits<double>::quiet_NaN();
  fit.is_estimate_trusted = false;
  return Curvature_field(space, fit);
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Curvature_field
estimate_curvature_to_accuracy(Spline_space_3& space, const Surface_function_view* normals,
                               const Curvature_options& given, double accuracy) {
  Curvature_options options = given;
  Function_fit fit;
  const std::vector<Surface_location> places = space.surface().is_point_set()
                                                   ? std::vector<Surface_location>()
                                                   : places_over_surface(space.surface());
  search_depth(space, accuracy, Progress(given.progress), {}, [&](const Progress& progress) {
    options.progress = progress.callback();
    fit = fit_for_curvature(space, normals, options);
    const Curvature_field field(space, fit);
    const std::vector<Surface_curvature> curvatures =
        places.empty() ? field.at_vertices() : field.at_locations(places);
    Eigen::MatrixXd means(static_cast<Eigen::Index>(curvatures.size()), 1);
    for(std::size_t i = 0; i < curvatures.size(); ++i) {
      const double mean = curvatures[i].mean;
      means(static_cast<Eigen::Index>(i), 0) = std::isfinite(mean) ? mean : 0;
    }
    fit.estimated_error = std::numeric_limits<double>::quiet_NaN();
    return Found_in_space{&fit, std::move(means)};
  });
  return Curvature_field(space, fit);
}

} // namespace internal

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Curvature_field
estimate_curvature(const Spline_space_3& space, const Surface_function_view& normals,
                   const Curvature_options& options) {
  return internal::curvature_of_fit(space, internal::fit_for_curvature(space, &normals, options));
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Curvature_field
estimate_curvature(const Spline_space_3& space, const Curvature_options& options) {
  return internal::curvature_of_fit(space, internal::fit_for_curvature(space, nullptr, options));
}

namespace internal {

/// calls `visit(face, curvature)` for the faces with an area and, in their middle, a curvature
template <class Visitor>
void visit_curvatures_of_faces(const Curvature_field& curvature, const Visitor& visit) {
  if(curvature.functions().number_of_functions() != 3)
    throw Input_error("the curvature is of coordinates, which knows no principal directions");
  const Triangulated_surface_3& surface = curvature.functions().space().surface();
  std::vector<Surface_location> centers;
  for(std::size_t face = 0; face < surface.number_of_faces(); ++face)
    if(!surface.is_degenerate(face))
      centers.push_back(center_of_face(surface, face));
  const std::vector<Surface_curvature> curvatures = curvature.at_locations(centers);
  for(std::size_t i = 0; i < centers.size(); ++i)
    if(std::isfinite(curvatures[i].mean)) // else a fit of normals is 0
      visit(centers[i].face, curvatures[i]);
}

} // namespace internal

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Face_function<Symmetric_tensor_3>
curvature_diffusion(const Curvature_field& curvature, const std::array<double, 2>& anisotropy) {
  constexpr double smallest_factor = 1e-4;
  for(const double a : anisotropy)
    if(!(a >= 0 && std::isfinite(a)))
      throw Parameter_error("anisotropy", "is " + std::to_string(a) +
                                              ", but must be a finite number that is not negative");
  std::vector<Symmetric_tensor_3> tensors(curvature.functions().space().surface().number_of_faces(),
                                          Symmetric_tensor_3{1, 1, 1, 0, 0, 0});
  internal::visit_curvatures_of_faces(curvature, [&](std::size_t face, const Surface_curvature& c) {
    const bool is_first_larger = std::abs(c.principal_values[0]) >= std::abs(c.principal_values[1]);
    std::array<double, 2> factors;
    for(int k = 0; k < 2; ++k) {
      const double a = anisotropy[k == 0 ? !is_first_larger : is_first_larger];
      factors[k] = (std::max)(std::exp(-a * std::abs(c.principal_values[1 - k])), smallest_factor);
    }
    tensors[face] = directional_tensor(c.principal_directions, factors);
  });
  return Face_function<Symmetric_tensor_3>(std::move(tensors));
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Surface_material normal_metric(const Curvature_field& curvature,
                                                                  double weight) {
  if(!(weight >= 0 && std::isfinite(weight)))
    throw Parameter_error("weight", "is " + std::to_string(weight) +
                                        ", but must be a finite number that is not negative");
  constexpr double largest_stretch = 1e2;
  const std::size_t number = curvature.functions().space().surface().number_of_faces();
  std::vector<Symmetric_tensor_3> tensors(number, Symmetric_tensor_3{1, 1, 1, 0, 0, 0});
  std::vector<double> densities(number, 1);
  internal::visit_curvatures_of_faces(curvature, [&](std::size_t face, const Surface_curvature& c) {
    std::array<double, 2> stretches;
    for(int k = 0; k < 2; ++k)
      stretches[k] = (std::min)(std::hypot(1, weight * c.principal_values[k]), largest_stretch);
    tensors[face] = directional_tensor(c.principal_directions,
                                       {stretches[1] / stretches[0], stretches[0] / stretches[1]});
    densities[face] = stretches[0] * stretches[1];
  });
  Surface_material result;
  result.set_diffusion(Face_function<Symmetric_tensor_3>(std::move(tensors)));
  result.set_density(Face_function<double>(std::move(densities)));
  return result;
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_CURVATURE_FIELD_IMPL_H
