// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Makes synthetic scans of a colored mesh, each with its own exposure and light: input for
// stitch_colors of which the truth is known.

#include "support/color_pattern.h"
#include "support/command_line.h"
#include "support/mesh_input.h"
#include "support/mesh_output.h"
#include "support/program.h"
#include "support/vertex_data.h"
#include "support/virtual_scanner.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <limits>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

using namespace programs;

const Help help = {"bake_scans MESH FOLDER [OPTION]...", R"(
Takes synthetic range images with colors of a mesh from cameras around it: input for
stitch_colors of which the truth is known.

MESH is a file of one of the formats off, obj, ply, stl and ts. The colors are those of the
vertices of MESH, a PLY file, or a pattern. FOLDER is made, and gets scan_00.ply,
scan_01.ply, ..., each in the frame of its camera; poses.conf with the matrices that take
them to the frame of MESH; and truth.ply, the mesh with its colors.
)",
                   R"(  bake_scans elephant.off scans --views 6 --exposure-range 0.3
      scans with exposures of their own, of which the largest is 1.3 times the smallest
  bake_scans elephant.off points --points --noise 0.5 --resolution 256
      noisy points with normals
)",
                   R"(  0  all went well
  1  an error, which one line on the error stream names
)"};

struct Options {
  std::string mesh, folder;
  int views = 8, resolution = 512;
  double field_of_view = 30, exposure_range = 0.3, tint = 0, light = 0, noise = 0;
  std::string exposures;
  bool in_linear_light = false, points = false, pattern = false, quiet = false;
  long long seed = 0;
};

// returns false if there is nothing more to do
bool read_options(int argc, char* argv[], Options& o) {
  po::options_description cameras("Cameras", help_width);
  auto add = cameras.add_options();
  add("views", po::value(&o.views)->value_name("N")->default_value(o.views),
      "number of cameras, spread evenly around the mesh");
  add("resolution", po::value(&o.resolution)->value_name("R")->default_value(o.resolution),
      "pixels along each side of a picture");
  add("field-of-view", po::value(&o.field_of_view)->value_name("A")->default_value(o.field_of_view),
      "angle of the pictures, in degrees, from 1 to 120; all of the mesh is seen by each camera");
  add("points", po::bool_switch(&o.points), "write points with normals instead of meshes");
  add("noise", po::value(&o.noise)->value_name("S")->default_value(o.noise),
      "standard deviation of normal noise of the depth, in units of the width of a pixel");
  po::options_description light("Colors and light", help_width);
  add = light.add_options();
  add("pattern", po::bool_switch(&o.pattern),
      "a pattern of waves in place of the colors of MESH; always if it has none");
  add("exposure-range",
      po::value(&o.exposure_range)->value_name("E")->default_value(o.exposure_range, "0.3"),
      "the largest exposure is 1, and 1 + E times the smallest one; they are spread evenly, in an "
      "order that depends on --seed");
  add("exposures", po::value(&o.exposures)->value_name("X,..."),
      "the exposure of each camera instead: factors of the colors");
  add("tint", po::value(&o.tint)->value_name("T")->default_value(o.tint),
      "red, green and blue get factors of their own, at random, of which the largest is up to 1 + "
      "T times the smallest");
  add("light", po::value(&o.light)->value_name("L")->default_value(o.light),
      "part of the light, from 0 to 1, that comes from a lamp beside each camera");
  add("linear-light", po::bool_switch(&o.in_linear_light),
      "factors apply to linear light, and colors are sRGB; by default they apply to the colors as "
      "they are stored");
  po::options_description general("General", help_width);
  add = general.add_options();
  add("seed", po::value(&o.seed)->value_name("N")->default_value(o.seed),
      "seed of everything random");
  add("quiet", po::bool_switch(&o.quiet), "print errors only");
  add_help_options(general);
  po::options_description all(help_width), arguments;
  all.add(cameras).add(light).add(general);
  arguments.add_options()("mesh", po::value(&o.mesh))("folder", po::value(&o.folder));
  po::positional_options_description positional;
  positional.add("mesh", 1).add("folder", 1);
  po::variables_map given;
  if(!parse_arguments(argc, argv, help, all, arguments, positional, given))
    return false;

  const auto is_in = [](double x, double low, double high) { return x >= low && x <= high; };
  const double infinity = std::numeric_limits<double>::max();
  require(!o.mesh.empty(), "no mesh is given; --help shows the options");
  require(!o.folder.empty(), "no folder is given; --help shows the options");
  require(is_in(o.views, 1, 10000), "the argument of --views must lie between 1 and 10000");
  require(is_in(o.resolution, 2, 1 << 14),
          "the argument of --resolution must lie between 2 and 16384");
  require(is_in(o.field_of_view, 1, 120),
          "the argument of --field-of-view must lie between 1 and 120");
  for(const char* option : {"exposure-range", "tint", "noise"})
    require(is_in(given[option].as<double>(), 0, infinity),
            std::string("the argument of --") + option + " must be a number that is not negative");
  require(is_in(o.light, 0, 1), "the argument of --light must lie between 0 and 1");
  require(o.exposures.empty() || given["exposure-range"].defaulted(),
          "give --exposures or --exposure-range, not both");
  require(o.seed >= 0, "the argument of --seed must not be negative");
  return true;
}

