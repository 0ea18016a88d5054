// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Computes distances along a mesh from some of its vertices or its boundary.

#include "support/color_map.h"
#include "support/command_line.h"
#include "support/point_input.h"
#include "support/program.h"
#include "support/space.h"
#include "support/surface_program.h"
#include "support/table.h"

#include <CGAL/Restricted_laplacian_3/geodesics/Geodesic_function.h>
#include <CGAL/Restricted_laplacian_3/geodesics/Geodesic_solver.h>
#include <CGAL/Restricted_laplacian_3/problems/Geodesic_fitter.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

using namespace programs;

const Help help = {"geodesic_distance MESH [OPTION]...",
                   std::string(R"(
Computes the distances of the vertices of a surface from sources, along the surface, and
which source is the nearest.

Distances are infinite at vertices that no source reaches. With --refine they are those of
a spline between the vertices.
)") + about_meshes +
                       R"(
In place of a mesh, a file .xyz with lines of six numbers, x y z nx ny nz, or a PLY file
without faces but with the properties nx, ny, nz of its vertices, is a set of points with
normals, oriented alike. Triangles are made of them by CGAL's advancing front.
)",
                   R"(  geodesic_distance elephant.off --source 0 --output distance.ply
      a mesh colored by the distance from its first vertex; draw_mesh draws isolines
  geodesic_distance elephant.off --farthest 8 --show nearest --output regions.ply
      eight vertices far from each other, and the regions that are nearest to each
  geodesic_distance elephant-with-holes.off --boundary --csv distance.csv
      a table of the distances from the boundary
  geodesic_distance elephant.off --source 0 --maximum-distance 0.2 --csv near.csv
      distances up to a fifth of the unit; what is farther away takes no time
  geodesic_distance elephant.off --source 0 --path 1000 2000 --isolines 10 --lines lines.obj
      the shortest paths from two vertices to the first one, and ten isolines, as lines
)",
                   R"(  0  all went well
  1  an error, which one line on the error stream names
)"};

struct Options : Common_options, Point_options {
  std::vector<std::size_t> sources, paths;
  bool boundary = false, exact = false;
  std::size_t farthest = 0, isolines = 0;
  std::string show = "distance", lines, zero_property;
  std::optional<double> maximum_distance;
};

// returns false if there is nothing more to do
bool read_options(int argc, char* argv[], Options& o, po::variables_map& given) {
  std::vector<long long> sources, paths;
  long long farthest = 0, isolines = 0;
  po::options_description problem("Problem", help_width);
  auto add = problem.add_options();
  add("source", po::value(&sources)->multitoken()->value_name("V..."),
      "numbers of vertices, counted from 0");
  add("boundary", po::bool_switch(&o.boundary), "edges with one face only are sources, too");
  add("farthest", po::value(&farthest)->value_name("N"),
      "N more sources: each is the vertex that is farthest from those before; the first one is the "
      "first vertex with a face, if there is no other source");
  add("zero-property", po::value(&o.zero_property)->value_name("NAME"),
      "in place of sources: where a vertex property of MESH, a PLY file, is 0; distances are "
      "negative where it is negative");
  add("maximum-distance",
      po::value<double>()->value_name("L")->notifier([&o](double l) { o.maximum_distance = l; }),
      "distances beyond are infinite, and take no time");
  add("joining-tolerance", po::value(&o.space.joining_tolerance)->value_name("T"),
      "--join for short: vertices on the boundary are one with those at a distance of T or less, "
      "in the unit of the "
      "coordinates, and faces are divided where such a vertex lies on a side");
  add("exact", po::bool_switch(&o.exact),
      "exact up to rounding, in more time; by default errors are of the order of 0.01 %");
  add("maximum-memory", po::value(&o.space.maximum_gigabytes)->value_name("GB"),
      "end if windows of rays would take more memory; by default that of the machine");
  po::options_description lines("Lines", help_width);
  add = lines.add_options();
  add("path", po::value(&paths)->multitoken()->value_name("V..."),
      "numbers of vertices from which the shortest paths to a source begin");
  add("isolines", po::value(&isolines)->value_name("N"),
      "N isolines, at equal distances from each other");
  add("lines", po::value(&o.lines)->value_name("FILE"), "write these, as lines of OBJ (.obj)");
  po::options_description colors("Colors", help_width);
  add = colors.add_options();
  add("show", po::value(&o.show)->value_name("distance|nearest")->default_value(o.show),
      "what colors show");
  po::options_description all(help_width);
  po::options_description output =
      spline_output_options(o, "vertex, distance, nearest", "the properties distance and nearest");
  add = output.add_options();
  add("depth", po::value<int>()->value_name("D")->notifier([&o](int d) { o.space.depth = d; }),
      "depth of the octree of the spline, for --refine (default: that of the other programs)");
  all.add(problem)
      .add(point_options(o, o))
      .add(lines)
      .add(colors)
      .add(output)
      .add(general_options(o));
  if(!parse_command_line(argc, argv, help, all, o, given))
    return false;
  o.sources = not_negative("source", sources);
  o.paths = not_negative("path", paths);
  o.farthest = not_negative("farthest", {farthest})[0];
  o.isolines = not_negative("isolines", {isolines})[0];
  require_choice("show", o.show, {"distance", "nearest"});
  require_effect(given, {"show"}, !o.output.empty() || !o.html.empty(), "--output or --html");
  require_effect(given, {"isolines"}, !o.lines.empty() || !o.html.empty(), "--lines or --html");
  const bool has_source = !o.sources.empty() || o.boundary || o.farthest > 0;
  require(has_source || !o.zero_property.empty(),
          "there is no source: give --source, --boundary, --farthest or --zero-property");
  require(o.zero_property.empty() || (!has_source && o.paths.empty() && o.refine == 0 &&
                                      o.isolines == 0 && o.show == "distance"),
          "--zero-property goes with no other source, and without --path, --isolines, --refine and "
          "--show");
  require_not_negative(given, "maximum-distance");
  require(!o.maximum_distance || (o.paths.empty() && o.isolines == 0 && o.refine == 0),
          "--maximum-distance goes without --path, --isolines and --refine");
  require(!o.boundary || o.farthest == 0, "--farthest begins with vertices, not with --boundary");
  require(given.count("depth") == 0 || o.refine > 0, "--depth needs --refine");
  require(o.lines.empty() || !o.paths.empty() || o.isolines > 0,
          "--lines needs --path or --isolines");
  require(o.isolines <= 10000, "the argument of --isolines must not be more than 10000");
  check_output("--lines", o.lines, {".obj"});
  check_input(o.mesh);
  return true;
}

