// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Poisson problems on several processes, against the solver of one process.

#include "../catch.h"
#include "../special_shapes.h"
#include "../test_meshes.h"
#include "slices.h"

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Restricted_laplacian_3/assembly/assemble.h>
#include <CGAL/Restricted_laplacian_3/assembly/shared/assemble_system.h>
#include <CGAL/Restricted_laplacian_3/distributed/Distributed_poisson_solver.h>
#include <CGAL/Restricted_laplacian_3/distributed/internal/Distributed_multigrid.h>
#include <CGAL/Restricted_laplacian_3/problems/Poisson_problem.h>
#include <CGAL/Restricted_laplacian_3/problems/stabilization.h>
#include <CGAL/Restricted_laplacian_3/splines/prolongation.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace RL = CGAL::Restricted_laplacian_3;
using shapes::Triangles;

struct Result {
  int iterations, iterations_of_one;
  double difference;
};

double f(const RL::Surface_point& p) { return p.point.x() + 0.3 * p.point.y() * p.point.z(); }

Result solve(const RL::Triangulated_surface_3& surface, int depth, double alpha, double tolerance,
             const RL::Communicator& communicator = RL::Communicator(),
             const RL::Surface_material& material = {}) {
  RL::Spline_space_options options;
  options.depth = depth;
  options.material = material;
  const RL::Distributed_surface distributed(communicator, slice_of(surface, communicator));
  const RL::Distributed_space space(distributed, options);
  RL::Poisson_solver_options solver_options;
  solver_options.tolerance = tolerance;
  const RL::Distributed_poisson_solver solver(space, alpha, {}, solver_options);
  Eigen::VectorXd load = RL::assemble_load(space.part(), f), x;
  if(alpha == 0)
    load = -load;
  const RL::Solve_report report = solver.solve(load, x);
  CHECK(report.converged);
  CHECK(report.relative_residual <= 1.1 * tolerance);

  const RL::Spline_space_3 whole(surface, options);
  RL::Poisson_problem problem(f);
  problem.alpha = alpha;
  problem.solver = solver_options;
  const RL::Poisson_solution expected = RL::solve_poisson_problem(whole, problem);
  CHECK(solver.kernel_dimension() == expected.kernel_dimension);
  // Coefficients are not unique, functions are.
  double largest = 0, difference = 0;
  for(std::size_t sheet = 0; sheet < space.part().number_of_sheets(depth); ++sheet) {
    const auto& elements = space.part().elements(depth, sheet);
    const auto& all = whole.elements(depth, space.level(depth).first_sheet + sheet);
    const auto values = RL::Tensor_basis_3::values({0.4, 0.5, 0.3});
    double u = 0, v = 0;
    for(std::size_t i = 0; i < elements.size(); ++i)
      if(elements[i] != RL::no_element) {
        u += values[i] * x[elements[i]];
        v += values[i] * expected.coefficients[all[i]];
      }
    largest = (std::max)(largest, std::abs(v));
    difference = (std::max)(difference, std::abs(u - v));
  }
  return {report.iterations, expected.iterations,
          communicator.maximum(difference) / communicator.maximum(largest)};
}

RL::Triangulated_surface_3 surface_of(const Triangles& t) {
  return RL::Triangulated_surface_3(t.points, t.faces);
}

} // namespace

TEST_CASE("poisson_problems_of_shapes_on_ranks", "[shapes]") {
  const std::vector<std::pair<std::string, Triangles>> surfaces = {
      {"sphere", shapes::sphere(3)},
      {"box", shapes::box(1, 1, 0.05, 3, 1)},
      {"two", shapes::joined(shapes::sphere(2), shapes::moved(shapes::sphere(2), {3, 0.1, 0}))}};
  for(const auto& [name, t] : surfaces)
    for(int depth : {1, 3, 5})
      for(double alpha : {0., 2.}) {
        INFO(name << ", depth " << depth << ", alpha " << alpha);
        const Result result = solve(surface_of(t), depth, alpha, 1e-10);
        CHECK(result.difference <= 1e-7);
        // small problems are solved directly by one process
        CHECK(result.iterations <= (std::max)(result.iterations_of_one + 1, 8));
      }
}

