// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_INTERNAL_BLOCK_KERNELS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_INTERNAL_BLOCK_KERNELS_H

#include <CGAL/Restricted_laplacian_3/internal/vector_lanes.h>

#include <cstddef>
#include <cstdint>
#include <cstring>

/// \file
/// The loops in which a cycle spends its time, for any processor (`plain`) and for vectors of 256
/// bits (`lanes`).

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

namespace plain {

template <int K>
void subtract_blocks(const float* values, const std::uint32_t* columns, std::size_t count,
                     const float* x, float* sum) {
  float own[8 * K] = {};
  for(std::size_t k = 0; k < count; ++k, values += 64) {
    const float* from = x + 8 * K * static_cast<std::size_t>(columns[k]);
    for(int c = 0; c < K; ++c)
      for(int j = 0; j < 8; ++j)
        for(int l = 0; l < 8; ++l)
          own[8 * c + l] += values[8 * j + l] * from[8 * c + j];
  }
  for(int l = 0; l < 8 * K; ++l)
    sum[l] -= own[l];
}

inline void multiply_dense(const float* matrix, int columns, int rows, const float* from,
                           float* to) {
  for(int i = 0; i < rows; ++i)
    to[i] = 0;
  for(int j = 0; j < columns; ++j)
    for(int i = 0; i < rows; ++i)
      to[i] += matrix[rows * j + i] * from[j];
}

inline void subtract_outer_product(const double* column, double factor, double* a, int size,
                                   int stride) {
  for(int i = 0; i < size; ++i)
    for(int j = i; j < size; ++j)
      a[static_cast<std::size_t>(stride) * i + j] -= factor * column[i] * column[j];
}

} // namespace plain

#ifdef CGAL_RESTRICTED_LAPLACIAN_3_HAS_LANES

namespace lanes {

using Float_lanes = float __attribute__((vector_size(32)));

CGAL_RESTRICTED_LAPLACIAN_3_LANES_INLINE Float_lanes load(const float* from) {
  Float_lanes result;
  std::memcpy(&result, from, sizeof(Float_lanes));
  return result;
}

CGAL_RESTRICTED_LAPLACIAN_3_LANES_INLINE void store(const Float_lanes& from, float* to) {
  std::memcpy(to, &from, sizeof(Float_lanes));
}

template <int K>
CGAL_RESTRICTED_LAPLACIAN_3_LANES_FUNCTION void
subtract_blocks(const float* values, const std::uint32_t* columns, std::size_t count,
                const float* x, float* sum) {
  // Four sums at a time: a sum takes that many cycles to be ready for the next term.
  constexpr int chains = K == 1 ? 4 : K;
  Float_lanes own[chains];
  for(int c = 0; c < chains; ++c)
    own[c] = Float_lanes{};
  for(std::size_t k = 0; k < count; ++k, values += 64) {
    const float* from = x + 8 * K * static_cast<std::size_t>(columns[k]);
    if(K == 1) {
      for(int j = 0; j < 8; ++j)
        own[j % chains] += load(values + 8 * j) * from[j];
    } else
      for(int j = 0; j < 8; ++j)
        for(int c = 0; c < K; ++c)
          own[c] += load(values + 8 * j) * from[8 * c + j];
  }
  if(K == 1)
    store(load(sum) - ((own[0] + own[1]) + (own[2] + own[3])), sum);
  else
    for(int c = 0; c < K; ++c)
      store(load(sum + 8 * c) - own[c], sum + 8 * c);
}

inline CGAL_RESTRICTED_LAPLACIAN_3_LANES_FUNCTION void
multiply_dense(const float* matrix, int columns, int rows, const float* from, float* to) {
  // 32 rows at a time are held in registers.
  int i = 0;
  for(; i + 32 <= rows; i += 32) {
    Float_lanes s0{}, s1{}, s2{}, s3{};
    const float* column = matrix + i;
    for(int j = 0; j < columns; ++j, column += rows) {
      s0 += load(column) * from[j];
      s1 += load(column + 8) * from[j];
      s2 += load(column + 16) * from[j];
      s3 += load(column + 24) * from[j];
    }
    store(s0, to + i);
    store(s1, to + i + 8);
    store(s2, to + i + 16);
    store(s3, to + i + 24);
  }
  for(; i < rows; i += 8) {
    Float_lanes even{}, odd{};
    const float* column = matrix + i;
    int j = 0;
    for(; j + 2 <= columns; j += 2, column += 2 * rows) {
      even += load(column) * from[j];
      odd += load(column + rows) * from[j + 1];
    }
    if(j < columns)
      even += load(column) * from[j];
    store(even + odd, to + i);
  }
}

inline CGAL_RESTRICTED_LAPLACIAN_3_LANES_FUNCTION void
subtract_outer_product(const double* column, double factor, double* a, int size, int stride) {
  for(int i = 0; i < size; ++i) {
    const double f = factor * column[i];
    double* row = a + static_cast<std::size_t>(stride) * i;
    for(int j = i & ~3; j < stride; j += 4)
      store(load(row + j) - f * load(column + j), row + j);
  }
}

} // namespace lanes

#define CGAL_RESTRICTED_LAPLACIAN_3_BEST(call)                                                     \
  if(processor_has_lanes())                                                                        \
    lanes::call;                                                                                   \
  else                                                                                             \
    plain::call
#else
#define CGAL_RESTRICTED_LAPLACIAN_3_BEST(call) plain::call
#endif

/// Subtracts a row of blocks of 8 x 8 numbers, times the clusters `columns` of `K` vectors `x`, from
/// a cluster of `K` vectors.
template <int K>
void subtract_blocks(const float* values, const std::uint32_t* columns, std::size_t count,
                     const float* x, float* sum) {
  CGAL_RESTRICTED_LAPLACIAN_3_BEST(subtract_blocks<K>(values, columns, count, x, sum));
}

/// Product of a dense matrix, stored by columns of `rows` numbers, a multiple of 8, with a vector.
inline void multiply_dense(const float* matrix, int columns, int rows, const float* from,
                           float* to) {
  CGAL_RESTRICTED_LAPLACIAN_3_BEST(multiply_dense(matrix, columns, rows, from, to));
}

/// Subtracts `factor` times the outer product of a vector with itself from the upper triangle of a
/// symmetric matrix, stored with `stride` numbers a row, a multiple of 4, as has the vector. Lower
/// entries may change.
inline void subtract_outer_product(const double* column, double factor, double* a, int size,
                                   int stride) {
  CGAL_RESTRICTED_LAPLACIAN_3_BEST(subtract_outer_product(column, factor, a, size, stride));
}

#undef CGAL_RESTRICTED_LAPLACIAN_3_BEST

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_INTERNAL_BLOCK_KERNELS_H
