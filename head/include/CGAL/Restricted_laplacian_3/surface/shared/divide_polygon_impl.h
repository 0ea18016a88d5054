// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SHARED_DIVIDE_POLYGON_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SHARED_DIVIDE_POLYGON_IMPL_H

#include <CGAL/Restricted_laplacian_3/surface/shared/divide_polygon.h>

#include <CGAL/Restricted_laplacian_3/surface/internal/Ear_clipping.h>
#include <CGAL/Restricted_laplacian_3/surface/internal/Least_bent_division.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// The corners of a polygon without its sides from a vertex to itself, in a unit that makes the
/// largest side of its box about 1, and only differs by a power of two.
class Divided_polygon {
public:
  using Triangle = Triangulated_surface_3::Triangle;

  Divided_polygon(const std::vector<Point_3>& points, const std::vector<std::uint32_t>& polygon) {
    for(std::size_t i = 0; i < polygon.size(); ++i)
      if(m_positions.empty() || (polygon[i] != polygon[m_positions.back()] &&
                                 (i + 1 < polygon.size() || polygon[i] != polygon[0])))
        m_positions.push_back(static_cast<std::uint32_t>(i));
    double extent = 0;
    for(const std::uint32_t position : m_positions) {
      const Point_3& p = points[polygon[position]];
      m_corners.push_back(p);
      for(int axis = 0; axis < 3; ++axis) {
        const double distance = std::abs(p[axis] - m_corners[0][axis]);
        m_is_finite = m_is_finite && std::isfinite(distance);
        extent = (std::max)(extent, distance);
      }
    }
    if(!m_is_finite || extent == 0)
      return;
    int exponent = 0;
    std::frexp(extent, &exponent);
    for(Point_3& p : m_corners)
      p = Point_3(std::ldexp(p.x(), -exponent), std::ldexp(p.y(), -exponent),
                  std::ldexp(p.z(), -exponent));
    for(std::size_t i = 2; i < m_corners.size(); ++i)
      m_area_vector = m_area_vector + CGAL::cross_product(from_first(i - 1), from_first(i));
  }

  std::vector<Triangle> triangles() const {
    // The search for the best division takes the third power of the number of corners.
    constexpr std::size_t many = 50;
    const std::size_t n = m_positions.size();
    std::vector<Triangle> result;
    if(m_is_finite && n > 3 && !is_convex_in_plane())
      result = n <= many ? Least_bent_division(m_corners).triangles()
                         : Ear_clipping(shadow()).triangles();
    // also for a polygon that cannot be divided into triangles that all have an area
    if(result.empty())
      for(std::uint32_t i = 2; i < n; ++i)
        result.push_back({0, i - 1, i});
    for(Triangle& triangle : result)
      for(std::uint32_t& corner : triangle)
        corner = m_positions[corner];
    return result;
  }

private:
  Vector_3 from_first(std::size_t i) const {
    return m_corners[i % m_corners.size()] - m_corners[0];
  }

  /// whether the corners turn by one angle below 180 degrees after the other, all in one plane up
  /// to rounding errors
  bool is_convex_in_plane() const {
    constexpr double tolerance = 1e-12;
    const std::size_t n = m_corners.size();
    const double area = std::sqrt(m_area_vector.squared_length());
    const auto turns_left = [&](const Vector_3& a, const Vector_3& b) {
      const Vector_3 product = CGAL::cross_product(a, b);
      const double height = product * m_area_vector / area;
      return height > 1e-6 * std::sqrt(a.squared_length() * b.squared_length()) &&
             std::sqrt(product.squared_length()) <= height * (1 + tolerance);
    };
    for(std::size_t i = 1; i <= n; ++i) {
      if(!turns_left(from_first(i) - from_first(i - 1), from_first(i + 1) - from_first(i)))
        return false;
      // and not more than once around
      if(i > 1 && i < n &&
         !(CGAL::cross_product(from_first(i - 1), from_first(i)) * m_area_vector > 0))
        return false;
    }
    return true;
  }

  /// the corners in the plane of the two axes in which the area is largest, counterclockwise
  std::vector<Ear_clipping::Place> shadow() const {
    int axis = 0; // the one that is left out
    for(const int other : {1, 2})
      if(std::abs(m_area_vector[other]) > std::abs(m_area_vector[axis]))
        axis = other;
    int x = (axis + 1) % 3, y = (axis + 2) % 3;
    if(m_area_vector[axis] < 0)
      std::swap(x, y);
    std::vector<Ear_clipping::Place> result;
    for(const Point_3& p : m_corners)
      result.push_back({p[x], p[y]});
    return result;
  }

  std::vector<std::uint32_t> m_positions;
  std::vector<Point_3> m_corners;
  Vector_3 m_area_vector = Vector_3(0, 0, 0); ///< twice
  bool m_is_finite = true;
};

CGAL_RESTRICTED_LAPLACIAN_3_INLINE std::vector<Triangulated_surface_3::Triangle>
divided_polygon(const std::vector<Point_3>& points, const std::vector<std::uint32_t>& polygon) {
  if(polygon.size() == 3)
    return {{0, 1, 2}};
  return Divided_polygon(points, polygon).triangles();
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SHARED_DIVIDE_POLYGON_IMPL_H
