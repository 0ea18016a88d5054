// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_INPUT_SHARED_SURFACE_SOURCE_H
#define CGAL_RESTRICTED_LAPLACIAN_3_INPUT_SHARED_SURFACE_SOURCE_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parameters.h>
#include <CGAL/Restricted_laplacian_3/input/point_areas.h>
#include <CGAL/Restricted_laplacian_3/input/shared/point_keys.h>
#include <CGAL/Restricted_laplacian_3/input/soup.h>
#include <CGAL/Restricted_laplacian_3/patches/Smooth_geometry.h>
#include <CGAL/Restricted_laplacian_3/patches/curved_surface.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>
#include <CGAL/Restricted_laplacian_3/surface/shared/Surface_builder.h>
#include <CGAL/Restricted_laplacian_3/surface/shared/coordinates.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <type_traits>
#include <utility>
#include <vector>

/// \file
/// The models of `RestrictedSurface_3`, seen alike: how each is read, and what the keys of property
/// maps mean on it.

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// the geometry that named parameters describe, but for creases, whose keys are edges
template <class Point, class Source, class NamedParameters>
Smooth_geometry geometry_of_vertices(const Source& source, const NamedParameters& np) {
  Smooth_geometry geometry = smooth_geometry_of<Point>(np);
  if constexpr(is_given_v<NamedParameters, internal_np::vertex_normal_map_t>) {
    const auto normal_map = parameters::get_parameter(np, internal_np::vertex_normal_map);
    source.for_each_vertex([&](std::size_t, const auto& v) {
      geometry.vertex_normals.push_back(with_coordinates_of<Vector_3>(value_at(normal_map, v)));
    });
  }
  return geometry;
}

