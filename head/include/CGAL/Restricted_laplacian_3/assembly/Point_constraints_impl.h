// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_POINT_CONSTRAINTS_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_POINT_CONSTRAINTS_IMPL_H

#include <CGAL/Restricted_laplacian_3/assembly/Point_constraints.h>
#include <CGAL/Restricted_laplacian_3/basis/Tensor_basis_3.h>
#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>

#include <cmath>
#include <cstdint>
#include <string>

namespace CGAL {
namespace Restricted_laplacian_3 {

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void Point_constraints::add(const Surface_location& location,
                                                               double value, double weight,
                                                               bool is_exact) {
  const Triangulated_surface_3& surface = m_space.surface();
  if(location.face >= surface.number_of_faces())
    throw Location_error("there is no face " + std::to_string(location.face));
  if(!(weight >= 0 && std::isfinite(weight)))
    throw Parameter_error("constraint_weight", "must be a finite number that is not negative");
  if(!std::isfinite(value))
    throw Parameter_error("constraints", "has a value that is not a finite number");
  const int depth = m_space.depth();
  const auto [sheet, t] = m_space.octree().locate(depth, location);
  if(sheet == m_space.octree().number_of_sheets(depth))
    throw Location_error("a constraint with face " + std::to_string(location.face) +
                         " is not on the surface");
  m_constraints.push_back({sheet, t, value, weight, is_exact});
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void Point_constraints::add(const Surface_location& location,
                                                               double value) {
  double diffusion = 1;
  if(!m_space.material().is_trivial() && location.face < m_space.surface().number_of_faces()) {
    const Surface_point point = m_space.surface().surface_point(location);
    Symmetric_tensor_3 tensor;
    m_space.material().diffusion_at(&point, 1, &tensor);
    diffusion = (tensor[0] + tensor[1] + tensor[2]) / 2;
  }
  add(location, value, weight_of_exact * diffusion, true);
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void Point_constraints::add(const Surface_location& location,
                                                               double value, double weight) {
  add(location, value, weight, false);
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Eigen::VectorXd Point_constraints::values() const {
  Eigen::VectorXd values(static_cast<Eigen::Index>(size()));
  for(std::size_t k = 0; k < size(); ++k)
    values[static_cast<Eigen::Index>(k)] = m_constraints[k].value;
  return values;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Eigen::VectorXd Point_constraints::weights() const {
  Eigen::VectorXd weights(static_cast<Eigen::Index>(size()));
  for(std::size_t k = 0; k < size(); ++k)
    weights[static_cast<Eigen::Index>(k)] = m_constraints[k].weight;
  return weights;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void Point_constraints::add_to_matrix(Sparse_matrix& a) const {
  for(const Constraint& c : m_constraints) {
    const Cell_elements& elements = m_space.elements(m_space.depth(), c.sheet);
    const Tensor_basis_3::Values b = Tensor_basis_3::values(c.t);
    for_each_element(elements, [&](int j, std::uint32_t column) {
      for_each_element(elements, [&](int i, std::uint32_t row) {
        a.coeffRef(row, column) += c.weight * (b[i] * b[j]);
      });
    });
  }
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Eigen::VectorXd
Point_constraints::load(const Eigen::VectorXd& fluxes) const {
  Eigen::VectorXd load = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(m_space.dimension()));
  for(std::size_t k = 0; k < size(); ++k) {
    const Constraint& c = m_constraints[k];
    const double flux = fluxes[static_cast<Eigen::Index>(k)];
    const Tensor_basis_3::Values b = Tensor_basis_3::values(c.t);
    for_each_element(m_space.elements(m_space.depth(), c.sheet),
                     [&](int i, std::uint32_t element) { load[element] += flux * b[i]; });
  }
  return load;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Eigen::VectorXd
Point_constraints::values_of(const Eigen::VectorXd& coefficients) const {
  Eigen::VectorXd values(static_cast<Eigen::Index>(size()));
  for(std::size_t k = 0; k < size(); ++k) {
    const Constraint& c = m_constraints[k];
    const Tensor_basis_3::Values b = Tensor_basis_3::values(c.t);
    double value = 0;
    for_each_element(m_space.elements(m_space.depth(), c.sheet),
                     [&](int i, std::uint32_t element) { value += coefficients[element] * b[i]; });
    values[static_cast<Eigen::Index>(k)] = value;
  }
  return values;
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_POINT_CONSTRAINTS_IMPL_H
