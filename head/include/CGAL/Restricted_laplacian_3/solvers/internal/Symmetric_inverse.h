// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_INTERNAL_SYMMETRIC_INVERSE_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_INTERNAL_SYMMETRIC_INVERSE_H

#include <CGAL/Restricted_laplacian_3/solvers/internal/block_kernels.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// Inverts small symmetric positive semi-definite matrices by Gauss-Jordan elimination without
/// exchanges, which keeps them symmetric (Beaton's sweep operator).
///
/// A pivot that is at most a given bound belongs to an unknown that nearly depends on those before
/// it: its row and column become 0, and the result is the inverse of the rest, so it is positive
/// semi-definite for any matrix.
///
/// Four pivots are swept at once. With their block \f$B\f$ and their columns \f$C\f$ in the other
/// rows \f$A\f$, a sweep turns \f$B\f$ into \f$-B^{-1}\f$, \f$C\f$ into \f$C B^{-1}\f$, and
/// \f$A\f$ into \f$A - C B^{-1} C^T\f$: each number of \f$A\f$ is read and written once for four
/// multiplications. Takes \f$n^3 / 2\f$ of them.
class Symmetric_inverse {
public:
  /// \param a in its lower triangle the matrix of `size` rows, on return the inverse; `stride`
  /// numbers a row, and as many rows, where `stride` is a multiple of 4 and at least `size`. Beyond
  /// `size` it has to be 0.
  /// \param cutoff the bound for pivots
  void operator()(double* a, int size, int stride, double cutoff) {
    m_columns.resize(width * static_cast<std::size_t>(stride));
    m_products.resize(m_columns.size());
    for(int first = 0; first < size; first += width)
      sweep(a, first, (std::min)(+width, size - first), size, stride, cutoff);
    for(int i = 0; i < size; ++i)
      for(int j = 0; j <= i; ++j)
        a[static_cast<std::size_t>(stride) * i + j] *= -1;
  }

private:
  static constexpr int width = pivots_of_a_sweep;
  using Block = std::array<std::array<double, width>, width>;

  void sweep(double* a, int first, int count, int size, int stride, double cutoff) {
    const auto row = [a, stride](int i) { return a + static_cast<std::size_t>(stride) * i; };
    const auto column = [this, stride](int p) { return m_columns.data() + p * stride; };
    const auto product = [this, stride](int p) { return m_products.data() + p * stride; };
    const int last = first + count;

    std::fill(m_columns.begin(), m_columns.end(), 0.);
    Block block = {};
    for(int p = 0; p < count; ++p) {
      for(int q = 0; q <= p; ++q)
        block[p][q] = block[q][p] = row(first + p)[first + q];
      std::copy(row(first + p), row(first + p) + first, column(p));
      std::fill(row(first + p), row(first + p) + last, 0.);
    }
    for(int i = last; i < size; ++i)
      for(int p = 0; p < count; ++p) {
        column(p)[i] = row(i)[first + p];
        row(i)[first + p] = 0;
      }
    invert(block, count, cutoff);
    for(int p = 0; p < width; ++p)
      for(int i = 0; i < stride; ++i)
        product(p)[i] = block[0][p] * column(0)[i] + block[1][p] * column(1)[i] +
                        block[2][p] * column(2)[i] + block[3][p] * column(3)[i];

    subtract_outer_products(m_products.data(), m_columns.data(), a, size, stride);

    for(int p = 0; p < count; ++p) {
      std::copy(product(p), product(p) + first, row(first + p));
      for(int q = 0; q <= p; ++q)
        row(first + p)[first + q] = -block[p][q];
    }
    for(int i = last; i < size; ++i)
      for(int p = 0; p < count; ++p)
        row(i)[first + p] = product(p)[i];
  }

  /// sweeps one pivot after the other
  static void invert(Block& a, int size, double cutoff) {
    for(int k = 0; k < size; ++k) {
      const double pivot = a[k][k];
      const bool is_dependent = !(pivot > cutoff);
      const double inverse = is_dependent ? 0 : 1 / pivot;
      std::array<double, width> column = {};
      for(int i = 0; i < size; ++i)
        if(i != k && !is_dependent)
          column[i] = a[i][k];
      for(int i = 0; i < size; ++i)
        for(int j = 0; j < size; ++j)
          a[i][j] -= inverse * (column[i] * column[j]);
      for(int i = 0; i < size; ++i)
        a[i][k] = a[k][i] = column[i] * inverse;
      a[k][k] = -inverse;
    }
    for(auto& row : a)
      for(double& entry : row)
        entry = -entry;
  }

  std::vector<double> m_columns, m_products;
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_INTERNAL_SYMMETRIC_INVERSE_H
