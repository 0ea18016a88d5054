// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_GEODESICS_INTERNAL_JOINED_SURFACE_H
#define CGAL_RESTRICTED_LAPLACIAN_3_GEODESICS_INTERNAL_JOINED_SURFACE_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Disjoint_sets.h>
#include <CGAL/Restricted_laplacian_3/geodesics/internal/Twin_faces.h>
#include <CGAL/Restricted_laplacian_3/geodesics/internal/triangulate_points.h>
#include <CGAL/Restricted_laplacian_3/surface/Surface_location.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>
#include <CGAL/Restricted_laplacian_3/surface/shared/Surface_edges.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// A surface without cracks: one whose boundaries are joined to what is near: a vertex of a side
/// that has no other face is one with those that are not farther than a tolerance, and where such a
/// vertex lies on a side, or any vertex on such a side, the face is divided there. Without a
/// tolerance, too, the ends of sides of no length are one, and other faces take the places of
/// `Twin_faces`. Faces keep their numbers; what else a divided face becomes has numbers behind
/// them.
class Joined_surface {
public:
  using Barycentric = std::array<double, 3>;
  /// a place in a face of the joined surface
  struct Place {
    std::uint32_t face = 0;
    Barycentric barycentric = {1, 0, 0};
  };

  /// \param tolerance in the unit of the coordinates; nothing is joined without one
  /// \throws Parameter_error if it is negative, or large beside the surface
  Joined_surface(Triangulated_surface_3 surface, std::optional<double> tolerance)
    : m_surface(std::move(surface)) {
    if(m_surface.is_point_set())
      join_points();
    else
      take_degenerate();
    if(!tolerance)
      return;
    if(!(*tolerance >= 0 && *tolerance <= largest_tolerance * m_surface.extent()))
      throw Parameter_error("joining_tolerance",
                            "must be from 0 to a hundredth of the size of the surface");
    if(m_surface.is_point_set())
      return;
    join(*tolerance);
  }

  /// as it was given
  const Triangulated_surface_3& original() const { return m_surface; }
  const Triangulated_surface_3& joined() const { return m_joined ? *m_joined : m_surface; }
  /// the vertex that stands for one
  std::uint32_t vertex(std::uint32_t v) const { return m_vertices.empty() ? v : m_vertices[v]; }

  Surface_location original(const Place& place) const {
    if(!is_divided(place.face))
      return {place.face, place.barycentric};
    const Part& part = m_parts[place.face];
    Surface_location result{part.face, {0, 0, 0}};
    for(std::size_t k = 0; k < 3; ++k)
      for(std::size_t i = 0; i < 3; ++i)
        result.barycentric[i] += place.barycentric[k] * part.corners[k][i];
    return result;
  }

  Place joined(const Surface_location& location) const {
    Place place = in_first(location.face, location.barycentric);
    if(is_divided(place.face)) {
      const Barycentric barycentric = std::exchange(place.barycentric, {0, 0, 0});
      double least = -2;
      for_each_part(place.face, [&](std::uint32_t f) {
        const Barycentric l = in_part(m_parts[f], barycentric);
        if(const double outside = (std::min)({l[0], l[1], l[2]}); outside > least) {
          least = outside;
          place = {f, l};
        }
      });
      place.barycentric = cut(place.barycentric);
    }
    m_joined_twins.move(place.face, place.barycentric);
    return place;
  }

