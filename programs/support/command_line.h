// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_PROGRAMS_COMMAND_LINE_H
#define RESTRICTED_LAPLACIAN_3_PROGRAMS_COMMAND_LINE_H

// The command line that the programs have in common.

#include "program.h"

#include <boost/program_options.hpp>

#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

namespace programs {

namespace po = boost::program_options;

// columns of the text of --help
constexpr unsigned int help_width = 92;

// Of the spline space, see make_space().
struct Space_options {
  std::optional<int> depth; // that of the surface, see RL::default_depth()
  std::optional<double> accuracy;
  double cube_scale = 0;         // the default
  double joining_tolerance = -1; // not joined
  double maximum_gigabytes = 0;  // those of the machine
  bool paper = false, split = true, split_point_set = false;
  std::string geometry = "flat";
  double crease_angle = 40;
  std::string diffusion_property, density_property; // of the mesh; none: 1
  double anisotropy = -1;                           // none
};

struct Common_options {
  std::string mesh;
  Space_options space;
  std::string vertex_data = "linear"; // see vertex_data_option()
  std::string assembly = "cubature";
  std::string sampling = "independent";
  long long samples = 1000000;
  long long seed = 0;
  int threads = 0; // all
  std::string csv, output, html;
  int refine = 0; // the mesh of output as it is
  bool quiet = false, verbose = false, progress = false, overwrite = false;
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

po::options_description space_options(Common_options& o);
// For programs whose operator has coefficients.
void add_material_options(po::options_description& description, Common_options& o);
// For programs that search a depth for an accuracy of `what`.
void add_accuracy_option(po::options_description& description, const std::string& what,
                         Common_options& o);
// For programs that take values at vertices.
void add_vertex_data_option(po::options_description& description, Common_options& o);

po::options_description integration_options(Common_options& o);

// the viewer for --html, see viewer_page.h: beside the folder of the programs
std::string viewer_file();

// `table` says what --csv writes, and `properties` which properties of vertices --output writes.
po::options_description output_options(Common_options& o, const std::string& table,
                                       const std::string& properties);

// The same for programs whose result is known between the vertices, too.
po::options_description spline_output_options(Common_options& o, const std::string& table,
                                              const std::string& properties);

// what every program has
void add_help_options(po::options_description& description);

po::options_description general_options(Common_options& o);

// requires that `value` is one of `choices`
void require_choice(const std::string& option, const std::string& value,
                    std::initializer_list<const char*> choices);

void require_positive(const po::variables_map& given, const std::string& option, double value);

// whether an option is on the command line
bool is_given(const po::variables_map& given, const std::string& option);

// requires that some options, if they are given, have an effect: `needed` says what they need
void require_effect(const po::variables_map& given, std::initializer_list<const char*> options,
                    bool has_effect, const std::string& needed);

// numbers that are at least 0, as of vertices
std::vector<std::size_t> not_negative(const std::string& option,
                                      const std::vector<long long>& values);

// requires that an option, if it is given, is a number that is not negative
void require_not_negative(const po::variables_map& given, const std::string& option);

const char* const about_meshes = R"(
MESH is a file of one of the formats off, obj, ply, stl, vtk (legacy PolyData) and ts. The
surface is taken as it is in the file: nothing is merged, cut or turned. It continues across
an edge from each of its faces to each other one, any number of them, whatever their
orientation. Vertices at the same place remain different vertices, and the edges between
them different edges, unless --joining-tolerance is given. Faces that are not triangles are
triangulated, and faces without area are left out of all integrals.
)";

// Reads a command line. Arguments without a name fill the options of `arguments`, which --help does
// not list, in the order of `positional`. Returns false if --help or --version was given, and
// prints it.
bool parse_arguments(int argc, char* argv[], const Help& help,
                     const po::options_description& visible,
                     const po::options_description& arguments,
                     const po::positional_options_description& positional,
                     po::variables_map& given);

void check_accuracy_option(const Common_options& o);

void check_integration_options(const Common_options& o, const po::variables_map& given);

// Reads the command line of a program that works on one mesh, the first argument without a name.
// The others are `rest`, if the program takes any. Returns false if --help was given, see above.
bool parse_command_line(int argc, char* argv[], const Help& help,
                        const po::options_description& visible, Common_options& o,
                        po::variables_map& given, std::vector<std::string>* rest = nullptr);

} // namespace programs

#endif // RESTRICTED_LAPLACIAN_3_PROGRAMS_COMMAND_LINE_H
