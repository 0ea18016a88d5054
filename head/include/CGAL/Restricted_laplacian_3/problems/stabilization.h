// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_STABILIZATION_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_STABILIZATION_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/parameters.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>

#include <algorithm>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \file
/// How strongly each problem is stabilized, unless told otherwise: the factor \f$c\f$ of
/// `assemble_operators()`. All of these decisions are here.

/// \ingroup PkgRestrictedLaplacian3Solvers
/// For Poisson problems and gradient fields: 1e-3, and 0 in the space of the paper. The number of
/// iterations does not depend on the depth of the octree then, while the error of the solution is
/// up to about twice that without stabilization.
inline double default_stabilization(const Spline_space_3& space) {
  return space.is_paper_space() ? 0 : 1e-3;
}

/// \ingroup PkgRestrictedLaplacian3Solvers
/// For `laplace_spectrum()`, of the stiffness matrix alone: 1e-5, and 0 in the space of the paper.
/// With it `multigrid_eigenpairs()` needs few iterations on any surface, while eigenvalues change
/// by no more than the discretization changes them.
inline double default_spectrum_stabilization(const Spline_space_3& space) {
  return space.is_paper_space() ? 0 : 1e-5;
}

namespace internal {

/// the smoothing weight in units of the squared cell width
inline double smoothing_in_cells(const Spline_space_3& space, double smoothing) {
  const double h = space.octree().cell_width(space.depth());
  return smoothing / (h * h);
}

} // namespace internal

/// \cond SKIP_IN_MANUAL
/// \ingroup PkgRestrictedLaplacian3Fits
/// For fits, `Function_fitter::fit()`: 1e-14, as small as rounding permits, so that the error is
/// that of the space. The iteration ends by what shows on the surface, see there, and need not
/// resolve what the stabilization is for. Smoothing with the weight \f$w\f$ is iterated up to small
/// residuals; then \f$10^{-3}\, w / h^2\f$ with the cell width \f$h\f$, as in the Poisson problem,
/// but not more than 1e-4.
/// \param space the space of the fit
/// \param smoothing \f$w\f$, in units of length^2
inline double default_fit_stabilization(const Spline_space_3& space, double smoothing = 0) {
  constexpr double smallest = 1e-14, largest = 1e-4, of_smoothing = 1e-3;
  return std::clamp(of_smoothing * internal::smoothing_in_cells(space, smoothing), smallest,
                    largest);
}
/// \endcond

/// \cond SKIP_IN_MANUAL
/// \ingroup PkgRestrictedLaplacian3Fits
/// Factor of the stabilization for `Function_fitter::project()`: nothing is known there of the
/// functions but their loads, so the iteration ends by the residual.
constexpr double default_projection_stabilization = 1e-4;
/// \endcond

/// \cond SKIP_IN_MANUAL
/// \ingroup PkgRestrictedLaplacian3Fits
/// Factor of the stabilization for `estimate_curvature()`: larger than for other fits, because it
/// is the derivatives that count.
constexpr double default_curvature_stabilization = 0.01;
/// \endcond

namespace internal {

/// The end of the iteration of a fit: the estimated error in the norm of the energy, over the
/// square root of what is minimized; 0 if the residual alone counts. In a least-squares problem
/// errors add as squares: with 0.1, the root mean square error is larger than the least one by half
/// a percent. Where waves as long as cells are wide are smoothed by more than a thousandth or so,
/// what is minimized says nothing of the error that is wanted.
inline double default_fit_tolerance(const Spline_space_3& space, double smoothing) {
  constexpr double least_smoothing = 1e-3;
  return smoothing_in_cells(space, smoothing) <= least_smoothing ? 0.1 : 0;
}

/// The same for `estimate_curvature()`, small because it is the derivatives that count: on a ragged
/// scan the mean curvature differs by 3e-4, root mean square over root mean square, from that of
/// the solved system.
constexpr double default_curvature_tolerance = 3e-4;

/// the value of `stabilization`, by default that of the space
template <class NamedParameters>
double stabilization(const Spline_space_3& space, const NamedParameters& np) {
  double result = default_stabilization(space);
  read_parameter(np, internal_np::stabilization, result);
  return result;
}

} // namespace internal

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_STABILIZATION_H
