// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Diffuses functions that are given at the vertices of a mesh, and writes what they become.

#include "support/command_line.h"
#include "support/point_input.h"
#include "support/program.h"
#include "support/solver_options.h"
#include "support/surface_program.h"
#include "support/table.h"

#include <CGAL/Restricted_laplacian_3/assembly/assemble.h>
#include <CGAL/Restricted_laplacian_3/patches/smooth_vertex_data.h>
#include <CGAL/Restricted_laplacian_3/problems/Diffusion_solver.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_functions_3.h>
#include <CGAL/Restricted_laplacian_3/surface/Surface_function_view.h>

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

using namespace programs;
namespace params = RL::parameters;

const Help help = {"diffuse MESH --property NAME[,NAME...] (--time T | --fwhm W) [OPTION]...",
                   std::string(R"(
Diffuses functions on a surface: du/dt = Laplacian u, for a time or to a width.

The functions are given at the vertices, and interpolated as --vertex-data says. With
--diffusion-property D and --density-property R it is R du/dt = div(D grad u). Nothing flows
through a boundary, unless --boundary-property prescribes u there. The mean of u over each
connected component is kept then.

With --fwhm W each value becomes the mean of those around it with weights that fall to a
half at the distance W / 2: a Gaussian, where the surface is flat. Vertices whose value is
NaN have no weight, and remain NaN. u is NaN, too, at vertices that have no face, or only
faces without area.
)") + about_meshes + about_points,
                   R"(  diffuse elephant.off --property z --time 0.001 --csv u.csv
      the coordinate z after a time of 0.001, in squared units of length
  diffuse u.ply --property value --fwhm 0.05 --output smooth.ply
      what another program wrote, smoothed over a width of 0.05
)"};

struct Options : Common_options, Point_options {
  std::string property, source_property, boundary_property;
  double time = 0, width = 0, stabilization = -1;
  double tolerance = RL::Diffusion_options::default_tolerance;
};

// returns false if there is nothing more to do
bool read_options(int argc, char* argv[], Options& o, po::variables_map& given) {
  po::options_description problem("Problem", help_width);
  auto add = problem.add_options();
  add("property", po::value(&o.property)->value_name("NAME,..."),
      "u at the time 0: vertex properties of MESH, a PLY file; x, y and z stand for the "
      "coordinates "
      "of any mesh");
  add("time", po::value(&o.time)->value_name("T"), "in units of squared length");
  add("fwhm", po::value(&o.width)->value_name("W"),
      "in place of the time the full width at half maximum of what a point becomes, T = W^2 / (16 "
      "ln 2), in units of length");
  add("source-property", po::value(&o.source_property)->value_name("NAME"),
      "a vertex property that is supplied at all times");
  add("boundary-property", po::value(&o.boundary_property)->value_name("NAME"),
      "u on the whole boundary at all times: a vertex property, too");
  add_material_options(problem, o);
  add_accuracy_option(problem, "the estimated error of u, relative to its deviation from its mean,",
                      o);
  add_vertex_data_option(problem, o);
  po::options_description solver("Solver", help_width);
  auto add_to_solver = solver.add_options();
  std::ostringstream tolerance; // with no more digits than it needs
  tolerance << o.tolerance;
  add_to_solver(
      "tolerance",
      po::value(&o.tolerance)->value_name("T")->default_value(o.tolerance, tolerance.str()),
      "of what is computed in time, relative to the deviation of u from its mean");
  add_to_solver(
      "stabilization", po::value(&o.stabilization)->value_name("C"),
      "factor of the stabilization by normal derivatives; default 0.001, or 0 with --paper");
  po::options_description all(help_width);
  all.add(problem)
      .add(space_options(o))
      .add(integration_options(o))
      .add(point_options(o, o))
      .add(solver)
      .add(spline_output_options(o, "vertex, value; of several functions value_NAME for each",
                                 "the properties of --csv"))
      .add(general_options(o));

  if(!parse_command_line(argc, argv, help, all, o, given))
    return false;
  require(!o.property.empty(), "give --property");
  require(is_given(given, "time") || is_given(given, "fwhm"), "give --time or --fwhm");
  require(!is_given(given, "time") || !is_given(given, "fwhm"), "give --time or --fwhm, not both");
  if(is_given(given, "time"))
    require_positive(given, "time", o.time);
  else {
    require_positive(given, "fwhm", o.width);
    o.time = RL::diffusion_time(o.width);
  }
  check_accuracy_option(o);
  require(o.tolerance > 0 && o.tolerance < 1, "the argument of --tolerance must be in (0, 1)");
  require_not_negative(given, "stabilization");
  return true;
}

// What is diffused. If there are holes, columns follow that are 1 where those before have a value,
// and 0 in the holes.
struct Functions : Vertex_functions {
  bool has_holes = false;
};

