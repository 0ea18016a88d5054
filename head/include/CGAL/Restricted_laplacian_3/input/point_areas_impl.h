// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_INPUT_POINT_AREAS_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_INPUT_POINT_AREAS_IMPL_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parallel_for.h>
#include <CGAL/Restricted_laplacian_3/input/point_areas.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>
#include <CGAL/Restricted_laplacian_3/surface/shared/Nearest_points.h>
#include <CGAL/Restricted_laplacian_3/surface/shared/Point_neighborhood.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <string>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// A convex polygon around the origin, which is clipped to the Voronoi cell of the origin.
class Voronoi_cell_2 {
public:
  using Point = std::array<double, 2>;

  /// a regular polygon whose area is that of a disc
  explicit Voronoi_cell_2(double radius) {
    constexpr int size = 16;
    constexpr double pi = 3.14159265358979323846, angle = 2 * pi / size;
    const double r = radius * std::sqrt(angle / std::sin(angle));
    for(int i = 0; i < size; ++i)
      m_corners.push_back({r * std::cos(i * angle), r * std::sin(i * angle)});
  }

  /// keeps what is nearer to the origin than to `p`
  void clip(const Point& p) {
    const double limit = (p[0] * p[0] + p[1] * p[1]) / 2;
    m_next.clear();
    for(std::size_t i = 0; i < m_corners.size(); ++i) {
      const Point &a = m_corners[i], &b = m_corners[i + 1 < m_corners.size() ? i + 1 : 0];
      const double side_a = p[0] * a[0] + p[1] * a[1] - limit,
                   side_b = p[0] * b[0] + p[1] * b[1] - limit;
      if(side_a <= 0)
        m_next.push_back(a);
      if((side_a < 0 && side_b > 0) || (side_a > 0 && side_b < 0)) {
        const double t = side_a / (side_a - side_b);
        m_next.push_back({a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])});
      }
    }
    m_corners.swap(m_next);
  }

  double area() const {
    double sum = 0;
    for(std::size_t i = 0; i < m_corners.size(); ++i) {
      const Point &a = m_corners[i], &b = m_corners[i + 1 < m_corners.size() ? i + 1 : 0];
      sum += a[0] * b[1] - a[1] * b[0];
    }
    return sum / 2;
  }

private:
  std::vector<Point> m_corners, m_next;
};

inline Point_sites unite_same_points(const std::vector<Point_3>& points,
                                     const std::vector<Vector_3>& normals) {
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
    return points[i] != points[j] ? CGAL::lexicographically_xyz_smaller(points[i], points[j])
                                  : i < j;
  });
  Point_sites sites;
  sites.site_of_point.resize(points.size());
  std::size_t first = 0; // site at the current point
  for(std::uint32_t i : order) {
    const Vector_3 normal = unit_vector(normals[i]);
    if(!sites.points.empty() && sites.points.back() != points[i])
      first = sites.points.size();
    std::size_t site = first;
    while(site < sites.points.size() && !(sites.normals[site] * normal > 0))
      ++site;
    if(site == sites.points.size()) {
      sites.points.push_back(points[i]);
      sites.normals.push_back(normal);
      sites.number_of_points.push_back(0);
    }
    sites.site_of_point[i] = static_cast<std::uint32_t>(site);
    ++sites.number_of_points[site];
  }
  return sites;
}

/// \param neighbors in the tangent plane
inline double tangent_cell_area(std::vector<std::array<double, 2>>& neighbors) {
  // A site whose neighbors leave nearly half of the plane empty is on the border.
  constexpr double smallest_gap_at_border = 2.8;
  constexpr double largest_radius = 2;
  if(neighbors.empty())
    return 0;
  double squared_radius = 0;
  for(const auto& p : neighbors)
    squared_radius = (std::max)(squared_radius, p[0] * p[0] + p[1] * p[1]);
  constexpr double pi = 3.14159265358979323846;
  const double spacing = std::sqrt(pi * squared_radius / static_cast<double>(neighbors.size()));
  Voronoi_cell_2 cell(largest_radius * spacing);
  for(const auto& p : neighbors)
    cell.clip(p);
  if(largest_gap(neighbors) > smallest_gap_at_border)
    for(const auto& p : neighbors)
      cell.clip({-p[0], -p[1]});
  return cell.area();
}

} // namespace internal

CGAL_RESTRICTED_LAPLACIAN_3_INLINE std::vector<double>
estimate_point_areas(const std::vector<Point_3>& points, const std::vector<Vector_3>& normals,
                     int number_of_neighbors, bool is_parallel) {
  if(number_of_neighbors < 3)
    throw Parameter_error("neighbors",
                          "is " + std::to_string(number_of_neighbors) + ", but must be at least 3");
  if(points.size() != normals.size())
    throw Parameter_error("points", "has another length than normals");
  std::vector<double> areas(points.size());
  if(points.empty())
    return areas;
  for(std::size_t i = 0; i < points.size(); ++i)
    internal::check_oriented_point(i, points[i], normals[i]);
  const internal::Point_sites sites = internal::unite_same_points(points, normals);
  const internal::Nearest_points nearest(sites.points);
  std::vector<double> area_of_site(sites.points.size());
  internal::parallel_for(
      is_parallel, 0, area_of_site.size(), 1 << 11, [&](std::size_t begin, std::size_t end) {
        std::vector<std::uint32_t> neighbors;
        std::vector<std::array<double, 2>> projected;
        for(std::size_t i = begin; i < end; ++i) {
          nearest.find(i, static_cast<std::size_t>(number_of_neighbors), neighbors);
          internal::project_neighbors(sites, i, neighbors, projected);
          area_of_site[i] = internal::tangent_cell_area(projected);
        }
      });
  for(std::size_t i = 0; i < points.size(); ++i) {
    const std::uint32_t site = sites.site_of_point[i];
    areas[i] = area_of_site[site] / sites.number_of_points[site];
  }
  return areas;
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_INPUT_POINT_AREAS_IMPL_H
