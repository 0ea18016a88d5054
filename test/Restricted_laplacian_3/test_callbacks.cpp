// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Callbacks hear how much of the work is done, and end it.

#include "catch.h"
#include "shapes.h"

#include <CGAL/Restricted_laplacian_3/estimate_curvature.h>
#include <CGAL/Restricted_laplacian_3/fit_function.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Progress.h>
#include <CGAL/Restricted_laplacian_3/integrate_gradient_field.h>
#include <CGAL/Restricted_laplacian_3/solve_poisson.h>
#include <CGAL/Restricted_laplacian_3/stitch_colors.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

namespace {

namespace RL = CGAL::Restricted_laplacian_3;
namespace params = RL::parameters;
using Callback = std::function<bool(double)>;
using Vertex = shapes::Mesh::Vertex_index;

/// Parts that are told begin with 0, never fall, end with 1, and come often enough; and a callback
/// that returns `false` is heard whenever it does.
/// \param run does some work with a callback
/// \param fewest calls that are expected
template <class Run> void check_callback(const Run& run, std::size_t fewest) {
  std::vector<double> parts;
  run([&](double part) {
    parts.push_back(part);
    return true;
  });
  REQUIRE(parts.size() >= fewest);
  CHECK(parts.front() == 0);
  CHECK(parts.back() == Approx(1).epsilon(1e-12));
  CHECK(parts.back() <= 1);
  CHECK(std::is_sorted(parts.begin(), parts.end()));
  for(const std::size_t calls : {std::size_t(1), parts.size() / 2, parts.size()}) {
    std::size_t call = 0;
    CHECK_THROWS_AS(run([&](double) { return ++call < calls; }), RL::Canceled);
    CHECK(call == calls);
  }
}

double height(const RL::Surface_point& p) { return p.point.z(); }

} // namespace

TEST_CASE("parts_of_a_progress_are_nested", "[callbacks]") {
  using RL::internal::Progress;
  std::vector<double> heard;
  const Progress whole([&](double part) {
    heard.push_back(part);
    return part < 0.9;
  });
  const Progress second = whole.part(0.5, 1), last = second.part(0.6, 1);
  whole(0.25);
  second(0.5);
  second(0.25);                                     // what was heard does not fall
  second(-1);                                       // as little as possible
  last(std::numeric_limits<double>::quiet_NaN());   // the same
  CHECK(Progress(last.callback()).part(0, 0.5)(0)); // as the callback of other work
  CHECK_THROWS_AS(last(2), RL::Canceled);
  const std::vector<double> expected = {0.25, 0.75, 0.75, 0.75, 0.8, 0.8, 1};
  REQUIRE(heard.size() == expected.size());
  for(std::size_t i = 0; i < heard.size(); ++i)
    CHECK(heard[i] == Approx(expected[i]));
  CHECK_FALSE(Progress().callback());
  CHECK(Progress()(0.5));
}

TEST_CASE("poisson_problems_report_progress_and_can_be_canceled", "[callbacks]") {
  shapes::Mesh mesh = shapes::mesh(shapes::sphere(3));
  auto u = mesh.add_property_map<Vertex, double>("v:u").first;
  const auto np = params::depth(4);
  SECTION("a function on a mesh") {
    check_callback(
        [&](const Callback& callback) {
          static_cast<void>(RL::solve_poisson(mesh, height, u, np.progress(callback)));
        },
        15);
    check_callback(
        [&](const Callback& callback) {
          static_cast<void>(RL::solve_screened_poisson(mesh, height, 2., u, np.progress(callback)));
        },
        15);
  }
  SECTION("prescribed values") {
    auto fixed = mesh.add_property_map<Vertex, double>("v:fixed", std::nan("")).first;
    fixed[Vertex(0)] = 0;
    check_callback(
        [&](const Callback& callback) {
          static_cast<void>(RL::solve_poisson(
              mesh, height, u, params::depth(4).constraints(fixed).progress(callback)));
        },
        15);
  }
  SECTION("steps") {
    const RL::Spline_space_3 space(mesh, np);
    check_callback(
        [&](const Callback& callback) {
          RL::assemble_operators_of_levels(space, 2, 4, 0, RL::Stabilized::stiffness_and_mass,
                                           callback);
        },
        9);
    check_callback(
        [&](const Callback& callback) { RL::Poisson_solver(space, 1, np.progress(callback)); }, 10);
    const RL::Poisson_solver solver(space);
    const Eigen::VectorXd one = RL::assemble_load(space, height);
    Eigen::VectorXd x, y;
    check_callback(
        [&](const Callback& callback) {
          static_cast<void>(solver.solve(one, x, {1e-6, callback}));
        },
        4);
    static_cast<void>(solver.solve(one, y, 1e-6));
    CHECK(x == y);
    // two passes of eight and of one
    Eigen::MatrixXd several(one.rows(), 9), solutions;
    for(Eigen::Index k = 0; k < 9; ++k)
      several.col(k) = one * (k + 1.);
    std::vector<double> parts;
    static_cast<void>(solver.solve(several, solutions, {1e-6, [&](double part) {
                                                          parts.push_back(part);
                                                          return true;
                                                        }}));
    CHECK(std::is_sorted(parts.begin(), parts.end()));
    CHECK(std::find_if(parts.begin(), parts.end(),
                       [](double part) { return std::abs(part - 8. / 9) < 1e-9; }) != parts.end());
    CHECK(parts.back() == 1);
  }
}

TEST_CASE("fits_report_progress_and_can_be_canceled", "[callbacks]") {
  shapes::Mesh mesh = shapes::mesh(shapes::sphere(3));
  auto u = mesh.add_property_map<Vertex, double>("v:u").first;
  check_callback(
      [&](const Callback& callback) {
        RL::fit_function(mesh, height, u, params::depth(3).progress(callback));
      },
      20);
  check_callback(
      [&](const Callback& callback) {
        RL::fit_function(mesh, height, u, params::depth(3).refinements(2).progress(callback));
      },
      20);
  auto c = mesh.add_property_map<Vertex, RL::Surface_curvature>("v:c").first;
  for(RL::Curvature_method method :
      {RL::Curvature_method::normals, RL::Curvature_method::face_normals,
       RL::Curvature_method::coordinates})
    check_callback(
        [&](const Callback& callback) {
          RL::estimate_curvature(mesh, c, params::depth(3).method(method).progress(callback));
        },
        15);
}

TEST_CASE("gradients_and_colors_report_progress_and_can_be_canceled", "[callbacks]") {
  const shapes::Triangles triangles = shapes::sphere(3);
  shapes::Mesh mesh = shapes::mesh(triangles);
  auto u = mesh.add_property_map<Vertex, double>("v:u").first;
  const auto upwards = [](const RL::Surface_point&) { return RL::Vector_3(0, 0, 1); };
  for(const bool with_details : {false, true})
    check_callback(
        [&](const Callback& callback) {
          RL::integrate_gradient_field(mesh, upwards, u,
                                       params::depth(3).details(with_details).progress(callback));
        },
        15);

  using Color = std::array<double, 3>;
  auto color = mesh.add_property_map<Vertex, Color>("v:color", Color{0.2, 0.4, 0.6}).first;
  const std::vector<RL::Colored_scan> scans = {
      RL::Colored_scan(mesh, color, params::viewpoint(RL::Point_3(0, 0, 5))),
      RL::Colored_scan(mesh, color, params::viewpoint(RL::Point_3(0, 0, -5)))};
  check_callback(
      [&](const Callback& callback) {
        RL::stitch_colors(mesh, scans, color, params::depth(3).progress(callback));
      },
      15);
}
