// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Makes large meshes: divides each triangle of a mesh into N^2, on its smooth patch.
//
//   refine_mesh MESH N FILE
//
// FILE is a binary .ply or .stl file, with coordinates of four bytes, that is written piece by
// piece: the memory is that of MESH and of the points on its edges. With armadillo_mc1m (1,023,130
// triangles) N = 8 gives 65 million triangles, 10 gives 102, 16 gives 262. The surface is the same
// for every N, up to how well the triangles follow the patches.

#include "support/meshes.h"
#include "support/refined_mesh.h"

#include <CGAL/Restricted_laplacian_3/patches/curved_surface.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <stdexcept>
#include <string>

int main(int argc, char* argv[]) {
  using namespace benchmarks;
  try {
    const int n = argc == 4 ? std::atoi(argv[2]) : 0;
    if(n < 1 || n > 1000) {
      std::fprintf(stderr, "usage: refine_mesh MESH N FILE, N from 1 to 1000\n");
      return 1;
    }
    const auto flat = find_mesh(argv[1]);
    if(!flat)
      throw std::runtime_error("no mesh");
    const RL::Triangulated_surface_3 surface = RL::curved_surface(*flat);
    const Refined_mesh mesh(surface, static_cast<std::uint32_t>(n));
    write_refined_mesh(mesh, argv[3]);
    std::printf("%zu vertices, %zu triangles\n", mesh.number_of_vertices(),
                mesh.number_of_triangles());
    return 0;
  } catch(const std::exception& e) {
    std::fprintf(stderr, "refine_mesh: %s\n", e.what());
    return 1;
  }
}
