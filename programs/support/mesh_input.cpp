// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "mesh_input.h"

#include "program.h"

#include <iostream>
#include <utility>

namespace programs {

namespace internal {

RL::Mesh_file read_file(const std::string& file, const Callback& callback) {
  check_input(file);
  RL::Mesh_file mesh = RL::read_mesh_file(file, RL::parameters::progress(callback));
  if(this_run().is_quiet)
    return mesh;
  for(const std::string& warning : mesh.warnings)
    std::cerr << "warning: '" << file << "': " << warning << std::endl;
  return mesh;
}

Mesh_input mesh_of(RL::Mesh_file mesh, const std::string& file) {
  require(!mesh.triangles.empty(), "'" + file + "' holds no face");
  try {
    return {RL::Triangulated_surface_3(std::move(mesh.points), std::move(mesh.triangles)),
            mesh.number_of_divided_faces > 0};
  } catch(const RL::Parameter_error&) {
    throw;
  } catch(const RL::Input_error& e) {
    throw Error("'" + file + "': " + e.what());
  }
}

} // namespace internal

Mesh_input read_mesh(const std::string& file, const Callback& callback) {
  return internal::mesh_of(internal::read_file(file, callback), file);
}

} // namespace programs
