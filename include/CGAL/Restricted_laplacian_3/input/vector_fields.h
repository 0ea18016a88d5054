// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_INPUT_VECTOR_FIELDS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_INPUT_VECTOR_FIELDS_H

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

#endif // CGAL_RESTRICTED_LAPLACIAN_3_INPUT_VECTOR_FIELDS_H
