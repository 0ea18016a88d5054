// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_GEODESICS_GEODESIC_SOLVER_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_GEODESICS_GEODESIC_SOLVER_IMPL_H

#include <CGAL/Restricted_laplacian_3/geodesics/Geodesic_solver.h>

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Progress.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/explain_out_of_memory.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parallel_for.h>
#include <CGAL/Restricted_laplacian_3/foundation/memory.h>
#include <CGAL/Restricted_laplacian_3/geodesics/internal/Geodesic_triangle.h>
#include <CGAL/Restricted_laplacian_3/geodesics/internal/Joined_surface.h>
#include <CGAL/Restricted_laplacian_3/geodesics/internal/Ray_geometry.h>
#include <CGAL/Restricted_laplacian_3/geodesics/internal/Ray_propagation.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <thread>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

struct Geodesic_solver::Impl {
  using Place = internal::Joined_surface::Place;

  Impl(Triangulated_surface_3 s, std::optional<double> joining_tolerance)
    : surface(std::move(s), joining_tolerance), geometry(surface.joined()) {}

  /// the unit of length of the geometry
  double unit() const { return surface.joined().extent(); }

  /// A location as barycentric coordinates, of which rounding errors are taken off.
  std::array<double, 3> checked(const Surface_location& location) const {
    constexpr double tolerance = 1e-9;
    if(location.face >= surface.original().number_of_faces())
      throw Location_error("there is no face " + std::to_string(location.face));
    std::array<double, 3> l = location.barycentric;
    double sum = 0;
    for(double& x : l) {
      if(!(x >= -tolerance && x <= 1 + tolerance))
        throw Location_error("a location is outside of face " + std::to_string(location.face));
      x = x < tolerance ? 0 : x;
      sum += x;
    }
    if(!(std::abs(sum - 1) <= 1e-6))
      throw Location_error("barycentric coordinates of a location in face " +
                           std::to_string(location.face) + " do not sum to 1");
    for(double& x : l)
      x /= sum;
    return l;
  }

  /// a vertex that has a face as a place in one of its faces
  Place place_of_vertex(std::uint32_t v) const {
    Place result;
    geometry.for_each_corner(v, [&](const internal::Ray_geometry::Corner& c) {
      result = {c.face, {0, 0, 0}};
      result.barycentric[c.number] = 1;
    });
    return result;
  }

  /// \throws Location_error if it is none
  Place place(const Surface_location& location) const {
    const auto checked = this->checked(location);
    if(!surface.original().is_point_set())
      return surface.joined(Surface_location{location.face, checked});
    return place_of_vertex(surface.vertex(static_cast<std::uint32_t>(location.face)));
  }

  /// Sources as rays need them: those that are vertices, with their labels, and parts of faces,
  /// each in all faces that it belongs to.
  struct All_sources {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> vertices;
    std::vector<internal::Source_part> parts;
  };

  /// \throws as `Geodesic_solver::distances()`
  All_sources all(const Geodesic_sources& sources) const {
    All_sources result;
    for(const auto& [v, label] : sources.vertices()) {
      if(v >= surface.original().number_of_vertices())
        throw Invalid_vertex_error(v, "is a source and does not exist");
      result.vertices.emplace_back(surface.vertex(static_cast<std::uint32_t>(v)), label);
    }
    for(const auto& [from, to, label] : sources.segments()) {
      const auto a = checked(from), b = checked(to);
      if(surface.original().is_point_set()) {
        result.vertices.emplace_back(surface.vertex(static_cast<std::uint32_t>(from.face)), label);
        continue;
      }
      surface.for_each_part(from.face, a, b, [&, label = label](const Place& p, const Place& q) {
        add(p, q, label, result);
      });
    }
    for(const std::uint32_t label : sources.boundaries())
      geometry.for_each_boundary_side([&](const internal::Ray_geometry::Side& side) {
        Place from{side.face, {0, 0, 0}}, to = from;
        from.barycentric[side.number] = 1;
        to.barycentric[(side.number + 1) % 3] = 1;
        add(from, to, label, result);
      });
    if(result.vertices.empty() && result.parts.empty() && sources.segments().empty())
      throw Parameter_error("sources", sources.boundaries().empty()
                                           ? "is empty"
                                           : "is the boundary, but the surface has none");
    return result;
  }

