// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_GEODESIC_DISTANCES_H
#define CGAL_RESTRICTED_LAPLACIAN_3_GEODESIC_DISTANCES_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/parameters.h>
#include <CGAL/Restricted_laplacian_3/geodesics/Geodesic_function.h>
#include <CGAL/Restricted_laplacian_3/geodesics/Geodesic_solver.h>
#include <CGAL/Restricted_laplacian_3/input/read_surface.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <optional>
#include <type_traits>

namespace CGAL {
namespace Restricted_laplacian_3 {

namespace internal {

/// sources that are given as such, as a vertex, or as a range of vertices
template <class FaceGraph, class Sources>
Geodesic_sources geodesic_sources(const FaceGraph& tm, const Sources& sources) {
  using Vertex = typename boost::graph_traits<FaceGraph>::vertex_descriptor;
  if constexpr(std::is_same_v<Sources, Geodesic_sources>)
    return sources;
  else {
    auto index = get(CGAL::dynamic_vertex_property_t<std::size_t>(), tm);
    std::size_t i = 0;
    for(Vertex v : vertices(tm))
      put(index, v, i++);
    Geodesic_sources result;
    if constexpr(std::is_convertible_v<Sources, Vertex>)
      result.add_vertex(get(index, Vertex(sources)));
    else
      for(const auto& v : sources)
        result.add_vertex(get(index, Vertex(v)));
    return result;
  }
}

template <class FaceGraph, class NamedParameters>
Geodesic_solver geodesic_solver(const FaceGraph& tm, const NamedParameters& np) {
  std::optional<double> joining_tolerance;
  read_parameter(np, internal_np::joining_tolerance, joining_tolerance);
  return Geodesic_solver(read_surface(tm, np), joining_tolerance);
}

} // namespace internal

/// \ingroup PkgRestrictedLaplacian3Distances
/// Computes distances along a mesh, see `Geodesic_solver`, which answers many queries.
/// \tparam FaceGraph a model of `FaceListGraph` and `VertexListGraph`, all of whose faces are
/// triangles
/// \param tm the surface
/// \param sources from where distances are measured: `Geodesic_sources`, a vertex descriptor, or a
/// range of vertex descriptors
/// \param distances a model of `WritablePropertyMap` with the vertex descriptor as key and a number
/// as value, receives the distances; infinite where no source is reached
/// \param np optional named parameters:
/// \cgalNamedParamsBegin
///   \named_of_mesh
///   \named_joining_tolerance \named_memory_of_distances \named_progress
/// \cgalNamedParamsEnd
/// \return distances again, directions and labels, in the order of `vertices(tm)`
/// \throws Input_error one of its derived classes names the face, vertex or parameter
template <class FaceGraph, class Sources, class VertexMap,
          class NamedParameters = parameters::Default_named_parameters,
          internal::Require_named_parameters<NamedParameters> = 0,
          internal::Require_no_named_parameters<VertexMap> = 0>
Geodesic_distances geodesic_distances(const FaceGraph& tm, const Sources& sources,
                                      VertexMap distances,
                                      const NamedParameters& np = parameters::default_values()) {
  Geodesic_distances result =
      internal::geodesic_solver(tm, np).distances(internal::geodesic_sources(tm, sources), np);
  std::size_t i = 0;
  for(auto v : vertices(tm))
    put(distances, v, result.distances[i++]);
  return result;
}

/// \ingroup PkgRestrictedLaplacian3Distances
/// Computes the shortest path between two vertices of a mesh. For many paths to one vertex, or to
/// other sources, see `Geodesic_function::shortest_path()`.
/// \tparam FaceGraph a model of `FaceListGraph` and `VertexListGraph`, all of whose faces are
/// triangles
/// \param tm the surface
/// \param from where the path begins
/// \param to where it ends
/// \param np optional named parameters:
/// \cgalNamedParamsBegin
///   \named_of_mesh
///   \named_joining_tolerance \named_memory_of_distances \named_progress
/// \cgalNamedParamsEnd
/// \throws Input_error one of its derived classes names the face, vertex or parameter
/// \throws Location_error if the vertices are not on one component
template <class FaceGraph, class NamedParameters = parameters::Default_named_parameters,
          internal::Require_named_parameters<NamedParameters> = 0>
Geodesic_path shortest_path(const FaceGraph& tm,
                            typename boost::graph_traits<FaceGraph>::vertex_descriptor from,
                            typename boost::graph_traits<FaceGraph>::vertex_descriptor to,
                            const NamedParameters& np = parameters::default_values()) {
  const Geodesic_solver solver = internal::geodesic_solver(tm, np);
  const Geodesic_sources start = internal::geodesic_sources(tm, from);
  return Geodesic_function(solver, solver.distances(internal::geodesic_sources(tm, to), np))
      .shortest_path(solver.location(start.vertices()[0].first));
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_GEODESIC_DISTANCES_H
