// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Parts of the interface that the other tests do not call: each with a value that is known.

#include "catch.h"
#include "special_shapes.h"

#include <CGAL/Restricted_laplacian_3/assembly/Dirichlet_boundary.h>
#include <CGAL/Restricted_laplacian_3/fit_function.h>
#include <CGAL/Restricted_laplacian_3/input/point_areas.h>
#include <CGAL/Restricted_laplacian_3/input/vertex_functions.h>
#include <CGAL/Restricted_laplacian_3/integrate_gradient_field.h>
#include <CGAL/Restricted_laplacian_3/integration/Monte_carlo.h>
#include <CGAL/Restricted_laplacian_3/integration/cubature.h>
#include <CGAL/Restricted_laplacian_3/integration/shared/Function_moments.h>
#include <CGAL/Restricted_laplacian_3/problems/Curvature_field.h>
#include <CGAL/Restricted_laplacian_3/problems/Function_fitter.h>
#include <CGAL/Restricted_laplacian_3/problems/Multigrid_preconditioner.h>
#include <CGAL/Restricted_laplacian_3/solve_poisson.h>
#include <CGAL/Restricted_laplacian_3/solvers/shared/Mean_projection.h>
#include <CGAL/Restricted_laplacian_3/spectra/zero_eigenvalues.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_function_3.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_functions_3.h>
#include <CGAL/Restricted_laplacian_3/splines/evaluation_matrix.h>
#include <CGAL/Restricted_laplacian_3/splines/prolongation.h>
#include <CGAL/Restricted_laplacian_3/surface/sample_surface.h>

#include <CGAL/Real_timer.h>
#include <CGAL/property_map.h>

#include <Eigen/IterativeLinearSolvers>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace {

namespace RL = CGAL::Restricted_laplacian_3;
namespace params = RL::parameters;
using shapes::Mesh;

Eigen::Vector3d coordinates(const RL::Surface_point& p) {
  return {p.point.x(), p.point.y(), p.point.z()};
}

/// not a constant, not linear, and different for each channel
RL::Vector_3 linear_field(const RL::Point_3& p) {
  return {1 + p.x() - 2 * p.y(), 0.5 * p.z() + p.x(), 3 - p.y()};
}

/// a function of as many components as one wants, which counts its calls
class Powers {
public:
  explicit Powers(int components) : m_components(components) {}

  int components() const { return m_components; }
  int degree() const { return 3; }
  void operator()(const RL::Surface_point* points, std::size_t number, double* values) const {
    ++calls;
    evaluations += number;
    for(std::size_t i = 0; i < number; ++i)
      for(int k = 0; k < m_components; ++k)
        *values++ = std::pow(points[i].point.x() + 2, k % 3) + points[i].point.z();
  }

  mutable std::size_t calls = 0, evaluations = 0;

private:
  int m_components;
};

} // namespace

TEST_CASE("functions_may_evaluate_themselves_at_many_points", "[interface]") {
  const shapes::Triangles sphere = shapes::sphere(3);
  const RL::Spline_space_3 space(RL::soup(sphere.points, sphere.faces), params::depth(3));
  const Powers powers(6);
  const RL::Surface_function_view view(powers);
  CHECK(view.components() == 6);
  CHECK(view.degree() == 3);
  CHECK(RL::Surface_function_view(view).components() == 6);
  const auto by_point = RL::function_of_degree(
      [&](const RL::Surface_point& p) {
        Eigen::Matrix<double, 6, 1> value;
        Powers(6)(&p, 1, value.data());
        return value;
      },
      3);
  CHECK(RL::assemble_component_loads(space, powers) ==
        RL::assemble_component_loads(space, by_point));
  CHECK(8 * powers.calls < powers.evaluations);
  // as two vectors
  const auto field = RL::function_of_degree(
      [&](const RL::Surface_point& p) {
        Eigen::Matrix<double, 3, 2> value;
        Powers(6)(&p, 1, value.data());
        return value;
      },
      3);
  CHECK(RL::Vector_field_view(powers).channels() == 2);
  CHECK(RL::assemble_gradient_loads(space, powers) == RL::assemble_gradient_loads(space, field));
  CHECK(RL::Function_fitter(space).fit(powers).coefficients ==
        RL::Function_fitter(space).fit(by_point).coefficients);
}

