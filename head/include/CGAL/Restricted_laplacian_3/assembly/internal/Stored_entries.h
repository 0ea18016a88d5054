// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_INTERNAL_STORED_ENTRIES_H
#define CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_INTERNAL_STORED_ENTRIES_H

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// which entries of a symmetric matrix are stored: all, or those on and above the diagonal
enum class Stored_entries { all, upper_half };

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_INTERNAL_STORED_ENTRIES_H
