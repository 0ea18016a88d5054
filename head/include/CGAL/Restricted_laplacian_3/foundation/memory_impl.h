// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_MEMORY_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_MEMORY_IMPL_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/operating_system.h>
#include <CGAL/Restricted_laplacian_3/foundation/memory.h>

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
  return (std::min)({internal::physical_memory(), internal::memory_limit_of_process(),
                     internal::limit_of_control_groups()});
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_MEMORY_IMPL_H
