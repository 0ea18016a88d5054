// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// How long does a Poisson problem on several processes take, and what do other preconditioners of
// the same distributed matrix do?
//
//   mpiexec -n R distributed_comparison MESH [--depth D] [--tolerance T...] [--method NAME...]
//                                       [--repetitions K] [--threads T]
//
// MESH is a file, of which the first process reads all. Problem: Laplacian u = z on the surface.
// Method `patches` is Distributed_poisson_solver; others are preconditioners of PETSc's conjugate
// gradients for its matrix, with the settings that solver_comparison has found to be their best:
// - boomeramg: hypre, HMIS coarsening, extended+i interpolation with at most 4 entries a row, one
//   level of aggressive coarsening, symmetric Gauss-Seidel on each rank;
//   boomeramg_l1: with the l1 norms of what couples ranks added to the diagonal, without which it
//   may not be positive definite;
// - boomeramg_classical: Falgout coarsening, classical interpolation;
// - gamg: PETSc's smoothed aggregation, with the constants of the components as near kernel;
//   gamg_sor: the same with Gauss-Seidel in place of Chebyshev as smoother.
// With --threads T one process solves the problem on T threads, without MPI: method `threads`.
//
// Columns: ranks, unknowns, method, tolerance; seconds for the space, for matrices (assembly_s),
// and for the hierarchy (setup_s), of `patches` with matrices of PETSc, of the others the set-up of
// PETSc alone; iterations, seconds of the iteration (the median of K), the residual; largest memory
// of a rank in MiB, up to then; of one application of the preconditioner the milliseconds, and the
// messages and kB that a rank sends, mean and largest.

// before headers of PETSc, which make macros of functions of MPI
#include "support/driver.h"
#include "support/sent_messages.h"

#include "support/distributed.h"
#include "support/measure.h"

#include <CGAL/Restricted_laplacian_3/assembly/assemble.h>
#include <CGAL/Restricted_laplacian_3/distributed/Distributed_poisson_solver.h>
#include <CGAL/Restricted_laplacian_3/problems/Poisson_problem.h>

#include <petscksp.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <map>
#include <string>
#include <utility>
#include <vector>

using namespace benchmarks;

