// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_INTERNAL_DISTRIBUTED_MULTIGRID_H
#define CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_INTERNAL_DISTRIBUTED_MULTIGRID_H

#include <CGAL/Restricted_laplacian_3/distributed/Communicator.h>
#include <CGAL/Restricted_laplacian_3/distributed/Distributed_space.h>
#include <CGAL/Restricted_laplacian_3/distributed/internal/Distributed_rows.h>
#include <CGAL/Restricted_laplacian_3/distributed/internal/Distributed_smoother.h>
#include <CGAL/Restricted_laplacian_3/distributed/internal/Element_exchange.h>
#include <CGAL/Restricted_laplacian_3/distributed/internal/petsc.h>
#include <CGAL/Restricted_laplacian_3/distributed/internal/petsc_shells.h>
#include <CGAL/Restricted_laplacian_3/foundation/Sparse_matrix.h>
#include <CGAL/Restricted_laplacian_3/solvers/Poisson_solver.h>
#include <CGAL/Restricted_laplacian_3/splines/prolongation.h>

#include <array>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// The hierarchy of a matrix on a space that is divided among ranks: the matrices, prolongations
/// and smoothers of its levels, of which `PCMG` makes its cycles. Level 0 of PETSc is the one that
/// all ranks hold, `Distributed_space::gathered_level()`.
class Distributed_multigrid {
public:
  /// \param space must outlive this object
  /// \param matrices of the levels from one that all ranks hold to depth, symmetric, of the sheets
  /// of this rank; ranks add theirs
  /// \param options cycle and smoothing steps
  Distributed_multigrid(const Distributed_space& space, std::vector<Sparse_matrix> matrices,
                        const Poisson_solver_options& options)
    : m_space(space), m_options(options) {
    const Communicator& communicator = space.communicator();
    const int gathered = space.gathered_level();
    const std::size_t number = static_cast<std::size_t>(space.depth() - gathered) + 1;
    std::vector<Sparse_matrix> whole(matrices.size() + 1 - number);
    for(std::size_t i = 0; i < whole.size(); ++i)
      whole[i].swap(matrices[i]);
    m_gathered.cycle = std::make_unique<Gathered_cycle>(space, std::move(whole), options);
    make_gathered_matrix();
    // entries of vectors of the next coarser level on this rank
    std::size_t coarse_size = range(0)[1] - range(0)[0];
    for(std::size_t i = 1; i < number; ++i) {
      const int level = gathered + static_cast<int>(i);
      const Distributed_level& of_level = space.level(level);
      m_levels.emplace_back();
      Level& l = m_levels.back();
      l.exchange = std::make_unique<Element_exchange>(communicator, of_level.first_elements,
                                                      of_level.elements);
      Sparse_matrix a;
      a.swap(matrices[matrices.size() - number + i]);
      Distributed_rows rows = sum_of_matrices(communicator, *l.exchange, of_level.elements, a);
      Sparse_matrix().swap(a);
      l.smoother = std::make_unique<Level_smoother>();
      l.smoother->smoother = std::make_unique<Distributed_smoother>(space, level, rows);
      l.matrix = petsc_matrix(communicator, std::move(rows), l.exchange->own_size());
      petsc_check(l.smoother->attach_to(l.matrix));
      Sparse_matrix p;
      communicator.agree([&] { p = prolongation_matrix(space.part(), level - 1); });
      l.prolongation = petsc_matrix(communicator,
                                    rows_of_owner(communicator, *l.exchange, of_level.elements,
                                                  space.level(level - 1).elements, p),
                                    coarse_size);
      coarse_size = l.exchange->own_size();
      l.shells = {Smoother_shell{l.smoother.get(), false}, Smoother_shell{l.smoother.get(), true}};
    }
    for(Level& l : m_levels)
      for(Petsc_vector* v : {&l.b, &l.x, &l.r})
        petsc_check(MatCreateVecs(l.matrix, v->address(), nullptr));
  }

  Distributed_multigrid(const Distributed_multigrid&) = delete;
  Distributed_multigrid& operator=(const Distributed_multigrid&) = delete;

