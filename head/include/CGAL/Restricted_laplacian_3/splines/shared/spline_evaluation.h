// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_SHARED_SPLINE_EVALUATION_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_SHARED_SPLINE_EVALUATION_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parallel_for.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// A point as evaluation needs it: a sheet of some level, and local coordinates in its cell.
struct Sheet_point {
  static constexpr std::size_t not_on_surface = static_cast<std::size_t>(-1);

  std::size_t sheet = not_on_surface;
  std::array<double, 3> t = {0, 0, 0};
};

/// the sheet point of a point of a face, or piece; `not_on_surface` if the point is not on it
inline Sheet_point locate_on_face(const Spline_space_3& space, int level, const Point_3& point,
                                  std::size_t face) {
  const auto [sheet, t] = space.octree().locate(level, point, face);
  if(sheet == space.octree().number_of_sheets(level))
    return {};
  return {sheet, t};
}

/// \throws Location_error if there is no such face, or if the location is not on the surface
inline Sheet_point locate_on_surface(const Spline_space_3& space, int level,
                                     const Surface_location& location) {
  const Triangulated_surface_3& surface = space.surface();
  if(location.face >= surface.number_of_faces())
    throw Location_error("there is no face " + std::to_string(location.face));
  const auto [sheet, t] = space.octree().locate(level, location);
  if(sheet == space.octree().number_of_sheets(level))
    throw Location_error("a location with face " + std::to_string(location.face) +
                         " is not on the surface");
  return {sheet, t};
}

/// The same for many locations, on several threads if the space was made so.
inline std::vector<Sheet_point> locate_on_surface(const Spline_space_3& space, int level,
                                                  const std::vector<Surface_location>& locations) {
  std::vector<Sheet_point> points(locations.size());
  constexpr std::size_t grain = 256;
  parallel_for(space.options().is_parallel, 0, points.size(), grain,
               [&](std::size_t begin, std::size_t end) {
                 for(std::size_t i = begin; i < end; ++i)
                   points[i] = locate_on_surface(space, level, locations[i]);
               });
  return points;
}

/// Finds sheet points for the vertices that have none: the tips of needles whose fragments were
/// lost to rounding.
class Lost_vertices {
public:
  /// \param is_lost which vertices of the pieces they are, of the first ones
  Lost_vertices(const Spline_space_3& space, int level, std::vector<char> is_lost)
    : m_space(space), m_surface(space.octree().pieces()), m_level(level),
      m_is_lost(std::move(is_lost)) {}

  /// the vertices that were found, each with its point
  std::vector<std::pair<std::uint32_t, Sheet_point>> find() {
    for_each([this](std::size_t f, std::uint32_t v) { try_face(f, v, m_surface.point(v)); });
    for_each([this](std::size_t f, std::uint32_t v) { search_inwards(f, v); });
    search_neighbors();
    return std::move(m_found);
  }

private:
  bool is_lost(std::uint32_t v) const { return v < m_is_lost.size() && m_is_lost[v]; }
  bool is_any_lost() const {
    return std::find(m_is_lost.begin(), m_is_lost.end(), 1) != m_is_lost.end();
  }

  /// calls `work(face, vertex)` for the vertices that are still lost, and all their faces
  template <class Work> void for_each(Work&& work) {
    if(is_any_lost())
      for(std::size_t f = 0; f < m_surface.number_of_faces(); ++f)
        if(!m_surface.is_degenerate(f))
          for(std::uint32_t v : m_surface.triangle(f))
            if(is_lost(v))
              work(f, v);
  }

  void try_face(std::size_t f, std::uint32_t v, const Point_3& place) {
    const Sheet_point point = locate_on_face(m_space, m_level, place, f);
    if(point.sheet == Sheet_point::not_on_surface)
      return;
    m_found.emplace_back(v, point);
    m_is_lost[v] = 0;
  }

  /// The nearest place of a face that has a fragment stands for its tip, of places that are twice
  /// as far each time.
  void search_inwards(std::size_t f, std::uint32_t v) {
    constexpr int steps = 20;
    const Point_3 tip = m_surface.point(v);
    const Point_3 center =
        CGAL::centroid(m_surface.point(f, 0), m_surface.point(f, 1), m_surface.point(f, 2));
    for(int step = steps; step >= 0 && m_is_lost[v]; --step)
      try_face(f, v, tip + std::ldexp(1., -step) * (center - tip));
  }

