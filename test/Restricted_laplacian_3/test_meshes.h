// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_TEST_TEST_MESHES_H
#define RESTRICTED_LAPLACIAN_3_TEST_TEST_MESHES_H

#include <fstream>
#include <string>

/// \file
/// Paths of mesh files. They are empty where the file is not there, and the test that needs it says
/// so with `SKIP_TEST()` or `SKIP_PART()`.

extern const char folder_of_cgal_meshes[], folder_of_shared_meshes[];

/// small files of all formats, which are there
extern const char folder_of_small_meshes[];

inline std::string path_of_mesh(const std::string& folder, const std::string& file) {
  const std::string path = folder + "/" + file;
  return !folder.empty() && std::ifstream(path) ? path : std::string();
}

/// a mesh of CGAL's data, one of those listed in cmake/Restricted_laplacian_3_test_data.cmake
inline std::string cgal_mesh(const std::string& file) {
  return path_of_mesh(folder_of_cgal_meshes, file);
}

/// a mesh of the larger set
inline std::string shared_mesh(const std::string& file) {
  return path_of_mesh(folder_of_shared_meshes, file);
}

#endif // RESTRICTED_LAPLACIAN_3_TEST_TEST_MESHES_H