  /// the number of the finest level
  std::size_t finest() const { return m_levels.size() - 1; }
  /// the matrix of a level
  Mat matrix(std::size_t level) const { return m_levels[level].matrix; }
  /// from the next coarser level
  Mat prolongation(std::size_t level) const { return m_levels[level].prolongation; }
  /// \param level not 0
  const Element_exchange& exchange(std::size_t level) const { return *m_levels[level].exchange; }

  /// Which elements of a level have their entries of vectors on this rank: a half-open range.
  std::array<std::size_t, 2> range(std::size_t level) const {
    if(level > 0) {
      const auto first = static_cast<std::size_t>(exchange(level).first());
      return {first, first + exchange(level).own_size()};
    }
    const auto n = static_cast<std::size_t>(m_space.dimension(m_space.gathered_level()));
    const auto ranks = static_cast<std::size_t>(m_space.communicator().size()),
               rank = static_cast<std::size_t>(m_space.communicator().rank());
    return {n * rank / ranks, n * (rank + 1) / ranks};
  }

  /// Makes a `PCMG` of a preconditioner of the matrix of level `finest`. This object must outlive
  /// it.
  void configure(PC pc, std::size_t finest) {
    const auto number = static_cast<PetscInt>(finest) + 1;
    petsc_check(PCSetType(pc, PCMG));
    petsc_check(PCMGSetLevels(pc, number, nullptr));
    petsc_check(PCMGSetType(pc, PC_MG_MULTIPLICATIVE));
    petsc_check(PCMGSetCycleType(pc, m_options.cycle == Cycle::V ? PC_MG_CYCLE_V : PC_MG_CYCLE_W));
    petsc_check(PCMGSetGalerkin(pc, PC_MG_GALERKIN_NONE));
    for(PetscInt i = 1; i < number; ++i) {
      Level& l = m_levels[static_cast<std::size_t>(i)];
      petsc_check(PCMGSetInterpolation(pc, i, l.prolongation));
      for(Smoother_shell& shell : l.shells) {
        KSP level = nullptr;
        petsc_check(shell.is_reversed ? PCMGGetSmootherUp(pc, i, &level)
                                      : PCMGGetSmootherDown(pc, i, &level));
        petsc_check(KSPSetType(level, KSPRICHARDSON));
        petsc_check(KSPSetNormType(level, KSP_NORM_NONE));
        petsc_check(KSPSetTolerances(level, PETSC_DEFAULT, PETSC_DEFAULT, PETSC_DEFAULT,
                                     m_options.smoothing_steps));
        petsc_check(KSPSetOperators(level, l.matrix, l.matrix));
        PC smoother = nullptr;
        petsc_check(KSPGetPC(level, &smoother));
        petsc_check(PCSetType(smoother, PCSHELL));
        petsc_check(PCShellSetContext(smoother, &shell));
        petsc_check(PCShellSetApply(smoother, Smoother_shell::apply));
        petsc_check(PCShellSetApplyRichardson(smoother, Smoother_shell::apply_richardson));
        petsc_check(PCShellSetName(smoother, "cell patches, color by color"));
      }
    }
    KSP coarse = nullptr;
    petsc_check(PCMGGetCoarseSolve(pc, &coarse));
    petsc_check(KSPSetType(coarse, KSPPREONLY));
    petsc_check(KSPSetOperators(coarse, matrix(0), matrix(0)));
    PC coarse_pc = nullptr;
    petsc_check(KSPGetPC(coarse, &coarse_pc));
    petsc_check(PCSetType(coarse_pc, PCSHELL));
    petsc_check(PCShellSetContext(coarse_pc, &m_gathered));
    petsc_check(PCShellSetApply(coarse_pc, Gathered_shell::apply));
    petsc_check(PCShellSetName(coarse_pc, "a cycle that each rank makes"));
  }

  /// To be called when the preconditioner has been set up, which sets the residual of the finest
  /// level.
  void set_residuals(PC pc, std::size_t finest) const {
    for(std::size_t i = 1; i <= finest; ++i)
      petsc_check(PCMGSetResidual(pc, static_cast<PetscInt>(i), Level_smoother::residual,
                                  m_levels[i].matrix));
  }

