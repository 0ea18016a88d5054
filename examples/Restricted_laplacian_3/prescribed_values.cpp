// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Four ways to tell a Poisson problem which values to take: along the boundary, along a part of it
// with a flux through the rest, at some vertices, and softly, by a weight for each vertex. The
// surface is the square [-1, 1] x [-1, 1], on which x, x^2 - y^2 and x y are harmonic.

#include <CGAL/Restricted_laplacian_3/solve_poisson.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <iostream>

namespace RL = CGAL::Restricted_laplacian_3;
namespace params = RL::parameters;
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;

double largest_difference(const Mesh& mesh, const Mesh::Property_map<Vertex, double>& u,
                          double (*exact)(const Point&)) {
  double result = 0;
  for(Vertex v : mesh.vertices())
    result = std::max(result, std::abs(u[v] - exact(mesh.point(v))));
  return result;
}

int main() try {
  Mesh mesh;
  CGAL::make_grid(
      20, 20, mesh, [](std::size_t i, std::size_t j) { return Point(i / 10. - 1, j / 10. - 1, 0); },
      true);
  auto u = mesh.add_property_map<Vertex, double>("v:u").first;
  const auto zero = [](const RL::Surface_point&) { return 0.; };

  // Laplacian u = 0 with u = x^2 - y^2 on the boundary
  const auto saddle = [](const RL::Surface_point& p) {
    return p.point.x() * p.point.x() - p.point.y() * p.point.y();
  };
  bool converged =
      RL::solve_poisson(mesh, zero, u, params::depth(4).boundary_values(saddle)).converged;
  std::cout << "boundary values, largest error: "
            << largest_difference(mesh, u,
                                  [](const Point& p) { return p.x() * p.x() - p.y() * p.y(); })
            << '\n';

  // Laplacian u = 0 with u = -1 on the left side, a derivative of 1 across the right one, and of 0
  // across the others
  const auto is_left = [](const RL::Surface_point& p) { return p.point.x() < 1e-9 - 1; };
  const auto flux = [](const RL::Surface_point& p) { return p.point.x() > 1 - 1e-9 ? 1. : 0.; };
  converged =
      RL::solve_poisson(
          mesh, zero, u,
          params::depth(4).boundary_values(-1).has_boundary_value(is_left).boundary_flux(flux))
          .converged &&
      converged;
  std::cout << "a value and a flux, largest error: "
            << largest_difference(mesh, u, [](const Point& p) { return p.x(); }) << '\n';

  // Laplacian u = 0 with u = 1 in one corner and -1 in the opposite one
  auto value = mesh.add_property_map<Vertex, double>("v:value", std::nan("")).first; // free
  for(Vertex v : mesh.vertices()) {
    const Point& p = mesh.point(v);
    if(std::abs(p.x() + p.y()) == 2)
      value[v] = p.x();
  }
  converged =
      RL::solve_poisson(mesh, zero, u, params::depth(4).constraints(value)).converged && converged;
  for(Vertex v : mesh.vertices())
    if(!std::isnan(value[v]))
      std::cout << "fixed vertex: wanted " << value[v] << ", got " << u[v] << '\n';

  // minimal: integral of |grad u|^2 + w (u - x y)^2, with a large weight w on the left half
  const auto weight = [](const RL::Surface_point& p) { return p.point.x() < 0 ? 1e4 : 0.; };
  const auto weighted_target = [&](const RL::Surface_point& p) {
    return weight(p) * p.point.x() * p.point.y();
  };
  converged =
      RL::solve_screened_poisson(mesh, weighted_target, weight, u, params::depth(4)).converged &&
      converged;
  double on_the_left = 0;
  for(Vertex v : mesh.vertices())
    if(mesh.point(v).x() < -0.2)
      on_the_left = std::max(on_the_left, std::abs(u[v] - mesh.point(v).x() * mesh.point(v).y()));
  std::cout << "weights, largest difference where they are large: " << on_the_left << '\n';
  return converged ? 0 : 1;
} catch(const std::exception& e) {
  std::cerr << "prescribed_values: " << e.what() << '\n';
  return 1;
}
