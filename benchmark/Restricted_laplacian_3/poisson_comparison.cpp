// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// From a mesh to the solution of a Poisson problem, by this package at several depths and by what
// people use today: the cotangent Laplacian with a sparse Cholesky factorization. The surface is
// the unit sphere, f a spherical harmonic of degree 6, so the error of each is known: accuracy
// stands beside time. All in one run on one core; quote ratios, the machine may be shared.
//
// usage: poisson_comparison

#include "sphere.h"

#include <CGAL/Restricted_laplacian_3/cotangent_operators.h>
#include <CGAL/Restricted_laplacian_3/solve_poisson.h>

#include <CGAL/Real_timer.h>

#include <Eigen/SparseCholesky>
#ifdef CGAL_RESTRICTED_LAPLACIAN_3_USE_CHOLMOD
#include <Eigen/CholmodSupport>
#endif

#include <cmath>
#include <complex>
#include <cstdio>
#include <vector>

namespace RL = CGAL::Restricted_laplacian_3;

namespace {

constexpr double eigenvalue = 42; // l (l + 1), l = 6

double harmonic(const RL::Point_3& p) {
  const double r = std::sqrt((p - CGAL::ORIGIN).squared_length());
  const double x = (2 * p.x() + 2 * p.y() + p.z()) / (3 * r);
  const double y = (-2 * p.x() + p.y() + 2 * p.z()) / (3 * r);
  return std::real(std::pow(std::complex<double>(x, y), 6));
}

/// root mean square over the vertices of the difference to the exact solution, relative
double relative_error(const RL::Triangulated_surface_3& surface, const double* u) {
  double error = 0, norm = 0;
  for(std::size_t v = 0; v < surface.number_of_vertices(); ++v) {
    const double exact = -harmonic(surface.point(v)) / eigenvalue;
    error += (u[v] - exact) * (u[v] - exact);
    norm += exact * exact;
  }
  return std::sqrt(error / norm);
}

void print(const char* method, const RL::Triangulated_surface_3& surface, std::size_t unknowns,
           double assembly, double setup, double solve, double error) {
  std::printf("%-22s %9zu %9zu %9.3f %9.3f %9.3f %9.3f %10.2e\n", method, surface.number_of_faces(),
              unknowns, assembly, setup, solve, assembly + setup + solve, error);
  std::fflush(stdout);
}

void restricted(const RL::Triangulated_surface_3& surface, int depth, double tolerance) {
  CGAL::Real_timer timer;
  timer.start();
  RL::Spline_space_options options;
  options.octree_depth = depth;
  const RL::Spline_space_3 space(surface, options);
  const RL::Operators operators = RL::assemble_operators(space);
  const Eigen::VectorXd load =
      RL::assemble_load(space, [](const RL::Surface_point& p) { return harmonic(p.point); });
  const double assembly = timer.time();
  const RL::Poisson_solver solver =
      RL::make_poisson_solver(space, operators, 0, CGAL::parameters::relative_tolerance(tolerance));
  const double setup = timer.time() - assembly;
  Eigen::VectorXd eta;
  const RL::Solve_report report = solver.solve(-load, eta);
  const std::vector<double> u = RL::Spline_function_3(space, eta).values_at_vertices();
  const double solve = timer.time() - assembly - setup;
  char method[64];
  std::snprintf(method, sizeof method, "restricted_d%d_%.0e%s", depth, tolerance,
                report.converged ? "" : "_not_reached");
  print(method, surface, space.dimension(), assembly, setup, solve,
        relative_error(surface, u.data()));
}

template <class Cholesky>
void cotangent(const char* method, const RL::Triangulated_surface_3& surface) {
  CGAL::Real_timer timer;
  timer.start();
  const RL::Operators operators = RL::cotangent_operators(surface);
  Eigen::VectorXd f(surface.number_of_vertices());
  for(std::size_t v = 0; v < surface.number_of_vertices(); ++v)
    f[v] = harmonic(surface.point(v));
  Eigen::VectorXd b = -(operators.mass * f);
  b.array() -= b.mean();
  const double assembly = timer.time();
  // one vertex held at 0 makes the matrix definite
  RL::Sparse_matrix a = operators.stiffness;
  a.coeffRef(0, 0) *= 2;
  Cholesky cholesky(a);
  const double setup = timer.time() - assembly;
  Eigen::VectorXd u = cholesky.solve(b);
  u.array() -= (operators.mass * u).sum() / surface.area();
  const double solve = timer.time() - assembly - setup;
  print(method, surface, surface.number_of_vertices(), assembly, setup, solve,
        relative_error(surface, u.data()));
}

} // namespace

int main() {
  std::printf("# %-20s %9s %9s %9s %9s %9s %9s %10s\n", "method", "triangles", "unknowns",
              "assem_s", "setup_s", "solve_s", "total_s", "rel_error");
  for(int n = 5; n <= 8; ++n) {
    const RL::Triangulated_surface_3 surface = sphere(n);
#ifdef CGAL_RESTRICTED_LAPLACIAN_3_USE_CHOLMOD
    cotangent<Eigen::CholmodDecomposition<RL::Sparse_matrix>>("cotangent_cholmod", surface);
#endif
    cotangent<Eigen::SimplicialLDLT<RL::Sparse_matrix>>("cotangent_eigen_ldlt", surface);
    for(int depth = 3; depth <= 6; ++depth)
      restricted(surface, depth, 1e-3);
    std::printf("\n\n");
  }
}