namespace {

using Options = std::vector<std::pair<std::string, std::string>>;

Options with(Options options, const std::string& name, const std::string& value) {
  options.emplace_back(name, value);
  return options;
}

const Options boomeramg = {{"-pc_type", "hypre"},
                           {"-pc_hypre_type", "boomeramg"},
                           {"-pc_hypre_boomeramg_coarsen_type", "HMIS"},
                           {"-pc_hypre_boomeramg_interp_type", "ext+i"},
                           {"-pc_hypre_boomeramg_P_max", "4"},
                           {"-pc_hypre_boomeramg_agg_nl", "1"},
                           {"-pc_hypre_boomeramg_strong_threshold", "0.25"}};

// the options of PETSc that make a method
const std::map<std::string, Options> methods = {
    {"boomeramg", boomeramg},
    {"boomeramg_l1", with(boomeramg, "-pc_hypre_boomeramg_relax_type_all", "l1scaled-SOR/Jacobi")},
    {"boomeramg_classical",
     {{"-pc_type", "hypre"},
      {"-pc_hypre_type", "boomeramg"},
      {"-pc_hypre_boomeramg_coarsen_type", "Falgout"},
      {"-pc_hypre_boomeramg_interp_type", "classical"},
      {"-pc_hypre_boomeramg_strong_threshold", "0.25"}}},
    {"gamg", {{"-pc_type", "gamg"}}},
    {"gamg_sor",
     {{"-pc_type", "gamg"}, {"-mg_levels_ksp_type", "richardson"}, {"-mg_levels_pc_type", "sor"}}}};

struct Row {
  std::string method;
  double tolerance, setup = 0, solve = 0, residual = 0, cycle = 0, messages = 0, kilobytes = 0;
  int iterations = 0;
};

// one application of a preconditioner: how long it takes, and what this rank sends
void measure_cycle(const RL::Communicator& communicator, PC pc, Vec b, Row& row) {
  constexpr int repetitions = 5;
  Vec x = nullptr;
  check(VecDuplicate(b, &x));
  row.cycle = 1e3 * timed(communicator, repetitions, [&] { check(PCApply(pc, b, x)); });
  sent_messages() = {};
  check(PCApply(pc, b, x));
  row.messages = sent_messages().number;
  row.kilobytes = 1e-3 * sent_messages().bytes;
  check(VecDestroy(&x));
}

Row measure_method(const RL::Communicator& communicator, const std::string& name, Mat a,
                   MatNullSpace kernel, Vec b, double tolerance, int repetitions) {
  Row row = {name, tolerance};
  for(const auto& [option, value] : methods.at(name))
    check(PetscOptionsSetValue(nullptr, option.c_str(), value.c_str()));
  KSP solver = nullptr;
  Vec x = nullptr, r = nullptr;
  check(VecDuplicate(b, &x));
  check(VecDuplicate(b, &r));
  row.setup = timed(communicator, 1, [&] {
    check(MatSetNullSpace(a, kernel));
    check(MatSetOption(a, MAT_SYMMETRIC, PETSC_TRUE));
    check(KSPCreate(communicator.get(), &solver));
    check(KSPSetType(solver, KSPCG));
    check(KSPSetNormType(solver, KSP_NORM_UNPRECONDITIONED));
    check(KSPSetOperators(solver, a, a));
    check(KSPSetTolerances(solver, tolerance, PETSC_DEFAULT, PETSC_DEFAULT, 2000));
    check(KSPSetFromOptions(solver));
    check(KSPSetUp(solver));
  });
  row.solve = timed(communicator, repetitions, [&] { check(KSPSolve(solver, b, x)); });
  PetscInt iterations = 0;
  check(KSPGetIterationNumber(solver, &iterations));
  row.iterations = static_cast<int>(iterations);
  check(MatResidual(a, b, x, r));
  PetscReal norm = 0, norm_of_b = 0;
  check(VecNorm(r, NORM_2, &norm));
  check(VecNorm(b, NORM_2, &norm_of_b));
  row.residual = norm / norm_of_b;
  PC pc = nullptr;
  check(KSPGetPC(solver, &pc));
  measure_cycle(communicator, pc, b, row);
  check(KSPDestroy(&solver));
  check(VecDestroy(&x));
  check(VecDestroy(&r));
  check(MatSetNullSpace(a, nullptr));
  for(const auto& option : methods.at(name))
    check(PetscOptionsClearValue(nullptr, option.first.c_str()));
  return row;
}

void print(const RL::Communicator& communicator, std::uint64_t unknowns, double space,
           double assembly, const Row& row) {
  const double mib = communicator.maximum(memory_of_this_rank()), ranks = communicator.size(),
               messages = communicator.sum(row.messages) / ranks,
               most_messages = communicator.maximum(row.messages),
               kilobytes = communicator.sum(row.kilobytes) / ranks,
               most_kilobytes = communicator.maximum(row.kilobytes);
  if(communicator.rank() != 0)
    return;
  std::printf("%5d %9llu %-20s %9.0e %8.2f %10.2f %8.2f %6d %8.2f %9.1e %8.0f %8.1f %7.0f %7.0f "
              "%8.0f %8.0f\n",
              communicator.size(), static_cast<unsigned long long>(unknowns), row.method.c_str(),
              row.tolerance, space, assembly, row.setup, row.iterations, row.solve, row.residual,
              mib, row.cycle, messages, most_messages, kilobytes, most_kilobytes);
  std::fflush(stdout);
}

void run(const RL::Communicator& communicator, const std::string& mesh, int depth,
         const std::vector<double>& tolerances, const std::vector<std::string>& names,
         int repetitions) {
  Measured_space measured(communicator, mesh, depth);
  measured.surface.reset();
  const RL::Distributed_space& space = *measured.space;
  const std::uint64_t unknowns = space.dimension(depth);
  const Eigen::VectorXd load =
      RL::assemble_load(space.part(), [](const RL::Surface_point& p) { return -p.point.z(); });
  for(double tolerance : tolerances) {
    RL::Poisson_solver_options of_solver;
    of_solver.tolerance = tolerance;
    const RL::Distributed_poisson_solver solver(space, 0, {}, of_solver);
    Row row = {"patches", tolerance};
    RL::Solve_report report;
    Eigen::VectorXd x;
    row.solve = timed(communicator, repetitions, [&] { report = solver.solve(load, x); });
    row.setup = communicator.maximum(report.setup_seconds);
    row.iterations = report.iterations;
    row.residual = report.relative_residual;
    const double assembly = communicator.maximum(report.assembly_seconds);
    Vec b = nullptr, unit = nullptr;
    check(MatCreateVecs(solver.matrix(), &unit, &b));
    // the load as PETSc has it: A x of the solution, orthogonal to the kernel
    KSP ksp = solver.ksp();
    check(KSPGetRhs(ksp, &unit) == 0 && unit ? 0 : 1);
    check(VecCopy(unit, b));
    PC pc = nullptr;
    check(KSPGetPC(ksp, &pc));
    measure_cycle(communicator, pc, b, row);
    print(communicator, unknowns, measured.seconds, assembly, row);
    MatNullSpace kernel = nullptr;
    Mat a = nullptr;
    check(KSPGetOperators(ksp, &a, nullptr));
    check(MatGetNullSpace(a, &kernel));
    for(const std::string& name : names)
      if(name != "patches")
        print(
            communicator, unknowns, measured.seconds, assembly,
            measure_method(communicator, name, solver.matrix(), kernel, b, tolerance, repetitions));
    check(VecDestroy(&b));
  }
}

// by one process without MPI
void run_threads(const RL::Communicator& communicator, const std::string& mesh, int depth,
                 const std::vector<double>& tolerances, int repetitions, int threads) {
  const Space_of_threads measured(communicator, mesh, depth, threads);
  const auto f = [](const RL::Surface_point& p) { return p.point.z(); };
  for(double tolerance : tolerances) {
    RL::Poisson_problem problem(f);
    problem.solver.tolerance = tolerance;
    problem.solver.is_parallel = threads > 1;
    std::vector<double> assembly, setup, solve;
    Row row = {"threads_" + std::to_string(threads), tolerance};
    for(int i = 0; i < repetitions; ++i) {
      const RL::Poisson_solution solution = RL::solve_poisson_problem(*measured.space, problem);
      assembly.push_back(solution.assembly_seconds);
      setup.push_back(solution.setup_seconds);
      solve.push_back(solution.solve_seconds);
      row.iterations = solution.iterations;
      row.residual = solution.relative_residual;
    }
    row.setup = median(setup);
    row.solve = median(solve);
    print(communicator, measured.space->dimension(), measured.seconds, median(assembly), row);
  }
}

} // namespace

