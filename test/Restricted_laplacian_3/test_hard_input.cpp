// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Surfaces and right-hand sides that are legal but unpleasant, and errors of those who work by steps.

#include "catch.h"
#include "special_shapes.h"

#include <CGAL/Restricted_laplacian_3/solve_poisson.h>

#include <CGAL/Polyhedron_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace {

namespace RL = CGAL::Restricted_laplacian_3;
namespace params = CGAL::parameters;
using shapes::Mesh;

const double not_a_number = std::numeric_limits<double>::quiet_NaN();
const double infinity = std::numeric_limits<double>::infinity();
const double pi = 3.14159265358979323846;

/// name of the parameter in the Parameter_error that `call` throws; says so if it throws none
template <class Call> std::string refused_parameter(Call&& call) {
  try {
    call();
  } catch(const RL::Parameter_error& error) {
    CHECK(std::string(error.what()).find(error.parameter()) == 0);
    return error.parameter();
  }
  return "nothing refused";
}

struct Solution {
  RL::Solve_report report;
  std::vector<double> values; // at the vertices
};

template <class Function, class NamedParameters>
Solution solve(const shapes::Triangles& t, const Function& f, const NamedParameters& np) {
  const Mesh mesh = shapes::mesh(t);
  Solution result;
  result.values.resize(t.points.size());
  result.report = RL::solve_poisson(
      mesh, f,
      boost::make_iterator_property_map(result.values.begin(), get(boost::vertex_index, mesh)), np);
  return result;
}

double x_plus_z(const RL::Surface_point& p) { return p.point.x() + p.point.z(); }

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double result = 0;
  for(std::size_t i = 0; i < a.size(); ++i)
    result = (std::max)(result, std::isnan(a[i] - b[i]) ? infinity : std::abs(a[i] - b[i]));
  return result;
}

RL::Spline_space_3 space_of(const shapes::Triangles& t, int depth, double cube_scale = 1.1) {
  return RL::Spline_space_3(RL::Triangulated_surface_3(t.points, t.faces), depth, false,
                            cube_scale);
}

/// largest difference of two matrices, relative to the largest entry; infinite if sizes differ
double relative_difference(const RL::Sparse_matrix& a, const RL::Sparse_matrix& b) {
  if(a.rows() != b.rows())
    return infinity;
  return RL::Sparse_matrix(a - b).coeffs().abs().maxCoeff() / b.coeffs().abs().maxCoeff();
}

void check_same_operators(const RL::Spline_space_3& a, const RL::Spline_space_3& b,
                          double tolerance) {
  const RL::Operators of_a = RL::assemble_operators(a), of_b = RL::assemble_operators(b);
  CHECK(relative_difference(of_a.stiffness, of_b.stiffness) <= tolerance);
  CHECK(relative_difference(of_a.mass / a.surface().area(), of_b.mass / b.surface().area()) <=
        tolerance);
}

/// each triangle with vertices of its own
shapes::Triangles separated(const shapes::Triangles& t) {
  shapes::Triangles result;
  for(const auto& f : t.faces) {
    const auto first = static_cast<std::uint32_t>(result.points.size());
    for(std::uint32_t v : f)
      result.points.push_back(t.points[v]);
    result.faces.push_back({first, first + 1, first + 2});
  }
  return result;
}

} // namespace

TEST_CASE("every_exception_is_an_input_error_with_a_message", "[input]") {
  STATIC_REQUIRE(std::is_base_of<std::invalid_argument, RL::Input_error>::value);
  STATIC_REQUIRE(std::is_base_of<RL::Input_error, RL::Empty_surface_error>::value);
  STATIC_REQUIRE(std::is_base_of<RL::Input_error, RL::Zero_area_error>::value);
  STATIC_REQUIRE(std::is_base_of<RL::Input_error, RL::Invalid_face_error>::value);
  STATIC_REQUIRE(std::is_base_of<RL::Input_error, RL::Invalid_vertex_error>::value);
  STATIC_REQUIRE(std::is_base_of<RL::Input_error, RL::Parameter_error>::value);
  STATIC_REQUIRE(std::is_base_of<RL::Input_error, RL::Location_error>::value);
  STATIC_REQUIRE(!std::is_base_of<RL::Input_error, RL::Numerical_error>::value);
  CHECK(std::string(RL::Invalid_vertex_error(7, "is bad").what()) == "vertex 7 is bad");
  CHECK(std::string(RL::Invalid_face_error(8, "is bad").what()) == "face 8 is bad");
  CHECK(std::string(RL::Zero_area_error(9).what()).find("9 faces") != std::string::npos);
}

