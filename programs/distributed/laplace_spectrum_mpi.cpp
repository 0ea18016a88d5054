// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Computes the smallest eigenvalues of the Laplacian on a mesh by several processes, and writes one
// eigenfunction.

#include "../support/point_input.h"
#include "../support/spectrum.h"
#include "../support/table.h"
#include "mpi_program.h"

#include <CGAL/Restricted_laplacian_3/distributed/Distributed_functions.h>
#include <CGAL/Restricted_laplacian_3/distributed/Distributed_spectrum.h>
#include <CGAL/Restricted_laplacian_3/distributed/vertex_values.h>

#include <CGAL/Real_timer.h>

#include <Eigen/Core>

#include <cmath>
#include <string>
#include <vector>

using namespace programs;

const Help help = {
    "mpiexec -n N laplace_spectrum_mpi MESH [OPTION]... [PETSC_OPTION]...", R"(
Computes the smallest eigenvalues of the Laplacian on a surface, the smallest numbers l for
which -Laplacian u = l u has a solution, as laplace_spectrum does, by N processes on one or
several machines. Each holds a part of the surface and of the unknowns.

Of a binary PLY file of triangles each process reads a part; files of other kinds are read
by the first one. All must see the folders of MESH and of what is written.

With --save, eigenpairs are written as soon as they are found, and at the end. A run that
was cut off, or is to have more of them, goes on with --continue. The number of processes
may be another one.

PETSC_OPTION is an option of PETSc or SLEPc, with one hyphen, behind all others:
-eps_monitor, -log_view, or -eps_type gd for generalized Davidson in place of LOBPCG.
)" + std::string(about_meshes) + about_points,
    R"(  mpiexec -n 4 laplace_spectrum_mpi dragon.ply --count 50 --csv eigenvalues.csv
      a table of 50 eigenvalues
  mpiexec -n 4 laplace_spectrum_mpi dragon.ply --count 100 --save pairs --continue pairs
      goes on with the eigenpairs in the file, if there is one
)"};

struct Options : Common_options, Point_options, Eigensolver_options, Continuation_options {
  int count = 20, eigenfunction = 1;
};

// returns false if there is nothing more to do
bool read_options(int argc, char* argv[], Options& o, po::variables_map& given) {
  po::options_description problem("Problem", help_width);
  auto add = problem.add_options();
  add("count", po::value(&o.count)->value_name("K")->default_value(o.count),
      "number of eigenvalues, with multiplicities");
  add("eigenfunction", po::value(&o.eigenfunction)->value_name("I")->default_value(o.eigenfunction),
      "index, from 0, of the eigenfunction for --output");
  po::options_description all(help_width);
  all.add(problem)
      .add(eigensolver_options(o, false))
      .add(space_options(o))
      .add(point_options(o, o))
      .add(mpi_output_options(o, "index, eigenvalue", "the property value, the eigenfunction"))
      .add(continuation_options(o, "write eigenpairs, whenever more have been found",
                                "begin with the eigenpairs in a file that --save has written"))
      .add(mpi_general_options(o));
  if(!parse_command_line(argc, argv, help, all, o, given))
    return false;
  check_mpi_options(o, given);
  require(o.count > 0, "the argument of --count must be positive");
  check_eigensolver_options(o, given, false);
  if(given["eigenfunction"].defaulted())
    o.eigenfunction = std::min(o.eigenfunction, o.count - 1);
  require(o.eigenfunction >= 0 && o.eigenfunction < o.count,
          "the argument of --eigenfunction must be at least 0 and less than that of --count");
  return true;
}

int solve(const RL::Communicator& communicator, const Options& o, const po::variables_map& given) {
  bool is_triangulated = false;
  const RL::Distributed_surface surface =
      read_distributed(communicator, o, o, given, is_triangulated);
  CGAL::Real_timer timer;
  timer.start();
  Summary summary(surface, is_triangulated);
  summary.add_detail("ranks", communicator.size());
  const RL::Distributed_space space(surface, distributed_options(surface, o));
  add_space(summary, space, "each has the eigenvalue 0");
  const double space_seconds = timer.time();
  RL::Laplace_spectrum_options options;
  options.eigenvalues_only = o.output.empty() && o.save.empty();
  if(o.stabilization >= 0)
    options.stabilization = o.stabilization;
  if(o.tolerance > 0)
    options.multigrid.tolerance = o.tolerance;
  RL::Distributed_spectrum_state state;
  state.known = load_begin(space, o);
  if(!o.save.empty())
    state.found = [&](const RL::Distributed_functions& pairs) {
      RL::save_functions(space, o.save, pairs);
    };
  const RL::Distributed_spectrum spectrum = RL::laplace_spectrum(space, o.count, options, state);
  const RL::Distributed_functions& pairs = spectrum.pairs;
  if(!o.save.empty())
    RL::save_functions(space, o.save, pairs);

  summary.add_detail("setup_seconds", space_seconds + spectrum.report.setup_seconds);
  summary.add_detail("assembly_seconds", spectrum.report.assembly_seconds);
  summary.add_detail("solve_seconds", spectrum.report.solve_seconds);
  summary.add_detail("iterations", spectrum.report.iterations);
  summary.add_detail("relative_residual", spectrum.report.relative_residual);
  if(!o.begin.empty())
    summary.add_detail("eigenpairs_known_before", spectrum.number_of_known);
  summary.add("seconds", timer.time());
  if(!o.csv.empty())
    communicator.agree([&] {
      if(communicator.rank() == 0)
        programs::write_csv(o.csv, summary, "index", {"eigenvalue"}, pairs.values);
    });
  if(!o.output.empty()) {
    // no eigenfunction, unless it is found
    std::vector<double> at_vertices(surface.points().size(), std::nan(""));
    if(o.eigenfunction < pairs.values.size())
      at_vertices = values_at_vertices(surface, space, pairs.coefficients.col(o.eigenfunction));
    write_ply(surface, o.output, at_vertices, Range(communicator, at_vertices));
  }
  if(!o.quiet) {
    summary.print(std::cout, o.verbose);
    print_eigenvalues(std::cout, pairs.values);
  }
  if(spectrum.report.converged)
    return success;
  if(communicator.rank() == 0)
    print_error("laplace_spectrum_mpi", "the solver did not converge: it found " +
                                            std::to_string(pairs.values.size()) + " of " +
                                            std::to_string(o.count) + " eigenvalues");
  return not_converged;
}

int main(int argc, char* argv[]) {
  return run_mpi_program("laplace_spectrum_mpi", argc, argv, read_options, solve);
}
