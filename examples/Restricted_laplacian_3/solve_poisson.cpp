// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Solves a Poisson problem on a mesh, and writes the solution at its vertices.

#include "support/command_line.h"
#include "support/mesh_input.h"
#include "support/mesh_output.h"
#include "support/picture.h"
#include "support/ply_property.h"
#include "support/point_input.h"
#include "support/program.h"
#include "support/space.h"
#include "support/table.h"
#include "support/threads.h"

#include <CGAL/Restricted_laplacian_3/Spline_function_3.h>
#include <CGAL/Restricted_laplacian_3/assemble.h>
#include <CGAL/Restricted_laplacian_3/solve_poisson.h>

#include <CGAL/Real_timer.h>

#include <Eigen/Core>

#include <boost/random/normal_distribution.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <random>
#include <string>
#include <utility>
#include <vector>

using namespace examples;
namespace params = CGAL::parameters;

const char* const usage =
    "usage: solve_poisson MESH [OPTION]...\n"
    "\n"
    "Solves Laplacian u = f on the surface of MESH (off, obj, ply, stl, ts, xyz). The Laplacian "
    "is\n"
    "the divergence of the gradient: it is negative, and on the unit sphere f = z gives\n"
    "u = -z / 2. On each connected component of the surface the mean of f is subtracted, and u\n"
    "has mean 0.\n"
    "With --alpha A it solves (A / area) u - Laplacian u = f instead, where the mean of f on the\n"
    "whole surface is subtracted; note the sign.\n"
    "Boundaries of the surface have the natural condition: u does not change across them.\n"
    "The value is NaN at vertices that have no face, or only faces without area.\n"
    "\n"
    "Exit status: 0 if all went well; 1 on an error; 2 if the solver did not converge, after\n"
    "the output was written.\n";

struct Options : Common_options, Point_options {
  std::string rhs = "z", rhs_property;
  double alpha = 0, tolerance = RL::Poisson_solver_options().relative_tolerance;
  double stabilization = -1; // the default
  std::string cycle = "v", smoother = "patch";
};

// returns false if there is nothing more to do
bool read_options(int argc, char* argv[], Options& o, po::variables_map& given) {
  po::options_description problem("Problem", help_width);
  auto add = problem.add_options();
  add("rhs", po::value(&o.rhs)->value_name("x|y|z|random")->default_value(o.rhs),
      "f: a coordinate, or independent normal random numbers at the vertices");
  add("rhs-property", po::value(&o.rhs_property)->value_name("NAME"),
      "f: a vertex property of MESH, a PLY file");
  add("alpha", po::value(&o.alpha)->value_name("A")->default_value(o.alpha),
      "screening weight, in units of 1 / area");
  po::options_description solver("Solver", help_width);
  add = solver.add_options();
  add("tolerance", po::value(&o.tolerance)->value_name("T")->default_value(o.tolerance),
      "norm of the residual, relative to that of the right-hand side");
  add("cycle", po::value(&o.cycle)->value_name("v|w")->default_value(o.cycle), "multigrid cycle");
  add("smoother", po::value(&o.smoother)->value_name("point|patch")->default_value(o.smoother),
      "smoother of the multigrid cycle");
  add("stabilization", po::value(&o.stabilization)->value_name("C"),
      "factor of the stabilization by normal derivatives; default 0.001, or 0 with --paper");
  po::options_description all(help_width);
  all.add(problem)
      .add(space_options(o))
      .add(point_options(o, o))
      .add(solver)
      .add(output_options(o));

  if(!parse_command_line(argc, argv, usage + std::string("\n") + about_points, all, o, given))
    return false;
  require_choice("rhs", o.rhs, {"x", "y", "z", "random"});
  require(given["rhs"].defaulted() || given.count("rhs-property") == 0,
          "give --rhs or --rhs-property, not both");
  require(o.alpha >= 0 && std::isfinite(o.alpha), "the argument of --alpha must not be negative");
  require(o.tolerance > 0 && o.tolerance < 1, "the argument of --tolerance must be in (0, 1)");
  require_choice("cycle", o.cycle, {"v", "w"});
  require_choice("smoother", o.smoother, {"point", "patch"});
  require(given.count("stabilization") == 0 ||
              (o.stabilization >= 0 && std::isfinite(o.stabilization)),
          "the argument of --stabilization must be a number that is not negative");
  return true;
}

