// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_INTERNAL_CONNECTED_COMPONENTS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_INTERNAL_CONNECTED_COMPONENTS_H

#include <Eigen/SparseCore>

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

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_INTERNAL_CONNECTED_COMPONENTS_H
