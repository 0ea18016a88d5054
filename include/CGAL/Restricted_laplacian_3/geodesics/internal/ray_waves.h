// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_GEODESICS_INTERNAL_RAY_WAVES_H
#define CGAL_RESTRICTED_LAPLACIAN_3_GEODESICS_INTERNAL_RAY_WAVES_H

#include <CGAL/Restricted_laplacian_3/geodesics/internal/Ray_geometry.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// \file
/// The two forms in which rays pass through a side of a face, in the frame of that side: it runs
/// from the origin along the first axis, the face lies above, and the rays come from below.

constexpr std::uint32_t no_root = 0xffffffff;

/// where rays come from
struct Ray_origin {
  /// the distance of the point from which they come straight
  double offset = 0;
  /// the vertex which that point is, or `no_root`
  std::uint32_t root = no_root;
  /// of the source
  std::uint32_t label = 0;
};

/// A vertex is flat, though its angles sum to so much more than 2 pi by rounding.
constexpr double flat_by_rounding = 1e-7;

/// What is closer to the end of a side than this part of its length is at the end. A ray through a
/// vertex goes on to both sides of it; one of the two windows would be as wide as a rounding error,
/// and be divided again at each vertex on the line: on regular grids their number would double and
/// double. It is not made, and the one on the other side begins at the vertex, so none is lost.
constexpr double close_to_end = 1e-9;

/// A corner that is not farther from the opposite side, over its length, lies on it: lengths tell
/// the height of a face up to the root of rounding.
constexpr double no_height = 1e-7;

/// Where on the way from `p` to `q` a ray from `s` passes, in units of length.
inline double passing_point(const Plane_vector& s, const Plane_vector& direction,
                            const Plane_vector& p, const Plane_vector& q) {
  const Plane_vector e = q - p;
  const double n = cross(e, direction), t = n != 0 ? cross(direction, p - s) / n : 0;
  return (t > 1 - close_to_end ? 1 : t > close_to_end ? t : 0) * e.length();
}

/// Rays from one point that pass through the part of a side from `first` to `last`.
struct Ray_window {
  Ray_geometry::Side side;
  Plane_vector source;
  double first, last;
  Ray_origin origin;
  std::uint32_t next = no_root; // the next one of those that wait at the side

  double distance(double x) const {
    return origin.offset + Plane_vector{x - source.x, source.y}.length();
  }
  /// distance of the part from the point
  double height() const {
    return Plane_vector{(std::max)({0., first - source.x, source.x - last}), source.y}.length();
  }
};

/// Takes off the parts of a window to which the ends of its side give shorter ways. Squared, the
/// equation of equal ways from the source and from an end is linear.
/// \param l the length of the side
/// \param ends the distances of its ends
inline void narrow(Ray_window& w, double l, const std::array<double, 2>& ends) {
  const double y = std::abs(w.source.y), slack = close_to_end * l + 1e-15 * y,
               from_first = w.source.x, from_second = l - w.source.x;
  // how far from an end that is `along` from the foot of the source
  const auto equal = [&](double end, double along) {
    const double d = end - w.origin.offset;
    return (along * along + (y - d) * (y + d)) / (2 * (along + d));
  };
  if(ends[0] + w.first < w.distance(w.first))
    w.first = (std::max)(w.first, equal(ends[0], from_first) - slack);
  if(ends[1] + (l - w.last) < w.distance(w.last))
    w.last = (std::min)(w.last, l - equal(ends[1], from_second) + slack);
}

/// Rays of one point that pass through a side of a face, all in one frame.
struct Ray_beam {
  Plane_vector source;
  Plane_vector p, q;  // the ends of the side, in the order of the face
  double first, last; // the part of the side
};

