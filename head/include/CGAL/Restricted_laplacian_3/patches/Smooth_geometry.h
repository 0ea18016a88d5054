// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PATCHES_SMOOTH_GEOMETRY_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PATCHES_SMOOTH_GEOMETRY_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/parameters.h>
#include <CGAL/Restricted_laplacian_3/surface/Surface_location.h>
#include <CGAL/Restricted_laplacian_3/surface/shared/coordinates.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Options
/// Which surface a mesh stands for: its triangles, or the smooth surface through its vertices, see
/// `curved_surface()`.
enum class Surface_geometry { flat, smooth };

/// \ingroup PkgRestrictedLaplacian3Dev
/// What a smooth surface through the vertices of a triangulated one is made from.
struct Smooth_geometry {
  /// An edge is a crease if the normals of its two faces differ by more than this angle, in
  /// degrees.
  double crease_angle = 40;
  /// Normals at the vertices, of any length; an empty vector, and vectors that are zero or not
  /// finite, are estimated. One that points to the other side of the faces is turned around. Not
  /// used at vertices on creases, where there are several normals.
  std::vector<Vector_3> vertex_normals;
  /// pairs of vertices whose edges are creases, whatever the angle
  std::vector<std::array<std::uint32_t, 2>> creases;
  /// A function that takes points near the surface to as many on it. If there is one, patches
  /// interpolate it between the vertices, and the members above have no effect. It is called twice:
  /// for the vertices, and for all other points.
  std::function<std::vector<Point_3>(const std::vector<Point_3>&)> projection;

  /// Makes `projection` of a function that takes one point to another.
  template <class Function> void set_projection(Function function) {
    projection = [function](std::vector<Point_3> points) {
      for(Point_3& p : points)
        p = function(p);
      return points;
    };
  }
};

namespace internal {

template <class T> struct Is_pair : std::false_type {};
template <class A, class B> struct Is_pair<std::pair<A, B>> : std::true_type {};

/// the point that a projection returns, alone or with a normal
template <class T> Point_3 projected_point(const T& projected) {
  if constexpr(Is_pair<T>::value)
    return with_coordinates_of<Point_3>(projected.first);
  else
    return with_coordinates_of<Point_3>(projected);
}

/// A projection may take the package's points, or else those of the mesh.
template <class MeshPoint, class Projection>
Point_3 project(const Projection& projection, const Point_3& p) {
  if constexpr(std::is_invocable_v<const Projection&, const Point_3&>)
    return projected_point(projection(p));
  else
    return projected_point(projection(with_coordinates_of<MeshPoint>(p)));
}

/// whether `geometry` asks for another surface than the triangles
template <class NamedParameters> bool asks_for_smooth_geometry(const NamedParameters& np) {
  if constexpr(is_given_v<NamedParameters, internal_np::geometry_t>) {
    const auto value = parameters::get_parameter(np, internal_np::geometry);
    if constexpr(std::is_same_v<std::decay_t<decltype(value)>, Surface_geometry>)
      return value == Surface_geometry::smooth;
    else
      return true;
  }
  return false;
}

/// The geometry that `geometry` and `crease_angle` describe, without the parameters whose
/// values are property maps.
/// \tparam MeshPoint the points of the mesh
template <class MeshPoint, class NamedParameters>
Smooth_geometry smooth_geometry_of(const NamedParameters& np) {
  Smooth_geometry result;
  read_parameter(np, internal_np::crease_angle, result.crease_angle);
  if constexpr(is_given_v<NamedParameters, internal_np::geometry_t>) {
    const auto value = parameters::get_parameter(np, internal_np::geometry);
    if constexpr(!std::is_same_v<std::decay_t<decltype(value)>, Surface_geometry>)
      result.set_projection([value](const Point_3& p) { return project<MeshPoint>(value, p); });
  }
  return result;
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_PATCHES_SMOOTH_GEOMETRY_H
