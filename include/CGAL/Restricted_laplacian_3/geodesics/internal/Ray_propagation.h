// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_GEODESICS_INTERNAL_RAY_PROPAGATION_H
#define CGAL_RESTRICTED_LAPLACIAN_3_GEODESICS_INTERNAL_RAY_PROPAGATION_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/Progress.h>
#include <CGAL/Restricted_laplacian_3/geodesics/internal/Propagation_limit.h>
#include <CGAL/Restricted_laplacian_3/geodesics/internal/Ray_geometry.h>
#include <CGAL/Restricted_laplacian_3/geodesics/internal/Ray_windows.h>
#include <CGAL/Restricted_laplacian_3/geodesics/internal/ray_waves.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// Propagates distances over the triangles, and with them the directions of their rays, in the
/// order of a Dijkstra heap. There are two ways from a side of a face through the face:
///
/// - Windows, which are exact: the rays from one source, unfolded into the plane of the face, that
///   enter through a part of the side (Mitchell, Mount, Papadimitriou 1987; pruned as by Xin and
///   Wang 2009). Sources are those given and the vertices at which rays turn: on the boundary,
///   where the faces form no fan, or where the angles sum to more than 2 pi. These send rays into
///   what lies in the shadow of their own ray only.
/// - A cubic, which costs the same for however many windows there are: distances and directions at
///   the two ends of a side give values and slopes of the squared distance along it, less that of
///   the source before squaring. Its cubic Hermite polynomial is exact for rays from one source.
///   The third corner minimizes over the side.
///
/// The cubic is used where it can be trusted: the two ends see the same source, to a part of the
/// side's length, and the side is short beside its distance from there. Windows that arrive at a
/// short side wait until the distances of both its ends are known, and go on only where the cubic
/// cannot be used; there more windows are made from the cubics at the two sides before. So close to
/// sources, at shadows, ridges and long needles distances are exact, and elsewhere one cubic takes
/// the place of many windows.
class Ray_propagation {
  static constexpr double infinity = std::numeric_limits<double>::infinity();

public:
  using Side = Ray_geometry::Side;
  using Corner = Ray_geometry::Corner;

  /// \param is_exact whether there are windows only
  /// \param maximum_memory in bytes
  Ray_propagation(const Ray_geometry& geometry, bool is_exact, double maximum_memory)
    : m_geometry(geometry), m_is_exact(is_exact), m_rays(geometry.surface().number_of_vertices()),
      m_is_popped(m_rays.size(), 0),
      m_states(3 * geometry.surface().number_of_faces(), is_exact ? State::windows : State::open),
      m_waiting(m_states.size(), no_root), m_nearest_rays(is_exact ? m_states.size() : 0),
      m_windows(maximum_memory,
                m_rays.size() * (sizeof(Ray) + sizeof(Entry)) +
                    m_states.size() * (sizeof(State) + sizeof(std::uint32_t)) +
                    m_nearest_rays.size() * sizeof(Nearest_ray),
                sizeof(Entry)) {}

  /// the ray from a vertex back to its source
  struct Ray {
    double distance = infinity;
    /// its angle in the fan; NaN if there is no fan, or if it is not known
    double angle = std::numeric_limits<double>::quiet_NaN();
    /// with an offset that is not less than 0
    Ray_origin origin;
  };

  void add_vertex(std::uint32_t v, std::uint32_t label) {
    Ray ray;
    ray.distance = 0;
    ray.origin = {0, v, label};
    offer(v, ray);
  }

  /// a point in a face, in the frame of its side 0; of a point on a side, the part in this face
  void add_point(std::uint32_t face, const Plane_vector& s, std::uint32_t label) {
    const std::array<Plane_vector, 3> corners = m_geometry.corners(face);
    for(std::uint32_t k = 0; k < 3; ++k) {
      const Plane_vector &p = corners[k], &q = corners[(k + 1) % 3];
      offer_from(face, k, corners, s, s, label);
      const bool has_height = m_geometry.apex({face, k}).y > no_height * m_geometry.length(face, k);
      add_beyond({face, k},
                 {has_height ? s : off_side(s, p, q), p, q, 0, m_geometry.length(face, k)},
                 {0, no_root, label});
    }
  }

