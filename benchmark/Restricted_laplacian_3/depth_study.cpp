// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Which depth for which mesh, at what cost? From meshes in memory to the solution of
// Laplacian u = z at their vertices
// - by solve_poisson() with its defaults at each depth (restricted),
// - by the cotangent Laplacian with CHOLMOD in AMD ordering, a vertex held at 0 (cot_cholmod),
// - and with conjugate gradients and BoomerAMG, configuration amg2 of support/boomer_amg.h, to the
//   same tolerance (cot_amg).
// Seconds are medians of three runs, MiB what was needed at most beyond the mesh, each in a process
// of its own. The threads are those of the package and of the BLAS of CHOLMOD; hypre has one.
//
// The error is the root mean square over the vertices, weighted by area, relative to that of the
// solution, means made equal. It is measured against the package one or more levels deeper, to
// 1e-9. How far that is from the cotangent Laplacian on the mesh refined at the midpoints of its
// edges, once or more, extrapolated from the last two, is printed above the rows of each mesh.
// edge/h is the mean length of edges over the width of the finest cells.
//
// usage: depth_study [OPTION]...

#include "support/driver.h"
#include "support/linear_solvers.h"
#include "support/package.h"
#include "support/spectra.h"

#include <CGAL/Restricted_laplacian_3/assembly/cotangent_operators.h>
#include <CGAL/Restricted_laplacian_3/input/read_surface.h>
#include <CGAL/Restricted_laplacian_3/solve_poisson.h>

#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace benchmarks;
namespace params = RL::parameters;
using Mesh = CGAL::Surface_mesh<RL::Point_3>;

struct Options {
  std::vector<std::string> meshes = {"couplingdown", "spot_color_5k8",     "cow_5k8",
                                     "koala_7k",     "turbine_18k",        "fandisk_32k",
                                     "bimba_46k",    "bunny_closed_70k",   "armadillo",
                                     "itokawa_197k", "gcanyon_color_318k", "armadillo_mc1m"};
  std::vector<int> depths = {4, 5, 6, 7, 8}, threads = {1};
  int deepest = 9, repetitions = 3;
  std::size_t most_unknowns = 1700000;
};

double z_coordinate(const RL::Surface_point& p) { return p.point.z(); }

/// Values at vertices, compared in the mean square.
class Vertex_norm {
public:
  explicit Vertex_norm(const RL::Triangulated_surface_3& surface)
    : m_areas(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(surface.number_of_vertices()))) {
    for(std::size_t f = 0; f < surface.number_of_faces(); ++f)
      for(const auto v : surface.triangle(f))
        m_areas[v] += surface.area(f) / 3;
  }

  /// without what vertices of no area have
  Eigen::VectorXd centered(const Eigen::VectorXd& u) const {
    const Eigen::VectorXd v = (m_areas.array() > 0).select(u, 0);
    return v.array() - m_areas.dot(v) / m_areas.sum();
  }
  double difference(const Eigen::VectorXd& u, const Eigen::VectorXd& reference) const {
    const Eigen::VectorXd v = centered(reference);
    return norm(centered(u) - v) / norm(v);
  }

private:
  double norm(const Eigen::VectorXd& u) const { return std::sqrt(m_areas.dot(u.cwiseAbs2())); }

  Eigen::VectorXd m_areas;
};

double mean_edge_length(const RL::Triangulated_surface_3& surface) {
  double sum = 0;
  for(std::size_t f = 0; f < surface.number_of_faces(); ++f) {
    const auto& t = surface.triangle(f);
    for(int i = 0; i < 3; ++i)
      sum += std::sqrt(CGAL::squared_distance(surface.point(t[i]), surface.point(t[(i + 1) % 3])));
  }
  return sum / (3 * static_cast<double>(surface.number_of_faces()));
}

struct Row {
  double seconds, edge_over_width, error;
  std::size_t unknowns;
  int iterations;
  bool converged;
};

class Study {
public:
  Study(const Options& o, const std::string& name, Mesh mesh)
    : m_options(o), m_name(name), m_mesh(std::move(mesh)), m_surface(RL::read_surface(m_mesh)),
      m_norm(m_surface) {}

