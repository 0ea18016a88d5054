// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_GEODESICS_INTERNAL_PROPAGATION_LIMIT_H
#define CGAL_RESTRICTED_LAPLACIAN_3_GEODESICS_INTERNAL_PROPAGATION_LIMIT_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// Where a propagation stops: a little beyond a distance, and beyond the last of some vertices.
/// What comes later may shorten a way of the fast method, so it goes on a little.
class Propagation_limit {
public:
  /// \param distance infinite, if there is no limit
  /// \param targets vertices, each of them once; empty: all
  Propagation_limit(double distance, const std::vector<std::uint32_t>& targets)
    : m_distance(distance), m_last_key(slack * distance), m_targets_left(targets.size()) {
    for(const std::uint32_t v : targets) {
      m_is_target.resize((std::max)(m_is_target.size(), std::size_t(v) + 1), false);
      m_is_target[v] = true;
    }
  }

  /// what is farther is not asked for
  double distance() const { return m_distance; }
  /// whether the propagation need not go on to what has this distance
  bool is_beyond(double key) const { return key > m_last_key; }
  /// tells that a vertex has its distance, once for each
  void reach(std::uint32_t v, double key) {
    if(v < m_is_target.size() && m_is_target[v] && --m_targets_left == 0)
      m_last_key = (std::min)(m_last_key, slack * key);
  }

private:
  static constexpr double slack = 1.05;

  double m_distance, m_last_key;
  std::size_t m_targets_left;
  std::vector<bool> m_is_target;
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_GEODESICS_INTERNAL_PROPAGATION_LIMIT_H
