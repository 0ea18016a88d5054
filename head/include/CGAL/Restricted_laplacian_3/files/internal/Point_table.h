// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_FILES_INTERNAL_POINT_TABLE_H
#define CGAL_RESTRICTED_LAPLACIAN_3_FILES_INTERNAL_POINT_TABLE_H

#include <CGAL/Restricted_laplacian_3/surface/Surface_location.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// Numbers points by their coordinates, in the order in which they are met: a hash table that holds
/// numbers only, 4 bytes in a place, and is at most three quarters full.
class Point_table {
public:
  /// \param points receives the points; it must outlive the table, and be empty
  explicit Point_table(std::vector<Point_3>& points) : m_points(points), m_places(1024, none) {}

  /// the number of a point; coordinates are finite
  std::uint32_t number_of(const Point_3& point) {
    std::size_t place = place_of(point);
    if(m_places[place] != none)
      return m_places[place];
    if(4 * m_points.size() >= 3 * m_places.size()) {
      grow();
      place = place_of(point);
    }
    m_places[place] = static_cast<std::uint32_t>(m_points.size());
    m_points.push_back(point);
    return m_places[place];
  }

private:
  static constexpr std::uint32_t none = (std::numeric_limits<std::uint32_t>::max)();

  /// the same for 0 and -0
  static std::uint64_t hash(const Point_3& p) {
    std::uint64_t result = 0;
    for(int axis = 0; axis < 3; ++axis) {
      const double x = p[axis] + 0.;
      std::uint64_t bits;
      std::memcpy(&bits, &x, sizeof bits);
      // the end of the generator "splitmix64"
      result += bits + 0x9e3779b97f4a7c15u;
      result = (result ^ result >> 30) * 0xbf58476d1ce4e5b9u;
      result = (result ^ result >> 27) * 0x94d049bb133111ebu;
      result ^= result >> 31;
    }
    return result;
  }

  /// where a point is, or has to be put; there is a place
  std::size_t place_of(const Point_3& p) const {
    std::size_t place = hash(p) & (m_places.size() - 1);
    while(m_places[place] != none && m_points[m_places[place]] != p)
      place = (place + 1) & (m_places.size() - 1);
    return place;
  }

  void grow() {
    std::vector<std::uint32_t>(2 * m_places.size(), none).swap(m_places);
    for(std::uint32_t i = 0; i < m_points.size(); ++i)
      m_places[place_of(m_points[i])] = i;
  }

  std::vector<Point_3>& m_points;
  std::vector<std::uint32_t> m_places; // a power of 2
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_FILES_INTERNAL_POINT_TABLE_H
