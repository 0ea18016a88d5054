// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SHARED_POINT_NEIGHBORHOOD_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SHARED_POINT_NEIGHBORHOOD_H

#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

/// \file
/// Points of a set and their neighbors in the tangent plane.

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// Points of a set that are the same and have normals within 90 degrees of each other, as one site.
struct Point_sites {
  std::vector<std::uint32_t> site_of_point;
  std::vector<std::uint32_t> number_of_points; // of sites, as all that follows
  std::vector<Point_3> points;
  std::vector<Vector_3> normals; // of unit length
};

/// The neighbors of a site in coordinates of its tangent plane: those whose normals are within 90
/// degrees of its own.
inline void project_neighbors(const Point_sites& sites, std::size_t site,
                              const std::vector<std::uint32_t>& neighbors,
                              std::vector<std::array<double, 2>>& projected) {
  const Vector_3& n = sites.normals[site];
  const auto [u, v] = tangent_axes(n);
  projected.clear();
  for(std::uint32_t j : neighbors)
    if(sites.normals[j] * n > 0) {
      const Vector_3 way = sites.points[j] - sites.points[site];
      projected.push_back({way * u, way * v});
    }
}

/// the largest angle between two neighbors that follow each other around the origin
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

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SHARED_POINT_NEIGHBORHOOD_H
