// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// In a source of its own: so nothing else is compiled again where the meshes lie elsewhere.

#include "test_meshes.h"

const char folder_of_cgal_meshes[] = RESTRICTED_LAPLACIAN_3_DATA_DIR;
const char folder_of_shared_meshes[] = RESTRICTED_LAPLACIAN_3_SHARED_MESHES;
const char folder_of_small_meshes[] = RESTRICTED_LAPLACIAN_3_MESH_FILES;
