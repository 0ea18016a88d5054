// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_SHARED_FIT_RESIDUAL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_SHARED_FIT_RESIDUAL_H

#include <CGAL/Restricted_laplacian_3/foundation/Sparse_matrix.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>
#include <CGAL/Restricted_laplacian_3/integration/Surface_integration.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>
#include <CGAL/Restricted_laplacian_3/surface/Surface_function_view.h>

#include <Eigen/Core>

#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// What is left of a function \f$f\f$ after a spline function \f$u\f$ is subtracted, for each
/// component \f$k\f$.
struct Fit_residual {
  /// \f$\int (f_k - u_k)\, b_i\f$: a row for each element, a column for each component
  Eigen::MatrixXd loads;
  /// \f$\int (f_k - u_k)^2\f$, in units of the squared cell width
  Eigen::VectorXd squares;

  /// \f$(\int (f_k - u_k)^2 / \mathrm{area})^{1/2}\f$ for each component, with the density of the
  /// surface as weight
  std::vector<double> root_means(const Spline_space_3& space) const;

  /// Subtracts one more spline function \f$v\f$ with the coefficients \f$\eta\f$:
  /// \f[ \int (g - v)\, b_i = \int g\, b_i - (M \eta)_i, \qquad
  ///     \int (g - v)^2 = \int g^2 - 2\, \eta^T \gamma + \eta^T M\, \eta, \quad
  ///     \gamma_i = \int g\, b_i \f]
  /// Small squares lose digits in that, see `are_accurate`.
  /// \param mass \f$M\f$; what is below its diagonal is not read
  /// \param coefficients \f$\eta\f$, a column for each component
  void subtract(const Spline_space_3& space, const Sparse_matrix& mass,
                const Eigen::MatrixXd& coefficients);

  /// whether at least four digits of the squares are not rounding errors
  bool are_accurate = true;
};

/// What there is to fit, \f$u = 0\f$.
/// \param f as in `assemble_component_loads()`
/// \throws Parameter_error if a value of `f` is not finite; names the face
Fit_residual fit_residual(const Spline_space_3& space, const Surface_function_view& f);

/// \f$(\int (f_k - u_k)^2 / \mathrm{area})^{1/2}\f$ for each component \f$k\f$, from the values of
/// both: accurate also where \f$u\f$ hardly differs from \f$f\f$. By a rule of degree 8, which has
/// half as many nodes as one that is exact for products of splines.
std::vector<double> fit_errors(const Spline_space_3& space, const Surface_function_view& f,
                               const Eigen::MatrixXd& coefficients);

/// \f$(\int (\nabla u_k - v_k)^T A\, (\nabla u_k - v_k) / \mathrm{area})^{1/2}\f$ with the metrics
/// \f$A\f$ of the integration, for each channel \f$k\f$ of a vector field; by a rule of few nodes
std::vector<double> gradient_residuals(const Spline_space_3& space, const Vector_field_view& v,
                                       const Eigen::MatrixXd& coefficients);

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/assembly/shared/fit_residual_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_SHARED_FIT_RESIDUAL_H
