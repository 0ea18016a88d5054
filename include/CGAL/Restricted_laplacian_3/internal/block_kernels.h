// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_INTERNAL_BLOCK_KERNELS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_INTERNAL_BLOCK_KERNELS_H

#include <CGAL/Restricted_laplacian_3/internal/vector_lanes.h>

#include <cstddef>
#include <cstdint>

/// \file
/// The loops in which a cycle spends its time, for any processor (`plain`) and for vectors of 256
/// bits (`lanes`).

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// how many vectors `subtract_outer_products()` takes
constexpr int pivots_of_a_sweep = 4;

namespace plain {

template <int K>
void subtract_blocks(const float* values, const std::uint32_t* columns,
                     const std::uint8_t* cluster_sizes, std::size_t count, const float* x,
                     float* sum) {
  float own[8 * K] = {};
  for(std::size_t k = 0; k < count; ++k) {
    const int size = cluster_sizes[columns[k]];
    const float* from = x + 8 * K * static_cast<std::size_t>(columns[k]);
    for(int j = 0; j < size; ++j, values += 8)
      for(int c = 0; c < K; ++c)
        for(int l = 0; l < 8; ++l)
          own[8 * c + l] += values[l] * from[8 * c + j];
  }
  for(int l = 0; l < 8 * K; ++l)
    sum[l] -= own[l];
}

inline void multiply_symmetric(const float* blocks, int number, const float* from, float* to) {
  for(int i = 0; i < 8 * number; ++i)
    to[i] = 0;
  for(int column = 0; column < number; ++column)
    for(int row = 0; row <= column; ++row, blocks += 64)
      for(int j = 0; j < 8; ++j)
        for(int i = 0; i < 8; ++i) {
          to[8 * row + i] += blocks[8 * j + i] * from[8 * column + j];
          if(row != column)
            to[8 * column + j] += blocks[8 * j + i] * from[8 * row + i];
        }
}

inline void subtract_outer_products(const double* c, const double* d, double* a, int size,
                                    int stride) {
  for(int i = 0; i < size; ++i)
    for(int p = 0; p < pivots_of_a_sweep; ++p) {
      const double factor = c[p * stride + i];
      for(int j = 0; j <= i; ++j)
        a[static_cast<std::size_t>(stride) * i + j] -= factor * d[p * stride + j];
    }
}

} // namespace plain

#ifdef CGAL_RESTRICTED_LAPLACIAN_3_HAS_LANES

