// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_SHARED_ELEMENT_MASKS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_SHARED_ELEMENT_MASKS_H

#include <array>
#include <cstdint>

/// \file
/// Which of the 27 elements of a cell are not zero on all of a piece of the surface in the cell: a
/// bit for each, those of the neighbors that they are centered on.

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// the bit of the neighbor at offset (dx, dy, dz), each -1, 0 or 1
inline int element_bit(int dx, int dy, int dz) { return (dx + 1) + 3 * (dy + 1) + 9 * (dz + 1); }

/// the bits of all neighbors at an offset along an axis
inline std::uint32_t elements_at_offset(int axis, int offset) {
  constexpr std::array<std::uint32_t, 3> lowest = {0x1249249, 0x1c0e07, 0x1ff};
  constexpr std::array<int, 3> shift = {1, 3, 9};
  return lowest[axis] << (shift[axis] * (offset + 1));
}

/// the bits of all of them
constexpr std::uint32_t all_elements = (1u << 27) - 1;

/// The element pieces of offsets -1, 0, 1 are (1-t)^2/2, 1/2+t-t^2 and t^2/2: with all of a
/// piece at t = 0 the last, with all of it at t = 1 the first vanishes on it.
/// \param range_along lowest and highest coordinate along an axis
template <class Range_along>
std::uint32_t element_mask_of_range(const Range_along& range_along,
                                    const std::array<int, 3>& cell) {
  std::uint32_t mask = all_elements;
  for(int axis = 0; axis < 3; ++axis) {
    const std::array<double, 2> range = range_along(axis);
    if(!(range[0] < cell[axis] + 1))
      mask &= ~elements_at_offset(axis, -1);
    if(!(range[1] > cell[axis]))
      mask &= ~elements_at_offset(axis, 1);
  }
  return mask;
}

/// The mask of a parent follows from those of its children: in the lower child of an axis (parity
/// 0) the surface is never all at t = 1 of the parent, in the upper one never at t = 0.
inline std::uint32_t parent_element_mask(std::uint32_t child_mask, int octant) {
  const auto child_offset = [octant](int axis, int offset) {
    const bool upper = octant >> axis & 1;
    return (offset == 1 && upper) || (offset == -1 && !upper) ? 0 : offset;
  };
  std::uint32_t mask = 0;
  for(int dz = -1; dz <= 1; ++dz)
    for(int dy = -1; dy <= 1; ++dy)
      for(int dx = -1; dx <= 1; ++dx) {
        const int bit = element_bit(child_offset(0, dx), child_offset(1, dy), child_offset(2, dz));
        if(child_mask >> bit & 1)
          mask |= 1u << element_bit(dx, dy, dz);
      }
  return mask;
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_SHARED_ELEMENT_MASKS_H
