// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Surfaces that no mesh data structure holds: triangle soups, non-manifold edges, non-orientable
// strips, duplicate vertices, T-junctions; and that soups and meshes give the same results.

#include "catch.h"
#include "special_shapes.h"

#include <CGAL/Restricted_laplacian_3/input/read_surface.h>
#include <CGAL/Restricted_laplacian_3/laplace_spectrum.h>
#include <CGAL/Restricted_laplacian_3/solve_poisson.h>

#include <CGAL/IO/polygon_soup_io.h>

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace {

namespace RL = CGAL::Restricted_laplacian_3;
namespace params = RL::parameters;
using shapes::Triangles;

std::size_t number_of_components(const Triangles& t, int depth = 4) {
  return RL::Spline_space_3(RL::soup(t.points, t.faces), params::depth(depth))
      .octree()
      .number_of_sheets(0);
}

std::size_t number_of_joined_components(const Triangles& t, double tolerance, int depth = 4) {
  return RL::Spline_space_3(RL::soup(t.points, t.faces),
                            params::depth(depth).joining_tolerance(tolerance))
      .octree()
      .number_of_sheets(0);
}

/// every triangle with points of its own
Triangles torn(const Triangles& t) {
  Triangles result;
  for(const auto& f : t.faces) {
    const auto first = static_cast<std::uint32_t>(result.points.size());
    for(std::uint32_t v : f)
      result.points.push_back(t.points[v]);
    result.faces.push_back({first, first + 1, first + 2});
  }
  return result;
}

/// n x n squares in the plane z = 0, of two triangles each
Triangles grid(double x, double width, double height, int n) {
  Triangles t;
  const std::uint32_t m = n + 1;
  for(int j = 0; j <= n; ++j)
    for(int i = 0; i <= n; ++i)
      t.points.emplace_back(x + width * i / n, height * j / n, 0);
  for(std::uint32_t j = 0; j + 1 < m; ++j)
    for(std::uint32_t i = 0; i + 1 < m; ++i) {
      const std::uint32_t a = j * m + i;
      t.faces.push_back({a, a + 1, a + m + 1});
      t.faces.push_back({a, a + m + 1, a + m});
    }
  return t;
}

Eigen::VectorXd eigenvalues(const Triangles& t, int count, int depth,
                            std::optional<double> joining = std::nullopt) {
  RL::Spline_space_options options;
  options.depth = depth;
  options.joining_tolerance = joining;
  const RL::Laplace_spectrum spectrum = RL::laplace_spectrum(
      RL::Spline_space_3(RL::read_surface(RL::soup(t.points, t.faces)), options), count);
  CHECK(spectrum.report.converged);
  return spectrum.eigenvalues;
}

} // namespace

TEST_CASE("soup_and_mesh_give_the_same_results", "[soups]") {
  const Triangles t = shapes::sphere(3);
  shapes::Mesh mesh = shapes::mesh(t);
  const auto f = [](const RL::Surface_point& p) { return p.point.z(); };
  const auto np = params::depth(3);
  auto map = mesh.add_property_map<shapes::Mesh::Vertex_index, double>("v:u").first;
  static_cast<void>(RL::solve_poisson(mesh, f, map, np));
  std::vector<double> u(t.points.size()), from_values(t.points.size()), z;
  const RL::Solve_report report =
      RL::solve_poisson(RL::soup(t.points, t.faces), f, CGAL::make_property_map(u), np);
  CHECK(report.converged);
  for(const RL::Point_3& p : t.points)
    z.push_back(p.z());
  static_cast<void>(RL::solve_poisson(RL::soup(t.points, t.faces), CGAL::make_property_map(z),
                                      CGAL::make_property_map(from_values), np));
  for(std::size_t i = 0; i < u.size(); ++i) {
    // the mesh may begin a face with another of its corners
    REQUIRE(u[i] == Approx(map[shapes::Mesh::Vertex_index(i)]).margin(1e-6));
    REQUIRE(from_values[i] == Approx(u[i]).margin(1e-6));
  }
  const RL::Laplace_spectrum of_mesh = RL::laplace_spectrum(mesh, 9, np),
                             of_soup = RL::laplace_spectrum(RL::soup(t.points, t.faces), 9, np);
  CHECK((of_mesh.eigenvalues - of_soup.eigenvalues).cwiseAbs().maxCoeff() <= 1e-8);
  // other types of indices
  std::vector<std::vector<std::size_t>> lists;
  std::vector<std::array<int, 3>> arrays;
  for(const auto& face : t.faces) {
    lists.push_back({face[0], face[1], face[2]});
    arrays.push_back({int(face[0]), int(face[1]), int(face[2])});
  }
  CHECK(RL::Spline_space_3(RL::soup(t.points, lists), np).dimension() ==
        RL::Spline_space_3(RL::soup(t.points, arrays), np).dimension());
}