TEST_CASE("evaluation_matrices_give_the_values_of_functions", "[interface]") {
  shapes::Triangles t = shapes::box(1, 0.7, 0.4, 3, 1);
  t.points.emplace_back(0.3, 0.2, 0.1); // of no face
  const RL::Spline_space_3 space(RL::soup(t.points, t.faces), params::depth(4));
  const auto locations = RL::sample_surface(space.surface(), 60, 1);
  for(int level : {2, 4}) {
    const auto n = static_cast<Eigen::Index>(space.dimension(level));
    const Eigen::MatrixXd h =
        Eigen::MatrixXd::Random(n, 2); // fixed by the generator of the C library
    const RL::Spline_functions_3 u(space, h, level);
    const RL::Spline_jets jets = u.jets_at_locations(locations);
    const auto differ = [](const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
      return (a - b).cwiseAbs().maxCoeff() / (1 + b.cwiseAbs().maxCoeff());
    };
    CHECK(differ(RL::evaluation_matrix(space, locations, level) * h, jets.values) < 1e-13);
    for(int axis = 0; axis < 3; ++axis)
      CHECK(differ(RL::derivative_matrix(space, axis, locations, level) * h,
                   jets.derivatives[axis]) < 1e-13);
    const Eigen::MatrixXd at_vertices = u.values_at_vertices();
    const RL::Sparse_matrix e = RL::evaluation_matrix(space, level);
    const Eigen::Index last = at_vertices.rows() - 1;
    CHECK(std::isnan(at_vertices(last, 0)));
    CHECK((e * h).row(last).isZero(0));
    CHECK(differ((e * h).topRows(last), at_vertices.topRows(last)) < 1e-13);
    for(int axis = 0; axis < 3; ++axis)
      CHECK(differ((RL::derivative_matrix(space, axis, level) * h).topRows(last),
                   u.jets_at_vertices().derivatives[axis].topRows(last)) < 1e-13);
    const Eigen::VectorXd sums = e * Eigen::VectorXd::Ones(n);
    CHECK((sums.head(last).array() - 1).abs().maxCoeff() < 1e-14);
  }
  CHECK_THROWS_AS(RL::derivative_matrix(space, 3), RL::Parameter_error);
  CHECK_THROWS_AS(RL::evaluation_matrix(space, 5), RL::Parameter_error);
}

