// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Surfaces that move: the metric of a moved surface, shrinking spheres, the conformal flow,
// boundaries, collapse, and bad input.

#include "catch.h"
#include "special_shapes.h"

#include <CGAL/Restricted_laplacian_3/fit_function.h>
#include <CGAL/Restricted_laplacian_3/laplace_spectrum.h>
#include <CGAL/Restricted_laplacian_3/mean_curvature_flow.h>
#include <CGAL/Restricted_laplacian_3/patches/curved_surface.h>
#include <CGAL/Restricted_laplacian_3/spherical_parameterization.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace RL = CGAL::Restricted_laplacian_3;
namespace params = RL::parameters;
using shapes::Mesh;
using shapes::Triangles;

const double half_turn = std::acos(-1.);

/// the mean distance of the vertices from the origin
double mean_radius(const RL::Mean_curvature_flow& flow) {
  return flow.vertex_positions().rowwise().norm().mean();
}

RL::Spline_space_3 flow_space(const Triangles& t, int depth) {
  return RL::Spline_space_3(RL::soup(t.points, t.faces), params::depth(depth));
}

/// a sphere, and not its facets
RL::Spline_space_3 round_sphere(double radius, int depth) {
  const auto project = [radius](const RL::Point_3& p) {
    return CGAL::ORIGIN +
           (p - CGAL::ORIGIN) * (radius / std::sqrt((p - CGAL::ORIGIN).squared_length()));
  };
  const Triangles t = shapes::scaled(shapes::sphere(3), radius);
  RL::Smooth_geometry geometry;
  geometry.set_projection(project);
  RL::Spline_space_options options;
  options.depth = depth;
  return RL::Spline_space_3(
      RL::curved_surface(RL::read_surface(RL::soup(t.points, t.faces)), geometry), options);
}

/// a torus whose tube has the radius 0.25
Triangles thin_torus() {
  Triangles t = shapes::grid(48, [](double x, double y) {
    const double u = 2 * half_turn * x, v = 2 * half_turn * y;
    return RL::Point_3((1 + 0.25 * std::cos(v)) * std::cos(u),
                       (1 + 0.25 * std::cos(v)) * std::sin(u), 0.25 * std::sin(v));
  });
  return t;
}

/// two balls with a thin neck between them
Triangles dumbbell() {
  Triangles t = shapes::sphere(4);
  for(RL::Point_3& p : t.points) {
    const double r = 0.2 + 0.8 * std::pow(std::abs(p.x()), 1.5),
                 s = std::sqrt(p.y() * p.y() + p.z() * p.z());
    const double profile = s * r * 1.2;
    const double factor = s > 0 ? profile / s : 1;
    p = RL::Point_3(2 * p.x(), factor * p.y(), factor * p.z());
  }
  return t;
}

} // namespace

