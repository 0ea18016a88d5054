// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_SHARED_PANEL_KERNELS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_SHARED_PANEL_KERNELS_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/vector_lanes.h>

#include <cstddef>

/// \file
/// The loops over the rows of panels, which are matrices of eight columns in double precision (some
/// also in single), stored row by row. They are there for any processor (`plain`), for vectors of
/// 256 bits (`lanes`) and of 512 (`wide_lanes`); the latter two give the same to the last bit.

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// Entries of a column of `N` matrices with the same pattern.
struct Column_entries {
  const double* const* values; ///< of each matrix
  const int* rows;
  std::size_t count;
};

namespace plain {

template <class Number>
void add_scalar_products(const Number* q, const double* b, std::size_t rows, double* sums) {
  for(std::size_t row = 0; row < rows; ++row, q += 8, b += 8)
    for(int j = 0; j < 8; ++j)
      for(int i = 0; i < 8; ++i)
        sums[8 * j + i] += b[j] * q[i];
}

inline void add_combination(const double* q, const double* c, std::size_t rows, double* sum) {
  for(std::size_t row = 0; row < rows; ++row, q += 8, sum += 8)
    for(int i = 0; i < 8; ++i)
      for(int j = 0; j < 8; ++j)
        sum[j] += q[i] * c[8 * i + j];
}

template <int K, int N>
void add_symmetric_column(const Column_entries& column, const double* x, const double* own,
                          double* const* sums, std::size_t first_row, double* own_sums) {
  for(std::size_t k = 0; k < column.count; ++k) {
    const std::size_t row = static_cast<std::size_t>(column.rows[k]);
    const double* const from = x + K * row;
    for(int n = 0; n < N; ++n) {
      double* const to = sums[n] + K * (row - first_row);
      for(int c = 0; c < K; ++c) {
        own_sums[K * n + c] += column.values[n][k] * from[c];
        to[c] += column.values[n][k] * own[c];
      }
    }
  }
}

} // namespace plain

#ifdef CGAL_RESTRICTED_LAPLACIAN_3_HAS_LANES

namespace lanes {

CGAL_RESTRICTED_LAPLACIAN_3_LANES_INLINE Lanes load_doubles(const double* from) {
  return load(from);
}

CGAL_RESTRICTED_LAPLACIAN_3_LANES_INLINE Lanes load_doubles(const float* from) {
  using Four_floats = float __attribute__((vector_size(16)));
  Four_floats four;
  std::memcpy(&four, from, sizeof(Four_floats));
  return __builtin_convertvector(four, Lanes);
}

// Four columns of `b` at a time: their sums with the eight columns of `q` fill eight registers.
template <class Number>
CGAL_RESTRICTED_LAPLACIAN_3_LANES_FUNCTION void
add_scalar_products(const Number* q, const double* b, std::size_t rows, double* sums) {
  for(int first = 0; first < 8; first += 4) {
    Lanes own[4][2] = {};
    for(std::size_t row = 0; row < rows; ++row) {
      const Lanes low = load_doubles(q + 8 * row), high = load_doubles(q + 8 * row + 4);
      for(int j = 0; j < 4; ++j) {
        own[j][0] += b[8 * row + first + j] * low;
        own[j][1] += b[8 * row + first + j] * high;
      }
    }
    for(int j = 0; j < 4; ++j)
      for(int half = 0; half < 2; ++half) {
        double* const to = sums + 8 * (first + j) + 4 * half;
        store(load(to) + own[j][half], to);
      }
  }
}

// Four rows at a time: what is loaded of `c` serves all of them.
inline CGAL_RESTRICTED_LAPLACIAN_3_LANES_FUNCTION void
add_combination(const double* q, const double* c, std::size_t rows, double* sum) {
  std::size_t row = 0;
  for(; row + 4 <= rows; row += 4, q += 32, sum += 32) {
    Lanes own[4][2];
    for(int r = 0; r < 4; ++r) {
      own[r][0] = load(sum + 8 * r);
      own[r][1] = load(sum + 8 * r + 4);
    }
    for(int i = 0; i < 8; ++i) {
      const Lanes low = load(c + 8 * i), high = load(c + 8 * i + 4);
      for(int r = 0; r < 4; ++r) {
        own[r][0] += q[8 * r + i] * low;
        own[r][1] += q[8 * r + i] * high;
      }
    }
    for(int r = 0; r < 4; ++r) {
      store(own[r][0], sum + 8 * r);
      store(own[r][1], sum + 8 * r + 4);
    }
  }
  for(; row < rows; ++row, q += 8, sum += 8)
    for(int i = 0; i < 8; ++i) {
      store(load(sum) + q[i] * load(c + 8 * i), sum);
      store(load(sum + 4) + q[i] * load(c + 8 * i + 4), sum + 4);
    }
}

template <int K, int N>
CGAL_RESTRICTED_LAPLACIAN_3_LANES_FUNCTION void
add_symmetric_column(const Column_entries& column, const double* x, const double* own,
                     double* const* sums, std::size_t first_row, double* own_sums) {
  static_assert(K == 8);
  const Lanes low = load(own), high = load(own + 4);
  Lanes low_sum[N], high_sum[N];
  for(int n = 0; n < N; ++n) {
    low_sum[n] = load(own_sums + 8 * n);
    high_sum[n] = load(own_sums + 8 * n + 4);
  }
  for(std::size_t k = 0; k < column.count; ++k) {
    const std::size_t row = static_cast<std::size_t>(column.rows[k]);
    const Lanes from_low = load(x + 8 * row), from_high = load(x + 8 * row + 4);
    for(int n = 0; n < N; ++n) {
      const double value = column.values[n][k];
      double* const to = sums[n] + 8 * (row - first_row);
      low_sum[n] += value * from_low;
      high_sum[n] += value * from_high;
      store(load(to) + value * low, to);
      store(load(to + 4) + value * high, to + 4);
    }
  }
  for(int n = 0; n < N; ++n) {
    store(low_sum[n], own_sums + 8 * n);
    store(high_sum[n], own_sums + 8 * n + 4);
  }
}

} // namespace lanes

