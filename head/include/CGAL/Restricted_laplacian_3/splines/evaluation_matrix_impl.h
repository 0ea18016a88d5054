// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_EVALUATION_MATRIX_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_EVALUATION_MATRIX_IMPL_H

#include <CGAL/Restricted_laplacian_3/splines/evaluation_matrix.h>

#include <CGAL/Restricted_laplacian_3/basis/Tensor_basis_3.h>
#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/splines/shared/spline_evaluation.h>

#include <Eigen/SparseCore>

#include <cstddef>
#include <cstdint>
#include <string>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// \param derivative the axis, or -1 for values
inline Sparse_matrix evaluation_matrix(const Spline_space_3& space, int level, int derivative,
                                       const std::vector<Sheet_point>& points) {
  const double width = space.octree().cell_width(level);
  Eigen::SparseMatrix<double, Eigen::RowMajor> rows(
      static_cast<Eigen::Index>(points.size()), static_cast<Eigen::Index>(space.dimension(level)));
  rows.reserve(static_cast<Eigen::Index>(points.size()) * Tensor_basis_3::size);
  for(std::size_t i = 0; i < points.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    rows.startVec(row);
    if(points[i].sheet == Sheet_point::not_on_surface)
      continue;
    const Tensor_basis_3::Values values =
        derivative < 0 ? Tensor_basis_3::values(points[i].t)
                       : Tensor_basis_3::derivatives(points[i].t, derivative);
    for_each_element(space.elements(level, points[i].sheet), [&](int k, std::uint32_t element) {
      rows.insertBackByOuterInnerUnordered(row, element) =
          derivative < 0 ? values[k] : values[k] / width;
    });
  }
  rows.finalize();
  // to the other order, which sorts
  return Sparse_matrix(rows);
}

inline int checked_axis(int axis) {
  if(axis < 0 || axis > 2)
    throw Parameter_error("axis", "is " + std::to_string(axis) + ", but must be 0, 1 or 2");
  return axis;
}

} // namespace internal

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Sparse_matrix evaluation_matrix(const Spline_space_3& space,
                                                                   std::optional<int> level) {
  const int l = space.checked_level(level);
  return internal::evaluation_matrix(space, l, -1, internal::locate_vertices(space, l));
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Sparse_matrix
evaluation_matrix(const Spline_space_3& space, const std::vector<Surface_location>& locations,
                  std::optional<int> level) {
  const int l = space.checked_level(level);
  return internal::evaluation_matrix(space, l, -1,
                                     internal::locate_on_surface(space, l, locations));
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Sparse_matrix derivative_matrix(const Spline_space_3& space,
                                                                   int axis,
                                                                   std::optional<int> level) {
  const int l = space.checked_level(level);
  return internal::evaluation_matrix(space, l, internal::checked_axis(axis),
                                     internal::locate_vertices(space, l));
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Sparse_matrix
derivative_matrix(const Spline_space_3& space, int axis,
                  const std::vector<Surface_location>& locations, std::optional<int> level) {
  const int l = space.checked_level(level);
  return internal::evaluation_matrix(space, l, internal::checked_axis(axis),
                                     internal::locate_on_surface(space, l, locations));
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_EVALUATION_MATRIX_IMPL_H
