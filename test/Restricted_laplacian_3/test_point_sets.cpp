// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Surfaces that are given by oriented points, without any mesh.

#include "catch.h"
#include "matrices.h"
#include "point_shapes.h"
#include "shapes.h"

#include <CGAL/Restricted_laplacian_3/assembly/Dirichlet_boundary.h>
#include <CGAL/Restricted_laplacian_3/assembly/cotangent_operators.h>
#include <CGAL/Restricted_laplacian_3/estimate_curvature.h>
#include <CGAL/Restricted_laplacian_3/fit_function.h>
#include <CGAL/Restricted_laplacian_3/input/point_areas.h>
#include <CGAL/Restricted_laplacian_3/input/read_surface.h>
#include <CGAL/Restricted_laplacian_3/integrate_gradient_field.h>
#include <CGAL/Restricted_laplacian_3/integration/Monte_carlo.h>
#include <CGAL/Restricted_laplacian_3/laplace_spectrum.h>
#include <CGAL/Restricted_laplacian_3/solve_poisson.h>
#include <CGAL/Restricted_laplacian_3/splines/prolongation.h>
#include <CGAL/Restricted_laplacian_3/surface/sample_surface.h>

#include <CGAL/Point_set_3.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace RL = CGAL::Restricted_laplacian_3;
namespace params = RL::parameters;
using shapes::Oriented_point;
using shapes::Oriented_points;
using Point_map = CGAL::First_of_pair_property_map<Oriented_point>;
using Normal_map = CGAL::Second_of_pair_property_map<Oriented_point>;
using Point_set = CGAL::Point_set_3<RL::Point_3>;

const double pi_of_points = shapes::point_shapes_pi;

/// the maps of a vector of pairs, before further parameters
template <class NamedParameters> auto maps_of_pairs(const NamedParameters& np) {
  return np.point_map(Point_map()).normal_map(Normal_map());
}

RL::Triangulated_surface_3 surface_of_points(const Oriented_points& points,
                                             const std::vector<double>& areas) {
  std::vector<RL::Point_3> p;
  std::vector<RL::Vector_3> n;
  for(const Oriented_point& point : points) {
    p.push_back(point.first);
    n.push_back(point.second);
  }
  return RL::Triangulated_surface_3(std::move(p), std::move(n), areas);
}

RL::Spline_space_3 space_of_points(const Oriented_points& points, const std::vector<double>& areas,
                                   int depth, bool is_split = false, bool is_parallel = false) {
  RL::Spline_space_options options;
  options.depth = depth;
  options.split_point_set = is_split;
  options.is_parallel = is_parallel;
  return RL::Spline_space_3(surface_of_points(points, areas), options);
}

std::vector<double> areas_of_points(const Oriented_points& points, int number_of_neighbors = 16,
                                    bool is_parallel = false) {
  std::vector<RL::Point_3> p;
  std::vector<RL::Vector_3> n;
  for(const Oriented_point& point : points) {
    p.push_back(point.first);
    n.push_back(point.second);
  }
  return RL::estimate_point_areas(p, n, number_of_neighbors, is_parallel);
}

double sum_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.);
}

/// largest relative error of the eigenvalues l (l + 1), l = 1 .. 5, of the unit sphere
double error_on_sphere(const Eigen::VectorXd& eigenvalues) {
  double error = 0;
  Eigen::Index i = 1;
  for(int l = 1; l <= 5; ++l)
    for(int multiplicity = 0; multiplicity < 2 * l + 1; ++multiplicity, ++i)
      error = (std::max)(error, std::abs(eigenvalues[i] / (l * (l + 1)) - 1));
  return error;
}

template <class Error, class Body> std::string message_of(Body&& body) {
  try {
    body();
  } catch(const Error& error) {
    return error.what();
  }
  return "no exception of this type";
}

/// the position that an `Invalid_point_error` names
template <class Body> long refused_point(Body&& body) {
  try {
    body();
  } catch(const RL::Invalid_point_error& error) {
    return static_cast<long>(error.point());
  }
  return -1;
}

} // namespace

