// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_INTERNAL_MASS_WEIGHTED_INTEGRATION_H
#define CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_INTERNAL_MASS_WEIGHTED_INTEGRATION_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/integration/cell_integrals.h>
#include <CGAL/Restricted_laplacian_3/integration/internal/sheet_kernels.h>
#include <CGAL/Restricted_laplacian_3/integration/surface_integration.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// A weight that is finite and not negative, else an exception that names the face.
inline double checked_screening_weight(double weight, std::size_t face) {
  if(!(weight >= 0 && std::isfinite(weight)))
    throw Parameter_error("screening_weight",
                          "is negative or not finite in face " + std::to_string(face));
  return weight;
}

/// Integration with a weight for the mass alone: the assembly gives \f$S\f$ and
/// \f$\int w\, b_i b_j\f$ of all levels in one pass. A model of `SurfaceIntegration_3` but for
/// that.
///
/// A weight that is constant on each face, integrated by `Cubature`, takes the moments of a
/// fragment only once, and is exact. For others, the weighted moments of a face are summed beside
/// those without weight.
template <class SurfaceIntegration, class Weight> class Mass_weighted_integration {
public:
  /// \param weight a function object that takes a `const Surface_point&` and returns a number
  /// \param integration,space,weight must outlive this object
  Mass_weighted_integration(const Spline_space_3& space, const SurfaceIntegration& integration,
                            const Weight& weight)
    : m_octree(space.octree()), m_integration(integration), m_weight(weight) {}

  /// \throws Parameter_error if a weight is negative or not finite
  void add_moments(std::size_t sheet, Cell_moments& moments) const {
    Cell_moments::Moments of_face, weighted;
    std::size_t face = no_face;
    const auto flush = [&] {
      if(face == no_face)
        return;
      add_scaled(weighted, 1, moments.mass);
      const auto projector = tangent_projector(m_octree.surface().normal(face));
      for(int k = 0; k < 6; ++k)
        add_scaled(of_face, projector[k], moments.tensor[k]);
    };
    m_integration.for_each_node(sheet, [&](const std::array<double, 3>& t,
                                           const Surface_location& location, double weight) {
      if(location.face != face) {
        flush();
        face = location.face;
        of_face.fill(0);
        weighted.fill(0);
      }
      add_node(t, weight, of_face);
      const double factor = weight_at(location);
      if(factor > 0)
        add_node(t, factor * weight, weighted);
    });
    flush();
  }

  void add_moments(std::size_t sheet, Sheet_moments& moments) const {
    if constexpr(std::is_same_v<SurfaceIntegration, Cubature>)
      if(degree_on_triangles(m_weight) == 0 && !m_octree.surface().is_point_set())
        return add_moments_of_faces(sheet, moments);
    Cell_moments sum = moments.cell_moments();
    add_moments(sheet, sum);
    moments = Sheet_moments(sum);
  }

private:
  static constexpr std::size_t no_face = (std::numeric_limits<std::size_t>::max)();

  double weight_at(const Surface_location& location) const {
    return checked_screening_weight(
        static_cast<double>(m_weight(m_octree.surface().surface_point(location))), location.face);
  }

  void add_moments_of_faces(std::size_t sheet, Sheet_moments& moments) const {
    const Cell_3 cell = m_octree.cell(m_octree.depth(), sheet);
    Surface_location center;
    center.barycentric.fill(1. / 3);
    for(std::uint32_t face : m_octree.faces(sheet)) {
      center.face = face;
      add_fragment(m_octree.fragment(cell, face), cell.index, m_octree.surface().normal(face),
                   moments, weight_at(center));
    }
  }

  const Octree_3& m_octree;
  const SurfaceIntegration& m_integration;
  const Weight& m_weight;
};

template <class SurfaceIntegration, class Weight>
void add_sheet_moments(const Mass_weighted_integration<SurfaceIntegration, Weight>& integration,
                       std::size_t sheet, Sheet_moments& moments) {
  integration.add_moments(sheet, moments);
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_INTERNAL_MASS_WEIGHTED_INTEGRATION_H
