// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Prescribed values: along the boundary, at vertices, and by weights.

#include "catch.h"
#include "special_shapes.h"

#include <CGAL/Restricted_laplacian_3/assembly/Boundary_integration.h>
#include <CGAL/Restricted_laplacian_3/assembly/Dirichlet_boundary.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/symmetric_eigenpairs.h>
#include <CGAL/Restricted_laplacian_3/solve_poisson.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

namespace {

namespace RL = CGAL::Restricted_laplacian_3;
namespace params = RL::parameters;
using shapes::Mesh;
using shapes::Triangles;

/// the unit square in a plane that is parallel to no axis
struct Tilted_square {
  RL::Vector_3 x{0.36, -0.8, 0.48}, y{0.48, 0.6, 0.64};
  Triangles triangles;

  explicit Tilted_square(int n) {
    const auto m = static_cast<std::uint32_t>(n + 1);
    for(std::uint32_t j = 0; j < m; ++j)
      for(std::uint32_t i = 0; i < m; ++i)
        triangles.points.push_back(CGAL::ORIGIN + x * (double(i) / n) + y * (double(j) / n));
    for(std::uint32_t j = 0; j + 1 < m; ++j)
      for(std::uint32_t i = 0; i + 1 < m; ++i) {
        const std::uint32_t a = j * m + i;
        triangles.faces.push_back({a, a + 1, a + m + 1});
        triangles.faces.push_back({a, a + m + 1, a + m});
      }
  }
  std::array<double, 2> coordinates(const RL::Point_3& p) const {
    return {(p - CGAL::ORIGIN) * x, (p - CGAL::ORIGIN) * y};
  }
  double solution(const RL::Point_3& p) const {
    const auto [a, b] = coordinates(p);
    return std::exp(a) * std::sin(b) + a * a * a;
  }
  double laplacian(const RL::Point_3& p) const { return 6 * coordinates(p)[0]; }
};

} // namespace

TEST_CASE("boundary_values_are_met_with_order_three", "[constraints]") {
  const Tilted_square square(12);
  const auto f = [&](const RL::Surface_point& p) { return square.laplacian(p.point); };
  const auto g = [&](const RL::Surface_point& p) { return square.solution(p.point); };
  std::vector<double> errors, boundary_errors;
  for(int depth = 3; depth <= 5; ++depth) {
    const RL::Spline_space_3 space(RL::soup(square.triangles.points, square.triangles.faces),
                                   params::depth(depth));
    const RL::Dirichlet_boundary boundary(space);
    CHECK(boundary.length() == Approx(4).epsilon(1e-12));
    const RL::Operators operators = RL::assemble_operators(space);
    RL::Sparse_matrix a = operators.stiffness;
    boundary.add_to_matrix(a);
    CHECK(RL::Sparse_matrix(a - RL::Sparse_matrix(a.transpose())).norm() <= 1e-14 * a.norm());
    // definite, up to what the common near-kernel of all matrices leaves
    const Eigen::VectorXd scale = a.diagonal().cwiseSqrt().cwiseInverse();
    if(depth == 3) {
      const Eigen::MatrixXd scaled = scale.asDiagonal() * Eigen::MatrixXd(a) * scale.asDiagonal();
      CHECK(RL::internal::symmetric_eigenpairs(scaled, "a").values[0] >= -1e-10);
    }
    const RL::Poisson_solver solver(space, a, operators.mass * Eigen::VectorXd::Ones(a.cols()), 0,
                                    params::tolerance(1e-8));
    CHECK(solver.kernel_dimension() == 0);
    CHECK(a.nonZeros() == operators.stiffness.nonZeros()); // of which the solver has a copy
    static_cast<void>(RL::Poisson_solver(space, std::move(a), solver.upper_half().diagonal()));
    CHECK(a.size() == 0);
    Eigen::VectorXd eta;
    CHECK(solver.solve(boundary.load(g) - RL::assemble_load(space, f), eta).converged);
    boundary_errors.push_back(boundary.root_mean_square_error(eta, g));
    const RL::Spline_function_3 u(space, eta);
    double sum = 0;
    const auto values = u.values_at_vertices();
    for(std::size_t v = 0; v < values.size(); ++v)
      sum += std::pow(values[v] - square.solution(square.triangles.points[v]), 2);
    errors.push_back(std::sqrt(sum / double(values.size())));
  }
  INFO("errors " << errors[0] << " " << errors[1] << " " << errors[2] << ", at the boundary "
                 << boundary_errors[0] << " " << boundary_errors[1] << " " << boundary_errors[2]);
  CHECK(std::log2(errors[0] / errors[2]) / 2 >= 2.7);
  CHECK(std::log2(boundary_errors[0] / boundary_errors[2]) / 2 >= 2.3); // 2.5 in theory
}

