// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// A Poisson problem on a mesh of any size: files are read in pieces, no mesh is built, and the
// depth is the largest up to 7 that a share of the memory allows.
//
// usage: large_surface [FILE [GB]]

#include <CGAL/Restricted_laplacian_3/files/read_mesh_file.h>
#include <CGAL/Restricted_laplacian_3/foundation/memory.h>
#include <CGAL/Restricted_laplacian_3/solve_poisson.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_function_3.h>
#include <CGAL/Restricted_laplacian_3/splines/estimate_memory.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace RL = CGAL::Restricted_laplacian_3;
namespace params = RL::parameters;

int main(int argc, char* argv[]) try {
  const std::string file = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off");
  const double memory = argc > 2 ? 1e9 * std::atof(argv[2]) : 0.5 * RL::memory_of_machine();

  // The arrays become the surface. Copies of it, as in the space, share them.
  RL::Mesh_file mesh = RL::read_mesh_file(file);
  const RL::Triangulated_surface_3 surface(std::move(mesh.points), std::move(mesh.triangles));
  std::printf("%zu triangles\ndepth  unknowns      MB\n", surface.number_of_faces());
  int depth = 1;
  for(int d = 1; d <= 7; ++d) {
    const RL::Memory_estimate estimate = RL::estimate_memory(surface, d);
    std::printf("%5d %9.0f %7.0f\n", d, estimate.dimension, 1e-6 * estimate.total());
    if(estimate.total() <= memory)
      depth = d;
  }

  // What does not fit is refused here, before any work.
  const RL::Spline_space_3 space(surface,
                                 params::depth(depth).maximum_memory(memory).concurrency_tag(
                                     CGAL::Parallel_if_available_tag()));
  const RL::Poisson_solution solution =
      RL::solve_poisson(space, [](const RL::Surface_point& p) { return p.point.x(); });
  double low = INFINITY, high = -INFINITY;
  for(double u : RL::Spline_function_3(space, solution.coefficients).values_at_vertices()) {
    low = std::fmin(low, u); // NaN at vertices without a triangle
    high = std::fmax(high, u);
  }
  std::printf("depth %d, %zu unknowns, %d iterations\nu is between %.3g and %.3g\n", depth,
              space.dimension(), solution.iterations, low, high);
  return 0;
} catch(const std::exception& e) {
  std::fprintf(stderr, "large_surface: %s\n", e.what());
  return 1;
}
