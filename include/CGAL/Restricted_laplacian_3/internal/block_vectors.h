// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_INTERNAL_BLOCK_VECTORS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_INTERNAL_BLOCK_VECTORS_H

#include <CGAL/Restricted_laplacian_3/internal/parallel_for.h>

#include <Eigen/SparseCore>

#include <cstddef>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// `K` vectors side by side, stored row by row, so that one pass over a matrix serves all of them
template <int K>
using Block_vector =
    Eigen::Matrix<double, Eigen::Dynamic, K, K == 1 ? Eigen::ColMajor : Eigen::RowMajor>;
template <int K> using Block_row = Eigen::Array<double, 1, K>;

/// row `i` of `x`, to be read or written
template <int K> Eigen::Map<Block_row<K>> row(Block_vector<K>& x, Eigen::Index i) {
  return Eigen::Map<Block_row<K>>(x.data() + K * i);
}
template <int K> Eigen::Map<const Block_row<K>> row(const Block_vector<K>& x, Eigen::Index i) {
  return Eigen::Map<const Block_row<K>>(x.data() + K * i);
}

/// subtracts entries `begin` .. `end` of the storage of `a`, times the rows of `x`, from `sum`
template <int K>
void subtract_entries(const Eigen::SparseMatrix<double>& a, int begin, int end,
                      const Block_vector<K>& x, Block_row<K>& sum) {
  const double* values = a.valuePtr();
  const int* inner = a.innerIndexPtr();
  for(int k = begin; k < end; ++k)
    sum -= values[k] * row<K>(x, inner[k]);
}

constexpr std::size_t rows_of_a_task = 2048;

/// \f$ y = A x \f$ for a symmetric matrix, whose columns are its rows
template <int K>
void multiply(const Eigen::SparseMatrix<double>& a, const Block_vector<K>& x, Block_vector<K>& y,
              bool is_parallel = false) {
  y.resize(a.cols(), K);
  const int* outer = a.outerIndexPtr();
  parallel_for(is_parallel, 0, a.cols(), rows_of_a_task, [&](std::size_t begin, std::size_t end) {
    for(std::size_t j = begin; j < end; ++j) {
      Block_row<K> sum = Block_row<K>::Zero();
      subtract_entries<K>(a, outer[j], outer[j + 1], x, sum);
      row<K>(y, j) = -sum;
    }
  });
}

/// \f$ r = b - A x \f$ for a symmetric matrix
template <int K>
void residual(const Eigen::SparseMatrix<double>& a, const Block_vector<K>& b,
              const Block_vector<K>& x, Block_vector<K>& r, bool is_parallel = false) {
  r.resize(a.cols(), K);
  const int* outer = a.outerIndexPtr();
  parallel_for(is_parallel, 0, a.cols(), rows_of_a_task, [&](std::size_t begin, std::size_t end) {
    for(std::size_t j = begin; j < end; ++j) {
      Block_row<K> sum = row<K>(b, j);
      subtract_entries<K>(a, outer[j], outer[j + 1], x, sum);
      row<K>(r, j) = sum;
    }
  });
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_INTERNAL_BLOCK_VECTORS_H
