// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_MAKE_POISSON_SOLVER_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_MAKE_POISSON_SOLVER_IMPL_H

#include <CGAL/Restricted_laplacian_3/assembly/Dirichlet_boundary.h>
#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Progress.h>
#include <CGAL/Restricted_laplacian_3/problems/make_poisson_solver.h>
#include <CGAL/Restricted_laplacian_3/problems/multigrid_levels.h>
#include <CGAL/Restricted_laplacian_3/splines/prolongation.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

namespace internal {

/// of the time that a solver takes, that of its matrices; the rest is for the hierarchy
constexpr double part_of_assembly = 0.6;

inline void check_alpha(double alpha) {
  if(!(alpha >= 0 && std::isfinite(alpha)))
    throw Parameter_error("alpha", "is " + std::to_string(alpha) +
                                       ", but must be a finite number that is not negative");
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Poisson_solver
poisson_solver(const Spline_space_3& space, Sparse_matrix&& a,
               std::vector<Sparse_matrix> coarse_matrices, const Eigen::VectorXd& integrals,
               const Eigen::VectorXd& constant_loads, const Poisson_solver_options& options) {
  Multigrid_levels levels = multigrid_levels(space);
  levels.coarse_matrices = std::move(coarse_matrices);
  return Poisson_solver(std::move(a), std::move(levels), integrals, constant_loads, options);
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Poisson_solver
elliptic_solver(const Spline_space_3& space, const Elliptic_operator& elliptic,
                const Poisson_solver_options& options, const Progress& progress,
                Eigen::VectorXd* constant_loads) {
  check_alpha(elliptic.reaction);
  // Matrices of the space of the paper are not the Galerkin products, which are computed then.
  const bool is_paper_space = space.is_paper_space();
  const int coarsest = is_paper_space ? space.depth() : coarsest_multigrid_level(space);
  System_matrices system = assemble_system(
      space, coarsest, elliptic, is_paper_space ? Stored_entries::all : Stored_entries::upper_half,
      progress.part(0, part_of_assembly));
  Sparse_matrix finest;
  finest.swap(system.matrices.back());
  system.matrices.pop_back();
  if(constant_loads)
    *constant_loads = system.constant_loads;
  progress(part_of_assembly);
  Poisson_solver solver = poisson_solver(space, std::move(finest), std::move(system.matrices),
                                         system.integrals, system.constant_loads, options);
  progress(1);
  return solver;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Poisson_solver constrained_solver(
    const Spline_space_3& space, const Elliptic_operator& elliptic,
    const std::optional<Surface_function_view>& boundary_values,
    const std::optional<Point_constraints>& constraints, const Poisson_solver_options& options,
    const Progress& progress, Eigen::VectorXd& load) {
  check_alpha(elliptic.reaction);
  System_matrices system = assemble_system(space, space.depth(), elliptic, Stored_entries::all,
                                           progress.part(0, part_of_assembly));
  Sparse_matrix a;
  a.swap(system.matrices.front());
  if(boundary_values) {
    const Dirichlet_boundary boundary(space);
    boundary.add_to_matrix(a);
    load += boundary.load(*boundary_values);
  }
  if(constraints) {
    constraints->add_to_matrix(a);
    load += constraints->load();
  }
  progress(part_of_assembly);
  Poisson_solver solver =
      poisson_solver(space, std::move(a), {}, system.integrals, system.constant_loads, options);
  progress(1);
  return solver;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Poisson_solver
poisson_solver_of(const Spline_space_3& space, const Operators& operators, double alpha,
                  const Poisson_solver_options& options) {
  check_alpha(alpha);
  const auto n = static_cast<Eigen::Index>(space.dimension());
  for(const Sparse_matrix* matrix : {&operators.stiffness, &operators.mass})
    if(matrix->rows() != n || matrix->cols() != n)
      throw Parameter_error("operators", "do not fit the dimension of the space");
  const Eigen::VectorXd integrals =
      space.is_paper_space() ? assemble_element_integrals(space)
                             : Eigen::VectorXd(operators.mass * Eigen::VectorXd::Ones(n));
  // The patterns may differ, for instance with a lumped mass matrix.
  Sparse_matrix a = alpha != 0 ? Sparse_matrix(operators.stiffness + alpha * operators.mass)
                               : operators.stiffness;
  return poisson_solver(space, std::move(a), {}, integrals, alpha * integrals, options);
}

} // namespace internal

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Poisson_solver make_poisson_solver(
    const Spline_space_3& space, Sparse_matrix&& a, const Eigen::VectorXd& element_integrals,
    double alpha, const internal::Poisson_solver_options& options) {
  internal::check_alpha(alpha);
  return internal::poisson_solver(space, std::move(a), {}, element_integrals,
                                  alpha * element_integrals, options);
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Poisson_solver make_poisson_solver(
    const Spline_space_3& space, const Sparse_matrix& a, const Eigen::VectorXd& element_integrals,
    double alpha, const internal::Poisson_solver_options& options) {
  return make_poisson_solver(space, Sparse_matrix(a), element_integrals, alpha, options);
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_MAKE_POISSON_SOLVER_IMPL_H
