// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Restricted_laplacian_3/laplace_spectrum.h>
#include <CGAL/Restricted_laplacian_3/spectral_descriptors.h>

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
    std::cerr << "usage: minimal_descriptors MESH\n";
    return 1;
  }
  const RL::Laplace_spectrum spectrum = RL::laplace_spectrum(mesh, 50, RL::parameters::depth(5));

  // how much heat stays where it is: a row for each vertex, a column for each time
  const Eigen::VectorXd times = RL::heat_kernel_times(spectrum, 5);
  const Eigen::MatrixXd hks = RL::heat_kernel_signature(spectrum, times);
  for(Eigen::Index j = 0; j < times.size(); ++j)
    std::cout << "heat kernel signature at time " << times[j] << ": from "
              << hks.col(j).minCoeff<Eigen::PropagateNumbers>() << " to "
              << hks.col(j).maxCoeff<Eigen::PropagateNumbers>() << '\n';

  // the biharmonic distance of two vertices is that of their rows
  const Eigen::MatrixXd points = RL::biharmonic_embedding(spectrum);
  const Eigen::Index last = points.rows() - 1;
  std::cout << "biharmonic distance of the first vertex from the last: "
            << (points.row(0) - points.row(last)).norm() << '\n';

  // eigenvalues times area
  std::cout << "ShapeDNA: " << RL::shape_dna(spectrum).head(5).transpose() << " ...\n";
  return spectrum.report.converged ? 0 : 1;
} catch(const std::exception& e) {
  std::cerr << "minimal_descriptors: " << e.what() << '\n';
  return 1;
}
