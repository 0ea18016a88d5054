// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_GEODESICS_INTERNAL_RAY_GEOMETRY_H
#define CGAL_RESTRICTED_LAPLACIAN_3_GEODESICS_INTERNAL_RAY_GEOMETRY_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/Number_lists.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>
#include <CGAL/Restricted_laplacian_3/surface/shared/Surface_edges.h>
#include <CGAL/Restricted_laplacian_3/surface/vertex_normals.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// a point, or a vector, of a plane into which triangles are unfolded
struct Plane_vector {
  double x = 0, y = 0;

  friend Plane_vector operator+(const Plane_vector& a, const Plane_vector& b) {
    return {a.x + b.x, a.y + b.y};
  }
  friend Plane_vector operator-(const Plane_vector& a, const Plane_vector& b) {
    return {a.x - b.x, a.y - b.y};
  }
  friend Plane_vector operator*(double t, const Plane_vector& a) { return {t * a.x, t * a.y}; }
  double length() const { return std::sqrt(x * x + y * y); }
};
inline double cross(const Plane_vector& a, const Plane_vector& b) { return a.x * b.y - a.y * b.x; }
inline double dot(const Plane_vector& a, const Plane_vector& b) { return a.x * b.x + a.y * b.y; }
/// the angle between two vectors, from 0 to pi
inline double angle(const Plane_vector& a, const Plane_vector& b) {
  return std::atan2(std::abs(cross(a, b)), dot(a, b));
}

/// What rays need to know of a surface: the lengths of sides, the angles of corners, which faces
/// are beyond a side, and the fan of a vertex, if its corners form one. Corner `k` of a face is its
/// vertex `k`, side `k` runs from there to the next corner.
///
/// The unit of length is the extent of the surface.
///
/// Directions at a vertex with a fan are angles: 0 along its first edge, growing by the angles of
/// the corners in the order in which they are met around the vertex.
class Ray_geometry {
public:
  /// a corner of a face, or a side
  struct Corner {
    std::uint32_t face;
    std::uint32_t number;
  };
  using Side = Surface_edges::Side;

  /// \param surface a surface of triangles; is referred to
  explicit Ray_geometry(const Triangulated_surface_3& surface)
    : m_surface(&surface), m_edges(surface), m_edge_of_side(3 * surface.number_of_faces()),
      m_lengths(m_edge_of_side.size()), m_angles(m_edge_of_side.size()),
      m_first_angles(m_edge_of_side.size()), m_starts_at_next(m_edge_of_side.size()),
      m_total_angles(surface.number_of_vertices(), 0),
      m_is_on_boundary(surface.number_of_vertices(), 0) {
    for(std::size_t e = 0; e < m_edges.size(); ++e) {
      m_is_manifold = m_is_manifold &&
                      (m_edges.sides(e).size() <= 2 || !is_used(m_edges.sides(e).begin()->face));
      for(const Side& side : m_edges.sides(e))
        m_edge_of_side[3 * side.face + side.number] = static_cast<std::uint32_t>(e);
    }
    for(std::size_t f = 0; f < surface.number_of_faces(); ++f)
      for(int k = 0; k < 3; ++k) {
        const Vector_3 a = (surface.point(f, (k + 1) % 3) - surface.point(f, k)) / surface.extent(),
                       b = (surface.point(f, (k + 2) % 3) - surface.point(f, k)) / surface.extent();
        m_lengths[3 * f + k] = std::sqrt(a.squared_length());
        m_angles[3 * f + k] =
            std::atan2(std::sqrt(CGAL::cross_product(a, b).squared_length()), a * b);
      }
    m_corners = Number_lists::by_key(
        surface.number_of_vertices(), m_edge_of_side.size(), [&](std::size_t i) -> std::size_t {
          return is_used(i / 3) ? surface.triangle(i / 3)[i % 3] : surface.number_of_vertices();
        });
    for(std::size_t v = 0; v < surface.number_of_vertices(); ++v)
      make_fan(static_cast<std::uint32_t>(v));
  }

