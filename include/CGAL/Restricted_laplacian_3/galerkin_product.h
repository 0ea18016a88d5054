// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_GALERKIN_PRODUCT_H
#define CGAL_RESTRICTED_LAPLACIAN_3_GALERKIN_PRODUCT_H

#include <Eigen/SparseCore>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// The coarse operator \f$P^T A P\f$ of a symmetric matrix \f$A\f$, column by column: with
/// \f$p = P e_j\f$, the sparse vector \f$A p\f$ is accumulated, then \f$P^T (A p)\f$. No product of
/// two matrices is stored. The rows of a column are sorted.
///
/// Takes time proportional to \f$\sum_j\f$ (entries of \f$A\f$ in the columns that column \f$j\f$
/// of \f$P\f$ meets), and the size of the result as memory.
inline Eigen::SparseMatrix<double> galerkin_product(const Eigen::SparseMatrix<double>& a,
                                                    const Eigen::SparseMatrix<double>& p) {
  using Iterator = Eigen::SparseMatrix<double>::InnerIterator;
  const Eigen::SparseMatrix<double> pt = p.transpose();
  const int fine_size = static_cast<int>(p.rows()), coarse_size = static_cast<int>(p.cols());
  std::vector<double> fine(fine_size, 0.), coarse(coarse_size, 0.);
  std::vector<int> fine_seen(fine_size, -1), coarse_seen(coarse_size, -1);
  std::vector<int> fine_rows, coarse_rows, outer(1, 0), inner;
  std::vector<double> values;
  for(int j = 0; j < coarse_size; ++j) {
    fine_rows.clear();
    coarse_rows.clear();
    for(Iterator k(p, j); k; ++k)
      for(Iterator i(a, k.row()); i; ++i) {
        const int row = static_cast<int>(i.row());
        if(fine_seen[row] != j) {
          fine_seen[row] = j;
          fine[row] = 0;
          fine_rows.push_back(row);
        }
        fine[row] += i.value() * k.value();
      }
    for(int row : fine_rows)
      for(Iterator i(pt, row); i; ++i) {
        const int coarse_row = static_cast<int>(i.row());
        if(coarse_seen[coarse_row] != j) {
          coarse_seen[coarse_row] = j;
          coarse[coarse_row] = 0;
          coarse_rows.push_back(coarse_row);
        }
        coarse[coarse_row] += i.value() * fine[row];
      }
    std::sort(coarse_rows.begin(), coarse_rows.end());
    for(int row : coarse_rows) {
      inner.push_back(row);
      values.push_back(coarse[row]);
    }
    outer.push_back(static_cast<int>(inner.size()));
  }
  Eigen::SparseMatrix<double> result(coarse_size, coarse_size);
  result.resizeNonZeros(static_cast<Eigen::Index>(inner.size()));
  std::copy(outer.begin(), outer.end(), result.outerIndexPtr());
  std::copy(inner.begin(), inner.end(), result.innerIndexPtr());
  std::copy(values.begin(), values.end(), result.valuePtr());
  return result;
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_GALERKIN_PRODUCT_H