/// A source in a face, which lies left of the side from `p` to `q`. If it lies in the side, since
/// the face has no height, it is moved off by next to nothing: else no rays would pass.
inline Plane_vector off_side(const Plane_vector& source, const Plane_vector& p,
                             const Plane_vector& q) {
  constexpr double least_height = 1e-12; // over the length of the side
  const Plane_vector e = q - p;
  const double square = dot(e, e), along = dot(source - p, e),
               missing = least_height * square - std::abs(cross(e, source - p));
  if(!(missing > 0 && along > 0 && along < square))
    return source;
  return source + missing / square * Plane_vector{-e.y, e.x};
}

/// Calls `visit(window)` for the windows in the faces beyond a side through which rays pass; none
/// if they come along the side.
template <class Visitor>
void for_each_window_beyond(const Ray_geometry& geometry, const Ray_geometry::Side& side,
                            const Ray_beam& beam, const Ray_origin& origin, Visitor&& visit) {
  constexpr double along_the_side = 1e-14;
  const double l = geometry.length(side.face, side.number), first = beam.first, last = beam.last;
  if(!(last > first))
    return;
  const Plane_vector u = (1 / l) * (beam.q - beam.p);
  const double x = dot(beam.source - beam.p, u),
               height = std::abs(internal::cross(u, beam.source - beam.p));
  if(!(height > along_the_side * l))
    return;
  geometry.for_each_beyond(side, [&](const Ray_geometry::Side& other) {
    const bool same =
        geometry.vertex(other.face, other.number) == geometry.vertex(side.face, side.number);
    Ray_window w;
    w.side = other;
    w.source = {same ? x : l - x, -height};
    w.first = same ? first : l - last;
    w.last = same ? last : l - first;
    w.origin = origin;
    visit(w);
  });
}

/// The nearest way through a side to the third corner of its face. Rays of other windows that
/// cross it give no point its distance: where they cross, it is not longer than they are, or they
/// would be nearer to the corner. So a window that is not nearer sends no ray across in the face.
/// If it sees the corner, it sends none to the other side of the way at all: followed back, the way
/// leaves the faces that the window has come through across those rays, since no vertex is there at
/// which it could begin (J. Chen and Y. Han, Shortest Paths on a Polyhedron, 1990: one angle, one
/// split).
struct Nearest_ray {
  double distance = std::numeric_limits<double>::infinity();
  double passes = 0;             // where, in units of length
  bool begins_at_vertex = false; // on a surface without edges of three faces
};

/// Where a window goes in its face: calls `at_apex(c, distance, passes)` with the third corner, its
/// distance from the source and where the ray passes the side, if that is seen, and
/// `through(side, beam)` for the other sides that rays pass through; all in the frame of the
/// window's side.
/// \param nearest the nearest way to the third corner, as far as it is known
template <class At_apex, class Through>
void cross_face(const Ray_geometry& geometry, const Ray_window& w, const Nearest_ray& nearest,
                At_apex&& at_apex, Through&& through) {
  constexpr double rounding = 1e-12;
  const std::uint32_t face = w.side.face, k = w.side.number;
  const Plane_vector &s = w.source, a{0, 0}, b{geometry.length(face, k), 0},
                     c = geometry.apex(w.side), to_apex = c - s;
  const double distance = to_apex.length(), passes = s.x - s.y * to_apex.x / to_apex.y;
  const auto sees_apex = [&](double tolerance) {
    const double slack = tolerance * b.x * distance / to_apex.y;
    return w.first < passes + slack && w.last > passes - slack;
  };
  const bool is_nearest = w.origin.offset + distance < nearest.distance * (1 - rounding);
  // the rays to the left side end, and those to the right side begin, at that to the corner
  double left_last = (std::min)(w.last, passes), right_first = (std::max)(w.first, passes);
  if(!is_nearest && std::abs(passes - nearest.passes) > close_to_end * b.x) {
    left_last = (std::min)(left_last, nearest.passes);
    right_first = (std::max)(right_first, nearest.passes);
    if(sees_apex(rounding) && nearest.begins_at_vertex)
      passes < nearest.passes ? right_first = w.last : left_last = w.first;
  }
  // The windows on the two sides of a vertex that is flat by rounding may leave a gap.
  if(sees_apex(flat_by_rounding))
    at_apex(c, distance, passes);
  const auto where = [&](double x, const Plane_vector& p, const Plane_vector& q) {
    return passing_point(s, {x - s.x, -s.y}, p, q);
  };
  if(left_last > w.first)
    through(Ray_geometry::Side{face, (k + 2) % 3},
            Ray_beam{s, c, a, where(left_last, c, a), where(w.first, c, a)});
  if(right_first < w.last)
    through(Ray_geometry::Side{face, (k + 1) % 3},
            Ray_beam{s, b, c, where(w.last, b, c), where(right_first, b, c)});
}

