// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "catch.h"
#include "shapes.h"
#include "special_shapes.h"

#include <CGAL/Restricted_laplacian_3/integration/triangle_quadrature.h>
#include <CGAL/Restricted_laplacian_3/problems/Multigrid_preconditioner.h>
#include <CGAL/Restricted_laplacian_3/solve_poisson.h>

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCholesky>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace {

namespace RL = CGAL::Restricted_laplacian_3;
namespace params = RL::parameters;
using shapes::Mesh;

/// A spherical harmonic of degree 6, in a frame that is that of no symmetry of the grid, as a
/// function of direction. Harmonics of low degree would be in the space of splines, and have no
/// error.
double harmonic(const RL::Point_3& p) {
  const double r = std::sqrt((p - CGAL::ORIGIN).squared_length());
  const double x = (2 * p.x() + 2 * p.y() + p.z()) / (3 * r);
  const double y = (-2 * p.x() + p.y() + 2 * p.z()) / (3 * r);
  return std::real(std::pow(std::complex<double>(x, y), 6));
}
constexpr double harmonic_eigenvalue = 42; // l (l + 1)

/// L2 norm of u minus a multiple of the harmonic, over that of the harmonic, by cubature on cells
double relative_error(const RL::Spline_function_3& u, double factor) {
  double error = 0, norm = 0;
  const RL::Triangulated_surface_3& surface = u.space().surface();
  for(std::size_t f = 0; f < surface.number_of_faces(); ++f)
    for(const RL::Triangle_quadrature_node& node : RL::triangle_quadrature(5)) {
      RL::Surface_location location;
      location.face = f;
      location.barycentric = {node.b0, node.b1, node.b2};
      const double expected = factor * harmonic(surface.surface_point(location).point);
      const double weight = node.weight * surface.area(f);
      error += weight * std::pow(u.value(location) - expected, 2);
      norm += weight * expected * expected;
    }
  return std::sqrt(error / norm);
}

Eigen::VectorXd random_load(const RL::Spline_space_3& space, unsigned seed) {
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal;
  std::vector<double> values(space.surface().number_of_vertices());
  for(double& v : values)
    v = normal(generator);
  return RL::assemble_load(space, RL::Linear_surface_function<double>(values));
}

} // namespace

TEST_CASE("poisson_on_the_sphere_converges_with_order_three", "[poisson][slow]") {
  // fine enough that its own error, of order 1/vertices, is below that of the splines
  const Mesh mesh = shapes::mesh(shapes::sphere(7));
  std::vector<double> errors;
  for(int depth = 2; depth <= 4; ++depth) {
    const RL::Spline_space_3 space(mesh, params::depth(depth));
    const RL::Operators operators = RL::assemble_operators(space);
    const RL::Poisson_solver solver(space, operators, 0, params::tolerance(1e-5));
    const Eigen::VectorXd load =
        RL::assemble_load(space, [](const RL::Surface_point& p) { return harmonic(p.point); });
    Eigen::VectorXd eta;
    const RL::Solve_report report = solver.solve(-load, eta);
    CHECK(report.converged);
    errors.push_back(relative_error(RL::Spline_function_3(space, eta), -1 / harmonic_eigenvalue));
  }
  INFO("errors " << errors[0] << " " << errors[1] << " " << errors[2]);
  CHECK(std::log2(errors[0] / errors[1]) >= 2.7);
  CHECK(std::log2(errors[1] / errors[2]) >= 2.7);
  CHECK(errors[2] <= 1.2e-3);
}

TEST_CASE("screened_poisson_on_the_sphere", "[poisson]") {
  Mesh mesh = shapes::mesh(shapes::sphere(6));
  auto u = mesh.add_property_map<Mesh::Vertex_index, double>("v:u").first;
  const double alpha = 3;
  const RL::Solve_report report = RL::solve_screened_poisson(
      mesh, [](const RL::Surface_point& p) { return 1 + harmonic(p.point); }, alpha, u,
      params::depth(4).tolerance(1e-5));
  CHECK(report.converged);
  // alpha u - Laplacian u = f, also for the constant part
  for(Mesh::Vertex_index v : mesh.vertices())
    REQUIRE(
        u[v] ==
        Approx(1 / alpha + harmonic(mesh.point(v)) / (alpha + harmonic_eigenvalue)).margin(1e-3));
}