Functions read_functions(const RL::Triangulated_surface_3& surface, const Options& o) {
  Functions result = {vertex_functions(surface, o, o.property)};
  std::vector<bool> is_used(surface.number_of_vertices());
  for(std::size_t i = 0; i < surface.number_of_faces(); ++i)
    for(const std::uint32_t vertex : surface.triangle(i))
      is_used[vertex] = is_used[vertex] || !surface.is_degenerate(i);
  for(std::size_t v = 0; v < is_used.size(); ++v)
    for(std::vector<double>& values : result.values) {
      if(!is_used[v] && !surface.is_point_set())
        values[v] = 0;
      require(!std::isinf(values[v]), "a value is infinite at vertex " + std::to_string(v));
      result.has_holes = result.has_holes || std::isnan(values[v]);
    }
  if(!result.has_holes)
    return result;
  require(o.source_property.empty() && o.boundary_property.empty(),
          "values that are NaN are left out of means, which --source-property and "
          "--boundary-property do not go with");
  const std::size_t number = result.values.size();
  for(std::size_t k = 0; k < number; ++k) {
    std::vector<double> weights;
    for(double& value : result.values[k]) {
      weights.push_back(std::isnan(value) ? 0 : 1);
      value = std::isnan(value) ? 0 : value;
    }
    result.values.push_back(std::move(weights));
  }
  return result;
}

// The means, from sums with weights and the weights, NaN where nothing is near.
Eigen::MatrixXd means(const Functions& functions, const Eigen::MatrixXd& u) {
  if(!functions.has_holes)
    return u;
  constexpr double smallest_weight = 1e-3;
  const Eigen::Index columns = u.cols() / 2;
  Eigen::MatrixXd result = u.leftCols(columns);
  for(Eigen::Index k = 0; k < columns; ++k)
    for(Eigen::Index v = 0; v < u.rows(); ++v) {
      const double weight = u(v, columns + k);
      result(v, k) =
          weight > smallest_weight ? u(v, k) / weight : std::numeric_limits<double>::quiet_NaN();
    }
  return result;
}

Eigen::MatrixXd loads(const RL::Spline_space_3& space,
                      const std::vector<std::vector<double>>& columns, const Options& o) {
  Eigen::MatrixXd result(space.dimension(), static_cast<Eigen::Index>(columns.size()));
  for(Eigen::Index k = 0; k < result.cols(); ++k)
    result.col(k) =
        RL::assemble_load(space, vertex_function(space.surface(), columns[std::size_t(k)], o));
  return result;
}

Outcome diffuse(Job& job, const Options& o) {
  const Functions functions = read_functions(job.surface, o);
  std::optional<RL::Cubic_surface_function<double>> boundary_values;
  std::optional<RL::Surface_function_view> on_boundary;
  if(!o.boundary_property.empty()) {
    boundary_values =
        vertex_function(job.surface, surface_property(job.surface, o, o.boundary_property), o);
    on_boundary.emplace(*boundary_values);
  }
  std::vector<std::vector<double>> sources;
  if(!o.source_property.empty())
    sources.assign(functions.values.size(), surface_property(job.surface, o, o.source_property));

  RL::Spline_space_3 space = job.make_space("nothing flows from one to another");
  RL::Diffused_functions found;
  job.search_depth(space, [&] {
    const auto progress = job.step("diffusion with", space);
    const RL::Diffusion_solver solver(
        space, o.time, params::tolerance(o.tolerance).stabilization(given_number(o.stabilization)),
        on_boundary ? &*on_boundary : nullptr);
    found = solver.diffuse_loads(loads(space, functions.values, o),
                                 sources.empty() ? Eigen::MatrixXd() : loads(space, sources, o),
                                 progress);
    return RL::internal::Found_in_space{
        &found, RL::internal::values_over_surface(space, found.coefficients)};
  });

  job.add_solve(found);
  job.summary.add("time", o.time);
  Outcome result;
  if(functions.names.size() == 1)
    result.names = {"value"};
  else
    for(const std::string& name : functions.names)
      result.names.push_back("value_" + name);
  const RL::Spline_functions_3 splines(space, found.coefficients);
  result.values = means(functions, splines.values_at_vertices());
  if(functions.has_holes) // where there was no value there is none
    for(Eigen::Index k = 0; k < result.values.cols(); ++k) {
      const std::vector<double>& weights = functions.values[std::size_t(k + result.values.cols())];
      for(std::size_t v = 0; v < weights.size(); ++v)
        if(weights[v] == 0)
          result.values(Eigen::Index(v), k) = std::numeric_limits<double>::quiet_NaN();
    }
  const std::vector<double> first(result.values.col(0).begin(), result.values.col(0).end());
  const Value_range range(first);
  job.summary.add("minimum", range.low);
  job.summary.add("maximum", range.high);
  result.paint = [](const Eigen::MatrixXd& u) { return value_colors(u.col(0)); };
  result.cell_width = space.octree().cell_width(space.depth());
  result.values_at = [splines, functions](const std::vector<RL::Surface_location>& locations) {
    return means(functions, splines.values_at_locations(locations));
  };
  return result;
}

int main(int argc, char* argv[]) {
  return run_surface_program("diffuse", argc, argv, read_options, diffuse);
}