  /// a segment in a face, in the frame of its side 0; of one along a side, the part in this face
  void add_segment(std::uint32_t face, const Plane_vector& a, const Plane_vector& b,
                   std::uint32_t label) {
    add_point(face, a, label);
    add_point(face, b, label);
    const double length = (b - a).length();
    if(!(length > 0))
      return;
    const std::array<Plane_vector, 3> corners = m_geometry.corners(face);
    const Plane_vector t = (1 / length) * (b - a);
    // Rays across the segment are parallel: they come from a source that is very far.
    for(const Plane_vector& n : {Plane_vector{-t.y, t.x}, Plane_vector{t.y, -t.x}}) {
      const Plane_vector source = a + 0.5 * length * t - far_source * n;
      for(std::uint32_t k = 0; k < 3; ++k) {
        const Plane_vector &p = corners[k], &q = corners[(k + 1) % 3];
        const double along = dot(p - a, t), across = dot(p - a, n);
        if(along >= 0 && along <= length && across >= 0)
          offer_from(face, k, corners, a + along * t, p - across * n, label);
        // the part of the side between the perpendiculars at a and b
        const double d_along = dot(q - p, t), d_across = dot(q - p, n);
        double low = 0, high = 1;
        const auto clip = [&](double value, double slope) { // value + x * slope >= 0
          if(slope > 0)
            low = (std::max)(low, -value / slope);
          else if(slope < 0)
            high = (std::min)(high, -value / slope);
          else if(value < 0)
            high = -1;
        };
        clip(along, d_along);
        clip(length - along, -d_along);
        clip(across, d_across);
        if((low + high) / 2 * d_across + across > 1e-12 * length)
          add_beyond({face, k}, {source, p, q, low * (q - p).length(), high * (q - p).length()},
                     {-far_source, no_root, label});
      }
    }
  }

  /// Distances of all vertices from what was added; infinite where there is no way, or beyond the
  /// limit. May be called once.
  /// \throws Parameter_error if there is more memory needed than permitted
  /// \throws Canceled
  std::vector<Ray> run(const Progress& progress, Propagation_limit limit) {
    for(std::size_t step = 0, popped_vertices = 0; !m_heap.empty(); ++step) {
      constexpr std::size_t steps_between_calls = 4096;
      if(step % steps_between_calls == 0)
        progress(static_cast<double>(popped_vertices) / static_cast<double>(m_rays.size()));
      const Entry next = m_heap.top();
      if(limit.is_beyond(next.key))
        break;
      m_heap.pop();
      if(next.is_window) {
        const Ray_window window = m_windows.take(next.number);
        if(is_useful(window))
          cross(window, all_ways);
      } else if(next.key == m_rays[next.number].distance && !is_shortened(next.number)) {
        if(std::exchange(m_is_popped[next.number], 1) == 0) {
          ++popped_vertices;
          limit.reach(next.number, next.key);
        }
        propagate(next.number);
      }
    }
    for(std::uint32_t v = 0; v < m_rays.size(); ++v)
      if(m_rays[v].distance > limit.distance())
        m_rays[v] = Ray();
      else if(std::isnan(m_rays[v].angle) && std::isfinite(m_rays[v].distance))
        look_along_edges(v);
    progress(1);
    return std::move(m_rays);
  }

private:
  /// gains below this part are rounding
  static constexpr double smallest_gain = 1e-10;
  /// A vertex is flat though its angles sum to so much more than 2 pi, also because among short
  /// sides, where cubics are used, the shadow behind it is too narrow to matter.
  static constexpr double flat_to_cubics = 3e-3;
  /// a ray along an edge may be on any side of it by rounding
  static constexpr double along_edge = 1e-9;
  /// A side shorter than this part of its distance from the source of its rays is short: there a
  /// cubic resolves them.
  static constexpr double short_side = 0.3;
  /// How far apart the sources may be that the two ends of a side see: the distances that each
  /// predicts at the other end, of a short side over its length; and the angle between their
  /// directions. On other sides they must be the same, up to a part of the least of the lengths of
  /// the ways: a long needle's third corner may be close to the source, and to the side.
  static constexpr double short_side_tolerance = 0.1, long_side_tolerance = 1e-3,
                          direction_tolerance = 0.1;
  /// Shadows are wider by this angle on both sides: rays have errors, and more windows do no harm.
  static constexpr double shadow_slack = 0.2;
  /// Windows that are made of a cubic: their number, and the part by which they overlap, and reach
  /// over flat ends of the side. Rays diverge, or are those of another cubic beyond the end, and
  /// would leave gaps.
  static constexpr int windows_of_cubic = 3;
  static constexpr double overlap = 0.3;
  /// Distance of the source of parallel rays, over the extent of the surface: rounding, and the
  /// curvature of what should be straight, are 1e-10 and 1e-7 then.
  static constexpr double far_source = 1e6;