TEST_CASE("options_say_what_named_parameters_say", "[interface]") {
  RL::Spline_space_options of_space;
  of_space.depth = 3;
  of_space.cube_scale = 1.3;
  const shapes::Triangles sphere = shapes::sphere(3);
  const RL::Spline_space_3 space(RL::Triangulated_surface_3(sphere.points, sphere.faces), of_space);
  CHECK(space.dimension() ==
        RL::Spline_space_3(shapes::mesh(sphere), params::depth(3).cube_scale(1.3)).dimension());
  const auto f = [](const RL::Surface_point& p) { return p.point.x() * p.point.y(); };
  const auto g = [](const RL::Surface_point& p) { return 1 + p.point.z() * p.point.z(); };
  int calls = 0;
  const auto count = [&](double) {
    ++calls;
    return true;
  };

  {
    RL::Poisson_problem problem(f);
    problem.alpha_function = g;
    problem.stabilization = 0.01;
    problem.solver.tolerance = 1e-9;
    problem.progress = count;
    const RL::Poisson_solution solution = RL::solve_poisson_problem(space, problem);
    CHECK(solution.converged);
    CHECK(calls > 2);
    CHECK(solution.coefficients ==
          RL::solve_screened_poisson(space, f, g, params::stabilization(0.01).tolerance(1e-9))
              .coefficients);
    // each option counts
    const auto differs = [&](const RL::Poisson_problem& other) {
      return RL::solve_poisson_problem(space, other).coefficients != solution.coefficients;
    };
    RL::Poisson_problem other = problem;
    other.alpha_function.reset();
    CHECK(differs(other));
    other = problem;
    other.stabilization.reset();
    CHECK(differs(other));
    other = problem;
    other.solver.tolerance.reset();
    CHECK(differs(other));
    CHECK(RL::solve_poisson_problem(space, RL::Poisson_problem(f)).coefficients ==
          RL::solve_poisson(space, f).coefficients);
    RL::Poisson_problem with_number(f);
    with_number.alpha = 3;
    CHECK(RL::solve_poisson_problem(space, with_number).coefficients ==
          RL::solve_screened_poisson(space, f, 3).coefficients);
    // a value at a point
    const RL::Surface_location center = {5, {1. / 3, 1. / 3, 1. / 3}};
    with_number.constraints.emplace(space);
    with_number.constraints->add(center, 2, 1e6);
    with_number.solver.tolerance = 1e-9;
    const RL::Poisson_solution constrained = RL::solve_poisson_problem(space, with_number);
    CHECK(RL::Spline_function_3(space, constrained.coefficients).value(center) ==
          Approx(2).epsilon(1e-3));
    // prescribed values have a smaller tolerance, unless told otherwise
    with_number.solver.tolerance.reset();
    CHECK(RL::solve_poisson_problem(space, with_number).relative_residual <= 1e-7);
    with_number.solver.tolerance = 1e-3;
    CHECK(RL::solve_poisson_problem(space, with_number).relative_residual > 1e-7);
  }
  {
    RL::Function_fit_options options;
    options.smoothing = 0.1;
    options.refinements = 1;
    options.solver.tolerance = 1e-6;
    const auto fit = [&](const RL::Function_fit_options& o) {
      return RL::Function_fitter(space, o).fit(f).coefficients;
    };
    const Eigen::MatrixXd expected = fit(options);
    CHECK(expected ==
          RL::fit_function(space, f, params::smoothing(0.1).refinements(1).tolerance(1e-6))
              .coefficients);
    RL::Function_fit_options other = options;
    other.refinements = 0;
    CHECK(fit(other) != expected);
    other = options;
    other.smoothing = 0;
    CHECK(fit(other) != expected);
    other = options;
    other.stabilization = 0.1;
    CHECK(fit(other) != expected);
    other = options;
    other.solver.tolerance.reset();
    other.energy_tolerance = 0;
    CHECK(fit(other) != expected);
  }
  {
    RL::Curvature_options options;
    options.smoothing = 0.01;
    options.refinements = 2;
    options.energy_tolerance = 0;
    options.solver.tolerance = 1e-10;
    calls = 0;
    options.progress = count;
    const auto np = params::smoothing(0.01).refinements(2).energy_tolerance(0.);
    const auto values = [](const RL::Curvature_field& field) {
      std::vector<double> result;
      for(const RL::Surface_curvature& curvature : field.at_vertices())
        result.push_back(curvature.mean);
      return result;
    };
    const std::vector<double> expected = values(RL::estimate_curvature(space, options));
    CHECK(expected == values(RL::estimate_curvature(space, np.tolerance(1e-10))));
    CHECK(calls > 2);
    const auto differs = [&](const RL::Curvature_options& other) {
      return values(RL::estimate_curvature(space, other)) != expected;
    };
    RL::Curvature_options other = options;
    other.smoothing.reset();
    CHECK(differs(other));
    other = options;
    other.refinements.reset();
    CHECK(differs(other));
    other = options;
    other.energy_tolerance.reset();
    CHECK(differs(other));
    other = options;
    other.stabilization = 0.1;
    CHECK(differs(other));
    other = options;
    other.solver.tolerance.reset();
    CHECK(differs(other));
    options = RL::Curvature_options();
    options.method = RL::Curvature_method::coordinates;
    CHECK(values(RL::estimate_curvature(space, options)) ==
          values(RL::estimate_curvature(space, params::method(RL::Curvature_method::coordinates))));
    CHECK(values(RL::estimate_curvature(space)) != values(RL::estimate_curvature(space, options)));
  }
  {
    const auto v = [](const RL::Surface_point& p) { return linear_field(p.point); };
    RL::Gradient_options options;
    RL::Gradient_screening& screening = options.screening;
    CHECK(!screening.has_weight());
    CHECK(screening.mean_or_zero(2) == Eigen::Vector2d(0, 0));
    screening.target = f;
    screening.weight_function = g;
    CHECK(screening.has_weight());
    options.stabilization = 1e-4;
    options.solver.tolerance = 1e-8;
    calls = 0;
    options.progress = count;
    const RL::Gradient_fit fit = RL::integrate_gradient_field(space, v, options);
    CHECK(fit.converged);
    CHECK(calls > 2);
    CHECK(fit.coefficients ==
          RL::integrate_gradient_field(
              space, v, params::target(f).alpha(g).stabilization(1e-4).tolerance(1e-8))
              .coefficients);
  }
}

