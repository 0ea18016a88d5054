// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "command_line.h"

#include "viewer_page.h"

#include <CGAL/Restricted_laplacian_3/version.h>

#include <CGAL/version.h>

#include <cmath>
#include <filesystem>
#include <iostream>
#include <limits>
#include <system_error>

namespace programs {

po::options_description space_options(Common_options& o) {
  po::options_description description("Finite elements", help_width);
  auto add = description.add_options();
  auto* depth = po::value<int>()->value_name("D");
  depth->notifier([&o](int value) { o.space.depth = value; });
  if(o.space.depth)
    depth->default_value(*o.space.depth);
  add("depth", depth,
      o.space.depth
          ? "depth of the octree: 2^D cells along each side of the domain cube"
          : "depth of the octree: 2^D cells along each side of the domain cube (default: the "
            "smallest from 5 to 8 at which sides of triangles are at least half as long as cells "
            "are wide, in the mean)");
  add("cube-scale", po::value(&o.space.cube_scale)->value_name("S"),
      "side of the domain cube over the longest side of the bounding box "
      "(default: 1.1, or 1.2 with --paper)");
  add("no-split", po::bool_switch(),
      "do not split elements; by default an element is split into one for each connected "
      "component of the surface in its support. Parts of the surface that are near to each "
      "other are connected then");
  add("joining-tolerance", po::value(&o.space.joining_tolerance)->value_name("T"),
      "--join for short: join sides of faces that have no other face, where they run along each "
      "other at a "
      "distance of T or less, in the unit of the coordinates; unsplit elements do not depend on "
      "this");
  add("maximum-memory", po::value(&o.space.maximum_gigabytes)->value_name("GB"),
      "refuse what would take more memory, before any work; by default that of the machine");
  add("geometry", po::value(&o.space.geometry)->value_name("KIND")->default_value(o.space.geometry),
      "flat: the surface consists of the triangles; smooth: it is a smooth one through the "
      "vertices, for meshes whose vertices lie on such a surface, and not for those whose "
      "triangles were fitted to it");
  add("crease-angle",
      po::value(&o.space.crease_angle)->value_name("A")->default_value(o.space.crease_angle),
      "for --geometry smooth: edges at which normals of faces differ by more than A degrees are "
      "creases");
  add("paper", po::bool_switch(&o.space.paper),
      "the space of the paper: only elements that are centered in the 2^D grid, unsplit");
  return description;
}

void add_material_options(po::options_description& description, Common_options& o) {
  auto add = description.add_options();
  add("diffusion-property", po::value(&o.space.diffusion_property)->value_name("NAME"),
      "D of the operator div(D grad u): a vertex property of MESH, positive; or the symmetric "
      "matrix "
      "with the components NAME_xx, NAME_yy, NAME_zz, NAME_xy, NAME_xz, NAME_yz, of which the part "
      "along the surface counts");
  add("density-property", po::value(&o.space.density_property)->value_name("NAME"),
      "the density, a vertex property of MESH, positive, with which integrals are weighted");
  add("anisotropy", po::value(&o.space.anisotropy)->value_name("A"),
      "in place of a diffusion: factors exp(-A |k|) along each principal direction, where k is the "
      "curvature along the other one; A is a length");
}

void add_accuracy_option(po::options_description& description, const std::string& what,
                         Common_options& o) {
  auto* accuracy = po::value<double>()->value_name("E");
  accuracy->notifier([&o](double value) { o.space.accuracy = value; });
  description.add_options()("accuracy", accuracy,
                            ("deeper and deeper octrees are tried until " + what +
                             " is not larger than E; --depth is the first one then, 4 by default")
                                .c_str());
}

void check_accuracy_option(const Common_options& o) {
  if(!o.space.accuracy)
    return;
  require(*o.space.accuracy > 0 && *o.space.accuracy < 1,
          "the argument of --accuracy must be in (0, 1)");
  require(!o.space.paper, "--accuracy excludes --paper");
  require(o.assembly == "cubature", "--accuracy needs --assembly cubature");
}

void add_vertex_data_option(po::options_description& description, Common_options& o) {
  description.add_options()(
      "vertex-data", po::value(&o.vertex_data)->value_name("KIND")->default_value(o.vertex_data),
      "what values at vertices mean between them: linear in each triangle, or smooth (cubic), with "
      "creases as for --geometry smooth");
}

po::options_description integration_options(Common_options& o) {
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

std::string viewer_file() {
  namespace fs = std::filesystem;
  std::error_code ignored;
  const fs::path root = fs::read_symlink("/proc/self/exe", ignored).parent_path().parent_path();
  const fs::path installed = root / "share/Restricted_laplacian_3/viewer.html";
  const fs::path built = root / "viewer/viewer.html";
  return (fs::is_regular_file(installed, ignored) ? installed : built).string();
}

po::options_description output_options(Common_options& o, const std::string& table,
                                       const std::string& properties) {
  po::options_description description("Output", help_width);
  auto add = description.add_options();
  add("csv", po::value(&o.csv)->value_name("FILE"),
      ("write a CSV table with the columns " + table).c_str());
  add("output", po::value(&o.output)->value_name("FILE"),
      ("write the mesh with colors: as binary PLY (.ply) with, at its vertices, " + properties +
       "; or as OBJ (.obj), without these")
          .c_str());
  add("html", po::value(&o.html)->value_name("FILE"),
      "write a page (.html) that shows the mesh and its values in a browser, to be turned around; "
      "it needs no network");
  add("overwrite", po::bool_switch(&o.overwrite), "outputs may replace a file that is read");
  return description;
}

po::options_description spline_output_options(Common_options& o, const std::string& table,
                                              const std::string& properties) {
  po::options_description description = output_options(o, table, properties);
  auto add = description.add_options();
  add("refine", po::value(&o.refine)->value_name("N"),
      "divide the faces of the mesh of --output and --html until no side is longer than 1/N of the "
      "width of a cell of the octree, and evaluate the splines at all of its vertices: what it "
      "shows does not "
      "depend on the faces of MESH then");
  return description;
}

void add_help_options(po::options_description& description) {
  auto add = description.add_options();
  add("help", "print this text");
  add("version", "print the versions of the package and of CGAL");
}

po::options_description general_options(Common_options& o) {
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

void require_choice(const std::string& option, const std::string& value,
                    std::initializer_list<const char*> choices) {
  std::string list;
  for(const char* choice : choices) {
    if(value == choice)
      return;
    list += (list.empty() ? "" : ", ") + std::string(choice);
  }
  throw Error("the argument '" + value + "' of --" + option + " is not one of " + list);
}

void require_positive(const po::variables_map& given, const std::string& option, double value) {
  require(given.count(option) == 0 || (value > 0 && std::isfinite(value)),
          "the argument of --" + option + " must be a positive number");
}

bool is_given(const po::variables_map& given, const std::string& option) {
  return given.count(option) > 0 && !given[option].defaulted();
}

void require_effect(const po::variables_map& given, std::initializer_list<const char*> options,
                    bool has_effect, const std::string& needed) {
  for(const char* option : options)
    require(has_effect || !is_given(given, option),
            "--" + std::string(option) + " has no effect without " + needed);
}

std::vector<std::size_t> not_negative(const std::string& option,
                                      const std::vector<long long>& values) {
  std::vector<std::size_t> result;
  for(const long long value : values) {
    require(value >= 0,
            "the argument " + std::to_string(value) + " of --" + option + " must not be negative");
    result.push_back(static_cast<std::size_t>(value));
  }
  return result;
}

void require_not_negative(const po::variables_map& given, const std::string& option) {
  require(given.count(option) == 0 ||
              (given[option].as<double>() >= 0 && std::isfinite(given[option].as<double>())),
          "the argument of --" + option + " must be a number that is not negative");
}

bool parse_arguments(int argc, char* argv[], const Help& help,
                     const po::options_description& visible,
                     const po::options_description& arguments,
                     const po::positional_options_description& positional,
                     po::variables_map& given) {
  po::options_description all;
  all.add(visible).add(arguments);
  for(const auto& option : all.options())
    this_run().options.insert(option->long_name());
  std::vector<std::string> words(argv + 1, argv + argc);
  for(std::string& word : words)
    if(word == "--join" || word.rfind("--join=", 0) == 0)
      word.replace(2, 4, "joining-tolerance");
  // no guessing: a mistyped option is an error, not another option
  const int style = po::command_line_style::unix_style & ~po::command_line_style::allow_guessing;
  po::store(po::command_line_parser(words).options(all).positional(positional).style(style).run(),
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

void check_integration_options(const Common_options& o, const po::variables_map& given) {
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

bool parse_command_line(int argc, char* argv[], const Help& help,
                        const po::options_description& visible, Common_options& o,
                        po::variables_map& given, std::vector<std::string>* rest) {
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
  require_positive(given, "maximum-memory", o.space.maximum_gigabytes);
  if(given.count("no-split")) // a program with a space
    o.space.split = !given["no-split"].as<bool>();
  require(given.count("joining-tolerance") == 0 ||
              (o.space.joining_tolerance >= 0 && std::isfinite(o.space.joining_tolerance)),
          "the argument of --joining-tolerance must be a number that is not negative");
  require(o.space.geometry == "flat" || o.space.geometry == "smooth",
          "the argument of --geometry must be flat or smooth");
  require(o.vertex_data == "linear" || o.vertex_data == "smooth",
          "the argument of --vertex-data must be linear or smooth");
  // or details of a length are smoothed, but creases
  require_effect(given, {"crease-angle"},
                 o.space.geometry == "smooth" || o.vertex_data == "smooth" ||
                     given.count("length") > 0,
                 "--geometry smooth or --vertex-data smooth");
  require_effect(given, {"joining-tolerance"},
                 given.count("paper") == 0 || (o.space.split && !o.space.paper), "split elements");
  require(!o.quiet || !(o.verbose || o.progress), "--quiet excludes --verbose and --progress");
  if(given.count("assembly"))
    check_integration_options(o, given);
  require_not_negative(given, "anisotropy");
  require(o.space.anisotropy < 0 || o.space.diffusion_property.empty(),
          "give --anisotropy or --diffusion-property, not both");
  require(o.space.anisotropy < 0 || !o.space.accuracy,
          "--anisotropy follows the curvature in a space: it needs --depth, no --accuracy");
  require_positive(given, "threads", o.threads);
  require(given.count("refine") == 0 || (o.refine >= 1 && o.refine <= 64),
          "the argument of --refine must lie between 1 and 64");
  require(given.count("refine") == 0 || !o.output.empty() || !o.html.empty(),
          "--refine needs --output or --html");
  this_run().is_quiet = o.quiet;
  this_run().has_overwrite = given.count("overwrite") > 0;
  this_run().may_overwrite_input = o.overwrite;
  check_output("--csv", o.csv);
  check_output("--output", o.output, {".ply", ".obj"});
  check_output("--html", o.html, {".html", ".htm"});
  if(!o.html.empty())
    check_viewer(viewer_file());
  require(o.csv.empty() || o.csv != o.output, "--csv and --output name the same file");
  check_input(o.mesh);
  return true;
}

} // namespace programs
