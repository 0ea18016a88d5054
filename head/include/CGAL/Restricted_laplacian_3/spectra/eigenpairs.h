// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_EIGENPAIRS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_EIGENPAIRS_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/parameters.h>
#include <CGAL/Restricted_laplacian_3/solvers/Solve_report.h>

#include <Eigen/Core>

#include <functional>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Solvers
/// Some eigenpairs \f$S x = \lambda M x\f$.
struct Eigenpairs {
  /// ascending
  Eigen::VectorXd values;
  /// one column for each value, \f$x^T M x = 1\f$; of the two signs the one that makes the entry of
  /// largest absolute value positive
  Eigen::MatrixXd vectors;
  /// \f$ \|S x - \lambda M x\|_2 / \|(S - \sigma M) x\|_2 \f$ for each pair
  Eigen::VectorXd residuals;
  /// whether all requested pairs were found to the tolerance; if not, `values` holds those that
  /// were
  bool converged = false;
  /// how the iteration ended, of `multigrid_eigenpairs()` the one on the finest level
  Solve_status status = Solve_status::iteration_limit;
  /// restarts of the Lanczos iteration, 0 if the problem was solved densely; of
  /// `multigrid_eigenpairs()`, iterations on the finest level
  int iterations = 0;
  /// \f$\sigma = -4 \pi / \sum_{ij} M_{ij}\f$, see `smallest_eigenpairs()`
  double shift = 0;
  /// \f$\tau\f$, see `smallest_eigenpairs()`; 0 for `multigrid_eigenpairs()`
  double regularization = 0;
  /// \cond
  /// Of `multigrid_eigenpairs()`: the values of the same pairs on coarser levels, to the accuracy
  /// with which they are computed there, coarsest first.
  std::vector<Eigen::VectorXd> coarser_values;
  /// \endcond

  /// sets the status, and whether that is `Solve_status::converged`
  void set_status(Solve_status s) {
    status = s;
    converged = s == Solve_status::converged;
  }
};

/// \ingroup PkgRestrictedLaplacian3Options
/// The named parameters of `smallest_eigenpairs()`.
struct Eigenpairs_options {
  /// of the eigenvalues, relative
  double tolerance = 1e-10;
  /// restarts of the Lanczos iteration after which it ends, converged or not
  int maximum_iterations = 1000;
  /// \f$\tau\f$ of the first attempt
  double regularization = 1e-12;
  /// is told about which part of the work is done, from 0 to 1; if it returns `false`, the
  /// computation ends with a `Canceled` exception
  std::function<bool(double)> progress;

  /// the defaults
  Eigenpairs_options() = default;
  /// what is among named parameters, and the defaults else
  template <class NamedParameters, internal::Require_named_parameters<NamedParameters> = 0>
  Eigenpairs_options(const NamedParameters& np) {
    internal::read_parameter(np, internal_np::tolerance, tolerance);
    internal::read_parameter(np, internal_np::maximum_iterations, maximum_iterations);
    internal::read_parameter(np, internal_np::progress, progress);
  }
};

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_EIGENPAIRS_H
