// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Diffusion in time: harmonics of the sphere, sources, boundaries, means, widths, and bad input.

#include "catch.h"
#include "special_shapes.h"

#include <CGAL/Restricted_laplacian_3/diffuse.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_function_3.h>

#include <Eigen/Core>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace {

namespace RL = CGAL::Restricted_laplacian_3;
namespace params = RL::parameters;
using shapes::Mesh;
using shapes::Triangles;

const double pi = std::acos(-1.);

/// the space of a unit sphere
RL::Spline_space_3 sphere_space(int depth) {
  const auto project = [](const RL::Point_3& p) {
    return CGAL::ORIGIN + (p - CGAL::ORIGIN) / std::sqrt((p - CGAL::ORIGIN).squared_length());
  };
  const Triangles t = shapes::sphere(3);
  RL::Triangulated_surface_3 surface = RL::read_surface(RL::soup(t.points, t.faces));
  RL::Spline_space_options options;
  options.depth = depth;
  RL::Smooth_geometry geometry;
  geometry.set_projection(project);
  return RL::Spline_space_3(RL::curved_surface(std::move(surface), geometry), options);
}

double legendre_2(double x) { return (3 * x * x - 1) / 2; }
double legendre_5(double x) { return (63 * std::pow(x, 5) - 70 * std::pow(x, 3) + 15 * x) / 8; }

/// the root of the mean square of a function over the surface
double norm(const RL::Diffusion_solver& solver, const Eigen::VectorXd& coefficients) {
  return std::sqrt(coefficients.dot(Eigen::VectorXd(solver.loads_of(coefficients))) /
                   solver.space().surface().area());
}

} // namespace

TEST_CASE("harmonics_decay_as_they_do_on_the_sphere", "[diffusion]") {
  const RL::Spline_space_3 space = sphere_space(5);
  // all three functions of the space are fitted by diffusion over a short time
  const auto harmonics = [](const RL::Surface_point& p) {
    return std::array<double, 3>{1 + p.point.z(), legendre_2(p.point.z()), legendre_5(p.point.z())};
  };
  const RL::Diffusion_options exactly = params::tolerance(1e-8).stabilization(1e-4);
  for(const double time : {1e-3, 0.05, 1.}) {
    const RL::Diffusion_solver solver(space, time, exactly);
    const RL::Diffused_functions u = solver.diffuse(harmonics);
    REQUIRE(u.converged);
    const Eigen::MatrixXd values =
        RL::Spline_functions_3(space, u.coefficients).values_at_vertices();
    const std::array<double, 3> decay = {std::exp(-2 * time), std::exp(-6 * time),
                                         std::exp(-30 * time)};
    double errors[3] = {0, 0, 0};
    for(Eigen::Index v = 0; v < values.rows(); ++v) {
      const RL::Point_3& p = space.surface().point(static_cast<std::size_t>(v));
      const double z = p.z() / std::sqrt((p - CGAL::ORIGIN).squared_length());
      errors[0] = (std::max)(errors[0], std::abs(values(v, 0) - 1 - decay[0] * z));
      errors[1] = (std::max)(errors[1], std::abs(values(v, 1) - decay[1] * legendre_2(z)));
      errors[2] = (std::max)(errors[2], std::abs(values(v, 2) - decay[2] * legendre_5(z)));
    }
    INFO("time " << time << ", errors " << errors[0] << ' ' << errors[1] << ' ' << errors[2]);
    // splines that are not the harmonics have a part of other harmonics, which decay more slowly
    constexpr double of_others = 2e-5;
    CHECK(errors[0] < 5e-5);
    CHECK(errors[1] < 5e-4 * decay[1] + of_others);
    CHECK(errors[2] < 5e-3 * (1 + 30 * time) * decay[2] + of_others);
  }
}

