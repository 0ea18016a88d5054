// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_INTERNAL_CLUSTER_MATRIX_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_INTERNAL_CLUSTER_MATRIX_H

#include <CGAL/Restricted_laplacian_3/foundation/Sparse_matrix.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parallel_for.h>
#include <CGAL/Restricted_laplacian_3/solvers/internal/Level_vectors.h>
#include <CGAL/Restricted_laplacian_3/solvers/internal/Object_pool.h>
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
/// Restricted splines of neighbouring cells act on the same sheets, so their rows have most of
/// their columns in common: with clusters of neighbours two thirds of these numbers are entries of
/// the matrix, and what is read of a vector serves eight rows.
class Cluster_matrix {
public:
  Cluster_matrix() : m_first(1, 0), m_first_values(1, 0) {}

  /// \param a a symmetric matrix, of which the entries on and above the diagonal are read
  /// \param scale the matrix becomes \f$D A D\f$ with this diagonal matrix \f$D\f$
  /// \param room what may be written to meanwhile
  Cluster_matrix(bool is_parallel, const Sparse_matrix& a, const Level_positions& positions,
                 const std::vector<double>& scale, Aligned_room* room = nullptr) {
    const Symmetric_rows rows(a, room);
    const std::size_t clusters = positions.number_of_clusters();
    std::vector<int> unknowns(positions.number_of_positions, -1);
    m_cluster_sizes.assign(clusters, 0);
    for(std::size_t i = 0; i < positions.of_unknown.size(); ++i) {
      unknowns[positions.of_unknown[i]] = static_cast<int>(i);
      ++m_cluster_sizes[positions.of_unknown[i] / lanes_of_floats];
    }
    // calls visit(lane, position of the column, value) for all entries in the rows of cluster i
    const auto for_each_entry = [&](std::size_t i, auto&& visit) {
      for(int lane = 0; lane < m_cluster_sizes[i]; ++lane) {
        const int row = unknowns[lanes_of_floats * i + lane];
        rows.for_each_entry(row, [&](int column, double value) {
          visit(lane, positions.of_unknown[column], scale[row] * value * scale[column]);
        });
      }
    };
    // calls work(i, numbers) for all clusters, with a number for each position that is kept
    using Numbers = std::vector<std::uint32_t>;
    constexpr std::uint32_t none = (std::numeric_limits<std::uint32_t>::max)();
    constexpr std::size_t grain = 2048;
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
      Numbers& columns = chunks[i / grain];
      const std::ptrdiff_t before = static_cast<std::ptrdiff_t>(columns.size());
      for_each_entry(i, [&](int, std::uint32_t column, double) {
        if(last_seen[column] != i)
          columns.push_back(column);
        last_seen[column] = static_cast<std::uint32_t>(i);
      });
      std::sort(columns.begin() + before, columns.end());
      m_first[i + 1] = columns.size() - static_cast<std::size_t>(before);
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
    for_each_cluster([&](std::size_t i, Numbers& number_of_column) {
      for(std::size_t k = m_first[i]; k < m_first[i + 1]; ++k)
        number_of_column[m_columns[k]] = static_cast<std::uint32_t>(k - m_first[i]);
      float* const values = m_values.data() + m_first_values[i];
      for_each_entry(i, [&](int lane, std::uint32_t column, double value) {
        values[m_cluster_sizes[i] * number_of_column[column] + lane] = static_cast<float>(value);
      });
    });
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
