// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_INTERNAL_STABLE_SORT_BY_KEY_H
#define CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_INTERNAL_STABLE_SORT_BY_KEY_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/parallel_for.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// Sorts by the lowest `bits` bits of `key(value)`; values of equal keys keep their order, so the
/// result does not depend on how the work is shared among threads.
///
/// A radix sort, from the lowest digit to the highest: linear time, one copy of the values.
template <class T, class Key>
void stable_sort_by_key(std::vector<T>& values, int bits, bool is_parallel, Key&& key) {
  const std::size_t n = values.size();
  const int number_of_passes = (bits + 10) / 11;
  if(number_of_passes == 0 || n < 2)
    return;
  const int digit_bits = (bits + number_of_passes - 1) / number_of_passes;
  const std::size_t number_of_digits = std::size_t(1) << digit_bits;
  // Each chunk counts its digits on its own.
  const std::size_t grain = (std::max)(n / 16 + 1, std::size_t(1) << 14);
  std::vector<std::vector<std::size_t>> places((n - 1) / grain + 1);
  std::vector<T> sorted(n);
  for(int pass = 0; pass < number_of_passes; ++pass) {
    const auto digit = [&](const T& value) {
      return static_cast<std::size_t>(key(value) >> (pass * digit_bits)) & (number_of_digits - 1);
    };
    parallel_for(is_parallel, 0, n, grain, [&](std::size_t begin, std::size_t end) {
      auto& counts = places[begin / grain];
      counts.assign(number_of_digits, 0);
      for(std::size_t i = begin; i < end; ++i)
        ++counts[digit(values[i])];
    });
    std::size_t place = 0;
    for(std::size_t d = 0; d < number_of_digits; ++d)
      for(auto& of_chunk : places) {
        const std::size_t count = of_chunk[d];
        of_chunk[d] = place;
        place += count;
      }
    parallel_for(is_parallel, 0, n, grain, [&](std::size_t begin, std::size_t end) {
      auto& next = places[begin / grain];
      for(std::size_t i = begin; i < end; ++i)
        sorted[next[digit(values[i])]++] = values[i];
    });
    values.swap(sorted);
  }
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_INTERNAL_STABLE_SORT_BY_KEY_H
