// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// How long do the smallest eigenpairs take?
//
// Without --mesh-to-pairs, on the same matrices of the finest level: multigrid_eigenpairs() to the
// tolerance, with its hierarchy, and Spectra's shift-invert Lanczos with CHOLMOD
// (smallest_eigenpairs()). Errors are relative differences of eigenvalues to the latter. The memory
// is what is needed at most beyond the matrices; the copies that the former uses up are given back
// before.
//
// With --mesh-to-pairs, from a mesh in memory: laplace_spectrum() at some depths, and the cotangent
// Laplacian of the mesh with Spectra's SymGEigsShiftSolver and CHOLMOD, as users do it today.
// Errors are relative, against laplace_spectrum() at the depth of --reference.
//
// Each in a process of its own, which is where the peak memory comes from.
//
// usage: eigensolver_comparison [OPTION]... MESH DEPTH
//        eigensolver_comparison --mesh-to-pairs [--reference DEPTH] [OPTION]... MESH DEPTH...

#include "support/driver.h"
#include "support/measure.h"
#include "support/meshes.h"
#include "support/package.h"

#include <CGAL/Restricted_laplacian_3/assembly/cotangent_operators.h>
#include <CGAL/Restricted_laplacian_3/laplace_spectrum.h>
#include <CGAL/Restricted_laplacian_3/spectra/internal/eigenproblem.h>
#include <CGAL/Restricted_laplacian_3/spectra/smallest_eigenpairs.h>
#include <CGAL/Restricted_laplacian_3/splines/prolongation.h>

#include <CGAL/Real_timer.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>
#ifdef CGAL_RESTRICTED_LAPLACIAN_3_USE_CHOLMOD
#include <Eigen/CholmodSupport>
#else
#include <Eigen/SparseCholesky>
#endif

#include <Spectra/MatOp/SparseSymMatProd.h>
#include <Spectra/SymGEigsShiftSolver.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace benchmarks;
namespace params = RL::parameters;

struct Options {
  int pairs = 100;
  double tolerance = 0;
  int threads = 1;
  int reference = 0;
  double stabilization = -1; // the default of the space
  bool from_mesh = false, with_peer = true;
  std::string mesh;
  std::vector<int> depths;
};

struct Result {
  double unknowns, matrix_seconds, seconds, iterations, residual;
};

constexpr unsigned patience = 1500; // seconds
constexpr int most_pairs = 1000;

/// a record that carries eigenvalues, too
struct Values {
  Result result;
  double values[most_pairs];
};

/// what Spectra wants of a factorization of \f$A - \sigma B\f$
class Factorization {
public:
  using Scalar = double;
  Factorization(const RL::Sparse_matrix& a, const RL::Sparse_matrix& b) : m_a(a), m_b(b) {}
  Eigen::Index rows() const { return m_a.rows(); }
  Eigen::Index cols() const { return m_a.rows(); }
  void set_shift(double sigma) { m_solver.compute(m_a - sigma * m_b); }
  void perform_op(const double* in, double* out) const {
    Eigen::Map<Eigen::VectorXd>(out, rows()) =
        m_solver.solve(Eigen::Map<const Eigen::VectorXd>(in, rows()));
  }

private:
  const RL::Sparse_matrix &m_a, &m_b;
#ifdef CGAL_RESTRICTED_LAPLACIAN_3_USE_CHOLMOD
  Eigen::CholmodSupernodalLLT<RL::Sparse_matrix> m_solver;
#else
  Eigen::SimplicialLLT<RL::Sparse_matrix> m_solver;
#endif
};

std::vector<RL::Operators> level_operators(const RL::Spline_space_3& space, int coarsest,
                                           const Options& o) {
  return RL::assemble_operators_of_levels(
      space, coarsest, space.depth(),
      o.stabilization < 0 ? RL::default_spectrum_stabilization(space) : o.stabilization,
      RL::Stabilized::stiffness);
}