  /// calls `visit(from, to)` for the parts of a segment in a face, each in one face
  template <class Visitor>
  void for_each_part(std::size_t face, const Barycentric& from, const Barycentric& to,
                     Visitor&& visit) const {
    const Place first = in_first(face, from), last = in_first(face, to);
    const auto visit_firsts = [&](Place p, Place q) {
      m_joined_twins.move(p.face, p.barycentric);
      m_joined_twins.move(q.face, q.barycentric);
      visit(p, q);
    };
    if(!is_divided(first.face)) {
      visit_firsts(first, last);
      return;
    }
    if(from == to) {
      const Place place = joined(Surface_location{face, from});
      visit(place, place);
      return;
    }
    for_each_part(first.face, [&](std::uint32_t part) {
      const Barycentric a = in_part(m_parts[part], first.barycentric),
                        b = in_part(m_parts[part], last.barycentric);
      double low = 0, high = 1;
      for(std::size_t k = 0; k < 3; ++k)
        if(b[k] > a[k])
          low = (std::max)(low, -a[k] / (b[k] - a[k]));
        else if(b[k] < a[k])
          high = (std::min)(high, a[k] / (a[k] - b[k]));
        else if(a[k] < 0)
          high = -1;
      const auto at = [&](double t) {
        Barycentric l;
        for(std::size_t k = 0; k < 3; ++k)
          l[k] = (1 - t) * a[k] + t * b[k];
        return Place{part, cut(l)};
      };
      if(low < high)
        visit_firsts(at(low), at(high));
    });
  }

private:
  /// Over the extent of the surface: with more, boundaries are joined to what is not near.
  static constexpr double largest_tolerance = 0.01;
  /// Sides are divided that are so many tolerances long; vertices on shorter ones are near their
  /// ends.
  static constexpr double shortest_side = 4;

  /// what a face of the joined surface is in the one that was given
  struct Part {
    std::uint32_t face;
    std::array<Barycentric, 3> corners;
    std::uint32_t next; // part of the same face, or `none`
  };
  static constexpr std::uint32_t none = 0xffffffff;

  bool is_divided(std::uint32_t face) const {
    return face < m_parts.size() && (m_parts[face].face != face || m_parts[face].next != none);
  }
  template <class Visitor> void for_each_part(std::uint32_t face, Visitor&& visit) const {
    for(std::uint32_t f = face; f != none; f = m_parts[f].next)
      visit(f);
  }
  /// barycentric coordinates in a part
  static Barycentric in_part(const Part& part, const Barycentric& l) {
    const auto determinant = [](const Barycentric& a, const Barycentric& b, const Barycentric& c) {
      return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
             a[2] * (b[0] * c[1] - b[1] * c[0]);
    };
    const auto& [a, b, c] = part.corners;
    const double all = determinant(a, b, c);
    if(all == 0)
      return {-1, -1, -1};
    return {determinant(l, b, c) / all, determinant(a, l, c) / all, determinant(a, b, l) / all};
  }
  /// without what rounding puts outside
  static Barycentric cut(Barycentric l) {
    constexpr double rounding = 1e-12;
    double sum = 0;
    for(double& x : l) {
      x = x < rounding ? 0 : x;
      sum += x;
    }
    for(double& x : l)
      x /= sum;
    return l;
  }

  using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::uint32_t>;
  using Boxes = std::vector<Box>;

  /// calls `visit()` with the numbers of two boxes that intersect
  template <class Visitor> static void for_each_pair(Boxes a, Boxes b, Visitor&& visit) {
    CGAL::box_intersection_d(a.begin(), a.end(), b.begin(), b.end(),
                             [&](const Box& i, const Box& j) { visit(i.info(), j.info()); });
  }

