// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_WEIGHTED_INTEGRATION_H
#define CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_WEIGHTED_INTEGRATION_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/integration/Integration_nodes.h>
#include <CGAL/Restricted_laplacian_3/integration/Surface_integration.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Operators
/// Integration over the surface with a weight: \f$\int w f\f$ in place of \f$\int f\f$, by the
/// nodes of another integration. The mass matrix becomes \f$\int w\, b_i b_j\f$. With
/// `Triangle_cubature` it is exact up to rounding if \f$w\f$ is constant on each triangle; a linear
/// \f$w\f$ makes the integrand one degree higher than the rule.
///
/// \cgalModels `SurfaceIntegration_3`
template <class Weight> class Weighted_integration {
public:
  /// \param integration a model of `SurfaceIntegration_3`, which is copied
  /// \param weight a function object that takes a `const Surface_point&` and returns a number
  Weighted_integration(const Surface_integration& integration, Weight weight)
    : m_integration(integration), m_weight(std::move(weight)) {}

  /// the nodes of the other integration, their weights multiplied
  /// \throws Parameter_error if a weight is negative or not finite
  void add_nodes(std::size_t sheet, int degree, Integration_nodes& nodes) const {
    m_integration.visit_nodes(sheet, degree, [&](Integration_node_block& block) {
      for(std::size_t i = 0; i < block.size; ++i) {
        const double factor = static_cast<double>(m_weight(block.points[i]));
        if(!(factor >= 0 && std::isfinite(factor)))
          throw Parameter_error("weight", "is negative or not finite in face " +
                                              std::to_string(block.points[i].polygon));
        nodes.add(block.points[i], block.position(i), block.weights[i] * factor, block.metrics[i],
                  block.areas[i]);
      }
    });
  }

private:
  Surface_integration m_integration;
  Weight m_weight;
};

/// \ingroup PkgRestrictedLaplacian3Operators
/// Integration over the surface with a diffusion tensor \f$D\f$: the stiffness matrix becomes
/// \f$ \int (P \nabla b_i)^T D\, P \nabla b_j \f$, where \f$P = I - n n^T\f$; so \f$\Delta u\f$
/// becomes \f$\mathrm{div}(D \nabla u)\f$. Areas, normals and the mass matrix remain.
///
/// \cgalModels `SurfaceIntegration_3`
template <class Tensor> class Diffusion_integration {
public:
  /// \param integration a model of `SurfaceIntegration_3`, which is copied
  /// \param tensor a function object that takes a `const Surface_point&` and returns a
  /// `Symmetric_tensor_3`, positive semi-definite; only its tangential part counts
  Diffusion_integration(const Surface_integration& integration, Tensor tensor)
    : m_integration(integration), m_tensor(std::move(tensor)) {}

  /// the nodes of the other integration, with the metric \f$P D P\f$
  void add_nodes(std::size_t sheet, int degree, Integration_nodes& nodes) const {
    m_integration.visit_nodes(sheet, degree, [&](Integration_node_block& block) {
      for(std::size_t i = 0; i < block.size; ++i)
        nodes.add(block.points[i], block.position(i), block.weights[i],
                  tangential_part(m_tensor(block.points[i]), block.points[i].normal),
                  block.areas[i]);
    });
  }

private:
  Surface_integration m_integration;
  Tensor m_tensor;
};

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_WEIGHTED_INTEGRATION_H
