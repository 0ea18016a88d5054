// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SHARED_DIVIDE_POLYGON_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SHARED_DIVIDE_POLYGON_IMPL_H

#include <CGAL/Restricted_laplacian_3/surface/shared/divide_polygon.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>

#include <algorithm>
#include <array>
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
  std::array<std::size_t, 3> corners;

  Polygon_part(std::size_t i, std::size_t j, std::size_t k) : corners{i, j, k} {}
};

/// whether corners with finite coordinates turn by one angle below 180 degrees after the other, all
/// in one plane up to rounding errors
inline bool is_convex_in_plane(const std::vector<Point_3>& corners) {
  constexpr double tolerance = 1e-12;
  const std::size_t n = corners.size();
  // the area vector, of corners in units that avoid overflow
  double extent = 0;
  for(const Point_3& p : corners)
    for(int axis = 0; axis < 3; ++axis)
      extent = (std::max)(extent, std::abs(p[axis] - corners[0][axis]));
  const auto from_first = [&](std::size_t i) { return (corners[i % n] - corners[0]) / extent; };
  Vector_3 normal(0, 0, 0);
  for(std::size_t i = 2; i < n; ++i)
    normal = normal + CGAL::cross_product(from_first(i - 1), from_first(i));
  const double area = std::sqrt(normal.squared_length());
  const auto turns_left = [&](const Vector_3& a, const Vector_3& b) {
    const Vector_3 product = CGAL::cross_product(a, b);
    const double height = product * normal / area;
    return height > 1e-6 * std::sqrt(a.squared_length() * b.squared_length()) &&
           std::sqrt(product.squared_length()) <= height * (1 + tolerance);
  };
  for(std::size_t i = 1; i <= n; ++i) {
    const Vector_3 before = from_first(i) - from_first(i - 1),
                   after = from_first(i + 1) - from_first(i);
    if(!turns_left(before, after))
      return false;
    // and not more than once around
    if(i > 1 && i < n && !(CGAL::cross_product(from_first(i - 1), from_first(i)) * normal > 0))
      return false;
  }
  return true;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE std::vector<Triangulated_surface_3::Triangle>
divided_polygon(const std::vector<Point_3>& points, const std::vector<std::uint32_t>& polygon) {
  using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
  // The search for the best division takes the third power of the number of corners. In a plane
  // it takes no time.
  constexpr std::size_t many = 50, too_many = 500;
  if(polygon.size() == 3)
    return {{0, 1, 2}};
  // a side from a vertex to itself is none
  std::vector<std::uint32_t> positions;
  for(std::size_t i = 0; i < polygon.size(); ++i)
    if(positions.empty() || (polygon[i] != polygon[positions.back()] &&
                             (i + 1 < polygon.size() || polygon[i] != polygon[0])))
      positions.push_back(static_cast<std::uint32_t>(i));
  const std::size_t n = positions.size();
  std::vector<Point_3> corners;
  bool is_finite = true;
  for(const std::uint32_t position : positions) {
    const Point_3& p = points[polygon[position]];
    is_finite = is_finite && std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z());
    corners.push_back(p);
  }
  std::vector<Polygon_part> parts;
  if(is_finite && n > 3 && !is_convex_in_plane(corners)) {
    std::vector<Point> points_of_cgal;
    for(const Point_3& p : corners)
      points_of_cgal.emplace_back(p.x(), p.y(), p.z());
    CGAL::Polygon_mesh_processing::triangulate_hole_polyline(
        points_of_cgal, std::back_inserter(parts),
        CGAL::parameters::use_2d_constrained_delaunay_triangulation(n > many)
            .threshold_distance(n > many ? (std::numeric_limits<double>::max)() : -1)
            .use_delaunay_triangulation(false)
            .do_not_use_cubic_algorithm(n > too_many));
  }
  // also for a polygon that cannot be divided into triangles that all have an area
  if(parts.size() + 2 != n) {
    parts.clear();
    for(std::size_t i = 2; i < n; ++i)
      parts.emplace_back(0, i - 1, i);
  }
  std::vector<Triangulated_surface_3::Triangle> result;
  for(const Polygon_part& part : parts)
    result.push_back(
        {positions[part.corners[0]], positions[part.corners[1]], positions[part.corners[2]]});
  return result;
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SHARED_DIVIDE_POLYGON_IMPL_H
