// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Values on a part of the boundary, and fluxes on the rest, against analytic solutions.

#include "catch.h"
#include "harmonic_functions.h"
#include "special_shapes.h"

#include <CGAL/Restricted_laplacian_3/assembly/Boundary_integration.h>
#include <CGAL/Restricted_laplacian_3/assembly/Dirichlet_boundary.h>
#include <CGAL/Restricted_laplacian_3/integration/shared/line_rule.h>
#include <CGAL/Restricted_laplacian_3/solve_poisson.h>

#include <boost/math/quadrature/gauss.hpp>
#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

namespace {

namespace RL = CGAL::Restricted_laplacian_3;
namespace params = RL::parameters;
using shapes::conormal;
using shapes::Harmonic;
using shapes::logarithm;
using shapes::Mesh;
using shapes::power;
using shapes::Triangles;

const double pi = std::acos(-1.);
constexpr double free_value = std::numeric_limits<double>::quiet_NaN();

/// the root mean square of the error at the vertices
/// \param has_value where values are prescribed; the conormal derivative is elsewhere
double error_at_depth(const Triangles& t, const Harmonic& u,
                      const std::function<bool(const RL::Point_3&)>& has_value, int depth) {
  const RL::Spline_space_3 space(RL::soup(t.points, t.faces), params::depth(depth));
  const auto f = [](const RL::Surface_point&) { return 0.; };
  const auto g = [&](const RL::Surface_point& p) { return u.value(p.point.x(), p.point.y()); };
  const auto flux = [&](const RL::Surface_point& p) {
    return u.gradient(p.point.x(), p.point.y()) * conormal(t, p);
  };
  RL::Poisson_problem problem(f);
  const RL::Boundary_integration with_values(
      space, [&](const RL::Surface_point& p) { return has_value(p.point); });
  if(with_values.length() > 0) {
    problem.boundary_values = g;
    problem.has_boundary_value = [&](const RL::Surface_point& p) { return has_value(p.point); };
  }
  if(const RL::Boundary_integration whole(space); with_values.length() < 0.999 * whole.length())
    problem.boundary_flux = flux;
  problem.solver.tolerance = 1e-9;
  problem.stabilization = 1e-5; // that of tiny sheets at corners shows in errors of 1e-6
  const RL::Poisson_solution solution = RL::solve_poisson_problem(space, problem);
  REQUIRE(solution.converged);
  CHECK(solution.kernel_dimension == (with_values.length() > 0 ? 0 : 1));
  const std::vector<double> values =
      RL::Spline_function_3(space, solution.coefficients).values_at_vertices();
  std::vector<double> errors;
  double mean = 0;
  for(std::size_t v = 0; v < values.size(); ++v)
    if(!std::isnan(values[v])) {
      const RL::Point_3& p = t.points[v];
      errors.push_back(p == CGAL::ORIGIN ? 0 : values[v] - u.value(p.x(), p.y()));
      mean += errors.back();
    }
  mean = with_values.length() > 0 ? 0 : mean / double(errors.size());
  double sum = 0;
  for(const double e : errors)
    sum += (e - mean) * (e - mean);
  return std::sqrt(sum / double(errors.size()));
}

/// what depths 4 to 6 give
void check_order(const Triangles& t, const Harmonic& u,
                 const std::function<bool(const RL::Point_3&)>& has_value, double order,
                 double largest_error) {
  std::vector<double> errors;
  for(int depth = 4; depth <= 6; ++depth)
    errors.push_back(error_at_depth(t, u, has_value, depth));
  CAPTURE(errors);
  CHECK(errors[2] <= largest_error);
  CHECK(std::log2(errors[0] / errors[2]) / 2 >= order - 0.35);
}

bool everywhere(const RL::Point_3&) { return true; }
bool nowhere(const RL::Point_3&) { return false; }

} // namespace

