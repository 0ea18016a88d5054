// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// The paper's study of spectra (section 5.1, figure 3, table 1): does the spectrum depend on the
// tessellation? The first 200 eigenvalues of the cotangent operator, of the space of the paper and
// of the default space, on spheres and on shapes that QSlim reduces to 30 % and 10 % of their
// vertices.
//
// sphere  spheres with the numbers of vertices of table 1, from an icosahedron, and others from an
//         octahedron; the known eigenvalues l (l + 1), each 2 l + 1 times
// series  shapes in three tessellations; where the restricted spectrum changes more than the
//         target, the same at greater depths, and how far QSlim has moved the surface
// thin    shapes with thin parts and needle triangles: errors over the number of unknowns
//
// Prints tables, writes one CSV file for each shape into a folder, for plots/spectrum_study.gp, and
// progress on the error stream. Of the paper's meshes only the sphere can be had, and bimba in
// another resolution; what stands for the others is said in the tables. Shapes that are not found
// are left out, with a message. Meant to be built with CHOLMOD.
//
// usage: spectrum_study [--output FOLDER] [PART|MESH]...
// A MESH, a file or a name, is studied as a series.

#include "support/measure.h"
#include "support/meshes.h"
#include "support/simplify.h"
#include "support/spectra.h"
#include "support/sphere.h"

#include <CGAL/Restricted_laplacian_3/input/read_surface.h>

#include <CGAL/Bbox_3.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace RL = CGAL::Restricted_laplacian_3;
using namespace benchmarks;

namespace {

using Surface = RL::Triangulated_surface_3;

// with the eigenvalue 0, which is left out of all differences
constexpr int count = 200, few = 100;

constexpr std::array<const char*, 3> tessellations = {"low", "medium", "high"};
constexpr std::array<const char*, 3> operators = {"cotangent", "paper", "restricted"};
enum { cotangent, paper, restricted };

/// eigenvalues without the first, in units of 1 / length^2
Eigen::VectorXd eigenvalues(const Spectrum& spectrum) { return spectrum.values / spectrum.area; }

/// differences of the first eigenvalues of two surfaces
Difference change(const Spectrum& spectrum, const Spectrum& reference, int number) {
  return Difference(eigenvalues(spectrum).head(number - 1),
                    eigenvalues(reference).head(number - 1));
}

/// a shape in three tessellations, and its spectra: of each operator, on each tessellation
struct Study {
  Study(std::string name_, int depth_, std::vector<Surface> surfaces_)
    : name(std::move(name_)), depth(depth_), surfaces(std::move(surfaces_)) {
    std::fprintf(stderr, "%s, depth %d\n", name.c_str(), depth);
    for(const Surface& surface : surfaces) {
      spectra[cotangent].push_back(cotangent_spectrum(surface, 1, count - 1));
      spectra[paper].push_back(restricted_spectrum(surface, Space::paper, depth, 1, count - 1));
      spectra[restricted].push_back(
          restricted_spectrum(surface, Space::split, depth, 1, count - 1));
    }
  }

  void write(const std::string& folder) const {
    std::ofstream file(folder + "/" + name + ".csv");
    file << "# eigenvalues without the first, which is 0, in units of 1 / length^2\n# depth: "
         << depth << "\nindex";
    for(const char* o : operators)
      for(const char* tessellation : tessellations)
        file << ',' << o << '_' << tessellation;
    file << '\n';
    file.precision(8);
    for(int i = 0; i + 1 < count; ++i) {
      file << i + 1;
      for(const auto& of_operator : spectra)
        for(const Spectrum& spectrum : of_operator)
          file << ',' << eigenvalues(spectrum)[i];
      file << '\n';
    }
    if(!file.flush())
      throw std::runtime_error("cannot write into the folder " + folder);
  }