TEST_CASE("many_components_on_ranks", "[shapes]") {
  // scraps of a scan: each has a constant that no level sees
  Triangles scraps = shapes::sphere(2);
  for(int i = 0; i < 40; ++i)
    scraps =
        shapes::joined(scraps, shapes::moved(shapes::rectangle(0.02 * (1 + i % 7), 0.15),
                                             {1.5 + 0.37 * (i % 6), 0.41 * (i / 6), 0.01 * i}));
  for(int depth : {4, 5, 6}) {
    INFO("depth " << depth);
    const Result result = solve(surface_of(scraps), depth, 0, 1e-10);
    CHECK(result.difference <= 1e-7);
    CHECK(result.iterations <= result.iterations_of_one + 2);
  }
}

TEST_CASE("materials_on_ranks", "[shapes]") {
  const RL::Triangulated_surface_3 sphere = surface_of(shapes::sphere(3));
  for(int depth : {3, 5})
    for(double alpha : {0., 2.}) {
      INFO("depth " << depth << ", alpha " << alpha);
      const Result result = solve(sphere, depth, alpha, 1e-10, RL::Communicator(), some_material());
      CHECK(result.difference <= 1e-7);
      CHECK(result.iterations <= (std::max)(result.iterations_of_one + 1, 8));
    }
  // property maps belong to a mesh that no rank has as a whole
  RL::Spline_space_options options;
  options.depth = 3;
  options.has_material_of_maps = true;
  const RL::Communicator communicator;
  const RL::Distributed_surface surface(communicator, slice_of(sphere, communicator));
  CHECK_THROWS_WITH(RL::Distributed_space(surface, options), Catch::Contains("not a property map"));
}

TEST_CASE("iterations_do_not_depend_on_the_number_of_ranks", "[shapes]") {
  const RL::Triangulated_surface_3 surface = surface_of(shapes::stairs(8, 0.1));
  const Result of_all = solve(surface, 6, 0, 1e-8),
               of_one = solve(surface, 6, 0, 1e-8, RL::Communicator(MPI_COMM_SELF));
  CHECK(of_all.iterations == of_one.iterations);
}

TEST_CASE("matrices_and_options_are_those_of_petsc", "[shapes]") {
  const Spaces spaces(surface_of(shapes::sphere(3)), 5);
  const RL::Distributed_space& space = spaces.distributed;
  RL::Poisson_solver_options solver_options;
  solver_options.tolerance = 1e-8;
  const Eigen::VectorXd load = RL::assemble_load(space.part(), f);
  Eigen::VectorXd x, y;
  {
    const RL::Distributed_poisson_solver solver(space, 3, {}, solver_options);
    const RL::Solve_report report = solver.solve(load, x);
    CHECK(report.converged);
    KSPType type = nullptr;
    REQUIRE(KSPGetType(solver.ksp(), &type) == 0);
    CHECK(std::string(type) == KSPCG);

    // S + 3 M of one process
    const RL::Operators o =
        RL::assemble_operators(spaces.whole, {}, RL::default_stabilization(spaces.whole));
    const RL::Sparse_matrix a = o.stiffness + 3 * o.mass;
    PetscInt rows = 0, first = 0, last = 0;
    REQUIRE(MatGetSize(solver.matrix(), &rows, nullptr) == 0);
    REQUIRE(rows == a.rows());
    REQUIRE(MatGetOwnershipRange(solver.matrix(), &first, &last) == 0);
    const double largest = a.coeffs().cwiseAbs().maxCoeff();
    bool are_equal = true;
    for(PetscInt i = first; i < last; ++i) {
      PetscInt size = 0;
      const PetscInt* columns = nullptr;
      const PetscScalar* values = nullptr;
      REQUIRE(MatGetRow(solver.matrix(), i, &size, &columns, &values) == 0);
      are_equal &= size == a.outerIndexPtr()[i + 1] - a.outerIndexPtr()[i];
      for(PetscInt k = 0; k < size; ++k)
        are_equal &= std::abs(values[k] - a.coeff(columns[k], i)) <= 1e-12 * largest;
      REQUIRE(MatRestoreRow(solver.matrix(), i, &size, &columns, &values) == 0);
    }
    CHECK(are_equal);
  }
  // another preconditioner
  REQUIRE(PetscOptionsSetValue(nullptr, "-pc_type", "gamg") == 0);
  const RL::Distributed_poisson_solver solver(space, 3, {}, solver_options);
  REQUIRE(PetscOptionsClearValue(nullptr, "-pc_type") == 0);
  PC pc = nullptr;
  PCType type = nullptr;
  REQUIRE(KSPGetPC(solver.ksp(), &pc) == 0);
  REQUIRE(PCGetType(pc, &type) == 0);
  CHECK(std::string(type) == PCGAMG);
  const RL::Solve_report report = solver.solve(load, y);
  CHECK(report.converged);
  REQUIRE(x.size() == static_cast<Eigen::Index>(space.part().dimension()));
  CHECK((x - y).norm() <= 1e-3 * x.norm());
}

