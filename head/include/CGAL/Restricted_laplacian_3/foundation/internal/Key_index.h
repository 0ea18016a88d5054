// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_INTERNAL_KEY_INDEX_H
#define CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_INTERNAL_KEY_INDEX_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// Makes the search in a sorted array of keys short: says where the keys begin whose highest bits
/// have a value. There are about as many values as keys.
class Key_index {
public:
  /// an index of no keys
  Key_index() : m_first_of_prefix(2, 0) {}

  /// \param keys ascending; not kept
  /// \param bits of the keys that may be set
  Key_index(const std::vector<std::uint64_t>& keys, int bits) {
    int prefix_bits = 0;
    while(prefix_bits < bits && std::size_t(1) << prefix_bits < keys.size())
      ++prefix_bits;
    m_shift = bits - prefix_bits;
    m_first_of_prefix.resize((std::size_t(1) << prefix_bits) + 1);
    std::size_t i = 0;
    for(std::size_t prefix = 0; prefix < m_first_of_prefix.size(); ++prefix) {
      while(i < keys.size() && prefix_of(keys[i]) < prefix)
        ++i;
      m_first_of_prefix[prefix] = static_cast<std::uint32_t>(i);
    }
  }

  /// the position of a key, or the number of keys
  /// \param keys those that this index was made of
  /// \param key with no more bits than those
  std::size_t find(const std::vector<std::uint64_t>& keys, std::uint64_t key) const {
    const std::size_t prefix = prefix_of(key);
    const auto last = keys.begin() + m_first_of_prefix[prefix + 1];
    const auto it = std::lower_bound(keys.begin() + m_first_of_prefix[prefix], last, key);
    return it != last && *it == key ? static_cast<std::size_t>(it - keys.begin()) : keys.size();
  }

private:
  // a shift by all 64 bits is not defined
  std::size_t prefix_of(std::uint64_t key) const {
    return m_shift < 64 ? static_cast<std::size_t>(key >> m_shift) : 0;
  }

  std::vector<std::uint32_t> m_first_of_prefix; // and one more
  int m_shift = 64;
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_INTERNAL_KEY_INDEX_H