  const Triangulated_surface_3& surface() const { return *m_surface; }
  /// whether the three vertices of a face are different; others are passed over
  bool is_used(std::size_t face) const {
    const auto& t = m_surface->triangle(face);
    return t[0] != t[1] && t[1] != t[2] && t[2] != t[0];
  }
  /// `k` may be up to 5, as in the following
  std::uint32_t vertex(std::uint32_t face, std::uint32_t k) const {
    return m_surface->triangle(face)[k % 3];
  }
  double length(std::uint32_t face, std::uint32_t k) const { return m_lengths[3 * face + k % 3]; }
  double corner_angle(std::uint32_t face, std::uint32_t k) const {
    return m_angles[3 * face + k % 3];
  }
  /// the third corner of a face, in a frame in which a side runs from the origin along the first
  /// axis
  Plane_vector apex(const Side& side) const {
    const double l = length(side.face, side.number), a = length(side.face, side.number + 2),
                 b = length(side.face, side.number + 1);
    const double x = l > 0 ? (l * l + (a - b) * (a + b)) / (2 * l) : 0;
    return {x, std::sqrt((std::max)(0., (a - x) * (a + x)))};
  }
  /// the corners of a face in the frame of its side 0
  std::array<Plane_vector, 3> corners(std::uint32_t face) const {
    return {Plane_vector{0, 0}, {length(face, 0), 0}, apex({face, 0})};
  }
  /// a point of a face in that frame
  Plane_vector place(std::uint32_t face, const std::array<double, 3>& barycentric) const {
    const std::array<Plane_vector, 3> c = corners(face);
    return barycentric[1] * c[1] + barycentric[2] * c[2];
  }
  /// the corner that barycentric coordinates are those of, or 3
  static std::uint32_t corner_of(const std::array<double, 3>& barycentric) {
    for(std::uint32_t k = 0; k < 3; ++k)
      if(barycentric[k] == 1)
        return k;
    return 3;
  }
  /// barycentric coordinates of a point on a side, in the face of another side along it
  std::array<double, 3> beyond(const Side& side, const Side& other,
                               const std::array<double, 3>& barycentric) const {
    const std::uint32_t a = side.number, b = (a + 1) % 3, c = other.number, d = (c + 1) % 3;
    const bool same_way = vertex(other.face, c) == vertex(side.face, a);
    std::array<double, 3> result = {0, 0, 0};
    result[c] = barycentric[same_way ? a : b];
    result[d] = barycentric[same_way ? b : a];
    return result;
  }
  /// calls `visit(side)` for the sides of other faces that run along a side
  template <class Visitor> void for_each_beyond(const Side& side, Visitor&& visit) const {
    for(const Side& other : m_edges.sides(m_edge_of_side[3 * side.face + side.number]))
      if(other.face != side.face && is_used(other.face))
        visit(other);
  }
  /// calls `visit(corner)` for the corners at a vertex
  template <class Visitor> void for_each_corner(std::uint32_t v, Visitor&& visit) const {
    for(const std::uint32_t i : m_corners[v])
      visit(Corner{i / 3, i % 3});
  }
  bool has_corner(std::uint32_t v) const { return !m_corners[v].empty(); }
  /// calls `visit(side)` for the sides with no other face beyond
  template <class Visitor> void for_each_boundary_side(Visitor&& visit) const {
    for(std::size_t e = 0; e < m_edges.size(); ++e)
      if(m_edges.sides(e).size() == 1 && is_used(m_edges.sides(e).begin()->face))
        visit(*m_edges.sides(e).begin());
  }

  /// whether no edge has more than two faces
  bool is_manifold() const { return m_is_manifold; }

