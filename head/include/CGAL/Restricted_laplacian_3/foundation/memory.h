// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_MEMORY_H
#define CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_MEMORY_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>

#include <string>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Options
/// The memory that a process may take, in bytes: that of the machine, or less where the limits of
/// its control group (a container has one) or of its address space say so. Infinity where the
/// system does not tell.
double memory_of_machine();

namespace internal {

/// bytes for people: "950 MB", "16 GB"
std::string memory_text(double bytes);

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/foundation/memory_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_MEMORY_H
