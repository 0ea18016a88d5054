// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_DISTRIBUTED_POISSON_SOLVER_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_DISTRIBUTED_POISSON_SOLVER_IMPL_H

#include <CGAL/Restricted_laplacian_3/assembly/shared/assemble_system.h>
#include <CGAL/Restricted_laplacian_3/distributed/Distributed_poisson_solver.h>
#include <CGAL/Restricted_laplacian_3/distributed/internal/Distributed_components.h>
#include <CGAL/Restricted_laplacian_3/distributed/internal/Distributed_rows.h>
#include <CGAL/Restricted_laplacian_3/distributed/internal/Distributed_smoother.h>
#include <CGAL/Restricted_laplacian_3/distributed/internal/Element_exchange.h>
#include <CGAL/Restricted_laplacian_3/distributed/internal/petsc.h>
#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/problems/multigrid_levels.h>
#include <CGAL/Restricted_laplacian_3/problems/stabilization.h>
#include <CGAL/Restricted_laplacian_3/solvers/Multigrid.h>
#include <CGAL/Restricted_laplacian_3/solvers/shared/connected_components.h>
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
namespace internal {

/// The cycle of `Multigrid` that all ranks make on the levels that they hold, as PETSc sees it.
class Gathered_cycle {
public:
  /// \param matrices of the levels up to the gathered one, coarsest first, of the sheets of this
  /// rank; ranks add theirs
  Gathered_cycle(const Distributed_space& space, std::vector<Sparse_matrix> matrices,
                 const Poisson_solver_options& options)
    : m_options(options) {
    const Communicator& communicator = space.communicator();
    for(Sparse_matrix& a : matrices) {
      std::vector<double> values(a.valuePtr(), a.valuePtr() + a.nonZeros());
      communicator.sum(values);
      std::copy(values.begin(), values.end(), a.valuePtr());
    }
    m_rows = matrices.back();
    communicator.agree([&] {
      const int number = static_cast<int>(matrices.size());
      Multigrid_levels levels;
      for(int i = 1; i < number; ++i) {
        const int level = space.gathered_level() - number + i;
        levels.prolongations.push_back(prolongation_matrix(space.part(), level));
        levels.patches.push_back(smoothing_patches(space.part(), level + 1));
      }
      Sparse_matrix finest = std::move(matrices.back());
      matrices.pop_back();
      levels.coarse_matrices = std::move(matrices);
      m_multigrid = Multigrid<Patch_smoother>(std::move(finest), std::move(levels),
                                              space.part().options().is_parallel);
    });
  }

  /// the matrix of the gathered level
  const Sparse_matrix& matrix() const { return m_rows; }

  /// \param b the whole right-hand side
  /// \param is_first whether a nested iteration comes before the cycle
  void apply(const double* b, double* x, bool is_first) {
    const Eigen::Index n = m_multigrid.size();
    Block_vector<1> load = Eigen::Map<const Eigen::VectorXd>(b, n), solution, guess;
    if(is_first) {
      m_multigrid.nested_iteration<1>(load, guess, m_options.cycle, m_options.smoothing_steps,
                                      m_workspace);
      load -= m_rows * guess;
    }
    m_multigrid.apply<1>(load, solution, m_options.cycle, m_options.smoothing_steps, m_workspace);
    if(is_first)
      solution += guess;
    Eigen::Map<Eigen::VectorXd>(x, n) = solution;
  }

private:
  Poisson_solver_options m_options;
  Sparse_matrix m_rows;
  Multigrid<Patch_smoother> m_multigrid;
  Multigrid<Patch_smoother>::Workspace<1> m_workspace;
};

/// what PETSc calls on the coarsest of its levels
struct Gathered_shell {
  Gathered_cycle* cycle;
  Petsc_scatter to_all;
  Petsc_vector whole;
  std::vector<double> solution;
  bool is_first = false;

  static PetscErrorCode apply(PC pc, Vec b, Vec x) {
    void* context = nullptr;
    PetscCall(PCShellGetContext(pc, &context));
    auto& shell = *static_cast<Gathered_shell*>(context);
    PetscCall(VecScatterBegin(shell.to_all, b, shell.whole, INSERT_VALUES, SCATTER_FORWARD));
    PetscCall(VecScatterEnd(shell.to_all, b, shell.whole, INSERT_VALUES, SCATTER_FORWARD));
    const PetscScalar* values = nullptr;
    PetscCall(VecGetArrayRead(shell.whole, &values));
    shell.cycle->apply(values, shell.solution.data(), shell.is_first);
    PetscCall(VecRestoreArrayRead(shell.whole, &values));
    PetscInt first = 0, last = 0;
    PetscCall(VecGetOwnershipRange(x, &first, &last));
    PetscScalar* own = nullptr;
    PetscCall(VecGetArrayWrite(x, &own));
    std::copy(shell.solution.begin() + first, shell.solution.begin() + last, own);
    PetscCall(VecRestoreArrayWrite(x, &own));
    return 0;
  }
};

/// The smoother of a level that is divided, and the vectors that it has seen last.
class Level_smoother {
public:
  std::unique_ptr<Distributed_smoother> smoother;

