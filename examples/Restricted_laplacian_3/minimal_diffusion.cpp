// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Data at the vertices, here those of a checkerboard, smoothed by a width: a tenth of the size of
// the surface.

#include <CGAL/Restricted_laplacian_3/diffuse.h>

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <iostream>

namespace RL = CGAL::Restricted_laplacian_3;
using Mesh = CGAL::Surface_mesh<RL::Point_3>;

int main(int argc, char* argv[]) {
  Mesh mesh;
  if(argc != 2 || !CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(argv[1], mesh)) {
    std::cerr << "usage: minimal_diffusion MESH\n";
    return 1;
  }
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(mesh);
  const double width = 0.1 * std::max({box.x_span(), box.y_span(), box.z_span()});
  auto data = mesh.add_property_map<Mesh::Vertex_index, double>("v:data").first;
  for(const Mesh::Vertex_index v : mesh.vertices())
    data[v] = v.idx() % 2;

  auto u = mesh.add_property_map<Mesh::Vertex_index, double>("v:smooth").first;
  const RL::Solve_report report =
      RL::diffuse(mesh, data, RL::diffusion_time(width), u, RL::parameters::depth(6));
  const auto [low, high] = std::minmax_element(u.begin(), u.end());
  std::cout << "from 0 and 1 to " << *low << " and " << *high << ", by " << report.iterations
            << " linear systems\n";
  return !report.converged;
}