TEST_CASE("solution_has_mean_zero_and_the_sign_of_the_laplacian", "[poisson]") {
  Mesh mesh = shapes::mesh(shapes::sphere(5));
  auto f = mesh.add_property_map<Mesh::Vertex_index, double>("v:f").first;
  auto u = mesh.add_property_map<Mesh::Vertex_index, double>("v:u").first;
  for(Mesh::Vertex_index v : mesh.vertices())
    f[v] = 5 + mesh.point(v).z(); // the 5 has to be removed
  const RL::Solve_report report = RL::solve_poisson(mesh, f, u, params::depth(4).tolerance(1e-5));
  CHECK(report.converged);
  for(Mesh::Vertex_index v : mesh.vertices())
    REQUIRE(u[v] == Approx(-mesh.point(v).z() / 2).margin(1e-3)); // Laplacian z = -2 z
  double mean = 0;
  for(auto face : mesh.faces())
    for(auto v : vertices_around_face(mesh.halfedge(face), mesh))
      mean += u[v];
  CHECK(std::abs(mean / num_faces(mesh)) <= 1e-4);
}

TEST_CASE("problems_in_a_space_are_those_on_its_mesh", "[poisson]") {
  const auto f = [](const RL::Surface_point& p) { return p.point.z() + p.point.x() - 0.2; };
  const auto weight = [](const RL::Surface_point& p) { return 1 + p.point.y() * p.point.y(); };
  for(const bool is_open : {false, true}) {
    const Mesh mesh = shapes::mesh(is_open ? shapes::rectangle(2, 1) : shapes::sphere(3));
    const auto np = params::depth(3).tolerance(1e-8);
    const RL::Spline_space_3 space(mesh, np);
    std::vector<double> u(mesh.number_of_vertices());
    const auto map = boost::make_iterator_property_map(u.begin(), get(boost::vertex_index, mesh));
    const auto agrees = [&](const RL::Poisson_solution& solution, const RL::Solve_report& report) {
      CHECK(solution.converged);
      CHECK(solution.iterations == report.iterations);
      CHECK(RL::Spline_function_3(space, solution.coefficients).values_at_vertices() == u);
    };
    RL::Solve_report report = RL::solve_poisson(mesh, f, map, np);
    agrees(RL::solve_poisson(space, f, np), report);
    CHECK(RL::solve_poisson(space, f, np).kernel_dimension == 1);
    report = RL::solve_screened_poisson(mesh, f, 3, map, np);
    agrees(RL::solve_screened_poisson(space, f, 3, np), report);
    CHECK(RL::solve_screened_poisson(space, f, 3, np).kernel_dimension == 0);
    report = RL::solve_screened_poisson(mesh, f, weight, map, np);
    agrees(RL::solve_screened_poisson(space, f, weight, np), report);
    if(is_open) {
      report = RL::solve_poisson(mesh, f, map, np.boundary_values(2.5));
      agrees(RL::solve_poisson(space, f, np.boundary_values(2.5)), report);
      report = RL::solve_poisson(mesh, f, map, np.boundary_values(weight));
      agrees(RL::solve_poisson(space, f, np.boundary_values(weight)), report);
    }
    CHECK_THROWS_AS(RL::solve_screened_poisson(space, f, 0), RL::Parameter_error);
  }
}

TEST_CASE("residual_in_the_report_is_the_true_one", "[poisson]") {
  const Mesh mesh = shapes::mesh(shapes::sphere(4));
  const RL::Spline_space_3 space(mesh, params::depth(4));
  const RL::Operators operators = RL::assemble_operators(space);
  const Eigen::VectorXd load = random_load(space, 3);
  const Eigen::VectorXd integrals = RL::assemble_element_integrals(space);
  const Eigen::VectorXd b = load - integrals * (load.sum() / integrals.sum());
  for(RL::Cycle cycle : {RL::Cycle::V, RL::Cycle::W})
    for(bool alone : {false, true})
      for(int steps : {1, 2, 3}) {
        const RL::Poisson_solver solver(
            space, operators, 0,
            params::cycle(cycle).stand_alone_multigrid(alone).smoothing_steps(steps).tolerance(
                5e-3));
        CHECK(solver.kernel_dimension() == 1);
        Eigen::VectorXd x;
        const RL::Solve_report report = solver.solve(load, x);
        INFO("cycle " << int(cycle) << " alone " << alone << " steps " << steps << " iterations "
                      << report.iterations);
        CHECK(report.converged);
        CHECK(report.relative_residual <= 5e-3);
        CHECK(report.relative_residual ==
              Approx((b - operators.stiffness * x).norm() / b.norm()).epsilon(1e-6));
        CHECK(std::abs(integrals.dot(x)) <= 1e-12 * integrals.dot(x.cwiseAbs()));
      }
}

