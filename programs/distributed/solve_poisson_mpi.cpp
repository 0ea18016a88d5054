// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Solves a Poisson problem on a mesh by several processes, and writes the solution at its vertices.

#include "../support/point_input.h"
#include "../support/poisson_input.h"
#include "../support/solver_options.h"
#include "../support/vertex_data.h"
#include "mpi_program.h"

#include <CGAL/Restricted_laplacian_3/assembly/assemble.h>
#include <CGAL/Restricted_laplacian_3/distributed/Distributed_poisson_solver.h>
#include <CGAL/Restricted_laplacian_3/distributed/vertex_values.h>
#include <CGAL/Restricted_laplacian_3/patches/smooth_vertex_data.h>

#include <CGAL/Real_timer.h>

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

using namespace programs;

const Help help = {"mpiexec -n N solve_poisson_mpi MESH [OPTION]... [PETSC_OPTION]...", R"(
Solves Laplacian u = f on a surface, or with --alpha A the screened problem
(A / area) u - Laplacian u = f, as solve_poisson does, by N processes on one or several
machines. Each holds a part of the surface and of the unknowns; the solution is the same.

Of a binary PLY file of triangles each process reads a part; files of other kinds are read
by the first one. All must see the folders of MESH and of what is written.

PETSC_OPTION is an option of PETSc, with one hyphen, behind all others: -ksp_monitor,
-log_view, -pc_type gamg. They apply to its conjugate gradients and multigrid.

With --save, the solution is written as coefficients of the finite elements. With
--continue, another run begins with it, and may have another number of processes.
)" + std::string(about_meshes) + about_points,
                   R"(  mpiexec -n 4 solve_poisson_mpi dragon.ply --depth 10 --output u.ply
      the solution for f = z
  mpiexec -n 2 solve_poisson_mpi elephant.off --rhs x --csv u.csv -ksp_monitor
      with the residual of each iteration
)"};

struct Options : Common_options,
                 Point_options,
                 Solver_options,
                 Poisson_options,
                 Continuation_options {
  Options() : Solver_options(RL::Poisson_solver_options::default_tolerance) {}

  std::string cycle = "v";
};

// returns false if there is nothing more to do
bool read_options(int argc, char* argv[], Options& o, po::variables_map& given) {
  po::options_description problem("Problem", help_width);
  add_poisson_options(problem, o);
  po::options_description solver = solver_options(o, "default 0.001");
  auto add = solver.add_options();
  add("cycle", po::value(&o.cycle)->value_name("v|w")->default_value(o.cycle), "multigrid cycle");
  po::options_description general = mpi_general_options(o);
  general.add_options()("seed", po::value(&o.seed)->value_name("S")->default_value(o.seed),
                        "seed of the random numbers of --rhs random");
  po::options_description all(help_width);
  all.add(problem)
      .add(space_options(o))
      .add(point_options(o, o))
      .add(solver)
      .add(mpi_output_options(o, "vertex, value", "the property value"))
      .add(continuation_options(o, "write the coefficients of the solution",
                                "begin with the solution in a file that --save has written"))
      .add(general);
  if(!parse_command_line(argc, argv, help, all, o, given))
    return false;
  check_mpi_options(o, given);
  check_poisson_options(o, given);
  check_solver_options(o, given);
  require_choice("cycle", o.cycle, {"v", "w"});
  require(given.count("energy-tolerance") == 0,
          "--energy-tolerance is not possible on several processes");
  require(o.seed >= 0, "the argument of --seed must not be negative");
  return true;
}

// f at the vertices of the slice of this rank
std::vector<double> right_hand_side(const RL::Distributed_surface& surface, const Options& o) {
  const RL::Communicator& communicator = surface.communicator();
  const auto rank = static_cast<std::size_t>(communicator.rank());
  const std::size_t first = surface.first_vertices()[rank],
                    last = surface.first_vertices()[rank + 1];
  if(!o.rhs_property.empty()) {
    std::vector<std::vector<double>> slices(static_cast<std::size_t>(communicator.size()));
    communicator.agree([&] {
      if(rank != 0)
        return;
      const std::vector<double> f = read_vertex_property(o.mesh, o.rhs_property);
      require(f.size() == surface.number_of_vertices(), "not every vertex has a value");
      for(std::size_t r = 0; r < slices.size(); ++r)
        slices[r].assign(f.begin() + static_cast<std::ptrdiff_t>(surface.first_vertices()[r]),
                         f.begin() + static_cast<std::ptrdiff_t>(surface.first_vertices()[r + 1]));
    });
    return communicator.exchange(slices).front();
  }
  std::vector<double> f;
  communicator.agree([&] {
    if(o.rhs == "random")
      f = random_values(first, last, o.seed);
    else
      for(const RL::Point_3& p : surface.points())
        f.push_back(p[o.rhs[0] - 'x']);
  });
  return f;
}

