// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_MULTIGRID_SOLVER_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_MULTIGRID_SOLVER_H

#include <CGAL/Restricted_laplacian_3/foundation/Sparse_matrix.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parameters.h>
#include <CGAL/Restricted_laplacian_3/solvers/Multigrid_levels.h>
#include <CGAL/Restricted_laplacian_3/solvers/Solve_report.h>

#include <Eigen/Core>

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Solvers
/// which smoother a `Poisson_solver` uses: `Patch_smoother` or `Gauss_seidel_smoother`
enum class Smoother_type { patch, point };

namespace internal {

class Mean_projection;

} // namespace internal

/// \ingroup PkgRestrictedLaplacian3Options
/// The named parameters of a `Poisson_solver`.
struct Poisson_solver_options {
  /// the default of `tolerance` in `Poisson_solver`
  static constexpr double default_tolerance = 1e-3;
  /// \f$ \|b - A x\|_2 \le \f$ tolerance times \f$\|b\|_2\f$ ends the iteration; without a value
  /// what the application needs
  std::optional<double> tolerance;
  /// the iteration also ends at an estimated error of that size, relative to the solution, in the
  /// norm of the energy; 0: never
  double energy_tolerance = 0;
  /// the iteration ends after this many cycles, converged or not
  int maximum_iterations = 1000;
  /// shape of the multigrid cycle
  Cycle cycle = Cycle::V;
  /// smoothing steps before, and again after the coarse correction
  int smoothing_steps = 1;
  /// iterate cycles alone, instead of preconditioning conjugate gradients with them
  bool stand_alone_multigrid = false;
  /// patches take twice the memory and setup of points, and a tenth of their iterations
  Smoother_type smoother = Smoother_type::patch;
  /// whether several threads are used; results do not depend on that
  bool is_parallel = false;

  /// the defaults
  Poisson_solver_options() = default;
  /// what is among named parameters, and the defaults else
  template <class NamedParameters, internal::Require_named_parameters<NamedParameters> = 0>
  Poisson_solver_options(const NamedParameters& np) : is_parallel(internal::is_parallel(np)) {
    internal::read_parameter(np, internal_np::tolerance, tolerance);
    internal::read_parameter(np, internal_np::energy_tolerance, energy_tolerance);
    internal::read_parameter(np, internal_np::maximum_iterations, maximum_iterations);
    internal::read_parameter(np, internal_np::cycle, cycle);
    internal::read_parameter(np, internal_np::smoothing_steps, smoothing_steps);
    internal::read_parameter(np, internal_np::stand_alone_multigrid, stand_alone_multigrid);
    internal::read_parameter(np, internal_np::smoother, smoother);
  }
};

/// \ingroup PkgRestrictedLaplacian3Options
/// When the iteration for a least-squares problem ends, at the latest: the solution \f$x\f$ of
/// \f$A x = b\f$ minimizes \f$x^T A\, x - 2\, b^T x + s\f$, and an error well below the square
/// root of the minimum does not show.
struct Least_squares_criterion {
  /// \f$s\f$ of each right-hand side
  Eigen::VectorXd squares;
  /// largest estimated error in the norm of the energy, over the square root of the minimum; 0: any
  double tolerance = 0;
};

/// \ingroup PkgRestrictedLaplacian3Options
/// What a call of `Poisson_solver::solve()` has otherwise than the solver.
struct Solve_options {
  /// in place of that of the solver, between 0 and 1
  std::optional<double> tolerance;
  /// is told which part of the work is done, from 0 to 1, as far as residuals show it; if it
  /// returns `false`, the computation ends with an exception
  std::function<bool(double)> progress;
  /// Whether the argument for the solution is a first guess, as that of the time step before is. It
  /// is improved by nested iteration where that makes the residual smaller, and ignored if its
  /// residual is larger than the right-hand side.
  bool has_first_guess = false;
  /// if the problem is one of least squares
  Least_squares_criterion least_squares;
  /// \cond
  /// Receives, if there is no first guess, the solutions of the level below the finest and of the
  /// one below that, to the accuracy of a cycle, as functions of the finest level. NaN where they
  /// are not known.
  std::array<Eigen::MatrixXd, 2>* coarser_solutions = nullptr;
  /// \endcond

  /// the defaults
  Solve_options() = default;
  /// \param tolerance in place of that of the solver, between 0 and 1
  /// \param progress as above
  Solve_options(double tolerance, std::function<bool(double)> progress = {})
    : tolerance(tolerance), progress(std::move(progress)) {}
};