  /// How rays go on from a side into its face: not known yet, both ends being popped; by the cubic,
  /// or not at all, because they come out of the face; by windows.
  enum class State : std::uint8_t { open, cubic, windows };

  struct Entry {
    double key;
    bool is_window;
    std::uint32_t number;

    friend bool operator>(const Entry& a, const Entry& b) {
      if(a.key != b.key)
        return a.key > b.key;
      return a.is_window != b.is_window ? a.is_window : a.number > b.number;
    }
  };

  void offer(std::uint32_t v, const Ray& ray) {
    Ray& known = m_rays[v];
    const double distance = known.distance;
    const bool is_shorter = ray.distance < distance * (1 - smallest_gain) ||
                            (std::isinf(distance) && std::isfinite(ray.distance));
    // Rays along edges are as long as others that arrive there, and have no direction yet.
    if(!is_shorter && (!std::isnan(known.angle) || std::isnan(ray.angle) ||
                       ray.distance > distance * (1 + smallest_gain) +
                                          smallest_gain / far_source * std::abs(ray.origin.offset)))
      return;
    known = ray;
    known.origin.offset = (std::max)(0., ray.origin.offset);
    if(is_shorter)
      m_heap.push({ray.distance, false, v});
    else
      known.distance = distance;
  }

  /// offers the distance of a corner from `nearest`, in the direction of `from`
  void offer_from(std::uint32_t face, std::uint32_t k, const std::array<Plane_vector, 3>& corners,
                  const Plane_vector& nearest, const Plane_vector& from, std::uint32_t label) {
    Ray ray;
    ray.distance = (corners[k] - nearest).length();
    ray.angle =
        m_geometry.fan_angle(face, k, angle(corners[(k + 1) % 3] - corners[k], from - corners[k]));
    ray.origin.label = label;
    offer(m_geometry.vertex(face, k), ray);
  }

  /// whether rays turn at a vertex
  bool is_root(std::uint32_t v) const {
    if(m_rays[v].distance == 0 || m_geometry.is_on_boundary(v) || !m_geometry.has_fan(v))
      return true;
    const double excess = m_geometry.total_angle(v) - 2 * CGAL_PI;
    return excess > flat_by_rounding &&
           (m_is_exact || excess > flat_to_cubics || !is_among_short_sides(v));
  }
  /// whether no side of the faces of a vertex is too long for a cubic
  bool is_among_short_sides(std::uint32_t v) const {
    double longest = 0;
    m_geometry.for_each_corner(v, [&](const Corner& c) {
      for(std::uint32_t k = 0; k < 3; ++k)
        longest = (std::max)(longest, m_geometry.length(c.face, k));
    });
    return longest <= short_side * (m_rays[v].distance - m_rays[v].origin.offset);
  }

  // Vertices

