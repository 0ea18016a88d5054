// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes.h"

#include "built_from.h"

#include <CGAL/Restricted_laplacian_3/input/read_surface.h>

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>

#include <cstdio>
#include <fstream>

namespace benchmarks {

std::string shared_file(const std::string& name) {
  return std::string(folder_of_shared_meshes) + "/" + name;
}

std::string cgal_file(const std::string& name) {
  return std::string(folder_of_cgal_meshes) + "/" + name;
}

std::string find_path(const std::string& name) {
  for(const std::string& file : {name, shared_file(name + ".ply"), cgal_file(name + ".off")})
    if(std::ifstream(file).good())
      return file;
  std::fprintf(
      stderr,
      "SKIPPED: there is no mesh %s, nor %s.ply in the folder of shared meshes, nor %s.off "
      "in CGAL's data\n",
      name.c_str(), name.c_str(), name.c_str());
  return {};
}

std::optional<CGAL::Surface_mesh<RL::Point_3>> read_mesh_file(const std::string& file) {
  CGAL::Surface_mesh<RL::Point_3> mesh;
  if(!file.empty() && CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(file, mesh))
    return mesh;
  return std::nullopt;
}

std::optional<CGAL::Surface_mesh<RL::Point_3>> find_mesh_file(const std::string& name) {
  return read_mesh_file(find_path(name));
}

std::optional<RL::Triangulated_surface_3> find_mesh(const std::string& name) {
  if(const auto mesh = find_mesh_file(name))
    return RL::read_surface(*mesh);
  return std::nullopt;
}

} // namespace benchmarks
