// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Colors a mesh from several colored scans, without visible seams.

#include "support/color_error.h"
#include "support/command_line.h"
#include "support/poses.h"
#include "support/program.h"
#include "support/scan_input.h"
#include "support/solver_options.h"
#include "support/surface_program.h"
#include "support/table.h"
#include "support/vertex_data.h"

#include <CGAL/Restricted_laplacian_3/stitch_colors.h>
#include <CGAL/Restricted_laplacian_3/textures/Colored_scan.h>

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iomanip>
#include <iostream>
#include <limits>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

using namespace programs;

const Help help = {
    "stitch_colors MESH SCAN... --poses FILE [OPTION]...", std::string(R"(
Colors the vertices of a mesh from several colored scans, without visible seams.

A SCAN is a PLY file with the vertex properties red, green and blue, a mesh or points, in a
frame of its own with the eye of the camera at the origin. For each triangle of MESH a scan
is chosen that sees it well; the colors are those whose gradients are nearest to those of
the chosen scans. Steps of the exposure or the light between scans vanish. Parts of MESH
that no scan covers are filled smoothly.

FILE of --poses has a line for each scan: the name of its file, and 16 numbers, row by row,
of the matrix that takes its coordinates to those of MESH. Lines that begin with # are
comments.
)") + about_meshes,
    R"(  stitch_colors elephant.off scans/scan_*.ply --poses scans/poses.conf --depth 6 \
    --output colored.ply
      colors from the scans that the first example of bake_scans --help makes
  stitch_colors elephant.off scans/scan_*.ply --poses scans/poses.conf --depth 6 \
    --method nearest --truth scans/truth.ply
      the error of a simpler method, for comparison
)"};

struct Options : Common_options, Solver_options {
  Options() : Solver_options(RL::Color_stitcher::default_tolerance) { space.depth = 8; }

  std::vector<std::string> scans;
  std::vector<RL::Scan_pose> scan_poses; // from the scans to MESH
  std::string poses, frame, method = "gradients", gradients = "back-projection", truth;
  double alpha = RL::Color_stitcher::default_screening;
  double maximum_distance = 0; // chosen
  double normal_angle = 60;    // degrees
  bool no_oriented = false, leave_out = false;
  bool no_match_exposures = false, linear_light = false, no_details = false;
};

void read_scan_poses(Options& o) {
  const std::map<std::string, RL::Scan_pose> known_poses = read_poses(o.poses);
  const RL::Scan_pose to_mesh = o.frame.empty() ? RL::Scan_pose(CGAL::IDENTITY)
                                                : pose_of(known_poses, o.frame, o.poses).inverse();
  for(const std::string& scan : o.scans)
    o.scan_poses.push_back(to_mesh * pose_of(known_poses, scan, o.poses));
}