  void propagate(std::uint32_t v) {
    const bool is_root_here = is_root(v);
    m_geometry.for_each_corner(v, [&](const Corner& c) {
      // along the two sides, of which one begins here, and the other one ends
      offer_along({c.face, c.number}, v, true, is_root_here);
      offer_along({c.face, (c.number + 2) % 3}, v, false, is_root_here);
    });
    m_geometry.for_each_corner(v, [&](const Corner& c) {
      if(m_is_popped[m_geometry.vertex(c.face, c.number + 1)])
        close({c.face, c.number});
      if(m_is_popped[m_geometry.vertex(c.face, c.number + 2)])
        close({c.face, (c.number + 2) % 3});
    });
    if(is_root_here || std::isnan(m_rays[v].angle))
      m_geometry.for_each_corner(v, [&](const Corner& c) { emit(c); });
  }

  /// offers the way along a side to its other end
  void offer_along(const Side& side, std::uint32_t v, bool begins_here, bool is_root_here) {
    const std::uint32_t there = begins_here ? side.number + 1 : side.number;
    Ray ray = m_rays[v];
    ray.distance += m_geometry.length(side.face, side.number);
    ray.angle = std::numeric_limits<double>::quiet_NaN();
    if(is_root_here) {
      ray.origin = {m_rays[v].distance, v, ray.origin.label};
      ray.angle = m_geometry.fan_angle(side.face, there,
                                       begins_here ? m_geometry.corner_angle(side.face, there) : 0);
    }
    offer(m_geometry.vertex(side.face, there), ray);
  }

  /// The direction of a ray that is known to come along an edge. It is not used before: such rays
  /// may be a little longer than others that come later, with quite another direction.
  void look_along_edges(std::uint32_t v) {
    m_geometry.for_each_corner(v, [&](const Corner& c) {
      const auto look = [&](std::uint32_t side, std::uint32_t there, double t) {
        if(m_rays[m_geometry.vertex(c.face, there)].distance + m_geometry.length(c.face, side) <=
           m_rays[v].distance * (1 + smallest_gain))
          m_rays[v].angle = m_geometry.fan_angle(c.face, c.number, t);
      };
      look(c.number, c.number + 1, 0);
      look(c.number + 2, c.number + 2, m_geometry.corner_angle(c.face, c.number));
    });
  }

  /// Windows that are made of cubics may leave a gap at a vertex, which has the length of a way
  /// along edges then: whether the cubic at an opposite side gives a clearly shorter way, which it
  /// has now.
  bool is_shortened(std::uint32_t v) {
    constexpr double least_gain = 0.1; // over the length of the side
    if(m_is_exact || m_is_popped[v] || !std::isnan(m_rays[v].angle))
      return false;
    const double known = m_rays[v].distance;
    m_geometry.for_each_corner(v, [&](const Corner& c) {
      const Side side{c.face, (c.number + 1) % 3};
      if(!m_is_popped[m_geometry.vertex(side.face, side.number)] ||
         !m_is_popped[m_geometry.vertex(side.face, side.number + 1)])
        return;
      const Ends ends = ends_of(side);
      if(ends.is_regular && ends.is_short)
        offer_to_apex(side, ends.cubic, known - least_gain * ends.cubic.length);
    });
    return m_rays[v].distance < known;
  }

