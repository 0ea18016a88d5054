// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_MULTIGRID_EIGENPAIRS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_MULTIGRID_EIGENPAIRS_H

#include <CGAL/Restricted_laplacian_3/foundation/Sparse_matrix.h>
#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parameters.h>
#include <CGAL/Restricted_laplacian_3/solvers/Multigrid_levels.h>
#include <CGAL/Restricted_laplacian_3/spectra/eigenpairs.h>

#include <functional>
#include <optional>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Options
/// The named parameters of `multigrid_eigenpairs()`.
struct Multigrid_eigenpairs_options {
  /// the default of `tolerance`
  static constexpr double default_tolerance = 1e-3;

  /// the largest of `Eigenpairs::residuals` that counts as converged; the error of an eigenvector
  /// is of the order of its residual, the relative one of an eigenvalue of the order of its square.
  /// Without a value `default_tolerance`.
  std::optional<double> tolerance;
  /// on each level
  int maximum_iterations = 100;
  /// of a cycle: smoothing steps before, and again after the coarse correction
  int smoothing_steps = 1;
  /// whether only eigenvalues are needed: vectors are not made orthonormal at the end, and
  /// residuals are those with which pairs converged
  bool eigenvalues_only = false;
  /// whether several threads are used; results do not depend on that
  bool is_parallel = false;
  /// is told which part of the work is done, from 0 to 1; if it returns `false`, the computation
  /// ends with a `Canceled` exception
  std::function<bool(double)> progress;

  /// the defaults
  Multigrid_eigenpairs_options() = default;
  /// what is among named parameters, and the defaults else
  template <class NamedParameters, internal::Require_named_parameters<NamedParameters> = 0>
  Multigrid_eigenpairs_options(const NamedParameters& np) : is_parallel(internal::is_parallel(np)) {
    internal::read_parameter(np, internal_np::tolerance, tolerance);
    internal::read_parameter(np, internal_np::maximum_iterations, maximum_iterations);
    internal::read_parameter(np, internal_np::smoothing_steps, smoothing_steps);
    internal::read_parameter(np, internal_np::eigenvalues_only, eigenvalues_only);
    internal::read_parameter(np, internal_np::progress, progress);
  }
};

/// \ingroup PkgRestrictedLaplacian3Solvers
/// The smallest eigenvalues of \f$S x = \lambda M x\f$, with multiplicities, and eigenvectors,
/// for symmetric positive semi-definite matrices that are given on all levels of a hierarchy.
///
/// *Nested iteration.* The coarsest level with ten unknowns for each vector is solved by
/// `smallest_eigenpairs()`, or the next one if that fails. The eigenvectors of a level are
/// prolongated to the next finer one and improved there, until their residuals are at most 1e-2, on
/// the finest level at most `tolerance`.
///
/// *Improvement* is by LOBPCG (A. V. Knyazev, *Toward the optimal preconditioned eigensolver*, SIAM
/// J. Sci. Comput. 23, 2001), preconditioned by one V-cycle for \f$S + \alpha M\f$, where
/// \f$\alpha\f$ is half of the tenth eigenvalue. Cycles are applied to eight vectors at a time, in
/// single precision; everything else is in double precision. About a third more vectors than asked
/// for are carried along, but no longer improved on the finest level: the last pairs converge the
/// faster, the larger the gap to the first eigenvalue beyond them is. Pairs that have converged are
/// locked softly; at the end all residuals are computed once more, from vectors that are
/// orthonormal to rounding, and the iteration goes on if one is too large.
///
/// The stiffness matrix is to be stabilized, the mass matrix is not, see `assemble_operators()`.
/// Without stabilization it takes more iterations, or does not get to the tolerance.
///
/// Takes a time of the order of \f$k\f$ cycles and of \f$k^2\f$ times the number of unknowns for
/// each iteration. Memory: matrices and hierarchy as in `Poisson_solver`, and about \f$1.4\, k\f$
/// vectors in double precision and \f$2.4\, k\f$ in single precision.
///
/// The result is the same for any number of threads.
///
/// \param stiffness,mass full symmetric matrices of the levels, coarsest first, each pair with the
/// same pattern
/// \param prolongations from each level to the next finer one
/// \param patches of each level but the coarsest, see `smoothing_patches()`
/// \param count number \f$k\f$ of pairs
/// \param options named parameters, or the options themselves:
/// \cgalNamedParamsBegin
///   \named_tolerance{`1e-3`}
///   \named_maximum_iterations{`100`, on each level}
///   \named_smoothing_steps
///   \named_eigenvalues_only
///   \named_concurrency_tag
///   \named_progress
/// \cgalNamedParamsEnd
/// \return pairs that are orthonormal with respect to \f$M\f$, with `eigenvalues_only` nearly so.
/// If not all residuals got below the tolerance, `converged` is `false` and the pairs are the best
/// approximations that were found. `iterations` are those on the finest level; 0 if that was solved
/// by `smallest_eigenpairs()`, because it is small.
/// \throws Parameter_error if sizes do not fit, if an entry is not finite, if `count` is not
/// positive or exceeds the number of independent functions, or if an option is outside its domain
/// \throws Numerical_error if neither a coarse problem nor the finest one can be solved directly
/// \throws Canceled if `progress` returned `false`
Eigenpairs multigrid_eigenpairs(std::vector<Sparse_matrix> stiffness,
                                std::vector<Sparse_matrix> mass,
                                std::vector<Sparse_matrix> prolongations,
                                std::vector<Smoothing_patches> patches, int count,
                                const Multigrid_eigenpairs_options& options = {});

} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/spectra/multigrid_eigenpairs_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_MULTIGRID_EIGENPAIRS_H
