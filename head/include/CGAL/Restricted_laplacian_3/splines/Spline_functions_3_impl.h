// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_SPLINE_FUNCTIONS_3_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_SPLINE_FUNCTIONS_3_IMPL_H

#include <CGAL/Restricted_laplacian_3/basis/Tensor_basis_3.h>
#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/explain_out_of_memory.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parallel_for.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_functions_3.h>
#include <CGAL/Restricted_laplacian_3/splines/shared/spline_evaluation.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Spline_functions_3::Spline_functions_3(
    const Spline_space_3& space, const Eigen::Ref<const Eigen::MatrixXd>& coefficients, int level)
  : m_space(space), m_level(space.checked_level(level)) {
  if(static_cast<std::size_t>(coefficients.rows()) != space.dimension(level))
    throw Parameter_error("coefficients", "has " + std::to_string(coefficients.rows()) +
                                              " rows, but the dimension of the space is " +
                                              std::to_string(space.dimension(level)));
  m_coefficients = coefficients.transpose();
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE
Spline_functions_3::Spline_functions_3(const Spline_space_3& space,
                                       const Eigen::Ref<const Eigen::MatrixXd>& coefficients)
  : Spline_functions_3(space, coefficients, space.depth()) {}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Eigen::MatrixXd Spline_functions_3::values_at_vertices() const {
  return internal::explain_out_of_memory("not enough memory for the values at the vertices", [&] {
    Eigen::MatrixXd result(static_cast<Eigen::Index>(m_space.surface().number_of_vertices()),
                           m_coefficients.rows());
    internal::for_each_vertex_chunk(
        m_space, m_level, [&](std::size_t first, const std::vector<internal::Sheet_point>& points) {
          for(std::size_t begin = 0; begin < points.size(); begin += points_at_once) {
            const std::size_t size = (std::min)(points_at_once, points.size() - begin);
            write_sums(points.data() + begin, size, &Tensor_basis_3::values, first + begin, result);
          }
        });
    return result;
  });
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Spline_jets Spline_functions_3::jets_at_vertices() const {
  return jets(internal::locate_vertices(m_space, m_level));
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Eigen::MatrixXd
Spline_functions_3::values_at(const std::vector<Surface_location>& locations) const {
  return values(internal::locate_on_surface(m_space, m_level, locations));
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Spline_jets
Spline_functions_3::jets_at(const std::vector<Surface_location>& locations) const {
  return jets(internal::locate_on_surface(m_space, m_level, locations));
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Spline_jets
Spline_functions_3::jets(const std::vector<internal::Sheet_point>& points) const {
  const double width = m_space.octree().cell_width(m_level);
  Spline_jets result;
  result.values = values(points);
  for(int axis = 0; axis < 3; ++axis)
    result.derivatives[axis] = sums(points,
                                    [axis](const std::array<double, 3>& t) {
                                      return Tensor_basis_3::derivatives(t, axis);
                                    }) /
                               width;
  return result;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Eigen::MatrixXd
Spline_functions_3::values(const std::vector<internal::Sheet_point>& points) const {
  return sums(points, &Tensor_basis_3::values);
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Eigen::MatrixXd
Spline_functions_3::sums(const std::vector<internal::Sheet_point>& points,
                         const internal::Element_numbers& values_of) const {
  Eigen::MatrixXd result(static_cast<Eigen::Index>(points.size()), m_coefficients.rows());
  internal::parallel_for(m_space.options().is_parallel, 0, points.size(), points_at_once,
                         [&](std::size_t begin, std::size_t end) {
                           write_sums(points.data() + begin, end - begin, values_of, begin, result);
                         });
  return result;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void
Spline_functions_3::write_sums(const internal::Sheet_point* points, std::size_t number_of_points,
                               const internal::Element_numbers& values_of, std::size_t first_row,
                               Eigen::MatrixXd& result) const {
  if(m_coefficients.rows() == 0)
    return; // no function: no memory to take parts of
  // Values are gathered point by point, and stored column by column: the rows of the result are
  // far apart in memory.
  const auto size = static_cast<Eigen::Index>(number_of_points);
  Eigen::MatrixXd chunk = Eigen::MatrixXd::Zero(m_coefficients.rows(), size);
  for(Eigen::Index i = 0; i < size; ++i) {
    const internal::Sheet_point& p = points[i];
    if(p.sheet == internal::Sheet_point::not_on_surface) {
      chunk.col(i).setConstant(std::numeric_limits<double>::quiet_NaN());
      continue;
    }
    const Tensor_basis_3::Values values = values_of(p.t);
    for_each_element(m_space.elements(m_level, p.sheet), [&](int k, std::uint32_t element) {
      chunk.col(i) += values[k] * m_coefficients.col(element);
    });
  }
  result.middleRows(static_cast<Eigen::Index>(first_row), size) = chunk.transpose();
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_SPLINE_FUNCTIONS_3_IMPL_H