  /// a place in the first face with the vertices of a face that was given
  Place in_first(std::size_t face, const Barycentric& barycentric) const {
    Place place{static_cast<std::uint32_t>(face), barycentric};
    m_twins.move(place.face, place.barycentric);
    return place;
  }
  /// takes out sides of no length, and twins
  void take_degenerate() {
    constexpr double no_length = 1e-12; // over the longest side of a face
    const std::size_t n = m_surface.number_of_vertices();
    std::vector<Triangulated_surface_3::Triangle> triangles;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> same;
    for(std::size_t f = 0; f < m_surface.number_of_faces(); ++f) {
      triangles.push_back(m_surface.triangle(f));
      std::array<double, 3> squares;
      for(int k = 0; k < 3; ++k)
        squares[k] = (m_surface.point(f, (k + 1) % 3) - m_surface.point(f, k)).squared_length();
      const double longest = (std::max)({squares[0], squares[1], squares[2]});
      for(std::size_t k = 0; k < 3; ++k)
        if(squares[k] <= no_length * no_length * longest)
          same.emplace_back(triangles[f][k], triangles[f][(k + 1) % 3]);
    }
    if(!same.empty()) {
      Disjoint_sets sets(n);
      for(const auto& [v, w] : same)
        sets.unite(v, w);
      for(std::uint32_t v = 0; v < n; ++v)
        m_vertices.push_back(sets.find(v));
      for(auto& t : triangles)
        for(std::uint32_t& v : t)
          v = m_vertices[v];
    }
    m_twins = Twin_faces(triangles, n);
    if(!same.empty() || !m_twins.empty())
      set_joined(std::move(triangles), m_twins);
  }
  /// sets the joined surface, without faces of which others take the place
  void set_joined(std::vector<Triangulated_surface_3::Triangle> triangles,
                  const Twin_faces& twins = {}) {
    twins.take_from(triangles);
    std::vector<Point_3> points;
    for(std::size_t v = 0; v < m_surface.number_of_vertices(); ++v)
      points.push_back(m_surface.point(v));
    m_joined.emplace(std::move(points), std::move(triangles));
  }

