// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_TRIANGULATED_SURFACE_3_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_TRIANGULATED_SURFACE_3_IMPL_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/explain_out_of_memory.h>
#include <CGAL/Restricted_laplacian_3/surface/Surface_patches.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void check_oriented_point(std::size_t i, const Point_3& point,
                                                             const Vector_3& normal) {
  for(int axis = 0; axis < 3; ++axis) {
    if(!std::isfinite(point[axis]))
      throw Invalid_point_error(i, "has a coordinate that is not a finite number");
    if(!std::isfinite(normal[axis]))
      throw Invalid_point_error(i, "has a normal that is not finite");
  }
  if(normal == CGAL::NULL_VECTOR)
    throw Invalid_point_error(i, "has a normal of length zero");
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void check_size_of_surface(std::size_t vertices,
                                                              std::size_t faces) {
  constexpr std::size_t most = Triangulated_surface_3::maximum_number_of_faces;
  if(vertices > most || faces > most)
    throw Parameter_error("surface", "has " + std::to_string((std::max)(vertices, faces)) +
                                         (faces > most ? " faces" : " vertices") +
                                         ", but can have at most " + std::to_string(most));
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Vector_3 unit_vector(const Vector_3& v) {
  const double largest = (std::max)({std::abs(v.x()), std::abs(v.y()), std::abs(v.z())});
  const Vector_3 scaled(v.x() / largest, v.y() / largest, v.z() / largest);
  return scaled / std::sqrt(scaled.squared_length());
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE std::array<Vector_3, 2> tangent_axes(const Vector_3& normal) {
  // the axis that is farthest from the normal
  const double x = std::abs(normal.x()), y = std::abs(normal.y()), z = std::abs(normal.z());
  const Vector_3 axis = x <= y && x <= z ? Vector_3(1, 0, 0)
                        : y <= z         ? Vector_3(0, 1, 0)
                                         : Vector_3(0, 0, 1);
  const Vector_3 first = unit_vector(CGAL::cross_product(normal, axis));
  return {first, CGAL::cross_product(normal, first)};
}

} // namespace internal

CGAL_RESTRICTED_LAPLACIAN_3_INLINE
Triangulated_surface_3::Triangulated_surface_3(std::vector<Point_3> points,
                                               std::vector<Triangle> triangles)
  : m_points(std::move(points)), m_triangles(std::move(triangles)) {
  if(m_triangles.empty())
    throw Empty_surface_error();
  internal::check_size_of_surface(m_points.size(), m_triangles.size());
  for(std::size_t f = 0; f < m_triangles.size(); ++f)
    for(std::uint32_t v : m_triangles[f])
      if(v >= m_points.size())
        throw Invalid_face_error(f, "names a vertex that does not exist");
  compute_bounding_box();
  internal::explain_out_of_memory("not enough memory for the surface", [&] { compute_areas(); });
  if(!(m_area > 0))
    throw zero_area_error();
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE
Triangulated_surface_3::Triangulated_surface_3(internal::Part_of_surface&& part)
  : m_points(std::move(part.points)), m_triangles(std::move(part.triangles)),
    m_normals(std::move(part.normals)), m_areas(std::move(part.areas)),
    m_is_point_set(part.is_point_set) {
  CGAL_precondition(!m_triangles.empty());
  set_bounding_box(part.low, part.high);
  if(m_is_point_set)
    for(double area : m_areas)
      m_area += area;
  else
    internal::explain_out_of_memory("not enough memory for the surface", [&] { compute_areas(); });
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Triangulated_surface_3::Triangulated_surface_3(
    std::vector<Point_3> points, std::vector<Vector_3> normals, std::vector<double> areas)
  : m_points(std::move(points)), m_areas(std::move(areas)), m_is_point_set(true) {
  if(m_points.empty())
    throw Empty_surface_error("the point set has no point");
  internal::check_size_of_surface(m_points.size(), 0);
  if(normals.size() != m_points.size() || m_areas.size() != m_points.size())
    throw Parameter_error("points", "has another length than normals or areas");
  std::vector<Triangle> triangles(m_points.size());
  for(std::size_t i = 0; i < m_points.size(); ++i) {
    internal::check_oriented_point(i, m_points[i], normals[i]);
    if(!(m_areas[i] >= 0 && std::isfinite(m_areas[i])))
      throw Invalid_point_error(i, "has an area that is negative or not a finite number");
    normals[i] = internal::unit_vector(normals[i]);
    triangles[i].fill(static_cast<std::uint32_t>(i));
    m_area += m_areas[i];
  }
  m_normals = internal::Shared_array<Vector_3>(std::move(normals));
  m_triangles = internal::Shared_array<Triangle>(std::move(triangles));
  compute_bounding_box();
  if(!(m_area > 0))
    throw zero_area_error();
  if(!std::isfinite(m_area))
    throw Parameter_error("area_map", "has values whose sum is not a finite number");
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void
Triangulated_surface_3::require_triangles(const std::string& who) const {
  if(m_is_point_set)
    throw Input_error("the surface is a point set, but " + who + " needs triangles");
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void Triangulated_surface_3::compute_bounding_box() {
  const double infinity = std::numeric_limits<double>::infinity();
  std::array<double, 3> low = {infinity, infinity, infinity},
                        high = {-infinity, -infinity, -infinity};
  for(const Triangle& triangle : m_triangles)
    for(std::uint32_t v : triangle)
      for(int axis = 0; axis < 3; ++axis) {
        const double x = m_points[v][axis];
        if(!std::isfinite(x))
          throw Invalid_vertex_error(v, "has a coordinate that is not a finite number");
        low[axis] = (std::min)(low[axis], x);
        high[axis] = (std::max)(high[axis], x);
      }
  set_bounding_box(Point_3(low[0], low[1], low[2]), Point_3(high[0], high[1], high[2]));
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void
Triangulated_surface_3::set_bounding_box(const Point_3& low, const Point_3& high) {
  m_min = low;
  m_max = high;
  m_extent = (std::max)({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
  if(m_extent == 0)
    throw zero_area_error();
  if(!(m_extent >= smallest_extent && m_extent <= largest_extent))
    throw Parameter_error("extent", "of the bounding box is outside of 1e-100 .. 1e100");
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void Triangulated_surface_3::compute_areas() {
  std::vector<double> areas(m_triangles.size());
  for(std::size_t f = 0; f < m_triangles.size(); ++f) {
    areas[f] = scaled_normal(f).area * m_extent * m_extent;
    m_number_of_degenerate_faces += areas[f] == 0;
    m_area += areas[f];
  }
  m_areas = internal::Shared_array<double>(std::move(areas));
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Zero_area_error Triangulated_surface_3::zero_area_error() const {
  if(!m_is_point_set)
    return Zero_area_error(m_triangles.size());
  return Zero_area_error("the point set has area zero: all of its " +
                         std::to_string(m_points.size()) +
                         (m_extent == 0 ? " points are the same" : " points have area zero"));
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void
Triangulated_surface_3::set_patches(std::shared_ptr<const Surface_patches> patches) {
  m_patches = std::move(patches);
  // Radon's rule of degree 5: the center, and three points on the medians at either side of it
  const double root = std::sqrt(15.);
  const std::array<double, 2> near = {(6 - root) / 21, (6 + root) / 21},
                              weights = {(155 - root) / 1200, (155 + root) / 1200};
  std::vector<double> areas(m_areas.begin(), m_areas.end());
  m_area = 0;
  for(std::size_t f = 0; f < number_of_faces(); ++f) {
    if(!is_degenerate(f) && !m_patches->is_flat(f)) {
      const std::array<Point_3, 3> corners = {point(f, 0), point(f, 1), point(f, 2)};
      double area = 9. / 40 * m_patches->evaluate(f, corners, {1. / 3, 1. / 3, 1. / 3}).area;
      for(int k = 0; k < 2; ++k)
        for(int i = 0; i < 3; ++i) {
          std::array<double, 3> l = {near[k], near[k], near[k]};
          l[i] = 1 - 2 * near[k];
          area += weights[k] * m_patches->evaluate(f, corners, l).area;
        }
      areas[f] = area;
    }
    m_area += areas[f];
  }
  m_areas = internal::Shared_array<double>(std::move(areas));
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void
Triangulated_surface_3::set_patch_point(Surface_point& p) const {
  const Patch_point on_patch = m_patches->evaluate(
      p.face, {m_points[p.vertices[0]], m_points[p.vertices[1]], m_points[p.vertices[2]]},
      p.barycentric);
  p.point = on_patch.point;
  p.normal = on_patch.normal;
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_TRIANGULATED_SURFACE_3_IMPL_H
