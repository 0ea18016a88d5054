// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_INTERNAL_DISJOINT_SETS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_INTERNAL_DISJOINT_SETS_H

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// Disjoint sets of the numbers 0 .. size - 1. The representative of a set is its smallest element,
/// whatever the order of the unions, so results do not depend on that order. Kept between uses, it
/// allocates nothing (unlike `boost::disjoint_sets`, whose representatives depend on the order).
class Disjoint_sets {
public:
  explicit Disjoint_sets(std::size_t size = 0) { reset(size); }

  /// `size` sets of one element each
  void reset(std::size_t size) {
    m_parents.resize(size);
    std::iota(m_parents.begin(), m_parents.end(), 0u);
  }

  /// the smallest element of the set of `i`
  std::uint32_t find(std::uint32_t i) {
    while(m_parents[i] != i)
      i = m_parents[i] = m_parents[m_parents[i]];
    return i;
  }

  void unite(std::uint32_t i, std::uint32_t j) {
    i = find(i);
    j = find(j);
    if(i < j)
      m_parents[j] = i;
    else
      m_parents[i] = j;
  }

private:
  std::vector<std::uint32_t> m_parents;
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_INTERNAL_DISJOINT_SETS_H