  /// The first guess by nested iteration, as that of `Multigrid`: the solution of each level is
  /// prolongated to the next, and improved by one cycle there, except on the finest.
  void make_first_guess(PC pc, Vec b, Vec x) {
    petsc_check(VecCopy(b, m_levels.back().b));
    for(std::size_t level = finest(); level > 0; --level)
      petsc_check(MatMultTranspose(prolongation(level), m_levels[level].b, m_levels[level - 1].b));
    std::vector<Petsc_vector> solutions(finest());
    for(std::size_t level = 0; level < finest(); ++level) {
      const Level& l = m_levels[level];
      petsc_check(VecDuplicate(l.x, solutions[level].address()));
      if(level == 0) {
        petsc_check(VecSet(solutions[0], 0));
        petsc_check(VecCopy(l.b, l.r));
      } else {
        petsc_check(MatMult(prolongation(level), solutions[level - 1], solutions[level]));
        petsc_check(MatResidual(matrix(level), l.b, solutions[level], l.r));
      }
      m_gathered.is_first = level == 0;
      make_cycle(pc, level);
      m_gathered.is_first = false;
      petsc_check(VecAXPY(solutions[level], 1, l.x));
    }
    petsc_check(MatMult(prolongation(finest()), solutions.back(), x));
  }

private:
  struct Level {
    Petsc_matrix matrix, prolongation;
    Petsc_vector b, x, r;
    std::unique_ptr<Element_exchange> exchange;
    std::unique_ptr<Level_smoother> smoother;
    std::array<Smoother_shell, 2> shells = {};
  };

  /// PETSc's solver on a level, before or after the coarse correction
  static KSP level_solver(PC pc, std::size_t level, bool is_up) {
    KSP result = nullptr;
    const auto i = static_cast<PetscInt>(level);
    petsc_check(level == 0 ? PCMGGetCoarseSolve(pc, &result)
                : is_up    ? PCMGGetSmootherUp(pc, i, &result)
                           : PCMGGetSmootherDown(pc, i, &result));
    return result;
  }

  /// One cycle on a level that starts from 0, for the vector `r` of the level; the correction is in
  /// `x` on return.
  void make_cycle(PC pc, std::size_t level) const {
    const Level& l = m_levels[level];
    if(level == 0)
      return petsc_check(KSPSolve(level_solver(pc, 0, false), l.r, l.x));
    const Level& coarse = m_levels[level - 1];
    Petsc_vector b;
    petsc_check(VecDuplicate(l.r, b.address()));
    petsc_check(VecCopy(l.r, b));
    petsc_check(VecSet(l.x, 0));
    petsc_check(KSPSetInitialGuessNonzero(level_solver(pc, level, false), PETSC_FALSE));
    petsc_check(KSPSolve(level_solver(pc, level, false), b, l.x));
    petsc_check(Level_smoother::residual(l.matrix, b, l.x, l.r));
    petsc_check(MatMultTranspose(l.prolongation, l.r, coarse.r));
    make_cycle(pc, level - 1);
    petsc_check(MatMultAdd(l.prolongation, coarse.x, l.x, l.x));
    petsc_check(KSPSetInitialGuessNonzero(level_solver(pc, level, true), PETSC_TRUE));
    petsc_check(KSPSolve(level_solver(pc, level, true), b, l.x));
  }

  void make_gathered_matrix() {
    const Sparse_matrix& a = m_gathered.cycle->matrix();
    const auto [first, last] = range(0);
    Distributed_rows rows;
    for(std::size_t i = first; i < last; ++i) {
      for(Sparse_matrix::InnerIterator k(a, static_cast<int>(i)); k; ++k) {
        rows.columns.push_back(static_cast<PetscInt>(k.row()));
        rows.values.push_back(k.value());
      }
      rows.first.push_back(petsc_int(rows.columns.size()));
    }
    m_levels.emplace_back();
    m_levels.back().matrix = petsc_matrix(m_space.communicator(), std::move(rows), last - first);
    Petsc_vector v;
    petsc_check(MatCreateVecs(matrix(0), v.address(), nullptr));
    petsc_check(VecScatterCreateToAll(v, m_gathered.to_all.address(), m_gathered.whole.address()));
    m_gathered.solution.resize(static_cast<std::size_t>(a.rows()));
  }

  const Distributed_space& m_space;
  Poisson_solver_options m_options;
  Gathered_shell m_gathered;
  std::vector<Level> m_levels; // of PETSc
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_INTERNAL_DISTRIBUTED_MULTIGRID_H
