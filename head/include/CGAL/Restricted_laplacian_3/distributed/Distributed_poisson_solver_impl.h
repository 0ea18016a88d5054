// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_DISTRIBUTED_POISSON_SOLVER_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_DISTRIBUTED_POISSON_SOLVER_IMPL_H

#include <CGAL/Restricted_laplacian_3/assembly/shared/assemble_system.h>
#include <CGAL/Restricted_laplacian_3/distributed/Distributed_poisson_solver.h>
#include <CGAL/Restricted_laplacian_3/distributed/internal/Distributed_means.h>
#include <CGAL/Restricted_laplacian_3/distributed/internal/Distributed_multigrid.h>
#include <CGAL/Restricted_laplacian_3/distributed/internal/Element_exchange.h>
#include <CGAL/Restricted_laplacian_3/distributed/internal/petsc.h>
#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/problems/stabilization.h>

#include <CGAL/Real_timer.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
struct Distributed_poisson_solver::Impl {
  Impl(const Distributed_space& s, double alpha, std::optional<double> stabilization,
       const Poisson_solver_options& o)
    : space(s), options(o) {
    CGAL::Real_timer timer;
    timer.start();
    const Communicator& communicator = space.communicator();
    internal::System_matrices system;
    communicator.agree([&] {
      if(space.part().is_paper_space())
        throw Parameter_error("paper", "is not possible on several ranks");
      if(options.smoothing_steps < 1)
        throw Parameter_error("smoothing_steps", "must be positive");
      const double tolerance =
          options.tolerance.value_or(Poisson_solver_options::default_tolerance);
      if(!(tolerance > 0 && tolerance < 1))
        throw Parameter_error("tolerance", "must be between 0 and 1");
      if(!(alpha >= 0 && std::isfinite(alpha)))
        throw Parameter_error("alpha", "is " + std::to_string(alpha) +
                                           ", but must be a finite number that is not negative");
      internal::Elliptic_operator elliptic;
      elliptic.reaction = alpha;
      elliptic.stabilization = stabilization.value_or(default_stabilization(space.part()));
      // levels up to the gathered one are the same on all ranks
      const int coarsest =
          (std::min)(internal::coarsest_multigrid_level(space.part()), space.gathered_level());
      system = internal::assemble_system(space.part(), coarsest, elliptic);
    });
    assembly_seconds = timer.time();

    multigrid = std::make_unique<internal::Distributed_multigrid>(space, std::move(system.matrices),
                                                                  options);
    exchange = &multigrid->exchange(multigrid->finest());
    matrix = multigrid->matrix(multigrid->finest());
    means = std::make_unique<internal::Distributed_means>(
        space, *exchange, matrix, exchange->own_sums(system.integrals),
        exchange->own_sums(system.constant_loads));
    make_solver();
    setup_seconds = timer.time() - assembly_seconds;
  }

  void make_solver() {
    using internal::petsc_check;
    const MPI_Comm comm = space.communicator().get();
    make_operator();
    petsc_check(MatNullSpaceCreate(comm, PETSC_FALSE, 0, nullptr, null_space.address()));
    petsc_check(MatNullSpaceSetFunction(null_space, internal::Distributed_means::remove_kernel,
                                        means.get()));
    if(means->kernel_dimension() > 0)
      petsc_check(MatSetNullSpace(singular, null_space));

    petsc_check(KSPCreate(comm, solver.address()));
    petsc_check(KSPSetType(solver, KSPCG));
    petsc_check(KSPSetNormType(solver, KSP_NORM_UNPRECONDITIONED));
    petsc_check(KSPSetOperators(solver, singular, matrix));
    petsc_check(KSPSetTolerances(
        solver, options.tolerance.value_or(Poisson_solver_options::default_tolerance),
        PETSC_DEFAULT, PETSC_DEFAULT, options.maximum_iterations));
    PC pc = nullptr;
    petsc_check(KSPGetPC(solver, &pc));
    multigrid->configure(pc, multigrid->finest());
    petsc_check(KSPSetFromOptions(solver));
    if(!is_multigrid()) // other methods like to know
      petsc_check(MatSetOption(matrix, MAT_SYMMETRIC, PETSC_TRUE));
    petsc_check(KSPSetUp(solver));
    if(is_multigrid())
      multigrid->set_residuals(pc, multigrid->finest());
  }

  /// whether the preconditioner is the one that was made here
  bool is_multigrid() const {
    PC pc = nullptr;
    PetscBool result = PETSC_FALSE;
    internal::petsc_check(KSPGetPC(solver, &pc));
    internal::petsc_check(PetscObjectTypeCompare(reinterpret_cast<PetscObject>(pc), PCMG, &result));
    return result == PETSC_TRUE;
  }

  /// The matrix as conjugate gradients see it. What is known of its kernel is not for the smoother
  /// of the finest level: PETSc would project its vectors, which are copied for that.
  void make_operator() {
    using internal::petsc_check;
    PetscInt rows = 0;
    petsc_check(MatGetLocalSize(matrix, &rows, nullptr));
    petsc_check(MatCreateShell(space.communicator().get(), rows, rows, PETSC_DETERMINE,
                               PETSC_DETERMINE, matrix, singular.address()));
    PetscErrorCode (*const multiply)(Mat, Vec, Vec) = [](Mat shell, Vec x, Vec y) {
      void* context = nullptr;
      PetscCall(MatShellGetContext(shell, &context));
      PetscCall(MatMult(static_cast<Mat>(context), x, y));
      return PetscErrorCode(0);
    };
    petsc_check(MatShellSetOperation(singular, MATOP_MULT, reinterpret_cast<void (*)()>(multiply)));
  }

