// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_GEODESICS_GEODESIC_FUNCTION_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_GEODESICS_GEODESIC_FUNCTION_IMPL_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/geodesics/Geodesic_function.h>
#include <CGAL/Restricted_laplacian_3/geodesics/Geodesic_solver_impl.h>
#include <CGAL/Restricted_laplacian_3/geodesics/internal/Geodesic_triangle.h>
#include <CGAL/Restricted_laplacian_3/geodesics/internal/Path_search.h>
#include <CGAL/Restricted_laplacian_3/surface/vertex_normals.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

struct Geodesic_function::Impl {
  using Side = internal::Ray_geometry::Side;
  using Triangle = internal::Geodesic_triangle;

  Impl(const Geodesic_solver& s, Geodesic_distances d) : solver(s), distances(std::move(d)) {
    const std::size_t n = solver.surface().number_of_vertices();
    if(distances.distances.size() != n || distances.angles.size() != n)
      throw Parameter_error("distances", "are not those of the vertices of the surface");
    sources = solver.m_impl->parts(distances.sources);
  }

  /// joined
  const Triangulated_surface_3& surface() const { return solver.m_impl->surface.joined(); }
  const internal::Ray_geometry& geometry() const { return solver.m_impl->geometry; }

  double unit() const { return solver.m_impl->unit(); }

  bool is_point_set() const { return solver.surface().is_point_set(); }
  /// at a point of a surface given by points
  Value at_point(std::size_t i) const {
    return {distances.distances[i], -1. * distances.directions[i]};
  }

  Triangle triangle(std::uint32_t face) const {
    return solver.m_impl->triangle(face, sources, [this](std::uint32_t v) {
      return std::pair(distances.distances[v] / unit(), distances.angles[v]);
    });
  }

  /// a value in the frame of side 0 of a face, as one in space
  Value in_space(std::size_t face, const Triangle::Value& value) const {
    const Vector_3 u = internal::unit_or_zero(surface().point(face, 1) - surface().point(face, 0)),
                   v = CGAL::cross_product(surface().normal(face), u);
    return {value.distance * unit(), value.gradient.x * u + value.gradient.y * v};
  }

  void add(std::uint32_t face, const Triangle::Barycentric& from, const Triangle::Barycentric& to,
           Geodesic_path& path) const {
    const internal::Joined_surface& all = solver.m_impl->surface;
    if(path.points.empty())
      path.points.push_back(surface().surface_point({face, from}).point);
    if(!all.original().is_point_set())
      path.segments.push_back({all.original({face, from}), all.original({face, to}), 0});
    path.points.push_back(surface().surface_point({face, to}).point);
    path.length += (geometry().place(face, to) - geometry().place(face, from)).length() * unit();
  }

  /// The point of a side at which the distance has a value, which is between those of its ends;
  /// found in the first face at the edge, so that it is the same for all.
  Triangle::Barycentric crossing(const Side& side, double value) const {
    Side first = side;
    geometry().for_each_beyond(side, [&](const Side& other) {
      if(other.face < first.face)
        first = other;
    });
    const Triangle in_face = triangle(first.face);
    const auto at = [&](double t) {
      Triangle::Barycentric l = {0, 0, 0};
      l[first.number] = 1 - t;
      l[(first.number + 1) % 3] = t;
      return l;
    };
    const bool rises = in_face.corner_distance(first.number) < value;
    double low = 0, high = 1;
    for(int i = 0; i < 50; ++i) {
      const double t = (low + high) / 2;
      ((in_face.bounded(at(t)).distance < value) == rises ? low : high) = t;
    }
    return first.face == side.face ? at(low) : geometry().beyond(first, side, at(low));
  }

  Geodesic_solver solver;
  Geodesic_distances distances;
  std::vector<internal::Source_part> sources; // sorted by their faces
};

CGAL_RESTRICTED_LAPLACIAN_3_INLINE
Geodesic_function::Geodesic_function(const Geodesic_solver& solver, Geodesic_distances distances)
  : m_impl(std::make_shared<const Impl>(solver, std::move(distances))) {}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE const Triangulated_surface_3&
