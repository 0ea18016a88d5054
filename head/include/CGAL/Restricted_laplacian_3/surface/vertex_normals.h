// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_VERTEX_NORMALS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_VERTEX_NORMALS_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>

#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// \f$v / \lvert v \rvert\f$; the zero vector if \f$v\f$ is
Vector_3 unit_or_zero(const Vector_3& v);

} // namespace internal

/// \ingroup PkgRestrictedLaplacian3Fits
/// Unit normals at the vertices of a surface, in the order of `vertices(tm)`, to the side to which
/// the faces are oriented. The zero vector at vertices without a face of positive area, and where
/// the normals of the faces cancel.
///
/// They are means of the normals of the faces around with the weights of N. Max, *Weights for
/// computing vertex normals from facet normals*, Journal of Graphics Tools 4 (1999): the sine of
/// the angle between the two sides at the vertex, over the product of their lengths. On spheres
/// these are exact, and on smooth surfaces, above all with triangles of different shape, several
/// times as accurate as with areas or angles as weights.
///
/// At the boundary of an open surface the faces lie to one side, and their mean is the normal at
/// some distance from the vertex. There the normals are corrected: along an edge from \f$p\f$ to
/// \f$q\f$, \f$\langle n(p) + n(q), q - p \rangle\f$ is 0 up to terms of third order.
///
/// The points of a point set have their own normals.
///
/// Takes \f$O(F \log F)\f$ time for \f$F\f$ faces.
std::vector<Vector_3> vertex_normals(const Triangulated_surface_3& surface);

} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/surface/vertex_normals_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_VERTEX_NORMALS_H
