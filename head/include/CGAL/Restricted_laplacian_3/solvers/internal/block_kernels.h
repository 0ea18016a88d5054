// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_INTERNAL_BLOCK_KERNELS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_INTERNAL_BLOCK_KERNELS_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/vector_lanes.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>

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

/// how many numbers a symmetric matrix of `size` rows has on and below its diagonal
constexpr int symmetric_size(int size) { return size * (size + 1) / 2; }

/// Writes the `symmetric_size()` numbers of a symmetric matrix, eight columns after the other. Of
/// these there are first the blocks of eight rows above those of the diagonal, column by column,
/// then the lower triangle of the block on it, likewise.
/// \param matrix its lower triangle, row by row, with `stride` numbers each
inline void pack_symmetric(const double* matrix, int size, int stride, float* to) {
  for(int first = 0; first < size; first += 8) {
    const int end = first + 8 < size ? first + 8 : size;
    const auto row = [matrix, stride](int i) {
      return matrix + static_cast<std::size_t>(stride) * i;
    };
    for(int block = 0; block < first; block += 8)
      for(int j = first; j < end; ++j)
        to = std::copy(row(j) + block, row(j) + block + 8, to);
    for(int j = first; j < end; ++j)
      for(int i = j; i < end; ++i)
        *to++ = static_cast<float>(row(i)[j]);
  }
}

