// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_SHARED_SHEET_SORTER_H
#define CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_SHARED_SHEET_SORTER_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/Disjoint_sets.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// a direction in which the centroids of two pieces of a symmetric surface differ
inline std::array<double, 3> sorting_direction() {
  return {0.5301239457, 0.3190881637, 0.7855683291};
}

/// Area of a piece of the surface, and its integral of the position along `sorting_direction()`.
struct Place {
  double area = 0;
  double moment = 0;

  void add(const Place& other) {
    area += other.area;
    moment += other.moment;
  }
  double position() const { return moment / area; }
};

/// Puts the sheets of a cell in order. Its memory is used again for the next cell.
class Sheet_sorter {
public:
  /// Returns the representatives of the sets of the numbers `begin` .. `end` - 1, sorted by the
  /// position of the centroids of the sets, and appends the places of the sets to `places`. What is
  /// returned is valid until the next call.
  template <class PlaceOf>
  const std::vector<std::uint32_t>& operator()(Disjoint_sets& sets, std::uint32_t begin,
                                               std::uint32_t end, PlaceOf&& place_of,
                                               std::vector<Place>& places) {
    m_sorted.clear();
    for(std::uint32_t i = begin; i < end; ++i)
      if(sets.find(i) == i)
        m_sorted.push_back({Place(), i});
    for(std::uint32_t i = begin; i < end; ++i) {
      const auto it =
          std::lower_bound(m_sorted.begin(), m_sorted.end(), sets.find(i),
                           [](const Piece& piece, std::uint32_t j) { return piece.number < j; });
      it->place.add(place_of(i));
    }
    if(m_sorted.size() > 1)
      std::stable_sort(m_sorted.begin(), m_sorted.end(), [](const Piece& a, const Piece& b) {
        return a.place.position() < b.place.position();
      });
    m_numbers.clear();
    for(const Piece& piece : m_sorted) {
      m_numbers.push_back(piece.number);
      places.push_back(piece.place);
    }
    return m_numbers;
  }

private:
  struct Piece {
    Place place;
    std::uint32_t number;
  };

  std::vector<Piece> m_sorted;
  std::vector<std::uint32_t> m_numbers;
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_SHARED_SHEET_SORTER_H