TEST_CASE("diffusion_has_the_tolerance_that_is_asked_for", "[diffusion]") {
  // rough: one on a cap, and a point of a single triangle
  const Mesh mesh = shapes::mesh(shapes::sphere(3));
  const RL::Spline_space_3 space(mesh, params::depth(4));
  const auto f = [](const RL::Surface_point& p) {
    return std::array<double, 2>{p.point.x() > 0.3 ? 1e3 : 0, p.face == 17 ? 1e-6 : 0};
  };
  for(const double time : {1e-3, 0.03, 10.}) {
    const RL::Diffusion_options finest = params::tolerance(1e-11);
    const RL::Diffusion_solver exact(space, time, finest);
    const Eigen::MatrixXd expected = exact.diffuse(f).coefficients;
    for(const double tolerance : {1e-2, 1e-5, 1e-8}) {
      const RL::Diffusion_options options = params::tolerance(tolerance);
      const RL::Diffused_functions found = RL::Diffusion_solver(space, time, options).diffuse(f);
      CHECK(found.converged);
      CHECK(found.iterations <= 5 - 3 * std::log10(tolerance));
      for(int k = 0; k < 2; ++k) {
        const Eigen::VectorXd mean = Eigen::VectorXd::Constant(
            expected.rows(),
            expected.col(k).dot(RL::assemble_element_integrals(space)) / space.surface().area());
        const double error = norm(exact, found.coefficients.col(k) - expected.col(k)),
                     size = norm(exact, expected.col(k) - mean);
        INFO("time " << time << ", tolerance " << tolerance << ", function " << k << ": "
                     << error / size << " after " << found.iterations);
        // what has decayed altogether has no digits
        CHECK(error <= 3 * tolerance * size + 1e-13 * std::abs(mean[0]));
      }
    }
  }
}

TEST_CASE("factor_and_multigrid_of_diffusion_agree", "[diffusion]") {
  // with threads, too, and with a boundary, and where there is no factor
  const Triangles t = shapes::grid(12, [](double x, double y) { return RL::Point_3(x, y, x * y); });
  const RL::Spline_space_3 space(RL::soup(t.points, t.faces), params::depth(4)),
      parallel(RL::soup(t.points, t.faces),
               params::depth(4).concurrency_tag(CGAL::Parallel_if_available_tag()));
  const auto f = [](const RL::Surface_point& p) {
    Eigen::Matrix<double, 19, 1> values; // more than are diffused at once
    for(int k = 0; k < values.size(); ++k)
      values[k] = std::cos(k * p.point.x()) + p.point.y();
    return values;
  };
  const auto one = [](const RL::Surface_point&) { return 1.; };
  const auto first = [&](const RL::Surface_point& p) { return f(p)[1]; };
  const RL::Surface_function_view boundary_values(one);
  for(const bool is_prescribed : {false, true}) {
    RL::Diffusion_options options = params::tolerance(1e-9);
    const auto apply = [&](const RL::Spline_space_3& in, bool factorize) {
      options.factorize = factorize;
      const RL::Diffusion_solver solver(in, 0.02, options,
                                        is_prescribed ? &boundary_values : nullptr);
      const RL::Diffused_functions u = is_prescribed ? solver.diffuse(first) : solver.diffuse(f);
      CHECK(u.converged);
      return u.coefficients;
    };
    const Eigen::MatrixXd of_factor = apply(space, true);
    CHECK(apply(parallel, true) == of_factor);
    CHECK((apply(space, false) - of_factor).cwiseAbs().maxCoeff() <
          2e-5 * of_factor.cwiseAbs().maxCoeff());
  }
  RL::Diffusion_options options;
  options.factorize = true;
  options.stabilization = 0;
  const RL::Spline_space_3 paper(RL::soup(t.points, t.faces), params::depth(4).paper(true));
  CHECK(RL::Diffusion_solver(paper, 0.02, options).diffuse(f).coefficients.allFinite());
}

TEST_CASE("diffusion_keeps_means_and_signs", "[diffusion]") {
  // two spheres, far from each other, and a density
  const Triangles both =
      shapes::joined(shapes::sphere(3), shapes::moved(shapes::sphere(3), {5, 0, 0}));
  const RL::Spline_space_3 plain(RL::soup(both.points, both.faces), params::depth(6));
  REQUIRE(plain.number_of_sheets(0) == 2);
  RL::Surface_material material;
  material.set_density([](const RL::Surface_point& p) { return 2 + p.point.y(); });
  const auto f = [](const RL::Surface_point& p) {
    return p.point.x() > 2.5 ? 7. : p.point.z() > 0.5 ? 1. : 0.;
  };
  for(const RL::Spline_space_3& space : {plain, plain.with_material(material)}) {
    const RL::Diffusion_solver solver(space, 0.05);
    const Eigen::VectorXd load = RL::assemble_load(space, f);
    const RL::Diffused_functions u = solver.diffuse(f);
    CHECK(u.converged);
    const Eigen::VectorXd after = solver.loads_of(u.coefficients);
    CHECK(std::abs(after.sum() / load.sum() - 1) < 1e-12);
    const std::vector<double> values =
        RL::Spline_function_3(space, u.coefficients.col(0)).values_at_vertices();
    for(std::size_t v = 0; v < values.size(); ++v)
      if(both.points[v].x() > 2.5)
        REQUIRE(std::abs(values[v] - 7) < 1e-9); // constant there
    CHECK(*std::min_element(values.begin(), values.end()) > -2e-3);
    // half of the time twice
    const RL::Diffusion_solver half(space, 0.025);
    const Eigen::MatrixXd once = half.diffuse(f).coefficients;
    const Eigen::MatrixXd twice = half.diffuse_loads(half.loads_of(once), {}).coefficients;
    CHECK(norm(solver, twice - u.coefficients) < 5e-4 * norm(solver, u.coefficients));
  }
}

