// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_GEODESICS_INTERNAL_PATH_SEARCH_H
#define CGAL_RESTRICTED_LAPLACIAN_3_GEODESICS_INTERNAL_PATH_SEARCH_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/geodesics/internal/Face_strip.h>
#include <CGAL/Restricted_laplacian_3/geodesics/internal/Geodesic_triangle.h>
#include <CGAL/Restricted_laplacian_3/geodesics/internal/Ray_geometry.h>
#include <CGAL/Restricted_laplacian_3/geodesics/internal/ray_waves.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <queue>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// Finds the faces of a shortest path back to a source. A shortest path is straight up to a vertex
/// or a source, from where the distance is known: windows of rays from its first point are searched
/// for the one whose way together with the distance there is least, those first whose way and
/// distance, as the triangles have it, are least. So the search goes straight down the distance,
/// and turns back where triangles are too coarse for that. From the vertex it is repeated.
class Path_search {
public:
  using Side = Ray_geometry::Side;
  using Corner = Ray_geometry::Corner;
  using Barycentric = Geodesic_triangle::Barycentric;
  /// the triangle of a face, with the distances of its corners
  using Triangle_of = std::function<Geodesic_triangle(std::uint32_t)>;
  /// a point of a face
  struct Point {
    std::uint32_t face;
    Barycentric place;
  };

  Path_search(const Ray_geometry& geometry, Triangle_of triangle_of)
    : m_geometry(geometry), m_triangle_of(std::move(triangle_of)) {}

  /// strips from a point to a source, each of which goes on where the last one ends
  std::vector<Face_strip> operator()(const Point& start) {
    std::vector<Face_strip> strips(1, Face_strip(m_geometry, start.face, start.place));
    Point here = start;
    double distance = m_triangle_of(start.face).bounded(start.place).distance;
    std::set<std::uint32_t> visited;
    while(distance > 0) {
      const std::uint32_t corner = Ray_geometry::corner_of(here.place);
      if(corner < 3)
        visited.insert(m_geometry.vertex(here.face, corner));
      const Way way = nearest(here, distance, visited);
      connect(here, way.from, strips);
      for(const auto& [out, in] : way.crossings)
        strips.back().cross(out, in);
      here = way.to;
      distance = way.distance;
    }
    strips.back().end_at(here.place);
    return strips;
  }

private:
  static constexpr std::uint32_t none = 0xffffffff;
  /// ways that are longer by this part than the distance are taken for it
  static constexpr double enough = 1e-4;
  /// most windows of one search; more are of no use but on surfaces made for that
  static constexpr std::size_t most_windows = 20000;

  /// a straight way to a vertex or a source
  struct Way {
    Point from; // in the first face of the way
    std::vector<std::pair<Side, Side>> crossings;
    Point to;
    double distance = 0; // of its end
  };
  /// rays through a part of a side into its face, from the first point
  struct Window {
    Ray_window rays;
    Side out;             // of the face before
    std::uint32_t before; // window, or `none`
    Point from;
  };
  /// what to look at next: a window, or an end
  struct Entry {
    double key = std::numeric_limits<double>::infinity();
    std::uint32_t window = none;
    bool is_end = false;
    Point end = {};
    double distance = 0; // of the end
    Point from = {};

    friend bool operator>(const Entry& a, const Entry& b) { return a.key > b.key; }
  };

  /// calls `visit(point)` with a point as one of each face that it belongs to
  template <class Visitor> void for_each_face(const Point& p, Visitor&& visit) const {
    const std::uint32_t corner = Ray_geometry::corner_of(p.place);
    if(corner < 3) {
      m_geometry.for_each_corner(m_geometry.vertex(p.face, corner), [&](const Corner& c) {
        Point there{c.face, {0, 0, 0}};
        there.place[c.number] = 1;
        visit(there);
      });
      return;
    }
    visit(p);
    for(std::uint32_t k = 0; k < 3; ++k)
      if(p.place[(k + 2) % 3] == 0)
        m_geometry.for_each_beyond({p.face, k}, [&](const Side& other) {
          visit(Point{other.face, m_geometry.beyond({p.face, k}, other, p.place)});
        });
  }

  static Barycentric corner(std::uint32_t k) {
    Barycentric l = {0, 0, 0};
    l[k % 3] = 1;
    return l;
  }

