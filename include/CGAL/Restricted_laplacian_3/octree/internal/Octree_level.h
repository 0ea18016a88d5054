// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_INTERNAL_OCTREE_LEVEL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_INTERNAL_OCTREE_LEVEL_H

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

inline void Octree_level::index_keys() {
  int bits = 0;
  while(bits < 3 * level && std::size_t(1) << bits < keys.size())
    ++bits;
  prefix_shift = 3 * level - bits;
  first_of_prefix.resize((std::size_t(1) << bits) + 1);
  std::size_t i = 0;
  for(std::size_t prefix = 0; prefix < first_of_prefix.size(); ++prefix) {
    while(i < keys.size() && keys[i] >> prefix_shift < prefix)
      ++i;
    first_of_prefix[prefix] = static_cast<std::uint32_t>(i);
  }
}

inline std::size_t Octree_level::find(const Cell_3& cell) const {
  if(!cell.is_inside_grid())
    return keys.size();
  const std::uint64_t key = cell.key();
  const auto prefix = static_cast<std::size_t>(key >> prefix_shift);
  const auto last = keys.begin() + first_of_prefix[prefix + 1];
  const auto it = std::lower_bound(keys.begin() + first_of_prefix[prefix], last, key);
  return it != last && *it == key ? it - keys.begin() : keys.size();
}

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

#endif // CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_INTERNAL_OCTREE_LEVEL_H
