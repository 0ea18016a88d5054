// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_GEODESICS_INTERNAL_FACE_STRIP_H
#define CGAL_RESTRICTED_LAPLACIAN_3_GEODESICS_INTERNAL_FACE_STRIP_H

#include <CGAL/Restricted_laplacian_3/geodesics/internal/Ray_geometry.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// Faces, each beyond a side of the one before, from a point in the first of them to one in the
/// last: a strip that unfolds into a plane. The shortest path in a strip is that of the funnel
/// algorithm (Lee and Preparata, Networks 14, 1984): straight but at some vertices. Where it bends
/// by more than the surface on the other side of the vertex needs, the strip is led around there,
/// and the path becomes shorter, until it is shortest among all paths close by.
class Face_strip {
public:
  using Side = Ray_geometry::Side;
  using Barycentric = std::array<double, 3>;
  /// a part of a path, in one face
  struct Segment {
    std::uint32_t face;
    Barycentric from, to;
  };

  Face_strip(const Ray_geometry& geometry, std::uint32_t face, const Barycentric& start)
    : m_geometry(&geometry), m_first_face(face), m_start(start) {}

  /// goes on from the last face into another one
  void cross(const Side& out, const Side& in) { m_crossings.push_back({out, in}); }
  /// \param end a point of the last face
  void end_at(const Barycentric& end) { m_end = end; }

  /// the shortest path close by, without segments of no length
  std::vector<Segment> shortest_path() {
    // Each time the path becomes shorter, by what rounding leaves of it.
    const std::size_t most_turns = 100 + 10 * m_crossings.size();
    std::vector<Bend> bends;
    for(std::size_t turn = 0;; ++turn) {
      clean();
      unfold();
      bends = pull();
      if(turn == most_turns || !go_around_a_vertex(bends))
        break;
    }
    return segments(bends);
  }

private:
  struct Crossing {
    Side out, in;
  };
  /// The place of a side between two faces in the plane, seen on the way.
  struct Portal {
    Plane_vector left, right;
    std::uint32_t left_vertex, right_vertex;
  };
  /// a vertex at which the path turns
  struct Bend {
    std::size_t portal; // one that ends there
    bool is_left;
    Plane_vector place;
  };

  /// removes what goes forth and back, and sides on which the first point is
  void clean() {
    std::vector<Crossing> kept;
    for(const Crossing& c : m_crossings)
      if(!kept.empty() && same(kept.back().in, c.out) && same(kept.back().out, c.in))
        kept.pop_back();
      else
        kept.push_back(c);
    std::size_t first = 0;
    for(; first < kept.size() && is_on(m_start, kept[first].out); ++first) {
      m_start = m_geometry->beyond(kept[first].out, kept[first].in, m_start);
      m_first_face = kept[first].in.face;
    }
    m_crossings.assign(kept.begin() + static_cast<std::ptrdiff_t>(first), kept.end());
  }
  static bool same(const Side& a, const Side& b) {
    return a.face == b.face && a.number == b.number;
  }
  static bool is_on(const Barycentric& l, const Side& side) {
    return l[(side.number + 2) % 3] == 0;
  }

  static Plane_vector place(const std::array<Plane_vector, 3>& corners, const Barycentric& l) {
    return l[0] * corners[0] + l[1] * corners[1] + l[2] * corners[2];
  }

  void unfold() {
    m_portals.clear();
    std::array<Plane_vector, 3> corners = m_geometry->corners(m_first_face);
    m_start_place = place(corners, m_start);
    bool is_turned_over = false; // whether corners run clockwise
    for(const auto& [out, in] : m_crossings) {
      const std::uint32_t p = out.number, q = (p + 1) % 3, a = in.number, b = (a + 1) % 3;
      const bool same_way = m_geometry->vertex(out.face, p) == m_geometry->vertex(in.face, a);
      Portal portal{corners[q], corners[p], m_geometry->vertex(out.face, q),
                    m_geometry->vertex(out.face, p)};
      if(is_turned_over) {
        std::swap(portal.left, portal.right);
        std::swap(portal.left_vertex, portal.right_vertex);
      }
      m_portals.push_back(portal);
      is_turned_over = is_turned_over != same_way;
      std::array<Plane_vector, 3> next;
      next[a] = corners[same_way ? p : q];
      next[b] = corners[same_way ? q : p];
      const Plane_vector apex = m_geometry->apex(in), side = next[b] - next[a];
      const double l = side.length();
      const Plane_vector u = l > 0 ? (1 / l) * side : Plane_vector{1, 0};
      const double y = is_turned_over ? -apex.y : apex.y;
      next[(a + 2) % 3] = next[a] + Plane_vector{apex.x * u.x - y * u.y, apex.x * u.y + y * u.x};
      corners = next;
    }
    m_end_place = place(corners, m_end);
  }

