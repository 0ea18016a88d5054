// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_GEODESIC_FUNCTION_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_GEODESIC_FUNCTION_IMPL_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/surface/Geodesic_function.h>
#include <CGAL/Restricted_laplacian_3/surface/Geodesic_solver_impl.h>
#include <CGAL/Restricted_laplacian_3/surface/internal/Geodesic_triangle.h>
#include <CGAL/Restricted_laplacian_3/surface/vertex_normals.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// the triangle of a face, for distances of the vertices
inline Geodesic_triangle geodesic_triangle(const Ray_geometry& geometry, std::size_t face,
                                           const Geodesic_distances& distances) {
  const Triangulated_surface_3& surface = geometry.surface();
  Geodesic_triangle::Barycentric d, angles;
  for(std::size_t k = 0; k < 3; ++k) {
    const std::uint32_t v = surface.triangle(face)[k];
    d[k] = distances.distances[v] / surface.extent();
    angles[k] = distances.angles[v];
  }
  return Geodesic_triangle(geometry, static_cast<std::uint32_t>(face), d, angles);
}

/// a value in the frame of side 0 of a face, as one in space
inline Geodesic_function::Value value_in_space(const Triangulated_surface_3& surface,
                                               std::size_t face,
                                               const Geodesic_triangle::Value& value) {
  const Vector_3 u = unit_or_zero(surface.point(face, 1) - surface.point(face, 0));
  return {value.distance * surface.extent(),
          value.gradient.x * u + value.gradient.y * CGAL::cross_product(surface.normal(face), u)};
}

} // namespace internal

CGAL_RESTRICTED_LAPLACIAN_3_INLINE
Geodesic_function::Geodesic_function(const Geodesic_solver& solver, Geodesic_distances distances)
  : m_solver(solver), m_distances(std::make_shared<Geodesic_distances>(std::move(distances))) {
  const std::size_t n = surface().number_of_vertices();
  if(m_distances->distances.size() != n || m_distances->angles.size() != n)
    throw Parameter_error("distances", "are not those of the vertices of the surface");
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Geodesic_function::Value
Geodesic_function::bounded(const Surface_location& location) const {
  const auto barycentric = m_solver.m_impl->checked(location);
  return internal::value_in_space(
      surface(), location.face,
      internal::geodesic_triangle(m_solver.m_impl->geometry, location.face, *m_distances)
          .bounded(barycentric));
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void
Geodesic_function::evaluate(const Surface_point* points, std::size_t number, Value* values) const {
  for(std::size_t i = 0; i < number;) {
    const std::size_t face = points[i].face;
    const internal::Geodesic_triangle triangle =
        internal::geodesic_triangle(m_solver.m_impl->geometry, face, *m_distances);
    for(; i < number && points[i].face == face; ++i)
      values[i] = internal::value_in_space(surface(), face, triangle(points[i].barycentric));
  }
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_GEODESIC_FUNCTION_IMPL_H