TEST_CASE("moved_surface_has_its_own_metric", "[flow]") {
  // the square, bent to a wave: its spectrum is that of the wave, integrated over its own triangles
  const auto wave = [](double x, double y) {
    return RL::Point_3(x, y, 0.2 * std::sin(2 * half_turn * x) + 0.1 * x * y);
  };
  const Triangles flat = shapes::grid(40, [](double x, double y) { return RL::Point_3(x, y, 0); });
  const Triangles bent = shapes::grid(40, wave);
  const RL::Spline_space_3 space = flow_space(flat, 5);
  const RL::Function_fit fit = RL::Function_fitter(space).fit(
      [&](const RL::Surface_point& p) { return wave(p.point.x(), p.point.y()) - CGAL::ORIGIN; });
  const RL::Spline_space_3 moved =
      space.integrated_by(RL::Moved_integration(space, fit.coefficients));
  const Eigen::VectorXd expected = RL::laplace_spectrum(flow_space(bent, 5), 8).eigenvalues,
                        found = RL::laplace_spectrum(moved, 8).eigenvalues,
                        other = RL::laplace_spectrum(space, 8).eigenvalues;
  for(int i = 1; i < 8; ++i) {
    INFO(i << ": " << found[i] << " and " << expected[i]);
    CHECK(std::abs(found[i] / expected[i] - 1) < 4e-3);
  }
  CHECK(std::abs(other[1] / expected[1] - 1) > 0.1);
  CHECK(std::abs(RL::assemble_mass_matrix(moved).sum() / flow_space(bent, 5).surface().area() - 1) <
        2e-3);
  // the other metric has the energy of the square, and the area of the wave
  const RL::Spline_space_3 conformal = space.integrated_by(
      RL::Moved_integration(space, fit.coefficients, RL::Moved_metric::conformal));
  const RL::Operators of_conformal = RL::assemble_operators(conformal);
  CHECK((of_conformal.stiffness - RL::assemble_operators(space).stiffness).norm() <
        1e-3 * of_conformal.stiffness.norm());
  CHECK(std::abs(of_conformal.mass.sum() / RL::assemble_mass_matrix(moved).sum() - 1) < 1e-12);
  CHECK_THROWS_AS(RL::Moved_integration(space, fit.coefficients.leftCols(2)), RL::Parameter_error);
  Eigen::MatrixXd bad = fit.coefficients;
  bad(3, 1) = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(RL::Moved_integration(space, bad), RL::Parameter_error);
}

TEST_CASE("sphere_shrinks_as_it_should", "[flow]") {
  // r^2 = 1 - 4 t, and the error is of first order in the step, in any unit of length
  for(const double unit : {1e-6, 1e6}) {
    const RL::Spline_space_3 space = round_sphere(unit, 3);
    std::vector<double> errors;
    const double end = 0.12;
    for(const int steps : {8, 16}) {
      RL::Mean_curvature_flow flow(space);
      for(int i = 0; i < steps; ++i) {
        const RL::Flow_report report = flow.step(end / steps * unit * unit);
        REQUIRE(report.converged);
        REQUIRE(report.collapse.empty());
      }
      CHECK(std::abs(flow.time() / (end * unit * unit) - 1) < 1e-12);
      errors.push_back(mean_radius(flow) / unit - std::sqrt(1 - 4 * end));
    }
    INFO("errors " << errors[0] << ' ' << errors[1]);
    CHECK(errors[0] < 0.02);
    CHECK(std::abs(errors[0] / errors[1] - 2) < 0.25);
  }
  // a thousandth, until half of the area is gone
  RL::Mean_curvature_flow flow(round_sphere(1, 3));
  for(int i = 0; i < 250; ++i)
    REQUIRE(flow.step(0.0005).converged);
  CHECK(std::abs(mean_radius(flow) / std::sqrt(0.5) - 1) < 1e-3);
}

TEST_CASE("conformal_flow_makes_spheres", "[flow]") {
  Triangles t = shapes::sphere(4);
  for(RL::Point_3& p : t.points)
    p = RL::Point_3(2 * p.x() + 0.3 * p.y() * p.y(), p.y(), 0.5 * p.z() + 5);
  for(const bool is_parallel : {false, true}) {
    RL::Spline_space_options options;
    options.depth = 4;
    options.is_parallel = is_parallel;
    const RL::Spline_space_3 space(RL::read_surface(RL::soup(t.points, t.faces)), options);
    const double area = space.surface().area();
    RL::Mean_curvature_flow flow(space, params::conformal(true));
    RL::Flow_report report;
    for(int i = 0; i < 40; ++i) {
      report = flow.step(0.02 * area);
      REQUIRE(report.converged);
    }
    CHECK(report.sphere_deviation < 2e-3);
    CHECK(report.mean_distortion < 1.01);
    CHECK(std::abs(report.area / area - 1) < 1e-9);
    CHECK(std::abs(report.volume / (std::pow(area, 1.5) / 6 / std::sqrt(half_turn)) - 1) < 0.01);
    CHECK(report.largest_distortion >= report.mean_distortion);
    CHECK((report.smallest_angle > 5 && report.smallest_angle < 60));
    static Eigen::MatrixXd of_one_thread;
    if(is_parallel)
      CHECK(flow.vertex_positions() == of_one_thread);
    of_one_thread = flow.vertex_positions();
    CHECK(flow.positions().number_of_functions() == 3);
    CHECK(flow.coefficients().rows() == static_cast<Eigen::Index>(space.dimension()));
    CHECK(flow.space().depth() == 4);
    // the moved surface is a sphere: its eigenvalues are l (l + 1) / r^2
    const double unit = 4 * half_turn / area;
    const Eigen::VectorXd values = RL::laplace_spectrum(flow.moved_space(), 4).eigenvalues;
    CHECK(std::abs(values[1] / (2 * unit) - 1) < 0.01);
    CHECK(std::abs(values[3] / (2 * unit) - 1) < 0.01);
  }
}

