// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_SPLINE_FUNCTION_3_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_SPLINE_FUNCTION_3_IMPL_H

#include <CGAL/Restricted_laplacian_3/basis/Tensor_basis_3.h>
#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/explain_out_of_memory.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_function_3.h>
#include <CGAL/Restricted_laplacian_3/splines/shared/spline_evaluation.h>

#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

CGAL_RESTRICTED_LAPLACIAN_3_INLINE
Spline_function_3::Spline_function_3(const Spline_space_3& space, Eigen::VectorXd coefficients,
                                     int level)
  : m_space(space), m_level(space.checked_level(level)), m_coefficients(std::move(coefficients)) {
  if(static_cast<std::size_t>(m_coefficients.size()) != space.dimension(level))
    throw Parameter_error("coefficients", "has " + std::to_string(m_coefficients.size()) +
                                              " entries, but the dimension of the space is " +
                                              std::to_string(space.dimension(level)));
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE
Spline_function_3::Spline_function_3(const Spline_space_3& space, Eigen::VectorXd coefficients)
  : Spline_function_3(space, std::move(coefficients), space.depth()) {}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE double
Spline_function_3::value(const Surface_location& location) const {
  return value(internal::locate_on_surface(m_space, m_level, location));
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Vector_3
Spline_function_3::gradient(const Surface_location& location) const {
  const internal::Sheet_point p = internal::locate_on_surface(m_space, m_level, location);
  if(surface().is_degenerate(location.face))
    throw Location_error("face " + std::to_string(location.face) +
                         " is degenerate: it has no tangent plane");
  const Cell_elements& elements = m_space.elements(m_level, p.sheet);
  const auto gradients = Tensor_basis_3::gradients(p.t);
  const Vector_3 in_space = Vector_3(combination(elements, gradients[0], m_coefficients),
                                     combination(elements, gradients[1], m_coefficients),
                                     combination(elements, gradients[2], m_coefficients)) /
                            m_space.octree().cell_width(m_level);
  const Vector_3 n = surface().surface_point(location).normal;
  return in_space - (in_space * n) * n;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE std::vector<double>
Spline_function_3::values_at_vertices() const {
  return internal::explain_out_of_memory("not enough memory for the values at the vertices", [&] {
    std::vector<double> values(surface().number_of_vertices());
    internal::for_each_vertex_chunk(
        m_space, m_level, [&](std::size_t first, const std::vector<internal::Sheet_point>& points) {
          for(std::size_t i = 0; i < points.size(); ++i)
            values[first + i] = value(points[i]);
        });
    return values;
  });
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE double
Spline_function_3::value(const internal::Sheet_point& p) const {
  return p.sheet == internal::Sheet_point::not_on_surface
             ? std::numeric_limits<double>::quiet_NaN()
             : combination(m_space.elements(m_level, p.sheet), Tensor_basis_3::values(p.t),
                           m_coefficients);
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_SPLINE_FUNCTION_3_IMPL_H
