// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_INTERNAL_SPLINE_EVALUATION_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_INTERNAL_SPLINE_EVALUATION_H

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

/// the sheet point of a point of a face; `not_on_surface` if the point is not on it
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
  const Sheet_point p =
      locate_on_face(space, level, surface.surface_point(location).point, location.face);
  if(p.sheet == Sheet_point::not_on_surface)
    throw Location_error("a location with face " + std::to_string(location.face) +
                         " is not on the surface");
  return p;
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

/// The sheet points of all vertices; `not_on_surface` for those without a face of positive area.
inline std::vector<Sheet_point> locate_vertices(const Spline_space_3& space, int level) {
  const Triangulated_surface_3& surface = space.surface();
  const auto none = (std::numeric_limits<std::uint32_t>::max)();
  std::vector<std::uint32_t> first_face(surface.number_of_vertices(), none);
  for(std::size_t f = surface.number_of_faces(); f-- > 0;)
    if(!surface.is_degenerate(f))
      for(std::uint32_t v : surface.triangle(f))
        first_face[v] = static_cast<std::uint32_t>(f);

  std::vector<Sheet_point> points(surface.number_of_vertices());
  constexpr std::size_t grain = 1024;
  parallel_for(space.options().is_parallel, 0, points.size(), grain,
               [&](std::size_t begin, std::size_t end) {
                 for(std::size_t v = begin; v < end; ++v)
                   if(first_face[v] != none)
                     points[v] = locate_on_face(space, level, surface.point(v), first_face[v]);
               });

  // The tip of a needle may have lost its fragment to rounding; then another face serves.
  std::vector<char> is_lost(points.size());
  for(std::size_t v = 0; v < points.size(); ++v)
    is_lost[v] = first_face[v] != none && points[v].sheet == Sheet_point::not_on_surface;
  if(std::find(is_lost.begin(), is_lost.end(), 1) != is_lost.end())
    for(std::size_t f = 0; f < surface.number_of_faces(); ++f)
      for(std::uint32_t v : surface.triangle(f))
        if(is_lost[v] && !surface.is_degenerate(f)) {
          points[v] = locate_on_face(space, level, surface.point(v), f);
          is_lost[v] = points[v].sheet == Sheet_point::not_on_surface;
        }
  // Where all of them are needles, the nearest place that has a fragment stands for the tip, of
  // places that are twice as far each time.
  constexpr int steps = 20;
  if(std::find(is_lost.begin(), is_lost.end(), 1) != is_lost.end())
    for(std::size_t f = 0; f < surface.number_of_faces(); ++f)
      for(std::uint32_t v : surface.triangle(f)) {
        const Point_3 center =
            CGAL::centroid(surface.point(f, 0), surface.point(f, 1), surface.point(f, 2));
        for(int step = steps; step >= 0 && is_lost[v] && !surface.is_degenerate(f); --step) {
          const Vector_3 inwards = std::ldexp(1., -step) * (center - surface.point(v));
          points[v] = locate_on_face(space, level, surface.point(v) + inwards, f);
          is_lost[v] = points[v].sheet == Sheet_point::not_on_surface;
        }
      }
  return points;
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_INTERNAL_SPLINE_EVALUATION_H
