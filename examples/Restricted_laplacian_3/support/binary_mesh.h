// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_EXAMPLES_BINARY_MESH_H
#define RESTRICTED_LAPLACIAN_3_EXAMPLES_BINARY_MESH_H

// Reads binary files of triangles in one go: CGAL's readers take a stream number by number.

#include "program.h"

#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>

#include <optional>
#include <string>
#include <vector>

namespace examples {

struct Triangle_soup {
  std::vector<RL::Point_3> points;
  std::vector<RL::Triangulated_surface_3::Triangle> triangles;
};

// What is in a binary PLY or STL file. Nothing, if it is another file, if it has other faces than
// triangles, or if there is something wrong: then CGAL's readers are to have a look, and to say
// what. The result is what they would give: points in the order of a PLY file, and in STL files
// equal points as one, in the order in which they are met.
std::optional<Triangle_soup> read_binary_triangles(const std::string& file);

} // namespace examples

#endif // RESTRICTED_LAPLACIAN_3_EXAMPLES_BINARY_MESH_H
