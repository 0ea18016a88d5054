// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_INTERNAL_CONNECTED_COMPONENTS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_INTERNAL_CONNECTED_COMPONENTS_H

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// Number of the connected component of each unknown in the graph of a symmetric matrix, counted
/// from 0, and the number of components.
inline std::pair<std::vector<int>, int> connected_components(const Eigen::SparseMatrix<double>& a) {
  std::vector<int> component(a.cols(), -1), stack;
  int number = 0;
  for(int start = 0; start < a.cols(); ++start) {
    if(component[start] != -1)
      continue;
    component[start] = number;
    stack.push_back(start);
    while(!stack.empty()) {
      const int j = stack.back();
      stack.pop_back();
      for(Eigen::SparseMatrix<double>::InnerIterator i(a, j); i; ++i)
        if(component[i.row()] == -1) {
          component[i.row()] = number;
          stack.push_back(static_cast<int>(i.row()));
        }
    }
    ++number;
  }
  return {std::move(component), number};
}

/// A thousand times the rounding error of a row sum, as a fraction of the largest diagonal entry.
constexpr double row_sum_tolerance = 1e-13;

/// For each component of the graph of a matrix \f$A\f$, whether \f$A 1 = v\f$ in its rows. This
/// counts as satisfied if no entry is off by more than `row_sum_tolerance` times the largest
/// diagonal entry of the component, and never if that is 0.
inline std::vector<char> maps_constants_to(const Eigen::VectorXd& v,
                                           const Eigen::SparseMatrix<double>& a,
                                           const std::vector<int>& component, int number) {
  const Eigen::VectorXd defect = a * Eigen::VectorXd::Ones(a.cols()) - v, diagonal = a.diagonal();
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

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_INTERNAL_CONNECTED_COMPONENTS_H