  Way nearest(const Point& start, double distance, const std::set<std::uint32_t>& visited) {
    m_windows.clear();
    m_heap = {};
    m_best = {};
    Entry aside; // if there is no way down: to a vertex where no way was before
    for_each_face(start, [&](const Point& p) {
      const Plane_vector s = m_geometry.place(p.face, p.place);
      const Geodesic_triangle triangle = m_triangle_of(p.face);
      const auto corners = m_geometry.corners(p.face);
      offer_sources(triangle, p, s, none, [](const Plane_vector&) { return true; });
      for(std::uint32_t k = 0; k < 3; ++k) {
        const double there = triangle.corner_distance(k);
        const Entry end = end_at((corners[k] - s).length(), none, {p.face, corner(k)}, there, p);
        if(there < distance)
          offer_end(end);
        else if(end.key < aside.key && visited.count(m_geometry.vertex(p.face, k)) == 0)
          aside = end;
        if(p.place[(k + 2) % 3] > 0)
          add_beyond({p.face, k},
                     {off_side(s, corners[k], corners[(k + 1) % 3]), corners[k],
                      corners[(k + 1) % 3], 0, m_geometry.length(p.face, k)},
                     none, p);
      }
    });
    while(!m_heap.empty() && m_windows.size() < most_windows) {
      const Entry next = m_heap.top();
      m_heap.pop();
      if(next.is_end) {
        if(next.key <= distance * (1 + enough))
          break;
      } else
        cross(next.window, distance);
    }
    const Entry& end = std::isinf(m_best.key) ? aside : m_best;
    if(std::isinf(end.key))
      throw Numerical_error("no path to a source is found from face " + std::to_string(start.face));
    return way_to(end);
  }

  Way way_to(const Entry& end) const {
    Way way;
    way.to = end.end;
    way.distance = end.distance;
    way.from = end.from;
    for(std::uint32_t w = end.window; w != none; w = m_windows[w].before)
      way.crossings.emplace_back(m_windows[w].out, m_windows[w].rays.side);
    std::reverse(way.crossings.begin(), way.crossings.end());
    return way;
  }

  static Entry end_at(double way, std::uint32_t window, const Point& end, double distance,
                      const Point& from) {
    Entry result;
    result.key = way + distance;
    result.window = window;
    result.is_end = true;
    result.end = end;
    result.distance = distance;
    result.from = from;
    return result;
  }
  void offer_end(const Entry& end) {
    if(end.key < m_best.key) {
      m_best = end;
      m_heap.push(end);
    }
  }

  /// \param sees whether a point of the face, in the frame of its side 0, is seen
  template <class Sees>
  void offer_sources(const Geodesic_triangle& triangle, const Point& p, const Plane_vector& s,
                     std::uint32_t window, Sees&& sees) {
    triangle.for_each_source([&](const Source_part& source) {
      const Plane_vector a = m_geometry.place(source.face, source.from),
                         b = m_geometry.place(source.face, source.to), way = b - a;
      const double square = dot(way, way),
                   t = square > 0 ? std::clamp(dot(s - a, way) / square, 0., 1.) : 0;
      const Plane_vector q = a + t * way;
      if(!sees(q))
        return;
      Point end{source.face, {0, 0, 0}};
      for(std::size_t k = 0; k < 3; ++k)
        end.place[k] = (1 - t) * source.from[k] + t * source.to[k];
      offer_end(end_at((q - s).length(), window, end, 0, p));
    });
  }

  void add_beyond(const Side& out, const Ray_beam& beam, std::uint32_t before, const Point& from) {
    const double l = m_geometry.length(out.face, out.number);
    const auto add = [&](const Ray_window& w) {
      const Side& in = w.side;
      const Geodesic_triangle triangle = m_triangle_of(in.face);
      const double d0 = triangle.corner_distance(in.number),
                   d1 = triangle.corner_distance((in.number + 1) % 3);
      double key = std::numeric_limits<double>::infinity();
      constexpr int parts = 4;
      for(int i = 0; i <= parts; ++i) {
        const double there = w.first + i * (w.last - w.first) / parts;
        Barycentric place = {0, 0, 0};
        place[(in.number + 1) % 3] = there / l;
        place[in.number] = 1 - there / l;
        const double way = Plane_vector{there - w.source.x, w.source.y}.length();
        key = (std::min)(key, way + triangle.bounded(place).distance);
      }
      // no point of the window is nearer to a source than the triangle inequality permits
      const double least =
          Plane_vector{(std::max)({0., w.first - w.source.x, w.source.x - w.last}), w.source.y}
              .length() +
          (std::max)({0., d0 - w.last, d1 - (l - w.first)});
      if(!(least < m_best.key))
        return;
      m_windows.push_back({w, out, before, from});
      Entry entry;
      entry.key = key;
      entry.window = static_cast<std::uint32_t>(m_windows.size() - 1);
      m_heap.push(entry);
    };
    for_each_window_beyond(m_geometry, out, beam, {}, add);
  }

