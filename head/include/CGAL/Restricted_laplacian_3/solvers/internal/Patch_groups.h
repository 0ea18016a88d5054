// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_INTERNAL_PATCH_GROUPS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_INTERNAL_PATCH_GROUPS_H

#include <CGAL/Restricted_laplacian_3/foundation/Sparse_matrix.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parallel_for.h>
#include <CGAL/Restricted_laplacian_3/solvers/Multigrid_levels.h>
#include <CGAL/Restricted_laplacian_3/solvers/internal/Cluster_matrix.h>
#include <CGAL/Restricted_laplacian_3/solvers/internal/Group_layout.h>
#include <CGAL/Restricted_laplacian_3/solvers/internal/Level_vectors.h>
#include <CGAL/Restricted_laplacian_3/solvers/internal/Scratch_memory.h>
#include <CGAL/Restricted_laplacian_3/solvers/internal/Symmetric_inverse.h>
#include <CGAL/Restricted_laplacian_3/solvers/internal/block_kernels.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// Added to the diagonals, which are near 1, before a block is inverted: well above the rounding
/// errors of single precision, times the number of entries in a row. Without it a combination of
/// elements whose energy is only rounding error would be amplified by the inverse of that error.
/// With it the inverse is never too large, so the smoother converges for any matrix.
constexpr double relative_regularization = 1e-5;

/// What `Patch_smoother` keeps, and how it relaxes a group.
class Patch_groups : public Group_layout {
public:
  Patch_groups(const Sparse_matrix& a, const Smoothing_patches& patches, bool is_parallel)
    : Group_layout(a, patches, is_parallel), m_groups(patches.groups) {
    CGAL_precondition(patches.neighborhoods.empty() ||
                      patches.neighborhoods.size() == static_cast<std::size_t>(a.cols()));
    find_clusters(static_cast<std::size_t>(a.cols()), patches,
                  patches.neighborhoods.empty() ? independent_neighborhoods(a, patches)
                                                : patches.neighborhoods);
    find_parts(patches);
    // Products read eight numbers at a time.
    m_inverses = Scratch_memory(sizeof(float) * (m_patches.back().inverse + lanes_of_floats - 1));
    m_matrix = Cluster_matrix(is_parallel, a, positions, scale, &m_inverses);
    invert_blocks();
  }

  /// \f$r = b - A x\f$
  template <int K>
  void residual(const Level_vectors<K>& b, const Level_vectors<K>& x, Level_vectors<K>& r) const {
    m_matrix.template residual<K>(is_parallel, b, x, r);
  }

  /// relaxes a group in order or in reverse
  template <int K>
  void relax_group(std::size_t group, const Level_vectors<K>& b, Level_vectors<K>& x,
                   bool is_reversed) const {
    const std::size_t size = static_cast<std::size_t>(K) * rounded_up(m_largest_size, 8);
    Aligned_floats residuals(size), update(size);
    const std::uint32_t begin = m_groups[group], end = m_groups[group + 1];
    for(std::uint32_t k = 0; k < end - begin; ++k)
      relax<K>(is_reversed ? end - 1 - k : begin + k, b, x, residuals.data(), update.data());
  }

private:
  struct Patch {
    std::uint32_t first_part;
    std::uint32_t size;  // number of unknowns
    std::size_t inverse; // number of its first entry in m_inverses
  };

  /// what a patch has of a cluster
  struct Part {
    std::uint32_t cluster;
    std::uint32_t mask;
  };

  static int rounded_up(int size, int multiple) {
    return (size + multiple - 1) / multiple * multiple;
  }

  /// Unknowns of a neighborhood go into the same cluster, those of one patch first if they are
  /// more than eight.
  void find_clusters(std::size_t n, const Smoothing_patches& patches,
                     const std::vector<std::uint64_t>& neighborhoods) {
    constexpr std::size_t lanes = lanes_of_floats;
    std::vector<std::uint32_t> last_patch(n, 0);
    for(std::size_t p = 0; p < patches.number_of_patches; ++p)
      for(std::uint32_t i : patches.unknowns[p])
        last_patch[i] = static_cast<std::uint32_t>(p);
    struct Place {
      std::uint64_t neighborhood;
      std::uint32_t patch, unknown;
    };
    std::vector<Place> places(n);
    for(std::size_t i = 0; i < n; ++i)
      places[i] = {neighborhoods[i], last_patch[i], static_cast<std::uint32_t>(i)};
    std::sort(places.begin(), places.end(), [](const Place& a, const Place& b) {
      return std::tie(a.neighborhood, a.patch, a.unknown) <
             std::tie(b.neighborhood, b.patch, b.unknown);
    });

    positions.of_unknown.resize(n);
    std::size_t position = 0;
    for(std::size_t begin = 0, end = 0; begin < n; begin = end) {
      while(end < n && places[end].neighborhood == places[begin].neighborhood &&
            places[end].patch == places[begin].patch)
        ++end;
      const bool is_new = begin > 0 && places[begin].neighborhood != places[begin - 1].neighborhood;
      const std::size_t left = (lanes - position % lanes) % lanes;
      if(is_new || end - begin > left)
        position += left;
      for(std::size_t i = begin; i < end; ++i)
        positions.of_unknown[places[i].unknown] = static_cast<std::uint32_t>(position++);
    }
    positions.number_of_positions = (position + lanes - 1) / lanes * lanes;
  }

