// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SHARED_DIVIDED_SURFACE_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SHARED_DIVIDED_SURFACE_IMPL_H

#include <CGAL/Restricted_laplacian_3/surface/shared/Divided_surface.h>
#include <CGAL/Restricted_laplacian_3/surface/shared/Surface_edges.h>

#include <CGAL/Kernel/global_functions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// Divides the faces of a smooth surface, one after the other.
class Patch_divider {
public:
  Patch_divider(const Triangulated_surface_3& surface, double tolerance, Divided_surface& result)
    : m_surface(surface), m_patches(surface.patches()), m_squared_tolerance(tolerance * tolerance),
      m_result(result), m_edges(surface) {}

  /// returns the pieces
  Triangulated_surface_3 run() {
    for(std::size_t v = 0; v < m_surface.number_of_vertices(); ++v)
      m_points.push_back(m_surface.point(v));
    divide_edges();
    for(m_face = 0; m_face < m_surface.number_of_faces(); ++m_face) {
      m_result.m_first_pieces.push_back(static_cast<std::uint32_t>(m_triangles.size()));
      divide_face();
    }
    m_result.m_first_pieces.push_back(static_cast<std::uint32_t>(m_triangles.size()));
    return Triangulated_surface_3(std::move(m_points), std::move(m_triangles));
  }

private:
  using Barycentric = std::array<double, 3>;

  /// pieces are not smaller than this part of a face, or edge
  static constexpr int most_halvings = 12;
  static constexpr std::uint32_t none = (std::numeric_limits<std::uint32_t>::max)();

  struct Corner {
    Barycentric place;
    std::uint32_t vertex;
  };
  /// A side of a piece: a part of an edge, or inside of the face. Parameters go from the lower end
  /// of the edge to the upper.
  struct Side {
    std::uint32_t edge = none;
    double begin = 0, end = 0;
  };

  static Barycentric mean(const Barycentric& a, const Barycentric& b, double s) {
    return {(1 - s) * a[0] + s * b[0], (1 - s) * a[1] + s * b[1], (1 - s) * a[2] + s * b[2]};
  }

  Point_3 point(std::size_t face, const Barycentric& l) const {
    return point_of_triangle(m_surface.point(face, 0), m_surface.point(face, 1),
                             m_surface.point(face, 2), l) +
           m_patches.deviation(face, l);
  }

  /// whether a curve leaves its chord by more than the tolerance
  /// \param curve from 0 to 1
  template <class Curve> bool is_bent(const Curve& curve) const {
    const Point_3 begin = curve(0.), end = curve(1.);
    for(double s : {0.5, 0.25, 0.75})
      if((curve(s) - begin - s * (end - begin)).squared_length() > m_squared_tolerance)
        return true;
    return false;
  }

  void divide_edges() {
    m_first_parameters.push_back(0);
    m_edges_of_faces.resize(m_surface.number_of_faces());
    for(std::size_t edge = 0; edge < m_edges.size(); ++edge) {
      for(const Surface_edges::Side& side : m_edges.sides(edge))
        m_edges_of_faces[side.face][side.number] = static_cast<std::uint32_t>(edge);
      const Surface_edges::Side side = m_edges.sides(edge).front();
      const bool is_ascending = m_surface.triangle(side.face)[side.number] == m_edges.ends(edge)[0];
      const auto curve = [&](double s) {
        Barycentric place = {0, 0, 0};
        place[side.number] = is_ascending ? 1 - s : s;
        place[(side.number + 1) % 3] = is_ascending ? s : 1 - s;
        return point(side.face, place);
      };
      if(!m_patches.is_flat(side.face))
        divide_curve(curve, 0, 1, 0);
      m_first_parameters.push_back(m_parameters.size());
    }
  }