TEST_CASE("values_at_vertices_are_interpolated_linearly", "[interface]") {
  Mesh mesh = shapes::mesh(shapes::box(1, 0.7, 0.4, 2, 3));
  auto map = mesh.add_property_map<Mesh::Vertex_index, RL::Vector_3>("v:field").first;
  std::vector<double> first_component(mesh.number_of_vertices());
  for(Mesh::Vertex_index v : mesh.vertices()) {
    map[v] = linear_field(mesh.point(v));
    first_component[v] = map[v].x();
  }
  const RL::Spline_space_3 space(mesh, params::depth(3));
  const auto of_components = RL::vertex_function(mesh, map);
  const auto field = RL::function_of_degree(
      [&](const RL::Surface_point& p) {
        const Eigen::Vector3d v = of_components(p);
        return RL::Vector_3(v[0], v[1], v[2]);
      },
      of_components.degree());
  CHECK(field.degree() == 1);
  const auto function =
      RL::vertex_function(space.surface(), CGAL::make_property_map(first_component));
  for(const RL::Surface_location& location : RL::sample_surface(space.surface(), 50, 1)) {
    const RL::Surface_point p = space.surface().surface_point(location);
    const RL::Vector_3 expected = linear_field(p.point);
    CHECK((field(p) - expected).squared_length() <= 1e-28);
    CHECK(function(p) == Approx(expected.x()).epsilon(1e-13));
  }
  const auto cubic = [](const RL::Surface_point& p) { return p.point.x() * p.point.x(); };
  const RL::Function_of_degree<std::decay_t<decltype(cubic)>> of_degree =
      RL::function_of_degree(cubic, 3);
  CHECK(RL::Surface_function_view(of_degree).degree() == 3);
  const RL::Vector_field_view view(field);
  CHECK(view.channels() == 1);
  CHECK(view.components() == 3);
  CHECK(view.degree() == 1);
  const Eigen::VectorXd load = RL::assemble_gradient_load(space, field),
                        expected = RL::assemble_gradient_load(
                            space, [](const RL::Surface_point&p) { return linear_field(p.point); });
  CHECK((load - expected).norm() <= 1e-13 * expected.norm());
}

