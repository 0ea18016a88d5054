// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_MULTIGRID_LEVELS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_MULTIGRID_LEVELS_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>
#include <CGAL/Restricted_laplacian_3/solvers/Multigrid_levels.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Solvers
/// The patches of a level on which `Patch_smoother` works: one for each sheet of the next coarser
/// level, with all elements that act on one of its children. On a smooth surface these are about 50
/// of the \f$4 \times 4 \times 4\f$ elements around two cells by two by two.
///
/// A group consists of the patches in one block of \f$8 \times 8 \times 8\f$ coarser cells, its
/// color is the parity of the coordinates of the block. Two groups of the same color are 16 cells
/// apart; an element of a patch reaches 2 cells beyond the coarser cell, and elements that are 3
/// cells apart are not coupled.
/// \param space the space whose elements are grouped
/// \param level not 0
Smoothing_patches smoothing_patches(const Spline_space_3& space, int level);

/// \cond SKIP_IN_MANUAL
/// \ingroup PkgRestrictedLaplacian3Solvers
/// What a multigrid hierarchy needs of a space besides the matrices: prolongations and patches of
/// the levels from `coarsest` to depth.
/// \param space the space
/// \param coarsest from 0 to depth
Multigrid_levels multigrid_levels(const Spline_space_3& space, int coarsest);
/// \endcond

/// \cond SKIP_IN_MANUAL
/// \ingroup PkgRestrictedLaplacian3Solvers
/// The same from the finest level whose dense factorization takes no time that counts.
Multigrid_levels multigrid_levels(const Spline_space_3& space);
/// \endcond

} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/problems/multigrid_levels_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_MULTIGRID_LEVELS_H