void print(const std::string& what, int threads, const std::vector<Values>& records, double peak,
           const Eigen::VectorXd& reference) {
  if(records.empty()) {
    std::printf("%-24s failed, or took longer than %u s\n", what.c_str(), patience);
    return;
  }
  const Result& r = records[0].result;
  std::printf("%-24s %7d %9.0f %9.2f %9.2f %7.0f %5.0f %9.1e", what.c_str(), threads, r.unknowns,
              r.matrix_seconds, r.seconds, peak, r.iterations, r.residual);
  if(reference.size() > 0) {
    double mean = 0, largest = 0;
    for(Eigen::Index i = 1; i < reference.size(); ++i) {
      const double error = std::abs(records[0].values[i] / reference[i] - 1);
      mean += error / static_cast<double>(reference.size() - 1);
      largest = (std::max)(largest, error);
    }
    std::printf(" %9.1e %9.1e", mean, largest);
  }
  std::printf("\n");
  std::fflush(stdout);
}

std::vector<Values> record(const Result& result, const Eigen::VectorXd& values) {
  Values v = {result, {}};
  for(Eigen::Index i = 0; i < values.size() && i < most_pairs; ++i)
    v.values[i] = values[i];
  return {v};
}

void compare_on_matrices(const Options& o) {
  const auto surface = find_mesh(o.mesh);
  if(!surface)
    return;
  // without threads: those of TBB would not exist in the child processes
  const RL::Spline_space_3 space(*surface, space_options(o.depths[0], true, 1));
  const int coarsest = RL::internal::coarsest_multigrid_level(space);
  std::vector<RL::Operators> operators = level_operators(space, coarsest, o);
  std::printf("# %s, depth %d, %d pairs, tolerance %g\n# what                  threads  unknowns  "
              "matrices     pairs     MiB  iter.  residual mean err.  max. err.\n",
              o.mesh.c_str(), o.depths[0], o.pairs, o.tolerance);
  Eigen::VectorXd exact;
  const auto measure = [&](const std::string& what, auto&& solve) {
    double peak = 0;
    const auto records = in_child_process<Values>(patience, peak, [&] {
      const auto limit = limit_threads(o.threads);
      set_blas_threads(o.threads);
      CGAL::Real_timer timer;
      timer.start();
      const RL::Eigenpairs pairs = solve();
      return record({double(space.dimension()), 0, timer.time(), double(pairs.iterations),
                     pairs.residuals.maxCoeff()},
                    pairs.values);
    });
    print(what, o.threads, records, peak, exact);
    return records;
  };
  if(o.with_peer) {
    const auto records = measure("shift_invert_cholmod", [&] {
      return RL::smallest_eigenpairs(operators.back().stiffness, operators.back().mass, o.pairs);
    });
    if(!records.empty())
      exact = Eigen::Map<const Eigen::VectorXd>(records[0].values, o.pairs);
  }
  measure("multigrid_eigenpairs", [&] {
    RL::Multigrid_eigenpairs_options options;
    options.tolerance = o.tolerance;
    options.is_parallel = o.threads > 1;
    return RL::internal::multigrid_eigenpairs_of(space, coarsest, std::move(operators), o.pairs,
                                                 options);
  });
}

