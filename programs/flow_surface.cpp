// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Moves a surface by mean-curvature flow, and writes where its vertices are then.

#include "support/command_line.h"
#include "support/moved_surface.h"
#include "support/program.h"
#include "support/solver_options.h"
#include "support/step_series.h"
#include "support/surface_program.h"

#include <CGAL/Restricted_laplacian_3/problems/Mean_curvature_flow.h>

#include <string>

using namespace programs;
namespace params = RL::parameters;

const Help help = {
    "flow_surface MESH --steps N --time-step T [OPTION]...", std::string(R"(
Moves a surface by mean-curvature flow: dx/dt = Laplacian x, in implicit steps.

A sphere of the radius r shrinks as (r^2 - 4 t)^(1/2), and thin parts sooner than thick
ones. Where a part collapses the program stops, says so, and writes the surface before the
step. With --conformal the energy remains that of the first surface: then a surface without
holes and handles becomes a sphere, and the map to it is conformal in the end; it is scaled
to its first area after each step.
)") + about_meshes,
    R"(  flow_surface elephant.off --steps 30 --time-step 0.01 --conformal --output sphere.ply
      a conformal map to a sphere, colored by how far vertices moved
  flow_surface mannequin-devil.off --steps 5 --time-step 1e-5 --csv positions.csv
      where the vertices are after a short time
  flow_surface elephant.off --steps 9 --time-step 1e-3 --conformal --pictures flow
      pictures flow0.png to flow9.png; --html has a slider over the steps instead
)"};

struct Options : Common_options {
  int steps = 1;
  double time_step = 0;
  Solver_options solver{RL::Mean_curvature_flow_options().tolerance, false};
  bool conformal = false, free_boundary = false;
  std::string rescaling, pictures;
};

// returns false if there is nothing more to do
bool read_options(int argc, char* argv[], Options& o, po::variables_map& given) {
  po::options_description problem("Flow", help_width);
  auto add = problem.add_options();
  add("steps", po::value(&o.steps)->value_name("N")->default_value(o.steps), "how many");
  add("time-step", po::value(&o.time_step)->value_name("T"), "in units of squared length");
  add("conformal", po::bool_switch(&o.conformal), "with the energy of the first surface");
  add("rescaling", po::value(&o.rescaling)->value_name("none|area|volume"),
      "what is kept by scaling after each step; default: area with --conformal, or none");
  add("no-fixed-boundary", po::bool_switch(&o.free_boundary),
      "the boundary of an open surface moves, too; by default it stays where it is");
  add("pictures", po::value(&o.pictures)->value_name("PREFIX"),
      "draws the surface before the first step and after at most 20 others; PREFIX and the "
      "number of the step are the name of a PNG file");
  po::options_description all(help_width);
  all.add(problem)
      .add(space_options(o))
      .add(solver_options(o.solver, "default 0.001"))
      .add(output_options(o, "vertex, x, y, z",
                          "the property displacement, how far they moved, of the moved mesh; "
                          "pages show up to 20 of the steps, too"))
      .add(general_options(o));

  if(!parse_command_line(argc, argv, help, all, o, given))
    return false;
  require(o.steps > 0, "the argument of --steps must be positive");
  require(is_given(given, "time-step"), "give --time-step");
  require_positive(given, "time-step", o.time_step);
  check_solver_options(o.solver, given);
  if(is_given(given, "rescaling"))
    require_choice("rescaling", o.rescaling, {"none", "area", "volume"});
  return true;
}

RL::Mean_curvature_flow_options flow_options(const Options& o) {
  RL::Mean_curvature_flow_options result;
  result.conformal = o.conformal;
  if(!o.rescaling.empty())
    result.rescaling = o.rescaling == "area"     ? RL::Rescaling::area
                       : o.rescaling == "volume" ? RL::Rescaling::volume
                                                 : RL::Rescaling::none;
  result.fixed_boundary = !o.free_boundary;
  result.tolerance = o.solver.tolerance;
  result.stabilization = given_number(o.solver.stabilization);
  return result;
}

Outcome flow_surface(Job& job, const Options& o) {
  const RL::Spline_space_3 space = job.make_space("each component moves on its own");
  RL::Mean_curvature_flow flow(space, flow_options(o));
  const auto progress = job.step("moving", space);
  RL::Flow_report report;
  const bool is_shown = !o.html.empty() || !o.pictures.empty();
  Step_series series(job.surface, o.steps);
  double solve_seconds = 0;
  int steps = 0;
  while(steps < o.steps && report.collapse.empty()) {
    report = flow.step(o.time_step);
    solve_seconds += report.solve_seconds;
    steps += report.collapse.empty();
    if(is_shown && series.wants(steps) && steps > series.last_step())
      series.add(steps, report.time, flow.vertex_positions());
    progress(static_cast<double>(steps) / o.steps);
    if(!report.converged)
      break;
  }
  report.solve_seconds = solve_seconds;
  job.add_solve(report);
  job.summary.add("steps", steps);
  job.summary.add("time", report.time);
  job.summary.add("moved_area", report.area);
  job.summary.add("moved_volume", report.volume);
  job.summary.add("smallest_angle", report.smallest_angle);
  job.summary.add("mean_distortion", report.mean_distortion);
  job.summary.add("largest_distortion", report.largest_distortion);
  job.summary.add("sphere_deviation", report.sphere_deviation);
  if(!report.collapse.empty())
    job.fail("after " + std::to_string(steps) + " steps " + report.collapse);

  if(is_shown && steps > series.last_step())
    series.add(steps, report.time, flow.vertex_positions());

  Outcome result = moved_outcome(job.surface, flow.vertex_positions());
  series.show_on_page(result.page);
  if(!o.pictures.empty())
    result.write_more = [series, prefix = o.pictures] { series.draw(prefix); };
  return result;
}

int main(int argc, char* argv[]) {
  return run_surface_program("flow_surface", argc, argv, read_options, flow_surface);
}
