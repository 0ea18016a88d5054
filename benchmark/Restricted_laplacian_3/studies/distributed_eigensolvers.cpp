// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// How long do the smallest eigenpairs take on several processes?
//
//   mpiexec -n R distributed_eigensolvers MESH [--depth D] [--pairs K...] [--tolerance T...]
//                                         [--method NAME...] [--threads T]
//
// MESH is a file, of which the first process reads all. All methods are eigensolvers of SLEPc in
// laplace_spectrum() of a Distributed_space, and begin with the eigenvectors of the next coarser
// level:
// - lobpcg: the default, preconditioned by a cycle of our multigrid;
// - gd: generalized Davidson with the same preconditioner, in blocks of 4 vectors, with a basis of
//   32 to 96, which is what 20 pairs take least time with;
// - krylovschur: shift-invert, by a Cholesky factorization of MUMPS, with room for twice as many
//   entries as it expects, which are not enough.
// With --threads T one process on T threads, without MPI: multigrid_eigenpairs(), method `threads`.
//
// Columns: ranks, unknowns, method, pairs, tolerance; seconds for the space, for matrices
// (assembly_s), for the hierarchy (setup_s), and for the eigensolver on all levels (solve_s);
// iterations on the finest level; pairs found; the largest residual; if all were found, the largest
// relative difference of an eigenvalue, 0 aside, to multigrid_eigenpairs() at 1e-8; largest memory
// of a rank in MiB, up to then, without the first rank, which has computed the latter, if there are
// others.

#include "support/distributed.h"
#include "support/driver.h"
#include "support/measure.h"

#include <CGAL/Restricted_laplacian_3/distributed/Distributed_spectrum.h>
#include <CGAL/Restricted_laplacian_3/problems/space_spectrum.h>

#include <Eigen/Core>

#include <slepceps.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <string>
#include <utility>
#include <vector>

using namespace benchmarks;