  /// A face that is thinner than the tolerance of walls may have no fragment at all: then one of
  /// those that share a vertex with it serves, if it is in the cell of the lost vertex.
  void search_neighbors() {
    constexpr int most_trials = 64; // of a vertex: fans of needles may be large
    std::vector<std::pair<std::uint32_t, std::uint32_t>> lost_at; // a vertex, one that is lost
    for_each([&](std::size_t f, std::uint32_t v) {
      for(std::uint32_t corner : m_surface.triangle(f))
        if(corner != v)
          lost_at.emplace_back(corner, v);
    });
    std::sort(lost_at.begin(), lost_at.end());
    std::vector<int> trials(lost_at.empty() ? 0 : m_is_lost.size(), 0);
    for(std::size_t f = 0; f < m_surface.number_of_faces() && !lost_at.empty(); ++f)
      if(!m_surface.is_degenerate(f))
        for(std::uint32_t corner : m_surface.triangle(f))
          for(auto p = std::lower_bound(lost_at.begin(), lost_at.end(), std::make_pair(corner, 0u));
              p != lost_at.end() && p->first == corner; ++p)
            if(m_is_lost[p->second] && trials[p->second]++ < most_trials)
              try_face(f, p->second, m_surface.point(p->second));
  }

  const Spline_space_3& m_space;
  const Triangulated_surface_3& m_surface;
  int m_level;
  std::vector<char> m_is_lost;
  std::vector<std::pair<std::uint32_t, Sheet_point>> m_found;
};

/// Calls `visit(first, points)`, perhaps on several threads, with the sheet points of the vertices
/// from `first` on, `not_on_surface` for those without a face of positive area; once more for the
/// few that are found late. The vertices of a smooth surface are the first ones of its pieces, and
/// lie on them. Holds 5 bytes for each vertex.
template <class Visitor>
void for_each_vertex_chunk(const Spline_space_3& space, int level, Visitor&& visit) {
  const Triangulated_surface_3& surface = space.octree().pieces();
  const std::size_t number_of_vertices = space.surface().number_of_vertices();
  const auto none = (std::numeric_limits<std::uint32_t>::max)();
  std::vector<std::uint32_t> first_face(number_of_vertices, none);
  for(std::size_t f = surface.number_of_faces(); f-- > 0;)
    if(!surface.is_degenerate(f))
      for(std::uint32_t v : surface.triangle(f))
        if(v < number_of_vertices)
          first_face[v] = static_cast<std::uint32_t>(f);

  std::vector<char> is_lost(number_of_vertices);
  constexpr std::size_t grain = 1024;
  parallel_for(space.options().is_parallel, 0, number_of_vertices, grain,
               [&](std::size_t begin, std::size_t end) {
                 std::vector<Sheet_point> points(end - begin);
                 for(std::size_t v = begin; v < end; ++v)
                   if(first_face[v] != none) {
                     Sheet_point& point = points[v - begin];
                     point = locate_on_face(space, level, surface.point(v), first_face[v]);
                     is_lost[v] = point.sheet == Sheet_point::not_on_surface;
                   }
                 visit(begin, points);
               });
  for(const auto& [v, point] : Lost_vertices(space, level, std::move(is_lost)).find())
    visit(std::size_t(v), std::vector<Sheet_point>{point});
}

/// The sheet points of all vertices; `not_on_surface` for those without a face of positive area.
inline std::vector<Sheet_point> locate_vertices(const Spline_space_3& space, int level) {
  std::vector<Sheet_point> result(space.surface().number_of_vertices());
  for_each_vertex_chunk(space, level,
                        [&](std::size_t first, const std::vector<Sheet_point>& points) {
                          std::copy(points.begin(), points.end(),
                                    result.begin() + static_cast<std::ptrdiff_t>(first));
                        });
  return result;
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_SHARED_SPLINE_EVALUATION_H
