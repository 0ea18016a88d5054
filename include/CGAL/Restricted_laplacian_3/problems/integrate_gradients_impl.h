// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_INTEGRATE_GRADIENTS_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_INTEGRATE_GRADIENTS_IMPL_H

#include <CGAL/Restricted_laplacian_3/assembly/assemble.h>
#include <CGAL/Restricted_laplacian_3/assembly/shared/assemble_system.h>
#include <CGAL/Restricted_laplacian_3/assembly/shared/fit_residual.h>
#include <CGAL/Restricted_laplacian_3/assembly/shared/sheet_loads.h>
#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Progress.h>
#include <CGAL/Restricted_laplacian_3/integration/shared/sheet_integrals.h>
#include <CGAL/Restricted_laplacian_3/problems/Poisson_solver.h>
#include <CGAL/Restricted_laplacian_3/problems/integrate_gradients.h>
#include <CGAL/Restricted_laplacian_3/problems/internal/level_estimate.h>
#include <CGAL/Restricted_laplacian_3/problems/internal/require_enough_points.h>
#include <CGAL/Restricted_laplacian_3/problems/internal/vertex_details.h>
#include <CGAL/Restricted_laplacian_3/problems/shared/values_over_surface.h>
#include <CGAL/Restricted_laplacian_3/problems/stabilization.h>
#include <CGAL/Restricted_laplacian_3/solvers/shared/Mean_projection.h>
#include <CGAL/Restricted_laplacian_3/splines/shared/spline_evaluation.h>