  std::string name;
  int depth;
  std::vector<Surface> surfaces;
  std::array<std::vector<Spectrum>, 3> spectra;
};

/// the dimensions that table 1 of the paper has for a shape, low to high
struct Of_paper {
  const char* name;
  std::array<int, 6> dimensions;
};
constexpr Of_paper table_1[] = {{"sphere", {642, 2562, 10242, 504, 504, 504}},
                                {"bimba", {6100, 12200, 74764, 6071, 6083, 6083}},
                                {"fish", {3700, 14800, 59200, 3617, 3619, 3616}},
                                {"pulley", {6459, 19499, 45676, 6160, 6160, 6161}}};

void print_dimensions(const std::vector<Study>& studies) {
  std::printf("# dimensions, in the manner of table 1\n%-26s %5s", "# shape", "depth");
  for(const char* o : operators)
    std::printf(" | %-10s low  medium    high", o);
  std::printf("\n");
  for(const Study& study : studies) {
    std::printf("%-26s %5d", study.name.c_str(), study.depth);
    for(const auto& of_operator : study.spectra) {
      std::printf("  ");
      for(const Spectrum& spectrum : of_operator)
        std::printf(" %8zu", spectrum.unknowns);
      std::printf("   ");
    }
    std::printf("\n");
  }
  for(const Of_paper& shape : table_1) {
    std::printf("# the paper: %-13s %5d", shape.name, shape.name == std::string("sphere") ? 3 : 5);
    for(int i = 0; i < 6; ++i)
      std::printf("%s %8d",
                  i % 3 == 0 && i > 0 ? "      "
                  : i == 0            ? "  "
                                      : "",
                  shape.dimensions[i]);
    std::printf("\n");
  }
  std::printf("\n\n");
}

void print_changes(const std::vector<Study>& studies) {
  std::printf(
      "# relative change of the eigenvalues against those on the high tessellation; less: how "
      "many times less than that of the cotangent operator, mean of the first %d\n",
      few);
  std::printf("# %-24s %5s %-7s %-10s %10s %10s %10s %10s %8s\n", "shape", "depth", "mesh",
              "operator", "mean_100", "largest", "mean_200", "largest", "less");
  for(const Study& study : studies)
    for(int t = 1; t >= 0; --t)
      for(int o = 0; o < 3; ++o) {
        const auto& s = study.spectra[o];
        const Difference first = change(s[t], s[2], few), all = change(s[t], s[2], count),
                         reference =
                             change(study.spectra[cotangent][t], study.spectra[cotangent][2], few);
        std::printf("%-26s %5d %-7s %-10s %10.2e %10.2e %10.2e %10.2e %8.1f\n", study.name.c_str(),
                    study.depth, tessellations[t], operators[o], first.mean / 100,
                    first.largest / 100, all.mean / 100, all.largest / 100,
                    reference.mean / first.mean);
      }
  std::printf("\n\n");
}

// spheres

/// Eigenvalue number i, counted from 0, belongs to the degree l with l^2 <= i < (l + 1)^2, and its
/// exact value l (l + 1) lies in the middle of the same interval.
int degree(double number) { return static_cast<int>(std::floor(std::sqrt(number))); }

void print_multiplicities(const Study& study, int t) {
  constexpr int degrees = 14;
  static_assert(degrees * degrees <= count, "there are not so many eigenvalues");
  for(int o = 0; o < 3; ++o) {
    const Eigen::VectorXd values = eigenvalues(study.spectra[o][t]);
    std::array<int, degrees + 2> multiplicity = {};
    std::array<double, degrees> error = {}, mean = {};
    for(int i = 1; i < count; ++i) {
      const int found = (std::min)(degree(values[i - 1]), degrees + 1), l = degree(i);
      ++multiplicity[found];
      if(l < degrees) {
        const double e = values[i - 1] / (l * (l + 1)) - 1;
        error[l] = (std::max)(error[l], std::abs(e));
        mean[l] += e / (2 * l + 1);
      }
    }
    bool all = true;
    std::printf("# %s, %zu vertices, %s, depth %d, %zu unknowns\n# degree: ", study.name.c_str(),
                study.surfaces[t].number_of_vertices(), operators[o], study.depth,
                study.spectra[o][t].unknowns);
    for(int l = 1; l < degrees; ++l)
      std::printf(" %9d", l);
    std::printf("\nmultiplicity");
    for(int l = 1; l < degrees; ++l) {
      all = all && multiplicity[l] == 2 * l + 1;
      std::printf(" %9d", multiplicity[l]);
    }
    std::printf("\nmean_error  ");
    for(int l = 1; l < degrees; ++l)
      std::printf(" %9.1e", mean[l]);
    std::printf("\nlargest_abs ");
    for(int l = 1; l < degrees; ++l)
      std::printf(" %9.1e", error[l]);
    std::printf(
        "\n# %s multiplicities 2 l + 1 of the degrees up to %d were found; largest error %.2e\n",
        all ? "all" : "NOT all", degrees - 1, *std::max_element(error.begin(), error.end()));
  }
  std::printf("\n\n");
}

void run_spheres(const std::string& folder) {
  std::vector<Study> studies;
  for(int depth : {3, 5}) {
    const std::string suffix = "_depth_" + std::to_string(depth);
    studies.emplace_back(
        "sphere_icosahedral" + suffix, depth,
        std::vector<Surface>{icosahedral_sphere(3), icosahedral_sphere(4), icosahedral_sphere(5)});
    studies.emplace_back("sphere_octahedral" + suffix, depth,
                         std::vector<Surface>{sphere(4), sphere(5), sphere(6)});
  }
  print_dimensions(studies);
  print_changes(studies);
  for(const Study& study : studies) {
    study.write(folder);
    print_multiplicities(study, 2);
  }
}

// series made by QSlim

/// a closed smooth surface with bumps, for those who have no mesh files
Mesh generated_mesh() {
  const Surface s = icosahedral_sphere(6);
  Mesh mesh;
  for(std::size_t v = 0; v < s.number_of_vertices(); ++v) {
    const RL::Point_3& p = s.point(v);
    const double r = 1 + 0.2 * std::sin(4 * p.x() + 1) * std::sin(5 * p.y()) +
                     0.15 * std::sin(7 * p.z() + 2 * p.x());
    mesh.add_vertex(CGAL::ORIGIN + r * (p - CGAL::ORIGIN));
  }
  for(std::size_t f = 0; f < s.number_of_faces(); ++f) {
    const auto& t = s.triangle(f);
    mesh.add_face(Mesh::Vertex_index(t[0]), Mesh::Vertex_index(t[1]), Mesh::Vertex_index(t[2]));
  }
  return mesh;
}

struct Series {
  std::string name, mesh, remark;
};
const std::vector<Series> all_series = {
    {"bimba", "bimba_46k", "the paper's shape, in a lower resolution"},
    {"fish", "fish_22k", "stands for the paper's fish: another one, with thin fins"},
    {"pulley", "pulley_28k", "stands for the paper's pulley: another one, with thin rims"},
    {"bunny", "bunny00", ""},
    {"armadillo", "armadillo", ""},
    {"fandisk", "fandisk_32k", ""},
    {"bumps", "", "generated"}};

constexpr double target = 1e-3, target_ratio = 20;

/// The surface with a face of area 0 that reaches over a box: the same integrals, on the grid of
/// the box.
Surface with_box(const Surface& surface, const CGAL::Bbox_3& box) {
  std::vector<RL::Point_3> points;
  std::vector<Surface::Triangle> triangles;
  for(std::size_t v = 0; v < surface.number_of_vertices(); ++v)
    points.push_back(surface.point(v));
  for(std::size_t f = 0; f < surface.number_of_faces(); ++f)
    triangles.push_back(surface.triangle(f));
  const auto low = static_cast<std::uint32_t>(points.size());
  points.emplace_back(box.xmin(), box.ymin(), box.zmin());
  points.emplace_back(box.xmax(), box.ymax(), box.zmax());
  triangles.push_back({low, low + 1, low + 1});
  return Surface(std::move(points), std::move(triangles));
}

CGAL::Bbox_3 box_of(const Surface& surface) {
  return surface.bounding_box_min().bbox() + surface.bounding_box_max().bbox();
}

/// What explains a change: the spectra of both surfaces on the same grid (that of a surface follows
/// its bounding box), at greater depths, and by another method that converges.
void print_reason(const Study& study, int t) {
  const auto print = [&](const std::string& name, const Eigen::VectorXd& values,
                         const Eigen::VectorXd& reference) {
    const double ratio = study.surfaces[t].area() / study.surfaces[2].area();
    const Eigen::ArrayXd d = (values - reference).array() / reference.array();
    const Eigen::ArrayXd scaled = (values * ratio - reference).array() / reference.array();
    std::printf("%-10s %-7s %-34s %10.2e %10.2e %10.2e\n", study.name.c_str(), tessellations[t],
                name.c_str(), d.abs().mean(), d.mean(), scaled.abs().mean());
    std::fflush(stdout);
  };
  const int n = few - 1;
  const CGAL::Bbox_3 box = box_of(study.surfaces[t]) + box_of(study.surfaces[2]);
  print("restricted, the same grid",
        eigenvalues(
            restricted_spectrum(with_box(study.surfaces[t], box), Space::split, study.depth, 1, n)),
        eigenvalues(restricted_spectrum(with_box(study.surfaces[2], box), Space::split, study.depth,
                                        1, n)));
  constexpr std::size_t largest_dimension = 200000;
  std::vector<std::array<Eigen::VectorXd, 2>> by_depth;
  for(int depth = study.depth; depth <= study.depth + 2; ++depth) {
    if(space_of(study.surfaces[2], Space::split, depth).dimension() > largest_dimension)
      break;
    by_depth.push_back(
        {eigenvalues(restricted_spectrum(study.surfaces[t], Space::split, depth, 1, n)),
         eigenvalues(restricted_spectrum(study.surfaces[2], Space::split, depth, 1, n))});
    print("restricted, depth " + std::to_string(depth), by_depth.back()[0], by_depth.back()[1]);
  }
  for(std::size_t i = 0; i + 1 < by_depth.size(); ++i)
    std::printf("# depth %d against the greatest: mean %.3g %% on the %s, %.3g %% on the high "
                "tessellation\n",
                study.depth + static_cast<int>(i),
                Difference(by_depth[i][0], by_depth.back()[0]).mean, tessellations[t],
                Difference(by_depth[i][1], by_depth.back()[1]).mean);
  constexpr std::size_t largest_number_of_vertices = 400000;
  const Cotangent_reference a(study.surfaces[t], 1, n, 2, largest_number_of_vertices),
      b(study.surfaces[2], 1, n, 2, largest_number_of_vertices);
  print("cotangent, refined " + std::to_string(a.refinements) + " and " +
            std::to_string(b.refinements) + " times",
        eigenvalues(a.fine), eigenvalues(b.fine));
  print("the same, extrapolated", a.extrapolated / a.fine.area, b.extrapolated / b.fine.area);
}

/// Low, medium and high tessellation; prints how far the first two are from the last.
std::vector<Surface> tessellated(const std::string& name, const Mesh& high) {
  std::vector<Surface> surfaces;
  for(double fraction : {0.1, 0.3, 1.}) {
    const auto vertices = static_cast<std::size_t>(
        std::lround(fraction * static_cast<double>(high.number_of_vertices())));
    const Mesh mesh = fraction < 1 ? simplified(high, vertices) : high;
    std::printf("%-12s %-7s %9zu %10zu", name.c_str(), tessellations[surfaces.size()],
                static_cast<std::size_t>(mesh.number_of_vertices()),
                static_cast<std::size_t>(mesh.number_of_faces()));
    if(fraction < 1) {
      const Geometric_change moved(mesh, high);
      std::printf(" %10.2e %10.2e %10.2e", moved.area, moved.volume, moved.hausdorff);
    }
    std::printf("\n");
    std::fflush(stdout);
    surfaces.push_back(RL::read_surface(mesh));
  }
  return surfaces;
}

/// Prints which shapes meet the target, and why the others do not.
void print_verdicts(const std::vector<Study>& studies) {
  std::printf("# target: mean change of the first %d at the medium tessellation at most %g, and %g "
              "times less than that of the cotangent operator\n",
              few, target, target_ratio);
  std::vector<const Study*> missed;
  for(const Study& study : studies) {
    const Difference d = change(study.spectra[restricted][1], study.spectra[restricted][2], few);
    const double ratio =
        change(study.spectra[cotangent][1], study.spectra[cotangent][2], few).mean / d.mean;
    const bool is_met = d.mean <= 100 * target && ratio >= target_ratio;
    std::printf("%-12s %10.2e %8.1f  %s\n", study.name.c_str(), d.mean / 100, ratio,
                is_met ? "met" : "MISSED");
    if(!is_met)
      missed.push_back(&study);
  }
  std::printf("\n\n");
  if(missed.empty())
    return;
  std::printf("# where it was missed: mean change of the first %d on the same grid, with greater "
              "depth, and by another method; mean with sign; mean after scaling to the same area\n",
              few);
  std::printf("# %-8s %-7s %-34s %10s %10s %10s\n", "shape", "mesh", "method", "mean", "signed",
              "scaled");
  for(const Study* study : missed)
    print_reason(*study, 1);
  std::printf("\n\n");
}

int run_series(const std::string& folder, const std::vector<Series>& all) {
  std::vector<Study> studies;
  int failures = 0;
  std::printf("# QSlim: change of area and volume, relative, and symmetric Hausdorff distance "
              "(sampled) over the longest side of the bounding box, against the high "
              "tessellation\n");
  std::printf("# %-10s %-7s %9s %10s %10s %10s %10s\n", "shape", "mesh", "vertices", "triangles",
              "area", "volume", "Hausdorff");
  for(const Series& series : all)
    try {
      const auto high =
          series.mesh.empty() ? std::make_optional(generated_mesh()) : find_mesh_file(series.mesh);
      if(!high) {
        std::printf("# %s: SKIPPED, there is no mesh %s\n", series.name.c_str(),
                    series.mesh.c_str());
        continue;
      }
      if(!series.remark.empty())
        std::printf("# %s: %s\n", series.name.c_str(), series.remark.c_str());
      require_watertight(*high);
      constexpr int depth = 5;
      studies.emplace_back(series.name, depth, tessellated(series.name, *high));
      studies.back().write(folder);
    } catch(const std::exception& e) {
      std::printf("# %s: %s\n", series.name.c_str(), e.what());
      ++failures;
    }
  std::printf("\n\n");
  print_dimensions(studies);
  print_changes(studies);
  print_verdicts(studies);
  return failures;
}

// thin shapes

struct Row {
  std::string method;
  int level; // depth, or number of refinements
  Spectrum spectrum;
};

/// paper's space, default space up to depth 7, cotangent operator up to three refinements
std::array<std::vector<Row>, 3> thin_spectra(const Surface& surface, int number) {
  constexpr std::size_t largest_number_of_vertices = 400000;
  const int kernel = number_of_components(surface);
  std::array<std::vector<Row>, 3> rows;
  for(int depth = 4; depth <= 6; ++depth)
    rows[paper].push_back(
        {"paper", depth, restricted_spectrum(surface, Space::paper, depth, kernel, number)});
  for(int depth = 4; depth <= 7; ++depth)
    rows[restricted].push_back(
        {"restricted", depth, restricted_spectrum(surface, Space::split, depth, kernel, number)});
  Surface finer = surface;
  for(int level = 0;; ++level) {
    rows[cotangent].push_back({"cotangent", level, cotangent_spectrum(finer, kernel, number)});
    if(level == 3 || (level > 0 && finer.number_of_vertices() + finer.number_of_faces() * 3 / 2 >
                                       largest_number_of_vertices))
      break;
    finer = refined(finer);
  }
  return rows;
}

void run_thin(const char* name, const char* mesh_name, const std::string& folder) {
  constexpr int number = few - 1;
  const auto found = find_mesh_file(mesh_name);
  if(!found) {
    std::printf("# %s: SKIPPED, there is no mesh %s\n\n\n", name, mesh_name);
    return;
  }
  std::fprintf(stderr, "%s\n", name);
  const Surface surface = RL::read_surface(*found);
  const auto rows = thin_spectra(surface, number);
  const auto last = [&rows](int o, int before) -> const Eigen::VectorXd& {
    return rows[o][rows[o].size() - 1 - before].spectrum.values;
  };
  const Eigen::VectorXd extrapolated =
      last(cotangent, 0) + (last(cotangent, 0) - last(cotangent, 1)) / 3;
  const Difference of_cotangent(last(cotangent, 0), last(cotangent, 1)),
      of_split(last(restricted, 0), last(restricted, 1)), both(extrapolated, last(restricted, 0));
  const bool cotangent_counts = of_cotangent.largest <= 1;
  const Eigen::VectorXd& reference = cotangent_counts ? extrapolated : last(restricted, 0);
  std::printf("# %s: %zu vertices, %zu triangles; the first %d eigenvalues above 0\n", name,
              surface.number_of_vertices(), surface.number_of_faces(), number);
  std::printf("# percent:                                                    largest     mean\n"
              "# cotangent operator, last two refinements differ by        %9.3f %9.3f\n"
              "# restricted, depths 6 and 7 differ by                      %9.3f %9.3f\n"
              "# extrapolated cotangent and restricted, depth 7, differ by %9.3f %9.3f\n",
              of_cotangent.largest, of_cotangent.mean, of_split.largest, of_split.mean,
              both.largest, both.mean);
  std::printf("# of two upper bounds, that of the finest cotangent operator is above that of "
              "restricted, depth 7, for %d of %d eigenvalues\n",
              static_cast<int>((last(cotangent, 0).array() > last(restricted, 0).array()).count()),
              number);
  std::printf("# reference: %s\n",
              cotangent_counts ? "cotangent, extrapolated" : "restricted, depth 7");
  std::printf("# %-10s %5s %9s %10s %7s %10s %8s\n", "operator", "level", "unknowns", "largest_%",
              "number", "mean_%", "seconds");
  std::ofstream file(folder + "/errors_" + name + ".csv");
  file << "# " << name << ": relative error of the first " << number
       << " eigenvalues above 0\noperator,level,unknowns,largest,mean\n";
  for(int o : {paper, restricted, cotangent})
    for(const Row& row : rows[o]) {
      const Difference error(row.spectrum.values, reference);
      const bool is_reference = &row.spectrum.values == &reference;
      std::printf("%-12s %5d %9zu %10.3f %7d %10.3f %8.1f%s\n", row.method.c_str(), row.level,
                  row.spectrum.unknowns, error.largest, static_cast<int>(error.position) + 1,
                  error.mean, row.spectrum.assembly_seconds + row.spectrum.eigenvalue_seconds,
                  is_reference ? " # the reference" : "");
      if(!is_reference)
        file << row.method << ',' << row.level << ',' << row.spectrum.unknowns << ','
             << error.largest / 100 << ',' << error.mean / 100 << '\n';
    }
  std::printf("\n\n");
  std::fflush(stdout);
}

} // namespace

