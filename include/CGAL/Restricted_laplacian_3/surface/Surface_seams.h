// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SURFACE_SEAMS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SURFACE_SEAMS_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/Disjoint_sets.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Dev
/// Along which of their sides the faces of a surface are joined.
///
/// A seam is a set of sides of faces that run along the same line in space; the surface continues
/// across a seam from each of its faces to each other one. The sides with the same two vertices are
/// one seam, any number of them: non-manifold edges need no special treatment, and orientation does
/// not matter. Beyond that,
/// - the three sides of a thin face, whose height over its longest side is at most `thinness`, are
///   one seam: it may have no fragment in a cell where its neighbours have one;
/// - if a joining tolerance is given, a side that is alone so far and another side are one seam if
///   they run along each other: of their four ends, two that are farther apart than the tolerance
///   are each within the tolerance of the other side. That closes duplicate vertices and
///   T-junctions.
///
/// Side `i` of a face goes from corner `i` to corner `(i + 1) % 3`.
///
/// Linear in the number of faces; joining takes \f$O(F \log F)\f$, as long as few sides are near
/// to each other.
class Surface_seams {
public:
  /// \param surface a surface of triangles; it is read here only
  /// \param thinness in the unit of the coordinates
  /// \param joining_tolerance in the unit of the coordinates; negative: do not join
  /// \throws Input_error the surface is a point set
  Surface_seams(const Triangulated_surface_3& surface, double thinness, double joining_tolerance) {
    surface.require_triangles("a boundary or a seam");
    number_edges(surface);
    internal::Disjoint_sets sets(m_number_of_seams);
    bool united = unite_sides_of_thin_faces(surface, thinness, sets);
    if(joining_tolerance >= 0)
      united = join_lone_sides(surface, joining_tolerance, sets) || united;
    if(united)
      renumber(sets);
  }

  /// number of seams; a side that is joined to no other is one as well
  std::size_t number_of_seams() const { return m_number_of_seams; }

  /// number of the seam that a side belongs to
  std::uint32_t seam(std::size_t face, int side) const { return m_seams[face][side]; }

  /// whether the sides of a seam may be different edges
  bool is_united(std::uint32_t seam) const { return !m_is_united.empty() && m_is_united[seam]; }

private:
  /// Gives the sides with the same vertices the same number: sides are sorted into one list for
  /// each vertex, that of their lower end.
  void number_edges(const Triangulated_surface_3& surface) {
    struct Side {
      std::uint32_t upper_end;
      std::uint32_t face;
      int side;
    };
    const std::size_t number_of_faces = surface.number_of_faces();
    std::vector<std::size_t> first(surface.number_of_vertices() + 1, 0);
    const auto ends = [&surface](std::size_t face, int side) {
      const auto& t = surface.triangle(face);
      return std::minmax(t[side], t[(side + 1) % 3]);
    };
    for(std::size_t f = 0; f < number_of_faces; ++f)
      for(int side = 0; side < 3; ++side)
        ++first[ends(f, side).first + 1];
    for(std::size_t v = 0; v + 1 < first.size(); ++v)
      first[v + 1] += first[v];
    std::vector<Side> sides(3 * number_of_faces);
    std::vector<std::size_t> next(first.begin(), first.end() - 1);
    for(std::size_t f = 0; f < number_of_faces; ++f)
      for(int side = 0; side < 3; ++side) {
        const auto [low, high] = ends(f, side);
        sides[next[low]++] = {high, static_cast<std::uint32_t>(f), side};
      }
    m_seams.resize(number_of_faces);
    for(std::size_t v = 0; v + 1 < first.size(); ++v) {
      const auto begin = sides.begin() + first[v], end = sides.begin() + first[v + 1];
      std::sort(begin, end, [](const Side& a, const Side& b) {
        return a.upper_end < b.upper_end || (a.upper_end == b.upper_end && a.face < b.face);
      });
      for(auto it = begin; it != end; ++it) {
        if(it == begin || it->upper_end != (it - 1)->upper_end)
          ++m_number_of_seams;
        m_seams[it->face][it->side] = static_cast<std::uint32_t>(m_number_of_seams - 1);
      }
    }
  }