TEST_CASE("boundary_values_through_named_parameters", "[constraints]") {
  const Tilted_square square(8);
  Mesh mesh = shapes::mesh(square.triangles);
  auto g = mesh.add_property_map<Mesh::Vertex_index, double>("v:g").first;
  auto u = mesh.add_property_map<Mesh::Vertex_index, double>("v:u").first;
  // a linear function is in the space, and harmonic
  for(Mesh::Vertex_index v : mesh.vertices())
    g[v] = 1 + 2 * mesh.point(v).x() - mesh.point(v).y() + mesh.point(v).z();
  const auto zero = [](const RL::Surface_point&) { return 0.; };
  const RL::Solve_report report =
      RL::solve_poisson(mesh, zero, u, params::depth(4).boundary_values(g));
  CHECK(report.converged);
  CHECK(report.relative_residual <= 1e-6);
  for(Mesh::Vertex_index v : mesh.vertices())
    REQUIRE(u[v] == Approx(g[v]).margin(1e-5));

  // with screening: u - 0.1 Laplacian u = g is solved by g as well
  static_cast<void>(RL::solve_screened_poisson(
      mesh, boost::make_function_property_map<Mesh::Vertex_index>([&](Mesh::Vertex_index v) {
        return 10 * g[v];
      }),
      10., u, params::depth(4).boundary_values(g)));
  for(Mesh::Vertex_index v : mesh.vertices())
    REQUIRE(u[v] == Approx(g[v]).margin(1e-5));

  Mesh closed = shapes::mesh(shapes::sphere(2));
  auto w = closed.add_property_map<Mesh::Vertex_index, double>("v:w").first;
  CHECK_THROWS_AS(RL::solve_poisson(closed, zero, w, params::depth(3).boundary_values(zero)),
                  RL::Parameter_error);
}

TEST_CASE("components_without_boundary_keep_their_mean", "[constraints]") {
  const Tilted_square square(4);
  const Triangles t =
      shapes::joined(square.triangles, shapes::moved(shapes::sphere(4), {2.5, 0, 0}));
  const auto on_sphere = [](const RL::Surface_point& p) { return p.point.x() > 1.2; };
  const auto f = [&](const RL::Surface_point& p) { return on_sphere(p) ? p.point.z() : 0.; };
  const auto g = [](const RL::Surface_point&) { return 7.; };
  std::vector<double> u(t.points.size());
  const RL::Solve_report report =
      RL::solve_poisson(RL::soup(t.points, t.faces), f, CGAL::make_property_map(u),
                        params::depth(5).boundary_values(g));
  CHECK(report.converged);
  for(std::size_t i = 0; i < u.size(); ++i)
    REQUIRE(u[i] ==
            Approx(i < square.triangles.points.size() ? 7 : -t.points[i].z() / 2).margin(5e-3));
}