  /// whether the corners of a vertex form a fan, open or closed
  bool has_fan(std::uint32_t v) const { return m_total_angles[v] > 0; }
  /// the sum of the angles in a fan
  double total_angle(std::uint32_t v) const { return m_total_angles[v]; }
  bool is_on_boundary(std::uint32_t v) const { return m_is_on_boundary[v] != 0; }
  /// whether the surface is flat at a vertex inside it, or nearly so
  bool is_flat(std::uint32_t v) const {
    constexpr double largest_defect = 0.03;
    return !is_on_boundary(v) && std::abs(total_angle(v) - 2 * CGAL_PI) < largest_defect;
  }
  /// The angle in the fan of a direction in a corner, `t` from the side that begins there; NaN
  /// without a fan.
  double fan_angle(std::uint32_t face, std::uint32_t k, double t) const {
    const std::size_t i = 3 * face + k % 3;
    return m_starts_at_next[i] ? m_first_angles[i] + t : m_first_angles[i] + m_angles[i] - t;
  }
  /// whether angles in the fan grow from one of the two sides at a corner into the face
  /// \param begins whether it is the side that begins there
  bool grows_from(std::uint32_t face, std::uint32_t k, bool begins) const {
    return (m_starts_at_next[3 * face + k % 3] != 0) == begins;
  }
  /// The angles `t` of those directions in a corner that lie between two angles in the fan; none if
  /// the second is not larger than the first.
  std::array<double, 2> part_of_corner(const Corner& c, double low, double high) const {
    const std::size_t i = 3 * c.face + c.number;
    low = (std::max)(low - m_first_angles[i], 0.);
    high = (std::min)(high - m_first_angles[i], m_angles[i]);
    if(m_starts_at_next[i])
      return {low, high};
    return {m_angles[i] - high, m_angles[i] - low};
  }
  /// the angle between two directions in a fan, the smaller way around
  double difference(std::uint32_t v, double a, double b) const {
    const double d = std::abs(a - b);
    return m_is_on_boundary[v] ? d : (std::min)(d, m_total_angles[v] - d);
  }
  /// The angle of a direction in a fan from the side that begins at a corner, growing into the
  /// face, the smaller way around from the middle of the corner.
  double angle_in_corner(const Corner& c, double phi) const {
    const std::size_t i = 3 * c.face + c.number;
    const double total = m_total_angles[m_surface->triangle(c.face)[c.number]],
                 middle = m_first_angles[i] + m_angles[i] / 2;
    double t = phi - middle;
    if(!m_is_on_boundary[m_surface->triangle(c.face)[c.number]])
      t = t > total / 2 ? t - total : t < -total / 2 ? t + total : t;
    return m_angles[i] / 2 + (m_starts_at_next[i] ? t : -t);
  }
  /// a direction in a fan as a unit vector
  Vector_3 direction(std::uint32_t v, double phi) const {
    Corner best = {0, 0};
    double excess = std::numeric_limits<double>::infinity(), angle = 0;
    for_each_corner(v, [&](const Corner& c) {
      const double t = angle_in_corner(c, phi),
                   out = (std::max)(-t, t - m_angles[3 * c.face + c.number]);
      if(out < excess) {
        excess = out;
        best = c;
        angle = t;
      }
    });
    const Point_3& o = m_surface->point(v);
    const Vector_3 a = unit_or_zero(m_surface->point(best.face, (best.number + 1) % 3) - o),
                   b = m_surface->point(best.face, (best.number + 2) % 3) - o;
    return std::cos(angle) * a + std::sin(angle) * unit_or_zero(b - (b * a) * a);
  }

private:
  void make_fan(std::uint32_t v) {
    const auto corners = m_corners[v];
    for(const std::uint32_t i : corners)
      m_first_angles[i] = std::numeric_limits<double>::quiet_NaN();
    if(corners.empty())
      return;
    const auto sides = [&](std::uint32_t face, std::uint32_t side) {
      return m_edges.sides(m_edge_of_side[3 * face + side]);
    };
    // at the boundary, if the vertex is on one, else anywhere
    Corner c{corners[0] / 3, corners[0] % 3};
    std::uint32_t in = c.number;
    for(const std::uint32_t i : corners)
      for(const std::uint32_t side : {i % 3, (i + 2) % 3})
        if(sides(i / 3, side).size() == 1) {
          m_is_on_boundary[v] = 1;
          c = {i / 3, i % 3};
          in = side;
        }
    const Corner start = c;
    double angle = 0;
    bool is_fan = true;
    for(std::size_t met = 0;;) {
      const std::size_t i = 3 * c.face + c.number;
      if(!std::isnan(m_first_angles[i])) {
        is_fan = c.face == start.face && met == corners.size();
        break;
      }
      m_first_angles[i] = angle;
      m_starts_at_next[i] = in == c.number;
      angle += m_angles[i];
      ++met;
      const auto beyond = sides(c.face, in == c.number ? (c.number + 2) % 3 : c.number);
      if(beyond.size() != 2) {
        is_fan = beyond.size() == 1 && met == corners.size();
        break;
      }
      const Side& next = beyond.begin()->face == c.face ? beyond.begin()[1] : *beyond.begin();
      const auto& t = m_surface->triangle(next.face);
      c = {next.face, t[0] == v ? 0u : t[1] == v ? 1u : 2u};
      in = next.number;
    }
    if(is_fan && angle > 0)
      m_total_angles[v] = angle;
    else
      for(const std::uint32_t i : corners)
        m_first_angles[i] = std::numeric_limits<double>::quiet_NaN();
  }

  const Triangulated_surface_3* m_surface;
  Surface_edges m_edges;
  std::vector<std::uint32_t> m_edge_of_side;
  std::vector<double> m_lengths, m_angles, m_first_angles; // of sides; of corners, in fans
  std::vector<char>
      m_starts_at_next;   // whether the first angle is that of the side which begins there
  Number_lists m_corners; // of vertices: 3 * face + number
  std::vector<double> m_total_angles; // of vertices; 0 without a fan
  std::vector<char> m_is_on_boundary;
  bool m_is_manifold = true;
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_GEODESICS_INTERNAL_RAY_GEOMETRY_H
