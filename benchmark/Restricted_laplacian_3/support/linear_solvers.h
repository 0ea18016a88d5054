// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_BENCHMARK_LINEAR_SOLVERS_H
#define RESTRICTED_LAPLACIAN_3_BENCHMARK_LINEAR_SOLVERS_H

// How others solve a Poisson problem with the cotangent Laplacian.

#include "boomer_amg.h"

#include <CGAL/Restricted_laplacian_3/foundation/Sparse_matrix.h>

#include <CGAL/Real_timer.h>

#include <Eigen/Core>
#ifdef CGAL_RESTRICTED_LAPLACIAN_3_USE_CHOLMOD
#include <Eigen/CholmodSupport>
#endif

namespace benchmarks {

class Stopwatch {
public:
  Stopwatch() { m_timer.start(); }
  /// seconds since the last lap
  double lap() {
    const double end = m_timer.time(), seconds = end - m_begin;
    m_begin = end;
    return seconds;
  }

private:
  CGAL::Real_timer m_timer;
  double m_begin = 0;
};

/// \f$ -M (f - \bar f) \f$, with the mean over the surface, so that the sum is 0
/// \param mass its entries sum to the area
inline Eigen::VectorXd poisson_load(const CGAL::Restricted_laplacian_3::Sparse_matrix& mass,
                                    const Eigen::VectorXd& f) {
  const Eigen::VectorXd areas = mass * Eigen::VectorXd::Ones(f.size());
  return areas * (areas.dot(f) / areas.sum()) - mass * f;
}

struct Solver_run {
  double setup_seconds, solve_seconds;
  bool converged;
};

#ifdef CGAL_RESTRICTED_LAPLACIAN_3_USE_CHOLMOD
/// CHOLMOD with AMD ordering; the first unknown is held at 0 by a larger diagonal entry.
/// \param a positive semi-definite, with the constants as kernel
inline Solver_run solve_by_cholmod(CGAL::Restricted_laplacian_3::Sparse_matrix a,
                                   const Eigen::VectorXd& b, Eigen::VectorXd& u) {
  Stopwatch watch;
  Solver_run run;
  a.coeffRef(0, 0) *= 2;
  Eigen::CholmodSupernodalLLT<CGAL::Restricted_laplacian_3::Sparse_matrix> cholesky;
  cholesky.cholmod().print = 0;
  cholesky.cholmod().nmethods = 1;
  cholesky.cholmod().method[0].ordering = CHOLMOD_AMD;
  cholesky.compute(a);
  run.setup_seconds = watch.lap();
  u = cholesky.solve(b);
  run.solve_seconds = watch.lap();
  run.converged = cholesky.info() == Eigen::Success;
  return run;
}
#endif

/// Conjugate gradients with BoomerAMG, configuration amg2. A `Hypre_session` has to exist.
inline Solver_run solve_by_amg(const CGAL::Restricted_laplacian_3::Sparse_matrix& a,
                               const Eigen::VectorXd& b, double tolerance, Eigen::VectorXd& u) {
  constexpr int maximum_iterations = 500;
  Stopwatch watch;
  Solver_run run;
  Boomer_amg amg(MPI_COMM_WORLD, 0, static_cast<int>(a.rows()), a.outerIndexPtr(),
                 a.innerIndexPtr(), a.valuePtr());
  amg.setup(boomer_amg_configuration("amg2_pcg"));
  run.setup_seconds = watch.lap();
  u.resize(a.rows());
  run.converged = amg.solve(b.data(), u.data(), tolerance, maximum_iterations) < maximum_iterations;
  run.solve_seconds = watch.lap();
  return run;
}

} // namespace benchmarks

#endif // RESTRICTED_LAPLACIAN_3_BENCHMARK_LINEAR_SOLVERS_H
