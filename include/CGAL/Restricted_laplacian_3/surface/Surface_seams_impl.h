// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SURFACE_SEAMS_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SURFACE_SEAMS_IMPL_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/Disjoint_sets.h>
#include <CGAL/Restricted_laplacian_3/surface/Surface_seams.h>
#include <CGAL/Restricted_laplacian_3/surface/shared/Surface_edges.h>

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
namespace internal {

/// distance of a point from a segment
inline double distance_to_segment(const Point_3& p, const std::array<Point_3, 2>& segment) {
  const Vector_3 d = segment[1] - segment[0], v = p - segment[0];
  const double length = d * d;
  const double t = length > 0 ? (std::min)((std::max)(v * d / length, 0.), 1.) : 0.;
  return std::sqrt((v - t * d).squared_length());
}

/// whether two of the four ends that are apart are near to the other segment
inline bool run_along_each_other(const std::array<Point_3, 2>& a, const std::array<Point_3, 2>& b,
                                 double tolerance) {
  std::array<Point_3, 4> near;
  std::size_t count = 0;
  for(int i = 0; i < 2; ++i) {
    if(distance_to_segment(a[i], b) <= tolerance)
      near[count++] = a[i];
    if(distance_to_segment(b[i], a) <= tolerance)
      near[count++] = b[i];
  }
  for(std::size_t i = 0; i < count; ++i)
    for(std::size_t j = 0; j < i; ++j)
      if((near[i] - near[j]).squared_length() > tolerance * tolerance)
        return true;
  return false;
}

} // namespace internal

CGAL_RESTRICTED_LAPLACIAN_3_INLINE
Surface_seams::Surface_seams(const Triangulated_surface_3& surface, double thinness,
                             double joining_tolerance) {
  surface.require_triangles("a boundary or a seam");
  number_edges(surface);
  internal::Disjoint_sets sets(m_number_of_seams);
  bool united = unite_sides_of_thin_faces(surface, thinness, sets);
  if(joining_tolerance >= 0)
    united = join_lone_sides(surface, joining_tolerance, sets) || united;
  if(united)
    renumber(sets);
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void
Surface_seams::number_edges(const Triangulated_surface_3& surface) {
  const internal::Surface_edges edges(surface);
  m_number_of_seams = edges.size();
  m_seams.resize(surface.number_of_faces());
  for(std::size_t edge = 0; edge < edges.size(); ++edge)
    for(const auto& side : edges.sides(edge))
      m_seams[side.face][side.number] = static_cast<std::uint32_t>(edge);
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE bool
Surface_seams::unite_sides_of_thin_faces(const Triangulated_surface_3& surface, double thinness,
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

CGAL_RESTRICTED_LAPLACIAN_3_INLINE bool
Surface_seams::join_lone_sides(const Triangulated_surface_3& surface, double tolerance,
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
                                internal::run_along_each_other(s.ends, t.ends, tolerance)) {
                               sets.unite(s.seam, t.seam);
                               united = true;
                             }
                           });
  return united;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void Surface_seams::renumber(internal::Disjoint_sets& sets) {
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

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SURFACE_SEAMS_IMPL_H