TEST_CASE("polygon_of_a_polyhedron_is_named", "[input]") {
  // a prism: two triangles, and three quadrangles after them
  CGAL::Polyhedron_3<CGAL::Simple_cartesian<double>> prism;
  CGAL::make_triangular_prism(RL::Point_3(0, 0, 0), RL::Point_3(1, 0, 0), RL::Point_3(0, 1, 0),
                              RL::Point_3(0, 0, 1), RL::Point_3(1, 0, 1), RL::Point_3(0, 1, 1),
                              prism);
  std::size_t first_quadrangle = 0;
  for(auto f : faces(prism)) {
    if(!is_triangle(halfedge(f, prism), prism))
      break;
    ++first_quadrangle;
  }
  REQUIRE(first_quadrangle < num_faces(prism));
  try {
    RL::read_surface(prism);
    FAIL("no exception");
  } catch(const RL::Invalid_face_error& error) {
    CHECK(error.face() == first_quadrangle);
  }
}

TEST_CASE("extents_whose_squares_are_no_numbers_are_refused", "[input]") {
  const shapes::Triangles t = shapes::sphere(1);
  for(double scale : {1e200, 1.7e308, 1e-200, 1e-310})
    CHECK(refused_parameter([&] { space_of(shapes::scaled(t, scale), 2); }) == "extent");
  for(double scale : {1e99, 1e-99}) {
    const RL::Spline_space_3 space = space_of(shapes::scaled(t, scale), 2);
    CHECK(space.surface().number_of_degenerate_faces() == 0);
    CHECK(space.surface().area() / scale / scale ==
          Approx(space_of(t, 2).surface().area()).epsilon(1e-14));
  }
  // far too large numbers at a vertex without a face do no harm
  shapes::Triangles with_lonely_vertex = t;
  with_lonely_vertex.points.emplace_back(1e300, infinity, not_a_number);
  CHECK(space_of(with_lonely_vertex, 2).dimension() == space_of(t, 2).dimension());
}

TEST_CASE("too_deep_octree_is_refused_before_any_work", "[input]") {
  // The faces of the octahedron have 1e11 cells each: one face alone would fill the memory.
  for(int depth : {15, 20})
    CHECK(refused_parameter([&] { space_of(shapes::sphere(0), depth); }) == "octree_depth");
  // a surface of few cells may have any depth
  const shapes::Triangles needle = {{{0, 0, 0}, {1, 0, 0}, {1, 1e-9, 0}}, {{0, 1, 2}}};
  const RL::Octree_3 octree(RL::Triangulated_surface_3(needle.points, needle.faces), 20, 1.1);
  CHECK(octree.number_of_cells(20) >= (std::size_t(1) << 20) / 1.2);
  CHECK(octree.number_of_cells(20) <= std::size_t(1) << 20);
}

TEST_CASE("results_are_equivariant_under_scaling", "[input]") {
  const shapes::Triangles t = shapes::box(1, 0.7, 0.4, 3, 1);
  const RL::Spline_space_3 reference = space_of(t, 4);
  const auto np = params::octree_depth(4, params::relative_tolerance(1e-6));
  const auto function = [](double scale) {
    return [scale](const RL::Surface_point& p) { return x_plus_z(p) / scale; };
  };
  const Solution expected = solve(t, function(1), np);
  for(double scale : {1e-99, 1e-9, 1e-6, 1e-3, 0.3, 1e3, 1e6, 1e9, 1e99}) {
    INFO("scale " << scale);
    const shapes::Triangles s = shapes::scaled(t, scale);
    const RL::Spline_space_3 space = space_of(s, 4);
    REQUIRE(space.dimension() == reference.dimension());
    check_same_operators(space, reference, 1e-12);
    const Solution solution = solve(s, function(scale), np);
    CHECK(solution.report.converged);
    CHECK(solution.report.iterations == expected.report.iterations);
    std::vector<double> scaled_back = solution.values;
    for(double& u : scaled_back)
      u = u / scale / scale;
    CHECK(largest_difference(scaled_back, expected.values) <= 1e-8);
  }
}

