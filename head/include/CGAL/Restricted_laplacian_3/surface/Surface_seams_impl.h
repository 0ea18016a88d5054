// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SURFACE_SEAMS_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SURFACE_SEAMS_IMPL_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/Disjoint_sets.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Key_index.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Number_view.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parallel_for.h>
#include <CGAL/Restricted_laplacian_3/surface/Surface_seams.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/box_intersection_d.h>

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
                             double joining_tolerance, const Parts& parts, bool is_parallel)
  : m_surface(surface), m_is_parallel(is_parallel) {
  surface.require_triangles("a boundary or a seam");
  Pairs pairs;
  add_sides_of_thin_faces(thinness, pairs);
  if(joining_tolerance >= 0)
    add_near_sides(joining_tolerance, parts, pairs);
  unite(pairs);
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE internal::Key_index
Surface_seams::index_of(const Keys& edges) const {
  int bits = 32;
  while(bits < 64 && m_surface.number_of_vertices() >> (bits - 32) != 0)
    ++bits;
  return internal::Key_index(edges, bits);
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void Surface_seams::add_sides_of_thin_faces(double thinness,
                                                                               Pairs& pairs) const {
  const std::size_t number_of_faces = m_surface.number_of_faces(), grain = 1 << 15;
  std::vector<Pairs> of_chunks((number_of_faces - 1) / grain + 1);
  internal::parallel_for(
      m_is_parallel, 0, number_of_faces, grain, [&](std::size_t begin, std::size_t end) {
        for(std::size_t f = begin; f < end; ++f) {
          double longest = 0;
          for(int side = 0; side < 3; ++side)
            longest = (std::max)(
                longest,
                (m_surface.point(f, (side + 1) % 3) - m_surface.point(f, side)).squared_length());
          if(2 * m_surface.area(f) > thinness * std::sqrt(longest))
            continue;
          for(int side = 1; side < 3; ++side)
            of_chunks[begin / grain].emplace_back(edge_of_side(f, 0), edge_of_side(f, side));
        }
      });
  for(const Pairs& of_chunk : of_chunks)
    pairs.insert(pairs.end(), of_chunk.begin(), of_chunk.end());
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void
Surface_seams::add_near_sides(double tolerance, const Parts& parts, Pairs& pairs) const {
  Keys lone_edges;
  for(const internal::Face_side& side : lone_sides())
    lone_edges.push_back(edge_of_side(side.face, side.number));
  std::sort(lone_edges.begin(), lone_edges.end());
  if(lone_edges.empty())
    return;
  const internal::Key_index index = index_of(lone_edges);
  for(const internal::Number_view& part : parts)
    add_near_sides(tolerance, part, lone_edges, index, pairs);
  if(parts.empty())
    add_near_sides(tolerance, internal::Number_view(m_surface.number_of_faces()), lone_edges, index,
                   pairs);
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void
Surface_seams::add_near_sides(double tolerance, const internal::Number_view& part,
                              const Keys& lone_edges, const internal::Key_index& index,
                              Pairs& pairs) const {
  using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, Key>;
  Keys edges;
  bool has_lone_edges = false;
  const auto is_lone = [&](Key edge) { return index.find(lone_edges, edge) != lone_edges.size(); };
  for(std::size_t i = 0; i < part.size(); ++i)
    for(int side = 0; side < 3; ++side) {
      edges.push_back(edge_of_side(part[i], side));
      has_lone_edges = has_lone_edges || is_lone(edges.back());
    }
  if(!has_lone_edges)
    return;
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  const auto ends = [this](Key edge) {
    return std::array<Point_3, 2>{m_surface.point(edge >> 32),
                                  m_surface.point(static_cast<std::uint32_t>(edge))};
  };
  std::vector<Box> boxes, lone_boxes;
  boxes.reserve(edges.size());
  for(const Key edge : edges) {
    const auto [p, q] = ends(edge);
    const CGAL::Bbox_3 b = p.bbox() + q.bbox();
    const double r = tolerance / 2;
    boxes.emplace_back(CGAL::Bbox_3(b.xmin() - r, b.ymin() - r, b.zmin() - r, b.xmax() + r,
                                    b.ymax() + r, b.zmax() + r),
                       edge);
    if(is_lone(edge))
      lone_boxes.push_back(boxes.back());
  }
  CGAL::box_intersection_d(
      lone_boxes.begin(), lone_boxes.end(), boxes.begin(), boxes.end(),
      [&](const Box& a, const Box& b) {
        if(a.info() != b.info() &&
           internal::run_along_each_other(ends(a.info()), ends(b.info()), tolerance))
          pairs.emplace_back(a.info(), b.info());
      });
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void Surface_seams::unite(const Pairs& pairs) {
  for(const auto& [a, b] : pairs)
    if(a != b) { // two sides of a face may have the same ends
      m_edges.push_back(a);
      m_edges.push_back(b);
    }
  std::sort(m_edges.begin(), m_edges.end());
  m_edges.erase(std::unique(m_edges.begin(), m_edges.end()), m_edges.end());
  m_index = index_of(m_edges);
  internal::Disjoint_sets sets(m_edges.size());
  for(const auto& [a, b] : pairs)
    if(a != b)
      sets.unite(static_cast<std::uint32_t>(m_index.find(m_edges, a)),
                 static_cast<std::uint32_t>(m_index.find(m_edges, b)));
  for(std::uint32_t i = 0; i < m_edges.size(); ++i)
    m_seams.push_back(m_edges[sets.find(i)]);
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE std::vector<internal::Face_side>
Surface_seams::lone_sides(std::size_t sides_at_once) const {
  CGAL_precondition(sides_at_once > 0);
  struct Side_of_seam {
    Key seam;
    std::uint64_t side; // three times the number of the face, and more
  };
  // Seams are looked at in ranges of their lower vertex.
  const std::size_t number_of_sides = 3 * m_surface.number_of_faces(),
                    number_of_vertices = m_surface.number_of_vertices(),
                    number_of_ranges = (number_of_sides - 1) / sides_at_once + 1;
  std::vector<std::uint64_t> lone;
  std::vector<Side_of_seam> sides;
  for(std::size_t range = 0; range < number_of_ranges; ++range) {
    const std::size_t first = number_of_vertices * range / number_of_ranges,
                      last = number_of_vertices * (range + 1) / number_of_ranges;
    sides.clear();
    for(std::size_t f = 0; f < m_surface.number_of_faces(); ++f)
      for(int number = 0; number < 3; ++number) {
        const Key key = seam(f, number);
        if(key >> 32 >= first && key >> 32 < last)
          sides.push_back({key, 3 * f + static_cast<std::size_t>(number)});
      }
    std::sort(sides.begin(), sides.end(),
              [](const Side_of_seam& a, const Side_of_seam& b) { return a.seam < b.seam; });
    for(std::size_t i = 0; i < sides.size(); ++i)
      if((i == 0 || sides[i - 1].seam != sides[i].seam) &&
         (i + 1 == sides.size() || sides[i + 1].seam != sides[i].seam))
        lone.push_back(sides[i].side);
  }
  std::sort(lone.begin(), lone.end());
  std::vector<internal::Face_side> result;
  result.reserve(lone.size());
  for(const std::uint64_t side : lone)
    result.push_back({static_cast<std::size_t>(side / 3), static_cast<int>(side % 3)});
  return result;
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SURFACE_SEAMS_IMPL_H