TEST_CASE("values_at_vertices_are_held", "[constraints]") {
  // two poles of a sphere: the solution is odd, and between the two values
  const Triangles sphere = shapes::sphere(3);
  Mesh mesh = shapes::mesh(sphere);
  auto u = mesh.add_property_map<Mesh::Vertex_index, double>("v:u").first;
  auto value = mesh.add_property_map<Mesh::Vertex_index, double>("v:g", std::nan("")).first;
  const Mesh::Vertex_index north(4), south(5);
  value[north] = 3;
  value[south] = -1;
  const auto zero = [](const RL::Surface_point&) { return 0.; };
  double last_miss = 1;
  for(double weight : {1e1, 1e2, 1e4}) {
    const RL::Solve_report report = RL::solve_poisson(
        mesh, zero, u, params::depth(3).constraints(value).constraint_weight(weight));
    CHECK(report.converged);
    const double miss = std::abs(u[north] - 3);
    CHECK(miss <= 0.5 * last_miss);
    CHECK(miss <= 20 / weight);
    last_miss = miss;
    for(Mesh::Vertex_index v : mesh.vertices()) {
      REQUIRE(u[v] <= 3);
      REQUIRE(u[v] >= -1);
      const RL::Point_3 p = mesh.point(v);
      if(p.z() == 0)
        REQUIRE(u[v] == Approx(1).margin(5e-3));
    }
  }
  value[south] = std::numeric_limits<double>::infinity();
  CHECK_THROWS_WITH(
      static_cast<void>(RL::solve_poisson(mesh, zero, u, params::depth(3).constraints(value))),
      Catch::Contains("constraints has an infinite value at vertex 5"));
  const RL::Spline_space_3 space(mesh, params::depth(3));
  RL::Point_constraints constraints(space);
  RL::Surface_location nowhere;
  nowhere.face = 1000000;
  CHECK_THROWS_AS(constraints.add(nowhere, 1, 1), RL::Location_error);
  CHECK_THROWS_AS(constraints.add(RL::Surface_location(), 1, -1), RL::Parameter_error);
  CHECK_THROWS_AS(constraints.add(RL::Surface_location(), std::nan(""), 1), RL::Parameter_error);
  CHECK(constraints.size() == 0);
}

TEST_CASE("a_value_at_one_vertex_fixes_the_constant_only", "[constraints]") {
  const Triangles sphere = shapes::sphere(3);
  const auto f = [](const RL::Surface_point& p) { return p.point.z(); };
  for(const int depth : {3, 4}) {
    const RL::Spline_space_3 space(RL::soup(sphere.points, sphere.faces), params::depth(depth));
    std::vector<double> expected;
    for(const double g : {0., 1., 100., 1e4, 1e8}) {
      RL::Poisson_problem problem(f);
      problem.vertex_values.assign(sphere.points.size(), std::nan(""));
      problem.vertex_values[7] = g;
      const RL::Poisson_solution solution = RL::solve_poisson_problem(space, problem);
      CHECK(solution.converged);
      CHECK(solution.constraint_error <= 1e-7);
      const std::vector<double> u =
          RL::Spline_function_3(space, solution.coefficients).values_at_vertices();
      CHECK(std::abs(u[7] - g) <= 1e-7);
      if(g == 0)
        expected = u;
      CAPTURE(depth, g);
      double change = 0, error = 0;
      for(std::size_t v = 0; v < u.size(); ++v) {
        change = (std::max)(change, std::abs(u[v] - g - expected[v]));
        error = (std::max)(error,
                           std::abs(u[v] - g + (sphere.points[v].z() - sphere.points[7].z()) / 2));
      }
      CHECK(change <= (g <= 1e4 ? 1e-6 : 2e-4));
      CHECK(error <= 0.02); // of the polyhedron
    }
  }
}

TEST_CASE("equal_values_at_vertices_give_a_constant", "[constraints]") {
  const Triangles sphere = shapes::sphere(3);
  const auto f = [](const RL::Surface_point&) { return 0.; };
  const RL::Spline_space_3 space(RL::soup(sphere.points, sphere.faces), params::depth(4));
  for(const double g : {0., 1. / 3, -1e6})
    for(const std::size_t step : {1, 7, 1000}) {
      RL::Poisson_problem problem(f);
      problem.vertex_values.assign(sphere.points.size(), std::nan(""));
      for(std::size_t v = 0; v < sphere.points.size(); v += step)
        problem.vertex_values[v] = g;
      const RL::Poisson_solution solution = RL::solve_poisson_problem(space, problem);
      CAPTURE(g, step);
      CHECK(solution.converged);
      CHECK(solution.constraint_error <= 1e-12 * std::abs(g));
      for(const double u : RL::Spline_function_3(space, solution.coefficients).values_at_vertices())
        REQUIRE(std::abs(u - g) <= 1e-10 * std::abs(g));
    }
}

