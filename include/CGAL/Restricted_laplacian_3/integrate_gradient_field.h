// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATE_GRADIENT_FIELD_H
#define CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATE_GRADIENT_FIELD_H

#include <CGAL/Restricted_laplacian_3/Poisson_solver.h>
#include <CGAL/Restricted_laplacian_3/Solve_report.h>
#include <CGAL/Restricted_laplacian_3/Spline_functions_3.h>
#include <CGAL/Restricted_laplacian_3/Spline_space_3.h>
#include <CGAL/Restricted_laplacian_3/assemble.h>
#include <CGAL/Restricted_laplacian_3/exceptions.h>
#include <CGAL/Restricted_laplacian_3/internal/Mass_weighted_integration.h>
#include <CGAL/Restricted_laplacian_3/internal/Screening.h>
#include <CGAL/Restricted_laplacian_3/internal/fit_residual.h>
#include <CGAL/Restricted_laplacian_3/internal/function_components.h>
#include <CGAL/Restricted_laplacian_3/internal/parallel_for.h>
#include <CGAL/Restricted_laplacian_3/internal/spline_evaluation.h>
#include <CGAL/Restricted_laplacian_3/internal/vertex_details.h>
#include <CGAL/Restricted_laplacian_3/parameters.h>
#include <CGAL/Restricted_laplacian_3/solve_poisson.h>
#include <CGAL/Restricted_laplacian_3/vector_fields.h>

#include <CGAL/Real_timer.h>

#include <Eigen/Core>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Gradients
/// What `integrate_gradient_field()` did.
struct Gradient_report : Solve_report {
  /// \f$(\int \lvert \nabla u_k - v_k \rvert^2 / \mathrm{area})^{1/2}\f$ for each channel, in units
  /// of \f$v\f$: the part of the field that is not a gradient, or that the space does not resolve.
  /// Of the spline, without `vertex_details`; measured by a rule of three nodes.
  std::vector<double> root_mean_square_residuals;
  /// number of connected components on which the weight vanishes everywhere, if one is given
  int components_without_weight = 0;
  /// number of iterations for `vertex_details`
  int details_iterations = 0;
  /// wall-clock seconds: `vertex_details`
  double details_seconds = 0;
};

/// \ingroup PkgRestrictedLaplacian3Gradients
/// The functions whose gradients fit a vector field: their coefficients, to be evaluated by
/// `Spline_function_3` or `Spline_functions_3`.
struct Gradient_fit : Gradient_report {
  /// a row for each element of the finest level, a column for each channel
  Eigen::MatrixXd coefficients;
};

