// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_PROLONGATION_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_PROLONGATION_IMPL_H

#include <CGAL/Restricted_laplacian_3/basis/Tensor_basis_3.h>
#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/splines/prolongation.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Sparse_matrix prolongation_matrix(const Spline_space_3& space,
                                                                     int level) {
  if(level < 0 || level >= space.depth())
    throw Parameter_error("level", "is " + std::to_string(level) + ", but must be in 0 .. " +
                                       std::to_string(space.depth() - 1));
  // All coarse elements that contain a fine one act on the parent of any sheet on which it acts, so
  // rows are found through one such sheet; Eigen transposes them into columns.
  const std::size_t rows = space.dimension(level + 1);
  Eigen::SparseMatrix<double, Eigen::RowMajor> by_rows(rows, space.dimension(level));
  constexpr int largest_row = 8;
  by_rows.reserve(largest_row * rows);
  for(std::size_t i = 0; i < rows; ++i) {
    const std::size_t parent = space.octree().parent(level + 1, space.slot(level + 1, i).first);
    const Tensor_basis_3::Values weights = Tensor_basis_3::two_scale_coefficients(
        space.center(level + 1, i).index, space.octree().cell(level, parent).index);
    const auto row = static_cast<Eigen::Index>(i);
    by_rows.startVec(row);
    for_each_element(space.elements(level, parent), [&](int j, std::uint32_t coarse) {
      if(weights[j] != 0)
        by_rows.insertBackByOuterInnerUnordered(row, coarse) = weights[j];
    });
  }
  by_rows.finalize();
  return by_rows;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE std::vector<Sparse_matrix>
prolongation_matrices(const Spline_space_3& space, int coarsest) {
  // Matrices of Eigen 3.4 are copied where they could be moved; a copy for which there is no memory
  // loses what it has.
  std::vector<Sparse_matrix> result(
      static_cast<std::size_t>((std::max)(space.depth() - coarsest, 0)));
  for(std::size_t i = 0; i < result.size(); ++i)
    prolongation_matrix(space, coarsest + static_cast<int>(i)).swap(result[i]);
  return result;
}

namespace internal {

CGAL_RESTRICTED_LAPLACIAN_3_INLINE int coarsest_multigrid_level(const Spline_space_3& space) {
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

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_PROLONGATION_IMPL_H