TEST_CASE("iterations_with_prescribed_values_are_limited", "[constraints]") {
  const Triangles sphere = shapes::sphere(3);
  const auto f = [](const RL::Surface_point& p) { return p.point.z(); };
  const RL::Spline_space_3 space(RL::soup(sphere.points, sphere.faces), params::depth(4));
  RL::Poisson_problem problem(f);
  problem.vertex_values.assign(sphere.points.size(), std::nan(""));
  problem.vertex_values[7] = 1;
  for(const int limit : {0, 1, 2}) {
    problem.solver.maximum_iterations = limit;
    const RL::Poisson_solution solution = RL::solve_poisson_problem(space, problem);
    CAPTURE(limit);
    CHECK(solution.status == RL::Solve_status::iteration_limit);
    CHECK(solution.iterations < 2 * limit + 1); // the last step may begin below the limit
  }
}

TEST_CASE("boundary_values_may_have_an_offset", "[constraints]") {
  const Triangles square =
      shapes::grid(16, [](double x, double y) { return RL::Point_3(x, y, 0); });
  const auto zero = [](const RL::Surface_point&) { return 0.; };
  for(const double offset : {0., -1., 1e6}) {
    const auto g = [&](const RL::Surface_point& p) { return p.point.x() * p.point.y() + offset; };
    std::vector<double> u(square.points.size());
    const RL::Solve_report report =
        RL::solve_poisson(RL::soup(square.points, square.faces), zero, CGAL::make_property_map(u),
                          params::depth(5).boundary_values(g));
    CHECK(report.converged);
    CHECK(report.constraint_error == 0);
    for(std::size_t v = 0; v < u.size(); ++v) {
      const RL::Point_3& p = square.points[v];
      REQUIRE(std::abs(u[v] - offset - p.x() * p.y()) <= 1e-4);
    }
  }
}

TEST_CASE("values_at_vertices_hold_along_the_boundary", "[constraints]") {
  constexpr int n = 16;
  const Triangles square =
      shapes::joined(shapes::grid(n, [](double x, double y) { return RL::Point_3(x, y, 0); }),
                     shapes::moved(shapes::sphere(3), {3, 0, 0}));
  constexpr std::size_t on_square = (n + 1) * (n + 1);
  const auto f = [](const RL::Surface_point& p) { return p.point.x() > 1.5 ? p.point.z() : 0.; };
  for(const int depth : {4, 5, 6}) {
    const RL::Spline_space_3 space(RL::soup(square.points, square.faces), params::depth(depth));
    RL::Poisson_problem problem(f);
    problem.vertex_values.assign(square.points.size(), std::nan(""));
    for(std::size_t j = 0; j <= n; ++j) {
      problem.vertex_values[j * (n + 1)] = 0;
      problem.vertex_values[j * (n + 1) + n] = 1000;
    }
    const RL::Poisson_solution solution = RL::solve_poisson_problem(space, problem);
    CAPTURE(depth);
    CHECK(solution.converged);
    CHECK(solution.constraint_error <= 1e-3);
    CHECK(solution.kernel_dimension == 1);
    const std::vector<double> u =
        RL::Spline_function_3(space, solution.coefficients).values_at_vertices();
    double error = 0, error_on_sphere = 0;
    for(std::size_t v = 0; v < u.size(); ++v)
      if(v < on_square)
        error = (std::max)(error, std::abs(u[v] - 1000 * square.points[v].x()));
      else
        error_on_sphere = (std::max)(error_on_sphere, std::abs(u[v] + square.points[v].z() / 2));
    CHECK(error <= 1e-3);
    CHECK(error_on_sphere <= 0.02); // mean 0 there, as without the square
  }
}