TEST_CASE("a_cycle_for_many_vectors_is_that_of_petsc_for_each", "[shapes]") {
  const RL::Communicator communicator;
  const Spaces spaces(surface_of(shapes::sphere(3)), 6);
  const RL::Distributed_space& space = spaces.distributed;
  const int coarsest =
      std::min(RL::internal::coarsest_multigrid_level(space.part()), space.gathered_level());
  RL::internal::Elliptic_operator elliptic;
  elliptic.reaction = 1;
  elliptic.stabilization = RL::default_stabilization(space.part());
  for(const RL::Cycle cycle : {RL::Cycle::V, RL::Cycle::W})
    for(const int steps : {1, 2}) {
      RL::Poisson_solver_options solver_options;
      solver_options.cycle = cycle;
      solver_options.smoothing_steps = steps;
      RL::internal::Distributed_multigrid multigrid(
          space, RL::internal::assemble_system(space.part(), coarsest, elliptic).matrices,
          solver_options);
      const std::size_t finest = multigrid.finest();
      REQUIRE(finest >= 2);
      const Mat a = multigrid.matrix(finest);

      // a panel, and three more
      constexpr PetscInt columns = 11;
      PetscInt size = 0, first = 0, last = 0;
      REQUIRE(MatGetLocalSize(a, &size, nullptr) == 0);
      REQUIRE(MatGetOwnershipRange(a, &first, &last) == 0);
      // a load, times the solution, is an energy: neither hides elements that are hardly reached
      RL::internal::Petsc_vector y;
      REQUIRE(MatCreateVecs(a, y.address(), nullptr) == 0);
      REQUIRE(MatGetDiagonal(a, y) == 0);
      REQUIRE(VecSqrtAbs(y) == 0);
      const std::vector<double> scale = RL::internal::values_of(y);
      RL::internal::Petsc_matrix b, x;
      for(RL::internal::Petsc_matrix* m : {&b, &x})
        REQUIRE(MatCreateDense(communicator.get(), size, PETSC_DECIDE, PETSC_DETERMINE, columns,
                               nullptr, m->address()) == 0);
      PetscScalar* entries = nullptr;
      REQUIRE(MatDenseGetArrayWrite(b, &entries) == 0);
      for(PetscInt c = 0; c < columns; ++c) // of different size
        for(PetscInt i = 0; i < size; ++i)
          entries[c * size + i] = std::pow(10., 12 * c - 60) * scale[i] *
                                  std::sin(1. + 1e-3 * (c + 1) * static_cast<double>(first + i));
      REQUIRE(MatDenseRestoreArrayWrite(b, &entries) == 0);

      RL::internal::Petsc_solver solver, solver_of_many;
      PC pc = nullptr, pc_of_many = nullptr;
      for(RL::internal::Petsc_solver* s : {&solver, &solver_of_many}) {
        REQUIRE(KSPCreate(communicator.get(), s->address()) == 0);
        REQUIRE(KSPSetOperators(*s, a, a) == 0);
      }
      REQUIRE(KSPGetPC(solver, &pc) == 0);
      REQUIRE(KSPGetPC(solver_of_many, &pc_of_many) == 0);
      multigrid.configure(pc, finest);
      multigrid.configure_for_many(pc_of_many, finest);
      REQUIRE(KSPSetUp(solver) == 0);
      REQUIRE(KSPSetUp(solver_of_many) == 0);
      multigrid.set_residuals(pc, finest);
      REQUIRE(PCMatApply(pc_of_many, b, x) == 0);
      // in the norm of the energy, which does not see what nearly dependent elements may be
      RL::internal::Petsc_vector expected, ax;
      REQUIRE(VecDuplicate(y, expected.address()) == 0);
      REQUIRE(VecDuplicate(y, ax.address()) == 0);
      const auto energy = [&](Vec v) {
        PetscReal result = 0;
        REQUIRE(MatMult(a, v, ax) == 0);
        REQUIRE(VecDot(v, ax, &result) == 0);
        return std::sqrt(result);
      };
      for(PetscInt c = 0; c < columns; ++c) {
        Vec load = nullptr, of_many = nullptr;
        REQUIRE(MatDenseGetColumnVecRead(b, c, &load) == 0);
        REQUIRE(PCApply(pc, load, expected) == 0);
        REQUIRE(PCApply(pc_of_many, load, y) == 0);
        REQUIRE(MatDenseRestoreColumnVecRead(b, c, &load) == 0);
        REQUIRE(VecAXPY(y, -1, expected) == 0);
        CHECK(energy(y) / energy(expected) <= 5e-5);
        REQUIRE(MatDenseGetColumnVecRead(x, c, &of_many) == 0);
        REQUIRE(VecCopy(of_many, y) == 0);
        REQUIRE(MatDenseRestoreColumnVecRead(x, c, &of_many) == 0);
        REQUIRE(VecAXPY(y, -1, expected) == 0);
        CHECK(energy(y) / energy(expected) <= 5e-5);
      }
    }
}