TEST_CASE("diffusion_does_not_depend_on_the_unit_of_length", "[diffusion]") {
  // a box, with values of any size; what is diffused for twenty times as long has nearly decayed
  const Triangles box = shapes::box(1, 0.7, 0.4, 3, 1);
  const auto result_of = [&](double scale, double size, double time, bool is_source) {
    const Triangles t = shapes::scaled(box, scale);
    const RL::Spline_space_3 space(RL::soup(t.points, t.faces), params::depth(4));
    const auto f = [=](const RL::Surface_point& p) { return size * (p.point.x() > 0.1 * scale); };
    const auto g = [](const RL::Surface_point&) { return 0.; };
    const RL::Diffusion_solver solver(space, time * scale * scale);
    const RL::Surface_function_view source(f);
    const RL::Diffused_functions u = is_source ? solver.diffuse(g, &source) : solver.diffuse(f);
    CHECK(u.converged);
    return Eigen::VectorXd(u.coefficients.col(0) / size / (is_source ? time * scale * scale : 1));
  };
  for(const double time : {0.01, 1.})
    for(const bool is_source : {false, true}) {
      const Eigen::VectorXd expected = result_of(1, 1, time, is_source);
      for(const auto& [scale, size] :
          {std::pair(1e-6, 1.), std::pair(1e6, 1e6), std::pair(1e3, 1e-6), std::pair(1e80, 1e80),
           std::pair(1., 1e-200)})
        CHECK((result_of(scale, size, time, is_source) - expected).cwiseAbs().maxCoeff() < 1e-3);
    }
}

TEST_CASE("sources_and_boundaries_of_diffusion", "[diffusion]") {
  // on the square [0, 1]^2: u = sin(pi x) sin(pi y) e^(-2 pi^2 t) with 0 on the boundary
  const Triangles t = shapes::grid(16, [](double x, double y) { return RL::Point_3(x, y, 0); });
  const RL::Spline_space_3 space(RL::soup(t.points, t.faces), params::depth(5));
  const auto sine = [](const RL::Surface_point& p) {
    return std::sin(pi * p.point.x()) * std::sin(pi * p.point.y());
  };
  std::vector<double> values(t.points.size());
  const auto u = CGAL::make_property_map(values);
  const double time = 0.03;
  CHECK(RL::diffuse(space, sine, time, u, params::boundary_values(0)).converged);
  double error = 0;
  for(std::size_t v = 0; v < values.size(); ++v)
    error = (std::max)(
        error, std::abs(values[v] - std::exp(-2 * pi * pi * time) * std::sin(pi * t.points[v].x()) *
                                        std::sin(pi * t.points[v].y())));
  CHECK(error < 1e-3);
  // u = cos(pi x) (1 - e^(-pi^2 t)) / pi^2 + 3 t of a source, with no flux through the boundary
  const auto source = [](const RL::Surface_point& p) { return 3 + std::cos(pi * p.point.x()); };
  CHECK(RL::diffuse(space, 0., time, u, params::source_term(source)).converged);
  error = 0;
  for(std::size_t v = 0; v < values.size(); ++v)
    error = (std::max)(
        error, std::abs(values[v] - 3 * time -
                        std::cos(pi * t.points[v].x()) * -std::expm1(-pi * pi * time) / (pi * pi)));
  CHECK(error < 1e-4);
  // what is prescribed is what remains
  const auto linear = [](const RL::Surface_point& p) { return 1 + p.point.x() - 2 * p.point.y(); };
  CHECK(RL::diffuse(space, sine, 5., u, params::boundary_values(linear)).converged);
  error = 0;
  for(std::size_t v = 0; v < values.size(); ++v)
    error = (std::max)(error, std::abs(values[v] - 1 - t.points[v].x() + 2 * t.points[v].y()));
  CHECK(error < 1e-3);
}

