// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_BENCHMARK_CURVED_SHAPES_H
#define RESTRICTED_LAPLACIAN_3_BENCHMARK_CURVED_SHAPES_H

// Triangulations of surfaces whose curvature is known. All vertices lie on the surface. In the
// irregular ones each vertex is moved at random by up to 0.3 of the distance to the next one along
// both parameters, and each quadrilateral is cut along a diagonal chosen at random, as far as no
// triangle is turned over: angles and areas vary strongly.

#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace benchmarks {

namespace RL = CGAL::Restricted_laplacian_3;

/// mean and Gaussian curvature with respect to the normals of the faces
struct Exact_curvature {
  double mean, gaussian;
};

struct Curved_shape {
  std::string name;
  std::vector<RL::Point_3> points;
  std::vector<RL::Triangulated_surface_3::Triangle> faces;
  std::vector<Exact_curvature> curvatures; // of vertices
};

namespace internal {

using Parameters = std::array<double, 2>;

inline double twice_area(const Parameters& a, const Parameters& b, const Parameters& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// A grid of `columns` x `rows` quadrilaterals in the plane of two parameters, whose unit is the
/// width of the grid. It may be periodic.
class Parameter_grid {
public:
  std::vector<Parameters> parameters;
  std::vector<RL::Triangulated_surface_3::Triangle> faces;

  Parameter_grid(int columns, int rows, bool is_periodic, bool is_irregular)
    : m_columns(columns), m_rows(rows), m_is_periodic(is_periodic) {
    std::mt19937 generator(1);
    // std::uniform_real_distribution differs between standard libraries
    const auto offset = [&] { return 0.6 * (generator() / 4294967296. - 0.5); };
    const int end = is_periodic ? 0 : 1;
    for(int i = 0; i < columns + end; ++i)
      for(int j = 0; j < rows + end; ++j) {
        const double u = offset(), v = offset();
        const bool is_u_free = is_periodic || (i > 0 && i < columns);
        const bool is_v_free = is_periodic || (j > 0 && j < rows);
        parameters.push_back(
            {i + (is_irregular && is_u_free ? u : 0.), j + (is_irregular && is_v_free ? v : 0.)});
      }
    for(int i = 0; i < columns; ++i)
      for(int j = 0; j < rows; ++j)
        add_quadrilateral(i, j, is_irregular && generator() % 2);
  }

private:
  std::uint32_t vertex(int i, int j) const {
    return m_is_periodic ? static_cast<std::uint32_t>(i % m_columns * m_rows + j % m_rows)
                         : static_cast<std::uint32_t>(i * (m_rows + 1) + j);
  }

  // parameters of a vertex, as near to the others of its quadrilateral as they are on the surface
  Parameters place(int i, int j) const {
    Parameters p = parameters[vertex(i, j)];
    if(m_is_periodic && i == m_columns)
      p[0] += m_columns;
    if(m_is_periodic && j == m_rows)
      p[1] += m_rows;
    return p;
  }

  void add_quadrilateral(int i, int j, bool by_second_diagonal) {
    const std::uint32_t a = vertex(i, j), b = vertex(i + 1, j), c = vertex(i + 1, j + 1),
                        d = vertex(i, j + 1);
    const Parameters pa = place(i, j), pb = place(i + 1, j), pc = place(i + 1, j + 1),
                     pd = place(i, j + 1);
    constexpr double smallest = 0.05;
    const double first = std::min(twice_area(pa, pb, pc), twice_area(pa, pc, pd)),
                 second = std::min(twice_area(pa, pb, pd), twice_area(pb, pc, pd));
    if(by_second_diagonal ? second > smallest : first <= smallest) {
      faces.push_back({a, b, d});
      faces.push_back({b, c, d});
    } else {
      faces.push_back({a, b, c});
      faces.push_back({a, c, d});
    }
  }

  int m_columns, m_rows;
  bool m_is_periodic;
};

} // namespace internal

/// the torus with radii 1 and 0.4, outward normals
inline Curved_shape torus_shape(int triangles, bool is_irregular) {
  const int rows = static_cast<int>(std::lround(std::sqrt(triangles / 2 / 2.5)));
  const int columns = 5 * rows / 2;
  const internal::Parameter_grid grid(columns, rows, true, is_irregular);
  Curved_shape result = {"torus", {}, grid.faces, {}};
  const double r = 0.4;
  for(const auto& [i, j] : grid.parameters) {
    const double u = 2 * CGAL_PI * i / columns, v = 2 * CGAL_PI * j / rows;
    const double distance = 1 + r * std::cos(v);
    result.points.emplace_back(distance * std::cos(u), distance * std::sin(u), r * std::sin(v));
    result.curvatures.push_back(
        {(1 / r + std::cos(v) / distance) / 2, std::cos(v) / (r * distance)});
  }
  return result;
}

/// the graph of (x^2 - y^2) / 2 over [-1, 1] x [-1, 1], upward normals
inline Curved_shape saddle_shape(int triangles, bool is_irregular) {
  const int n = static_cast<int>(std::lround(std::sqrt(triangles / 2)));
  const internal::Parameter_grid grid(n, n, false, is_irregular);
  Curved_shape result = {"saddle", {}, grid.faces, {}};
  for(const auto& [i, j] : grid.parameters) {
    const double x = 2 * i / n - 1, y = 2 * j / n - 1, g = 1 + x * x + y * y;
    result.points.emplace_back(x, y, (x * x - y * y) / 2);
    result.curvatures.push_back({(x * x - y * y) / (2 * std::pow(g, 1.5)), -1 / (g * g)});
  }
  return result;
}

/// The ellipsoid with the given axes, outward normals: an octahedron with a grid on each side,
/// projected. Irregular vertices are moved in space before they are projected; diagonals stay.
inline Curved_shape ellipsoid_shape(const std::string& name, const std::array<double, 3>& axes,
                                    int triangles, bool is_irregular) {
  const int n = static_cast<int>(std::lround(std::sqrt(triangles / 8)));
  Curved_shape result = {name, {}, {}, {}};
  std::mt19937 generator(1);
  const auto offset = [&] { return 0.6 * (generator() / 4294967296. - 0.5); };
  std::map<std::array<int, 3>, std::uint32_t> numbers;
  const auto vertex = [&](const std::array<int, 3>& i) {
    const auto [it, is_new] = numbers.insert({i, static_cast<std::uint32_t>(result.points.size())});
    if(!is_new)
      return it->second;
    std::array<double, 3> p;
    for(int k = 0; k < 3; ++k)
      p[k] = i[k] + (is_irregular ? offset() : 0.);
    const double length = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
    double q = 0, squares = 0, trace = 0, product = 1;
    for(int k = 0; k < 3; ++k) {
      p[k] *= axes[k] / length;
      q += p[k] * p[k] / std::pow(axes[k], 4);
      squares += p[k] * p[k];
      trace += axes[k] * axes[k];
      product *= axes[k] * axes[k];
    }
    result.points.emplace_back(p[0], p[1], p[2]);
    result.curvatures.push_back(
        {(trace - squares) / (2 * product * std::pow(q, 1.5)), 1 / (product * q * q)});
    return it->second;
  };
  for(int octant = 0; octant < 8; ++octant) {
    const int x = octant & 1 ? -1 : 1, y = octant & 2 ? -1 : 1, z = octant & 4 ? -1 : 1;
    const auto add = [&](const std::array<int, 2>& a, std::array<int, 2> b, std::array<int, 2> c) {
      if(x * y * z < 0)
        std::swap(b, c);
      RL::Triangulated_surface_3::Triangle face;
      int corner = 0;
      for(const auto& i : {a, b, c})
        face[corner++] = vertex({x * i[0], y * i[1], z * (n - i[0] - i[1])});
      result.faces.push_back(face);
    };
    for(int i = 0; i < n; ++i)
      for(int j = 0; i + j < n; ++j) {
        add({i, j}, {i + 1, j}, {i, j + 1});
        if(i + j + 1 < n)
          add({i + 1, j}, {i + 1, j + 1}, {i, j + 1});
      }
  }
  return result;
}

} // namespace benchmarks

#endif // RESTRICTED_LAPLACIAN_3_BENCHMARK_CURVED_SHAPES_H