// Vertices without a face of positive area are not on the surface, and f may be anything there.
void check_right_hand_side(const RL::Surface_part& part, const std::vector<double>& f) {
  for(std::size_t i = 0; i < part.faces.size(); ++i)
    for(std::uint32_t vertex : part.surface.triangle(i))
      require(part.surface.is_degenerate(i) || std::isfinite(f[vertex]),
              "the right-hand side is not a finite number at vertex " +
                  std::to_string(part.vertices[vertex]));
}

int solve(const RL::Communicator& communicator, const Options& o, const po::variables_map& given) {
  const bool is_first = communicator.rank() == 0;
  bool is_triangulated = false;
  const RL::Distributed_surface surface =
      read_distributed(communicator, o, o, given, is_triangulated);
  CGAL::Real_timer timer;
  timer.start();
  Summary summary(surface, is_triangulated);
  summary.add_detail("ranks", communicator.size());
  const std::vector<double> f = right_hand_side(surface, o);
  const RL::Distributed_space space(surface, distributed_options(surface, o));
  add_space(summary, space,
            o.alpha == 0 ? "on each component f and u have mean 0"
                         : "components do not influence each other");
  const double space_seconds = timer.time();
  RL::Poisson_solver_options solver_options;
  solver_options.tolerance = o.tolerance;
  solver_options.cycle = o.cycle == "v" ? RL::Cycle::V : RL::Cycle::W;
  const auto stabilization =
      o.stabilization < 0 ? std::nullopt : std::optional<double>(o.stabilization);
  const RL::Distributed_poisson_solver solver(space, o.alpha / surface.area(), stabilization,
                                              solver_options);
  const double before_load = timer.time();
  const std::vector<double> values = vertex_values_of_part(surface, space, f);
  Eigen::VectorXd load, u, integrals;
  communicator.agree([&] {
    check_right_hand_side(space.surface_part(), values);
    load = RL::assemble_load(space.part(), RL::Cubic_surface_function<double>(values));
    integrals = RL::assemble_element_integrals(space.part());
  });
  // Without screening it is a matter of the solver that f has mean 0.
  if(o.alpha > 0)
    load -= communicator.sum(load.sum()) / surface.area() * integrals;
  else
    load = -load;
  const double load_seconds = timer.time() - before_load;
  const RL::Distributed_functions begin = load_begin(space, o);
  if(begin.values.size() > 0)
    u = begin.coefficients.col(0);
  const RL::Solve_report report = solver.solve(load, u, begin.values.size() > 0);
  if(!o.save.empty())
    RL::save_functions(space, o.save, {Eigen::VectorXd::Zero(1), u});
  const std::vector<double> at_vertices = values_at_vertices(surface, space, u);

  if(o.alpha == 0)
    summary.add_detail("kernel_dimension", solver.kernel_dimension());
  summary.add_detail("setup_seconds", space_seconds + report.setup_seconds);
  summary.add_detail("assembly_seconds", report.assembly_seconds + load_seconds);
  summary.add_detail("solve_seconds", report.solve_seconds);
  summary.add_detail("iterations", report.iterations);
  summary.add_detail("relative_residual", report.relative_residual);
  const Range range(communicator, at_vertices);
  summary.add("minimum", range.low);
  summary.add("maximum", range.high);
  summary.add("mean", surface_mean(surface, at_vertices));
  summary.add("seconds", timer.time());
  if(!o.csv.empty())
    write_csv(surface, o.csv, summary, at_vertices);
  if(!o.output.empty())
    write_ply(surface, o.output, at_vertices, range);
  if(!o.quiet)
    summary.print(std::cout, o.verbose);
  if(report.converged)
    return success;
  if(is_first)
    print_error("solve_poisson_mpi",
                "the solver did not converge: the iteration " + to_string(report.status));
  return not_converged;
}

int main(int argc, char* argv[]) {
  return run_mpi_program("solve_poisson_mpi", argc, argv, read_options, solve);
}
