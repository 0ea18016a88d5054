// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SHARED_SURFACE_BUILDER_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SHARED_SURFACE_BUILDER_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>
#include <CGAL/Restricted_laplacian_3/surface/shared/divide_polygon.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// Makes a surface of polygons. All points come before the first polygon.
class Surface_builder {
public:
  void reserve(std::size_t points, std::size_t polygons) {
    m_points.reserve(points);
    m_triangles.reserve(polygons);
  }
  void add_point(const Point_3& p) { m_points.push_back(p); }

  /// number of polygons so far, which is that of the next one
  std::size_t number_of_polygons() const { return m_number_of_polygons; }

  /// \throws Invalid_face_error it has fewer than three corners, or names a vertex that does not
  /// exist
  void add_polygon(const std::vector<std::uint32_t>& vertices) {
    if(vertices.size() < 3)
      throw Invalid_face_error(m_number_of_polygons, "has fewer than three corners");
    for(const std::uint32_t v : vertices)
      if(v >= m_points.size())
        throw Invalid_face_error(m_number_of_polygons, "names a vertex that does not exist");
    if(vertices.size() == 3)
      add_triangle(vertices, {0, 1, 2});
    else {
      note_polygons();
      std::vector<Triangle> parts = divided_polygon(m_points, vertices);
      if(parts.empty())
        parts.push_back({0, 1, 2}); // and has no area
      for(const Triangle& part : parts)
        add_triangle(vertices, part);
    }
    if(m_has_polygons)
      m_polygons.sizes.push_back(static_cast<std::uint32_t>(vertices.size()));
    ++m_number_of_polygons;
  }

  Triangulated_surface_3 surface() && {
    Triangulated_surface_3 result(std::move(m_points), std::move(m_triangles));
    if(m_has_polygons)
      result.set_polygons(std::move(m_polygons));
    return result;
  }

private:
  using Triangle = Triangulated_surface_3::Triangle;

  void note_polygons() {
    if(m_has_polygons)
      return;
    m_has_polygons = true;
    m_polygons.sizes.assign(m_triangles.size(), 3);
    for(std::size_t i = 0; i < m_triangles.size(); ++i)
      note_part({0, 1, 2}, i);
  }
  void note_part(const Triangle& corners, std::size_t polygon) {
    m_polygons.numbers.push_back(static_cast<std::uint32_t>(polygon));
    m_polygons.corners.push_back(corners);
  }
  void add_triangle(const std::vector<std::uint32_t>& vertices, const Triangle& corners) {
    m_triangles.push_back({vertices[corners[0]], vertices[corners[1]], vertices[corners[2]]});
    if(m_has_polygons)
      note_part(corners, m_number_of_polygons);
  }

  std::vector<Point_3> m_points;
  std::vector<Triangle> m_triangles;
  Polygons_of_surface m_polygons;
  bool m_has_polygons = false;
  std::size_t m_number_of_polygons = 0;
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SHARED_SURFACE_BUILDER_H
