// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_INTERNAL_VECTOR_LANES_H
#define CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_INTERNAL_VECTOR_LANES_H

/// \file
/// Vectors of four numbers, or of eight in single precision, through the vector extensions of GCC
/// and Clang. On x86-64 functions marked by `CGAL_RESTRICTED_LAPLACIAN_3_LANES_FUNCTION` are
/// compiled for AVX2 with fused multiplication and addition, whatever the flags of the program are;
/// they may be called only if `processor_has_lanes()`. The macro
/// `CGAL_RESTRICTED_LAPLACIAN_3_HAS_LANES` tells whether the compiler is one that has all this.
/// (`CGAL_RESTRICTED_LAPLACIAN_3_NO_LANES` turns it off.)
///
/// Few loops are worth a second version, for vectors of eight numbers (AVX-512), which are compiled
/// and called likewise, by the macros and functions with `WIDE` in their names.

#if defined(__GNUC__) && (defined(__clang__) || __GNUC__ >= 9) &&                                  \
    !defined(CGAL_RESTRICTED_LAPLACIAN_3_NO_LANES)

#define CGAL_RESTRICTED_LAPLACIAN_3_HAS_LANES

#include <cstring>
#ifdef __x86_64__
#include <cpuid.h>
#endif

// A function that is inlined must have the same target as its caller: else the vectors in it are
// taken apart before it is inlined.
#ifdef __x86_64__
#define CGAL_RESTRICTED_LAPLACIAN_3_LANES_FUNCTION __attribute__((target("avx2,fma")))
#define CGAL_RESTRICTED_LAPLACIAN_3_WIDE_LANES_FUNCTION __attribute__((target("avx512f")))
#else
#define CGAL_RESTRICTED_LAPLACIAN_3_LANES_FUNCTION
#define CGAL_RESTRICTED_LAPLACIAN_3_WIDE_LANES_FUNCTION
#endif
#define CGAL_RESTRICTED_LAPLACIAN_3_LANES_INLINE                                                   \
  CGAL_RESTRICTED_LAPLACIAN_3_LANES_FUNCTION __attribute__((always_inline)) inline
#define CGAL_RESTRICTED_LAPLACIAN_3_WIDE_LANES_INLINE                                              \
  CGAL_RESTRICTED_LAPLACIAN_3_WIDE_LANES_FUNCTION __attribute__((always_inline)) inline

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

using Lanes = double __attribute__((vector_size(32)));
using Float_lanes = float __attribute__((vector_size(32)));
using Wide_lanes = double __attribute__((vector_size(64)));

#ifdef __x86_64__
/// What the processor has, and the system saves when it changes threads. By its own instructions:
/// `__builtin_cpu_supports()` needs tables of a runtime library, which are empty in some.
struct Processor {
  bool has_lanes = false, has_wide_lanes = false;

  Processor() {
    unsigned a, b, c, d, b7, c7, d7;
    if(!__get_cpuid(1, &a, &b, &c, &d) || !__get_cpuid_count(7, 0, &a, &b7, &c7, &d7))
      return;
    constexpr unsigned fma = 1U << 12, xsave = 1U << 27, avx2 = 1U << 5, avx512f = 1U << 16;
    if((c & xsave) == 0)
      return;
    unsigned saved, above;
    __asm__("xgetbv" : "=a"(saved), "=d"(above) : "c"(0)); // XCR0
    constexpr unsigned registers = 0x06, wide_registers = 0xe6;
    has_lanes = (saved & registers) == registers && (c & fma) != 0 && (b7 & avx2) != 0;
    has_wide_lanes = has_lanes && (saved & wide_registers) == wide_registers && (b7 & avx512f) != 0;
  }

  static const Processor& of_process() {
    static const Processor processor;
    return processor;
  }
};
#endif

inline bool processor_has_lanes() {
#ifdef __x86_64__
  return Processor::of_process().has_lanes;
#else
  return true;
#endif
}

inline bool processor_has_wide_lanes() {
#ifdef __x86_64__
  return Processor::of_process().has_wide_lanes;
#else
  return false;
#endif
}