TEST_CASE("width_of_a_diffused_point", "[diffusion]") {
  // a small square of the plane becomes a Gaussian: its second moment grows by 2 t in each axis
  const double width = 0.2, time = RL::diffusion_time(width);
  CHECK(std::abs(std::sqrt(2 * time * 8 * std::log(2.)) - width) < 1e-15);
  const Triangles t = shapes::grid(64, [](double x, double y) { return RL::Point_3(x, y, 0); });
  const RL::Spline_space_3 space(RL::soup(t.points, t.faces), params::depth(6));
  const auto f = [](const RL::Surface_point& p) {
    return std::abs(p.point.x() - 0.5) < 1. / 64 && std::abs(p.point.y() - 0.5) < 1. / 64 ? 1. : 0.;
  };
  std::vector<double> u(t.points.size());
  CHECK(RL::diffuse(space, f, time, CGAL::make_property_map(u)).converged);
  double sum = 0, moment = 0;
  for(std::size_t v = 0; v < u.size(); ++v) {
    const double x = t.points[v].x() - 0.5;
    sum += u[v];
    moment += u[v] * x * x;
  }
  const double own = 1. / 64 / 64 / 3, sigma = std::sqrt(moment / sum - own);
  INFO(sigma * std::sqrt(8 * std::log(2.)));
  CHECK(std::abs(sigma * std::sqrt(8 * std::log(2.)) / width - 1) < 0.01);
}

TEST_CASE("diffusion_of_an_accuracy_and_on_other_surfaces", "[diffusion]") {
  const Mesh mesh = shapes::mesh(shapes::sphere(4));
  std::vector<double> u(num_vertices(mesh)), of_soup(u.size());
  const auto at = boost::make_function_property_map<Mesh::Vertex_index>(
      [&](Mesh::Vertex_index v) -> double& { return u[v.idx()]; });
  const auto f = boost::make_function_property_map<Mesh::Vertex_index>(
      [&](Mesh::Vertex_index v) { return mesh.point(v).z(); });
  const RL::Solve_report report = RL::diffuse(mesh, f, 0.1, at, params::accuracy(1e-2));
  CHECK(report.converged);
  CHECK(report.estimated_error <= 1e-2);
  for(const auto v : vertices(mesh))
    REQUIRE(std::abs(u[v.idx()] - std::exp(-0.2) * mesh.point(v).z()) < 0.02);
  const Triangles t = shapes::triangles(mesh);
  const auto g = [](const RL::Surface_point& p) { return p.point.z(); };
  CHECK(RL::diffuse(RL::soup(t.points, t.faces), g, 0.1, CGAL::make_property_map(of_soup),
                    params::depth(4).concurrency_tag(CGAL::Parallel_if_available_tag()))
            .converged);
  for(std::size_t v = 0; v < u.size(); ++v)
    REQUIRE(std::abs(u[v] - of_soup[v]) < 0.02);
}

TEST_CASE("bad_diffusion_is_refused", "[diffusion]") {
  const RL::Spline_space_3 space(shapes::mesh(shapes::sphere(2)), params::depth(3));
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               infinity = std::numeric_limits<double>::infinity();
  for(const double bad : {0., -1., nan, infinity})
    CHECK_THROWS_AS(RL::Diffusion_solver(space, bad), RL::Parameter_error);
  for(const double bad : {0., 1., nan}) {
    const RL::Diffusion_options options = params::tolerance(bad);
    CHECK_THROWS_AS(RL::Diffusion_solver(space, 1, options), RL::Parameter_error);
  }
  CHECK_THROWS_AS(RL::diffusion_time(-1), RL::Parameter_error);
  CHECK_THROWS_AS(RL::diffusion_time(nan), RL::Parameter_error);
  const auto one = [](const RL::Surface_point&) { return 1.; };
  const auto two = [](const RL::Surface_point&) { return std::array<double, 2>{1, 1}; };
  const auto hole = [=](const RL::Surface_point& p) { return p.face == 3 ? nan : 1.; };
  const RL::Diffusion_solver solver(space, 1);
  CHECK_THROWS_WITH(solver.diffuse(hole), Catch::Contains("face 3"));
  const RL::Surface_function_view source(two);
  CHECK_THROWS_WITH(solver.diffuse(one, &source), Catch::Contains("source"));
  const RL::Surface_function_view values(one);
  CHECK_THROWS_WITH(RL::Diffusion_solver(space, 1, {}, &values), Catch::Contains("boundary"));
  const Triangles square = shapes::rectangle(1, 1);
  const RL::Spline_space_3 open(RL::soup(square.points, square.faces), params::depth(3));
  const RL::Surface_function_view pairs(two);
  CHECK_THROWS_WITH(RL::Diffusion_solver(open, 1, {}, &pairs), Catch::Contains("2 components"));
  CHECK_THROWS_AS(solver.diffuse(one, nullptr, [](double) { return false; }), RL::Canceled);
  // constants stay
  const RL::Diffused_functions u = solver.diffuse(one);
  CHECK(u.converged);
  CHECK((u.coefficients.array() - 1).abs().maxCoeff() < 1e-12);
}
