// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_TEST_SPECIAL_SHAPES_H
#define RESTRICTED_LAPLACIAN_3_TEST_SPECIAL_SHAPES_H

#include "shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

/// \file
/// Open shapes in special positions, and changes of shapes.

namespace shapes {

/// the rectangle [0, x] x [0, y] in the plane z = 0, of two triangles
inline Triangles rectangle(double x, double y) {
  return {{{0, 0, 0}, {x, 0, 0}, {x, y, 0}, {0, y, 0}}, {{0, 1, 2}, {0, 2, 3}}};
}

/// `n` steps of width and height `step`: with `n` cells a side of the domain cube and cube scale 1
/// all faces lie in walls
inline Triangles stairs(int n, double step) {
  Triangles t;
  for(int k = 0; k < n; ++k) {
    const double low = step * k, high = step * (k + 1), width = step * n;
    const auto first = static_cast<std::uint32_t>(t.points.size());
    t.points.insert(t.points.end(), {{low, 0, low},
                                     {high, 0, low},
                                     {high, width, low},
                                     {low, width, low},
                                     {high, 0, high},
                                     {high, width, high}});
    for(const auto& f : {std::array<std::uint32_t, 3>{0, 1, 2}, {0, 2, 3}, {1, 4, 5}, {1, 5, 2}})
      t.faces.push_back({first + f[0], first + f[1], first + f[2]});
  }
  return t;
}

/// how the squares of a grid are cut
enum class Diagonals { rising, falling, alternating };

/// a grid over [0, 1]^2, taken to space
template <class Map>
Triangles grid(int n, Map&& map, Diagonals diagonals = Diagonals::alternating) {
  Triangles t;
  for(int j = 0; j <= n; ++j)
    for(int i = 0; i <= n; ++i)
      t.points.push_back(map(double(i) / n, double(j) / n));
  for(int j = 0; j < n; ++j)
    for(int i = 0; i < n; ++i) {
      const auto a = static_cast<std::uint32_t>(i + (n + 1) * j), b = a + 1,
                 c = static_cast<std::uint32_t>(a + n + 2), d = c - 1;
      if(diagonals == Diagonals::rising ||
         (diagonals == Diagonals::alternating && (i + j) % 2 != 0)) {
        t.faces.push_back({a, b, c});
        t.faces.push_back({a, c, d});
      } else {
        t.faces.push_back({a, b, d});
        t.faces.push_back({b, c, d});
      }
    }
  return t;
}

/// A part of a plane in polar coordinates, from a radius to 1 and from the direction of x to an
/// angle: `n` rings of `m` sectors. An angle of a full turn closes the rings.
inline Triangles sector(int n, int m, double inner_radius, double angle) {
  const double full_turn = 2 * std::acos(-1.);
  const bool is_closed = angle > full_turn - 1e-9;
  const auto columns = static_cast<std::uint32_t>(is_closed ? m : m + 1);
  Triangles t;
  const auto index = [&](int i, int j) -> std::uint32_t {
    if(inner_radius == 0 && i == 0)
      return 0;
    const auto ring = static_cast<std::uint32_t>(inner_radius == 0 ? i - 1 : i);
    return (inner_radius == 0 ? 1 : 0) + ring * columns + static_cast<std::uint32_t>(j) % columns;
  };
  for(int i = 0; i <= n; ++i)
    for(std::uint32_t j = 0; j < columns; ++j)
      if(i > 0 || inner_radius > 0 || j == 0) {
        const double r = inner_radius + (1 - inner_radius) * i / n, phi = angle * j / m;
        t.points.push_back({r * std::cos(phi), r * std::sin(phi), 0});
      }
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < m; ++j) {
      t.faces.push_back({index(i, j), index(i + 1, j), index(i + 1, j + 1)});
      if(i > 0 || inner_radius > 0)
        t.faces.push_back({index(i, j), index(i + 1, j + 1), index(i, j + 1)});
    }
  return t;
}

/// the square [-1, 1]^2 without the quarter in which x > 0 and y < 0, of 2n x 2n squares
inline Triangles l_shape(int n) {
  Triangles t =
      grid(2 * n, [](double x, double y) { return RL::Point_3(2 * x - 1, 2 * y - 1, 0); });
  t.faces.erase(std::remove_if(t.faces.begin(), t.faces.end(),
                               [&](const auto& f) {
                                 double x = 0, y = 0;
                                 for(const std::uint32_t v : f) {
                                   x += t.points[v].x();
                                   y += t.points[v].y();
                                 }
                                 return x > 0 && y < 0;
                               }),
                t.faces.end());
  return t;
}

inline Triangles scaled(Triangles t, double factor) {
  for(RL::Point_3& p : t.points)
    p = RL::Point_3(factor * p.x(), factor * p.y(), factor * p.z());
  return t;
}

inline Triangles moved(Triangles t, const RL::Vector_3& by) {
  for(RL::Point_3& p : t.points)
    p = p + by;
  return t;
}

/// two shapes side by side, vertices and faces of `b` after those of `a`
inline Triangles joined(Triangles a, const Triangles& b) {
  const auto shift = static_cast<std::uint32_t>(a.points.size());
  a.points.insert(a.points.end(), b.points.begin(), b.points.end());
  for(const auto& f : b.faces)
    a.faces.push_back({f[0] + shift, f[1] + shift, f[2] + shift});
  return a;
}

} // namespace shapes

#endif // RESTRICTED_LAPLACIAN_3_TEST_SPECIAL_SHAPES_H
