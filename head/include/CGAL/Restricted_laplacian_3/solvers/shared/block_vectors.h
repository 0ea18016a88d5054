// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_SHARED_BLOCK_VECTORS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_SHARED_BLOCK_VECTORS_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/parallel_for.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

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

/// The sum of what `add_term(i, sum)` adds to `sum`, an array of numbers, for all rows `i`. Rows
/// are summed in chunks, which are added in their order, so the result is the same for any number
/// of threads.
template <class Sum, class Term>
Sum sum_over_rows(bool is_parallel, Eigen::Index rows, const Sum& zero, Term&& add_term) {
  constexpr std::size_t grain = 4096;
  const std::size_t size = static_cast<std::size_t>(rows);
  std::vector<Sum> sums((size + grain - 1) / grain, zero);
  parallel_for(is_parallel, 0, size, grain, [&](std::size_t begin, std::size_t end) {
    Sum sum = zero;
    for(std::size_t i = begin; i < end; ++i)
      add_term(static_cast<Eigen::Index>(i), sum);
    sums[begin / grain] = sum;
  });
  Sum result = zero;
  for(const Sum& sum : sums)
    result += sum;
  return result;
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_SHARED_BLOCK_VECTORS_H
