// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_SURFACE_INTEGRATION_VIEW_H
#define CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_SURFACE_INTEGRATION_VIEW_H

#include <CGAL/Restricted_laplacian_3/integration/Integration_nodes.h>

#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

struct Sheet_integrals;

/// the factor of the mass on each face
using Face_weight = Function_view<double(std::size_t)>;

/// whether a type is a model of `SurfaceIntegration_3`
template <class T, class = void> struct Is_surface_integration : std::false_type {};
template <class T>
struct Is_surface_integration<T, std::void_t<decltype(std::declval<const T&>().add_nodes(
                                     std::size_t(), int(), std::declval<Integration_nodes&>()))>>
  : std::true_type {};

/// whether a model adds moments faster than its nodes would
template <class T, class = void> struct Adds_moments : std::false_type {};
template <class T>
struct Adds_moments<
    T, std::void_t<decltype(std::declval<const T&>().add_moments(
           std::size_t(), std::declval<const Face_weight*>(), std::declval<Sheet_integrals&>()))>>
  : std::true_type {};

} // namespace internal

/// \ingroup PkgRestrictedLaplacian3Operators
/// Refers to a model of `SurfaceIntegration_3` of any type, which must outlive it. Functions take
/// it where a caller gives a model, whose conversion is implicit; so they are compiled once.
class Surface_integration_view {
public:
  /// \tparam SurfaceIntegration a model of `SurfaceIntegration_3`
  template <class SurfaceIntegration,
            std::enable_if_t<internal::Is_surface_integration<SurfaceIntegration>::value, int> = 0>
  Surface_integration_view(const SurfaceIntegration& integration)
    : m_integration(std::addressof(integration)),
      m_add_nodes(
          [](const void* integration, std::size_t sheet, int degree, Integration_nodes& nodes) {
            static_cast<const SurfaceIntegration*>(integration)->add_nodes(sheet, degree, nodes);
          }) {
    if constexpr(internal::Adds_moments<SurfaceIntegration>::value)
      m_add_moments = [](const void* integration, std::size_t sheet,
                         const internal::Face_weight* weight,
                         internal::Sheet_integrals& integrals) {
        static_cast<const SurfaceIntegration*>(integration)->add_moments(sheet, weight, integrals);
      };
  }

  /// Calls `visit(block)` for the nodes on a sheet of the finest level, see
  /// `SurfaceIntegration_3::add_nodes()`.
  void visit_nodes(std::size_t sheet, int degree, const Integration_nodes::Consumer& visit) const {
    Integration_nodes nodes(visit);
    m_add_nodes(m_integration, sheet, degree, nodes);
    nodes.flush();
  }

  /// whether the model has moments of its own
  bool adds_moments() const { return m_add_moments != nullptr; }
  /// adds the moments of a sheet, by the model; requires `adds_moments()`
  void add_moments(std::size_t sheet, const internal::Face_weight* weight,
                   internal::Sheet_integrals& integrals) const {
    m_add_moments(m_integration, sheet, weight, integrals);
  }

private:
  const void* m_integration;
  void (*m_add_nodes)(const void*, std::size_t, int, Integration_nodes&);
  void (*m_add_moments)(const void*, std::size_t, const internal::Face_weight*,
                        internal::Sheet_integrals&) = nullptr;
};

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_SURFACE_INTEGRATION_VIEW_H