namespace internal {

/// the tolerance of `integrate_gradient_field()`
constexpr double default_gradient_tolerance = 1e-5;

/// A system with the integrals that tell its constants: of the elements, and with the weight.
struct Screened_system {
  System_matrices system;
  Eigen::VectorXd constant_loads;
};

template <class SurfaceIntegration>
Screened_system
assemble_screened_system(const Spline_space_3& space, const SurfaceIntegration& integration,
                         const Screening_weight& weight, double normal_stabilization) {
  const int coarsest = coarsest_assembled_level(space);
  const auto plain_integrals = [&]() -> Eigen::VectorXd {
    return assemble_load(space, function_of_degree([](const Surface_point&) { return 1.; }, 0),
                         space.depth(), integration);
  };
  Screened_system result;
  if(weight.function) {
    const auto w = function_of_degree(weight.function, weight.degree);
    const Mass_weighted_integration<SurfaceIntegration, decltype(w)> weighted(space, integration,
                                                                              w);
    result.system = assemble_system(space, coarsest, weighted, 1, normal_stabilization);
    result.constant_loads.swap(result.system.integrals);
    result.system.integrals = plain_integrals();
  } else {
    result.system =
        assemble_system(space, coarsest, integration, weight.constant, normal_stabilization);
    if(space.is_paper_space())
      result.system.integrals = plain_integrals();
    result.constant_loads = weight.constant * result.system.integrals;
  }
  return result;
}

/// the means of the solution on the components of the matrix, a row for each
template <int K> using Component_means = Eigen::Matrix<double, Eigen::Dynamic, K>;

/// \param target_loads those of the weighted target, or of the target if there is no weight; not
/// used if there is no target
template <int K, class ScreeningType>
Component_means<K> component_means(const Constants& constants, const ScreeningType& screening,
                                   const Eigen::MatrixXd& target_loads) {
  const int number = constants.number_of_components();
  Component_means<K> means(number, K);
  means.rowwise() = screening.mean().transpose();
  if constexpr(!ScreeningType::has_target)
    return means;
  Component_means<K> sums = Component_means<K>::Zero(number, K);
  for(std::size_t i = 0; i < constants.components().size(); ++i)
    sums.row(constants.components()[i]) += target_loads.row(static_cast<Eigen::Index>(i));
  Eigen::Matrix<double, 1, K> total = Eigen::Matrix<double, 1, K>::Zero();
  double total_weight = 0;
  const auto is_known = [&](int c) {
    return constants.sum_of_measures(c) > 0 &&
           (!ScreeningType::has_weight || constants.is_screened(c));
  };
  for(int c = 0; c < number; ++c)
    if(is_known(c)) {
      means.row(c) = sums.row(c) / constants.sum_of_measures(c);
      total += sums.row(c);
      total_weight += constants.sum_of_measures(c);
    }
  for(int c = 0; c < number; ++c)
    if(!is_known(c) && !screening.has_mean() && total_weight > 0)
      means.row(c) = total / total_weight;
  return means;
}

/// shifts the rows of `x` that belong to a component so that their mean by `measures` is given
template <int K, class Matrix>
void shift_to_means(const std::vector<int>& components, const Eigen::VectorXd& measures,
                    const Component_means<K>& means, Matrix& x) {
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(means.rows());
  Component_means<K> sums = Component_means<K>::Zero(means.rows(), K);
  for(std::size_t i = 0; i < components.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    if(components[i] < 0 || measures[row] == 0)
      continue;
    weights[components[i]] += measures[row];
    sums.row(components[i]) += measures[row] * x.row(row);
  }
  for(std::size_t i = 0; i < components.size(); ++i) {
    const int c = components[i];
    if(c >= 0 && weights[c] > 0)
      x.row(static_cast<Eigen::Index>(i)) += means.row(c) - sums.row(c) / weights[c];
  }
}

/// \f$(\int \lvert \nabla u_k - v_k \rvert^2 / \mathrm{area})^{1/2}\f$
template <class Field, class SurfaceIntegration>
std::vector<double>
root_mean_square_residuals(const Spline_space_3& space, const SurfaceIntegration& integration,
                           const Field& v, const Eigen::MatrixXd& coefficients) {
  constexpr int number = Channels_of<Field>::number, degree_of_rule = 2;
  const int depth = space.depth();
  const double h = space.octree().cell_width(depth);
  const std::size_t number_of_sheets = space.number_of_sheets(depth);
  std::vector<std::array<double, number>> squares(number_of_sheets);
  constexpr std::size_t grain = 256;
  parallel_for(space.options().is_parallel, 0, number_of_sheets, grain,
               [&](std::size_t begin, std::size_t end) {
                 for(std::size_t sheet = begin; sheet < end; ++sheet) {
                   squares[sheet].fill(0);
                   const Sheet_functions<number> u(space, sheet, coefficients);
                   for_each_node_of_level(
                       space, depth, sheet, integration, degree_of_rule,
                       [&](const std::array<double, 3>& t, const Surface_point& p, double weight) {
                         const Eigen::Vector3d normal(p.normal.x(), p.normal.y(), p.normal.z());
                         const Eigen::Matrix<double, 3, number> difference =
                             u.gradients(t).transpose() / h - Channels_of<Field>::read(v(p));
                         for(int k = 0; k < number; ++k) {
                           const double along_normal = normal.dot(difference.col(k));
                           squares[sheet][k] +=
                               weight * (difference.col(k) - along_normal * normal).squaredNorm();
                         }
                       });
                 }
               });
  std::vector<double> result(number, 0.);
  for(const auto& of_sheet : squares)
    for(int k = 0; k < number; ++k)
      result[k] += of_sheet[k];
  for(double& x : result)
    x = h * std::sqrt(x / space.surface().area());
  return result;
}

/// a fit, with what is needed to keep its means when details are added
template <int K> struct Gradient_solution {
  Gradient_fit fit;
  Component_means<K> means;
  std::vector<int> components; // of the elements
  std::vector<char> is_screened;
};

struct Gradient_options {
  Poisson_solver_options solver;
  double normal_stabilization;
};

template <class NamedParameters>
Gradient_options gradient_options(const Spline_space_3& space, const NamedParameters& np) {
  Gradient_options options = {poisson_solver_options(np), normal_stabilization(space, np)};
  options.solver.relative_tolerance = parameters::choose_parameter(
      parameters::get_parameter(np, internal_np::relative_tolerance), default_gradient_tolerance);
  return options;
}

template <int K, class SurfaceIntegration, class Field, class ScreeningType>
Gradient_solution<K> integrate_gradients(const Spline_space_3& space,
                                         const SurfaceIntegration& integration, const Field& v,
                                         const ScreeningType& screening,
                                         const Gradient_options& options) {
  CGAL::Real_timer timer;
  timer.start();
  Eigen::MatrixXd loads = assemble_gradient_loads(space, v, space.depth(), integration);
  Eigen::MatrixXd target_loads;
  if constexpr(ScreeningType::has_target)
    target_loads =
        assemble_component_loads(space, screening.weighted_target(), space.depth(), integration);
  Screened_system a = assemble_screened_system(space, integration, screening.assembled_weight(),
                                               options.normal_stabilization);
  Sparse_matrix finest;
  finest.swap(a.system.matrices.back());
  a.system.matrices.pop_back();
  const Poisson_solver solver =
      poisson_solver(space, std::move(finest), std::move(a.system.matrices), a.system.integrals,
                     a.constant_loads, options.solver);
  const Constants& constants = solver.constants();

  Gradient_solution<K> result;
  result.means = component_means<K>(constants, screening, target_loads);
  result.components = constants.components();
  for(int c = 0; c < constants.number_of_components(); ++c)
    result.is_screened.push_back(constants.is_screened(c));
  if constexpr(ScreeningType::has_weight) {
    if constexpr(ScreeningType::has_target)
      loads += target_loads;
    else
      loads += a.constant_loads * screening.mean().transpose();
  }
  const double assembly_seconds = timer.time() - solver.setup_seconds();
  Eigen::MatrixXd x;
  static_cast<Solve_report&>(result.fit) = solver.solve(loads, x);
  // The solver takes means from the sum of all loads, where those of a small weight are lost to
  // rounding beside those of the gradients. They are known without it.
  std::vector<int> shifted = result.components;
  for(int& c : shifted)
    // In the space of the paper, constants may not be in the space: then the system has the mean.
    if(!constants.is_split_off(c) && constants.is_screened(c))
      c = -1;
  shift_to_means<K>(shifted, constants.measures(), result.means, x);
  const double before_residuals = timer.time();
  result.fit.root_mean_square_residuals = root_mean_square_residuals(space, integration, v, x);
  result.fit.coefficients.swap(x);
  result.fit.assembly_seconds = assembly_seconds + timer.time() - before_residuals;
  if(ScreeningType::has_weight)
    result.fit.components_without_weight =
        static_cast<int>(std::count(result.is_screened.begin(), result.is_screened.end(), char(0)));
  return result;
}

/// number of the component of the matrix that a vertex belongs to; -1 if it is not on the surface
inline std::vector<int> components_of_vertices(const Spline_space_3& space,
                                               const std::vector<int>& components_of_elements) {
  std::vector<int> result;
  for(const Sheet_point& p : locate_vertices(space, space.depth())) {
    result.push_back(-1);
    if(p.sheet == Sheet_point::not_on_surface)
      continue;
    for(const auto element : space.elements(space.depth(), p.sheet))
      if(element != Spline_space_3::no_element) {
        result.back() = components_of_elements[element];
        break;
      }
  }
  return result;
}

/// corrects the values of a solution at the vertices
template <int K, class Field, class ScreeningType>
void add_details(const Spline_space_3& space, const Field& v, const ScreeningType& screening,
                 const Poisson_solver_options& options, Gradient_solution<K>& solution,
                 Eigen::MatrixXd& values) {
  CGAL::Real_timer timer;
  timer.start();
  space.surface().require_triangles("vertex_details");
  const int degree =
      (std::max)(degree_on_triangles(v),
                 ScreeningType::has_weight
                     ? screening.weight_degree() + (std::max)(2, screening.target_degree() + 1)
                     : 0);
  Vertex_system<K> system = vertex_system<K>(
      space.surface(), v, [&](const Surface_point& p) { return screening.weight(p); },
      [&](const Surface_point& p) { return screening.target(p); }, (std::min)(degree, 12));
  // As for the splines, the means are subtracted and added again.
  const std::vector<int> components = components_of_vertices(space, solution.components);
  Eigen::VectorXd measures = system.integrals;
  for(std::size_t i = 0; i < components.size(); ++i)
    if(components[i] >= 0) {
      const auto row = static_cast<Eigen::Index>(i);
      const auto mean = solution.means.row(components[i]);
      if(solution.is_screened[components[i]])
        measures[row] = system.weighted_integrals[row];
      system.loads.row(row) -= system.weighted_integrals[row] * mean;
      values.row(row) -= mean;
    }
  const Vertex_details_report report =
      add_vertex_details(system, options.relative_tolerance, options.maximum_iterations, values);
  shift_to_means<K>(components, measures, solution.means, values);
  solution.fit.converged = solution.fit.converged && report.converged;
  solution.fit.details_iterations = report.iterations;
  solution.fit.details_seconds = timer.time();
}

/// what is not given, and numbers, remain as they are
template <class Function, class OnSurface>
auto optional_function(const Function& f, OnSurface&& on_surface) {
  if constexpr(std::is_same_v<Function, internal_np::Param_not_found> ||
               std::is_arithmetic_v<Function>)
    return f;
  else
    return on_surface(f);
}

template <class Source, class Field, class PropertyMap, class NamedParameters>
Gradient_report integrate_gradient_field(const Source& source, const Field& v, PropertyMap u,
                                         const NamedParameters& np) {
  using Components = Function_components<typename boost::property_traits<PropertyMap>::value_type>;
  CGAL::Real_timer timer;
  timer.start();
  const auto field = vector_field_on_surface(source, v);
  constexpr int K = Channels_of<std::decay_t<decltype(field)>>::number;
  static_assert(Components::number == K, "u needs as many components as v has channels");
  const auto target =
      optional_function(parameters::get_parameter(np, internal_np::target_values),
                        [&](const auto& f) { return components_on_surface(source, f); });
  const auto weight =
      optional_function(parameters::get_parameter(np, internal_np::screening_weight),
                        [&](const auto& f) { return numbers_on_surface(source, f); });
  const Screening<K, std::decay_t<decltype(target)>, std::decay_t<decltype(weight)>> screening(
      target, weight, np);
  const Spline_space_3 space = source.space(np);
  const double space_seconds = timer.time();
  const Gradient_options options = gradient_options(space, np);
  Gradient_solution<K> solution =
      integrate_gradients<K>(space, Cubature(space), field, screening, options);
  Eigen::MatrixXd values =
      Spline_functions_3(space, solution.fit.coefficients).values_at_vertices();
  if(parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_details),
                                  false))
    add_details(space, field, screening, options.solver, solution, values);
  put_rows(source, values, u);
  solution.fit.space_seconds = space_seconds;
  return static_cast<const Gradient_report&>(solution.fit);
}

} // namespace internal

