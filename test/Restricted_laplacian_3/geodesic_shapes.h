// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_TEST_GEODESIC_SHAPES_H
#define RESTRICTED_LAPLACIAN_3_TEST_GEODESIC_SHAPES_H

#include "shapes.h"
#include "special_shapes.h"

#include <CGAL/Restricted_laplacian_3/geodesics/Geodesic_solver.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <utility>
#include <vector>

/// \file
/// What the tests of distances along surfaces share.

namespace shapes {

inline RL::Geodesic_solver geodesics(const Triangles& t) {
  return RL::Geodesic_solver(RL::Triangulated_surface_3(t.points, t.faces));
}

inline double length(const RL::Vector_3& v) { return std::sqrt(v.squared_length()); }

/// Dijkstra along the edges, by relaxation
inline std::vector<double> along_edges(const Triangles& t, std::size_t source) {
  std::vector<double> d(t.points.size(), std::numeric_limits<double>::infinity());
  d[source] = 0;
  for(bool changed = true; changed;) {
    changed = false;
    for(const auto& f : t.faces)
      for(int k = 0; k < 3; ++k)
        for(const auto& [a, b] :
            {std::pair(f[k], f[(k + 1) % 3]), std::pair(f[(k + 1) % 3], f[k])}) {
          const double there = d[a] + length(t.points[a] - t.points[b]);
          if(there < d[b]) {
            d[b] = there;
            changed = true;
          }
        }
  }
  return d;
}

inline Triangles crumpled(Triangles t, double amount, unsigned seed) {
  std::mt19937 generator(seed);
  const auto random = [&] { return amount * (generator() * std::ldexp(2., -32) - 1); };
  for(RL::Point_3& p : t.points)
    p = p + RL::Vector_3(random(), random(), random());
  return t;
}

/// A nearly flat rectangle [0, stretch] x [0, 1] of `n` x `n` vertices, moved at random by a part
/// of the distance of neighbors, and in height by `amount`. Sides of its faces have been exchanged
/// for the other diagonals of their quadrilaterals again and again: needles that lie anyhow.
inline Triangles anyhow(std::uint32_t n, double stretch, double amount, unsigned seed) {
  Triangles t;
  std::mt19937 generator(seed);
  const auto random = [&] { return generator() * std::ldexp(2., -32) - 1; };
  std::vector<std::array<double, 2>> plane;
  for(std::uint32_t j = 0; j < n; ++j)
    for(std::uint32_t i = 0; i < n; ++i) {
      const auto moved = [&](std::uint32_t k) {
        return (k + (k > 0 && k + 1 < n ? 0.4 * random() : 0)) / (n - 1);
      };
      const double x = moved(i), y = moved(j);
      plane.push_back({x, y});
      t.points.emplace_back(stretch * x, y, amount * random());
      if(i + 1 < n && j + 1 < n) {
        const std::uint32_t k = j * n + i;
        t.faces.push_back({k, k + 1, k + n + 1});
        t.faces.push_back({k, k + n + 1, k + n});
      }
    }
  const auto area = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    return (plane[b][0] - plane[a][0]) * (plane[c][1] - plane[a][1]) -
           (plane[b][1] - plane[a][1]) * (plane[c][0] - plane[a][0]);
  };
  const auto have = [&](std::uint32_t c, std::uint32_t d) { // faces, an edge between these
    return std::any_of(t.faces.begin(), t.faces.end(), [&](const auto& f) {
      return std::count(f.begin(), f.end(), c) + std::count(f.begin(), f.end(), d) == 2;
    });
  };
  const double least = 0.02 / (n * n);
  for(std::size_t turns = 10 * t.faces.size(); turns > 0; --turns) {
    auto& f = t.faces[generator() % t.faces.size()];
    const unsigned k = generator() % 3;
    const std::uint32_t a = f[k], b = f[(k + 1) % 3], c = f[(k + 2) % 3];
    for(auto& g : t.faces)
      for(int m = 0; m < 3; ++m) {
        const std::uint32_t d = g[(m + 2) % 3];
        if(g[m] == b && g[(m + 1) % 3] == a && area(c, a, d) > least && area(d, b, c) > least &&
           !have(c, d)) {
          f = {c, a, d};
          g = {d, b, c};
          m = 3;
        }
      }
  }
  return t;
}

