// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_GEODESICS_GEODESIC_SOLVER_H
#define CGAL_RESTRICTED_LAPLACIAN_3_GEODESICS_GEODESIC_SOLVER_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parameters.h>
#include <CGAL/Restricted_laplacian_3/surface/Surface_location.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Distances
/// From where distances are measured: any number of vertices, points in faces, segments and the
/// boundary. Each has a label, a number that the vertices get which are nearest to it: sources with
/// one label are one set.
class Geodesic_sources {
public:
  /// \ingroup PkgRestrictedLaplacian3Distances
  /// A point, or the segment between two points of a face.
  struct Segment {
    /// one end
    Surface_location from;
    /// the other end, the same if it is a point; a location of the same face
    Surface_location to;
    /// the label
    std::uint32_t label;
  };

  Geodesic_sources() = default;
  /// one vertex, with the label 0
  static Geodesic_sources vertex(std::size_t v) {
    Geodesic_sources sources;
    sources.add_vertex(v);
    return sources;
  }

  /// \param v position of the vertex in the iteration over `vertices(tm)`, counted from 0
  /// \param label what the nearest vertices get
  void add_vertex(std::size_t v, std::uint32_t label = 0) { m_vertices.push_back({v, label}); }
  /// a point of the surface; it may lie on an edge, or be a vertex
  void add_location(const Surface_location& location, std::uint32_t label = 0) {
    m_segments.push_back({location, location, label});
  }
  /// The segment between two points of a face. A polyline on the surface consists of such segments.
  /// \throws Location_error if the faces differ
  void add_segment(const Surface_location& from, const Surface_location& to,
                   std::uint32_t label = 0) {
    if(from.face != to.face)
      throw Location_error("a segment begins in face " + std::to_string(from.face) +
                           " and ends in face " + std::to_string(to.face));
    m_segments.push_back({from, to, label});
  }
  /// all edges with one face only
  void add_boundary(std::uint32_t label = 0) { m_boundaries.push_back(label); }

  /// whether nothing was added
  bool empty() const { return m_vertices.empty() && m_segments.empty() && m_boundaries.empty(); }
  /// vertices, and their labels
  const std::vector<std::pair<std::size_t, std::uint32_t>>& vertices() const { return m_vertices; }
  /// points and segments
  const std::vector<Segment>& segments() const { return m_segments; }
  /// labels of the boundary, one for each time that it was added
  const std::vector<std::uint32_t>& boundaries() const { return m_boundaries; }

private:
  std::vector<std::pair<std::size_t, std::uint32_t>> m_vertices;
  std::vector<Segment> m_segments;
  std::vector<std::uint32_t> m_boundaries;
};

/// \ingroup PkgRestrictedLaplacian3Distances
/// Distances along a surface, and what is known with them.
struct Geodesic_distances {
  /// the label of a vertex that no source reaches
  static constexpr std::uint32_t no_label = 0xffffffff;

  /// from where they are
  Geodesic_sources sources;
  /// of the vertices, in units of length; infinite where no source is reached
  std::vector<double> distances;
  /// Unit vectors at the vertices: where the shortest way to the source begins, tangent to a face
  /// of the vertex. The gradient of the distance is the opposite. Zero at sources, where no source
  /// is reached, where the faces of a vertex form no fan, and at the few vertices at which the
  /// direction could not be found.
  std::vector<Vector_3> directions;
  /// The same as angles around the vertices, over their faces, counted from an edge that only the
  /// solver knows, for `Geodesic_function`; NaN where the vector is zero.
  std::vector<double> angles;
  /// labels of the nearest sources: Voronoi regions
  std::vector<std::uint32_t> labels;
  /// number of the vertices with a face that no source reaches
  std::size_t number_of_unreached_vertices = 0;
};

/// \ingroup PkgRestrictedLaplacian3Distances
/// How distances are propagated.
enum class Geodesic_method {
  /// by windows where they are needed, and cubics elsewhere
  fast,
  /// by windows alone: exact up to rounding, in more time, on fine meshes by far
  exact
};

