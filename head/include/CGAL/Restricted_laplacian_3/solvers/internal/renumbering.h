// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_INTERNAL_RENUMBERING_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_INTERNAL_RENUMBERING_H

#include <CGAL/Restricted_laplacian_3/foundation/Sparse_matrix.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// Orders the unknowns of a positive semi-definite matrix by the octave (binary exponent) of their
/// diagonal entry, large ones first, and keeps the given order within an octave.
///
/// Restricted elements are nearly dependent: those whose support hardly reaches the surface have
/// small diagonal entries and are nearly combinations of the large ones around them. When
/// Gauss-Seidel relaxes the large ones first before the coarse correction, and last after it, the
/// small ones only have to take up what the large ones left: conjugate gradients need about half of
/// the iterations that they need with the elements in the order of space. Octaves do as well as a
/// full sort, and neighbors in space stay near in memory.
inline std::vector<int> order_by_octave_of_diagonal(const Sparse_matrix& a) {
  const Eigen::VectorXd diagonal = a.diagonal();
  std::vector<int> octave(diagonal.size());
  for(Eigen::Index i = 0; i < diagonal.size(); ++i)
    octave[i] = diagonal[i] > 0 ? std::ilogb(diagonal[i]) : (std::numeric_limits<int>::min)();
  std::vector<int> order(octave.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&octave](int i, int j) { return octave[i] > octave[j]; });
  return order;
}

/// inverse of a permutation
inline std::vector<int> ranks(const std::vector<int>& order) {
  std::vector<int> rank(order.size());
  for(std::size_t i = 0; i < order.size(); ++i)
    rank[order[i]] = static_cast<int>(i);
  return rank;
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_INTERNAL_RENUMBERING_H
