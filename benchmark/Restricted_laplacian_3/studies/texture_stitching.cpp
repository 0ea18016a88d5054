// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// How well are colors of several scans stitched, as in the paper's section 5.2 and figure 1?
//
// Scans of a colored mesh are made by cameras around it, whose exposures differ by a factor of up
// to 1 + R (--range). With --lamp L, the part L of the light comes from a lamp beside each camera,
// so that shading differs too. Then the colors of the mesh are recovered from them.
//
// nearest: the color of the scan that is nearest to each vertex. chosen: that of the scan that is
// chosen for it. paper: gradients of the chosen scans, integrated by the finite elements alone.
// Others have one or more of: matched exposures (exp), gradients of the colors that scans give to
// the vertices (bp), details at the vertices (det); all three are the default of the package.
//
// rms is that of the error over the vertices that a scan covers, weighted by area, and over the
// components, after one gain for all was fitted. contrast of seams is the mean step of the colors
// along edges across which the scan changes, minus that of the truth; times is that of `nearest`
// over that of this method. Seconds are those of all that stitching does, from the surface to the
// colors, with the spline space but without reading and making scans.
//
// usage: texture_stitching [OPTION]... [MESH]...

#include "../../programs/support/color_error.h"
#include "../../programs/support/color_pattern.h"
#include "../../programs/support/mesh_input.h"
#include "../../programs/support/mesh_output.h"
#include "../../programs/support/vertex_data.h"
#include "../../programs/support/virtual_scanner.h"
#include "support/driver.h"
#include "support/measure.h"
#include "support/meshes.h"
#include "support/package.h"

#include <CGAL/Restricted_laplacian_3/stitch_colors.h>
#include <CGAL/Restricted_laplacian_3/textures/Colored_scan.h>

#include <CGAL/Real_timer.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace RL = CGAL::Restricted_laplacian_3;
using namespace benchmarks;
using programs::Color;

