// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_POISSON_PROBLEM_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_POISSON_PROBLEM_IMPL_H

#include <CGAL/Restricted_laplacian_3/assembly/assemble.h>
#include <CGAL/Restricted_laplacian_3/assembly/shared/assemble_system.h>
#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Progress.h>
#include <CGAL/Restricted_laplacian_3/problems/Poisson_problem.h>
#include <CGAL/Restricted_laplacian_3/problems/make_poisson_solver.h>

#include <CGAL/Real_timer.h>

#include <Eigen/Core>

#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Poisson_solution
solve_poisson_problem(const Spline_space_3& space, const Poisson_problem& problem) {
  CGAL::Real_timer timer;
  timer.start();
  const internal::Progress progress(problem.callback);
  progress(0);
  internal::Elliptic_operator elliptic;
  elliptic.reaction = problem.alpha;
  elliptic.reaction_function = problem.alpha_function;
  elliptic.normal_stabilization =
      problem.normal_stabilization.value_or(default_normal_stabilization(space));
  Eigen::VectorXd load = assemble_load(space, problem.f);
  if(elliptic.reaction == 0 && !elliptic.reaction_function)
    load = -load;
  const internal::Progress of_setup = progress.part(0.1, 0.7);
  const bool has_prescribed_values = problem.boundary_values || problem.constraints;
  const Poisson_solver solver =
      has_prescribed_values
          ? internal::constrained_solver(space, elliptic, problem.boundary_values,
                                         problem.constraints, problem.solver, of_setup, load)
          : internal::elliptic_solver(space, elliptic, problem.solver, of_setup);
  const double assembly_seconds = timer.time() - solver.setup_seconds();
  Poisson_solution solution;
  const double tolerance = problem.solver.relative_tolerance.value_or(
      has_prescribed_values ? internal::tolerance_with_constraints
                            : Poisson_solver_options::default_tolerance);
  static_cast<Solve_report&>(solution) =
      solver.solve(load, solution.coefficients, {tolerance, progress.part(0.7, 1).callback()});
  solution.assembly_seconds = assembly_seconds;
  solution.kernel_dimension = solver.kernel_dimension();
  return solution;
}

namespace internal {

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

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_POISSON_PROBLEM_IMPL_H
