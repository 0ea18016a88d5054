// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// How large the error of a solution and of eigenvalues is, what one depth more gains, and
// eigenvalues of an accuracy.

#include <CGAL/Restricted_laplacian_3/laplace_spectrum.h>
#include <CGAL/Restricted_laplacian_3/solve_poisson.h>

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Surface_mesh.h>

#include <iostream>

namespace RL = CGAL::Restricted_laplacian_3;

int main(int argc, char* argv[]) {
  CGAL::Surface_mesh<RL::Point_3> mesh;
  if(argc != 2 || !CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(argv[1], mesh)) {
    std::cerr << "usage: estimated_errors MESH\n";
    return 1;
  }
  std::cout.precision(2);
  const auto f = [](const RL::Surface_point& s) { return s.point.z(); };
  for(int depth = 4; depth <= 6; ++depth) {
    const RL::Spline_space_3 space(mesh, RL::parameters::depth(depth));
    const RL::Poisson_solution u = RL::solve_poisson(space, f);
    const RL::Laplace_spectrum spectrum = RL::laplace_spectrum(space, 20);
    std::cout << "depth " << depth << ", " << space.dimension() << " unknowns: errors of about "
              << 100 * u.estimated_error << " % of u, and " << 100 * spectrum.report.estimated_error
              << " % of 20 eigenvalues"
              << (u.is_estimate_trusted ? "\n" : " (cells may not resolve the surface)\n");
  }
  const auto np = RL::parameters::accuracy(0.03);
  const RL::Laplace_spectrum spectrum = RL::laplace_spectrum(mesh, 20, np);
  std::cout << "accuracy 3 %: " << spectrum.pairs.vectors.rows() << " unknowns, "
            << to_string(spectrum.report.status) << '\n';
}
