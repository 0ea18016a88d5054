// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "catch.h"
#include "shapes.h"
#include "special_shapes.h"
#include "test_meshes.h"

#include <CGAL/Restricted_laplacian_3/assembly/shared/fit_residual.h>
#include <CGAL/Restricted_laplacian_3/fit_function.h>
#include <CGAL/Restricted_laplacian_3/input/read_surface.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_function_3.h>
#include <CGAL/Restricted_laplacian_3/surface/vertex_normals.h>

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <random>
#include <string>
#include <vector>

namespace {

namespace RL = CGAL::Restricted_laplacian_3;
namespace params = RL::parameters;
using shapes::Mesh;

RL::Spline_space_3 fitting_space(const shapes::Triangles& t, int depth) {
  return RL::Spline_space_3(RL::soup(t.points, t.faces), params::depth(depth));
}

/// L2 norm of the difference of two spline functions over that of the second
double fit_difference(const RL::Sparse_matrix& mass, const Eigen::VectorXd& a,
                      const Eigen::VectorXd& b) {
  const Eigen::VectorXd difference = a - b;
  return std::sqrt(difference.dot(mass * difference) / b.dot(mass * b));
}

double smooth_test_function(const RL::Surface_point& p) {
  return std::sin(2 * p.point.x() + 0.5) * std::cos(p.point.y()) + std::exp(p.point.z());
}

} // namespace

TEST_CASE("functions_in_the_space_are_fitted_to_the_tolerance", "[fit]") {
  const RL::Spline_space_3 space = fitting_space(shapes::sphere(4), 3);
  const RL::Sparse_matrix mass = RL::assemble_mass_matrix(space);
  std::mt19937 generator(1);
  std::normal_distribution<double> normal;
  Eigen::VectorXd eta(space.dimension());
  for(double& x : eta)
    x = normal(generator);
  const RL::Spline_function_3 u(space, eta);
  const auto spline = [&](const RL::Surface_point& p) { return u.value(p); };
  const auto quadric = [](const RL::Surface_point& p) {
    return 1e3 + p.point.x() * p.point.y() - 2 * p.point.z() + p.point.z() * p.point.z();
  };
  const RL::Function_fit fit = RL::fit_function(space, spline);
  CHECK(fit.converged);
  CHECK(fit_difference(mass, fit.coefficients, eta) < 1e-6);
  // values, not only their norm
  const std::vector<double> fitted =
      RL::Spline_function_3(space, fit.coefficients).values_at_vertices();
  const std::vector<double> expected = u.values_at_vertices();
  for(std::size_t v = 0; v < fitted.size(); ++v)
    CHECK(std::abs(fitted[v] - expected[v]) < 1e-5);
  CHECK(RL::fit_function(space, quadric).root_mean_square_error() < 1e-6);
}

TEST_CASE("smooth_functions_are_fitted_with_order_three", "[fit][slow]") {
  // an ellipsoid whose axes are not those of the grid
  shapes::Triangles ellipsoid = shapes::sphere(4);
  for(RL::Point_3& p : ellipsoid.points)
    p = RL::Point_3(p.x() + 0.3 * p.y(), 0.8 * p.y() - 0.2 * p.z(), 0.6 * p.z() + 0.1 * p.x());
  std::vector<double> errors;
  for(int depth = 3; depth <= 5; ++depth) {
    const RL::Function_fit fit =
        RL::fit_function(fitting_space(ellipsoid, depth), smooth_test_function);
    CHECK(fit.converged);
    errors.push_back(fit.root_mean_square_error());
  }
  CHECK(std::log2(errors[0] / errors[1]) > 2.4);
  CHECK(std::log2(errors[1] / errors[2]) > 2.8);
}

TEST_CASE("constants_are_fitted_to_rounding", "[fit]") {
  const shapes::Triangles two =
      shapes::joined(shapes::sphere(2), shapes::moved(shapes::sphere(2), {4, 0, 0}));
  const RL::Spline_space_3 space = fitting_space(two, 4);
  const auto f = [](const RL::Surface_point& p) { return p.point.x() < 2 ? -7. : 1e6; };
  for(double w : {0., 1e-3, 1e6}) {
    const RL::Function_fit fit = RL::fit_function(space, f, params::smoothing(w));
    CHECK(fit.root_mean_square_error() < 1e-9 * 1e6);
  }
}

