// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_EXAMPLES_COMMAND_LINE_H
#define RESTRICTED_LAPLACIAN_3_EXAMPLES_COMMAND_LINE_H

// The command line that the programs have in common.

#include "program.h"

#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>
#include <CGAL/Restricted_laplacian_3/version.h>

#include <CGAL/version.h>

#include <boost/program_options.hpp>

#include <cmath>
#include <initializer_list>
#include <iostream>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace examples {

namespace po = boost::program_options;

// columns of the text of --help
constexpr unsigned int help_width = 92;

// Of the spline space, see make_space().
struct Space_options {
  std::optional<int> octree_depth; // that of the surface, see RL::default_octree_depth()
  double cube_scale = 0;           // the default
  double joining_tolerance = -1;   // not joined
  bool paper_space = false, split_elements = true, split_point_set = false;
};

struct Common_options {
  std::string mesh;
  Space_options space;
  std::string assembly = "cubature";
  std::string sampling = "independent";
  long long samples = 1000000;
  long long seed = 0;
  int threads = 0; // all
  std::string csv, output;
  int refine = 0; // the mesh of output as it is
  bool quiet = false, verbose = false, progress = false;
};

// What --help prints around the options.
struct Help {
  // the forms of a call
  std::string usage;
  // what the program does, in one sentence, and then what one has to know about it
  std::string description;
  // calls, each indented by two spaces, and behind it, indented by six, what it is good for
  std::string examples;
  std::string exit_status = R"(  0  all went well
  1  an error, which one line on the error stream names
  2  the solver did not converge; what it found was written
)";
};

inline po::options_description space_options(Common_options& o) {
  po::options_description description("Finite elements", help_width);
  auto add = description.add_options();
  auto* depth = po::value<int>()->value_name("D");
  depth->notifier([&o](int value) { o.space.octree_depth = value; });
  if(o.space.octree_depth)
    depth->default_value(*o.space.octree_depth);
  add("depth", depth,
      o.space.octree_depth
          ? "depth of the octree: 2^D cells along each side of the domain cube"
          : "depth of the octree: 2^D cells along each side of the domain cube (default: the "
            "smallest from 5 to 8 at which sides of triangles are at least half as long as cells "
            "are wide, in the mean)");
  add("cube-scale", po::value(&o.space.cube_scale)->value_name("S"),
      "side of the domain cube over the longest side of the bounding box "
      "(default: 1.1, or 1.2 with --paper)");
  add("unsplit", po::bool_switch(),
      "do not split elements; by default an element is split into one for each connected "
      "component of the surface in its support. Parts of the surface that are near to each "
      "other are connected then");
  add("join", po::value(&o.space.joining_tolerance)->value_name("T"),
      "join sides of faces that have no other face, where they run along each other at a "
      "distance of T or less, in the unit of the coordinates; unsplit elements do not depend on "
      "this");
  add("paper", po::bool_switch(&o.space.paper_space),
      "the space of the paper: only elements that are centered in the 2^D grid, unsplit");
  return description;
}

inline po::options_description integration_options(Common_options& o) {
  po::options_description description("Integration", help_width);
  auto add = description.add_options();
  add("assembly", po::value(&o.assembly)->value_name("METHOD")->default_value(o.assembly),
      "cubature: integrals over the triangles, or sums over the points; monte-carlo: sums over "
      "random samples");
  add("samples", po::value(&o.samples)->value_name("N")->default_value(o.samples),
      "number of samples for --assembly monte-carlo");
  add("sampling", po::value(&o.sampling)->value_name("KIND")->default_value(o.sampling),
      "samples that are independent, or stratified: one in each of N parts of equal area");
  add("seed", po::value(&o.seed)->value_name("N")->default_value(o.seed),
      "seed of everything random");
  return description;
}

// `table` says what --csv writes, and `properties` which properties of vertices --output writes.
inline po::options_description output_options(Common_options& o, const std::string& table,
                                              const std::string& properties) {
  po::options_description description("Output", help_width);
  auto add = description.add_options();
  add("csv", po::value(&o.csv)->value_name("FILE"),
      ("write a CSV table with the columns " + table).c_str());
  add("output", po::value(&o.output)->value_name("FILE"),
      ("write the mesh with colors: as binary PLY (.ply) with, at its vertices, " + properties +
       "; or as OBJ (.obj), without these")
          .c_str());
  return description;
}

// The same for programs whose result is known between the vertices, too.
inline po::options_description spline_output_options(Common_options& o, const std::string& table,
                                                     const std::string& properties) {
  po::options_description description = output_options(o, table, properties);
  auto add = description.add_options();
  add("refine", po::value(&o.refine)->value_name("N"),
      "divide the faces of the mesh of --output until no side is longer than 1/N of the width of a "
      "cell of the octree, and evaluate the splines at all of its vertices: what it shows does not "
      "depend on the faces of MESH then");
  return description;
}

// what every program has
inline void add_help_options(po::options_description& description) {
  auto add = description.add_options();
  add("help", "print this text");
  add("version", "print the versions of the package and of CGAL");
}

inline po::options_description general_options(Common_options& o) {
  po::options_description description("General", help_width);
  auto add = description.add_options();
  add("threads", po::value(&o.threads)->value_name("N"),
      "number of threads, at most; by default all processors are used. The result does not "
      "depend on it");
  add("quiet", po::bool_switch(&o.quiet), "print errors only");
  add("verbose", po::bool_switch(&o.verbose), "print all that --csv writes above the table");
  add("progress", po::bool_switch(&o.progress),
      "show what is done, and how many seconds are left, also if the error stream is no terminal");
  add_help_options(description);
  return description;
}

