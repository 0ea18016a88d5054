// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// A wave on a surface, d^2 u / dt^2 = Laplacian u, from a bump at rest beside the first vertex.
// Steps of the trapezoidal rule keep the energy (1/2) integral (du/dt)^2 + |grad u|^2; each solves
// one screened Poisson problem, all with one multigrid hierarchy.

#include <CGAL/Restricted_laplacian_3/assembly/assemble.h>
#include <CGAL/Restricted_laplacian_3/problems/Poisson_solver.h>

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Surface_mesh.h>

#include <Eigen/Core>

#include <cmath>
#include <iostream>
#include <stdexcept>

namespace RL = CGAL::Restricted_laplacian_3;
namespace params = RL::parameters;

int main(int argc, char* argv[]) try {
  CGAL::Surface_mesh<RL::Point_3> mesh;
  if(argc != 2 || !CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(argv[1], mesh)) {
    std::cerr << "usage: waves MESH\n";
    return 1;
  }
  const RL::Spline_space_3 space(mesh, params::depth(5));
  const RL::Operators operators = RL::assemble_operators(space);
  const double size = std::sqrt(space.surface().area()), width = 0.1 * size, step = 0.02 * size;

  // (S + (4 / step^2) M) x = b
  const double alpha = 4 / (step * step);
  const RL::Poisson_solver solver(space, operators, alpha, params::tolerance(1e-8));
  const auto solve = [&](const Eigen::VectorXd& load) {
    Eigen::VectorXd x;
    if(!solver.solve(load, x).converged)
      throw std::runtime_error("a step did not converge");
    return x;
  };

  const RL::Point_3 center = space.surface().point(0);
  const auto bump = [&](const RL::Surface_point& p) {
    return std::exp(-CGAL::squared_distance(p.point, center) / (2 * width * width));
  };
  // smoothed by the length of a step
  Eigen::VectorXd u = solve(alpha * RL::assemble_load(space, bump)),
                  velocity = Eigen::VectorXd::Zero(space.dimension());
  for(int i = 0; i <= 50; ++i) {
    if(i % 10 == 0)
      std::cout << "time " << i * step / size << ": energy "
                << 0.5 * (velocity.dot(operators.mass * velocity) + u.dot(operators.stiffness * u))
                << ", mean of u " << (operators.mass * u).sum() / space.surface().area() << '\n';
    // the mean of both ends: (u' - u) / step = (velocity' + velocity) / 2, and M times the velocity
    // changes by -step S (u' + u) / 2
    const Eigen::VectorXd middle = solve(operators.mass * (alpha * u + (2 / step) * velocity));
    velocity = (4 / step) * (middle - u) - velocity;
    u = 2 * middle - u;
  }
} catch(const std::exception& e) {
  std::cerr << e.what() << '\n';
  return 1;
}