TEST_CASE("values_may_be_prescribed_on_a_part_of_the_boundary", "[constraints]") {
  const Tilted_square square(8);
  const RL::Spline_space_3 space(RL::soup(square.triangles.points, square.triangles.faces),
                                 params::depth(4));
  const auto is_left = [&](const RL::Surface_point& p) {
    return square.coordinates(p.point)[0] < 1e-9;
  };
  const RL::Dirichlet_boundary left(RL::Boundary_integration(space, is_left));
  CHECK(left.length() == Approx(1).epsilon(1e-12));
  CHECK(left.mean([&](const RL::Surface_point& p) { return square.coordinates(p.point)[1]; }) ==
        Approx(0.5).epsilon(1e-12));
  const auto nowhere = [](const RL::Surface_point&) { return false; };
  const RL::Dirichlet_boundary none(RL::Boundary_integration(space, nowhere));
  CHECK(none.length() == 0);
  CHECK(none.mean([](const RL::Surface_point&) { return 1.; }) == 0);
}

TEST_CASE("values_at_vertices_are_exact_where_functions_have_them", "[constraints]") {
  const Triangles sphere = shapes::sphere(3);
  const auto f = [](const RL::Surface_point& p) { return p.point.x(); };
  std::mt19937 generator(1);
  for(const int depth : {3, 4, 5})
    for(const double scale : {1e-6, 1., 1e6})
      for(const double alpha : {0., 3.}) {
        const RL::Spline_space_3 space(RL::soup(sphere.points, sphere.faces), params::depth(depth));
        RL::Poisson_problem problem(f);
        problem.alpha = alpha;
        problem.vertex_values.assign(sphere.points.size(), std::nan(""));
        for(std::size_t v = 0; v < sphere.points.size(); v += 30)
          problem.vertex_values[v] = scale * (5 + std::ldexp(double(generator()), -32));
        const RL::Poisson_solution solution = RL::solve_poisson_problem(space, problem);
        const std::vector<double> u =
            RL::Spline_function_3(space, solution.coefficients).values_at_vertices();
        double missed = 0;
        for(std::size_t v = 0; v < u.size(); v += 30)
          missed = (std::max)(missed, std::abs(u[v] - problem.vertex_values[v]));
        CAPTURE(depth, scale, alpha, solution.iterations);
        CHECK(solution.converged);
        CHECK(missed == Approx(solution.constraint_error).margin(1e-15 * scale));
        CHECK(missed <= 1e-6 * (std::max)(scale, 1.)); // or of the solution for f
        CHECK(solution.iterations <= 60);
      }
}

TEST_CASE("values_with_a_weight_pull_beside_exact_ones", "[constraints]") {
  const Triangles sphere = shapes::sphere(3);
  const RL::Spline_space_3 space(RL::soup(sphere.points, sphere.faces), params::depth(3));
  const std::vector<RL::Surface_location> locations =
      RL::internal::locations_of_vertices(space.surface());
  RL::Point_constraints constraints(space);
  constraints.add(locations[4], 3);
  constraints.add(locations[5], -1, 10);
  CHECK(constraints.is_exact(0));
  CHECK_FALSE(constraints.is_exact(1));
  CHECK(constraints.weights() == Eigen::Vector2d(RL::Point_constraints::weight_of_exact, 10));
  CHECK(constraints.values() == Eigen::Vector2d(3, -1));
  const auto f = [](const RL::Surface_point&) { return 0.; };
  RL::Poisson_problem problem(f);
  problem.constraints = constraints;
  const RL::Poisson_solution solution = RL::solve_poisson_problem(space, problem);
  CHECK(solution.converged);
  const Eigen::VectorXd u = constraints.values_of(solution.coefficients);
  CHECK(std::abs(u[0] - 3) <= 1e-6);
  CHECK(u[1] > -1);
  // the fluxes are opposite, with weights all values pull: the same problem but for what is exact
  problem.constraints.reset();
  problem.vertex_values.assign(sphere.points.size(), std::nan(""));
  problem.vertex_values[4] = 3;
  problem.vertex_values[5] = -1;
  problem.vertex_weight = 10;
  const Eigen::VectorXd pulled =
      constraints.values_of(RL::solve_poisson_problem(space, problem).coefficients);
  CHECK(3 - pulled[0] == Approx(pulled[1] + 1).epsilon(1e-5));
  const double flux = 10 * (u[1] + 1), flux_of_pulled = 10 * (pulled[1] + 1);
  CHECK((u[0] - u[1]) / flux == Approx((pulled[0] - pulled[1]) / flux_of_pulled).epsilon(1e-5));
}