TEST_CASE("matrices_of_points_are_sums_over_them", "[points]") {
  Oriented_points points = shapes::torus_points(3000, 1, 0.4);
  std::vector<double> areas;
  for(std::size_t i = 0; i < points.size(); ++i)
    areas.push_back(i % 7 == 0 ? 0 : 1e-3 * (1 + i % 5));
  for(bool is_split : {false, true}) {
    const RL::Spline_space_3 space = space_of_points(points, areas, 4, is_split);
    const RL::Operators operators = RL::assemble_operators(space);
    const Eigen::VectorXd one = Eigen::VectorXd::Ones(space.dimension());
    CHECK(one.dot(operators.mass * one) == Approx(sum_of(areas)).epsilon(1e-12));
    CHECK((operators.stiffness * one).cwiseAbs().maxCoeff() <=
          1e-12 * operators.stiffness.coeffs().maxCoeff());

    // u' M u and u' S u against values and gradients of u at the points
    Eigen::VectorXd x(space.dimension());
    for(Eigen::Index i = 0; i < x.size(); ++i)
      x[i] = std::sin(1.7 * i);
    const RL::Spline_function_3 u(space, x);
    const auto f = [](const RL::Surface_point& p) { return std::cos(3 * p.point.x()); };
    const Eigen::VectorXd load = RL::assemble_load(space, f);
    double squares = 0, energy = 0, product = 0;
    for(std::size_t i = 0; i < points.size(); ++i) {
      RL::Surface_location location;
      location.face = i;
      const double value = u.value(location);
      squares += areas[i] * value * value;
      energy += areas[i] * u.gradient(location).squared_length();
      product += areas[i] * value * std::cos(3 * points[i].first.x());
    }
    CHECK(x.dot(operators.mass * x) == Approx(squares).epsilon(1e-11));
    CHECK(x.dot(operators.stiffness * x) == Approx(energy).epsilon(1e-11));
    CHECK(x.dot(load) == Approx(product).epsilon(1e-11));
    // coarse matrices are the Galerkin products
    const RL::Operators coarse = RL::assemble_operators(space, 3);
    const RL::Sparse_matrix p = RL::prolongation_matrix(space, 3);
    CHECK(relative_difference(RL::Sparse_matrix(p.transpose() * operators.stiffness * p),
                              coarse.stiffness) <= 1e-12);
  }
}

TEST_CASE("points_with_the_areas_of_samples_give_their_operators", "[points]") {
  // The corners of the box belong to both, so that both have the same grid.
  const shapes::Triangles box = shapes::box(1, 0.8, 0.6, 3, 1);
  const RL::Triangulated_surface_3 mesh(box.points, box.faces);
  RL::Spline_space_options options;
  options.depth = 2;
  options.split = false;
  const RL::Spline_space_3 space(mesh, options);
  const std::size_t number = 4000;
  const std::vector<RL::Surface_location> samples = RL::sample_surface(mesh, number, 1);
  Oriented_points points;
  std::vector<double> areas(number, mesh.area() / number);
  for(const RL::Surface_location& sample : samples) {
    const RL::Surface_point p = mesh.surface_point(sample);
    points.emplace_back(p.point, p.normal);
  }
  for(const RL::Point_3& corner : {RL::Point_3(0, 0, 0), RL::Point_3(1, 0.8, 0.6)}) {
    points.emplace_back(corner, RL::Vector_3(0, 0, 1));
    areas.push_back(0);
  }
  const RL::Operators of_samples =
      RL::assemble_operators(space.integrated_by(RL::Monte_carlo(space.octree(), samples)), 2, 0.1);
  const RL::Operators of_points = [&] {
    const RL::Spline_space_3 point_space = space_of_points(points, areas, 2);
    REQUIRE(point_space.dimension() == space.dimension());
    return RL::assemble_operators(point_space, 2, 0.1);
  }();
  CHECK(relative_difference(of_points.mass, of_samples.mass) <= 1e-12);
  CHECK(relative_difference(of_points.stiffness, of_samples.stiffness) <= 1e-12);
}

