// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// How well are known colors found from their gradients? The experiment of the paper's figure 4:
// the colors at the vertices of a mesh, divided by 255 and interpolated linearly, have a gradient
// on each triangle; integrate_gradient_field() integrates the three channels of that field, and the
// mean of each is that of the colors.
//
// - guess: nested iteration only, a W-cycle on each level but the finest
// - w_cycle: and a single W-cycle, without conjugate gradients, as in the paper
// - converged: conjugate gradients with V-cycles, to the default tolerance of the residual
// - details_T: the same with details, all to the tolerance T; details is the number of steps
//   of conjugate gradients on the system of the vertices
// - cholmod: the cotangent system with one vertex held fast, by CHOLMOD with AMD ordering, which
//   solves this problem exactly: the gradient of a function that is linear in each triangle is what
//   it was made for. So its error is rounding.
// Spaces: split is the default; paper is that of the paper, without stabilization.
//
// rms is (sum_v a_v |u - g|^2 / sum_v a_v)^(1/2), with a third of the area of the faces around a
// vertex as a_v and the sum over the three channels in |u - g|^2; rms/ch has their mean there, so
// it is smaller by 3^(1/2). The paper does not say which of them its figure is, nor is its mesh
// known. max is the largest |u - g|. Times are wall-clock seconds of one run; total is that from
// the mesh in memory to the values at its vertices; in the row of CHOLMOD, assem_s is the cotangent
// matrix and the loads, setup_s the factor.
//
// usage: gradient_integration [OPTION]... [MESH]...

#include "../../programs/support/mesh_output.h"
#include "../../programs/support/vertex_data.h"
#include "support/driver.h"
#include "support/measure.h"
#include "support/meshes.h"
#include "support/package.h"

#include <CGAL/Restricted_laplacian_3/input/read_surface.h>
#include <CGAL/Restricted_laplacian_3/integrate_gradient_field.h>
#include <CGAL/Restricted_laplacian_3/problems/internal/vertex_details.h>

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Real_timer.h>
#include <CGAL/property_map.h>

#include <Eigen/Core>
#ifdef CGAL_RESTRICTED_LAPLACIAN_3_USE_CHOLMOD
#include <Eigen/CholmodSupport>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace RL = CGAL::Restricted_laplacian_3;
namespace params = RL::parameters;
using namespace benchmarks;

namespace {

using Rgb = RL::Rgb_color;

struct Options {
  std::vector<std::string> meshes = {"head_male_color_18k", "spot_color_5k8", "gcanyon_color_318k"};
  std::vector<int> depths = {6, 7, 8, 9};
  std::vector<std::string> spaces = {"split", "paper"};
  std::vector<double> details = {1e-3, 1e-5};
  int threads = 1;
  std::string folder; // for colored meshes
};

struct Colored_mesh {
  std::string name;
  std::vector<RL::Point_3> points;
  std::vector<std::vector<std::size_t>> triangles;
  std::vector<Rgb> colors, solution;
  std::vector<double> areas; // of vertices: a third of their faces
  double area = 0;

  // The file is read as a soup, because head_male_color_18k is no manifold.
  explicit Colored_mesh(const std::string& mesh_name)
    : name(std::filesystem::path(mesh_name).stem()) {
    const std::string file = find_path(mesh_name);
    if(!CGAL::IO::read_polygon_soup(file, points, triangles))
      throw std::runtime_error("cannot read " + file);
    colors = programs::read_colors(file);
    solution.resize(points.size());
    const RL::Triangulated_surface_3 surface = RL::read_surface(RL::soup(points, triangles));
    area = surface.area();
    areas.assign(points.size(), 0.);
    for(std::size_t f = 0; f < surface.number_of_faces(); ++f)
      for(const std::uint32_t v : surface.triangle(f))
        areas[v] += surface.area(f) / 3;
  }

