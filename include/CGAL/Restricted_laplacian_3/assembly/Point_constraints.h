// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_POINT_CONSTRAINTS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_POINT_CONSTRAINTS_H

#include <CGAL/Restricted_laplacian_3/foundation/Sparse_matrix.h>
#include <CGAL/Restricted_laplacian_3/foundation/compiled.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>
#include <CGAL/Restricted_laplacian_3/surface/Surface_location.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Operators
/// Prescribes values at single points by a penalty: minimizes the energy plus
/// \f$ \sum_k w_k (u(p_k) - g_k)^2 \f$, which adds \f$ \sum_k w_k b(p_k) b(p_k)^T \f$ to the matrix
/// and \f$ \sum_k w_k g_k b(p_k) \f$ to the right-hand side.
///
/// The weights have the unit of the stiffness matrix: none. With weight \f$w\f$ the solution misses
/// the value by \f$1 / w\f$ times the flux that it takes to hold it, so \f$10^3\f$ or
/// \f$10^4\f$ hold a value to three or four digits, while small weights pull gently. For
/// values along a boundary take `Dirichlet_boundary`.
///
/// A value at a point of a surface has no meaning for the differential equation: the finer the
/// space, the narrower the peak by which it is met.
class Point_constraints {
public:
  /// \param space is copied, which costs nothing
  explicit Point_constraints(const Spline_space_3& space) : m_space(space) {}

  /// \throws Location_error if the location is not on the surface
  /// \throws Parameter_error if the weight is negative, or if a number is not finite
  void add(const Surface_location& location, double value, double weight);

  /// number of prescribed values
  std::size_t size() const { return m_constraints.size(); }

  /// adds to a matrix of the finest level that has the pattern of the stiffness matrix
  void add_to_matrix(Sparse_matrix& a) const;

  /// `dimension()` entries
  Eigen::VectorXd load() const;

private:
  struct Constraint {
    std::size_t sheet;
    std::array<double, 3> t; // local coordinate in the cell
    double value, weight;
  };

  Spline_space_3 m_space;
  std::vector<Constraint> m_constraints;
};

} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/assembly/Point_constraints_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_POINT_CONSTRAINTS_H
