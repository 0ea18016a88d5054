// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_VECTOR_FIELDS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_VECTOR_FIELDS_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/surface/Surface_location.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>
#include <CGAL/Restricted_laplacian_3/surface/shared/function_components.h>

#include <CGAL/assertions.h>
#include <CGAL/number_utils.h>

#include <Eigen/Core>

#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Gradients
/// A function or vector field that is constant on each triangle, as a function object on
/// `Surface_point`. Integrals of it are exact up to rounding, and take fewer nodes than others.
/// \tparam T a number, or a vector type
///
/// \cgalModels `SurfaceFunction_3`
template <class T> class Face_function {
public:
  /// \param values for each face, in the order of `faces(tm)`
  explicit Face_function(std::vector<T> values) : m_values(std::move(values)) {}

  /// the value of the face of a location
  /// \pre there is a value for that face
  const T& operator()(const Surface_point& p) const {
    CGAL_precondition(p.face < m_values.size());
    return m_values[p.face];
  }
  /// constant on each triangle
  int degree() const { return 0; }
  /// the values, one for each face
  const std::vector<T>& values() const { return m_values; }

private:
  std::vector<T> m_values;
};

/// \ingroup PkgRestrictedLaplacian3Gradients
/// A vector field that is linear in each triangle, and may jump from one to the next, as a function
/// object on `Surface_point`: it is given by its values at the corners of the triangles.
/// \tparam T a vector type, such as `Vector_3` or `Eigen::Matrix<double, 3, K>`
///
/// \cgalModels `SurfaceFunction_3`
template <class T> class Corner_vector_field {
public:
  /// \param values three for each face, in the order of `faces(tm)`, at its vertices `source(h)`,
  /// `target(h)`, `target(next(h))`, where `h = halfedge(f, tm)`, or at those that a triangle of a
  /// soup names
  explicit Corner_vector_field(std::vector<T> values) : m_values(std::move(values)) {}

  /// the value at a location: the mean of those at the three corners with the barycentric
  /// coordinates as weights
  /// \pre there are values for that face
  T operator()(const Surface_point& p) const {
    CGAL_precondition(3 * p.face + 3 <= m_values.size());
    const T* const corners = m_values.data() + 3 * p.face;
    return corners[0] * p.barycentric[0] + corners[1] * p.barycentric[1] +
           corners[2] * p.barycentric[2];
  }
  /// linear in each triangle
  int degree() const { return 1; }
  /// the values, three for each face
  const std::vector<T>& values() const { return m_values; }

private:
  std::vector<T> m_values;
};

namespace internal {

/// whether a property map of a source, such as `Mesh_source`, has these descriptors as keys
template <class Source, class Map, class = void> struct Has_corner_keys : std::false_type {};
template <class Source, class Map>
struct Has_corner_keys<Source, Map, std::void_t<typename Source::Halfedge>>
  : std::bool_constant<
        !std::is_same_v<typename Source::Halfedge, typename Source::Vertex> &&
        std::is_same_v<typename boost::property_traits<Map>::key_type, typename Source::Halfedge>> {
};
template <class Source, class Map, class = void> struct Has_face_keys : std::false_type {};
template <class Source, class Map>
struct Has_face_keys<Source, Map, std::void_t<typename Source::Face>>
  : std::bool_constant<
        !std::is_same_v<typename Source::Face, typename Source::Vertex> &&
        std::is_same_v<typename boost::property_traits<Map>::key_type, typename Source::Face>> {};

/// What a caller gives as a function on the surface, as a function object on `Surface_point`. Such
/// an object is taken as it is. A property map is read by `read(value)`: with vertices as keys it
/// is interpolated linearly in each triangle; with halfedges so are the values at the corners of
/// each triangle; with faces it is constant on each.
/// \param source such as `Mesh_source`
template <class Source, class Function, class Read>
auto function_on_surface(const Source& source, const Function& f, Read&& read) {
  if constexpr(std::is_invocable_v<const Function&, const Surface_point&>)
    return f;
  else {
    using T = std::decay_t<decltype(read(
        std::declval<typename boost::property_traits<Function>::value_type>()))>;
    std::vector<T> values;
    const auto add = [&](std::size_t, const auto& key) {
      values.push_back(read(value_at(f, key)));
    };
    if constexpr(Has_corner_keys<Source, Function>::value) {
      source.for_each_corner(add);
      return Corner_vector_field<T>(std::move(values));
    } else if constexpr(Has_face_keys<Source, Function>::value) {
      source.for_each_face(add);
      return Face_function<T>(std::move(values));
    } else {
      source.for_each_vertex(add);
      return Linear_surface_function<T>(std::move(values));
    }
  }
}

template <class Source, class Field>
auto vector_field_on_surface(const Source& source, const Field& v) {
  return function_on_surface(source, v, [](const auto& value) {
    return Vector_field_channels<std::decay_t<decltype(value)>>::read(value);
  });
}
template <class Source, class Function>
auto components_on_surface(const Source& source, const Function& f) {
  return function_on_surface(source, f, [](const auto& value) {
    return Function_components<std::decay_t<decltype(value)>>::read(value);
  });
}
template <class Source, class Function>
auto numbers_on_surface(const Source& source, const Function& f) {
  return function_on_surface(source, f, [](const auto& value) { return CGAL::to_double(value); });
}

/// the gradients of the three functions that are linear in a triangle, and 1 at one corner
inline Eigen::Matrix3d hat_gradients(const Triangulated_surface_3& surface, std::size_t face) {
  Eigen::Matrix3d result;
  for(int i = 0; i < 3; ++i) {
    const Vector_3 side = surface.point(face, (i + 2) % 3) - surface.point(face, (i + 1) % 3);
    const Vector_3 gradient =
        CGAL::cross_product(surface.normal(face), side) / (2 * surface.area(face));
    result.col(i) << gradient.x(), gradient.y(), gradient.z();
  }
  return result;
}

/// \param components_of vertex number &rarr; column vector of `K` components
template <int K, class ComponentsOf>
Face_function<Eigen::Matrix<double, 3, K>>
gradients_of_linear_functions(const Triangulated_surface_3& surface, ComponentsOf&& components_of) {
  surface.require_triangles("the gradient of a function that is linear in each triangle");
  std::vector<Eigen::Matrix<double, 3, K>> gradients(surface.number_of_faces(),
                                                     Eigen::Matrix<double, 3, K>::Zero());
  for(std::size_t f = 0; f < gradients.size(); ++f) {
    if(surface.is_degenerate(f))
      continue;
    const Eigen::Matrix3d of_hats = hat_gradients(surface, f);
    const auto& v = surface.triangle(f);
    // Differences, because a large constant would leave its rounding error.
    for(int i = 1; i < 3; ++i)
      gradients[f] +=
          of_hats.col(i) * (components_of(v[i]) - components_of(v[0])).eval().transpose();
  }
  return Face_function<Eigen::Matrix<double, 3, K>>(std::move(gradients));
}

/// by the values of a property map, in the order of the vertices
template <class Values>
auto gradients_of_values(const Triangulated_surface_3& surface, const Values& values) {
  using Components = Function_components<typename Values::value_type>;
  return gradients_of_linear_functions<Components::number>(
      surface, [&](std::size_t v) { return Components::read(values[v]); });
}

} // namespace internal

