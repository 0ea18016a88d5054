// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_ESTIMATE_MEMORY_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_ESTIMATE_MEMORY_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Options
/// How large a spline space is, and how much memory a Poisson problem in it takes.
struct Memory_estimate {
  /// number of unknowns
  double dimension;
  /// bytes of the surface, whatever the depth
  double surface;
  /// bytes of the space, and of the matrices and the multigrid solver of a Poisson problem; or of
  /// what is needed to make the space, if that is more
  double solver;

  /// bytes of both
  double total() const { return surface + solver; }
};

/// \ingroup PkgRestrictedLaplacian3Options
/// Tells before any work how much memory a depth takes.
///
/// A plane piece of a surface, with the unit normal \f$n\f$ and the area \f$A\f$, meets
/// \f$\lVert n \rVert_1 A / h^2\f$ cells of width \f$h\f$; to a cell belong 3 unknowns, and about
/// 7 kB. That is right within some percent where pieces are larger than cells. With many
/// boundaries, as in ragged scans, there are up to three times as many unknowns at small depths;
/// without splitting, and where many layers lie in one cell, fewer. Of the parts of triangles in
/// cells, at most some four million are held at once, 140 bytes each. Eigenvectors, values at
/// vertices and what is made of them come on top, 8 bytes for each number.
///
/// Takes time linear in the number of faces.
/// \param surface triangles, or points
/// \param depth of the octree
/// \param cube_scale side of the domain cube over the longest side of the bounding box, from 1 to
/// \f$10^6\f$
/// \throws Parameter_error if `cube_scale` is out of range
Memory_estimate estimate_memory(const Triangulated_surface_3& surface, int depth,
                                double cube_scale = 1.1);

namespace internal {

/// What a space of this dimension has, once it is made, without a look at the faces.
Memory_estimate memory_of_space(const Triangulated_surface_3& surface, double dimension);

/// \param maximum in bytes
/// \throws Parameter_error if the estimate is larger, with the depths that would do
void check_memory(const Triangulated_surface_3& surface, int depth, double cube_scale,
                  double maximum);

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/splines/estimate_memory_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_ESTIMATE_MEMORY_H