TEST_CASE("vectors_are_fitted_as_their_components", "[fit]") {
  const shapes::Triangles sphere = shapes::sphere(3);
  const RL::Spline_space_3 space = fitting_space(sphere, 3);
  const auto first = [](const RL::Surface_point& p) { return p.normal.x(); };
  const RL::Function_fit one = RL::fit_function(space, first),
                         other = RL::fit_function(space, smooth_test_function);
  // a rough and a smooth component
  const RL::Function_fit both = RL::fit_function(space, [&](const RL::Surface_point& p) {
    return std::array<double, 2>{first(p), smooth_test_function(p)};
  });
  REQUIRE(both.coefficients.cols() == 2);
  const RL::Sparse_matrix mass = RL::assemble_mass_matrix(space);
  CHECK(fit_difference(mass, both.coefficients.col(0), one.coefficients) < 1e-5);
  CHECK(fit_difference(mass, both.coefficients.col(1), other.coefficients) < 1e-5);
  CHECK(both.root_mean_square_errors[0] == Approx(one.root_mean_square_error()));
  CHECK(both.root_mean_square_error() ==
        Approx(std::hypot(one.root_mean_square_error(), other.root_mean_square_error())));

  const auto eigen = [&](const RL::Surface_point& p) {
    return Eigen::Vector2d(first(p), smooth_test_function(p));
  };
  CHECK(RL::fit_function(space, eigen).coefficients == both.coefficients);
  const RL::Function_fit normal =
      RL::fit_function(space, [](const RL::Surface_point& p) { return p.normal; });
  REQUIRE(normal.coefficients.cols() == 3);
  CHECK(fit_difference(mass, normal.coefficients.col(0), one.coefficients) < 1e-5);
}

TEST_CASE("smoothing_leads_from_the_function_to_its_mean", "[fit]") {
  const RL::Spline_space_3 space = fitting_space(shapes::sphere(4), 3);
  // x is an eigenfunction of the Laplacian, with eigenvalue 2
  const auto x = [](const RL::Surface_point& p) { return 3 + p.point.x(); };
  const RL::Sparse_matrix mass = RL::assemble_mass_matrix(space);
  const auto amplitude = [&](double w, int steps) {
    const RL::Function_fit fit =
        RL::fit_function(space, x, params::smoothing(w).refinements(steps));
    CHECK(fit.converged);
    const Eigen::VectorXd centered = fit.coefficients.col(0).array() - 3;
    return std::sqrt(centered.dot(mass * centered) / (space.surface().area() / 3));
  };
  CHECK(amplitude(0, 0) == Approx(1).epsilon(2e-3));
  CHECK(amplitude(1e-9, 0) == Approx(amplitude(0, 0)).epsilon(1e-6));
  for(double w : {0.1, 1.}) {
    const double s = 2 * w;
    CHECK(amplitude(w, 0) == Approx(1 / (1 + s)).epsilon(5e-3));
    CHECK(amplitude(w, 2) == Approx(1 - std::pow(s / (1 + s), 3)).epsilon(5e-3));
  }
  CHECK(amplitude(1e4, 0) == Approx(1 / (1 + 2e4)).epsilon(1e-2));
  CHECK(amplitude(1e8, 0) < 1e-6);
  CHECK(RL::fit_function(space, x, params::smoothing(1e8)).root_mean_square_error() ==
        Approx(std::sqrt(1. / 3)).epsilon(1e-2));
}

