// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Restricted_laplacian_3/laplace_spectrum.h>

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <exception>
#include <iostream>

namespace RL = CGAL::Restricted_laplacian_3;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

int main(int argc, char* argv[]) try {
  Mesh mesh;
  if(argc != 2 || !CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(argv[1], mesh)) {
    std::cerr << "usage: minimal_spectrum MESH\n";
    return 1;
  }
  const RL::Laplace_spectrum spectrum = RL::laplace_spectrum(mesh, 10, RL::parameters::depth(5));

  // eigenvalues are in units of 1 / area; column i of vertex_values is eigenfunction i
  for(Eigen::Index i = 0; i < spectrum.eigenvalues.size(); ++i)
    std::cout << "eigenvalue " << i << ": " << spectrum.eigenvalues[i] << ", eigenfunction from "
              << spectrum.vertex_values.col(i).minCoeff() << " to "
              << spectrum.vertex_values.col(i).maxCoeff() << '\n';
  return spectrum.report.converged ? 0 : 1;
} catch(const std::exception& e) {
  std::cerr << "minimal_spectrum: " << e.what() << '\n';
  return 1;
}
