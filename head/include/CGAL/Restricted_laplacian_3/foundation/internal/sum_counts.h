// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_INTERNAL_SUM_COUNTS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_INTERNAL_SUM_COUNTS_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// Replaces counts of entries by their running sums, and returns the last one.
/// \param counts,size how many entries each column of a sparse matrix has, none of them negative
/// \param parameter,matrix whose value gives which matrix, for the message
/// \throws Parameter_error if there are more entries than an `int` can number
inline int sum_counts(int* counts, std::size_t size, const std::string& parameter,
                      const std::string& matrix) {
  std::int64_t sum = 0;
  for(std::size_t i = 0; i < size; ++i) {
    sum += counts[i];
    if(sum > (std::numeric_limits<int>::max)())
      throw Parameter_error(parameter, "gives a " + matrix + " of more than 2^31 - 1 entries");
    counts[i] = static_cast<int>(sum);
  }
  return static_cast<int>(sum);
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_INTERNAL_SUM_COUNTS_H