  void run() {
    const int depth_of_reference = deepest_depth();
    m_reference = in_vector([&] { return restricted(depth_of_reference, 1e-9, 2).second; });
    if(m_reference.size() == 0)
      throw std::runtime_error(m_name + ": there is no reference");
    std::printf("# %s, %zu vertices, %zu triangles; reference: depth %d\n", m_name.c_str(),
                m_surface.number_of_vertices(), m_surface.number_of_faces(), depth_of_reference);
    print_check_of_reference();
    for(const int threads : m_options.threads) {
#ifdef CGAL_RESTRICTED_LAPLACIAN_3_USE_CHOLMOD
      print("cot_cholmod", 0, threads, [&] {
        return cotangent(m_surface, [](const auto& a, const auto& b, auto& u) {
          return solve_by_cholmod(a, b, u);
        });
      });
#endif
      if(threads == 1)
        print("cot_amg", 0, threads, [&] {
          static const Hypre_session session; // of the process
          return cotangent(m_surface, [](const auto& a, const auto& b, auto& u) {
            return solve_by_amg(a, b, 1e-3, u);
          });
        });
      for(const int depth : m_options.depths)
        if(depth < depth_of_reference)
          print("restricted", depth, threads, [&] { return restricted(depth, 1e-3, threads); });
    }
    std::printf("\n\n");
  }

private:
  using Solution = std::pair<Row, Eigen::VectorXd>;

  int deepest_depth() const {
    for(int depth = m_options.deepest; depth > 1; --depth)
      if(RL::Spline_space_3(m_surface, space_options(depth, true, 1)).dimension() <=
         m_options.most_unknowns)
        return depth;
    return 1;
  }

  Solution restricted(int depth, double tolerance, int threads) {
    const auto limited = limit_threads(threads);
    (void)limited;
    const auto u = m_mesh.add_property_map<Mesh::Vertex_index, double>("v:u").first;
    const auto np = params::depth(depth).tolerance(tolerance);
    Stopwatch watch;
    const RL::Solve_report report =
        threads > 1 ? RL::solve_poisson(m_mesh, z_coordinate, u,
                                        np.concurrency_tag(CGAL::Parallel_if_available_tag()))
                    : RL::solve_poisson(m_mesh, z_coordinate, u, np);
    Solution result;
    result.first.seconds = watch.lap();
    result.first.iterations = report.iterations;
    result.first.converged = report.converged;
    result.second = Eigen::Map<const Eigen::VectorXd>(
        u.data(), static_cast<Eigen::Index>(m_mesh.number_of_vertices()));
    return result;
  }

  template <class Solve>
  Solution cotangent(const RL::Triangulated_surface_3& surface, Solve&& solve) const {
    Solution result;
    Stopwatch watch;
    const RL::Operators both = RL::cotangent_operators(surface);
    Eigen::VectorXd f(both.mass.rows());
    for(Eigen::Index v = 0; v < f.size(); ++v)
      f[v] = surface.point(static_cast<std::size_t>(v)).z();
    const Eigen::VectorXd b = poisson_load(both.mass, f);
    result.first.converged = solve(both.stiffness, b, result.second).converged;
    result.first.seconds = watch.lap();
    result.first.unknowns = static_cast<std::size_t>(f.size());
    result.first.iterations = 0;
    return result;
  }

  /// computes a vector in a process of its own, whose memory and threads are gone then
  template <class Compute> static Eigen::VectorXd in_vector(Compute&& compute) {
    double mib = 0;
    const std::vector<double> values = in_child_process<double>(3600, mib, [&] {
      const Eigen::VectorXd u = compute();
      return std::vector<double>(u.data(), u.data() + u.size());
    });
    return Eigen::Map<const Eigen::VectorXd>(values.data(),
                                             static_cast<Eigen::Index>(values.size()));
  }

