// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_INTERNAL_LEVEL_VECTORS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_INTERNAL_LEVEL_VECTORS_H

#include <CGAL/Restricted_laplacian_3/internal/parallel_for.h>

#include <Eigen/SparseCore>

#include <boost/align/aligned_allocator.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// The numbers of a level inside of a multigrid cycle are in single precision, eight in a row: a
/// vector register of 256 bits.
constexpr int lanes_of_floats = 8;
using Aligned_floats = std::vector<float, boost::alignment::aligned_allocator<float, 64>>;

/// `K` vectors of a level of a hierarchy. Eight consecutive positions of a vector form a cluster;
/// the clusters of the `K` vectors follow each other.
template <int K> class Level_vectors {
public:
  void resize(std::size_t positions) { m_values.resize(K * positions); }
  void set_zero(std::size_t positions) { m_values.assign(K * positions, 0.f); }

  /// cluster `i` of all vectors
  float* cluster(std::size_t i) { return m_values.data() + K * lanes_of_floats * i; }
  const float* cluster(std::size_t i) const { return m_values.data() + K * lanes_of_floats * i; }

  /// place of a position in the first vector; in the next one it is `lanes_of_floats` further
  static std::size_t offset(std::size_t position) {
    return position % lanes_of_floats + position / lanes_of_floats * (K * lanes_of_floats);
  }
  float* data() { return m_values.data(); }
  const float* data() const { return m_values.data(); }
  std::size_t size() const { return m_values.size(); }
  void swap(Level_vectors& other) { m_values.swap(other.m_values); }

private:
  Aligned_floats m_values;
};

/// Where the unknowns of a level are in its vectors. The number of positions is a multiple of
/// eight. A cluster may have less than eight unknowns; they come first in it, and the positions
/// that belong to no unknown hold 0.
struct Level_positions {
  std::vector<std::uint32_t> of_unknown;
  std::size_t number_of_positions = 0;

  std::size_t number_of_clusters() const { return number_of_positions / lanes_of_floats; }
};

/// A sparse matrix in single precision, row by row, between the positions of two levels.
class Row_matrix {
public:
  Row_matrix() : m_first(1, 0) {}

  /// The matrix with row `rows.of_unknown[i]` for each row `i` of `a`, times `row_scale[i]`, and
  /// with its columns placed and scaled likewise.
  static Row_matrix of(const Eigen::SparseMatrix<double>& a, const Level_positions& rows,
                       const std::vector<double>& row_scale, const Level_positions& columns,
                       const std::vector<double>& column_scale) {
    return Row_matrix(a, rows, row_scale, columns, column_scale,
                      [](int i, int /*j*/) { return i; });
  }

  /// the same for the transpose of `a`
  static Row_matrix of_transpose(const Eigen::SparseMatrix<double>& a, const Level_positions& rows,
                                 const std::vector<double>& row_scale,
                                 const Level_positions& columns,
                                 const std::vector<double>& column_scale) {
    return Row_matrix(a, rows, row_scale, columns, column_scale,
                      [](int /*i*/, int j) { return j; });
  }

  /// \f$y = A x\f$, or \f$y = y + A x\f$
  template <int K, bool is_added>
  void multiply(bool is_parallel, const Level_vectors<K>& x, Level_vectors<K>& y) const {
    const std::size_t positions = m_first.size() - 1;
    if(!is_added)
      y.resize(positions);
    constexpr std::size_t grain = 4096;
    parallel_for(is_parallel, 0, positions, grain, [&](std::size_t begin, std::size_t end) {
      for(std::size_t i = begin; i < end; ++i) {
        float* to = y.data() + Level_vectors<K>::offset(i);
        const std::array<float, K> sum = row_product<K>(i, x);
        for(int c = 0; c < K; ++c)
          to[lanes_of_floats * c] = is_added ? to[lanes_of_floats * c] + sum[c] : sum[c];
      }
    });
  }

  /// row `i` times `x`
  template <int K>
  std::array<float, K> row_product(std::size_t i, const Level_vectors<K>& x) const {
    std::array<float, K> sum = {};
    for(std::size_t k = m_first[i]; k < m_first[i + 1]; ++k) {
      const float* from = x.data() + Level_vectors<K>::offset(m_entries[k].column);
      for(int c = 0; c < K; ++c)
        sum[c] += m_entries[k].value * from[lanes_of_floats * c];
    }
    return sum;
  }

private:
  struct Entry {
    std::uint32_t column;
    float value;
  };

  /// \param row whether an entry (i, j) of `a` goes to row i or j
  template <class Row>
  Row_matrix(const Eigen::SparseMatrix<double>& a, const Level_positions& rows,
             const std::vector<double>& row_scale, const Level_positions& columns,
             const std::vector<double>& column_scale, Row&& row)
    : m_first(rows.number_of_positions + 1, 0) {
    const auto for_each_entry = [&](auto&& visit) {
      for(int j = 0; j < a.cols(); ++j)
        for(Eigen::SparseMatrix<double>::InnerIterator k(a, j); k; ++k) {
          const int i = static_cast<int>(k.row());
          visit(row(i, j), row(j, i), k.value());
        }
    };
    // Ends are counted down to beginnings while the rows are filled from their ends.
    for_each_entry([&](int i, int, double) { ++m_first[rows.of_unknown[i]]; });
    for(std::size_t i = 0; i < rows.number_of_positions; ++i)
      m_first[i + 1] += m_first[i];
    m_entries.resize(m_first.back());
    for_each_entry([&](int i, int j, double value) {
      m_entries[--m_first[rows.of_unknown[i]]] = {
          columns.of_unknown[j], static_cast<float>(row_scale[i] * value * column_scale[j])};
    });
  }

  std::vector<std::uint32_t> m_first;
  std::vector<Entry> m_entries;
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_INTERNAL_LEVEL_VECTORS_H
