// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_INTERNAL_CLUSTER_MATRIX_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_INTERNAL_CLUSTER_MATRIX_H

#include <CGAL/Restricted_laplacian_3/foundation/Sparse_matrix.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Object_pool.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parallel_for.h>
#include <CGAL/Restricted_laplacian_3/solvers/internal/Level_vectors.h>
#include <CGAL/Restricted_laplacian_3/solvers/internal/Symmetric_rows.h>
#include <CGAL/Restricted_laplacian_3/solvers/internal/block_kernels.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// A symmetric sparse matrix in single precision. The eight rows of a cluster share one list of the
/// columns in which any of them has an entry, with a number of each row for each.
///
/// Restricted splines of neighboring cells act on the same sheets, so their rows have most of
/// their columns in common: with clusters of neighbors two thirds of these numbers are entries of
/// the matrix, and what is read of a vector serves eight rows.
class Cluster_matrix {
public:
  Cluster_matrix() : m_first(1, 0), m_first_values(1, 0) {}

  /// \param a a symmetric matrix, of which the entries on and above the diagonal are read
  /// \param scale the matrix becomes \f$D A D\f$ with this diagonal matrix \f$D\f$
  /// \param room what may be written to meanwhile
  Cluster_matrix(bool is_parallel, const Sparse_matrix& a, const Level_positions& positions,
                 const std::vector<double>& scale, Scratch_memory* room = nullptr) {
    const Source source(a, positions, scale, room);
    const std::size_t clusters = positions.number_of_clusters();
    m_cluster_sizes.assign(clusters, 0);
    for(std::uint32_t position : positions.of_unknown)
      ++m_cluster_sizes[position / lanes_of_floats];
    // calls work(i, numbers) for all clusters, with a number for each position that is kept
    Object_pool<Numbers> pool;
    const auto for_each_cluster = [&](auto&& work) {
      parallel_for(is_parallel, 0, clusters, grain, [&](std::size_t begin, std::size_t end) {
        pool.borrow([&] { return Numbers(positions.number_of_positions, none); },
                    [&](Numbers& numbers) {
                      for(std::size_t i = begin; i < end; ++i)
                        work(i, numbers);
                    });
      });
    };
    std::vector<Numbers> chunks((clusters + grain - 1) / grain);
    m_first.assign(clusters + 1, 0);
    for_each_cluster([&](std::size_t i, Numbers& last_seen) {
      m_first[i + 1] = add_columns(i, source, last_seen, chunks[i / grain]);
    });
    m_first_values.assign(clusters + 1, 0);
    for(std::size_t i = 0; i < clusters; ++i) {
      m_first_values[i + 1] = m_first_values[i] + m_cluster_sizes[i] * m_first[i + 1];
      m_first[i + 1] += m_first[i];
    }
    m_columns.reserve(m_first.back());
    for(Numbers& columns : chunks) {
      m_columns.insert(m_columns.end(), columns.begin(), columns.end());
      Numbers().swap(columns);
    }
    // Products read eight numbers at a time.
    m_values.assign(m_first_values.back() + lanes_of_floats - 1, 0.f);
    for_each_cluster(
        [&](std::size_t i, Numbers& number_of_column) { set_values(i, source, number_of_column); });
  }

  std::size_t number_of_clusters() const { return m_first.size() - 1; }

  /// Calls `visit(column, values)` with the position of each column that the rows of a cluster
  /// have, and their numbers in it.
  template <class Visitor> void for_each_column(std::size_t cluster, Visitor&& visit) const {
    const float* values = m_values.data() + m_first_values[cluster];
    for(std::size_t k = m_first[cluster]; k < m_first[cluster + 1]; ++k) {
      visit(m_columns[k], values);
      values += m_cluster_sizes[cluster];
    }
  }

