// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_SCALE_DETAILS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_SCALE_DETAILS_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>
#include <CGAL/Restricted_laplacian_3/problems/Edited_signal.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>

#include <Eigen/Core>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Problems
/// Multiplies what is smaller than a length by a factor, and leaves what is larger: waves of the
/// length \f$\lambda\f$ are multiplied by \f$1 - (1 - f) / (1 + (\lambda / \ell)^4)\f$, a
/// Butterworth filter of the Laplacian, \f$(1 + f) / 2\f$ for \f$\lambda = \ell\f$. It minimizes
/// for \f$f = 0\f$ \f$\int (\ell / 2 \pi)^4 (\Delta u)^2 + (u - x)^2\f$. No step has to be small:
/// it is found in a Krylov space, as by `Diffusion_solver`. What is smaller than cells is
/// multiplied by \f$f\f$.
///
/// Planes remain what they are, and their boundaries: the filter is of the Laplacian of \f$x\f$
/// itself, without what a natural condition would add along them.
/// \param space of a surface of triangles, with cells smaller than the length
/// \param length \f$\ell\f$, positive
/// \param factor \f$f\f$: 0 smooths, 2 sharpens
/// \param options named parameters, or the options themselves
/// \param signal \f$x\f$: a row for each vertex, a column for each component; if it is empty, the
/// positions
/// \throws Parameter_error if something is outside its domain
Edited_signal scale_details(const Spline_space_3& space, double length, double factor,
                            const Editing_options& options = {},
                            const Eigen::MatrixXd& signal = {});

/// \ingroup PkgRestrictedLaplacian3Problems
/// Smooths a surface and keeps its creases. First the normals of the faces are filtered: each
/// becomes a mean of those of the faces that share a vertex with it, with Gaussian weights for the
/// distance and for the angle between them \cgalCite{ZFAT11}, as often as it takes to spread over
/// the length. Then the surface is fitted to them: the gradients of its coordinates are turned as
/// the normals are, and the positions have these gradients as far as possible.
/// \param space of a surface of triangles, with cells not larger than half an edge
/// \param length \f$\ell\f$, positive: waves of this length are halved where the surface is smooth
/// \param options named parameters, or the options themselves, with a crease angle
/// \throws Parameter_error if something is outside its domain
Edited_signal smooth_between_creases(const Spline_space_3& space, double length,
                                     const Editing_options& options);

namespace internal {

/// The given space, or for creases without a depth of the caller one with cells of half an edge.
Spline_space_3 space_for_details(const Spline_space_3& space, bool has_depth,
                                 const Editing_options& options);

} // namespace internal

} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/problems/scale_details_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_SCALE_DETAILS_H