/// \ingroup PkgRestrictedLaplacian3Problems
/// Integrates a vector field: finds the functions \f$u_k\f$ of a spline space whose gradients are
/// closest to the channels \f$v_k\f$ of a tangent vector field (paper, section 5.2, equation 6).
/// \f[ \int_{\mathcal M} \lvert \nabla u_k - v_k \rvert^2
///     + \int_{\mathcal M} \alpha\, (u_k - g_k)^2 \to \min, \qquad
///     (S + M_\alpha)\, \eta_{\cdot k} = \gamma, \quad
///     \gamma_i = \int_{\mathcal M} \langle v_k, \nabla b_i \rangle
///              + \int_{\mathcal M} \alpha\, g_k\, b_i, \f]
/// where \f$(M_\alpha)_{ij} = \int \alpha\, b_i b_j\f$. All channels share the matrix, one pass
/// over the surface and each pass of the solver. On boundaries the natural condition holds: the
/// part of
/// \f$\nabla u - v\f$ along the conormal is 0.
///
/// *Means.* Gradients do not tell constants. Without a weight \f$\alpha\f$, the mean of \f$u\f$ on
/// each connected component of the surface is that of the target \f$g\f$, if there is one, and
/// `mean_value` else. With a weight, the weighted mean of \f$u\f$ on a component is that of
/// \f$g\f$, which is ensured separately from the solution of the system, however small the weight
/// is. On components where the weight vanishes everywhere, the mean is `mean_value`, if it is
/// given, and else the weighted mean of the targets of all other components. (Components are those
/// of the splines: not split, if `split_elements` is `false`, where two come within three cells of
/// each other.)
///
/// \param space the space that the solution is in
/// \param integration a model of `SurfaceIntegration_3`: `Cubature`, or samples
/// \param v a function object that takes a `const Surface_point&` and returns a 3D vector of \cgal
/// (one channel), a `std::array` of such vectors, or an `Eigen::Matrix<double, 3, K>`, whose
/// columns are the channels; for example a `Face_function`, a `Corner_vector_field`, or the result
/// of `vertex_gradients()`. Only the part tangential to the face counts. Integrated as in
/// `assemble_gradient_loads()`.
/// \param np optional named parameters:
/// - `target_values`: \f$g\f$, a function object that takes a `const Surface_point&` and returns a
///   value with as many components as \f$v\f$ has channels: a number, a `std::array` of numbers, a
///   vector of Eigen of a fixed size, or a 3D vector or point of \cgal. Not read where the weight
///   is 0. Default: the constant `mean_value`
/// - `screening_weight`: \f$\alpha\f$, in units of 1 / area: a positive number, or a function
///   object that takes a `const Surface_point&` and returns a number that is not negative; default:
///   none. A weight that is constant on each face (a `Face_function`, or with
///   `function_of_degree()`) costs no more than a number.
/// - `mean_value`: as many numbers as \f$v\f$ has channels; default 0
/// - `normal_stabilization`: factor \f$c\f$ of `assemble_operators()`; default
///   `default_normal_stabilization()`
/// - `relative_tolerance`: of the residual; default 1e-5
/// - `number_of_iterations`, `cycle`, `smoothing_steps`, `smoother`, `stand_alone_multigrid`,
///   `concurrency_tag`: as in `make_poisson_solver()`
/// \return the coefficients, whether the solver converged, iterations, residuals, times
/// \throws Parameter_error if a parameter is outside its domain, or if a value of `v`, of the
/// target or of the weight cannot be used; names the face
///
/// Takes time and memory proportional to the number of triangles (or samples) plus the number of
/// elements, times the number of iterations.
template <class SurfaceIntegration, class VectorField,
          class NamedParameters = parameters::Default_named_parameters,
          internal::Require_named_parameters<NamedParameters> = 0,
          internal::Require_no_named_parameters<VectorField> = 0>