TEST_CASE("columns_solved_together_equal_columns_solved_alone", "[poisson]") {
  const Mesh mesh = shapes::mesh(shapes::sphere(4));
  const RL::Spline_space_3 space(mesh, params::depth(3));
  const RL::Poisson_solver solver(space, 0, params::tolerance(1e-9));
  Eigen::MatrixXd b(space.dimension(), 7);
  for(int k = 0; k < 7; ++k)
    b.col(k) = random_load(space, k);
  b.col(2).setZero();
  Eigen::MatrixXd together;
  const RL::Solve_report report = solver.solve(b, together);
  CHECK(report.converged);
  REQUIRE(report.relative_residuals.size() == 7);
  for(int k = 0; k < 7; ++k) {
    Eigen::VectorXd alone;
    static_cast<void>(solver.solve(b.col(k), alone));
    // the cycles of one and of four columns round differently
    CHECK((together.col(k) - alone).norm() <= 1e-5 * alone.norm());
  }
  CHECK(together.col(2).norm() == 0);
}

TEST_CASE("a_first_guess_saves_iterations_and_changes_no_solution", "[poisson]") {
  const RL::Spline_space_3 space(shapes::mesh(shapes::sphere(4)), params::depth(3));
  const RL::Poisson_solver solver(space, 0, params::tolerance(1e-9));
  const RL::Sparse_matrix mass = RL::assemble_mass_matrix(space);
  RL::Solve_options from_guess;
  from_guess.has_first_guess = true;
  for(int columns : {1, 9}) {
    Eigen::MatrixXd b(space.dimension(), columns), solution;
    for(int k = 0; k < columns; ++k)
      b.col(k) = (k + 1) * random_load(space, k);
    const RL::Solve_report report = solver.solve(b, solution);
    const auto check = [&](const Eigen::MatrixXd& x, double tolerance) {
      for(int k = 0; k < columns; ++k) {
        const Eigen::VectorXd difference = x.col(k) - solution.col(k);
        CHECK(std::sqrt(difference.dot(mass * difference)) <=
              tolerance * std::sqrt(solution.col(k).dot(mass * solution.col(k))));
      }
    };
    // the solution, and a constant that does not matter
    Eigen::MatrixXd x = solution.array() + 3;
    CHECK(solver.solve(b, x, from_guess).iterations <= 1);
    check(x, 1e-8);
    // that of a problem nearby
    x = solution;
    const RL::Solve_report next = solver.solve(1.0001 * b, x, from_guess);
    CHECK(next.converged);
    CHECK(next.iterations < report.iterations);
    check(x / 1.0001, 1e-8);
    // one that is worse than none
    x = 1e6 * Eigen::MatrixXd::Random(b.rows(), columns);
    CHECK(solver.solve(b, x, from_guess).converged);
    check(x, 1e-8);

    const auto refused = [&](Eigen::MatrixXd guess) {
      try {
        static_cast<void>(solver.solve(b, guess, from_guess));
      } catch(const RL::Parameter_error& error) {
        return error.parameter();
      }
      return std::string();
    };
    CHECK(refused(x.topRows(5)) == "x");
    CHECK(refused(Eigen::MatrixXd()) == "x");
    x(3, columns - 1) = std::numeric_limits<double>::quiet_NaN();
    CHECK(refused(x) == "x");
  }
}

