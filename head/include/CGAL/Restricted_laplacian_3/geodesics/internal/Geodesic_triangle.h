// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_GEODESICS_INTERNAL_GEODESIC_TRIANGLE_H
#define CGAL_RESTRICTED_LAPLACIAN_3_GEODESICS_INTERNAL_GEODESIC_TRIANGLE_H

#include <CGAL/Restricted_laplacian_3/geodesics/internal/Ray_geometry.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// a source in a face: a segment, or a point
struct Source_part {
  std::uint32_t face;
  std::array<double, 3> from, to;
  std::uint32_t label;
};

/// The distance in a triangle whose corners know theirs, in the frame of its side 0.
///
/// - In a face with sources that give the corners their distances, it is that from these.
/// - Else, if the directions of all rays are known, the squared distance is the cubic polynomial
/// that has
///   the squares and their gradients at the corners, and reproduces all quadratic ones: exact for
///   rays from one point, and for parallel ones.
/// - Where rays from different sides meet, so that the slopes at two corners point to each other,
/// it
///   is the least distance from the points that the corners see, and what is linear and makes that
///   right at the corners.
/// - Without the directions the squared distance is the quadratic polynomial that is exact for rays
///   from one point.
class Geodesic_triangle {
public:
  using Barycentric = std::array<double, 3>;
  /// a distance, and its gradient
  struct Value {
    double distance = std::numeric_limits<double>::infinity();
    Plane_vector gradient;
  };

  /// \param distances of the corners, in the unit of the geometry
  /// \param angles in the fans of the corners; NaN if they are not known
  /// \param first, last the sources in the face, which are referred to
  Geodesic_triangle(const Ray_geometry& geometry, std::uint32_t face, const Barycentric& distances,
                    const Barycentric& angles, const Source_part* first, const Source_part* last)
    : m_corners(geometry.corners(face)), m_distances(distances), m_first_source(first),
      m_last_source(last) {
    if(first != last && sees_all_sources()) {
      m_form = Form::sources;
      return;
    }
    for(std::uint32_t k = 0; k < 3; ++k) {
      const Plane_vector side = m_corners[(k + 1) % 3] - m_corners[k];
      const double length = side.length();
      if(m_distances[k] > 0 && !(std::isfinite(angles[k]) && length > 0)) {
        m_form = Form::quadratic;
        return;
      }
      if(!(m_distances[k] > 0))
        continue;
      const double t = geometry.angle_in_corner({face, k}, angles[k]);
      const Plane_vector u = (-1 / length) * side;
      m_gradients[k] = {std::cos(t) * u.x - std::sin(t) * u.y,
                        std::sin(t) * u.x + std::cos(t) * u.y};
    }
    for(std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      const Plane_vector side = m_corners[next] - m_corners[k];
      if(m_distances[k] > 0 && m_distances[next] > 0 &&
         dot(m_gradients[k] - m_gradients[next], side) > ridge * side.length())
        m_form = Form::ridge;
    }
  }

  /// at barycentric coordinates
  Value operator()(const Barycentric& l) const {
    if(!std::isfinite(m_distances[0] + m_distances[1] + m_distances[2]))
      return {};
    const Value of_sources = from_sources(l);
    if(m_form == Form::sources)
      return of_sources;
    const Value of_corners = m_form == Form::ridge ? at_ridge(l) : from_square(l);
    return of_sources.distance < of_corners.distance ? of_sources : of_corners;
  }

  /// The same, not shorter or longer than the triangle inequality with the corners permits: no
  /// point is wrong by more than its distance from a corner. This makes gradients too short where
  /// it acts.
  Value bounded(const Barycentric& l) const {
    Value result = (*this)(l);
    const Plane_vector p = place(l);
    for(std::size_t k = 0; k < 3; ++k) {
      const Plane_vector from = p - m_corners[k];
      const double length = from.length(), longest = m_distances[k] + length,
                   shortest = m_distances[k] - length;
      if(result.distance > longest + rounding)
        result = {longest, unit_of(from)};
      else if(result.distance < shortest - rounding)
        result = {shortest, -1 * unit_of(from)};
    }
    return result;
  }

  /// what a corner knows
  double corner_distance(std::size_t k) const { return m_distances[k]; }
  /// calls `visit(source)` for the sources in the face
  template <class Visitor> void for_each_source(Visitor&& visit) const {
    std::for_each(m_first_source, m_last_source, visit);
  }
  /// the place of a point of a source that is next to a point of the triangle
  Barycentric nearest(const Source_part& source, const Barycentric& l) const {
    const Plane_vector a = place(source.from), way = place(source.to) - a;
    const double square = dot(way, way),
                 t = square > 0 ? std::clamp(dot(place(l) - a, way) / square, 0., 1.) : 0;
    Barycentric result;
    for(std::size_t k = 0; k < 3; ++k)
      result[k] = (1 - t) * source.from[k] + t * source.to[k];
    return result;
  }

private:
  enum class Form { sources, cubic, ridge, quadratic };

