// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_SHARED_SYMMETRIC_MATRIX_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_SHARED_SYMMETRIC_MATRIX_H

#include <CGAL/Restricted_laplacian_3/foundation/Sparse_matrix.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parallel_for.h>
#include <CGAL/Restricted_laplacian_3/solvers/internal/symmetric_halves.h>
#include <CGAL/Restricted_laplacian_3/solvers/shared/block_vectors.h>
#include <CGAL/Restricted_laplacian_3/solvers/shared/panel_kernels.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// A symmetric sparse matrix of which the entries on and above the diagonal are stored: half the
/// memory, and half of what a product has to read.
///
/// *Threads.* An entry \f$(i, j)\f$ adds to rows \f$i\f$ and \f$j\f$ of a product. The columns are
/// cut into a few parts. A part writes the rows that have the numbers of its columns; what it adds
/// to the rows of earlier parts goes into a vector of its own, and is added in the order of the
/// parts. So results are the same for any number of threads.
class Symmetric_matrix {
public:
  /// Takes the half of a symmetric matrix, with the rows of a column sorted; it is empty
  /// afterwards. If there are entries below the diagonal, the half exists beside the whole for a
  /// moment.
  void take_half_of(Sparse_matrix& a) {
    a.makeCompressed();
    Sparse_matrix upper(a.rows(), a.cols());
    int* const firsts = upper.outerIndexPtr();
    for(int j = 0; j < a.cols(); ++j)
      firsts[j + 1] = firsts[j] + number_above(a, j);
    if(firsts[a.cols()] == a.nonZeros())
      upper.swap(a);
    else {
      upper.resizeNonZeros(firsts[a.cols()]);
      for(int j = 0; j < a.cols(); ++j) {
        const int from = a.outerIndexPtr()[j], number = firsts[j + 1] - firsts[j];
        std::copy_n(a.innerIndexPtr() + from, number, upper.innerIndexPtr() + firsts[j]);
        std::copy_n(a.valuePtr() + from, number, upper.valuePtr() + firsts[j]);
      }
    }
    Sparse_matrix().swap(a);
    m_upper.swap(upper);
    m_parts.clear();
    const std::size_t columns = static_cast<std::size_t>(m_upper.cols());
    const std::size_t width =
        (std::max)((columns + number_of_parts - 1) / number_of_parts, std::size_t(1024));
    for(std::size_t begin = 0; begin < columns; begin += width) {
      Part part = {begin, (std::min)(begin + width, columns), begin};
      for(std::size_t j = part.begin; j < part.end; ++j)
        if(outer(j) < outer(j + 1))
          part.first_row = (std::min)(part.first_row,
                                      static_cast<std::size_t>(m_upper.innerIndexPtr()[outer(j)]));
      m_parts.push_back(part);
    }
  }

  void swap(Symmetric_matrix& other) {
    m_upper.swap(other.m_upper);
    m_parts.swap(other.m_parts);
  }

  Eigen::Index rows() const { return m_upper.rows(); }
  const Sparse_matrix& upper_half() const { return m_upper; }

  /// \f$ y = A x \f$
  template <int K>
  void multiply(const Block_vector<K>& x, Block_vector<K>& y, bool is_parallel) const {
    CGAL_precondition(x.rows() == rows());
    y.resize(rows(), K);
    std::vector<Block_vector<K>> earlier_rows(m_parts.size());
    parallel_for(is_parallel, 0, m_parts.size(), 1, [&](std::size_t number, std::size_t) {
      multiply_part<K>(m_parts[number], x, y, earlier_rows[number]);
    });
    parallel_for(is_parallel, 0, static_cast<std::size_t>(rows()), rows_of_a_task,
                 [&](std::size_t begin, std::size_t end) {
                   for(std::size_t k = 0; k < m_parts.size(); ++k) {
                     const std::size_t first = (std::max)(begin, m_parts[k].first_row),
                                       last = (std::min)(end, m_parts[k].begin);
                     for(std::size_t i = first; i < last; ++i)
                       row<K>(y, i) += row<K>(earlier_rows[k], i - m_parts[k].first_row);
                   }
                 });
  }

  /// \f$ r = b - A x \f$
  template <int K>
  void residual(const Block_vector<K>& b, const Block_vector<K>& x, Block_vector<K>& r,
                bool is_parallel) const {
    multiply<K>(x, r, is_parallel);
    r = b - r;
  }

private:
  static constexpr std::size_t number_of_parts = 8;
  static constexpr std::size_t rows_of_a_task = 2048;

  /// a range of columns, and the first of the rows that they reach; the last one is the last column
  struct Part {
    std::size_t begin, end, first_row;
  };

  int outer(std::size_t column) const { return m_upper.outerIndexPtr()[column]; }

  /// The product of the entries in some columns, and of their mirror images: to the rows of `y`
  /// with the same numbers, and to `earlier_rows`, from `first_row` on.
  template <int K>
  void multiply_part(const Part& part, const Block_vector<K>& x, Block_vector<K>& y,
                     Block_vector<K>& earlier_rows) const {
    earlier_rows = Block_vector<K>::Zero(static_cast<Eigen::Index>(part.begin - part.first_row), K);
    const double* const values = m_upper.valuePtr();
    const int* const inner = m_upper.innerIndexPtr();
    for(std::size_t j = part.begin; j < part.end; ++j) {
      const int first = outer(j);
      int end = outer(j + 1);
      const Block_row<K> x_j = row<K>(x, j);
      Block_row<K> sum = Block_row<K>::Zero();
      if(end > first && static_cast<std::size_t>(inner[end - 1]) == j)
        sum = values[--end] * x_j;
      int own = first;
      while(own < end && static_cast<std::size_t>(inner[own]) < part.begin)
        ++own;
      add_symmetric_column<K>(values + first, inner + first, static_cast<std::size_t>(own - first),
                              x.data(), x_j.data(), earlier_rows.data(), part.first_row,
                              sum.data());
      add_symmetric_column<K>(values + own, inner + own, static_cast<std::size_t>(end - own),
                              x.data(), x_j.data(), y.data(), 0, sum.data());
      row<K>(y, j) = sum;
    }
  }

  Sparse_matrix m_upper;
  std::vector<Part> m_parts;
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_SHARED_SYMMETRIC_MATRIX_H
