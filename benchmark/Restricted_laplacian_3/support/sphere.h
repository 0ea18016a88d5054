// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_BENCHMARK_SPHERE_H
#define RESTRICTED_LAPLACIAN_3_BENCHMARK_SPHERE_H

#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace spheres {

using Surface = CGAL::Restricted_laplacian_3::Triangulated_surface_3;
using Point = CGAL::Restricted_laplacian_3::Point_3;
using Triangles = std::vector<std::array<std::uint32_t, 3>>;

/// a polyhedron around the origin, its triangles split in four `n` times, with all points projected
/// to the unit sphere
inline Surface subdivided(std::vector<Point> points, Triangles faces, int n) {
  const auto project = [](Point& p) {
    const auto v = p - CGAL::ORIGIN;
    p = CGAL::ORIGIN + v / std::sqrt(v.squared_length());
  };
  std::for_each(points.begin(), points.end(), project);
  for(int i = 0; i < n; ++i) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> midpoints;
    const auto midpoint = [&](std::uint32_t a, std::uint32_t b) {
      const auto [it, is_new] =
          midpoints.insert({std::minmax(a, b), static_cast<std::uint32_t>(points.size())});
      if(is_new) {
        points.push_back(CGAL::midpoint(points[a], points[b]));
        project(points.back());
      }
      return it->second;
    };
    Triangles finer;
    for(const auto& f : faces) {
      const std::uint32_t a = midpoint(f[0], f[1]), b = midpoint(f[1], f[2]),
                          c = midpoint(f[2], f[0]);
      finer.insert(finer.end(), {{f[0], a, c}, {a, f[1], b}, {c, b, f[2]}, {a, b, c}});
    }
    faces.swap(finer);
  }
  return Surface(std::move(points), std::move(faces));
}

} // namespace spheres

/// octahedron, split `n` times and projected to the unit sphere: 4^(n+1) + 2 vertices
inline spheres::Surface sphere(int n) {
  return spheres::subdivided(
      {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
      {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}, n);
}

/// the same of an icosahedron: 10 4^n + 2 vertices
inline spheres::Surface icosahedral_sphere(int n) {
  const double g = (1 + std::sqrt(5.)) / 2;
  return spheres::subdivided({{-1, g, 0},
                              {1, g, 0},
                              {-1, -g, 0},
                              {1, -g, 0},
                              {0, -1, g},
                              {0, 1, g},
                              {0, -1, -g},
                              {0, 1, -g},
                              {g, 0, -1},
                              {g, 0, 1},
                              {-g, 0, -1},
                              {-g, 0, 1}},
                             {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                              {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                              {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                              {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}},
                             n);
}

#endif // RESTRICTED_LAPLACIAN_3_BENCHMARK_SPHERE_H