TEST_CASE("triangles_need_not_share_vertices_nor_an_orientation", "[input]") {
  const shapes::Triangles t = shapes::sphere(3), soup = separated(t);
  check_same_operators(space_of(soup, 4), space_of(t, 4), 1e-13);
  shapes::Triangles flipped = soup;
  std::mt19937 generator(1);
  for(auto& f : flipped.faces)
    if(generator() & 1u)
      std::swap(f[0], f[1]);
  check_same_operators(space_of(flipped, 4), space_of(t, 4), 1e-13);

  // A mesh cannot hold inconsistent orientations on one vertex, but a soup of triangles can.
  const Solution of_mesh = solve(t, x_plus_z, params::octree_depth(4)),
                 of_soup = solve(flipped, x_plus_z, params::octree_depth(4));
  CHECK(of_soup.report.iterations == of_mesh.report.iterations);
  for(std::size_t f = 0; f < t.faces.size(); ++f)
    for(int i = 0; i < 3; ++i)
      REQUIRE(of_soup.values[soup.faces[f][i]] ==
              Approx(of_mesh.values[t.faces[f][i]]).margin(1e-9));
}

TEST_CASE("surface_with_one_face_of_positive_area_is_that_face", "[input]") {
  shapes::Triangles t = {{{0, 0, 0}, {1, 0, 0.2}, {0, 1, 0.3}}, {{0, 1, 2}}};
  const RL::Spline_space_3 expected = space_of(t, 3);
  t.points.emplace_back(0.5, 0, 0.1);
  t.faces.insert(t.faces.begin(), {0, 0, 0});
  t.faces.push_back({0, 3, 1});
  t.faces.push_back({1, 1, 2});
  const RL::Spline_space_3 space = space_of(t, 3);
  CHECK(space.surface().number_of_faces() == 4);
  CHECK(space.surface().number_of_degenerate_faces() == 3);
  check_same_operators(space, expected, 1e-15);
  const std::vector<double> values =
      RL::Spline_function_3(space, Eigen::VectorXd::Ones(space.dimension())).values_at_vertices();
  CHECK(values[0] == Approx(1));
  CHECK(std::isnan(values[3])); // it has faces of area zero only
  RL::Surface_location location;
  location.face = 0;
  CHECK_THROWS_AS(
      RL::Spline_function_3(space, Eigen::VectorXd::Ones(space.dimension())).gradient(location),
      RL::Location_error);
}

TEST_CASE("square_has_the_solution_with_the_natural_boundary_condition", "[input]") {
  // Laplacian u = f on the unit square, u = cos(pi x): in a wall, between walls, and oblique
  struct Position {
    double cube_scale;
    RL::Vector_3 x, y;
  };
  const double c = std::sqrt(0.5);
  for(const Position& position :
      {Position{1, {1, 0, 0}, {0, 1, 0}}, Position{1.1, {0, 1, 0}, {0, 0, 1}},
       Position{1.1, {c, c, 0}, {0, 0, 1}}, Position{1.3, {0.6, 0, 0.8}, {-0.64, 0.6, 0.48}}}) {
    shapes::Triangles t = shapes::split_in_four(shapes::split_in_four(shapes::rectangle(1, 1)));
    std::vector<double> expected;
    for(RL::Point_3& p : t.points) {
      expected.push_back(std::cos(pi * p.x()));
      p = CGAL::ORIGIN + p.x() * position.x + p.y() * position.y;
    }
    const Solution solution = solve(
        t,
        [&](const RL::Surface_point& p) {
          return -pi * pi * std::cos(pi * ((p.point - CGAL::ORIGIN) * position.x));
        },
        params::octree_depth(
            4, params::relative_tolerance(1e-5, params::cube_scale(position.cube_scale))));
    CHECK(solution.report.converged);
    CHECK(largest_difference(solution.values, expected) <= 1e-3);
  }
}