namespace lanes {

template <int K>
CGAL_RESTRICTED_LAPLACIAN_3_LANES_FUNCTION void
subtract_blocks(const float* values, const std::uint32_t* columns,
                const std::uint8_t* cluster_sizes, std::size_t count, const float* x, float* sum) {
  // Four sums at a time: a sum takes that many cycles to be ready for the next term.
  constexpr int chains = K == 1 ? 4 : K;
  Float_lanes own[chains];
  for(int c = 0; c < chains; ++c)
    own[c] = Float_lanes{};
  for(std::size_t k = 0; k < count; ++k) {
    const int size = cluster_sizes[columns[k]];
    const float* from = x + 8 * K * static_cast<std::size_t>(columns[k]);
    int j = 0;
    if(K == 1)
      for(; j + 4 <= size; j += 4)
        for(int c = 0; c < 4; ++c)
          own[c] += load(values + 8 * (j + c)) * from[j + c];
    for(; j < size; ++j) {
      const Float_lanes a = load(values + 8 * j);
      for(int c = 0; c < K; ++c)
        own[c] += a * from[8 * c + j];
    }
    values += 8 * size;
  }
  if(K == 1)
    store(load(sum) - ((own[0] + own[1]) + (own[2] + own[3])), sum);
  else
    for(int c = 0; c < K; ++c)
      store(load(sum + 8 * c) - own[c], sum + 8 * c);
}

inline CGAL_RESTRICTED_LAPLACIAN_3_LANES_FUNCTION void
multiply_symmetric(const float* blocks, int number, const float* from, float* to) {
  for(int i = 0; i < number; ++i)
    store(Float_lanes{}, to + 8 * i);
  for(int column = 0; column < number; ++column) {
    const float* x = from + 8 * column;
    Float_lanes transposed[8] = {};
    for(int row = 0; row < column; ++row, blocks += 64) {
      const Float_lanes x_row = load(from + 8 * row);
      Float_lanes even = load(to + 8 * row), odd{};
      for(int j = 0; j < 8; j += 2) {
        const Float_lanes a = load(blocks + 8 * j), b = load(blocks + 8 * j + 8);
        even += a * x[j];
        odd += b * x[j + 1];
        transposed[j] += a * x_row;
        transposed[j + 1] += b * x_row;
      }
      store(even + odd, to + 8 * row);
    }
    Float_lanes sum = sums_of_components(transposed), odd{};
    for(int j = 0; j < 8; j += 2) {
      sum += load(blocks + 8 * j) * x[j];
      odd += load(blocks + 8 * j + 8) * x[j + 1];
    }
    blocks += 64;
    store(load(to + 8 * column) + (sum + odd), to + 8 * column);
  }
}

inline CGAL_RESTRICTED_LAPLACIAN_3_LANES_FUNCTION void
subtract_outer_products(const double* c, const double* d, double* a, int size, int stride) {
  // Two rows at a time: what is loaded of `d` serves both.
  for(int i = 0; i < size; i += 2) {
    double* row = a + static_cast<std::size_t>(stride) * i;
    double* next = row + stride;
    Lanes of_row[pivots_of_a_sweep], of_next[pivots_of_a_sweep];
    for(int p = 0; p < pivots_of_a_sweep; ++p) {
      of_row[p] = Lanes{} + c[p * stride + i];
      of_next[p] = Lanes{} + c[p * stride + i + 1];
    }
    for(int j = 0; j <= i + 1; j += 4) {
      Lanes sum = load(row + j), next_sum = load(next + j);
      for(int p = 0; p < pivots_of_a_sweep; ++p) {
        const Lanes factor = load(d + p * stride + j);
        sum -= of_row[p] * factor;
        next_sum -= of_next[p] * factor;
      }
      store(sum, row + j);
      store(next_sum, next + j);
    }
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

/// Subtracts a row of blocks, times the clusters `columns` of `K` vectors `x`, from a cluster of
/// `K` vectors. A block has eight rows, and as many columns as its cluster has unknowns.
template <int K>
void subtract_blocks(const float* values, const std::uint32_t* columns,
                     const std::uint8_t* cluster_sizes, std::size_t count, const float* x,
                     float* sum) {
  CGAL_RESTRICTED_LAPLACIAN_3_BEST(
      subtract_blocks<K>(values, columns, cluster_sizes, count, x, sum));
}

/// Product of a symmetric matrix with a vector. The matrix consists of `number` x `number` blocks
/// of 8 x 8 numbers, of which the upper triangle is stored, one column of blocks after the other.
inline void multiply_symmetric(const float* blocks, int number, const float* from, float* to) {
  CGAL_RESTRICTED_LAPLACIAN_3_BEST(multiply_symmetric(blocks, number, from, to));
}

/// Subtracts the sum of the outer products of the vectors `c[p]` and `d[p]` from the lower triangle
/// of a matrix of `size` rows. Vectors and rows have `stride` numbers, a multiple of 4 and at least
/// `size`; there are `stride` rows, of which those from `size` on may change, as upper entries may.
inline void subtract_outer_products(const double* c, const double* d, double* a, int size,
                                    int stride) {
  CGAL_RESTRICTED_LAPLACIAN_3_BEST(subtract_outer_products(c, d, a, size, stride));
}

#undef CGAL_RESTRICTED_LAPLACIAN_3_BEST

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_INTERNAL_BLOCK_KERNELS_H