/// \ingroup PkgRestrictedLaplacian3Distances
/// How distances are computed: the named parameters of queries. A `Geodesic_method` stands for
/// options that are the defaults else.
struct Geodesic_options {
  /// whether they need to be exact
  Geodesic_method method = Geodesic_method::fast;
  /// Bytes that a query may take for what it propagates. Most need some hundred bytes for each
  /// face, but there are surfaces, made for that, on which windows of rays multiply. Without a
  /// value `memory_of_machine()`
  std::optional<double> maximum_memory;
  /// Distances beyond are infinite, and take no time; without a value all are computed. In the unit
  /// of the coordinates.
  std::optional<double> maximum_distance;
  /// is called with the part of the work that is done, from 0 to 1, on the thread of the caller; if
  /// it returns `false`, the work ends with the exception `Canceled`
  std::function<bool(double)> progress;
  /// whether queries for several sources run on several threads; no effect unless the program is
  /// linked with TBB. The results are the same.
  bool is_parallel = false;

  /// the defaults
  Geodesic_options() = default;
  /// \param m the method
  Geodesic_options(Geodesic_method m) : method(m) {}
  /// what is among named parameters, and the defaults else
  template <class NamedParameters, internal::Require_named_parameters<NamedParameters> = 0>
  Geodesic_options(const NamedParameters& np) : is_parallel(internal::is_parallel(np)) {
    internal::read_parameter(np, internal_np::maximum_memory, maximum_memory);
    internal::read_parameter(np, internal_np::maximum_distance, maximum_distance);
    internal::read_parameter(np, internal_np::progress, progress);
  }
};

/// \ingroup PkgRestrictedLaplacian3Distances
/// Vertices near sources, and their distances.
struct Near_vertices {
  /// ascending
  std::vector<std::size_t> vertices;
  /// one for each of them
  std::vector<double> distances;
};

/// \ingroup PkgRestrictedLaplacian3Distances
/// Distances along a surface, set up once for any number of queries.
///
/// Distances are those on the triangles as they are, lengths of shortest ways over their faces.
/// They are propagated from the sources together with the directions of their rays, exactly near
/// sources, at the shadows of saddles and boundaries, at ridges and on long needles, elsewhere by a
/// cubic in the squared distance along each edge; see \ref RL_theory_distances. On the meshes of
/// \ref RL_distance_study they differ from exact distances by less than 0.03 % in the mean. The
/// surface need not be a manifold, nor orientable, nor connected. Faces with the same vertices
/// count once, vertices at the two ends of a side of no length are one, and faces may have no area.
///
/// A query takes time and memory nearly linear in the number of faces. Queries may run at the same
/// time; their results do not depend on the number of threads.
class Geodesic_solver {
public:
  /// Takes time \f$O(n \log n)\f$ for \f$n\f$ faces.
  /// \param surface triangles, or points: then triangles are made of these by CGAL's advancing
  /// front, and distances are those on them; a point that no triangle takes is at infinity, and
  /// many of these show that the points are too sparse for a surface
  /// \param joining_tolerance in the unit of the coordinates: vertices on the boundary are one if
  /// they are not farther apart, and a face is divided where such a vertex lies on its side, as in
  /// soups with cracks and T-junctions; without a value nothing is joined
  /// \throws Input_error if no triangle can be made of the points
  /// \throws Parameter_error if the tolerance is negative, or more than a hundredth of the extent
  explicit Geodesic_solver(Triangulated_surface_3 surface,
                           std::optional<double> joining_tolerance = {});

  /// the surface, as given to the constructor
  const Triangulated_surface_3& surface() const;

  /// Whether a vertex, or point, is one of a triangle. Others are no part of the surface: their
  /// distances from all vertices but themselves are infinite.
  /// \throws Invalid_vertex_error if it does not exist
  bool has_face(std::size_t vertex) const;

  /// A vertex as a location: in one of its faces.
  /// \throws Invalid_vertex_error if it does not exist, or has no face
  Surface_location location(std::size_t vertex) const;

  /// Distances of all vertices from the nearest of the sources.
  /// \param sources at least one
  /// \param options how they are computed
  /// \throws Parameter_error `maximum_memory`, if windows of rays would take more
  /// \throws Parameter_error if there is no source: none was added, or the boundary, and there is
  /// none
  /// \throws Invalid_vertex_error a source is a vertex that does not exist
  /// \throws Location_error a source is not on the surface
  /// \throws Canceled if `progress` returns `false`
  Geodesic_distances distances(const Geodesic_sources& sources,
                               const Geodesic_options& options = {}) const;