TEST_CASE("values_on_two_sides_of_a_square", "[boundary_conditions]") {
  constexpr int n = 16;
  const Triangles square = shapes::grid(n, [](double x, double y) { return RL::Point_3(x, y, 0); });
  Mesh mesh = shapes::mesh(square);
  const auto zero = [](const RL::Surface_point&) { return 0.; };
  auto g = mesh.add_property_map<Mesh::Vertex_index, double>("v:g", free_value).first;
  auto u = mesh.add_property_map<Mesh::Vertex_index, double>("v:u").first;
  auto is_constrained = mesh.add_property_map<Mesh::Edge_index, bool>("e:c", false).first;
  for(const Mesh::Vertex_index v : mesh.vertices())
    if(const double x = mesh.point(v).x(); x == 0 || x == 1)
      g[v] = 1000 * x;
  for(const Mesh::Edge_index e : mesh.edges()) {
    const RL::Point_3 &a = mesh.point(mesh.vertex(e, 0)), &b = mesh.point(mesh.vertex(e, 1));
    is_constrained[e] = a.x() == b.x() && (a.x() == 0 || a.x() == 1);
  }
  const auto by_place = [](const RL::Surface_point& p) {
    return p.point.x() == 0 || p.point.x() == 1;
  };
  const auto error = [&] {
    double result = 0;
    for(const Mesh::Vertex_index v : mesh.vertices())
      result = (std::max)(result, std::abs(u[v] - 1000 * mesh.point(v).x()));
    return result;
  };
  for(const int depth : {4, 5, 6})
    for(const RL::Vertex_data data : {RL::Vertex_data::linear, RL::Vertex_data::smooth}) {
      const auto np = params::depth(depth).vertex_data(data);
      // at depth 6 corners reach 0.09 cells into theirs, where all of the gradient is stabilized
      const double tolerance = depth == 6 ? 1e-2 : 1e-3;
      CAPTURE(depth);
      CHECK(RL::solve_poisson(mesh, zero, u,
                              np.boundary_values(g).edge_is_constrained_map(is_constrained))
                .converged);
      CHECK(error() <= tolerance);
      CHECK(RL::solve_poisson(mesh, zero, u, np.boundary_values(g).has_boundary_value(by_place))
                .converged);
      CHECK(error() <= tolerance);
      // value on the left, flux on the right
      CHECK(RL::solve_poisson(
                mesh, zero, u,
                np.boundary_values(0)
                    .has_boundary_value([](const RL::Surface_point& p) { return p.point.x() == 0; })
                    .boundary_flux([](const RL::Surface_point& p) {
                      return p.point.x() > 1 - 1e-9 ? 1000. : 0.;
                    }))
                .converged);
      CHECK(error() <= tolerance);
    }
}

TEST_CASE("conditions_on_an_annulus_a_sector_and_the_l_shape", "[boundary_conditions]") {
  const Triangles annulus = shapes::sector(8, 48, 0.4, 2 * pi);
  const auto is_inner = [](const RL::Point_3& p) { return std::hypot(p.x(), p.y()) < 0.5; };
  check_order(annulus, logarithm, is_inner, 3, 5e-6);
  check_order(annulus, logarithm, everywhere, 3, 5e-6);
  check_order(annulus, logarithm, nowhere, 3, 5e-6);
  // a sixth of a disc: natural conditions on the straight sides
  const auto is_round = [](const RL::Point_3& p) { return std::hypot(p.x(), p.y()) > 0.99; };
  check_order(shapes::sector(16, 16, 0, pi / 3), power(3, pi / 2), is_round, 3, 5e-7);
  // singular at the origin: where conditions change on a straight line, and at a re-entrant corner
  const auto is_not_left = [](const RL::Point_3& p) { return p.y() > 1e-9 || p.x() > 0; };
  check_order(shapes::sector(16, 32, 0, pi), power(0.5, 0), is_not_left, 1, 2e-3);
  const Triangles l_shape = shapes::l_shape(16);
  check_order(l_shape, power(2. / 3, 0), everywhere, 4. / 3, 2e-4);
  const auto is_reentrant = [](const RL::Point_3& p) {
    return (p.y() == 0 && p.x() > 0) || (p.x() == 0 && p.y() < 0);
  };
  check_order(l_shape, power(2. / 3, 0), is_reentrant, 4. / 3, 3e-4);
  const auto is_above_corner = [](const RL::Point_3& p) { return p.y() == 0 && p.x() > 0; };
  check_order(l_shape, power(1. / 3, 0), is_above_corner, 2. / 3, 0.0125);
}

