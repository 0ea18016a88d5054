// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SURFACE_LOCATION_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SURFACE_LOCATION_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/surface/shared/coordinates.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/assertions.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

namespace internal {

/// the kernel in which the package computes
using Double_kernel = CGAL::Simple_cartesian<double>;

} // namespace internal

/// \ingroup PkgRestrictedLaplacian3Functions
/// The points with which this package computes, those of `CGAL::Simple_cartesian<double>`. Points
/// of other kernels are converted with `CGAL::to_double()`.
using Point_3 = CGAL::Simple_cartesian<double>::Point_3;
/// \ingroup PkgRestrictedLaplacian3Functions
/// the vectors that belong to them
using Vector_3 = CGAL::Simple_cartesian<double>::Vector_3;

/// \ingroup PkgRestrictedLaplacian3Functions
/// A location on the surface: a face and barycentric coordinates in it.
struct Surface_location {
  /// position of the face in the iteration over `faces(tm)`, counted from 0
  std::size_t face = 0;
  /// coordinates with respect to the vertices `source(h)`, `target(h)`, `target(next(h))`, where
  /// `h = halfedge(f, tm)`: the convention of \cgal's `PMP::Barycentric_coordinates`
  std::array<double, 3> barycentric = {1, 0, 0};
};

/// \ingroup PkgRestrictedLaplacian3Functions
/// A location on the surface with what a function of it may need. Functions and vector fields are
/// given to the package as function objects on `const Surface_point&`.
struct Surface_point : Surface_location {
  /// positions of the face's vertices in the iteration over `vertices(tm)`
  std::array<std::uint32_t, 3> vertices = {0, 0, 0};
  /// coordinates of the location
  Point_3 point;
  /// unit normal of the face, by the right-hand rule
  Vector_3 normal;
};

/// \ingroup PkgRestrictedLaplacian3Functions
/// Converts locations of \cgal (face descriptor and barycentric coordinates) to `Surface_location`.
/// Construction is linear in the number of faces, conversion takes constant time.
template <class FaceGraph> class Surface_location_converter {
  using Face = typename boost::graph_traits<FaceGraph>::face_descriptor;
  using Index_map =
      typename boost::property_map<FaceGraph,
                                   CGAL::dynamic_face_property_t<std::size_t>>::const_type;

public:
  /// \param tm is read here only
  explicit Surface_location_converter(const FaceGraph& tm)
    : m_index(get(CGAL::dynamic_face_property_t<std::size_t>(), tm)) {
    std::size_t i = 0;
    for(Face f : faces(tm))
      put(m_index, f, i++);
  }

  /// a face and barycentric coordinates with respect to the vertices that `Surface_location` names
  Surface_location operator()(Face f, const std::array<double, 3>& barycentric) const {
    Surface_location location;
    location.face = get(m_index, f);
    location.barycentric = barycentric;
    return location;
  }

  /// the same as a pair, the form of \cgal's `PMP::Face_location`; coordinates are converted with
  /// `CGAL::to_double()`
  template <class FT>
  Surface_location operator()(const std::pair<Face, std::array<FT, 3>>& location) const {
    return (*this)(location.first,
                   {CGAL::to_double(location.second[0]), CGAL::to_double(location.second[1]),
                    CGAL::to_double(location.second[2])});
  }

private:
  Index_map m_index;
};

/// \ingroup PkgRestrictedLaplacian3Functions
/// A function object on `Surface_point` together with the degree that `function_of_degree()` says.
///
/// \cgalModels `SurfaceFunction_3`
template <class Function> class Function_of_degree {
public:
  /// \param f a function object that takes a `const Surface_point&`
  /// \param degree from 0 to 6
  Function_of_degree(Function f, int degree) : m_function(std::move(f)), m_degree(degree) {}

  /// the value of the function at a location
  decltype(auto) operator()(const Surface_point& p) const { return m_function(p); }
  /// the degree of the polynomials that the function is close to
  int degree() const { return m_degree; }

private:
  Function m_function;
  int m_degree;
};