TEST_CASE("flows_that_end_and_flows_that_pass", "[flow]") {
  // the tube of a torus has the radius sqrt(r^2 - 2 t), or nearly so
  const Triangles ring = thin_torus();
  const RL::Spline_space_3 space(RL::soup(ring.points, ring.faces),
                                 params::depth(5).joining_tolerance(1e-9));
  RL::Mean_curvature_flow flow(space);
  RL::Flow_report report;
  int steps = 0;
  for(; steps < 100 && report.collapse.empty(); ++steps)
    report = flow.step(2e-3);
  INFO("torus: " << flow.time() << ", " << report.collapse);
  CHECK(report.collapse.find("face") != std::string::npos);
  CHECK(std::abs(flow.time() - 0.25 * 0.25 / 2) < 8e-3);
  CHECK(flow.vertex_positions().allFinite());
  const Eigen::MatrixXd last = flow.vertex_positions();
  CHECK(!flow.step(2e-3).collapse.empty());
  CHECK(flow.vertex_positions() == last); // the last good state
  // a dumbbell breaks, and passes conformally
  const RL::Spline_space_3 bell = flow_space(dumbbell(), 5);
  RL::Mean_curvature_flow plain(bell), conformal(bell, params::conformal(true));
  report = RL::Flow_report();
  for(int i = 0; i < 200 && report.collapse.empty(); ++i)
    report = plain.step(4e-3);
  CHECK(!report.collapse.empty());
  CHECK(report.area > 0.2 * bell.surface().area()); // the balls are still there
  for(int i = 0; i < 40; ++i)
    report = conformal.step(0.04 * bell.surface().area());
  CHECK(report.collapse.empty());
  INFO("deviation " << report.sphere_deviation);
  CHECK(report.sphere_deviation < 0.02);
}

TEST_CASE("a_fixed_boundary_does_not_hide_how_far_a_flow_converged", "[flow]") {
  // its penalty dominates the residual
  const Triangles t = shapes::grid(60, [](double x, double y) {
    return RL::Point_3(x, y,
                       0.2 * std::sin(half_turn * x) * std::sin(half_turn * y) +
                           0.02 * std::sin(40 * x) * std::cos(33 * y));
  });
  const RL::Spline_space_3 space = flow_space(t, 6);
  RL::Mean_curvature_flow usual(space), exact(space, params::tolerance(1e-10));
  CHECK(usual.step(0.05).converged);
  exact.step(0.05);
  const double not_converged =
      (usual.vertex_positions() - exact.vertex_positions()).rowwise().norm().maxCoeff();
  INFO("not converged " << not_converged);
  CHECK(not_converged < 5e-6);
}