// the colors of values; those that are infinite have none
std::vector<Color> distance_colors(const Eigen::VectorXd& distances) {
  std::vector<double> finite(distances.begin(), distances.end());
  std::replace_if(
      finite.begin(), finite.end(), [](double d) { return std::isinf(d); }, std::nan(""));
  return value_colors(finite);
}

// a color for each source: hues that are far from each other
std::vector<Color> region_colors(const Eigen::VectorXd& nearest) {
  std::vector<Color> colors;
  for(const double label : nearest) {
    Color color = {0.5, 0.5, 0.5};
    for(std::size_t k = 0; label >= 0 && k < 3; ++k)
      color[k] = 0.6 + 0.35 * std::cos(2.399963 * label - 2.0943951 * static_cast<double>(k));
    colors.push_back(color);
  }
  return colors;
}

void write_lines(const std::string& file, const std::vector<RL::Geodesic_path>& lines) {
  write_file(file, [&](std::ostream& out) {
    std::size_t number = 0;
    for(const RL::Geodesic_path& line : lines) {
      for(const RL::Point_3& p : line.points)
        out << "v " << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
      out << 'l';
      for(std::size_t i = 0; i < line.points.size(); ++i)
        out << ' ' << ++number;
      out << '\n';
    }
  });
}

// Adds the lines that the options ask for to what is found.
void add_lines(const Job& job, const Options& o, const RL::Geodesic_solver& solver,
               const RL::Geodesic_function& distance, double largest, Outcome& result) {
  std::vector<RL::Geodesic_path> lines;
  for(const std::size_t v : o.paths) {
    job.progress.show("finding shortest paths");
    lines.push_back(distance.shortest_path(solver.location(v)));
    job.summary.add("path_length", lines.back().length);
  }
  for(std::size_t i = 1; i <= o.isolines; ++i) {
    job.progress.show("tracing isolines");
    const double value = largest * static_cast<double>(i) / static_cast<double>(o.isolines + 1);
    if(!(value > 0))
      break;
    for(RL::Geodesic_path& line : distance.isolines(value))
      lines.push_back(std::move(line));
  }
  for(const RL::Geodesic_path& line : lines)
    result.page.lines.push_back(line.points);
  if(!o.lines.empty())
    result.write_more = [file = o.lines, lines = std::move(lines)] { write_lines(file, lines); };
}

