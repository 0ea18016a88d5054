// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_SHARED_SURFACE_SOURCE_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_SHARED_SURFACE_SOURCE_H

#include <CGAL/Restricted_laplacian_3/input/read_point_set.h>
#include <CGAL/Restricted_laplacian_3/input/read_surface.h>
#include <CGAL/Restricted_laplacian_3/patches/Smooth_geometry.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>
#include <CGAL/Restricted_laplacian_3/surface/Surface_location.h>

#include <CGAL/boost/graph/helpers.h>

#include <cstddef>
#include <iterator>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// of the time that a function takes on a mesh, that of its space
constexpr double part_of_space = 0.15;

/// a mesh as the source of a surface
template <class FaceGraph> class Mesh_source {
public:
  using Vertex = typename boost::graph_traits<FaceGraph>::vertex_descriptor;
  using Halfedge = typename boost::graph_traits<FaceGraph>::halfedge_descriptor;
  using Face = typename boost::graph_traits<FaceGraph>::face_descriptor;

  explicit Mesh_source(const FaceGraph& tm) : m_mesh(tm) {}

  template <class NamedParameters> Spline_space_3 space(const NamedParameters& np) const {
    return Spline_space_3(m_mesh, np);
  }
  template <class NamedParameters>
  Smooth_geometry smooth_geometry(const NamedParameters& np) const {
    return smooth_geometry_of_mesh(m_mesh, np);
  }
  /// calls `visit(i, v)` for all vertices in the order in which they are numbered
  template <class Visitor> void for_each_vertex(Visitor&& visit) const {
    std::size_t i = 0;
    for(auto v : vertices(m_mesh))
      visit(i++, v);
  }
  /// the same for the faces
  template <class Visitor> void for_each_face(Visitor&& visit) const {
    std::size_t i = 0;
    for(auto f : faces(m_mesh))
      visit(i++, f);
  }
  /// calls `visit(i, h)` for the corners of the faces, each given by the halfedge of the face that
  /// points to it; corner `k` of face `f` has the number `3 * f + k`
  template <class Visitor> void for_each_corner(Visitor&& visit) const {
    for_each_face([&](std::size_t i, const auto& f) {
      auto h = prev(halfedge(f, m_mesh), m_mesh);
      for(std::size_t corner = 3 * i; corner < 3 * i + 3; ++corner, h = next(h, m_mesh))
        visit(corner, h);
    });
  }
  /// calls `visit(i, e, is_at_boundary)` for the sides of the faces; side `k` of face `f`, from
  /// corner `k` to the next one, has the number `3 * f + k`
  template <class Visitor> void for_each_side(Visitor&& visit) const {
    for_each_corner([&](std::size_t i, const auto& h) {
      const auto e = edge(next(h, m_mesh), m_mesh);
      visit(i, e, CGAL::is_border(e, m_mesh));
    });
  }

private:
  const FaceGraph& m_mesh;
};

/// a triangle soup as the source of a surface: keys of property maps are the indices of points
template <class PointRange, class TriangleRange> class Soup_source {
public:
  Soup_source(const PointRange& points, const TriangleRange& triangles)
    : m_points(points), m_triangles(triangles) {}

  template <class NamedParameters> Spline_space_3 space(const NamedParameters& np) const {
    return Spline_space_3(m_points, m_triangles, np);
  }
  template <class NamedParameters>
  Smooth_geometry smooth_geometry(const NamedParameters& np) const {
    return smooth_geometry_of_soup(m_points, np);
  }
  template <class Visitor> void for_each_vertex(Visitor&& visit) const {
    const auto size =
        static_cast<std::size_t>(std::distance(std::begin(m_points), std::end(m_points)));
    for(std::size_t i = 0; i < size; ++i)
      visit(i, i);
  }

private:
  const PointRange& m_points;
  const TriangleRange& m_triangles;
};

/// A range of oriented points as the source of a surface: keys of property maps are the elements of
/// the range or their positions, see `read_point_set()`.
template <class PointRange> class Point_source {
public:
  explicit Point_source(const PointRange& points) : m_points(points) {}

  template <class NamedParameters> Spline_space_3 space(const NamedParameters& np) const {
    return Spline_space_3(m_points, np);
  }
  template <class NamedParameters> Smooth_geometry smooth_geometry(const NamedParameters&) const {
    return {};
  }
  template <class Visitor> void for_each_vertex(Visitor&& visit) const {
    for_each_point_key(m_points, [&](const auto& key) { visit(key.position, key); });
  }

private:
  const PointRange& m_points;
};

/// a mesh, or a range of oriented points, as the source of a surface
template <class Surface> auto mesh_or_point_source(const Surface& surface) {
  if constexpr(is_range_v<Surface>)
    return Point_source<Surface>(surface);
  else
    return Mesh_source<Surface>(surface);
}

} // namespace internal

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_SHARED_SURFACE_SOURCE_H
