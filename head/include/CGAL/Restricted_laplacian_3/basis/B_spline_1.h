// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_BASIS_B_SPLINE_1_H
#define CGAL_RESTRICTED_LAPLACIAN_3_BASIS_B_SPLINE_1_H

#include <array>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Dev
/// The B-spline of degree 2 on the uniform knots of a grid, centered on a cell. On one cell with
/// local coordinate \f$t \in [0,1]\f$ three of them are not zero: that of the cell below (offset
/// \f$-1\f$), of the cell itself (0) and of the cell above (+1). Pieces are numbered by offset + 1.
///
/// \f[ \beta_{-1}(t) = (1-t)^2/2, \quad \beta_0(t) = 1/2 + t - t^2, \quad \beta_1(t) = t^2/2 \f]
///
/// They are non-negative, sum to 1, and are \f$C^1\f$ across cells.
struct B_spline_1 {
  /// values of the three pieces at \f$t\f$
  static std::array<double, 3> values(double t) {
    const double s = 1 - t;
    return {s * s / 2, 0.5 + t * s, t * t / 2};
  }

  /// derivatives of the three pieces with respect to \f$t\f$ (divide by the width of the cell to
  /// obtain those with respect to the coordinate in space)
  static std::array<double, 3> derivatives(double t) { return {t - 1, 1 - 2 * t, t}; }

  /// coefficients of the three pieces in the Bernstein polynomials of degree 2,
  /// \f$(1-t)^2, 2t(1-t), t^2\f$; none is negative
  static constexpr std::array<std::array<double, 3>, 3> bernstein_coefficients() {
    return {{{1. / 2, 0, 0}, {1. / 2, 1, 1. / 2}, {0, 0, 1. / 2}}};
  }

  /// coefficients of the derivatives of the three pieces in the Bernstein polynomials of degree 2
  static constexpr std::array<std::array<double, 3>, 3> derivative_bernstein_coefficients() {
    return {{{-1, -1. / 2, 0}, {1, 0, -1}, {0, 1. / 2, 1}}};
  }

  /// Two-scale relation \f$ \beta^l_i = \sum_j c_{j - 2i}\, \beta^{l+1}_j \f$ with
  /// \f$c_{-1} = c_2 = 1/4\f$, \f$c_0 = c_1 = 3/4\f$, all others 0 (paper, section 4.2).
  /// \param difference \f$j - 2i\f$ for the fine index \f$j\f$ and the coarse index \f$i\f$
  static double two_scale_coefficient(int difference) {
    switch(difference) {
    case -1:
    case 2: return 0.25;
    case 0:
    case 1: return 0.75;
    default: return 0;
    }
  }
};

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_BASIS_B_SPLINE_1_H