  /// One side of the funnel, seen from its apex: where the portal ends there, and the leg, which is
  /// the end of a portal before that narrows the view. Angles are followed from portal to portal,
  /// because strips wind around vertices by any angle.
  struct Funnel_side {
    Plane_vector end; // 0 if it is the apex, or if there is none yet
    double angle = 0, angle_of_leg = 0;
    bool has_leg = false;
    std::size_t portal = 0; // of the leg

    bool has_end() const { return end.x != 0 || end.y != 0; }
    /// \param other the other side, which has its new end
    /// \param sign of the angle from the other side to this one
    void move(const Plane_vector& to, const Funnel_side& other, double sign) {
      if(has_end())
        angle += signed_angle(end, to);
      else if(other.has_end())
        angle = other.angle + sign * internal::angle(other.end, to);
      end = to;
    }
    void make_leg(std::size_t i) {
      has_leg = true;
      angle_of_leg = angle;
      portal = i;
    }
  };
  static double signed_angle(const Plane_vector& a, const Plane_vector& b) {
    return std::atan2(internal::cross(a, b), dot(a, b));
  }

  /// the bends of the shortest path in the strip
  std::vector<Bend> pull() const {
    std::vector<Bend> bends;
    Plane_vector apex = m_start_place;
    Funnel_side left, right;
    const auto bend_at = [&](std::size_t portal, bool is_left) {
      apex = is_left ? m_portals[portal].left : m_portals[portal].right;
      bends.push_back({portal, is_left, apex});
      left = right = {};
      return portal; // from which it goes on
    };
    for(std::size_t i = 0; i <= m_portals.size(); ++i) {
      if(i == m_portals.size()) {
        const Plane_vector end = m_end_place - apex;
        const Funnel_side& from = right.has_end() ? right : left;
        const double angle = from.angle + signed_angle(from.end, end);
        if(left.has_leg && angle > left.angle_of_leg)
          i = bend_at(left.portal, true);
        else if(right.has_leg && angle < right.angle_of_leg)
          i = bend_at(right.portal, false);
        continue;
      }
      const Plane_vector l = m_portals[i].left - apex, r = m_portals[i].right - apex;
      if(left.has_end()) {
        left.move(l, right, 1);
        right.move(r, left, -1);
      } else {
        right.move(r, left, -1);
        left.move(l, right, 1);
      }
      if(right.has_end() && !(right.has_leg && right.angle < right.angle_of_leg)) {
        if(left.has_leg && right.angle >= left.angle_of_leg) {
          i = bend_at(left.portal, true);
          continue;
        }
        right.make_leg(i);
      }
      if(left.has_end() && !(left.has_leg && left.angle > left.angle_of_leg)) {
        if(right.has_leg && left.angle <= right.angle_of_leg) {
          i = bend_at(right.portal, false);
          continue;
        }
        left.make_leg(i);
      }
    }
    return bends;
  }

