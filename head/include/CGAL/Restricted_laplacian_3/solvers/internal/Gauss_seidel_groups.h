// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_INTERNAL_GAUSS_SEIDEL_GROUPS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_INTERNAL_GAUSS_SEIDEL_GROUPS_H

#include <CGAL/Restricted_laplacian_3/foundation/Sparse_matrix.h>
#include <CGAL/Restricted_laplacian_3/solvers/Multigrid_levels.h>
#include <CGAL/Restricted_laplacian_3/solvers/internal/Group_layout.h>
#include <CGAL/Restricted_laplacian_3/solvers/internal/Level_vectors.h>
#include <CGAL/Restricted_laplacian_3/solvers/internal/renumbering.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// What `Gauss_seidel_smoother` keeps, and how it relaxes a group.
class Gauss_seidel_groups : public Group_layout {
public:
  Gauss_seidel_groups(const Sparse_matrix& a, const Smoothing_patches& patches, bool is_parallel)
    : Group_layout(a, patches, is_parallel) {
    const std::size_t n = static_cast<std::size_t>(a.cols());
    const std::vector<int> by_octave = order_by_octave_of_diagonal(a);
    const std::vector<int> rank = ranks(by_octave);
    // Each unknown belongs to the first group that has it, the others to one more group at the end.
    std::vector<char> is_placed(n, 0);
    std::vector<int> order;
    order.reserve(n);
    m_groups.push_back(0);
    for(std::size_t group = 0; group + 1 < patches.groups.size(); ++group) {
      for(std::uint32_t p = patches.groups[group]; p < patches.groups[group + 1]; ++p)
        for(std::uint32_t i : patches.unknowns[p])
          if(!is_placed[i]) {
            is_placed[i] = 1;
            order.push_back(static_cast<int>(i));
          }
      std::sort(order.begin() + m_groups.back(), order.end(),
                [&rank](int i, int j) { return rank[i] < rank[j]; });
      m_groups.push_back(static_cast<std::uint32_t>(order.size()));
    }
    if(order.size() < n) {
      for(int i : by_octave)
        if(!is_placed[i])
          order.push_back(i);
      m_groups.push_back(static_cast<std::uint32_t>(n));
      colors.push_back(static_cast<std::uint32_t>(m_groups.size() - 1));
    }
    positions = Level_positions::consecutive(n);
    for(std::size_t i = 0; i < n; ++i)
      positions.of_unknown[order[i]] = static_cast<std::uint32_t>(i);
    m_matrix = Level_matrix::of_symmetric(a, positions, scale);
    m_inverse_diagonal.assign(n, 0.f);
    for(std::size_t i = 0; i < n; ++i) {
      const double diagonal = a.coeff(order[i], order[i]) * scale[order[i]] * scale[order[i]];
      if(diagonal > std::numeric_limits<float>::epsilon())
        m_inverse_diagonal[i] = static_cast<float>(1 / diagonal);
    }
  }

  /// \f$r = b - A x\f$
  template <int K>
  void residual(const Level_vectors<K>& b, const Level_vectors<K>& x, Level_vectors<K>& r) const {
    m_matrix.template multiply<K, false>(is_parallel, x, r);
    for(std::size_t i = 0; i < r.size(); ++i)
      r.data()[i] = b.data()[i] - r.data()[i];
  }

  /// relaxes a group in order or in reverse
  template <int K>
  void relax_group(std::size_t group, const Level_vectors<K>& b, Level_vectors<K>& x,
                   bool is_reversed) const {
    const std::uint32_t begin = m_groups[group], end = m_groups[group + 1];
    for(std::uint32_t k = 0; k < end - begin; ++k) {
      const std::size_t i = is_reversed ? end - 1 - k : begin + k;
      const float* const load = b.position(i);
      float* const value = x.position(i);
      float residual[K];
      std::copy(load, load + K, residual);
      m_matrix.template add_row_product<K>(i, -1, x, residual);
      for(int c = 0; c < K; ++c)
        value[c] += residual[c] * m_inverse_diagonal[i];
    }
  }

private:
  std::vector<std::uint32_t> m_groups;
  Level_matrix m_matrix;
  std::vector<float> m_inverse_diagonal;
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_INTERNAL_GAUSS_SEIDEL_GROUPS_H
