// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_MAKE_POISSON_SOLVER_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_MAKE_POISSON_SOLVER_H

#include <CGAL/Restricted_laplacian_3/assembly/assemble.h>
#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/parameters.h>
#include <CGAL/Restricted_laplacian_3/problems/multigrid_levels.h>
#include <CGAL/Restricted_laplacian_3/solvers/Poisson_solver.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>
#include <CGAL/Restricted_laplacian_3/splines/prolongation.h>

#include <Eigen/Core>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Solvers
/// The factor \f$c\f$ of the stabilisation, see `assemble_operators()`, that the functions for
/// Poisson problems use unless told otherwise: 1e-3, and 0 in the space of the paper. The number of
/// iterations does not depend on the depth of the octree then, while the error of the solution is
/// up to about twice that without stabilisation.
inline double default_normal_stabilization(const Spline_space_3& space) {
  return space.is_paper_space() ? 0 : 1e-3;
}

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

/// the value of `normal_stabilization`, by default that of the space
template <class NamedParameters>
double normal_stabilization(const Spline_space_3& space, const NamedParameters& np) {
  return checked_normal_stabilization(
      parameters::choose_parameter(parameters::get_parameter(np, internal_np::normal_stabilization),
                                   default_normal_stabilization(space)));
}

/// \f$\int b_i\f$
inline Eigen::VectorXd element_integrals(const Spline_space_3& space, const Operators& operators) {
  return space.is_paper_space()
             ? assemble_element_integrals(space)
             : Eigen::VectorXd(operators.mass * Eigen::VectorXd::Ones(operators.mass.cols()));
}

inline void check_alpha(double alpha) {
  if(!(alpha >= 0 && std::isfinite(alpha)))
    throw Parameter_error("alpha", "is " + std::to_string(alpha) +
                                       ", but must be a finite number that is not negative");
}

/// \param coarse_matrices of the levels above the coarsest one of the hierarchy; may be empty
/// \param screening the number \f$\alpha\f$, or the loads of constants
template <class Screening>
Poisson_solver poisson_solver(const Spline_space_3& space, Sparse_matrix&& a,
                              std::vector<Sparse_matrix> coarse_matrices,
                              const Eigen::VectorXd& integrals, const Screening& screening,
                              const Poisson_solver_options& options) {
  Multigrid_levels levels = multigrid_levels(space);
  levels.coarse_matrices = std::move(coarse_matrices);
  return Poisson_solver(std::move(a), std::move(levels), integrals, screening, options);
}

/// The coarsest level whose matrices are assembled for the solver. Those of the space of the paper
/// are not the Galerkin products, which are computed then.
inline int coarsest_assembled_level(const Spline_space_3& space) {
  return space.is_paper_space() ? space.depth() : coarsest_multigrid_level(space);
}

/// with the matrices of all levels from one pass over the surface
template <class SurfaceIntegration>
Poisson_solver poisson_solver(const Spline_space_3& space, const SurfaceIntegration& integration,
                              double alpha, double normal_stabilization,
                              const Poisson_solver_options& options) {
  System_matrices system = assemble_system(space, coarsest_assembled_level(space), integration,
                                           alpha, normal_stabilization);
  if(space.is_paper_space())
    system.integrals = assemble_element_integrals(space);
  Sparse_matrix finest;
  finest.swap(system.matrices.back());
  system.matrices.pop_back();
  return poisson_solver(space, std::move(finest), std::move(system.matrices), system.integrals,
                        alpha, options);
}

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
inline Poisson_solver
make_poisson_solver(const Spline_space_3& space, Sparse_matrix&& a,
                    const Eigen::VectorXd& element_integrals, double alpha = 0,
                    const Poisson_solver_options& options = Poisson_solver_options()) {
  internal::check_alpha(alpha);
  return internal::poisson_solver(space, std::move(a), {}, element_integrals, alpha, options);
}

/// \ingroup PkgRestrictedLaplacian3Solvers
/// The same with a copy of the matrix.
inline Poisson_solver
make_poisson_solver(const Spline_space_3& space, const Sparse_matrix& a,
                    const Eigen::VectorXd& element_integrals, double alpha = 0,
                    const Poisson_solver_options& options = Poisson_solver_options()) {
  return make_poisson_solver(space, Sparse_matrix(a), element_integrals, alpha, options);
}

/// \ingroup PkgRestrictedLaplacian3Solvers
/// A solver for \f$(S + \alpha M)\, \eta = b\f$ on the finest level of a space, which assembles the
/// matrices of all levels in one pass over the surface.
/// \param space the space; its prolongations and patches make the hierarchy
/// \param alpha screening weight, at least 0, in units of 1 / area
/// \param np optional named parameters: those of the overload that takes `Operators`, and
/// - `normal_stabilization`: factor \f$c\f$ of `assemble_operators()`; default
///   `default_normal_stabilization()`
/// \throws Parameter_error if a parameter is outside its domain
template <class NamedParameters = parameters::Default_named_parameters,
          internal::Require_named_parameters<NamedParameters> = 0>
Poisson_solver make_poisson_solver(const Spline_space_3& space, double alpha = 0,
                                   const NamedParameters& np = parameters::default_values()) {
  return make_poisson_solver(space, alpha, Cubature(space), np);
}

/// \ingroup PkgRestrictedLaplacian3Solvers
/// The same with an integration that the caller chooses.
/// \tparam SurfaceIntegration a model of `SurfaceIntegration_3`
template <class SurfaceIntegration, class NamedParameters = parameters::Default_named_parameters,
          internal::Require_no_named_parameters<SurfaceIntegration> = 0>
Poisson_solver make_poisson_solver(const Spline_space_3& space, double alpha,
                                   const SurfaceIntegration& integration,
                                   const NamedParameters& np = parameters::default_values()) {
  internal::check_alpha(alpha);
  return internal::poisson_solver(space, integration, alpha,
                                  internal::normal_stabilization(space, np),
                                  internal::poisson_solver_options(np));
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
  // The patterns are the same, so values can be added without a merge.
  Sparse_matrix a = operators.stiffness;
  if(alpha != 0)
    a.coeffs() += alpha * operators.mass.coeffs();
  return make_poisson_solver(space, std::move(a), internal::element_integrals(space, operators),
                             alpha, internal::poisson_solver_options(np));
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_MAKE_POISSON_SOLVER_H