TEST_CASE("bad_soups_are_refused", "[soups]") {
  const Triangles t = shapes::sphere(0);
  std::vector<std::vector<int>> faces = {{0, 2, 4}, {2, 1, 4}};
  const auto message = [&] {
    try {
      RL::read_surface(RL::soup(t.points, faces));
    } catch(const RL::Input_error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CHECK(message().empty());
  faces[1] = {2, 1, 6};
  CHECK_THAT(message(), Catch::Contains("face 1") && Catch::Contains("does not exist"));
  faces[1] = {2, 1, -1};
  CHECK_THAT(message(), Catch::Contains("face 1") && Catch::Contains("does not exist"));
  faces[1] = {2, 1};
  CHECK_THAT(message(), Catch::Contains("face 1") && Catch::Contains("fewer than three corners"));
  CHECK_THROWS_AS(RL::Triangulated_surface_3(t.points, {{0, 1, 9}}), RL::Invalid_face_error);
  for(double tolerance : {-1e-3, std::nan(""), std::numeric_limits<double>::infinity()})
    CHECK_THROWS_AS(number_of_joined_components(t, tolerance), RL::Parameter_error);
}

TEST_CASE("three_half_planes_on_one_edge_are_joined", "[soups]") {
  // u is constant only if it is the same constant on all three
  Triangles t;
  t.points = {{0, 0, 0}, {0, 0, 1}};
  for(int k = 0; k < 3; ++k) {
    const double angle = 0.3 + 2 * CGAL_PI * k / 3;
    const auto first = static_cast<std::uint32_t>(t.points.size());
    for(double z : {0., 1.})
      t.points.emplace_back(std::cos(angle), std::sin(angle), z);
    t.faces.push_back({0, first, first + 1});
    t.faces.push_back({0, first + 1, 1});
  }
  CHECK(number_of_components(t) == 1);
  // On a star of three rays of length 1 the eigenfunctions are cos(k pi r) on all, and sin((k +
  // 1/2) pi r) with coefficients that sum to 0; along z they are cosines.
  const double pi2 = CGAL_PI * CGAL_PI;
  const std::vector<double> exact = {0,          pi2 / 4,    pi2 / 4, pi2,        pi2,
                                     1.25 * pi2, 1.25 * pi2, 2 * pi2, 2.25 * pi2, 2.25 * pi2};
  const Eigen::VectorXd values = eigenvalues(t, 10, 5);
  for(std::size_t i = 1; i < exact.size(); ++i)
    CHECK(values[i] == Approx(exact[i]).epsilon(0.02));

  // the third with vertices of its own: its side is alone, those of the others are not
  Triangles apart = t;
  const auto copy = static_cast<std::uint32_t>(apart.points.size());
  apart.points.push_back(t.points[0]);
  apart.points.push_back(t.points[1]);
  for(std::size_t f = 4; f < 6; ++f)
    for(std::uint32_t& v : apart.faces[f])
      if(v < 2)
        v += copy;
  CHECK(number_of_components(apart) == 2);
  CHECK(number_of_joined_components(apart, 0) == 1);
  CHECK((eigenvalues(apart, 10, 5, 0) - values).cwiseAbs().maxCoeff() <= 1e-8);
}

TEST_CASE("moebius_strip", "[soups]") {
  // A flat strip of n triangles, turned around once and a half. Its surface is not orientable; the
  // kernel is that of one component.
  Triangles t;
  const std::uint32_t n = 60;
  for(std::uint32_t i = 0; i < n; ++i) {
    const double angle = 2 * CGAL_PI * i / n, c = std::cos(angle), s = std::sin(angle);
    for(double w : {-0.3, 0.3}) {
      const double r = 1 + w * std::cos(angle / 2);
      t.points.emplace_back(r * c, r * s, w * std::sin(angle / 2));
    }
  }
  for(std::uint32_t i = 0; i < n; ++i) {
    // after one turn the two borders are exchanged
    const std::uint32_t a = 2 * i, b = a + 1, c = i + 1 < n ? a + 2 : 1, d = i + 1 < n ? a + 3 : 0;
    t.faces.push_back({a, b, d});
    t.faces.push_back({a, d, c});
  }
  const RL::Spline_space_3 space(RL::soup(t.points, t.faces), params::depth(5));
  CHECK(space.octree().number_of_sheets(0) == 1);
  const RL::Poisson_solver solver(space, RL::assemble_operators(space));
  CHECK(solver.kernel_dimension() == 1);
  // cutting it open changes the spectrum
  Triangles cut = t;
  const auto first = static_cast<std::uint32_t>(cut.points.size());
  cut.points.push_back(t.points[1]);
  cut.points.push_back(t.points[0]);
  cut.faces[2 * n - 2] = {2 * n - 2, 2 * n - 1, first + 1};
  cut.faces[2 * n - 1] = {2 * n - 2, first + 1, first};
  const Eigen::VectorXd whole = eigenvalues(t, 6, 5), opened = eigenvalues(cut, 6, 5);
  CHECK(opened[1] < 0.5 * whole[1]);
  // and joining closes it again
  const Eigen::VectorXd joined = eigenvalues(cut, 6, 5, 0);
  CHECK((joined - whole).cwiseAbs().maxCoeff() <= 1e-8);
}

TEST_CASE("duplicate_vertices_are_joined_on_request", "[soups]") {
  const Triangles sphere = shapes::sphere(2), pieces = torn(sphere);
  CHECK(number_of_components(pieces) == sphere.faces.size());
  CHECK(number_of_joined_components(pieces, 0) == 1);
  const Eigen::VectorXd exact = eigenvalues(sphere, 12, 4);
  CHECK((eigenvalues(pieces, 12, 4, 0) - exact).cwiseAbs().maxCoeff() <= 1e-8);
  // cracks
  Triangles moved = pieces;
  for(std::size_t i = 0; i < moved.points.size(); ++i)
    moved.points[i] =
        moved.points[i] + 1e-5 * RL::Vector_3(std::sin(1. * i), std::sin(2. * i), std::sin(3. * i));
  CHECK(number_of_components(moved) == sphere.faces.size());
  CHECK(number_of_joined_components(moved, 1e-7) == sphere.faces.size());
  CHECK(number_of_joined_components(moved, 1e-4) == 1);
  CHECK(eigenvalues(moved, 12, 4, 1e-4)[4] == Approx(exact[4]).epsilon(1e-3));
}

TEST_CASE("t_junctions_are_joined_on_request", "[soups]") {
  // two rectangles whose vertices along the common line agree at its ends only
  for(const auto& [n, m] : {std::pair<int, int>{1, 3}, {2, 3}, {4, 7}}) {
    const Triangles t = shapes::joined(grid(0, 0.6, 1, n), grid(0.6, 0.4, 1, m));
    INFO(n << " and " << m << " edges");
    CHECK(number_of_components(t) == 2);
    CHECK(number_of_joined_components(t, 1e-12) == 1);
    const Eigen::VectorXd joined = eigenvalues(t, 8, 4, 1e-12),
                          whole = eigenvalues(grid(0, 1, 1, 1), 8, 4);
    CHECK((joined - whole).cwiseAbs().maxCoeff() <= 1e-8);
  }
  // parallel sides that are near, but not along each other, stay apart
  const Triangles apart = shapes::joined(grid(0, 0.6, 1, 2), grid(0.61, 0.4, 1, 3));
  CHECK(number_of_joined_components(apart, 1e-3) == 2);
  // rectangles that touch in a corner only
  const Triangles corner =
      shapes::joined(grid(0, 1, 1, 1), shapes::moved(grid(1, 1, 1, 1), {0, 1, 0}));
  CHECK(number_of_joined_components(corner, 1e-6) == 2);
}

TEST_CASE("needles_do_not_tear_the_surface", "[soups]") {
  // The side of a coarse half has a vertex of the fine half on it; a triangle without area, or
  // nearly so, lies between.
  for(double height : {0., 1e-16, 1e-13, 1e-9, 1e-6})
    for(int depth : {3, 5}) {
      INFO("height " << height << ", depth " << depth);
      Triangles t;
      t.points = {{0, 0, 0},   {1, 0, 0},  {0.4 + height, 0.5, 0}, {1, 1, 0}, {0, 1, 0},
                  {0.4, 0, 0}, {0.4, 1, 0}};
      // left: one side from (0.4, 0) to (0.4, 1); right: two sides, over (0.4 + height, 0.5)
      t.faces = {{0, 5, 6}, {0, 6, 4}, {5, 2, 6}, {5, 1, 2}, {1, 3, 2}, {2, 3, 6}};
      CHECK(number_of_components(t, depth) == 1);
      const Eigen::VectorXd values = eigenvalues(t, 4, depth);
      CHECK(values[1] == Approx(CGAL_PI * CGAL_PI).epsilon(0.02));
      CHECK(values[2] == Approx(CGAL_PI * CGAL_PI).epsilon(0.02));
    }
}

TEST_CASE("bad_meshes_of_the_larger_set", "[soups][slow]") {
  struct Case {
    std::string file;
    std::size_t components; // by common edges
  };
  for(const auto& [file, components] : std::vector<Case>{{"cycloidal_soup_43k.ply", 112},
                                                         {"cessna_soup_14k.ply", 11},
                                                         {"moebius.ply", 1},
                                                         {"rgbd5_scan1.ply", 107},
                                                         {"rgbd5_scan5.ply", 23},
                                                         {"bunscan_000.ply", 2},
                                                         {"bunny_zipper_69k.ply", 1},
                                                         {"plane_holes_17k.ply", 1}}) {
    const std::string path = shared_mesh(file);
    if(path.empty())
      SKIP_TEST("no such file: " << file);
    INFO(file);
    std::vector<RL::Point_3> points;
    std::vector<std::vector<std::size_t>> faces;
    REQUIRE(CGAL::IO::read_polygon_soup(path, points, faces));
    const RL::Spline_space_3 space(RL::soup(points, faces), params::depth(4));
    CHECK(space.octree().number_of_sheets(0) == components);
    const RL::Operators operators = RL::assemble_operators(space);
    const Eigen::VectorXd ones = Eigen::VectorXd::Ones(space.dimension());
    CHECK((operators.stiffness * ones).cwiseAbs().maxCoeff() <=
          1e-13 * operators.stiffness.diagonal().maxCoeff());
    const RL::Poisson_solver solver(space, operators);
    CHECK(std::size_t(solver.kernel_dimension()) == components);
    Eigen::VectorXd eta;
    const auto x = [](const RL::Surface_point& p) { return p.point.x(); };
    CHECK(solver.solve(RL::assemble_load(space, x), eta).converged);
    CHECK(eta.allFinite());
    const int count = static_cast<int>(components) + 3;
    const RL::Laplace_spectrum spectrum = RL::laplace_spectrum(space, count);
    CHECK(spectrum.report.converged);
    const double unit = 1 / space.surface().area();
    CHECK(std::abs(spectrum.eigenvalues[components - 1]) <= 1e-6 * unit);
    CHECK(spectrum.eigenvalues[components] >= 0.01 * unit);
  }
}
