// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_DISTRIBUTED_SPECTRUM_H
#define CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_DISTRIBUTED_SPECTRUM_H

#include <CGAL/Restricted_laplacian_3/distributed/Distributed_functions.h>
#include <CGAL/Restricted_laplacian_3/distributed/Distributed_space.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>
#include <CGAL/Restricted_laplacian_3/problems/space_spectrum.h>
#include <CGAL/Restricted_laplacian_3/solvers/Solve_report.h>

#include <Eigen/Core>

#include <functional>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Distributed
/// The low end of the spectrum of the Laplace-Beltrami operator, on several ranks.
struct Distributed_spectrum {
  /// \f$\lambda\f$ with \f$-\Delta u = \lambda u\f$, ascending, in units of 1 / area, and the
  /// coefficients of the eigenfunctions, \f$x^T M x = 1\f$; of the two signs the one that makes the
  /// coefficient of largest absolute value positive. If not all converged, those that did.
  Distributed_functions pairs;
  /// \f$ \|S x - \lambda M x\|_2 / \|(S - \sigma M) x\|_2 \f$ for each pair, with
  /// \f$\sigma = -4 \pi / \mathrm{area}\f$
  Eigen::VectorXd residuals;
  /// how many of them were known before
  int number_of_known = 0;
  /// convergence, iterations on the finest level, largest residual, times
  Solve_report report;
};

/// \cond SKIP_IN_MANUAL
/// \ingroup PkgRestrictedLaplacian3Options
/// Where a computation of eigenpairs on several ranks begins, and whom it tells of what it finds.
struct Distributed_spectrum_state {
  /// Eigenpairs that an earlier run has found, the smallest ones without a gap. Those that satisfy
  /// the tolerance are not computed again, others are first guesses.
  Distributed_functions known;
  /// is called on all ranks when more pairs on the finest level have converged, with all that have,
  /// in no order, such as for `save_functions()`
  std::function<void(const Distributed_functions&)> found;
};
/// \endcond

/// \ingroup PkgRestrictedLaplacian3Distributed
/// The smallest eigenvalues and eigenfunctions of \f$-\Delta_{\mathcal M}\f$ on a space whose
/// parts are on several ranks, by an eigensolver of SLEPc for
/// \f$M x = \frac{1}{\lambda + \alpha}\, (S + \alpha M)\, x\f$, preconditioned by a multigrid cycle
/// for \f$S + \alpha M\f$, that of `Distributed_poisson_solver`, for eight vectors at a time.
///
/// As in `multigrid_eigenpairs()`, \f$\alpha\f$ is half of the tenth eigenvalue, the eigenvectors
/// of each level are prolongated to the next finer one and improved there, and the first level is
/// solved by `smallest_eigenpairs()`, on rank 0: the finest one of which all ranks hold the whole,
/// or the first finer one that has ten unknowns for each vector. Coarse levels ask for residuals of
/// 1e-2. A problem with fewer than ten unknowns for each pair is solved by rank 0 altogether.
///
/// SLEPc and PETSc must be initialized. SLEPc's options apply on the finest level: `-eps_monitor`,
/// `-eps_lobpcg_blocksize 64`, or `-eps_type gd` for generalized Davidson in place of LOBPCG; on
/// coarser levels with the prefix `coarse_`. With `-eps_type krylovschur -st_type shift
/// -st_ksp_type preonly -st_pc_type cholesky` the matrix \f$S + \alpha M\f$ is factorized; then
/// one of several equal eigenvalues may be missing.
/// \param space the space; its finest level is used
/// \param count number of pairs, positive
/// \param options `stabilization`, `eigenvalues_only`, and of `multigrid` the tolerance, the
/// largest number of iterations and the smoothing steps; what else they contain has no effect
/// \param state what is known already, and a functor that is told of what is found
/// \throws Distributed_error on all ranks if a parameter is outside its domain, if a factorization
/// fails, if memory is not enough, or if PETSc or SLEPc fail
Distributed_spectrum laplace_spectrum(const Distributed_space& space, int count,
                                      const Laplace_spectrum_options& options = {},
                                      const Distributed_spectrum_state& state = {});

} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/distributed/Distributed_spectrum_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_DISTRIBUTED_SPECTRUM_H