// Memory need not be aligned for more than a single number.
namespace lanes {

CGAL_RESTRICTED_LAPLACIAN_3_LANES_INLINE Lanes load(const double* from) {
  Lanes result;
  std::memcpy(&result, from, sizeof(Lanes));
  return result;
}

CGAL_RESTRICTED_LAPLACIAN_3_LANES_INLINE Float_lanes load(const float* from) {
  Float_lanes result;
  std::memcpy(&result, from, sizeof(Float_lanes));
  return result;
}

CGAL_RESTRICTED_LAPLACIAN_3_LANES_INLINE void store(const Lanes& from, double* to) {
  std::memcpy(to, &from, sizeof(Lanes));
}

CGAL_RESTRICTED_LAPLACIAN_3_LANES_INLINE void store(const Float_lanes& from, float* to) {
  std::memcpy(to, &from, sizeof(Float_lanes));
}

// Before version 12 GCC wants the numbers in a vector of integers, such as a comparison gives.
#if defined(__clang__) || __GNUC__ >= 12
#define CGAL_RESTRICTED_LAPLACIAN_3_SHUFFLE(a, b, ...) __builtin_shufflevector(a, b, __VA_ARGS__)
#else
#define CGAL_RESTRICTED_LAPLACIAN_3_SHUFFLE(a, b, ...)                                             \
  __builtin_shuffle(a, b, decltype(a < b){__VA_ARGS__})
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

/// the sums of the components of eight vectors
CGAL_RESTRICTED_LAPLACIAN_3_LANES_INLINE Float_lanes sums_of_components(const Float_lanes* a) {
  Float_lanes pairs[4], fours[2];
  for(int i = 0; i < 4; ++i)
    pairs[i] =
        CGAL_RESTRICTED_LAPLACIAN_3_SHUFFLE(a[2 * i], a[2 * i + 1], 0, 8, 2, 10, 4, 12, 6, 14) +
        CGAL_RESTRICTED_LAPLACIAN_3_SHUFFLE(a[2 * i], a[2 * i + 1], 1, 9, 3, 11, 5, 13, 7, 15);
  for(int i = 0; i < 2; ++i)
    fours[i] = CGAL_RESTRICTED_LAPLACIAN_3_SHUFFLE(pairs[2 * i], pairs[2 * i + 1], 0, 1, 8, 9, 4, 5,
                                                   12, 13) +
               CGAL_RESTRICTED_LAPLACIAN_3_SHUFFLE(pairs[2 * i], pairs[2 * i + 1], 2, 3, 10, 11, 6,
                                                   7, 14, 15);
  return CGAL_RESTRICTED_LAPLACIAN_3_SHUFFLE(fours[0], fours[1], 0, 1, 2, 3, 8, 9, 10, 11) +
         CGAL_RESTRICTED_LAPLACIAN_3_SHUFFLE(fours[0], fours[1], 4, 5, 6, 7, 12, 13, 14, 15);
}

#undef CGAL_RESTRICTED_LAPLACIAN_3_SHUFFLE

} // namespace lanes
} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

/// calls the function of that name in `lanes` if the processor has them, else the one in `plain`
#define CGAL_RESTRICTED_LAPLACIAN_3_BEST(...)                                                      \
  if(processor_has_lanes())                                                                        \
    lanes::__VA_ARGS__;                                                                            \
  else                                                                                             \
    plain::__VA_ARGS__

/// the same, where there is a function in `wide_lanes` as well
#define CGAL_RESTRICTED_LAPLACIAN_3_WIDEST(...)                                                    \
  if(processor_has_wide_lanes())                                                                   \
    wide_lanes::__VA_ARGS__;                                                                       \
  else if(processor_has_lanes())                                                                   \
    lanes::__VA_ARGS__;                                                                            \
  else                                                                                             \
    plain::__VA_ARGS__
#else
#define CGAL_RESTRICTED_LAPLACIAN_3_BEST(...) plain::__VA_ARGS__
#define CGAL_RESTRICTED_LAPLACIAN_3_WIDEST(...) plain::__VA_ARGS__
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_INTERNAL_VECTOR_LANES_H
