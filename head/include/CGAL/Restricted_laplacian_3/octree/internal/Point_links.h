// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_INTERNAL_POINT_LINKS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_INTERNAL_POINT_LINKS_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/Disjoint_sets.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Number_lists.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parallel_for.h>
#include <CGAL/Restricted_laplacian_3/octree/internal/Finest_sheets.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>
#include <CGAL/Restricted_laplacian_3/surface/shared/Nearest_points.h>

#include <boost/range/iterator_range.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// Which points of a point set lie next to each other on the surface: a guess, from positions and
/// oriented normals.
///
/// Two points are linked if one is among the `number_of_neighbors` nearest of the other, if their
/// normals differ by at most 120 degrees, and if the way from one to the other makes an angle of at
/// most 53 degrees (sine 0.8) with both tangent planes. The two sides of a thin plate, whose
/// normals are opposite, are not linked, however near they are; the faces that meet in an edge of
/// 90 degrees are.
///
/// The guess is wrong where normals are not oriented alike, where layers of the same orientation
/// are nearer to each other than about two distances of points, and at edges sharper than 60
/// degrees, such as the rim of a plate that is thinner than the distance of its points: there the
/// surface is torn.
class Point_links {
public:
  static constexpr std::size_t number_of_neighbors = 12;
  static constexpr double smallest_cosine_of_normals = -0.5;
  static constexpr double largest_sine_with_tangent_plane = 0.8;

  Point_links(const Triangulated_surface_3& surface, bool is_parallel) {
    const std::size_t size = surface.number_of_vertices(), grain = 1 << 11;
    std::vector<Point_3> points;
    for(std::size_t i = 0; i < size; ++i)
      points.push_back(surface.point(i));
    const Nearest_points nearest(points);
    std::vector<std::vector<Number_lists::Pair>> of_chunks((size - 1) / grain + 1);
    parallel_for(is_parallel, 0, size, grain, [&](std::size_t begin, std::size_t end) {
      std::vector<std::uint32_t> neighbors;
      for(std::size_t i = begin; i < end; ++i) {
        nearest.find(i, number_of_neighbors, neighbors);
        for(std::uint32_t j : neighbors)
          if(are_linked(surface, i, j)) {
            of_chunks[begin / grain].emplace_back(static_cast<std::uint32_t>(i), j);
            of_chunks[begin / grain].emplace_back(j, static_cast<std::uint32_t>(i));
          }
      }
    });
    std::vector<Number_lists::Pair> pairs;
    for(const auto& of_chunk : of_chunks)
      pairs.insert(pairs.end(), of_chunk.begin(), of_chunk.end());
    m_links = Number_lists(size, pairs);
  }

  /// the points that a point is linked with, ascending
  boost::iterator_range<const std::uint32_t*> operator[](std::size_t i) const { return m_links[i]; }

  /// Unites those of some points in `sets` that are linked.
  /// \param points one fragment for each, ascending
  void join(const Cell_fragment* points, std::uint32_t size, Disjoint_sets& sets) const {
    sets.reset(size);
    for(std::uint32_t a = 0; a < size; ++a) {
      std::uint32_t b = 0;
      for(std::uint32_t other : m_links[points[a].face]) {
        while(b < a && points[b].face < other)
          ++b;
        if(b == a)
          break;
        if(points[b].face == other)
          sets.unite(a, b);
      }
    }
  }

private:
  static bool are_linked(const Triangulated_surface_3& surface, std::size_t i, std::size_t j) {
    const Vector_3 way = surface.point(j) - surface.point(i);
    const Vector_3 n = surface.normal(i), m = surface.normal(j);
    const double height = (std::max)(std::abs(way * n), std::abs(way * m));
    return n * m >= smallest_cosine_of_normals &&
           height <= largest_sine_with_tangent_plane * std::sqrt(way.squared_length());
  }

  Number_lists m_links;
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_INTERNAL_POINT_LINKS_H
