// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// A surface that the processes of MPI divide among themselves: a Poisson problem, and eigenvalues.
//
// usage: mpiexec -n RANKS distributed_surface [FILE [DEPTH]]

#include <CGAL/Restricted_laplacian_3/assembly/assemble.h>
#include <CGAL/Restricted_laplacian_3/distributed/Distributed_poisson_solver.h>
#include <CGAL/Restricted_laplacian_3/distributed/Distributed_spectrum.h>
#include <CGAL/Restricted_laplacian_3/distributed/surface_slices.h>
#include <CGAL/Restricted_laplacian_3/distributed/vertex_values.h>

#include <slepcsys.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace RL = CGAL::Restricted_laplacian_3;

void solve(const RL::Communicator& ranks, const std::string& file, int depth) {
  const RL::Distributed_surface surface(ranks, RL::read_surface_slice(ranks, file));
  const RL::Distributed_space space(surface, RL::parameters::depth(depth));

  // Laplacian u = z: each rank assembles the load of its part of the surface
  const Eigen::VectorXd load =
      RL::assemble_load(space.part(), [](const RL::Surface_point& p) { return -p.point.z(); });
  Eigen::VectorXd coefficients;
  const RL::Solve_report report = RL::Distributed_poisson_solver(space).solve(load, coefficients);

  // at the vertices of the slice of this rank
  double largest = 0;
  for(const double u : RL::values_at_vertices(surface, space, coefficients))
    largest = std::fmax(largest, u); // NaN at vertices without a triangle
  largest = ranks.maximum(largest);
  const RL::Distributed_spectrum spectrum = RL::laplace_spectrum(space, 10);
  if(ranks.rank() == 0)
    std::printf("%d iterations, u is at most %.3g, the first eigenvalue above 0 is %.5g\n",
                report.iterations, largest, spectrum.pairs.values[1]);
}

int main(int argc, char* argv[]) {
  if(SlepcInitialize(&argc, &argv, nullptr, nullptr) != 0) // with MPI
    return 1;
  const std::string file = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off");
  int status = 0;
  try {
    solve(RL::Communicator(), file, argc > 2 ? std::atoi(argv[2]) : 5);
  } catch(const RL::Distributed_error& e) { // what fails on one rank is thrown by all
    if(RL::Communicator().rank() == 0)
      std::fprintf(stderr, "distributed_surface: %s\n", e.what());
    status = 1;
  }
  SlepcFinalize();
  return status;
}