TEST_CASE("fitters_reproduce_coordinates", "[interface]") {
  const Mesh mesh = shapes::mesh(shapes::box(1, 0.7, 0.4, 2, 3));
  const RL::Spline_space_3 space(mesh, params::depth(3));
  RL::Function_fitter other(space, params::stabilization(0.5));
  CHECK(&other.space().octree() == &space.octree());
  CHECK(other.options().stabilization == 0.5);
  RL::Function_fitter fitter(space);
  const RL::Function_fit fit = fitter.fit(coordinates);
  CHECK(fit.converged);
  REQUIRE(fit.root_mean_square_errors.size() == 3);
  for(double error : fit.root_mean_square_errors)
    CHECK(error <= 1e-6);
  const RL::Spline_functions_3 functions(space, fit.coefficients);
  const auto locations = RL::sample_surface(space.surface(), 50, 1);
  const RL::Spline_jets jets = functions.jets_at_locations(locations),
                        at_vertices = functions.jets_at_vertices();
  CHECK(jets.values == functions.values_at_locations(locations));
  CHECK(at_vertices.values == functions.values_at_vertices());
  for(std::size_t i = 0; i < locations.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const RL::Surface_point p = space.surface().surface_point(locations[i]);
    for(int k = 0; k < 3; ++k) {
      CHECK(jets.values(row, k) == Approx(p.point[k]).margin(1e-5));
      const RL::Vector_3 derivative(jets.derivatives[0](row, k), jets.derivatives[1](row, k),
                                    jets.derivatives[2](row, k));
      const RL::Vector_3 axis(k == 0, k == 1, k == 2),
          error = derivative - axis - ((derivative - axis) * p.normal) * p.normal;
      CHECK(error.squared_length() <= 1e-6);
      const RL::Vector_3 gradient =
          RL::Spline_function_3(space, fit.coefficients.col(k)).gradient(locations[i]);
      CHECK((derivative - (derivative * p.normal) * p.normal - gradient).squared_length() <= 1e-20);
    }
  }
  for(Mesh::Vertex_index v : mesh.vertices())
    for(int axis = 0; axis < 3; ++axis)
      CHECK(at_vertices.values(static_cast<Eigen::Index>(v), axis) ==
            Approx(mesh.point(v)[axis]).margin(1e-5));

  // options of the solver are kept
  const auto one_step = params::maximum_iterations(1).tolerance(1e-12);
  CHECK_FALSE(RL::Function_fitter(space, one_step).fit(coordinates).converged);

  // from loads, after a move of the fitter
  other = std::move(fitter);
  const RL::Function_fit again =
      other.project(RL::assemble_component_loads(space, coordinates, space.depth()));
  CHECK(again.root_mean_square_errors.empty());
  CHECK((RL::Spline_functions_3(space, again.coefficients).values_at_locations(locations) -
         jets.values)
            .cwiseAbs()
            .maxCoeff() <= 1e-3);
}

TEST_CASE("conormals_have_the_divergence_of_the_coordinates", "[interface]") {
  // the integral of the conormal times a coordinate is the area in the plane, along either axis
  const Mesh mesh = shapes::mesh(shapes::rectangle(1, 0.6));
  const RL::Spline_space_3 space(mesh, params::depth(3));
  const Eigen::MatrixXd x = RL::Function_fitter(space).fit(coordinates).coefficients,
                        of_conormals = RL::Boundary_integration(space).conormal_loads();
  REQUIRE(of_conormals.cols() == 3);
  const Eigen::Matrix3d integrals = x.transpose() * of_conormals,
                        expected = Eigen::Vector3d(0.6, 0.6, 0).asDiagonal();
  CHECK((integrals - expected).cwiseAbs().maxCoeff() <= 1e-5);
  CHECK(of_conormals.colwise().sum().cwiseAbs().maxCoeff() <= 1e-14);
}

TEST_CASE("penalties_of_boundaries_are_bounded", "[interface]") {
  // A sliver reaches 1e-5 cells beyond a wall: the penalty that its sheet needs has no limit.
  const double h = 0.125;
  const Mesh mesh = shapes::mesh({{{0, 0, 0}, {1, 0, 0}, {4 * h + 1e-5 * h, 1, 0}}, {{0, 1, 2}}});
  const RL::Spline_space_3 space(mesh, params::depth(3).cube_scale(1.));
  const RL::Dirichlet_boundary boundary(space);
  RL::Sparse_matrix a = RL::assemble_stiffness_matrix(space);
  const RL::Sparse_matrix s = a;
  boundary.add_to_matrix(a);
  const double penalty = (a - s).eval().sum() / boundary.length();
  CHECK(penalty > 1 / h);
  CHECK(penalty <= RL::Dirichlet_boundary::largest_penalty / h);
}