namespace plain {

template <int K>
void subtract_columns(const float* values, const std::uint32_t* columns, std::size_t count,
                      int rows, const float* x, float* sum) {
  for(std::size_t k = 0; k < count; ++k)
    for(int i = 0; i < rows; ++i)
      for(int c = 0; c < K; ++c)
        sum[K * i + c] -= values[rows * k + i] * x[K * static_cast<std::size_t>(columns[k]) + c];
}

template <int K> void multiply_symmetric(const float* a, int size, const float* from, float* to) {
  for(int i = 0; i < K * size; ++i)
    to[i] = 0;
  for(int first = 0; first < size; first += 8) {
    const int width = size - first < 8 ? size - first : 8;
    for(int j = first; j < first + width; ++j)
      for(int i = 0; i < first; ++i) {
        const float entry = a[width * (i / 8 * 8) + 8 * (j - first) + i % 8];
        for(int c = 0; c < K; ++c) {
          to[K * i + c] += entry * from[K * j + c];
          to[K * j + c] += entry * from[K * i + c];
        }
      }
    a += width * first;
    for(int j = first; j < first + width; ++j)
      for(int i = j; i < first + width; ++i, ++a)
        for(int c = 0; c < K; ++c) {
          to[K * i + c] += *a * from[K * j + c];
          if(i != j)
            to[K * j + c] += *a * from[K * i + c];
        }
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

/// the numbers of a vector in the lanes from `first` to `end`, 0 in the others
CGAL_RESTRICTED_LAPLACIAN_3_LANES_INLINE Float_lanes some_lanes(const Float_lanes& a, int first,
                                                                int end) {
  using Masks = std::int32_t __attribute__((vector_size(32)));
  Masks bits, mask;
  std::memcpy(&bits, &a, sizeof(Masks));
  for(int i = 0; i < 8; ++i)
    mask[i] = i >= first && i < end ? -1 : 0;
  bits &= mask;
  Float_lanes result;
  std::memcpy(&result, &bits, sizeof(Masks));
  return result;
}

// One vector: adds the products of a panel of columns, and of the rows that mirror it.
template <int width>
CGAL_RESTRICTED_LAPLACIAN_3_LANES_INLINE const float*
add_panel_of_one(const float* a, int first, const float* from, float* to) {
  const float* const x = from + first;
  Float_lanes transposed[8] = {};
  for(int row = 0; row < first; row += 8, a += 8 * width) {
    const Float_lanes x_row = load(from + row);
    Float_lanes even = load(to + row), odd{};
    for(int j = 0; j < width; j += 2) {
      const Float_lanes column = load(a + 8 * j);
      even += column * x[j];
      transposed[j] += column * x_row;
      if(j + 1 < width) {
        const Float_lanes next = load(a + 8 * j + 8);
        odd += next * x[j + 1];
        transposed[j + 1] += next * x_row;
      }
    }
    store(even + odd, to + row);
  }
  // The triangle: a column is read from so far before it that its numbers are in their lanes.
  const Float_lanes own = load(x);
  Float_lanes even{}, odd{};
  for(int j = 0; j < width; ++j, a += width - j + 1) {
    const Float_lanes column = load(a - j);
    (j % 2 == 0 ? even : odd) += some_lanes(column, j, width) * x[j];
    transposed[j] += some_lanes(column, j + 1, width) * own;
  }
  store(load(to + first) + (sums_of_components(transposed) + (even + odd)), to + first);
  return a;
}

inline CGAL_RESTRICTED_LAPLACIAN_3_LANES_FUNCTION void
multiply_one_symmetric(const float* a, int size, const float* from, float* to) {
  for(int i = 0; i < size; i += 8)
    store(Float_lanes{}, to + i);
  int first = 0;
  for(; first + 8 <= size; first += 8)
    a = add_panel_of_one<8>(a, first, from, to);
  switch(size - first) {
  case 1: add_panel_of_one<1>(a, first, from, to); break;
  case 2: add_panel_of_one<2>(a, first, from, to); break;
  case 3: add_panel_of_one<3>(a, first, from, to); break;
  case 4: add_panel_of_one<4>(a, first, from, to); break;
  case 5: add_panel_of_one<5>(a, first, from, to); break;
  case 6: add_panel_of_one<6>(a, first, from, to); break;
  case 7: add_panel_of_one<7>(a, first, from, to); break;
  }
}

// Eight vectors: the product of eight rows, or of the last ones.
template <int width>
CGAL_RESTRICTED_LAPLACIAN_3_LANES_INLINE void
multiply_rows_of_eight(const float* a, int size, int first, const float* from, float* to) {
  Float_lanes sum[width] = {};
  // their own panel, which mirrors what is before the diagonal
  const float* own = a + symmetric_size(first);
  for(int column = 0; column < first; ++column) {
    const Float_lanes x = load(from + 8 * column);
    const float* const entry = own + width * (column / 8 * 8) + column % 8;
    for(int i = 0; i < width; ++i)
      sum[i] += entry[8 * i] * x;
  }
  own += width * first;
  for(int j = 0; j < width; ++j, own += width - j + 1) {
    const Float_lanes x = load(from + 8 * (first + j));
    sum[j] += *own * x;
    for(int i = j + 1; i < width; ++i) {
      sum[i] += own[i - j] * x;
      sum[j] += own[i - j] * load(from + 8 * (first + i));
    }
  }
  for(int panel = first + 8; panel < size; panel += 8) {
    const int columns = size - panel < 8 ? size - panel : 8;
    const float* entry = a + symmetric_size(panel) + columns * first;
    for(int j = 0; j < columns; ++j, entry += 8) {
      const Float_lanes x = load(from + 8 * (panel + j));
      for(int i = 0; i < width; ++i)
        sum[i] += entry[i] * x;
    }
  }
  for(int i = 0; i < width; ++i)
    store(sum[i], to + 8 * (first + i));
}

inline CGAL_RESTRICTED_LAPLACIAN_3_LANES_FUNCTION void
multiply_eight_symmetric(const float* a, int size, const float* from, float* to) {
  int first = 0;
  for(; first + 8 <= size; first += 8)
    multiply_rows_of_eight<8>(a, size, first, from, to);
  switch(size - first) {
  case 1: multiply_rows_of_eight<1>(a, size, first, from, to); break;
  case 2: multiply_rows_of_eight<2>(a, size, first, from, to); break;
  case 3: multiply_rows_of_eight<3>(a, size, first, from, to); break;
  case 4: multiply_rows_of_eight<4>(a, size, first, from, to); break;
  case 5: multiply_rows_of_eight<5>(a, size, first, from, to); break;
  case 6: multiply_rows_of_eight<6>(a, size, first, from, to); break;
  case 7: multiply_rows_of_eight<7>(a, size, first, from, to); break;
  }
}

template <int K>
inline void multiply_symmetric(const float* a, int size, const float* from, float* to) {
  static_assert(K == 1 || K == 8);
  if(K == 1)
    multiply_one_symmetric(a, size, from, to);
  else
    multiply_eight_symmetric(a, size, from, to);
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

/// Product of a symmetric matrix of `size` rows with `K` vectors. The matrix is as
/// `pack_symmetric()` writes it. There has to be room for seven numbers more after it, and for
/// vectors of a multiple of eight rows; the additional rows of `from` are 0, those of `to` may
/// change.
template <int K> void multiply_symmetric(const float* a, int size, const float* from, float* to) {
  CGAL_RESTRICTED_LAPLACIAN_3_BEST(multiply_symmetric<K>(a, size, from, to));
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