  /// adds the parameters at which a curve is halved, in ascending order, and points there
  template <class Curve>
  void divide_curve(const Curve& curve, double begin, double end, int halvings) {
    if(halvings == most_halvings ||
       !is_bent([&](double s) { return curve((1 - s) * begin + s * end); }))
      return;
    const double middle = (begin + end) / 2;
    divide_curve(curve, begin, middle, halvings + 1);
    m_parameters.push_back({middle, static_cast<std::uint32_t>(m_points.size())});
    m_points.push_back(curve(middle));
    divide_curve(curve, middle, end, halvings + 1);
  }

  void divide_face() {
    const auto& t = m_surface.triangle(m_face);
    std::array<Corner, 3> corners;
    std::array<Side, 3> sides;
    for(int i = 0; i < 3; ++i) {
      corners[i].place = {0, 0, 0};
      corners[i].place[i] = 1;
      corners[i].vertex = t[i];
      const std::uint32_t edge = m_edges_of_faces[m_face][i];
      const bool is_ascending = m_edges.ends(edge)[0] == t[i];
      sides[i] = {edge, is_ascending ? 0. : 1., is_ascending ? 1. : 0.};
    }
    m_inner_points.clear();
    divide(corners, sides, 0);
  }

  /// the vertex in the middle of a side of a piece, if it is divided
  std::uint32_t middle(const Corner& a, const Corner& b, const Side& side, int halvings) {
    if(side.edge != none) {
      const double parameter = (side.begin + side.end) / 2;
      const auto begin = m_parameters.begin() +
                         static_cast<std::ptrdiff_t>(m_first_parameters[side.edge]),
                 end = m_parameters.begin() +
                       static_cast<std::ptrdiff_t>(m_first_parameters[side.edge + 1]);
      const auto found = std::lower_bound(begin, end, std::make_pair(parameter, std::uint32_t(0)));
      return found != end && found->first == parameter ? found->second : none;
    }
    const auto [it, is_new] = m_inner_points.insert({std::minmax(a.vertex, b.vertex), none});
    if(is_new && halvings < most_halvings &&
       is_bent([&](double s) { return point(m_face, mean(a.place, b.place, s)); })) {
      it->second = static_cast<std::uint32_t>(m_points.size());
      m_points.push_back(point(m_face, mean(a.place, b.place, 0.5)));
    }
    return it->second;
  }

  void divide(const std::array<Corner, 3>& c, const std::array<Side, 3>& s, int halvings) {
    std::array<Corner, 3> m; // middles of the sides
    int count = 0;
    for(int i = 0; i < 3; ++i) {
      m[i].place = mean(c[i].place, c[(i + 1) % 3].place, 0.5);
      m[i].vertex = middle(c[i], c[(i + 1) % 3], s[i], halvings);
      count += m[i].vertex != none ? 1 : 0;
    }
    // halves of a side
    const auto first = [&](int i) -> Side {
      return {s[i].edge, s[i].begin, (s[i].begin + s[i].end) / 2};
    };
    const auto second = [&](int i) -> Side {
      return {s[i].edge, (s[i].begin + s[i].end) / 2, s[i].end};
    };
    const Side inside;
    if(count == 3) {
      for(int i = 0; i < 3; ++i)
        divide({c[i], m[i], m[(i + 2) % 3]}, {first(i), inside, second((i + 2) % 3)}, halvings + 1);
      divide({m[0], m[1], m[2]}, {inside, inside, inside}, halvings + 1);
    } else if(count == 2) {
      int i = 0; // the side that is not divided
      while(m[i].vertex != none)
        ++i;
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      divide({m[j], c[k], m[k]}, {second(j), first(k), inside}, halvings + 1);
      const auto squared_distance = [&](const Corner& a, const Corner& b) {
        return (m_points[a.vertex] - m_points[b.vertex]).squared_length();
      };
      if(squared_distance(c[i], m[j]) <= squared_distance(c[j], m[k])) {
        divide({c[i], c[j], m[j]}, {s[i], first(j), inside}, halvings + 1);
        divide({c[i], m[j], m[k]}, {inside, inside, second(k)}, halvings + 1);
      } else {
        divide({c[i], c[j], m[k]}, {s[i], inside, second(k)}, halvings + 1);
        divide({c[j], m[j], m[k]}, {first(j), inside, inside}, halvings + 1);
      }
    } else if(count == 1) {
      int i = 0;
      while(m[i].vertex == none)
        ++i;
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      divide({c[i], m[i], c[k]}, {first(i), inside, s[k]}, halvings + 1);
      divide({m[i], c[j], c[k]}, {second(i), s[j], inside}, halvings + 1);
    } else if(is_bulging(c) && halvings < most_halvings) {
      Corner center;
      for(int i = 0; i < 3; ++i)
        center.place[i] = (c[0].place[i] + c[1].place[i] + c[2].place[i]) / 3;
      center.vertex = static_cast<std::uint32_t>(m_points.size());
      m_points.push_back(point(m_face, center.place));
      for(int i = 0; i < 3; ++i)
        divide({c[i], c[(i + 1) % 3], center}, {s[i], inside, inside}, halvings + 1);
    } else {
      m_triangles.push_back({c[0].vertex, c[1].vertex, c[2].vertex});
      m_result.m_faces.push_back(static_cast<std::uint32_t>(m_face));
      m_result.m_is_flat.push_back(m_patches.is_flat(m_face) ? 1 : 0);
      m_result.m_corners.push_back({{{c[0].place[0], c[0].place[1]},
                                     {c[1].place[0], c[1].place[1]},
                                     {c[2].place[0], c[2].place[1]}}});
    }
  }

