// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_POISSON_PROBLEM_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_POISSON_PROBLEM_IMPL_H

#include <CGAL/Restricted_laplacian_3/assembly/Boundary_integration.h>
#include <CGAL/Restricted_laplacian_3/assembly/Dirichlet_boundary.h>
#include <CGAL/Restricted_laplacian_3/assembly/assemble.h>
#include <CGAL/Restricted_laplacian_3/assembly/shared/assemble_system.h>
#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Progress.h>
#include <CGAL/Restricted_laplacian_3/problems/Poisson_problem.h>
#include <CGAL/Restricted_laplacian_3/problems/Poisson_solver.h>
#include <CGAL/Restricted_laplacian_3/problems/internal/Prescribed_iteration.h>
#include <CGAL/Restricted_laplacian_3/problems/internal/level_estimate.h>
#include <CGAL/Restricted_laplacian_3/problems/internal/require_enough_points.h>
#include <CGAL/Restricted_laplacian_3/problems/shared/values_over_surface.h>
#include <CGAL/Restricted_laplacian_3/surface/surface_functions.h>

#include <CGAL/Real_timer.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

namespace internal {

/// What is prescribed in a problem, as the matrices take it.
class Prescribed_values {
public:
  Prescribed_values(const Spline_space_3& space, const Poisson_problem& problem)
    : m_points(problem.constraints), m_on_sides(problem.vertex_values),
      m_values(problem.boundary_values.value_or(m_on_sides)) {
    if(!problem.vertex_values.empty())
      add_vertices(space, problem);
    if(has_values_along_boundary(space, problem)) {
      m_boundary.emplace(Boundary_integration(
          space, [&](const Surface_point& p) { return holds_values(problem, p); }));
      if(m_boundary->length() == 0)
        m_boundary.reset();
    }
    if(problem.boundary_values && !m_boundary)
      throw Parameter_error("boundary_values", "are given, but hold on no part of a boundary");
    if(problem.boundary_flux)
      add_flux(space, problem);
  }
  Prescribed_values(const Prescribed_values&) = delete;
  Prescribed_values& operator=(const Prescribed_values&) = delete;

  const Dirichlet_boundary* boundary() const { return m_boundary ? &*m_boundary : nullptr; }
  const Point_constraints* points() const { return m_points ? &*m_points : nullptr; }

  /// adds what values and fluxes on the boundary add to the right-hand side
  void add_load(Eigen::MatrixXd& load) const {
    if(m_boundary)
      load.colwise() += m_boundary->load(m_values);
    if(m_flux_load.size() > 0)
      load.colwise() += m_flux_load;
  }

  /// a number around which the values are
  double mean() const {
    if(m_points && m_points->size() > 0)
      return m_points->values().mean();
    return m_boundary ? m_boundary->mean(m_values) : 0;
  }

private:
  static bool has_values_along_boundary(const Spline_space_3& space,
                                        const Poisson_problem& problem) {
    return problem.boundary_values || (!problem.vertex_values.empty() && !problem.vertex_weight &&
                                       !space.surface().is_point_set());
  }

  /// whether values hold on a side of a face whose middle this is
  bool holds_values(const Poisson_problem& problem, const Surface_point& p) const {
    if(problem.boundary_values)
      return !problem.has_boundary_value || problem.has_boundary_value(p);
    return std::isfinite(m_on_sides(p)); // at both ends
  }

  void add_flux(const Spline_space_3& space, const Poisson_problem& problem) {
    const bool has_values = m_boundary.has_value();
    const Boundary_integration rest(
        space, [&](const Surface_point& p) { return !has_values || !holds_values(problem, p); });
    if(rest.length() == 0)
      throw Parameter_error("boundary_flux",
                            "is given, but there is no boundary without prescribed values");
    m_flux_load = rest.load(*problem.boundary_flux);
  }

  void add_vertices(const Spline_space_3& space, const Poisson_problem& problem) {
    const std::vector<double>& values = problem.vertex_values;
    const Triangulated_surface_3& surface = space.surface();
    if(values.size() != surface.number_of_vertices())
      throw Parameter_error("vertex_values",
                            "are " + std::to_string(values.size()) + ", but the surface has " +
                                std::to_string(surface.number_of_vertices()) + " vertices");
    if(!m_points)
      m_points.emplace(space);
    const std::vector<Surface_location> locations = locations_of_vertices(surface);
    for(std::size_t v = 0; v < values.size(); ++v) {
      if(std::isnan(values[v]))
        continue;
      if(locations[v].barycentric[0] < 0)
        throw Invalid_vertex_error(v, "has a prescribed value, but no face of positive area");
      if(problem.vertex_weight)
        m_points->add(locations[v], values[v], *problem.vertex_weight);
      else
        m_points->add(locations[v], values[v]);
    }
  }

