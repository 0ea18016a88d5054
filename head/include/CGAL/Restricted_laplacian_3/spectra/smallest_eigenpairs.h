// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_SMALLEST_EIGENPAIRS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_SMALLEST_EIGENPAIRS_H

#include <CGAL/Restricted_laplacian_3/foundation/Sparse_matrix.h>
#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>
#include <CGAL/Restricted_laplacian_3/spectra/eigenpairs.h>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Solvers
/// The smallest eigenvalues of \f$S x = \lambda M x\f$, with multiplicities, and eigenvectors,
/// for symmetric positive semi-definite matrices.
///
/// By Spectra, a restarted Lanczos iteration for \f$K^{-1} M\f$, in the symmetric form
/// \f$R^{-T} M R^{-1}\f$, where \f$ R^T R = K = S - \sigma M + \tau\, \mathrm{diag}(S - \sigma M)
/// \f$ is factorized once, by CHOLMOD if the macro `CGAL_RESTRICTED_LAPLACIAN_3_USE_CHOLMOD` is
/// defined, else by Eigen; `shift_invert_eigenpairs()` takes another factorization.
///
/// *Shift.* \f$\sigma = -4 \pi / \sum_{ij} M_{ij}\f$: below the spectrum by about the mean distance
/// of two eigenvalues of a surface of this area (Weyl's law), so \f$K\f$ is positive semi-definite
/// although \f$S\f$ has the constants in its kernel, and all eigenvalues near 0 are well separated.
///
/// *Common near-kernel.* Combinations of elements that nearly vanish on the surface are nearly in
/// the kernel of \f$S\f$ and of \f$M\f$; rounding may make their pivots negative. They are made
/// regular by \f$\tau = 10^{-12}\f$, relative to each diagonal entry. For them \f$K\f$ is then
/// dominated by \f$\tau\f$ while \f$M\f$ is zero to rounding, so \f$K^{-1} M\f$ sends them to 0,
/// the far end of the spectrum. The values returned are Rayleigh quotients with \f$S\f$ itself, in
/// which \f$\tau\f$ enters squared only. Should a factorization fail, \f$\tau\f$ is multiplied by
/// 100, up to \f$10^{-8}\f$; the result reports the value used.
///
/// *Kernel.* Functions that are constant on a connected component of the graph of \f$S\f$ and in
/// its kernel are recognized and returned as they are.
///
/// *Multiplicity.* A second iteration, with all pairs found so far deflated, looks for copies of a
/// multiple eigenvalue that the first one missed, and is repeated until it finds none.
///
/// Problems with fewer than 100 unknowns, or with `count` more than a third of them, are solved
/// densely.
///
/// Takes one factorization, and two to four times \f$2 k\f$ solves with it and products with
/// \f$M\f$; memory for the factor and \f$2 k\f$ vectors.
///
/// \param s,m full symmetric matrices; an unknown whose rows are empty is 0 in all vectors
/// \param count number \f$k\f$ of pairs, positive
/// \param options named parameters, or the options themselves:
/// \cgalNamedParamsBegin
///   \named_tolerance{`1e-10`, of the eigenvalues}
///   \named_maximum_iterations{`1000` restarts of the Lanczos iteration}
///   \named_progress
/// \cgalNamedParamsEnd
/// \throws Parameter_error if `count` is not positive, exceeds the number of independent functions,
/// or is more than a third of more than 10,000 unknowns; if the matrices are not square and of the
/// same size, if an entry is not finite, or the entries of `m` do not have a positive sum
/// \throws Numerical_error if no factorization succeeds; also for each problem that is not solved
/// densely, if this was compiled without Spectra
/// \throws Canceled if `progress` returned `false`
Eigenpairs smallest_eigenpairs(const Sparse_matrix& s, const Sparse_matrix& m, int count,
                               const Eigenpairs_options& options = {});

} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/spectra/smallest_eigenpairs_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_SMALLEST_EIGENPAIRS_H
