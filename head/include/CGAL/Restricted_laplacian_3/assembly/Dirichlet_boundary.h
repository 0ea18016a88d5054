// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_DIRICHLET_BOUNDARY_H
#define CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_DIRICHLET_BOUNDARY_H

#include <CGAL/Restricted_laplacian_3/assembly/Boundary_integration.h>
#include <CGAL/Restricted_laplacian_3/foundation/Sparse_matrix.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Function_view.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>
#include <CGAL/Restricted_laplacian_3/surface/Surface_function_view.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Operators
/// Prescribes the values \f$u = g\f$ on the boundary of an open surface, or a part \f$\Gamma\f$
/// of it, by the symmetric method of Nitsche. The rest has the natural condition, or a flux, see
/// `Boundary_integration::load()`. With the outward conormal \f$\nu\f$ (unit, tangential to the
/// surface) it adds
/// \f[ A_{ij} = \int_\Gamma -\partial_\nu b_i\, b_j - b_i\, \partial_\nu b_j
///     + \beta\, b_i b_j, \qquad
///     \phi_i = \int_\Gamma g\, (\beta\, b_i - \partial_\nu b_i) \f]
/// to the stiffness matrix and to the right-hand side of \f$S \eta = \dots\f$. The solution of the
/// differential equation satisfies the discrete equations exactly (the method is consistent), so
/// the order of convergence is that of the space; values on the boundary are met up to the
/// discretization error, not to rounding.
///
/// \f$\beta\f$ is \f$2 \lambda\f$, one for each sheet of the finest level, with the largest
/// \f$\lambda\f$ for which
/// \f$ \int_\Gamma (\partial_\nu u)^2 = \lambda \int \lvert \nabla u \rvert^2 \f$
/// on the sheet for some \f$u\f$: this makes \f$S + A\f$ positive semi-definite however the
/// boundary cuts the cells, and needs no parameter.
///
/// Where the boundary only clips a corner of a cell, \f$\lambda\f$ grows without limit and would
/// dominate all norms. There \f$\beta\f$ is at most `largest_penalty` over the cell width, and the
/// terms with \f$\partial_\nu\f$ are multiplied by \f$\sqrt{\beta / 2 \lambda}\f$, which keeps
/// the matrix positive semi-definite.
///
/// See J. Nitsche, "Ueber ein Variationsprinzip zur Loesung von Dirichlet-Problemen", 1971; the
/// choice of \f$\beta\f$: M. Griebel and M. A. Schweitzer, "A particle-partition of unity method,
/// part V: boundary conditions", 2003.
class Dirichlet_boundary {
public:
  /// upper bound of \f$\beta\f$ times the cell width of the finest level
  static constexpr double largest_penalty = 1000;

  /// Takes time proportional to the number of faces, and for each sheet at the boundary that of the
  /// eigenvalues of a 27 x 27 matrix.
  /// \param space is copied, which costs nothing
  /// \throws Parameter_error if the surface has no boundary
  /// \throws Numerical_error if a part of the boundary lies on no sheet; names the face
  explicit Dirichlet_boundary(const Spline_space_3& space);

  /// Prescribes values on a part of the boundary.
  /// \param boundary all of it or none of it, too
  explicit Dirichlet_boundary(Boundary_integration boundary);

  /// the boundary on which values are prescribed
  const Boundary_integration& boundary() const { return m_boundary; }
  /// its length
  double length() const { return m_boundary.length(); }

  /// adds \f$A\f$ to a matrix of the finest level that has the pattern of the stiffness matrix
  void add_to_matrix(Sparse_matrix& a) const;

  /// \f$\phi\f$, `dimension()` entries
  /// \param g a function object that takes a `const Surface_point&` and returns a number
  /// \throws Parameter_error if a value is not finite; names the face
  Eigen::VectorXd load(const Surface_function_view& g) const;

  /// \f$\int_\Gamma g / \mathrm{length}\f$, 0 if the length is
  double mean(const Surface_function_view& g) const;

  /// \f$(\int_\Gamma (u - g)^2 / \mathrm{length})^{1/2}\f$
  double root_mean_square_error(const Eigen::VectorXd& coefficients,
                                const Surface_function_view& g) const;

private:
  /// of the nodes of a sheet
  struct Penalty {
    double beta;
    double flux; // factor of the conormal derivative
  };

  Penalty penalty(std::size_t first, std::size_t last) const;
  Eigen::VectorXd values(const Surface_function_view& g) const {
    return m_boundary.values(g, "boundary_values");
  }
  void for_each_sheet(internal::Function_view<void(std::size_t, std::size_t)> visit) const;

  Boundary_integration m_boundary;
  std::vector<Penalty> m_penalties; // one for each node
};

} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/assembly/Dirichlet_boundary_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_DIRICHLET_BOUNDARY_H
