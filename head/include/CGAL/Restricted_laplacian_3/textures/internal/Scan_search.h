// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_TEXTURES_INTERNAL_SCAN_SEARCH_H
#define CGAL_RESTRICTED_LAPLACIAN_3_TEXTURES_INTERNAL_SCAN_SEARCH_H

#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>
#include <CGAL/Restricted_laplacian_3/surface/shared/Nearest_points.h>
#include <CGAL/Restricted_laplacian_3/textures/internal/Triangle_tree.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// Barycentric coordinates of the point of a triangle that is nearest to `q`, by the region in
/// which `q` lies: exactly 0 for corners opposite to the side on which that point is.
inline std::array<double, 3> nearest_in_triangle(const Double_kernel::Triangle_3& t,
                                                 const Point_3& q) {
  const Vector_3 ab = t[1] - t[0], ac = t[2] - t[0], aq = q - t[0], bq = q - t[1], cq = q - t[2];
  const double d1 = ab * aq, d2 = ac * aq, d3 = ab * bq, d4 = ac * bq, d5 = ab * cq, d6 = ac * cq;
  if(d1 <= 0 && d2 <= 0)
    return {1, 0, 0};
  if(d3 >= 0 && d4 <= d3)
    return {0, 1, 0};
  if(d6 >= 0 && d5 <= d6)
    return {0, 0, 1};
  const double a = d3 * d6 - d5 * d4, b = d5 * d2 - d1 * d6, c = d1 * d4 - d3 * d2;
  if(c <= 0 && d1 >= 0 && d3 <= 0) {
    const double x = d1 / (d1 - d3);
    return {1 - x, x, 0};
  }
  if(b <= 0 && d2 >= 0 && d6 <= 0) {
    const double x = d2 / (d2 - d6);
    return {1 - x, 0, x};
  }
  if(a <= 0 && d4 >= d3 && d5 >= d6) {
    const double x = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return {0, 1 - x, x};
  }
  const double sum = a + b + c;
  return {a / sum, b / sum, c / sum};
}

/// The point of a surface, triangles or points, that is nearest to any location. Coordinates are
/// taken relative to the bounding box, so squares of distances neither overflow nor vanish. May be
/// asked from several threads at once.
class Scan_search {
public:
  /// What the last search found, for the next one: near locations are found faster.
  /// A point, and the position of its triangle among those that are not degenerate.
  using Hint = std::optional<std::pair<Point_3, std::size_t>>;

  explicit Scan_search(const Triangulated_surface_3& surface)
    : m_center(surface.center()), m_scale(1 / surface.extent()),
      m_half_sides(relative(surface.bounding_box_max()) - CGAL::ORIGIN) {
    if(surface.is_point_set()) {
      for(std::size_t i = 0; i < surface.number_of_vertices(); ++i)
        m_points.push_back(relative(surface.point(i)));
      m_nearest_points.emplace(m_points);
      return;
    }
    for(std::size_t f = 0; f < surface.number_of_faces(); ++f)
      if(!surface.is_degenerate(f)) {
        m_triangles.emplace_back(relative(surface.point(f, 0)), relative(surface.point(f, 1)),
                                 relative(surface.point(f, 2)));
        m_faces.push_back(static_cast<std::uint32_t>(f));
      }
    m_tree.emplace(m_triangles.cbegin(), m_triangles.cend());
    m_tree->do_not_accelerate_distance_queries(); // hints are better: locations come in order
    m_tree->build();
  }

  Scan_search(const Scan_search&) = delete;
  Scan_search& operator=(const Scan_search&) = delete;

  /// The location that is nearest to `query`, if there is one within `maximum_distance`.
  std::optional<Surface_location> find(const Point_3& query, double maximum_distance,
                                       Hint& hint) const {
    constexpr double largest_bound = 1e50; // its square is finite
    const double bound = (std::min)(maximum_distance * m_scale, largest_bound);
    const Point_3 q = relative(query);
    for(int axis = 0; axis < 3; ++axis)
      if(!(std::abs(q[axis]) <= m_half_sides[axis] + bound))
        return std::nullopt;
    return m_tree ? find_in_triangles(q, bound, hint) : find_among_points(q, bound);
  }

private:
  Point_3 relative(const Point_3& p) const { return CGAL::ORIGIN + (p - m_center) * m_scale; }

  std::optional<Surface_location> find_in_triangles(const Point_3& q, double bound,
                                                    Hint& hint) const {
    // a point at the distance of the bound stands for nothing found
    Triangle_tree::Point_and_primitive_id nearest(Point_3(q.x() + bound, q.y(), q.z()),
                                                  m_triangles.cend());
    if(hint && CGAL::squared_distance(q, hint->first) <= bound * bound)
      nearest = {hint->first, m_triangles.cbegin() + static_cast<std::ptrdiff_t>(hint->second)};
    nearest = m_tree->closest_point_and_primitive(q, nearest);
    hint.reset();
    if(nearest.second == m_triangles.cend())
      return std::nullopt;
    hint.emplace(nearest.first, static_cast<std::size_t>(nearest.second - m_triangles.cbegin()));
    Surface_location location;
    location.face = m_faces[hint->second];
    location.barycentric = nearest_in_triangle(*nearest.second, q);
    return location;
  }

  std::optional<Surface_location> find_among_points(const Point_3& q, double bound) const {
    Surface_location location;
    location.face = m_nearest_points->nearest_to(q);
    if(CGAL::squared_distance(q, m_points[location.face]) > bound * bound)
      return std::nullopt;
    return location;
  }

  Point_3 m_center;
  double m_scale;
  Vector_3 m_half_sides;
  Triangles_in_tree m_triangles; // those that are not degenerate
  std::vector<std::uint32_t> m_faces;
  std::optional<Triangle_tree> m_tree;
  std::vector<Point_3> m_points; // if the surface is given by points
  std::optional<Nearest_points> m_nearest_points;
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_TEXTURES_INTERNAL_SCAN_SEARCH_H
