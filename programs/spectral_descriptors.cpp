// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Computes descriptors of the points of a mesh, or of the mesh, from its eigenfunctions.

#include "support/command_line.h"
#include "support/mesh_input.h"
#include "support/program.h"
#include "support/spectrum.h"
#include "support/surface_program.h"
#include "support/table.h"

#include <CGAL/Restricted_laplacian_3/assembly/assemble.h>
#include <CGAL/Restricted_laplacian_3/laplace_spectrum.h>
#include <CGAL/Restricted_laplacian_3/spectral_descriptors.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_functions_3.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

using namespace programs;

const Help help = {
    "spectral_descriptors MESH [OPTION]...", std::string(R"(
Computes from the first eigenvalues and eigenfunctions of the Laplacian on a surface a
descriptor of each vertex, or of the whole surface.

The descriptors are

  hks         heat kernel signature, a column for each time
  wks         wave kernel signature, a column for each energy
  gps         global point signature: eigenfunctions over square roots of eigenvalues
  biharmonic  eigenfunctions over eigenvalues: coordinates for the biharmonic distance
  diffusion   diffusion map: coordinates for the diffusion distance at --time
  shape-dna   the eigenvalues in a form that does not depend on size

Times are in units of the area of the surface, and energies are natural logarithms of
eigenvalues times area: they mean the same for surfaces of different size. The values of hks
and wks and the coordinates are in the units of MESH.
)") + about_meshes,
    R"(  spectral_descriptors elephant.off --count 50 --depth 5 --time 0.01 --output hks.ply
      a mesh with the heat kernel signature at one time
  spectral_descriptors elephant.off --descriptor biharmonic --depth 5 --csv biharmonic.csv
      coordinates of each vertex, of which the biharmonic distance is the usual one
  spectral_descriptors elephant.off --descriptor shape-dna --count 20 --depth 5 \
    --compare elephant-with-holes.off
      how far the spectra of two shapes differ
)"};

struct Options : Common_options, Eigensolver_options {
  int count = 100;
  std::string descriptor = "hks";
  int columns = 100;
  double time = 0.05, energy = 0;
  bool is_time_given = false, is_energy_given = false;
  bool is_scaled = false;
  std::string normalization = "area", other_mesh;
  int column = 0;
  bool is_column_given = false;

  bool is_of_vertices() const { return descriptor != "shape-dna"; }
  // whether columns are times or energies
  bool is_signature() const { return descriptor == "hks" || descriptor == "wks"; }
};

// requires that an option is given with one of some descriptors only
void require_descriptor(const po::variables_map& given, const Options& o, const std::string& option,
                        std::initializer_list<const char*> descriptors) {
  std::string list;
  bool is_one = false;
  for(const char* descriptor : descriptors) {
    is_one = is_one || o.descriptor == descriptor;
    list += (list.empty() ? "" : " or ") + std::string(descriptor);
  }
  require(!is_given(given, option) || is_one, "--" + option + " needs --descriptor " + list);
}

// returns false if there is nothing more to do
bool read_options(int argc, char* argv[], Options& o, po::variables_map& given) {
  po::options_description problem("Descriptor", help_width);
  auto add = problem.add_options();
  add("descriptor", po::value(&o.descriptor)->value_name("NAME")->default_value(o.descriptor),
      "hks, wks, gps, biharmonic, diffusion or shape-dna");
  add("count", po::value(&o.count)->value_name("K")->default_value(o.count),
      "number of eigenvalues, with multiplicities and zeros");
  add("columns", po::value(&o.columns)->value_name("N")->default_value(o.columns),
      "number of times of hks, or energies of wks, over the range of the eigenvalues");
  add("time", po::value(&o.time)->value_name("T"),
      "hks: this time only; diffusion: the time (default: 0.05)");
  add("energy", po::value(&o.energy)->value_name("E"), "wks: this energy only");
  add("scaled", po::bool_switch(&o.is_scaled),
      "hks: divide by the heat trace, so that the integral over the surface is 1");
  add("normalization",
      po::value(&o.normalization)->value_name("NAME")->default_value(o.normalization),
      "shape-dna: multiply eigenvalues with the area, or divide them by the first that is not 0 "
      "(first) or by the slope of a fitted line (weyl), or nothing (none)");
  add("compare", po::value(&o.other_mesh)->value_name("MESH"),
      "shape-dna: print the distance to that of another mesh");
  add("column", po::value(&o.column)->value_name("I"),
      "index, from 0, of the column for --output (default: the middle one of hks and wks, the "
      "first "
      "of others)");
  add_material_options(problem, o);
  add_accuracy_option(problem, "the largest estimated relative error of the eigenvalues", o);
  po::options_description all(help_width);
  all.add(problem)
      .add(eigensolver_options(o))
      .add(space_options(o))
      .add(integration_options(o))
      .add(spline_output_options(o, "vertex and those of the descriptor, or index, shape_dna",
                                 "the property value, one column of the descriptor"))
      .add(general_options(o));

  if(!parse_command_line(argc, argv, help, all, o, given))
    return false;
  require_choice("descriptor", o.descriptor,
                 {"hks", "wks", "gps", "biharmonic", "diffusion", "shape-dna"});
  require(o.count > 0, "the argument of --count must be positive");
  check_accuracy_option(o);
  check_eigensolver_options(o, given, o.space.paper);
  require(o.columns > 1, "the argument of --columns must be at least 2");
  require_descriptor(given, o, "columns", {"hks", "wks"});
  require_descriptor(given, o, "time", {"hks", "diffusion"});
  require_descriptor(given, o, "energy", {"wks"});
  require(!o.is_scaled || o.descriptor == "hks", "--scaled needs --descriptor hks");
  require_descriptor(given, o, "normalization", {"shape-dna"});
  require_descriptor(given, o, "compare", {"shape-dna"});
  require_effect(given, {"columns"}, !is_given(given, "time") && !is_given(given, "energy"),
                 "all times or energies");
  require_choice("normalization", o.normalization, {"area", "first", "weyl", "none"});
  o.is_time_given = given.count("time") > 0;
  o.is_energy_given = given.count("energy") > 0;
  o.is_column_given = given.count("column") > 0;
  require_positive(given, "time", o.time);
  require(std::isfinite(o.energy), "the argument of --energy must be a finite number");
  require(!o.is_column_given || o.is_of_vertices(), "shape-dna has no --column");
  require(o.column >= 0, "the argument of --column must not be negative");
  require(o.is_of_vertices() || (o.output.empty() && o.html.empty()),
          "--output and --html need a descriptor of vertices, and shape-dna is none");
  return true;
}