TEST_CASE("fits_of_normals_take_few_iterations", "[fit][slow]") {
  const std::string path = shared_mesh("bunny_uniform_18k.ply");
  if(path.empty())
    SKIP_TEST("bunny_uniform_18k.ply");
  const RL::Triangulated_surface_3 bunny = RL::read_surface(shapes::read(path));
  for(int depth = 4; depth <= 6; ++depth) {
    RL::Spline_space_options options;
    options.depth = depth;
    const RL::Spline_space_3 space(bunny, options);
    const RL::Function_fit fit =
        RL::fit_function(space, [](const RL::Surface_point& p) { return p.normal; });
    INFO("depth " << depth << ", " << fit.iterations << " iterations");
    CHECK(fit.converged);
    CHECK(fit.iterations <= 10);
  }
}

TEST_CASE("fits_end_when_their_iteration_does_not_show", "[fit][slow]") {
  // Plane faces and creases: residuals of the unstabilized systems shrink slowly there. The box is
  // not aligned with the grid.
  shapes::Triangles box = shapes::box(1, 0.7, 0.4, 8, 1);
  for(RL::Point_3& p : box.points)
    p = RL::Point_3(p.x() + 0.3 * p.y(), p.y() - 0.3 * p.x(), p.z() + 0.2 * p.x());
  const RL::Spline_space_3 space = fitting_space(box, 4);
  const auto wave = [](const RL::Surface_point& p) {
    return 1e3 + std::sin(9 * p.point.x()) * std::cos(8 * p.point.y()) + p.point.z();
  };
  const auto normal = [](const RL::Surface_point& p) { return p.normal; };
  const auto check = [&](const RL::Surface_function_view& f) {
    const RL::Function_fit fit = RL::fit_function(space, f),
                           best = RL::fit_function(space, f, params::energy_tolerance(0.003));
    CHECK(fit.status == RL::Solve_status::converged);
    CHECK(best.converged);
    CHECK(fit.iterations <= 15);
    CHECK(best.iterations > fit.iterations);
    CHECK(fit.relative_residual > 1e-8);
    CHECK(best.relative_energy_error < fit.relative_energy_error);
    CHECK(fit.stabilization == RL::default_fit_stabilization(space));
    for(std::size_t k = 0; k < fit.root_mean_square_errors.size(); ++k) {
      const double least = best.root_mean_square_errors[k];
      // errors add as squares, and the one that is left is estimated before the last four steps
      CHECK(fit.root_mean_square_errors[k] <= std::sqrt(1 + 0.1 * 0.1) * least);
      CHECK(fit.root_mean_square_errors[k] >= (1 - 1e-5) * least);
    }
    // what is left of the iteration, which the estimate stands for
    const RL::Sparse_matrix mass = RL::assemble_mass_matrix(space);
    const Eigen::MatrixXd difference = fit.coefficients - best.coefficients;
    for(Eigen::Index k = 0; k < difference.cols(); ++k) {
      const double error =
          std::sqrt(difference.col(k).dot(mass * difference.col(k)) / space.surface().area());
      CHECK(error <= 0.1 * fit.root_mean_square_errors[k]);
    }
  };
  check(wave);
  check(normal);

  // by the residual alone
  const RL::Function_fit by_residual = RL::fit_function(
      space, wave, params::energy_tolerance(0.).stabilization(1e-4).tolerance(1e-6));
  CHECK(by_residual.converged);
  CHECK(by_residual.relative_residual <= 1e-6);
}

TEST_CASE("errors_of_fits_are_integrals_of_squared_differences", "[fit]") {
  const RL::Spline_space_3 space = fitting_space(shapes::sphere(3), 3);
  const double h = space.octree().cell_width(3);
  const auto check = [&](const RL::Surface_function_view& f, const RL::Function_fit& fit) {
    const std::vector<double> errors = RL::internal::fit_errors(space, f, fit.coefficients);
    for(std::size_t k = 0; k < errors.size(); ++k)
      CHECK(fit.root_mean_square_errors[k] == Approx(errors[k]).epsilon(1e-3));
  };
  const auto wave = [](const RL::Surface_point& p) {
    return std::sin(9 * p.point.x()) * p.point.z();
  };
  const auto normal = [](const RL::Surface_point& p) { return p.normal; };
  const auto plane = [](const RL::Surface_point& p) {
    return std::array<double, 2>{1 + 2 * p.point.x() - p.point.z(), std::cos(4 * p.point.y())};
  };
  check(wave, RL::fit_function(space, wave));
  check(normal, RL::fit_function(space, normal));
  // where hardly anything is left, as where the first component is in the space
  check(plane, RL::fit_function(space, plane));
  // with smoothing, and with refinement after it
  for(int steps = 0; steps < 3; ++steps)
    for(const double c : {1e-4, 1e-2})
      check(wave, RL::fit_function(space, wave,
                                   params::smoothing(h * h).refinements(steps).stabilization(c)));
  // by a fitter that had another use for its solver
  RL::Function_fitter fitter(space, params::smoothing(h * h).stabilization(1e-3).refinements(1));
  fitter.project(RL::assemble_load(space, wave));
  check(wave, fitter.fit(wave));
}

