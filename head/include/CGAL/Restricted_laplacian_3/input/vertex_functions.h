// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_INPUT_VERTEX_FUNCTIONS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_INPUT_VERTEX_FUNCTIONS_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/input/read_surface.h>
#include <CGAL/Restricted_laplacian_3/surface/Surface_location.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>
#include <CGAL/Restricted_laplacian_3/surface/shared/function_components.h>
#include <CGAL/Restricted_laplacian_3/surface/surface_functions.h>

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
namespace internal {

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

/// what values of a property map become
template <class Value> struct Vertex_value {
  using Components = Function_components<Value>;
  using type = std::conditional_t<Components::number == 1, double, typename Components::Vector>;
  static type read(const Value& value) {
    if constexpr(Components::number == 1)
      return Components::read(value)[0];
    else
      return Components::read(value);
  }
};

} // namespace internal

/// \ingroup PkgRestrictedLaplacian3Functions
/// The function that is linear in each triangle and takes the values of a property map at the
/// vertices, as a function object on `Surface_point`. The values are copied.
/// \tparam Surface a model of `RestrictedSurface_3`
/// \param surface a mesh, a `soup()`, oriented points, or a `Triangulated_surface_3`
/// \param map a model of `ReadablePropertyMap` with vertices as keys; its values are numbers,
/// `std::array`s of numbers, vectors of Eigen of a fixed size, or 3D vectors of \cgal
/// \return a `Linear_surface_function` with values `double` or, for several components,
/// `Eigen::Matrix<double, K, 1>`
template <class Surface, class VertexMap>
auto vertex_function(const Surface& surface, VertexMap map) {
  using Value =
      internal::Vertex_value<std::decay_t<typename boost::property_traits<VertexMap>::value_type>>;
  std::vector<typename Value::type> values;
  internal::surface_source(surface).for_each_vertex([&](std::size_t, const auto& v) {
    values.push_back(Value::read(internal::value_at(map, v)));
  });
  return Linear_surface_function<typename Value::type>(std::move(values));
}

/// \ingroup PkgRestrictedLaplacian3Gradients
/// The gradients of the functions that are linear in each triangle and take the values of a vertex
/// property map: a vector field that is constant on each triangle, and tangent to it, with the
/// gradient of component \f$k\f$ as its channel \f$k\f$, in units of the values over length; 0 on
/// degenerate faces. Linear in the number of faces.
/// \tparam Surface a model of `RestrictedSurface_3`; not points, which have no triangles
/// \param surface the mesh or `soup()` whose vertices the map knows
/// \param map a model of `ReadablePropertyMap` with vertices as keys; its values are numbers,
/// `std::array`s of numbers, vectors of Eigen of a fixed size, or 3D vectors of \cgal
/// \param np optional named parameters:
/// \cgalNamedParamsBegin
///   \named_of_surface
/// \cgalNamedParamsEnd
/// \return a `Face_function` with values `Eigen::Matrix<double, 3, K>`
/// \throws Input_error one of its derived classes names the face or vertex that cannot be used
template <class Surface, class VertexMap,
          class NamedParameters = parameters::Default_named_parameters,
          internal::Require_named_parameters<NamedParameters> = 0>
auto vertex_gradients(const Surface& surface, VertexMap map,
                      const NamedParameters& np = parameters::default_values()) {
  std::vector<std::decay_t<typename boost::property_traits<VertexMap>::value_type>> values;
  internal::surface_source(surface).for_each_vertex(
      [&](std::size_t, const auto& v) { values.push_back(internal::value_at(map, v)); });
  return internal::gradients_of_values(read_surface(surface, np), values);
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_INPUT_VERTEX_FUNCTIONS_H
