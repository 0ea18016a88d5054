// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_POINT_AREAS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_POINT_AREAS_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parallel_for.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>
#include <CGAL/Restricted_laplacian_3/surface/internal/Nearest_points.h>

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

/// \ingroup PkgRestrictedLaplacian3Functions
/// How many neighbours `estimate_point_areas()` looks at unless told otherwise.
constexpr int default_number_of_neighbors = 16;

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

/// Points of a set that are the same and have normals within 90 degrees of each other, as one site.
struct Point_sites {
  std::vector<std::uint32_t> site_of_point;
  std::vector<std::uint32_t> number_of_points; // of sites, as all that follows
  std::vector<Point_3> points;
  std::vector<Vector_3> normals; // of unit length
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

/// The neighbours of a site in coordinates of its tangent plane: those whose normals are within 90
/// degrees of its own.
inline void project_neighbors(const Point_sites& sites, std::size_t site,
                              const std::vector<std::uint32_t>& neighbors,
                              std::vector<std::array<double, 2>>& projected) {
  const Vector_3& n = sites.normals[site];
  // The axis that is farthest from the normal gives the first direction.
  const double x = std::abs(n.x()), y = std::abs(n.y()), z = std::abs(n.z());
  const Vector_3 axis = x <= y && x <= z ? Vector_3(1, 0, 0)
                        : y <= z         ? Vector_3(0, 1, 0)
                                         : Vector_3(0, 0, 1);
  const Vector_3 u = unit_vector(CGAL::cross_product(n, axis)), v = CGAL::cross_product(n, u);
  projected.clear();
  for(std::uint32_t j : neighbors)
    if(sites.normals[j] * n > 0) {
      const Vector_3 way = sites.points[j] - sites.points[site];
      projected.push_back({way * u, way * v});
    }
}

/// the largest angle between two neighbours that follow each other around the origin
inline double largest_gap(const std::vector<std::array<double, 2>>& neighbors) {
  constexpr double pi = 3.14159265358979323846;
  std::vector<double> angles;
  for(const auto& p : neighbors)
    angles.push_back(std::atan2(p[1], p[0]));
  std::sort(angles.begin(), angles.end());
  double gap = angles.front() + 2 * pi - angles.back();
  for(std::size_t i = 1; i < angles.size(); ++i)
    gap = (std::max)(gap, angles[i] - angles[i - 1]);
  return gap;
}

/// \param neighbors in the tangent plane
inline double tangent_cell_area(std::vector<std::array<double, 2>>& neighbors) {
  // A site whose neighbours leave nearly half of the plane empty is on the border.
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

/// \ingroup PkgRestrictedLaplacian3Functions
/// The area that each point of a set stands for, from the density of the points around it: the
/// Voronoi cell of the point among its `number_of_neighbors` nearest neighbours, in its tangent
/// plane.
///
/// Neighbours whose normals are more than 90 degrees away from that of the point are left out: they
/// are on the other side of something thin. A point on the border of an open surface is told by
/// half of the directions around it being empty; its cell reaches as far outwards as inwards. No
/// cell is larger than a disc of twice the local distance of points.
/// Points that are the same share their cell. A point without neighbours that agree has area 0.
///
/// \param points the points; some may be the same
/// \param normals of any length, oriented alike
/// \param number_of_neighbors at least 3
/// \param is_parallel whether several threads are used, if the program is linked with TBB; the
/// result is the same
/// \return areas in units of squared coordinates
/// \throws Invalid_point_error a coordinate or a normal is not finite, or a normal is zero
/// \throws Parameter_error `number_of_neighbors` is less than 3, or the vectors differ in length
/// Takes \f$O(n \log n)\f$ time for \f$n\f$ points.
inline std::vector<double>
estimate_point_areas(const std::vector<Point_3>& points, const std::vector<Vector_3>& normals,
                     int number_of_neighbors = default_number_of_neighbors,
                     bool is_parallel = false) {
  if(number_of_neighbors < 3)
    throw Parameter_error("number_of_neighbors",
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

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_POINT_AREAS_H