TEST_CASE("thin_and_touching_surfaces_have_finite_solutions", "[input]") {
  const shapes::Triangles sphere = shapes::sphere(3);
  std::vector<std::pair<std::string, shapes::Triangles>> all;
  for(double gap : {1e-3, 1e-9, 0.}) // an element sees both spheres
    all.emplace_back("spheres", shapes::joined(sphere, shapes::moved(sphere, {2 + gap, 0, 0})));
  for(double height : {1e-3, 1e-9, 1e-12})
    all.emplace_back("box", shapes::box(1, 1, height, 3, 1));
  for(double width : {1e-3, 1e-9})
    all.emplace_back("strip", shapes::rectangle(1, width));
  all.emplace_back("twice the same", shapes::joined(sphere, sphere));
  all.emplace_back("stairs", shapes::stairs(8, 0.1));
  for(const auto& [name, t] : all)
    for(double cube_scale : {1., 1.1, 1e3, 1e6}) {
      INFO(name << ", " << t.points.size() << " vertices, cube scale " << cube_scale);
      const Mesh mesh = shapes::mesh(t);
      const RL::Spline_space_3 space(mesh, params::octree_depth(4, params::cube_scale(cube_scale)));
      const RL::Operators operators = RL::assemble_operators(space);
      CHECK(operators.mass.sum() == Approx(space.surface().area()).epsilon(1e-11));
      const RL::Poisson_solver solver = RL::make_poisson_solver(space, operators);
      CHECK(solver.kernel_dimension() == 1);
      Eigen::VectorXd u;
      const RL::Solve_report report = solver.solve(RL::assemble_load(space, x_plus_z), u);
      CHECK(report.converged);
      CHECK(u.allFinite());
      const double integral = RL::assemble_element_integrals(space).dot(u);
      CHECK(std::abs(integral) <= 1e-12 * RL::assemble_element_integrals(space).dot(u.cwiseAbs()));
    }
}

TEST_CASE("a_surface_covered_twice_has_the_same_solution", "[input]") {
  const shapes::Triangles sphere = shapes::sphere(3);
  const Solution once = solve(sphere, x_plus_z, params::octree_depth(4)),
                 twice = solve(shapes::joined(sphere, sphere), x_plus_z, params::octree_depth(4));
  CHECK(twice.report.iterations == once.report.iterations);
  std::vector<double> expected = once.values;
  expected.insert(expected.end(), once.values.begin(), once.values.end());
  CHECK(largest_difference(twice.values, expected) <= 1e-9);
}

TEST_CASE("right_hand_side_that_is_not_finite_is_refused", "[input]") {
  const shapes::Triangles t = shapes::sphere(2);
  for(double bad : {not_a_number, infinity, -infinity})
    CHECK(refused_parameter([&] {
            solve(
                t, [bad](const RL::Surface_point& p) { return p.face == 3 ? bad : 1.; },
                params::octree_depth(3));
          }) == "b");
  Mesh mesh = shapes::mesh(t);
  auto f = mesh.add_property_map<Mesh::Vertex_index, double>("v:f", 1.).first;
  auto u = mesh.add_property_map<Mesh::Vertex_index, double>("v:u", 5.).first;
  f[Mesh::Vertex_index(11)] = not_a_number;
  CHECK(refused_parameter([&] { RL::solve_poisson(mesh, f, u, params::octree_depth(3)); }) == "b");
  CHECK(refused_parameter(
            [&] { RL::solve_screened_poisson(mesh, f, 1, u, params::octree_depth(3)); }) == "b");
  for(Mesh::Vertex_index v : mesh.vertices()) // nothing was written
    REQUIRE(u[v] == 5);
}

