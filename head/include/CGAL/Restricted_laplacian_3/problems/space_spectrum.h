// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_SPACE_SPECTRUM_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_SPACE_SPECTRUM_H

#include <CGAL/Restricted_laplacian_3/assembly/assemble.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parameters.h>
#include <CGAL/Restricted_laplacian_3/problems/stabilization.h>
#include <CGAL/Restricted_laplacian_3/solvers/Solve_report.h>
#include <CGAL/Restricted_laplacian_3/spectra/eigenpairs.h>
#include <CGAL/Restricted_laplacian_3/spectra/multigrid_eigenpairs.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>

#include <Eigen/Core>

#include <functional>
#include <optional>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Solvers
/// How `laplace_spectrum()` computes eigenpairs: by `multigrid_eigenpairs()`, by
/// `smallest_eigenpairs()`, or by the one of them that is faster; if that is `multigrid`, and it
/// stalls, by the other one, unless it would take more than the `maximum_memory` of the space.
enum class Eigensolver { automatic, multigrid, shift_invert };

/// \ingroup PkgRestrictedLaplacian3Solvers
/// The low end of the spectrum of the Laplace-Beltrami operator.
struct Laplace_spectrum {
  /// \f$\lambda\f$ with \f$-\Delta u = \lambda u\f$, ascending, in units of 1 / area; the first is
  /// 0
  Eigen::VectorXd eigenvalues;
  /// Values of the eigenfunctions at the vertices: one column for each eigenvalue, rows in the
  /// order of `vertices(tm)`; NaN at vertices without a face of positive area. Their mean squares
  /// over the surface are 1 / area. Empty with `eigenvalues_only`. They are orthonormal as splines
  /// on the surface; with the mass matrix \f$M\f$ of `cotangent_operators()` at the vertices nearly
  /// so, the finer the mesh the more. \f$\Phi L^{-T}\f$ with
  /// \f$L L^T = \Phi^T M \Phi\f$ is, exactly.
  Eigen::MatrixXd vertex_values;
  /// An estimate of the relative error of each eigenvalue that the finite elements make, by what
  /// changed from level to level; see the section on errors in the User Manual. 0 for those that
  /// are 0; empty where it is not known. The largest one is in `report`.
  Eigen::VectorXd estimated_errors;
  /// Eigenvalues without the error that falls fourfold from level to level,
  /// \f$(4 \lambda_d - \lambda_{d-1}) / 3\f$, by those of the two finest levels: mostly nearer,
  /// but no upper bounds, as `eigenvalues` are up to the stabilization. Empty where the coarser
  /// level is not known.
  Eigen::VectorXd extrapolated_eigenvalues;
  /// of the surface
  double area = 0;
  /// the algebraic problem: vectors of coefficients, residuals, shift and regularization
  Eigenpairs pairs;
  /// which one has computed the pairs, `multigrid` or `shift_invert`
  Eigensolver eigensolver = Eigensolver::automatic;
  /// convergence, iterations, largest residual, times
  Solve_report report;
};

/// \ingroup PkgRestrictedLaplacian3Options
/// The named parameters of `laplace_spectrum()` and `laplace_eigenpairs()`.
struct Laplace_spectrum_options {
  /// the default of `tolerance` with `eigenvalues_only`: errors of eigenvalues are of the
  /// order of its square, about 1e-5
  static constexpr double tolerance_of_eigenvalues = 2.5e-3;

  /// how eigenpairs are computed
  Eigensolver eigensolver = Eigensolver::automatic;
  /// factor \f$c\f$ of the stabilization, of the stiffness matrix alone; without a value
  /// `default_spectrum_stabilization()`
  std::optional<double> stabilization;
  /// Whether eigenfunctions are of no use: they are not evaluated at the vertices, nor made
  /// orthonormal at the end, and the iteration ends at `tolerance_of_eigenvalues`, unless told
  /// otherwise.
  bool eigenvalues_only = false;
  /// those of `Eigensolver::multigrid`, with `eigenvalues_only` as above; `progress` is called by
  /// both eigensolvers, and whether several threads are used is a matter of the space
  Multigrid_eigenpairs_options multigrid;

  /// the defaults
  Laplace_spectrum_options() = default;
  /// what is among named parameters, and the defaults else
  template <class NamedParameters, internal::Require_named_parameters<NamedParameters> = 0>
  Laplace_spectrum_options(const NamedParameters& np) : multigrid(np) {
    internal::read_parameter(np, internal_np::eigensolver, eigensolver);
    internal::read_parameter(np, internal_np::stabilization, stabilization);
    internal::read_parameter(np, internal_np::eigenvalues_only, eigenvalues_only);
  }
};

/// \ingroup PkgRestrictedLaplacian3Problems
/// The smallest eigenvalues and eigenfunctions of \f$-\Delta_{\mathcal M}\f$ on a spline space.
/// \param space the space; its finest level is used
/// \param count number of pairs, positive
/// \param options named parameters, or the options themselves:
/// \cgalNamedParamsBegin
///   \named_of_spectrum
/// \cgalNamedParamsEnd
/// \throws Parameter_error if a parameter is outside its domain, or if so many pairs would take
/// more than the `maximum_memory` of the space
/// \throws Numerical_error if a factorization fails
/// \throws Canceled if `progress` returned `false`
Laplace_spectrum laplace_spectrum(const Spline_space_3& space, int count,
                                  const Laplace_spectrum_options& options = {});

/// \ingroup PkgRestrictedLaplacian3Solvers
/// The smallest eigenvalues and eigenfunctions of \f$-\Delta_{\mathcal M}\f$ on a spline space:
/// \f$S \eta = \lambda M \eta\f$ (paper, section 5.1), without values at the vertices: the member
/// `vertex_values` remains empty.
/// \param space the space; its finest level is used
/// \param count number of pairs, positive
/// \param options named parameters, or the options themselves:
/// \cgalNamedParamsBegin
///   \named_of_spectrum
/// \cgalNamedParamsEnd
/// \throws Parameter_error if a parameter is outside its domain, or if so many pairs would take
/// more than the `maximum_memory` of the space
/// \throws Numerical_error if a factorization fails
/// \throws Canceled if `progress` returned `false`
Laplace_spectrum laplace_eigenpairs(const Spline_space_3& space, int count,
                                    const Laplace_spectrum_options& options = {});

namespace internal {

/// `multigrid_eigenpairs()` on a space, with operators of the levels from `coarsest` to depth
Eigenpairs multigrid_eigenpairs_of(const Spline_space_3& space, int coarsest,
                                   std::vector<Operators> operators, int count,
                                   const Multigrid_eigenpairs_options& options);

/// Computes eigenpairs in deeper and deeper spaces.
/// \param space the first one, and then that of the pairs
/// \param accuracy the estimated error that ends the search, or the memory of the spaces does
Laplace_spectrum laplace_eigenpairs_to_accuracy(Spline_space_3& space, int count,
                                                const Laplace_spectrum_options& options,
                                                double accuracy);
/// with values at the vertices, if eigenfunctions are of use
Laplace_spectrum laplace_spectrum_to_accuracy(Spline_space_3& space, int count,
                                              const Laplace_spectrum_options& options,
                                              double accuracy);

/// `cotangent_spectrum()` of a surface
Laplace_spectrum cotangent_eigenpairs(const Triangulated_surface_3& surface, int count,
                                      bool lumped_mass);

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/problems/space_spectrum_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_SPACE_SPECTRUM_H
