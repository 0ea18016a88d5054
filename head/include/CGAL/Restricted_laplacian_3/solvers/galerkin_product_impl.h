// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_GALERKIN_PRODUCT_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_GALERKIN_PRODUCT_IMPL_H

#include <CGAL/Restricted_laplacian_3/solvers/galerkin_product.h>

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Object_pool.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parallel_for.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/sum_counts.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Sparse_matrix galerkin_product(const Sparse_matrix& a,
                                                                  const Sparse_matrix& p,
                                                                  bool is_parallel) {
  using Iterator = Sparse_matrix::InnerIterator;
  if(a.rows() != a.cols() || p.rows() != a.cols())
    throw Parameter_error("p", "does not fit the size of the matrix");
  const Sparse_matrix pt = p.transpose();
  const std::size_t coarse_size = static_cast<std::size_t>(p.cols());
  struct Columns {
    std::vector<int> inner;
    std::vector<double> values;
  };
  // A sparse vector: numbers of any size, those of the rows that the current column has seen.
  struct Accumulator {
    std::vector<double> values;
    std::vector<int> seen; // the last column
    std::vector<int> rows;

    explicit Accumulator(std::size_t size) : values(size), seen(size, -1) {}
    void add(int column, int row, double value) {
      if(seen[row] != column) {
        seen[row] = column;
        values[row] = 0;
        rows.push_back(row);
      }
      values[row] += value;
    }
  };
  using Accumulators = std::pair<Accumulator, Accumulator>; // fine, coarse
  internal::Object_pool<Accumulators> pool;
  constexpr std::size_t grain = 2048;
  std::vector<Columns> chunks((coarse_size + grain - 1) / grain);
  Sparse_matrix result(p.cols(), p.cols());
  int* const outer = result.outerIndexPtr();
  const auto multiply = [&](std::size_t begin, std::size_t end, Accumulators& accumulators) {
    auto& [fine, coarse] = accumulators;
    Columns& columns = chunks[begin / grain];
    for(int j = static_cast<int>(begin); j < static_cast<int>(end); ++j) {
      fine.rows.clear();
      for(Iterator k(p, j); k; ++k)
        for(Iterator i(a, static_cast<int>(k.row())); i; ++i)
          fine.add(j, static_cast<int>(i.row()), i.value() * k.value());
      coarse.rows.clear();
      for(int row : fine.rows)
        for(Iterator i(pt, row); i; ++i)
          coarse.add(j, static_cast<int>(i.row()), i.value() * fine.values[row]);
      std::sort(coarse.rows.begin(), coarse.rows.end());
      for(int row : coarse.rows) {
        columns.inner.push_back(row);
        columns.values.push_back(coarse.values[row]);
      }
      outer[j + 1] = static_cast<int>(coarse.rows.size());
    }
  };
  internal::parallel_for(
      is_parallel, 0, coarse_size, grain, [&](std::size_t begin, std::size_t end) {
        pool.borrow([&] { return Accumulators(static_cast<std::size_t>(p.rows()), coarse_size); },
                    [&](Accumulators& own) { multiply(begin, end, own); });
      });
  result.resizeNonZeros(internal::sum_counts(outer + 1, coarse_size, "a", "Galerkin product"));
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

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_GALERKIN_PRODUCT_IMPL_H
