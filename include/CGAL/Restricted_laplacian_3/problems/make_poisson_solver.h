// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_MAKE_POISSON_SOLVER_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_MAKE_POISSON_SOLVER_H

#include <CGAL/Restricted_laplacian_3/assembly/Point_constraints.h>
#include <CGAL/Restricted_laplacian_3/assembly/assemble.h>
#include <CGAL/Restricted_laplacian_3/assembly/internal/assemble_system.h>
#include <CGAL/Restricted_laplacian_3/foundation/Sparse_matrix.h>
#include <CGAL/Restricted_laplacian_3/foundation/compiled.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Progress.h>
#include <CGAL/Restricted_laplacian_3/foundation/parameters.h>
#include <CGAL/Restricted_laplacian_3/integration/Cubature.h>
#include <CGAL/Restricted_laplacian_3/integration/Surface_integration_view.h>
#include <CGAL/Restricted_laplacian_3/problems/stabilization.h>
#include <CGAL/Restricted_laplacian_3/solvers/Poisson_solver.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

namespace internal {

template <class NamedParameters>
Poisson_solver_options poisson_solver_options(const NamedParameters& np) {
  using parameters::choose_parameter;
  using parameters::get_parameter;
  Poisson_solver_options options;
  options.relative_tolerance = choose_parameter(get_parameter(np, internal_np::relative_tolerance),
                                                options.relative_tolerance);
  options.maximum_iterations = choose_parameter(
      get_parameter(np, internal_np::number_of_iterations), options.maximum_iterations);
  options.cycle = choose_parameter(get_parameter(np, internal_np::cycle), options.cycle);
  options.smoothing_steps =
      choose_parameter(get_parameter(np, internal_np::smoothing_steps), options.smoothing_steps);
  options.stand_alone_multigrid = choose_parameter(
      get_parameter(np, internal_np::stand_alone_multigrid), options.stand_alone_multigrid);
  options.smoother = choose_parameter(get_parameter(np, internal_np::smoother), options.smoother);
  options.is_parallel = is_parallel(np);
  return options;
}

/// The levels of a space as a multigrid hierarchy, for a system on its finest level.
/// \param coarse_matrices of the levels above the coarsest one of the hierarchy; may be empty
/// \param constant_loads what the matrix maps the constant 1 to
Poisson_solver poisson_solver(const Spline_space_3& space, Sparse_matrix&& a,
                              std::vector<Sparse_matrix> coarse_matrices,
                              const Eigen::VectorXd& integrals,
                              const Eigen::VectorXd& constant_loads,
                              const Poisson_solver_options& options);

/// the `callback` among named parameters, if it is there
template <class NamedParameters> Progress progress_of(const NamedParameters& np) {
  return Progress(parameters::choose_parameter(parameters::get_parameter(np, internal_np::callback),
                                               Progress::Callback()));
}

/// of the time that a function takes on a mesh, that of its space
constexpr double part_of_space = 0.15;

/// with the matrices of all levels from one pass over the surface
/// \param constant_loads if not null, on return what the matrix maps the constant 1 to
/// \throws Parameter_error if the reaction or the stabilisation is outside its domain
Poisson_solver
elliptic_solver(const Spline_space_3& space, const Surface_integration_view& integration,
                const Elliptic_operator& elliptic, const Poisson_solver_options& options,
                const Progress& progress = Progress(), Eigen::VectorXd* constant_loads = nullptr);

/// The same with prescribed values: their matrices are known for the finest level only.
/// \param load what they add to the right-hand side is added to it
Poisson_solver constrained_solver(const Spline_space_3& space,
                                  const Surface_integration_view& integration,
                                  const Elliptic_operator& elliptic,
                                  const std::optional<Surface_function_view>& boundary_values,
                                  const std::optional<Point_constraints>& constraints,
                                  const Poisson_solver_options& options, const Progress& progress,
                                  Eigen::VectorXd& load);

/// with matrices of any patterns
Poisson_solver poisson_solver_of(const Spline_space_3& space, const Operators& operators,
                                 double alpha, const Poisson_solver_options& options);

} // namespace internal

