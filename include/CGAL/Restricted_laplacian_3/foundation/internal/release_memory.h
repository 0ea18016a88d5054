// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_INTERNAL_RELEASE_MEMORY_H
#define CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_INTERNAL_RELEASE_MEMORY_H

#include <Eigen/SparseCore>

#include <cstdint>

#ifdef __linux__
#include <sys/mman.h>
#include <unistd.h>
#endif

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

#ifdef __linux__
/// Gives the pages in an array that is no longer used back to the system. The array remains
/// allocated; its content is lost.
template <class T> void release_pages(T* begin, T* end) {
  const auto page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
  const std::uintptr_t first = (reinterpret_cast<std::uintptr_t>(begin) + page - 1) / page * page,
                       last = reinterpret_cast<std::uintptr_t>(end) / page * page;
  // If the system refuses, the memory stays in use, and nothing else is different.
  if(first < last)
    static_cast<void>(madvise(reinterpret_cast<void*>(first), last - first, MADV_DONTNEED));
}
#endif

/// Releases the memory that a matrix has allocated beyond its entries. On Linux without a copy: the
/// moment at which one exists beside the matrix would be that of the largest need of memory.
inline void release_free_entries(Eigen::SparseMatrix<double>& a) {
#ifdef __linux__
  const auto size = a.data().size(), allocated = a.data().allocatedSize();
  release_pages(a.valuePtr() + size, a.valuePtr() + allocated);
  release_pages(a.innerIndexPtr() + size, a.innerIndexPtr() + allocated);
#else
  a.data().squeeze();
#endif
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_INTERNAL_RELEASE_MEMORY_H
