// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Estimates mean and Gaussian curvature of a mesh, and writes them at its vertices.

#include "support/command_line.h"
#include "support/point_input.h"
#include "support/program.h"
#include "support/solver_options.h"
#include "support/surface_program.h"
#include "support/table.h"

#include <CGAL/Restricted_laplacian_3/estimate_curvature.h>

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

using namespace programs;
namespace params = RL::parameters;

const Help help = {"estimate_curvature MESH [OPTION]...", std::string(R"(
Estimates the mean curvature H and the Gaussian curvature K of a surface at its vertices.

A sphere of radius r whose normals point outward has H = 1 / r; if they point inward, it has
H = -1 / r. The faces must be oriented alike. The values are NaN at vertices that have no
face, or only faces without area.
)") + about_meshes + about_points,
                   R"(  estimate_curvature elephant.off --output mean.ply
      a mesh colored by mean curvature
  estimate_curvature elephant.off --show gaussian --csv curvature.csv --output gaussian.ply
      a table of both curvatures, and a mesh colored by Gaussian curvature
)"};

struct Options : Common_options, Point_options, Solver_options {
  Options() : Solver_options(RL::Function_fitter::default_tolerance) {}

  std::string method = "normals", show = "mean";
  double smoothing = -1; // the default
  double clip = 95;
};

// returns false if there is nothing more to do
bool read_options(int argc, char* argv[], Options& o, po::variables_map& given) {
  po::options_description problem("Problem", help_width);
  auto add = problem.add_options();
  add("method", po::value(&o.method)->value_name("METHOD")->default_value(o.method),
      "normals: the derivative of a fit of vertex normals; face-normals: the same with the normals "
      "of the faces; coordinates: the Laplacian of the coordinates, which gives H, and NaN for K");
  add("smoothing", po::value(&o.smoothing)->value_name("W"),
      "weight of the squared gradient of the normals, in units of the squared width of a cell; by "
      "default 1, and 0 on surfaces with a boundary and on points");
  add_accuracy_option(
      problem,
      "the estimated error of the mean curvature, relative to its deviation from its "
      "mean,",
      o);
  po::options_description colors("Colors", help_width);
  add = colors.add_options();
  add("show", po::value(&o.show)->value_name("mean|gaussian")->default_value(o.show),
      "what colors show: blue is negative, red positive");
  add("clip", po::value(&o.clip)->value_name("P")->default_value(o.clip),
      "colors are full at the magnitude that P percent of the vertices are below");
  po::options_description all(help_width);
  all.add(problem)
      .add(space_options(o))
      .add(integration_options(o))
      .add(point_options(o, o))
      .add(solver_options(o, "default 0.01"))
      .add(colors)
      .add(spline_output_options(o, "vertex, mean, gaussian", "the properties mean and gaussian"))
      .add(general_options(o));

  if(!parse_command_line(argc, argv, help, all, o, given))
    return false;
  require_choice("method", o.method, {"normals", "face-normals", "coordinates"});
  require_choice("show", o.show, {"mean", "gaussian"});
  require(o.show == "mean" || o.method != "coordinates",
          "--show gaussian needs another --method than coordinates");
  require(o.clip > 0 && o.clip <= 100, "the argument of --clip must be in (0, 100]");
  require_effect(given, {"show", "clip"}, !o.output.empty() || !o.html.empty(),
                 "--output or --html");
  require_not_negative(given, "smoothing");
  check_accuracy_option(o);
  require(!o.space.accuracy || o.smoothing < 0, "--accuracy excludes --smoothing");
  check_solver_options(o, given);
  return true;
}

RL::Curvature_method method(const Options& o) {
  return o.method == "normals"        ? RL::Curvature_method::normals
         : o.method == "face-normals" ? RL::Curvature_method::face_normals
                                      : RL::Curvature_method::coordinates;
}

// a row for each point: mean and Gaussian curvature
Eigen::MatrixXd table(const std::vector<RL::Surface_curvature>& curvatures) {
  Eigen::MatrixXd result(static_cast<Eigen::Index>(curvatures.size()), 2);
  Eigen::Index row = 0;
  for(const RL::Surface_curvature& c : curvatures)
    result.row(row++) << c.mean, c.gaussian;
  return result;
}

Outcome estimate(Job& job, const Options& o) {
  RL::Spline_space_3 space = job.make_space("each component is fitted on its own");
  const double h = space.octree().cell_width(space.depth());
  const auto np = solver_parameters(o).method(method(o)).progress(job.step("fitting by", space));
  const RL::Curvature_field field =
      o.space.accuracy
          ? RL::internal::estimate_curvature_to_accuracy(space, nullptr, np, *o.space.accuracy)
      : o.smoothing < 0 ? RL::estimate_curvature(space, np)
                        : RL::estimate_curvature(space, np.smoothing(o.smoothing * h * h));
  const RL::Fit_report& report = field.report();
  if(o.space.accuracy)
    job.add_space_of_search(space, report);
  job.add_solve(report);
  if(!report.root_mean_square_errors.empty())
    job.summary.add_detail("rms_error_of_normals", report.root_mean_square_error());

  Outcome result;
  result.names = {"mean", "gaussian"};
  result.values = table(field.at_vertices());
  for(Eigen::Index k = 0; k < 2; ++k) {
    const Value_range range(result.values.col(k));
    const std::string& name = result.names[static_cast<std::size_t>(k)];
    if(k == 0 || o.method != "coordinates") {
      job.summary.add(name + "_minimum", range.low);
      job.summary.add(name + "_maximum", range.high);
    }
  }
  for(const auto column : result.values.colwise()) {
    const Color_scale clipped = clipped_scale({column.begin(), column.end()}, o.clip / 100);
    result.page.ranges.emplace_back(std::pair(clipped.low(), clipped.high()));
  }
  result.page.first = o.show == "mean" ? 0 : 1;
  const Eigen::Index shown = o.show == "mean" ? 0 : 1;
  const auto column = result.values.col(shown);
  const Color_scale scale = clipped_scale({column.begin(), column.end()}, o.clip / 100);
  result.paint = [scale, shown](const Eigen::MatrixXd& values) {
    return scale.colors(values.col(shown));
  };
  result.cell_width = space.octree().cell_width(space.depth());
  result.values_at = [field](const std::vector<RL::Surface_location>& locations) {
    return table(field.at_locations(locations));
  };
  return result;
}

int main(int argc, char* argv[]) {
  return run_surface_program("estimate_curvature", argc, argv, read_options, estimate);
}
