// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_INPUT_SHARED_FUNCTION_ON_SURFACE_H
#define CGAL_RESTRICTED_LAPLACIAN_3_INPUT_SHARED_FUNCTION_ON_SURFACE_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/parameters.h>
#include <CGAL/Restricted_laplacian_3/input/shared/point_keys.h>
#include <CGAL/Restricted_laplacian_3/patches/Smooth_geometry.h>
#include <CGAL/Restricted_laplacian_3/patches/smooth_vertex_data.h>
#include <CGAL/Restricted_laplacian_3/surface/Surface_location.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>
#include <CGAL/Restricted_laplacian_3/surface/shared/function_components.h>
#include <CGAL/Restricted_laplacian_3/surface/surface_functions.h>

#include <CGAL/number_utils.h>

#include <Eigen/Core>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

/// \file
/// What callers give as functions, and take as values at vertices: property maps of a source, such
/// as `Mesh_source`. All functions of the package ask here what a map means between the vertices.

namespace CGAL {
namespace Restricted_laplacian_3 {
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

/// how values at the vertices of a surface are interpolated
struct Vertex_interpolation {
  Vertex_data data;
  const Triangulated_surface_3* surface; // must outlive this object
  Smooth_geometry geometry;              // with the creases, if the data are smooth
};

/// what `vertex_data` says; nothing else than linear on a point set, whose faces are points
/// \param surface of the source
template <class Source, class NamedParameters>
Vertex_interpolation vertex_interpolation(const Source& source,
                                          const Triangulated_surface_3& surface,
                                          const NamedParameters& np) {
  Vertex_interpolation result{Vertex_data::linear, &surface, {}};
  read_parameter(np, internal_np::vertex_data, result.data);
  if(surface.is_point_set())
    result.data = Vertex_data::linear;
  if(result.data == Vertex_data::smooth)
    result.geometry = source.smooth_geometry(np);
  return result;
}

/// What a caller gives as a function on the surface, as a function object on `Surface_point`. Such
/// an object, or a number, is taken as it is. A property map is read by `read(value)`: with
/// vertices as keys it is interpolated as is asked for; with halfedges the values at the corners of
/// each triangle are, linearly; with faces it is constant on each.
/// \param source such as `Mesh_source`
/// \param interpolation with the surface of the source
template <class Source, class Function, class Read>
auto function_on_surface(const Source& source, const Function& f,
                         const Vertex_interpolation& interpolation, Read&& read) {
  if constexpr(std::is_invocable_v<const Function&, const Surface_point&> ||
               std::is_arithmetic_v<Function>)
    return f;
  else {
    using T = std::decay_t<decltype(read(
        std::declval<typename boost::property_traits<Function>::value_type>()))>;
    std::vector<T> values;
    const auto add = [&](std::size_t, const auto& key) {
      values.push_back(read(value_at(f, key)));
    };
    if constexpr(Has_corner_keys<Source, Function>::value) {
      source.for_each_corner(*interpolation.surface, add);
      return Corner_vector_field<T>(std::move(values));
    } else if constexpr(Has_face_keys<Source, Function>::value) {
      source.for_each_face(*interpolation.surface, add);
      return Face_function<T>(std::move(values));
    } else {
      source.for_each_vertex(add);
      return interpolation.data == Vertex_data::smooth
                 ? Cubic_surface_function<T>(*interpolation.surface, std::move(values),
                                             interpolation.geometry)
                 : Cubic_surface_function<T>(std::move(values));
    }
  }
}

template <class Source, class Field>
auto vector_field_on_surface(const Source& source, const Field& v,
                             const Vertex_interpolation& interpolation) {
  return function_on_surface(source, v, interpolation, [](const auto& value) {
    return Vector_field_channels<std::decay_t<decltype(value)>>::read(value);
  });
}
template <class Source, class Function>
auto components_on_surface(const Source& source, const Function& f,
                           const Vertex_interpolation& interpolation) {
  return function_on_surface(source, f, interpolation, [](const auto& value) {
    return Function_components<std::decay_t<decltype(value)>>::read(value);
  });
}
template <class Source, class Function>
auto numbers_on_surface(const Source& source, const Function& f,
                        const Vertex_interpolation& interpolation) {
  return function_on_surface(source, f, interpolation,
                             [](const auto& value) { return CGAL::to_double(value); });
}

/// writes the rows of a matrix, one for each vertex, into a property map of numbers or vectors
template <class Source, class PropertyMap>
void put_rows(const Source& source, const Eigen::MatrixXd& values, const PropertyMap& map) {
  using Components = Function_components<typename boost::property_traits<PropertyMap>::value_type>;
  source.for_each_vertex([&](std::size_t i, const auto& v) {
    const Eigen::Matrix<double, Components::number, 1> components =
        values.row(static_cast<Eigen::Index>(i)).transpose();
    put_value_at(map, v, Components::make(components));
  });
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_INPUT_SHARED_FUNCTION_ON_SURFACE_H