namespace {

// the options of SLEPc that make a method
const std::map<std::string, std::vector<std::pair<std::string, std::string>>> methods = {
    {"lobpcg", {}},
    {"gd",
     {{"-eps_type", "gd"},
      {"-eps_gd_blocksize", "4"},
      {"-eps_gd_minv", "32"},
      {"-eps_gd_initial_size", "32"},
      {"-eps_ncv", "96"}}},
    {"krylovschur",
     {{"-eps_type", "krylovschur"},
      {"-st_type", "shift"},
      {"-st_ksp_type", "preonly"},
      {"-st_pc_type", "cholesky"},
      {"-st_pc_factor_mat_solver_type", "mumps"},
      {"-st_mat_mumps_icntl_14", "100"}}}};

struct Row {
  std::string method;
  int pairs;
  double tolerance;
  RL::Solve_report report = {};
  Eigen::VectorXd eigenvalues = {};
};

void print(const RL::Communicator& communicator, double unknowns, double space, double memory,
           const Eigen::VectorXd& reference, const Row& row) {
  if(communicator.rank() != 0)
    return;
  const Eigen::Index n = row.eigenvalues.size();
  double error = n == row.pairs ? 0 : NAN;
  for(Eigen::Index i = 0; n == row.pairs && i < n; ++i)
    if(reference[i] > 1e-9 * reference[n - 1])
      error = std::max(error, std::abs(row.eigenvalues[i] / reference[i] - 1));
  std::printf("%5d %9.0f %-12s %5d %9.0e %7.2f %10.2f %7.2f %8.2f %5d %5d %9.1e %8.1e %7.0f\n",
              communicator.size(), unknowns, row.method.c_str(), row.pairs, row.tolerance, space,
              row.report.assembly_seconds, row.report.setup_seconds, row.report.solve_seconds,
              row.report.iterations, static_cast<int>(n), row.report.relative_residual, error,
              memory);
  std::fflush(stdout);
}

// by one process
RL::Laplace_spectrum spectrum_of(const RL::Spline_space_3& space, int pairs, double tolerance) {
  RL::Laplace_spectrum_options options;
  options.eigensolver = RL::Eigensolver::multigrid;
  options.multigrid.tolerance = tolerance;
  return RL::laplace_eigenpairs(space, pairs, options);
}

struct Task {
  std::string mesh;
  int depth = 6, threads = 0;
  std::vector<int> pairs = {20};
  std::vector<double> tolerances = {1e-6};
  std::vector<std::string> methods = {"lobpcg"};
};

constexpr double tolerance_of_reference = 1e-8;

void run(const RL::Communicator& communicator, const Task& task) {
  const Measured_space measured(communicator, task.mesh, task.depth);
  const RL::Distributed_space& space = *measured.space;
  for(int pairs : task.pairs) {
    Eigen::VectorXd reference;
    communicator.agree([&] {
      if(communicator.rank() != 0)
        return;
      RL::Spline_space_options options;
      options.depth = task.depth;
      const RL::Spline_space_3 whole(*measured.surface, options);
      reference = spectrum_of(whole, pairs, tolerance_of_reference).eigenvalues;
    });
    for(double tolerance : task.tolerances)
      for(const std::string& name : task.methods) {
        for(const auto& [option, value] : methods.at(name))
          check(PetscOptionsSetValue(nullptr, option.c_str(), value.c_str()));
        RL::Laplace_spectrum_options options;
        options.multigrid.tolerance = tolerance;
        const RL::Distributed_spectrum spectrum = RL::laplace_spectrum(space, pairs, options);
        for(const auto& option : methods.at(name))
          check(PetscOptionsClearValue(nullptr, option.first.c_str()));
        Row row = {name, pairs, tolerance, spectrum.report, spectrum.pairs.values};
        row.report.assembly_seconds = communicator.maximum(row.report.assembly_seconds);
        row.report.setup_seconds = communicator.maximum(row.report.setup_seconds);
        row.report.solve_seconds = communicator.maximum(row.report.solve_seconds);
        const bool counts = communicator.rank() > 0 || communicator.size() == 1;
        const double memory = communicator.maximum(counts ? memory_of_this_rank() : 0);
        print(communicator, static_cast<double>(space.dimension(task.depth)), measured.seconds,
              memory, reference, row);
      }
  }
}

// by one process without MPI
void run_threads(const RL::Communicator& communicator, const Task& task) {
  const Space_of_threads measured(communicator, task.mesh, task.depth, task.threads);
  for(int pairs : task.pairs)
    for(double tolerance : task.tolerances) {
      const RL::Laplace_spectrum spectrum = spectrum_of(*measured.space, pairs, tolerance);
      print(communicator, static_cast<double>(measured.space->dimension()), measured.seconds,
            memory_of_this_rank(),
            spectrum_of(*measured.space, pairs, tolerance_of_reference).eigenvalues,
            {"threads_" + std::to_string(task.threads), pairs, tolerance, spectrum.report,
             spectrum.eigenvalues});
    }
}

} // namespace

int main(int argc, char* argv[]) {
  const auto run_all = [&](const RL::Communicator& communicator) {
    Task task;
    Command_line line("usage: distributed_eigensolvers [OPTION]... MESH");
    line.add("depth", task.depth);
    line.add("pairs", task.pairs);
    line.add("tolerance", task.tolerances);
    line.add("method", task.methods);
    line.add("threads", task.threads);
    line.add("mesh", task.mesh);
    line.add_positional("mesh", 1);
    if(!line.read(argc, argv))
      return;
    line.require("mesh");
    if(communicator.rank() == 0) {
      print_header(argc, argv);
      std::printf("# ranks unknowns method       pairs tolerance space_s assembly_s setup_s  "
                  "solve_s  iter found  residual    error     mib\n");
    }
    if(task.threads > 0)
      run_threads(communicator, task);
    else
      run(communicator, task);
  };
  return run_on_ranks("distributed_eigensolvers", argc, argv, SlepcInitialize, SlepcFinalize,
                      run_all);
}
