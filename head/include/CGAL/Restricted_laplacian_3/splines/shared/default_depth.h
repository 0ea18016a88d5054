// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_SHARED_DEFAULT_DEPTH_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_SHARED_DEFAULT_DEPTH_H

#include <CGAL/Restricted_laplacian_3/foundation/morton_key.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

/// \file
/// What `default_depth()` says: of a whole surface, or from what is known of its parts.

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// sum of the lengths of the sides of all faces
inline double sum_of_edges(const Triangulated_surface_3& surface) {
  // lengths may be so small that their squares are 0
  const double unit = surface.extent();
  double sum = 0;
  for(std::size_t face = 0; face < surface.number_of_faces(); ++face)
    for(int i = 0; i < 3; ++i) {
      const Vector_3 edge = surface.point(face, (i + 1) % 3) - surface.point(face, i);
      sum += std::hypot(edge.x() / unit, edge.y() / unit, edge.z() / unit);
    }
  return sum * unit;
}

/// \param sum of the lengths of all sides, over the side of the domain cube
inline int depth_of_edges(double sum, std::uint64_t number_of_faces) {
  constexpr int default_smallest_depth = 5;
  constexpr int default_largest_depth = 8;
  constexpr double least_edge_over_width = 0.5;
  const double mean = sum / (3. * static_cast<double>(number_of_faces));
  int depth = default_smallest_depth;
  while(depth < default_largest_depth && std::ldexp(mean, depth) < least_edge_over_width)
    ++depth;
  return depth;
}

/// the largest depth that is considered for points
constexpr int largest_depth_of_points = 6;

/// The Morton keys of the cells of that depth that hold points, ascending.
/// \param side of the domain cube
inline std::vector<std::uint64_t> cells_of_points(const Triangulated_surface_3& surface,
                                                  double side) {
  constexpr int cells_per_side = 1 << largest_depth_of_points;
  const Point_3 center = surface.center();
  std::vector<std::uint64_t> keys;
  keys.reserve(surface.number_of_vertices());
  for(std::size_t i = 0; i < surface.number_of_vertices(); ++i) {
    std::array<int, 3> index;
    for(int axis = 0; axis < 3; ++axis) {
      const double x = ((surface.point(i)[axis] - center[axis]) / side + 0.5) * cells_per_side;
      index[axis] = (std::min)((std::max)(static_cast<int>(x), 0), cells_per_side - 1);
    }
    keys.push_back(morton_key(index));
  }
  std::sort(keys.begin(), keys.end());
  keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
  return keys;
}

/// \param keys `cells_of_points()`
inline int depth_of_points(std::vector<std::uint64_t> keys, std::uint64_t number_of_points) {
  constexpr std::uint64_t points_per_cell = 50;
  for(int depth = largest_depth_of_points;; --depth) {
    keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
    if(depth == 1 || number_of_points >= points_per_cell * keys.size())
      return depth;
    for(std::uint64_t& key : keys)
      key >>= 3;
  }
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_SHARED_DEFAULT_DEPTH_H
