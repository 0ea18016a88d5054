// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Draws a picture of a mesh, or of points, such as the other programs write.

#include "support/color_map.h"
#include "support/command_line.h"
#include "support/picture.h"
#include "support/point_input.h"
#include "support/program.h"
#include "support/vertex_data.h"
#include "support/viewer_page.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <ostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

using namespace programs;

const Help help = {"draw_mesh MESH PICTURE [OPTION]...", R"(
Draws a mesh in the colors of its vertices, or in gray if it has none.

MESH is a file of one of the formats off, obj, ply, stl and ts, or points with normals, as
the programs read them. PICTURE is a PNG file (.png): the mesh is seen from the front,
somewhat from above and from the right, in parallel projection. Or it is a page (.html)
that shows the mesh in a browser, to be turned around, with all vertex properties of a PLY
file; and other meshes beside it.

Values are linear in each face. Level lines are those of a spline if the program that wrote
MESH was given --refine, which divides large faces.
)",
                   R"(  draw_mesh u.ply u.png --isolines 20
      what a program wrote to u.ply with --output, with level lines
  draw_mesh u.ply below.png --property value --range -0.1,0.1 --view 0,-1,0.5
      values in colors of a given range, with a legend, seen from below
  draw_mesh gaussian.ply gaussian.png --property gaussian
      a property, in colors of its own
  draw_mesh u.ply pair.html --beside gaussian.ply
      two meshes side by side, to be turned around in a browser
)",
                   R"(  0  all went well
  1  an error, which one line on the error stream names
)"};

struct Options {
  std::string mesh, picture, property, up = "y";
  std::vector<std::string> beside;
  std::vector<double> view, range; // empty if they are not given
  int isolines = 0, size = 1000;
  bool no_legend = false;
};

bool is_page(const Options& o) { return extension(o.picture) != ".png"; }

// `number` numbers between commas
std::vector<double> numbers(const std::string& option, const std::string& text,
                            std::size_t number) {
  std::vector<double> result;
  std::istringstream list(text);
  for(std::string word; std::getline(list, word, ',');) {
    std::istringstream in(word);
    double x = 0;
    require(static_cast<bool>(in >> x) && in.eof() && std::isfinite(x),
            "'" + word + "' in the argument of --" + option + " is not a number");
    result.push_back(x);
  }
  require(result.size() == number, "the argument of --" + option + " must be " +
                                       std::to_string(number) + " numbers between commas");
  return result;
}

// returns false if there is nothing more to do
bool read_options(int argc, char* argv[], Options& o) {
  std::string view, range;
  po::options_description options("Picture", help_width), all(help_width), arguments;
  auto add = options.add_options();
  add("property", po::value(&o.property)->value_name("NAME"),
      "show the values of a vertex property of MESH, a PLY file: from blue by white (0) to red if "
      "there are both signs, else from dark violet (smallest) to yellow; gray is no value. A "
      "legend "
      "tells which color is which value");
  add("range", po::value(&range)->value_name("LOW,HIGH"),
      "colors of --property are those of values from LOW to HIGH; by default from the smallest to "
      "the largest value");
  add("no-legend", po::bool_switch(&o.no_legend), "leave out the legend");
  add("isolines", po::value(&o.isolines)->value_name("N")->default_value(o.isolines),
      "draw level lines of --property, or of the property value, that divide the range of values "
      "into about N bands");
  add("view", po::value(&view)->value_name("X,Y,Z"),
      "see the mesh from this direction, for example 0,0,1");
  add("up", po::value(&o.up)->value_name("y|z")->default_value(o.up), "the axis that points up");
  add("beside", po::value(&o.beside)->multitoken()->value_name("MESH..."),
      "meshes that a page shows beside the first one, with the same camera and colors");
  add("size", po::value(&o.size)->value_name("N")->default_value(o.size),
      "pixels of the longer side, without the legend");
  add_help_options(options);
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
  if(given.count("view") > 0) {
    o.view = numbers("view", view, 3);
    require(std::any_of(o.view.begin(), o.view.end(), [](double x) { return x != 0; }),
            "the argument of --view must not be 0,0,0");
  }
  if(given.count("range") > 0) {
    require(!o.property.empty(), "--range needs --property");
    o.range = numbers("range", range, 2);
    require(o.range[0] < o.range[1], "the argument of --range must be LOW,HIGH with LOW < HIGH");
  }
  check_output("PICTURE", o.picture, {".png", ".html", ".htm"});
  if(is_page(o)) {
    check_viewer(viewer_file());
    for(const char* option : {"view", "no-legend", "size"})
      require(given.count(option) == 0 || given[option].defaulted(),
              "--" + std::string(option) + " needs a PNG file, not a page");
  } else
    require(o.beside.empty(), "--beside needs a page (.html), not a PNG file");
  return true;
}

