// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_INTERNAL_CONSTANT_DEFLATION_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_INTERNAL_CONSTANT_DEFLATION_H

#include <CGAL/Restricted_laplacian_3/foundation/Sparse_matrix.h>
#include <CGAL/Restricted_laplacian_3/solvers/internal/Level_vectors.h>
#include <CGAL/Restricted_laplacian_3/solvers/shared/connected_components.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// Removes from a load of a level what lies along the constants that the matrix \f$A\f$ of the
/// level does not see: on each component of its graph with \f$1^T A\, 1 \le 10^{-6} \max A_{ii}\f$.
///
/// In exact arithmetic the load of a singular system has no such part. In single precision it has
/// one by rounding, which each visit of the level would answer with a constant, as large as the
/// regularization of its patches permits. A V-cycle adds one such answer, a W-cycle \f$2^k\f$ of
/// them \f$k\f$ levels below the finest.
///
/// With \f$A\f$ replaced by \f$D A D\f$ the constants are \f$v = D^{-1} 1\f$, and the load becomes
/// \f$b - v\, (v^T b) / (v^T v)\f$.
class Constant_deflation {
public:
  /// nothing to remove
  Constant_deflation() = default;

  /// \param a what is below its diagonal is not read
  /// \param positions,scale of the level
  Constant_deflation(const Sparse_matrix& a, const Level_positions& positions,
                     const std::vector<double>& scale) {
    const auto [component, number] = connected_components(a);
    const std::size_t count = static_cast<std::size_t>(number);
    std::vector<double> energies(count, 0.), largest(count, 0.);
    for(int j = 0; j < a.cols(); ++j)
      for(Sparse_matrix::InnerIterator i(a, j); i && i.row() <= j; ++i) {
        energies[component[j]] += i.row() < j ? 2 * i.value() : i.value();
        if(i.row() == j)
          largest[component[j]] = (std::max)(largest[component[j]], i.value());
      }
    std::vector<std::vector<Entry>> entries(count);
    for(std::size_t i = 0; i < component.size(); ++i)
      if(energies[component[i]] <= largest_energy * largest[component[i]])
        entries[component[i]].push_back(
            {positions.of_unknown[i], static_cast<float>(1 / scale[i])});
    m_first.push_back(0);
    for(const std::vector<Entry>& of_component : entries) {
      if(of_component.empty())
        continue;
      double norm = 0;
      for(const Entry& e : of_component)
        norm += static_cast<double>(e.weight) * e.weight;
      m_entries.insert(m_entries.end(), of_component.begin(), of_component.end());
      m_first.push_back(m_entries.size());
      m_squared_norms.push_back(norm);
    }
  }

  /// takes linear time
  template <int K> void remove_from(Level_vectors<K>& b) const {
    for(std::size_t c = 0; c < m_squared_norms.size(); ++c) {
      std::array<double, K> products = {};
      for(std::size_t i = m_first[c]; i < m_first[c + 1]; ++i) {
        const float* const place = b.position(m_entries[i].position);
        for(int k = 0; k < K; ++k)
          products[k] += static_cast<double>(m_entries[i].weight) * place[k];
      }
      for(double& product : products)
        product /= m_squared_norms[c];
      for(std::size_t i = m_first[c]; i < m_first[c + 1]; ++i) {
        float* const place = b.position(m_entries[i].position);
        for(int k = 0; k < K; ++k)
          place[k] -= static_cast<float>(m_entries[i].weight * products[k]);
      }
    }
  }

private:
  /// What has more energy is not lost in rounding.
  static constexpr double largest_energy = 1e-6;

  struct Entry {
    std::uint32_t position;
    float weight;
  };

  std::vector<Entry> m_entries;
  std::vector<std::size_t> m_first;
  std::vector<double> m_squared_norms; // of each component
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_INTERNAL_CONSTANT_DEFLATION_H