TEST_CASE("least_squares_end_when_the_error_does_not_show", "[poisson]") {
  const RL::Spline_space_3 space(shapes::mesh(shapes::sphere(4)), params::depth(4));
  const RL::Poisson_solver solver(space, 1, params::tolerance(1e-12));
  const Eigen::VectorXd b = random_load(space, 2);
  Eigen::VectorXd exact, x;
  const int iterations = solver.solve(b, exact).iterations;
  // so x^T A x - 2 b^T x + s has the minimum 1e-2 b^T x
  RL::Solve_options options;
  options.least_squares.squares = Eigen::VectorXd::Constant(1, 1.01 * b.dot(exact));
  options.least_squares.tolerance = 0.1;
  const RL::Solve_report report = solver.solve(b, x, options);
  CHECK(report.converged);
  CHECK(report.iterations < iterations);
  CHECK(report.relative_residual > 1e-12);
  // the square of the error is that of b^T x in conjugate gradients
  CHECK(b.dot(exact - x) <= 0.1 * 0.1 * 0.01 * b.dot(exact));
  const RL::Least_squares_criterion none = {options.least_squares.squares, 0};
  options.least_squares = none;
  CHECK(solver.solve(b, x, options).iterations == iterations);

  const auto refused = [&](const Eigen::VectorXd& squares, double tolerance) {
    options.least_squares = {squares, tolerance};
    try {
      static_cast<void>(solver.solve(b, x, options));
    } catch(const RL::Parameter_error& error) {
      return error.parameter() == "least_squares";
    }
    return false;
  };
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(refused(Eigen::VectorXd(), 0.1));
  CHECK(refused(Eigen::VectorXd::Ones(2), 0.1));
  CHECK(refused(Eigen::VectorXd::Constant(1, nan), 0.1));
  CHECK(refused(Eigen::VectorXd::Ones(1), -1));
  CHECK(refused(Eigen::VectorXd::Ones(1), nan));
}

TEST_CASE("solvers_of_several_weights_share_their_operators", "[poisson]") {
  for(bool is_paper_space : {false, true}) {
    const RL::Spline_space_3 space(shapes::mesh(shapes::sphere(4)),
                                   params::depth(4).paper(is_paper_space));
    const auto np = params::tolerance(1e-10);
    const std::vector<RL::Operators> operators = RL::multigrid_operators(space);
    const Eigen::VectorXd b = random_load(space, 1);
    for(double alpha : {0., 0.3, 100.}) {
      Eigen::VectorXd expected, x;
      CHECK(RL::Poisson_solver(space, alpha, np).solve(b, expected).converged);
      CHECK(RL::Poisson_solver(space, operators, alpha, np).solve(b, x).converged);
      CHECK((x - expected).dot(operators.back().stiffness * (x - expected)) <=
            1e-12 * expected.dot(operators.back().stiffness * expected));
    }
    CHECK_THROWS_AS(RL::Poisson_solver(space, operators, -1.), RL::Parameter_error);
    CHECK_THROWS_AS(RL::Poisson_solver(space, std::vector<RL::Operators>()), RL::Parameter_error);
    // levels of the space of the paper are not nested
    if(is_paper_space)
      CHECK_THROWS_AS(RL::Poisson_solver(space, RL::assemble_operators_of_levels(space, 3, 4)),
                      RL::Parameter_error);
  }
  // those of another space
  const RL::Spline_space_3 space(shapes::mesh(shapes::sphere(4)), params::depth(4)),
      other(shapes::mesh(shapes::box(1, 0.7, 0.4, 3, 1)), params::depth(4));
  CHECK_THROWS_AS(RL::Poisson_solver(space, RL::multigrid_operators(other)), RL::Parameter_error);
}

TEST_CASE("patches_cover_all_elements_and_colors_do_not_interact", "[poisson]") {
  for(const auto& soup : {shapes::sphere(4), shapes::box(1, 1, 0.03, 9, 1)}) {
    const Mesh mesh = shapes::mesh(soup);
    for(bool is_split : {false, true}) {
      const RL::Spline_space_3 space(mesh, params::depth(5).split(is_split));
      const RL::Sparse_matrix a = RL::assemble_stiffness_matrix(space);
      const RL::Smoothing_patches patches = RL::smoothing_patches(space, 5);
      CHECK(patches.number_of_patches == space.number_of_sheets(4));
      REQUIRE(patches.groups.back() == patches.number_of_patches);
      REQUIRE(patches.colors.back() == patches.groups.size() - 1);
      CHECK(patches.colors.size() == 9);
      std::vector<char> is_covered(space.dimension(), 0);
      for(std::size_t color = 0; color + 1 < patches.colors.size(); ++color) {
        // the group of this color that relaxes an unknown, and whether others need it
        std::vector<int> group_of(space.dimension(), -1);
        for(std::uint32_t g = patches.colors[color]; g < patches.colors[color + 1]; ++g)
          for(std::uint32_t p = patches.groups[g]; p < patches.groups[g + 1]; ++p)
            for(std::uint32_t i : patches.unknowns[p]) {
              REQUIRE((group_of[i] == -1 || group_of[i] == static_cast<int>(g)));
              group_of[i] = static_cast<int>(g);
              is_covered[i] = 1;
            }
        bool do_not_interact = true;
        for(int j = 0; j < a.cols(); ++j)
          for(RL::Sparse_matrix::InnerIterator i(a, j); i; ++i)
            do_not_interact = do_not_interact && (group_of[j] == -1 || group_of[i.row()] == -1 ||
                                                  group_of[j] == group_of[i.row()]);
        REQUIRE(do_not_interact);
      }
      CHECK(std::count(is_covered.begin(), is_covered.end(), 1) ==
            static_cast<std::ptrdiff_t>(space.dimension()));
    }
  }
}

