// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_GEODESICS_INTERNAL_TRIANGULATE_POINTS_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_GEODESICS_INTERNAL_TRIANGULATE_POINTS_IMPL_H

#include <CGAL/Restricted_laplacian_3/geodesics/internal/triangulate_points.h>

#include <CGAL/Advancing_front_surface_reconstruction.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// Which triangle of three points the advancing front takes next: the smallest first, and none
/// whose points have normals on different sides of it, or opposite to each other, as those on both
/// sides of something thin.
class Priority_by_normals {
public:
  /// is copied by CGAL, and refers to the surface
  explicit Priority_by_normals(const Triangulated_surface_3& points) : m_points(&points) {}

  template <class Advancing_front, class Cell_handle>
  double operator()(const Advancing_front& front, Cell_handle& cell, const int& index) const {
    std::array<std::size_t, 3> v;
    for(int k = 0; k < 3; ++k) {
      v[k] = cell->vertex((index + k + 1) % 4)->info();
      if(v[k] >= m_points->number_of_vertices())
        return front.infinity();
    }
    const Point_3& p = m_points->point(v[0]);
    const double scale = 1 / m_points->extent();
    const Vector_3 normal = CGAL::cross_product(scale * (m_points->point(v[1]) - p),
                                                scale * (m_points->point(v[2]) - p));
    double low = 0, high = 0;
    for(const std::size_t i : v) {
      low = (std::min)(low, normal * m_points->normal(i));
      high = (std::max)(high, normal * m_points->normal(i));
    }
    const double side = least_cosine * std::sqrt(normal.squared_length());
    bool is_opposite = low < -side && high > side;
    for(int k = 0; k < 3; ++k)
      is_opposite |= m_points->normal(v[k]) * m_points->normal(v[(k + 1) % 3]) < opposite;
    return is_opposite ? front.infinity() : front.smallest_radius_delaunay_sphere(cell, index);
  }

private:
  /// the cosine from which on a normal is on a side of a triangle
  static constexpr double least_cosine = 0.2;
  /// the cosine of the angle from which on normals are opposite
  static constexpr double opposite = -0.5;

  const Triangulated_surface_3* m_points;
};

CGAL_RESTRICTED_LAPLACIAN_3_INLINE std::vector<Triangulated_surface_3::Triangle>
triangulate_points(const Triangulated_surface_3& points) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  // in the unit of the extent, for squares of radii
  const Point_3 center = points.center();
  std::vector<Kernel::Point_3> unit_points;
  for(std::size_t i = 0; i < points.number_of_vertices(); ++i) {
    const Vector_3 v = (points.point(i) - center) / points.extent();
    unit_points.emplace_back(v.x(), v.y(), v.z());
  }
  // Points in a plane need a triangulation in space, too: points far away, of which no triangle is
  // made.
  constexpr double far = 50;
  for(const double x : {-far, far}) {
    unit_points.emplace_back(x, 0, 0);
    unit_points.emplace_back(0, x, 0);
    unit_points.emplace_back(0, 0, x);
  }
  std::vector<std::array<std::size_t, 3>> found;
  CGAL::advancing_front_surface_reconstruction(unit_points.begin(), unit_points.end(),
                                               std::back_inserter(found),
                                               Priority_by_normals(points));
  std::vector<Triangulated_surface_3::Triangle> triangles;
  for(const auto& t : found)
    triangles.push_back({static_cast<std::uint32_t>(t[0]), static_cast<std::uint32_t>(t[1]),
                         static_cast<std::uint32_t>(t[2])});
  return triangles;
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_GEODESICS_INTERNAL_TRIANGULATE_POINTS_IMPL_H
