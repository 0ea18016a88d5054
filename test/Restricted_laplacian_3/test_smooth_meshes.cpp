// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Smooth geometry on real meshes, whose vertices were not made for it: a strip with one side, a
// soup, creases, boundaries, needles; and with normals that are wrong.

#include "catch.h"
#include "shapes.h"
#include "test_meshes.h"

#include <CGAL/Restricted_laplacian_3/assembly/assemble.h>
#include <CGAL/Restricted_laplacian_3/input/read_surface.h>
#include <CGAL/Restricted_laplacian_3/patches/curved_surface.h>
#include <CGAL/Restricted_laplacian_3/problems/Poisson_solver.h>
#include <CGAL/Restricted_laplacian_3/surface/Surface_patches.h>
#include <CGAL/Restricted_laplacian_3/surface/vertex_normals.h>

#include <CGAL/IO/polygon_soup_io.h>

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace {

namespace RL = CGAL::Restricted_laplacian_3;
namespace params = RL::parameters;

RL::Triangulated_surface_3 read(const std::string& path) {
  std::vector<RL::Point_3> points;
  std::vector<std::vector<std::size_t>> faces;
  REQUIRE(CGAL::IO::read_polygon_soup(path, points, faces));
  return RL::read_surface(RL::soup(points, faces));
}

/// A Poisson problem that must be solved as on any other surface.
void solve_on(const RL::Triangulated_surface_3& surface, int depth) {
  const RL::Spline_space_3 space(surface, params::depth(depth));
  const RL::Operators operators = RL::assemble_operators(space);
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(space.dimension());
  CHECK((operators.stiffness * ones).lpNorm<Eigen::Infinity>() <
        1e-12 * Eigen::VectorXd(operators.stiffness.diagonal()).maxCoeff());
  CHECK(ones.dot(operators.mass * ones) == Approx(surface.area()).epsilon(5e-5));
  Eigen::VectorXd eta;
  const RL::Solve_report report =
      RL::Poisson_solver(space, operators)
          .solve(RL::assemble_load(space, [](const RL::Surface_point& p) { return p.point.x(); }),
                 eta);
  CHECK(report.converged);
  CHECK(report.iterations <= 10);
  CHECK(eta.allFinite());
}

} // namespace

TEST_CASE("smooth_geometry_of_real_meshes") {
  for(const char* file :
      {"moebius.ply", "wingnut_6k.ply", "bunny_adaptive_12k.ply", "cessna_soup_14k.ply",
       "fandisk_14k.ply", "plane_holes_17k.ply", "turbine_18k.ply"}) {
    const std::string path = shared_mesh(file);
    if(path.empty())
      SKIP_TEST("no such file: " << file);
    INFO(file);
    const RL::Triangulated_surface_3 flat = read(path), smooth = RL::curved_surface(flat);
    CHECK(std::abs(smooth.area() / flat.area() - 1) < 0.02);
    CHECK(smooth.patches().number_of_folded_faces() < flat.number_of_faces() / 20);
    const auto components = [](const RL::Triangulated_surface_3& surface) {
      return RL::Spline_space_3(surface, params::depth(4)).octree().number_of_sheets(0);
    };
    CHECK(components(smooth) == components(flat));
    solve_on(smooth, 5);
  }
}

TEST_CASE("normals_that_are_wrong") {
  const std::string path = shared_mesh("spot_23k.ply");
  if(path.empty())
    SKIP_TEST("no such file: spot_23k.ply");
  const RL::Triangulated_surface_3 flat = read(path);
  const std::vector<RL::Vector_3> normals = RL::vertex_normals(flat);
  std::mt19937 generator(1);
  const auto random = [&] { return generator() * std::ldexp(2., -32) - 1; };
  const auto with = [&](auto&& change) {
    RL::Smooth_geometry geometry;
    geometry.vertex_normals = normals;
    for(std::size_t v = 0; v < normals.size(); ++v)
      change(v, geometry.vertex_normals[v]);
    return RL::curved_surface(flat, geometry);
  };
  const RL::Triangulated_surface_3 estimated = RL::curved_surface(flat),
                                   given = with([](std::size_t, RL::Vector_3&) {});
  CHECK(given.area() == Approx(estimated.area()).epsilon(5e-4));

  SECTION("turned around, and of any length") {
    const auto turned = with([](std::size_t v, RL::Vector_3& n) {
      n = n * (v % 3 == 0 ? -1. : v % 3 == 1 ? 1e-100 : 1e100);
    });
    CHECK(turned.area() == Approx(given.area()).epsilon(1e-12));
  }
  SECTION("zero, not finite, or not there") {
    CHECK(with([](std::size_t v, RL::Vector_3& n) {
            n = v % 2 ? RL::Vector_3(0, 0, 0)
                      : RL::Vector_3(std::numeric_limits<double>::quiet_NaN(), 0, 0);
          }).area() == estimated.area());
    const auto half = with([](std::size_t v, RL::Vector_3& n) {
      if(v % 2)
        n = RL::Vector_3(0, 0, 0);
    });
    CHECK(half.area() == Approx(estimated.area()).epsilon(5e-4));
  }
  SECTION("noise") {
    for(double noise : {0.01, 0.1, 0.3}) {
      const auto noisy = with([&](std::size_t, RL::Vector_3& n) {
        n = n + noise * RL::Vector_3(random(), random(), random());
      });
      INFO(noise << ", " << noisy.patches().number_of_folded_faces() << " folded");
      CHECK(std::abs(noisy.area() / given.area() - 1) < noise * noise);
      solve_on(noisy, 5);
    }
  }
}
