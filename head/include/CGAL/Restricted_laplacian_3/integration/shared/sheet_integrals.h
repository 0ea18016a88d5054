// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_SHARED_SHEET_INTEGRALS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_SHARED_SHEET_INTEGRALS_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/integration/Surface_integration.h>
#include <CGAL/Restricted_laplacian_3/integration/shared/sheet_kernels.h>
#include <CGAL/Restricted_laplacian_3/surface/Surface_function_view.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <string>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// A factor of the mass that varies over the surface, with the name that errors give it.
struct Mass_weight {
  Surface_function_view function;
  const char* name;

  /// \throws Parameter_error if a value is negative or not finite; names the face
  void operator()(const Surface_point* points, std::size_t number, double* values) const {
    function(points, number, values);
    for(std::size_t i = 0; i < number; ++i)
      if(!(values[i] >= 0 && std::isfinite(values[i])))
        throw Parameter_error(name, "is negative or not finite in face " +
                                        std::to_string(points[i].polygon));
  }
};

/// Adds the integrals over a sheet of the finest level, with a weight for the mass alone, if one is
/// given. By the moments of the integration, if it has any and the weight is constant on each face,
/// else by nodes.
inline void add_sheet_integrals(const Triangulated_surface_3& surface,
                                const Surface_integration& integration, const Mass_weight* weight,
                                std::size_t sheet, Sheet_integrals& integrals) {
  if(integration.adds_moments() && !weight)
    return integration.add_moments(sheet, nullptr, integrals);
  if(integration.adds_moments() && weight->function.degree() == 0) {
    const auto factors_of_face = [&](std::size_t face) {
      const Surface_point point = center_of_face(surface, face);
      Face_factors factors;
      (*weight)(&point, 1, &factors.mass_weight);
      return factors;
    };
    const Factors_of_face view(factors_of_face);
    return integration.add_moments(sheet, &view, integrals);
  }
  integration.visit_nodes(sheet, integrals.degree, [&](Integration_node_block& block) {
    std::array<double, Integration_node_block::capacity> weights;
    if(weight)
      (*weight)(block.points.data(), block.size, weights.data());
    add_node_moments(block, weight ? weights.data() : nullptr, integrals.moments);
    double diffusion = integrals.diffusion.value_or(0);
    for(std::size_t i = 0; i < block.size; ++i) {
      const Symmetric_tensor_3& metric = block.metrics[i];
      diffusion += block.weights[i] * (metric[0] + metric[1] + metric[2]) / 2;
      integrals.add_normal(block.points[i].normal, block.areas[i]);
    }
    integrals.diffusion = diffusion;
  });
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_SHARED_SHEET_INTEGRALS_H
