// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_INTERNAL_EAR_CLIPPING_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_INTERNAL_EAR_CLIPPING_H

#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// The division of a polygon in the plane, counterclockwise, by cutting off one corner after the
/// other in whose triangle no other corner lies. A grid finds the corners near a triangle. Whoever
/// was cut off, the corner before it is tried next, so that a few turns around the polygon do: O(n)
/// time for n corners, times the number of those near a triangle. In the end a polygon that meets
/// itself has no such corner left; then any is cut off, so that the number of triangles is right.
class Ear_clipping {
public:
  using Place = std::array<double, 2>;
  using Triangle = Triangulated_surface_3::Triangle;

  /// \param corners at least three, with finite coordinates
  explicit Ear_clipping(std::vector<Place> corners)
    : m_places(std::move(corners)), m_before(m_places.size()), m_after(m_places.size()) {
    const std::size_t n = m_places.size();
    for(std::size_t i = 0; i < n; ++i) {
      m_after[i] = static_cast<std::uint32_t>((i + 1) % n);
      m_before[i] = static_cast<std::uint32_t>((i + n - 1) % n);
    }
    fill_grid();
  }

  /// the triangles, as numbers of corners: two fewer than these
  std::vector<Triangle> triangles() {
    std::vector<Triangle> result;
    std::uint32_t corner = 0, last_met = 0;
    std::size_t left_over = m_places.size();
    Ear least = Ear::plain;
    while(left_over > 2) {
      if(is_ear(corner, least)) {
        result.push_back({m_before[corner], corner, m_after[corner]});
        corner = last_met = cut_off(corner);
        --left_over;
      } else {
        corner = m_after[corner];
        if(corner == last_met) // a whole turn
          least = least == Ear::plain ? Ear::straight : Ear::any;
      }
    }
    return result;
  }

private:
  /// what is cut off, each the next where the one before is found nowhere any more: a corner that
  /// turns left and whose triangle is empty; one whose triangle has no area, too; any
  enum class Ear { plain, straight, any };

  double turn(std::uint32_t i, std::uint32_t j, std::uint32_t k) const {
    const Place &a = m_places[i], &b = m_places[j], &c = m_places[k];
    return (b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0]);
  }

  bool is_ear(std::uint32_t corner, Ear least) const {
    if(least == Ear::any)
      return true;
    const double area = turn(m_before[corner], corner, m_after[corner]);
    return area > 0 ? is_empty(m_before[corner], corner, m_after[corner])
                    : area == 0 && least == Ear::straight;
  }

  /// whether no corner at which the polygon is not convex lies in a triangle or on its sides
  bool is_empty(std::uint32_t i, std::uint32_t j, std::uint32_t k) const {
    const Place &a = m_places[i], &b = m_places[j], &c = m_places[k];
    const auto [x0, x1] = std::minmax({a[0], b[0], c[0]});
    const auto [y0, y1] = std::minmax({a[1], b[1], c[1]});
    const auto lowest = cell_of({x0, y0}), highest = cell_of({x1, y1});
    for(std::size_t y = lowest[1]; y <= highest[1]; ++y)
      for(std::size_t n = m_cells[y * m_size + lowest[0]]; n < m_cells[y * m_size + highest[0] + 1];
          ++n) {
        const std::uint32_t v = m_sorted[n];
        const Place& p = m_places[v];
        if(m_after[v] != v && p != a && p != b && p != c && turn(i, j, v) >= 0 &&
           turn(j, k, v) >= 0 && turn(k, i, v) >= 0 && turn(m_before[v], v, m_after[v]) <= 0)
          return false;
      }
    return true;
  }

  /// \return the corner with which to go on: that before, for which it may have been in the way
  std::uint32_t cut_off(std::uint32_t corner) {
    const std::uint32_t before = m_before[corner], after = m_after[corner];
    m_after[before] = after;
    m_before[after] = before;
    m_after[corner] = corner;
    return before;
  }

  std::array<std::size_t, 2> cell_of(const Place& p) const {
    std::array<std::size_t, 2> result;
    for(int axis = 0; axis < 2; ++axis)
      result[axis] = (std::min)(
          static_cast<std::size_t>((p[axis] - m_lowest[axis]) * m_cells_per_unit), m_size - 1);
    return result;
  }

  /// sorts the corners by cells, about as many as there are corners
  void fill_grid() {
    m_lowest = m_places[0];
    Place highest = m_places[0];
    for(const Place& p : m_places)
      for(int axis = 0; axis < 2; ++axis) {
        m_lowest[axis] = (std::min)(m_lowest[axis], p[axis]);
        highest[axis] = (std::max)(highest[axis], p[axis]);
      }
    m_size = 1 + static_cast<std::size_t>(std::sqrt(double(m_places.size())));
    const double extent = (std::max)(highest[0] - m_lowest[0], highest[1] - m_lowest[1]);
    m_cells_per_unit = extent > 0 ? double(m_size) / extent : 0;
    m_cells.assign(m_size * m_size + 1, 0);
    const auto number_of = [&](const Place& p) {
      const auto cell = cell_of(p);
      return cell[1] * m_size + cell[0];
    };
    for(const Place& p : m_places)
      ++m_cells[number_of(p) + 1];
    std::partial_sum(m_cells.begin(), m_cells.end(), m_cells.begin());
    std::vector<std::size_t> next(m_cells.begin(), m_cells.end() - 1);
    m_sorted.resize(m_places.size());
    for(std::size_t i = 0; i < m_places.size(); ++i)
      m_sorted[next[number_of(m_places[i])]++] = static_cast<std::uint32_t>(i);
  }

  std::vector<Place> m_places;
  std::vector<std::uint32_t> m_before, m_after; ///< of a corner that is cut off: itself
  Place m_lowest = {0, 0};
  double m_cells_per_unit = 0;
  std::size_t m_size = 1;           ///< the number of cells on a side
  std::vector<std::size_t> m_cells; ///< the first of the corners of each, among those sorted
  std::vector<std::uint32_t> m_sorted;
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_INTERNAL_EAR_CLIPPING_H
