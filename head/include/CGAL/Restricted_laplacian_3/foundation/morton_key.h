// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_MORTON_KEY_H
#define CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_MORTON_KEY_H

#include <array>
#include <cstdint>

namespace CGAL {
namespace Restricted_laplacian_3 {

namespace internal {

/// spreads the low 21 bits of `x` to every third bit
inline std::uint64_t spread_bits_by_three(std::uint64_t x) {
  x &= 0x1fffff;
  x = (x | x << 32) & 0x001f00000000ffffull;
  x = (x | x << 16) & 0x001f0000ff0000ffull;
  x = (x | x << 8) & 0x100f00f00f00f00full;
  x = (x | x << 4) & 0x10c30c30c30c30c3ull;
  x = (x | x << 2) & 0x1249249249249249ull;
  return x;
}

/// inverse of `spread_bits_by_three()`
inline std::uint64_t gather_every_third_bit(std::uint64_t x) {
  x &= 0x1249249249249249ull;
  x = (x | x >> 2) & 0x10c30c30c30c30c3ull;
  x = (x | x >> 4) & 0x100f00f00f00f00full;
  x = (x | x >> 8) & 0x001f0000ff0000ffull;
  x = (x | x >> 16) & 0x001f00000000ffffull;
  x = (x | x >> 32) & 0x00000000001fffffull;
  return x;
}

} // namespace internal

/// \ingroup PkgRestrictedLaplacian3Dev
/// Morton key (z-order) of three coordinates in \f$[0, 2^{21})\f$: bit \f$3k + a\f$ of the key is
/// bit \f$k\f$ of coordinate \f$a\f$. Keys of the 8 children of a cell are 8 consecutive numbers.
inline std::uint64_t morton_key(const std::array<int, 3>& index) {
  return internal::spread_bits_by_three(static_cast<std::uint64_t>(index[0])) |
         internal::spread_bits_by_three(static_cast<std::uint64_t>(index[1])) << 1 |
         internal::spread_bits_by_three(static_cast<std::uint64_t>(index[2])) << 2;
}

/// \ingroup PkgRestrictedLaplacian3Dev
/// inverse of `morton_key()`
inline std::array<int, 3> morton_index(std::uint64_t key) {
  return {static_cast<int>(internal::gather_every_third_bit(key)),
          static_cast<int>(internal::gather_every_third_bit(key >> 1)),
          static_cast<int>(internal::gather_every_third_bit(key >> 2))};
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_MORTON_KEY_H