  Solve_report solve(const Eigen::VectorXd& load, Eigen::VectorXd& coefficients,
                     bool has_guess) const {
    using internal::petsc_check;
    CGAL::Real_timer timer;
    timer.start();
    const Communicator& communicator = space.communicator();
    communicator.agree([&] {
      const auto check = [&](const char* name, const Eigen::VectorXd& v) {
        if(v.size() != static_cast<Eigen::Index>(space.part().dimension()))
          throw Parameter_error(name, "does not fit the part of the space");
        if(!v.allFinite())
          throw Parameter_error(name, "has an entry that is not a finite number");
      };
      check("load", load);
      if(has_guess)
        check("coefficients", coefficients);
    });
    std::vector<double> own = exchange->own_sums(load);
    const std::vector<double> given = own;
    means->project_load(own.data());
    const auto norm = [&](const std::vector<double>& v) {
      double sum = 0;
      for(double x : v)
        sum += x * x;
      return std::sqrt(communicator.sum(sum));
    };
    Solve_report report;
    report.assembly_seconds = assembly_seconds;
    report.setup_seconds = setup_seconds;
    report.set_status(Solve_status::converged);
    const double norm_of_load = norm(own), norm_of_given = norm(given);
    std::vector<double> solution(own.size(), 0.);
    if(norm_of_load > projection_tolerance * norm_of_given) {
      internal::Petsc_vector b, x;
      petsc_check(MatCreateVecs(matrix, x.address(), b.address()));
      internal::set_values(b, own);
      if(has_guess)
        internal::set_values(x, exchange->own_values(coefficients));
      else if(is_multigrid())
        multigrid->make_first_guess(b, x);
      petsc_check(KSPSetInitialGuessNonzero(solver, has_guess || is_multigrid() ? PETSC_TRUE
                                                                                : PETSC_FALSE));
      petsc_check(KSPSolve(solver, b, x));
      PetscInt iterations = 0;
      KSPConvergedReason reason = KSP_CONVERGED_ITERATING;
      petsc_check(KSPGetIterationNumber(solver, &iterations));
      petsc_check(KSPGetConvergedReason(solver, &reason));
      report.iterations = static_cast<int>(iterations);
      internal::Petsc_vector r;
      petsc_check(VecDuplicate(b, r.address()));
      petsc_check(MatResidual(matrix, b, x, r));
      PetscReal residual = 0;
      petsc_check(VecNorm(r, NORM_2, &residual));
      report.relative_residual = residual / norm_of_load;
      report.set_status(reason > 0                         ? Solve_status::converged
                        : reason == KSP_DIVERGED_ITS       ? Solve_status::iteration_limit
                        : !(report.relative_residual <= 1) ? Solve_status::diverged
                                                           : Solve_status::stalled);
      solution = internal::values_of(x);
    }
    report.relative_residuals.assign(1, report.relative_residual);
    means->shift_solution(given.data(), solution.data());
    coefficients = exchange->known_values(solution);
    report.solve_seconds = timer.time();
    return report;
  }

  /// a right-hand side that the projection reduces to this fraction is a constant
  static constexpr double projection_tolerance = 1e-13;

  const Distributed_space& space;
  Poisson_solver_options options;
  std::unique_ptr<internal::Distributed_multigrid> multigrid;
  // of the finest level
  const internal::Element_exchange* exchange = nullptr;
  Mat matrix = nullptr;
  std::unique_ptr<internal::Distributed_means> means;
  internal::Petsc_matrix singular;
  internal::Petsc_null_space null_space;
  internal::Petsc_solver solver;
  double assembly_seconds = 0, setup_seconds = 0;
};

CGAL_RESTRICTED_LAPLACIAN_3_INLINE
Distributed_poisson_solver::Distributed_poisson_solver(const Distributed_space& space, double alpha,
                                                       std::optional<double> stabilization,
                                                       const Poisson_solver_options& options)
  : m_impl(std::make_unique<Impl>(space, alpha, stabilization, options)) {}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Distributed_poisson_solver::Distributed_poisson_solver(
    Distributed_poisson_solver&& other) noexcept = default;
CGAL_RESTRICTED_LAPLACIAN_3_INLINE
Distributed_poisson_solver::~Distributed_poisson_solver() = default;

CGAL_RESTRICTED_LAPLACIAN_3_INLINE KSP Distributed_poisson_solver::ksp() const {
  return m_impl->solver;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Mat Distributed_poisson_solver::matrix() const {
  return m_impl->matrix;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE int Distributed_poisson_solver::kernel_dimension() const {
  return m_impl->means->kernel_dimension();
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Solve_report Distributed_poisson_solver::solve(
    const Eigen::VectorXd& load, Eigen::VectorXd& coefficients, bool has_guess) const {
  return m_impl->solve(load, coefficients, has_guess);
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_DISTRIBUTED_POISSON_SOLVER_IMPL_H
