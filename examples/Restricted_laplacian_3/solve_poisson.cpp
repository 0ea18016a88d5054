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

#include <CGAL/Restricted_laplacian_3/solve_poisson.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_function_3.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <optional>
#include <string>
#include <utility>
#include <vector>

using namespace examples;
namespace params = RL::parameters;

const Help help = {"solve_poisson MESH [OPTION]...", std::string(R"(
Solves Laplacian u = f on a surface, or with --alpha A the screened problem
(A / area) u - Laplacian u = f; note the sign.

The Laplacian is the divergence of the gradient: it is negative, and on the unit sphere
f = z gives u = -z / 2. On each connected component of the surface the mean of f is
subtracted, and u has mean 0. With --alpha the mean of f on the whole surface is subtracted.
Boundaries of the surface have the natural condition: u does not change across them. u is
NaN at vertices that have no face, or only faces without area.
)") + about_meshes + about_points,
                   R"(  solve_poisson elephant.off --rhs x --output u.ply --csv u.csv
      the solution for f = x, as a colored mesh and a table
  solve_poisson elephant.off --alpha 100 --depth 7 --output screened.ply
      a screened problem on a finer grid
  solve_poisson ../points_3/kitten.xyz --csv u.csv
      on points with normals
)"};

struct Options : Common_options, Point_options, Solver_options, Poisson_options {
  Options() : Solver_options(RL::Poisson_solver::default_tolerance) {}

  std::string cycle = "v", smoother = "patch";
};

// returns false if there is nothing more to do
bool read_options(int argc, char* argv[], Options& o, po::variables_map& given) {
  po::options_description problem("Problem", help_width);
  add_poisson_options(problem, o);
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
  check_solver_options(o, given);
  require_choice("cycle", o.cycle, {"v", "w"});
  require_choice("smoother", o.smoother, {"point", "patch"});
  return true;
}

// f at the vertices
std::vector<double> right_hand_side(const RL::Triangulated_surface_3& surface, const Options& o) {
  const std::size_t number = surface.number_of_vertices();
  if(!o.rhs_property.empty()) {
    const std::vector<double> f = read_ply_property(o.mesh, o.rhs_property);
    require(f.size() == number, "not every vertex has a value");
    return f;
  }
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
  const RL::Spline_space_3 space =
      job.make_space(o.alpha == 0 ? "on each component f and u have mean 0"
                                  : "components do not influence each other");

  const auto np =
      solver_parameters(o)
          .cycle(o.cycle == "v" ? RL::Cycle::V : RL::Cycle::W)
          .smoother(o.smoother == "patch" ? RL::Smoother_type::patch : RL::Smoother_type::point)
          .callback(job.step("solving for", space));
  // Without screening it is a matter of the solver that f has mean 0.
  if(o.alpha > 0) {
    const double mean = surface_mean(surface, f);
    for(double& value : f)
      value -= mean;
  }
  const auto right_hand_side = vertex_function(surface, std::move(f), o);
  const RL::Poisson_solution solution =
      o.alpha > 0 ? RL::solve_screened_poisson(space, right_hand_side, o.alpha / surface.area(), np)
                  : RL::solve_poisson(space, right_hand_side, np);

  if(o.alpha == 0 && !space.is_paper_space())
    job.summary.add_detail("kernel_dimension", solution.kernel_dimension);
  job.add_solve(solution);
  const std::vector<double> u =
      RL::Spline_function_3(space, solution.coefficients).values_at_vertices();
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