/// a mesh, whose vertices, faces, edges and halfedges are keys
template <class FaceGraph> class Mesh_source {
public:
  using Vertex = typename boost::graph_traits<FaceGraph>::vertex_descriptor;
  using Halfedge = typename boost::graph_traits<FaceGraph>::halfedge_descriptor;
  using Face = typename boost::graph_traits<FaceGraph>::face_descriptor;

  explicit Mesh_source(const FaceGraph& tm) : m_mesh(tm) {}

  template <class NamedParameters> Triangulated_surface_3 read(const NamedParameters& np) const {
    const auto point_map = points(np);
    const auto traits = geom_traits_of(np);
    auto index_map = get(CGAL::dynamic_vertex_property_t<std::uint32_t>(), m_mesh);
    Surface_builder builder;
    builder.reserve(num_vertices(m_mesh), num_faces(m_mesh));
    for_each_vertex([&](std::size_t i, Vertex v) {
      put(index_map, v, static_cast<std::uint32_t>(i));
      builder.add_point(with_coordinates_of<Point_3>(get(point_map, v), traits));
    });
    std::vector<std::uint32_t> corners;
    for(Face f : faces(m_mesh)) {
      corners.clear();
      const Halfedge first = halfedge(f, m_mesh);
      Halfedge h = first;
      do {
        corners.push_back(get(index_map, source(h, m_mesh)));
        h = next(h, m_mesh);
      } while(h != first);
      builder.add_polygon(corners);
    }
    return std::move(builder).surface();
  }
  template <class NamedParameters>
  Smooth_geometry smooth_geometry(const NamedParameters& np) const {
    using Point_map = decltype(points(np));
    auto geometry =
        geometry_of_vertices<typename boost::property_traits<Point_map>::value_type>(*this, np);
    if constexpr(is_given_v<NamedParameters, internal_np::edge_is_feature_map_t>) {
      const auto feature_map = parameters::get_parameter(np, internal_np::edge_is_feature_map);
      const auto index_map = vertex_numbers();
      for(auto e : edges(m_mesh))
        if(get(feature_map, e))
          geometry.creases.push_back(
              {get(index_map, source(e, m_mesh)), get(index_map, target(e, m_mesh))});
    }
    return geometry;
  }

  /// calls `visit(i, v)` for all vertices in the order in which they are numbered
  template <class Visitor> void for_each_vertex(Visitor&& visit) const {
    std::size_t i = 0;
    for(Vertex v : vertices(m_mesh))
      visit(i++, v);
  }
  /// calls `visit(number)` for vertices, given as a range or as a single one
  template <class Keys, class Visitor>
  void for_each_number(const Keys& keys, Visitor&& visit) const {
    const auto index_map = vertex_numbers();
    if constexpr(std::is_convertible_v<Keys, Vertex>)
      visit(get(index_map, Vertex(keys)));
    else
      for(const auto& v : keys)
        visit(get(index_map, Vertex(v)));
  }
  /// calls `visit(i, f)` for the faces of the surface that was read, in their order, with the face
  /// of the mesh that each is a part of
  template <class Visitor>
  void for_each_face(const Triangulated_surface_3& surface, Visitor&& visit) const {
    std::size_t i = 0, polygon = 0;
    for(Face f : faces(m_mesh)) {
      for(; i < surface.number_of_faces() && surface.polygon(i) == polygon; ++i)
        visit(i, f);
      ++polygon;
    }
  }
  /// calls `visit(i, h)` for the corners of these faces, each given by the halfedge of the face of
  /// the mesh that points to it; corner `k` of face `f` has the number `3 * f + k`
  template <class Visitor>
  void for_each_corner(const Triangulated_surface_3& surface, Visitor&& visit) const {
    std::vector<Halfedge> corners;
    std::size_t last = surface.number_of_faces();
    for_each_face(surface, [&](std::size_t i, Face f) {
      if(surface.polygon(i) != last) {
        last = surface.polygon(i);
        corners.clear();
        for(Halfedge h = prev(halfedge(f, m_mesh), m_mesh); corners.empty() || h != corners[0];
            h = next(h, m_mesh))
          corners.push_back(h);
      }
      for(int k = 0; k < 3; ++k)
        visit(3 * i + static_cast<std::size_t>(k), corners[surface.corner_of_polygon(i, k)]);
    });
  }
  /// calls `visit(i, e, is_at_boundary)` for the sides of these faces that are sides of a face of
  /// the mesh; side `k` of face `f`, from corner `k` to the next one, has the number `3 * f + k`
  template <class Visitor>
  void for_each_side(const Triangulated_surface_3& surface, Visitor&& visit) const {
    std::array<Halfedge, 3> corners;
    for_each_corner(surface, [&](std::size_t i, Halfedge h) {
      corners[i % 3] = h;
      if(i % 3 == 2)
        for(std::size_t k = 0; k < 3; ++k) {
          const Halfedge side = corners[(k + 1) % 3];
          if(source(side, m_mesh) == target(corners[k], m_mesh))
            visit(i - 2 + k, edge(side, m_mesh), CGAL::is_border(edge(side, m_mesh), m_mesh));
        }
    });
  }

private:
  template <class NamedParameters> auto points(const NamedParameters& np) const {
    return parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                        get_const_property_map(CGAL::vertex_point, m_mesh));
  }
  auto vertex_numbers() const {
    auto index_map = get(CGAL::dynamic_vertex_property_t<std::uint32_t>(), m_mesh);
    for_each_vertex(
        [&](std::size_t i, Vertex v) { put(index_map, v, static_cast<std::uint32_t>(i)); });
    return index_map;
  }

  const FaceGraph& m_mesh;
};

/// calls `visit(number)` for positions, given as a range or as a single one
template <class Keys, class Visitor> void for_each_position(const Keys& keys, Visitor&& visit) {
  if constexpr(std::is_convertible_v<Keys, std::size_t>)
    visit(static_cast<std::size_t>(keys));
  else
    for(const auto& i : keys)
      visit(static_cast<std::size_t>(i));
}

/// a polygon soup, the indices of whose points are keys
template <class PointRange, class PolygonRange> class Soup_source {
public:
  explicit Soup_source(const Polygon_soup<PointRange, PolygonRange>& soup) : m_soup(soup) {}

  template <class NamedParameters> Triangulated_surface_3 read(const NamedParameters& np) const {
    const auto traits = geom_traits_of(np);
    Surface_builder builder;
    for(const auto& p : m_soup.points())
      builder.add_point(with_coordinates_of<Point_3>(p, traits));
    std::vector<std::uint32_t> corners;
    for(const auto& polygon : m_soup.polygons()) {
      corners.clear();
      for(const auto index : polygon) {
        const auto i = static_cast<long long>(index);
        if(i < 0 || i > static_cast<long long>(Triangulated_surface_3::maximum_number_of_faces))
          throw Invalid_face_error(builder.number_of_polygons(),
                                   "names a vertex that does not exist");
        corners.push_back(static_cast<std::uint32_t>(i));
      }
      builder.add_polygon(corners);
    }
    return std::move(builder).surface();
  }
  template <class NamedParameters>
  Smooth_geometry smooth_geometry(const NamedParameters& np) const {
    return geometry_of_vertices<Range_value<std::remove_reference_t<PointRange>>>(*this, np);
  }
  template <class Visitor> void for_each_vertex(Visitor&& visit) const {
    const std::size_t size = size_of_range(m_soup.points());
    for(std::size_t i = 0; i < size; ++i)
      visit(i, i);
  }
  template <class Keys, class Visitor>
  void for_each_number(const Keys& keys, Visitor&& visit) const {
    for_each_position(keys, visit);
  }

private:
  const Polygon_soup<PointRange, PolygonRange>& m_soup;
};

