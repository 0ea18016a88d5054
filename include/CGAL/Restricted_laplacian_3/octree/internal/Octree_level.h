// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_INTERNAL_OCTREE_LEVEL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_INTERNAL_OCTREE_LEVEL_H

#include <CGAL/Restricted_laplacian_3/foundation/compiled.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Number_lists.h>
#include <CGAL/Restricted_laplacian_3/octree/Cell_3.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// The cells and sheets of one level of an octree.
struct Octree_level {
  int level = 0;
  std::vector<std::uint64_t> keys; // of cells, ascending
  // First cell whose key without the lowest `prefix_shift` bits is at least the index: there are
  // about as many prefixes as cells, so the search for a cell is short.
  std::vector<std::uint32_t> first_of_prefix;
  int prefix_shift = 0;
  std::vector<std::uint32_t> first_sheets; // of cells, and one more
  std::vector<std::uint32_t> cells;        // of sheets, as all that follows
  std::vector<std::uint32_t> element_masks;
  std::vector<std::uint32_t> parents;
  Number_lists children;
  Number_lists links;
  Number_lists faces; // on the finest level only

  std::size_t number_of_cells() const { return keys.size(); }
  std::size_t number_of_sheets() const { return cells.size(); }
  /// the cell of a sheet
  Cell_3 cell(std::size_t sheet) const { return Cell_3::from_key(level, keys[cells[sheet]]); }
  /// the sheets of cell number `i`, a half-open range
  std::array<std::size_t, 2> sheets(std::size_t i) const {
    return {first_sheets[i], first_sheets[i + 1]};
  }

  /// makes `find()` possible, after a change of `keys`
  void index_keys();
  /// number of a cell, or `number_of_cells()`
  std::size_t find(const Cell_3& cell) const;
  /// the sheet in cell number `i` that has a fragment of a face, or `number_of_sheets()`
  std::size_t sheet_of_face(std::size_t i, std::size_t face) const;
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/octree/internal/Octree_level_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_INTERNAL_OCTREE_LEVEL_H