/// \ingroup PkgRestrictedLaplacian3Solvers
/// A solver for \f$A \eta = b\f$ on the finest level of a space, where \f$A\f$ is the stiffness
/// matrix with other matrices of its pattern added, such as those of `Dirichlet_boundary` and
/// `Point_constraints`. The matrix is empty afterwards.
/// \param space the space; its prolongations and patches make the hierarchy
/// \param a \f$A\f$; it is empty afterwards
/// \param element_integrals \f$\int b_i\f$
/// \param alpha number \f$\alpha\f$ for which \f$A\f$ contains \f$\alpha M\f$, in units of 1 / area
/// \param options tolerance, iterations, cycle, smoother
/// \throws Parameter_error if a parameter is outside its domain
Poisson_solver
make_poisson_solver(const Spline_space_3& space, Sparse_matrix&& a,
                    const Eigen::VectorXd& element_integrals, double alpha = 0,
                    const Poisson_solver_options& options = Poisson_solver_options());

/// \ingroup PkgRestrictedLaplacian3Solvers
/// The same with a copy of the matrix.
Poisson_solver
make_poisson_solver(const Spline_space_3& space, const Sparse_matrix& a,
                    const Eigen::VectorXd& element_integrals, double alpha = 0,
                    const Poisson_solver_options& options = Poisson_solver_options());

/// \ingroup PkgRestrictedLaplacian3Solvers
/// A solver for \f$(S + \alpha M)\, \eta = b\f$ on the finest level of a space, which assembles the
/// matrices of all levels in one pass over the surface.
/// \param space the space; its prolongations and patches make the hierarchy
/// \param alpha screening weight, at least 0, in units of 1 / area
/// \param np optional named parameters: those of the overload that takes `Operators`, and
/// - `normal_stabilization`: factor \f$c\f$ of `assemble_operators()`; default
///   `default_normal_stabilization()`
/// - `callback`: a function object that is called with the part of the work that is done, from 0 to
///   1, and returns `false` to end it with a `Canceled` exception; `Poisson_solver::solve()` takes
///   one of its own
/// \throws Parameter_error if a parameter is outside its domain
/// \throws Canceled if the callback returned `false`
template <class NamedParameters = parameters::Default_named_parameters,
          internal::Require_named_parameters<NamedParameters> = 0>
Poisson_solver make_poisson_solver(const Spline_space_3& space, double alpha = 0,
                                   const NamedParameters& np = parameters::default_values()) {
  return make_poisson_solver(space, alpha, Default_integration(space), np);
}

/// \ingroup PkgRestrictedLaplacian3Solvers
/// The same with an integration that the caller chooses: any model of `SurfaceIntegration_3`.
template <class NamedParameters = parameters::Default_named_parameters>
Poisson_solver make_poisson_solver(const Spline_space_3& space, double alpha,
                                   const Surface_integration_view& integration,
                                   const NamedParameters& np = parameters::default_values()) {
  internal::Elliptic_operator elliptic;
  elliptic.reaction = alpha;
  elliptic.normal_stabilization = internal::normal_stabilization(space, np);
  return internal::elliptic_solver(space, integration, elliptic,
                                   internal::poisson_solver_options(np), internal::progress_of(np));
}

/// \ingroup PkgRestrictedLaplacian3Solvers
/// A solver for \f$(S + \alpha M)\, \eta = b\f$ on the finest level of a space.
/// \param space the space; its prolongations and patches make the hierarchy
/// \param alpha screening weight, at least 0, in units of 1 / area
/// \param operators the matrices of the finest level of `space`
/// \param np optional named parameters:
/// - `relative_tolerance`: of the residual; default 1e-3
/// - `number_of_iterations`: at most; default 1000
/// - `cycle`: `Cycle::V` (default) or `Cycle::W`
/// - `smoothing_steps`: before, and again after the coarse correction; default 1
/// - `smoother`: `Smoother_type::patch` (default) or `Smoother_type::point`
/// - `stand_alone_multigrid`: iterate cycles, instead of preconditioning conjugate gradients with
///   them; default `false`
/// - `concurrency_tag`: `CGAL::Parallel_tag()` to use several threads, with the same results;
///   default `CGAL::Sequential_tag()`
/// \throws Parameter_error if a parameter is outside its domain
template <class NamedParameters = parameters::Default_named_parameters>
Poisson_solver make_poisson_solver(const Spline_space_3& space, const Operators& operators,
                                   double alpha = 0,
                                   const NamedParameters& np = parameters::default_values()) {
  return internal::poisson_solver_of(space, operators, alpha, internal::poisson_solver_options(np));
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/problems/make_poisson_solver_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_MAKE_POISSON_SOLVER_H
