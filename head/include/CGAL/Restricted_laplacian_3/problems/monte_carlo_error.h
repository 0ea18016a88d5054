// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_MONTE_CARLO_ERROR_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_MONTE_CARLO_ERROR_H

#include <CGAL/Restricted_laplacian_3/assembly/assemble.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parameters.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>
#include <CGAL/Restricted_laplacian_3/surface/sample_surface.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Options
/// The named parameters of `estimate_operators()` and `estimate_eigenvalues()`.
struct Monte_carlo_options {
  /// of all batches together; each has this over `batches`, rounded down
  std::size_t samples = 1000000;
  /// at least 2. The standard errors have a relative error of about \f$1 / \sqrt{2 (B - 1)}\f$
  /// themselves, \f$B\f$ the number of batches: 24 % for 10 batches.
  int batches = 10;
  /// the same seed gives the same result with every compiler, and any number of threads
  std::uint64_t seed = 0;
  /// how the samples of a batch are drawn
  Sampling sampling = Sampling::independent;

  /// the defaults
  Monte_carlo_options() = default;
  /// what is among named parameters, and the defaults else
  template <class NamedParameters, internal::Require_named_parameters<NamedParameters> = 0>
  Monte_carlo_options(const NamedParameters& np) {
    internal::read_parameter(np, internal_np::samples, samples);
    internal::read_parameter(np, internal_np::batches, batches);
    internal::read_parameter(np, internal_np::seed, seed);
    internal::read_parameter(np, internal_np::sampling, sampling);
  }
};

/// \ingroup PkgRestrictedLaplacian3Operators
/// Matrices from samples, and the standard error of each of their entries.
struct Estimated_operators {
  /// as `assemble_operators()` with `Monte_carlo` gives them
  Operators operators;
  /// standard errors of the entries, in matrices of the same pattern
  Operators standard_errors;
};

/// \ingroup PkgRestrictedLaplacian3Operators
/// Eigenvalues from samples, and their standard errors.
struct Estimated_eigenvalues {
  /// ascending
  Eigen::VectorXd values;
  /// one for each value
  Eigen::VectorXd standard_errors;
};

/// \ingroup PkgRestrictedLaplacian3Operators
/// Stiffness and mass matrix of one level by the sum over random samples (paper, section 4.3), and
/// how far each entry is from the integral.
///
/// The samples are drawn in batches that are independent of each other, each with its own matrix
/// \f$A_b\f$. The result is their mean \f$\bar A\f$, whose standard error is
/// \f[ \sqrt{ \frac{1}{B (B - 1)} \sum_{b=1}^{B} (A_b - \bar A)^2 } \f]
/// for each entry. The matrix without stabilization is unbiased.
///
/// Takes the time of one assembly for each batch.
/// \param space the space whose elements are integrated
/// \param level from 0, the coarsest, to the depth of the space
/// \param options named parameters, or the options themselves:
/// \cgalNamedParamsBegin
///   \named_samples
///   \named_batches
///   \named_seed
///   \named_sampling
/// \cgalNamedParamsEnd
/// \param stabilization,stabilized as in `assemble_operators()`
/// \throws Parameter_error if the level or a parameter is outside its domain
Estimated_operators estimate_operators(const Spline_space_3& space, int level,
                                       const Monte_carlo_options& options = {},
                                       double stabilization = 0,
                                       Stabilized stabilized = Stabilized::stiffness_and_mass);

/// \ingroup PkgRestrictedLaplacian3Operators
/// The smallest eigenvalues of \f$S x = \lambda M x\f$ on the finest level by random samples,
/// and how far each is from that of the integrals.
///
/// The eigenvalues are those of the mean matrices of all batches. Their standard errors follow from
/// the first-order change that each batch would cause: with \f$x^T M x = 1\f$ the number
/// \f$x^T (S_b - \lambda M_b)\, x\f$ has mean 0 over the batches, and the standard error of that
/// mean is the one of \f$\lambda\f$.
///
/// The error of discretization is not in it. Nor is what is of second order. Eigenvalues that are
/// equal or nearer to each other than their errors repel each other, so that the lowest is too low,
/// and the highest too high; take the mean of such a group, whose error is right. And with few
/// samples in a cell all eigenvalues are too small, by several standard errors for 10 samples, and
/// by hardly one for 1000.
///
/// Takes the time of two assemblies for each batch and one eigenproblem by `smallest_eigenpairs()`.
/// \param space the space; its finest level is used
/// \param count number of eigenvalues, positive
/// \param options named parameters, or the options themselves:
/// \cgalNamedParamsBegin
///   \named_samples
///   \named_batches
///   \named_seed
///   \named_sampling
/// \cgalNamedParamsEnd
/// \param stabilization of the stiffness matrix, as in `assemble_operators()`
/// \throws Parameter_error if `count` or a parameter is outside its domain
/// \throws Numerical_error if a factorization fails, or if not all eigenvalues were found
Estimated_eigenvalues estimate_eigenvalues(const Spline_space_3& space, int count,
                                           const Monte_carlo_options& options = {},
                                           double stabilization = 0);

} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/problems/monte_carlo_error_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_MONTE_CARLO_ERROR_H
