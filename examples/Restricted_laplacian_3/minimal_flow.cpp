// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// A surface that flows to a sphere, and one that shrinks.

#include <CGAL/Restricted_laplacian_3/mean_curvature_flow.h>

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>

#include <iostream>
#include <stdexcept>

namespace RL = CGAL::Restricted_laplacian_3;
namespace PMP = CGAL::Polygon_mesh_processing;
namespace params = RL::parameters;

int main(int argc, char* argv[]) try {
  CGAL::Surface_mesh<RL::Point_3> mesh;
  if(argc != 2 || !PMP::IO::read_polygon_mesh(argv[1], mesh))
    throw std::invalid_argument("usage: minimal_flow MESH");
  const double area = PMP::area(mesh);
  auto sphere =
      mesh.add_property_map<CGAL::Surface_mesh<RL::Point_3>::Vertex_index, RL::Point_3>("v:sphere")
          .first;

  // its area is kept, unless it is told otherwise
  const RL::Flow_report conformal =
      RL::mean_curvature_flow(mesh, 0.01 * area, 30, sphere, params::depth(5).conformal(true));
  std::cout << "from a sphere by " << 100 * conformal.sphere_deviation << " %, distortion "
            << conformal.mean_distortion << '\n';

  const RL::Flow_report flow =
      RL::mean_curvature_flow(mesh, 1e-5 * area, 5, mesh.points(), params::depth(5));
  std::cout << "after the time " << flow.time << " the area is " << flow.area / area
            << " of what it was\n";
  return conformal.converged && flow.converged ? 0 : 1;
} catch(const std::exception& e) {
  std::cerr << e.what() << '\n';
  return 1;
}
