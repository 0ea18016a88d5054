// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_GALERKIN_PRODUCT_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_GALERKIN_PRODUCT_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/parallel_for.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Dev
/// The coarse operator \f$P^T A P\f$ of a symmetric matrix \f$A\f$, column by column: with
/// \f$p = P e_j\f$, the sparse vector \f$A p\f$ is accumulated, then \f$P^T (A p)\f$. No product of
/// two matrices is stored. The rows of a column are sorted.
///
/// Takes time proportional to \f$\sum_j\f$ (entries of \f$A\f$ in the columns that column \f$j\f$
/// of \f$P\f$ meets), and the size of the result as memory, twice for a moment.
inline Eigen::SparseMatrix<double> galerkin_product(const Eigen::SparseMatrix<double>& a,
                                                    const Eigen::SparseMatrix<double>& p,
                                                    bool is_parallel = false) {
  using Iterator = Eigen::SparseMatrix<double>::InnerIterator;
  const Eigen::SparseMatrix<double> pt = p.transpose();
  const std::size_t fine_size = static_cast<std::size_t>(p.rows()),
                    coarse_size = static_cast<std::size_t>(p.cols());
  struct Columns {
    std::vector<int> inner;
    std::vector<double> values;
  };
  constexpr std::size_t grain = 2048;
  std::vector<Columns> chunks((coarse_size + grain - 1) / grain);
  Eigen::SparseMatrix<double> result(coarse_size, coarse_size);
  int* outer = result.outerIndexPtr();
  internal::parallel_for(is_parallel, 0, coarse_size, grain,
                         [&](std::size_t begin, std::size_t end) {
                           std::vector<double> fine(fine_size, 0.), coarse(coarse_size, 0.);
                           std::vector<int> fine_rows, coarse_rows, fine_seen(fine_size, -1),
                               coarse_seen(coarse_size, -1);
                           Columns& columns = chunks[begin / grain];
                           for(std::size_t column = begin; column < end; ++column) {
                             const int j = static_cast<int>(column);
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
                               columns.inner.push_back(row);
                               columns.values.push_back(coarse[row]);
                             }
                             outer[j + 1] = static_cast<int>(coarse_rows.size());
                           }
                         });
  for(std::size_t j = 0; j < coarse_size; ++j)
    outer[j + 1] += outer[j];
  result.resizeNonZeros(outer[coarse_size]);
  for(std::size_t chunk = 0; chunk < chunks.size(); ++chunk) {
    const int first = outer[chunk * grain];
    std::copy(chunks[chunk].inner.begin(), chunks[chunk].inner.end(),
              result.innerIndexPtr() + first);
    std::copy(chunks[chunk].values.begin(), chunks[chunk].values.end(), result.valuePtr() + first);
    chunks[chunk] = Columns();
  }
  return result;
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_GALERKIN_PRODUCT_H
