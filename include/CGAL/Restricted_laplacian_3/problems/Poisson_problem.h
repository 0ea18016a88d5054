// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_POISSON_PROBLEM_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_POISSON_PROBLEM_H

#include <CGAL/Restricted_laplacian_3/assembly/Point_constraints.h>
#include <CGAL/Restricted_laplacian_3/assembly/internal/assemble_system.h>
#include <CGAL/Restricted_laplacian_3/foundation/compiled.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Progress.h>
#include <CGAL/Restricted_laplacian_3/solvers/Poisson_solver.h>
#include <CGAL/Restricted_laplacian_3/solvers/Solve_report.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>
#include <CGAL/Restricted_laplacian_3/surface/Surface_function_view.h>

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Problems
/// The solution of a Poisson problem in a space: its coefficients, to be evaluated by
/// `Spline_function_3`.
struct Poisson_solution : Solve_report {
  /// one for each element of the finest level
  Eigen::VectorXd coefficients;
  /// number of connected components of the surface on which constants are not determined by the
  /// problem; the solution has mean 0 there
  int kernel_dimension = 0;
};

namespace internal {

/// A Poisson problem on a space, \f$\Delta u = f\f$, or \f$\alpha u - \Delta u = f\f$ if
/// \f$\alpha\f$ is not 0, with prescribed values where wanted.
struct Poisson_problem {
  Surface_function_view f;
  Elliptic_operator elliptic;
  std::optional<Surface_function_view> boundary_values;
  std::optional<Point_constraints> constraints;
  Poisson_solver_options options;
  Progress progress;
};

/// Prescribed values enter the right-hand side with large factors, and its norm with them: the
/// same relative residual means less.
constexpr double tolerance_with_constraints = 1e-7;

Poisson_solution solve_poisson_problem(const Spline_space_3& space, const Poisson_problem& problem);

/// A location of each vertex that has a face of positive area; \f$-1\f$ as its barycentric
/// coordinate marks the others.
std::vector<Surface_location> locations_of_vertices(const Triangulated_surface_3& surface);

/// refuses a screening weight that is not a positive number
void check_screening_weight(double alpha);

} // namespace internal

} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/problems/Poisson_problem_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_POISSON_PROBLEM_H
