// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// What do the values of many functions at all vertices cost? From a space in memory and a matrix of
// random coefficients to the matrix of values
// - with a Spline_function_3 for each column (one_by_one),
// - with Spline_functions_3 for all columns (together),
// and the largest difference of the two. Seconds, and seconds of all processors together, which
// other programs on the machine disturb less; each is the median of three runs, on one thread, and
// on two with TBB.
//
// usage: evaluation [MESH [DEPTH [NUMBER OF FUNCTIONS]]]
// default: armadillo_mc1m of the shared meshes, 5, 100

#include "support/driver.h"
#include "support/measure.h"
#include "support/package.h"

#include <CGAL/Restricted_laplacian_3/splines/Spline_function_3.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_functions_3.h>

#include <CGAL/Real_timer.h>

#include <Eigen/Core>

#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

namespace {

using namespace benchmarks;

template <class Work> void measure(const char* name, int threads, Work&& work) {
  std::vector<double> seconds, processor_seconds;
  for(int repetition = 0; repetition < 3; ++repetition) {
    CGAL::Real_timer timer;
    timer.start();
    const std::clock_t start = std::clock();
    work();
    processor_seconds.push_back(double(std::clock() - start) / CLOCKS_PER_SEC);
    seconds.push_back(timer.time());
  }
  std::printf("%-12s %7d %9.3f %10.3f\n", name, threads, median(seconds),
              median(processor_seconds));
  std::fflush(stdout);
}

void compare(int argc, char* argv[]) {
  const std::string name = argc > 1 ? argv[1] : "armadillo_mc1m";
  const int depth = argc > 2 ? std::stoi(argv[2]) : 5,
            number_of_functions = argc > 3 ? std::stoi(argv[3]) : 100;
  const auto surface = find_mesh(name);
  if(!surface)
    return;
  print_header(argc, argv);
  for(int threads = 1; threads <= (is_parallel_available() ? 2 : 1); ++threads) {
    [[maybe_unused]] const auto limited = limit_threads(threads);
    const RL::Spline_space_3 space(*surface, space_options(depth, true, threads));
    std::srand(1);
    const Eigen::MatrixXd coefficients =
        Eigen::MatrixXd::Random(static_cast<Eigen::Index>(space.dimension()), number_of_functions);
    if(threads == 1) {
      std::printf("# %s, %zu vertices; depth %d, %zu unknowns; %d functions\n", name.c_str(),
                  surface->number_of_vertices(), depth, space.dimension(), number_of_functions);
      std::printf("# %-10s %7s %9s %10s\n", "what", "threads", "seconds", "processor");
    }
    Eigen::MatrixXd values, expected(surface->number_of_vertices(), number_of_functions);
    measure("one_by_one", threads, [&] {
      for(Eigen::Index k = 0; k < coefficients.cols(); ++k) {
        const std::vector<double> column =
            RL::Spline_function_3(space, coefficients.col(k)).values_at_vertices();
        expected.col(k) = Eigen::Map<const Eigen::VectorXd>(
            column.data(), static_cast<Eigen::Index>(column.size()));
      }
    });
    measure("together", threads,
            [&] { values = RL::Spline_functions_3(space, coefficients).values_at_vertices(); });
    std::printf("# largest difference %g\n", (values - expected).cwiseAbs().maxCoeff());
  }
}

} // namespace

int main(int argc, char* argv[]) {
  return run_benchmark("evaluation", [&] { compare(argc, argv); });
}
