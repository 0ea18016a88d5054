// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "catch.h"
#include "shapes.h"

#include <CGAL/Restricted_laplacian_3/integrate_gradient_field.h>

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

namespace {

namespace RL = CGAL::Restricted_laplacian_3;
namespace params = CGAL::parameters;
using shapes::Mesh;
using Jacobian = Eigen::Matrix<double, 3, 3>;

RL::Spline_space_3 gradient_space(const shapes::Triangles& t, int depth) {
  return RL::Spline_space_3(t.points, t.faces, params::octree_depth(depth));
}

// three quadrics, which are in the space, and their gradients in space
Eigen::Vector3d quadrics(const RL::Point_3& p) {
  return {p.x() * p.y() - 2 * p.z(), p.z() * p.z() + p.x(), p.x() * p.x() - p.y() * p.z() + 3};
}
Jacobian quadric_gradients(const RL::Surface_point& s) {
  const RL::Point_3& p = s.point;
  Jacobian result;
  result.col(0) << p.y(), p.x(), -2;
  result.col(1) << 1, 0, 2 * p.z();
  result.col(2) << 2 * p.x(), -p.z(), -p.y();
  return result;
}

/// largest difference of the values of a spline at the vertices to functions of the points
template <class Function>
double largest_difference(const RL::Spline_space_3& space, const Eigen::MatrixXd& coefficients,
                          Function&& f) {
  const Eigen::MatrixXd values = RL::Spline_functions_3(space, coefficients).values_at_vertices();
  double result = 0;
  for(Eigen::Index i = 0; i < values.rows(); ++i)
    result = std::max(
        result, (values.row(i).transpose() - f(space.surface().point(static_cast<std::size_t>(i))))
                    .cwiseAbs()
                    .maxCoeff());
  return result;
}

} // namespace

TEST_CASE("gradients_of_functions_in_the_space_are_integrated", "[gradient]") {
  const RL::Spline_space_3 space = gradient_space(shapes::sphere(3), 3);
  const auto target = [](const RL::Surface_point& p) { return quadrics(p.point); };
  const auto np = params::target_values(
      target, params::relative_tolerance(1e-9, params::normal_stabilization(1e-9)));
  const RL::Gradient_fit fit = RL::integrate_gradient_field(space, quadric_gradients, np);
  CHECK(fit.converged);
  CHECK(fit.root_mean_square_residuals.size() == 3);
  for(double residual : fit.root_mean_square_residuals)
    CHECK(residual < 1e-4);
  CHECK(largest_difference(space, fit.coefficients, quadrics) < 1e-4);
}