namespace wide_lanes {

// A row of a panel is a vector. Nothing is passed by value: a vector of this size would go through
// memory where the caller is compiled for other processors.
CGAL_RESTRICTED_LAPLACIAN_3_WIDE_LANES_INLINE void load(const double* from, Wide_lanes& to) {
  std::memcpy(&to, from, sizeof(Wide_lanes));
}
CGAL_RESTRICTED_LAPLACIAN_3_WIDE_LANES_INLINE void load(const float* from, Wide_lanes& to) {
  using Eight_floats = float __attribute__((vector_size(32)));
  Eight_floats eight;
  std::memcpy(&eight, from, sizeof(Eight_floats));
  to = __builtin_convertvector(eight, Wide_lanes);
}
CGAL_RESTRICTED_LAPLACIAN_3_WIDE_LANES_INLINE void store(const Wide_lanes& from, double* to) {
  std::memcpy(to, &from, sizeof(Wide_lanes));
}

template <class Number>
CGAL_RESTRICTED_LAPLACIAN_3_WIDE_LANES_FUNCTION void
add_scalar_products(const Number* q, const double* b, std::size_t rows, double* sums) {
  Wide_lanes own[8] = {}, from;
  for(std::size_t row = 0; row < rows; ++row) {
    load(q + 8 * row, from);
    for(int j = 0; j < 8; ++j)
      own[j] += b[8 * row + j] * from;
  }
  for(int j = 0; j < 8; ++j) {
    load(sums + 8 * j, from);
    from += own[j];
    store(from, sums + 8 * j);
  }
}

// Four rows at a time: a sum takes that many cycles to be ready for the next term.
inline CGAL_RESTRICTED_LAPLACIAN_3_WIDE_LANES_FUNCTION void
add_combination(const double* q, const double* c, std::size_t rows, double* sum) {
  Wide_lanes of_row[8], own[4];
  for(int i = 0; i < 8; ++i)
    load(c + 8 * i, of_row[i]);
  std::size_t row = 0;
  for(; row + 4 <= rows; row += 4, q += 32, sum += 32) {
    for(int r = 0; r < 4; ++r)
      load(sum + 8 * r, own[r]);
    for(int i = 0; i < 8; ++i)
      for(int r = 0; r < 4; ++r)
        own[r] += q[8 * r + i] * of_row[i];
    for(int r = 0; r < 4; ++r)
      store(own[r], sum + 8 * r);
  }
  for(; row < rows; ++row, q += 8, sum += 8) {
    load(sum, own[0]);
    for(int i = 0; i < 8; ++i)
      own[0] += q[i] * of_row[i];
    store(own[0], sum);
  }
}

template <int K, int N>
CGAL_RESTRICTED_LAPLACIAN_3_WIDE_LANES_FUNCTION void
add_symmetric_column(const Column_entries& column, const double* x, const double* own,
                     double* const* sums, std::size_t first_row, double* own_sums) {
  static_assert(K == 8);
  Wide_lanes x_own, from, to, own_sum[N];
  load(own, x_own);
  for(int n = 0; n < N; ++n)
    load(own_sums + 8 * n, own_sum[n]);
  for(std::size_t k = 0; k < column.count; ++k) {
    const std::size_t row = static_cast<std::size_t>(column.rows[k]);
    load(x + 8 * row, from);
    for(int n = 0; n < N; ++n) {
      const double value = column.values[n][k];
      double* const place = sums[n] + 8 * (row - first_row);
      own_sum[n] += value * from;
      load(place, to);
      to += value * x_own;
      store(to, place);
    }
  }
  for(int n = 0; n < N; ++n)
    store(own_sum[n], own_sums + 8 * n);
}

} // namespace wide_lanes

#endif

/// Adds the scalar product of column `i` of a panel `q` with column `j` of a panel `b` to number
/// \f$8 j + i\f$ of `sums`.
template <class Number>
void add_scalar_products(const Number* q, const double* b, std::size_t rows, double* sums) {
  CGAL_RESTRICTED_LAPLACIAN_3_WIDEST(add_scalar_products(q, b, rows, sums));
}

/// Adds the product of a panel with the 8 x 8 matrix of the numbers `c`, stored row by row, to
/// another panel.
inline void add_combination(const double* q, const double* c, std::size_t rows, double* sum) {
  CGAL_RESTRICTED_LAPLACIAN_3_WIDEST(add_combination(q, c, rows, sum));
}

/// Adds the products of entries of a column of `N` symmetric matrices, and of their mirror images,
/// with `K` vectors `x`: those of the column, times the row `own` of `x`, to `sums`, which begin
/// with row `first_row`, and those of the row to `own_sums`, `K` numbers for each matrix.
template <int K, int N>
void add_symmetric_column(const Column_entries& column, const double* x, const double* own,
                          double* const* sums, std::size_t first_row, double* own_sums) {
  if constexpr(K == 8) {
    CGAL_RESTRICTED_LAPLACIAN_3_WIDEST(
        add_symmetric_column<K, N>(column, x, own, sums, first_row, own_sums));
  } else
    plain::add_symmetric_column<K, N>(column, x, own, sums, first_row, own_sums);
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_SHARED_PANEL_KERNELS_H
