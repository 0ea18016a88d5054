// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_DISTRIBUTED_POISSON_SOLVER_H
#define CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_DISTRIBUTED_POISSON_SOLVER_H

#include <CGAL/Restricted_laplacian_3/distributed/Distributed_space.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>
#include <CGAL/Restricted_laplacian_3/solvers/Multigrid_solver.h>
#include <CGAL/Restricted_laplacian_3/solvers/Solve_report.h>

#include <Eigen/Core>

#include <petscksp.h>

#include <memory>
#include <optional>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Distributed A solver for \f$(S + \alpha M)\, \eta = b\f$ on a
/// space whose parts are on several ranks: PETSc's conjugate gradients and its multigrid `PCMG`,
/// with the matrices, prolongations and smoothing patches of this package. It takes the same steps
/// whatever the number of ranks.
///
/// The matrix of each level is a `MATAIJ`. On levels that are divided the patches are relaxed color
/// by color, on all ranks at the same time, in single precision, as by `Patch_smoother`; where all
/// ranks hold the whole, each makes a cycle of `Multigrid` of its own.
///
/// PETSc must be initialized. Its options apply: `-ksp_monitor`, `-log_view`,
/// `-mg_levels_pc_type sor`, or `-pc_type gamg` for another preconditioner of the same matrix.
class Distributed_poisson_solver {
public:
  /// Assembles and sets up.
  /// \param space must outlive this object
  /// \param alpha \f$\alpha \ge 0\f$, in units of 1 / area
  /// \param stabilization as for `assemble_operators()`; without a value
  /// `default_stabilization()`
  /// \param options tolerance, largest number of iterations, cycle and smoothing steps; what else
  /// they contain has no effect
  /// \throws Distributed_error on all ranks if a parameter is wrong, or memory is not enough
  Distributed_poisson_solver(const Distributed_space& space, double alpha = 0,
                             std::optional<double> stabilization = {},
                             const Poisson_solver_options& options = Poisson_solver_options());
  /// moves the solver
  Distributed_poisson_solver(Distributed_poisson_solver&& other) noexcept;
  /// destroys what PETSc has
  ~Distributed_poisson_solver();

  /// PETSc's solver, ready for use
  KSP ksp() const;
  /// PETSc's matrix of the finest level
  Mat matrix() const;
  /// number of components of the surface on which solutions are determined up to a constant
  int kernel_dimension() const;

  /// Solves.
  /// \param load the right-hand side of the sheets of this rank, as `assemble_load()` gives it for
  /// `Distributed_space::part()`: ranks add theirs. On components with a kernel its mean is
  /// removed.
  /// \param coefficients receives the solution, the coefficients of a `Spline_function_3` on
  /// `Distributed_space::part()`; its mean is 0 on components with a kernel
  /// \param has_guess whether `coefficients` is a first guess; else a nested iteration makes one
  /// \throws Distributed_error if `load` or the first guess do not have as many entries as the part
  /// has elements, or one that is not finite; if PETSc fails
  Solve_report solve(const Eigen::VectorXd& load, Eigen::VectorXd& coefficients,
                     bool has_guess = false) const;

private:
  struct Impl;
  std::unique_ptr<Impl> m_impl;
};

} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/distributed/Distributed_poisson_solver_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_DISTRIBUTED_POISSON_SOLVER_H