  /// makes triangles of points; those that are the same are one
  void join_points() {
    const std::size_t n = m_surface.number_of_vertices();
    std::vector<std::uint32_t> order(n);
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
      const Point_3 &p = m_surface.point(i), &q = m_surface.point(j);
      return p != q ? p < q : i < j;
    });
    m_vertices.resize(n);
    for(std::size_t i = 0; i < n; ++i) {
      const bool is_same = i > 0 && m_surface.point(order[i]) == m_surface.point(order[i - 1]);
      m_vertices[order[i]] = is_same ? m_vertices[order[i - 1]] : order[i];
    }
    std::vector<Triangulated_surface_3::Triangle> triangles = triangulate_points(m_surface);
    if(triangles.empty())
      throw Input_error("no triangle can be made of the points, so there are no distances along "
                        "their surface");
    for(auto& t : triangles)
      for(std::uint32_t& v : t)
        v = m_vertices[v];
    set_joined(std::move(triangles));
  }

  void join(double tolerance) {
    const Triangulated_surface_3& given = joined();
    const auto box = [r = tolerance / 2](const Point_3& p, const Point_3& q, std::uint32_t info) {
      const CGAL::Bbox_3 b = p.bbox() + q.bbox();
      return Box(CGAL::Bbox_3(b.xmin() - r, b.ymin() - r, b.zmin() - r, b.xmax() + r, b.ymax() + r,
                              b.zmax() + r),
                 info);
    };
    // whether sides have no other face; their vertices
    std::vector<char> is_lone_side(3 * given.number_of_faces(), 0),
        is_lone(given.number_of_vertices(), 0);
    const Surface_edges edges(given);
    for(std::size_t e = 0; e < edges.size(); ++e)
      if(edges.sides(e).size() == 1) {
        const auto& side = *edges.sides(e).begin();
        is_lone_side[3 * side.face + side.number] = 1;
        for(std::uint32_t k = 0; k < 2; ++k)
          is_lone[given.triangle(side.face)[(side.number + k) % 3]] = 1;
      }
    Boxes lone_vertices, vertices;
    for(std::uint32_t v = 0; v < is_lone.size(); ++v) {
      vertices.push_back(box(given.point(v), given.point(v), v));
      if(is_lone[v])
        lone_vertices.push_back(vertices.back());
    }
    Disjoint_sets sets(is_lone.size());
    const double square = tolerance * tolerance;
    for_each_pair(lone_vertices, vertices, [&](std::uint32_t v, std::uint32_t w) {
      if((given.point(v) - given.point(w)).squared_length() <= square)
        sets.unite(v, w);
    });
    std::vector<std::uint32_t> joined_vertices;
    for(std::uint32_t v = 0; v < is_lone.size(); ++v)
      joined_vertices.push_back(sets.find(vertex(v)));
    m_vertices.swap(joined_vertices);

    // vertices on sides: side, part of its length, vertex
    std::vector<std::tuple<std::uint32_t, double, std::uint32_t>> on_sides;
    const auto look = [&](std::uint32_t side, std::uint32_t w) {
      const auto& t = given.triangle(side / 3);
      const std::uint32_t v = m_vertices[w], k = side % 3;
      for(const std::uint32_t corner : t)
        if(m_vertices[corner] == v)
          return;
      const Point_3 &p = given.point(t[k]), &q = given.point(t[(k + 1) % 3]);
      const Vector_3 d = q - p, to_v = given.point(v) - p;
      const double along = d.squared_length() > 0 ? to_v * d / d.squared_length() : 0;
      if(d.squared_length() > shortest_side * shortest_side * square && along > 0 && along < 1 &&
         (to_v - along * d).squared_length() <= square)
        on_sides.emplace_back(side, along, v);
    };
    Boxes lone_sides, sides;
    for(std::uint32_t i = 0; i < is_lone_side.size(); ++i) {
      const auto& t = given.triangle(i / 3);
      (is_lone_side[i] ? lone_sides : sides)
          .push_back(box(given.point(t[i % 3]), given.point(t[(i + 1) % 3]), i));
    }
    for_each_pair(lone_sides, vertices, look);
    for_each_pair(sides, lone_vertices, look);
    std::sort(on_sides.begin(), on_sides.end());
    on_sides.erase(std::unique(on_sides.begin(), on_sides.end()), on_sides.end());

    std::vector<Triangulated_surface_3::Triangle> triangles;
    for(std::uint32_t f = 0; f < given.number_of_faces(); ++f) {
      triangles.push_back(given.triangle(f));
      for(std::uint32_t& v : triangles.back())
        v = m_vertices[v];
      m_parts.push_back({f, {Barycentric{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, none});
    }
    for(const auto& [side, t, v] : on_sides) {
      Barycentric place = {0, 0, 0};
      place[side % 3] = 1 - t;
      place[(side % 3 + 1) % 3] = t;
      divide(side / 3, side % 3, place, v, triangles);
    }
    m_joined_twins = Twin_faces(triangles, given.number_of_vertices());
    set_joined(std::move(triangles), m_joined_twins);
  }

  /// divides that part of a face which has a point of a side on a side of its own
  void divide(std::uint32_t face, std::uint32_t side, const Barycentric& place, std::uint32_t v,
              std::vector<Triangulated_surface_3::Triangle>& triangles) {
    const std::size_t opposite = (side + 2) % 3, along = (side + 1) % 3;
    for(std::uint32_t f = face; f != none; f = m_parts[f].next)
      for(std::size_t k = 0; k < 3; ++k) {
        const std::size_t next = (k + 1) % 3;
        const Barycentric a = m_parts[f].corners[k], b = m_parts[f].corners[next];
        if(a[opposite] != 0 || b[opposite] != 0 || !(a[along] < place[along]) ||
           !(place[along] < b[along]))
          continue;
        Part other = m_parts[f];
        Triangulated_surface_3::Triangle triangle = triangles[f];
        other.corners[k] = place;
        triangle[k] = v;
        m_parts[f].corners[next] = place;
        triangles[f][next] = v;
        m_parts[f].next = static_cast<std::uint32_t>(m_parts.size());
        m_parts.push_back(other);
        triangles.push_back(triangle);
        return;
      }
  }

  Triangulated_surface_3 m_surface;
  std::optional<Triangulated_surface_3> m_joined;
  std::vector<std::uint32_t> m_vertices; // empty if nothing is joined
  std::vector<Part> m_parts;             // of the joined surface; empty if nothing is joined
  Twin_faces m_twins, m_joined_twins;    // of the surface given, and of the joined one
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_GEODESICS_INTERNAL_JOINED_SURFACE_H
