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
#include <CGAL/Restricted_laplacian_3/solvers/Multigrid_solver.h>
#include <CGAL/Restricted_laplacian_3/splines/prolongation.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <exception>
#include <memory>
#include <tuple>
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
      for(Petsc_vector* v : {&l.b, &l.r})
        petsc_check(MatCreateVecs(l.matrix, v->address(), nullptr));
    for(std::size_t level = 0; level < m_levels.size(); ++level)
      m_levels[level].cycle = {this, level};
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
        // PETSc would begin the second visit of a W-cycle anew; it begins the first one with 0.
        if(m_options.cycle == Cycle::W && i + 1 < number)
          petsc_check(KSPSetInitialGuessNonzero(level, PETSC_TRUE));
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

  /// Makes of a preconditioner of the matrix of a level the same cycle for eigensolvers: PETSc has
  /// it for many vectors at once, which are relaxed side by side.
  void configure_for_many(PC pc, std::size_t level) {
    petsc_check(PCSetType(pc, PCSHELL));
    petsc_check(PCShellSetContext(pc, &m_levels[level].cycle));
    petsc_check(PCShellSetApply(pc, Cycle_shell::apply));
    petsc_check(PCShellSetMatApply(pc, Cycle_shell::apply_to_columns));
    petsc_check(PCShellSetName(pc, "a cycle for several vectors at once"));
  }

  /// throws what a cycle has thrown within a function of PETSc, if one has
  void rethrow() {
    if(m_error)
      std::rethrow_exception(std::exchange(m_error, nullptr));
  }

  /// The first guess by nested iteration, as that of `Multigrid`: the solution of each level is
  /// prolongated to the next, and improved by one cycle there, except on the finest.
  void make_first_guess(Vec b, Vec x) {
    petsc_check(VecCopy(b, m_levels.back().b));
    for(std::size_t level = finest(); level > 0; --level)
      petsc_check(MatMultTranspose(prolongation(level), m_levels[level].b, m_levels[level - 1].b));
    std::vector<Petsc_vector> solutions(finest());
    for(std::size_t level = 0; level < finest(); ++level) {
      const Level& l = m_levels[level];
      petsc_check(VecDuplicate(l.b, solutions[level].address()));
      if(level == 0) {
        petsc_check(VecSet(solutions[0], 0));
        petsc_check(VecCopy(l.b, l.r));
      } else {
        petsc_check(MatMult(prolongation(level), solutions[level - 1], solutions[level]));
        petsc_check(MatResidual(matrix(level), l.b, solutions[level], l.r));
      }
      m_gathered.is_first = level == 0;
      const double* const correction = make_cycle<1>(level, values_of(l.r).data());
      m_gathered.is_first = false;
      PetscScalar* solution = nullptr;
      petsc_check(VecGetArray(solutions[level], &solution));
      for(std::size_t i = 0; i < own_size(level); ++i)
        solution[i] += correction[i];
      petsc_check(VecRestoreArray(solutions[level], &solution));
    }
    petsc_check(MatMult(prolongation(finest()), solutions.back(), x));
  }

