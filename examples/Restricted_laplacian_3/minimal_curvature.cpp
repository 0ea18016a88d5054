// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Restricted_laplacian_3/estimate_curvature.h>
#include <CGAL/Restricted_laplacian_3/fit_function.h>

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>
#include <exception>
#include <iostream>

namespace RL = CGAL::Restricted_laplacian_3;
namespace params = RL::parameters;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

int main(int argc, char* argv[]) try {
  Mesh mesh;
  if(argc != 2 || !CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(argv[1], mesh)) {
    std::cerr << "usage: minimal_curvature MESH\n";
    return 1;
  }
  const auto np = params::depth(5);

  // mean, Gaussian and principal curvatures, principal directions and normals
  auto curvature = mesh.add_property_map<Mesh::Vertex_index, RL::Surface_curvature>("v:c").first;
  RL::estimate_curvature(mesh, curvature, np);
  double low = HUGE_VAL, high = -HUGE_VAL;
  for(const RL::Surface_curvature& c : curvature) { // NaN at vertices on no area
    low = std::fmin(low, c.mean);
    high = std::fmax(high, c.mean);
  }
  std::cout << "mean curvature is between " << low << " and " << high << '\n';

  // the normals of the faces, as three functions that are smooth and defined everywhere
  auto normal = mesh.add_property_map<Mesh::Vertex_index, RL::Vector_3>("v:n").first;
  const RL::Fit_report report = RL::fit_function(
      mesh, [](const RL::Surface_point& p) { return p.normal; }, normal, np);
  std::cout << "normals are fitted with a root mean square error of "
            << report.root_mean_square_error() << '\n';
  return report.converged ? 0 : 1;
} catch(const std::exception& e) {
  std::cerr << "minimal_curvature: " << e.what() << '\n';
  return 1;
}
