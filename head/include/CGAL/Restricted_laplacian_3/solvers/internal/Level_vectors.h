// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_INTERNAL_LEVEL_VECTORS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_INTERNAL_LEVEL_VECTORS_H

#include <CGAL/Restricted_laplacian_3/foundation/Sparse_matrix.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parallel_for.h>
#include <CGAL/Restricted_laplacian_3/solvers/internal/block_kernels.h>

#include <CGAL/assertions.h>

#include <boost/align/aligned_allocator.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// The numbers of a level inside of a multigrid cycle are in single precision, eight in a row: a
/// vector register of 256 bits.
constexpr int lanes_of_floats = 8;
/// The number of vectors that cycles are applied to at once, where there are several: one for each
/// lane.
constexpr int vectors_of_a_block = lanes_of_floats;
using Aligned_floats = std::vector<float, boost::alignment::aligned_allocator<float, 64>>;

/// `K` vectors of a level of a hierarchy, side by side, in single precision: the `K` numbers of a
/// position follow each other. `K` is 1 or 8; with 8 a position fills a vector register. Eight
/// consecutive positions form a *cluster*.
template <int K> class Level_vectors {
public:
  /// makes room for so many positions; their values are undefined
  void resize(std::size_t positions) { m_values.resize(K * positions); }
  /// makes room for so many positions, all 0
  void set_zero(std::size_t positions) { m_values.assign(K * positions, 0.f); }

  /// the `K` numbers of position `i`
  float* position(std::size_t i) { return m_values.data() + K * i; }
  const float* position(std::size_t i) const { return m_values.data() + K * i; }
  /// the `8 * K` numbers of cluster `i`
  float* cluster(std::size_t i) { return position(lanes_of_floats * i); }
  const float* cluster(std::size_t i) const { return position(lanes_of_floats * i); }

  /// all numbers, `size()` of them
  float* data() { return m_values.data(); }
  const float* data() const { return m_values.data(); }
  /// `K` times the number of positions
  std::size_t size() const { return m_values.size(); }
  /// exchanges the contents in constant time
  void swap(Level_vectors& other) { m_values.swap(other.m_values); }

private:
  Aligned_floats m_values;
};

/// Where the unknowns of a level are in its vectors. The number of positions is a multiple of
/// eight. A cluster may have less than eight unknowns; they come first in it, and what is at the
/// positions that belong to no unknown has no meaning: nothing may depend on it.
struct Level_positions {
  /// the position of each unknown, all different
  std::vector<std::uint32_t> of_unknown;
  /// a multiple of 8
  std::size_t number_of_positions = 0;

  /// a cluster has eight positions
  std::size_t number_of_clusters() const { return number_of_positions / lanes_of_floats; }

  /// unknowns 0, 1, 2, ... at the positions 0, 1, 2, ...
  static Level_positions consecutive(std::size_t number_of_unknowns) {
    constexpr std::size_t lanes = lanes_of_floats;
    Level_positions positions;
    positions.of_unknown.resize(number_of_unknowns);
    std::iota(positions.of_unknown.begin(), positions.of_unknown.end(), 0u);
    positions.number_of_positions = (number_of_unknowns + lanes - 1) / lanes * lanes;
    return positions;
  }
};

/// Powers of two \f$d_i\f$ with \f$1/2 \le d_i^2 A_{ii} \le 2\f$, so that \f$D A D\f$ fits into
/// single precision, also where elements hardly reach the surface. A diagonal entry below 1e-30 of
/// the largest, which has no significant digit left beside it, counts as one of that size: scaled
/// prolongations would leave the range of numbers otherwise.
inline std::vector<double> balancing_scale(const Sparse_matrix& a) {
  const Eigen::VectorXd diagonal = a.diagonal();
  const double largest = diagonal.size() > 0 ? diagonal.maxCoeff() : 0;
  std::vector<double> scale(static_cast<std::size_t>(diagonal.size()), 1.);
  if(!(largest > 0))
    return scale;
  for(Eigen::Index i = 0; i < diagonal.size(); ++i) {
    const double entry = (std::max)(diagonal[i], 1e-30 * largest);
    scale[i] = std::ldexp(1., -static_cast<int>(std::lround(std::log2(entry) / 2)));
  }
  return scale;
}

