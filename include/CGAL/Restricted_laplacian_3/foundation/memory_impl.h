// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_MEMORY_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_MEMORY_IMPL_H

#include <CGAL/Restricted_laplacian_3/foundation/memory.h>

#if __has_include(<sys/resource.h>) && __has_include(<unistd.h>)
#include <sys/resource.h>
#include <unistd.h>
#define CGAL_RESTRICTED_LAPLACIAN_3_POSIX
#endif

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <string>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// the number in a file; infinity if there is none
inline double limit_in_file(const std::string& file) {
  double limit;
  std::ifstream in(file);
  return in >> limit ? limit : std::numeric_limits<double>::infinity();
}

/// The smallest limit of the control groups of Linux, version 2, that this process is in, and of
/// the whole container in version 1.
inline double limit_of_control_groups() {
  const std::string root = "/sys/fs/cgroup";
  double limit = (std::min)(limit_in_file(root + "/memory.max"),
                            limit_in_file(root + "/memory/memory.limit_in_bytes"));
  std::ifstream groups("/proc/self/cgroup");
  for(std::string line; std::getline(groups, line);) {
    if(line.compare(0, 3, "0::") != 0)
      continue;
    for(std::string group = line.substr(3); group.size() > 1; group.erase(group.rfind('/')))
      limit = (std::min)(limit, limit_in_file(root + group + "/memory.max"));
  }
  return limit;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE std::string memory_text(double bytes) {
  const bool is_large = bytes >= 1e9;
  const double value = bytes / (is_large ? 1e9 : 1e6);
  char text[64];
  std::snprintf(text, sizeof text, value < 9.95 ? "%.1f %s" : "%.0f %s", value,
                is_large ? "GB" : "MB");
  return text;
}

} // namespace internal

CGAL_RESTRICTED_LAPLACIAN_3_INLINE double memory_of_machine() {
  double memory = std::numeric_limits<double>::infinity();
#ifdef CGAL_RESTRICTED_LAPLACIAN_3_POSIX
#if defined(_SC_PHYS_PAGES) && defined(_SC_PAGESIZE)
  const double pages = static_cast<double>(sysconf(_SC_PHYS_PAGES)),
               size = static_cast<double>(sysconf(_SC_PAGESIZE));
  if(pages > 0 && size > 0)
    memory = pages * size;
#endif
  rlimit limit;
  if(getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
    memory = (std::min)(memory, static_cast<double>(limit.rlim_cur));
  memory = (std::min)(memory, internal::limit_of_control_groups());
#endif
  return memory;
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#undef CGAL_RESTRICTED_LAPLACIAN_3_POSIX

#endif // CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_MEMORY_IMPL_H
