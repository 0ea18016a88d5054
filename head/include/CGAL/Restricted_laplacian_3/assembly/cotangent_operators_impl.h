// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_COTANGENT_OPERATORS_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_COTANGENT_OPERATORS_IMPL_H

#include <CGAL/Restricted_laplacian_3/assembly/cotangent_operators.h>
#include <CGAL/Restricted_laplacian_3/assembly/shared/linear_elements.h>

#include <Eigen/SparseCore>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Operators
cotangent_operators(const Triangulated_surface_3& surface, bool lumped_mass) {
  surface.require_triangles("the cotangent Laplacian");
  std::vector<Eigen::Triplet<double>> stiffness, mass;
  stiffness.reserve(9 * surface.number_of_faces());
  mass.reserve((lumped_mass ? 3 : 9) * surface.number_of_faces());
  for(std::size_t f = 0; f < surface.number_of_faces(); ++f) {
    if(surface.is_degenerate(f))
      continue;
    const Triangulated_surface_3::Triangle& triangle = surface.triangle(f);
    internal::add_block(triangle, internal::linear_stiffness(surface, f), stiffness);
    if(!lumped_mass)
      internal::add_block(triangle, internal::linear_mass(surface.area(f)), mass);
    else
      for(std::uint32_t v : triangle)
        mass.emplace_back(static_cast<int>(v), static_cast<int>(v), surface.area(f) / 3);
  }
  const Eigen::Index n = static_cast<Eigen::Index>(surface.number_of_vertices());
  Operators operators{Sparse_matrix(n, n), Sparse_matrix(n, n)};
  operators.stiffness.setFromTriplets(stiffness.begin(), stiffness.end());
  operators.mass.setFromTriplets(mass.begin(), mass.end());
  return operators;
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_COTANGENT_OPERATORS_IMPL_H
