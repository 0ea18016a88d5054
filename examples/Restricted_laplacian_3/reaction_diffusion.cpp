// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Spots that form by themselves (Turing 1952, with the reaction of Schnakenberg 1979):
// du/dt = D Laplacian u + a - u + u^2 v, dv/dt = 20 D Laplacian v + b - u^2 v. Their distance is
// chosen, here 0.15 of the size of the surface, and does not depend on the triangles.

#include <CGAL/Restricted_laplacian_3/assembly/assemble.h>
#include <CGAL/Restricted_laplacian_3/problems/Diffusion_solver.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_function_3.h>

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Surface_mesh.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iostream>
#include <vector>

namespace RL = CGAL::Restricted_laplacian_3;
using Mesh = CGAL::Surface_mesh<RL::Point_3>;

int main(int argc, char* argv[]) {
  Mesh mesh;
  if(argc < 2 || argc > 3 || !CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(argv[1], mesh)) {
    std::cerr << "usage: reaction_diffusion MESH [RESULT.ply]\n";
    return 1;
  }
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(mesh);
  const double distance = 0.15 * std::max({box.x_span(), box.y_span(), box.z_span()});
  const double a = 0.1, b = 0.9, ratio = 20, step = 0.3;
  // u = a + b, v = b / (a + b)^2 is at rest; of all waves, those of this length grow fastest
  const double diffusion = std::pow(distance / (2 * std::acos(-1.)), 2) / std::sqrt(ratio);

  const RL::Spline_space_3 space(
      mesh, RL::parameters::depth(5).concurrency_tag(CGAL::Parallel_if_available_tag()));
  std::cout.precision(3);
  // both are set up once; each step then solves a few systems with their factors
  const RL::Diffusion_solver of_u(space, diffusion * step, RL::parameters::tolerance(1e-3)),
      of_v(space, ratio * diffusion * step, RL::parameters::tolerance(1e-3));

  // at rest, and a little beside it
  const auto noise = [&](const RL::Surface_point& p) {
    const auto wave = [&](double x) { return std::sin(9 * x / distance); };
    return 0.01 * wave(p.point.x()) * wave(p.point.y()) * wave(p.point.z());
  };
  Eigen::MatrixXd loads = RL::assemble_component_loads(space, [&](const RL::Surface_point& p) {
    return std::array<double, 2>{a + b + noise(p), b / ((a + b) * (a + b))};
  });
  for(int i = 0;; ++i) {
    const RL::Spline_function_3 u(space, of_u.diffuse_loads(loads.col(0), {}).coefficients),
        v(space, of_v.diffuse_loads(loads.col(1), {}).coefficients);
    if(i % 20 == 0) {
      const std::vector<double> values = u.values_at_vertices();
      const auto [low, high] = std::minmax_element(values.begin(), values.end());
      std::cout << "time " << i * step << ": u from " << *low << " to " << *high << '\n';
    }
    if(i == 100) {
      evaluate_at_vertices(u, mesh, mesh.add_property_map<Mesh::Vertex_index, double>("v:u").first);
      if(argc == 2)
        return 0;
      std::ofstream file(argv[2]);
      return !CGAL::IO::write_PLY(file, mesh); // with properties, which are written to streams only
    }
    const auto react = [&](const RL::Surface_point& p) {
      const double u_here = u.value(p), v_here = v.value(p), made = u_here * u_here * v_here;
      return std::array<double, 2>{u_here + step * (a - u_here + made), v_here + step * (b - made)};
    };
    // of degree 2 is exact enough, and takes a fraction of the points
    loads = RL::assemble_component_loads(space, RL::function_of_degree(react, 2));
  }
}
