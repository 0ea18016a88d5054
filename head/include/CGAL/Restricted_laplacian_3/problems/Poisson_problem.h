// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_POISSON_PROBLEM_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_POISSON_PROBLEM_H

#include <CGAL/Restricted_laplacian_3/assembly/Point_constraints.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>
#include <CGAL/Restricted_laplacian_3/problems/shared/search_depth.h>
#include <CGAL/Restricted_laplacian_3/solvers/Multigrid_solver.h>
#include <CGAL/Restricted_laplacian_3/solvers/Solve_report.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>
#include <CGAL/Restricted_laplacian_3/surface/Surface_function_view.h>
#include <CGAL/Restricted_laplacian_3/surface/Surface_location.h>

#include <Eigen/Core>

#include <functional>
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

/// \ingroup PkgRestrictedLaplacian3Options
/// A Poisson problem, \f$\Delta u = f\f$, or a screened one,
/// \f$\alpha u - \Delta u = f\f$. Functions are referred to, and have to outlive it.
struct Poisson_problem {
  /// the right-hand side
  Surface_function_view f;
  /// screening weight, at least 0, in units of 1 / area
  double alpha = 0;
  /// the screening weight as a function whose values are not negative, in place of the number
  std::optional<Surface_function_view> alpha_function;
  /// what the solution is on the boundary, where it is prescribed
  std::optional<Surface_function_view> boundary_values;
  /// Where `boundary_values` hold: called with the middle of each side of a face that is at the
  /// boundary, for which it decides. Everywhere if it is empty.
  std::function<bool(const Surface_point&)> has_boundary_value;
  /// \f$\partial_\nu u\f$ with the outward conormal \f$\nu\f$, where no values hold along the
  /// boundary; without a value it is 0, the natural condition
  std::optional<Surface_function_view> boundary_flux;
  /// What the solution is at vertices, a number for each, NaN where it is free; empty: free
  /// everywhere. The values are met exactly. Without `boundary_values` they hold along each side of
  /// a face at the boundary, too, both ends of which have one, linear between them.
  std::vector<double> vertex_values;
  /// if it has a value, those at vertices only pull with this weight, and do not hold along sides
  std::optional<double> vertex_weight;
  /// what the solution is at points, besides
  std::optional<Point_constraints> constraints;
  /// factor \f$c\f$ of the stabilization; without a value `default_stabilization()`
  std::optional<double> stabilization;
  /// of the linear system; without a value its tolerance is 1e-3, and 1e-8 with prescribed values
  Poisson_solver_options solver;
  /// is told which part of the work is done, from 0 to 1; if it returns `false`, the computation
  /// ends with an exception
  std::function<bool(double)> progress;

  /// a Poisson problem without prescribed values
  explicit Poisson_problem(const Surface_function_view& f) : f(f) {}
};

/// \ingroup PkgRestrictedLaplacian3Problems
/// What `solve_poisson()` and `solve_screened_poisson()` do in a space.
/// \param space the space that the solution is in
/// \param problem what is solved, and how
/// \throws Parameter_error if something is outside its domain, if a value of a function is not
/// finite, or if values or fluxes are given for a boundary of length 0
/// \throws Canceled if `progress` returned `false`
Poisson_solution solve_poisson_problem(const Spline_space_3& space, const Poisson_problem& problem);

namespace internal {

/// The solutions for all components of a right-hand side; what is reported is the worst of them.
struct Poisson_solutions : Solve_report {
  /// a column for each component
  Eigen::MatrixXd coefficients;
  int kernel_dimension = 0;
};

/// Solves a problem whose right-hand side may have several components, unless values are
/// prescribed.
Poisson_solutions solve_poisson_problems(const Spline_space_3& space,
                                         const Poisson_problem& problem);

/// Solves a problem in deeper and deeper spaces.
/// \param space the first one, and then that of the solution
/// \param accuracy the estimated error that ends the search, or the memory of the spaces does
/// \param integrated called for each space, unless it is empty
Poisson_solutions solve_poisson_to_accuracy(Spline_space_3& space, const Poisson_problem& problem,
                                            double accuracy,
                                            const Integrated_space& integrated = {});

/// the tolerance of problems with prescribed values
constexpr double tolerance_with_constraints = 1e-8;

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