  bool unite_sides_of_thin_faces(const Triangulated_surface_3& surface, double thinness,
                                 internal::Disjoint_sets& sets) const {
    bool united = false;
    for(std::size_t f = 0; f < surface.number_of_faces(); ++f) {
      double longest = 0;
      for(int side = 0; side < 3; ++side)
        longest = (std::max)(
            longest, (surface.point(f, (side + 1) % 3) - surface.point(f, side)).squared_length());
      if(2 * surface.area(f) > thinness * std::sqrt(longest))
        continue;
      sets.unite(m_seams[f][0], m_seams[f][1]);
      sets.unite(m_seams[f][0], m_seams[f][2]);
      united = true;
    }
    return united;
  }

  /// distance of a point from a segment
  static double distance(const Point_3& p, const std::array<Point_3, 2>& segment) {
    const Vector_3 d = segment[1] - segment[0], v = p - segment[0];
    const double length = d * d;
    const double t = length > 0 ? (std::min)((std::max)(v * d / length, 0.), 1.) : 0.;
    return std::sqrt((v - t * d).squared_length());
  }

  static bool run_along_each_other(const std::array<Point_3, 2>& a, const std::array<Point_3, 2>& b,
                                   double tolerance) {
    std::array<Point_3, 4> near;
    std::size_t count = 0;
    for(int i = 0; i < 2; ++i) {
      if(distance(a[i], b) <= tolerance)
        near[count++] = a[i];
      if(distance(b[i], a) <= tolerance)
        near[count++] = b[i];
    }
    for(std::size_t i = 0; i < count; ++i)
      for(std::size_t j = 0; j < i; ++j)
        if((near[i] - near[j]).squared_length() > tolerance * tolerance)
          return true;
    return false;
  }

  bool join_lone_sides(const Triangulated_surface_3& surface, double tolerance,
                       internal::Disjoint_sets& sets) const {
    std::vector<std::uint32_t> number_of_sides(m_number_of_seams, 0);
    for(const auto& seams : m_seams)
      for(std::uint32_t seam : seams)
        ++number_of_sides[seam];
    struct Edge {
      std::uint32_t seam;
      std::array<Point_3, 2> ends;
    };
    using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::size_t>;
    std::vector<Edge> edges;
    std::vector<Box> boxes, lone_boxes;
    std::vector<char> is_seen(m_number_of_seams, 0);
    for(std::size_t f = 0; f < m_seams.size(); ++f)
      for(int side = 0; side < 3; ++side) {
        const std::uint32_t seam = m_seams[f][side];
        if(is_seen[seam])
          continue;
        is_seen[seam] = 1;
        edges.push_back({seam, {surface.point(f, side), surface.point(f, (side + 1) % 3)}});
        const CGAL::Bbox_3 b = edges.back().ends[0].bbox() + edges.back().ends[1].bbox();
        const double r = tolerance / 2;
        boxes.emplace_back(CGAL::Bbox_3(b.xmin() - r, b.ymin() - r, b.zmin() - r, b.xmax() + r,
                                        b.ymax() + r, b.zmax() + r),
                           edges.size() - 1);
        if(number_of_sides[seam] == 1)
          lone_boxes.push_back(boxes.back());
      }
    bool united = false;
    CGAL::box_intersection_d(lone_boxes.begin(), lone_boxes.end(), boxes.begin(), boxes.end(),
                             [&](const Box& a, const Box& b) {
                               const Edge &s = edges[a.info()], &t = edges[b.info()];
                               if(s.seam != t.seam &&
                                  run_along_each_other(s.ends, t.ends, tolerance)) {
                                 sets.unite(s.seam, t.seam);
                                 united = true;
                               }
                             });
    return united;
  }

  void renumber(internal::Disjoint_sets& sets) {
    const std::uint32_t unset = (std::numeric_limits<std::uint32_t>::max)();
    std::vector<std::uint32_t> number(m_number_of_seams, unset);
    std::vector<char> has_others(m_number_of_seams, 0);
    for(std::uint32_t edge = 0; edge < m_number_of_seams; ++edge)
      if(sets.find(edge) != edge)
        has_others[sets.find(edge)] = 1;
    m_number_of_seams = 0;
    for(auto& seams : m_seams)
      for(std::uint32_t& seam : seams) {
        const std::uint32_t set = sets.find(seam);
        if(number[set] == unset) {
          number[set] = static_cast<std::uint32_t>(m_number_of_seams++);
          m_is_united.push_back(has_others[set]);
        }
        seam = number[set];
      }
  }

  std::vector<std::array<std::uint32_t, 3>> m_seams;
  std::size_t m_number_of_seams = 0;
  std::vector<char> m_is_united; // empty if no seam is
};

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SURFACE_SEAMS_H
