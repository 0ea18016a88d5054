// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Random hostile surfaces: nothing crashes, hangs or turns into NaN, and the identities hold. The
// number of rounds is that of the environment variable RESTRICTED_LAPLACIAN_3_FUZZ_ROUNDS, 30 if it
// is not set; a failure names the seed of its round.

#include "catch.h"
#include "special_shapes.h"

#include <CGAL/Restricted_laplacian_3/assembly/Dirichlet_boundary.h>
#include <CGAL/Restricted_laplacian_3/solve_poisson.h>
#include <CGAL/Restricted_laplacian_3/solvers/galerkin_product.h>
#include <CGAL/Restricted_laplacian_3/splines/prolongation.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <random>
#include <vector>

namespace {

namespace RL = CGAL::Restricted_laplacian_3;
namespace params = RL::parameters;

class Fuzzer {
public:
  explicit Fuzzer(unsigned seed) : m_generator(seed) {}

  int depth() { return 1 + below(5); }
  double cube_scale() { return std::vector<double>{1, 1.1, 1.25, 2, 3.7}[below(5)]; }
  std::optional<double> joining_tolerance() {
    return std::vector<std::optional<double>>{{}, {}, 0, 1e-9, 1e-2}[below(5)];
  }

  shapes::Triangles surface() {
    shapes::Triangles t;
    const double scale = std::pow(10., below(3) == 0 ? below(19) - 9 : 0);
    const double offset = below(4) == 0 ? std::pow(10., below(9)) : 0;
    for(int parts = 1 + below(4); parts > 0; --parts)
      t = shapes::joined(t, part());
    distort(t);
    for(RL::Point_3& p : t.points)
      p = RL::Point_3(scale * (p.x() + offset), scale * (p.y() - offset), scale * p.z());
    // no face uses it, so it may lie anywhere
    t.points.emplace_back(std::nan(""), 1e300, 0);
    return t;
  }

private:
  int below(int n) { return static_cast<int>(m_generator() % static_cast<unsigned>(n)); }
  double uniform() { return std::ldexp(double(m_generator()), -32); }
  /// coordinates that like to lie on walls, or beside them by next to nothing
  double coordinate() {
    switch(below(4)) {
    case 0: return std::ldexp(below(17), -4);
    case 1: return std::ldexp(below(17), -4) + std::pow(10., -3 - below(15)) * (uniform() - 0.5);
    default: return uniform();
    }
  }
  RL::Point_3 point() {
    const double x = coordinate(), y = coordinate(), z = coordinate();
    return {x, y, z};
  }

  shapes::Triangles part() {
    switch(below(6)) {
    case 0: return shapes::sphere(below(4));
    case 1: {
      const double x = coordinate() + 0.01, y = coordinate() + 0.01, z = coordinate() + 0.01;
      const int n = 1 + below(4);
      return shapes::box(x, y, z, n, static_cast<unsigned>(below(1000)));
    }
    case 2: {
      const int n = 1 + below(8);
      return shapes::stairs(n, std::ldexp(1, -below(5)));
    }
    case 3: {
      const double width = coordinate() + 0.01;
      return shapes::moved(shapes::rectangle(width, 1), point() - CGAL::ORIGIN);
    }
    default: return soup();
    }
  }

  shapes::Triangles soup() {
    shapes::Triangles t;
    const int number_of_points = 3 + below(30);
    for(int i = 0; i < number_of_points; ++i)
      t.points.push_back(point());
    const auto vertex = [&] { return static_cast<std::uint32_t>(below(number_of_points)); };
    for(int i = 1 + below(40); i > 0; --i) {
      const std::uint32_t a = vertex(), b = vertex(), c = vertex();
      t.faces.push_back({a, b, c});
    }
    return t;
  }

  void distort(shapes::Triangles& t) {
    const auto any_point = [&]() -> RL::Point_3& {
      return t.points[m_generator() % t.points.size()];
    };
    const auto any_face = [&]() -> auto& { return t.faces[m_generator() % t.faces.size()]; };
    for(int i = below(10); i > 0; --i)
      switch(below(7)) {
      case 0: any_point() = any_point(); break;
      case 1: any_point() = CGAL::midpoint(any_point(), any_point()); break;
      case 2: std::swap(any_face()[0], any_face()[1]); break;
      case 3: t.faces.push_back(any_face()); break;
      case 4: any_face()[0] = any_face()[1]; break;
      case 5: any_point() = any_point() + RL::Vector_3(1e-14 * uniform(), 0, 0); break;
      case 6: t.points.push_back(point()); break;
      }
  }