  std::optional<Point_constraints> m_points;
  std::optional<Dirichlet_boundary> m_boundary;
  Linear_surface_function<double> m_on_sides; // values at vertices, NaN where one is
  Surface_function_view m_values;             // on the boundary
  Eigen::VectorXd m_flux_load;
};

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Poisson_solutions
solve_poisson_problems(const Spline_space_3& space, const Poisson_problem& problem) {
  CGAL::Real_timer timer;
  timer.start();
  require_enough_points(space);
  const Progress progress(problem.progress);
  progress(0);
  Elliptic_system system;
  system.elliptic.reaction = problem.alpha;
  system.elliptic.reaction_function = problem.alpha_function;
  system.elliptic.stabilization = problem.stabilization.value_or(default_stabilization(space));
  Eigen::MatrixXd load = assemble_component_loads(space, problem.f);
  if(problem.alpha == 0 && !problem.alpha_function)
    load = -load;
  const Progress of_setup = progress.part(0.1, 0.7), of_solve = progress.part(0.7, 1);
  const Prescribed_values prescribed(space, problem);
  prescribed.add_load(load);
  system.boundary = prescribed.boundary();
  system.constraints = prescribed.points();
  const Poisson_solver solver(space, system, problem.solver, of_setup);
  const double assembly_seconds = timer.time() - solver.setup_seconds();
  Poisson_solutions solution;
  Solve_report& report = solution;
  if(system.boundary || system.constraints) {
    if(load.cols() != 1)
      throw Parameter_error("f", "has several components, and values are prescribed");
    const Eigen::VectorXd only_load = load;
    Prescribed_iteration iteration(solver, only_load, prescribed.points(), prescribed.mean());
    report =
        iteration.solve(problem.solver.tolerance.value_or(tolerance_with_constraints), of_solve);
    solution.coefficients = iteration.coefficients();
  } else {
    Solve_options options;
    options.progress = of_solve.callback();
    std::array<Eigen::MatrixXd, 2> coarser;
    options.coarser_solutions = &coarser;
    report = solver.solve(load, solution.coefficients, options);
    estimate_error(space, solution.coefficients, coarser, solution);
  }
  solution.assembly_seconds = assembly_seconds;
  solution.kernel_dimension = solver.kernel_dimension();
  return solution;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Poisson_solutions
solve_poisson_to_accuracy(Spline_space_3& space, const Poisson_problem& given, double accuracy,
                          const Integrated_space& integrated) {
  if(given.constraints)
    throw Parameter_error("accuracy", "needs other spaces than that of the constraints at points");
  Poisson_problem problem = given;
  if(!problem.solver.tolerance && problem.vertex_values.empty() && !problem.boundary_values)
    problem.solver.tolerance = (std::min)(Poisson_solver_options::default_tolerance, accuracy);
  const bool has_estimate = problem.vertex_values.empty() && !problem.boundary_values;
  Depth_search_options options;
  options.most_steps = has_estimate ? 2 : 1;
  Poisson_solutions solution;
  search_depth(space, accuracy, Progress(given.progress), options, [&](const Progress& progress) {
    problem.progress = progress.callback();
    solution = solve_poisson_problems(integrated ? integrated(space) : space, problem);
    return Found_in_space{&solution, values_over_surface(space, solution.coefficients)};
  });
  return solution;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE std::vector<Surface_location>
locations_of_vertices(const Triangulated_surface_3& surface) {
  Surface_location none;
  none.barycentric.fill(-1);
  std::vector<Surface_location> result(surface.number_of_vertices(), none);
  for(std::size_t f = 0; f < surface.number_of_faces(); ++f)
    for(int corner = 0; corner < 3 && !surface.is_degenerate(f); ++corner) {
      Surface_location& location = result[surface.triangle(f)[corner]];
      location.face = f;
      location.barycentric.fill(0);
      location.barycentric[corner] = 1;
    }
  return result;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void check_screening_weight(double alpha) {
  if(!(alpha > 0 && std::isfinite(alpha)))
    throw Parameter_error("alpha", "is " + std::to_string(alpha) +
                                       ", but must be a positive, finite number");
}

} // namespace internal

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Poisson_solution
solve_poisson_problem(const Spline_space_3& space, const Poisson_problem& problem) {
  if(problem.f.components() != 1)
    throw Parameter_error("f", "has " + std::to_string(problem.f.components()) +
                                   " components, but must have 1");
  internal::Poisson_solutions solutions = internal::solve_poisson_problems(space, problem);
  Poisson_solution solution;
  static_cast<Solve_report&>(solution) = solutions;
  solution.coefficients = solutions.coefficients.col(0);
  solution.kernel_dimension = solutions.kernel_dimension;
  return solution;
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_POISSON_PROBLEM_IMPL_H
