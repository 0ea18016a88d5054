// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// How do the times of octree, numbering and exact assembly grow with depth and with the number of
// triangles? One mesh (the argument, or CGAL's bunny) at depths 5 to 8, the same with elements that
// are not split, and spheres of 8 thousand to 2 million triangles at depth 6. One core. Prints a
// table that gnuplot reads; for each run also the time per unknown and per fragment (part of a
// triangle in a cell): both are flat where the growth is linear.
//
// usage: assembly_scaling [MESH]

#include "sphere.h"

#include <CGAL/Restricted_laplacian_3/assemble.h>

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Real_timer.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cstdio>
#include <string>

namespace RL = CGAL::Restricted_laplacian_3;

namespace {

void run(const char* name, const RL::Triangulated_surface_3& surface, int depth,
         bool is_split = true) {
  // the best of three: other programs share the machine
  double space_seconds = 1e9, assembly_seconds = 1e9;
  std::size_t unknowns = 0, fragments = 0, entries = 0;
  for(int repetition = 0; repetition < 3; ++repetition) {
    CGAL::Real_timer timer;
    timer.start();
    RL::Spline_space_options options;
    options.octree_depth = depth;
    options.split_elements = is_split;
    const RL::Spline_space_3 space(surface, options);
    const double space_end = timer.time();
    const RL::Operators operators = RL::assemble_operators(space);
    const double assembly_end = timer.time();
    space_seconds = (std::min)(space_seconds, space_end);
    assembly_seconds = (std::min)(assembly_seconds, assembly_end - space_end);
    unknowns = space.dimension();
    fragments = space.octree().number_of_fragments();
    entries = static_cast<std::size_t>(operators.stiffness.nonZeros());
  }
  const double seconds = space_seconds + assembly_seconds;
  std::printf("%-8s %9zu %5d %9zu %9zu %10zu %8.3f %8.3f %8.3f %10.2f %10.2f\n", name,
              surface.number_of_faces(), depth, fragments, unknowns, entries, space_seconds,
              assembly_seconds, seconds, 1e6 * seconds / static_cast<double>(unknowns),
              1e6 * seconds / static_cast<double>(fragments));
  std::fflush(stdout);
}

} // namespace

int main(int argc, char* argv[]) {
  const std::string path =
      argc > 1 ? argv[1] : std::string(RESTRICTED_LAPLACIAN_3_DATA_DIR) + "/bunny00.off";
  CGAL::Surface_mesh<RL::Point_3> mesh;
  if(!CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(path, mesh)) {
    std::fprintf(stderr, "cannot read %s\n", path.c_str());
    return 1;
  }
  std::printf("# %-6s %9s %5s %9s %9s %10s %8s %8s %8s %10s %10s\n", "surface", "triangles",
              "depth", "fragments", "unknowns", "entries", "space_s", "assem_s", "total_s",
              "us/unknown", "us/fragm");
  const RL::Triangulated_surface_3 surface = RL::read_surface(mesh);
  for(int depth = 5; depth <= 8; ++depth)
    run("mesh", surface, depth);
  std::printf("\n\n");
  for(int depth = 5; depth <= 8; ++depth)
    run("unsplit", surface, depth, false);
  std::printf("\n\n");
  for(int n = 5; n <= 9; ++n)
    run("sphere", sphere(n), 6);
}