  /// Distances of all vertices from where a function is 0 that is linear on each triangle, negative
  /// where the function is negative: the signed distance from the boundary of a region. Directions
  /// lead to the zeros from both sides. Between points the triangles are those that the solver
  /// made; then `sources` of the result is empty.
  /// \param values of the function, one for each vertex
  /// \param options how they are computed
  /// \throws Parameter_error `values`, if their number is not that of the vertices, one of them is
  /// not finite, or the function is nowhere 0
  /// \throws Parameter_error, Canceled as `distances()`
  Geodesic_distances signed_distances(const std::vector<double>& values,
                                      const Geodesic_options& options = {}) const;

  /// Distances of all vertices from each of several sources.
  /// \param sources each is a set of sources, as for `distances()`
  /// \param options how they are computed; each thread may take the memory
  /// \return one row for each element of `sources`, of as many numbers as there are vertices, one
  /// after the other; infinite where no source is reached
  /// \throws Parameter_error, Invalid_vertex_error, Location_error as `distances()`
  /// \throws Canceled if `progress` returns `false`
  std::vector<double> distance_matrix(const std::vector<Geodesic_sources>& sources,
                                      const Geodesic_options& options = {}) const;

  /// The same for some vertices, the targets: the propagation ends when it has reached them.
  /// \param sources each is a set of sources, as for `distances()`
  /// \param targets vertices, in any order
  /// \param options how they are computed
  /// \return one row for each element of `sources`, of as many numbers as there are targets;
  /// infinite where no source is reached
  /// \throws Parameter_error, Invalid_vertex_error, Location_error as `distances()`; also for
  /// targets
  /// \throws Canceled if `progress` returns `false`
  std::vector<double> distance_matrix(const std::vector<Geodesic_sources>& sources,
                                      const std::vector<std::size_t>& targets,
                                      const Geodesic_options& options = {}) const;

  /// The same for points anywhere in faces. Between the corners of a face the distance is that of
  /// `Geodesic_function`; of a surface given by points the location is the point.
  /// \param sources each is a set of sources, as for `distances()`
  /// \param targets locations, in any order
  /// \param options how they are computed
  /// \return one row for each element of `sources`, of as many numbers as there are targets
  /// \throws Parameter_error, Invalid_vertex_error, Location_error as `distances()`; also for
  /// targets
  /// \throws Canceled if `progress` returns `false`
  std::vector<double> distance_matrix(const std::vector<Geodesic_sources>& sources,
                                      const std::vector<Surface_location>& targets,
                                      const Geodesic_options& options = {}) const;

  /// The vertices that are not farther than a distance from each of several sources.
  /// \param sources each is a set of sources, as for `distances()`
  /// \param maximum_distance in the unit of the coordinates, not negative
  /// \param options how distances are computed
  /// \return what is near each element of `sources`
  /// \throws Parameter_error, Invalid_vertex_error, Location_error as `distances()`
  /// \throws Canceled if `progress` returns `false`
  std::vector<Near_vertices> near_vertices(const std::vector<Geodesic_sources>& sources,
                                           double maximum_distance,
                                           const Geodesic_options& options = {}) const;

  /// Vertices far from each other and from the sources: each is the one that is farthest from the
  /// sources and those before (Gonzalez 1985). Ties go to the lower number.
  /// \param sources where to begin; if empty, the first vertex with a face, which is the first
  /// result then
  /// \param number of vertices
  /// \param options how distances are computed
  /// \return at most as many vertices as there are on the components that are reached
  std::vector<std::size_t> farthest_points(std::size_t number, const Geodesic_sources& sources = {},
                                           const Geodesic_options& options = {}) const;

private:
  /// calls `take(i, rays)` with the rays from each of the sources, on several threads
  /// \param targets vertices of the joined surface at which the rays end; empty: all
  template <class Take>
  void for_each_source(const std::vector<Geodesic_sources>& sources,
                       std::vector<std::uint32_t> targets, const Geodesic_options& options,
                       const Take& take) const;

  friend class Geodesic_function;

  struct Impl;
  std::shared_ptr<const Impl> m_impl;
};

} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/geodesics/Geodesic_solver_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_GEODESICS_GEODESIC_SOLVER_H
