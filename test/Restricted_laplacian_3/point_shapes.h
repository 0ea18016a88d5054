// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_TEST_POINT_SHAPES_H
#define RESTRICTED_LAPLACIAN_3_TEST_POINT_SHAPES_H

#include <CGAL/Restricted_laplacian_3/surface/Surface_location.h>

#include <cmath>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

/// \file
/// Oriented points on shapes, from formulas.

namespace shapes {

using Oriented_point =
    std::pair<CGAL::Restricted_laplacian_3::Point_3, CGAL::Restricted_laplacian_3::Vector_3>;
using Oriented_points = std::vector<Oriented_point>;

constexpr double point_shapes_pi = 3.14159265358979323846;

/// `n` points on the unit sphere along a spiral, each with the same area
inline Oriented_points sphere_points(int n) {
  Oriented_points result;
  for(int i = 0; i < n; ++i) {
    const double z = 2 * (i + 0.5) / n - 1, r = std::sqrt(1 - z * z),
                 angle = point_shapes_pi * (3 - std::sqrt(5.)) * i;
    const CGAL::Restricted_laplacian_3::Vector_3 v(r * std::cos(angle), r * std::sin(angle), z);
    result.emplace_back(CGAL::ORIGIN + v, v);
  }
  return result;
}

/// `n` independent random points on the unit sphere
inline Oriented_points random_sphere_points(int n, unsigned seed) {
  std::mt19937 generator(seed);
  const auto uniform = [&generator] { return std::ldexp(generator() + 0.5, -32); };
  Oriented_points result;
  for(int i = 0; i < n; ++i) {
    const double z = 2 * uniform() - 1, r = std::sqrt(1 - z * z),
                 angle = 2 * point_shapes_pi * uniform();
    const CGAL::Restricted_laplacian_3::Vector_3 v(r * std::cos(angle), r * std::sin(angle), z);
    result.emplace_back(CGAL::ORIGIN + v, v);
  }
  return result;
}

/// `n` points on a torus around the z axis, each with the same area
inline Oriented_points torus_points(int n, double large_radius, double small_radius) {
  Oriented_points result;
  for(int i = 0; i < n; ++i) {
    // v + (r / R) sin v is proportional to the area within the angle v of the outer equator
    const double target = 2 * point_shapes_pi * (i + 0.5) / n, q = small_radius / large_radius;
    double v = target;
    for(int k = 0; k < 50; ++k)
      v -= (v + q * std::sin(v) - target) / (1 + q * std::cos(v));
    const double u = point_shapes_pi * (3 - std::sqrt(5.)) * i;
    const CGAL::Restricted_laplacian_3::Vector_3 out(std::cos(u), std::sin(u), 0);
    const CGAL::Restricted_laplacian_3::Vector_3 normal =
        std::cos(v) * out + CGAL::Restricted_laplacian_3::Vector_3(0, 0, std::sin(v));
    result.emplace_back(CGAL::ORIGIN + large_radius * out + small_radius * normal, normal);
  }
  return result;
}

/// `n` x `n` points in the middles of the squares of a grid on [0, 1] x [0, 1] at height `z`
inline Oriented_points square_points(int n, double z, double normal_z) {
  Oriented_points result;
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < n; ++j)
      result.push_back({{(i + 0.5) / n, (j + 0.5) / n, z}, {0, 0, normal_z}});
  return result;
}

/// `n` x `n` points in each side of the unit cube
inline Oriented_points cube_points(int n) {
  Oriented_points result;
  for(int axis = 0; axis < 3; ++axis)
    for(int side = 0; side < 2; ++side)
      for(const Oriented_point& p : square_points(n, side, 2 * side - 1)) {
        double x[3], v[3];
        for(int k = 0; k < 3; ++k) {
          x[(axis + 1 + k) % 3] = p.first[k];
          v[(axis + 1 + k) % 3] = p.second[k];
        }
        result.push_back({{x[0], x[1], x[2]}, {v[0], v[1], v[2]}});
      }
  return result;
}

} // namespace shapes

#endif // RESTRICTED_LAPLACIAN_3_TEST_POINT_SHAPES_H
