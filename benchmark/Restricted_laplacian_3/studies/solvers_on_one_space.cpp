// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// What does a space spare those who solve more than one problem on it? Processor seconds, on one
// thread, medians of three runs, for
// - a solver of (S + alpha M) x = b that is made of the space (solver),
// - the operators of all levels (operators), and a solver with another alpha that is made of them
//   (of_operators),
// - a solver for another diffusion tensor (tensor),
// - 20 implicit steps of the heat flow to 1e-8 (steps), and the same from the solution before as a
//   first guess (guess), with the iterations that they take together.
//
// usage: solvers_on_one_space [MESH DEPTH]...
// default: cow_5k8 6 bunny_closed_70k 6 armadillo 7 of the shared meshes

#include "support/driver.h"
#include "support/measure.h"
#include "support/package.h"

#include <CGAL/Restricted_laplacian_3/integration/Weighted_integration.h>

#include <Eigen/Core>

#include <cstdio>
#include <ctime>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace benchmarks;

template <class Work> void measure(const std::string& mesh, const char* name, Work&& work) {
  std::vector<double> seconds;
  int iterations = 0;
  for(int repetition = 0; repetition < 3; ++repetition) {
    const std::clock_t start = std::clock();
    iterations = work();
    seconds.push_back(double(std::clock() - start) / CLOCKS_PER_SEC);
  }
  std::printf("%-18s %-13s %9.3f %11d\n", mesh.c_str(), name, median(seconds), iterations);
  std::fflush(stdout);
}

/// \return iterations of all steps
int flow_heat(const RL::Poisson_solver& solver, const RL::Sparse_matrix& mass, double tau,
              const Eigen::VectorXd& load_at_the_beginning, bool has_first_guess) {
  RL::Solve_options options(1e-8);
  Eigen::VectorXd load = load_at_the_beginning, u;
  int iterations = 0;
  for(int step = 0; step < 20; ++step) {
    iterations += solver.solve(load / tau, u, options).iterations;
    load = mass * u;
    options.has_first_guess = has_first_guess;
  }
  return iterations;
}

void compare(const std::string& name, int depth) {
  const auto surface = find_mesh(name);
  if(!surface)
    return;
  const RL::Spline_space_3 space(*surface, space_options(depth, true, 1));
  const double alpha = 1e3 / space.surface().area();
  std::printf("# %s, depth %d, %zu unknowns\n", name.c_str(), depth, space.dimension());
  measure(name, "solver", [&] {
    RL::Poisson_solver(space, alpha);
    return 0;
  });
  std::vector<RL::Operators> operators;
  measure(name, "operators", [&] {
    operators = RL::multigrid_operators(space);
    return 0;
  });
  measure(name, "of_operators", [&] {
    RL::Poisson_solver(space, operators, 2 * alpha);
    return 0;
  });
  const auto tensor = [](const RL::Surface_point&) {
    return RL::Symmetric_tensor_3{2, 1, 1, 0, 0, 0};
  };
  measure(name, "tensor", [&] {
    RL::Poisson_solver(space.integrated_by(RL::Diffusion_integration(space.integration(), tensor)),
                       alpha);
    return 0;
  });
  const RL::Poisson_solver solver(space, operators, alpha);
  const RL::Triangulated_surface_3& triangles = space.surface();
  const RL::Point_3 center = triangles.point(0, 0);
  const Eigen::VectorXd load = RL::assemble_load(space, [&](const RL::Surface_point& p) {
    return 1 / (1 + 100 / triangles.area() * CGAL::squared_distance(p.point, center));
  });
  const auto flow = [&](bool has_first_guess) {
    return flow_heat(solver, operators.back().mass, 1 / alpha, load, has_first_guess);
  };
  measure(name, "steps", [&] { return flow(false); });
  measure(name, "guess", [&] { return flow(true); });
}

} // namespace

int main(int argc, char* argv[]) {
  return run_benchmark("solvers_on_one_space", [&] {
    std::vector<std::pair<std::string, int>> cases;
    for(int i = 1; i + 1 < argc; i += 2)
      cases.emplace_back(argv[i], std::stoi(argv[i + 1]));
    if(cases.empty())
      cases = {{"cow_5k8", 6}, {"bunny_closed_70k", 6}, {"armadillo", 7}};
    print_header(argc, argv);
    [[maybe_unused]] const auto limited = limit_threads(1);
    std::printf("# %-16s %-13s %9s %11s\n", "mesh", "what", "seconds", "iterations");
    for(const auto& [name, depth] : cases)
      compare(name, depth);
  });
}
