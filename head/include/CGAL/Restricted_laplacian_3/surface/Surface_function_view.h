// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SURFACE_FUNCTION_VIEW_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SURFACE_FUNCTION_VIEW_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/Function_view.h>
#include <CGAL/Restricted_laplacian_3/surface/Surface_location.h>
#include <CGAL/Restricted_laplacian_3/surface/shared/function_components.h>
#include <CGAL/Restricted_laplacian_3/surface/surface_functions.h>

#include <Eigen/Core>

#include <cstddef>
#include <memory>
#include <type_traits>

namespace CGAL {
namespace Restricted_laplacian_3 {

class Surface_function_view;

namespace internal {

/// whether an object of a type evaluates itself at many points in one call
template <class Function>
constexpr bool is_block_function =
    std::is_invocable_v<const Function&, const Surface_point*, std::size_t, double*> &&
    !std::is_base_of_v<Surface_function_view, Function>;

} // namespace internal

/// \ingroup PkgRestrictedLaplacian3Dev
/// Refers to a model of `SurfaceFunction_3` of any type, which must outlive it. It is evaluated at
/// many points in one call, so what is compiled once costs nothing that counts.
///
/// Functions take it where a caller gives a function object, whose conversion is implicit.
class Surface_function_view {
public:
  /// \tparam Function a model of `SurfaceFunction_3` whose values are numbers, `std::array`s of
  /// numbers, vectors of Eigen of a fixed size, or 3D vectors or points of \cgal
  template <class Function,
            std::enable_if_t<std::is_invocable_v<const Function&, const Surface_point&>, int> = 0>
  Surface_function_view(const Function& f)
    : Surface_function_view(f, internal::Components_of<Function>()) {}

  /// A function that evaluates itself at many points in one call, and whose number of components is
  /// known when the program runs: interpreters call once for a block.
  /// \tparam Function has members `components()` and `degree()`, and can be called as an object of
  /// this class can
  template <class Function, std::enable_if_t<internal::is_block_function<Function>, int> = 0>
  Surface_function_view(const Function& f)
    : m_function(internal::address_of(f)), m_components(f.components()), m_degree(f.degree()),
      m_evaluate([](const void* function, const Surface_point* points, std::size_t number,
                    double* values) {
        internal::function_at<Function>(function)(points, number, values);
      }) {}

  /// number of components of a value
  int components() const { return m_components; }
  /// the degree of the polynomials that the function is close to, one on each triangle
  int degree() const { return m_degree; }

  /// Writes the values at `number` points, all components of a point before the next one.
  void operator()(const Surface_point* points, std::size_t number, double* values) const {
    m_evaluate(m_function, points, number, values);
  }

protected:
  /// \tparam Components how values are read, see `internal::Function_components`
  template <class Function, class Components>
  Surface_function_view(const Function& f, const Components&)
    : m_function(internal::address_of(f)), m_components(Components::size),
      m_degree(internal::degree_on_triangles(f)),
      m_evaluate([](const void* function, const Surface_point* points, std::size_t number,
                    double* values) {
        const Function& f = internal::function_at<Function>(function);
        for(std::size_t i = 0; i < number; ++i, values += Components::size) {
          Eigen::Map<typename Components::Vector> value(values);
          value = Components::read(f(points[i]));
        }
      }) {}

private:
  const void* m_function;
  int m_components, m_degree;
  void (*m_evaluate)(const void*, const Surface_point*, std::size_t, double*);
};

/// \ingroup PkgRestrictedLaplacian3Dev
/// The same for a vector field of one or several channels: a value has three components for each.
class Vector_field_view : public Surface_function_view {
public:
  /// \tparam VectorField a model of `SurfaceFunction_3` whose values are 3D vectors of \cgal,
  /// `std::array`s of them, or matrices of Eigen of three rows and a fixed number of columns
  template <
      class VectorField,
      std::enable_if_t<std::is_invocable_v<const VectorField&, const Surface_point&>, int> = 0>
  Vector_field_view(const VectorField& v)
    : Surface_function_view(v, internal::Channels_of<VectorField>()) {}

  /// A vector field that evaluates itself at many points in one call.
  /// \tparam VectorField as for functions; the components of a value are those of the first vector,
  /// then of the second
  template <class VectorField, std::enable_if_t<internal::is_block_function<VectorField>, int> = 0>
  Vector_field_view(const VectorField& v) : Surface_function_view(v) {}

  /// number of vectors of a value
  int channels() const { return components() / 3; }
};

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SURFACE_FUNCTION_VIEW_H
