// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_PROLONGATION_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_PROLONGATION_H

#include <CGAL/Restricted_laplacian_3/foundation/Sparse_matrix.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>

#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Operators
/// The matrix \f$P\f$ that writes a function of a level in terms of the next finer one:
/// \f$ \sum_j \eta_j b^l_j = \sum_i (P \eta)_i b^{l+1}_i \f$, `dimension(level + 1)` rows and
/// `dimension(level)` columns. Its columns hold the \f$4 \times 4 \times 4\f$ stencil
/// \f$\frac14 (1\ 3\ 3\ 1)^{\otimes 3}\f$ (paper, section 4.2), as far as the elements exist. Its
/// transpose restricts residuals. In the space of the paper the stencil is cut off at the boundary
/// of the grid, and the relation holds only away from it.
/// \throws Parameter_error if `level` is not from 0 to depth - 1
Sparse_matrix prolongation_matrix(const Spline_space_3& space, int level);

/// \cond SKIP_IN_MANUAL
/// \ingroup PkgRestrictedLaplacian3Operators
/// The prolongations from `coarsest` to `coarsest + 1`, ..., from depth - 1 to depth.
std::vector<Sparse_matrix> prolongation_matrices(const Spline_space_3& space, int coarsest);
/// \endcond

namespace internal {

/// The coarsest level of a hierarchy: the finest one whose dense factorization takes no time that
/// counts. It is done for each connected component of the surface, which is a sheet of level 0.
int coarsest_multigrid_level(const Spline_space_3& space);

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/splines/prolongation_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_PROLONGATION_H
