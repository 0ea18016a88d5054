// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Computes the smallest eigenvalues of the Laplacian on a mesh, and writes one eigenfunction.

#include "support/command_line.h"
#include "support/point_input.h"
#include "support/program.h"
#include "support/spectrum.h"
#include "support/surface_program.h"
#include "support/table.h"

#include <CGAL/Restricted_laplacian_3/assembly/assemble.h>
#include <CGAL/Restricted_laplacian_3/assembly/cotangent_operators.h>
#include <CGAL/Restricted_laplacian_3/spectra/smallest_eigenpairs.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_function_3.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

using namespace programs;

const Help help = {"laplace_spectrum MESH [OPTION]...", std::string(R"(
Computes the smallest eigenvalues of the Laplacian on a surface: the smallest numbers l for
which -Laplacian u = l u has a solution.

They are 0, 2, 2, 2, 6, ... on the unit sphere, and in units of 1 / area. Boundaries have
the natural condition: u does not change across them. With --operator cotangent the
functions are linear in each triangle, and the options of finite elements and integration
have no meaning.
)") + about_meshes + about_points,
                   R"(  laplace_spectrum elephant.off --count 50 --depth 5 --csv eigenvalues.csv
      a table of 50 eigenvalues
  laplace_spectrum elephant.off --count 10 --eigenfunction 5 --output u5.ply
      a mesh with eigenfunction 5
  laplace_spectrum elephant.off --operator cotangent --count 10
      the usual operator, for comparison
)"};

struct Options : Common_options, Point_options, Eigensolver_options {
  int count = 20;
  int eigenfunction = 1;
  std::string operator_name = "restricted";
  bool lumped_mass = false;
};

// returns false if there is nothing more to do
bool read_options(int argc, char* argv[], Options& o, po::variables_map& given) {
  po::options_description problem("Problem", help_width);
  auto add = problem.add_options();
  add("count", po::value(&o.count)->value_name("K")->default_value(o.count),
      "number of eigenvalues, with multiplicities");
  add("operator", po::value(&o.operator_name)->value_name("NAME")->default_value(o.operator_name),
      "restricted: B-splines restricted to the surface; cotangent: for comparison");
  add("lumped-mass", po::bool_switch(&o.lumped_mass),
      "the mass matrix of --operator cotangent is diagonal");
  add("eigenfunction", po::value(&o.eigenfunction)->value_name("I")->default_value(o.eigenfunction),
      "index, from 0, of the eigenfunction for --output; --html has all of them, and shows this "
      "one first");
  add_material_options(problem, o);
  add_accuracy_option(problem, "the largest estimated relative error of the eigenvalues", o);
  po::options_description all(help_width);
  all.add(problem)
      .add(eigensolver_options(o))
      .add(space_options(o))
      .add(integration_options(o))
      .add(point_options(o, o))
      .add(spline_output_options(
          o,
          "index, eigenvalue, and, for restricted splines, the estimated relative "
          "error and the extrapolated eigenvalue",
          "the property value, the eigenfunction"))
      .add(general_options(o));

  if(!parse_command_line(argc, argv, help, all, o, given))
    return false;
  require(o.count > 0, "the argument of --count must be positive");
  require_choice("operator", o.operator_name, {"restricted", "cotangent"});
  require(o.refine == 0 || o.operator_name == "restricted", "--refine needs --operator restricted");
  require_effect(given, {"diffusion-property", "density-property", "anisotropy"},
                 o.operator_name == "restricted", "--operator restricted");
  require_effect(given, {"lumped-mass"}, o.operator_name == "cotangent", "--operator cotangent");
  require_effect(given,
                 {"accuracy", "eigensolver", "tolerance", "stabilization", "depth", "cube-scale",
                  "no-split", "joining-tolerance", "maximum-memory", "paper", "assembly", "split"},
                 o.operator_name == "restricted", "--operator restricted");
  require_effect(given, {"eigenfunction"}, !o.output.empty() || !o.html.empty(),
                 "--output or --html");
  check_accuracy_option(o);
  check_eigensolver_options(o, given, o.space.paper);
  if(given["eigenfunction"].defaulted())
    o.eigenfunction = std::min(o.eigenfunction, o.count - 1);
  require(o.eigenfunction >= 0 && o.eigenfunction < o.count,
          "the argument of --eigenfunction must be at least 0 and less than that of --count");
  return true;
}

// lets --html show all eigenfunctions
void show_eigenfunctions(const Eigen::VectorXd& eigenvalues, Eigen::MatrixXd at_vertices,
                         const Options& o, Outcome& result) {
  for(Eigen::Index i = 0; i < eigenvalues.size(); ++i) {
    std::ostringstream name;
    name << "eigenfunction " << i << ", eigenvalue " << std::setprecision(6) << eigenvalues[i];
    result.page.names.push_back(name.str());
  }
  result.page.values = std::move(at_vertices);
  result.page.first = static_cast<std::size_t>(o.eigenfunction);
}

