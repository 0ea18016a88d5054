// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Estimates mean and Gaussian curvature of a mesh, and writes them at its vertices.

#include "support/command_line.h"
#include "support/mesh_input.h"
#include "support/mesh_output.h"
#include "support/picture.h"
#include "support/point_input.h"
#include "support/program.h"
#include "support/space.h"
#include "support/table.h"
#include "support/threads.h"

#include <CGAL/Restricted_laplacian_3/estimate_curvature.h>

#include <CGAL/Real_timer.h>

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <iostream>
#include <string>
#include <vector>

using namespace examples;
namespace params = CGAL::parameters;

const char* const usage =
    "usage: estimate_curvature MESH [OPTION]...\n"
    "\n"
    "Estimates the mean curvature H and the Gaussian curvature K of the surface of MESH (off,\n"
    "obj, ply, stl, ts, xyz) at its vertices. A sphere of radius r whose normals point outward\n"
    "has H = 1 / r; if they point inward, H = -1 / r.\n"
    "Methods: normals, the derivative of a fit of vertex normals; face-normals, the same with the\n"
    "normals of the faces; coordinates, the Laplacian of the coordinates, which gives H only, and\n"
    "NaN for K. The faces must be oriented alike.\n"
    "The values are NaN at vertices that have no face, or only faces without area.\n"
    "\n"
    "Exit status: 0 if all went well; 1 on an error; 2 if the solver did not converge, after\n"
    "the output was written.\n";

struct Options : Common_options, Point_options {
  std::string method = "normals", show = "mean";
  double smoothing = -1; // the default
  double stabilization = RL::default_curvature_stabilization;
  double tolerance = RL::Function_fit_options().solver.relative_tolerance, clip = 95;
};

// returns false if there is nothing more to do
bool read_options(int argc, char* argv[], Options& o, po::variables_map& given) {
  po::options_description problem("Problem", help_width);
  auto add = problem.add_options();
  add("method",
      po::value(&o.method)->value_name("normals|face-normals|coordinates")->default_value(o.method),
      "how curvature is estimated");
  add("smoothing", po::value(&o.smoothing)->value_name("W"),
      "weight of the squared gradient of the normals, in units of the squared width of a cell; by "
      "default 1, and 0 on surfaces with a boundary and on points");
  po::options_description solver("Solver", help_width);
  add = solver.add_options();
  add("tolerance", po::value(&o.tolerance)->value_name("T")->default_value(o.tolerance),
      "norm of the residual, relative to that of the right-hand side");
  add("stabilization", po::value(&o.stabilization)->value_name("C")->default_value(o.stabilization),
      "factor of the stabilization by normal derivatives");
  po::options_description colors("Colors", help_width);
  add = colors.add_options();
  add("show", po::value(&o.show)->value_name("mean|gaussian")->default_value(o.show),
      "what colors show: blue is negative, red positive");
  add("clip", po::value(&o.clip)->value_name("P")->default_value(o.clip),
      "colors are full at the magnitude that P percent of the vertices are below");
  po::options_description all(help_width);
  all.add(problem)
      .add(space_options(o))
      .add(point_options(o, o))
      .add(solver)
      .add(colors)
      .add(output_options(o));

  if(!parse_command_line(argc, argv, usage + std::string("\n") + about_points, all, o, given))
    return false;
  require_choice("method", o.method, {"normals", "face-normals", "coordinates"});
  require_choice("show", o.show, {"mean", "gaussian"});
  require(o.show == "mean" || o.method != "coordinates",
          "--show gaussian needs another --method than coordinates");
  require(o.tolerance > 0 && o.tolerance < 1, "the argument of --tolerance must be in (0, 1)");
  require(o.clip > 0 && o.clip <= 100, "the argument of --clip must be in (0, 100]");
  for(const char* option : {"smoothing", "stabilization"})
    require(given.count(option) == 0 ||
                (given[option].as<double>() >= 0 && std::isfinite(given[option].as<double>())),
            std::string("the argument of --") + option + " must be a number that is not negative");
  return true;
}

RL::Curvature_method method(const Options& o) {
  return o.method == "normals"        ? RL::Curvature_method::normals
         : o.method == "face-normals" ? RL::Curvature_method::face_normals
                                      : RL::Curvature_method::coordinates;
}

// Estimates the curvatures at the vertices, and describes what was done.
bool estimate(const RL::Triangulated_surface_3& surface, const Options& o,
              Eigen::MatrixXd& curvatures, Summary& summary, const Progress& progress) {
  CGAL::Real_timer timer;
  timer.start();
  progress.show("building the spline space");
  const RL::Spline_space_3 space(surface, o.space);
  const double space_seconds = timer.time();

  progress.show("fitting by " + std::to_string(space.dimension()) + " unknowns");
  const double h = space.octree().cell_width(space.depth());
  const auto np = params::curvature_method(
      method(o), params::relative_tolerance(
                     o.tolerance, params::normal_stabilization(
                                      o.stabilization,
                                      params::concurrency_tag(CGAL::Parallel_if_available_tag()))));
  const RL::Curvature_field field = assemble_with(space, o, [&](const auto& integration) {
    return o.smoothing < 0
               ? RL::estimate_curvature(space, integration, np)
               : RL::estimate_curvature(space, integration,
                                        params::smoothing_weight(o.smoothing * h * h, np));
  });
  const std::vector<RL::Surface_curvature> values = field.at_vertices();
  curvatures.resize(static_cast<Eigen::Index>(values.size()), 2);
  for(std::size_t v = 0; v < values.size(); ++v)
    curvatures.row(static_cast<Eigen::Index>(v)) << values[v].mean, values[v].gaussian;

  const RL::Fit_report& report = field.report();
  add_space(summary, space);
  summary.add("setup_seconds", space_seconds + report.setup_seconds);
  summary.add("assembly_seconds", report.assembly_seconds);
  summary.add("solve_seconds", report.solve_seconds);
  summary.add("iterations", report.iterations);
  summary.add("relative_residual", report.relative_residual);
  if(!report.root_mean_square_errors.empty())
    summary.add("rms_error_of_normals", report.root_mean_square_error());
  return report.converged;
}

int main(int argc, char* argv[]) {
  return run_program("estimate_curvature", [&]() -> int {
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
    Eigen::MatrixXd curvatures;
    const bool has_converged = estimate(input.surface, o, curvatures, summary, progress);

    progress.show("writing the results");
    const Eigen::VectorXd column = curvatures.col(o.show == "mean" ? 0 : 1);
    const std::vector<double> shown(column.begin(), column.end());
    const std::vector<Color> colors = clipped_colors(shown, o.clip / 100);
    const std::vector<std::string> names = {"mean", "gaussian"};
    if(!o.csv.empty())
      write_csv(o.csv, summary, "vertex", names, curvatures);
    if(!o.output.empty())
      write_mesh(o.output, input.surface, colors, names, curvatures);
    if(!o.picture.empty())
      write_picture(o.picture, input.surface, colors, shown, {o.up == "z", o.isolines});
    progress.show("");
    if(!o.quiet)
      summary.print(std::cout);
    if(!has_converged) {
      print_error("estimate_curvature", "the solver did not converge");
      return not_converged;
    }
    return success;
  });
}
