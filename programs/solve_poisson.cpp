// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Solves a Poisson problem on a mesh, and writes the solution at its vertices.

#include "support/command_line.h"
#include "support/point_input.h"
#include "support/poisson_input.h"
#include "support/program.h"
#include "support/solver_options.h"
#include "support/surface_program.h"
#include "support/table.h"
#include "support/vertex_data.h"

#include <CGAL/Restricted_laplacian_3/assembly/assemble.h>
#include <CGAL/Restricted_laplacian_3/patches/smooth_vertex_data.h>
#include <CGAL/Restricted_laplacian_3/problems/Poisson_problem.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_function_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <optional>
#include <string>
#include <utility>
#include <vector>

using namespace programs;
namespace params = RL::parameters;

const Help help = {"solve_poisson MESH [OPTION]...", std::string(R"(
Solves Laplacian u = f on a surface, or with --alpha A the screened problem
(A / area) u - Laplacian u = f; note the sign.

The Laplacian is the divergence of the gradient: it is negative, and on the unit sphere
f = z gives u = -z / 2. On each connected component of the surface the mean of f is
subtracted, and u has mean 0, unless u is prescribed there. With --alpha the mean of f on
the whole surface is subtracted, unless something is prescribed on the boundary. Boundaries
of the surface have the natural condition: u does not change across them, unless
--boundary-property prescribes u there, or --flux-property how fast it changes. u is NaN at
vertices that have no face, or only faces without area.
)") + about_meshes + about_points,
                   R"(  solve_poisson elephant.off --rhs x --output u.ply --csv u.csv
      the solution for f = x, as a colored mesh and a table
  solve_poisson elephant.off --alpha 100 --depth 7 --output screened.ply
      a screened problem on a finer grid
  solve_poisson ../points_3/kitten.xyz --csv u.csv
      on points with normals
)"};

struct Options : Common_options, Point_options, Solver_options, Poisson_options {
  Options() : Solver_options(RL::Poisson_solver_options::default_tolerance) {}

  std::string boundary_property, flux_property, cycle = "v", smoother = "patch";
};

void add_condition_options(po::options_description& problem, Options& o) {
  auto add = problem.add_options();
  add("boundary-property", po::value(&o.boundary_property)->value_name("NAME"),
      "u on the boundary: a vertex property of MESH, a PLY file; NaN where u is free. It counts on "
      "edges of the boundary both ends of which have a value");
  add("flux-property", po::value(&o.flux_property)->value_name("NAME"),
      "the derivative of u across the rest of the boundary, outward: a vertex property, too");
}

// returns false if there is nothing more to do
bool read_options(int argc, char* argv[], Options& o, po::variables_map& given) {
  po::options_description problem("Problem", help_width);
  add_poisson_options(problem, o);
  add_condition_options(problem, o);
  add_material_options(problem, o);
  add_accuracy_option(problem, "the estimated error of u, relative to its deviation from its mean,",
                      o);
  add_vertex_data_option(problem, o);
  po::options_description solver = solver_options(o, "default 0.001, or 0 with --paper");
  auto add = solver.add_options();
  add("cycle", po::value(&o.cycle)->value_name("v|w")->default_value(o.cycle), "multigrid cycle");
  add("smoother", po::value(&o.smoother)->value_name("point|patch")->default_value(o.smoother),
      "smoother of the multigrid cycle");
  po::options_description all(help_width);
  all.add(problem)
      .add(space_options(o))
      .add(integration_options(o))
      .add(point_options(o, o))
      .add(solver)
      .add(spline_output_options(o, "vertex, value", "the property value"))
      .add(general_options(o));

  if(!parse_command_line(argc, argv, help, all, o, given))
    return false;
  check_poisson_options(o, given);
  check_accuracy_option(o);
  check_solver_options(o, given);
  if(given["tolerance"].defaulted() && !o.boundary_property.empty())
    o.tolerance = RL::internal::tolerance_with_constraints;
  else if(given["tolerance"].defaulted() && o.space.accuracy)
    o.tolerance = std::min(o.tolerance, *o.space.accuracy);
  require_choice("cycle", o.cycle, {"v", "w"});
  require_choice("smoother", o.smoother, {"point", "patch"});
  return true;
}