TEST_CASE("iterations_do_not_depend_on_the_depth", "[poisson][slow]") {
  const Mesh mesh = shapes::mesh(shapes::sphere(5));
  int last = 0;
  for(int depth = 4; depth <= 6; ++depth) {
    const RL::Spline_space_3 space(mesh, params::depth(depth));
    const RL::Poisson_solver solver(space, 0, params::tolerance(1e-8));
    Eigen::VectorXd x;
    const Eigen::VectorXd b = random_load(space, 7);
    const RL::Solve_report report = solver.solve(b, x);
    INFO("depth " << depth << ": " << report.iterations);
    CHECK(report.converged);
    CHECK(report.iterations <= 12);
    if(depth > 4)
      CHECK(report.iterations <= 1.25 * last + 1);
    last = report.iterations;
    const Eigen::VectorXd integrals = RL::assemble_element_integrals(space),
                          load = b - integrals * (b.sum() / integrals.sum());
    CHECK(report.relative_residual ==
          Approx((load - solver.upper_half().selfadjointView<Eigen::Upper>() * x).norm() /
                 load.norm())
              .epsilon(1e-3));
  }
}

TEST_CASE("iterations_where_the_surface_lies_in_walls_or_is_ragged", "[poisson]") {
  // Sides of the box lie in walls, the rectangle does in the middle of its cube, and small
  // triangles apart from each other have more components than a coarse level can tell from
  // constants.
  shapes::Triangles scattered;
  for(int i = 0; i < 60; ++i)
    scattered = shapes::joined(
        scattered, shapes::moved(shapes::rectangle(0.05 + 0.003 * i, 0.02),
                                 RL::Vector_3(0.37 * (i % 7), 0.31 * (i / 7), 0.01 * i)));
  // pieces smaller than a cell are nearly dependent also along the surface
  for(const auto& [soup, bound] :
      {std::make_pair(shapes::box(1, 1, 1, 4, 1), 12),
       std::make_pair(shapes::rectangle(1, 0.7), 12), std::make_pair(scattered, 45)}) {
    const Mesh mesh = shapes::mesh(soup);
    for(int depth : {4, 5}) {
      const RL::Spline_space_3 space(mesh, params::depth(depth).cube_scale(8. / 6));
      Eigen::VectorXd x;
      const RL::Solve_report report =
          RL::Poisson_solver(space, 0, params::tolerance(1e-8)).solve(random_load(space, 1), x);
      INFO("depth " << depth << ": " << report.iterations);
      CHECK(report.converged);
      CHECK(report.iterations <= bound);
      CHECK(x.allFinite());
    }
  }
}

TEST_CASE("tiny_pieces_of_surface_in_cells_do_not_slow_the_solver", "[poisson]") {
  // Flat, in a wall between cells, and nearly flat.
  for(const double height : {0., 0.01})
    for(unsigned seed : {1, 2, 3}) {
      const Mesh mesh = shapes::mesh(shapes::ragged_square(48, height, seed));
      for(int depth : {4, 5}) {
        const RL::Spline_space_3 space(mesh, params::depth(depth));
        Eigen::VectorXd x;
        const RL::Solve_report report =
            RL::Poisson_solver(space, 0, params::tolerance(1e-8)).solve(random_load(space, 1), x);
        INFO("height " << height << ", seed " << seed << ", depth " << depth << ": "
                       << report.iterations);
        CHECK(report.converged);
        CHECK(report.iterations <= 9);
      }
    }
}