  /// Sources as parts of faces, vertices, too, sorted by their faces.
  /// \throws as `Geodesic_solver::distances()`
  std::vector<internal::Source_part> parts(const Geodesic_sources& sources) const {
    All_sources given = all(sources);
    for(const auto& [v, label] : given.vertices)
      geometry.for_each_corner(v, [&, label = label](const internal::Ray_geometry::Corner& c) {
        internal::Source_part part{c.face, {0, 0, 0}, {0, 0, 0}, label};
        part.from[c.number] = part.to[c.number] = 1;
        given.parts.push_back(part);
      });
    std::stable_sort(given.parts.begin(), given.parts.end(),
                     [](const auto& a, const auto& b) { return a.face < b.face; });
    return std::move(given.parts);
  }

  /// The distance in a face.
  /// \param parts of the sources, which are referred to
  /// \param ray `ray(v)` is the distance of a vertex, in the unit of the geometry, and the angle of
  /// its ray
  template <class Ray_of_vertex>
  internal::Geodesic_triangle triangle(std::uint32_t face,
                                       const std::vector<internal::Source_part>& parts,
                                       const Ray_of_vertex& ray) const {
    internal::Geodesic_triangle::Barycentric distances, angles;
    for(std::uint32_t k = 0; k < 3; ++k)
      std::tie(distances[k], angles[k]) = ray(geometry.vertex(face, k));
    const auto is_before = [](const internal::Source_part& s, std::uint32_t f) {
      return s.face < f;
    };
    const auto first = std::lower_bound(parts.begin(), parts.end(), face, is_before),
               last = std::lower_bound(first, parts.end(), face + 1, is_before);
    return {geometry,
            face,
            distances,
            angles,
            parts.data() + (first - parts.begin()),
            parts.data() + (last - parts.begin())};
  }

  /// the rays of the vertices of the joined surface
  /// \throws as `Geodesic_solver::distances()`
  std::vector<internal::Ray_propagation::Ray>
  rays(const Geodesic_sources& sources, const Geodesic_options& options,
       const internal::Progress& progress, const std::vector<std::uint32_t>& targets = {}) const {
    const All_sources given = all(sources);
    const double maximum_distance =
        options.maximum_distance.value_or(std::numeric_limits<double>::infinity());
    if(!(maximum_distance >= 0))
      throw Parameter_error("maximum_distance", "is " + std::to_string(maximum_distance) +
                                                    ", and must not be negative");
    const double maximum_memory = options.maximum_memory.value_or(this->maximum_memory);
    if(!(maximum_memory > 0))
      throw Parameter_error("maximum_memory",
                            "is " + std::to_string(maximum_memory) + ", and must be positive");
    return internal::explain_out_of_memory("not enough memory for the windows of rays", [&] {
      internal::Ray_propagation propagation(geometry, options.method == Geodesic_method::exact,
                                            maximum_memory);
      for(const auto& [v, label] : given.vertices)
        propagation.add_vertex(v, label);
      for(const auto& part : given.parts)
        propagation.add_segment(part.face, geometry.place(part.face, part.from),
                                geometry.place(part.face, part.to), part.label);
      return propagation.run(progress, {maximum_distance / unit(), targets});
    });
  }

  /// a segment in a face
  void add(const Place& p, const Place& q, std::uint32_t label, All_sources& all) const {
    const std::uint32_t face = p.face;
    const auto &from = p.barycentric, &to = q.barycentric;
    for(const auto& end : {from, to})
      if(geometry.corner_of(end) < 3)
        all.vertices.emplace_back(geometry.vertex(face, geometry.corner_of(end)), label);
    if(!geometry.is_used(face) || (from == to && geometry.corner_of(from) < 3))
      return;
    all.parts.push_back({face, from, to, label});
    // On a side they belong to the other faces there, too: the segment, or one of its ends.
    for(std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t opposite = (k + 2) % 3;
      if(from[opposite] == 0 || to[opposite] == 0)
        geometry.for_each_beyond({face, k}, [&](const internal::Ray_geometry::Side& other) {
          const auto there = [&](const std::array<double, 3>& l) {
            return geometry.beyond({face, k}, other, l);
          };
          all.parts.push_back({other.face, there(from[opposite] == 0 ? from : to),
                               there(to[opposite] == 0 ? to : from), label});
        });
    }
  }

