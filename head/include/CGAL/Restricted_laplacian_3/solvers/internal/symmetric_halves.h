// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_INTERNAL_SYMMETRIC_HALVES_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_INTERNAL_SYMMETRIC_HALVES_H

#include <CGAL/Restricted_laplacian_3/foundation/Sparse_matrix.h>
#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>

#include <algorithm>
#include <cstddef>
#include <string>

/// \file
/// Symmetric matrices are given as a whole, or as the half on and above the diagonal. The rows of a
/// column are sorted.

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// number of the entries of a column on and above the diagonal, which are the first ones of it
inline int number_above(const Sparse_matrix& a, int column) {
  const int* const first = a.innerIndexPtr() + a.outerIndexPtr()[column];
  const int number = a.isCompressed() ? a.outerIndexPtr()[column + 1] - a.outerIndexPtr()[column]
                                      : a.innerNonZeroPtr()[column];
  return static_cast<int>(std::upper_bound(first, first + number, column) - first);
}

/// whether a matrix has entries below the diagonal
/// \throws Parameter_error if it has some, but not one for each of those above, so that it is
/// neither symmetric nor the half that it should be
inline bool has_both_halves(const Sparse_matrix& a, const std::string& parameter) {
  std::size_t upper = 0;
  for(int j = 0; j < a.cols(); ++j)
    upper += static_cast<std::size_t>(number_above(a, j));
  const std::size_t lower = static_cast<std::size_t>(a.nonZeros()) - upper;
  std::size_t diagonal = 0;
  for(int j = 0; j < a.cols() && lower > 0; ++j) {
    const int number = number_above(a, j);
    diagonal += number > 0 && a.innerIndexPtr()[a.outerIndexPtr()[j] + number - 1] == j;
  }
  if(lower > 0 && lower != upper - diagonal)
    throw Parameter_error(parameter, "is not symmetric: there are " + std::to_string(lower) +
                                         " entries below the diagonal, and " +
                                         std::to_string(upper - diagonal) + " above");
  return lower > 0;
}

/// all entries of a matrix that may be given as half
inline Sparse_matrix whole(const Sparse_matrix& a) {
  if(has_both_halves(a, "a"))
    return a;
  return Sparse_matrix(a.selfadjointView<Eigen::Upper>());
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_INTERNAL_SYMMETRIC_HALVES_H
