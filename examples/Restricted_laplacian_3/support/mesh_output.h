// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_EXAMPLES_MESH_OUTPUT_H
#define RESTRICTED_LAPLACIAN_3_EXAMPLES_MESH_OUTPUT_H

// Writes colored meshes.

#include "color_map.h"
#include "mesh_input.h"
#include "program.h"

#include <CGAL/IO/Color.h>
#include <CGAL/IO/io.h>
#include <CGAL/Surface_mesh/IO/PLY.h>

#include <iostream>
#include <string>
#include <vector>

namespace examples {

// Writes a binary PLY file of a mesh with all its property maps, and a color for each vertex that
// shows `values`.
inline void write_mesh(const std::string& file, Mesh mesh, const Values& values) {
  auto color_map = mesh.add_property_map<Vertex, CGAL::IO::Color>("v:color").first;
  const std::vector<Color> colors = value_colors(values);
  for(const Vertex v : mesh.vertices()) {
    const Color& c = colors[v.idx()];
    color_map[v] =
        CGAL::IO::Color(linear_to_srgb(c[0]), linear_to_srgb(c[1]), linear_to_srgb(c[2]));
  }
  write_file(file, [&](std::ostream& out) {
    CGAL::IO::set_binary_mode(out);
    CGAL::IO::write_PLY(out, mesh);
  });
}

} // namespace examples

#endif // RESTRICTED_LAPLACIAN_3_EXAMPLES_MESH_OUTPUT_H
