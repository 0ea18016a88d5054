// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Does gradient fitting survive thin and interpenetrating parts? A vector field u is fitted to the
// gradient of the normals of a mesh, as in the paper's section 5.5 and figure 7: for each
// coordinate n of the vertex normals, interpolated linearly,
//   (S + alpha M) eta = <grad n, grad b_i> + alpha <n, b_i>.
// In the unsplit space of the paper, near parts of the surface share elements, and without
// screening nothing ties u to n but the gradient; the paper's cure is alpha = 1/20, this package's
// is to split the elements.
//
// The paper does not state the unit of alpha. Here it is 1 / L^2, L the longest side of the
// bounding box (--alpha), or 1 / h^2, h the width of the cells (--cell-alpha); the column LL*alpha
// has it in units of 1 / L^2. rms and max are those of |u - n| over the vertices, rms weighted by
// area, after the mean of u was set to that of n. (On each closed part that is 0 up to
// interpolation: one number serves all parts.) The paper's figures stand in the column `paper`,
// for its own cow and pulley: the first is much like ours, the second is another shape.
//
// With --pictures FOLDER also MESH_dDEPTH_SPACE_ALPHA.png of |u - n|: logarithmic, dark violet is
// 0.001 and less, yellow 1 and more.
//
// usage: normal_fitting [OPTION]... [MESH]...

#include "../../programs/support/picture.h"
#include "support/driver.h"
#include "support/measure.h"
#include "support/package.h"
#include "support/vertex_normals.h"

#include <CGAL/Restricted_laplacian_3/splines/Spline_function_3.h>

#include <CGAL/Real_timer.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace RL = CGAL::Restricted_laplacian_3;
using namespace benchmarks;

namespace {

struct Options {
  std::vector<std::string> meshes = {"pulley_28k", "cow_5k8"};
  std::vector<int> depths = {6, 7, 8};
  std::vector<std::string> spaces = {"unsplit", "split"};
  std::vector<double> alphas = {0, 0.05}, cell_alphas = {0.05};
  double tolerance = 1e-3, stabilization = default_stabilization();
  int iterations = 300, threads = 1;
  std::string pictures;
};

struct Fit {
  double setup_seconds = 0;
  RL::Solve_report report;
  std::vector<double> errors; // at the vertices
  double rms = 0, largest = 0;
};

// One space, with what all fits on it share.
class Fitting {
public:
  Fitting(const Options& o, const RL::Triangulated_surface_3& surface,
          const Vertex_normals& normals, const std::string& kind, int depth)
    : m_options(o), m_surface(surface), m_normals(normals), m_timer(started()),
      m_space(surface, options(kind, depth, o.threads)) {
    m_space_seconds = m_timer.time();
    m_operators = operators(m_space, o.stabilization);
    const auto n = static_cast<Eigen::Index>(m_space.dimension());
    m_gradient_loads.resize(n, 3);
    m_loads.resize(n, 3);
    for(int k = 0; k < 3; ++k) {
      m_gradient_loads.col(k) =
          RL::assemble_gradient_load(m_space, [&](const RL::Surface_point& p) {
            return normals.gradients_of_face[3 * p.face + k];
          });
      std::vector<double> values;
      for(const RL::Vector_3& normal : normals.at_vertex)
        values.push_back(normal[k]);
      m_loads.col(k) =
          RL::assemble_load(m_space, RL::Linear_surface_function<double>(std::move(values)));
    }
    m_assembly_seconds = m_timer.time() - m_space_seconds;
  }

  std::size_t dimension() const { return m_space.dimension(); }
  // the values of alpha in units of 1 / L^2, with names
  std::vector<std::pair<std::string, double>> screenings() const {
    const double cells = m_surface.extent() / m_space.octree().cell_width(m_space.depth());
    std::vector<std::pair<std::string, double>> result;
    const auto add = [&](double alpha, const std::string& unit, double factor) {
      char text[32];
      std::snprintf(text, sizeof text, "%.4g", alpha);
      result.emplace_back(alpha == 0 ? "0" : text + unit, alpha * factor);
    };
    for(double alpha : m_options.alphas)
      add(alpha, "/L^2", 1);
    for(double alpha : m_options.cell_alphas)
      add(alpha, "/h^2", cells * cells);
    return result;
  }
  double space_seconds() const { return m_space_seconds; }
  double assembly_seconds() const { return m_assembly_seconds; }

  // alpha in units of 1 / L^2
  Fit fit(double alpha) const {
    const double a = alpha / (m_surface.extent() * m_surface.extent());
    RL::Sparse_matrix matrix = m_operators.stiffness;
    if(a != 0)
      matrix.coeffs() += a * m_operators.mass.coeffs();
    const RL::Poisson_solver solver(
        m_space, std::move(matrix), RL::assemble_element_integrals(m_space), a,
        solver_options("patch", m_options.threads, m_options.tolerance, m_options.iterations));
    Fit result;
    Eigen::MatrixXd eta;
    result.report = solver.solve(m_gradient_loads + a * m_loads, eta);
    result.setup_seconds = solver.setup_seconds();
    measure_errors(eta, result);
    return result;
  }

private:
  static CGAL::Real_timer started() {
    CGAL::Real_timer timer;
    timer.start();
    return timer;
  }
  static RL::Spline_space_options options(const std::string& kind, int depth, int threads) {
    RL::Spline_space_options result = space_options(depth, kind == "split", threads);
    result.paper = kind == "paper";
    return result;
  }

