// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_INTERNAL_BLOCK_MATRIX_H
#define CGAL_RESTRICTED_LAPLACIAN_3_INTERNAL_BLOCK_MATRIX_H

#include <CGAL/Restricted_laplacian_3/internal/block_kernels.h>
#include <CGAL/Restricted_laplacian_3/internal/level_vectors.h>
#include <CGAL/Restricted_laplacian_3/internal/parallel_for.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// A symmetric sparse matrix in single precision that consists of dense blocks, one for each pair
/// of clusters with a common entry, of eight rows and as many columns as the cluster has unknowns.
/// Restricted splines of neighbouring cells act on the same sheets, so their rows have most of
/// their columns in common: with clusters of neighbours the blocks are half full, and a product
/// takes no indirect access to single numbers.
class Block_matrix {
public:
  Block_matrix() : m_first(1, 0), m_first_values(1, 0) {}

  /// \param scale the matrix becomes \f$D A D\f$ with this diagonal matrix \f$D\f$
  Block_matrix(bool is_parallel, const Eigen::SparseMatrix<double>& a,
               const Level_positions& positions, const std::vector<double>& scale) {
    const std::size_t clusters = positions.number_of_clusters();
    std::vector<std::uint32_t> unknowns(positions.number_of_positions, no_unknown);
    m_cluster_sizes.assign(clusters, 0);
    for(std::size_t i = 0; i < positions.of_unknown.size(); ++i) {
      unknowns[positions.of_unknown[i]] = static_cast<std::uint32_t>(i);
      ++m_cluster_sizes[positions.of_unknown[i] / lanes_of_floats];
    }
    // the columns of blocks in row i
    const auto find_blocks = [&](std::size_t i, std::vector<std::uint32_t>& last_seen,
                                 std::vector<std::uint32_t>& columns) {
      columns.clear();
      for(int lane = 0; lane < m_cluster_sizes[i]; ++lane) {
        const std::uint32_t j = unknowns[lanes_of_floats * i + lane];
        for(int k = a.outerIndexPtr()[j]; k < a.outerIndexPtr()[j + 1]; ++k) {
          const std::uint32_t column = positions.of_unknown[a.innerIndexPtr()[k]] / lanes_of_floats;
          if(last_seen[column] != i) {
            last_seen[column] = static_cast<std::uint32_t>(i);
            columns.push_back(column);
          }
        }
      }
    };
    constexpr std::size_t grain = 2048;
    m_first.assign(clusters + 1, 0);
    m_first_values.assign(clusters + 1, 0);
    parallel_for(is_parallel, 0, clusters, grain, [&](std::size_t begin, std::size_t end) {
      std::vector<std::uint32_t> last_seen(clusters, no_unknown), columns;
      for(std::size_t i = begin; i < end; ++i) {
        find_blocks(i, last_seen, columns);
        m_first[i + 1] = columns.size();
        for(std::uint32_t column : columns)
          m_first_values[i + 1] += lanes_of_floats * m_cluster_sizes[column];
      }
    });
    for(std::size_t i = 0; i < clusters; ++i) {
      m_first[i + 1] += m_first[i];
      m_first_values[i + 1] += m_first_values[i];
    }
    m_columns.resize(m_first.back());
    m_values.resize(m_first_values.back());
    parallel_for(is_parallel, 0, clusters, grain, [&](std::size_t begin, std::size_t end) {
      std::vector<std::uint32_t> last_seen(clusters, no_unknown), columns;
      std::vector<std::size_t> block(clusters); // place of the block of a column
      for(std::size_t i = begin; i < end; ++i) {
        find_blocks(i, last_seen, columns);
        std::sort(columns.begin(), columns.end());
        std::copy(columns.begin(), columns.end(), m_columns.begin() + m_first[i]);
        std::size_t place = m_first_values[i];
        for(std::uint32_t column : columns) {
          block[column] = place;
          place += lanes_of_floats * m_cluster_sizes[column];
        }
        std::fill(m_values.begin() + m_first_values[i], m_values.begin() + place, 0.f);
        for(int lane = 0; lane < m_cluster_sizes[i]; ++lane) {
          const std::uint32_t j = unknowns[lanes_of_floats * i + lane];
          for(int k = a.outerIndexPtr()[j]; k < a.outerIndexPtr()[j + 1]; ++k) {
            const int row = a.innerIndexPtr()[k];
            const std::uint32_t position = positions.of_unknown[row];
            m_values[block[position / lanes_of_floats] +
                     lanes_of_floats * (position % lanes_of_floats) + lane] =
                static_cast<float>(scale[j] * a.valuePtr()[k] * scale[row]);
          }
        }
      }
    });
  }

  std::size_t number_of_clusters() const { return m_first.size() - 1; }

  /// Calls `visit(column, values)` for the blocks of a row, where entry (i, j) of a block is number
  /// \f$i + 8 j\f$ of its values.
  template <class Visitor> void for_each_block(std::size_t row, Visitor&& visit) const {
    const float* values = m_values.data() + m_first_values[row];
    for(std::size_t k = m_first[row]; k < m_first[row + 1]; ++k) {
      visit(m_columns[k], values);
      values += lanes_of_floats * m_cluster_sizes[m_columns[k]];
    }
  }

  /// subtracts row `i` of the matrix, times `x`, from a cluster of `K` vectors
  template <int K> void subtract_row(std::size_t i, const Level_vectors<K>& x, float* sum) const {
    subtract_blocks<K>(m_values.data() + m_first_values[i], m_columns.data() + m_first[i],
                       m_cluster_sizes.data(), m_first[i + 1] - m_first[i], x.data(), sum);
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
                     subtract_row<K>(i, x, r.cluster(i));
                   }
                 });
  }

private:
  static constexpr std::uint32_t no_unknown = (std::numeric_limits<std::uint32_t>::max)();

  std::vector<std::uint8_t> m_cluster_sizes;
  std::vector<std::size_t> m_first;        // block of each row
  std::vector<std::size_t> m_first_values; // of each row
  std::vector<std::uint32_t> m_columns;
  Aligned_floats m_values;
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_INTERNAL_BLOCK_MATRIX_H
