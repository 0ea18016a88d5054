// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Solves a Poisson problem on a mesh, and writes the solution at its vertices.

#include "support/command_line.h"
#include "support/mesh_input.h"
#include "support/mesh_output.h"
#include "support/picture.h"
#include "support/ply_property.h"
#include "support/program.h"
#include "support/space.h"
#include "support/table.h"

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

const char* const usage =
    "usage: solve_poisson MESH [OPTION]...\n"
    "\n"
    "Solves Laplacian u = f on the surface of MESH (off, obj, ply, stl, ts). The Laplacian is\n"
    "the divergence of the gradient: it is negative, and on the unit sphere f = z gives\n"
    "u = -z / 2. The surface mean of f is subtracted, and u has surface mean 0.\n"
    "With --alpha A it solves (A / area) u - Laplacian u = f instead; note the sign.\n"
    "Boundaries of the surface have the natural condition: u does not change across them.\n"
    "The value is NaN at vertices that no face uses.\n"
    "\n"
    "Exit status: 0 if all went well; 1 on an error; 2 if the solver did not converge, after\n"
    "the output was written.\n";

struct Options : Common_options {
  std::string rhs = "z", rhs_property;
  double alpha = 0, tolerance = RL::Poisson_solver_options().relative_tolerance;
  std::string cycle = "v", smoother = "point";
};

// returns false if there is nothing more to do
bool read_options(int argc, char* argv[], Options& o) {
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
  po::options_description all(help_width);
  all.add(problem).add(space_options(o)).add(solver).add(output_options(o));

  po::variables_map given;
  if(!parse_command_line(argc, argv, usage, all, o, given))
    return false;
  require_choice("rhs", o.rhs, {"x", "y", "z", "random"});
  require(given["rhs"].defaulted() || given.count("rhs-property") == 0,
          "give --rhs or --rhs-property, not both");
  require(o.alpha >= 0 && std::isfinite(o.alpha), "the argument of --alpha must not be negative");
  require(o.tolerance > 0 && o.tolerance < 1, "the argument of --tolerance must be in (0, 1)");
  require_choice("cycle", o.cycle, {"v", "w"});
  require_choice("smoother", o.smoother, {"point", "patch"});
  require(o.smoother == "point", "--smoother: the patch smoother is not available");
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

// f at the vertices of the mesh
void set_right_hand_side(const Mesh_input& input, const Options& o, Values& f) {
  if(o.rhs_property.empty() && o.rhs != "random") {
    for(const Vertex v : input.mesh.vertices())
      f[v] = input.mesh.point(v)[o.rhs[0] - 'x'];
    return;
  }
  const std::vector<double> in_file = o.rhs_property.empty()
                                          ? random_values(input.vertex_of_file.size(), o.seed)
                                          : read_ply_property(o.mesh, o.rhs_property);
  require(in_file.size() == input.vertex_of_file.size(), "not every vertex has a value");
  for(const Vertex v : input.mesh.vertices()) {
    f[v] = in_file[input.file_index[v.idx()]];
    if(!std::isfinite(f[v]) && !input.mesh.is_isolated(v))
      throw Error("the property '" + o.rhs_property + "' of vertex " +
                  std::to_string(input.file_index[v.idx()]) + " is not a finite number");
  }
}

// the mean over the surface of a function that is linear in each triangle
double surface_mean(const RL::Triangulated_surface_3& surface, const Values& f) {
  double sum = 0;
  for(std::size_t i = 0; i < surface.number_of_faces(); ++i)
    for(const std::uint32_t vertex : surface.triangle(i))
      sum += surface.area(i) * f[Vertex(vertex)] / 3;
  return sum / surface.area();
}

// Solves the problem, with the results at the vertices in `u`, and describes what was done.
RL::Solve_report solve(const Mesh& mesh, const Options& o, Values& f, Values& u, Summary& summary,
                       const Progress& progress) {
  CGAL::Real_timer timer;
  timer.start();
  progress.show("building the spline space");
  const RL::Spline_space_3 space = make_space(mesh, o);
  const double area = space.surface().area();
  const double space_seconds = timer.time();

  progress.show("assembling " + std::to_string(space.dimension()) + " unknowns");
  const double mean = surface_mean(space.surface(), f);
  for(double& value : f)
    value -= mean;
  RL::Operators operators;
  Eigen::VectorXd load;
  assemble_with(space, o, [&](const auto& integration) {
    operators = RL::assemble_operators(space, space.depth(), integration);
    load = RL::assemble_load(space, RL::vertex_function(mesh, f), space.depth(), integration);
  });
  const double assembly_seconds = timer.time() - space_seconds;

  progress.show("setting up the solver");
  const RL::Poisson_solver solver = RL::make_poisson_solver(
      space, operators, o.alpha / area,
      params::relative_tolerance(o.tolerance,
                                 params::cycle(o.cycle == "v" ? RL::Cycle::V : RL::Cycle::W)));

  // The Laplacian is minus the stiffness matrix.
  progress.show("solving");
  if(o.alpha == 0)
    load = -load;
  Eigen::VectorXd coefficients;
  const RL::Solve_report report = solver.solve(load, coefficients);
  RL::evaluate_at_vertices(RL::Spline_function_3(space, std::move(coefficients)), mesh, u);

  summary.add("depth", space.depth());
  summary.add("dimension", space.dimension());
  summary.add("area", area);
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
    if(!read_options(argc, argv, o))
      return success;
    const Progress progress(o.quiet);

    progress.show("reading " + o.mesh);
    Mesh_input input = read_mesh(o.mesh);
    Values f = input.mesh.add_property_map<Vertex, double>("v:f").first;
    Values u = input.mesh.add_property_map<Vertex, double>("v:value").first;
    set_right_hand_side(input, o, f);

    Summary summary(input);
    summary.add("threads", 1);
    const RL::Solve_report report = solve(input.mesh, o, f, u, summary, progress);

    progress.show("writing the results");
    if(!o.csv.empty())
      write_csv(o.csv, summary, "vertex,value", values_in_file_order(input, u));
    if(!o.output.empty())
      write_mesh(o.output, input.mesh, u);
    if(!o.picture.empty())
      write_picture(o.picture, input.mesh, value_colors(u), u, {o.up == "z", o.isolines});
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