// The spectrum of a surface, with eigenfunctions at the vertices if the descriptor needs them.
Spectrum spectrum_of(Job& job, const Options& o) {
  Spectrum spectrum = solve_spectrum(o.count, !o.is_of_vertices(), o, job);
  check_number(job, spectrum.pairs, o.count);

  job.progress.show("evaluating eigenfunctions");
  if(o.is_of_vertices())
    spectrum.vertex_values =
        RL::Spline_functions_3(spectrum.space, spectrum.pairs.vectors).values_at_vertices();

  job.summary.add("zero_eigenvalues", RL::number_of_zero_eigenvalues(spectrum));
  return spectrum;
}

// a value for each vertex in each column
struct Descriptor {
  Eigen::MatrixXd values;
  std::vector<std::string> columns; // their names
};

std::string name_of(const std::string& quantity, double value) {
  std::ostringstream name;
  name << quantity << '=' << value;
  return name.str();
}

Descriptor heat_kernel_signature(const RL::Laplace_spectrum& spectrum, const Options& o) {
  Descriptor d;
  const Eigen::VectorXd times = o.is_time_given
                                    ? Eigen::VectorXd::Constant(1, o.time * spectrum.area)
                                    : RL::heat_kernel_times(spectrum, o.columns);
  d.values = RL::heat_kernel_signature(spectrum, times,
                                       o.is_scaled ? RL::Heat_kernel_scaling::heat_trace
                                                   : RL::Heat_kernel_scaling::none);
  for(const double time : times)
    d.columns.push_back(name_of("t", time / spectrum.area));
  return d;
}

Descriptor wave_kernel_signature(const RL::Laplace_spectrum& spectrum, const Options& o) {
  Descriptor d;
  const double unit = std::log(spectrum.area);
  RL::Wave_kernel_energies energies = RL::wave_kernel_energies(spectrum, o.columns);
  if(o.is_energy_given)
    energies.energies = Eigen::VectorXd::Constant(1, o.energy - unit);
  d.values = RL::wave_kernel_signature(spectrum, energies);
  for(const double energy : energies.energies)
    d.columns.push_back(name_of("e", energy + unit));
  return d;
}

Descriptor embedding(const RL::Laplace_spectrum& spectrum, const Options& o) {
  Descriptor d;
  if(o.descriptor == "gps")
    d.values = RL::global_point_signature(spectrum);
  else if(o.descriptor == "biharmonic")
    d.values = RL::biharmonic_embedding(spectrum);
  else
    d.values = RL::diffusion_map(spectrum, o.time * spectrum.area);
  // the number of the eigenfunction, which zeros that are left out count for
  const Eigen::Index first = spectrum.eigenvalues.size() - d.values.cols();
  for(Eigen::Index i = first; i < spectrum.eigenvalues.size(); ++i)
    d.columns.push_back(o.descriptor + "_" + std::to_string(i));
  return d;
}

