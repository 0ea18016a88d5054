// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_INTEGRATE_GRADIENTS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_INTEGRATE_GRADIENTS_H

#include <CGAL/Restricted_laplacian_3/assembly/assemble.h>
#include <CGAL/Restricted_laplacian_3/assembly/internal/fit_residual.h>
#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parallel_for.h>
#include <CGAL/Restricted_laplacian_3/foundation/parameters.h>
#include <CGAL/Restricted_laplacian_3/integration/internal/Mass_weighted_integration.h>
#include <CGAL/Restricted_laplacian_3/problems/internal/Screening.h>
#include <CGAL/Restricted_laplacian_3/problems/internal/vertex_details.h>
#include <CGAL/Restricted_laplacian_3/problems/make_poisson_solver.h>
#include <CGAL/Restricted_laplacian_3/solvers/Poisson_solver.h>
#include <CGAL/Restricted_laplacian_3/solvers/Solve_report.h>
#include <CGAL/Restricted_laplacian_3/solvers/internal/Mean_projection.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_functions_3.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>
#include <CGAL/Restricted_laplacian_3/splines/internal/spline_evaluation.h>
#include <CGAL/Restricted_laplacian_3/surface/internal/function_components.h>
#include <CGAL/Restricted_laplacian_3/surface/vector_fields.h>

#include <CGAL/Real_timer.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
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
Component_means<K> component_means(const Mean_projection& constants, const ScreeningType& screening,
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
  const Mean_projection& constants = solver.mean_projection();

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

} // namespace internal

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_INTEGRATE_GRADIENTS_H