std::vector<double> random_values(std::size_t number, long long seed) {
  // std::normal_distribution differs between standard libraries
  std::mt19937_64 generator(static_cast<std::uint64_t>(seed));
  boost::random::normal_distribution<double> distribution;
  std::vector<double> values(number);
  for(double& value : values)
    value = distribution(generator);
  return values;
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
    return random_values(number, o.seed);
  std::vector<double> f;
  for(std::size_t v = 0; v < number; ++v)
    f.push_back(surface.point(v)[o.rhs[0] - 'x']);
  return f;
}

// The mean over the surface of the function f that is linear in each triangle. Vertices without a
// face of positive area are not on the surface, and f may be anything there.
double surface_mean(const RL::Triangulated_surface_3& surface, const std::vector<double>& f) {
  double sum = 0;
  for(std::size_t i = 0; i < surface.number_of_faces(); ++i) {
    if(surface.is_degenerate(i))
      continue;
    for(const std::uint32_t vertex : surface.triangle(i)) {
      if(!std::isfinite(f[vertex]))
        throw Error("the right-hand side is not a finite number at vertex " +
                    std::to_string(vertex));
      sum += surface.area(i) * f[vertex] / 3;
    }
  }
  return sum / surface.area();
}

// Solves the problem, with the results at the vertices in `u`, and describes what was done.
RL::Solve_report solve(const RL::Triangulated_surface_3& surface, const Options& o,
                       std::vector<double> f, std::vector<double>& u, Summary& summary,
                       const Progress& progress) {
  CGAL::Real_timer timer;
  timer.start();
  progress.show("building the spline space");
  const RL::Spline_space_3 space(surface, o.space);
  const double space_seconds = timer.time();

  progress.show("assembling " + std::to_string(space.dimension()) + " unknowns");
  const double mean = surface_mean(surface, f);
  for(double& value : f)
    value -= mean;
  const double stabilization =
      o.stabilization < 0 ? RL::default_normal_stabilization(space) : o.stabilization;
  const auto parameters = params::relative_tolerance(
      o.tolerance, params::cycle(o.cycle == "v" ? RL::Cycle::V : RL::Cycle::W,
                                 params::smoother(o.smoother == "patch" ? RL::Smoother::patch
                                                                        : RL::Smoother::point,
                                                  params::normal_stabilization(stabilization))));
  Eigen::VectorXd load;
  const RL::Poisson_solver solver = assemble_with(space, o, [&](const auto& integration) {
    load = RL::assemble_load(space, RL::Linear_surface_function<double>(f), space.depth(),
                             integration);
    return RL::make_poisson_solver(
        space, o.alpha / surface.area(), integration,
        params::concurrency_tag(CGAL::Parallel_if_available_tag(), parameters));
  });
  const double assembly_seconds = timer.time() - space_seconds - solver.setup_seconds();

  // The Laplacian is minus the stiffness matrix.
  progress.show("solving");
  if(o.alpha == 0)
    load = -load;
  Eigen::VectorXd coefficients;
  const RL::Solve_report report = solver.solve(load, coefficients);
  u = RL::Spline_function_3(space, std::move(coefficients)).values_at_vertices();

  add_space(summary, space);
  if(o.alpha == 0 && !space.is_paper_space())
    summary.add("kernel_dimension", solver.kernel_dimension());
  summary.add("setup_seconds", space_seconds + report.setup_seconds);
  summary.add("assembly_seconds", assembly_seconds);
  summary.add("solve_seconds", report.solve_seconds);
  summary.add("iterations", report.iterations);
  summary.add("relative_residual", report.relative_residual);
  return report;
}

int main(int argc, char* argv[]) {
  return run_program("solve_poisson", [&]() -> int {
    Options o;
    po::variables_map given;
    if(!read_options(argc, argv, o, given))
      return success;
    const Progress progress(o.quiet);

    progress.show("reading " + o.mesh);
    const Mesh_input input = read_mesh_or_points(o, o, given);
    Summary summary(input);
    const Thread_limit threads(o.threads);
    summary.add("threads", threads.number());
    std::vector<double> u;
    const RL::Solve_report report =
        solve(input.surface, o, right_hand_side(input.surface, o), u, summary, progress);

    progress.show("writing the results");
    if(!o.csv.empty())
      write_csv(o.csv, summary, "vertex,value", u);
    if(!o.output.empty())
      write_mesh(o.output, input.surface, u);
    if(!o.picture.empty())
      write_picture(o.picture, input.surface, value_colors(u), u, {o.up == "z", o.isolines});
    progress.show("");
    if(!o.quiet)
      summary.print(std::cout);
    if(!report.converged) {
      print_error("solve_poisson",
                  "the solver did not converge: " + std::to_string(report.iterations) +
                      " iterations left the relative residual above the tolerance");
      return not_converged;
    }
    return success;
  });
}
