// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_INTERNAL_NUMBER_LISTS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_INTERNAL_NUMBER_LISTS_H

#include <boost/range/iterator_range_core.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// Puts values, one for each of the numbers 0 .. `count` - 1, in order by the keys of the numbers,
/// 0 .. `size` - 1; those of the same key keep their order. Numbers with the key `size` are left
/// out. Linear in `size` and `count`.
/// \param key_of number &rarr; key; called twice for each
/// \param value_of number &rarr; value
/// \param first receives the positions at which the values of each key begin, and the end of all
template <class KeyOf, class ValueOf, class Value>
void group_by_key(std::size_t size, std::size_t count, KeyOf&& key_of, ValueOf&& value_of,
                  std::vector<std::size_t>& first, std::vector<Value>& values) {
  // While values are put in place, entry `i + 1` is the end of those of key `i` as far as they are
  // there: at first their begin.
  first.assign(size + 2, 0);
  for(std::size_t number = 0; number < count; ++number) {
    const std::size_t key = key_of(number);
    if(key < size)
      ++first[key + 2];
  }
  std::partial_sum(first.begin(), first.end(), first.begin());
  values.resize(first.back());
  for(std::size_t number = 0; number < count; ++number) {
    const std::size_t key = key_of(number);
    if(key < size)
      values[first[key + 1]++] = value_of(number);
  }
  first.pop_back();
}

/// A list of numbers for each of the numbers 0 .. size - 1, all in one array.
class Number_lists {
public:
  using Pair = std::pair<std::uint32_t, std::uint32_t>;

  Number_lists() : m_first(1, 0) {}

  /// \param numbers the lists, one after the other
  /// \param first position at which each begins, and the end of the last one
  Number_lists(std::vector<std::size_t> first, std::vector<std::uint32_t> numbers)
    : m_first(std::move(first)), m_numbers(std::move(numbers)) {}

  /// List `i` consists of all `j` with a pair (i, j), ascending and without repetition.
  Number_lists(std::size_t size, const std::vector<Pair>& pairs)
    : Number_lists(by_key(size, pairs.size(), [&](std::size_t k) { return pairs[k].first; })) {
    for(std::uint32_t& number : m_numbers)
      number = pairs[number].second;
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

  /// List `i` consists of those of the numbers 0 .. `count` - 1 whose key is `i`, ascending.
  /// Numbers with the key `size` are in no list. Linear in `size` and `count`.
  /// \param key_of number &rarr; key; called twice for each
  template <class KeyOf>
  static Number_lists by_key(std::size_t size, std::size_t count, KeyOf&& key_of) {
    Number_lists result;
    group_by_key(
        size, count, key_of, [](std::size_t number) { return static_cast<std::uint32_t>(number); },
        result.m_first, result.m_numbers);
    return result;
  }

  /// number of lists
  std::size_t size() const { return m_first.size() - 1; }
  /// all lists, one after the other
  const std::vector<std::uint32_t>& numbers() const { return m_numbers; }
  /// position in `numbers()` at which a list begins; of list `size()`, the end of the last one
  std::size_t first(std::size_t i) const { return m_first[i]; }

  /// a list
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
