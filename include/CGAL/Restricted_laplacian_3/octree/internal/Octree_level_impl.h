// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_INTERNAL_OCTREE_LEVEL_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_INTERNAL_OCTREE_LEVEL_IMPL_H

#include <CGAL/Restricted_laplacian_3/octree/internal/Octree_level.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void Octree_level::index_keys() {
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

CGAL_RESTRICTED_LAPLACIAN_3_INLINE std::size_t Octree_level::find(const Cell_3& cell) const {
  if(!cell.is_inside_grid())
    return keys.size();
  const std::uint64_t key = cell.key();
  const auto prefix = static_cast<std::size_t>(key >> prefix_shift);
  const auto last = keys.begin() + first_of_prefix[prefix + 1];
  const auto it = std::lower_bound(keys.begin() + first_of_prefix[prefix], last, key);
  return it != last && *it == key ? it - keys.begin() : keys.size();
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE std::size_t Octree_level::sheet_of_face(std::size_t i,
                                                                           std::size_t face) const {
  const auto [first, last] = sheets(i);
  for(std::size_t sheet = first; sheet < last; ++sheet)
    if(std::binary_search(faces[sheet].begin(), faces[sheet].end(), face))
      return sheet;
  return number_of_sheets();
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_INTERNAL_OCTREE_LEVEL_IMPL_H
