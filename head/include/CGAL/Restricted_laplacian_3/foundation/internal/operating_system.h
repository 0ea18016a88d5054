// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_INTERNAL_OPERATING_SYSTEM_H
#define CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_INTERNAL_OPERATING_SYSTEM_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// a function of the libraries that the process has loaded; null if there is none of this name, or
/// where the system does not tell
void* loaded_function(const char* name);

/// bytes of the memory of the machine; infinite where the system does not tell
double physical_memory();

/// bytes that the process may take, whatever the machine has; infinite without a limit
double memory_limit_of_process();

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/foundation/internal/operating_system_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_INTERNAL_OPERATING_SYSTEM_H