// Lets distance and nearest source be evaluated between the vertices.
void add_spline(Job& job, const Options& o, const RL::Geodesic_function& distance,
                Outcome& result) {
  if(o.refine == 0)
    return;
  const RL::Spline_space_3 space =
      job.make_space("distances are infinite on those without a source");
  const RL::Geodesic_spline spline =
      RL::Geodesic_fitter(space).fit(distance, job.step("fitting by", space));
  job.add_solve(spline.report());
  result.cell_width = space.octree().cell_width(space.depth());
  result.values_at = [spline](const std::vector<RL::Surface_location>& locations) {
    Eigen::MatrixXd values(static_cast<Eigen::Index>(locations.size()), 2);
    const RL::Geodesic_function& d = spline.function();
    Eigen::Index row = 0;
    for(const RL::Surface_location& l : locations) {
      // the label of the corner that is the largest part
      const auto& b = l.barycentric;
      const std::uint32_t label = d.distances().labels[d.surface().triangle(
          l.face)[static_cast<std::size_t>(std::max_element(b.begin(), b.end()) - b.begin())]];
      values.row(row++) << spline.value(l),
          label == RL::Geodesic_distances::no_label ? -1 : static_cast<double>(label);
    }
    return values;
  };
}

Outcome measure(Job& job, const Options& o) {
  job.progress.show("setting up rays");
  std::optional<double> joining_tolerance;
  if(o.space.joining_tolerance >= 0)
    joining_tolerance = o.space.joining_tolerance;
  const RL::Geodesic_solver solver(job.surface, joining_tolerance);
  const double setup_seconds = job.seconds();
  RL::Geodesic_options options;
  options.method = o.exact ? RL::Geodesic_method::exact : RL::Geodesic_method::fast;
  if(o.space.maximum_gigabytes > 0)
    options.maximum_memory = 1e9 * o.space.maximum_gigabytes;
  RL::Geodesic_sources sources;
  std::vector<std::size_t> all = o.sources;
  for(std::size_t v : o.sources)
    sources.add_vertex(v);
  if(o.farthest > 0) {
    options.progress = job.progress.step("choosing vertices far from each other");
    for(std::size_t v : solver.farthest_points(o.farthest, sources, options))
      all.push_back(v);
  }
  sources = {};
  for(std::size_t i = 0; i < all.size(); ++i)
    sources.add_vertex(all[i], static_cast<std::uint32_t>(i));
  if(o.boundary)
    sources.add_boundary(static_cast<std::uint32_t>(all.size()));
  options.progress = job.progress.step("propagating distances");
  const double begin = job.seconds();
  options.maximum_distance = o.maximum_distance;
  const RL::Geodesic_distances found =
      o.zero_property.empty()
          ? solver.distances(sources, options)
          : solver.signed_distances(surface_property(job.surface, o, o.zero_property), options);
  job.summary.add_detail("rays_seconds", setup_seconds);
  job.summary.add_detail("query_seconds", job.seconds() - begin);

  Outcome result;
  result.names = {"distance", "nearest"};
  result.values.resize(static_cast<Eigen::Index>(found.distances.size()), 2);
  double largest = 0;
  for(std::size_t v = 0; v < found.distances.size(); ++v) {
    const bool is_reached = found.labels[v] != RL::Geodesic_distances::no_label;
    result.values.row(static_cast<Eigen::Index>(v)) << found.distances[v],
        is_reached ? static_cast<double>(found.labels[v]) : -1;
    if(is_reached)
      largest = (std::max)(largest, std::abs(found.distances[v]));
  }
  job.summary.add("largest_distance", largest);
  job.summary.add("unreached_vertices", found.number_of_unreached_vertices);
  result.paint = [show = o.show](const Eigen::MatrixXd& values) {
    return show == "nearest" ? region_colors(values.col(1)) : distance_colors(values.col(0));
  };
  const RL::Geodesic_function distance(solver, found);
  result.page.isolines = o.isolines > 0 ? 0 : 20;
  result.page.first = o.show == "nearest" ? 1 : 0;
  add_lines(job, o, solver, distance, largest, result);
  add_spline(job, o, distance, result);
  if(o.farthest > 0)
    result.print = [all](std::ostream& out) {
      out << "sources\n";
      for(std::size_t v : all)
        out << v << '\n';
    };
  return result;
}

int main(int argc, char* argv[]) {
  return run_surface_program("geodesic_distance", argc, argv, read_options, measure);
}
