// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// All that depends on where and from what the benchmarks are built, in a source of its own: so
// nothing else is compiled again in another folder, or for another commit.

#include "built_from.h"

namespace benchmarks {

const char built_from_commit[] = RESTRICTED_LAPLACIAN_3_COMMIT;
const char built_with_flags[] = RESTRICTED_LAPLACIAN_3_BUILD;
const char folder_of_shared_meshes[] = RESTRICTED_LAPLACIAN_3_SHARED_MESHES;
const char folder_of_cgal_meshes[] = RESTRICTED_LAPLACIAN_3_DATA_DIR;

} // namespace benchmarks
