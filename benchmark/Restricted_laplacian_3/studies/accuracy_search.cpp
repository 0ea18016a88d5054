// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// What an accuracy costs: the time of all spaces of the search against that of the last one alone,
// and the error against a deeper space.
//
// Poisson problems with a coordinate as right-hand side, and the first 31 eigenvalues with their
// functions. Errors as in estimate_study.py; NaN where the deeper space would have too many
// unknowns.
//
// usage: accuracy_search [OPTION]... [MESH]...

#include "support/driver.h"
#include "support/measure.h"
#include "support/meshes.h"
#include "support/package.h"

#include <CGAL/Restricted_laplacian_3/laplace_spectrum.h>
#include <CGAL/Restricted_laplacian_3/solve_poisson.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <string>
#include <vector>

namespace RL = CGAL::Restricted_laplacian_3;
namespace params = RL::parameters;
using namespace benchmarks;

namespace {

constexpr int pairs = 31;

struct Options {
  std::vector<std::string> meshes = {"anchor_8k",    "bimba_46k", "bunny_closed_70k", "armadillo",
                                     "itokawa_197k", "cow_5k8",   "fandisk_32k"};
  std::vector<double> accuracies = {1e-2, 1e-3};
  int levels = 1, repetitions = 3;
  std::size_t most_unknowns = 600000;
};

/// a result, and the space that it is in
struct Found {
  RL::Solve_report report;
  Eigen::VectorXd values; // what is compared
  std::size_t unknowns = 0;
  int depth = 0;
};

Found poisson(RL::Spline_space_3 space, double accuracy) {
  const auto f = [](const RL::Surface_point& p) { return p.point.z(); };
  RL::Poisson_problem problem(f);
  const RL::internal::Poisson_solutions u =
      accuracy > 0 ? RL::internal::solve_poisson_to_accuracy(space, problem, accuracy)
                   : RL::internal::solve_poisson_problems(space, problem);
  const std::vector<double> values =
      RL::Spline_function_3(space, u.coefficients.col(0)).values_at_vertices();
  return {u, Eigen::Map<const Eigen::VectorXd>(values.data(), Eigen::Index(values.size())),
          space.dimension(), space.depth()};
}

Found spectrum(RL::Spline_space_3 space, double accuracy) {
  const RL::Laplace_spectrum s =
      accuracy > 0 ? RL::internal::laplace_spectrum_to_accuracy(space, pairs, {}, accuracy)
                   : RL::laplace_spectrum(space, pairs);
  return {s.report, s.eigenvalues, space.dimension(), space.depth()};
}

double error_of(const std::string& problem, const Eigen::VectorXd& found,
                const Eigen::VectorXd& exact) {
  if(problem == "spectrum") {
    const Eigen::Index n = exact.size() - 1;
    return (found.tail(n).array() / exact.tail(n).array() - 1).abs().maxCoeff();
  }
  double sum = 0, all = 0;
  for(Eigen::Index i = 0; i < exact.size(); ++i)
    if(std::isfinite(exact[i]) && std::isfinite(found[i])) {
      sum += (found[i] - exact[i]) * (found[i] - exact[i]);
      all += exact[i] * exact[i];
    }
  return std::sqrt(sum / all);
}

void study(const Options& o, const std::string& name, const RL::Triangulated_surface_3& surface) {
  for(const std::string problem : {"poisson", "spectrum"})
    for(const double accuracy : o.accuracies) {
      const auto solve = [&](int depth, double a) {
        RL::Spline_space_3 space(surface, params::depth(depth));
        return problem == "poisson" ? poisson(space, a) : spectrum(space, a);
      };
      Found found;
      std::vector<double> whole, last;
      for(int i = 0; i < o.repetitions; ++i) {
        double begin = seconds_now();
        found = solve(RL::internal::first_depth_of_search(surface, {}), accuracy);
        whole.push_back(seconds_now() - begin);
        begin = seconds_now();
        static_cast<void>(solve(found.depth, 0));
        last.push_back(seconds_now() - begin);
      }
      double error = std::nan("");
      if(static_cast<double>(found.unknowns) * std::pow(4, o.levels) <=
         static_cast<double>(o.most_unknowns))
        error = error_of(problem, found.values, solve(found.depth + o.levels, 0).values);
      std::printf("%-18s %-8s %8.0e %5d %8zu %8.1e %8s %8.1e %8.3f %8.3f %6.2f %s\n", name.c_str(),
                  problem.c_str(), accuracy, found.depth, found.unknowns,
                  found.report.estimated_error, found.report.is_estimate_trusted ? "yes" : "no",
                  error, median(whole), median(last), median(whole) / median(last),
                  found.report.converged ? "yes" : "no");
      std::fflush(stdout);
    }
}

bool read_options(int argc, char* argv[], Options& o) {
  Command_line line("usage: accuracy_search [OPTION]... [MESH]...");
  line.add("mesh", o.meshes, "files, or names in the folder of shared meshes");
  line.add("accuracy", o.accuracies, "1e-2 1e-3");
  line.add("levels", o.levels, "by which the space of the reference is deeper");
  line.add("most-unknowns", o.most_unknowns, "of the reference");
  line.add("repetitions", o.repetitions);
  line.add_positional("mesh");
  return line.read(argc, argv);
}

} // namespace

int main(int argc, char* argv[]) {
  return run_benchmark("accuracy_search", [&] {
    Options o;
    if(!read_options(argc, argv, o))
      return;
    [[maybe_unused]] const auto limited = limit_threads(1);
    print_header(argc, argv);
    std::printf("# %-16s %-8s %8s %5s %8s %8s %8s %8s %8s %8s %6s %s\n", "mesh", "problem",
                "accuracy", "depth", "unknowns", "estimate", "trusted", "error", "whole_s",
                "last_s", "ratio", "ok");
    for(const std::string& name : o.meshes)
      if(const auto surface = find_mesh(name))
        study(o, name, *surface);
  });
}
