// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// What compile_times.sh compares with: the example minimal_poisson.cpp without a problem to solve.

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <iostream>

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

int main(int argc, char* argv[]) {
  Mesh mesh;
  if(argc != 2 || !CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(argv[1], mesh)) {
    std::cerr << "usage: read_mesh MESH\n";
    return 1;
  }
  auto u = mesh.add_property_map<Mesh::Vertex_index, double>("v:u").first;

  for(Mesh::Vertex_index v : mesh.vertices())
    u[v] = mesh.point(v).z();

  std::cout << "u is at most " << *std::max_element(u.begin(), u.end()) << '\n';
  return 0;
}
