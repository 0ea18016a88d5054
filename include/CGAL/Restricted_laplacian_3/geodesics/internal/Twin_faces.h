// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_GEODESICS_INTERNAL_TWIN_FACES_H
#define CGAL_RESTRICTED_LAPLACIAN_3_GEODESICS_INTERNAL_TWIN_FACES_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/Number_lists.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// Faces of which others take the place. One with the same three vertices as a face before it, in
/// any order, as in files that have faces twice, or once for each side of a sheet: rays would go on
/// in both, and become twice as many at every side. And one with fewer than three vertices, which
/// would lie between two faces at a side: its place is taken by a face with these vertices.
class Twin_faces {
public:
  using Triangle = Triangulated_surface_3::Triangle;

  Twin_faces() = default;
  /// Nearly linear in the number of faces.
  explicit Twin_faces(const std::vector<Triangle>& triangles, std::size_t number_of_vertices) {
    // faces by the least of their vertices
    const Number_lists by_vertex =
        Number_lists::by_key(number_of_vertices, triangles.size(),
                             [&](std::size_t f) { return sorted(triangles[f])[0]; });
    std::vector<std::uint32_t> others; // with fewer than three vertices
    std::vector<std::pair<Triangle, std::uint32_t>> faces;
    for(std::size_t v = 0; v < number_of_vertices; ++v) {
      faces.clear();
      for(const std::uint32_t f : by_vertex[v])
        if(const Triangle t = sorted(triangles[f]); t[0] < t[1] && t[1] < t[2])
          faces.emplace_back(t, f);
        else
          others.push_back(f);
      std::sort(faces.begin(), faces.end());
      for(std::size_t i = 1; i < faces.size(); ++i)
        if(faces[i].first == faces[i - 1].first) {
          const std::uint32_t before = faces[i - 1].second;
          replace(faces[i].second, m_places.empty() ? before : m_places[before].face, triangles);
        }
    }
    replace_degenerate(others, triangles);
  }

  bool empty() const { return m_places.empty(); }

  /// Leaves one vertex to each of them, so that their sides are nobody's. They keep their numbers.
  void take_from(std::vector<Triangle>& triangles) const {
    for(std::uint32_t f = 0; f < m_places.size(); ++f)
      if(m_places[f].face != f)
        triangles[f].fill(triangles[f][0]);
  }

  /// from a place in a face to the same in the face that takes its place
  void move(std::uint32_t& face, std::array<double, 3>& barycentric) const {
    if(face >= m_places.size() || m_places[face].face == face)
      return;
    const std::array<double, 3> l = std::exchange(barycentric, {0, 0, 0});
    for(std::size_t k = 0; k < 3; ++k)
      barycentric[m_places[face].corners[k]] += l[k];
    face = m_places[face].face;
  }

private:
  static Triangle sorted(Triangle t) {
    std::sort(t.begin(), t.end());
    return t;
  }

  void replace(std::uint32_t face, std::uint32_t by, const std::vector<Triangle>& triangles) {
    if(m_places.empty())
      for(std::uint32_t f = 0; f < triangles.size(); ++f)
        m_places.push_back({f, {0, 1, 2}});
    m_places[face].face = by;
    const Triangle& t = triangles[by];
    for(std::size_t k = 0; k < 3; ++k)
      m_places[face].corners[k] =
          static_cast<std::uint32_t>(std::find(t.begin(), t.end(), triangles[face][k]) - t.begin());
  }

  /// finds for each of these faces one that has its vertices, if there is one
  void replace_degenerate(const std::vector<std::uint32_t>& faces,
                          const std::vector<Triangle>& triangles) {
    using Ends = std::array<std::uint32_t, 2>;
    std::vector<std::pair<Ends, std::uint32_t>> wanted;
    for(const std::uint32_t f : faces) {
      const Triangle t = sorted(triangles[f]);
      wanted.push_back({{t[0], t[2]}, f});
    }
    std::sort(wanted.begin(), wanted.end());
    const std::size_t n = wanted.empty() ? 0 : triangles.size();
    for(std::uint32_t f = 0; f < n; ++f) {
      const Triangle t = sorted(triangles[f]);
      if(!(t[0] < t[1] && t[1] < t[2]) || (!empty() && m_places[f].face != f))
        continue;
      for(const Ends& ends :
          {Ends{t[0], t[1]}, {t[1], t[2]}, {t[0], t[2]}, {t[0], t[0]}, {t[1], t[1]}, {t[2], t[2]}})
        for(auto w = std::lower_bound(wanted.begin(), wanted.end(), std::pair(ends, 0u));
            w != wanted.end() && w->first == ends; ++w)
          if(empty() || m_places[w->second].face == w->second)
            replace(w->second, f, triangles);
    }
  }

  struct Place {
    std::uint32_t face;
    std::array<std::uint32_t, 3> corners; // in it, of the corners of the other face
  };
  std::vector<Place> m_places; // of all faces; empty if they keep their places
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_GEODESICS_INTERNAL_TWIN_FACES_H
