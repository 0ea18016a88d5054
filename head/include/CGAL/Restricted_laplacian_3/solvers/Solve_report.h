// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_SOLVE_REPORT_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_SOLVE_REPORT_H

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Solvers
/// How an iteration ended, from good to bad. (One that is canceled ends with the exception
/// `Canceled`.)
enum class Solve_status {
  /// the tolerance is reached
  converged,
  /// the tolerance is reached, but not the `accuracy` that was asked for: the largest memory or
  /// depth does not suffice, or deeper levels do not help
  inaccurate,
  /// after the largest number of iterations that was permitted; more would go on
  iteration_limit,
  /// more iterations do not help: what is left is rounding, or what the multigrid method does not
  /// reduce
  stalled,
  /// the residual is larger than the right-hand side, or the numbers left the range of numbers
  diverged
};

/// \ingroup PkgRestrictedLaplacian3Solvers
/// The status in words that follow on "the iteration".
inline std::string to_string(Solve_status status) {
  switch(status) {
  case Solve_status::converged: return "converged";
  case Solve_status::inaccurate: return "did not reach the accuracy";
  case Solve_status::iteration_limit: return "reached the largest number of iterations";
  case Solve_status::stalled: return "stalled";
  default: return "diverged";
  }
}

/// \ingroup PkgRestrictedLaplacian3Solvers
/// What a solver did. A solver that does not reach its tolerance says so here; it does not throw.
struct [[nodiscard]] Solve_report {
  /// whether the tolerance is reached for every right-hand side: the relative residual is at most
  /// the tolerance, or the estimated error at most the `energy_tolerance`
  bool converged = false;
  /// how the iteration ended; the worst one, if there are several right-hand sides
  Solve_status status = Solve_status::iteration_limit;
  /// number of iterations; the largest one, if there are several right-hand sides
  int iterations = 0;
  /// \f$ \|b - A x\|_2 / \|b\|_2 \f$, recomputed from the returned solution; the largest one, if
  /// there are several right-hand sides. For a singular system \f$b\f$ is the right-hand side after
  /// its part outside the range was removed.
  double relative_residual = 0;
  /// relative residual of each right-hand side
  std::vector<double> relative_residuals;
  /// An estimate of the error of the solution in the norm of the energy,
  /// \f$ (e^T A\, e / x^T A\, x)^{1/2} \f$ with \f$e = A^{-1} b - x\f$: for conjugate gradients
  /// \f$e^T A\, e\f$ before a step is the sum of \f$\alpha\, r^T z\f$ over all steps that follow,
  /// see M. R. Hestenes, E. Stiefel, *Methods of conjugate gradients for solving linear systems*,
  /// J. Res. Nat. Bur. Standards 49 (1952), and Z. Strakos, P. Tichy, *On error estimation in the
  /// conjugate gradient method*, ETNA 13 (2002). Here it is that of the last four steps, so the
  /// error four steps before the end. The largest one, if there are several right-hand sides; 0 for
  /// a solution that is 0; NaN where there was no step, as with `stand_alone_multigrid`.
  double relative_energy_error = std::numeric_limits<double>::quiet_NaN();
  /// Largest difference to a value that is prescribed exactly at a point: at most 1e-6 of the range
  /// of those values, or of the root of the energy, if the space has functions that meet them. One
  /// that is more than 1e-3 does not count as converged. 0 if there are none.
  double constraint_error = 0;
  /// An estimate of the error of the result, relative to its size, that the finite elements make,
  /// by what changed from level to level; see the section on errors in the User Manual. Of
  /// solutions the root mean square over the surface, relative to that of what is left of the
  /// solution without its mean, the largest one if there are several; of eigenvalues the largest
  /// relative one. NaN where it is not known.
  double estimated_error = std::numeric_limits<double>::quiet_NaN();
  /// whether the cells resolve the surface, so that the estimate can be relied on: the number of
  /// unknowns grows about fourfold from level to level
  bool is_estimate_trusted = false;
  /// wall-clock seconds: reading the surface, octree and numbering
  double space_seconds = 0;
  /// wall-clock seconds: matrices and right-hand sides
  double assembly_seconds = 0;
  /// wall-clock seconds: hierarchy and smoothers, or factorization
  double setup_seconds = 0;
  /// wall-clock seconds: iterations
  double solve_seconds = 0;

  /// sets the status, and whether that is `Solve_status::converged`
  void set_status(Solve_status s) {
    status = s;
    converged = s == Solve_status::converged;
  }
  /// the same if the status is worse than the one that is set
  void worsen_status(Solve_status s) { set_status((std::max)(status, s)); }
};

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_SOLVE_REPORT_H