namespace {

struct Options {
  std::vector<std::string> meshes = {"head_male_color_18k", "spot_color_5k8", "bunny_closed_70k"};
  std::vector<int> depths = {8};
  std::vector<double> lamps = {0, 0.5}, alphas;
  int views = 8, resolution = 1024, threads = 2;
  double range = 0.3, tint = 0;
  std::vector<std::string> methods = {"paper", "paper+exp", "bp", "bp+exp", "bp+exp+det"};
  std::string meshes_folder;
};

struct Mesh {
  std::string name;
  RL::Triangulated_surface_3 surface;
  std::vector<Color> colors;
};

Mesh read(const std::string& name, const std::string& path) {
  RL::Triangulated_surface_3 surface = programs::read_mesh(path).surface;
  std::vector<Color> colors =
      programs::has_colors(path) ? programs::read_colors(path) : programs::color_pattern(surface);
  return {std::filesystem::path(name).stem(), std::move(surface), std::move(colors)};
}

std::vector<RL::Colored_scan> bake(const Mesh& mesh, const Options& o, double lamp) {
  const programs::Virtual_scanner scanner(mesh.surface, mesh.colors);
  const auto cameras = programs::cameras_around(mesh.surface, o.views, CGAL_PI / 6, o.resolution);
  programs::Random random(0);
  const std::vector<double> exposures = programs::spread_exposures(o.views, o.range, random);
  const auto lightings = programs::make_lightings(exposures, o.tint, lamp, random);
  std::vector<RL::Colored_scan> scans;
  for(std::size_t i = 0; i < cameras.size(); ++i) {
    programs::Virtual_scan scan = scanner.scan(cameras[i], lightings[i], false, 0, i);
    scans.emplace_back(scan.surface, std::move(scan.colors), cameras[i].to_world,
                       RL::Point_3(0, 0, 0), o.threads > 1);
  }
  return scans;
}

bool has(const std::string& method, const std::string& part) {
  return method.find(part) != std::string::npos;
}

RL::Color_stitching_options options_of(const std::string& method, const Options& o) {
  RL::Color_stitching_options options;
  options.gradients =
      has(method, "bp") ? RL::Gradient_source::back_projection : RL::Gradient_source::scans;
  options.match_exposures = has(method, "exp");
  options.details = has(method, "det");
  options.solver.is_parallel = o.threads > 1;
  return options;
}

struct Row {
  std::string method;
  double alpha = 0, seconds = 0, nearest_contrast = 0;
  programs::Color_error error;
  RL::Stitched_colors report;
};

void print(const Mesh& mesh, const Options& o, double lamp, const RL::Spline_space_3& space,
           const Row& row) {
  std::printf(
      "%-20s %5d %5d %5.2f %-14s %8.0e %8zu %7.4f %7.4f %8.4f %8.4f %7.1f %6.3f %5d %7.2f\n",
      mesh.name.c_str(), space.depth(), o.views, lamp, row.method.c_str(), row.alpha,
      space.dimension(), row.error.gain, row.error.root_mean_square, row.error.seam_contrast(),
      row.error.true_jump, row.nearest_contrast / std::abs(row.error.seam_contrast()),
      row.report.uncovered_area, row.report.iterations, row.seconds);
  std::fflush(stdout);
}

void write(const Mesh& mesh, const Options& o, double lamp, int depth, const std::string& method,
           const std::vector<Color>& colors) {
  if(o.meshes_folder.empty())
    return;
  char file[512];
  std::snprintf(file, sizeof file, "%s/%s_d%d_lamp%g_%s.ply", o.meshes_folder.c_str(),
                mesh.name.c_str(), depth, lamp, method.c_str());
  programs::write_mesh(file, mesh.surface, colors);
}

void run(const Mesh& mesh, const Options& o, double lamp, int depth) {
  const std::vector<RL::Colored_scan> scans = bake(mesh, o, lamp);
  CGAL::Real_timer timer;
  timer.start();
  const RL::Spline_space_3 space(mesh.surface, space_options(depth, true, o.threads));
  const double space_seconds = timer.time();
  double nearest_contrast = 0;
  write(mesh, o, lamp, depth, "truth", mesh.colors);
  for(const std::string& method : o.methods)
    for(const double alpha :
        o.alphas.empty() ? std::vector<double>{RL::Color_stitcher::default_screening} : o.alphas) {
      RL::Color_stitching_options options = options_of(method, o);
      options.alpha = alpha / mesh.surface.area();
      timer.reset();
      RL::Color_stitcher stitcher(space, options);
      for(const RL::Colored_scan& scan : scans)
        stitcher.add(scan);
      stitcher.choose();
      Row row;
      if(nearest_contrast == 0) {
        for(const char* simple : {"nearest", "chosen"}) {
          row.method = simple;
          row.seconds = timer.time();
          const RL::Vertex_colors found =
              row.method == "nearest" ? stitcher.nearest_colors() : stitcher.chosen_colors();
          row.error = programs::color_error(mesh.surface, found, mesh.colors);
          if(nearest_contrast == 0)
            nearest_contrast = row.error.seam_contrast();
          row.nearest_contrast = nearest_contrast;
          print(mesh, o, lamp, space, row);
          write(mesh, o, lamp, depth, simple, found.colors);
        }
        timer.reset(); // about the same again, without what was measured
        RL::Color_stitcher again(space, options);
        for(const RL::Colored_scan& scan : scans)
          again.add(scan);
        again.choose();
      }
      row.method = method;
      row.alpha = alpha;
      row.report = stitcher.stitch();
      row.seconds = space_seconds + timer.time();
      const RL::Vertex_colors found = {row.report.colors, stitcher.scans_of_vertices()};
      row.error = programs::color_error(mesh.surface, found, mesh.colors);
      row.nearest_contrast = nearest_contrast;
      print(mesh, o, lamp, space, row);
      write(mesh, o, lamp, depth, method, found.colors);
    }
}

bool read_options(int argc, char* argv[], Options& o) {
  Command_line line("usage: texture_stitching [OPTION]... [MESH]...");
  line.add("mesh", o.meshes,
           "files, or names in the folder of shared meshes; those without colors get a pattern");
  line.add("depth", o.depths, "8");
  line.add("lamp", o.lamps, "parts of the light; 0 0.5");
  line.add("method", o.methods, "paper paper+exp bp bp+exp bp+exp+det");
  line.add("alpha", o.alphas, "in units of 1 / area; the default of the package");
  line.add("views", o.views);
  line.add("resolution", o.resolution);
  line.add("range", o.range, "of exposures");
  line.add("tint", o.tint, "of white balance");
  line.add("threads", o.threads);
  line.add("write", o.meshes_folder, "folder for colored meshes, which has to exist");
  line.add_positional("mesh");
  return line.read(argc, argv);
}

} // namespace

int main(int argc, char* argv[]) {
  return run_benchmark("texture_stitching", [&] {
    Options o;
    if(!read_options(argc, argv, o))
      return;
    [[maybe_unused]] const auto limited = limit_threads(o.threads);
    print_header(argc, argv);
    std::printf("# exposures differ by the factor %g, white balance by %g; pictures of %d x %d; %d "
                "threads; seconds of one run\n",
                1 + o.range, 1 + o.tint, o.resolution, o.resolution, o.threads);
    std::printf("# %-18s %5s %5s %5s %-14s %8s %8s %7s %7s %8s %8s %7s %6s %5s %7s\n", "mesh",
                "depth", "views", "lamp", "method", "A", "unknowns", "gain", "rms", "contrast",
                "truejump", "times", "uncov", "iter", "seconds");
    for(const std::string& name : o.meshes) {
      const std::string path = find_path(name);
      if(path.empty())
        continue;
      const Mesh mesh = read(name, path);
      for(const int depth : o.depths)
        for(const double lamp : o.lamps)
          run(mesh, o, lamp, depth);
      std::printf("\n\n");
    }
  });
}