Gradient_fit integrate_gradient_field(const Spline_space_3& space,
                                      const SurfaceIntegration& integration, const VectorField& v,
                                      const NamedParameters& np = parameters::default_values()) {
  constexpr int K = internal::Channels_of<VectorField>::number;
  const auto target = parameters::get_parameter(np, internal_np::target_values);
  const auto weight = parameters::get_parameter(np, internal_np::screening_weight);
  const internal::Screening<K, std::decay_t<decltype(target)>, std::decay_t<decltype(weight)>>
      screening(target, weight, np);
  return internal::integrate_gradients<K>(space, integration, v, screening,
                                          internal::gradient_options(space, np))
      .fit;
}

/// \ingroup PkgRestrictedLaplacian3Problems
/// The same by cubature.
template <class VectorField, class NamedParameters = parameters::Default_named_parameters,
          internal::Require_named_parameters<NamedParameters> = 0>
Gradient_fit integrate_gradient_field(const Spline_space_3& space, const VectorField& v,
                                      const NamedParameters& np = parameters::default_values()) {
  return integrate_gradient_field(space, Cubature(space), v, np);
}

/// \ingroup PkgRestrictedLaplacian3Problems
/// Integrates a vector field on a mesh, see above.
///
/// *Details.* Splines do not resolve what is smaller than a cell. With `vertex_details`, their
/// values at the vertices are the first guess for the same problem with the functions that are
/// linear in each triangle, whose matrix \f$S\f$ is that of cotangents. What they leave is of short
/// waves, so a few steps of conjugate gradients with an incomplete Cholesky factor suffice. The
/// splines, with their multigrid, are then the auxiliary space of a solver for the cotangent
/// system. See J. Xu, *The auxiliary space method and optimal multigrid preconditioning techniques
/// for unstructured grids*, Computing 56 (1996). The result depends on the triangulation as that of
/// cotangents does.
///
/// \tparam FaceGraph a model of `FaceListGraph` and `VertexListGraph`, all of whose faces are
/// triangles; or a range of oriented points, which take the place of vertices, see
/// `read_point_set()`
/// \param tm the surface
/// \param v a function object as above; or a model of `ReadablePropertyMap` with such values. Its
/// key is the vertex descriptor: the field is linear in each triangle, and continuous up to the
/// projection to the tangent planes; the halfedge descriptor: it is linear in each triangle, with
/// the value of a halfedge at its target, in its face; or the face descriptor: it is constant in
/// each triangle.
/// \param u a model of `WritablePropertyMap` with the vertex descriptor as key, and values as
/// `target_values` has, receives the values; NaN at vertices without a face of positive area
/// \param np optional named parameters: those of `Spline_space_3` and of the overloads above, where
/// `target_values` and `screening_weight` may be property maps too, with the vertex or face
/// descriptor as key; and
/// - `vertex_details`: whether details below the cells are added at the vertices, not available on
///   point sets; default `false`
/// \throws Input_error one of its derived classes names the face, vertex or parameter
template <class FaceGraph, class VectorField, class VertexMap,
          class NamedParameters = parameters::Default_named_parameters,
          internal::Require_named_parameters<NamedParameters> = 0,
          internal::Require_no_named_parameters<VertexMap> = 0,
          std::enable_if_t<!std::is_same_v<FaceGraph, Spline_space_3>, int> = 0>
Gradient_report integrate_gradient_field(const FaceGraph& tm, const VectorField& v, VertexMap u,
                                         const NamedParameters& np = parameters::default_values()) {
  return internal::integrate_gradient_field(internal::mesh_or_point_source(tm), v, u, np);
}

/// \ingroup PkgRestrictedLaplacian3Problems
/// The same on a triangle soup, which need not be a manifold, nor orientable.
/// \param points a range of 3D points
/// \param triangles a range of ranges of three indices into `points`
/// \param v,u,np as above, where property maps have the index of a point as key, a `std::size_t`
template <class PointRange, class TriangleRange, class VectorField, class IndexMap,
          class NamedParameters = parameters::Default_named_parameters,
          internal::Require_no_named_parameters<IndexMap> = 0,
          std::enable_if_t<!std::is_same_v<PointRange, Spline_space_3>, int> = 0>
Gradient_report integrate_gradient_field(const PointRange& points, const TriangleRange& triangles,
                                         const VectorField& v, IndexMap u,
                                         const NamedParameters& np = parameters::default_values()) {
  return internal::integrate_gradient_field(
      internal::Soup_source<PointRange, TriangleRange>(points, triangles), v, u, np);
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATE_GRADIENT_FIELD_H
