// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_SOLVE_REPORT_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_SOLVE_REPORT_H

#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Solvers
/// What a solver did. A solver that does not reach its tolerance says so here; it does not throw.
struct Solve_report {
  /// whether the relative residual is at most the tolerance, for every right-hand side
  bool converged = false;
  /// number of iterations; the largest one, if there are several right-hand sides
  int iterations = 0;
  /// \f$ \|b - A x\|_2 / \|b\|_2 \f$, recomputed from the returned solution; the largest one, if
  /// there are several right-hand sides. For a singular system \f$b\f$ is the right-hand side after
  /// its part outside the range was removed.
  double relative_residual = 0;
  /// relative residual of each right-hand side
  std::vector<double> relative_residuals;
  /// wall-clock seconds: reading the surface, octree and numbering
  double space_seconds = 0;
  /// wall-clock seconds: matrices and right-hand sides
  double assembly_seconds = 0;
  /// wall-clock seconds: hierarchy and smoothers, or factorization
  double setup_seconds = 0;
  /// wall-clock seconds: iterations
  double solve_seconds = 0;
};

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_SOLVE_REPORT_H