  /// leads the strip around the other side of the first vertex where that is shorter
  bool go_around_a_vertex(const std::vector<Bend>& bends) {
    constexpr double rounding = 1e-9;
    for(std::size_t i = 0; i < bends.size(); ++i) {
      const Bend& bend = bends[i];
      const Portal& portal = m_portals[bend.portal];
      const std::uint32_t v = bend.is_left ? portal.left_vertex : portal.right_vertex;
      if(!m_geometry->has_fan(v) || m_geometry->is_on_boundary(v))
        continue;
      const Plane_vector before = i > 0 ? bends[i - 1].place : m_start_place,
                         after = i + 1 < bends.size() ? bends[i + 1].place : m_end_place;
      // The strip may wind around the vertex at which the path ends: that is no bend.
      if((after - bend.place).length() == 0)
        continue;
      const double turn = angle(bend.place - before, after - bend.place);
      if(m_geometry->total_angle(v) - (CGAL_PI + turn) < CGAL_PI - rounding) {
        go_around(v, bend.portal);
        return true;
      }
    }
    return false;
  }

  /// \param portal one that ends at the vertex
  void go_around(std::uint32_t v, std::size_t portal) {
    const auto ends_at_v = [&](std::size_t i) {
      return m_portals[i].left_vertex == v || m_portals[i].right_vertex == v;
    };
    std::size_t first = portal, last = portal;
    while(first > 0 && ends_at_v(first - 1))
      --first;
    while(last + 1 < m_portals.size() && ends_at_v(last + 1))
      ++last;
    std::vector<Crossing> around(m_crossings.begin(),
                                 m_crossings.begin() + static_cast<std::ptrdiff_t>(first));
    Side taken = m_crossings[first].out;
    while(taken.face != m_crossings[last].in.face) {
      std::uint32_t k = 0; // the corner, of whose sides it is the other one
      while(m_geometry->vertex(taken.face, k) != v)
        ++k;
      const Side out{taken.face, taken.number == k ? (k + 2) % 3 : k};
      m_geometry->for_each_beyond(out, [&](const Side& in) { taken = in; });
      around.push_back({out, taken});
    }
    around.insert(around.end(), m_crossings.begin() + static_cast<std::ptrdiff_t>(last + 1),
                  m_crossings.end());
    m_crossings.swap(around);
  }

  /// where a segment passes a portal: 0 at its right end, 1 at its left one
  static double part_to_left(const Portal& portal, const Plane_vector& begin,
                             const Plane_vector& end) {
    const auto same = [](const Plane_vector& a, const Plane_vector& b) {
      return a.x == b.x && a.y == b.y;
    };
    if(same(portal.left, begin) || same(portal.left, end))
      return 1;
    if(same(portal.right, begin) || same(portal.right, end))
      return 0;
    const double l = internal::cross(end - begin, portal.left - begin),
                 r = internal::cross(end - begin, portal.right - begin);
    return l - r > 0 ? std::clamp(-r / (l - r), 0., 1.) : 0;
  }

  std::vector<Segment> segments(const std::vector<Bend>& bends) const {
    std::vector<Segment> result;
    std::uint32_t face = m_first_face;
    Barycentric from = m_start;
    std::size_t next = 0; // bend
    Plane_vector begin = m_start_place;
    const auto add = [&](const Barycentric& to) {
      if(from != to)
        result.push_back({face, from, to});
    };
    for(std::size_t i = 0; i < m_portals.size(); ++i) {
      const auto& [out, in] = m_crossings[i];
      const Portal& portal = m_portals[i];
      if(next < bends.size() && bends[next].portal == i)
        begin = bends[next++].place;
      const Plane_vector end = next < bends.size() ? bends[next].place : m_end_place;
      const double to_left = part_to_left(portal, begin, end);
      const auto on = [&](const Side& side) {
        Barycentric l = {0, 0, 0};
        const bool is_left = m_geometry->vertex(side.face, side.number) == portal.left_vertex;
        l[side.number] = is_left ? to_left : 1 - to_left;
        l[(side.number + 1) % 3] = 1 - l[side.number];
        return l;
      };
      add(on(out));
      from = on(in);
      face = in.face;
    }
    add(m_end);
    return result;
  }

  const Ray_geometry* m_geometry;
  std::uint32_t m_first_face;
  Barycentric m_start, m_end = {1, 0, 0};
  std::vector<Crossing> m_crossings;
  // unfolded
  std::vector<Portal> m_portals;
  Plane_vector m_start_place, m_end_place;
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_GEODESICS_INTERNAL_FACE_STRIP_H
