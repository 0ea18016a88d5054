// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_PROGRAMS_MESH_INPUT_H
#define RESTRICTED_LAPLACIAN_3_PROGRAMS_MESH_INPUT_H

// Reads a surface from a file.

#include "program.h"

#include <CGAL/Restricted_laplacian_3/files/read_mesh_file.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>

#include <functional>
#include <string>

namespace programs {

// hears which part of a file is read
using Callback = std::function<bool(double)>;

struct Mesh_input {
  // The vertices and triangles of the file, in its order. They need not form a manifold. Or its
  // points, see point_input.h.
  RL::Triangulated_surface_3 surface;
  // whether the file has faces that are not triangles
  bool is_triangulated;
};

namespace internal {

// reads a file, and says on the standard error stream what was passed over
RL::Mesh_file read_file(const std::string& file, const Callback& callback = {});
Mesh_input mesh_of(RL::Mesh_file mesh, const std::string& file);

} // namespace internal

// Nothing is repaired: it does not matter how many faces meet in an edge and how they are oriented,
// and points at the same place remain different vertices.
Mesh_input read_mesh(const std::string& file, const Callback& callback = {});

} // namespace programs

#endif // RESTRICTED_LAPLACIAN_3_PROGRAMS_MESH_INPUT_H