TEST_CASE("point_sets_of_all_types_are_the_same", "[points]") {
  const Oriented_points points = shapes::sphere_points(500);
  Point_set set;
  set.add_normal_map();
  auto area = set.add_property_map<double>("area", 0).first;
  std::vector<RL::Point_3> bare_points;
  std::vector<RL::Vector_3> bare_normals;
  std::vector<double> areas;
  for(std::size_t i = 0; i < points.size(); ++i) {
    const auto it = set.insert(points[i].first, 3 * points[i].second);
    areas.push_back(area[*it] = 1 + 0.01 * static_cast<double>(i));
    bare_points.push_back(points[i].first);
    bare_normals.push_back(points[i].second);
  }
  const RL::Triangulated_surface_3 expected = surface_of_points(points, areas);
  const auto check = [&](const RL::Triangulated_surface_3& surface) {
    REQUIRE(surface.number_of_vertices() == expected.number_of_vertices());
    CHECK(surface.is_point_set());
    CHECK(surface.area() == expected.area());
    double difference = 0;
    for(std::size_t i = 0; i < points.size(); ++i)
      difference += std::abs(surface.area(i) - expected.area(i)) +
                    std::sqrt((surface.normal(i) - expected.normal(i)).squared_length()) +
                    std::sqrt((surface.point(i) - expected.point(i)).squared_length());
    CHECK(difference <= 1e-12);
  };
  check(RL::read_surface(set, params::area_map(area)));
  check(RL::read_surface(points, maps_of_pairs(params::area_map(CGAL::make_property_map(areas)))));
  // points are the elements, normals are found by position
  check(RL::read_surface(bare_points, params::area_map(CGAL::make_property_map(areas))
                                          .normal_map(CGAL::make_property_map(bare_normals))));
  // indices are the elements
  std::vector<std::size_t> indices(points.size());
  std::iota(indices.begin(), indices.end(), std::size_t(0));
  check(RL::read_surface(indices, params::area_map(CGAL::make_property_map(areas))
                                      .point_map(CGAL::make_property_map(bare_points))
                                      .normal_map(CGAL::make_property_map(bare_normals))));
  // without areas they are estimated
  const RL::Spline_space_3 space(set, params::depth(2).neighbors(12));
  CHECK_FALSE(space.is_split());
  CHECK(space.surface().area() == sum_of(areas_of_points(points, 12)));
  CHECK(space.surface().area() != sum_of(areas_of_points(points, 5)));
}

TEST_CASE("estimated_areas_of_points", "[points]") {
  CHECK(sum_of(areas_of_points(shapes::sphere_points(3000))) ==
        Approx(4 * pi_of_points).epsilon(2e-3));
  CHECK(sum_of(areas_of_points(shapes::random_sphere_points(10000, 1))) ==
        Approx(4 * pi_of_points).epsilon(1e-2));
  CHECK(sum_of(areas_of_points(shapes::torus_points(5000, 1, 0.4))) ==
        Approx(4 * pi_of_points * pi_of_points * 0.4).epsilon(5e-3));
  // a border: cells of the grid reach as far outwards as inwards
  const std::vector<double> square = areas_of_points(shapes::square_points(40, 0, 1));
  for(double area : {*std::min_element(square.begin(), square.end()),
                     *std::max_element(square.begin(), square.end())})
    CHECK(area == Approx(1. / 1600).epsilon(1e-9));
  CHECK(sum_of(areas_of_points(shapes::cube_points(40))) == Approx(6).epsilon(2e-2));
}

