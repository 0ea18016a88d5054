// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Fits functions that are given at the vertices of a mesh by splines, and writes the fits at its
// vertices.

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

#include <CGAL/Restricted_laplacian_3/Spline_functions_3.h>
#include <CGAL/Restricted_laplacian_3/fit_function.h>
#include <CGAL/Restricted_laplacian_3/vertex_normals.h>

#include <CGAL/Real_timer.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

using namespace examples;

const char* const usage =
    "usage: fit_function MESH --property NAME[,NAME...] [OPTION]...\n"
    "       fit_function MESH --normals [OPTION]...\n"
    "\n"
    "Fits functions on the surface of MESH (off, obj, ply, stl, ts, xyz) by splines: the functions "
    "of\n"
    "the space for which the integral of the squared difference is smallest. They are given at "
    "the\n"
    "vertices, and interpolated linearly.\n"
    "With --smoothing W the integral of W times the squared gradient is added, W in units of the\n"
    "squared width of a cell.\n"
    "The value is NaN at vertices that have no face, or only faces without area.\n"
    "\n"
    "Exit status: 0 if all went well; 1 on an error; 2 if the solver did not converge, after\n"
    "the output was written.\n";

struct Options : Common_options, Point_options {
  std::string property;
  bool normals = false;
  double smoothing = 0, tolerance = RL::Function_fit_options().solver.relative_tolerance;
  double stabilization = -1; // chosen
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
  po::options_description solver("Solver", help_width);
  add = solver.add_options();
  add("tolerance", po::value(&o.tolerance)->value_name("T")->default_value(o.tolerance),
      "norm of the residual, relative to that of the right-hand side");
  add("stabilization", po::value(&o.stabilization)->value_name("C"),
      "factor of the stabilization by normal derivatives; by default it is chosen for each "
      "function: small for smooth ones");
  po::options_description all(help_width);
  all.add(problem)
      .add(space_options(o))
      .add(point_options(o, o))
      .add(solver)
      .add(output_options(o));

  if(!parse_command_line(argc, argv, usage + std::string("\n") + about_points, all, o, given))
    return false;
  require(o.normals || given.count("property") == 1, "give --property or --normals");
  require(!o.normals || given.count("property") == 0, "give --property or --normals, not both");
  require(o.smoothing >= 0 && std::isfinite(o.smoothing),
          "the argument of --smoothing must be a number that is not negative");
  require(o.refinements >= 0, "the argument of --refinements must not be negative");
  require(o.tolerance > 0 && o.tolerance < 1, "the argument of --tolerance must be in (0, 1)");
  require(given.count("stabilization") == 0 ||
              (o.stabilization >= 0 && std::isfinite(o.stabilization)),
          "the argument of --stabilization must be a number that is not negative");
  return true;
}

// What is fitted: a name and values at the vertices for each function.
struct Functions {
  std::vector<std::string> names;
  std::vector<std::vector<double>> values;
};

Functions normals(const RL::Triangulated_surface_3& surface) {
  Functions result = {{"nx", "ny", "nz"}, std::vector<std::vector<double>>(3)};
  for(const RL::Vector_3& n : RL::vertex_normals(surface))
    for(int axis = 0; axis < 3; ++axis)
      result.values[axis].push_back(n[axis]);
  return result;
}

Functions properties(const RL::Triangulated_surface_3& surface, const Options& o) {
  Functions result;
  std::istringstream list(o.property);
  for(std::string name; std::getline(list, name, ',');) {
    result.names.push_back(name);
    if(name == "x" || name == "y" || name == "z") {
      result.values.emplace_back();
      for(std::size_t v = 0; v < surface.number_of_vertices(); ++v)
        result.values.back().push_back(surface.point(v)[name[0] - 'x']);
    } else
      result.values.push_back(read_ply_property(o.mesh, name));
    require(result.values.back().size() == surface.number_of_vertices(),
            "not every vertex has a value");
  }
  require(!result.names.empty(), "--property names no property");
  return result;
}

// Adds the fit of some functions to those of others.
void append(RL::Function_fit& all, const RL::Function_fit& fit) {
  const Eigen::Index columns = all.coefficients.cols();
  all.coefficients.conservativeResize(fit.coefficients.rows(), columns + fit.coefficients.cols());
  all.coefficients.rightCols(fit.coefficients.cols()) = fit.coefficients;
  all.converged = (columns == 0 || all.converged) && fit.converged;
  all.iterations = std::max(all.iterations, fit.iterations);
  all.relative_residual = std::max(all.relative_residual, fit.relative_residual);
  all.setup_seconds = fit.setup_seconds;
  all.assembly_seconds = fit.assembly_seconds;
  all.solve_seconds += fit.solve_seconds;
  for(std::size_t k = 0; k < fit.root_mean_square_errors.size(); ++k) {
    all.root_mean_square_errors.push_back(fit.root_mean_square_errors[k]);
    all.normal_stabilizations.push_back(fit.normal_stabilizations[k]);
  }
}

