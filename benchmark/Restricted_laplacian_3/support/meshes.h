// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_BENCHMARK_MESHES_H
#define RESTRICTED_LAPLACIAN_3_BENCHMARK_MESHES_H

#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>

#include <CGAL/Surface_mesh.h>

#include <optional>
#include <string>

namespace benchmarks {

namespace RL = CGAL::Restricted_laplacian_3;

/// A file in the folder of shared meshes, or among CGAL's data, whether it is there or not.
std::string shared_file(const std::string& name);
std::string cgal_file(const std::string& name);

/// A mesh file, or the one of that name in the folder of shared meshes or among those of CGAL's
/// data; empty, and a message, if there is none.
std::string find_path(const std::string& name);

/// The mesh of a file, if it can be read.
std::optional<CGAL::Surface_mesh<RL::Point_3>> read_mesh_file(const std::string& file);

/// The mesh that `find_path()` finds, if it can be read.
std::optional<CGAL::Surface_mesh<RL::Point_3>> find_mesh_file(const std::string& name);

/// the same as a surface
std::optional<RL::Triangulated_surface_3> find_mesh(const std::string& name);

} // namespace benchmarks

#endif // RESTRICTED_LAPLACIAN_3_BENCHMARK_MESHES_H