TEST_CASE("estimated_areas_of_points_are_local_and_covariant", "[points]") {
  Oriented_points points = shapes::square_points(20, 0, 1);
  const std::vector<double> of_square = areas_of_points(points);
  // the other side of something infinitely thin does not matter
  Oriented_points both = points;
  for(const Oriented_point& p : points)
    both.emplace_back(p.first, -p.second);
  const std::vector<double> of_both = areas_of_points(both);
  for(std::size_t i = 0; i < points.size(); ++i) {
    CHECK(of_both[i] == Approx(of_square[i]).epsilon(1e-9));
    CHECK(of_both[i + points.size()] == Approx(of_square[i]).epsilon(1e-9));
  }
  // points that are the same share
  Oriented_points repeated = points;
  for(int k = 0; k < 50; ++k)
    repeated.push_back(points[210]);
  const std::vector<double> of_repeated = areas_of_points(repeated);
  CHECK(of_repeated[210] == Approx(of_square[210] / 51));
  CHECK(of_repeated.back() == of_repeated[210]);
  CHECK(sum_of(of_repeated) == Approx(sum_of(of_square)));
  // scale, and the length of normals
  for(double scale : {1e-90, 1e90}) {
    Oriented_points scaled = points;
    for(Oriented_point& p : scaled)
      p = {CGAL::ORIGIN + scale * (p.first - CGAL::ORIGIN), scale * p.second};
    CHECK(sum_of(areas_of_points(scaled)) / scale / scale == Approx(sum_of(of_square)));
  }
  CHECK(areas_of_points(points, 16, true) == of_square);
  CHECK(areas_of_points({}).empty());
  CHECK(areas_of_points({points[0]}) == std::vector<double>{0});
  CHECK(sum_of(areas_of_points({points[0], points[1]})) > 0);
  CHECK_THROWS_AS(areas_of_points(points, 2), RL::Parameter_error);
}

TEST_CASE("poisson_problems_on_points", "[points]") {
  const Oriented_points points = shapes::sphere_points(8000);
  Point_set set;
  set.add_normal_map();
  auto f = set.add_property_map<double>("f", 0).first,
       u = set.add_property_map<double>("u", 0).first;
  std::vector<double> g, v(points.size());
  for(const Oriented_point& p : points) {
    f[*set.insert(p.first, p.second)] = p.first.z();
    g.push_back(p.first.z());
  }
  const auto z = [](const RL::Surface_point& p) { return p.point.z(); };
  const auto error = [&](double factor, const auto& value) {
    double largest = 0;
    for(std::size_t i = 0; i < points.size(); ++i)
      largest = (std::max)(largest, std::abs(value(i) - factor * points[i].first.z()));
    return largest;
  };
  const auto of_set = [&](std::size_t i) { return u[Point_set::Index(i)]; };
  const auto of_vector = [&](std::size_t i) { return v[i]; };

  // Laplacian z = -2 z
  CHECK(RL::solve_poisson(set, z, u, params::depth(3)).converged);
  CHECK(error(-0.5, of_set) <= 2e-3);
  CHECK(RL::solve_poisson(points, CGAL::make_property_map(g), CGAL::make_property_map(v),
                          maps_of_pairs(params::depth(3)))
            .converged);
  CHECK(error(-0.5, of_vector) <= 2e-3);
  CHECK(RL::solve_screened_poisson(set, f, 3., u, params::depth(3)).converged);
  CHECK(error(0.2, of_set) <= 1e-3);
  // prescribed values, also by keys of the set
  auto at_poles = set.add_property_map<double>("at_poles", std::nan("")).first;
  for(std::size_t i : {std::size_t(0), points.size() - 1})
    at_poles[Point_set::Index(i)] = points[i].first.z();
  const auto zero = [](const RL::Surface_point&) { return 0.; };
  CHECK(RL::solve_poisson(set, zero, u, params::depth(3).constraints(at_poles)).converged);
  for(std::size_t i : {std::size_t(0), points.size() - 1})
    CHECK(of_set(i) == Approx(points[i].first.z()).epsilon(1e-2));
  // weights in place of a number
  const std::vector<double> threes(points.size(), 3);
  CHECK(RL::solve_screened_poisson(points, z, CGAL::make_property_map(threes),
                                   CGAL::make_property_map(v), maps_of_pairs(params::depth(3)))
            .converged);
  CHECK(error(0.2, of_vector) <= 1e-3);
  CHECK_THROWS_AS(RL::solve_screened_poisson(set, f, z, u, params::depth(3)), RL::Parameter_error);
}