  auto color_map() const { return CGAL::make_property_map(colors); }
  auto gradients() const { return RL::vertex_gradients(RL::soup(points, triangles), color_map()); }
};

struct Row {
  int depth = 0;
  std::string space = "-", method;
  std::size_t unknowns = 0;
  RL::Gradient_report report;
  double total_seconds = 0;
};

void print(const Colored_mesh& m, const Row& row) {
  double square = 0, largest = 0;
  for(std::size_t v = 0; v < m.points.size(); ++v) {
    double difference = 0;
    for(std::size_t k = 0; k < 3; ++k)
      difference += (m.solution[v][k] - m.colors[v][k]) * (m.solution[v][k] - m.colors[v][k]);
    if(m.areas[v] == 0)
      continue;
    square += m.areas[v] / m.area * difference;
    largest = std::max(largest, std::sqrt(difference));
  }
  const RL::Gradient_report& r = row.report;
  std::printf("%-19s %5d %-5s %-13s %8zu %4d %7d %7.2f %7.2f %7.2f %7.2f %7.2f %7.2f %8.1e %3s "
              "%8.5f %8.5f %8.5f\n",
              m.name.c_str(), row.depth, row.space.c_str(), row.method.c_str(), row.unknowns,
              r.iterations, r.details_iterations, r.space_seconds, r.assembly_seconds,
              r.setup_seconds, r.solve_seconds, r.details_seconds, row.total_seconds,
              r.relative_residual, r.converged ? "yes" : "no", std::sqrt(square),
              std::sqrt(square / 3), largest);
  std::fflush(stdout);
}

// as MESH_dDEPTH_METHOD.ply, and the map itself as MESH.ply
void write(const Options& o, const Colored_mesh& m, const Row& row) {
  if(o.folder.empty())
    return;
  const RL::Triangulated_surface_3 surface = RL::read_surface(RL::soup(m.points, m.triangles));
  const std::string file = o.folder + "/" + m.name;
  programs::write_mesh(file + ".ply", surface, m.colors);
  programs::write_mesh(file + "_d" + std::to_string(row.depth) + "_" + row.method + ".ply", surface,
                       m.solution);
}

template <class Parameters>
void integrate(const Options& o, Colored_mesh& m, Row row, const std::string& method,
               const Parameters& np) {
  CGAL::Real_timer timer;
  timer.start();
  row.method = method;
  row.report = RL::integrate_gradient_field(RL::soup(m.points, m.triangles), m.gradients(),
                                            CGAL::make_property_map(m.solution), np);
  row.total_seconds = timer.time();
  print(m, row);
  write(o, m, row);
}

void run(const Options& o, Colored_mesh& m, const std::string& space, int depth) {
  const bool is_paper = space == "paper";
  const auto all = [&](const auto& np) {
    return np.concurrency_tag(CGAL::Parallel_if_available_tag())
        .target(m.color_map())
        .paper(is_paper)
        .depth(depth);
  };
  const auto cycles = [&](int number) {
    return all(params::maximum_iterations(number)).stand_alone_multigrid(true).cycle(RL::Cycle::W);
  };
  Row row;
  row.depth = depth;
  row.space = space;
  row.unknowns = RL::Spline_space_3(RL::soup(m.points, m.triangles), all(params::default_values()))
                     .dimension();
  integrate(o, m, row, "guess", cycles(0));
  integrate(o, m, row, "w_cycle", cycles(1));
  if(is_paper)
    return;
  integrate(o, m, row, "converged", all(params::default_values()));
  for(double tolerance : o.details) {
    char name[32];
    std::snprintf(name, sizeof name, "details_%.0e", tolerance);
    integrate(o, m, row, name, all(params::default_values()).tolerance(tolerance).details(true));
  }
}

#ifdef CGAL_RESTRICTED_LAPLACIAN_3_USE_CHOLMOD
void run_cholmod(Colored_mesh& m) {
  CGAL::Real_timer timer;
  timer.start();
  Row row;
  row.method = "cholmod";
  const auto field = m.gradients();
  auto system = RL::internal::vertex_system(
      RL::read_surface(RL::soup(m.points, m.triangles)), field,
      [](const RL::Surface_point*, std::size_t) {}, [](std::size_t) { return 0.; },
      [](std::size_t) -> const double* { return nullptr; }, 0);
  row.unknowns = static_cast<std::size_t>(system.matrix.cols());
  row.report.assembly_seconds = timer.time();
  system.matrix.coeffRef(0, 0) *= 2;
  Eigen::CholmodSupernodalLLT<RL::Sparse_matrix> cholesky;
  cholesky.cholmod().print = 0;
  cholesky.cholmod().nmethods = 1;
  cholesky.cholmod().method[0].ordering = CHOLMOD_AMD;
  cholesky.compute(system.matrix);
  row.report.setup_seconds = timer.time() - row.report.assembly_seconds;
  const Eigen::MatrixXd u = cholesky.solve(Eigen::MatrixXd(system.loads));
  row.report.converged = cholesky.info() == Eigen::Success;
  const auto row_of = [](Rgb& rgb) { return Eigen::Map<Eigen::RowVector3d>(rgb.data()); };
  const auto n = static_cast<Eigen::Index>(m.points.size());
  Eigen::RowVector3d mean = Eigen::RowVector3d::Zero();
  for(Eigen::Index v = 0; v < n; ++v)
    mean += system.integrals[v] / m.area * (row_of(m.colors[v]) - u.row(v));
  for(Eigen::Index v = 0; v < n; ++v)
    row_of(m.solution[v]) = u.row(v) + mean;
  row.total_seconds = timer.time();
  row.report.solve_seconds =
      row.total_seconds - row.report.assembly_seconds - row.report.setup_seconds;
  print(m, row);
}
#endif

bool read_options(int argc, char* argv[], Options& o) {
  Command_line line("usage: gradient_integration [OPTION]... [MESH]...");
  bool is_quick = false;
  line.add("mesh", o.meshes, "PLY files, or names in the folder of shared meshes");
  line.add("depth", o.depths, "6 7 8 9");
  line.add("space", o.spaces, "split paper");
  line.add("details", o.details, "tolerances with details; 1e-3 1e-5");
  line.add("threads", o.threads);
  line.add("write", o.folder, "folder for colored meshes, which has to exist");
  line.add("quick", is_quick, "depths 5 and 6");
  line.add_positional("mesh");
  if(!line.read(argc, argv))
    return false;
  if(is_quick)
    o.depths = {5, 6};
  return true;
}

} // namespace

int main(int argc, char* argv[]) {
  return run_benchmark("gradient_integration", [&] {
    Options o;
    if(!read_options(argc, argv, o))
      return;
    [[maybe_unused]] const auto limited = limit_threads(o.threads);
    set_blas_threads(o.threads);
    print_header(argc, argv);
    std::printf("# %d threads\n", o.threads);
    std::printf("# %-17s %5s %-5s %-13s %8s %4s %7s %7s %7s %7s %7s %7s %7s %8s %3s %8s %8s %8s\n",
                "mesh", "depth", "space", "method", "unknowns", "iter", "details", "space_s",
                "assem_s", "setup_s", "solve_s", "detl_s", "total_s", "residual", "ok", "rms",
                "rms/ch", "max");
    for(const std::string& name : o.meshes) {
      Colored_mesh mesh(name);
#ifdef CGAL_RESTRICTED_LAPLACIAN_3_USE_CHOLMOD
      run_cholmod(mesh);
#endif
      for(const std::string& space : o.spaces)
        for(int depth : o.depths)
          run(o, mesh, space, depth);
      std::printf("\n\n");
    }
  });
}