TEST_CASE("w_cycles_take_no_more_iterations_than_v_cycles", "[poisson]") {
  // Many pieces in few cells: the coarsest level is that of the root of the octree, the next one
  // has one patch, the whole surface, and is visited 64 times by each cycle.
  const Mesh mesh = shapes::mesh(shapes::bumpy_square(60, 0.003, 5, 1));
  const int depth = 7;
  const RL::Spline_space_3 space(mesh, params::depth(depth).cube_scale(2.2));
  REQUIRE(space.dimension(1) > 300);
  const Eigen::VectorXd b = random_load(space, 1);
  for(const auto& [c, alpha] :
      {std::make_pair(1e-3, 0.), std::make_pair(1e-3, 1e-6), std::make_pair(1e-5, 0.)}) {
    const auto report = [&, c = c, alpha = alpha](RL::Cycle cycle) {
      Eigen::VectorXd x;
      return RL::Poisson_solver(space, alpha, params::tolerance(1e-8).cycle(cycle).stabilization(c))
          .solve(b, x);
    };
    const RL::Solve_report v = report(RL::Cycle::V), w = report(RL::Cycle::W);
    INFO("c " << c << ", alpha " << alpha << ": " << v.iterations << ", " << w.iterations);
    CHECK(v.converged);
    CHECK(w.converged);
    CHECK(w.iterations <= v.iterations);
  }
}

TEST_CASE("stabilization_keeps_the_order_of_the_error", "[poisson][slow]") {
  const Mesh mesh = shapes::mesh(shapes::sphere(6));
  const auto f = [](const RL::Surface_point& p) { return harmonic(p.point); };
  std::vector<double> errors;
  for(int depth = 2; depth <= 4; ++depth) {
    const RL::Spline_space_3 space(mesh, params::depth(depth));
    Eigen::VectorXd eta;
    CHECK(RL::Poisson_solver(space, 0, params::tolerance(1e-8))
              .solve(-RL::assemble_load(space, f), eta)
              .converged);
    errors.push_back(relative_error(RL::Spline_function_3(space, eta), -1 / harmonic_eigenvalue));
  }
  INFO("errors " << errors[0] << " " << errors[1] << " " << errors[2]);
  CHECK(std::log2(errors[0] / errors[1]) >= 2);
  CHECK(std::log2(errors[1] / errors[2]) >= 2.5);
  CHECK(errors[2] <= 3.2e-3);
}

TEST_CASE("matrices_of_all_levels_at_once_make_the_same_solver", "[poisson]") {
  const Mesh mesh = shapes::mesh(shapes::sphere(4));
  for(bool is_paper_space : {false, true}) {
    const RL::Spline_space_3 space(mesh, params::depth(4).paper(is_paper_space));
    const double c = 0.01, alpha = 0.5;
    const RL::Operators operators = RL::assemble_operators(space, 4, c);
    const auto np = params::stabilization(c).tolerance(1e-10);
    const RL::Poisson_solver direct(space, alpha, np), galerkin(space, operators, alpha, np);
    CHECK((direct.upper_half() - galerkin.upper_half()).norm() <=
          1e-13 * galerkin.upper_half().norm());
    Eigen::VectorXd x, y;
    const Eigen::VectorXd b = random_load(space, 3);
    const RL::Solve_report report = direct.solve(b, x), other = galerkin.solve(b, y);
    CHECK(report.converged);
    CHECK(std::abs(report.iterations - other.iterations) <= 1);
    CHECK((x - y).norm() <= 1e-6 * x.norm());
  }
}

#ifdef CGAL_LINKED_WITH_TBB
TEST_CASE("solution_does_not_depend_on_threads", "[poisson][threads]") {
  const Mesh mesh = shapes::mesh(shapes::sphere(5));
  const auto solution = [&mesh](RL::Smoother_type smoother, const auto& np) {
    Mesh copy = mesh;
    auto u = copy.add_property_map<Mesh::Vertex_index, double>("v:u").first;
    static_cast<void>(RL::solve_poisson(
        copy, [](const RL::Surface_point& p) { return p.point.x() * p.point.y(); }, u,
        np.smoother(smoother).depth(5)));
    std::vector<double> values;
    for(Mesh::Vertex_index v : copy.vertices())
      values.push_back(u[v]);
    return values;
  };
  for(RL::Smoother_type smoother : {RL::Smoother_type::patch, RL::Smoother_type::point}) {
    const auto sequential = solution(smoother, params::concurrency_tag(CGAL::Sequential_tag()));
    CHECK(solution(smoother, params::concurrency_tag(CGAL::Parallel_tag())) == sequential);
  }
}
#endif

