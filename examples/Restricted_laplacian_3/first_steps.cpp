// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Restricted_laplacian_3.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <iostream>

namespace RL = CGAL::Restricted_laplacian_3;
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Vertex = CGAL::SM_Vertex_index;

int main() {
  CGAL::Surface_mesh<Point> mesh; // any of CGAL's
  if(!CGAL::IO::read_polygon_mesh("elephant.off", mesh))
    return 1;
  // Laplacian u = z
  auto z = [](const RL::Surface_point& s) { return s.point.z(); };
  auto u = mesh.add_property_map<Vertex, double>("v:u").first;
  if(!RL::solve_poisson(mesh, z, u).converged)
    return 1;
  // eigenvalues, eigenfunctions at the vertices
  auto spectrum = RL::laplace_spectrum(mesh, 50);
  std::cout << spectrum.eigenvalues[1] << '\n';
}
