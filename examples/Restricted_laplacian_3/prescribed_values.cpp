// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Four ways to tell a Poisson problem which values to take: along the boundary, along a part of it
// with a flux through the rest, at some vertices, and softly, by a weight. The surface is the
// square [-1, 1] x [-1, 1], on which x, x^2 - y^2 and x y are harmonic.

#include <CGAL/Restricted_laplacian_3/solve_poisson.h>

#include <array>
#include <cmath>
#include <iostream>
#include <vector>

namespace RL = CGAL::Restricted_laplacian_3;
namespace params = RL::parameters;

int main() {
  const std::vector<RL::Point_3> points = {{-1, -1, 0}, {0, -1, 0}, {1, -1, 0},
                                           {-1, 1, 0},  {0, 1, 0},  {1, 1, 0}};
  const std::vector<std::array<int, 4>> faces = {{0, 1, 4, 3}, {1, 2, 5, 4}};
  const auto zero = [](const RL::Surface_point&) { return 0; };
  const RL::Spline_space_3 square(RL::soup(points, faces), params::depth(4));
  std::vector<double> values(6);
  const auto u = CGAL::make_property_map(values);
  const auto print = [&](const char* what, double (*exact)(const RL::Point_3&)) {
    double largest = 0;
    for(std::size_t v = 0; v < points.size(); ++v)
      largest = std::fmax(largest, std::abs(values[v] - exact(points[v])));
    std::cout << what << ", largest error: " << largest << '\n';
  };
  // Laplacian u = 0 with u = x^2 - y^2 on the boundary
  const auto saddle = [](const RL::Point_3& p) { return p.x() * p.x() - p.y() * p.y(); };
  const auto on_boundary = [&](const RL::Surface_point& p) { return saddle(p.point); };
  bool converged =
      RL::solve_poisson(square, zero, u, params::boundary_values(on_boundary)).converged;
  print("boundary values", saddle);

  // Laplacian u = 0 with u = -1 on the left side, a derivative of 1 across the right one, and of 0
  // across the others
  const auto is_left = [](const RL::Surface_point& p) { return p.point.x() < 1e-9 - 1; };
  const auto flux = [](const RL::Surface_point& p) { return p.point.x() > 1 - 1e-9 ? 1. : 0.; };
  const auto np = params::boundary_values(-1).has_boundary_value(is_left).boundary_flux(flux);
  converged &= RL::solve_poisson(square, zero, u, np).converged;
  print("a value and a flux", [](const RL::Point_3& p) { return p.x(); });

  // Laplacian u = 0 with u = -1 in one corner and 1 in the opposite one
  const std::vector<double> fixed = {-1, NAN, NAN, NAN, NAN, 1};
  const auto constraints = params::constraints(CGAL::make_property_map(fixed));
  converged &= RL::solve_poisson(square, zero, u, constraints).converged;
  std::cout << "fixed vertices: wanted -1 and 1, got " << values[0] << " and " << values[5] << '\n';

  // minimal: integral of |grad u|^2 + w (u - x y)^2, with a large weight w on the left half
  const auto w = [](const RL::Surface_point& p) { return p.point.x() < 0 ? 1e4 : 0.; };
  const auto f = [&](const RL::Surface_point& p) { return w(p) * p.point.x() * p.point.y(); };
  converged &= RL::solve_screened_poisson(square, f, w, u).converged;
  std::cout << "weights: wanted 1 and -1, got " << values[0] << " and " << values[3] << '\n';
  return !converged;
}