  /// rays from a vertex through the opposite side, into the shadow of its own ray
  void emit(const Corner& c) {
    const std::uint32_t v = m_geometry.vertex(c.face, c.number);
    const double phi = m_rays[v].angle, all = m_geometry.corner_angle(c.face, c.number);
    if(std::isnan(phi) || m_rays[v].distance == 0) {
      emit(c, {0, all});
      return;
    }
    const double total = m_geometry.total_angle(v), to_shadow = CGAL_PI - shadow_slack;
    if(m_geometry.is_on_boundary(v)) {
      emit(c, m_geometry.part_of_corner(c, phi + to_shadow, infinity));
      emit(c, m_geometry.part_of_corner(c, -infinity, phi - to_shadow));
    } else
      for(const double turn : {-total, 0., total})
        emit(c,
             m_geometry.part_of_corner(c, phi + to_shadow + turn, phi + total - to_shadow + turn));
  }
  /// \param part angles from the side that begins at the corner
  void emit(const Corner& c, const std::array<double, 2>& part) {
    if(!(part[1] > part[0]))
      return;
    const std::uint32_t v = m_geometry.vertex(c.face, c.number);
    const double all = m_geometry.corner_angle(c.face, c.number),
                 l = m_geometry.length(c.face, c.number),
                 m = m_geometry.length(c.face, c.number + 2);
    const Plane_vector p{l, 0}, q{m * std::cos(all), m * std::sin(all)}, s = off_side({0, 0}, p, q);
    const auto passes = [&](double t) {
      return passing_point(s, {std::cos(t), std::sin(t)}, p, q);
    };
    const Side opposite{c.face, (c.number + 1) % 3};
    const double first = part[0] <= 0 ? 0 : passes(part[0]),
                 last = part[1] >= all ? m_geometry.length(opposite.face, opposite.number)
                                       : passes(part[1]);
    add_beyond(opposite, {s, p, q, first, last}, {m_rays[v].distance, v, m_rays[v].origin.label});
  }

  // Windows

  /// Makes windows in the faces beyond a side of a face.
  void add_beyond(const Side& side, const Ray_beam& beam, const Ray_origin& origin) {
    for_each_window_beyond(m_geometry, side, beam, origin, [&](const Ray_window& w) { add(w); });
  }

  void add(Ray_window w) {
    if(!is_useful(w))
      return;
    if(m_is_exact) {
      narrow(w, m_geometry.length(w.side.face, w.side.number), end_distances(w.side));
      if(!(w.last > w.first))
        return;
    }
    const std::uint32_t i = m_windows.add(w);
    const std::size_t side = 3 * w.side.face + w.side.number;
    if(m_states[side] != State::windows &&
       m_geometry.length(w.side.face, w.side.number) <= short_side * w.height()) {
      m_windows[i].next = m_waiting[side];
      m_waiting[side] = i;
    } else
      m_heap.push({w.origin.offset + w.height(), true, i});
  }

  /// Whether a window can give any point its distance: not if one end of the side gives a shorter
  /// way to the far end of the window.
  bool is_useful(const Ray_window& w) const {
    constexpr double rounding = 1 - 1e-12;
    const std::array<double, 2> ends = end_distances(w.side);
    const double l = m_geometry.length(w.side.face, w.side.number);
    return !(ends[0] + w.last < w.distance(w.last) * rounding) &&
           !(ends[1] + (l - w.first) < w.distance(w.first) * rounding);
  }

  /// distances of the ends of a side
  std::array<double, 2> end_distances(const Side& side) const {
    return {m_rays[m_geometry.vertex(side.face, side.number)].distance,
            m_rays[m_geometry.vertex(side.face, side.number + 1)].distance};
  }

  static constexpr std::uint32_t all_ways = 3;

  /// takes a window through its face: to the third corner, and through the other sides
  /// \param target the number of a side, to go through that one only, or `all_ways`
  void cross(const Ray_window& w, std::uint32_t target) {
    const Plane_vector& s = w.source;
    // Windows of cubics have errors, and do not exclude each other.
    Nearest_ray none;
    Nearest_ray& nearest = m_is_exact ? m_nearest_rays[3 * w.side.face + w.side.number] : none;
    cross_face(
        m_geometry, w, nearest,
        [&](const Plane_vector& c, double distance, double passes) {
          if(target != all_ways)
            return;
          Ray ray;
          ray.distance = w.origin.offset + distance;
          if(ray.distance < nearest.distance)
            nearest = {ray.distance, passes, w.origin.root != no_root && m_geometry.is_manifold()};
          ray.angle = m_geometry.fan_angle(w.side.face, w.side.number + 2,
                                           angle(Plane_vector{0, 0} - c, s - c));
          ray.origin = w.origin;
          offer(m_geometry.vertex(w.side.face, w.side.number + 2), ray);
        },
        [&](const Side& side, const Ray_beam& beam) {
          if(target == all_ways || target == side.number)
            add_beyond(side, beam, w.origin);
        });
  }