int main(int argc, char* argv[]) {
  std::string folder = "spectrum_study";
  std::vector<std::string> parts(argv + 1, argv + argc);
  if(parts.size() >= 2 && parts[0] == "--output") {
    folder = parts[1];
    parts.erase(parts.begin(), parts.begin() + 2);
  }
  if(!parts.empty() && parts[0][0] == '-') {
    std::fprintf(stderr, "usage: spectrum_study [--output FOLDER] [sphere|series|thin|MESH]...\n");
    return 1;
  }
  if(parts.empty())
    parts = {"sphere", "series", "thin"};
  int failures = 0;
  try {
    std::filesystem::create_directories(folder);
    print_header(argc, argv);
    std::vector<Series> meshes;
    for(const std::string& part : parts)
      if(part == "sphere")
        run_spheres(folder);
      else if(part == "series")
        failures += run_series(folder, all_series);
      else if(part == "thin") {
        run_thin("rotor", "rotor_small", folder);
        run_thin("pulley", "pulley_28k", folder);
      } else
        meshes.push_back({std::filesystem::path(part).stem().string(), part, ""});
    if(!meshes.empty())
      failures += run_series(folder, meshes);
  } catch(const std::exception& e) {
    std::fprintf(stderr, "%s\n", e.what());
    return 1;
  }
  return failures > 0;
}
