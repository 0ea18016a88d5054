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
                                                               double value, double weight) {
  const Triangulated_surface_3& surface = m_space.surface();
  if(location.face >= surface.number_of_faces())
    throw Location_error("there is no face " + std::to_string(location.face));
  if(!(weight >= 0 && std::isfinite(weight)))
    throw Parameter_error("constraint_weight", "must be a finite number that is not negative");
  if(!std::isfinite(value))
    throw Parameter_error("constraint_values", "has a value that is not a finite number");
  const int depth = m_space.depth();
  const auto [sheet, t] = m_space.octree().locate(depth, location);
  if(sheet == m_space.octree().number_of_sheets(depth))
    throw Location_error("a constraint with face " + std::to_string(location.face) +
                         " is not on the surface");
  m_constraints.push_back({sheet, t, value, weight});
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

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Eigen::VectorXd Point_constraints::load() const {
  Eigen::VectorXd load = Eigen::VectorXd::Zero(m_space.dimension());
  for(const Constraint& c : m_constraints) {
    const Tensor_basis_3::Values b = Tensor_basis_3::values(c.t);
    for_each_element(m_space.elements(m_space.depth(), c.sheet), [&](int i, std::uint32_t element) {
      load[element] += c.weight * c.value * b[i];
    });
  }
  return load;
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_POINT_CONSTRAINTS_IMPL_H
