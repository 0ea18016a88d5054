// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_RANK_RANGES_H
#define CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_RANK_RANGES_H

#include <CGAL/Restricted_laplacian_3/foundation/morton_key.h>
#include <CGAL/Restricted_laplacian_3/octree/Cell_3.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Dev Which rank owns which cells of an octree: each a
/// range of the cells of one coarse level in Morton order, with all that they contain. The elements
/// centered on a cell belong to its owner, those centered outside the grid to that of the nearest
/// cell inside.
class Rank_ranges {
public:
  /// The level of the ranges for an octree: three above the finest, from 1 to 8. It does not depend
  /// on the number of ranks, and so neither does the order in which unknowns are relaxed.
  static int level_of_ranges(int depth) { return (std::min)((std::max)(depth - 3, 1), 8); }

  /// Ranges of about the same weight: a cell belongs to the equal part of the whole in which its
  /// middle lies.
  /// \param level of the ranges
  /// \param weights of all cells of that level, in Morton order
  /// \param number_of_ranks how many ranges are made; some are empty if there are few cells
  template <class Weight>
  Rank_ranges(int level, const std::vector<Weight>& weights, std::size_t number_of_ranks)
    : m_level(level), m_first_cells(number_of_ranks + 1, weights.size()) {
    CGAL_precondition(weights.size() == std::size_t(1) << 3 * level && number_of_ranks > 0);
    double total = 0, sum = 0;
    for(const Weight& weight : weights)
      total += static_cast<double>(weight);
    const auto ranks = static_cast<double>(number_of_ranks);
    std::size_t next = 0; // rank whose first cell is looked for
    for(std::size_t cell = 0; cell < weights.size(); ++cell) {
      const auto weight = static_cast<double>(weights[cell]);
      const double part = total > 0 ? std::floor((sum + weight / 2) / total * ranks) : 0;
      while(next < number_of_ranks && static_cast<double>(next) <= part)
        m_first_cells[next++] = cell;
      sum += weight;
    }
    m_first_cells[0] = 0;
  }

  /// level of the ranges
  int level() const { return m_level; }
  /// how many there are
  std::size_t size() const { return m_first_cells.size() - 1; }

  /// half-open range of the Morton keys of the cells of a level, not coarser than `level()`, that a
  /// rank owns
  std::array<std::uint64_t, 2> cells(std::size_t rank, int level) const {
    CGAL_precondition(rank < size() && level >= m_level);
    const int shift = 3 * (level - m_level);
    return {m_first_cells[rank] << shift, m_first_cells[rank + 1] << shift};
  }

  /// the owner of a cell, given by its Morton key, of a level that is not coarser than `level()`
  std::size_t owner(int level, std::uint64_t key) const {
    CGAL_precondition(level >= m_level && key >> 3 * level == 0);
    return owner_of_range_cell(key >> 3 * (level - m_level));
  }

  /// Calls `visit(rank)` for the owners of the cells that are at most `distance` away, along each
  /// axis, from a cell inside the grid; perhaps several times for the same rank.
  template <class Visitor>
  void for_each_rank_near(int level, std::uint64_t key, int distance, Visitor&& visit) const {
    const std::array<int, 3> cell = morton_index(key);
    const int shift = level - m_level, last = (1 << level) - 1;
    std::array<int, 3> low, high, i;
    for(int axis = 0; axis < 3; ++axis) {
      low[axis] = (std::max)(cell[axis] - distance, 0) >> shift;
      high[axis] = (std::min)(cell[axis] + distance, last) >> shift;
    }
    for(i[2] = low[2]; i[2] <= high[2]; ++i[2])
      for(i[1] = low[1]; i[1] <= high[1]; ++i[1])
        for(i[0] = low[0]; i[0] <= high[0]; ++i[0])
          visit(owner_of_range_cell(morton_key(i)));
  }

  /// whether a rank owns a cell that is at most `distance` away from the given one
  bool is_near(std::size_t rank, int level, std::uint64_t key, int distance) const {
    bool result = false;
    for_each_rank_near(level, key, distance,
                       [&](std::size_t other) { result = result || other == rank; });
    return result;
  }

private:
  std::size_t owner_of_range_cell(std::uint64_t cell) const {
    const auto after = std::upper_bound(m_first_cells.begin(), m_first_cells.end(), cell);
    return static_cast<std::size_t>(after - m_first_cells.begin()) - 1;
  }

  int m_level;
  std::vector<std::uint64_t> m_first_cells; // of ranks, and one more
};

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_RANK_RANGES_H
