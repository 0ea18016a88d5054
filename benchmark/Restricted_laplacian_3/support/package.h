// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_BENCHMARK_PACKAGE_H
#define RESTRICTED_LAPLACIAN_3_BENCHMARK_PACKAGE_H

// How the comparisons call the package: one function for each choice that they compare.

#include "measure.h"
#include "meshes.h"

#include <CGAL/Restricted_laplacian_3/assembly/assemble.h>
#include <CGAL/Restricted_laplacian_3/solve_poisson.h>
#include <CGAL/Restricted_laplacian_3/splines/prolongation.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

namespace benchmarks {

namespace RL = CGAL::Restricted_laplacian_3;

inline RL::Spline_space_options space_options(int depth, bool is_split, int threads) {
  RL::Spline_space_options options;
  options.is_parallel = threads > 1;
  options.depth = depth;
  options.split = is_split;
  return options;
}

/// \param stabilization dimensionless, 0 for the system of the paper
inline RL::Operators operators(const RL::Spline_space_3& space, double stabilization) {
  return RL::assemble_operators(space, space.depth(), stabilization);
}

/// the stabilization that the package has unless told otherwise
inline double default_stabilization() { return 1e-3; }

/// whether `threads` has an effect on the solver
constexpr bool is_parallel_available() {
#ifdef CGAL_LINKED_WITH_TBB
  return true;
#else
  return false;
#endif
}

/// Limits the threads of the package for as long as the returned object lives.
inline auto limit_threads(int threads) {
#ifdef CGAL_LINKED_WITH_TBB
  return tbb::global_control(tbb::global_control::max_allowed_parallelism, threads);
#else
  return threads;
#endif
}

/// \param smoother patch, the default of the package, or point
inline RL::Poisson_solver_options solver_options(const std::string& smoother, int threads,
                                                 double tolerance, int maximum_iterations) {
  RL::Poisson_solver_options options;
  options.smoother = smoother == "patch" ? RL::Smoother_type::patch : RL::Smoother_type::point;
  options.is_parallel = threads > 1;
  options.tolerance = tolerance;
  options.maximum_iterations = maximum_iterations;
  return options;
}

/// The matrix of a problem, `stiffness` \f$S\f$ + `mass` \f$M / h^2\f$, \f$h\f$ the width of the
/// finest cells: Poisson, screened, or a fit.
struct System_factors {
  double stiffness = 1, mass = 0;
};

/// What the solver of the package needs besides the matrix of the finest level: the matrices of the
/// coarser ones, which the assembly makes in the same pass, and the seconds that this adds to it.
/// None in the space of the paper, where the solver makes them.
struct Coarse_levels {
  std::vector<RL::Sparse_matrix> matrices;
  double seconds = 0;
};

inline Coarse_levels coarse_levels(const RL::Spline_space_3& space, const System_factors& factors,
                                   double stabilization) {
  Coarse_levels result;
  if(space.is_paper_space())
    return result;
  const double h = space.octree().cell_width(space.depth());
  RL::internal::Elliptic_operator elliptic;
  elliptic.reaction = factors.mass / (h * h);
  elliptic.diffusion = factors.stiffness;
  elliptic.stabilization = stabilization;
  std::array<double, 2> seconds = {1e9, 1e9};
  for(int repetition = 0; repetition < 3; ++repetition)
    for(int is_all = 0; is_all < 2; ++is_all) {
      const double begin = seconds_now();
      auto matrices =
          RL::internal::assemble_system(
              space, is_all ? RL::internal::coarsest_multigrid_level(space) : space.depth(),
              elliptic)
              .matrices;
      seconds[is_all] = std::min(seconds[is_all], seconds_now() - begin);
      if(is_all)
        result.matrices = std::move(matrices);
    }
  result.matrices.pop_back();
  result.seconds = std::max(0., seconds[1] - seconds[0]);
  return result;
}

/// the default solver, with the matrices of all levels from one pass over the surface
inline RL::Poisson_solver poisson_solver(const RL::Spline_space_3& space, double stabilization,
                                         int threads, double tolerance) {
  namespace params = RL::parameters;
  const auto np = params::stabilization(stabilization).tolerance(tolerance);
  return threads > 1
             ? RL::Poisson_solver(space, 0, np.concurrency_tag(CGAL::Parallel_if_available_tag()))
             : RL::Poisson_solver(space, 0, np);
}

} // namespace benchmarks

#endif // RESTRICTED_LAPLACIAN_3_BENCHMARK_PACKAGE_H