private:
  /// `K` vectors of a level: the entries on this rank, vector by vector, and PETSc's view of them.
  template <int K> struct Block {
    std::vector<double> values;
    Petsc_matrix matrix;

    void allocate(MPI_Comm communicator, std::size_t size) {
      if(matrix)
        return;
      values.resize(K * size);
      petsc_check(MatCreateDense(communicator, petsc_int(size), PETSC_DECIDE, PETSC_DETERMINE, K,
                                 values.data(), matrix.address()));
    }
  };
  /// of a cycle for `K` vectors on a level
  template <int K> struct Workspace {
    Block<K> x, r;
    std::vector<double> residual;
    Petsc_matrix restricted, prolongated; // of r, and of the solution of the next coarser level
  };

  /// what PETSc calls to make a cycle on a level
  struct Cycle_shell {
    Distributed_multigrid* multigrid = nullptr;
    std::size_t level = 0;

    static PetscErrorCode apply(PC pc, Vec b, Vec x) {
      void* context = nullptr;
      PetscCall(PCShellGetContext(pc, &context));
      return with_entries(b, x, [context](const PetscScalar* load, PetscScalar* solution) {
        return static_cast<Cycle_shell*>(context)->make<1>(load, 0, solution, 0, 1);
      });
    }

    static PetscErrorCode apply_to_columns(PC pc, Mat b, Mat x) {
      void* context = nullptr;
      PetscCall(PCShellGetContext(pc, &context));
      PetscInt columns = 0, stride_of_b = 0, stride_of_x = 0;
      const PetscScalar* load = nullptr;
      PetscScalar* solution = nullptr;
      PetscCall(MatGetSize(b, nullptr, &columns));
      PetscCall(MatDenseGetLDA(b, &stride_of_b));
      PetscCall(MatDenseGetLDA(x, &stride_of_x));
      PetscCall(MatDenseGetArrayRead(b, &load));
      PetscCall(MatDenseGetArrayWrite(x, &solution));
      for(PetscInt c = 0; c < columns; c += vectors_of_a_block)
        PetscCall(static_cast<Cycle_shell*>(context)->make<vectors_of_a_block>(
            load + c * stride_of_b, stride_of_b, solution + c * stride_of_x, stride_of_x,
            (std::min)(static_cast<PetscInt>(vectors_of_a_block), columns - c)));
      PetscCall(MatDenseRestoreArrayWrite(x, &solution));
      PetscCall(MatDenseRestoreArrayRead(b, &load));
      return 0;
    }

  private:
    /// for the first columns of a block
    template <int K>
    PetscErrorCode make(const PetscScalar* b, PetscInt stride_of_b, PetscScalar* x,
                        PetscInt stride_of_x, PetscInt columns) {
      try { // no exceptions through functions of C
        const auto size = static_cast<std::ptrdiff_t>(multigrid->own_size(level));
        std::vector<double> load(static_cast<std::size_t>(K * size), 0.);
        for(PetscInt c = 0; c < columns; ++c)
          std::copy_n(b + c * stride_of_b, size, load.data() + c * size);
        const double* const solution = multigrid->make_cycle<K>(level, load.data());
        for(PetscInt c = 0; c < columns; ++c)
          std::copy_n(solution + c * size, size, x + c * stride_of_x);
        return 0;
      } catch(...) {
        multigrid->m_error = std::current_exception();
        return PETSC_ERR_USER;
      }
    }
  };

  struct Level {
    Petsc_matrix matrix, prolongation;
    Petsc_vector b, r;
    std::unique_ptr<Element_exchange> exchange;
    std::unique_ptr<Level_smoother> smoother;
    std::array<Smoother_shell, 2> shells = {};
    Cycle_shell cycle;
    std::tuple<Workspace<1>, Workspace<vectors_of_a_block>> workspaces;
  };

  /// how many entries of a vector of a level are on this rank
  std::size_t own_size(std::size_t level) const { return range(level)[1] - range(level)[0]; }

  /// One cycle on a level that starts from 0, for `K` vectors, 1 or 8, as that of `PCMG`.
  /// \param b the right-hand sides: their entries on this rank, vector by vector
  /// \return the solutions, until the next cycle on this level
  template <int K> const double* make_cycle(std::size_t level, const double* b) {
    Level& l = m_levels[level];
    auto& w = std::get<Workspace<K>>(l.workspaces);
    const std::size_t size = own_size(level);
    w.x.allocate(m_space.communicator().get(), size);
    double* const x = w.x.values.data();
    if(level == 0) {
      petsc_check(m_gathered.solve<K>(b, x));
      return x;
    }
    w.r.allocate(m_space.communicator().get(), size);
    Distributed_smoother& smoother = *l.smoother->smoother;
    for(int step = 0; step < m_options.smoothing_steps; ++step)
      smoother.smooth<K>(b, x, false, step == 0);
    smoother.residual<K>(w.r.values.data());
    petsc_check(MatTransposeMatMult(l.prolongation, w.r.matrix,
                                    w.restricted ? MAT_REUSE_MATRIX : MAT_INITIAL_MATRIX,
                                    PETSC_DEFAULT, w.restricted.address()));
    const PetscScalar* load = nullptr;
    petsc_check(MatDenseGetArrayRead(w.restricted, &load));
    make_cycle<K>(level - 1, load);
    add_coarse<K>(level);
    if(m_options.cycle == Cycle::W && level > 1) {
      // The second visit corrects what the first one left.
      w.residual.resize(K * own_size(level - 1));
      m_levels[level - 1].smoother->smoother->template residual<K>(w.residual.data());
      make_cycle<K>(level - 1, w.residual.data());
      add_coarse<K>(level);
    }
    petsc_check(MatDenseRestoreArrayRead(w.restricted, &load));
    for(int step = 0; step < m_options.smoothing_steps; ++step)
      smoother.smooth<K>(b, x, true, false);
    return x;
  }

  /// adds the solution of the next coarser level
  template <int K> void add_coarse(std::size_t level) {
    Level& l = m_levels[level];
    auto& w = std::get<Workspace<K>>(l.workspaces);
    const auto& coarse = std::get<Workspace<K>>(m_levels[level - 1].workspaces);
    petsc_check(MatMatMult(l.prolongation, coarse.x.matrix,
                           w.prolongated ? MAT_REUSE_MATRIX : MAT_INITIAL_MATRIX, PETSC_DEFAULT,
                           w.prolongated.address()));
    const PetscScalar* values = nullptr;
    petsc_check(MatDenseGetArrayRead(w.prolongated, &values));
    for(std::size_t i = 0; i < w.x.values.size(); ++i)
      w.x.values[i] += values[i];
    petsc_check(MatDenseRestoreArrayRead(w.prolongated, &values));
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
    m_gathered.own = std::move(v);
    m_gathered.first = first;
    m_gathered.size = last - first;
  }

  const Distributed_space& m_space;
  Poisson_solver_options m_options;
  Gathered_shell m_gathered;
  std::vector<Level> m_levels; // of PETSc
  std::exception_ptr m_error;
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_INTERNAL_DISTRIBUTED_MULTIGRID_H