/// \ingroup PkgRestrictedLaplacian3Gradients
/// The gradients of the functions that are linear in each triangle and take the values of a vertex
/// property map: a vector field that is constant on each triangle, and tangent to it, with the
/// gradient of component \f$k\f$ as its channel \f$k\f$, in units of the values over length; 0 on
/// degenerate faces. Linear in the number of faces.
/// \tparam FaceGraph a model of `FaceListGraph` and `VertexListGraph`, all of whose faces are
/// triangles
/// \param tm the mesh whose vertices the map knows
/// \param map a model of `ReadablePropertyMap` with the vertex descriptor as key; its values are
/// numbers, `std::array`s of numbers, vectors of Eigen of a fixed size, or 3D vectors of \cgal
/// \param np optional named parameters:
/// \cgalNamedParamsBegin
///   \named_of_mesh
/// \cgalNamedParamsEnd
/// \return a `Face_function` with values `Eigen::Matrix<double, 3, K>`
/// \throws Input_error one of its derived classes names the face or vertex that cannot be used
template <class FaceGraph, class VertexMap,
          class NamedParameters = parameters::Default_named_parameters,
          internal::Require_named_parameters<NamedParameters> = 0>
auto vertex_gradients(const FaceGraph& tm, VertexMap map,
                      const NamedParameters& np = parameters::default_values()) {
  std::vector<std::decay_t<typename boost::property_traits<VertexMap>::value_type>> values;
  values.reserve(num_vertices(tm));
  for(auto v : vertices(tm))
    values.push_back(get(map, v));
  return internal::gradients_of_values(read_surface(tm, np), values);
}

/// \ingroup PkgRestrictedLaplacian3Gradients
/// The gradients of the functions that are linear in each triangle of a soup, with the values of a
/// property map, see the overload for meshes.
/// \param points a range of 3D points
/// \param triangles a range of ranges of three indices into `points`
/// \param map a model of `ReadablePropertyMap` with the index of a point as key, a `std::size_t`
/// \param np `geom_traits`, as in `read_surface()`
template <class PointRange, class TriangleRange, class IndexMap,
          class NamedParameters = parameters::Default_named_parameters,
          internal::Require_no_named_parameters<IndexMap> = 0>
auto vertex_gradients(const PointRange& points, const TriangleRange& triangles, IndexMap map,
                      const NamedParameters& np = parameters::default_values()) {
  const Triangulated_surface_3 surface = read_surface(points, triangles, np);
  std::vector<std::decay_t<typename boost::property_traits<IndexMap>::value_type>> values;
  for(std::size_t i = 0; i < surface.number_of_vertices(); ++i)
    values.push_back(get(map, i));
  return internal::gradients_of_values(surface, values);
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_VECTOR_FIELDS_H