TEST_CASE("conditions_on_a_smooth_boundary", "[boundary_conditions]") {
  // the upper half of a sphere: u = z, whose Laplacian is -2 z, is 0 at the equator, and its
  // conormal derivative there is -1
  Triangles half = shapes::sphere(3);
  half.faces.erase(std::remove_if(half.faces.begin(), half.faces.end(),
                                  [&](const auto& f) {
                                    double z = 0;
                                    for(const std::uint32_t v : f)
                                      z += half.points[v].z();
                                    return z < 0;
                                  }),
                   half.faces.end());
  const auto f = [](const RL::Surface_point& p) { return -2 * p.point.z(); };
  for(const bool is_smooth : {false, true}) {
    const auto np = params::depth(4).geometry(is_smooth ? RL::Surface_geometry::smooth
                                                        : RL::Surface_geometry::flat);
    const RL::Spline_space_3 space(RL::soup(half.points, half.faces), np);
    const RL::Boundary_integration equator(space);
    CHECK(equator.length() == Approx(2 * pi).epsilon(is_smooth ? 1e-4 : 1e-2));
    for(const RL::Boundary_integration::Node& node : equator.nodes()) {
      REQUIRE(std::abs(node.conormal.z() + 1) <= (is_smooth ? 1e-3 : 0.05));
      REQUIRE(*std::min_element(node.location.barycentric.begin(),
                                node.location.barycentric.end()) == 0);
      REQUIRE(node.sheet < space.number_of_sheets(space.depth()));
      for(const double t : node.t)
        REQUIRE(std::abs(t - 0.5) <= 0.55); // smooth pieces of a curve leave their cells a little
      double sum = 0;                       // of all elements, which sum to 1
      for(const double derivative : equator.conormal_derivatives(node))
        sum += derivative;
      REQUIRE(std::abs(sum) <= 1e-9);
    }
    const double tolerance = is_smooth ? 1e-3 : 0.05;
    for(const bool with_value : {false, true}) {
      RL::Poisson_problem problem(f);
      const auto zero = [](const RL::Surface_point&) { return 0.; };
      const auto flux = [](const RL::Surface_point&) { return -1.; };
      if(with_value) {
        // zero on one half, the flux on the other
        problem.boundary_values = zero;
        problem.has_boundary_value = [](const RL::Surface_point& p) { return p.point.x() > 0; };
      }
      problem.boundary_flux = flux;
      const RL::Poisson_solution solution = RL::solve_poisson_problem(space, problem);
      CHECK(solution.converged);
      const std::vector<double> u =
          RL::Spline_function_3(space, solution.coefficients).values_at_vertices();
      const double shift = with_value ? 0 : 0.5; // the mean of z
      for(std::size_t v = 0; v < u.size(); ++v)
        if(!std::isnan(u[v]))
          REQUIRE(std::abs(u[v] + shift - half.points[v].z()) <= tolerance);
    }
  }
}

TEST_CASE("rule_of_lines_is_that_of_boost", "[boundary_conditions]") {
  using Rule = boost::math::quadrature::gauss<double, 7>;
  REQUIRE(2 * Rule::abscissa().size() - 1 == RL::internal::line_rule.size());
  for(std::size_t i = 0; i < RL::internal::line_rule.size(); ++i) {
    const auto [place, weight] = RL::internal::line_rule[i];
    CHECK(std::abs(place) == Rule::abscissa()[(i + 1) / 2]);
    CHECK(weight == Rule::weights()[(i + 1) / 2]);
    CHECK((i % 2 == 1) == (place > 0));
  }
}

TEST_CASE("what_is_wrong_with_boundary_conditions_is_said", "[boundary_conditions]") {
  const Triangles square = shapes::grid(4, [](double x, double y) { return RL::Point_3(x, y, 0); });
  Mesh mesh = shapes::mesh(square);
  const auto zero = [](const RL::Surface_point&) { return 0.; };
  auto u = mesh.add_property_map<Mesh::Vertex_index, double>("v:u").first;
  auto all_edges = mesh.add_property_map<Mesh::Edge_index, bool>("e:all", true).first;
  auto no_edge = mesh.add_property_map<Mesh::Edge_index, bool>("e:no", false).first;
  const auto np = params::depth(3);
  // an edge inside, values nowhere, a flux where values are, or on a closed surface
  CHECK_THROWS_AS(
      RL::solve_poisson(mesh, zero, u, np.boundary_values(0).edge_is_constrained_map(all_edges)),
      RL::Parameter_error);
  CHECK_THROWS_AS(
      RL::solve_poisson(mesh, zero, u, np.boundary_values(0).edge_is_constrained_map(no_edge)),
      RL::Parameter_error);
  CHECK_THROWS_AS(RL::solve_poisson(mesh, zero, u, np.boundary_values(0).boundary_flux(1)),
                  RL::Parameter_error);
  const Mesh sphere = shapes::mesh(shapes::sphere(1));
  std::vector<double> on_sphere(num_vertices(sphere));
  const auto map = [&](Mesh::Vertex_index v) -> double& { return on_sphere[v]; };
  const auto u_on_sphere = boost::make_function_property_map<Mesh::Vertex_index, double&>(map);
  CHECK_THROWS_AS(RL::solve_poisson(sphere, zero, u_on_sphere, np.boundary_flux(1)),
                  RL::Parameter_error);
  // NaN where values hold
  auto g = mesh.add_property_map<Mesh::Vertex_index, double>("v:g", 0).first;
  g[Mesh::Vertex_index(0)] = free_value;
  CHECK_THROWS_AS(RL::solve_poisson(mesh, zero, u, np.boundary_values(g)), RL::Parameter_error);
  CHECK_THROWS_AS(RL::solve_poisson(mesh, zero, u, np.boundary_flux(g)), RL::Parameter_error);
  // what has no solution gets the one for another f: all of the flux comes from f
  CHECK(RL::solve_poisson(mesh, zero, u, np.boundary_flux(1)).converged);
  for(const Mesh::Vertex_index v : mesh.vertices()) {
    const RL::Point_3& p = mesh.point(v);
    const double x = p.x() - 0.5, y = p.y() - 0.5; // Laplacian 4, derivatives 1 on all sides
    REQUIRE(u[v] == Approx(x * x + y * y - 1. / 6).margin(1e-3));
  }
}