// returns false if there is nothing more to do
bool read_options(int argc, char* argv[], Options& o, po::variables_map& given) {
  po::options_description problem("Problem", help_width);
  auto add = problem.add_options();
  add("poses", po::value(&o.poses)->value_name("FILE"), "where the scans were taken from");
  add("frame", po::value(&o.frame)->value_name("NAME"),
      "MESH is in the coordinates of the scan of this name in --poses; by default it is in those "
      "of the world");
  add("method", po::value(&o.method)->value_name("METHOD")->default_value(o.method),
      "gradients: as above; for comparison, chosen: the colors of the chosen scans as they are; "
      "nearest: those of the scan that is nearest to each vertex");
  add("gradients", po::value(&o.gradients)->value_name("KIND")->default_value(o.gradients),
      "back-projection: gradients of the colors that a scan gives to the vertices; scans: its own "
      "gradients there");
  add("alpha", po::value(&o.alpha)->value_name("A")->default_value(o.alpha),
      "how strongly the result is drawn to the colors of the chosen scans, in units of 1 / area");
  add("maximum-distance", po::value(&o.maximum_distance)->value_name("D"),
      "of a vertex to a scan that covers it, in the unit of the coordinates; by default it follows "
      "from the distances of points");
  add("normal-angle", po::value(&o.normal_angle)->value_name("A")->default_value(o.normal_angle),
      "largest angle in degrees between the normals of MESH and of a scan that covers it, up to "
      "180; "
      "more than the default for noisy scans");
  add("no-oriented", po::bool_switch(&o.no_oriented),
      "the normals of MESH need not point to the side from which it is seen");
  add("leave-out", po::bool_switch(&o.leave_out),
      "leave out scans that cover no vertex; by default that is an error");
  add("no-match-exposures", po::bool_switch(&o.no_match_exposures),
      "do not multiply the colors of each scan by factors that make overlapping scans agree");
  add("linear-light", po::bool_switch(&o.linear_light),
      "colors are sRGB: stitch them in linear light");
  add("no-details", po::bool_switch(&o.no_details),
      "do not add at the vertices what the finite elements do not resolve");
  add("truth", po::value(&o.truth)->value_name("FILE"),
      "a PLY file with the vertices of MESH and their true colors: errors are printed");
  po::options_description all(help_width);
  all.add(problem)
      .add(space_options(o))
      .add(solver_options(o, "default 0.001, or 0 with --paper"))
      .add(output_options(o, "vertex, red, green, blue",
                          "the property scan, the number of the chosen scan"))
      .add(general_options(o));

  if(!parse_command_line(argc, argv, help, all, o, given, &o.scans))
    return false;
  require(!o.scans.empty(), "no scan is given; --help shows the options");
  require(!o.poses.empty(), "no poses of the scans are given: --poses FILE");
  require_choice("method", o.method, {"gradients", "chosen", "nearest"});
  require_choice("gradients", o.gradients, {"back-projection", "scans"});
  require_effect(
      given, {"gradients", "alpha", "no-details", "tolerance", "energy-tolerance", "stabilization"},
      o.method == "gradients", "--method gradients");
  require_positive(given, "alpha", o.alpha);
  require_positive(given, "maximum-distance", o.maximum_distance);
  require(o.normal_angle > 0 && o.normal_angle <= 180,
          "the argument of --normal-angle must be in (0, 180]");
  check_solver_options(o, given);
  read_scan_poses(o);
  return true;
}

auto stitching_parameters(const Options& o, double area) {
  std::optional<double> maximum_distance;
  if(o.maximum_distance > 0)
    maximum_distance = o.maximum_distance;
  return solver_parameters(o)
      .maximum_distance(maximum_distance)
      .normal_angle(o.normal_angle)
      .oriented(!o.no_oriented)
      .gradients(o.gradients == "scans" ? RL::Gradient_source::scans
                                        : RL::Gradient_source::back_projection)
      .match_exposures(!o.no_match_exposures)
      .linear_light(o.linear_light)
      .alpha(o.alpha / area)
      .details(!o.no_details);
}

// why a scan covers no vertex
std::string reason(const RL::Scan_usage& usage) {
  std::ostringstream text;
  if(!std::isfinite(usage.smallest_distance))
    text << "no vertex is near";
  else if(usage.smallest_distance > usage.maximum_distance)
    text << "it comes as near as " << usage.smallest_distance << " to a vertex, and only "
         << usage.maximum_distance << " is near enough; is its pose right?";
  else
    text
        << "where it is near, the mesh shows its back or differs in its normals; see --no-oriented "
           "and --normal-angle, or --leave-out";
  return text.str();
}

void add_scans(RL::Color_stitcher& stitcher, const Options& o, const Progress& progress) {
  for(std::size_t i = 0; i < o.scans.size(); ++i) {
    progress.show("scan " + std::to_string(i + 1) + " of " + std::to_string(o.scans.size()) + ": " +
                  o.scans[i]);
    const RL::Scan_usage usage =
        stitcher.add(read_scan(o.scans[i], o.scan_poses[i], o.threads != 1));
    require(usage.covered_vertices > 0 || o.leave_out,
            "'" + o.scans[i] + "' misses the mesh: " + reason(usage));
  }
}