TEST_CASE("defaults_are_those_of_the_manual", "[interface]") {
  const Mesh mesh = shapes::mesh(shapes::sphere(2));
  const RL::Spline_space_3 space(mesh, params::depth(3)), paper(mesh, params::depth(3).paper(true));
  CHECK(RL::default_stabilization(space) == 1e-3);
  CHECK(RL::default_stabilization(paper) == 0);
  CHECK(RL::default_spectrum_stabilization(space) == 1e-5);
  CHECK(RL::default_spectrum_stabilization(paper) == 0);
  CHECK(RL::default_curvature_stabilization == 0.01);
  CHECK(space.octree().wall_tolerance(0) == RL::Octree_3::relative_wall_tolerance);
  CHECK(space.checked_level(3) == 3);
  CHECK_THROWS_AS(space.checked_level(4), RL::Parameter_error);

  std::vector<RL::Vector_3> normals;
  const std::vector<RL::Point_3> points = shapes::sphere(4).points;
  for(const RL::Point_3& p : points)
    normals.push_back(p - CGAL::ORIGIN);
  CHECK(RL::default_number_of_neighbors == 16);
  const std::vector<double> areas = RL::estimate_point_areas(points, normals);
  CHECK(areas == RL::estimate_point_areas(points, normals, RL::default_number_of_neighbors));
  CHECK(areas != RL::estimate_point_areas(points, normals, 8));
  const RL::Triangulated_surface_3 cloud(points, normals, areas);
  const int depth = RL::default_depth(cloud, 1.1);
  CHECK(depth == 1); // 1026 points: 128 in each of 8 cells, of 56 cells less than 50 in each
  CHECK_THROWS_WITH(cloud.require_triangles("this test"), Catch::Contains("this test"));
  CHECK_NOTHROW(space.surface().require_triangles("this test"));
}

TEST_CASE("default_depth", "[interface]") {
  // The unit square, n times split in four: sides have a mean length of (2 + sqrt(2)) / (3 2^n),
  // half of 2.27614 / 2^n.
  const auto depth_of = [](int n, double cube_scale, double factor = 1) {
    shapes::Triangles t = shapes::rectangle(1, 1);
    for(int i = 0; i < n; ++i)
      t = shapes::split_in_four(t);
    t = shapes::scaled(t, factor);
    return RL::default_depth(RL::Triangulated_surface_3(t.points, t.faces), cube_scale);
  };
  for(int n : {0, 4, 5, 6, 7, 8, 9}) {
    CAPTURE(n);
    const int depth = (std::min)((std::max)(n, 5), 8);
    CHECK(depth_of(n, 1.2) == depth);
    CHECK(depth_of(n, 2.276) == depth);
    CHECK(depth_of(n, 2.277) == (std::min)((std::max)(n + 1, 5), 8));
  }
  CHECK(depth_of(6, 2.276, 1e-60) == 6);
  CHECK(depth_of(6, 2.277, 1e60) == 7);
  CHECK_THROWS_AS(depth_of(1, 0.5), RL::Parameter_error);

  shapes::Triangles t = shapes::rectangle(1, 1);
  for(int i = 0; i < 6; ++i)
    t = shapes::split_in_four(t);
  const Mesh mesh = shapes::mesh(t);
  CHECK(RL::Spline_space_3(mesh).depth() == 5);                      // the side of the cube is 1.1
  CHECK(RL::Spline_space_3(mesh, params::paper(true)).depth() == 6); // 1.2
  CHECK(RL::Spline_space_3(mesh, params::cube_scale(2.3)).depth() == 7);
  CHECK(RL::Spline_space_3(mesh, params::depth(3)).depth() == 3);
}

TEST_CASE("extents_are_limited", "[interface]") {
  const auto extent = [](double length) {
    const shapes::Triangles t = shapes::scaled(shapes::rectangle(1, 1), length);
    return RL::Triangulated_surface_3(t.points, t.faces).extent();
  };
  const double smallest = RL::Triangulated_surface_3::smallest_extent,
               largest = RL::Triangulated_surface_3::largest_extent;
  CHECK(smallest == 1e-100);
  CHECK(largest == 1e100);
  CHECK(extent(smallest) == smallest);
  CHECK(extent(largest) == largest);
  CHECK_THROWS_AS(extent(0.999 * smallest), RL::Parameter_error);
  CHECK_THROWS_AS(extent(1.001 * largest), RL::Parameter_error);
}

TEST_CASE("eigenvalues_are_zero_up_to_the_tolerance", "[interface]") {
  const double largest = 50;
  Eigen::VectorXd eigenvalues(4);
  eigenvalues << -0.9, 0.9, 1.1, largest / (largest * RL::zero_eigenvalue_tolerance);
  eigenvalues *= largest * RL::zero_eigenvalue_tolerance;
  CHECK(RL::number_of_zero_eigenvalues(eigenvalues) == 2);
}