// requires that `value` is one of `choices`
inline void require_choice(const std::string& option, const std::string& value,
                           std::initializer_list<const char*> choices) {
  std::string list;
  for(const char* choice : choices) {
    if(value == choice)
      return;
    list += (list.empty() ? "" : ", ") + std::string(choice);
  }
  throw Error("the argument '" + value + "' of --" + option + " is not one of " + list);
}

inline void require_positive(const po::variables_map& given, const std::string& option,
                             double value) {
  require(given.count(option) == 0 || (value > 0 && std::isfinite(value)),
          "the argument of --" + option + " must be a positive number");
}

// requires that an option, if it is given, is a number that is not negative
inline void require_not_negative(const po::variables_map& given, const std::string& option) {
  require(given.count(option) == 0 ||
              (given[option].as<double>() >= 0 && std::isfinite(given[option].as<double>())),
          "the argument of --" + option + " must be a number that is not negative");
}

const char* const about_meshes = R"(
MESH is a file of one of the formats off, obj, ply, stl and ts. The surface is taken as it
is in the file: nothing is merged, cut or turned. It continues across an edge from each of
its faces to each other one, any number of them, whatever their orientation. Vertices at the
same place remain different vertices, and the edges between them different edges, unless
--join is given. Faces that are not triangles are triangulated, and faces without area are
left out of all integrals.
)";

// Reads a command line. Arguments without a name fill the options of `arguments`, which --help does
// not list, in the order of `positional`. Returns false if --help or --version was given, and
// prints it.
inline bool parse_arguments(int argc, char* argv[], const Help& help,
                            const po::options_description& visible,
                            const po::options_description& arguments,
                            const po::positional_options_description& positional,
                            po::variables_map& given) {
  po::options_description all;
  all.add(visible).add(arguments);
  // no guessing: a mistyped option is an error, not another option
  const int style = po::command_line_style::unix_style & ~po::command_line_style::allow_guessing;
  po::store(
      po::command_line_parser(argc, argv).options(all).positional(positional).style(style).run(),
      given);
  if(given.count("help")) {
    std::cout << "usage: " << help.usage << '\n'
              << help.description << "\nThe value after = is the default.\n"
              << visible << "\nExamples:\n"
              << help.examples << "\nExit status:\n"
              << help.exit_status;
    return false;
  }
  if(given.count("version")) {
    std::cout << help.usage.substr(0, help.usage.find(' ')) << " ("
              << "Restricted_laplacian_3 " << CGAL_RESTRICTED_LAPLACIAN_3_VERSION << ", CGAL "
              << CGAL_VERSION_STR << ")\n";
    return false;
  }
  po::notify(given);
  return true;
}

inline void check_integration_options(const Common_options& o, const po::variables_map& given) {
  require_choice("assembly", o.assembly, {"cubature", "monte-carlo"});
  require(given["samples"].defaulted() || o.assembly == "monte-carlo",
          "--samples needs --assembly monte-carlo");
  require_choice("sampling", o.sampling, {"independent", "stratified"});
  require(given["sampling"].defaulted() || o.assembly == "monte-carlo",
          "--sampling needs --assembly monte-carlo");
  require_positive(given, "samples", static_cast<double>(o.samples));
  require(o.seed >= 0 && o.seed <= std::numeric_limits<unsigned int>::max(),
          "the argument of --seed must lie between 0 and 4294967295");
}

// Reads the command line of a program that works on one mesh, the first argument without a name.
// The others are `rest`, if the program takes any. Returns false if --help was given, see above.
inline bool parse_command_line(int argc, char* argv[], const Help& help,
                               const po::options_description& visible, Common_options& o,
                               po::variables_map& given, std::vector<std::string>* rest = nullptr) {
  po::options_description arguments;
  arguments.add_options()("mesh", po::value(&o.mesh));
  po::positional_options_description positional;
  positional.add("mesh", 1);
  if(rest) {
    arguments.add_options()("rest", po::value(rest));
    positional.add("rest", -1);
  }
  if(!parse_arguments(argc, argv, help, visible, arguments, positional, given))
    return false;

  require(given.count("mesh") == 1, "no mesh is given; --help shows the options");
  require_positive(given, "cube-scale", o.space.cube_scale);
  o.space.split_elements = !given["unsplit"].as<bool>();
  require(given.count("join") == 0 ||
              (o.space.joining_tolerance >= 0 && std::isfinite(o.space.joining_tolerance)),
          "the argument of --join must be a number that is not negative");
  if(given.count("assembly"))
    check_integration_options(o, given);
  require_positive(given, "threads", o.threads);
  require(given.count("refine") == 0 || (o.refine >= 1 && o.refine <= 64),
          "the argument of --refine must lie between 1 and 64");
  require(given.count("refine") == 0 || !o.output.empty(), "--refine needs --output");
  check_output("--csv", o.csv);
  check_output("--output", o.output, {".ply", ".obj"});
  require(o.csv.empty() || o.csv != o.output, "--csv and --output name the same file");
  return true;
}

} // namespace examples

#endif // RESTRICTED_LAPLACIAN_3_EXAMPLES_COMMAND_LINE_H
