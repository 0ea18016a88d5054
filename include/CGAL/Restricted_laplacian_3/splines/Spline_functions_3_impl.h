// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_SPLINE_FUNCTIONS_3_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_SPLINE_FUNCTIONS_3_IMPL_H

#include <CGAL/Restricted_laplacian_3/basis/Tensor_basis_3.h>
#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/name_step.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parallel_for.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_functions_3.h>
#include <CGAL/Restricted_laplacian_3/splines/shared/spline_evaluation.h>

#include <Eigen/Core>

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
  return internal::name_step("not enough memory for the values at the vertices",
                             [&] { return values(internal::locate_vertices(m_space, m_level)); });
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
  if(m_coefficients.rows() == 0)
    return result; // no function: no memory to take parts of
  // Values of a chunk are gathered point by point, and stored column by column: the rows of the
  // result are far apart in memory.
  constexpr std::size_t grain = 64;
  internal::parallel_for(
      m_space.options().is_parallel, 0, points.size(), grain,
      [&](std::size_t begin, std::size_t end) {
        const Eigen::Index size = static_cast<Eigen::Index>(end - begin);
        Eigen::MatrixXd chunk = Eigen::MatrixXd::Zero(m_coefficients.rows(), size);
        for(Eigen::Index i = 0; i < size; ++i) {
          const internal::Sheet_point& p = points[begin + static_cast<std::size_t>(i)];
          if(p.sheet == internal::Sheet_point::not_on_surface) {
            chunk.col(i).setConstant(std::numeric_limits<double>::quiet_NaN());
            continue;
          }
          const Tensor_basis_3::Values values = values_of(p.t);
          for_each_element(m_space.elements(m_level, p.sheet), [&](int k, std::uint32_t element) {
            chunk.col(i) += values[k] * m_coefficients.col(element);
          });
        }
        result.middleRows(static_cast<Eigen::Index>(begin), size) = chunk.transpose();
      });
  return result;
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_SPLINE_FUNCTIONS_3_IMPL_H