TEST_CASE("prolongations_of_all_levels", "[interface]") {
  const RL::Spline_space_3 space(shapes::mesh(shapes::sphere(2)), params::depth(4));
  for(int coarsest : {0, 2, 4}) {
    const std::vector<RL::Sparse_matrix> all = RL::prolongation_matrices(space, coarsest);
    REQUIRE(all.size() == static_cast<std::size_t>(4 - coarsest));
    for(std::size_t i = 0; i < all.size(); ++i) {
      const RL::Sparse_matrix p = RL::prolongation_matrix(space, coarsest + static_cast<int>(i));
      CHECK(p.rows() == all[i].rows());
      CHECK((p - all[i]).norm() == 0);
      // constants are prolongated to constants
      CHECK((all[i] * Eigen::VectorXd::Ones(p.cols()) - Eigen::VectorXd::Ones(p.rows()))
                .cwiseAbs()
                .maxCoeff() <= 1e-15);
    }
  }
}

TEST_CASE("reports_say_how_long_it_took", "[interface]") {
  Mesh mesh = shapes::mesh(shapes::sphere(2));
  auto u = mesh.add_property_map<Mesh::Vertex_index, double>("v:u").first;
  const auto z = [](const RL::Surface_point& p) { return p.point.z(); };
  CGAL::Real_timer timer;
  timer.start();
  const RL::Solve_report report = RL::solve_poisson(mesh, z, u, params::depth(3));
  const double elapsed = timer.time();
  for(double seconds :
      {report.space_seconds, report.assembly_seconds, report.setup_seconds, report.solve_seconds})
    CHECK(seconds > 0);
  CHECK(report.space_seconds + report.assembly_seconds + report.setup_seconds +
            report.solve_seconds <=
        elapsed);

  const RL::Spline_space_3 space(mesh, params::depth(3));
  RL::Poisson_solver solver(space);
  CHECK(solver.setup_seconds() > 0);
  CHECK(solver.mean_projection().kernel_dimension() == 1);
  const Eigen::VectorXd load = -RL::assemble_load(space, z);
  Eigen::VectorXd x, y;
  const RL::Solve_report of_load = solver.solve(load, x);
  CHECK(of_load.setup_seconds == solver.setup_seconds());
  CHECK(of_load.space_seconds == 0);
  // a solver that is moved to another one solves the same
  RL::Poisson_solver other(space, 5.);
  static_cast<void>(other.solve(load, y));
  CHECK(x != y);
  other = std::move(solver);
  static_cast<void>(other.solve(load, y));
  CHECK(x == y);

  timer.reset();
  const RL::Gradient_report of_gradients = RL::integrate_gradient_field(
      mesh, RL::vertex_gradients(mesh, u), u, params::depth(3).details(true));
  CHECK(of_gradients.details_seconds > 0);
  CHECK(of_gradients.details_seconds + of_gradients.solve_seconds <= timer.time());
}

TEST_CASE("neighborhoods_do_not_change_solutions", "[interface]") {
  const RL::Spline_space_3 space(shapes::mesh(shapes::sphere(3)), params::depth(4));
  const RL::Operators operators = RL::assemble_operators(space, space.depth(), 1e-3);
  const Eigen::VectorXd integrals = RL::assemble_element_integrals(space),
                        b = operators.mass.col(7);
  std::array<Eigen::VectorXd, 2> solutions;
  for(int i = 0; i < 2; ++i) {
    RL::Multigrid_levels levels = RL::multigrid_levels(space);
    std::vector<std::uint64_t>& neighborhoods = levels.patches.back().neighborhoods;
    REQUIRE(neighborhoods.size() == space.dimension());
    if(i == 1) // each on its own
      std::iota(neighborhoods.begin(), neighborhoods.end(), 0u);
    const RL::Multigrid_solver solver(operators.stiffness + operators.mass, std::move(levels),
                                      integrals, 1, params::tolerance(1e-10));
    CHECK(solver.solve(b, solutions[i]).converged);
  }
  CHECK((solutions[0] - solutions[1]).norm() <= 1e-6 * solutions[0].norm());
}