int main(int argc, char* argv[]) {
  const auto run_all = [&](const RL::Communicator& communicator) {
    std::vector<double> tolerances = {5e-3, 1e-8};
    std::vector<std::string> names = {"boomeramg", "boomeramg_l1", "boomeramg_classical", "gamg",
                                      "gamg_sor"};
    int depth = 8, repetitions = 3, threads = 0;
    std::string mesh;
    Command_line line("usage: distributed_comparison [OPTION]... MESH");
    line.add("depth", depth);
    line.add("tolerance", tolerances);
    line.add("method", names);
    line.add("repetitions", repetitions);
    line.add("threads", threads);
    line.add("mesh", mesh);
    line.add_positional("mesh", 1);
    if(!line.read(argc, argv))
      return;
    line.require("mesh");
    if(communicator.rank() == 0) {
      print_header(argc, argv);
      std::printf("# ranks unknowns method              tolerance  space_s assembly_s  setup_s  "
                  "iter  solve_s  residual      mib cycle_ms messages most_m.     kB  most_kB\n");
    }
    if(threads > 0)
      run_threads(communicator, mesh, depth, tolerances, repetitions, threads);
    else
      run(communicator, mesh, depth, tolerances, names, repetitions);
  };
  return run_on_ranks("distributed_comparison", argc, argv, PetscInitialize, PetscFinalize,
                      run_all);
}
