// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SHARED_DIVIDE_POLYGON_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SHARED_DIVIDE_POLYGON_IMPL_H

#include <CGAL/Restricted_laplacian_3/surface/shared/divide_polygon.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// The corners of a triangle among those of a polygon. A type of its own keeps this instance of
/// CGAL's templates, which may be compiled without 3D triangulations, apart from those of callers.
struct Polygon_part {
  std::size_t first, second, third;

  Polygon_part(std::size_t i, std::size_t j, std::size_t k) : first(i), second(j), third(k) {}
};

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void
divide_polygon(const std::vector<Point_3>& points, std::vector<std::uint32_t> polygon,
               std::vector<Triangulated_surface_3::Triangle>& triangles) {
  using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
  // The search for the best division takes the third power of the number of corners. In a plane
  // it takes no time.
  constexpr std::size_t many = 50, too_many = 500;
  std::vector<Polygon_part> parts;
  if(polygon.size() > 3) {
    // a side from a vertex to itself is none
    polygon.erase(std::unique(polygon.begin(), polygon.end()), polygon.end());
    if(polygon.size() > 1 && polygon.front() == polygon.back())
      polygon.pop_back();
    std::vector<Point> corners;
    bool is_finite = true;
    for(const std::uint32_t vertex : polygon) {
      const Point_3& p = points[vertex];
      is_finite = is_finite && std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z());
      corners.emplace_back(p.x(), p.y(), p.z());
    }
    if(is_finite && polygon.size() > 3)
      CGAL::Polygon_mesh_processing::triangulate_hole_polyline(
          corners, std::back_inserter(parts),
          CGAL::parameters::use_2d_constrained_delaunay_triangulation(polygon.size() > many)
              .threshold_distance(polygon.size() > many ? (std::numeric_limits<double>::max)() : -1)
              .use_delaunay_triangulation(false)
              .do_not_use_cubic_algorithm(polygon.size() > too_many));
  }
  // a triangle, or a polygon that cannot be divided into triangles that all have an area: a fan
  if(parts.size() + 2 != polygon.size()) {
    parts.clear();
    for(std::size_t i = 2; i < polygon.size(); ++i)
      parts.emplace_back(0, i - 1, i);
  }
  for(const Polygon_part& part : parts)
    triangles.push_back({polygon[part.first], polygon[part.second], polygon[part.third]});
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SHARED_DIVIDE_POLYGON_IMPL_H