  /// the clusters of each patch, and which of their unknowns belong to it
  void find_parts(const Smoothing_patches& patches) {
    m_patches.reserve(patches.number_of_patches + 1);
    std::size_t inverse = 0;
    std::vector<std::uint32_t> sorted;
    for(std::size_t p = 0; p < patches.number_of_patches; ++p) {
      const int size = static_cast<int>(patches.unknowns[p].size());
      m_patches.push_back(
          {static_cast<std::uint32_t>(m_parts.size()), static_cast<std::uint32_t>(size), inverse});
      sorted.clear();
      for(std::uint32_t i : patches.unknowns[p])
        sorted.push_back(positions.of_unknown[i]);
      std::sort(sorted.begin(), sorted.end());
      for(std::uint32_t position : sorted) {
        const std::uint32_t cluster = position / lanes_of_floats;
        if(m_parts.size() == m_patches.back().first_part || m_parts.back().cluster != cluster)
          m_parts.push_back({cluster, 0});
        m_parts.back().mask |= 1u << position % lanes_of_floats;
      }
      m_largest_size = (std::max)(m_largest_size, size);
      inverse += static_cast<std::size_t>(symmetric_size(size));
    }
    m_patches.push_back({static_cast<std::uint32_t>(m_parts.size()), 0, inverse});
  }

  void invert_blocks() {
    constexpr std::size_t grain = 256;
    parallel_for(
        is_parallel, 0, m_patches.size() - 1, grain, [&](std::size_t begin, std::size_t end) {
          Symmetric_inverse invert;
          std::vector<double> block;
          std::vector<std::uint32_t> unknowns;
          for(std::size_t p = begin; p < end; ++p) {
            const Patch& patch = m_patches[p];
            const int size = static_cast<int>(patch.size), stride = rounded_up(size, 8);
            extract(p, stride, unknowns, block);
            for(int i = 0; i < size; ++i) {
              double& diagonal = block[static_cast<std::size_t>(stride) * i + i];
              // Where it is 0 the row is 0, and the unknown remains 0.
              diagonal = diagonal > 0 ? diagonal + relative_regularization : 0;
            }
            invert(block.data(), size, stride, relative_regularization / 2);
            pack_symmetric(block.data(), size, stride, m_inverses.as<float>() + patch.inverse);
          }
        });
  }

  /// calls `visit(position)` for the positions of a part
  template <class Visitor> static void for_each_position(const Part& part, Visitor&& visit) {
    for(std::uint32_t lane = 0; lane < lanes_of_floats; ++lane)
      if(part.mask >> lane & 1)
        visit(lanes_of_floats * part.cluster + lane);
  }

  /// The lower triangle of the dense block of a patch, with as many rows as columns in memory.
  /// \param unknowns receives the positions of the patch, ascending
  void extract(std::size_t p, int stride, std::vector<std::uint32_t>& unknowns,
               std::vector<double>& block) const {
    const std::uint32_t first = m_patches[p].first_part, last = m_patches[p + 1].first_part;
    block.assign(static_cast<std::size_t>(stride) * stride, 0.);
    unknowns.clear();
    for(std::uint32_t k = first; k < last; ++k)
      for_each_position(m_parts[k], [&](std::uint32_t position) { unknowns.push_back(position); });
    std::size_t row_of_part = 0;
    for(std::uint32_t k = first; k < last; ++k) {
      const Part part = m_parts[k];
      // The columns are ascending as well.
      std::size_t column_of_block = 0;
      m_matrix.for_each_column(part.cluster, [&](std::uint32_t column, const float* values) {
        while(column_of_block < unknowns.size() && unknowns[column_of_block] < column)
          ++column_of_block;
        if(column_of_block == unknowns.size() || unknowns[column_of_block] != column)
          return;
        // The block is transposed, so that a row of the result is read from consecutive numbers.
        double* const to =
            block.data() + static_cast<std::size_t>(stride) * column_of_block + row_of_part;
        std::size_t row = 0;
        for_each_position(
            part, [&](std::uint32_t position) { to[row++] = values[position % lanes_of_floats]; });
      });
      for_each_position(part, [&](std::uint32_t) { ++row_of_part; });
    }
  }

  /// \param residuals,update room for `K` vectors
  template <int K>
  void relax(std::size_t p, const Level_vectors<K>& b, Level_vectors<K>& x, float* residuals,
             float* update) const {
    const Patch& patch = m_patches[p];
    const std::uint32_t first = patch.first_part, last = m_patches[p + 1].first_part;
    // residuals of the unknowns, one after the other
    float* place = residuals;
    for(std::uint32_t k = first; k < last; ++k) {
      const Part part = m_parts[k];
      float sum[lanes_of_floats * K];
      std::copy(b.cluster(part.cluster), b.cluster(part.cluster) + lanes_of_floats * K, sum);
      m_matrix.template subtract_rows<K>(part.cluster, x, sum);
      for(int lane = 0; lane < lanes_of_floats; ++lane)
        if(part.mask >> lane & 1)
          place = std::copy(sum + K * lane, sum + K * lane + K, place);
    }
    const int size = static_cast<int>(patch.size);
    std::fill(place, residuals + K * rounded_up(size, 8), 0.f);
    multiply_symmetric<K>(m_inverses.as<float>() + patch.inverse, size, residuals, update);
    const float* from = update;
    for(std::uint32_t k = first; k < last; ++k)
      for_each_position(m_parts[k], [&](std::uint32_t position) {
        float* const value = x.position(position);
        for(int c = 0; c < K; ++c)
          value[c] += *from++;
      });
  }

  Cluster_matrix m_matrix;
  std::vector<std::uint32_t> m_groups;
  std::vector<Patch> m_patches; // and one more
  std::vector<Part> m_parts;
  Scratch_memory m_inverses;
  int m_largest_size = 0;
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_INTERNAL_PATCH_GROUPS_H