TEST_CASE("values_at_vertices_that_no_function_has_are_told_of", "[constraints]") {
  const Triangles sphere = shapes::sphere(4);
  const RL::Spline_space_3 space(RL::soup(sphere.points, sphere.faces), params::depth(2));
  const auto f = [](const RL::Surface_point&) { return 0.; };
  RL::Poisson_problem problem(f);
  for(std::size_t v = 0; v < sphere.points.size(); ++v)
    problem.vertex_values.push_back(double(v % 2));
  const RL::Poisson_solution noise = RL::solve_poisson_problem(space, problem);
  CHECK_FALSE(noise.converged);
  CHECK(noise.status == RL::Solve_status::stalled);
  CHECK(noise.constraint_error > 0.3);
  CHECK(noise.constraint_error < 2);
  // denser than the functions, and one of them has the values
  for(std::size_t v = 0; v < sphere.points.size(); ++v)
    problem.vertex_values[v] = 1e3 * sphere.points[v].x();
  const RL::Poisson_solution linear = RL::solve_poisson_problem(space, problem);
  CHECK(linear.converged);
  CHECK(linear.constraint_error <= 2e-3);
  problem.vertex_values.pop_back();
  CHECK_THROWS_AS(RL::solve_poisson_problem(space, problem), RL::Parameter_error);
}

TEST_CASE("weights_pull_the_solution", "[constraints]") {
  const Triangles sphere = shapes::sphere(4);
  const auto np = params::depth(4).tolerance(1e-5);
  std::vector<double> by_number(sphere.points.size()), by_map = by_number, pulled = by_number;
  const auto f = [](const RL::Surface_point& p) { return 8 * p.point.z(); };
  static_cast<void>(RL::solve_screened_poisson(RL::soup(sphere.points, sphere.faces), f, 2.,
                                               CGAL::make_property_map(by_number), np));
  std::vector<double> twos(sphere.points.size(), 2);
  static_cast<void>(RL::solve_screened_poisson(RL::soup(sphere.points, sphere.faces), f,
                                               CGAL::make_property_map(twos),
                                               CGAL::make_property_map(by_map), np));
  for(std::size_t i = 0; i < by_map.size(); ++i) {
    // 2 u - Laplacian u = 8 z: u = 2 z
    REQUIRE(by_number[i] == Approx(2 * sphere.points[i].z()).margin(0.02));
    REQUIRE(by_map[i] == Approx(by_number[i]).margin(1e-4));
  }
  // strong weights on the upper half only: u is g there, and harmonic below
  const auto weight = [](const RL::Surface_point& p) { return p.point.z() > 0 ? 1e5 : 0.; };
  const auto weighted_g = [&](const RL::Surface_point& p) { return weight(p) * (1 + p.point.x()); };
  const RL::Solve_report report =
      RL::solve_screened_poisson(RL::soup(sphere.points, sphere.faces), weighted_g, weight,
                                 CGAL::make_property_map(pulled), np);
  CHECK(report.converged);
  for(std::size_t i = 0; i < pulled.size(); ++i) {
    const RL::Point_3& p = sphere.points[i];
    if(p.z() > 0.2)
      REQUIRE(pulled[i] == Approx(1 + p.x()).margin(0.02));
    if(p.z() < -0.95)
      REQUIRE(pulled[i] == Approx(1).margin(0.2));
  }
  for(double bad : {-1., std::nan("")})
    CHECK_THROWS_AS(RL::solve_screened_poisson(
                        RL::soup(sphere.points, sphere.faces), f,
                        [bad](const RL::Surface_point&) { return bad; },
                        CGAL::make_property_map(pulled), params::depth(2)),
                    RL::Parameter_error);
}
