// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SURFACE_FUNCTIONS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SURFACE_FUNCTIONS_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/surface/Surface_location.h>
#include <CGAL/Restricted_laplacian_3/surface/shared/coordinates.h>

#include <CGAL/assertions.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

/// \file
/// Functions on a surface that are given by values at its vertices, corners or faces. What such
/// values mean between the vertices is decided here, and in `shared/function_on_surface.h`, which
/// chooses.

namespace CGAL {
namespace Restricted_laplacian_3 {

namespace internal {

/// The mean of values at the corners of a triangle with barycentric coordinates as weights. On a
/// side the value at the corner opposite to it does not count, even if it is NaN.
template <class T>
T barycentric_mean(const T& a, const T& b, const T& c, const std::array<double, 3>& barycentric) {
  const auto& [x, y, z] = barycentric;
  if(x != 0 && y != 0 && z != 0)
    return a * x + b * y + c * z;
  if(x == 0)
    return y == 0 ? T(c * z) : z == 0 ? T(b * y) : T(b * y + c * z);
  return y != 0 ? T(a * x + b * y) : z != 0 ? T(a * x + c * z) : T(a * x);
}

} // namespace internal

/// \cond SKIP_IN_MANUAL
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
/// \endcond

/// \ingroup PkgRestrictedLaplacian3Functions
/// Tells that a function or vector field is well approximated by polynomials of a degree below 6 on
/// each part of a triangle in a cell, which takes fewer nodes: 16 in place of 32 for degree 2, with
/// which the error of a Poisson solution remains of the order \f$h^3\f$ for a smooth function; for
/// degree 1 and 0 the values at the corners of the part say all.
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
    return internal::barycentric_mean(m_values[p.vertices[0]], m_values[p.vertices[1]],
                                      m_values[p.vertices[2]], p.barycentric);
  }
  /// linear in each triangle
  int degree() const { return 1; }

private:
  std::vector<T> m_values;
};

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
    return internal::barycentric_mean(corners[0], corners[1], corners[2], p.barycentric);
  }
  /// linear in each triangle
  int degree() const { return 1; }
  /// the values, three for each face
  const std::vector<T>& values() const { return m_values; }

private:
  std::vector<T> m_values;
};

namespace internal {

/// the same number everywhere on the surface
struct Constant_function {
  double value;

  double operator()(const Surface_point&) const { return value; }
  static constexpr int degree() { return 0; }
};

/// a number as a function, and others as they are
template <class Function> auto function_or_number(const Function& f) {
  if constexpr(std::is_arithmetic_v<Function>)
    return Constant_function{static_cast<double>(f)};
  else
    return f;
}

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

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SURFACE_FUNCTIONS_H