// f at the vertices
std::vector<double> right_hand_side(const RL::Triangulated_surface_3& surface, const Options& o) {
  const std::size_t number = surface.number_of_vertices();
  if(!o.rhs_property.empty())
    return surface_property(surface, o, o.rhs_property);
  if(o.rhs == "random")
    return random_values(0, number, o.seed);
  std::vector<double> f;
  for(std::size_t v = 0; v < number; ++v)
    f.push_back(surface.point(v)[o.rhs[0] - 'x']);
  return f;
}

// The mean over the surface of the function f that is linear in each triangle. Vertices without a
// face of positive area are not on the surface, and f may be anything there.
double surface_mean(const RL::Triangulated_surface_3& surface, const std::vector<double>& f) {
  double sum = 0;
  for(std::size_t i = 0; i < surface.number_of_faces(); ++i)
    if(!surface.is_degenerate(i))
      for(const std::uint32_t vertex : surface.triangle(i))
        sum += surface.area(i) * f[vertex] / 3;
  return sum / surface.area();
}

// The same with the density of a space as weight.
double weighted_mean(const RL::Spline_space_3& space, const std::vector<double>& f,
                     const Options& o) {
  if(o.space.density_property.empty())
    return surface_mean(space.surface(), f);
  // elements sum to 1
  return RL::assemble_load(space, vertex_function(space.surface(), f, o)).sum() /
         RL::assemble_element_integrals(space).sum();
}

void check_right_hand_side(const RL::Triangulated_surface_3& surface,
                           const std::vector<double>& f) {
  for(std::size_t i = 0; i < surface.number_of_faces(); ++i)
    for(const std::uint32_t vertex : surface.triangle(i))
      if(!surface.is_degenerate(i) && !std::isfinite(f[vertex]))
        throw Error("the right-hand side is not a finite number at vertex " +
                    std::to_string(vertex));
}

Outcome solve(Job& job, const Options& o) {
  const RL::Triangulated_surface_3& surface = job.surface;
  std::vector<double> f = right_hand_side(surface, o);
  check_right_hand_side(surface, f);
  RL::Spline_space_3 space =
      job.make_space(o.alpha == 0 ? "on each component f and u have mean 0"
                                  : "components do not influence each other");

  const auto np =
      solver_parameters(o)
          .cycle(o.cycle == "v" ? RL::Cycle::V : RL::Cycle::W)
          .smoother(o.smoother == "patch" ? RL::Smoother_type::patch : RL::Smoother_type::point);
  const bool has_conditions = !o.boundary_property.empty() || !o.flux_property.empty();
  // Without screening it is a matter of the solver that f has mean 0.
  if(o.alpha > 0 && !has_conditions) {
    const double mean = weighted_mean(space, f, o);
    for(double& value : f)
      value -= mean;
  }
  const auto right_hand_side = vertex_function(surface, std::move(f), o);
  RL::Poisson_problem problem(right_hand_side);
  problem.alpha = o.alpha / surface.area();
  problem.solver = np;
  problem.stabilization = given_number(o.stabilization);
  problem.progress = job.step("solving for", space);
  std::optional<RL::Cubic_surface_function<double>> values, flux;
  if(!o.boundary_property.empty()) {
    values = vertex_function(surface, surface_property(surface, o, o.boundary_property), o);
    problem.boundary_values = *values;
    problem.has_boundary_value = [&](const RL::Surface_point& p) {
      return !std::isnan((*values)(p));
    };
  }
  if(!o.flux_property.empty()) {
    flux = vertex_function(surface, surface_property(surface, o, o.flux_property), o);
    problem.boundary_flux = *flux;
  }
  RL::internal::Poisson_solutions solution;
  if(o.space.accuracy) {
    solution = RL::internal::solve_poisson_to_accuracy(space, problem, *o.space.accuracy);
    job.add_space_of_search(space, solution);
  } else
    solution = RL::internal::solve_poisson_problems(space, problem);

  if(o.alpha == 0 && !space.is_paper_space())
    job.summary.add_detail("kernel_dimension", solution.kernel_dimension);
  job.add_solve(solution);
  const std::vector<double> u =
      RL::Spline_function_3(space, solution.coefficients.col(0)).values_at_vertices();
  const Value_range range(u);
  job.summary.add("minimum", range.low);
  job.summary.add("maximum", range.high);
  job.summary.add("mean", surface_mean(surface, u));
  Outcome result = outcome(u);
  result.page.isolines = 20;
  result.set_splines(space, solution.coefficients);
  return result;
}

int main(int argc, char* argv[]) {
  return run_surface_program("solve_poisson", argc, argv, read_options, solve);
}
