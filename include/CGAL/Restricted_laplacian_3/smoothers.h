// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SMOOTHERS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SMOOTHERS_H

#include <CGAL/Restricted_laplacian_3/internal/block_vectors.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Ref
/// Point Gauss-Seidel, in the order of the unknowns before the coarse correction and in reverse
/// after it, which makes a cycle a symmetric operator. The matrix is symmetric. A row whose
/// diagonal entry is not positive is left out: its unknown stays 0.
///
/// One sweep takes one pass over the matrix; the first one, which starts from 0, and the residual
/// after it take half a pass each: after the update of unknown \f$j\f$ its equation holds, with 0
/// for all later unknowns, so the residual is \f$ r_j = -\sum_{i > j} A_{ji} x_i \f$.
///
/// \cgalModels `MultigridSmoother_3`
class Gauss_seidel_smoother {
public:
  explicit Gauss_seidel_smoother(const Eigen::SparseMatrix<double>& a)
    : m_inverse_diagonal(a.cols(), 0.), m_diagonal_position(a.cols()) {
    const int *outer = a.outerIndexPtr(), *inner = a.innerIndexPtr();
    for(int j = 0; j < a.cols(); ++j) {
      const int position =
          static_cast<int>(std::lower_bound(inner + outer[j], inner + outer[j + 1], j) - inner);
      m_diagonal_position[j] = position;
      if(position < outer[j + 1] && inner[position] == j && a.valuePtr()[position] > 0)
        m_inverse_diagonal[j] = 1 / a.valuePtr()[position];
    }
  }

  /// starts from \f$x = 0\f$; on return \f$r = b - A x\f$
  template <int K>
  void pre_smooth(const Eigen::SparseMatrix<double>& a, const internal::Block_vector<K>& b,
                  internal::Block_vector<K>& x, internal::Block_vector<K>& r, int steps) const {
    const int n = static_cast<int>(a.cols());
    const int* outer = a.outerIndexPtr();
    x.setZero(n, K);
    if(steps == 0) {
      r = b;
      return;
    }
    for(int j = 0; j < n; ++j) {
      internal::Block_row<K> sum = internal::row<K>(b, j);
      internal::subtract_entries<K>(a, outer[j], m_diagonal_position[j], x, sum);
      internal::row<K>(x, j) = sum * m_inverse_diagonal[j];
    }
    if(steps == 1) {
      r.resize(n, K);
      for(int j = 0; j < n; ++j) {
        internal::Block_row<K> sum = internal::Block_row<K>::Zero();
        if(m_inverse_diagonal[j] == 0) {
          sum = internal::row<K>(b, j);
          internal::subtract_entries<K>(a, outer[j], outer[j + 1], x, sum);
        } else
          internal::subtract_entries<K>(a, m_diagonal_position[j] + 1, outer[j + 1], x, sum);
        internal::row<K>(r, j) = sum;
      }
      return;
    }
    for(int step = 1; step < steps; ++step)
      for(int j = 0; j < n; ++j)
        update<K>(a, b, x, j);
    internal::residual<K>(a, b, x, r);
  }

  template <int K>
  void post_smooth(const Eigen::SparseMatrix<double>& a, const internal::Block_vector<K>& b,
                   internal::Block_vector<K>& x, int steps) const {
    for(int step = 0; step < steps; ++step)
      for(int j = static_cast<int>(a.cols()) - 1; j >= 0; --j)
        update<K>(a, b, x, j);
  }

private:
  template <int K>
  void update(const Eigen::SparseMatrix<double>& a, const internal::Block_vector<K>& b,
              internal::Block_vector<K>& x, int j) const {
    internal::Block_row<K> sum = internal::row<K>(b, j);
    internal::subtract_entries<K>(a, a.outerIndexPtr()[j], a.outerIndexPtr()[j + 1], x, sum);
    internal::row<K>(x, j) += sum * m_inverse_diagonal[j];
  }

  std::vector<double> m_inverse_diagonal;
  std::vector<int> m_diagonal_position;
};

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SMOOTHERS_H