Geodesic_function::surface() const {
  return m_impl->solver.surface();
}
CGAL_RESTRICTED_LAPLACIAN_3_INLINE const Geodesic_distances& Geodesic_function::distances() const {
  return m_impl->distances;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Geodesic_function::Value
Geodesic_function::bounded(const Surface_location& location) const {
  if(m_impl->is_point_set()) {
    m_impl->solver.m_impl->checked(location);
    return m_impl->at_point(location.face);
  }
  const auto [face, barycentric] = m_impl->solver.m_impl->place(location);
  return m_impl->in_space(face, m_impl->triangle(face).bounded(barycentric));
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void
Geodesic_function::evaluate(const Surface_point* points, std::size_t number, Value* values) const {
  if(m_impl->is_point_set()) {
    for(std::size_t i = 0; i < number; ++i)
      values[i] = m_impl->at_point(points[i].face);
    return;
  }
  for(std::size_t i = 0; i < number;) {
    auto place = m_impl->solver.m_impl->surface.joined(points[i]);
    const std::uint32_t face = place.face;
    const internal::Geodesic_triangle triangle = m_impl->triangle(face);
    do {
      values[i] = m_impl->in_space(face, triangle(place.barycentric));
      if(++i < number)
        place = m_impl->solver.m_impl->surface.joined(points[i]);
    } while(i < number && place.face == face);
  }
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Geodesic_path
Geodesic_function::shortest_path(const Surface_location& from) const {
  if(std::isinf(value(from)))
    throw Location_error("no source is reached from face " + std::to_string(from.face));
  const auto [start_face, start_place] = m_impl->solver.m_impl->place(from);
  const internal::Path_search::Point start{start_face, start_place};
  internal::Path_search search(m_impl->geometry(),
                               [this](std::uint32_t face) { return m_impl->triangle(face); });
  Geodesic_path path;
  path.points.push_back(surface().surface_point(from).point);
  for(internal::Face_strip& strip : search(start))
    for(const auto& [face, begin, end] : strip.shortest_path())
      m_impl->add(face, begin, end, path);
  return path;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE std::vector<Geodesic_path>
Geodesic_function::isolines(double value) const {
  if(!(value > 0 && std::isfinite(value)))
    throw Parameter_error("value", "must be a positive, finite number");
  using Side = internal::Ray_geometry::Side;
  const internal::Ray_geometry& geometry = m_impl->geometry();
  const double level = value / m_impl->unit();
  const auto is_below = [&](std::uint32_t face, std::uint32_t k) {
    return distances().distances[geometry.vertex(face, k)] < value;
  };
  // the side by which the line leaves a face that it enters by a side
  const auto other_side = [&](const Side& in) {
    for(std::uint32_t k = in.number + 1; k < in.number + 3; ++k)
      if(is_below(in.face, k) != is_below(in.face, k + 1))
        return Side{in.face, k % 3};
    return in;
  };
  std::vector<char> is_done(m_impl->surface().number_of_faces(), 0);
  // the face beyond a side, if there is just one
  const auto beyond = [&](const Side& out) {
    Side result = out;
    int number = 0;
    geometry.for_each_beyond(out, [&](const Side& other) {
      result = other;
      ++number;
    });
    return number == 1 ? result : out;
  };
  std::vector<Geodesic_path> lines;
  for(std::uint32_t face = 0; face < is_done.size(); ++face) {
    if(is_done[face] || !geometry.is_used(face) ||
       !std::isfinite(distances().distances[geometry.vertex(face, 0)]))
      continue;
    std::uint32_t k = 0;
    while(k < 3 && is_below(face, k) == is_below(face, k + 1))
      ++k;
    if(k == 3)
      continue;
    // back to where the line begins, or once around, and then forth
    Side first{face, k};
    for(Side before = beyond(first); before.face != first.face;) {
      first = other_side(before);
      if(first.face == face)
        break;
      before = beyond(first);
    }
    Geodesic_path line;
    for(Side in = first; !is_done[in.face];) {
      is_done[in.face] = 1;
      const Side out = other_side(in);
      m_impl->add(in.face, m_impl->crossing(in, level), m_impl->crossing(out, level), line);
      in = beyond(out);
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_GEODESICS_GEODESIC_FUNCTION_IMPL_H