  static constexpr double rounding = 1e-14;
  /// There is a ridge if the slope along a side, which rises from one corner, falls by so much on
  /// the way to the other one.
  static constexpr double ridge = 0.2;
  /// Gradients are cut at this length, but not at 1: their mean would be too small.
  static constexpr double longest_gradient = 1.2;

  static Plane_vector unit_of(const Plane_vector& v) {
    const double length = v.length();
    return length > 0 ? (1 / length) * v : v;
  }
  Plane_vector place(const Barycentric& l) const {
    return l[0] * m_corners[0] + l[1] * m_corners[1] + l[2] * m_corners[2];
  }
  /// \param d derivatives by the barycentric coordinates
  Plane_vector gradient(const Barycentric& d) const {
    Plane_vector result;
    double twice_area = cross(m_corners[1] - m_corners[0], m_corners[2] - m_corners[0]);
    if(!(twice_area > 0))
      return result;
    for(std::size_t k = 0; k < 3; ++k) {
      const Plane_vector side = m_corners[(k + 2) % 3] - m_corners[(k + 1) % 3];
      result = result + (d[k] / twice_area) * Plane_vector{-side.y, side.x};
    }
    return result;
  }
  static Value cut(double distance, const Plane_vector& gradient) {
    const double length = gradient.length();
    return {distance,
            length > longest_gradient ? (longest_gradient / length) * gradient : gradient};
  }

  Value from_sources(const Barycentric& l) const {
    Value result;
    if(m_first_source == m_last_source)
      return result;
    for(const Source_part* source = m_first_source; source != m_last_source; ++source) {
      const Plane_vector from = place(l) - place(nearest(*source, l));
      if(const double distance = from.length(); distance < result.distance)
        result = {distance, unit_of(from)};
    }
    // what is nearer has no direction but that of rounding errors
    return result.distance > rounding ? result : Value{0, {}};
  }
  bool sees_all_sources() const {
    for(std::size_t k = 0; k < 3; ++k) {
      Barycentric corner = {0, 0, 0};
      corner[k] = 1;
      if(!(from_sources(corner).distance <= m_distances[k] * (1 + 1e-9)))
        return false;
    }
    return true;
  }

  Value from_square(const Barycentric& l) const {
    double square = 0;
    Barycentric d;
    if(m_form == Form::quadratic)
      for(std::size_t k = 0; k < 3; ++k) {
        const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
        const double own = m_distances[k] * m_distances[k];
        square += l[k] * own - l[i] * l[j] * squared_side(i, j);
        d[k] = own - l[i] * squared_side(k, i) - l[j] * squared_side(k, j);
      }
    else {
      // Bezier points: at a corner, a third from there to another one, and the middle
      Barycentric own;
      std::array<Barycentric, 3> toward;
      double middle = 0;
      for(std::size_t k = 0; k < 3; ++k) {
        own[k] = m_distances[k] * m_distances[k];
        middle -= own[k] / 6;
        for(const std::size_t i : {(k + 1) % 3, (k + 2) % 3}) {
          toward[k][i] =
              own[k] + 2. / 3 * m_distances[k] * dot(m_gradients[k], m_corners[i] - m_corners[k]);
          middle += toward[k][i] / 4;
        }
      }
      square = 6 * middle * l[0] * l[1] * l[2];
      for(std::size_t k = 0; k < 3; ++k) {
        const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
        const double along = toward[k][i] * l[i] + toward[k][j] * l[j];
        square += l[k] * l[k] * (own[k] * l[k] + 3 * along);
        d[k] = 3 * l[k] * (own[k] * l[k] + 2 * along) +
               3 * (toward[i][k] * l[i] * l[i] + toward[j][k] * l[j] * l[j]) +
               6 * middle * l[i] * l[j];
      }
    }
    if(!(square > 0))
      return {0, {}};
    const double distance = std::sqrt(square);
    return cut(distance, 1 / (2 * distance) * gradient(d));
  }
  double squared_side(std::size_t i, std::size_t j) const {
    const Plane_vector side = m_corners[i] - m_corners[j];
    return dot(side, side);
  }

  Value at_ridge(const Barycentric& l) const {
    const Plane_vector p = place(l);
    Value result;
    Barycentric missing = {0, 0, 0}; // at the corners, at least 0: each sees its own distance
    for(std::size_t k = 0; k < 3; ++k) {
      const Plane_vector source = m_corners[k] - m_distances[k] * m_gradients[k], from = p - source;
      const double distance = from.length();
      if(distance < result.distance)
        result = {distance, unit_of(from)};
      for(std::size_t i = 0; i < 3; ++i)
        missing[i] = (std::max)(missing[i], m_distances[i] - (m_corners[i] - source).length());
    }
    return cut(result.distance + l[0] * missing[0] + l[1] * missing[1] + l[2] * missing[2],
               result.gradient + gradient(missing));
  }

  std::array<Plane_vector, 3> m_corners;
  std::array<Plane_vector, 3> m_gradients = {};
  Barycentric m_distances;
  const Source_part *m_first_source, *m_last_source;
  Form m_form = Form::cubic;
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_GEODESICS_INTERNAL_GEODESIC_TRIANGLE_H
