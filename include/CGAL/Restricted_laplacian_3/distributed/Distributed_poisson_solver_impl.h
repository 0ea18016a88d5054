// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_DISTRIBUTED_POISSON_SOLVER_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_DISTRIBUTED_POISSON_SOLVER_IMPL_H

#include <CGAL/Restricted_laplacian_3/assembly/shared/assemble_system.h>
#include <CGAL/Restricted_laplacian_3/distributed/Distributed_poisson_solver.h>
#include <CGAL/Restricted_laplacian_3/distributed/internal/Distributed_means.h>
#include <CGAL/Restricted_laplacian_3/distributed/internal/Distributed_rows.h>
#include <CGAL/Restricted_laplacian_3/distributed/internal/Distributed_smoother.h>
#include <CGAL/Restricted_laplacian_3/distributed/internal/Element_exchange.h>
#include <CGAL/Restricted_laplacian_3/distributed/internal/petsc.h>
#include <CGAL/Restricted_laplacian_3/distributed/internal/petsc_shells.h>
#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/problems/stabilization.h>
#include <CGAL/Restricted_laplacian_3/splines/prolongation.h>

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
  Impl(const Distributed_space& s, double alpha, std::optional<double> normal_stabilization,
       const Poisson_solver_options& o)
    : space(s), options(o),
      exchange(s.communicator(), s.level(s.depth()).first_elements, s.level(s.depth()).elements) {
    CGAL::Real_timer timer;
    timer.start();
    const Communicator& communicator = space.communicator();
    const int gathered = space.gathered_level(), depth = space.depth();
    internal::System_matrices system;
    int coarsest = 0;
    communicator.agree([&] {
      if(space.part().is_paper_space())
        throw Parameter_error("paper_space", "is not possible on several ranks");
      if(options.smoothing_steps < 1)
        throw Parameter_error("smoothing_steps", "must be positive");
      const double tolerance =
          options.relative_tolerance.value_or(Poisson_solver_options::default_tolerance);
      if(!(tolerance > 0 && tolerance < 1))
        throw Parameter_error("relative_tolerance", "must be between 0 and 1");
      if(!(alpha >= 0 && std::isfinite(alpha)))
        throw Parameter_error("alpha", "is " + std::to_string(alpha) +
                                           ", but must be a finite number that is not negative");
      internal::Elliptic_operator elliptic;
      elliptic.reaction = alpha;
      elliptic.normal_stabilization =
          normal_stabilization.value_or(default_normal_stabilization(space.part()));
      // levels up to the gathered one are the same on all ranks
      coarsest = (std::min)(internal::coarsest_multigrid_level(space.part()), gathered);
      system = internal::assemble_system(space.part(), coarsest, elliptic);
    });
    assembly_seconds = timer.time();

    std::vector<Sparse_matrix> whole;
    for(int level = coarsest; level <= gathered; ++level)
      whole.push_back(std::move(system.matrices[static_cast<std::size_t>(level - coarsest)]));
    cycle = std::make_unique<internal::Gathered_cycle>(space, std::move(whole), options);

    const std::size_t number = static_cast<std::size_t>(depth - gathered) + 1;
    matrices.resize(number);
    prolongations.resize(number);
    smoothers.resize(number);
    // entries of vectors of the next coarser level on this rank
    std::size_t coarse_size = gathered_range().second - gathered_range().first;
    for(std::size_t i = 1; i < number; ++i) {
      const int level = gathered + static_cast<int>(i);
      const Distributed_level& of_level = space.level(level);
      const internal::Element_exchange of_elements(communicator, of_level.first_elements,
                                                   of_level.elements);
      Sparse_matrix& a = system.matrices[static_cast<std::size_t>(level - coarsest)];
      const internal::Distributed_rows rows =
          internal::sum_of_matrices(communicator, of_elements, of_level.elements, a);
      Sparse_matrix().swap(a);
      const std::size_t size = of_elements.own_size();
      smoothers[i] = std::make_unique<internal::Level_smoother>();
      smoothers[i]->smoother = std::make_unique<internal::Distributed_smoother>(space, level, rows);
      matrices[i] = internal::petsc_matrix(communicator, rows, size);
      internal::petsc_check(smoothers[i]->attach_to(matrices[i]));
      Sparse_matrix p;
      communicator.agree([&] { p = prolongation_matrix(space.part(), level - 1); });
      prolongations[i] = internal::petsc_matrix(
          communicator,
          internal::rows_of_owner(communicator, of_elements, of_level.elements,
                                  space.level(level - 1).elements, p),
          coarse_size);
      coarse_size = size;
      if(level == depth) {
        std::vector<double> integrals(size, 0.), loads(size, 0.);
        const auto add = [](double& sum, double value) { sum += value; };
        exchange.combine(to_vector(system.integrals), integrals, add);
        exchange.combine(to_vector(system.constant_loads), loads, add);
        means = std::make_unique<internal::Distributed_means>(space, exchange, rows,
                                                              std::move(integrals), loads);
      }
    }
    make_solver();
    setup_seconds = timer.time() - assembly_seconds;
  }

  static std::vector<double> to_vector(const Eigen::VectorXd& v) {
    return std::vector<double>(v.data(), v.data() + v.size());
  }

  /// which elements of the gathered level have their entries of vectors on this rank
  std::pair<std::size_t, std::size_t> gathered_range() const {
    const auto n = static_cast<std::size_t>(space.dimension(space.gathered_level()));
    const auto ranks = static_cast<std::size_t>(space.communicator().size()),
               rank = static_cast<std::size_t>(space.communicator().rank());
    return {n * rank / ranks, n * (rank + 1) / ranks};
  }

  void make_solver() {
    using internal::petsc_check;
    const MPI_Comm comm = space.communicator().get();
    const auto number = static_cast<PetscInt>(matrices.size());
    make_gathered_matrix();
    make_operator();
    petsc_check(MatNullSpaceCreate(comm, PETSC_FALSE, 0, nullptr, null_space.address()));
    petsc_check(MatNullSpaceSetFunction(null_space, internal::Distributed_means::remove_kernel,
                                        means.get()));
    if(means->kernel_dimension() > 0)
      petsc_check(MatSetNullSpace(singular, null_space));

    petsc_check(KSPCreate(comm, solver.address()));
    petsc_check(KSPSetType(solver, KSPCG));
    petsc_check(KSPSetNormType(solver, KSP_NORM_UNPRECONDITIONED));
    petsc_check(KSPSetOperators(solver, singular, matrices.back()));
    petsc_check(KSPSetTolerances(
        solver, options.relative_tolerance.value_or(Poisson_solver_options::default_tolerance),
        PETSC_DEFAULT, PETSC_DEFAULT, options.maximum_iterations));
    PC pc = nullptr;
    petsc_check(KSPGetPC(solver, &pc));
    petsc_check(PCSetType(pc, PCMG));
    petsc_check(PCMGSetLevels(pc, number, nullptr));
    petsc_check(PCMGSetType(pc, PC_MG_MULTIPLICATIVE));
    petsc_check(PCMGSetCycleType(pc, options.cycle == Cycle::V ? PC_MG_CYCLE_V : PC_MG_CYCLE_W));
    petsc_check(PCMGSetGalerkin(pc, PC_MG_GALERKIN_NONE));
    for(PetscInt i = 1; i < number; ++i) {
      petsc_check(PCMGSetInterpolation(pc, i, prolongations[i]));
      for(bool is_up : {false, true}) {
        KSP level = nullptr;
        petsc_check(is_up ? PCMGGetSmootherUp(pc, i, &level) : PCMGGetSmootherDown(pc, i, &level));
        petsc_check(KSPSetType(level, KSPRICHARDSON));
        petsc_check(KSPSetNormType(level, KSP_NORM_NONE));
        petsc_check(KSPSetTolerances(level, PETSC_DEFAULT, PETSC_DEFAULT, PETSC_DEFAULT,
                                     options.smoothing_steps));
        petsc_check(KSPSetOperators(level, matrices[i], matrices[i]));
        PC smoother = nullptr;
        petsc_check(KSPGetPC(level, &smoother));
        petsc_check(PCSetType(smoother, PCSHELL));
        shells.push_back(std::make_unique<internal::Smoother_shell>(
            internal::Smoother_shell{smoothers[i].get(), is_up}));
        petsc_check(PCShellSetContext(smoother, shells.back().get()));
        petsc_check(PCShellSetApply(smoother, internal::Smoother_shell::apply));
        petsc_check(
            PCShellSetApplyRichardson(smoother, internal::Smoother_shell::apply_richardson));
        petsc_check(PCShellSetName(smoother, "cell patches, color by color"));
      }
    }
    KSP coarse = nullptr;
    petsc_check(PCMGGetCoarseSolve(pc, &coarse));
    petsc_check(KSPSetType(coarse, KSPPREONLY));
    petsc_check(KSPSetOperators(coarse, matrices.front(), matrices.front()));
    PC coarse_pc = nullptr;
    petsc_check(KSPGetPC(coarse, &coarse_pc));
    petsc_check(PCSetType(coarse_pc, PCSHELL));
    petsc_check(PCShellSetContext(coarse_pc, &gathered_shell));
    petsc_check(PCShellSetApply(coarse_pc, internal::Gathered_shell::apply));
    petsc_check(PCShellSetName(coarse_pc, "a cycle that each rank makes"));
    petsc_check(KSPSetFromOptions(solver));
    if(!is_multigrid()) // other methods like to know
      petsc_check(MatSetOption(matrices.back(), MAT_SYMMETRIC, PETSC_TRUE));
    petsc_check(KSPSetUp(solver));
    // after the setup, which sets that of the finest level
    for(PetscInt i = 1; i < number && is_multigrid(); ++i)
      petsc_check(PCMGSetResidual(pc, i, internal::Level_smoother::residual, matrices[i]));
    for(std::size_t i = 0; i < matrices.size(); ++i) {
      vectors.emplace_back();
      for(internal::Petsc_vector* v : {&vectors[i].b, &vectors[i].x, &vectors[i].r})
        petsc_check(MatCreateVecs(matrices[i], v->address(), nullptr));
    }
  }

  /// whether the preconditioner is the one that was made here
  bool is_multigrid() const {
    PC pc = nullptr;
    PetscBool result = PETSC_FALSE;
    internal::petsc_check(KSPGetPC(solver, &pc));
    internal::petsc_check(PetscObjectTypeCompare(reinterpret_cast<PetscObject>(pc), PCMG, &result));
    return result == PETSC_TRUE;
  }

  /// PETSc's solver on a level, before or after the coarse correction
  KSP level_solver(std::size_t level, bool is_up) const {
    PC pc = nullptr;
    KSP result = nullptr;
    internal::petsc_check(KSPGetPC(solver, &pc));
    const auto i = static_cast<PetscInt>(level);
    internal::petsc_check(level == 0 ? PCMGGetCoarseSolve(pc, &result)
                          : is_up    ? PCMGGetSmootherUp(pc, i, &result)
                                     : PCMGGetSmootherDown(pc, i, &result));
    return result;
  }

  /// One cycle on a level that starts from 0, for `vectors[level].r`; the correction is in
  /// `vectors[level].x` on return.
  void make_cycle(std::size_t level) const {
    using internal::petsc_check;
    const Level_vectors& v = vectors[level];
    if(level == 0)
      return petsc_check(KSPSolve(level_solver(0, false), v.r, v.x));
    const Level_vectors& coarse = vectors[level - 1];
    internal::Petsc_vector b;
    petsc_check(VecDuplicate(v.r, b.address()));
    petsc_check(VecCopy(v.r, b));
    petsc_check(VecSet(v.x, 0));
    petsc_check(KSPSetInitialGuessNonzero(level_solver(level, false), PETSC_FALSE));
    petsc_check(KSPSolve(level_solver(level, false), b, v.x));
    petsc_check(internal::Level_smoother::residual(matrices[level], b, v.x, v.r));
    petsc_check(MatMultTranspose(prolongations[level], v.r, coarse.r));
    make_cycle(level - 1);
    petsc_check(MatMultAdd(prolongations[level], coarse.x, v.x, v.x));
    petsc_check(KSPSetInitialGuessNonzero(level_solver(level, true), PETSC_TRUE));
    petsc_check(KSPSolve(level_solver(level, true), b, v.x));
  }

  /// The first guess by nested iteration, as that of `Multigrid`: the solution of each level is
  /// prolongated to the next, and improved by one cycle there, except on the finest.
  void make_first_guess(Vec b, Vec x) const {
    using internal::petsc_check;
    const std::size_t finest = matrices.size() - 1;
    petsc_check(VecCopy(b, vectors[finest].b));
    for(std::size_t level = finest; level > 0; --level)
      petsc_check(MatMultTranspose(prolongations[level], vectors[level].b, vectors[level - 1].b));
    std::vector<internal::Petsc_vector> solutions(finest);
    for(std::size_t level = 0; level < finest; ++level) {
      const Level_vectors& v = vectors[level];
      petsc_check(VecDuplicate(v.x, solutions[level].address()));
      if(level == 0) {
        petsc_check(VecSet(solutions[0], 0));
        petsc_check(VecCopy(v.b, v.r));
      } else {
        petsc_check(MatMult(prolongations[level], solutions[level - 1], solutions[level]));
        petsc_check(MatResidual(matrices[level], v.b, solutions[level], v.r));
      }
      gathered_shell.is_first = level == 0;
      make_cycle(level);
      gathered_shell.is_first = false;
      petsc_check(VecAXPY(solutions[level], 1, v.x));
    }
    petsc_check(MatMult(prolongations[finest], solutions[finest - 1], x));
  }

  /// The matrix as conjugate gradients see it. What is known of its kernel is not for the smoother
  /// of the finest level: PETSc would project its vectors, which are copied for that.
  void make_operator() {
    using internal::petsc_check;
    PetscInt rows = 0;
    Mat a = matrices.back();
    petsc_check(MatGetLocalSize(a, &rows, nullptr));
    petsc_check(MatCreateShell(space.communicator().get(), rows, rows, PETSC_DETERMINE,
                               PETSC_DETERMINE, a, singular.address()));
    PetscErrorCode (*const multiply)(Mat, Vec, Vec) = [](Mat shell, Vec x, Vec y) {
      void* context = nullptr;
      PetscCall(MatShellGetContext(shell, &context));
      PetscCall(MatMult(static_cast<Mat>(context), x, y));
      return PetscErrorCode(0);
    };
    petsc_check(MatShellSetOperation(singular, MATOP_MULT, reinterpret_cast<void (*)()>(multiply)));
  }

  void make_gathered_matrix() {
    using internal::petsc_check;
    const Sparse_matrix& a = cycle->matrix();
    const auto [first, last] = gathered_range();
    internal::Distributed_rows rows;
    for(std::size_t i = first; i < last; ++i) {
      for(Sparse_matrix::InnerIterator k(a, static_cast<int>(i)); k; ++k) {
        rows.columns.push_back(static_cast<PetscInt>(k.row()));
        rows.values.push_back(k.value());
      }
      rows.first.push_back(internal::petsc_int(rows.columns.size()));
    }
    matrices.front() = internal::petsc_matrix(space.communicator(), rows, last - first);
    internal::Petsc_vector v;
    petsc_check(MatCreateVecs(matrices.front(), v.address(), nullptr));
    petsc_check(
        VecScatterCreateToAll(v, gathered_shell.to_all.address(), gathered_shell.whole.address()));
    gathered_shell.cycle = cycle.get();
    gathered_shell.solution.resize(static_cast<std::size_t>(a.rows()));
  }

  Solve_report solve(const Eigen::VectorXd& load, Eigen::VectorXd& coefficients) const {
    using internal::petsc_check;
    CGAL::Real_timer timer;
    timer.start();
    const Communicator& communicator = space.communicator();
    std::vector<double> own(exchange.own_size(), 0.);
    communicator.agree([&] {
      if(load.size() != static_cast<Eigen::Index>(space.part().dimension()))
        throw Parameter_error("load", "does not fit the part of the space");
      if(!load.allFinite())
        throw Parameter_error("load", "has an entry that is not a finite number");
    });
    exchange.combine(to_vector(load), own, [](double& sum, double value) { sum += value; });
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
      petsc_check(MatCreateVecs(matrices.back(), x.address(), b.address()));
      copy(own, b);
      const bool has_guess = is_multigrid();
      if(has_guess)
        make_first_guess(b, x);
      petsc_check(KSPSetInitialGuessNonzero(solver, has_guess ? PETSC_TRUE : PETSC_FALSE));
      petsc_check(KSPSolve(solver, b, x));
      PetscInt iterations = 0;
      KSPConvergedReason reason = KSP_CONVERGED_ITERATING;
      petsc_check(KSPGetIterationNumber(solver, &iterations));
      petsc_check(KSPGetConvergedReason(solver, &reason));
      report.iterations = static_cast<int>(iterations);
      internal::Petsc_vector r;
      petsc_check(VecDuplicate(b, r.address()));
      petsc_check(MatResidual(matrices.back(), b, x, r));
      PetscReal residual = 0;
      petsc_check(VecNorm(r, NORM_2, &residual));
      report.relative_residual = residual / norm_of_load;
      report.set_status(reason > 0                         ? Solve_status::converged
                        : reason == KSP_DIVERGED_ITS       ? Solve_status::iteration_limit
                        : !(report.relative_residual <= 1) ? Solve_status::diverged
                                                           : Solve_status::stalled);
      const PetscScalar* values = nullptr;
      petsc_check(VecGetArrayRead(x, &values));
      std::copy(values, values + solution.size(), solution.begin());
      petsc_check(VecRestoreArrayRead(x, &values));
    }
    report.relative_residuals.assign(1, report.relative_residual);
    means->shift_solution(given.data(), solution.data());
    const std::vector<double> of_part = exchange.values(solution);
    coefficients = Eigen::Map<const Eigen::VectorXd>(of_part.data(),
                                                     static_cast<Eigen::Index>(of_part.size()));
    report.solve_seconds = timer.time();
    return report;
  }

  static void copy(const std::vector<double>& from, Vec to) {
    PetscScalar* values = nullptr;
    internal::petsc_check(VecGetArrayWrite(to, &values));
    std::copy(from.begin(), from.end(), values);
    internal::petsc_check(VecRestoreArrayWrite(to, &values));
  }

  /// a right-hand side that the projection reduces to this fraction is a constant
  static constexpr double projection_tolerance = 1e-13;

  const Distributed_space& space;
  Poisson_solver_options options;
  internal::Element_exchange exchange; // of the finest level
  std::unique_ptr<internal::Gathered_cycle> cycle;
  std::unique_ptr<internal::Distributed_means> means;
  std::vector<std::unique_ptr<internal::Level_smoother>> smoothers;
  std::vector<std::unique_ptr<internal::Smoother_shell>> shells;
  mutable internal::Gathered_shell gathered_shell;
  struct Level_vectors {
    internal::Petsc_vector b, x, r;
  };
  std::vector<Level_vectors> vectors; // of PETSc's levels, as the following
  // of PETSc's levels: the first is the gathered one
  std::vector<internal::Petsc_matrix> matrices, prolongations;
  internal::Petsc_matrix singular;
  internal::Petsc_null_space null_space;
  internal::Petsc_solver solver;
  double assembly_seconds = 0, setup_seconds = 0;
};

CGAL_RESTRICTED_LAPLACIAN_3_INLINE
Distributed_poisson_solver::Distributed_poisson_solver(const Distributed_space& space, double alpha,
                                                       std::optional<double> normal_stabilization,
                                                       const Poisson_solver_options& options)
  : m_impl(std::make_unique<Impl>(space, alpha, normal_stabilization, options)) {}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Distributed_poisson_solver::Distributed_poisson_solver(
    Distributed_poisson_solver&& other) noexcept = default;
CGAL_RESTRICTED_LAPLACIAN_3_INLINE
Distributed_poisson_solver::~Distributed_poisson_solver() = default;

CGAL_RESTRICTED_LAPLACIAN_3_INLINE KSP Distributed_poisson_solver::ksp() const {
  return m_impl->solver;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Mat Distributed_poisson_solver::matrix() const {
  return m_impl->matrices.back();
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE int Distributed_poisson_solver::kernel_dimension() const {
  return m_impl->means->kernel_dimension();
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Solve_report Distributed_poisson_solver::solve(
    const Eigen::VectorXd& load, Eigen::VectorXd& coefficients) const {
  return m_impl->solve(load, coefficients);
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_DISTRIBUTED_POISSON_SOLVER_IMPL_H
