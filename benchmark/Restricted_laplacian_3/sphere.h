// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_BENCHMARK_SPHERE_H
#define RESTRICTED_LAPLACIAN_3_BENCHMARK_SPHERE_H

#include <CGAL/Restricted_laplacian_3/Triangulated_surface_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

/// octahedron, split `n` times and projected to the unit sphere
inline CGAL::Restricted_laplacian_3::Triangulated_surface_3 sphere(int n) {
  namespace RL = CGAL::Restricted_laplacian_3;
  using Triangles = std::vector<std::array<std::uint32_t, 3>>;
  std::vector<RL::Point_3> points = {{1, 0, 0},  {-1, 0, 0}, {0, 1, 0},
                                     {0, -1, 0}, {0, 0, 1},  {0, 0, -1}};
  Triangles faces = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                     {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for(int i = 0; i < n; ++i) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> midpoints;
    const auto midpoint = [&](std::uint32_t a, std::uint32_t b) {
      const auto [it, is_new] =
          midpoints.insert({std::minmax(a, b), static_cast<std::uint32_t>(points.size())});
      if(is_new) {
        const RL::Vector_3 v = (points[a] - CGAL::ORIGIN) + (points[b] - CGAL::ORIGIN);
        points.push_back(CGAL::ORIGIN + v / std::sqrt(v.squared_length()));
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
  return RL::Triangulated_surface_3(std::move(points), std::move(faces));
}

#endif // RESTRICTED_LAPLACIAN_3_BENCHMARK_SPHERE_H
