// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_BENCHMARK_MESHES_H
#define RESTRICTED_LAPLACIAN_3_BENCHMARK_MESHES_H

#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Surface_mesh.h>

#include <cstdio>
#include <fstream>
#include <optional>
#include <string>

namespace benchmarks {

namespace RL = CGAL::Restricted_laplacian_3;

/// A mesh file, or the one of that name in the folder of shared meshes or among those of CGAL's
/// data; empty, and a message, if there is none.
inline std::string find_path(const std::string& name) {
  for(const std::string& file :
      {name, std::string(RESTRICTED_LAPLACIAN_3_SHARED_MESHES) + "/" + name + ".ply",
       std::string(RESTRICTED_LAPLACIAN_3_DATA_DIR) + "/" + name + ".off"})
    if(std::ifstream(file).good())
      return file;
  std::fprintf(
      stderr,
      "SKIPPED: there is no mesh %s, nor %s.ply in the folder of shared meshes, nor %s.off "
      "in CGAL's data\n",
      name.c_str(), name.c_str(), name.c_str());
  return {};
}

/// The mesh that `find_path()` finds, if it can be read.
inline std::optional<CGAL::Surface_mesh<RL::Point_3>> find_mesh_file(const std::string& name) {
  const std::string file = find_path(name);
  CGAL::Surface_mesh<RL::Point_3> mesh;
  if(!file.empty() && CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(file, mesh))
    return mesh;
  return std::nullopt;
}

/// the same as a surface
inline std::optional<RL::Triangulated_surface_3> find_mesh(const std::string& name) {
  if(const auto mesh = find_mesh_file(name))
    return RL::read_surface(*mesh);
  return std::nullopt;
}

} // namespace benchmarks

#endif // RESTRICTED_LAPLACIAN_3_BENCHMARK_MESHES_H
