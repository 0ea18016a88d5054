// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_SHARED_LINEAR_ELEMENTS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_SHARED_LINEAR_ELEMENTS_H

#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cstddef>
#include <vector>

/// \file
/// The functions that are linear in each triangle: blocks of a triangle, and where they go.

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// \f$\int \langle \nabla \phi_i, \nabla \phi_j \rangle = \langle e_i, e_j \rangle / (4 A)\f$ on a
/// triangle of area \f$A\f$, where \f$e_i\f$ is the side opposite to corner \f$i\f$.
inline Eigen::Matrix3d linear_stiffness(const Triangulated_surface_3& surface, std::size_t face) {
  Eigen::Matrix3d sides;
  for(int i = 0; i < 3; ++i) {
    const Vector_3 side = surface.point(face, (i + 2) % 3) - surface.point(face, (i + 1) % 3);
    sides.col(i) << side.x(), side.y(), side.z();
  }
  return sides.transpose() * sides / (4 * surface.area(face));
}

/// \f$\int \phi_i \phi_j = A/12\,(1 + \delta_{ij})\f$ on a triangle of area \f$A\f$
inline Eigen::Matrix3d linear_mass(double area) {
  return area / 12 * (Eigen::Matrix3d::Ones() + Eigen::Matrix3d::Identity());
}

/// adds a block of a triangle to the entries of a matrix with a row for each vertex
inline void add_block(const Triangulated_surface_3::Triangle& triangle,
                      const Eigen::Matrix3d& block, std::vector<Eigen::Triplet<double>>& entries) {
  for(int i = 0; i < 3; ++i)
    for(int j = 0; j < 3; ++j)
      entries.emplace_back(static_cast<int>(triangle[i]), static_cast<int>(triangle[j]),
                           block(i, j));
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_SHARED_LINEAR_ELEMENTS_H