  void print_check_of_reference() const {
#ifdef CGAL_RESTRICTED_LAPLACIAN_3_USE_CHOLMOD
    constexpr std::size_t most_vertices = 2200000;
    const auto vertices_of_refined = [](const RL::Triangulated_surface_3& s) {
      return s.number_of_vertices() + s.number_of_faces() * 3 / 2;
    };
    const auto solve = [&](const RL::Triangulated_surface_3& surface) {
      return m_norm.centered(in_vector([&] {
        set_blas_threads(2);
        return Eigen::VectorXd(
            cotangent(surface, [](const auto& a, const auto& b, auto& u) {
              return solve_by_cholmod(a, b, u);
            }).second.head(static_cast<Eigen::Index>(m_surface.number_of_vertices())));
      }));
    };
    RL::Triangulated_surface_3 surface = m_surface;
    Eigen::VectorXd coarse, fine = solve(surface);
    int refinements = 0;
    for(; refinements < 3 && vertices_of_refined(surface) <= most_vertices; ++refinements) {
      surface = refined(surface);
      coarse = fine;
      fine = solve(surface);
    }
    if(refinements > 0)
      std::printf(
          "# from which the cotangent Laplacian, refined %d times and extrapolated, differs "
          "by %.1e\n",
          refinements, m_norm.difference((4 * fine - coarse) / 3, m_reference));
#endif
  }

  template <class Solve> void print(const char* method, int depth, int threads, Solve&& solve) {
    double mib = 0;
    const std::vector<Row> rows = in_child_process<Row>(3600, mib, [&] {
      set_blas_threads(threads);
      std::vector<double> seconds;
      Solution solution;
      for(int i = 0; i < m_options.repetitions; ++i) {
        solution = solve();
        seconds.push_back(solution.first.seconds);
      }
      Row row = solution.first;
      row.seconds = median(seconds);
      row.error = m_norm.difference(solution.second, m_reference);
      return std::vector<Row>{row};
    });
    if(rows.empty()) {
      std::printf("%-18s %7zu %-12s %5d: failed\n", m_name.c_str(), m_surface.number_of_vertices(),
                  method, depth);
      return;
    }
    Row row = rows.front();
    if(depth > 0) {
      const RL::Spline_space_3 space(m_surface, space_options(depth, true, 1));
      row.unknowns = space.dimension();
      row.edge_over_width = mean_edge_length(m_surface) / space.octree().cell_width(depth);
    } else
      row.edge_over_width = 0;
    std::printf("%-18s %7zu %-12s %5d %6.2f %7d %9zu %9.3f %7.0f %5d %3s %9.2e\n", m_name.c_str(),
                m_surface.number_of_vertices(), method, depth, row.edge_over_width, threads,
                row.unknowns, row.seconds, mib, row.iterations, row.converged ? "yes" : "no",
                row.error);
    std::fflush(stdout);
  }

  const Options& m_options;
  std::string m_name;
  Mesh m_mesh;
  RL::Triangulated_surface_3 m_surface;
  Vertex_norm m_norm;
  Eigen::VectorXd m_reference;
};

bool read_options(int argc, char* argv[], Options& o) {
  Command_line line("usage: depth_study [OPTION]...");
  line.add("mesh", o.meshes, "files, or names in the folders of meshes; twelve shared ones");
  line.add("depth", o.depths, "4 5 6 7 8");
  line.add("threads", o.threads, "1");
  line.add("deepest", o.deepest, "depth of the reference");
  line.add("most-unknowns", o.most_unknowns, "of the reference, which else is less deep");
  line.add("repetitions", o.repetitions);
  return line.read(argc, argv);
}

} // namespace

int main(int argc, char* argv[]) {
  return run_benchmark("depth_study", [&] {
    Options o;
    if(!read_options(argc, argv, o))
      return;
    print_header(argc, argv);
    std::printf("# %-16s %7s %-12s %5s %6s %7s %9s %9s %7s %5s %3s %9s\n", "mesh", "vertices",
                "method", "depth", "edge/h", "threads", "unknowns", "seconds", "MiB", "iter", "ok",
                "error");
    for(const std::string& name : o.meshes)
      if(auto mesh = find_mesh_file(name))
        Study(o, name, std::move(*mesh)).run();
  });
}
