// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Fits functions that are given at the vertices of a mesh by splines, and writes the fits at its
// vertices.

#include "support/command_line.h"
#include "support/point_input.h"
#include "support/program.h"
#include "support/solver_options.h"
#include "support/surface_program.h"
#include "support/table.h"

#include <CGAL/Restricted_laplacian_3/fit_function.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_functions_3.h>
#include <CGAL/Restricted_laplacian_3/surface/vertex_normals.h>
#include <CGAL/Restricted_laplacian_3/textures/srgb.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

using namespace programs;

const Help help = {"fit_function MESH --property NAME[,NAME...] [OPTION]...\n"
                   "       fit_function MESH --normals [OPTION]...",
                   std::string(R"(
Fits functions on a surface by splines: those for which the integral of the squared
difference is smallest.

The functions are given at the vertices, and interpolated as --vertex-data says. With
--smoothing W the integral of W times the squared gradient is added. A fit is NaN at
vertices that have no face, or only faces without area.
)") + about_meshes + about_points,
                   R"(  fit_function elephant.off --normals --depth 5 --output normals.ply
      smooth normals, shown as red, green and blue
  fit_function elephant.off --property x,y --smoothing 1 --csv fit.csv
      smooth coordinates x and y
)"};

struct Options : Common_options, Point_options, Solver_options {
  Options() : Solver_options(RL::Function_fitter::default_tolerance) {}

  std::string property;
  bool normals = false;
  double smoothing = 0;
  int refinements = 0;
};

// returns false if there is nothing more to do
bool read_options(int argc, char* argv[], Options& o, po::variables_map& given) {
  po::options_description problem("Problem", help_width);
  auto add = problem.add_options();
  add("property", po::value(&o.property)->value_name("NAME,..."),
      "vertex properties of MESH, a PLY file; x, y and z stand for the coordinates of any mesh");
  add("normals", po::bool_switch(&o.normals), "normals at the vertices, three functions");
  add("smoothing", po::value(&o.smoothing)->value_name("W")->default_value(o.smoothing),
      "weight of the squared gradient, in units of the squared width of a cell");
  add("refinements", po::value(&o.refinements)->value_name("N")->default_value(o.refinements),
      "how often what the fit leaves is fitted and added");
  add_material_options(problem, o);
  add_accuracy_option(problem,
                      "the root mean square error of each fit, relative to the deviation of the "
                      "function from its mean (with --smoothing the estimated one),",
                      o);
  add_vertex_data_option(problem, o);
  po::options_description all(help_width);
  all.add(problem)
      .add(space_options(o))
      .add(integration_options(o))
      .add(point_options(o, o))
      .add(solver_options(o, "by default as small as rounding permits, more with --smoothing"))
      .add(spline_output_options(o, "vertex and, for each function, fit_NAME",
                                 "a property fit_NAME for each function"))
      .add(general_options(o));

  if(!parse_command_line(argc, argv, help, all, o, given))
    return false;
  require(o.normals || given.count("property") == 1, "give --property or --normals");
  require(!o.normals || given.count("property") == 0, "give --property or --normals, not both");
  require_not_negative(given, "smoothing");
  check_accuracy_option(o);
  check_solver_options(o, given);
  require(o.refinements >= 0, "the argument of --refinements must not be negative");
  return true;
}

Vertex_functions normals(const RL::Triangulated_surface_3& surface) {
  Vertex_functions result = {{"nx", "ny", "nz"}, std::vector<std::vector<double>>(3)};
  for(const RL::Vector_3& n : RL::vertex_normals(surface))
    for(int axis = 0; axis < 3; ++axis)
      result.values[axis].push_back(n[axis]);
  return result;
}

// Adds the fit of some functions to those of others.
void append(RL::Function_fit& all, const RL::Function_fit& fit) {
  const Eigen::Index columns = all.coefficients.cols();
  all.coefficients.conservativeResize(fit.coefficients.rows(), columns + fit.coefficients.cols());
  all.coefficients.rightCols(fit.coefficients.cols()) = fit.coefficients;
  if(columns == 0)
    all.set_status(fit.status);
  all.worsen_status(fit.status);
  all.iterations = std::max(all.iterations, fit.iterations);
  all.relative_residual = std::max(all.relative_residual, fit.relative_residual);
  all.estimated_error =
      columns == 0 ? fit.estimated_error : std::max(all.estimated_error, fit.estimated_error);
  all.is_estimate_trusted = fit.is_estimate_trusted;
  all.setup_seconds = fit.setup_seconds;
  all.assembly_seconds = fit.assembly_seconds;
  all.solve_seconds += fit.solve_seconds;
  all.stabilization = fit.stabilization;
  for(double error : fit.root_mean_square_errors)
    all.root_mean_square_errors.push_back(error);
}

// Three functions take hardly longer together than one of them; others are fitted one by one.
RL::Function_fit fit_all(const RL::Spline_space_3& space, const Vertex_functions& functions,
                         const Job& job, const Options& o) {
  const double h = space.octree().cell_width(space.depth());
  RL::Function_fitter fitter(
      space, solver_parameters(o).smoothing(o.smoothing * h * h).refinements(o.refinements));
  const auto& values = functions.values;
  if(values.size() == 3) {
    std::vector<Eigen::Vector3d> vectors;
    for(std::size_t v = 0; v < values[0].size(); ++v)
      vectors.emplace_back(values[0][v], values[1][v], values[2][v]);
    return fitter.fit(vertex_function(job.surface, std::move(vectors), o),
                      job.step("fitting by", space));
  }
  RL::Function_fit result;
  for(std::size_t k = 0; k < values.size(); ++k)
    append(result, fitter.fit(vertex_function(job.surface, values[k], o),
                              job.step("fitting " + functions.names[k] + " by", space)));
  return result;
}

// Normals as red, green and blue; of other functions the first one.
std::vector<Color> colors(const Options& o, const Eigen::MatrixXd& u) {
  if(!o.normals)
    return value_colors(u.col(0));
  std::vector<Color> result;
  for(Eigen::Index v = 0; v < u.rows(); ++v) {
    Color color;
    for(int axis = 0; axis < 3; ++axis)
      color[axis] = RL::linear_to_srgb(
          std::isfinite(u(v, axis)) ? std::clamp(0.5 + 0.5 * u(v, axis), 0., 1.) : 0.5);
    result.push_back(color);
  }
  return result;
}

Outcome fit(Job& job, const Options& o) {
  const Vertex_functions functions =
      o.normals ? normals(job.surface) : vertex_functions(job.surface, o, o.property);
  RL::Spline_space_3 space = job.make_space("each component is fitted on its own");
  RL::Function_fit fit;
  const bool smooths = o.smoothing > 0;
  job.search_depth(space, [&] {
    fit = fit_all(space, functions, job, o);
    return RL::internal::Found_in_space{
        &fit,
        smooths ? RL::internal::values_over_surface(space, fit.coefficients) : Eigen::MatrixXd()};
  });

  job.add_solve(fit);
  job.summary.add_detail("stabilization", fit.stabilization);
  job.summary.add("rms_error", fit.root_mean_square_error());

  Outcome result;
  // the functions themselves may be in the same file: coordinates, normals, colors
  for(const std::string& name : functions.names)
    result.names.push_back("fit_" + name);
  result.values = RL::Spline_functions_3(space, fit.coefficients).values_at_vertices();
  result.paint = [&o](const Eigen::MatrixXd& u) { return colors(o, u); };
  result.set_splines(space, fit.coefficients);
  return result;
}

int main(int argc, char* argv[]) {
  return run_surface_program("fit_function", argc, argv, read_options, fit);
}