// a surface in a file with all that is known at its vertices, the property of the options first
Viewer_surface viewer_surface(const std::string& mesh, const Options& o) {
  Viewer_surface result(std::filesystem::path(mesh).filename().string(),
                        read_mesh_or_points(mesh).surface);
  for(auto& [name, values] : read_vertex_values(mesh)) {
    const bool is_first = name == o.property;
    Viewer_field field = {name, std::move(values), false, {}};
    if(is_first && !o.range.empty())
      field.range = std::pair(o.range[0], o.range[1]);
    result.fields.insert(is_first ? result.fields.begin() : result.fields.end(), std::move(field));
  }
  require(o.property.empty() || (!result.fields.empty() && result.fields[0].name == o.property),
          "'" + mesh + "' is not a PLY file with a vertex property '" + o.property + "'");
  if(has_colors(mesh)) {
    Viewer_field field = {"color", {}, true, {}};
    for(const Color& color : read_colors(mesh))
      field.values.insert(field.values.end(), color.begin(), color.end());
    result.fields.push_back(std::move(field));
  }
  return result;
}

void write_page(const Options& o) {
  Viewer_page page;
  page.title = std::filesystem::path(o.mesh).filename().string();
  page.isolines = o.isolines;
  page.up = o.up[0];
  page.surfaces.push_back(viewer_surface(o.mesh, o));
  for(const std::string& mesh : o.beside)
    page.surfaces.push_back(viewer_surface(mesh, o));
  const std::string viewer = read_viewer(viewer_file());
  write_file(o.picture, [&](std::ostream& out) { write_viewer_page(out, viewer, page); });
}

int main(int argc, char* argv[]) {
  return run_program("draw_mesh", [&]() -> int {
    Options o;
    if(!read_options(argc, argv, o))
      return success;
    if(is_page(o)) {
      write_page(o);
      return success;
    }
    const RL::Triangulated_surface_3 surface = read_mesh_or_points(o.mesh).surface;
    const std::size_t number = surface.number_of_vertices();
    std::vector<double> values(number, 0.);
    if(!o.property.empty() || o.isolines > 0)
      values = read_vertex_property(o.mesh, o.property.empty() ? "value" : o.property);
    Picture_options picture;
    picture.z_is_up = o.up == "z";
    picture.isolines = o.isolines;
    picture.size = o.size;
    if(!o.view.empty())
      picture.from = RL::Vector_3(o.view[0], o.view[1], o.view[2]);
    const Color_scale scale =
        o.range.empty() ? Color_scale(Value_range(values)) : Color_scale(o.range[0], o.range[1]);
    if(!o.property.empty() && !o.no_legend)
      picture.legend = scale;
    const std::vector<Color> colors = !o.property.empty() ? scale.colors(values)
                                      : has_colors(o.mesh)
                                          ? read_colors(o.mesh)
                                          : std::vector<Color>(number, {0.8, 0.8, 0.8});
    require(values.size() == number && colors.size() == number, "not every vertex has a value");
    write_picture(o.picture, surface, colors, values, picture);
    return success;
  });
}