// Three functions take hardly longer together than one of them; others are fitted one by one.
template <class Integration>
RL::Function_fit fit_all(const RL::Spline_space_3& space, const Integration& integration,
                         const RL::Function_fit_options& options, const Functions& functions) {
  RL::Function_fitter<Integration> fitter(space, integration, options);
  const auto& values = functions.values;
  if(values.size() == 3) {
    std::vector<RL::Vector_3> vectors;
    for(std::size_t v = 0; v < values[0].size(); ++v)
      vectors.emplace_back(values[0][v], values[1][v], values[2][v]);
    return fitter.fit(RL::Linear_surface_function<RL::Vector_3>(std::move(vectors)));
  }
  RL::Function_fit result;
  for(const std::vector<double>& function : values)
    append(result, fitter.fit(RL::Linear_surface_function<double>(function)));
  return result;
}

// Fits the functions, with the results at the vertices in `u`, and describes what was done.
bool fit(const RL::Triangulated_surface_3& surface, const Options& o, const Functions& functions,
         Eigen::MatrixXd& u, Summary& summary, const Progress& progress) {
  CGAL::Real_timer timer;
  timer.start();
  progress.show("building the spline space");
  const RL::Spline_space_3 space(surface, o.space);
  const double space_seconds = timer.time();

  progress.show("fitting by " + std::to_string(space.dimension()) + " unknowns");
  const double h = space.octree().cell_width(space.depth());
  RL::Function_fit_options options;
  options.smoothing_weight = o.smoothing * h * h;
  options.refinement_steps = o.refinements;
  options.solver.relative_tolerance = o.tolerance;
  options.solver.is_parallel = o.space.is_parallel;
  if(o.stabilization >= 0)
    options.normal_stabilization = o.stabilization;
  const RL::Function_fit fit = assemble_with(space, o, [&](const auto& integration) {
    return fit_all(space, integration, options, functions);
  });
  u = RL::Spline_functions_3(space, fit.coefficients).values_at_vertices();

  add_space(summary, space);
  summary.add("setup_seconds", space_seconds + fit.setup_seconds);
  summary.add("assembly_seconds", fit.assembly_seconds);
  summary.add("solve_seconds", fit.solve_seconds);
  summary.add("iterations", fit.iterations);
  summary.add("relative_residual", fit.relative_residual);
  for(std::size_t k = 0; k < functions.names.size(); ++k)
    summary.add("stabilization_" + functions.names[k], fit.normal_stabilizations[k]);
  summary.add("rms_error", fit.root_mean_square_error());
  return fit.converged;
}

// Normals as red, green and blue; of other functions the first one.
std::vector<Color> colors(const Options& o, const Eigen::MatrixXd& u) {
  if(!o.normals)
    return value_colors(u.col(0));
  std::vector<Color> result;
  for(Eigen::Index v = 0; v < u.rows(); ++v) {
    Color color = {0.5, 0.5, 0.5};
    for(int axis = 0; axis < 3 && std::isfinite(u(v, axis)); ++axis)
      color[axis] = std::clamp(0.5 + 0.5 * u(v, axis), 0., 1.);
    result.push_back(color);
  }
  return result;
}

int main(int argc, char* argv[]) {
  return run_program("fit_function", [&]() -> int {
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
    const Functions functions = o.normals ? normals(input.surface) : properties(input.surface, o);
    Eigen::MatrixXd u;
    const bool has_converged = fit(input.surface, o, functions, u, summary, progress);

    progress.show("writing the results");
    std::vector<std::string> names = functions.names;
    if(names.size() == 1)
      names[0] = "value";
    if(!o.csv.empty())
      write_csv(o.csv, summary, "vertex", names, u);
    if(!o.output.empty())
      write_mesh(o.output, input.surface, colors(o, u), names, u);
    if(!o.picture.empty())
      write_picture(o.picture, input.surface, colors(o, u), {u.data(), u.data() + u.rows()},
                    {o.up == "z", o.isolines});
    progress.show("");
    if(!o.quiet)
      summary.print(std::cout);
    if(!has_converged) {
      print_error("fit_function", "the solver did not converge");
      return not_converged;
    }
    return success;
  });
}
