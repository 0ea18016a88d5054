// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_INTERNAL_DISTRIBUTED_MEANS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_INTERNAL_DISTRIBUTED_MEANS_H

#include <CGAL/Restricted_laplacian_3/distributed/Communicator.h>
#include <CGAL/Restricted_laplacian_3/distributed/Distributed_space.h>
#include <CGAL/Restricted_laplacian_3/distributed/internal/Distributed_components.h>
#include <CGAL/Restricted_laplacian_3/distributed/internal/Element_exchange.h>
#include <CGAL/Restricted_laplacian_3/distributed/internal/petsc.h>
#include <CGAL/Restricted_laplacian_3/solvers/shared/connected_components.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// Means on the components of a surface that is divided among ranks, as `Mean_projection` has them.
class Distributed_means {
public:
  /// \param matrix of the finest level
  /// \param integrals,constant_loads of the elements that this rank owns
  Distributed_means(const Distributed_space& space, const Element_exchange& exchange, Mat matrix,
                    std::vector<double> integrals, const std::vector<double>& constant_loads)
    : m_communicator(space.communicator()), m_components(space, exchange),
      m_measures(std::move(integrals)) {
    const std::size_t number = m_components.number;
    std::vector<double> loads(number, 0.);
    for(std::size_t i = 0; i < m_measures.size(); ++i)
      loads[component(i)] += constant_loads[i];
    m_communicator.sum(loads);
    std::vector<double> largest_defect(number, 0.), largest_diagonal(number, 0.);
    m_sums.assign(number, 0.);
    m_sizes.assign(number, 0.);
    Petsc_vector row_sums, diagonal;
    petsc_check(MatCreateVecs(matrix, row_sums.address(), diagonal.address()));
    petsc_check(MatGetRowSum(matrix, row_sums));
    petsc_check(MatGetDiagonal(matrix, diagonal));
    const std::vector<double> of_rows = values_of(row_sums), of_diagonal = values_of(diagonal);
    for(std::size_t i = 0; i < m_measures.size(); ++i) {
      const std::size_t c = component(i);
      if(loads[c] > 0)
        m_measures[i] = constant_loads[i];
      m_sums[c] += m_measures[i];
      m_sizes[c] += 1;
      largest_diagonal[c] = (std::max)(largest_diagonal[c], std::abs(of_diagonal[i]));
      largest_defect[c] = (std::max)(largest_defect[c], std::abs(of_rows[i] - constant_loads[i]));
    }
    m_communicator.sum(m_sums);
    m_communicator.sum(m_sizes);
    m_communicator.maximum(largest_defect);
    m_communicator.maximum(largest_diagonal);
    m_is_screened.assign(number, 0);
    for(std::size_t c = 0; c < number; ++c) {
      m_is_screened[c] = loads[c] > 0;
      m_is_split_off.push_back(m_sums[c] > 0 && largest_diagonal[c] > 0 &&
                               largest_defect[c] <= row_sum_tolerance * largest_diagonal[c]);
      m_has_kernel.push_back(m_is_split_off[c] && !m_is_screened[c]);
    }
  }

  int kernel_dimension() const {
    return static_cast<int>(std::count(m_has_kernel.begin(), m_has_kernel.end(), 1));
  }

  /// see `Mean_projection::project_load()`
  void project_load(double* b) const {
    const std::vector<double> means = this->means([&](std::size_t i) { return b[i]; });
    for(std::size_t i = 0; i < m_measures.size(); ++i)
      b[i] -= m_measures[i] * means[component(i)];
  }

  /// see `Mean_projection::shift_solution()`
  void shift_solution(const double* b, double* x) const {
    std::vector<double> shifts = this->means([&](std::size_t i) { return -m_measures[i] * x[i]; });
    const std::vector<double> loads = this->means([&](std::size_t i) { return b[i]; });
    for(std::size_t c = 0; c < shifts.size(); ++c)
      if(m_is_screened[c])
        shifts[c] += loads[c];
    for(std::size_t i = 0; i < m_measures.size(); ++i)
      x[i] += shifts[component(i)];
  }

  /// for PETSc: makes a vector orthogonal to the kernel
  static PetscErrorCode remove_kernel(MatNullSpace, Vec v, void* context) {
    const auto& means = *static_cast<const Distributed_means*>(context);
    PetscScalar* values = nullptr;
    PetscCall(VecGetArray(v, &values));
    std::vector<double> sums(means.m_components.number, 0.);
    for(std::size_t i = 0; i < means.m_measures.size(); ++i)
      sums[means.component(i)] += values[i];
    means.m_communicator.sum(sums);
    for(std::size_t c = 0; c < sums.size(); ++c)
      sums[c] = means.m_has_kernel[c] ? sums[c] / means.m_sizes[c] : 0;
    for(std::size_t i = 0; i < means.m_measures.size(); ++i)
      values[i] -= sums[means.component(i)];
    PetscCall(VecRestoreArray(v, &values));
    return 0;
  }

private:
  std::size_t component(std::size_t i) const { return m_components.of_element[i]; }

  template <class Value> std::vector<double> means(Value&& value) const {
    std::vector<double> result(m_components.number, 0.);
    for(std::size_t i = 0; i < m_measures.size(); ++i)
      result[component(i)] += value(i);
    m_communicator.sum(result);
    for(std::size_t c = 0; c < result.size(); ++c)
      result[c] *= m_is_split_off[c] ? 1 / m_sums[c] : 0.;
    return result;
  }

  Communicator m_communicator;
  Distributed_components m_components;
  std::vector<double> m_measures, m_sums, m_sizes;
  std::vector<char> m_is_screened, m_is_split_off, m_has_kernel;
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_INTERNAL_DISTRIBUTED_MEANS_H