TEST_CASE("spectrum_of_points", "[points]") {
  const Oriented_points points = shapes::sphere_points(8000);
  const RL::Laplace_spectrum spectrum =
      RL::laplace_spectrum(points, 36, maps_of_pairs(params::depth(3)));
  CHECK(spectrum.report.converged);
  CHECK(std::abs(spectrum.eigenvalues[0]) <= 1e-10);
  CHECK(error_on_sphere(spectrum.eigenvalues) <= 2e-3);
  CHECK(spectrum.vertex_values.rows() == 8000);
  CHECK(spectrum.vertex_values.allFinite());
  CHECK(spectrum.area == Approx(4 * pi_of_points).epsilon(1e-3));
}

TEST_CASE("depth_that_points_allow", "[points]") {
  const auto depth_of = [](int n) {
    const RL::Spline_space_3 space(shapes::sphere_points(n),
                                   maps_of_pairs(params::cube_scale(1.1)));
    const auto per_cell = [&](int depth) {
      return static_cast<double>(n) /
             RL::Octree_3(space.surface(), depth, 1.1, false).number_of_cells(depth);
    };
    CHECK((space.depth() == 1 || per_cell(space.depth()) >= 50));
    CHECK((space.depth() == 6 || per_cell(space.depth() + 1) < 50));
    return space.depth();
  };
  CHECK(depth_of(40) == 1);
  CHECK(depth_of(3000) == 2);
  CHECK(depth_of(20000) == 3);
  CHECK(depth_of(60000) == 4);
  // else the default is that of meshes
  CHECK(RL::Spline_space_3(shapes::mesh(shapes::sphere(0))).depth() == 5);
}

TEST_CASE("spectrum_of_many_points_on_a_sphere", "[points][slow]") {
  for(int depth : {3, 4, 5}) {
    INFO("depth " << depth);
    const RL::Laplace_spectrum regular = RL::laplace_spectrum(shapes::sphere_points(100000), 36,
                                                              maps_of_pairs(params::depth(depth)));
    CHECK(error_on_sphere(regular.eigenvalues) <= 8e-4);
    const RL::Laplace_spectrum random = RL::laplace_spectrum(
        shapes::random_sphere_points(100000, 1), 36, maps_of_pairs(params::depth(depth)));
    CHECK(error_on_sphere(random.eigenvalues) <= 1e-2);
  }
}

TEST_CASE("spectrum_of_many_points_on_a_torus", "[points][slow]") {
  const double pi = pi_of_points;
  const int n = 400, m = 160;
  shapes::Triangles torus;
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < m; ++j) {
      const double u = 2 * pi * i / n, v = 2 * pi * j / m, r = 1 + 0.4 * std::cos(v);
      torus.points.emplace_back(r * std::cos(u), r * std::sin(u), 0.4 * std::sin(v));
      const auto vertex = [&](int a, int b) {
        return static_cast<std::uint32_t>(((i + a) % n) * m + (j + b) % m);
      };
      torus.faces.push_back({vertex(0, 0), vertex(1, 0), vertex(1, 1)});
      torus.faces.push_back({vertex(0, 0), vertex(1, 1), vertex(0, 1)});
    }
  const int count = 36;
  const Eigen::VectorXd expected =
      RL::laplace_spectrum(RL::soup(torus.points, torus.faces), count, params::depth(5))
          .eigenvalues;
  const Eigen::VectorXd found = RL::laplace_spectrum(shapes::torus_points(100000, 1, 0.4), count,
                                                     maps_of_pairs(params::depth(4)))
                                    .eigenvalues;
  for(int i = 1; i < count; ++i)
    CHECK(found[i] == Approx(expected[i]).epsilon(5e-3));
}

TEST_CASE("points_on_opposite_sides_are_split", "[points]") {
  // A gap of a fifth of the distance of points, and of a tenth of a cell.
  Oriented_points plates = shapes::square_points(50, 0, -1);
  for(const Oriented_point& p : shapes::square_points(50, 0.004, 1))
    plates.push_back(p);
  const std::vector<double> areas(plates.size(), 1. / 2500);
  const RL::Spline_space_3 together = space_of_points(plates, areas, 4),
                           apart = space_of_points(plates, areas, 4, true),
                           alone = space_of_points(shapes::square_points(50, 0, 1),
                                                   std::vector<double>(2500, 1. / 2500), 4);
  CHECK(together.number_of_sheets(0) == 1);
  CHECK(apart.number_of_sheets(0) == 2);
  // The gap is in a wall between cells: together they meet four layers of elements, each alone
  // three.
  CHECK(together.dimension() == 4 * 18 * 18);
  CHECK(apart.dimension() == 6 * 18 * 18);
  const Eigen::VectorXd of_both = RL::laplace_spectrum(apart, 8).eigenvalues,
                        of_one = RL::laplace_spectrum(alone, 4).eigenvalues;
  for(int i = 0; i < 8; ++i)
    CHECK(of_both[i] == Approx(of_one[i / 2]).epsilon(1e-2).margin(1e-8));
}

