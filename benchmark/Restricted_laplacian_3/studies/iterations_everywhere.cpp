// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Does the solver stall anywhere? The iterations to 1e-8 of
// - Poisson problems, poisson_z and poisson_random,
// - screened ones, alpha from 1e-6 to 1e6 over the area, screened_1e-6 ...,
// - fits, which may end before by their own error: fit_z, fit_wave (a sine of each coordinate),
//   fit_normals (of the faces), fit_random,
// - gradients: a vector for each face, random
// with V- and W-cycles, where z is a coordinate, and what is random are independent normal numbers
// at the vertices (of the faces, for vectors).
//
// A line for each mesh, depth and cycle: unknowns, and the iterations of each problem, with * where
// the tolerance was not reached.
//
// usage: iterations_everywhere [OPTION]...

#include "support/driver.h"
#include "support/measure.h"
#include "support/meshes.h"
#include "support/package.h"

#include <CGAL/Restricted_laplacian_3/fit_function.h>
#include <CGAL/Restricted_laplacian_3/problems/integrate_gradients.h>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <optional>
#include <string>
#include <vector>

namespace {

using namespace benchmarks;
namespace params = RL::parameters;

struct Options {
  std::vector<std::string> meshes, problems, cycles = {"v", "w"};
  std::vector<int> depths = {4, 5, 6, 7, 8};
  int limit = 200, threads = 2;
  double tolerance = 1e-8, stabilization = -1, energy_tolerance = -1;
};

std::vector<double> random_numbers(std::size_t number) {
  boost::random::mt19937 engine(1);
  boost::random::normal_distribution<double> distribution;
  std::vector<double> result(number);
  for(double& x : result)
    x = distribution(engine);
  return result;
}

class Case {
public:
  Case(const Options& o, const std::string& mesh, const RL::Triangulated_surface_3& surface,
       int depth)
    : m_options(o), m_mesh(mesh), m_surface(surface), m_depth(depth),
      m_space(surface, space_options(depth, true, o.threads)),
      m_at_vertices(random_numbers(surface.number_of_vertices())),
      m_in_faces(random_numbers(3 * surface.number_of_faces())) {}

  void run(const std::string& cycle) {
    m_cycle = cycle == "w" ? RL::Cycle::W : RL::Cycle::V;
    std::printf("%-20s %5d %s %8zu", m_mesh.c_str(), m_depth, cycle.c_str(), m_space.dimension());
    for(const std::string& problem : m_options.problems) {
      const RL::Solve_report report = report_of(problem);
      const std::string iterations =
          std::to_string(report.iterations) + (report.converged ? "" : "*");
      std::printf(" %*s", static_cast<int>(problem.size()), iterations.c_str());
    }
    std::printf("\n");
    std::fflush(stdout);
  }

private:
  auto parameters() const {
    return params::tolerance(m_options.tolerance)
        .maximum_iterations(m_options.limit)
        .cycle(m_cycle)
        .concurrency_tag(CGAL::Parallel_if_available_tag());
  }

  RL::Solve_report report_of(const std::string& problem) const {
    if(problem.rfind("fit_", 0) == 0)
      return fitted(problem);
    return problem == "gradients" ? gradients() : solved(problem);
  }

  RL::Solve_report solved(const std::string& problem) const {
    double alpha = 0;
    if(problem.rfind("screened_", 0) == 0)
      alpha = std::atof(problem.c_str() + 9) / m_surface.area();
    Eigen::VectorXd load, x;
    if(problem == "poisson_z")
      load = RL::assemble_load(m_space, [](const RL::Surface_point& p) { return p.point.z(); });
    else
      load = RL::assemble_load(m_space, RL::Linear_surface_function<double>(m_at_vertices));
    if(m_options.stabilization >= 0)
      return RL::Poisson_solver(m_space, alpha, parameters().stabilization(m_options.stabilization))
          .solve(load, x);
    return RL::Poisson_solver(m_space, alpha, parameters()).solve(load, x);
  }

  RL::Function_fit fitted(const std::string& problem) const {
    const double unit = m_surface.extent() / 10;
    if(problem == "fit_z")
      return fit([](const RL::Surface_point& p) { return p.point.z(); });
    if(problem == "fit_wave")
      return fit([unit](const RL::Surface_point& p) {
        return std::array<double, 3>{std::sin(p.point.x() / unit), std::sin(p.point.y() / unit),
                                     std::sin(p.point.z() / unit)};
      });
    if(problem == "fit_normals")
      return fit([](const RL::Surface_point& p) { return p.normal; });
    return fit(RL::Linear_surface_function<double>(m_at_vertices));
  }

  RL::Function_fit fit(const RL::Surface_function_view& f) const {
    const auto given = [](double x) { return x >= 0 ? std::optional<double>(x) : std::nullopt; };
    return RL::fit_function(m_space, f,
                            parameters()
                                .stabilization(given(m_options.stabilization))
                                .energy_tolerance(given(m_options.energy_tolerance)));
  }

  RL::Solve_report gradients() const {
    const auto field = [this](const RL::Surface_point& p) {
      return RL::Vector_3(m_in_faces[3 * p.face], m_in_faces[3 * p.face + 1],
                          m_in_faces[3 * p.face + 2]);
    };
    const Eigen::VectorXd load = RL::assemble_gradient_load(m_space, field);
    Eigen::VectorXd x;
    return RL::Poisson_solver(m_space, 0, parameters()).solve(load, x);
  }

  const Options& m_options;
  std::string m_mesh;
  const RL::Triangulated_surface_3& m_surface;
  int m_depth;
  RL::Spline_space_3 m_space;
  std::vector<double> m_at_vertices, m_in_faces;
  RL::Cycle m_cycle = RL::Cycle::V;
};

} // namespace

int main(int argc, char* argv[]) {
  return run_benchmark("iterations_everywhere", [&] {
    Options o;
    Command_line line("usage: iterations_everywhere [OPTION]...");
    line.add("mesh", o.meshes, "files, or names of shared meshes");
    line.add("depth", o.depths, "4 to 8 by default");
    line.add("problem", o.problems, "all by default");
    line.add("cycle", o.cycles, "v, w, or both, the default");
    line.add("limit", o.limit, "iterations at most");
    line.add("tolerance", o.tolerance, "relative residual");
    line.add("stabilization", o.stabilization, "that of the package by default");
    line.add("energy-tolerance", o.energy_tolerance,
             "of fits, relative to what they leave; that of the package by default");
    line.add("threads", o.threads, "at most");
    if(!line.read(argc, argv))
      return 0;
    if(o.problems.empty())
      o.problems = {"poisson_z", "poisson_random", "screened_1e-6", "screened_1", "screened_1e6",
                    "fit_z",     "fit_wave",       "fit_normals",   "fit_random", "gradients"};
    print_header(argc, argv);
    std::printf("# %-18s %5s c %8s", "mesh", "depth", "unknowns");
    for(const std::string& problem : o.problems)
      std::printf(" %s", problem.c_str());
    std::printf("\n");
    const auto limit = limit_threads(o.threads);
    int failures = 0;
    for(const std::string& name : o.meshes)
      try {
        if(const auto mesh = find_mesh(name))
          for(const int depth : o.depths) {
            Case c(o, name.substr(name.rfind('/') + 1), *mesh, depth);
            for(const std::string& cycle : o.cycles)
              c.run(cycle);
          }
      } catch(const std::exception& e) {
        std::printf("# %s: %s\n", name.c_str(), e.what());
        ++failures;
      }
    return failures > 0 ? 1 : 0;
  });
}