  /// subtracts the rows of cluster `i`, times `x`, from a cluster of `K` vectors
  template <int K> void subtract_rows(std::size_t i, const Level_vectors<K>& x, float* sum) const {
    subtract_columns<K>(m_values.data() + m_first_values[i], m_columns.data() + m_first[i],
                        m_first[i + 1] - m_first[i], m_cluster_sizes[i], x.data(), sum);
  }

  /// \f$r = b - A x\f$
  template <int K>
  void residual(bool is_parallel, const Level_vectors<K>& b, const Level_vectors<K>& x,
                Level_vectors<K>& r) const {
    r.resize(lanes_of_floats * number_of_clusters());
    constexpr std::size_t grain = 512;
    parallel_for(is_parallel, 0, number_of_clusters(), grain,
                 [&](std::size_t begin, std::size_t end) {
                   for(std::size_t i = begin; i < end; ++i) {
                     std::copy(b.cluster(i), b.cluster(i) + lanes_of_floats * K, r.cluster(i));
                     subtract_rows<K>(i, x, r.cluster(i));
                   }
                 });
  }

private:
  using Numbers = std::vector<std::uint32_t>;
  static constexpr std::uint32_t none = (std::numeric_limits<std::uint32_t>::max)();
  static constexpr std::size_t grain = 2048; // clusters

  /// the scaled matrix, row by row, in the order of the positions
  class Source {
  public:
    Source(const Sparse_matrix& a, const Level_positions& positions,
           const std::vector<double>& scale, Scratch_memory* room)
      : m_rows(a, room), m_positions(positions.of_unknown), m_scale(scale),
        m_unknowns(positions.number_of_positions, -1) {
      for(std::size_t i = 0; i < m_positions.size(); ++i)
        m_unknowns[m_positions[i]] = static_cast<int>(i);
    }

    /// Calls `visit(position of the column, value)` for all entries of a row.
    template <class Visitor> void for_each_entry(std::size_t position, Visitor&& visit) const {
      const int row = m_unknowns[position];
      m_rows.for_each_entry(row, [&](int column, double value) {
        visit(m_positions[column], m_scale[row] * value * m_scale[column]);
      });
    }

  private:
    Symmetric_rows m_rows;
    const std::vector<std::uint32_t>& m_positions;
    const std::vector<double>& m_scale;
    std::vector<int> m_unknowns; // at each position
  };

  /// Appends the columns of cluster `i`, ascending.
  /// \param last_seen the last cluster, not `i`, with an entry at each position
  std::size_t add_columns(std::size_t i, const Source& source, Numbers& last_seen,
                          Numbers& columns) const {
    const std::size_t before = columns.size();
    for(std::size_t lane = 0; lane < m_cluster_sizes[i]; ++lane)
      source.for_each_entry(lanes_of_floats * i + lane, [&](std::uint32_t column, double) {
        if(last_seen[column] != i)
          columns.push_back(column);
        last_seen[column] = static_cast<std::uint32_t>(i);
      });
    std::sort(columns.begin() + static_cast<std::ptrdiff_t>(before), columns.end());
    return columns.size() - before;
  }

  /// \param number_of_column room for a number for each position
  void set_values(std::size_t i, const Source& source, Numbers& number_of_column) {
    for(std::size_t k = m_first[i]; k < m_first[i + 1]; ++k)
      number_of_column[m_columns[k]] = static_cast<std::uint32_t>(k - m_first[i]);
    float* const values = m_values.data() + m_first_values[i];
    const std::size_t size = m_cluster_sizes[i];
    for(std::size_t lane = 0; lane < size; ++lane)
      source.for_each_entry(lanes_of_floats * i + lane, [&](std::uint32_t column, double value) {
        values[size * number_of_column[column] + lane] = static_cast<float>(value);
      });
  }

  std::vector<std::uint8_t> m_cluster_sizes; // number of unknowns
  std::vector<std::size_t> m_first;          // column of each cluster, and one more
  std::vector<std::size_t> m_first_values;   // of each cluster, and one more
  std::vector<std::uint32_t> m_columns;
  Aligned_floats m_values;
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_INTERNAL_CLUSTER_MATRIX_H
