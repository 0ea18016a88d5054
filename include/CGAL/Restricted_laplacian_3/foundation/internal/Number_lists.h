// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_INTERNAL_NUMBER_LISTS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_INTERNAL_NUMBER_LISTS_H

#include <boost/range/iterator_range.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// A list of numbers for each of the numbers 0 .. size - 1, all in one array.
class Number_lists {
public:
  using Pair = std::pair<std::uint32_t, std::uint32_t>;

  Number_lists() : m_first(1, 0) {}

  /// List `i` consists of all `j` with a pair (i, j), ascending and without repetition.
  Number_lists(std::size_t size, const std::vector<Pair>& pairs) : m_first(size + 1, 0) {
    for(const Pair& pair : pairs)
      ++m_first[pair.first + 1];
    for(std::size_t i = 0; i < size; ++i)
      m_first[i + 1] += m_first[i];
    m_numbers.resize(pairs.size());
    std::vector<std::size_t> next(m_first.begin(), m_first.end() - 1);
    for(const Pair& pair : pairs)
      m_numbers[next[pair.first]++] = pair.second;
    auto end = m_numbers.begin();
    for(std::size_t i = 0, first = 0; i < size; ++i) {
      const auto begin = m_numbers.begin() + first;
      first = m_first[i + 1];
      std::sort(begin, m_numbers.begin() + first);
      end = std::unique_copy(begin, m_numbers.begin() + first, end);
      m_first[i + 1] = static_cast<std::size_t>(end - m_numbers.begin());
    }
    m_numbers.erase(end, m_numbers.end());
  }

  boost::iterator_range<const std::uint32_t*> operator[](std::size_t i) const {
    return {m_numbers.data() + m_first[i], m_numbers.data() + m_first[i + 1]};
  }

private:
  std::vector<std::size_t> m_first;
  std::vector<std::uint32_t> m_numbers;
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_INTERNAL_NUMBER_LISTS_H
