// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_SHARED_BLOCK_VECTORS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_SHARED_BLOCK_VECTORS_H

#include <Eigen/Core>

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

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_SHARED_BLOCK_VECTORS_H