/// A sparse matrix in single precision, row by row, between the positions of two levels, or of one.
class Level_matrix {
public:
  /// no rows
  Level_matrix() : m_first(1, 0) {}

  /// The matrix with row `rows.of_unknown[i]` for each row `i` of `a`, times `row_scale[i]`, and
  /// with its columns placed and scaled likewise.
  static Level_matrix of(const Sparse_matrix& a, const Level_positions& rows,
                         const std::vector<double>& row_scale, const Level_positions& columns,
                         const std::vector<double>& column_scale) {
    return Level_matrix(rows, row_scale, columns, column_scale, [&a](auto&& visit) {
      for_each_entry(a, [&visit](int i, int j, double value) { visit(i, j, value); });
    });
  }

  /// the same for the transpose of `a`
  static Level_matrix of_transpose(const Sparse_matrix& a, const Level_positions& rows,
                                   const std::vector<double>& row_scale,
                                   const Level_positions& columns,
                                   const std::vector<double>& column_scale) {
    return Level_matrix(rows, row_scale, columns, column_scale, [&a](auto&& visit) {
      for_each_entry(a, [&visit](int i, int j, double value) { visit(j, i, value); });
    });
  }

  /// The same for a symmetric matrix, of which the entries on and above the diagonal are read.
  static Level_matrix of_symmetric(const Sparse_matrix& a, const Level_positions& positions,
                                   const std::vector<double>& scale) {
    return Level_matrix(positions, scale, positions, scale, [&a](auto&& visit) {
      for_each_entry(a, [&visit](int i, int j, double value) {
        if(i <= j)
          visit(i, j, value);
        if(i < j)
          visit(j, i, value);
      });
    });
  }

  /// \f$y = A x\f$, or \f$y = y + A x\f$
  template <int K, bool is_added>
  void multiply(bool is_parallel, const Level_vectors<K>& x, Level_vectors<K>& y) const {
    const std::size_t positions = m_first.size() - 1;
    if(!is_added)
      y.resize(positions);
    CGAL_precondition(y.size() == K * positions);
    constexpr std::size_t grain = 4096;
    parallel_for(is_parallel, 0, positions, grain, [&](std::size_t begin, std::size_t end) {
      for(std::size_t i = begin; i < end; ++i) {
        float* to = y.position(i);
        if(!is_added)
          std::fill(to, to + K, 0.f);
        add_row_product<K>(i, 1, x, to);
      }
    });
  }

  /// adds row `i` times `x`, times a factor, to `K` numbers
  template <int K>
  void add_row_product(std::size_t i, float factor, const Level_vectors<K>& x, float* to) const {
    add_products<K>(m_entries.data() + m_first[i], m_first[i + 1] - m_first[i], factor, x.data(),
                    to);
  }

private:
  /// calls `visit(i, j, value)` column by column, also for a matrix that is not compressed
  template <class Visitor> static void for_each_entry(const Sparse_matrix& a, Visitor&& visit) {
    for(int j = 0; j < a.cols(); ++j)
      for(Sparse_matrix::InnerIterator k(a, j); k; ++k)
        visit(static_cast<int>(k.row()), j, k.value());
  }

  /// \param for_each calls its argument for all entries
  template <class For_each>
  Level_matrix(const Level_positions& rows, const std::vector<double>& row_scale,
               const Level_positions& columns, const std::vector<double>& column_scale,
               For_each&& for_each)
    : m_first(rows.number_of_positions + 1, 0) {
    // Ends are counted down to beginnings while the rows are filled from their ends.
    for_each([&](int i, int, double) { ++m_first[rows.of_unknown[i]]; });
    for(std::size_t i = 0; i < rows.number_of_positions; ++i)
      m_first[i + 1] += m_first[i];
    m_entries.resize(m_first.back());
    for_each([&](int i, int j, double value) {
      m_entries[--m_first[rows.of_unknown[i]]] = {
          columns.of_unknown[j], static_cast<float>(row_scale[i] * value * column_scale[j])};
    });
  }

  std::vector<std::uint32_t> m_first;
  std::vector<Row_entry> m_entries;
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_INTERNAL_LEVEL_VECTORS_H