TEST_CASE("splitting_keeps_connected_points_together", "[points]") {
  const auto components = [](const Oriented_points& points, int depth) {
    return space_of_points(points, std::vector<double>(points.size(), 1), depth, true)
        .number_of_sheets(0);
  };
  CHECK(components(shapes::sphere_points(5000), 4) == 1);
  CHECK(components(shapes::random_sphere_points(5000, 1), 4) == 1);
  CHECK(components(shapes::torus_points(5000, 1, 0.4), 4) == 1);
  CHECK(components(shapes::cube_points(20), 4) == 1); // edges of 90 degrees
  Oriented_points repeated = shapes::sphere_points(2000);
  for(int i = 0; i < 100; ++i)
    repeated.push_back(repeated[i % 3]);
  CHECK(components(repeated, 3) == 1);
}

TEST_CASE("points_do_not_depend_on_threads", "[points][threads]") {
  const Oriented_points points = shapes::random_sphere_points(20000, 2);
  const std::vector<double> areas = areas_of_points(points),
                            parallel = areas_of_points(points, 16, true);
  CHECK(areas == parallel);
  for(bool is_split : {false, true}) {
    const RL::Operators a = RL::assemble_operators(space_of_points(points, areas, 4, is_split)),
                        b = RL::assemble_operators(
                            space_of_points(points, areas, 4, is_split, true));
    REQUIRE(a.stiffness.nonZeros() == b.stiffness.nonZeros());
    CHECK((a.stiffness.coeffs() == b.stiffness.coeffs()).all());
    CHECK((a.mass.coeffs() == b.mass.coeffs()).all());
  }
}

TEST_CASE("points_on_walls_between_cells", "[points]") {
  // The middle plane of the cube is a wall, on which the elements below it vanish.
  const Oriented_points points = shapes::square_points(40, 0.25, 1);
  for(bool is_split : {false, true}) {
    const RL::Spline_space_3 space =
        space_of_points(points, std::vector<double>(points.size(), 1. / 1600), 3, is_split);
    const RL::Operators operators = RL::assemble_operators(space);
    CHECK(operators.mass.diagonal().minCoeff() > 0);
    CHECK(operators.mass.sum() == Approx(1).epsilon(1e-12));
    const Eigen::VectorXd eigenvalues = RL::laplace_spectrum(space, 4).eigenvalues;
    CHECK(std::abs(eigenvalues[0]) <= 1e-8);
    for(int i : {1, 2})
      CHECK(eigenvalues[i] == Approx(pi_of_points * pi_of_points).epsilon(1e-2));
  }
}

TEST_CASE("points_on_the_boundary_of_the_domain_cube", "[points]") {
  const Oriented_points points = shapes::cube_points(15);
  Oriented_points with_corners = points; // which lie on the last walls
  with_corners.push_back({{0, 0, 0}, {-1, -1, -1}});
  with_corners.push_back({{1, 1, 1}, {1, 1, 1}});
  RL::Spline_space_options options;
  options.depth = 2;
  options.cube_scale = 1;
  const std::vector<double> areas(with_corners.size(), 0.01);
  const RL::Spline_space_3 space(surface_of_points(with_corners, areas), options);
  CHECK(space.number_of_cells(2) == 64 - 8); // all but the inner ones
  const RL::Operators operators = RL::assemble_operators(space);
  CHECK(operators.mass.sum() == Approx(sum_of(areas)).epsilon(1e-12));
  CHECK(operators.mass.diagonal().minCoeff() > 0);
  const RL::Spline_function_3 one(space, Eigen::VectorXd::Ones(space.dimension()));
  for(double value : one.values_at_vertices())
    CHECK(value == Approx(1).epsilon(1e-12));
}

