// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_TEST_HARMONIC_FUNCTIONS_H
#define RESTRICTED_LAPLACIAN_3_TEST_HARMONIC_FUNCTIONS_H

#include "shapes.h"

#include <CGAL/Restricted_laplacian_3/surface/Surface_location.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>

/// \file
/// Solutions of Laplacian u = 0 in the plane z = 0, with their gradients.

namespace shapes {

/// The outward conormal of the side that a point is on
inline RL::Vector_3 conormal(const Triangles& t, const RL::Surface_point& p) {
  const auto opposite = static_cast<std::size_t>(
      std::min_element(p.barycentric.begin(), p.barycentric.end()) - p.barycentric.begin());
  const RL::Vector_3 side = t.points[p.vertices[(opposite + 2) % 3]] -
                            t.points[p.vertices[(opposite + 1) % 3]],
                     n = CGAL::cross_product(side, p.normal);
  return n / std::sqrt(n.squared_length());
}

/// a harmonic function in the plane
struct Harmonic {
  std::function<double(double, double)> value;
  std::function<RL::Vector_3(double, double)> gradient;
};

/// The logarithm of the radius
inline const Harmonic logarithm = {
    [](double x, double y) { return std::log(std::hypot(x, y)); },
    [](double x, double y) { return RL::Vector_3(x, y, 0) / (x * x + y * y); }};

/// r^a sin(a phi + shift), with angles from 0 to a full turn
inline Harmonic power(double a, double shift) {
  const auto angle = [](double x, double y) {
    const double phi = std::atan2(y, x);
    return phi < -1e-9 ? phi + 2 * std::acos(-1.) : phi;
  };
  return {[=](double x, double y) {
            return std::pow(std::hypot(x, y), a) * std::sin(a * angle(x, y) + shift);
          },
          [=](double x, double y) {
            const double size = a * std::pow(std::hypot(x, y), a - 1),
                         phi = (a - 1) * angle(x, y) + shift;
            return RL::Vector_3(size * std::sin(phi), size * std::cos(phi), 0);
          }};
}

} // namespace shapes

#endif // RESTRICTED_LAPLACIAN_3_TEST_HARMONIC_FUNCTIONS_H
