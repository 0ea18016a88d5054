// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_SHARED_MEAN_PROJECTION_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_SHARED_MEAN_PROJECTION_IMPL_H

#include <CGAL/Restricted_laplacian_3/solvers/shared/Mean_projection.h>

#include <CGAL/Restricted_laplacian_3/solvers/shared/connected_components.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

CGAL_RESTRICTED_LAPLACIAN_3_INLINE
Mean_projection::Mean_projection(const Sparse_matrix& a, Eigen::VectorXd integrals,
                                 const Eigen::VectorXd& constant_loads)
  : m_measures(std::move(integrals)) {
  CGAL_precondition(m_measures.size() == a.cols() && constant_loads.size() == a.cols());
  int number = 0;
  std::tie(m_component, number) = connected_components(a);
  m_is_screened.assign(number, 0);
  for(std::size_t i = 0; i < m_component.size(); ++i)
    if(constant_loads[i] > 0)
      m_is_screened[m_component[i]] = 1;
  m_sums.assign(number, 0.);
  for(std::size_t i = 0; i < m_component.size(); ++i) {
    if(m_is_screened[m_component[i]])
      m_measures[i] = constant_loads[i];
    m_sums[m_component[i]] += m_measures[i];
  }
  m_is_split_off = maps_constants_to(constant_loads, a, m_component, number);
  for(int c = 0; c < number; ++c) {
    m_is_split_off[c] = m_is_split_off[c] && m_sums[c] > 0;
    m_number += m_is_split_off[c];
  }
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE int Mean_projection::kernel_dimension() const {
  int result = 0;
  for(int c = 0; c < number_of_components(); ++c)
    result += m_is_split_off[c] && !m_is_screened[c];
  return result;
}

template <int K, class Weight>
Mean_projection::Block_rows<K> Mean_projection::means(const Block_vector<K>& v,
                                                      Weight&& weight) const {
  Block_rows<K> result(m_sums.size(), Block_row<K>::Zero());
  for(std::size_t i = 0; i < m_component.size() && m_number > 0; ++i)
    result[m_component[i]] += weight(m_measures[i]) * row<K>(v, i);
  for(std::size_t c = 0; c < result.size(); ++c)
    result[c] *= m_is_split_off[c] ? 1 / m_sums[c] : 0.;
  return result;
}

template <int K> void Mean_projection::project_load(Block_vector<K>& b) const {
  const auto means = this->means<K>(b, [](double) { return 1.; });
  for(std::size_t i = 0; i < m_component.size() && m_number > 0; ++i)
    row<K>(b, i) -= m_measures[i] * means[m_component[i]];
}

template <int K>
void Mean_projection::shift_solution(const Block_vector<K>& b, Block_vector<K>& x) const {
  if(m_number == 0)
    return;
  auto shifts = this->means<K>(x, [](double measure) { return -measure; });
  const auto loads = this->means<K>(b, [](double) { return 1.; });
  for(std::size_t c = 0; c < shifts.size(); ++c)
    if(m_is_screened[c])
      shifts[c] += loads[c];
  for(std::size_t i = 0; i < m_component.size(); ++i)
    row<K>(x, i) += shifts[m_component[i]];
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_SHARED_MEAN_PROJECTION_IMPL_H
