// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_SHARED_CONNECTED_COMPONENTS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_SHARED_CONNECTED_COMPONENTS_H

#include <CGAL/Restricted_laplacian_3/foundation/Sparse_matrix.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Disjoint_sets.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// Number of the connected component of each unknown in the graph of a symmetric matrix, counted
/// from 0, and the number of components. What is below the diagonal is not read.
inline std::pair<std::vector<int>, int> connected_components(const Sparse_matrix& a) {
  const std::size_t n = static_cast<std::size_t>(a.cols());
  Disjoint_sets sets(n);
  for(int j = 0; j < a.cols(); ++j)
    for(Sparse_matrix::InnerIterator i(a, j); i && i.row() < j; ++i)
      sets.unite(static_cast<std::uint32_t>(i.row()), static_cast<std::uint32_t>(j));
  // A representative is the smallest of its component.
  std::vector<int> component(n);
  int number = 0;
  for(std::size_t i = 0; i < n; ++i) {
    const std::uint32_t first = sets.find(static_cast<std::uint32_t>(i));
    component[i] = first == i ? number++ : component[first];
  }
  return {std::move(component), number};
}

/// A thousand times the rounding error of a row sum, as a fraction of the largest diagonal entry.
constexpr double row_sum_tolerance = 1e-13;

/// For each component of the graph of a matrix \f$A\f$, whether \f$A 1 = v\f$ in its rows. This
/// counts as satisfied if no entry is off by more than `row_sum_tolerance` times the largest
/// diagonal entry of the component, and never if that is 0. What is below the diagonal of \f$A\f$
/// is not read.
inline std::vector<char> maps_constants_to(const Eigen::VectorXd& v, const Sparse_matrix& a,
                                           const std::vector<int>& component, int number) {
  Eigen::VectorXd defect = -v;
  for(int j = 0; j < a.cols(); ++j)
    for(Sparse_matrix::InnerIterator i(a, j); i && i.row() <= j; ++i) {
      defect[i.row()] += i.value();
      if(i.row() < j)
        defect[j] += i.value();
    }
  const Eigen::VectorXd diagonal = a.diagonal();
  std::vector<double> largest_defect(number, 0.), largest_diagonal(number, 0.);
  for(std::size_t i = 0; i < component.size(); ++i) {
    double &largest = largest_defect[component[i]], &entry = largest_diagonal[component[i]];
    largest = (std::max)(largest, std::abs(defect[i]));
    entry = (std::max)(entry, std::abs(diagonal[i]));
  }
  std::vector<char> result(number);
  for(int c = 0; c < number; ++c)
    result[c] =
        largest_diagonal[c] > 0 && largest_defect[c] <= row_sum_tolerance * largest_diagonal[c];
  return result;
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_SHARED_CONNECTED_COMPONENTS_H