/// \ingroup PkgRestrictedLaplacian3Solvers
/// Solves \f$A x = b\f$ for a symmetric positive semi-definite matrix by conjugate gradients that
/// are preconditioned with a multigrid cycle, from a first guess by nested iteration:
/// \f$A = S\f$ for the Poisson problem, \f$A = S + \alpha M\f$ for the screened one. It is set up
/// once and then solves for any number of right-hand sides. Knows matrices only, no surface; that
/// of a `Spline_space_3` is a `Poisson_solver`.
///
/// *Precision.* The iteration is in double precision, the cycle in single precision. The iteration
/// ends by the true residual, computed anew from the solution; or, if an `energy_tolerance` is
/// given, by the estimated error.
///
/// *Cycles that diverge* are found out: steps \f$\alpha < 1/2\f$ of conjugate gradients prove that
/// \f$B A\f$ has an eigenvalue above 2. Three of them, or a first guess whose residual is larger
/// than the right-hand side, turn W-cycles into V-cycles. The report says how the iteration ended.
///
/// *Singular systems.* If \f$A\f$ annihilates the functions that are constant on a connected
/// component (of the graph of the matrix), the system has a solution only for right-hand sides
/// whose entries sum to 0 on the component. The load of a constant is subtracted from \f$b\f$ to
/// achieve this, which turns the load of \f$f\f$ into that of \f$f\f$ minus its mean on the
/// component, and of all solutions the one with mean 0 on the component is returned. With
/// screening, \f$A\f$ maps the constant 1 to its load with the screening weight, \f$\alpha\f$ or a
/// function, and the weighted mean of the solution is computed exactly, however small the weight
/// is. Near-kernel (combinations of
/// elements that nearly vanish on the surface) is left alone: its coefficients carry no
/// information, and do not change the function on the surface.
class Multigrid_solver {
  using Options = Poisson_solver_options;

public:
  /// a matrix, column by column, in double precision
  using Sparse_matrix = Restricted_laplacian_3::Sparse_matrix;
  /// of the residual, relative to the right-hand side
  static constexpr double default_tolerance = Options::default_tolerance;

  /// \param a the matrix, which is taken over and left empty; what is below its diagonal is not
  /// read, and need not be stored
  /// \param levels what else the hierarchy is made of, see `multigrid_levels()`; without patches,
  /// the smoother is point Gauss-Seidel
  /// \param element_integrals \f$\int b_i\f$ for each unknown
  /// \param alpha the screening weight that `a` contains, if any
  /// \param options named parameters, or the options themselves:
  /// \cgalNamedParamsBegin
  ///   \named_of_solver{`1e-3`}
  ///   \named_concurrency_tag
  /// \cgalNamedParamsEnd
  /// \throws Parameter_error if sizes do not fit, if an option is outside its domain, if an entry
  /// of the matrix is not finite, or a diagonal entry negative beyond rounding
  /// \throws Numerical_error if the coarsest level cannot be solved
  Multigrid_solver(Sparse_matrix&& a, Multigrid_levels levels,
                   const Eigen::VectorXd& element_integrals, double alpha = 0,
                   const Options& options = Options());

  /// The same with a copy of `a`.
  Multigrid_solver(const Sparse_matrix& a, Multigrid_levels levels,
                   const Eigen::VectorXd& element_integrals, double alpha = 0,
                   const Options& options = Options())
    : Multigrid_solver(Sparse_matrix(a), std::move(levels), element_integrals, alpha, options) {}

  /// With a screening weight that varies over the surface.
  /// \param a the matrix, as above; one that is still needed is copied by `Sparse_matrix(a)`
  /// \param levels what else the hierarchy is made of
  /// \param element_integrals \f$\int b_i\f$ for each unknown
  /// \param constant_loads \f$w_i = \int \alpha\, b_i\f$ for each unknown, not negative: what `a`
  /// maps the constant 1 to. On components where all of them are 0, constants are in the kernel.
  /// \param options named parameters, or the options themselves:
  /// \cgalNamedParamsBegin
  ///   \named_of_solver{`1e-3`}
  ///   \named_concurrency_tag
  /// \cgalNamedParamsEnd
  Multigrid_solver(Sparse_matrix&& a, Multigrid_levels levels,
                   const Eigen::VectorXd& element_integrals, const Eigen::VectorXd& constant_loads,
                   const Options& options = Options());

  /// A solver is moved, not copied. One that was moved from can only be assigned to.
  Multigrid_solver(Multigrid_solver&& other) noexcept;
  /// \copydoc Multigrid_solver(Multigrid_solver&&)
  Multigrid_solver& operator=(Multigrid_solver&& other) noexcept;
  ~Multigrid_solver();

  /// The values of the named parameters that are used: those given to the constructor, but
  /// `Smoother_type::point` if there are no patches.
  const Options& options() const;
  /// the entries of the matrix on and above its diagonal
  const Sparse_matrix& upper_half() const;
  /// number of connected components whose constants are in the kernel of the matrix
  int kernel_dimension() const;
  /// the connected components of the graph of the matrix, and the means on them
  const internal::Mean_projection& mean_projection() const;
  /// wall-clock seconds that the hierarchy took
  double setup_seconds() const;

  /// Solves \f$A x = b\f$.
  /// \param b right-hand side, as many rows as the matrix
  /// \param x on return the solution; its old content is used if it is a first guess
  /// \param options what is not as in the constructor; a number stands for a tolerance
  /// \throws Parameter_error if the number of rows does not fit, or if an entry is not finite
  /// \throws Canceled if `progress` returned `false`
  Solve_report solve(const Eigen::Ref<const Eigen::VectorXd>& b, Eigen::VectorXd& x,
                     const Solve_options& options = Solve_options()) const;

  /// The same for each column of `b`; up to eight at a time share each pass over the matrices.
  Solve_report solve(const Eigen::Ref<const Eigen::MatrixXd>& b, Eigen::MatrixXd& x,
                     const Solve_options& options = Solve_options()) const;

private:
  struct Impl;
  std::unique_ptr<Impl> m_impl;
};

} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/solvers/Multigrid_solver_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_MULTIGRID_SOLVER_H