// What is known of the eigenvalues that were found.
struct Found {
  RL::Eigenpairs pairs;
  std::vector<std::string> names = {"eigenvalue"}; // of columns
  Eigen::MatrixXd table;
};

// Each of these two returns the eigenvalues that were found, and sets `result` to the eigenfunction
// that the options ask for.
Found solve_restricted(Job& job, const Options& o, Outcome& result) {
  const bool eigenvalues_only = o.output.empty() && o.html.empty();
  Spectrum spectrum = solve_spectrum(o.count, eigenvalues_only, o, job);
  const RL::Spline_space_3& space = spectrum.space;
  const RL::Eigenpairs& pairs = spectrum.pairs;
  if(o.eigenfunction < pairs.values.size()) {
    const Eigen::VectorXd u = pairs.vectors.col(o.eigenfunction);
    result = outcome(RL::Spline_function_3(space, u).values_at_vertices());
    result.set_splines(space, u);
  }
  if(!o.html.empty()) {
    RL::Spline_functions_3 functions(space, pairs.vectors);
    show_eigenfunctions(pairs.values, functions.values_at_vertices(), o, result);
    result.page.values_at = [functions = std::move(functions)](const auto& locations) {
      return functions.values_at_locations(locations);
    };
  }
  Found found;
  found.table = pairs.values;
  if(spectrum.estimated_errors.size() > 0) {
    found.names.insert(found.names.end(), {"estimated_relative_error", "extrapolated"});
    found.table.conservativeResize(Eigen::NoChange, 3);
    found.table.rightCols(2) << spectrum.estimated_errors, spectrum.extrapolated_eigenvalues;
  }
  found.pairs = std::move(spectrum.pairs);
  return found;
}

Found solve_cotangent(Job& job, const Options& o, Outcome& result) {
  const RL::Triangulated_surface_3& surface = job.surface;
  require(!surface.is_point_set(), "--operator cotangent needs a mesh with triangles, not points");
  job.summary.add("dimension", surface.number_of_vertices());
  job.progress.show("assembling");
  const double start = job.seconds();
  const RL::Operators operators = RL::cotangent_operators(surface, o.lumped_mass);
  const double assembled = job.seconds();

  const auto callback = job.progress.step("computing eigenvalues of " +
                                          std::to_string(operators.stiffness.rows()) + " unknowns");
  RL::Eigenpairs pairs = RL::smallest_eigenpairs(operators.stiffness, operators.mass, o.count,
                                                 RL::parameters::progress(callback));
  job.summary.add_detail("assembly_seconds", assembled - start);
  job.summary.add_detail("solve_seconds", job.seconds() - assembled);
  job.summary.add_detail("iterations", pairs.iterations);
  job.summary.add_detail("relative_residual",
                         pairs.residuals.size() ? pairs.residuals.maxCoeff() : 0.);
  // nothing at vertices without a face
  std::vector<char> has_face(surface.number_of_vertices());
  for(std::size_t f = 0; f < surface.number_of_faces(); ++f)
    if(!surface.is_degenerate(f))
      for(const std::uint32_t vertex : surface.triangle(f))
        has_face[vertex] = 1;
  for(Eigen::Index v = 0; v < pairs.vectors.rows(); ++v)
    if(!has_face[static_cast<std::size_t>(v)])
      pairs.vectors.row(v).setConstant(std::nan(""));
  if(o.eigenfunction < pairs.values.size()) {
    const auto u = pairs.vectors.col(o.eigenfunction);
    result = outcome({u.begin(), u.end()});
  }
  if(!o.html.empty())
    show_eigenfunctions(pairs.values, pairs.vectors, o, result);
  Found found;
  found.table = pairs.values;
  found.pairs = std::move(pairs);
  return found;
}

Outcome solve(Job& job, const Options& o) {
  // no eigenfunction, unless it is found
  Outcome result = outcome(std::vector<double>(job.surface.number_of_vertices(), std::nan("")));
  const Found found = o.operator_name == "restricted" ? solve_restricted(job, o, result)
                                                      : solve_cotangent(job, o, result);
  result.write_table = [names = found.names, table = found.table](const std::string& file,
                                                                  const Summary& lines) {
    write_csv(file, lines, "index", names, table);
  };
  result.print = [values = found.pairs.values](std::ostream& out) {
    print_eigenvalues(out, values);
  };
  check_number(job, found.pairs, o.count);
  return result;
}

int main(int argc, char* argv[]) {
  return run_surface_program("laplace_spectrum", argc, argv, read_options, solve);
}