  /// whether the patch deviates in the middle of a piece
  bool is_bulging(const std::array<Corner, 3>& c) const {
    if(m_patches.is_flat(m_face))
      return false;
    Barycentric place;
    for(int i = 0; i < 3; ++i)
      place[i] = (c[0].place[i] + c[1].place[i] + c[2].place[i]) / 3;
    const Point_3 center =
        CGAL::centroid(m_points[c[0].vertex], m_points[c[1].vertex], m_points[c[2].vertex]);
    return (point(m_face, place) - center).squared_length() > m_squared_tolerance;
  }

  const Triangulated_surface_3& m_surface;
  const Surface_patches& m_patches;
  double m_squared_tolerance;
  Divided_surface& m_result;
  Surface_edges m_edges;
  std::vector<std::array<std::uint32_t, 3>> m_edges_of_faces;
  std::vector<std::pair<double, std::uint32_t>> m_parameters; // and vertices there
  std::vector<std::size_t> m_first_parameters;                // of edges, and one more
  std::vector<Point_3> m_points;
  std::vector<Triangulated_surface_3::Triangle> m_triangles;
  std::size_t m_face = 0;
  // of the face: vertices in the middle of sides of pieces that lie inside, or none
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> m_inner_points;
};

CGAL_RESTRICTED_LAPLACIAN_3_INLINE
Divided_surface::Divided_surface(const Triangulated_surface_3& surface, double tolerance)
  : m_pieces(Patch_divider(surface, tolerance, *this).run()) {}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Surface_location
Divided_surface::on_pieces(const Surface_location& location) const {
  Surface_location result;
  double deepest = -std::numeric_limits<double>::infinity();
  for(std::size_t piece = m_first_pieces[location.face]; piece < m_first_pieces[location.face + 1];
      ++piece) {
    const auto& c = m_corners[piece];
    const double x = location.barycentric[0] - c[0][0], y = location.barycentric[1] - c[0][1],
                 ux = c[1][0] - c[0][0], uy = c[1][1] - c[0][1], vx = c[2][0] - c[0][0],
                 vy = c[2][1] - c[0][1], determinant = ux * vy - uy * vx,
                 v = (x * vy - y * vx) / determinant, w = (ux * y - uy * x) / determinant,
                 depth = (std::min)({1 - v - w, v, w});
    if(depth > deepest) {
      deepest = depth;
      result.face = piece;
      result.barycentric = {1 - v - w, v, w};
    }
  }
  return result;
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SHARED_DIVIDED_SURFACE_IMPL_H
