// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_POISSON_SOLVER_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_POISSON_SOLVER_IMPL_H

#include <CGAL/Restricted_laplacian_3/assembly/Dirichlet_boundary.h>
#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Progress.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/explain_out_of_memory.h>
#include <CGAL/Restricted_laplacian_3/problems/Poisson_solver.h>
#include <CGAL/Restricted_laplacian_3/problems/multigrid_levels.h>
#include <CGAL/Restricted_laplacian_3/splines/prolongation.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

namespace internal {

/// of the time that a solver takes, that of its matrices; the rest is for the hierarchy
constexpr double share_of_assembly = 0.6;

inline void check_alpha(double alpha) {
  if(!(alpha >= 0 && std::isfinite(alpha)))
    throw Parameter_error("alpha", "is " + std::to_string(alpha) +
                                       ", but must be a finite number that is not negative");
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Multigrid_solver multigrid_solver(
    const Spline_space_3& space, System_matrices&& system, const Poisson_solver_options& options) {
  return explain_out_of_memory("not enough memory for the multigrid solver", [&] {
    Sparse_matrix finest;
    finest.swap(system.matrices.back());
    system.matrices.pop_back();
    Multigrid_levels levels = multigrid_levels(space);
    levels.coarse_matrices = std::move(system.matrices);
    return Multigrid_solver(std::move(finest), std::move(levels), system.integrals,
                            system.constant_loads, options);
  });
}

inline Multigrid_solver multigrid_solver(const Spline_space_3& space, const Elliptic_system& system,
                                         const Poisson_solver_options& options,
                                         const Progress& progress) {
  check_alpha(system.elliptic.reaction);
  // Matrices of the space of the paper are not the Galerkin products, which are computed then.
  const bool is_constrained = system.boundary || system.constraints,
             is_finest_only = is_constrained || space.is_paper_space();
  System_matrices matrices = assemble_system(
      space, is_finest_only ? space.depth() : coarsest_multigrid_level(space), system.elliptic,
      is_finest_only ? Stored_entries::all : Stored_entries::upper_half,
      progress.part(0, share_of_assembly), system.mass);
  if(system.boundary)
    system.boundary->add_to_matrix(matrices.matrices.back());
  if(system.constraints)
    system.constraints->add_to_matrix(matrices.matrices.back());
  if(system.constant_loads)
    *system.constant_loads = matrices.constant_loads;
  progress(share_of_assembly);
  Multigrid_solver solver = multigrid_solver(space, std::move(matrices), options);
  progress(1);
  return solver;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE std::vector<Operators>
multigrid_operators(const Spline_space_3& space, double stabilization) {
  // Matrices of the space of the paper are not the Galerkin products, which are computed then.
  const int coarsest = space.is_paper_space() ? space.depth() : coarsest_multigrid_level(space);
  return assemble_operators_of_levels(space, coarsest, space.depth(), stabilization);
}

/// \f$S + \alpha M\f$
inline Sparse_matrix shifted_stiffness(const Operators& operators, double alpha) {
  const auto& [s, m] = operators;
  const auto is_same = [](const int* a, const int* b, Eigen::Index size) {
    return a && b && std::equal(a, a + size, b);
  };
  if(alpha == 0)
    return s;
  if(!s.isCompressed() || !m.isCompressed() || s.nonZeros() != m.nonZeros() ||
     !is_same(s.outerIndexPtr(), m.outerIndexPtr(), s.cols()) ||
     !is_same(s.innerIndexPtr(), m.innerIndexPtr(), s.nonZeros()))
    return s + alpha * m;
  Sparse_matrix result = s;
  result.coeffs() += alpha * m.coeffs();
  return result;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Multigrid_solver
multigrid_solver(const Spline_space_3& space, const Operators* operators, std::size_t number,
                 double alpha, const Poisson_solver_options& options) {
  check_alpha(alpha);
  const int levels = static_cast<int>(number);
  if(levels != 1 &&
     (space.is_paper_space() || levels != space.depth() - coarsest_multigrid_level(space) + 1))
    throw Parameter_error("operators", "are not those of the levels of a hierarchy");
  System_matrices system;
  system.matrices.reserve(number);
  for(int i = 0; i < levels; ++i) {
    const auto n = static_cast<Eigen::Index>(space.dimension(space.depth() - levels + 1 + i));
    for(const Sparse_matrix* matrix : {&operators[i].stiffness, &operators[i].mass})
      if(matrix->rows() != n || matrix->cols() != n)
        throw Parameter_error("operators", "do not fit the dimension of the space");
    shifted_stiffness(operators[i], alpha).swap(system.matrices.emplace_back());
  }
  const Sparse_matrix& mass = operators[number - 1].mass;
  system.integrals = space.is_paper_space()
                         ? assemble_element_integrals(space)
                         : Eigen::VectorXd(mass * Eigen::VectorXd::Ones(mass.cols()));
  system.constant_loads = alpha * system.integrals;
  return multigrid_solver(space, std::move(system), options);
}

inline System_matrices system_of_matrix(Sparse_matrix&& a, const Eigen::VectorXd& integrals,
                                        double alpha) {
  check_alpha(alpha);
  System_matrices system;
  system.matrices.emplace_back().swap(a);
  system.integrals = integrals;
  system.constant_loads = alpha * integrals;
  return system;
}

} // namespace internal

CGAL_RESTRICTED_LAPLACIAN_3_INLINE
Poisson_solver::Poisson_solver(const Spline_space_3& space, Sparse_matrix&& a,
                               const Eigen::VectorXd& element_integrals, double alpha,
                               const Poisson_solver_options& options)
  : Multigrid_solver(internal::multigrid_solver(
        space, internal::system_of_matrix(std::move(a), element_integrals, alpha), options)) {}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE
Poisson_solver::Poisson_solver(const Spline_space_3& space, const internal::Elliptic_system& system,
                               const Poisson_solver_options& options,
                               const internal::Progress& progress)
  : Multigrid_solver(internal::multigrid_solver(space, system, options, progress)) {}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_POISSON_SOLVER_IMPL_H