TEST_CASE("problems_on_ranks_begin_with_a_guess", "[shapes]") {
  const Spaces spaces(surface_of(shapes::sphere(3)), 5);
  const RL::Distributed_space& space = spaces.distributed;
  RL::Poisson_solver_options loose, strict;
  loose.tolerance = 1e-5;
  strict.tolerance = 1e-10;
  const RL::Distributed_poisson_solver first(space, 0, {}, loose), second(space, 0, {}, strict);
  const Eigen::VectorXd load = RL::assemble_load(space.part(), f);
  Eigen::VectorXd x, y;
  CHECK(first.solve(load, x).converged);
  const int iterations = second.solve(load, y).iterations;
  // the mean of a guess does not matter
  x.array() += 5;
  const RL::Solve_report report = second.solve(load, x, true);
  CHECK(report.converged);
  CHECK(report.iterations < iterations);
  CHECK((x - y).cwiseAbs().maxCoeff() <= 1e-6 * y.cwiseAbs().maxCoeff());
  CHECK(second.solve(load, x, true).iterations == 0);
}

TEST_CASE("what_is_wrong_with_a_problem_on_ranks", "[shapes]") {
  const RL::Communicator communicator;
  const Spaces spaces(surface_of(shapes::sphere(2)), 4);
  const RL::Distributed_space& space = spaces.distributed;
  CHECK_THROWS_AS(RL::Distributed_poisson_solver(space, -1), RL::Distributed_error);
  const RL::Distributed_poisson_solver solver(space);
  Eigen::VectorXd load = RL::assemble_load(space.part(), f), x;
  // on one rank only
  if(communicator.rank() == communicator.size() - 1)
    load[0] = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(static_cast<void>(solver.solve(load, x)), RL::Distributed_error);
  x.setZero(1);
  load = RL::assemble_load(space.part(), f);
  CHECK_THROWS_AS(static_cast<void>(solver.solve(load, x, true)), RL::Distributed_error);
  // the load of a constant has no solution but 0
  load = RL::assemble_load(space.part(), [](const RL::Surface_point&) { return 1.; });
  const RL::Solve_report report = solver.solve(load, x);
  CHECK(report.converged);
  CHECK(report.iterations == 0);
  CHECK(x.cwiseAbs().maxCoeff() <= 1e-10);
}

TEST_CASE("poisson_problems_of_real_meshes_on_ranks", "[meshes]") {
  for(const std::string name : {"pulley_28k.ply", "moebius.ply", "rgbd5_scan1.ply"}) {
    const std::string path = shared_mesh(name);
    if(path.empty()) {
      SKIP_PART(name << " is not there");
      continue;
    }
    INFO(name);
    std::vector<RL::Point_3> points;
    std::vector<std::vector<std::size_t>> faces;
    REQUIRE(CGAL::IO::read_polygon_soup(path, points, faces));
    for(int depth : {4, 6}) {
      INFO("depth " << depth);
      const Result result = solve(RL::read_surface(RL::soup(points, faces)), depth, 0, 1e-8);
      CHECK(result.difference <= 1e-7);
      CHECK(result.iterations <= result.iterations_of_one + 1);
    }
  }
}
