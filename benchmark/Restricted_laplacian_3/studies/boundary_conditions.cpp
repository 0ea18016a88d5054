// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// How accurate are solutions with prescribed values and fluxes?
//
// --part boundary: Laplacian u = 0 on parts of the plane where the solution is known, with its
// values on a part of the boundary and its flux through the rest:
//   annulus_mixed, annulus_values, annulus_fluxes  the logarithm of the radius, from 0.4 to 1
//   sector     r^3 cos(3 phi) on a sixth of a disc, values on the arc
//   half_disc  r^(1/2) sin(phi/2): 0 for phi = 0, no flux for phi = pi, values on the arc
//   l_values   r^(2/3) sin(2 phi/3) on an L, whose angle is 3 pi/2, values everywhere
//   l_fluxes   the same, values at the two sides of the corner alone
//   l_mixed    r^(1/3) sin(phi/3): the value 0 at one side of the corner, fluxes elsewhere
// Circles are polygons, and conditions are those of the function on them: the discretization alone
// errs. The order is the one that the theory of quadratic functions gives.
//
// --part points: values at vertices. On a sphere, Laplacian u = z and one value of 0, 1, ... 1e8:
// by how much u differs, beyond the constant, from that with the value 0. On a unit square, 0 and
// 1000 on two opposite sides, at the vertices and along the sides: the solution is 1000 x.
//
// Errors are the root mean square over the vertices, for points the largest; options are the
// defaults but for the tolerance in the first part, 1e-10.
//
// usage: boundary_conditions [OPTION]...

#include "../../test/Restricted_laplacian_3/harmonic_functions.h"
#include "../../test/Restricted_laplacian_3/special_shapes.h"
#include "support/driver.h"
#include "support/package.h"

#include <CGAL/Restricted_laplacian_3/assembly/Boundary_integration.h>
#include <CGAL/Restricted_laplacian_3/problems/Poisson_problem.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_function_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace {

using namespace benchmarks;
namespace params = RL::parameters;
using shapes::Triangles;

struct Options {
  std::vector<std::string> parts = {"boundary", "points"};
  std::vector<int> depths = {4, 5, 6, 7, 8};
};

/// a solution that is known, and where its values are prescribed
struct Case {
  std::string name;
  Triangles surface;
  shapes::Harmonic u;
  std::function<bool(const RL::Point_3&)> has_value;
  double order;
};

std::vector<Case> cases() {
  const double pi = std::acos(-1.);
  const auto everywhere = [](const RL::Point_3&) { return true; };
  const auto nowhere = [](const RL::Point_3&) { return false; };
  const auto is_inner = [](const RL::Point_3& p) { return std::hypot(p.x(), p.y()) < 0.5; };
  const auto is_round = [](const RL::Point_3& p) { return std::hypot(p.x(), p.y()) > 0.99; };
  const auto is_not_left = [](const RL::Point_3& p) { return p.y() > 1e-9 || p.x() > 0; };
  const auto is_reentrant = [](const RL::Point_3& p) {
    return (p.y() == 0 && p.x() > 0) || (p.x() == 0 && p.y() < 0);
  };
  const auto is_right_of_corner = [](const RL::Point_3& p) { return p.y() == 0 && p.x() > 0; };
  const Triangles annulus = shapes::sector(8, 48, 0.4, 2 * pi), l_shape = shapes::l_shape(16);
  return {{"annulus_mixed", annulus, shapes::logarithm, is_inner, 3},
          {"annulus_values", annulus, shapes::logarithm, everywhere, 3},
          {"annulus_fluxes", annulus, shapes::logarithm, nowhere, 3},
          {"sector", shapes::sector(16, 16, 0, pi / 3), shapes::power(3, pi / 2), is_round, 3},
          {"half_disc", shapes::sector(16, 32, 0, pi), shapes::power(0.5, 0), is_not_left, 1},
          {"l_values", l_shape, shapes::power(2. / 3, 0), everywhere, 4. / 3},
          {"l_fluxes", l_shape, shapes::power(2. / 3, 0), is_reentrant, 4. / 3},
          {"l_mixed", l_shape, shapes::power(1. / 3, 0), is_right_of_corner, 2. / 3}};
}

std::vector<double> values_at_vertices(const RL::Spline_space_3& space,
                                       const RL::Poisson_solution& solution) {
  return RL::Spline_function_3(space, solution.coefficients).values_at_vertices();
}

/// where the values are known up to a constant, it is the one for which the error is least
double root_mean_square_error(const Case& c, const std::vector<double>& values,
                              bool is_up_to_constant) {
  std::vector<double> errors;
  double mean = 0;
  for(std::size_t v = 0; v < values.size(); ++v)
    if(const RL::Point_3& p = c.surface.points[v]; p != CGAL::ORIGIN && !std::isnan(values[v])) {
      errors.push_back(values[v] - c.u.value(p.x(), p.y()));
      mean += errors.back();
    }
  mean = is_up_to_constant ? mean / static_cast<double>(errors.size()) : 0;
  double sum = 0;
  for(const double e : errors)
    sum += (e - mean) * (e - mean);
  return std::sqrt(sum / static_cast<double>(errors.size()));
}