TEST_CASE("iterations_end_at_their_limit", "[input]") {
  const shapes::Triangles t = shapes::sphere(3);
  const auto run = [&t](int iterations, bool alone) {
    return solve(t, x_plus_z,
                 params::octree_depth(
                     4, params::relative_tolerance(1e-12, params::stand_alone_multigrid(alone)))
                     .number_of_iterations(iterations))
        .report;
  };
  for(bool alone : {false, true})
    for(int limit : {0, 1, 2}) {
      const RL::Solve_report report = run(limit, alone);
      CHECK_FALSE(report.converged);
      CHECK(report.iterations == limit);
      CHECK(report.relative_residual > 1e-12);
      CHECK(report.relative_residual < 1);
    }
}

TEST_CASE("no_right_hand_side_is_solved_at_once", "[input]") {
  const RL::Spline_space_3 space = space_of(shapes::sphere(2), 3);
  const RL::Poisson_solver solver = RL::make_poisson_solver(space, RL::assemble_operators(space));
  Eigen::MatrixXd x;
  const RL::Solve_report report = solver.solve(Eigen::MatrixXd(space.dimension(), 0), x);
  CHECK(report.converged);
  CHECK(report.iterations == 0);
  CHECK(x.rows() == static_cast<Eigen::Index>(space.dimension()));
  CHECK(x.cols() == 0);
}

TEST_CASE("matrices_that_do_not_fit_are_refused", "[input]") {
  const RL::Spline_space_3 space = space_of(shapes::sphere(2), 3);
  const RL::Operators operators = RL::assemble_operators(space);
  const Eigen::VectorXd integrals = RL::assemble_element_integrals(space);
  CHECK(refused_parameter([&] {
          RL::Poisson_solver(operators.stiffness, {}, integrals.head(5));
        }) == "element_integrals");
  CHECK(refused_parameter([&] {
          RL::Poisson_solver(operators.stiffness.leftCols(5), {}, integrals.head(5));
        }) == "a");
  CHECK(refused_parameter([&] {
          RL::Poisson_solver(operators.stiffness, {RL::prolongation_matrix(space, 1)}, integrals);
        }) == "prolongations");
  const RL::Poisson_solver solver = RL::make_poisson_solver(space, operators);
  Eigen::VectorXd x;
  CHECK(refused_parameter([&] { solver.solve(Eigen::VectorXd::Zero(3), x); }) == "b");
}

TEST_CASE("locations_off_the_surface_are_refused", "[input]") {
  const RL::Spline_space_3 space = space_of(shapes::sphere(2), 4);
  const RL::Spline_function_3 one(space, Eigen::VectorXd::Ones(space.dimension()));
  RL::Surface_location location;
  for(const std::array<double, 3>& barycentric : {std::array<double, 3>{not_a_number, 0, 1},
                                                  {infinity, 0, 0},
                                                  {-infinity, 1, 1},
                                                  {1e300, 1e300, 1e300},
                                                  {100, -100, 1},
                                                  {0, 0, 0}}) {
    location.barycentric = barycentric;
    CHECK_THROWS_AS(one.value(location), RL::Location_error);
    CHECK_THROWS_AS(one.gradient(location), RL::Location_error);
  }
  location.barycentric = {1, 0, 0};
  CHECK(one.value(location) == Approx(1));
  location.face = (std::numeric_limits<std::size_t>::max)();
  CHECK_THROWS_AS(one.value(location), RL::Location_error);
  CHECK_THROWS_AS(RL::Monte_carlo(space, std::vector<RL::Surface_location>{location}),
                  RL::Location_error);
}

TEST_CASE("functions_are_written_to_their_own_mesh_only", "[input]") {
  const Mesh mesh = shapes::mesh(shapes::sphere(2)), smaller = shapes::mesh(shapes::sphere(1)),
             larger = shapes::mesh(shapes::sphere(3));
  const RL::Spline_space_3 space(mesh, params::octree_depth(3));
  const RL::Spline_function_3 one(space, Eigen::VectorXd::Ones(space.dimension()));
  for(const Mesh* other : {&smaller, &larger}) {
    const auto map = get(CGAL::dynamic_vertex_property_t<double>(), *other);
    CHECK(refused_parameter([&] { RL::evaluate_at_vertices(one, *other, map); }) == "tm");
  }
}
