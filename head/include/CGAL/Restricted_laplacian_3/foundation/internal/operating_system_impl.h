// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_INTERNAL_OPERATING_SYSTEM_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_INTERNAL_OPERATING_SYSTEM_IMPL_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/operating_system.h>

// The only file that calls what POSIX has and the standard library has not.
#if __has_include(<dlfcn.h>)
#include <dlfcn.h>
#endif
#if __has_include(<sys/resource.h>) && __has_include(<unistd.h>)
#include <sys/resource.h>
#include <unistd.h>
#define CGAL_RESTRICTED_LAPLACIAN_3_HAS_LIMITS
#endif

#include <limits>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void* loaded_function([[maybe_unused]] const char* name) {
#if __has_include(<dlfcn.h>)
  return dlsym(RTLD_DEFAULT, name);
#else
  return nullptr;
#endif
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE double physical_memory() {
#if defined(_SC_PHYS_PAGES) && defined(_SC_PAGESIZE)
  const double pages = static_cast<double>(sysconf(_SC_PHYS_PAGES)),
               size = static_cast<double>(sysconf(_SC_PAGESIZE));
  if(pages > 0 && size > 0)
    return pages * size;
#endif
  return std::numeric_limits<double>::infinity();
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE double memory_limit_of_process() {
#ifdef CGAL_RESTRICTED_LAPLACIAN_3_HAS_LIMITS
  rlimit limit;
  if(getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
    return static_cast<double>(limit.rlim_cur);
#endif
  return std::numeric_limits<double>::infinity();
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#undef CGAL_RESTRICTED_LAPLACIAN_3_HAS_LIMITS

#endif // CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_INTERNAL_OPERATING_SYSTEM_IMPL_H