void compare_from_mesh(const Options& o) {
  const auto surface = find_mesh(o.mesh);
  if(!surface)
    return;
  const auto restricted = [&](int depth, double tolerance) {
    CGAL::Real_timer timer;
    timer.start();
    const RL::Spline_space_3 space(*surface, space_options(depth, true, o.threads));
    std::vector<RL::Operators> operators =
        level_operators(space, RL::internal::coarsest_multigrid_level(space), o);
    const double matrix_seconds = timer.time();
    RL::Multigrid_eigenpairs_options options;
    options.tolerance = tolerance;
    options.is_parallel = o.threads > 1;
    const RL::Eigenpairs pairs =
        RL::internal::multigrid_eigenpairs_of(space, RL::internal::coarsest_multigrid_level(space),
                                              std::move(operators), o.pairs, options);
    return record({double(space.dimension()), matrix_seconds, timer.time() - matrix_seconds,
                   double(pairs.iterations), pairs.residuals.maxCoeff()},
                  pairs.values);
  };
  double peak = 0;
  Eigen::VectorXd reference;
  if(o.reference > 0) {
    const auto records = in_child_process<Values>(patience, peak, [&] {
      const auto limit = limit_threads(o.threads);
      set_blas_threads(o.threads);
      return restricted(o.reference, 1e-5);
    });
    if(!records.empty())
      reference = Eigen::Map<const Eigen::VectorXd>(records[0].values, o.pairs);
  }
  std::printf(
      "# %s, %zu triangles, %d pairs, tolerance %g, reference: depth %d\n# what             "
      "     threads  unknowns  matrices     pairs     MiB  iter.  residual mean err.  max. "
      "err.\n",
      o.mesh.c_str(), surface->number_of_faces(), o.pairs, o.tolerance, o.reference);
  for(int depth : o.depths) {
    const auto records = in_child_process<Values>(patience, peak, [&] {
      const auto limit = limit_threads(o.threads);
      set_blas_threads(o.threads);
      return restricted(depth, o.tolerance);
    });
    print("restricted depth " + std::to_string(depth), o.threads, records, peak, reference);
  }
  if(!o.with_peer)
    return;
  const auto records = in_child_process<Values>(patience, peak, [&] {
    const auto limit = limit_threads(o.threads);
    set_blas_threads(o.threads);
    CGAL::Real_timer timer;
    timer.start();
    const RL::Operators operators = RL::cotangent_operators(*surface, false);
    const double matrix_seconds = timer.time();
    Factorization factorization(operators.stiffness, operators.mass);
    Spectra::SparseSymMatProd<double> mass(operators.mass);
    // as many vectors as its manual recommends, a shift a little below the spectrum
    Spectra::SymGEigsShiftSolver<Factorization, Spectra::SparseSymMatProd<double>,
                                 Spectra::GEigsMode::ShiftInvert>
        solver(factorization, mass, o.pairs, 2 * o.pairs,
               RL::internal::natural_shift(surface->area()));
    solver.init();
    solver.compute(Spectra::SortRule::LargestMagn, 1000, 1e-8, Spectra::SortRule::SmallestAlge);
    if(solver.info() != Spectra::CompInfo::Successful)
      throw std::runtime_error("Spectra did not converge");
    const Eigen::VectorXd values = solver.eigenvalues();
    const Eigen::MatrixXd vectors = solver.eigenvectors();
    return record({double(surface->number_of_vertices()), matrix_seconds,
                   timer.time() - matrix_seconds, double(solver.num_iterations()), 0},
                  values);
  });
  print("cotangent_spectra", o.threads, records, peak, reference);
}

bool read_options(int argc, char* argv[], Options& o) {
  Command_line line("usage: eigensolver_comparison [OPTION]... MESH DEPTH...");
  bool without_peer = false;
  line.add("pairs", o.pairs);
  line.add("tolerance", o.tolerance, "of residuals; default 1e-6, with --mesh-to-pairs 1e-3");
  line.add("threads", o.threads);
  line.add("stabilization", o.stabilization, "default that of the package");
  line.add("mesh-to-pairs", o.from_mesh, "times include the space");
  line.add("reference", o.reference, "depth with which --mesh-to-pairs compares; default 0, none");
  line.add("no-peer", without_peer, "without Spectra");
  line.add("mesh", o.mesh);
  line.add("depth", o.depths);
  line.add_positional("mesh", 1);
  line.add_positional("depth");
  if(!line.read(argc, argv))
    return false;
  line.require("mesh");
  line.require("depth");
  o.with_peer = !without_peer;
  if(o.pairs < 1 || o.pairs > most_pairs)
    throw std::runtime_error("the number of pairs must be between 1 and " +
                             std::to_string(most_pairs));
  if(o.tolerance == 0)
    o.tolerance = o.from_mesh ? 1e-3 : 1e-6;
  return true;
}

} // namespace

int main(int argc, char* argv[]) {
  return run_benchmark("eigensolver_comparison", [&] {
    Options o;
    if(!read_options(argc, argv, o))
      return;
    print_header(argc, argv);
    if(o.from_mesh)
      compare_from_mesh(o);
    else
      compare_on_matrices(o);
  });
}
