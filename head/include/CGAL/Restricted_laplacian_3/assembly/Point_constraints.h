// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_POINT_CONSTRAINTS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_POINT_CONSTRAINTS_H

#include <CGAL/Restricted_laplacian_3/foundation/Sparse_matrix.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>
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
/// Prescribes values at single points, \f$u(p_k) = g_k\f$ exactly, or by weights that pull.
///
/// A value with a weight adds \f$ w_k (u(p_k) - g_k)^2 \f$ to the energy that the solution
/// minimizes, that is \f$ w_k b(p_k) b(p_k)^T \f$ to the matrix and \f$ w_k g_k b(p_k) \f$ to the
/// right-hand side. Weights have the unit of the stiffness matrix: none. The solution misses the
/// value by \f$1 / w_k\f$ times the flux that it takes to hold it.
///
/// An exact value has the weight `weight_of_exact`, times the diffusion there, in the matrix, and
/// in the right-hand side a flux \f$\lambda_k b(p_k)\f$ besides, which `solve_poisson_problem()`
/// finds by the method of multipliers: \f$\lambda_k\f$ grows by \f$w_k (g_k - u(p_k))\f$ in each
/// step (M. R. Hestenes, *Multiplier and gradient methods*, J. Optimization Theory Appl. 4, 1969).
///
/// A value at a point of a surface has no meaning for the differential equation: the finer the
/// space, the narrower the peak by which it is met. For values along a boundary take
/// `Dirichlet_boundary`.
class Point_constraints {
public:
  /// of values that are met exactly, in the matrix
  static constexpr double weight_of_exact = 1e4;

  /// \param space is copied, which costs nothing
  explicit Point_constraints(const Spline_space_3& space) : m_space(space) {}

  /// a value that is met exactly
  /// \throws Location_error if the location is not on the surface
  /// \throws Parameter_error if the value is not finite
  void add(const Surface_location& location, double value);

  /// a value that pulls
  /// \throws Location_error if the location is not on the surface
  /// \throws Parameter_error if the weight is negative, or if a number is not finite
  void add(const Surface_location& location, double value, double weight);

  /// number of prescribed values
  std::size_t size() const { return m_constraints.size(); }
  /// whether a value is met exactly
  bool is_exact(std::size_t k) const { return m_constraints[k].is_exact; }
  /// \f$g\f$
  Eigen::VectorXd values() const;
  /// \f$w\f$
  Eigen::VectorXd weights() const;

  /// adds to a matrix of the finest level that has the pattern of the stiffness matrix
  void add_to_matrix(Sparse_matrix& a) const;

  /// \f$ \sum_k \phi_k b(p_k) \f$, `dimension()` entries
  /// \param fluxes \f$\phi\f$, one for each value
  Eigen::VectorXd load(const Eigen::VectorXd& fluxes) const;
  /// that of \f$\phi_k = w_k g_k\f$
  Eigen::VectorXd load() const { return load(weights().cwiseProduct(values())); }

  /// what a function is at the points
  Eigen::VectorXd values_of(const Eigen::VectorXd& coefficients) const;

private:
  struct Constraint {
    std::size_t sheet;
    std::array<double, 3> t; // local coordinate in the cell
    double value, weight;
    bool is_exact;
  };

  void add(const Surface_location& location, double value, double weight, bool is_exact);

  Spline_space_3 m_space;
  std::vector<Constraint> m_constraints;
};

} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/assembly/Point_constraints_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_POINT_CONSTRAINTS_H