  void remember(Vec b, Vec x) {
    m_b = state(b);
    m_x = state(x);
  }

  /// For PETSc: \f$b - A x\f$, by the matrix of the smoother if it has just found `x`.
  static PetscErrorCode residual(Mat a, Vec b, Vec x, Vec r) {
    PetscObject container = nullptr;
    PetscCall(PetscObjectQuery(reinterpret_cast<PetscObject>(a), name, &container));
    void* pointer = nullptr;
    if(container)
      PetscCall(PetscContainerGetPointer(reinterpret_cast<PetscContainer>(container), &pointer));
    auto* const level = static_cast<Level_smoother*>(pointer);
    if(!level || level->m_b != state(b) || level->m_x != state(x)) {
      PetscCall(MatResidual(a, b, x, r));
      return 0;
    }
    PetscScalar* values = nullptr;
    PetscCall(VecGetArrayWrite(r, &values));
    level->smoother->residual(values);
    PetscCall(VecRestoreArrayWrite(r, &values));
    return 0;
  }

  /// lets `residual()` find this object, which must live as long as the matrix
  PetscErrorCode attach_to(Mat a) {
    PetscContainer container = nullptr;
    PetscCall(PetscContainerCreate(PetscObjectComm(reinterpret_cast<PetscObject>(a)), &container));
    PetscCall(PetscContainerSetPointer(container, this));
    PetscCall(PetscObjectCompose(reinterpret_cast<PetscObject>(a), name,
                                 reinterpret_cast<PetscObject>(container)));
    PetscCall(PetscContainerDestroy(&container));
    return 0;
  }

private:
  static constexpr const char* name = "Restricted_laplacian_3_smoother";
  /// which vector, and how often it has changed
  using State = std::pair<PetscObjectId, PetscObjectState>;

  static State state(Vec v) {
    State result = {0, 0};
    PetscObjectGetId(reinterpret_cast<PetscObject>(v), &result.first);
    PetscObjectStateGet(reinterpret_cast<PetscObject>(v), &result.second);
    return result;
  }

  State m_b = {0, 0}, m_x = {0, 0};
};

/// what PETSc calls to smooth on a level that is divided
struct Smoother_shell {
  Level_smoother* level;
  bool is_reversed;

  static PetscErrorCode sweep(PC pc, Vec b, Vec x, PetscInt steps, bool is_zero) {
    void* context = nullptr;
    PetscCall(PCShellGetContext(pc, &context));
    auto& shell = *static_cast<Smoother_shell*>(context);
    const PetscScalar* load = nullptr;
    PetscScalar* solution = nullptr;
    PetscCall(VecGetArrayRead(b, &load));
    PetscCall(VecGetArray(x, &solution));
    for(PetscInt step = 0; step < steps; ++step)
      shell.level->smoother->smooth(load, solution, shell.is_reversed, is_zero && step == 0);
    PetscCall(VecRestoreArray(x, &solution));
    PetscCall(VecRestoreArrayRead(b, &load));
    shell.level->remember(b, x);
    return 0;
  }

  static PetscErrorCode apply(PC pc, Vec b, Vec x) { return sweep(pc, b, x, 1, true); }

  static PetscErrorCode apply_richardson(PC pc, Vec b, Vec x, Vec, PetscReal, PetscReal, PetscReal,
                                         PetscInt steps, PetscBool is_zero, PetscInt* done,
                                         PCRichardsonConvergedReason* reason) {
    PetscCall(sweep(pc, b, x, steps, is_zero == PETSC_TRUE));
    *done = steps;
    *reason = PCRICHARDSON_CONVERGED_ITS;
    return 0;
  }
};

/// Means on the components of a surface that is divided among ranks, as `Mean_projection` has them.
class Distributed_means {
public:
  /// \param integrals,constant_loads of the elements that this rank owns
  Distributed_means(const Distributed_space& space, const Element_exchange& exchange,
                    const Distributed_rows& rows, std::vector<double> integrals,
                    const std::vector<double>& constant_loads)
    : m_communicator(space.communicator()), m_components(space, exchange),
      m_measures(std::move(integrals)) {
    const std::size_t number = m_components.number;
    std::vector<double> loads(number, 0.);
    for(std::size_t i = 0; i < m_measures.size(); ++i)
      loads[component(i)] += constant_loads[i];
    m_communicator.sum(loads);
    std::vector<double> largest_defect(number, 0.), largest_diagonal(number, 0.);
    m_sums.assign(number, 0.);
    m_sizes.assign(number, 0.);
    for(std::size_t i = 0; i < m_measures.size(); ++i) {
      const std::size_t c = component(i);
      m_is_screened.resize(number);
      if(loads[c] > 0)
        m_measures[i] = constant_loads[i];
      m_sums[c] += m_measures[i];
      m_sizes[c] += 1;
      double defect = -constant_loads[i];
      for(PetscInt k = rows.first[i]; k < rows.first[i + 1]; ++k) {
        defect += rows.values[k];
        if(static_cast<std::uint64_t>(rows.columns[k]) == exchange.first() + i)
          largest_diagonal[c] = (std::max)(largest_diagonal[c], std::abs(rows.values[k]));
      }
      largest_defect[c] = (std::max)(largest_defect[c], std::abs(defect));
    }
    m_communicator.sum(m_sums);
    m_communicator.sum(m_sizes);
    largest_over_ranks(largest_defect);
    largest_over_ranks(largest_diagonal);
    m_is_screened.assign(number, 0);
    for(std::size_t c = 0; c < number; ++c) {
      m_is_screened[c] = loads[c] > 0;
      m_is_split_off.push_back(m_sums[c] > 0 && largest_diagonal[c] > 0 &&
                               largest_defect[c] <= row_sum_tolerance * largest_diagonal[c]);
      m_has_kernel.push_back(m_is_split_off[c] && !m_is_screened[c]);
    }
  }

