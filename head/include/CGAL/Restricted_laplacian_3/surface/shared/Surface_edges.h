// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SHARED_SURFACE_EDGES_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SHARED_SURFACE_EDGES_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/Number_lists.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>

#include <boost/range/iterator_range_core.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// The edges of a surface, and the sides of faces that run along each: those with the same two
/// vertices, any number of them. Edges are sorted by their vertices. Nearly linear in the number of
/// faces.
class Surface_edges {
public:
  /// side `number` of a face, from corner `number` to corner `(number + 1) % 3`
  struct Side {
    std::uint32_t face;
    std::uint32_t number;
  };
  /// the sides of which faces
  enum class Faces { all, not_degenerate };

  /// \param surface a surface of triangles; it is read here only
  explicit Surface_edges(const Triangulated_surface_3& surface, Faces faces = Faces::all)
    : m_number_of_vertices(surface.number_of_vertices()) {
    const auto ends = [&surface](std::size_t side) -> Ends {
      const std::size_t face = side / 3, number = side - 3 * face;
      const auto& t = surface.triangle(face);
      const std::uint32_t a = t[number], b = t[number == 2 ? 0 : number + 1];
      return {(std::min)(a, b), (std::max)(a, b)};
    };
    // the sides of each lower end: their upper ends, and in the low bits their numbers
    std::vector<std::size_t> first;
    std::vector<std::uint64_t> keys;
    group_by_key(
        m_number_of_vertices, 3 * surface.number_of_faces(),
        [&](std::size_t side) {
          return faces == Faces::not_degenerate && surface.is_degenerate(side / 3)
                     ? m_number_of_vertices
                     : std::size_t(ends(side)[0]);
        },
        [&](std::size_t side) { return std::uint64_t(ends(side)[1]) << 32 | side; }, first, keys);
    m_sides.reserve(keys.size());
    // Most edges have two sides.
    m_ends.reserve(keys.size() / 2 + 1);
    m_first_sides.reserve(keys.size() / 2 + 2);
    for(std::size_t v = 0; v < m_number_of_vertices; ++v) {
      std::sort(keys.begin() + static_cast<std::ptrdiff_t>(first[v]),
                keys.begin() + static_cast<std::ptrdiff_t>(first[v + 1]));
      for(std::size_t i = first[v]; i < first[v + 1]; ++i) {
        const auto upper_end = static_cast<std::uint32_t>(keys[i] >> 32),
                   side = static_cast<std::uint32_t>(keys[i]);
        if(i == first[v] || upper_end != keys[i - 1] >> 32) {
          m_ends.push_back({static_cast<std::uint32_t>(v), upper_end});
          m_first_sides.push_back(m_sides.size());
        }
        m_sides.push_back({side / 3, side % 3});
      }
    }
    m_first_sides.push_back(m_sides.size());
  }

  /// numbers of two vertices in ascending order
  using Ends = std::array<std::uint32_t, 2>;

  /// number of edges
  std::size_t size() const { return m_ends.size(); }
  /// the vertices of an edge
  const Ends& ends(std::size_t edge) const { return m_ends[edge]; }
  /// the number of the edge between two vertices, in ascending order, or `size()`
  std::size_t find(const Ends& ends) const {
    const auto edge = std::lower_bound(m_ends.begin(), m_ends.end(), ends);
    return edge != m_ends.end() && *edge == ends ? static_cast<std::size_t>(edge - m_ends.begin())
                                                 : size();
  }
  /// the sides along an edge, sorted by face
  boost::iterator_range<const Side*> sides(std::size_t edge) const {
    return {m_sides.data() + m_first_sides[edge], m_sides.data() + m_first_sides[edge + 1]};
  }
  /// whether an edge belongs to one side only
  bool is_on_boundary(std::size_t edge) const { return sides(edge).size() == 1; }

  /// the vertices of edges on the boundary, for each vertex 0 or 1
  std::vector<char> boundary_vertices() const {
    std::vector<char> result(m_number_of_vertices, 0);
    for(std::size_t edge = 0; edge < size(); ++edge)
      if(is_on_boundary(edge))
        result[m_ends[edge][0]] = result[m_ends[edge][1]] = 1;
    return result;
  }

private:
  std::size_t m_number_of_vertices;
  std::vector<Ends> m_ends;
  std::vector<std::size_t> m_first_sides; // of edges, and one more
  std::vector<Side> m_sides;
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SHARED_SURFACE_EDGES_H
