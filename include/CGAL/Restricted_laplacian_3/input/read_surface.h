// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_INPUT_READ_SURFACE_H
#define CGAL_RESTRICTED_LAPLACIAN_3_INPUT_READ_SURFACE_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parameters.h>
#include <CGAL/Restricted_laplacian_3/patches/Smooth_geometry.h>
#include <CGAL/Restricted_laplacian_3/patches/curved_surface.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>
#include <CGAL/Restricted_laplacian_3/surface/shared/coordinates.h>

#include <CGAL/boost/graph/named_params_helper.h>

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

namespace internal {

/// the property map of the points of a mesh
template <class FaceGraph, class NamedParameters>
auto vertex_points_of(const FaceGraph& tm, const NamedParameters& np) {
  return parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                      get_const_property_map(CGAL::vertex_point, tm));
}

/// the geometry that named parameters describe, with the property maps of a mesh
template <class FaceGraph, class NamedParameters>
Smooth_geometry smooth_geometry_of_mesh(const FaceGraph& tm, const NamedParameters& np) {
  using Point_map = decltype(vertex_points_of(tm, np));
  Smooth_geometry geometry =
      smooth_geometry_of<typename boost::property_traits<Point_map>::value_type>(np);
  if constexpr(is_given_v<NamedParameters, internal_np::vertex_normal_map_t>) {
    const auto normal_map = parameters::get_parameter(np, internal_np::vertex_normal_map);
    for(auto v : vertices(tm))
      geometry.vertex_normals.push_back(with_coordinates_of<Vector_3>(get(normal_map, v)));
  }
  if constexpr(is_given_v<NamedParameters, internal_np::edge_is_feature_map_t>) {
    const auto feature_map = parameters::get_parameter(np, internal_np::edge_is_feature_map);
    auto index_map = get(CGAL::dynamic_vertex_property_t<std::uint32_t>(), tm);
    std::uint32_t number = 0;
    for(auto v : vertices(tm))
      put(index_map, v, number++);
    for(auto e : edges(tm))
      if(get(feature_map, e))
        geometry.creases.push_back({get(index_map, source(e, tm)), get(index_map, target(e, tm))});
  }
  return geometry;
}

/// the same for a triangle soup, whose property maps have indices of points as keys
template <class PointRange, class NamedParameters>
Smooth_geometry smooth_geometry_of_soup(const PointRange& points, const NamedParameters& np) {
  using Point = std::decay_t<decltype(*std::begin(points))>;
  Smooth_geometry geometry = smooth_geometry_of<Point>(np);
  if constexpr(is_given_v<NamedParameters, internal_np::vertex_normal_map_t>) {
    const auto normal_map = parameters::get_parameter(np, internal_np::vertex_normal_map);
    const auto size = static_cast<std::size_t>(std::distance(std::begin(points), std::end(points)));
    for(std::size_t i = 0; i < size; ++i)
      geometry.vertex_normals.push_back(with_coordinates_of<Vector_3>(get(normal_map, i)));
  }
  return geometry;
}

} // namespace internal

/// \ingroup PkgRestrictedLaplacian3Dev
/// Reads a mesh. Vertices and faces are numbered in the order of `vertices(tm)` and `faces(tm)`.
///
/// \tparam FaceGraph a model of `FaceListGraph`
/// \param tm a mesh of triangles
/// \param np optional named parameters:
/// \cgalNamedParamsBegin
///   \named_of_mesh
///   \named_of_geometry
/// \cgalNamedParamsEnd
/// \throws Invalid_face_error if a face is not a triangle, and what the constructor of
/// `Triangulated_surface_3` and `curved_surface()` throw
template <class FaceGraph, class NamedParameters = parameters::Default_named_parameters,
          internal::Require_named_parameters<NamedParameters> = 0>
Triangulated_surface_3 read_surface(const FaceGraph& tm,
                                    const NamedParameters& np = parameters::default_values()) {
  using Vertex = typename boost::graph_traits<FaceGraph>::vertex_descriptor;
  const auto point_map = internal::vertex_points_of(tm, np);
  const auto traits = internal::geom_traits_of(np);
  auto index_map = get(CGAL::dynamic_vertex_property_t<std::uint32_t>(), tm);

  std::vector<Point_3> points;
  points.reserve(num_vertices(tm));
  for(Vertex v : vertices(tm)) {
    put(index_map, v, static_cast<std::uint32_t>(points.size()));
    points.push_back(internal::with_coordinates_of<Point_3>(get(point_map, v), traits));
  }

  std::vector<Triangulated_surface_3::Triangle> triangles;
  triangles.reserve(num_faces(tm));
  for(auto f : faces(tm)) {
    const auto h = halfedge(f, tm);
    if(next(next(next(h, tm), tm), tm) != h || next(h, tm) == h || next(next(h, tm), tm) == h)
      throw Invalid_face_error(triangles.size(), "is not a triangle");
    triangles.push_back({get(index_map, source(h, tm)), get(index_map, target(h, tm)),
                         get(index_map, target(next(h, tm), tm))});
  }
  Triangulated_surface_3 surface(std::move(points), std::move(triangles));
  if(!internal::asks_for_smooth_geometry(np))
    return surface;
  return curved_surface(std::move(surface), internal::smooth_geometry_of_mesh(tm, np));
}

/// \ingroup PkgRestrictedLaplacian3Dev
/// Reads a triangle soup: a surface that need not be a manifold.
/// \param points a range of 3D points
/// \param triangles a range of ranges of three indices into `points`, each of any integer type
/// \param np `geom_traits`, `geometry`, `crease_angle`: as above; `vertex_normal_map`: its
/// keys are indices of points
/// \throws Invalid_face_error if a face is not a triangle or names a point that does not exist, and
/// what the constructor of `Triangulated_surface_3` throws
template <class PointRange, class TriangleRange,
          class NamedParameters = parameters::Default_named_parameters,
          internal::Require_no_named_parameters<TriangleRange> = 0>
Triangulated_surface_3 read_surface(const PointRange& points, const TriangleRange& triangles,
                                    const NamedParameters& np = parameters::default_values()) {
  const auto traits = internal::geom_traits_of(np);
  std::vector<Point_3> own_points;
  for(const auto& p : points)
    own_points.push_back(internal::with_coordinates_of<Point_3>(p, traits));
  std::vector<Triangulated_surface_3::Triangle> own_triangles;
  for(const auto& triangle : triangles) {
    if(std::distance(std::begin(triangle), std::end(triangle)) != 3)
      throw Invalid_face_error(own_triangles.size(), "is not a triangle");
    Triangulated_surface_3::Triangle own;
    auto corner = own.begin();
    for(const auto index : triangle) {
      const auto i = static_cast<long long>(index);
      if(i < 0 || i >= static_cast<long long>(own_points.size()))
        throw Invalid_face_error(own_triangles.size(), "names a vertex that does not exist");
      *corner++ = static_cast<std::uint32_t>(i);
    }
    own_triangles.push_back(own);
  }
  Triangulated_surface_3 surface(std::move(own_points), std::move(own_triangles));
  if(!internal::asks_for_smooth_geometry(np))
    return surface;
  return curved_surface(std::move(surface), internal::smooth_geometry_of_soup(points, np));
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_INPUT_READ_SURFACE_H
