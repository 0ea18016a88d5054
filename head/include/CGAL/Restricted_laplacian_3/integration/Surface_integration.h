// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_SURFACE_INTEGRATION_H
#define CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_SURFACE_INTEGRATION_H

#include <CGAL/Restricted_laplacian_3/integration/Integration_nodes.h>

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

struct Sheet_integrals;
class Function_moments;

/// What is constant on a face: a weight of the mass alone, and the material there.
struct Face_factors {
  double mass_weight = 1, density = 1;
  /// \f$P D P\f$; without a value \f$P = I - n n^T\f$
  std::optional<Symmetric_tensor_3> metric;
};
using Factors_of_face = Function_view<Face_factors(std::size_t)>;

/// whether a type is a model of `SurfaceIntegration_3`
template <class T, class = void> struct Is_surface_integration : std::false_type {};
template <class T>
struct Is_surface_integration<T, std::void_t<decltype(std::declval<const T&>().add_nodes(
                                     std::size_t(), int(), std::declval<Integration_nodes&>()))>>
  : std::true_type {};

/// whether a model adds moments faster than its nodes would
template <class T, class = void> struct Adds_moments : std::false_type {};
template <class T>
struct Adds_moments<T, std::void_t<decltype(std::declval<const T&>().add_moments(
                           std::size_t(), std::declval<const Factors_of_face*>(),
                           std::declval<Sheet_integrals&>()))>> : std::true_type {};

/// whether a model adds functions that are linear on each face faster than its nodes would
template <class T, class = void> struct Adds_linear_functions : std::false_type {};
template <class T>
struct Adds_linear_functions<T, std::void_t<decltype(std::declval<const T&>().add_linear_function(
                                    std::size_t(), std::declval<Function_moments&>()))>>
  : std::true_type {};

} // namespace internal

/// \ingroup PkgRestrictedLaplacian3Operators
/// A model of `SurfaceIntegration_3` of any type, whose conversion is implicit. A space has one,
/// see `Spline_space_3::integration()`. Copies share the model.
class Surface_integration {
public:
  /// \tparam Model a model of `SurfaceIntegration_3`, which is copied
  template <class Model, std::enable_if_t<internal::Is_surface_integration<Model>::value, int> = 0>
  Surface_integration(Model model)
    : Surface_integration(std::make_shared<const Model>(std::move(model))) {}

  /// Refers to a model, which must outlive this object and all copies of it.
  /// \tparam Model a model of `SurfaceIntegration_3`
  template <class Model, std::enable_if_t<internal::Is_surface_integration<Model>::value, int> = 0>
  Surface_integration(std::reference_wrapper<const Model> model)
    : Surface_integration(std::shared_ptr<const Model>(std::shared_ptr<void>(), &model.get())) {}

  /// Calls `visit(block)` for the nodes on a sheet of the finest level, see
  /// `SurfaceIntegration_3::add_nodes()`.
  void visit_nodes(std::size_t sheet, int degree, const Integration_nodes::Consumer& visit) const {
    Integration_nodes nodes(visit);
    m_add_nodes(m_model.get(), sheet, degree, nodes);
    nodes.flush();
  }

  /// whether the model has moments of its own
  bool adds_moments() const { return m_add_moments != nullptr; }
  /// adds the moments of a sheet, by the model; requires `adds_moments()`
  void add_moments(std::size_t sheet, const internal::Factors_of_face* factors,
                   internal::Sheet_integrals& integrals) const {
    m_add_moments(m_model.get(), sheet, factors, integrals);
  }

  /// whether the model has a way of its own for functions that are linear on each face
  bool adds_linear_functions() const { return m_add_linear_function != nullptr; }
  /// adds such a function on a sheet, by the model; requires `adds_linear_functions()`
  void add_linear_function(std::size_t sheet, internal::Function_moments& moments) const {
    m_add_linear_function(m_model.get(), sheet, moments);
  }

private:
  template <class Model>
  explicit Surface_integration(std::shared_ptr<const Model> model)
    : m_model(std::move(model)),
      m_add_nodes([](const void* model, std::size_t sheet, int degree, Integration_nodes& nodes) {
        static_cast<const Model*>(model)->add_nodes(sheet, degree, nodes);
      }) {
    if constexpr(internal::Adds_moments<Model>::value)
      m_add_moments = [](const void* model, std::size_t sheet,
                         const internal::Factors_of_face* factors,
                         internal::Sheet_integrals& integrals) {
        static_cast<const Model*>(model)->add_moments(sheet, factors, integrals);
      };
    if constexpr(internal::Adds_linear_functions<Model>::value)
      m_add_linear_function = [](const void* model, std::size_t sheet,
                                 internal::Function_moments& moments) {
        static_cast<const Model*>(model)->add_linear_function(sheet, moments);
      };
  }

  std::shared_ptr<const void> m_model;
  void (*m_add_nodes)(const void*, std::size_t, int, Integration_nodes&);
  void (*m_add_moments)(const void*, std::size_t, const internal::Factors_of_face*,
                        internal::Sheet_integrals&) = nullptr;
  void (*m_add_linear_function)(const void*, std::size_t, internal::Function_moments&) = nullptr;
};

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_SURFACE_INTEGRATION_H
