// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_GEODESIC_DISTANCES_H
#define CGAL_RESTRICTED_LAPLACIAN_3_GEODESIC_DISTANCES_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/parameters.h>
#include <CGAL/Restricted_laplacian_3/geodesics/Geodesic_function.h>
#include <CGAL/Restricted_laplacian_3/geodesics/Geodesic_solver.h>
#include <CGAL/Restricted_laplacian_3/input/read_surface.h>
#include <CGAL/Restricted_laplacian_3/input/shared/Surface_source.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>

#include <cstddef>
#include <optional>
#include <type_traits>

namespace CGAL {
namespace Restricted_laplacian_3 {

namespace internal {

/// sources that are given as such, as a vertex, or as a range of vertices
template <class Surface, class Sources>
Geodesic_sources geodesic_sources(const Surface& surface, const Sources& sources) {
  if constexpr(std::is_same_v<Sources, Geodesic_sources>)
    return sources;
  else {
    Geodesic_sources result;
    surface_source(surface).for_each_number(sources, [&](std::size_t i) { result.add_vertex(i); });
    return result;
  }
}

template <class Surface, class NamedParameters>
Geodesic_solver geodesic_solver(const Surface& surface, const NamedParameters& np) {
  std::optional<double> joining_tolerance;
  read_parameter(np, internal_np::joining_tolerance, joining_tolerance);
  return Geodesic_solver(read_surface(surface, np), joining_tolerance);
}

} // namespace internal

/// \ingroup PkgRestrictedLaplacian3Distances
/// Computes distances along a surface, see `Geodesic_solver`, which answers many queries.
/// \tparam Surface a model of `RestrictedSurface_3`
/// \param surface a mesh, a `soup()`, or oriented points
/// \param sources from where distances are measured: `Geodesic_sources`, a vertex, or a range of
/// vertices: descriptors of a mesh; indices of points else
/// \param distances a model of `WritablePropertyMap` with vertices as keys and a number as value,
/// receives the distances; infinite where no source is reached
/// \param np optional named parameters:
/// \cgalNamedParamsBegin
///   \named_of_surface \named_joining_tolerance \named_memory_of_distances
///   \named_maximum_of_distances \named_progress
/// \cgalNamedParamsEnd
/// \return distances again, directions and labels, in the order of the vertices
/// \throws Input_error one of its derived classes names the face, vertex or parameter
template <class Surface, class Sources, class VertexMap,
          class NamedParameters = parameters::Default_named_parameters,
          internal::Require_named_parameters<NamedParameters> = 0,
          internal::Require_property_map<VertexMap> = 0>
Geodesic_distances geodesic_distances(const Surface& surface, const Sources& sources,
                                      VertexMap distances,
                                      const NamedParameters& np = parameters::default_values()) {
  Geodesic_distances result = internal::geodesic_solver(surface, np)
                                  .distances(internal::geodesic_sources(surface, sources), np);
  internal::surface_source(surface).for_each_vertex([&](std::size_t i, const auto& v) {
    internal::put_value_at(distances, v, result.distances[i]);
  });
  return result;
}

/// \ingroup PkgRestrictedLaplacian3Distances
/// Computes the shortest path between two vertices of a surface. For many paths to one vertex, or
/// to other sources, see `Geodesic_function::shortest_path()`.
/// \tparam Surface a model of `RestrictedSurface_3`
/// \param surface a mesh, a `soup()`, or oriented points
/// \param from where the path begins: a vertex descriptor of a mesh; the index of a point else
/// \param to where it ends
/// \param np optional named parameters:
/// \cgalNamedParamsBegin
///   \named_of_surface
///   \named_joining_tolerance \named_memory_of_distances \named_progress
/// \cgalNamedParamsEnd
/// \throws Input_error one of its derived classes names the face, vertex or parameter
/// \throws Location_error if the vertices are not on one component
template <class Surface, class Vertex, class NamedParameters = parameters::Default_named_parameters,
          internal::Require_named_parameters<NamedParameters> = 0>
Geodesic_path shortest_path(const Surface& surface, const Vertex& from, const Vertex& to,
                            const NamedParameters& np = parameters::default_values()) {
  const Geodesic_solver solver = internal::geodesic_solver(surface, np);
  const Geodesic_sources start = internal::geodesic_sources(surface, from);
  return Geodesic_function(solver, solver.distances(internal::geodesic_sources(surface, to), np))
      .shortest_path(solver.location(start.vertices()[0].first));
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_GEODESIC_DISTANCES_H
