// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_SHARED_OCTREE_LEVEL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_SHARED_OCTREE_LEVEL_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/Key_index.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Number_lists.h>
#include <CGAL/Restricted_laplacian_3/octree/Cell_3.h>

#include <algorithm>
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
  Key_index key_index;
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
  void index_keys() { key_index = Key_index(keys, 3 * level); }
  /// number of a cell, or `number_of_cells()`
  std::size_t find(const Cell_3& cell) const {
    return cell.is_inside_grid() ? key_index.find(keys, cell.key()) : keys.size();
  }
  /// the sheet in cell number `i` that has a fragment of a face, or `number_of_sheets()`
  std::size_t sheet_of_face(std::size_t i, std::size_t face) const;
};

inline std::size_t Octree_level::sheet_of_face(std::size_t i, std::size_t face) const {
  const auto [first, last] = sheets(i);
  for(std::size_t sheet = first; sheet < last; ++sheet)
    if(std::binary_search(faces[sheet].begin(), faces[sheet].end(), face))
      return sheet;
  return number_of_sheets();
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_SHARED_OCTREE_LEVEL_H