  void cross(std::uint32_t number, double distance) {
    const Ray_window w = m_windows[number].rays;
    const Point from = m_windows[number].from;
    const std::uint32_t face = w.side.face, k = w.side.number;
    const Plane_vector& s = w.source;
    const Geodesic_triangle triangle = m_triangle_of(face);
    // the frame of side 0
    const auto corners = m_geometry.corners(face);
    const double l = m_geometry.length(face, k);
    const Plane_vector x = (1 / l) * (corners[(k + 1) % 3] - corners[k]), y{-x.y, x.x};
    offer_sources(triangle, from, corners[k] + s.x * x + s.y * y, number,
                  [&](const Plane_vector& q) {
                    const Plane_vector here = q - corners[k],
                                       way = Plane_vector{dot(here, x), dot(here, y)} - s;
                    const double rounding = 1e-12 * l * way.length();
                    return internal::cross(way, {w.first - s.x, -s.y}) >= -rounding &&
                           internal::cross({w.last - s.x, -s.y}, way) >= -rounding;
                  });
    cross_face(
        m_geometry, w, {},
        [&](const Plane_vector&, double way, double) {
          const double there = triangle.corner_distance((k + 2) % 3);
          if(there < distance)
            offer_end(end_at(way, number, {face, corner(k + 2)}, there, from));
        },
        [&](const Side& side, const Ray_beam& beam) { add_beyond(side, beam, number, from); });
  }

  /// leads the strip from a point of a face to the same point of another face
  void connect(const Point& from, const Point& to, std::vector<Face_strip>& strips) const {
    if(from.face == to.face)
      return;
    const std::uint32_t corner = Ray_geometry::corner_of(from.place);
    if(corner < 3) {
      const std::uint32_t v = m_geometry.vertex(from.face, corner);
      if(m_geometry.has_fan(v) && turn(v, from.face, to.face, strips.back()))
        return;
      strips.back().end_at(from.place);
      strips.emplace_back(m_geometry, to.face, to.place);
      return;
    }
    for(std::uint32_t k = 0; k < 3; ++k)
      if(from.place[(k + 2) % 3] == 0)
        m_geometry.for_each_beyond({from.face, k}, [&](const Side& other) {
          if(other.face == to.face)
            strips.back().cross({from.face, k}, other);
        });
  }

  /// Around a vertex, the shorter way; its faces form a fan.
  bool turn(std::uint32_t v, std::uint32_t from, std::uint32_t to, Face_strip& strip) const {
    std::vector<std::pair<Side, Side>> best;
    bool is_found = false;
    for(const bool begins : {false, true}) {
      std::vector<std::pair<Side, Side>> way;
      std::uint32_t face = from;
      bool out_begins = begins, goes_on = true;
      while(face != to && goes_on) {
        std::uint32_t k = 0;
        while(m_geometry.vertex(face, k) != v)
          ++k;
        const Side out{face, out_begins ? k : (k + 2) % 3};
        goes_on = false;
        m_geometry.for_each_beyond(out, [&](const Side& in) {
          way.emplace_back(out, in);
          face = in.face;
          // it leaves the next face by the side that it did not come by
          out_begins = m_geometry.vertex(in.face, in.number) != v;
          goes_on = face != from;
        });
      }
      if(face == to && (!is_found || way.size() < best.size())) {
        best.swap(way);
        is_found = true;
      }
    }
    for(const auto& [out, in] : best)
      strip.cross(out, in);
    return is_found;
  }

  const Ray_geometry& m_geometry;
  Triangle_of m_triangle_of;
  std::vector<Window> m_windows;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> m_heap;
  Entry m_best;
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_GEODESICS_INTERNAL_PATH_SEARCH_H