TEST_CASE("boundaries_and_volumes_of_flows", "[flow]") {
  // a bent square becomes flat, with its boundary where it was
  const Triangles t = shapes::grid(12, [](double x, double y) {
    return RL::Point_3(x, y, 0.2 * std::sin(half_turn * x) * std::sin(half_turn * y));
  });
  const RL::Spline_space_3 space = flow_space(t, 4);
  RL::Mean_curvature_flow fixed(space), free(space, params::fixed_boundary(false));
  RL::Flow_report report;
  for(int i = 0; i < 30; ++i)
    report = fixed.step(0.05);
  CHECK(report.collapse.empty());
  CHECK(report.volume == 0);
  for(std::size_t v = 0; v < t.points.size(); ++v) {
    const auto p = fixed.vertex_positions().row(static_cast<Eigen::Index>(v));
    REQUIRE(std::abs(p[2]) < 0.01);
    const RL::Point_3& q = t.points[v];
    if(q.x() == 0 || q.y() == 1)
      REQUIRE((p - Eigen::RowVector3d(q.x(), q.y(), q.z())).norm() < 5e-3);
  }
  CHECK(std::abs(report.area - 1) < 5e-3);
  for(int i = 0; i < 3; ++i)
    CHECK(free.step(0.02).converged);
  CHECK(free.vertex_positions().col(0).maxCoeff() < 0.97);
  CHECK_THROWS_AS(RL::Mean_curvature_flow(space, params::rescaling(RL::Rescaling::volume)),
                  RL::Input_error);
  RL::Mean_curvature_flow_options loose;
  loose.tolerance = 2;
  CHECK_THROWS_AS(RL::Mean_curvature_flow(space, loose), RL::Parameter_error);
  // volumes
  const RL::Spline_space_3 ball = flow_space(shapes::box(1, 0.8, 0.6, 6, 1), 4);
  RL::Mean_curvature_flow flow(ball, params::rescaling(RL::Rescaling::volume));
  report = flow.step(0.01);
  CHECK(std::abs(report.volume / 0.48 - 1) < 1e-9);
  CHECK(report.area < ball.surface().area());
}

