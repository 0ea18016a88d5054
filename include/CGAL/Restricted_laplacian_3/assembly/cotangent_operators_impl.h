// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_COTANGENT_OPERATORS_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_COTANGENT_OPERATORS_IMPL_H

#include <CGAL/Restricted_laplacian_3/assembly/cotangent_operators.h>

#include <Eigen/SparseCore>

#include <array>
#include <cstddef>
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
    std::array<Vector_3, 3> side;
    for(int i = 0; i < 3; ++i)
      side[i] = surface.point(f, (i + 2) % 3) - surface.point(f, (i + 1) % 3);
    const double area = surface.area(f);
    const auto& v = surface.triangle(f);
    for(int i = 0; i < 3; ++i)
      for(int j = 0; j < 3; ++j) {
        const int row = static_cast<int>(v[i]), column = static_cast<int>(v[j]);
        stiffness.emplace_back(row, column, side[i] * side[j] / (4 * area));
        if(!lumped_mass)
          mass.emplace_back(row, column, area / (i == j ? 6 : 12));
        else if(i == j)
          mass.emplace_back(row, column, area / 3);
      }
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