/// \ingroup PkgRestrictedLaplacian3Functions
/// Tells that a function or vector field is well approximated by polynomials of a degree below 6 on
/// each part of a triangle in a cell, so that it is integrated with fewer nodes: 16 in place of 32
/// for degree 2 or less. With degree 2 the error of the solution of a Poisson problem remains of
/// the order \f$h^3\f$ for a smooth function; the time for a right-hand side is halved.
/// \param f a function object that takes a `const Surface_point&`
/// \param degree from 0 to 6; 6 is what functions have that are given as they are
/// \throws Parameter_error if `degree` is outside its domain
template <class Function> Function_of_degree<Function> function_of_degree(Function f, int degree) {
  if(degree < 0 || degree > 6)
    throw Parameter_error("degree", "is " + std::to_string(degree) + ", but must be in 0 .. 6");
  return Function_of_degree<Function>(std::move(f), degree);
}

/// \ingroup PkgRestrictedLaplacian3Functions
/// A function object on `Surface_point` that interpolates values at the vertices linearly in each
/// triangle. `T` is `double` or a vector type.
///
/// \cgalModels `SurfaceFunction_3`
template <class T> class Linear_surface_function {
public:
  /// \param values for each vertex, in the order of `vertices(tm)`
  explicit Linear_surface_function(std::vector<T> values) : m_values(std::move(values)) {}

  /// the value at a location: the mean of those at the three vertices with the barycentric
  /// coordinates as weights
  /// \pre there is a value for each of the three vertices
  T operator()(const Surface_point& p) const {
    CGAL_precondition((std::max)({p.vertices[0], p.vertices[1], p.vertices[2]}) < m_values.size());
    return m_values[p.vertices[0]] * p.barycentric[0] + m_values[p.vertices[1]] * p.barycentric[1] +
           m_values[p.vertices[2]] * p.barycentric[2];
  }
  /// linear in each triangle
  int degree() const { return 1; }

private:
  std::vector<T> m_values;
};

namespace internal {

/// the degree that functions have which do not tell it
constexpr int default_degree_on_triangles = 6;

template <class Function, class = void> struct Has_degree : std::false_type {};
template <class Function>
struct Has_degree<Function, std::void_t<decltype(int(std::declval<const Function&>().degree()))>>
  : std::true_type {};

/// the degree of the polynomials that a function consists of, one on each triangle: its member
/// `degree()`, if it has one
template <class Function> int degree_on_triangles(const Function& f) {
  if constexpr(Has_degree<Function>::value)
    return f.degree();
  else
    return default_degree_on_triangles;
}

} // namespace internal

/// \ingroup PkgRestrictedLaplacian3Functions
/// The function that is linear in each triangle and takes the values of a vertex property map, as a
/// function object on `Surface_point`. The values are copied.
/// \param tm the mesh whose vertices the map knows
/// \param map a model of `ReadablePropertyMap` with the vertex descriptor as key and a number type
/// as value
template <class FaceGraph, class VertexMap>
Linear_surface_function<double> vertex_function(const FaceGraph& tm, VertexMap map) {
  std::vector<double> values;
  values.reserve(num_vertices(tm));
  for(auto v : vertices(tm))
    values.push_back(CGAL::to_double(get(map, v)));
  return Linear_surface_function<double>(std::move(values));
}

/// \ingroup PkgRestrictedLaplacian3Functions
/// The function with the values of a property map at the points of a triangle soup, linear in each
/// triangle. The values are copied.
/// \param number_of_points the map is read at all indices below it
/// \param map a model of `ReadablePropertyMap` with the index of a point as key, a `std::size_t`,
/// and a number type as value, for example `CGAL::make_property_map()` of a vector
template <class IndexMap>
Linear_surface_function<double> index_function(std::size_t number_of_points, IndexMap map) {
  std::vector<double> values;
  values.reserve(number_of_points);
  for(std::size_t i = 0; i < number_of_points; ++i)
    values.push_back(CGAL::to_double(get(map, i)));
  return Linear_surface_function<double>(std::move(values));
}

/// \ingroup PkgRestrictedLaplacian3Functions
/// The vector field that is linear in each triangle and takes the values of a vertex property map,
/// as a function object on `Surface_point`.
/// \param tm the mesh whose vertices the map knows
/// \param map a model of `ReadablePropertyMap` with the vertex descriptor as key and a 3D vector
/// type of a \cgal kernel as value
template <class FaceGraph, class VertexMap>
Linear_surface_function<Vector_3> vertex_vector_field(const FaceGraph& tm, VertexMap map) {
  std::vector<Vector_3> values;
  values.reserve(num_vertices(tm));
  for(auto v : vertices(tm))
    values.push_back(internal::with_coordinates_of<Vector_3>(get(map, v)));
  return Linear_surface_function<Vector_3>(std::move(values));
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SURFACE_LOCATION_H
