// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SHARED_DIVIDE_POLYGON_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SHARED_DIVIDE_POLYGON_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>

#include <cstdint>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// Divides a polygon into triangles; it need not be plane, convex or free of self-intersections. A
/// convex one in a plane becomes a fan around its first corner. Of the divisions of others, up to
/// 50 corners, that with the least bends and then the least area is taken; of more corners, one of
/// their shadow in the plane of two axes.
/// \param points those that the polygon names, and more
/// \param polygon numbers of points
/// \return positions of the corners of the triangles in the polygon. There are two triangles fewer
/// than corners, not counted those at the point before; none if fewer than three remain. A triangle
/// is one, whatever it names.
std::vector<Triangulated_surface_3::Triangle>
divided_polygon(const std::vector<Point_3>& points, const std::vector<std::uint32_t>& polygon);

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/surface/shared/divide_polygon_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SHARED_DIVIDE_POLYGON_H
