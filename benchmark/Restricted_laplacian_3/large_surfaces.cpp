// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// How do time and memory grow with the number of triangles, from the file to the result?
//
//   large_surfaces MESH N... [--depth D...] [--threads T] [--pairs K] [--format ply|stl]
//                  [--folder FOLDER]
//
// Divides the triangles of MESH into N^2 each (as refine_mesh does), writes a file into FOLDER (by
// default that for temporary files), and solves a Poisson problem with the coordinate x at the
// vertices as right-hand side, whose solution is evaluated at the vertices; with --pairs K finds K
// eigenvalues instead. Each in a process of its own.
//
// Columns: seconds to read the file (read_s), for normals, areas, octree and numbering (space_s),
// for matrices and load (assembly_s), for the hierarchy and the iteration (solve_s), for values at
// the vertices (values_s), and of all; the largest memory in GB, and what estimate_memory() says;
// unknowns; the root mean square of the values, or the sum of the squares of the eigenvalues, a
// check that all problems are the same.

#include "../../programs/support/program.h"
#include "support/driver.h"
#include "support/measure.h"
#include "support/meshes.h"
#include "support/refined_mesh.h"

#include <CGAL/Restricted_laplacian_3/files/read_mesh_file.h>
#include <CGAL/Restricted_laplacian_3/problems/space_spectrum.h>
#include <CGAL/Restricted_laplacian_3/solve_poisson.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_function_3.h>
#include <CGAL/Restricted_laplacian_3/splines/estimate_memory.h>
#include <CGAL/Restricted_laplacian_3/surface/surface_functions.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

using namespace benchmarks;

namespace {

struct Run {
  std::string file;
  int depth, threads, pairs;
};

struct Record {
  double triangles, unknowns, read, space, assembly, solve, values, all, estimate, check;
};

std::vector<Record> measure(const Run& run) {
  programs::keep_memory();
#ifdef CGAL_LINKED_WITH_TBB
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  static_cast<std::size_t>(run.threads));
#endif
  Record r = {};
  const double start = seconds_now();
  double last = start;
  const auto lap = [&last] {
    const double now = seconds_now();
    return now - std::exchange(last, now);
  };
  RL::Mesh_file mesh = RL::read_mesh_file(run.file);
  r.read = lap();
  RL::Triangulated_surface_3 surface(std::move(mesh.points), std::move(mesh.triangles));
  r.triangles = static_cast<double>(surface.number_of_faces());
  r.estimate = 1e-9 * RL::estimate_memory(surface, run.depth).total();
  RL::Spline_space_options options;
  options.depth = run.depth;
  options.is_parallel = run.threads > 1;
  const RL::Spline_space_3 space(std::move(surface), options);
  r.unknowns = static_cast<double>(space.dimension());
  r.space = lap();
  if(run.pairs > 0) {
    // without values at the vertices
    RL::Laplace_spectrum_options of_spectrum;
    of_spectrum.eigenvalues_only = true;
    const RL::Laplace_spectrum spectrum = RL::laplace_eigenpairs(space, run.pairs, of_spectrum);
    r.assembly = spectrum.report.assembly_seconds;
    r.solve = lap() - r.assembly;
    r.check = spectrum.eigenvalues.squaredNorm();
  } else {
    std::vector<double> x(space.surface().number_of_vertices());
    for(std::size_t v = 0; v < x.size(); ++v)
      x[v] = space.surface().point(v).x();
    const RL::Poisson_solution solution =
        RL::solve_poisson(space, RL::Linear_surface_function<double>(std::move(x)));
    r.solve = solution.setup_seconds + solution.solve_seconds;
    r.assembly = lap() - r.solve;
    const std::vector<double> u =
        RL::Spline_function_3(space, solution.coefficients).values_at_vertices();
    r.values = lap();
    double sum = 0, count = 0;
    for(const double value : u)
      if(!std::isnan(value)) { // as it is at vertices without a face of positive area
        sum += value * value;
        ++count;
      }
    r.check = std::sqrt(sum / count);
  }
  r.all = seconds_now() - start;
  return {r};
}

} // namespace

int main(int argc, char* argv[]) {
  return run_benchmark("large_surfaces", [&] {
    std::vector<int> depths = {9}, divisions;
    int threads = 2, pairs = 0;
    std::string format = "ply", folder = std::filesystem::temp_directory_path().string(), mesh;
    Command_line line("usage: large_surfaces [OPTION]... MESH DIVISIONS...");
    line.add("depth", depths);
    line.add("threads", threads);
    line.add("pairs", pairs);
    line.add("format", format);
    line.add("folder", folder);
    line.add("mesh", mesh);
    line.add("divisions", divisions);
    line.add_positional("mesh", 1);
    line.add_positional("divisions");
    if(!line.read(argc, argv))
      return 0;
    line.require("mesh");
    line.require("divisions");

    const auto flat = find_mesh(mesh);
    if(!flat)
      return 1;
    print_header(argc, argv);
    std::printf("# threads: %d, %s\n", threads,
                pairs > 0 ? (std::to_string(pairs) + " eigenvalues").c_str() : "Poisson problem");
    std::printf("# triangles depth  read_s space_s assembly_s solve_s values_s    all_s memory_gb "
                "estimate_gb unknowns        check\n");
    for(const int n : divisions) {
      const std::string file =
          (std::filesystem::path(folder) / ("large_surface." + format)).string();
      {
        const RL::Triangulated_surface_3 surface = RL::curved_surface(*flat);
        write_refined_mesh(Refined_mesh(surface, static_cast<std::uint32_t>(n)), file);
      }
      for(const int depth : depths) {
        double mib = 0;
        const Run run = {file, depth, threads, pairs};
        const auto records = in_child_process<Record>(3600, mib, [&] { return measure(run); });
        for(const Record& r : records)
          std::printf("%11.0f %5d %7.1f %7.1f %10.1f %7.1f %8.1f %8.1f %9.2f %11.2f %8.0f %12.6g\n",
                      r.triangles, depth, r.read, r.space, r.assembly, r.solve, r.values, r.all,
                      mib * 1048576e-9, r.estimate, r.unknowns, r.check);
        std::fflush(stdout);
      }
      std::filesystem::remove(file);
    }
    return 0;
  });
}