  internal::Joined_surface surface;
  internal::Ray_geometry geometry; // of the joined surface, to which it refers
  double maximum_memory = memory_of_machine();
};

CGAL_RESTRICTED_LAPLACIAN_3_INLINE
Geodesic_solver::Geodesic_solver(Triangulated_surface_3 surface,
                                 std::optional<double> joining_tolerance) {
  m_impl = std::make_shared<const Impl>(std::move(surface), joining_tolerance);
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE const Triangulated_surface_3& Geodesic_solver::surface() const {
  return m_impl->surface.original();
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE bool Geodesic_solver::has_face(std::size_t vertex) const {
  if(vertex >= surface().number_of_vertices())
    throw Invalid_vertex_error(vertex, "does not exist");
  return m_impl->geometry.has_corner(m_impl->surface.vertex(static_cast<std::uint32_t>(vertex)));
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Surface_location
Geodesic_solver::location(std::size_t vertex) const {
  if(!has_face(vertex))
    throw Invalid_vertex_error(vertex, "has no face");
  if(surface().is_point_set())
    return {vertex, {1, 0, 0}};
  const std::uint32_t v = m_impl->surface.vertex(static_cast<std::uint32_t>(vertex));
  return m_impl->surface.original(m_impl->place_of_vertex(v));
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Geodesic_distances
Geodesic_solver::distances(const Geodesic_sources& sources, const Geodesic_options& options) const {
  const internal::Ray_geometry& geometry = m_impl->geometry;
  const std::size_t n = surface().number_of_vertices();
  const std::vector<internal::Ray_propagation::Ray> rays =
      m_impl->rays(sources, options, internal::Progress(options.progress));
  Geodesic_distances result;
  result.sources = sources;
  result.distances.resize(n);
  result.directions.assign(n, CGAL::NULL_VECTOR);
  result.angles.assign(n, std::numeric_limits<double>::quiet_NaN());
  result.labels.assign(n, Geodesic_distances::no_label);
  for(std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t v = m_impl->surface.vertex(i);
    result.distances[i] = rays[v].distance * m_impl->unit();
    if(std::isinf(rays[v].distance)) {
      result.number_of_unreached_vertices += geometry.has_corner(v);
      continue;
    }
    result.labels[i] = rays[v].origin.label;
    if(!std::isnan(rays[v].angle) && rays[v].distance > 0) {
      result.angles[i] = rays[v].angle;
      result.directions[i] = geometry.direction(v, rays[v].angle);
    }
  }
  return result;
}

template <class Take>
void Geodesic_solver::for_each_source(const std::vector<Geodesic_sources>& sources,
                                      std::vector<std::uint32_t> targets,
                                      const Geodesic_options& options, const Take& take) const {
  std::sort(targets.begin(), targets.end());
  targets.erase(std::unique(targets.begin(), targets.end()), targets.end());
  const internal::Progress progress(options.progress);
  const std::thread::id caller = std::this_thread::get_id();
  std::atomic<std::size_t> number_done = 0;
  const auto number = static_cast<double>(sources.size());
  internal::parallel_for(options.is_parallel, 0, sources.size(), 1,
                         [&](std::size_t i, std::size_t) {
                           internal::Progress part;
                           if(std::this_thread::get_id() == caller) {
                             const auto done = static_cast<double>(number_done);
                             part = progress.part(done / number, (done + 1) / number);
                           }
                           take(i, m_impl->rays(sources[i], options, part, targets));
                           ++number_done;
                         });
  progress(1);
}

namespace internal {

/// its numbers are to come
inline std::vector<double> matrix_of_distances(std::size_t rows, std::size_t columns) {
  return explain_out_of_memory("not enough memory for a matrix of distances",
                               [&] { return std::vector<double>(rows * columns); });
}

/// Adds where a function is 0 that is linear in a face: a segment, three sides or a corner.
inline void add_zeros(const Triangulated_surface_3& surface, std::size_t face,
                      const std::vector<double>& values, Geodesic_sources& sources) {
  std::array<double, 3> f;
  for(int i = 0; i < 3; ++i)
    f[i] = values[surface.triangle(face)[i]];
  std::vector<Surface_location> zeros;
  for(int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    Surface_location zero;
    zero.face = face;
    zero.barycentric.fill(0);
    if(f[i] == 0) {
      zero.barycentric[i] = 1;
      zeros.push_back(zero);
    } else if((f[i] < 0 && f[j] > 0) || (f[i] > 0 && f[j] < 0)) {
      // the halves do not overflow
      zero.barycentric[j] = f[i] / 2 / (f[i] / 2 - f[j] / 2);
      zero.barycentric[i] = 1 - zero.barycentric[j];
      zeros.push_back(zero);
    }
  }
  if(zeros.size() == 1)
    sources.add_location(zeros[0]);
  for(std::size_t k = 0; zeros.size() > 1 && k < (zeros.size() == 2 ? 1 : 3); ++k)
    sources.add_segment(zeros[k], zeros[(k + 1) % zeros.size()]);
}

} // namespace internal

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Geodesic_distances Geodesic_solver::signed_distances(
    const std::vector<double>& values, const Geodesic_options& options) const {
  const std::size_t n = surface().number_of_vertices();
  if(values.size() != n)
    throw Parameter_error("values", "are " + std::to_string(values.size()) + ", but there are " +
                                        std::to_string(n) + " vertices");
  for(std::size_t v = 0; v < n; ++v)
    if(!std::isfinite(values[v]))
      throw Parameter_error("values", "hold no finite number for vertex " + std::to_string(v));
  Geodesic_distances result;
  if(surface().is_point_set()) {
    // zeros are on the triangles between the points, which no location names
    result = Geodesic_solver(m_impl->surface.joined()).signed_distances(values, options);
    result.sources = {};
    for(std::size_t v = 0; v < n; ++v) {
      const std::uint32_t same = m_impl->surface.vertex(static_cast<std::uint32_t>(v));
      result.distances[v] = std::abs(result.distances[same]);
      result.directions[v] = result.directions[same];
      result.angles[v] = result.angles[same];
      result.labels[v] = result.labels[same];
    }
  } else {
    Geodesic_sources sources;
    for(std::size_t face = 0; face < surface().number_of_faces(); ++face)
      internal::add_zeros(surface(), face, values, sources);
    if(sources.empty())
      throw Parameter_error("values", "are nowhere 0, and do not change their sign");
    result = distances(sources, options);
  }
  for(std::size_t v = 0; v < n; ++v)
    if(values[v] < 0)
      result.distances[v] = -result.distances[v];
  return result;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE std::vector<double>
Geodesic_solver::distance_matrix(const std::vector<Geodesic_sources>& sources,
                                 const Geodesic_options& options) const {
  const std::size_t n = surface().number_of_vertices();
  std::vector<double> result = internal::matrix_of_distances(sources.size(), n);
  for_each_source(sources, {}, options, [&](std::size_t i, const auto& rays) {
    for(std::size_t v = 0; v < n; ++v)
      result[i * n + v] =
          rays[m_impl->surface.vertex(static_cast<std::uint32_t>(v))].distance * m_impl->unit();
  });
  return result;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE std::vector<double>
Geodesic_solver::distance_matrix(const std::vector<Geodesic_sources>& sources,
                                 const std::vector<std::size_t>& targets,
                                 const Geodesic_options& options) const {
  if(targets.empty())
    return {};
  const std::size_t n = targets.size();
  std::vector<std::uint32_t> vertices, to_reach;
  for(const std::size_t v : targets) {
    const bool is_on_surface = has_face(v);
    vertices.push_back(m_impl->surface.vertex(static_cast<std::uint32_t>(v)));
    if(is_on_surface)
      to_reach.push_back(vertices.back());
  }
  std::vector<double> result = internal::matrix_of_distances(sources.size(), n);
  for_each_source(sources, to_reach, options, [&](std::size_t i, const auto& rays) {
    for(std::size_t k = 0; k < n; ++k)
      result[i * n + k] = rays[vertices[k]].distance * m_impl->unit();
  });
  return result;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE std::vector<double>
Geodesic_solver::distance_matrix(const std::vector<Geodesic_sources>& sources,
                                 const std::vector<Surface_location>& targets,
                                 const Geodesic_options& options) const {
  if(targets.empty())
    return {};
  const internal::Ray_geometry& geometry = m_impl->geometry;
  const std::size_t n = targets.size();
  if(surface().is_point_set()) {
    std::vector<std::size_t> points;
    for(const Surface_location& target : targets) {
      m_impl->checked(target);
      points.push_back(target.face);
    }
    return distance_matrix(sources, points, options);
  }
  std::vector<Impl::Place> places;
  std::vector<std::uint32_t> vertices;
  double longest_side = 0;
  for(const Surface_location& target : targets) {
    places.push_back(m_impl->place(target));
    const std::uint32_t face = places.back().face;
    const auto corners = geometry.corners(face);
    for(std::uint32_t k = 0; k < 3; ++k) {
      vertices.push_back(geometry.vertex(face, k));
      longest_side = (std::max)(longest_side, (corners[(k + 1) % 3] - corners[k]).length());
    }
  }
  // corners may be farther than what is in the face
  Geodesic_options of_corners = options;
  if(options.maximum_distance && *options.maximum_distance >= 0)
    of_corners.maximum_distance = *options.maximum_distance + longest_side * m_impl->unit();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::vector<double> result = internal::matrix_of_distances(sources.size(), n);
  for_each_source(sources, vertices, of_corners, [&](std::size_t i, const auto& rays) {
    const std::vector<internal::Source_part> parts = m_impl->parts(sources[i]);
    for(std::size_t k = 0; k < n; ++k) {
      const internal::Geodesic_triangle triangle =
          m_impl->triangle(places[k].face, parts, [&](std::uint32_t v) {
            return std::pair(rays[v].distance, rays[v].angle);
          });
      const double distance = triangle.bounded(places[k].barycentric).distance * m_impl->unit();
      result[i * n + k] =
          distance > options.maximum_distance.value_or(infinity) ? infinity : distance;
    }
  });
  return result;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE std::vector<Near_vertices>
Geodesic_solver::near_vertices(const std::vector<Geodesic_sources>& sources,
                               double maximum_distance, const Geodesic_options& options) const {
  Geodesic_options own = options;
  own.maximum_distance = maximum_distance;
  std::vector<Near_vertices> result(sources.size());
  for_each_source(sources, {}, own, [&](std::size_t i, const auto& rays) {
    for(std::size_t v = 0; v < surface().number_of_vertices(); ++v) {
      const double distance = rays[m_impl->surface.vertex(static_cast<std::uint32_t>(v))].distance;
      if(std::isfinite(distance)) {
        result[i].vertices.push_back(v);
        result[i].distances.push_back(distance * m_impl->unit());
      }
    }
  });
  return result;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE std::vector<std::size_t>
Geodesic_solver::farthest_points(std::size_t number, const Geodesic_sources& sources,
                                 const Geodesic_options& options) const {
  const std::size_t n = surface().number_of_vertices();
  std::vector<std::size_t> result;
  if(number == 0)
    return result;
  const internal::Progress progress(options.progress);
  Geodesic_options of_query = options;
  // the last point needs no query
  const double queries = static_cast<double>(number) - (sources.empty() ? 1 : 0);
  double queries_done = 0;
  const auto distances_from = [&](const Geodesic_sources& from) {
    of_query.progress =
        progress.part(queries_done / queries, (queries_done + 1) / queries).callback();
    ++queries_done;
    return distances(from, of_query).distances;
  };
  std::vector<double> nearest;
  if(!sources.empty())
    nearest = distances_from(sources);
  else {
    std::size_t first = 0;
    while(!has_face(first))
      ++first;
    result.push_back(first);
    if(number > 1)
      nearest = distances_from(Geodesic_sources::vertex(first));
  }
  while(result.size() < number) {
    std::size_t farthest = n;
    for(std::size_t v = 0; v < n; ++v)
      if(std::isfinite(nearest[v]) && nearest[v] > (farthest < n ? nearest[farthest] : 0.))
        farthest = v;
    if(farthest == n)
      break;
    result.push_back(farthest);
    if(result.size() == number)
      break;
    const std::vector<double> from = distances_from(Geodesic_sources::vertex(farthest));
    for(std::size_t v = 0; v < n; ++v)
      nearest[v] = (std::min)(nearest[v], from[v]);
  }
  progress(1);
  return result;
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_GEODESICS_GEODESIC_SOLVER_IMPL_H