  int kernel_dimension() const {
    return static_cast<int>(std::count(m_has_kernel.begin(), m_has_kernel.end(), 1));
  }

  /// see `Mean_projection::project_load()`
  void project_load(double* b) const {
    const std::vector<double> means = this->means([&](std::size_t i) { return b[i]; });
    for(std::size_t i = 0; i < m_measures.size(); ++i)
      b[i] -= m_measures[i] * means[component(i)];
  }

  /// see `Mean_projection::shift_solution()`
  void shift_solution(const double* b, double* x) const {
    std::vector<double> shifts = this->means([&](std::size_t i) { return -m_measures[i] * x[i]; });
    const std::vector<double> loads = this->means([&](std::size_t i) { return b[i]; });
    for(std::size_t c = 0; c < shifts.size(); ++c)
      if(m_is_screened[c])
        shifts[c] += loads[c];
    for(std::size_t i = 0; i < m_measures.size(); ++i)
      x[i] += shifts[component(i)];
  }

  /// for PETSc: makes a vector orthogonal to the kernel
  static PetscErrorCode remove_kernel(MatNullSpace, Vec v, void* context) {
    const auto& means = *static_cast<const Distributed_means*>(context);
    PetscScalar* values = nullptr;
    PetscCall(VecGetArray(v, &values));
    std::vector<double> sums(means.m_components.number, 0.);
    for(std::size_t i = 0; i < means.m_measures.size(); ++i)
      sums[means.component(i)] += values[i];
    means.m_communicator.sum(sums);
    for(std::size_t c = 0; c < sums.size(); ++c)
      sums[c] = means.m_has_kernel[c] ? sums[c] / means.m_sizes[c] : 0;
    for(std::size_t i = 0; i < means.m_measures.size(); ++i)
      values[i] -= sums[means.component(i)];
    PetscCall(VecRestoreArray(v, &values));
    return 0;
  }

private:
  std::size_t component(std::size_t i) const { return m_components.of_element[i]; }

  template <class Value> std::vector<double> means(Value&& value) const {
    std::vector<double> result(m_components.number, 0.);
    for(std::size_t i = 0; i < m_measures.size(); ++i)
      result[component(i)] += value(i);
    m_communicator.sum(result);
    for(std::size_t c = 0; c < result.size(); ++c)
      result[c] *= m_is_split_off[c] ? 1 / m_sums[c] : 0.;
    return result;
  }

  void largest_over_ranks(std::vector<double>& values) const {
    MPI_Allreduce(MPI_IN_PLACE, values.data(), static_cast<int>(values.size()), MPI_DOUBLE, MPI_MAX,
                  m_communicator.get());
  }

  Communicator m_communicator;
  Distributed_components m_components;
  std::vector<double> m_measures, m_sums, m_sizes;
  std::vector<char> m_is_screened, m_is_split_off, m_has_kernel;
};

} // namespace internal

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
      coarsest = coarsest_level();
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
          i > 1 ? coarse_size : gathered_range().second - gathered_range().first);
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

  /// the first of the gathered levels whose direct solution takes time that counts, see
  /// `coarsest_multigrid_level()`
  int coarsest_level() const {
    constexpr double largest_dense_dimension = 300;
    const double components = static_cast<double>(space.number_of_sheets(0));
    int level = 0;
    while(level < space.gathered_level() && static_cast<double>(space.dimension(level + 1)) <=
                                                largest_dense_dimension * std::sqrt(components))
      ++level;
    return level;
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
  int coarsest = 0;
  std::size_t coarse_size = 0;
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
