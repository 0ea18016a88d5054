// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_BENCHMARK_SUPPORT_DISTRIBUTED_H
#define RESTRICTED_LAPLACIAN_3_BENCHMARK_SUPPORT_DISTRIBUTED_H

#include "measure.h"
#include "meshes.h"

#include <CGAL/Restricted_laplacian_3/distributed/Communicator.h>
#include <CGAL/Restricted_laplacian_3/distributed/Distributed_space.h>
#include <CGAL/Restricted_laplacian_3/distributed/Distributed_surface.h>
#include <CGAL/Restricted_laplacian_3/distributed/surface_slices.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <petscsys.h>
#include <sys/resource.h>

#include <cstddef>
#include <cstdio>
#include <exception>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// What benchmarks on several processes share.

namespace benchmarks {

inline void check(PetscErrorCode code) {
  if(code != 0)
    throw std::runtime_error("PETSc failed");
}

// Median of the seconds of `step`, over all ranks the slowest.
template <class Step>
double timed(const RL::Communicator& communicator, int repetitions, Step&& step) {
  std::vector<double> seconds;
  for(int i = 0; i < repetitions; ++i) {
    MPI_Barrier(communicator.get());
    const double start = seconds_now();
    step();
    seconds.push_back(communicator.maximum(seconds_now() - start));
  }
  return median(seconds);
}

// In MiB, the largest up to now.
inline double memory_of_this_rank() {
  rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

// A space whose parts are on all ranks, and how long it took. Rank 0 reads the mesh.
struct Measured_space {
  Measured_space(const RL::Communicator& communicator, const std::string& mesh, int depth) {
    communicator.agree([&] {
      if(communicator.rank() == 0)
        surface = find_mesh(mesh);
      if(communicator.rank() == 0 && !surface)
        throw std::runtime_error("no mesh");
    });
    const RL::Distributed_surface distributed(
        communicator, RL::slice_of_first_rank(communicator, surface ? &*surface : nullptr));
    RL::Spline_space_options options;
    options.depth = depth;
    seconds = timed(communicator, 1, [&] { space.emplace(distributed, options); });
  }

  std::optional<RL::Triangulated_surface_3> surface; // of rank 0
  std::optional<RL::Distributed_space> space;
  double seconds = 0;
};

// A space of one process on some threads.
struct Space_of_threads {
  Space_of_threads(const RL::Communicator& communicator, const std::string& mesh, int depth,
                   int threads)
#ifdef CGAL_LINKED_WITH_TBB
    : limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads))
#endif
  {
    std::optional<RL::Triangulated_surface_3> surface = find_mesh(mesh);
    if(!surface || communicator.size() > 1)
      throw std::runtime_error(surface ? "--threads needs one process" : "no mesh");
    RL::Spline_space_options options;
    options.depth = depth;
    options.is_parallel = threads > 1;
    seconds = timed(communicator, 1, [&] { space.emplace(std::move(*surface), options); });
  }

#ifdef CGAL_LINKED_WITH_TBB
  tbb::global_control limit;
#endif
  std::optional<RL::Spline_space_3> space;
  double seconds = 0;
};

// main() of a benchmark: MPI and a library are there while `run(communicator)` runs.
template <class Initialize, class Finalize, class Run>
int run_on_ranks(const char* name, int argc, char* argv[], Initialize&& initialize,
                 Finalize&& finalize, Run&& run) {
  MPI_Init(&argc, &argv);
  if(initialize(nullptr, nullptr, nullptr, nullptr) != 0)
    return 1;
  int status = 0;
  try {
    run(RL::Communicator());
  } catch(const RL::Distributed_error& e) { // all ranks know of it
    if(RL::Communicator().rank() == 0)
      std::fprintf(stderr, "%s: %s\n", name, e.what());
    status = 1;
  } catch(const std::exception& e) {
    std::fprintf(stderr, "%s: %s\n", name, e.what());
    MPI_Abort(MPI_COMM_WORLD, 1);
  }
  finalize();
  MPI_Finalize();
  return status;
}

} // namespace benchmarks

#endif // RESTRICTED_LAPLACIAN_3_BENCHMARK_SUPPORT_DISTRIBUTED_H