/// a strip of `n` pairs of needles of the aspect 1e4, [0, n * 1e-4] x [0, 1]
inline Triangles needles(std::uint32_t n) {
  Triangles t;
  for(std::uint32_t i = 0; i <= n; ++i) {
    t.points.emplace_back(i * 1e-4, 0, 0);
    t.points.emplace_back(i * 1e-4, 1, 0);
  }
  for(std::uint32_t i = 0; i < n; ++i) {
    t.faces.push_back({2 * i, 2 * i + 2, 2 * i + 1});
    t.faces.push_back({2 * i + 1, 2 * i + 2, 2 * i + 3});
  }
  return t;
}

/// the unit square with faces of no area: a vertex on a side, one at the place of another one, and
/// faces with the same vertex twice
inline Triangles square_with_flat_faces() {
  Triangles t = rectangle(1, 1);
  const auto n = static_cast<std::uint32_t>(t.points.size());
  t.points.push_back(CGAL::midpoint(t.points[0], t.points[1]));
  t.points.push_back(t.points[2]);
  t.faces.insert(t.faces.end(), {{0, 1, n}, {2, n + 1, 0}, {0, 0, 1}, {2, 2, 2}});
  return t;
}

/// the unit square with a row of `n` squares that have no height: of sides of no length, or, with
/// their upper ends moved by a part `shift` of a square, of faces of no area; both but for `height`
inline Triangles square_with_flat_row(int n, double shift, double height) {
  const double middle = double(n / 2) / n;
  return grid(n + 1, [&](double x, double y) {
    const double i = std::round(x * (n + 1)), j = std::round(y * (n + 1));
    x = (std::min)(i / n, 1.);
    if(j == n / 2 + 1)
      return RL::Point_3(i > 0 && i < n ? x + shift / n : x, middle + height, 0);
    return RL::Point_3(x, (j > n / 2 ? j - 1 : j) / n, 0);
  });
}

/// three half planes that meet in the y-axis, each a grid of `n` by `n` squares
inline Triangles three_wings(int n) {
  Triangles t;
  for(int wing = 0; wing < 3; ++wing) {
    const double phi = 2 * CGAL_PI * wing / 3 + 0.1;
    t = joined(t, grid(n, [&](double x, double y) {
                 return RL::Point_3(x * std::cos(phi), y, x * std::sin(phi));
               }));
  }
  // one axis for all
  const auto columns = static_cast<std::uint32_t>(n + 1), size = columns * columns;
  for(auto& f : t.faces)
    for(std::uint32_t& v : f)
      if(v % size % columns == 0)
        v %= size;
  return t;
}

/// triangles between random ones of few points: most edges have three faces or more
inline Triangles shared_soup(unsigned seed, int points, int faces) {
  std::mt19937 generator(seed);
  const auto random = [&] { return generator() * std::ldexp(1., -32); };
  Triangles t;
  for(int i = 0; i < points; ++i)
    t.points.emplace_back(random(), random(), random());
  while(static_cast<int>(t.faces.size()) < faces) {
    std::array<std::uint32_t, 3> face;
    for(std::uint32_t& v : face)
      v = generator() % static_cast<unsigned>(points);
    if(face[0] != face[1] && face[1] != face[2] && face[2] != face[0])
      t.faces.push_back(face);
  }
  return t;
}

} // namespace shapes

#endif // RESTRICTED_LAPLACIAN_3_TEST_GEODESIC_SHAPES_H
