// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_MAKE_POISSON_SOLVER_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_MAKE_POISSON_SOLVER_IMPL_H

#include <CGAL/Restricted_laplacian_3/assembly/Dirichlet_boundary.h>
#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Progress.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/name_step.h>
#include <CGAL/Restricted_laplacian_3/problems/make_poisson_solver.h>
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
  return name_step("not enough memory for the multigrid solver", [&] {
    Multigrid_levels levels = multigrid_levels(space);
    levels.coarse_matrices = std::move(coarse_matrices);
    return Poisson_solver(std::move(a), std::move(levels), integrals, constant_loads, options);
  });
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Poisson_solver
elliptic_solver(const Spline_space_3& space, const Elliptic_operator& elliptic,
                const Poisson_solver_options& options, const Progress& progress,
                Eigen::VectorXd* constant_loads, Sparse_matrix* mass) {
  check_alpha(elliptic.reaction);
  // Matrices of the space of the paper are not the Galerkin products, which are computed then.
  const bool is_paper_space = space.is_paper_space();
  const int coarsest = is_paper_space ? space.depth() : coarsest_multigrid_level(space);
  System_matrices system = assemble_system(
      space, coarsest, elliptic, is_paper_space ? Stored_entries::all : Stored_entries::upper_half,
      progress.part(0, part_of_assembly), mass);
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

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Poisson_solver
constrained_solver(const Spline_space_3& space, const Elliptic_operator& elliptic,
                   const Dirichlet_boundary* boundary, const Point_constraints* constraints,
                   const Poisson_solver_options& options, const Progress& progress) {
  check_alpha(elliptic.reaction);
  System_matrices system = assemble_system(space, space.depth(), elliptic, Stored_entries::all,
                                           progress.part(0, part_of_assembly));
  Sparse_matrix a;
  a.swap(system.matrices.front());
  if(boundary)
    boundary->add_to_matrix(a);
  if(constraints)
    constraints->add_to_matrix(a);
  progress(part_of_assembly);
  Poisson_solver solver =
      poisson_solver(space, std::move(a), {}, system.integrals, system.constant_loads, options);
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

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Poisson_solver
poisson_solver_of(const Spline_space_3& space, const Operators* operators, std::size_t number,
                  double alpha, const Poisson_solver_options& options) {
  check_alpha(alpha);
  const int levels = static_cast<int>(number);
  if(levels != 1 &&
     (space.is_paper_space() || levels != space.depth() - coarsest_multigrid_level(space) + 1))
    throw Parameter_error("operators", "are not those of the levels of a hierarchy");
  std::vector<Sparse_matrix> matrices;
  for(int i = 0; i < levels; ++i) {
    const auto n = static_cast<Eigen::Index>(space.dimension(space.depth() - levels + 1 + i));
    for(const Sparse_matrix* matrix : {&operators[i].stiffness, &operators[i].mass})
      if(matrix->rows() != n || matrix->cols() != n)
        throw Parameter_error("operators", "do not fit the dimension of the space");
    matrices.push_back(shifted_stiffness(operators[i], alpha));
  }
  const Sparse_matrix& mass = operators[number - 1].mass;
  const Eigen::VectorXd integrals =
      space.is_paper_space() ? assemble_element_integrals(space)
                             : Eigen::VectorXd(mass * Eigen::VectorXd::Ones(mass.cols()));
  Sparse_matrix finest = std::move(matrices.back());
  matrices.pop_back();
  return poisson_solver(space, std::move(finest), std::move(matrices), integrals, alpha * integrals,
                        options);
}

} // namespace internal

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Poisson_solver make_poisson_solver(
    const Spline_space_3& space, Sparse_matrix&& a, const Eigen::VectorXd& element_integrals,
    double alpha, const Poisson_solver_options& options) {
  internal::check_alpha(alpha);
  return internal::poisson_solver(space, std::move(a), {}, element_integrals,
                                  alpha * element_integrals, options);
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Poisson_solver make_poisson_solver(
    const Spline_space_3& space, const Sparse_matrix& a, const Eigen::VectorXd& element_integrals,
    double alpha, const Poisson_solver_options& options) {
  return make_poisson_solver(space, Sparse_matrix(a), element_integrals, alpha, options);
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_MAKE_POISSON_SOLVER_IMPL_H
