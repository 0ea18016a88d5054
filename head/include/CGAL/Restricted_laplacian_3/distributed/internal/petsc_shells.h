// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_INTERNAL_PETSC_SHELLS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_INTERNAL_PETSC_SHELLS_H

#include <CGAL/Restricted_laplacian_3/distributed/Communicator.h>
#include <CGAL/Restricted_laplacian_3/distributed/Distributed_space.h>
#include <CGAL/Restricted_laplacian_3/distributed/internal/Distributed_smoother.h>
#include <CGAL/Restricted_laplacian_3/distributed/internal/petsc.h>
#include <CGAL/Restricted_laplacian_3/foundation/Sparse_matrix.h>
#include <CGAL/Restricted_laplacian_3/problems/multigrid_levels.h>
#include <CGAL/Restricted_laplacian_3/solvers/Multigrid.h>
#include <CGAL/Restricted_laplacian_3/solvers/Multigrid_solver.h>
#include <CGAL/Restricted_laplacian_3/splines/prolongation.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <tuple>
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
    m_matrix = matrices.back();
    communicator.agree([&] {
      const int number = static_cast<int>(matrices.size());
      Multigrid_levels levels;
      for(int i = 1; i < number; ++i) {
        const int level = space.gathered_level() - number + i;
        levels.prolongations.push_back(prolongation_matrix(space.part(), level));
        levels.patches.push_back(smoothing_patches(space.part(), level + 1));
      }
      Sparse_matrix finest;
      finest.swap(matrices.back());
      matrices.pop_back();
      levels.coarse_matrices = std::move(matrices);
      m_multigrid = Multigrid<Patch_smoother>(std::move(finest), std::move(levels),
                                              space.part().options().is_parallel, false, true);
    });
  }

  /// the matrix of the gathered level
  const Sparse_matrix& matrix() const { return m_matrix; }

  /// One cycle for `K` vectors, 1 or 8.
  /// \param b the whole right-hand sides
  /// \param is_first whether a nested iteration comes before the cycle
  template <int K> void apply(const Block_vector<K>& b, Block_vector<K>& x, bool is_first = false) {
    auto& workspace = std::get<Workspace<K>>(m_workspaces);
    if(!is_first)
      return m_multigrid.apply<K>(b, x, m_options.cycle, m_options.smoothing_steps, workspace);
    Block_vector<K> guess, residual;
    m_multigrid.nested_iteration<K>(b, guess, m_options.cycle, m_options.smoothing_steps,
                                    workspace);
    residual = b - m_matrix * guess;
    m_multigrid.apply<K>(residual, x, m_options.cycle, m_options.smoothing_steps, workspace);
    x += guess;
  }

private:
  Poisson_solver_options m_options;
  Sparse_matrix m_matrix;
  template <int K> using Workspace = Multigrid<Patch_smoother>::Workspace<K>;
  Multigrid<Patch_smoother> m_multigrid;
  std::tuple<Workspace<1>, Workspace<vectors_of_a_block>> m_workspaces;
};

/// what PETSc calls on the coarsest of its levels
struct Gathered_shell {
  std::unique_ptr<Gathered_cycle> cycle;
  Petsc_scatter to_all;
  Petsc_vector own, whole;
  std::size_t first = 0, size = 0; // entries of vectors on this rank
  bool is_first = false;

  /// One cycle for `K` vectors, 1 or 8: their entries on this rank, vector by vector.
  template <int K> PetscErrorCode solve(const double* b, double* x) {
    PetscInt n = 0;
    PetscCall(VecGetSize(own, &n));
    Block_vector<K> load(n, K), solution;
    for(int c = 0; c < K; ++c) {
      PetscCall(VecPlaceArray(own, b + c * size));
      PetscCall(VecScatterBegin(to_all, own, whole, INSERT_VALUES, SCATTER_FORWARD));
      PetscCall(VecScatterEnd(to_all, own, whole, INSERT_VALUES, SCATTER_FORWARD));
      PetscCall(VecResetArray(own));
      const PetscScalar* values = nullptr;
      PetscCall(VecGetArrayRead(whole, &values));
      load.col(c) = Eigen::Map<const Eigen::VectorXd>(values, n);
      PetscCall(VecRestoreArrayRead(whole, &values));
    }
    cycle->apply<K>(load, solution, is_first);
    for(int c = 0; c < K; ++c)
      for(std::size_t i = 0; i < size; ++i)
        x[c * size + i] = solution(static_cast<Eigen::Index>(first + i), c);
    return 0;
  }

  static PetscErrorCode apply(PC pc, Vec b, Vec x) {
    void* context = nullptr;
    PetscCall(PCShellGetContext(pc, &context));
    return with_entries(b, x, [context](const PetscScalar* load, PetscScalar* solution) {
      return static_cast<Gathered_shell*>(context)->solve<1>(load, solution);
    });
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
    level->smoother->residual<1>(values);
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
  Level_smoother* level = nullptr;
  bool is_reversed = false;

  static PetscErrorCode sweep(PC pc, Vec b, Vec x, PetscInt steps, bool is_zero) {
    void* context = nullptr;
    PetscCall(PCShellGetContext(pc, &context));
    auto& shell = *static_cast<Smoother_shell*>(context);
    const PetscScalar* load = nullptr;
    PetscScalar* solution = nullptr;
    PetscCall(VecGetArrayRead(b, &load));
    PetscCall(VecGetArray(x, &solution));
    for(PetscInt step = 0; step < steps; ++step)
      shell.level->smoother->smooth<1>(load, solution, shell.is_reversed, is_zero && step == 0);
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

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_INTERNAL_PETSC_SHELLS_H