  std::mt19937 m_generator;
};

void check(const RL::Spline_space_3& space) {
  const RL::Operators operators = RL::assemble_operators(space);
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(space.dimension());
  // Corners near to a wall are moved onto it, which changes the area of a triangle by up to its
  // perimeter times that distance.
  const RL::Triangulated_surface_3& surface = space.surface();
  double perimeters = 0;
  for(std::size_t f = 0; f < surface.number_of_faces(); ++f)
    for(int side = 0; side < 3; ++side)
      perimeters +=
          std::sqrt((surface.point(f, (side + 1) % 3) - surface.point(f, side)).squared_length());
  const double moved = space.octree().wall_tolerance(0) * space.octree().side();
  REQUIRE(std::abs(ones.dot(operators.mass * ones) - surface.area()) <=
          1e-12 * surface.area() + 2 * moved * perimeters);
  REQUIRE((operators.stiffness * ones).cwiseAbs().maxCoeff() <=
          1e-12 * operators.stiffness.diagonal().maxCoeff());
  REQUIRE(operators.mass.diagonal().minCoeff() >= 0);
  const int level = space.depth() - 1;
  const RL::Sparse_matrix p = RL::prolongation_matrix(space, level);
  const RL::Sparse_matrix galerkin = RL::galerkin_product(operators.stiffness, p),
                          direct = RL::assemble_stiffness_matrix(space, level);
  REQUIRE(RL::Sparse_matrix(galerkin - direct).coeffs().abs().maxCoeff() <=
          1e-11 * direct.coeffs().abs().maxCoeff());
  const std::vector<double> values = RL::Spline_function_3(space, ones).values_at_vertices();
  for(std::size_t f = 0; f < surface.number_of_faces(); ++f)
    for(std::uint32_t v : surface.triangle(f))
      if(!surface.is_degenerate(f) && !std::isnan(values[v]))
        REQUIRE(values[v] == Approx(1).epsilon(1e-5));

  RL::internal::Poisson_solver_options options;
  options.maximum_iterations = 30;
  const RL::Poisson_solver solver =
      RL::make_poisson_solver(space, operators.stiffness, operators.mass * ones, 0, options);
  const RL::Point_3 origin = surface.bounding_box_min();
  Eigen::VectorXd eta;
  const RL::Solve_report report = solver.solve(
      RL::assemble_load(space, [&](const RL::Surface_point& p) { return (p.point - origin).x(); }),
      eta);
  REQUIRE(eta.allFinite());
  REQUIRE(std::isfinite(report.relative_residual));

  try {
    const RL::Dirichlet_boundary boundary(space);
    RL::Sparse_matrix a = operators.stiffness;
    boundary.add_to_matrix(a);
    REQUIRE(a.coeffs().allFinite());
    REQUIRE(a.diagonal().minCoeff() >= -1e-12 * a.diagonal().maxCoeff());
    REQUIRE(boundary.load([](const RL::Surface_point&) { return 1.; }).allFinite());
  } catch(const RL::Parameter_error&) {
    // a closed surface
  }
}

} // namespace

TEST_CASE("random_hostile_surfaces", "[fuzz]") {
  const char* given = std::getenv("RESTRICTED_LAPLACIAN_3_FUZZ_ROUNDS");
  const unsigned rounds = given ? static_cast<unsigned>(std::atoi(given)) : 30;
  unsigned accepted = 0;
  for(unsigned seed = 1; seed <= rounds; ++seed) {
    INFO("seed " << seed);
    Fuzzer fuzzer(seed);
    const shapes::Triangles t = fuzzer.surface();
    RL::internal::Spline_space_options options;
    options.octree_depth = fuzzer.depth();
    options.cube_scale = fuzzer.cube_scale();
    options.joining_tolerance = fuzzer.joining_tolerance();
    options.split_elements = seed % 4 != 0;
    try {
      check(RL::Spline_space_3(RL::Triangulated_surface_3(t.points, t.faces), options));
      ++accepted;
    } catch(const RL::Input_error&) {
      // nothing but degenerate faces
    }
  }
  CHECK(accepted >= rounds * 9 / 10);
}