  // Sides whose ends have distances

  /// what the ends of a side tell of the rays that pass into its face
  struct Ends {
    bool is_short = false;
    bool come_out = false;   // the rays of both, of the face
    bool is_regular = false; // whether the cubic can be trusted
    Ray_cubic cubic;
  };
  Ends ends_of(const Side& side) const {
    Ends ends;
    const std::uint32_t p = m_geometry.vertex(side.face, side.number),
                        q = m_geometry.vertex(side.face, side.number + 1);
    const Ray &at_p = m_rays[p], &at_q = m_rays[q];
    // An end may be the source of the other one's ray.
    const double offset_p = at_q.origin.root == p ? at_p.distance : at_p.origin.offset,
                 offset_q = at_p.origin.root == q ? at_q.distance : at_q.origin.offset,
                 l = m_geometry.length(side.face, side.number), from_p = at_p.distance - offset_p,
                 from_q = at_q.distance - offset_q;
    ends.is_short = l <= short_side * (std::min)(from_p, from_q);
    if(std::isnan(at_p.angle) || std::isnan(at_q.angle))
      return ends;
    const double along_p = m_geometry.fan_angle(side.face, side.number, 0),
                 along_q =
                     m_geometry.fan_angle(side.face, side.number + 1,
                                          m_geometry.corner_angle(side.face, side.number + 1));
    const bool first_comes_out = comes_out(side.face, side.number, true, along_p),
               second_comes_out = comes_out(side.face, (side.number + 1) % 3, false, along_q);
    ends.come_out = first_comes_out && second_comes_out;
    // derivatives of the distance along the side
    const double slope_p = -std::cos(m_geometry.difference(p, along_p, at_p.angle)),
                 slope_q = std::cos(m_geometry.difference(q, along_q, at_q.angle));
    // the sources that the ends see
    const auto behind = [](double c) { return -std::sqrt((std::max)(0., 1 - c * c)); };
    const Plane_vector end{l, 0}, middle{l / 2, 0},
        source_p{-from_p * slope_p, from_p * behind(slope_p)},
        source_q{l - from_q * slope_q, from_q * behind(slope_q)};
    const double limit =
        ends.is_short
            ? short_side_tolerance * l
            : long_side_tolerance * (std::min)({l, from_p, from_q, m_geometry.apex(side).y});
    Ray_origin older = offset_p < offset_q ? at_p.origin : at_q.origin;
    older.offset = (std::min)(offset_p, offset_q);
    const double r_p = at_p.distance - older.offset, r_q = at_q.distance - older.offset;
    ends.cubic = Ray_cubic(l, r_p, r_q, slope_p, slope_q, older);
    ends.is_regular = std::abs(r_p - r_q) <= l && r_p + r_q >= l && !first_comes_out &&
                      !second_comes_out &&
                      std::abs(source_q.length() + offset_q - at_p.distance) <= limit &&
                      std::abs((source_p - end).length() + offset_p - at_q.distance) <= limit &&
                      angle(source_p - middle, source_q - middle) <= direction_tolerance;
    return ends;
  }
  /// Whether the ray of a corner lies on the face's side of an edge, or along it.
  /// \param begins whether it is the edge that begins at the corner, or the one that ends there
  /// \param edge its direction
  bool comes_out(std::uint32_t face, std::uint32_t k, bool begins, double edge) const {
    const std::uint32_t v = m_geometry.vertex(face, k);
    const double phi = m_rays[v].angle, total = m_geometry.total_angle(v), // t into the face
        t = m_geometry.grows_from(face, k, begins) ? phi - edge : edge - phi;
    if(m_geometry.is_on_boundary(v))
      return t > -along_edge;
    return t < -along_edge ? t + total < along_edge - t : t < total - t + along_edge;
  }