// the numbers of a list, one for each view
std::vector<double> exposures(const Options& o) {
  std::vector<double> result;
  std::istringstream list(o.exposures);
  for(std::string word; std::getline(list, word, ',');) {
    std::istringstream number(word);
    double x = 0;
    require(static_cast<bool>(number >> x) && number.eof() && x > 0 && std::isfinite(x),
            "'" + word + "' in the argument of --exposures is not a positive number");
    result.push_back(x);
  }
  require(static_cast<int>(result.size()) == o.views,
          "--exposures has " + std::to_string(result.size()) + " numbers for " +
              std::to_string(o.views) + " views");
  return result;
}

std::vector<Lighting> lightings(const Options& o) {
  Random random(o.seed);
  const std::vector<double> factors =
      o.exposures.empty() ? spread_exposures(o.views, o.exposure_range, random) : exposures(o);
  std::vector<Lighting> result = make_lightings(factors, o.tint, o.light, random);
  for(Lighting& lighting : result)
    lighting.in_linear_light = o.in_linear_light;
  return result;
}

// the file of poses that stitch_colors reads
void write_poses(const std::string& file,
                 const std::vector<std::pair<std::string, RL::Scan_pose>>& poses) {
  write_file(file, [&](std::ostream& out) {
    out << "# file, then the 4x4 matrix, row by row, that takes its coordinates to the world\n";
    for(const auto& [name, pose] : poses) {
      out << name;
      for(int row = 0; row < 3; ++row)
        for(int column = 0; column < 4; ++column)
          out << ' ' << pose.m(row, column);
      out << " 0 0 0 1\n";
    }
  });
}

void print_line(const std::string& name, const Virtual_scan& scan, const Lighting& lighting) {
  std::cout << std::left << std::setw(14) << name << std::right << std::setw(9)
            << scan.surface.number_of_vertices() << std::setw(10)
            << (scan.surface.is_point_set() ? 0 : scan.surface.number_of_faces());
  for(const double factor : lighting.gain)
    std::cout << std::fixed << std::setprecision(3) << std::setw(7) << factor;
  std::cout << std::setw(10) << scan.clamped << '\n';
}

std::string scan_name(int i) {
  std::ostringstream name;
  name << "scan_" << std::setw(2) << std::setfill('0') << i << ".ply";
  return name.str();
}

int main(int argc, char* argv[]) {
  return run_program("bake_scans", [&]() -> int {
    Options o;
    if(!read_options(argc, argv, o))
      return success;
    const Progress progress(o.quiet, false);
    const std::filesystem::path folder(o.folder);
    this_run().is_quiet = o.quiet;
    for(int i = 0; i < o.views; ++i)
      this_run().outputs.emplace_back("FOLDER", (folder / scan_name(i)).string());
    this_run().outputs.emplace_back("FOLDER", (folder / "truth.ply").string());
    progress.show("reading " + o.mesh);
    const RL::Triangulated_surface_3 surface = read_mesh(o.mesh).surface;
    const std::vector<Color> colors =
        o.pattern || !has_colors(o.mesh) ? color_pattern(surface) : read_colors(o.mesh);
    require(colors.size() == surface.number_of_vertices(), "not every vertex has a color");
    const std::vector<Lighting> lighting = lightings(o);

    std::error_code error;
    std::filesystem::create_directories(o.folder, error);
    require(!error, "cannot make the folder '" + o.folder + "'");
    check_output("FOLDER", (folder / "poses.conf").string());

    const Virtual_scanner scanner(surface, colors);
    const std::vector<Camera> cameras =
        cameras_around(surface, o.views, o.field_of_view * CGAL_PI / 180, o.resolution);
    std::vector<Virtual_scan> scans;
    std::vector<std::pair<std::string, RL::Scan_pose>> poses;
    const auto of_scans = progress.step("taking " + std::to_string(o.views) + " scans");
    for(int i = 0; i < o.views; ++i) {
      of_scans(static_cast<double>(i) / o.views);
      scans.push_back(scanner.scan(cameras[i], lighting[i], o.points, o.noise,
                                   static_cast<std::uint64_t>(o.seed + i)));
      poses.emplace_back(scan_name(i), cameras[i].to_world);
    }

    progress.show("writing the scans");
    for(std::size_t i = 0; i < scans.size(); ++i)
      write_mesh((folder / poses[i].first).string(), scans[i].surface, scans[i].colors);
    write_mesh((folder / "truth.ply").string(), surface, colors);
    write_poses((folder / "poses.conf").string(), poses);
    progress.show("");
    if(!o.quiet) {
      std::cout << "scan             points triangles    red  green   blue   clamped\n";
      for(std::size_t i = 0; i < scans.size(); ++i)
        print_line(poses[i].first, scans[i], lighting[i]);
    }
    return success;
  });
}
