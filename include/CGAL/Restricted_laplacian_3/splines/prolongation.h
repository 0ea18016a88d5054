// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_PROLONGATION_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_PROLONGATION_H

#include <CGAL/Restricted_laplacian_3/foundation/Sparse_matrix.h>
#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/splines/B_spline_1.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Operators
/// The matrix \f$P\f$ that writes a function of a level in terms of the next finer one:
/// \f$ \sum_j \eta_j b^l_j = \sum_i (P \eta)_i b^{l+1}_i \f$, `dimension(level + 1)` rows and
/// `dimension(level)` columns. Its columns hold the \f$4 \times 4 \times 4\f$ stencil
/// \f$\frac14 (1\ 3\ 3\ 1)^{\otimes 3}\f$ (paper, section 4.2), as far as the elements exist. Its
/// transpose restricts residuals. In the space of the paper the stencil is cut off at the boundary
/// of the grid, and the relation holds only away from it.
/// \throws Parameter_error if `level` is not from 0 to depth - 1
inline Sparse_matrix prolongation_matrix(const Spline_space_3& space, int level) {
  if(level < 0 || level >= space.depth())
    throw Parameter_error("level", "is " + std::to_string(level) + ", but must be in 0 .. " +
                                       std::to_string(space.depth() - 1));
  // All coarse elements that contain a fine one act on the parent of any sheet on which it acts, so
  // rows are found through one such sheet, and then transposed into columns by a counting sort.
  struct Entry {
    std::uint32_t coarse;
    double value;
  };
  const std::size_t rows = space.dimension(level + 1), columns = space.dimension(level);
  std::vector<std::array<Entry, 8>> entries(rows);
  std::vector<int> counts(rows, 0);
  std::vector<int> outer(columns + 1, 0);
  for(std::size_t i = 0; i < rows; ++i) {
    const std::size_t parent = space.octree().parent(level + 1, space.slot(level + 1, i).first);
    const Cell_3 parent_cell = space.octree().cell(level, parent);
    const Cell_3 center = space.center(level + 1, i);
    const Cell_elements& elements = space.elements(level, parent);
    std::array<std::array<double, 3>, 3> weights;
    for(int axis = 0; axis < 3; ++axis)
      for(int offset = -1; offset <= 1; ++offset)
        weights[axis][offset + 1] = B_spline_1::two_scale_coefficient(
            center.index[axis] - 2 * (parent_cell.index[axis] + offset));
    for(int j = 0; j < 27; ++j) {
      const double weight = weights[0][j % 3] * weights[1][j / 3 % 3] * weights[2][j / 9];
      if(weight == 0 || elements[j] == Spline_space_3::no_element)
        continue;
      entries[i][counts[i]++] = {elements[j], weight};
      ++outer[elements[j] + 1];
    }
  }
  for(std::size_t j = 0; j < columns; ++j)
    outer[j + 1] += outer[j];
  Sparse_matrix p(rows, columns);
  p.resizeNonZeros(outer.back());
  std::copy(outer.begin(), outer.end(), p.outerIndexPtr());
  for(std::size_t i = 0; i < rows; ++i)
    for(int k = 0; k < counts[i]; ++k) {
      const int position = outer[entries[i][k].coarse]++;
      p.innerIndexPtr()[position] = static_cast<int>(i);
      p.valuePtr()[position] = entries[i][k].value;
    }
  return p;
}

/// \ingroup PkgRestrictedLaplacian3Operators
/// The prolongations from `coarsest` to `coarsest + 1`, ..., from depth - 1 to depth.
inline std::vector<Sparse_matrix> prolongation_matrices(const Spline_space_3& space, int coarsest) {
  std::vector<Sparse_matrix> result;
  for(int level = coarsest; level < space.depth(); ++level)
    result.push_back(prolongation_matrix(space, level));
  return result;
}

namespace internal {

/// The coarsest level of a hierarchy: the finest one whose dense factorisation takes no time that
/// counts. It is done for each connected component of the surface, which is a sheet of level 0.
inline int coarsest_multigrid_level(const Spline_space_3& space) {
  constexpr double largest_dense_dimension = 300;
  const double components = static_cast<double>(space.octree().number_of_sheets(0));
  int level = 0;
  while(level < space.depth() && static_cast<double>(space.dimension(level + 1)) <=
                                     largest_dense_dimension * std::sqrt(components))
    ++level;
  return level;
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_PROLONGATION_H