TEST_CASE("solver_needs_no_mesh", "[poisson]") {
  // the Laplacian of a path of three, and of a path of two beside it: two constants in the kernel
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(5, 5);
  dense.topLeftCorner(3, 3) << 1, -1, 0, -1, 2, -1, 0, -1, 1;
  dense.bottomRightCorner(2, 2) << 1, -1, -1, 1;
  RL::Sparse_matrix a = dense.sparseView();
  Eigen::VectorXd integrals(5), x;
  integrals << 1, 2, 1, 1, 3;
  const RL::Multigrid_solver solver(a, {}, integrals, 0);
  CHECK(solver.kernel_dimension() == 2);
  Eigen::VectorXd b(5);
  b << 1, 0, -1, 2, -2;
  CHECK(solver.solve(b, x).converged);
  Eigen::VectorXd expected(5);
  expected << 1, 0, -1, 1.5, -0.5; // mean 0 in each part, weighted with the integrals
  CHECK((x - expected).norm() <= 1e-11);
  // what is outside of the range is removed as a multiple of the integrals
  CHECK(solver.solve(Eigen::VectorXd(b + integrals), x).converged);
  CHECK((x - expected).norm() <= 1e-11);
}

TEST_CASE("matrices_that_are_not_semi_definite_are_refused", "[poisson]") {
  Eigen::MatrixXd dense(3, 3);
  dense << 2, -1, -1, -1, 2, -1, -1, -1, 2;
  const Eigen::VectorXd integrals = Eigen::VectorXd::Ones(3);
  const auto message = [&](int i, int j, double value) {
    Eigen::MatrixXd a = dense;
    a(i, j) = a(j, i) = value;
    try {
      RL::Multigrid_solver(a.sparseView(), {}, integrals);
    } catch(const RL::Parameter_error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CHECK(message(0, 0, 2).empty());
  CHECK(message(1, 1, -1e-16).empty());
  CHECK_THAT(message(1, 1, -2), Catch::Contains("row 1 is negative"));
  CHECK_THAT(message(0, 2, std::numeric_limits<double>::quiet_NaN()), Catch::Contains("finite"));
}

TEST_CASE("solution_agrees_with_a_direct_factorization", "[poisson]") {
  for(const std::string file : {"cow.off", "fandisk.off", "lion-head.off"}) {
    const Mesh mesh = shapes::read(cgal_mesh(file));
    if(mesh.is_empty())
      SKIP_TEST("no such file: " << file);
    INFO(file);
    const RL::Spline_space_3 space(mesh, params::depth(5));
    const RL::Operators operators = RL::assemble_operators(space);
    const double alpha = 1 / space.surface().area();
    const RL::Sparse_matrix a = operators.stiffness + alpha * operators.mass;
    const Eigen::VectorXd load =
        RL::assemble_load(space, [](const RL::Surface_point& p) { return p.point.x(); });

    Eigen::VectorXd x;
    const RL::Solve_report report =
        RL::Poisson_solver(space, operators, alpha, params::tolerance(1e-3)).solve(load, x);
    CHECK(report.converged);

    const Eigen::VectorXd scale = a.diagonal().cwiseSqrt().cwiseInverse();
    RL::Sparse_matrix identity(a.rows(), a.cols());
    identity.setIdentity();
    const RL::Sparse_matrix scaled = scale.asDiagonal() * a * scale.asDiagonal();
    const Eigen::SimplicialLDLT<RL::Sparse_matrix> cholesky(scaled + 1e-12 * identity);
    REQUIRE(cholesky.info() == Eigen::Success);
    const Eigen::VectorXd direct = scale.cwiseProduct(cholesky.solve(scale.cwiseProduct(load)));
    const Eigen::VectorXd difference = x - direct;
    CHECK(std::sqrt(difference.dot(operators.mass * difference)) <=
          3e-4 * std::sqrt(direct.dot(operators.mass * direct)));
  }
}

TEST_CASE("iterations_on_the_bunny", "[poisson][slow]") {
  const Mesh mesh = shapes::read(cgal_mesh("bunny00.off"));
  if(mesh.is_empty())
    SKIP_TEST("no such file: bunny00.off");
  const RL::Spline_space_3 space(mesh, params::depth(7));
  CHECK(space.dimension() == 139083); // our own output; the other one is that of a prototype
  CHECK(RL::Spline_space_3(mesh, params::depth(7).split(false)).dimension() == 138098);
  const RL::Poisson_solver solver(space, 0, params::tolerance(1e-8));
  Eigen::MatrixXd b(space.dimension(), 4), x;
  for(int axis = 0; axis < 3; ++axis)
    b.col(axis) =
        RL::assemble_load(space, [axis](const RL::Surface_point& p) { return p.point[axis]; });
  b.col(3) = random_load(space, 1);
  for(int column = 0; column < 4; ++column) {
    INFO("right-hand side " << column);
    CHECK(solver.solve(b.col(column), x, 5e-3).iterations <= 2);
    const RL::Solve_report report = solver.solve(b.col(column), x);
    CHECK(report.converged);
    CHECK(report.iterations <= 10);
  }
}

TEST_CASE("poisson_is_deterministic", "[poisson]") {
  Mesh mesh = shapes::mesh(shapes::sphere(4));
  auto u = mesh.add_property_map<Mesh::Vertex_index, double>("v:u").first;
  auto v = mesh.add_property_map<Mesh::Vertex_index, double>("v:v").first;
  const auto f = [](const RL::Surface_point& p) { return p.point.x() * p.point.y(); };
  static_cast<void>(RL::solve_poisson(mesh, f, u, params::depth(4)));
  static_cast<void>(RL::solve_poisson(mesh, f, v, params::depth(4)));
  for(Mesh::Vertex_index i : mesh.vertices())
    REQUIRE(u[i] == v[i]);
}

TEMPLATE_TEST_CASE("a_cycle_preconditions_solvers_of_eigen", "[poisson]", RL::Patch_smoother,
                   RL::Gauss_seidel_smoother) {
  using Preconditioner = RL::Multigrid_preconditioner<TestType>;
  using Sparse_matrix = Eigen::SparseMatrix<double>;
  const Mesh mesh = shapes::mesh(shapes::sphere(4));
  const RL::Spline_space_3 space(mesh, params::depth(4));
  const RL::Operators operators = RL::assemble_operators(space, space.depth(), 1e-3);
  const double alpha = 3;
  const Sparse_matrix a = operators.stiffness + alpha * operators.mass;
  const Eigen::VectorXd b =
      RL::assemble_load(space, [](const RL::Surface_point& s) { return harmonic(s.point); });

  const Preconditioner preconditioner(space, a);
  const Eigen::VectorXd c = a.col(7), bb = preconditioner.solve(b), bc = preconditioner.solve(c);
  CHECK(std::abs(c.dot(bb) - b.dot(bc)) <= 1e-8 * b.norm() * bc.norm());
  CHECK(b.dot(bb) > 0);

  Eigen::ConjugateGradient<Sparse_matrix, Eigen::Lower | Eigen::Upper, Preconditioner> solver;
  solver.preconditioner() = preconditioner;
  solver.setTolerance(1e-8);
  solver.compute(a);
  const Eigen::VectorXd x = solver.solve(b);
  Eigen::VectorXd expected;
  REQUIRE(RL::Poisson_solver(space, alpha, params::tolerance(1e-10)).solve(b, expected).converged);
  const Eigen::VectorXd error = x - expected;
  CHECK(error.dot(operators.mass * error) <= 1e-12 * expected.dot(operators.mass * expected));
  // Without a preconditioner 5,000 are not enough.
  CHECK(solver.iterations() <= (std::is_same_v<TestType, RL::Patch_smoother> ? 8 : 120));

  CHECK_THROWS_AS(preconditioner.solve(b.head(5)), RL::Parameter_error);
  CHECK_THROWS_AS(Preconditioner(space, Sparse_matrix(5, 5)), RL::Parameter_error);
  CHECK_THROWS_AS(Preconditioner(space, a, false, RL::Cycle::V, 0), RL::Parameter_error);
}
