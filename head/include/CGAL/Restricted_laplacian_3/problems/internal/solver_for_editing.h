// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_INTERNAL_SOLVER_FOR_EDITING_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_INTERNAL_SOLVER_FOR_EDITING_H

#include <CGAL/Restricted_laplacian_3/problems/Edited_signal.h>
#include <CGAL/Restricted_laplacian_3/problems/Poisson_solver.h>
#include <CGAL/Restricted_laplacian_3/problems/stabilization.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// of \f$S + \alpha M\f$, as options of editing say
inline Poisson_solver solver_for_editing(const Spline_space_3& space, double alpha,
                                         const Editing_options& options) {
  Elliptic_system system;
  system.elliptic.reaction = alpha;
  system.elliptic.stabilization = options.stabilization.value_or(default_stabilization(space));
  Poisson_solver_options of_solver;
  of_solver.tolerance = options.tolerance;
  of_solver.is_parallel = space.options().is_parallel;
  return Poisson_solver(space, system, of_solver);
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_INTERNAL_SOLVER_FOR_EDITING_H
