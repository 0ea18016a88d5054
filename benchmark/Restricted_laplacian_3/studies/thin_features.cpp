// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// What does splitting of elements do for surfaces with thin parts? The first 40 non-zero
// eigenvalues of meshes with blades, spokes and plates, by the unsplit and by the split space,
// against a reference that is itself converged. There are two candidates: the split space at depth
// 8, and the cotangent operator on the mesh after midpoint refinements, extrapolated from the last
// two. The latter counts if the last two agree within 1 %; on meshes with needle triangles they do
// not. Both are Galerkin methods, so before extrapolation all their eigenvalues are too large, and
// of two the smaller one is closer.
//
// With --gaps: surfaces with near layers whose spectrum is known exactly, because they are
// isometric to a rectangle or to a tube.
//
// Prints tables that gnuplot reads, progress on the error stream. Meant to be built with CHOLMOD.
//
// usage: thin_features [--values] [MESH...]
//        thin_features --gaps
// --values also prints the eigenvalues

#include "support/measure.h"
#include "support/meshes.h"
#include "support/spectra.h"

#include <CGAL/Restricted_laplacian_3/input/read_surface.h>

#include <CGAL/Surface_mesh.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

namespace RL = CGAL::Restricted_laplacian_3;
using namespace benchmarks;

namespace {

constexpr double pi = 3.14159265358979323846;

void run_mesh(const std::string& name, const RL::Triangulated_surface_3& surface,
              bool prints_values) {
  constexpr int count = 40;
  constexpr std::size_t largest_reference = 420000;
  constexpr double cotangent_tolerance = 1; // percent
  std::fprintf(stderr, "%s\n", name.c_str());
  std::printf("# %s: %zu vertices, %zu triangles\n", name.c_str(), surface.number_of_vertices(),
              surface.number_of_faces());

  int depth = 8, kernel;
  {
    const RL::Spline_space_3 space = space_of(surface, Space::split, depth);
    kernel = static_cast<int>(space.octree().number_of_sheets(0));
    if(space.dimension() > largest_reference) {
      std::printf("# depth 8 has %zu unknowns, too many here\n", space.dimension());
      depth = 7;
    }
  }
  const Spectrum finest = restricted_spectrum(surface, Space::split, depth, kernel, count);
  const Cotangent_reference cotangent(surface, kernel, count);

  bool cotangent_counts = false;
  if(cotangent.refinements == 0)
    std::printf("# the mesh is too large to be refined\n");
  else {
    const Difference change(cotangent.fine.values, cotangent.coarse.values),
        difference(cotangent.extrapolated, finest.values);
    cotangent_counts = cotangent.counts(cotangent_tolerance);
    std::printf("# cotangent operator, %d and %d refinements, %zu and %zu unknowns: differ by at "
                "most %.3g %%, mean %.3g %%%s\n",
                cotangent.refinements - 1, cotangent.refinements, cotangent.coarse.unknowns,
                cotangent.fine.unknowns, change.largest, change.mean,
                cotangent_counts ? "" : ": it does not count as a reference");
    std::printf("# extrapolated, it differs from the split space at depth %d by at most %.3g %%, "
                "mean %.3g %%\n",
                depth, difference.largest, difference.mean);
    const auto above = (cotangent.fine.values - finest.values).array() / finest.values.array();
    std::printf("# before extrapolation, of two upper bounds: that of the split space is smaller "
                "for %d of %d eigenvalues, by up to %.3g %%, else larger by up to %.3g %%\n",
                static_cast<int>((above > 0).count()), count,
                100 * (std::max)(above.maxCoeff(), 0.), 100 * (std::max)(-above.minCoeff(), 0.));
  }
  const Eigen::VectorXd& reference = cotangent_counts ? cotangent.extrapolated : finest.values;
  if(cotangent_counts)
    std::printf("# reference: cotangent operator, extrapolated\n");
  else
    std::printf("# reference: split space at depth %d\n", depth);
  if(prints_values) {
    if(cotangent.refinements > 0) {
      print_values("cotangent, one refinement less", cotangent.coarse.values);
      print_values("cotangent, refined", cotangent.fine.values);
      print_values("cotangent, extrapolated", cotangent.extrapolated);
    }
    print_values("split, finest", finest.values);
  }

  std::printf("# %-6s %5s %9s %11s %10s %7s %10s %8s %8s\n", "space", "depth", "unknowns",
              "sheets/cell", "largest_%", "number", "mean_%", "assem_s", "eigen_s");
  const auto print = [&](Space space, int d, const Spectrum& spectrum) {
    const Difference difference(spectrum.values, reference);
    std::printf("%-8s %5d %9zu %11.3f %10.3f %7d %10.3f %8.1f %8.1f%s\n", name_of(space), d,
                spectrum.unknowns, spectrum.sheets_per_cell, difference.largest,
                static_cast<int>(difference.position) + 1, difference.mean,
                spectrum.assembly_seconds, spectrum.eigenvalue_seconds,
                cotangent_counts || d < depth ? ""
                : space == Space::split       ? " # the reference"
                                              : " # as deep as the reference");
    if(prints_values)
      print_values("values", spectrum.values);
    std::fflush(stdout);
  };
  for(Space space : {Space::unsplit, Space::split})
    for(int d = 5; d <= 7; ++d)
      if(space == Space::unsplit || d < depth)
        print(space, d, restricted_spectrum(surface, space, d, kernel, count));
  print(Space::split, depth, finest);
  std::printf("\n\n");
}

int run_meshes(std::vector<std::string> paths, bool prints_values) {
  if(paths.empty()) {
    for(const char* file :
        {"pulley_28k", "turbine_18k", "sword_45k", "wingnut_6k", "cat_16k", "plane_holes_17k"})
      paths.push_back(shared_file(std::string(file) + ".ply"));
    paths.push_back(cgal_file("rotor_small.off"));
  }
  int failures = 0;
  for(const std::string& path : paths) {
    const std::size_t begin = path.find_last_of('/') + 1;
    const std::string name = path.substr(begin, path.find_last_of('.') - begin);
    const auto mesh = read_mesh_file(path);
    if(!mesh) {
      std::printf("# %s: cannot read %s\n\n\n", name.c_str(), path.c_str());
      continue;
    }
    try {
      run_mesh(name, RL::read_surface(*mesh), prints_values);
    } catch(const std::exception& e) {
      std::printf("# %s: %s\n\n\n", name.c_str(), e.what());
      ++failures;
    }
  }
  return failures > 0;
}

// surfaces with near layers

using Profile = std::vector<std::array<double, 2>>;

/// a unit square, both sides of it, with a gap between them
Profile flat_tube(double gap) { return {{0, 0}, {1, 0}, {1, gap}, {0, gap}}; }

/// a band rolled up to two turns, with a gap between them
Profile spiral(double gap) {
  constexpr int n = 160;
  Profile profile;
  for(int i = 0; i <= n; ++i) {
    const double angle = 4 * pi * i / n, r = 0.4 + gap * angle / (2 * pi);
    profile.push_back({r * std::cos(angle), r * std::sin(angle)});
  }
  return profile;
}

double length(const Profile& profile, bool is_closed) {
  double sum = 0;
  for(std::size_t i = is_closed ? 0 : 1; i < profile.size(); ++i) {
    const auto &p = profile[i], &q = profile[i == 0 ? profile.size() - 1 : i - 1];
    sum += std::hypot(p[0] - q[0], p[1] - q[1]);
  }
  return sum;
}

/// swept along z from 0 to 1 and rotated, so that no side is parallel to a wall of the grid
RL::Triangulated_surface_3 swept(const Profile& profile, bool is_closed) {
  const RL::Vector_3 x(0.36, 0.48, -0.8), y(-0.8, 0.6, 0), z(0.48, 0.64, 0.6);
  constexpr std::uint32_t n = 2;
  const auto m = static_cast<std::uint32_t>(profile.size());
  std::vector<RL::Point_3> points;
  std::vector<RL::Triangulated_surface_3::Triangle> triangles;
  for(std::uint32_t j = 0; j <= n; ++j)
    for(const auto& p : profile) {
      const RL::Vector_3 v(p[0], p[1], double(j) / n);
      points.emplace_back(x * v, y * v, z * v);
    }
  for(std::uint32_t j = 0; j < n; ++j)
    for(std::uint32_t i = 0; i + (is_closed ? 0 : 1) < m; ++i) {
      const std::uint32_t a = j * m + i, b = j * m + (i + 1) % m;
      triangles.push_back({a, b, b + m});
      triangles.push_back({a, b + m, a + m});
    }
  return RL::Triangulated_surface_3(std::move(points), std::move(triangles));
}

/// Those of a rectangle of sides `length` and 1, or of a tube of that circumference, with the
/// natural condition at the boundary; times area, without the first, which is 0.
Eigen::VectorXd exact_eigenvalues(double length, bool is_closed, int count) {
  std::vector<double> values;
  for(int m = 0; m < 40; ++m)
    for(int n = 0; n < 40; ++n) {
      const double wave = pi * m / length * (is_closed ? 2 : 1);
      values.insert(values.end(), is_closed && m > 0 ? 2 : 1,
                    (wave * wave + pi * pi * n * n) * length);
    }
  std::sort(values.begin(), values.end());
  return Eigen::Map<const Eigen::VectorXd>(values.data() + 1, count);
}

void run_gap(const char* name, Profile (*profile_of)(double), bool is_closed, int depth,
             int divisor) {
  // The width of the cells depends on the extent, and a little on the gap.
  double h = 0;
  for(int i = 0; i < 5; ++i) {
    const double cube_scale = 1.1;
    h = std::ldexp(cube_scale * swept(profile_of(h / divisor), is_closed).extent(), -depth);
  }
  const Profile profile = profile_of(h / divisor);
  const RL::Triangulated_surface_3 surface = swept(profile, is_closed);
  constexpr int count = 20;
  const Eigen::VectorXd exact = exact_eigenvalues(length(profile, is_closed), is_closed, count);
  for(Space space : {Space::unsplit, Space::split}) {
    const Spectrum spectrum = restricted_spectrum(surface, space, depth, 1, count);
    const Difference difference(spectrum.values, exact);
    std::printf("%-10s %5d    h/%-4d %-8s %9zu %11.3f %10.4f %10.4f\n", name, depth, divisor,
                name_of(space), spectrum.unknowns, spectrum.sheets_per_cell, difference.largest,
                difference.mean);
    std::fflush(stdout);
  }
}

void run_gaps() {
  std::printf("# the first 20 non-zero eigenvalues; h: width of a cell\n");
  std::printf("# %-8s %5s %8s %-8s %9s %11s %10s %10s\n", "surface", "depth", "gap", "space",
              "unknowns", "sheets/cell", "largest_%", "mean_%");
  for(int depth = 4; depth <= 6; ++depth)
    for(int divisor : {1, 4, 16})
      run_gap("spiral", spiral, false, depth, divisor);
  std::printf("\n\n");
  for(int depth = 4; depth <= 6; ++depth)
    for(int divisor : {1, 4, 16})
      run_gap("flat_tube", flat_tube, true, depth, divisor);
  std::printf("\n\n");
}

} // namespace

int main(int argc, char* argv[]) {
  std::vector<std::string> arguments(argv + 1, argv + argc);
  print_header(argc, argv);
  if(!arguments.empty() && arguments[0] == "--gaps") {
    run_gaps();
    return 0;
  }
  const bool prints_values = !arguments.empty() && arguments[0] == "--values";
  if(prints_values)
    arguments.erase(arguments.begin());
  return run_meshes(arguments, prints_values);
}