Descriptor descriptor_of(const RL::Laplace_spectrum& spectrum, const Options& o) {
  return o.descriptor == "hks"   ? heat_kernel_signature(spectrum, o)
         : o.descriptor == "wks" ? wave_kernel_signature(spectrum, o)
                                 : embedding(spectrum, o);
}

// some columns of the descriptor at locations, some at a time
Eigen::MatrixXd columns_at(Spectrum spectrum, const std::vector<RL::Surface_location>& locations,
                           const Options& o, Eigen::Index first_column, Eigen::Index columns) {
  constexpr std::size_t block = 4096;
  const RL::Spline_functions_3 functions(spectrum.space, spectrum.pairs.vectors);
  Eigen::MatrixXd values(static_cast<Eigen::Index>(locations.size()), columns);
  for(std::size_t first = 0; first < locations.size(); first += block) {
    const std::size_t number = std::min(block, locations.size() - first);
    const auto begin = locations.begin() + static_cast<std::ptrdiff_t>(first);
    spectrum.vertex_values = functions.values_at_locations(
        std::vector<RL::Surface_location>(begin, begin + static_cast<std::ptrdiff_t>(number)));
    values.middleRows(static_cast<Eigen::Index>(first), static_cast<Eigen::Index>(number)) =
        descriptor_of(spectrum, o).values.middleCols(first_column, columns);
  }
  return values;
}

// the descriptor of all vertices
Outcome describe_vertices(const Spectrum& spectrum, const Options& o, Job& job) {
  job.progress.show("computing the descriptor");
  const Descriptor d = descriptor_of(spectrum, o);
  const Eigen::Index column = o.is_column_given  ? o.column
                              : o.is_signature() ? d.values.cols() / 2
                                                 : 0;
  require(column < d.values.cols(), "the argument of --column must be less than " +
                                        std::to_string(d.values.cols()) +
                                        ", the number of columns");
  const std::vector<double> values(d.values.col(column).begin(), d.values.col(column).end());
  const Value_range range(values);
  job.summary.add("columns", d.values.cols());
  job.summary.add("column", d.columns[static_cast<std::size_t>(column)]);
  job.summary.add("smallest_value", range.low);
  job.summary.add("largest_value", range.high);

  Outcome result = outcome(values);
  result.cell_width = spectrum.space.octree().cell_width(spectrum.space.depth());
  result.values_at = [spectrum, &o, column](const std::vector<RL::Surface_location>& locations) {
    return columns_at(spectrum, locations, o, column, 1);
  };
  if(!o.html.empty())
    result.page.values = d.values;
  result.page.names = d.columns;
  result.page.values_at = [spectrum, &o, n = d.values.cols()](const auto& locations) {
    return columns_at(spectrum, locations, o, 0, n);
  };
  result.page.first = static_cast<std::size_t>(column);
  result.write_table = [d](const std::string& file, const Summary& lines) {
    write_csv(file, lines, "vertex", d.columns, d.values);
  };
  return result;
}

Eigen::VectorXd shape_dna(const RL::Laplace_spectrum& spectrum, const Options& o) {
  using Normalization = RL::Shape_dna_normalization;
  return RL::shape_dna(spectrum, o.normalization == "area"    ? Normalization::area
                                 : o.normalization == "first" ? Normalization::first_eigenvalue
                                 : o.normalization == "weyl"  ? Normalization::weyl_slope
                                                              : Normalization::none);
}

// The ShapeDNA of the surface, and its distance to that of another mesh.
Outcome describe_shape(const RL::Laplace_spectrum& spectrum, const Options& o, Job& job) {
  const Eigen::VectorXd dna = shape_dna(spectrum, o);
  if(!o.other_mesh.empty()) {
    job.progress.show("reading " + o.other_mesh);
    const Mesh_input other = read_mesh(o.other_mesh);
    Summary of_other(other);
    Job other_job(o, other.surface, of_other, job.progress);
    const Eigen::VectorXd other_dna = shape_dna(spectrum_of(other_job, o), o);
    if(!other_job.failure().empty())
      job.fail(o.other_mesh + ": " + other_job.failure());
    const Eigen::Index number = std::min(dna.size(), other_dna.size());
    job.summary.add("distance", RL::shape_dna_distance(dna.head(number), other_dna.head(number)));
  }
  Outcome result;
  result.write_table = [dna](const std::string& file, const Summary& lines) {
    write_csv(file, lines, "index", {"shape_dna"}, dna);
  };
  return result;
}

Outcome describe(Job& job, const Options& o) {
  const Spectrum spectrum = spectrum_of(job, o);
  job.summary.add("descriptor", o.descriptor);
  return o.is_of_vertices() ? describe_vertices(spectrum, o, job)
                            : describe_shape(spectrum, o, job);
}

int main(int argc, char* argv[]) {
  return run_surface_program("spectral_descriptors", argc, argv, read_options, describe);
}