TEST_CASE("flow_of_meshes_by_one_call", "[flow]") {
  Mesh mesh = shapes::mesh(shapes::sphere(3));
  int calls = 0;
  const auto count = [&](double) {
    ++calls;
    return true;
  };
  const RL::Flow_report report =
      RL::mean_curvature_flow(mesh, 0.01, 5, mesh.points(), params::depth(3).progress(count));
  CHECK(report.converged);
  CHECK(calls >= 5);
  CHECK(std::abs(report.time - 0.05) < 1e-12);
  for(const auto v : vertices(mesh))
    REQUIRE(std::abs(std::sqrt((mesh.point(v) - CGAL::ORIGIN).squared_length()) - 0.895) < 0.02);
  const Triangles t = shapes::sphere(3);
  std::vector<RL::Point_3> moved(t.points.size());
  CHECK(RL::mean_curvature_flow(RL::soup(t.points, t.faces), 0.05, 1,
                                CGAL::make_property_map(moved), params::depth(3))
            .converged);
  CHECK(moved[0].x() != t.points[0].x());
  for(const double bad :
      {0., -1., std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
    CHECK_THROWS_WITH(RL::mean_curvature_flow(mesh, bad, 1, mesh.points(), params::depth(3)),
                      Catch::Contains("time_step"));
  CHECK_THROWS_WITH(RL::mean_curvature_flow(mesh, 1, 0, mesh.points(), params::depth(3)),
                    Catch::Contains("number_of_steps"));
  CHECK_THROWS_AS(RL::mean_curvature_flow(mesh, 1, 1, mesh.points(),
                                          params::depth(3).progress([](double) { return false; })),
                  RL::Canceled);
  // a huge step is a collapse, and the last good state is kept
  const Mesh before = mesh;
  CHECK(!RL::mean_curvature_flow(mesh, 1e9, 1, mesh.points(), params::depth(3)).collapse.empty());
  for(const auto v : vertices(mesh))
    REQUIRE(std::sqrt((mesh.point(v) - before.point(v)).squared_length()) < 1e-3);
}

TEST_CASE("spherical_parameterization_is_conformal_and_centered", "[flow]") {
  Triangles t = shapes::sphere(4);
  for(RL::Point_3& p : t.points)
    p = RL::Point_3(2 * p.x() + 0.5 * p.y() * p.y() + 7, p.y(), 0.5 * p.z() + 0.3 * p.x());
  std::vector<RL::Point_3> on_sphere(t.points.size());
  const RL::Sphere_map_report report = RL::spherical_parameterization(
      RL::soup(t.points, t.faces), CGAL::make_property_map(on_sphere), params::depth(4));
  CHECK(report.converged);
  CHECK(report.sphere_deviation <= 1e-3);
  CHECK(report.folded_faces == 0);
  CHECK(report.mean_distortion < 1.01);
  CHECK(std::abs(report.area / (4 * half_turn) - 1) < 0.01);
  const RL::Triangulated_surface_3 surface = RL::read_surface(RL::soup(t.points, t.faces));
  RL::Vector_3 mean(0, 0, 0);
  for(std::size_t f = 0; f < surface.number_of_faces(); ++f)
    for(int i = 0; i < 3; ++i)
      mean = mean + surface.area(f) / 3 / surface.area() *
                        (on_sphere[surface.triangle(f)[i]] - CGAL::ORIGIN);
  CHECK(std::sqrt(mean.squared_length()) < 1e-9);
  for(const RL::Point_3& p : on_sphere)
    REQUIRE(std::abs((p - CGAL::ORIGIN).squared_length() - 1) < 1e-12);

  // the same whatever the place, the size and the depth
  const Triangles other = shapes::moved(shapes::scaled(t, 1e4), {3, 4, 5});
  const RL::Sphere_map map = RL::map_to_sphere(flow_space(other, 5));
  CHECK(map.folded_faces == 0);
  double largest = 0; // of distances between points, which do not know rotations
  for(std::size_t i = 0; i < on_sphere.size(); i += 97)
    for(std::size_t j = 0; j < i; j += 89)
      largest =
          (std::max)(largest, std::abs(std::sqrt((on_sphere[i] - on_sphere[j]).squared_length()) -
                                       (map.positions.row(static_cast<Eigen::Index>(i)) -
                                        map.positions.row(static_cast<Eigen::Index>(j)))
                                           .norm()));
  CHECK(largest < 0.01);

  // what has no such map
  const auto refused = [](const Triangles& shape, const std::string& words) {
    const RL::Spline_space_3 space(RL::soup(shape.points, shape.faces), params::depth(4));
    CHECK_THROWS_WITH(RL::map_to_sphere(space), Catch::Contains(words));
  };
  refused(thin_torus(), "Euler");
  refused(shapes::grid(4, [](double x, double y) { return RL::Point_3(x, y, 0); }), "Euler");
  refused(shapes::joined(shapes::sphere(2), shapes::moved(shapes::sphere(2), {9, 0, 0})),
          "2 connected components");
  RL::Sphere_map_options options;
  options.maximum_iterations = 1;
  const RL::Sphere_map early = RL::map_to_sphere(flow_space(t, 4), options);
  CHECK(!early.converged);
  CHECK(early.status == RL::Solve_status::iteration_limit);
  options.progress = [](double) { return false; };
  CHECK_THROWS_AS(RL::map_to_sphere(flow_space(t, 4), options), RL::Canceled);
  options.maximum_iterations = 0;
  CHECK_THROWS_AS(RL::map_to_sphere(flow_space(t, 4), options), RL::Parameter_error);
  options = RL::Sphere_map_options();
  options.tolerance = 0;
  CHECK_THROWS_AS(RL::map_to_sphere(flow_space(t, 4), options), RL::Parameter_error);
}