TEST_CASE("refinement_fits_what_is_left", "[fit]") {
  const RL::Spline_space_3 space = fitting_space(shapes::sphere(3), 3);
  const double h = space.octree().cell_width(3);
  const auto f = [](const RL::Surface_point& p) { return std::sin(9 * p.point.x()) * p.point.z(); };
  const auto options = params::smoothing(h * h).tolerance(1e-10);
  RL::Function_fit expected = RL::fit_function(space, f, options);
  // by values, not by matrices
  const RL::Spline_function_3 u(space, expected.coefficients);
  const auto left = [&](const RL::Surface_point& p) { return f(p) - u.value(p); };
  expected.coefficients += RL::fit_function(space, left, options).coefficients;
  const RL::Function_fit fit = RL::fit_function(space, f, options.refinements(1));
  const RL::Sparse_matrix mass = RL::assemble_mass_matrix(space);
  CHECK(fit_difference(mass, fit.coefficients, expected.coefficients) < 1e-8);
}

TEST_CASE("stabilization_of_fits_follows_their_smoothing", "[fit]") {
  const RL::Spline_space_3 space = fitting_space(shapes::sphere(2), 3);
  const double h = space.octree().cell_width(3), unit = h * h;
  CHECK(RL::default_fit_stabilization(space) == 1e-14);
  CHECK(RL::default_fit_stabilization(space, 1e-3 * unit) == Approx(1e-6));
  CHECK(RL::default_fit_stabilization(space, unit) == 1e-4);
  const auto x = [](const RL::Surface_point& p) { return p.point.x(); };
  const auto fit = [&](double w) {
    return RL::fit_function(space, x, params::smoothing(w * unit));
  };
  CHECK(fit(0.01).stabilization == Approx(1e-5));
  CHECK(fit(0.01).relative_residual <= 1e-8);
  const RL::Function_fit projected =
      RL::Function_fitter(space).project(RL::assemble_load(space, x));
  CHECK(projected.stabilization == RL::default_projection_stabilization);
  CHECK(projected.relative_residual <= 1e-8);
}

TEST_CASE("property_maps_are_fitted_on_meshes_and_soups", "[fit]") {
  const shapes::Triangles sphere = shapes::sphere(3);
  Mesh mesh = shapes::mesh(sphere);
  auto f = mesh.add_property_map<Mesh::Vertex_index, double>("f").first;
  auto u = mesh.add_property_map<Mesh::Vertex_index, float>("u").first;
  auto v = mesh.add_property_map<Mesh::Vertex_index, RL::Vector_3>("v").first;
  auto w = mesh.add_property_map<Mesh::Vertex_index, std::array<double, 3>>("w").first;
  for(Mesh::Vertex_index i : vertices(mesh)) {
    f[i] = mesh.point(i).z();
    v[i] = mesh.point(i) - CGAL::ORIGIN;
  }
  // coordinates are in the space, and linear in each triangle
  const auto np = params::depth(3);
  CHECK(RL::fit_function(mesh, f, u, np).root_mean_square_error() < 1e-6);
  const RL::Fit_report report = RL::fit_function(mesh, v, w, np);
  CHECK(report.root_mean_square_errors.size() == 3);
  for(Mesh::Vertex_index i : vertices(mesh)) {
    CHECK(u[i] == Approx(f[i]).margin(1e-6));
    for(int k = 0; k < 3; ++k)
      CHECK(w[i][k] == Approx(v[i][k]).margin(1e-6));
  }
  CHECK_THROWS_AS(RL::fit_function(mesh, v, u, np), RL::Parameter_error);

  std::vector<double> values, fitted(sphere.points.size());
  for(const RL::Point_3& p : sphere.points)
    values.push_back(p.z());
  RL::fit_function(RL::soup(sphere.points, sphere.faces), CGAL::make_property_map(values),
                   CGAL::make_property_map(fitted), np);
  for(std::size_t i = 0; i < values.size(); ++i)
    CHECK(fitted[i] == Approx(values[i]).margin(1e-6));
}