/// a range of oriented points; keys are its elements, or their positions
template <class PointRange> class Point_source {
public:
  explicit Point_source(const PointRange& points) : m_points(points) {}

  template <class NamedParameters> Triangulated_surface_3 read(const NamedParameters& np) const {
    const auto point_map = point_map_of(m_points, np);
    const auto normal_map = normal_map_of(m_points, np);
    constexpr bool has_areas = is_given_v<NamedParameters, internal_np::area_map_t>;
    const auto area_map = parameters::get_parameter(np, internal_np::area_map);
    const auto traits = geom_traits_of(np);
    std::vector<Point_3> points;
    std::vector<Vector_3> normals;
    std::vector<double> areas;
    for_each_vertex([&](std::size_t, const auto& key) {
      points.push_back(with_coordinates_of<Point_3>(value_at(point_map, key), traits));
      normals.push_back(with_coordinates_of<Vector_3>(value_at(normal_map, key), traits));
      if constexpr(has_areas)
        areas.push_back(CGAL::to_double(value_at(area_map, key)));
    });
    if(!has_areas) {
      int neighbors = default_number_of_neighbors;
      read_parameter(np, internal_np::neighbors, neighbors);
      areas = estimate_point_areas(points, normals, neighbors, is_parallel(np));
    }
    return Triangulated_surface_3(std::move(points), std::move(normals), std::move(areas));
  }
  /// none
  template <class NamedParameters> Smooth_geometry smooth_geometry(const NamedParameters&) const {
    return {};
  }
  template <class Visitor> void for_each_vertex(Visitor&& visit) const {
    for_each_point_key(m_points, [&](const auto& key) { visit(key.position, key); });
  }
  template <class Keys, class Visitor>
  void for_each_number(const Keys& keys, Visitor&& visit) const {
    for_each_position(keys, visit);
  }

private:
  const PointRange& m_points;
};

/// a surface that was read: the numbers of its vertices are keys
class Triangulated_source {
public:
  explicit Triangulated_source(const Triangulated_surface_3& surface) : m_surface(surface) {}

  template <class NamedParameters> Triangulated_surface_3 read(const NamedParameters&) const {
    return m_surface;
  }
  template <class NamedParameters>
  Smooth_geometry smooth_geometry(const NamedParameters& np) const {
    return geometry_of_vertices<Point_3>(*this, np);
  }
  template <class Visitor> void for_each_vertex(Visitor&& visit) const {
    for(std::size_t i = 0; i < m_surface.number_of_vertices(); ++i)
      visit(i, i);
  }
  template <class Keys, class Visitor>
  void for_each_number(const Keys& keys, Visitor&& visit) const {
    for_each_position(keys, visit);
  }

private:
  const Triangulated_surface_3& m_surface;
};

/// a surface of the caller as a source
template <class Surface> auto surface_source(const Surface& surface) {
  if constexpr(is_range_v<Surface>)
    return Point_source<Surface>(surface);
  else
    return Mesh_source<Surface>(surface);
}
template <class PointRange, class PolygonRange>
auto surface_source(const Polygon_soup<PointRange, PolygonRange>& soup) {
  return Soup_source<PointRange, PolygonRange>(soup);
}
inline Triangulated_source surface_source(const Triangulated_surface_3& surface) {
  return Triangulated_source(surface);
}

/// what a source stands for; a smooth surface, if it is asked for
template <class Source, class NamedParameters>
Triangulated_surface_3 read_source(const Source& source, const NamedParameters& np) {
  Triangulated_surface_3 surface = source.read(np);
  if(!asks_for_smooth_geometry(np))
    return surface;
  surface.require_triangles("a smooth geometry");
  return curved_surface(std::move(surface), source.smooth_geometry(np));
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_INPUT_SHARED_SURFACE_SOURCE_H
