// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_BENCHMARK_BUILT_FROM_H
#define RESTRICTED_LAPLACIAN_3_BENCHMARK_BUILT_FROM_H

namespace benchmarks {

// what the build knows
extern const char built_from_commit[], built_with_flags[];
extern const char folder_of_shared_meshes[], folder_of_cgal_meshes[];

} // namespace benchmarks

#endif // RESTRICTED_LAPLACIAN_3_BENCHMARK_BUILT_FROM_H
