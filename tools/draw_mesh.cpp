// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Draws a picture of a mesh, or of points, such as the example programs write.

#include "../examples/Restricted_laplacian_3/support/color_map.h"
#include "../examples/Restricted_laplacian_3/support/command_line.h"
#include "../examples/Restricted_laplacian_3/support/point_input.h"
#include "../examples/Restricted_laplacian_3/support/program.h"
#include "../examples/Restricted_laplacian_3/support/vertex_data.h"
#include "picture.h"

#include <string>
#include <vector>

using namespace examples;

const Help help = {"draw_mesh MESH PICTURE [OPTION]...", R"(
Draws a mesh in the colors of its vertices, or in gray if it has none.

MESH is a file of one of the formats off, obj, ply, stl and ts, or points with normals, as
the programs read them. PICTURE is a PNG file. The mesh is seen from the front, somewhat
from above and from the right, in parallel projection.
)",
                   R"(  draw_mesh u.ply u.png --isolines 20
      what a program wrote to u.ply with --output, with level lines
  draw_mesh gaussian.ply gaussian.png --property gaussian
      a property, in colors of its own
)",
                   R"(  0  all went well
  1  an error, which one line on the error stream names
)"};

struct Options {
  std::string mesh, picture, property, up = "y";
  int isolines = 0, size = 1000;
};

// returns false if there is nothing more to do
bool read_options(int argc, char* argv[], Options& o) {
  po::options_description options("Picture", help_width), all(help_width), arguments;
  auto add = options.add_options();
  add("property", po::value(&o.property)->value_name("NAME"),
      "show the values of a vertex property of MESH, a PLY file: from blue by white (0) to red if "
      "there are both signs, else from dark violet (smallest) to yellow; gray is no value");
  add("isolines", po::value(&o.isolines)->value_name("N")->default_value(o.isolines),
      "draw level lines of --property, or of the property value, that divide the range of values "
      "into about N bands");
  add("up", po::value(&o.up)->value_name("y|z")->default_value(o.up), "the axis that points up");
  add("size", po::value(&o.size)->value_name("N")->default_value(o.size),
      "pixels of the longer side");
  add("help", "print this text");
  all.add(options);
  arguments.add_options()("mesh", po::value(&o.mesh))("picture", po::value(&o.picture));
  po::positional_options_description positional;
  positional.add("mesh", 1).add("picture", 1);
  po::variables_map given;
  if(!parse_arguments(argc, argv, help, all, arguments, positional, given))
    return false;
  require(!o.mesh.empty(), "no mesh is given; --help shows the options");
  require(!o.picture.empty(), "no picture is given; --help shows the options");
  require(o.isolines >= 0, "the argument of --isolines must not be negative");
  require_choice("up", o.up, {"y", "z"});
  require(o.size >= 100 && o.size <= 10000,
          "the argument of --size must lie between 100 and 10000");
  return true;
}

int main(int argc, char* argv[]) {
  return run_program("draw_mesh", [&]() -> int {
    Options o;
    if(!read_options(argc, argv, o))
      return success;
    const RL::Triangulated_surface_3 surface = read_mesh_or_points(o.mesh).surface;
    const std::size_t number = surface.number_of_vertices();
    std::vector<double> values(number, 0.);
    if(!o.property.empty() || o.isolines > 0)
      values = read_ply_property(o.mesh, o.property.empty() ? "value" : o.property);
    const std::vector<Color> colors = !o.property.empty() ? value_colors(values)
                                      : has_colors(o.mesh)
                                          ? read_colors(o.mesh)
                                          : std::vector<Color>(number, {0.8, 0.8, 0.8});
    require(values.size() == number && colors.size() == number, "not every vertex has a value");
    write_picture(o.picture, surface, colors, values, {o.up == "z", o.isolines, o.size});
    return success;
  });
}
