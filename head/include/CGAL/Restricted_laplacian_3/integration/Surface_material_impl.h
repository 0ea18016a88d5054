// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_SURFACE_MATERIAL_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_SURFACE_MATERIAL_IMPL_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/integration/Surface_material.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

[[noreturn]] inline void refuse_coefficient(const char* name, const std::string& what,
                                            const Surface_point& p) {
  throw Parameter_error(name, what + " in face " + std::to_string(p.polygon));
}

/// \param values the components of a value: a number, a tensor, or a 3 x 3 matrix row by row
inline Symmetric_tensor_3 coefficient_tensor(const double* values, int components,
                                             const Surface_point& p) {
  if(components == 1)
    return {values[0], values[0], values[0], 0, 0, 0};
  if(components == 6)
    return {values[0], values[1], values[2], values[3], values[4], values[5]};
  constexpr double tolerance = 1e-9;
  double largest = 0;
  for(int i = 0; i < 9; ++i)
    largest = (std::max)(largest, std::abs(values[i]));
  const auto mean = [&](int i, int j) {
    if(!(std::abs(values[3 * i + j] - values[3 * j + i]) <= tolerance * largest))
      refuse_coefficient("diffusion", "is not a symmetric matrix of finite numbers", p);
    return (values[3 * i + j] + values[3 * j + i]) / 2;
  };
  return {values[0], values[4], values[8], mean(0, 1), mean(0, 2), mean(1, 2)};
}

/// whether a tensor that maps a plane to itself, and its normal to 0, is positive definite there
inline bool is_positive_definite_on_plane(const Symmetric_tensor_3& a) {
  // the two eigenvalues that are not 0 have this sum and this product
  constexpr double smallest_ratio = 1e-12;
  const double sum = a[0] + a[1] + a[2];
  const double product =
      a[0] * a[1] - a[3] * a[3] + a[0] * a[2] - a[4] * a[4] + a[1] * a[2] - a[5] * a[5];
  return std::isfinite(sum) && sum > 0 && product > smallest_ratio * sum * sum;
}

} // namespace internal

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Symmetric_tensor_3 directional_tensor(
    const std::array<Vector_3, 2>& directions, const std::array<double, 2>& weights) {
  Symmetric_tensor_3 result = {};
  for(int k = 0; k < 2; ++k) {
    const Vector_3& d = directions[k];
    const double factor = weights[k] / d.squared_length();
    const Symmetric_tensor_3 dd = {d.x() * d.x(), d.y() * d.y(), d.z() * d.z(),
                                   d.x() * d.y(), d.x() * d.z(), d.y() * d.z()};
    for(int i = 0; i < 6; ++i)
      result[i] += factor * dd[i];
  }
  return result;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void Surface_material::check_components() const {
  if(m_diffusion)
    if(const int n = m_diffusion->view().components(); n != 1 && n != 6 && n != 9)
      throw Parameter_error("diffusion", "has " + std::to_string(n) +
                                             " components, but must be a number, a symmetric "
                                             "tensor (6), or a matrix (9)");
  if(m_density)
    if(const int n = m_density->view().components(); n != 1)
      throw Parameter_error("density",
                            "has " + std::to_string(n) + " components, but must be a number");
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void
Surface_material::diffusion_at(const Surface_point* points, std::size_t number,
                               Symmetric_tensor_3* tensors) const {
  if(!m_diffusion) {
    for(std::size_t i = 0; i < number; ++i)
      tensors[i] = tangent_projector(points[i].normal);
    return;
  }
  const Surface_function_view& f = m_diffusion->view();
  const int components = f.components();
  std::vector<double> values(number * static_cast<std::size_t>(components));
  f(points, number, values.data());
  for(std::size_t i = 0; i < number; ++i) {
    const double* const value = values.data() + i * static_cast<std::size_t>(components);
    if(components == 1) {
      if(!(value[0] > 0 && std::isfinite(value[0])))
        internal::refuse_coefficient("diffusion", "is not positive and finite", points[i]);
      tensors[i] = tangent_projector(points[i].normal);
      for(double& component : tensors[i])
        component *= value[0];
      continue;
    }
    tensors[i] = tangential_part(internal::coefficient_tensor(value, components, points[i]),
                                 points[i].normal);
    if(!internal::is_positive_definite_on_plane(tensors[i]))
      internal::refuse_coefficient("diffusion", "is not positive definite on the tangent plane",
                                   points[i]);
  }
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void Surface_material::density_at(const Surface_point* points,
                                                                     std::size_t number,
                                                                     double* densities) const {
  if(!m_density) {
    std::fill_n(densities, number, 1.);
    return;
  }
  m_density->view()(points, number, densities);
  for(std::size_t i = 0; i < number; ++i)
    if(!(densities[i] > 0 && std::isfinite(densities[i])))
      internal::refuse_coefficient("density", "is not positive and finite", points[i]);
}

namespace internal {

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void
Material_integration::add_nodes(std::size_t sheet, int degree, Integration_nodes& nodes) const {
  m_integration.visit_nodes(sheet, degree, [&](Integration_node_block& block) {
    std::array<Symmetric_tensor_3, Integration_node_block::capacity> tensors;
    std::array<double, Integration_node_block::capacity> densities;
    m_material.diffusion_at(block.points.data(), block.size, tensors.data());
    m_material.density_at(block.points.data(), block.size, densities.data());
    for(std::size_t i = 0; i < block.size; ++i) {
      for(std::size_t k = 0; k < 6; ++k)
        block.metrics[i][k] = tensors[i][k] / densities[i];
      block.weights[i] *= densities[i];
    }
    nodes.hand_on(block);
  });
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void
Face_material_integration::add_moments(std::size_t sheet, const Factors_of_face* factors,
                                       Sheet_integrals& integrals) const {
  const auto with_material = [&](std::size_t face) {
    Face_factors result = factors ? (*factors)(face) : Face_factors();
    const Surface_point point = center_of_face(*m_surface, face);
    material().density_at(&point, 1, &result.density);
    result.metric.emplace();
    material().diffusion_at(&point, 1, &*result.metric);
    return result;
  };
  const Factors_of_face view(with_material);
  integration().add_moments(sheet, &view, integrals);
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Surface_integration
integration_with_material(const Surface_integration& integration, const Surface_material& material,
                          const Triangulated_surface_3& surface) {
  if(material.is_trivial())
    return integration;
  if(material.is_constant_on_faces() && integration.adds_moments() && !surface.is_smooth())
    return Face_material_integration(integration, material, surface);
  return Material_integration(integration, material);
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_SURFACE_MATERIAL_IMPL_H
