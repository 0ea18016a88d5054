// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_TEXTURES_INTERNAL_HARMONIC_FILL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_TEXTURES_INTERNAL_HARMONIC_FILL_H

#include <CGAL/Restricted_laplacian_3/assembly/cotangent_operators.h>
#include <CGAL/Restricted_laplacian_3/foundation/Sparse_matrix.h>
#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Disjoint_sets.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>

#include <Eigen/Core>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// The rows of vertices whose values are to be found: -1 for those that are known, and for those
/// that are connected to no known vertex.
inline std::vector<int> rows_to_be_filled(const Triangulated_surface_3& surface,
                                          const std::vector<char>& is_known) {
  const std::size_t n = surface.number_of_vertices();
  Disjoint_sets sets(n + 1); // all known vertices are in the set of number n
  for(std::size_t v = 0; v < n; ++v)
    if(is_known[v])
      sets.unite(static_cast<std::uint32_t>(v), static_cast<std::uint32_t>(n));
  for(std::size_t f = 0; f < surface.number_of_faces(); ++f)
    if(!surface.is_degenerate(f))
      for(int i = 1; i < 3; ++i)
        sets.unite(surface.triangle(f)[0], surface.triangle(f)[i]);
  std::vector<int> rows(n, -1);
  int next = 0;
  for(std::size_t v = 0; v < n; ++v)
    if(!is_known[v] &&
       sets.find(static_cast<std::uint32_t>(v)) == sets.find(static_cast<std::uint32_t>(n)))
      rows[v] = next++;
  return rows;
}

inline Numerical_error harmonic_fill_error() {
  return Numerical_error("the factorization for parts of the surface without a scan failed: they "
                         "are joined to the others by needle triangles only");
}

/// Fills in values at vertices by functions that are linear in each triangle and harmonic: they
/// minimize \f$\int \lvert \nabla u \rvert^2\f$ with the known values. Values on connected
/// components without a known vertex are left as they are.
/// \param values a row for each vertex
/// \throws Numerical_error the factorization fails
inline void fill_harmonically(const Triangulated_surface_3& surface,
                              const std::vector<char>& is_known, Eigen::MatrixXd& values) {
  const std::vector<int> rows = rows_to_be_filled(surface, is_known);
  int number = 0;
  for(int row : rows)
    number += row >= 0;
  if(number == 0)
    return;
  const Sparse_matrix stiffness = cotangent_operators(surface).stiffness;
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::MatrixXd right_sides = Eigen::MatrixXd::Zero(number, values.cols());
  for(Eigen::Index column = 0; column < stiffness.cols(); ++column)
    for(Sparse_matrix::InnerIterator it(stiffness, column); it; ++it) {
      const int i = rows[static_cast<std::size_t>(it.row())],
                j = rows[static_cast<std::size_t>(column)];
      if(i >= 0 && j >= 0)
        entries.emplace_back(i, j, it.value());
      else if(i >= 0)
        right_sides.row(i) -= it.value() * values.row(column);
    }
  Sparse_matrix matrix(number, number);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Sparse_matrix> factor(matrix);
  if(factor.info() != Eigen::Success)
    throw harmonic_fill_error();
  const Eigen::MatrixXd solution = factor.solve(right_sides);
  if(!solution.allFinite())
    throw harmonic_fill_error();
  for(std::size_t v = 0; v < rows.size(); ++v)
    if(rows[v] >= 0)
      values.row(static_cast<Eigen::Index>(v)) = solution.row(rows[v]);
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_TEXTURES_INTERNAL_HARMONIC_FILL_H
