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
#include <CGAL/Restricted_laplacian_3/files/read_mesh_file.h>

#include <slepcsys.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace RL = CGAL::Restricted_laplacian_3;

void solve(const RL::Communicator& ranks, const std::string& file, int depth) {
  // Each rank reads a part of a binary PLY file. Other files the first one reads for all.
  std::optional<RL::Surface_slice> slice = RL::read_binary_ply_slice(ranks, file);
  if(!slice) {
    std::optional<RL::Triangulated_surface_3> whole;
    ranks.agree([&] { // what fails here on one rank is thrown by all
      if(ranks.rank() != 0)
        return;
      RL::Mesh_file mesh = RL::read_mesh_file(file);
      whole.emplace(std::move(mesh.points), std::move(mesh.triangles));
    });
    slice = RL::slice_of_first_rank(ranks, whole ? &*whole : nullptr);
  }
  const RL::Distributed_surface surface(ranks, std::move(*slice));
  RL::Spline_space_options options;
  options.depth = depth;
  const RL::Distributed_space space(surface, options);

  // Laplacian u = z: each rank assembles the load of its part of the surface
  const Eigen::VectorXd load =
      RL::assemble_load(space.part(), [](const RL::Surface_point& p) { return -p.point.z(); });
  const RL::Distributed_poisson_solver solver(space);
  Eigen::VectorXd coefficients;
  const RL::Solve_report report = solver.solve(load, coefficients);

  // at the vertices of the slice of this rank
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for(const double u : RL::values_at_vertices(surface, space, coefficients)) {
    low = std::fmin(low, u); // NaN at vertices without a triangle
    high = std::fmax(high, u);
  }
  low = ranks.minimum(low);
  high = ranks.maximum(high);

  constexpr int number_of_eigenvalues = 10;
  const RL::Distributed_spectrum spectrum = RL::laplace_spectrum(space, number_of_eigenvalues);
  if(ranks.rank() != 0)
    return;
  std::printf("depth %d, %llu unknowns, %d iterations\nu is between %.3g and %.3g\n", depth,
              static_cast<unsigned long long>(space.dimension(depth)), report.iterations, low,
              high);
  for(const double eigenvalue : spectrum.pairs.values)
    std::printf("%.5g\n", std::abs(eigenvalue) < 1e-9 ? 0 : eigenvalue);
}

int main(int argc, char* argv[]) {
  // with MPI, unless it is there
  if(SlepcInitialize(&argc, &argv, nullptr, nullptr) != 0)
    return 1;
  const std::string file = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off");
  const int depth = argc > 2 ? std::atoi(argv[2]) : 5;
  int status = 0;
  try {
    solve(RL::Communicator(), file, depth);
  } catch(const RL::Distributed_error& e) { // on all ranks
    if(RL::Communicator().rank() == 0)
      std::fprintf(stderr, "distributed_surface: %s\n", e.what());
    status = 1;
  } catch(const std::exception& e) { // on this one
    std::fprintf(stderr, "distributed_surface: %s\n", e.what());
    MPI_Abort(MPI_COMM_WORLD, 1);
  }
  SlepcFinalize();
  return status;
}