TEST_CASE("preconditioners_keep_their_hierarchy", "[interface]") {
  using Preconditioner = RL::Multigrid_preconditioner<RL::Patch_smoother>;
  const RL::Spline_space_3 space(shapes::mesh(shapes::sphere(3)), params::depth(3));
  const RL::Operators operators = RL::assemble_operators(space, space.depth(), 1e-3);
  const RL::Sparse_matrix a = operators.stiffness + operators.mass;
  const Eigen::VectorXd b = operators.mass.col(5);
  Preconditioner preconditioner(space, a);
  const Eigen::VectorXd expected = preconditioner.solve(b);
  // whatever matrix the solver of Eigen names
  CHECK(preconditioner.analyzePattern(operators.mass).solve(b) == expected);
  CHECK(preconditioner.factorize(operators.mass).solve(b) == expected);
  CHECK(preconditioner.info() == Eigen::Success);

  // nested iteration makes a guess: in energy, half of the error of 0 at most
  const Eigen::VectorXd load =
      RL::assemble_load(space, [](const RL::Surface_point& p) { return p.point.z(); });
  Eigen::VectorXd exact;
  REQUIRE(RL::Poisson_solver(space, operators, 1, params::tolerance(1e-8))
              .solve(load, exact)
              .converged);
  RL::Multigrid<RL::Patch_smoother>::Workspace<1> workspace;
  RL::internal::Block_vector<1> guess;
  preconditioner.multigrid().nested_iteration<1>(load, guess, RL::Cycle::V, 1, workspace);
  const Eigen::VectorXd error = guess - exact;
  CHECK(error.dot(a * error) <= 0.25 * exact.dot(a * exact));
}

TEST_CASE("nodes_on_flat_triangles_have_the_metric_of_their_plane", "[interface]") {
  const RL::Spline_space_3 space(shapes::mesh(shapes::sphere(1)), params::depth(2));
  const RL::Surface_integration view = RL::default_integration(space.octree());
  CHECK(view.adds_moments());
  double area = 0;
  for(std::size_t sheet = 0; sheet < space.number_of_sheets(space.depth()); ++sheet)
    view.visit_nodes(sheet, 4, [&](RL::Integration_node_block& block) {
      for(std::size_t i = 0; i < block.size; ++i) {
        area += block.weights[i];
        REQUIRE(block.metrics[i] == RL::tangent_projector(block.points[i].normal));
      }
    });
  const double h = space.octree().cell_width(space.depth());
  CHECK(area * h * h == Approx(space.surface().area()).epsilon(1e-13));
  const auto ignore = [](RL::Integration_node_block&) {};
  for(const int degree : {-1, 13})
    CHECK_THROWS_AS(view.visit_nodes(0, degree, ignore), RL::Parameter_error);
  // functions that are linear on faces need none
  CHECK(view.adds_linear_functions());
  CHECK(!RL::Surface_integration(RL::Monte_carlo(space.octree(), 100, 1)).adds_linear_functions());
  const auto two = RL::function_of_degree([](const RL::Surface_point&) { return 2.; }, 0);
  double square = 0;
  for(std::size_t sheet = 0; sheet < space.number_of_sheets(space.depth()); ++sheet) {
    RL::internal::Function_moments moments(two, "two");
    view.add_linear_function(sheet, moments);
    square += moments.square(0);
  }
  CHECK(square * h * h == Approx(4 * space.surface().area()).epsilon(1e-13));
  // those that are left are handed on
  std::size_t number = 0;
  const auto count = [&](RL::Integration_node_block& block) { number += block.size; };
  const RL::Integration_nodes::Consumer consumer(count);
  RL::Integration_nodes nodes(consumer);
  const RL::Surface_point point = space.surface().surface_point({0, {1, 0, 0}});
  for(int i = 0; i < 40; ++i)
    nodes.add(point, {0, 0, 0}, 1);
  CHECK(number == RL::Integration_node_block::capacity);
  nodes.flush();
  CHECK(number == 40);
  nodes.flush();
  CHECK(number == 40);
}
