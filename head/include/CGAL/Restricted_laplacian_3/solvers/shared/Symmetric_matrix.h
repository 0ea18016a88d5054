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
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// `N` symmetric sparse matrices with entries in the same places, of which those on and above the
/// diagonal are stored: half the memory, and half of what a product has to read.
///
/// *Threads.* An entry \f$(i, j)\f$ adds to rows \f$i\f$ and \f$j\f$ of a product. The columns are
/// cut into a few parts. A part writes the rows that have the numbers of its columns; what it adds
/// to the rows of earlier parts goes into a vector of its own, and is added in the order of the
/// parts. So results are the same for any number of threads.
template <int N> class Symmetric_matrices {
public:
  /// Takes the halves of symmetric matrices, with the rows of a column sorted; they are empty
  /// afterwards. If there are entries below the diagonal, a half exists beside the whole for a
  /// moment.
  void take_halves_of(std::array<Sparse_matrix*, N> matrices) {
    for(Sparse_matrix* a : matrices)
      keep_upper_half(*a);
    if(!have_one_pattern(matrices))
      merge_patterns(matrices);
    m_first.swap(*matrices[0]);
    for(std::size_t n = 1; n < N; ++n) {
      const Sparse_matrix& a = *matrices[n];
      m_others[n - 1].assign(a.valuePtr(), a.valuePtr() + a.nonZeros());
    }
    for(Sparse_matrix* a : matrices)
      Sparse_matrix().swap(*a);
    m_parts.clear();
    const std::size_t columns = static_cast<std::size_t>(m_first.cols());
    const std::size_t width =
        (std::max)((columns + number_of_parts - 1) / number_of_parts, std::size_t(1024));
    for(std::size_t begin = 0; begin < columns; begin += width) {
      Part part = {begin, (std::min)(begin + width, columns), begin};
      for(std::size_t j = part.begin; j < part.end; ++j)
        if(outer(j) < outer(j + 1))
          part.first_row = (std::min)(part.first_row,
                                      static_cast<std::size_t>(m_first.innerIndexPtr()[outer(j)]));
      m_parts.push_back(part);
    }
  }

  void swap(Symmetric_matrices& other) {
    m_first.swap(other.m_first);
    m_others.swap(other.m_others);
    m_parts.swap(other.m_parts);
  }

  Eigen::Index rows() const { return m_first.rows(); }

  /// \f$ y_n = A_n x \f$, all of them in one pass over the places of the entries
  template <int K>
  void multiply(const Block_vector<K>& x, std::array<Block_vector<K>*, N> y,
                bool is_parallel) const {
    CGAL_precondition(x.rows() == rows());
    for(Block_vector<K>* product : y)
      product->resize(rows(), K);
    std::vector<std::array<Block_vector<K>, N>> earlier_rows(m_parts.size());
    parallel_for(is_parallel, 0, m_parts.size(), 1, [&](std::size_t number, std::size_t) {
      multiply_part<K>(m_parts[number], x, y, earlier_rows[number]);
    });
    parallel_for(is_parallel, 0, static_cast<std::size_t>(rows()), rows_of_a_task,
                 [&](std::size_t begin, std::size_t end) {
                   for(std::size_t k = 0; k < m_parts.size(); ++k) {
                     const std::size_t first = (std::max)(begin, m_parts[k].first_row),
                                       last = (std::min)(end, m_parts[k].begin);
                     for(std::size_t n = 0; n < N; ++n)
                       for(std::size_t i = first; i < last; ++i)
                         row<K>(*y[n], i) += row<K>(earlier_rows[k][n], i - m_parts[k].first_row);
                   }
                 });
  }

protected:
  const Sparse_matrix& first_half() const { return m_first; }

private:
  static constexpr std::size_t number_of_parts = 8;
  static constexpr std::size_t rows_of_a_task = 2048;

  /// a range of columns, and the first of the rows that they reach; the last one is the last column
  struct Part {
    std::size_t begin, end, first_row;
  };

  static void keep_upper_half(Sparse_matrix& a) {
    a.makeCompressed();
    Sparse_matrix upper(a.rows(), a.cols());
    int* const firsts = upper.outerIndexPtr();
    for(int j = 0; j < a.cols(); ++j)
      firsts[j + 1] = firsts[j] + number_above(a, j);
    if(firsts[a.cols()] == a.nonZeros())
      return;
    upper.resizeNonZeros(firsts[a.cols()]);
    for(int j = 0; j < a.cols(); ++j) {
      const int from = a.outerIndexPtr()[j], number = firsts[j + 1] - firsts[j];
      std::copy_n(a.innerIndexPtr() + from, number, upper.innerIndexPtr() + firsts[j]);
      std::copy_n(a.valuePtr() + from, number, upper.valuePtr() + firsts[j]);
    }
    a.swap(upper);
  }

  static bool have_one_pattern(const std::array<Sparse_matrix*, N>& matrices) {
    const Sparse_matrix& first = *matrices[0];
    return std::all_of(matrices.begin(), matrices.end(), [&first](const Sparse_matrix* a) {
      CGAL_precondition(a->rows() == first.rows() && a->cols() == first.cols());
      return a->nonZeros() == first.nonZeros() &&
             std::equal(a->outerIndexPtr(), a->outerIndexPtr() + a->cols() + 1,
                        first.outerIndexPtr()) &&
             std::equal(a->innerIndexPtr(), a->innerIndexPtr() + a->nonZeros(),
                        first.innerIndexPtr());
    });
  }

  /// gives each matrix zeros where others have entries
  static void merge_patterns(const std::array<Sparse_matrix*, N>& matrices) {
    Sparse_matrix zeros(matrices[0]->rows(), matrices[0]->cols());
    for(const Sparse_matrix* a : matrices)
      zeros = Sparse_matrix(zeros + 0 * *a);
    for(Sparse_matrix* a : matrices)
      *a = Sparse_matrix(*a + zeros);
  }

  int outer(std::size_t column) const { return m_first.outerIndexPtr()[column]; }
  const double* values(std::size_t n) const {
    return n == 0 ? m_first.valuePtr() : m_others[n - 1].data();
  }

  /// The products of the entries in some columns, and of their mirror images: to the rows of `y`
  /// with the same numbers, and to `earlier_rows`, from `first_row` on.
  template <int K>
  void multiply_part(const Part& part, const Block_vector<K>& x,
                     const std::array<Block_vector<K>*, N>& y,
                     std::array<Block_vector<K>, N>& earlier_rows) const {
    std::array<double*, N> to, to_earlier;
    for(std::size_t n = 0; n < N; ++n) {
      earlier_rows[n] =
          Block_vector<K>::Zero(static_cast<Eigen::Index>(part.begin - part.first_row), K);
      to[n] = y[n]->data();
      to_earlier[n] = earlier_rows[n].data();
    }
    const int* const inner = m_first.innerIndexPtr();
    for(std::size_t j = part.begin; j < part.end; ++j) {
      const int first = outer(j);
      int end = outer(j + 1);
      const Block_row<K> x_j = row<K>(x, j);
      const bool has_diagonal = end > first && static_cast<std::size_t>(inner[end - 1]) == j;
      end -= has_diagonal;
      int own = first;
      while(own < end && static_cast<std::size_t>(inner[own]) < part.begin)
        ++own;
      double sums[N * K];
      std::array<const double*, N> of_earlier, of_own;
      for(std::size_t n = 0; n < N; ++n) {
        Eigen::Map<Block_row<K>>(sums + K * n) = (has_diagonal ? values(n)[end] : 0.) * x_j;
        of_earlier[n] = values(n) + first;
        of_own[n] = values(n) + own;
      }
      const Column_entries earlier = {of_earlier.data(), inner + first,
                                      static_cast<std::size_t>(own - first)},
                           later = {of_own.data(), inner + own,
                                    static_cast<std::size_t>(end - own)};
      add_symmetric_column<K, N>(earlier, x.data(), x_j.data(), to_earlier.data(), part.first_row,
                                 sums);
      add_symmetric_column<K, N>(later, x.data(), x_j.data(), to.data(), 0, sums);
      for(std::size_t n = 0; n < N; ++n)
        row<K>(*y[n], j) = Eigen::Map<const Block_row<K>>(sums + K * n);
    }
  }

  Sparse_matrix m_first;                           // the half of the first matrix
  std::array<std::vector<double>, N - 1> m_others; // values of the other ones
  std::vector<Part> m_parts;
};

/// one of them
class Symmetric_matrix : public Symmetric_matrices<1> {
public:
  /// see `take_halves_of()`
  void take_half_of(Sparse_matrix& a) { take_halves_of({&a}); }

  const Sparse_matrix& upper_half() const { return first_half(); }

  /// \f$ y = A x \f$
  template <int K>
  void multiply(const Block_vector<K>& x, Block_vector<K>& y, bool is_parallel) const {
    Symmetric_matrices<1>::multiply<K>(x, {&y}, is_parallel);
  }

  /// \f$ r = b - A x \f$
  template <int K>
  void residual(const Block_vector<K>& b, const Block_vector<K>& x, Block_vector<K>& r,
                bool is_parallel) const {
    multiply<K>(x, r, is_parallel);
    r = b - r;
  }
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_SHARED_SYMMETRIC_MATRIX_H
