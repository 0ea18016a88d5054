// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Restricted_laplacian_3/input/read_surface.h>
#include <CGAL/Restricted_laplacian_3/stitch_colors.h>

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <cmath>
#include <exception>
#include <iostream>
#include <vector>

namespace RL = CGAL::Restricted_laplacian_3;
namespace params = RL::parameters;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Color = std::array<double, 3>;

int main(int argc, char* argv[]) try {
  Mesh mesh;
  if(argc != 2 || !CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(argv[1], mesh)) {
    std::cerr << "usage: minimal_stitching MESH\n";
    return 1;
  }
  const RL::Triangulated_surface_3 surface = RL::read_surface(mesh);

  // Six scans, from the sides of a cube around the mesh, each with an exposure of its own. Here
  // they are the mesh itself; otherwise scans are meshes of their own, or points, with poses.
  auto seen = mesh.add_property_map<Mesh::Vertex_index, Color>("v:seen").first;
  std::vector<RL::Colored_scan> scans;
  for(int i = 0; i < 6; ++i) {
    const double exposure = 0.75 + 0.05 * i, distance = i % 2 ? 5 : -5;
    for(Mesh::Vertex_index v : vertices(mesh)) {
      const RL::Vector_3 p = (mesh.point(v) - surface.center()) / surface.extent();
      const double wave = std::sin(20 * p.x()) * std::sin(20 * p.y()) * std::sin(20 * p.z());
      seen[v] = {exposure * (0.5 + p.x() / 2), exposure * (0.5 + p.y() / 2),
                 exposure * (0.5 + wave / 4)};
    }
    std::array<double, 3> eye = {0, 0, 0};
    eye[i / 2] = distance * surface.extent();
    const RL::Point_3 viewpoint = surface.center() + RL::Vector_3(eye[0], eye[1], eye[2]);
    scans.emplace_back(mesh, seen, params::viewpoint(viewpoint));
  }

  auto colors = mesh.add_property_map<Mesh::Vertex_index, Color>("v:stitched").first;
  const RL::Stitching_report report = RL::stitch_colors(mesh, scans, colors, params::depth(6));
  std::cout << "mean step of the color between scans: " << report.jump_before << " before, "
            << report.jump_after << " after; without a scan: " << 100 * report.uncovered_area
            << " % of the area\n";
  return report.converged ? 0 : 1;
} catch(const std::exception& e) {
  std::cerr << "minimal_stitching: " << e.what() << '\n';
  return 1;
}