TEST_CASE("point_sets_that_cannot_be_used", "[points]") {
  const Oriented_points points = shapes::sphere_points(50);
  const std::vector<double> areas(points.size(), 1);
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               infinity = std::numeric_limits<double>::infinity();
  const auto with_point = [&](const RL::Point_3& p, const RL::Vector_3& n) {
    Oriented_points changed = points;
    changed[17] = {p, n};
    return changed;
  };
  for(const Oriented_points& bad :
      {with_point({nan, 0, 0}, {0, 0, 1}), with_point({0, infinity, 0}, {0, 0, 1}),
       with_point({0, 0, 1}, {0, nan, 0}), with_point({0, 0, 1}, {0, infinity, 0}),
       with_point({0, 0, 1}, {0, 0, 0})}) {
    CHECK(refused_point([&] { surface_of_points(bad, areas); }) == 17);
    CHECK(refused_point([&] { areas_of_points(bad); }) == 17);
    CHECK(refused_point([&] { RL::laplace_spectrum(bad, 3, maps_of_pairs(params::depth(2))); }) ==
          17);
  }
  for(double area : {-1., nan, infinity}) {
    std::vector<double> bad = areas;
    bad[17] = area;
    CHECK(refused_point([&] { surface_of_points(points, bad); }) == 17);
  }
  CHECK_THROWS_AS(surface_of_points({}, {}), RL::Empty_surface_error);
  CHECK_THROWS_AS(surface_of_points({points[0]}, {1}), RL::Zero_area_error);
  CHECK_THROWS_AS(surface_of_points(points, std::vector<double>(50, 0.)), RL::Zero_area_error);
  CHECK_THROWS_AS(surface_of_points(points, std::vector<double>(50, 1e308)), RL::Parameter_error);
  CHECK_THROWS_AS(surface_of_points(points, {1, 2}), RL::Parameter_error);
  CHECK_THROWS_AS(surface_of_points(Oriented_points(9, points[0]), std::vector<double>(9, 1.)),
                  RL::Zero_area_error);
  Point_set without_normals;
  without_normals.insert(RL::Point_3(0, 0, 0));
  CHECK(message_of<RL::Input_error>([&] { RL::read_surface(without_normals); }) ==
        "the point set has no normals");

  // what needs faces says so
  const RL::Spline_space_3 space = space_of_points(points, areas, 2);
  CHECK_THROWS_AS(RL::sample_surface(space.surface(), 10, 1), RL::Input_error);
  CHECK_THROWS_AS(RL::cotangent_operators(space.surface()), RL::Input_error);
  CHECK(message_of<RL::Input_error>([&] {
          RL::Dirichlet_boundary boundary(space);
        }).find("point set") != std::string::npos);
  CHECK_THROWS_AS(RL::Spline_function_3(space, Eigen::VectorXd::Zero(space.dimension()))
                      .value(RL::Surface_location{50, {1, 0, 0}}),
                  RL::Location_error);
}

TEST_CASE("spectra_of_points_scale", "[points]") {
  for(double scale : {1e-90, 1e90}) {
    Oriented_points points = shapes::sphere_points(3000);
    for(Oriented_point& p : points)
      p = {CGAL::ORIGIN + scale * (p.first - CGAL::ORIGIN), scale * p.second};
    const Eigen::VectorXd eigenvalues =
        RL::laplace_spectrum(points, 4, maps_of_pairs(params::depth(2))).eigenvalues;
    for(int i = 1; i < 4; ++i)
      CHECK(eigenvalues[i] * scale * scale == Approx(2).epsilon(2e-2));
  }
}

