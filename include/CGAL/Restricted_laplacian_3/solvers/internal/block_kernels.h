// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_INTERNAL_BLOCK_KERNELS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_INTERNAL_BLOCK_KERNELS_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/vector_lanes.h>

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

/// an entry of a row of a sparse matrix
struct Row_entry {
  std::uint32_t column;
  float value;
};

namespace plain {

template <int K>
void subtract_columns(const float* values, const std::uint32_t* columns, std::size_t count,
                      int rows, const float* x, float* sum) {
  for(std::size_t k = 0; k < count; ++k)
    for(int i = 0; i < rows; ++i)
      for(int c = 0; c < K; ++c)
        sum[K * i + c] -= values[rows * k + i] * x[K * static_cast<std::size_t>(columns[k]) + c];
}

template <int K>
void multiply_symmetric(const float* blocks, int number, const float* from, float* to) {
  for(int i = 0; i < 8 * K * number; ++i)
    to[i] = 0;
  for(int column = 0; column < number; ++column)
    for(int row = 0; row <= column; ++row, blocks += 64)
      for(int j = 0; j < 8; ++j)
        for(int i = 0; i < 8; ++i)
          for(int c = 0; c < K; ++c) {
            to[K * (8 * row + i) + c] += blocks[8 * j + i] * from[K * (8 * column + j) + c];
            if(row != column)
              to[K * (8 * column + j) + c] += blocks[8 * j + i] * from[K * (8 * row + i) + c];
          }
}

template <int K>
void add_products(const Row_entry* entries, std::size_t count, float factor, const float* x,
                  float* sum) {
  float own[K] = {};
  for(std::size_t k = 0; k < count; ++k)
    for(int c = 0; c < K; ++c)
      own[c] += entries[k].value * x[K * static_cast<std::size_t>(entries[k].column) + c];
  for(int c = 0; c < K; ++c)
    sum[c] += factor * own[c];
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

// One vector: the lanes are the rows of a cluster. Where it has less than eight, the others get
// numbers without meaning, which nothing reads.
inline CGAL_RESTRICTED_LAPLACIAN_3_LANES_FUNCTION void
subtract_columns_of_one(const float* values, const std::uint32_t* columns, std::size_t count,
                        int rows, const float* x, float* sum) {
  // Four sums: a sum takes that many cycles to be ready for the next term.
  Float_lanes own[4] = {};
  std::size_t k = 0;
  for(; k + 4 <= count; k += 4)
    for(int c = 0; c < 4; ++c)
      own[c] += load(values + rows * (k + c)) * x[columns[k + c]];
  for(; k < count; ++k)
    own[0] += load(values + rows * k) * x[columns[k]];
  store(load(sum) - ((own[0] + own[1]) + (own[2] + own[3])), sum);
}

// Eight vectors: the lanes are the vectors, and what is read of them serves all rows of a cluster.
template <int rows>
CGAL_RESTRICTED_LAPLACIAN_3_LANES_FUNCTION void
subtract_columns_of_eight(const float* values, const std::uint32_t* columns, std::size_t count,
                          const float* x, float* sum) {
  Float_lanes own[rows];
  for(int i = 0; i < rows; ++i)
    own[i] = load(sum + 8 * i);
  for(std::size_t k = 0; k < count; ++k) {
    const Float_lanes from = load(x + 8 * static_cast<std::size_t>(columns[k]));
    for(int i = 0; i < rows; ++i)
      own[i] -= values[rows * k + i] * from;
  }
  for(int i = 0; i < rows; ++i)
    store(own[i], sum + 8 * i);
}

template <int K>
inline void subtract_columns(const float* values, const std::uint32_t* columns, std::size_t count,
                             int rows, const float* x, float* sum) {
  static_assert(K == 1 || K == 8);
  if(K == 1)
    return subtract_columns_of_one(values, columns, count, rows, x, sum);
  switch(rows) {
  case 1: return subtract_columns_of_eight<1>(values, columns, count, x, sum);
  case 2: return subtract_columns_of_eight<2>(values, columns, count, x, sum);
  case 3: return subtract_columns_of_eight<3>(values, columns, count, x, sum);
  case 4: return subtract_columns_of_eight<4>(values, columns, count, x, sum);
  case 5: return subtract_columns_of_eight<5>(values, columns, count, x, sum);
  case 6: return subtract_columns_of_eight<6>(values, columns, count, x, sum);
  case 7: return subtract_columns_of_eight<7>(values, columns, count, x, sum);
  case 8: return subtract_columns_of_eight<8>(values, columns, count, x, sum);
  }
}

inline CGAL_RESTRICTED_LAPLACIAN_3_LANES_FUNCTION void
multiply_one_symmetric(const float* blocks, int number, const float* from, float* to) {
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
multiply_eight_symmetric(const float* blocks, int number, const float* from, float* to) {
  const auto block = [blocks](int row, int column) {
    return blocks + 64 * (column * (column + 1) / 2 + row);
  };
  for(int row = 0; row < number; ++row) {
    Float_lanes sum[8] = {};
    for(int column = 0; column < row; ++column) {
      const float* a = block(column, row);
      for(int j = 0; j < 8; ++j) {
        const Float_lanes x = load(from + 8 * (8 * column + j));
        for(int i = 0; i < 8; ++i)
          sum[i] += a[8 * i + j] * x;
      }
    }
    for(int column = row; column < number; ++column) {
      const float* a = block(row, column);
      for(int j = 0; j < 8; ++j) {
        const Float_lanes x = load(from + 8 * (8 * column + j));
        for(int i = 0; i < 8; ++i)
          sum[i] += a[8 * j + i] * x;
      }
    }
    for(int i = 0; i < 8; ++i)
      store(sum[i], to + 8 * (8 * row + i));
  }
}

template <int K>
inline void multiply_symmetric(const float* blocks, int number, const float* from, float* to) {
  static_assert(K == 1 || K == 8);
  if(K == 1)
    multiply_one_symmetric(blocks, number, from, to);
  else
    multiply_eight_symmetric(blocks, number, from, to);
}

inline CGAL_RESTRICTED_LAPLACIAN_3_LANES_FUNCTION void
add_products_of_eight(const Row_entry* entries, std::size_t count, float factor, const float* x,
                      float* sum) {
  Float_lanes own[2] = {};
  std::size_t k = 0;
  for(; k + 2 <= count; k += 2)
    for(int c = 0; c < 2; ++c)
      own[c] +=
          entries[k + c].value * load(x + 8 * static_cast<std::size_t>(entries[k + c].column));
  if(k < count)
    own[0] += entries[k].value * load(x + 8 * static_cast<std::size_t>(entries[k].column));
  store(load(sum) + factor * (own[0] + own[1]), sum);
}

template <int K>
inline void add_products(const Row_entry* entries, std::size_t count, float factor, const float* x,
                         float* sum) {
  static_assert(K == 1 || K == 8);
  if(K == 1)
    plain::add_products<1>(entries, count, factor, x, sum);
  else
    add_products_of_eight(entries, count, factor, x, sum);
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

#endif

/// Subtracts the `rows` rows of a cluster, times `K` vectors `x`, from `K` vectors: for each of
/// `count` columns a number for each row. `x` and `sum` have `K` numbers for each position; those
/// of `sum` beyond the rows may change. After the values there have to be seven numbers more.
template <int K>
void subtract_columns(const float* values, const std::uint32_t* columns, std::size_t count,
                      int rows, const float* x, float* sum) {
  CGAL_RESTRICTED_LAPLACIAN_3_BEST(subtract_columns<K>(values, columns, count, rows, x, sum));
}

/// Product of a symmetric matrix with `K` vectors. The matrix has `number` x `number` blocks of
/// 8 x 8 numbers, of which the upper triangle is stored, one column of blocks after the other.
template <int K>
void multiply_symmetric(const float* blocks, int number, const float* from, float* to) {
  CGAL_RESTRICTED_LAPLACIAN_3_BEST(multiply_symmetric<K>(blocks, number, from, to));
}

/// Adds the product of a row of a sparse matrix with `K` vectors, times a factor, to `K` numbers.
template <int K>
void add_products(const Row_entry* entries, std::size_t count, float factor, const float* x,
                  float* sum) {
  CGAL_RESTRICTED_LAPLACIAN_3_BEST(add_products<K>(entries, count, factor, x, sum));
}

/// Subtracts the sum of the outer products of the vectors `c[p]` and `d[p]` from the lower triangle
/// of a matrix of `size` rows. Vectors and rows have `stride` numbers, a multiple of 4 and at least
/// `size`; there are `stride` rows, of which those from `size` on may change, as upper entries may.
inline void subtract_outer_products(const double* c, const double* d, double* a, int size,
                                    int stride) {
  CGAL_RESTRICTED_LAPLACIAN_3_BEST(subtract_outer_products(c, d, a, size, stride));
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_INTERNAL_BLOCK_KERNELS_H
