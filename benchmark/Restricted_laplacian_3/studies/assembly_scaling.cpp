// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// How do the times of octree, numbering and exact assembly grow with depth, with the number of
// triangles, and with the number of threads?
// - one mesh (the argument, or CGAL's bunny) at depths 5 to 8, the same with elements that are not
//   split, and spheres of 8 thousand to 2 million triangles at depth 6;
// - the armadillo of a million triangles from the shared meshes, at depths 6 and 7.
//
// Prints a table that gnuplot reads. Times: from the mesh in memory, or the triangles of a sphere,
// to octree and numbering (space_s); the stiffness matrix of the finest level alone (S_s);
// stiffness and mass matrices of all levels (all_s). Mfragm/s: millions of fragments (parts of
// triangles in cells) per second of S_s. us/unknown: microseconds of space_s and all_s per unknown;
// flat where the growth is linear. With TBB each line is printed for one thread and for two.
//
// usage: assembly_scaling [MESH]

#include "support/measure.h"
#include "support/meshes.h"
#include "support/sphere.h"

#include <CGAL/Restricted_laplacian_3/assembly/assemble.h>
#include <CGAL/Restricted_laplacian_3/input/read_surface.h>

#include <CGAL/Real_timer.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <algorithm>
#include <cstdio>
#include <string>
#include <utility>

namespace RL = CGAL::Restricted_laplacian_3;

namespace {

/// calls `function` and returns the seconds it took
template <class Function> double seconds(Function&& function) {
  CGAL::Real_timer timer;
  timer.start();
  function();
  return timer.time();
}

/// \param make_surface makes the `RL::Triangulated_surface_3`
template <class Make>
void run(const char* name, const Make& make_surface, int depth, int threads, bool is_split) {
#ifdef CGAL_LINKED_WITH_TBB
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  static_cast<std::size_t>(threads));
#endif
  RL::Spline_space_options options;
  options.depth = depth;
  options.split = is_split;
  options.is_parallel = threads > 1;
  // the best of three: other programs share the machine
  double space_seconds = 1e9, stiffness_seconds = 1e9, all_seconds = 1e9;
  std::size_t triangles = 0, unknowns = 0, fragments = 0, entries = 0;
  for(int repetition = 0; repetition < 3; ++repetition) {
    CGAL::Real_timer timer;
    timer.start();
    const RL::Spline_space_3 space(make_surface(), options);
    space_seconds = (std::min)(space_seconds, timer.time());
    stiffness_seconds = (std::min)(stiffness_seconds, seconds([&] {
                                     entries = static_cast<std::size_t>(
                                         RL::assemble_stiffness_matrix(space, depth).nonZeros());
                                   }));
    all_seconds = (std::min)(all_seconds,
                             seconds([&] { RL::assemble_operators_of_levels(space, 0, depth); }));
    triangles = space.surface().number_of_faces();
    unknowns = space.dimension();
    fragments = space.octree().number_of_fragments();
  }
  std::printf("%-9s %9zu %5d %7d %9zu %9zu %10zu %8.3f %8.3f %8.3f %9.2f %10.2f\n", name, triangles,
              depth, threads, fragments, unknowns, entries, space_seconds, stiffness_seconds,
              all_seconds, 1e-6 * static_cast<double>(fragments) / stiffness_seconds,
              1e6 * (space_seconds + all_seconds) / static_cast<double>(unknowns));
  std::fflush(stdout);
}

template <class Make>
void run_on_threads(const char* name, const Make& make_surface, int depth, bool is_split = true) {
  run(name, make_surface, depth, 1, is_split);
#ifdef CGAL_LINKED_WITH_TBB
  run(name, make_surface, depth, 2, is_split);
#endif
}

} // namespace

int main(int argc, char* argv[]) {
  const std::string path = argc > 1 ? argv[1] : benchmarks::cgal_file("bunny00.off");
  const auto mesh = benchmarks::read_mesh_file(path);
  if(!mesh) {
    std::fprintf(stderr, "cannot read %s\n", path.c_str());
    return 1;
  }
  benchmarks::print_header(argc, argv);
  std::printf("# %-7s %9s %5s %7s %9s %9s %10s %8s %8s %8s %9s %10s\n", "surface", "triangles",
              "depth", "threads", "fragments", "unknowns", "entries", "space_s", "S_s", "all_s",
              "Mfragm/s", "us/unknown");
  const auto read = [&mesh] { return RL::read_surface(*mesh); };
  for(int depth = 5; depth <= 8; ++depth)
    run_on_threads("mesh", read, depth);
  std::printf("\n\n");
  for(int depth = 5; depth <= 8; ++depth)
    run_on_threads("unsplit", read, depth, false);
  std::printf("\n\n");
  for(int n = 5; n <= 9; ++n) {
    const RL::Triangulated_surface_3 surface = sphere(n);
    run_on_threads(
        "sphere", [&surface] { return surface; }, 6);
  }
  std::printf("\n\n");
  const auto large = benchmarks::read_mesh_file(benchmarks::shared_file("armadillo_mc1m.ply"));
  if(!large) {
    std::printf("# left out: cannot read armadillo_mc1m.ply of the shared meshes\n");
    return 0;
  }
  for(int depth = 6; depth <= 7; ++depth)
    run_on_threads(
        "armadillo", [&large] { return RL::read_surface(*large); }, depth);
}
