// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_CELL_3_H
#define CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_CELL_3_H

#include <CGAL/Restricted_laplacian_3/foundation/morton_key.h>

#include <array>
#include <cstdint>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \cond SKIP_IN_MANUAL
/// \ingroup PkgRestrictedLaplacian3Functions largest depth of an octree: coordinates of cells, with
/// one more bit for the elements centered one cell outside the grid, take 21 bits each, and three
/// of them one 64-bit key
constexpr int maximum_octree_depth = 20;
/// \endcond

/// \ingroup PkgRestrictedLaplacian3Dev
/// A cell of the grid of \f$2^l \times 2^l \times 2^l\f$ cells at level \f$l\f$ of the octree.
/// The coordinates may lie outside the grid: the element centered on such a cell can still meet the
/// surface.
struct Cell_3 {
  /// level \f$l\f$ of the octree, 0 for the root
  int level = 0;
  /// coordinates along the three axes, in units of the cell width: \f$0 \dots 2^l - 1\f$ inside the
  /// grid
  std::array<int, 3> index = {0, 0, 0};

  /// the cell of a level whose `key()` is given
  static Cell_3 from_key(int level, std::uint64_t key) { return {level, morton_index(key)}; }

  /// Morton key; requires `is_inside_grid()`
  std::uint64_t key() const { return morton_key(index); }

  /// whether all three coordinates are in \f$0 \dots 2^l - 1\f$
  bool is_inside_grid() const {
    const int n = 1 << level;
    return index[0] >= 0 && index[0] < n && index[1] >= 0 && index[1] < n && index[2] >= 0 &&
           index[2] < n;
  }

  /// the cell of the next coarser level that contains this one
  Cell_3 parent() const { return {level - 1, {index[0] >> 1, index[1] >> 1, index[2] >> 1}}; }

  /// which of the 8 children of its parent this cell is; bit \f$a\f$ is the parity along axis
  /// \f$a\f$
  int octant() const { return (index[0] & 1) | (index[1] & 1) << 1 | (index[2] & 1) << 2; }

  /// the child whose `octant()` is given, a cell of the next finer level
  Cell_3 child(int octant) const {
    return {level + 1,
            {2 * index[0] + (octant & 1), 2 * index[1] + (octant >> 1 & 1),
             2 * index[2] + (octant >> 2 & 1)}};
  }

  /// the cell of the same level at an offset in cells; it may lie outside the grid
  Cell_3 neighbor(int dx, int dy, int dz) const {
    return {level, {index[0] + dx, index[1] + dy, index[2] + dz}};
  }

  friend bool operator==(const Cell_3& a, const Cell_3& b) {
    return a.level == b.level && a.index == b.index;
  }
  friend bool operator!=(const Cell_3& a, const Cell_3& b) { return !(a == b); }
};

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_CELL_3_H