TEST_CASE("fits_and_curvature_of_points", "[points]") {
  const double large = 1, small = 0.4;
  const Oriented_points points = shapes::torus_points(8000, large, small);
  const auto np = maps_of_pairs(params::depth(3));

  // normals are a smooth function
  std::vector<RL::Vector_3> fit(points.size());
  const RL::Fit_report report =
      RL::fit_function(points, Normal_map(), CGAL::make_property_map(fit), np);
  CHECK(report.converged);
  CHECK(report.root_mean_square_error() <= 1e-2);
  double sum = 0;
  for(std::size_t i = 0; i < points.size(); ++i)
    sum += (fit[i] - points[i].second).squared_length();
  CHECK(std::sqrt(sum / static_cast<double>(points.size())) ==
        Approx(report.root_mean_square_error()).epsilon(0.2));

  for(RL::Curvature_method method :
      {RL::Curvature_method::normals, RL::Curvature_method::face_normals}) {
    std::vector<RL::Surface_curvature> curvatures(points.size());
    CHECK(RL::estimate_curvature(points, CGAL::make_property_map(curvatures),
                                 maps_of_pairs(params::depth(4).method(method)))
              .converged);
    std::vector<double> errors;
    for(std::size_t i = 0; i < points.size(); ++i) {
      const double x = points[i].first.x(), y = points[i].first.y();
      const double r = std::sqrt(x * x + y * y), c = (r - large) / small;
      const double mean = (large + 2 * small * c) / (2 * small * r);
      errors.push_back(std::abs(curvatures[i].mean / mean - 1));
    }
    std::sort(errors.begin(), errors.end());
    CHECK(errors[errors.size() / 2] <= 0.02);
    CHECK(errors[errors.size() * 95 / 100] <= 0.08);
  }
}

TEST_CASE("points_that_do_not_determine_functions_are_refused", "[point_sets]") {
  const auto zero = [](const RL::Surface_point& p) { return p.point.z(); };
  for(const int n : {5, 20, 45})
    for(const int depth : {1, 3}) {
      const Oriented_points points = shapes::sphere_points(n);
      const auto np = maps_of_pairs(params::depth(depth));
      const RL::Spline_space_3 space(points, np);
      REQUIRE(3 * space.dimension() > 4 * points.size());
      std::vector<double> u(points.size());
      std::vector<RL::Surface_curvature> curvatures(points.size());
      CAPTURE(n, depth);
      CHECK_THROWS_WITH(RL::laplace_spectrum(points, 3, np), Catch::Contains("do not determine"));
      CHECK_THROWS_AS(RL::laplace_eigenpairs(space, 3), RL::Input_error);
      CHECK_THROWS_AS(RL::solve_poisson(points, zero, CGAL::make_property_map(u), np),
                      RL::Input_error);
      CHECK_THROWS_AS(RL::solve_screened_poisson(points, zero, 1, CGAL::make_property_map(u), np),
                      RL::Input_error);
      CHECK_THROWS_AS(RL::estimate_curvature(points, CGAL::make_property_map(curvatures), np),
                      RL::Input_error);
      const auto field = [](const RL::Surface_point&) { return RL::Vector_3(0, 0, 1); };
      CHECK_THROWS_AS(RL::integrate_gradient_field(points, field, CGAL::make_property_map(u), np),
                      RL::Input_error);
    }
  // a depth for which there are enough is named
  CHECK_THROWS_WITH(
      RL::laplace_spectrum(shapes::sphere_points(300), 3, maps_of_pairs(params::depth(4))),
      Catch::Contains("depth 2 is possible"));
}

TEST_CASE("few_points_have_constants_in_the_kernel", "[point_sets]") {
  // with fewer functions than 100 and more, which are solved by other methods
  for(const int n : {70, 100, 250, 400})
    for(const int depth : {1, 2}) {
      const Oriented_points points = shapes::sphere_points(n);
      const RL::Spline_space_3 space(points, maps_of_pairs(params::depth(depth)));
      if(space.dimension() > points.size())
        continue;
      const RL::Laplace_spectrum spectrum = RL::laplace_spectrum(space, 4);
      CAPTURE(n, depth, spectrum.eigenvalues);
      CHECK(std::abs(spectrum.eigenvalues[0]) <= 1e-9);
      for(int i = 1; i < 4; ++i)
        CHECK(spectrum.eigenvalues[i] == Approx(2).epsilon(0.1));
    }
}