void study_boundary(const Options& o) {
  std::printf("# %-16s %5s %9s %10s %10s %6s\n", "boundary", "depth", "unknowns", "iterations",
              "error", "order");
  for(const Case& c : cases())
    for(const int depth : o.depths) {
      const RL::Spline_space_3 space(RL::soup(c.surface.points, c.surface.faces),
                                     params::depth(depth));
      const auto f = [](const RL::Surface_point&) { return 0.; };
      const auto g = [&](const RL::Surface_point& p) {
        return c.u.value(p.point.x(), p.point.y());
      };
      const auto flux = [&](const RL::Surface_point& p) {
        return c.u.gradient(p.point.x(), p.point.y()) * shapes::conormal(c.surface, p);
      };
      const auto has_value = [&](const RL::Surface_point& p) { return c.has_value(p.point); };
      const auto has_none = [&](const RL::Surface_point& p) { return !c.has_value(p.point); };
      const bool has_values = RL::Boundary_integration(space, has_value).length() > 0;
      RL::Poisson_problem problem(f);
      if(has_values) {
        problem.boundary_values = g;
        problem.has_boundary_value = has_value;
      }
      if(RL::Boundary_integration(space, has_none).length() > 0)
        problem.boundary_flux = flux;
      problem.solver.tolerance = 1e-10;
      const RL::Poisson_solution solution = RL::solve_poisson_problem(space, problem);
      if(!solution.converged)
        std::printf("# %s, depth %d: did not converge\n", c.name.c_str(), depth);
      std::printf("%-18s %5d %9zu %10d %10.2e %6.3f\n", c.name.c_str(), depth,
                  static_cast<std::size_t>(space.dimension()), solution.iterations,
                  root_mean_square_error(c, values_at_vertices(space, solution), !has_values),
                  c.order);
      std::fflush(stdout);
    }
}

void study_one_value(const Options& o) {
  const Triangles sphere = shapes::sphere(3);
  const auto f = [](const RL::Surface_point& p) { return p.point.z(); };
  constexpr std::size_t vertex = 7;
  for(const int depth : o.depths) {
    const RL::Spline_space_3 space(RL::soup(sphere.points, sphere.faces), params::depth(depth));
    std::vector<double> at_zero;
    for(const double value : {0., 1., 100., 1e4, 1e8}) {
      RL::Poisson_problem problem(f);
      problem.vertex_values.assign(sphere.points.size(), std::numeric_limits<double>::quiet_NaN());
      problem.vertex_values[vertex] = value;
      const RL::Poisson_solution solution = RL::solve_poisson_problem(space, problem);
      if(!solution.converged)
        std::printf("# value %g, depth %d: did not converge\n", value, depth);
      std::vector<double> u = values_at_vertices(space, solution);
      const double miss = std::abs(u[vertex] - value);
      if(value == 0)
        at_zero = u;
      double change = 0;
      for(std::size_t v = 0; v < u.size(); ++v)
        change = (std::max)(change, std::abs(u[v] - value - at_zero[v]));
      std::printf("%-18s %5d %9zu %10d %10g %10.1e %10.1e\n", "sphere", depth,
                  static_cast<std::size_t>(space.dimension()), solution.iterations, value, change,
                  miss);
      std::fflush(stdout);
    }
  }
}

void study_two_sides(const Options& o) {
  constexpr int n = 16;
  const Triangles square = shapes::grid(n, [](double x, double y) { return RL::Point_3(x, y, 0); });
  const auto f = [](const RL::Surface_point&) { return 0.; };
  for(const int depth : o.depths) {
    const RL::Spline_space_3 space(RL::soup(square.points, square.faces), params::depth(depth));
    RL::Poisson_problem problem(f);
    for(const RL::Point_3& p : square.points)
      problem.vertex_values.push_back(
          p.x() == 0 || p.x() == 1 ? 1000 * p.x() : std::numeric_limits<double>::quiet_NaN());
    const RL::Poisson_solution solution = RL::solve_poisson_problem(space, problem);
    if(!solution.converged)
      std::printf("# square, depth %d: did not converge\n", depth);
    const std::vector<double> u = values_at_vertices(space, solution);
    double error = 0;
    for(std::size_t v = 0; v < u.size(); ++v)
      error = (std::max)(error, std::abs(u[v] - 1000 * square.points[v].x()));
    std::printf("%-18s %5d %9zu %10d %10g %10.1e %10.1e\n", "square", depth,
                static_cast<std::size_t>(space.dimension()), solution.iterations, 1000., error,
                solution.constraint_error);
    std::fflush(stdout);
  }
}

bool read_options(int argc, char* argv[], Options& o) {
  Command_line line("usage: boundary_conditions [OPTION]...");
  line.add("part", o.parts, "boundary points");
  line.add("depth", o.depths, "4 5 6 7 8");
  return line.read(argc, argv);
}

} // namespace

int main(int argc, char* argv[]) {
  return run_benchmark("boundary_conditions", [&] {
    Options o;
    if(!read_options(argc, argv, o))
      return;
    print_header(argc, argv);
    for(const std::string& part : o.parts)
      if(part == "boundary")
        study_boundary(o);
      else {
        std::printf("# %-16s %5s %9s %10s %10s %10s %10s\n", "points", "depth", "unknowns",
                    "iterations", "value", "error", "miss");
        study_one_value(o);
        study_two_sides(o);
      }
  });
}