void print_scans(std::ostream& out, const Options& o, const std::vector<RL::Scan_usage>& usages) {
  std::ostringstream lines;
  lines << "scan   covered    chosen      factors of red, green, blue\n" << std::fixed;
  for(std::size_t i = 0; i < usages.size(); ++i) {
    lines << std::left << std::setw(4) << i << std::right << std::setprecision(1) << std::setw(8)
          << 100 * usages[i].covered_area << " %" << std::setw(8) << 100 * usages[i].chosen_area
          << " %" << std::setprecision(3) << "    ";
    for(const double gain : usages[i].gains)
      lines << std::setw(7) << gain;
    lines << "    " << o.scans[i] << '\n';
  }
  out << lines.str();
}

void add_stitching(Job& job, const RL::Stitched_colors& stitched) {
  Summary& summary = job.summary;
  summary.add_detail("back_projection_seconds", stitched.back_projection_seconds);
  summary.add_detail("choice_seconds", stitched.choice_seconds);
  job.add_solve(stitched);
  summary.add("uncovered_area", stitched.uncovered_area);
  summary.add("uncovered_vertices", stitched.uncovered_vertices);
  summary.add("seam_length", stitched.seam_length);
  summary.add("jump_before", stitched.jump_before);
  summary.add("jump_after", stitched.jump_after);
  summary.add("clamped_values", stitched.clamped_values);
}

void add_error(Summary& summary, const RL::Triangulated_surface_3& surface,
               const RL::Vertex_colors& found, const std::vector<Color>& truth) {
  const Color_error error = color_error(surface, found, truth);
  summary.add("gain", error.gain);
  summary.add("rms_error", error.root_mean_square);
  summary.add("jump", error.jump);
  summary.add("true_jump", error.true_jump);
}

Outcome stitch(Job& job, const Options& o) {
  const RL::Triangulated_surface_3& surface = job.surface;
  std::vector<Color> truth;
  if(!o.truth.empty())
    truth = read_colors(o.truth);
  require(o.truth.empty() || truth.size() == surface.number_of_vertices(),
          "'" + o.truth + "' has another number of vertices than the mesh");
  const RL::Spline_space_3 space = job.make_space("each component is stitched on its own");

  RL::Color_stitcher stitcher(space, stitching_parameters(o, surface.area()));
  add_scans(stitcher, o, job.progress);
  job.progress.show("choosing a scan for each triangle");
  stitcher.choose();
  RL::Vertex_colors found =
      o.method == "nearest" ? stitcher.nearest_colors() : stitcher.chosen_colors();
  if(o.method == "gradients") {
    RL::Stitched_colors stitched = stitcher.stitch(job.step("stitching with", space));
    found.colors = std::move(stitched.colors);
    add_stitching(job, stitched);
  }
  if(!truth.empty())
    add_error(job.summary, surface, found, truth);

  Outcome result;
  result.names = {"scan"};
  result.values.resize(static_cast<Eigen::Index>(found.scans.size()), 1);
  for(std::size_t v = 0; v < found.scans.size(); ++v)
    result.values(static_cast<Eigen::Index>(v), 0) =
        found.scans[v] == RL::no_scan ? -1. : static_cast<double>(found.scans[v]);
  Eigen::MatrixXd table(static_cast<Eigen::Index>(found.colors.size()), 3);
  for(std::size_t v = 0; v < found.colors.size(); ++v)
    for(std::size_t k = 0; k < 3; ++k)
      table(static_cast<Eigen::Index>(v), static_cast<Eigen::Index>(k)) = found.colors[v][k];
  result.page.colors = found.colors;
  result.paint = [colors = std::move(found.colors)](const Eigen::MatrixXd&) { return colors; };
  result.write_table = [table](const std::string& file, const Summary& lines) {
    write_csv(file, lines, "vertex", {"red", "green", "blue"}, table);
  };
  const std::vector<RL::Scan_usage> usages = stitcher.usages();
  result.print = [usages, &o](std::ostream& out) { print_scans(out, o, usages); };
  return result;
}

int main(int argc, char* argv[]) {
  return run_surface_program("stitch_colors", argc, argv, read_options, stitch);
}