/// Squared distances along a side of the length `length`, less the offset before squaring: a cubic
/// in t from 0 to 1.
struct Ray_cubic {
  double length = 0;
  std::array<double, 4> coefficients = {0, 0, 0, 0};
  Ray_origin origin;

  Ray_cubic() = default;
  /// \param r0, r1 distances of the ends, less the offset
  /// \param slope0, slope1 their derivatives along the side
  Ray_cubic(double length, double r0, double r1, double slope0, double slope1,
            const Ray_origin& origin)
    : length(length), origin(origin) {
    const double y0 = r0 * r0, y1 = r1 * r1, m0 = 2 * r0 * slope0 * length,
                 m1 = 2 * r1 * slope1 * length;
    coefficients = {y0, m0, 3 * (y1 - y0) - 2 * m0 - m1, 2 * (y0 - y1) + m0 + m1};
  }

  /// the distance less the offset
  double distance(double t) const { return std::sqrt((std::max)(0., square(t))); }

  /// a way through the side to a point beyond
  struct Way {
    double t = 0, distance = std::numeric_limits<double>::infinity();
  };
  /// The shortest way to a point above the side, by Newton's method from where a ray crosses it
  /// that comes straight from the source of the two end distances; infinite if it leaves the side.
  Way shortest_way(const Plane_vector& c) const {
    constexpr double longest_step = 0.3;
    constexpr int newton_steps = 3;
    const Plane_vector s = source(0, 1);
    const bool is_on_side = c.y <= no_height * length;
    Way way;
    way.t = (is_on_side ? c.x : s.x - s.y * (c.x - s.x) / (c.y - s.y)) / length;
    double distance = 0;
    for(int step = 0;; ++step) {
      const double y = square(way.t), along = way.t * length - c.x,
                   beyond = Plane_vector{along, c.y}.length();
      if(!(y > 0))
        return {};
      const auto& q = coefficients;
      const double r = std::sqrt(y);
      distance = origin.offset + r + beyond;
      if(step == newton_steps || is_on_side)
        break;
      const double slope = q[1] + way.t * (2 * q[2] + 3 * way.t * q[3]),
                   curvature = 2 * q[2] + 6 * way.t * q[3],
                   second = curvature / (2 * r) - slope * slope / (4 * y * r) +
                            length * length * c.y * c.y / (beyond * beyond * beyond);
      if(!(second > 0))
        return {};
      const double move = -(slope / (2 * r) + length * along / beyond) / second;
      way.t += (std::max)(-longest_step, (std::min)(longest_step, move));
    }
    if(way.t >= -close_to_end && way.t <= 1 + close_to_end)
      way.distance = distance;
    return way;
  }

  /// the point from which the distances at two places come straight
  Plane_vector source(double t0, double t1) const {
    // Rays along the side come from close below it.
    constexpr double grazing = 1e-6;
    const double r0 = distance(t0), r1 = distance(t1), h = (t1 - t0) * length,
                 x = ((r0 - r1) * (r0 + r1) / h + h) / 2;
    return {t0 * length + x,
            -std::sqrt((std::max)((r0 - x) * (r0 + x), grazing * grazing * r0 * r0))};
  }

private:
  double square(double t) const {
    const auto& c = coefficients;
    return c[0] + t * (c[1] + t * (c[2] + t * c[3]));
  }
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_GEODESICS_INTERNAL_RAY_WAVES_H
