// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_INTERNAL_VECTOR_LANES_H
#define CGAL_RESTRICTED_LAPLACIAN_3_INTERNAL_VECTOR_LANES_H

/// \file
/// Vectors of four numbers, through the vector extensions of GCC and Clang. On x86-64 functions
/// marked by `CGAL_RESTRICTED_LAPLACIAN_3_LANES_FUNCTION` are compiled for AVX2 with fused
/// multiplication and addition, whatever the flags of the program are; they may be called only if
/// `processor_has_lanes()`. The macro `CGAL_RESTRICTED_LAPLACIAN_3_HAS_LANES` tells whether the
/// compiler is one that has all this. (`CGAL_RESTRICTED_LAPLACIAN_3_NO_LANES` turns it off.)

#if defined(__GNUC__) && (defined(__clang__) || __GNUC__ >= 9) &&                                  \
    !defined(CGAL_RESTRICTED_LAPLACIAN_3_NO_LANES)

#define CGAL_RESTRICTED_LAPLACIAN_3_HAS_LANES

#include <cstring>

// A function that is inlined must have the same target as its caller: else the vectors in it are
// taken apart before it is inlined.
#ifdef __x86_64__
#define CGAL_RESTRICTED_LAPLACIAN_3_LANES_FUNCTION __attribute__((target("avx2,fma")))
#else
#define CGAL_RESTRICTED_LAPLACIAN_3_LANES_FUNCTION
#endif
#define CGAL_RESTRICTED_LAPLACIAN_3_LANES_INLINE                                                   \
  CGAL_RESTRICTED_LAPLACIAN_3_LANES_FUNCTION __attribute__((always_inline)) inline

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

using Lanes = double __attribute__((vector_size(32)));

inline bool processor_has_lanes() {
#ifdef __x86_64__
  static const bool result = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  return result;
#else
  return true;
#endif
}

// Memory need not be aligned for more than a single number.
namespace lanes {

CGAL_RESTRICTED_LAPLACIAN_3_LANES_INLINE Lanes load(const double* from) {
  Lanes result;
  std::memcpy(&result, from, sizeof(Lanes));
  return result;
}

CGAL_RESTRICTED_LAPLACIAN_3_LANES_INLINE void store(const Lanes& from, double* to) {
  std::memcpy(to, &from, sizeof(Lanes));
}

#if defined(__clang__) || __GNUC__ >= 12
#define CGAL_RESTRICTED_LAPLACIAN_3_SHUFFLE(a, b, i, j, k, l)                                      \
  __builtin_shufflevector(a, b, i, j, k, l)
#else
using Lane_numbers = long long __attribute__((vector_size(32)));
#define CGAL_RESTRICTED_LAPLACIAN_3_SHUFFLE(a, b, i, j, k, l)                                      \
  __builtin_shuffle(a, b, Lane_numbers{i, j, k, l})
#endif

/// rows of a 4 x 4 matrix -> columns
CGAL_RESTRICTED_LAPLACIAN_3_LANES_INLINE void transpose(const Lanes& a, const Lanes& b,
                                                        const Lanes& c, const Lanes& d, Lanes& p,
                                                        Lanes& q, Lanes& r, Lanes& s) {
  const Lanes ab_even = CGAL_RESTRICTED_LAPLACIAN_3_SHUFFLE(a, b, 0, 4, 2, 6);
  const Lanes ab_odd = CGAL_RESTRICTED_LAPLACIAN_3_SHUFFLE(a, b, 1, 5, 3, 7);
  const Lanes cd_even = CGAL_RESTRICTED_LAPLACIAN_3_SHUFFLE(c, d, 0, 4, 2, 6);
  const Lanes cd_odd = CGAL_RESTRICTED_LAPLACIAN_3_SHUFFLE(c, d, 1, 5, 3, 7);
  p = CGAL_RESTRICTED_LAPLACIAN_3_SHUFFLE(ab_even, cd_even, 0, 1, 4, 5);
  q = CGAL_RESTRICTED_LAPLACIAN_3_SHUFFLE(ab_odd, cd_odd, 0, 1, 4, 5);
  r = CGAL_RESTRICTED_LAPLACIAN_3_SHUFFLE(ab_even, cd_even, 2, 3, 6, 7);
  s = CGAL_RESTRICTED_LAPLACIAN_3_SHUFFLE(ab_odd, cd_odd, 2, 3, 6, 7);
}

/// the sums of the components of four vectors
CGAL_RESTRICTED_LAPLACIAN_3_LANES_INLINE void
sum_components(const Lanes& a, const Lanes& b, const Lanes& c, const Lanes& d, Lanes& sums) {
  Lanes p, q, r, s;
  transpose(a, b, c, d, p, q, r, s);
  sums = (p + q) + (r + s);
}

#undef CGAL_RESTRICTED_LAPLACIAN_3_SHUFFLE

} // namespace lanes
} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_INTERNAL_VECTOR_LANES_H
