// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Restricted_laplacian_3/solve_poisson.h>

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>
#include <exception>
#include <iostream>

namespace RL = CGAL::Restricted_laplacian_3;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

int main(int argc, char* argv[]) try {
  Mesh mesh;
  if(argc != 2 || !CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(argv[1], mesh)) {
    std::cerr << "usage: minimal_poisson MESH\n";
    return 1;
  }
  auto u = mesh.add_property_map<Mesh::Vertex_index, double>("v:u").first;
  const auto f = [](const RL::Surface_point& s) { return s.point.z(); };

  // Laplacian u = f; the mean of f is removed, and u has mean zero
  const RL::Solve_report report = RL::solve_poisson(mesh, f, u);

  double low = 0, high = 0;
  for(double value : u) { // NaN, the value of vertices on no area, is left out
    low = std::fmin(low, value);
    high = std::fmax(high, value);
  }
  std::cout << "u is between " << low << " and " << high << '\n';
  return report.converged ? 0 : 1;
} catch(const std::exception& e) {
  std::cerr << "minimal_poisson: " << e.what() << '\n';
  return 1;
}