TEST_CASE("classes_take_named_parameters_as_functions_do", "[fit]") {
  const std::optional<double> none;
  const shapes::Triangles t = shapes::sphere(2);
  const RL::Spline_space_3 space(
      RL::Triangulated_surface_3(t.points, t.faces),
      params::cube_scale(none).joining_tolerance(std::optional<double>(0.)).depth(2));
  CHECK(space.depth() == 2);
  CHECK(space.options().cube_scale == 1.1);
  CHECK(space.options().joining_tolerance == 0.);
  RL::Function_fitter fitter(space, params::stabilization(none).smoothing(0.1).tolerance(1e-6));
  CHECK_FALSE(fitter.options().stabilization);
  CHECK(fitter.options().smoothing == 0.1);
  CHECK(fitter.options().solver.tolerance == 1e-6);
  CHECK(RL::Function_fitter(space).options().solver.tolerance ==
        RL::Function_fitter::default_tolerance);
  CHECK(fitter.fit(smooth_test_function).coefficients ==
        RL::fit_function(space, smooth_test_function, params::tolerance(1e-6).smoothing(0.1))
            .coefficients);
}

TEST_CASE("fits_do_not_depend_on_scales", "[fit]") {
  const shapes::Triangles sphere = shapes::sphere(2);
  const auto fitted = [&](double length, double value) {
    const RL::Spline_space_3 space = fitting_space(shapes::scaled(sphere, length), 2);
    const RL::Function_fit fit = RL::fit_function(
        space,
        [&](const RL::Surface_point& p) {
          return value * std::exp(p.point.x() / length) * p.normal.y();
        },
        params::smoothing(1e-3 * length * length));
    CHECK(fit.converged);
    return RL::Spline_functions_3(space, fit.coefficients).values_at_vertices().eval();
  };
  const Eigen::MatrixXd unit = fitted(1, 1);
  for(double length : {1e-60, 1e60})
    for(double value : {1e-120, 1e120})
      CHECK((fitted(length, value) / value - unit).cwiseAbs().maxCoeff() < 1e-6);
}

TEST_CASE("fits_of_bad_input_are_refused", "[fit]") {
  const RL::Spline_space_3 space = fitting_space(shapes::sphere(1), 2);
  const auto one = [](const RL::Surface_point&) { return 1.; };
  const auto refused = [&](const auto& np) {
    CHECK_THROWS_AS(RL::fit_function(space, one, np), RL::Parameter_error);
  };
  refused(params::smoothing(-1.));
  refused(params::smoothing(std::numeric_limits<double>::quiet_NaN()));
  refused(params::refinements(-1));
  refused(params::stabilization(-1.));
  refused(params::energy_tolerance(-0.1));
  refused(params::energy_tolerance(1.));
  refused(params::tolerance(0.));
  const auto nan = [](const RL::Surface_point& p) {
    return p.face == 5 ? std::numeric_limits<double>::quiet_NaN() : 1.;
  };
  CHECK_THROWS_WITH(RL::fit_function(space, nan), Catch::Contains("face 5"));
  CHECK_THROWS_AS(
      RL::fit_function(Mesh(), one, Mesh().add_property_map<Mesh::Vertex_index, double>().first),
      RL::Empty_surface_error);
}