  /// Both ends of a side have their distances: decides how rays go on into its face.
  void close(const Side& side) {
    if(m_is_exact || !(m_geometry.length(side.face, side.number) > 0))
      return;
    State& state = m_states[3 * side.face + side.number];
    const Ends ends = ends_of(side);
    if(ends.come_out && ends.is_short) {
      state = State::cubic;
      return;
    }
    if(!ends.is_regular) {
      state = State::windows;
      release(side);
      make_windows_before(side);
      return;
    }
    state = State::cubic;
    offer_to_apex(side, ends.cubic);
    for(std::uint32_t k = 1; k < 3; ++k)
      if(windows_go_on({side.face, (side.number + k) % 3}))
        make_windows(side, ends.cubic, (side.number + k) % 3);
  }

  /// lets windows go on that wait at a side
  void release(const Side& side) {
    std::uint32_t& first = m_waiting[3 * side.face + side.number];
    for(std::uint32_t i = first; i != no_root; i = m_windows[i].next)
      m_heap.push({m_windows[i].origin.offset + m_windows[i].height(), true, i});
    first = no_root;
  }

  bool windows_go_on(const Side& side) const {
    bool result = false;
    m_geometry.for_each_beyond(side, [&](const Side& other) {
      result |= m_states[3 * other.face + other.number] == State::windows;
    });
    return result;
  }

  /// windows from the cubics at the sides before a side
  void make_windows_before(const Side& side) {
    m_geometry.for_each_beyond(side, [&](const Side& other) {
      for(std::uint32_t k = 1; k < 3; ++k) {
        const Side before{other.face, (other.number + k) % 3};
        if(m_states[3 * before.face + before.number] != State::cubic)
          continue;
        const Ends ends = ends_of(before);
        if(ends.is_regular) // still
          make_windows(before, ends.cubic, other.number);
      }
    });
  }

  /// Windows that stand for a cubic, each from the source that the distances at its ends give.
  void make_windows(const Side& side, const Ray_cubic& cubic, std::uint32_t target) {
    const double low =
                     m_geometry.is_flat(m_geometry.vertex(side.face, side.number)) ? -infinity : 0,
                 high = m_geometry.is_flat(m_geometry.vertex(side.face, side.number + 1)) ? infinity
                                                                                          : 1;
    for(int i = 0; i < windows_of_cubic; ++i) {
      Ray_window w;
      w.side = side;
      w.source = cubic.source(double(i) / windows_of_cubic, double(i + 1) / windows_of_cubic);
      w.first = (std::max)(low, (i - overlap) / windows_of_cubic) * cubic.length;
      w.last = (std::min)(high, (i + 1 + overlap) / windows_of_cubic) * cubic.length;
      w.origin = cubic.origin;
      cross(w, target);
    }
  }

  /// the shortest way to the third corner through a side, if it is shorter than a bound
  void offer_to_apex(const Side& side, const Ray_cubic& cubic, double bound = infinity) {
    const Plane_vector c = m_geometry.apex(side);
    const Ray_cubic::Way way = cubic.shortest_way(c);
    if(!(way.distance < bound))
      return;
    Ray ray;
    ray.distance = way.distance;
    const Plane_vector from =
        c.y > no_height * cubic.length ? Plane_vector{way.t * cubic.length, 0} : cubic.source(0, 1);
    ray.angle =
        m_geometry.fan_angle(side.face, side.number + 2, angle(Plane_vector{0, 0} - c, from - c));
    ray.origin = cubic.origin;
    offer(m_geometry.vertex(side.face, side.number + 2), ray);
  }

  const Ray_geometry& m_geometry;
  bool m_is_exact;
  std::vector<Ray> m_rays; // of vertices
  std::vector<char> m_is_popped;
  std::vector<State> m_states;             // of sides
  std::vector<std::uint32_t> m_waiting;    // of sides: the first window that waits
  std::vector<Nearest_ray> m_nearest_rays; // of sides, if exact
  Ray_windows m_windows;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> m_heap;
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_GEODESICS_INTERNAL_RAY_PROPAGATION_H
