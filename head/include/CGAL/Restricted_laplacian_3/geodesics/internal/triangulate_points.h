// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_GEODESICS_INTERNAL_TRIANGULATE_POINTS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_GEODESICS_INTERNAL_TRIANGULATE_POINTS_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>

#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// Triangles between points, by the advancing front of \cgal (Cohen-Steiner, Da 2004): the surface
/// that interpolates them. Of points that are the same, one is used.
std::vector<Triangulated_surface_3::Triangle>
triangulate_points(const Triangulated_surface_3& points);

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/geodesics/internal/triangulate_points_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_GEODESICS_INTERNAL_TRIANGULATE_POINTS_H
