// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_TEXTURES_SRGB_H
#define CGAL_RESTRICTED_LAPLACIAN_3_TEXTURES_SRGB_H

#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Colors
/// Red, green and blue, from 0 to 1.
using Rgb_color = std::array<double, 3>;

/// \ingroup PkgRestrictedLaplacian3Colors
/// Light of a component that is encoded by the curve of sRGB (IEC 61966-2-1), both from 0 to 1:
/// \f$x / 12.92\f$ up to 0.04045, \f$((x + 0.055) / 1.055)^{2.4}\f$ above. Numbers below 0 and
/// above 1 take the continuation of their piece.
inline double srgb_to_linear(double x) {
  return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
}

/// \ingroup PkgRestrictedLaplacian3Colors
/// The inverse of `srgb_to_linear()`.
inline double linear_to_srgb(double x) {
  return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
}

namespace internal {

/// derivative of `srgb_to_linear()`
inline double srgb_to_linear_derivative(double x) {
  return x <= 0.04045 ? 1 / 12.92 : 2.4 / 1.055 * std::pow((x + 0.055) / 1.055, 1.4);
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_TEXTURES_SRGB_H