#include <CGAL/Real_timer.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Eigen::VectorXd
Gradient_screening::mean_or_zero(int channels) const {
  return mean.size() > 0 ? mean : Eigen::VectorXd(Eigen::VectorXd::Zero(channels));
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void Gradient_screening::check(int channels) const {
  if(target && target->components() != channels)
    throw Parameter_error("target", "need as many components as the field has channels");
  if(weight && !(*weight > 0 && std::isfinite(*weight)))
    throw Parameter_error("alpha", "is " + std::to_string(*weight) +
                                       ", but must be a positive, finite number");
  if(mean.size() > 0 && mean.size() != channels)
    throw Parameter_error("mean", "needs as many components as the field has channels");
  if(!mean.allFinite())
    throw Parameter_error("mean", "is not finite");
}

namespace internal {

/// The weight and the targets at some points, for a screening that has them: the target is not read
/// where the weight is 0.
class Screening_values {
public:
  Screening_values(const Gradient_screening& screening, int channels)
    : m_screening(screening), m_channels(static_cast<std::size_t>(channels)) {}

  /// \throws Parameter_error if a weight or a target cannot be used; names the face
  void evaluate(const Surface_point* points, std::size_t number) {
    m_weights.assign(number, m_screening.weight.value_or(m_screening.weight_function ? 0 : 1));
    if(m_screening.weight_function)
      Mass_weight{*m_screening.weight_function, "alpha"}(points, number, m_weights.data());
    m_targets.assign(m_channels * number, 0.);
    if(!m_screening.target) {
      const Eigen::VectorXd mean = m_screening.mean_or_zero(static_cast<int>(m_channels));
      for(std::size_t i = 0; i < number; ++i)
        std::copy(mean.data(), mean.data() + m_channels, m_targets.data() + m_channels * i);
      return;
    }
    for(std::size_t i = 0; i < number; ++i) {
      if(!(m_weights[i] > 0))
        continue;
      double* const target = m_targets.data() + m_channels * i;
      (*m_screening.target)(points + i, 1, target);
      for(std::size_t k = 0; k < m_channels; ++k)
        if(!std::isfinite(target[k]))
          throw Parameter_error("target", "has a value that is not finite in face " +
                                              std::to_string(points[i].polygon));
    }
  }

  /// 1 if the screening has no weight
  double weight(std::size_t i) const { return m_weights[i]; }
  /// all channels; the mean if the screening has no target
  const double* target(std::size_t i) const { return m_targets.data() + m_channels * i; }

private:
  const Gradient_screening& m_screening;
  std::size_t m_channels;
  std::vector<double> m_weights, m_targets;
};

/// degrees on the triangles
inline int weight_degree(const Gradient_screening& screening) {
  return screening.weight_function ? screening.weight_function->degree() : 0;
}
inline int target_degree(const Gradient_screening& screening) {
  return screening.target ? screening.target->degree() : 0;
}

/// \f$\int \alpha\, g_k\, b_i\f$, or \f$\int g_k\, b_i\f$ if there is no weight
inline Eigen::MatrixXd weighted_target_loads(const Spline_space_3& space,
                                             const Gradient_screening& screening) {
  const int number = screening.target->components(), depth = space.depth();
  const int degree = 6 + (std::min)(weight_degree(screening) + target_degree(screening), 6);
  const double h = space.octree().cell_width(depth);
  return sum_loads(space, depth, number, h * h, [&](std::size_t sheet, Cell_load::Load* loads) {
    std::vector<Cell_load> moments(number);
    Screening_values values(screening, number);
    space.integration_with_material().visit_nodes(
        sheet, degree, [&](Integration_node_block& block) {
          values.evaluate(block.points.data(), block.size);
          for(int k = 0; k < number; ++k) {
            Node_values weighted = {};
            for(std::size_t i = 0; i < block.size; ++i)
              weighted[i] = block.weights[i] * values.weight(i) * values.target(i)[k];
            moments[k].add(block.positions, weighted);
          }
        });
    for(int k = 0; k < number; ++k)
      moments[k].add_values_to(loads[k]);
  });
}

/// The means of the solution on the components of the matrix, a row for each.
/// \param target_loads those of the weighted target, or of the target if there is no weight; not
/// used if there is no target
inline Eigen::MatrixXd component_means(const Mean_projection& constants,
                                       const Gradient_screening& screening, int channels,
                                       const Eigen::MatrixXd& target_loads) {
  const int number = constants.number_of_components();
  Eigen::MatrixXd means(number, channels);
  means.rowwise() = screening.mean_or_zero(channels).transpose();
  if(!screening.target)
    return means;
  Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(number, channels);
  for(std::size_t i = 0; i < constants.components().size(); ++i)
    sums.row(constants.components()[i]) += target_loads.row(static_cast<Eigen::Index>(i));
  Eigen::RowVectorXd total = Eigen::RowVectorXd::Zero(channels);
  double total_weight = 0;
  const auto is_known = [&](int c) {
    return constants.sum_of_measures(c) > 0 &&
           (!screening.has_weight() || constants.is_screened(c));
  };
  for(int c = 0; c < number; ++c)
    if(is_known(c)) {
      means.row(c) = sums.row(c) / constants.sum_of_measures(c);
      total += sums.row(c);
      total_weight += constants.sum_of_measures(c);
    }
  for(int c = 0; c < number; ++c)
    if(!is_known(c) && screening.mean.size() == 0 && total_weight > 0)
      means.row(c) = total / total_weight;
  return means;
}

/// shifts the rows of `x` that belong to a component so that their mean by `measures` is given
inline void shift_to_means(const std::vector<int>& components, const Eigen::VectorXd& measures,
                           const Eigen::MatrixXd& means, Eigen::MatrixXd& x) {
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(means.rows());
  for(std::size_t i = 0; i < components.size(); ++i)
    if(components[i] >= 0)
      weights[components[i]] += measures[static_cast<Eigen::Index>(i)];
  Eigen::MatrixXd changes = means;
  for(std::size_t i = 0; i < components.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    if(components[i] >= 0 && measures[row] > 0) // before the product, which may overflow
      changes.row(components[i]) -= (measures[row] / weights[components[i]]) * x.row(row);
  }
  for(std::size_t i = 0; i < components.size(); ++i)
    if(components[i] >= 0 && weights[components[i]] > 0)
      x.row(static_cast<Eigen::Index>(i)) += changes.row(components[i]);
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Gradient_solution
integrate_gradients(const Spline_space_3& space, const Vector_field_view& v,
                    const Gradient_options& options, const Progress& progress) {
  const Gradient_screening& screening = options.screening;
  screening.check(v.channels());
  require_enough_points(space);
  CGAL::Real_timer timer;
  timer.start();
  progress(0);
  Eigen::MatrixXd loads = assemble_gradient_loads(space, v, space.depth());
  Eigen::MatrixXd target_loads;
  if(screening.target)
    target_loads = weighted_target_loads(space, screening);
  Eigen::VectorXd constant_loads;
  Elliptic_system system;
  system.elliptic.reaction = screening.weight.value_or(0);
  system.elliptic.reaction_function = screening.weight_function;
  system.elliptic.stabilization = options.stabilization.value_or(default_stabilization(space));
  system.constant_loads = &constant_loads;
  const Poisson_solver solver(space, system, options.solver, progress.part(0.15, 0.65));
  const Mean_projection& constants = solver.mean_projection();

  Gradient_solution result;
  result.means = component_means(constants, screening, v.channels(), target_loads);
  result.components = constants.components();
  for(int c = 0; c < constants.number_of_components(); ++c)
    result.is_screened.push_back(constants.is_screened(c));
  if(screening.has_weight()) {
    if(screening.target)
      loads += target_loads;
    else
      loads += constant_loads * screening.mean_or_zero(v.channels()).transpose();
  }
  const double assembly_seconds = timer.time() - solver.setup_seconds();
  Eigen::MatrixXd x;
  Solve_options of_solve(tolerance_of(options.solver), progress.part(0.65, 1).callback());
  std::array<Eigen::MatrixXd, 2> coarser;
  of_solve.coarser_solutions = &coarser;
  static_cast<Solve_report&>(result.fit) = solver.solve(loads, x, of_solve);
  estimate_error(space, x, coarser, result.fit);
  // The solver takes means from the sum of all loads, where those of a small weight are lost to
  // rounding beside those of the gradients. They are known without it.
  std::vector<int> shifted = result.components;
  for(int& c : shifted)
    // In the space of the paper, constants may not be in the space: then the system has the mean.
    if(!constants.is_split_off(c) && constants.is_screened(c))
      c = -1;
  shift_to_means(shifted, constants.measures(), result.means, x);
  const double before_residuals = timer.time();
  result.fit.root_mean_square_residuals = gradient_residuals(space, v, x);
  result.fit.coefficients.swap(x);
  result.fit.assembly_seconds = assembly_seconds + timer.time() - before_residuals;
  if(screening.has_weight())
    result.fit.components_without_weight =
        static_cast<int>(std::count(result.is_screened.begin(), result.is_screened.end(), char(0)));
  return result;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Gradient_solution integrate_gradients_to_accuracy(
    Spline_space_3& space, const Vector_field_view& v, const Gradient_options& options,
    double accuracy, const Progress& progress, const Integrated_space& integrated) {
  Gradient_solution solution;
  search_depth(space, accuracy, progress, {}, [&](const Progress& part) {
    solution = integrate_gradients(integrated ? integrated(space) : space, v, options, part);
    return Found_in_space{&solution.fit, values_over_surface(space, solution.fit.coefficients)};
  });
  return solution;
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

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void
add_details(const Spline_space_3& space, const Vector_field_view& v,
            const Gradient_screening& screening, double tolerance, int maximum_iterations,
            Gradient_solution& solution, Eigen::MatrixXd& values) {
  CGAL::Real_timer timer;
  timer.start();
  space.surface().require_triangles("details");
  const int degree = (std::max)(v.degree(), screening.has_weight()
                                                ? weight_degree(screening) +
                                                      (std::max)(2, target_degree(screening) + 1)
                                                : 0);
  Screening_values of_screening(screening, v.channels());
  const auto evaluate = [&](const Surface_point* points, std::size_t number) {
    if(screening.has_weight())
      of_screening.evaluate(points, number);
  };
  const auto weight = [&](std::size_t i) {
    return screening.has_weight() ? of_screening.weight(i) : 0.;
  };
  const auto target = [&](std::size_t i) { return of_screening.target(i); };
  Vertex_system system =
      vertex_system(space.surface(), v, evaluate, weight, target, (std::min)(degree, 12));
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
      add_vertex_details(system, tolerance, maximum_iterations, values);
  shift_to_means(components, measures, solution.means, values);
  solution.fit.worsen_status(report.status);
  solution.fit.details_iterations = report.iterations;
  solution.fit.details_seconds = timer.time();
}

} // namespace internal

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Gradient_fit integrate_gradient_field(
    const Spline_space_3& space, const Vector_field_view& v, const Gradient_options& options) {
  return internal::integrate_gradients(space, v, options, internal::Progress(options.progress)).fit;
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_INTEGRATE_GRADIENTS_IMPL_H