  void measure_errors(const Eigen::MatrixXd& eta, Fit& result) const {
    const auto n = static_cast<Eigen::Index>(m_surface.number_of_vertices());
    Eigen::MatrixXd u(n, 3);
    for(int k = 0; k < 3; ++k) {
      const std::vector<double> values =
          RL::Spline_function_3(m_space, eta.col(k)).values_at_vertices();
      u.col(k) = Eigen::Map<const Eigen::VectorXd>(values.data(), n);
    }
    Eigen::RowVector3d mean = Eigen::RowVector3d::Zero();
    for(Eigen::Index v = 0; v < n; ++v)
      if(m_normals.areas[v] > 0)
        mean += m_normals.areas[v] / m_surface.area() * u.row(v);
    u.rowwise() += m_normals.mean - mean;
    for(Eigen::Index v = 0; v < n; ++v) {
      const RL::Vector_3& normal = m_normals.at_vertex[v];
      const double error =
          (u.row(v) - Eigen::RowVector3d(normal.x(), normal.y(), normal.z())).norm();
      result.errors.push_back(error);
      if(m_normals.areas[v] == 0)
        continue;
      result.rms += m_normals.areas[v] / m_surface.area() * error * error;
      result.largest = std::max(result.largest, error);
    }
    result.rms = std::sqrt(result.rms);
  }

  const Options& m_options;
  const RL::Triangulated_surface_3& m_surface;
  const Vertex_normals& m_normals;
  CGAL::Real_timer m_timer;
  RL::Spline_space_3 m_space;
  RL::Operators m_operators;
  Eigen::MatrixXd m_gradient_loads, m_loads;
  double m_space_seconds = 0, m_assembly_seconds = 0;
};

void draw(const std::string& file, const RL::Triangulated_surface_3& surface,
          const std::vector<double>& errors) {
  constexpr double decades = 3; // below 1
  std::vector<programs::Color> colors;
  for(double error : errors)
    colors.push_back(
        programs::color_at(programs::sequential_colors, 1 + std::log10(error) / decades));
  programs::write_picture(file, surface, colors, errors, programs::Picture_options());
}

// depth 8, without and with screening
const std::map<std::string, std::array<double, 2>> paper = {
    {"cow", {0.3073, 0.0962}}, {"cow_5k8", {0.3073, 0.0962}}, {"pulley_28k", {0.0435, 0.0024}}};

void run(const Options& o, const std::string& mesh) {
  const auto surface = find_mesh(mesh);
  if(!surface)
    return;
  const std::string name = std::filesystem::path(mesh).stem();
  const Vertex_normals normals(*surface);
  for(int depth : o.depths)
    for(const std::string& kind : o.spaces) {
      const Fitting fitting(o, *surface, normals, kind, depth);
      for(const auto& [label, alpha] : fitting.screenings()) {
        const Fit fit = fitting.fit(alpha);
        double of_paper = std::nan("");
        if(depth == 8 && kind != "split" && paper.count(name))
          of_paper = paper.at(name)[alpha > 0];
        std::printf("%-12s %5d %-8s %-8s %8.2f %8zu %8.2f %8.2f %8.2f %8.2f %5d %9.1e %3s %9.2e "
                    "%9.2e %7.4f\n",
                    name.c_str(), depth, kind.c_str(), label.c_str(), alpha, fitting.dimension(),
                    fitting.space_seconds(), fitting.assembly_seconds(), fit.setup_seconds,
                    fit.report.solve_seconds, fit.report.iterations, fit.report.relative_residual,
                    fit.report.converged ? "yes" : "no", fit.rms, fit.largest, of_paper);
        std::fflush(stdout);
        if(!o.pictures.empty()) {
          char file[256];
          std::snprintf(file, sizeof file, "%s/%s_d%d_%s_%.4g.png", o.pictures.c_str(),
                        name.c_str(), depth, kind.c_str(), alpha);
          draw(file, *surface, fit.errors);
        }
      }
    }
}

bool read_options(int argc, char* argv[], Options& o) {
  Command_line line("usage: normal_fitting [OPTION]... [MESH]...");
  bool is_quick = false;
  line.add("mesh", o.meshes, "files, or names in the folder of shared meshes");
  line.add("depth", o.depths, "6 7 8");
  line.add("space", o.spaces, "unsplit split; also: paper");
  line.add("alpha", o.alphas, "in units of 1 / L^2; 0 0.05");
  line.add("cell-alpha", o.cell_alphas, "in units of 1 / h^2; 0.05");
  line.add("tolerance", o.tolerance);
  line.add("iterations", o.iterations);
  line.add("stabilization", o.stabilization);
  line.add("threads", o.threads);
  line.add("pictures", o.pictures, "folder for pictures, which has to exist");
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
  return run_benchmark("normal_fitting", [&] {
    Options o;
    if(!read_options(argc, argv, o))
      return;
    [[maybe_unused]] const auto limited = limit_threads(o.threads);
    print_header(argc, argv);
    std::printf("# stabilization %g, residual %g, %d threads; seconds of one run\n",
                o.stabilization, o.tolerance, o.threads);
    std::printf("# %-10s %5s %-8s %-8s %8s %8s %8s %8s %8s %8s %5s %9s %3s %9s %9s %7s\n", "mesh",
                "depth", "space", "alpha", "LL*alpha", "unknowns", "space_s", "assem_s", "setup_s",
                "solve_s", "iter", "residual", "ok", "rms", "max", "paper");
    for(const std::string& mesh : o.meshes) {
      run(o, mesh);
      std::printf("\n\n");
    }
  });
}
