// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// What the stabilization by normal derivatives costs in accuracy and saves in iterations.
//
//   stabilization [MESH]...
//
// First the relative errors, in L2 and H1, of a Poisson problem on the unit sphere whose solution
// is a spherical harmonic of degree 6, by factor and depth. Then the iterations to a true relative
// residual of 1e-8 on meshes (files, or names in the folder of shared meshes), for the coordinate x
// as right-hand side. Times are not measured. Raw output is in results/.

#include "support/package.h"
#include "support/sphere.h"

#include <CGAL/Restricted_laplacian_3/splines/Spline_function_3.h>

#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdio>
#include <string>
#include <vector>

namespace {

using namespace benchmarks;
namespace params = RL::parameters;

constexpr double factors[] = {0, 1e-4, 3e-4, 1e-3, 1e-2};

double harmonic(const RL::Surface_point& p) {
  const double r = std::sqrt((p.point - CGAL::ORIGIN).squared_length());
  return std::real(std::pow(std::complex<double>(p.point.x() / r, p.point.y() / r), 6));
}

void errors_on_the_sphere(const RL::Triangulated_surface_3& surface, int depth) {
  constexpr double eigenvalue = 42;
  const RL::Spline_space_3 space(surface, space_options(depth, true, 1));
  const RL::Operators pure = operators(space, 0);
  const Eigen::VectorXd load = RL::assemble_load(space, harmonic);
  const double h = space.octree().cell_width(depth);
  double norm = 0;
  for(std::size_t sheet = 0; sheet < space.number_of_sheets(depth); ++sheet)
    space.integration().visit_nodes(sheet, 12, [&](const RL::Integration_node_block& block) {
      for(std::size_t i = 0; i < block.size; ++i)
        norm += block.weights[i] * h * h * std::pow(harmonic(block.points[i]), 2);
    });
  for(double c : factors) {
    // Without stabilization the residual cannot be made small, and the error does not need it.
    Eigen::VectorXd eta;
    const RL::Solve_report report =
        RL::Poisson_solver(space, 0, params::stabilization(c).tolerance(c > 0 ? 1e-9 : 1e-7))
            .solve(eigenvalue * load, eta);
    const double l2 = eta.dot(pure.mass * eta) - 2 * eta.dot(load) + norm,
                 h1 = eta.dot(pure.stiffness * eta) / eigenvalue - 2 * eta.dot(load) + norm;
    std::printf("%5d %8zu %8.0e %10.2e %10.2e %6d %s\n", depth, space.dimension(), c,
                std::sqrt(std::abs(l2) / norm), std::sqrt(std::abs(h1) / norm), report.iterations,
                report.converged ? "" : "not converged");
    std::fflush(stdout);
  }
}

void iterations(const char* name, const RL::Triangulated_surface_3& surface, int depth) {
  const RL::Spline_space_3 space(surface, space_options(depth, true, 2));
  const Eigen::VectorXd load =
      RL::assemble_load(space, [](const RL::Surface_point& p) { return p.point.x(); });
  std::printf("%-18s %5d %8zu", name, depth, space.dimension());
  for(double c : factors) {
    const auto np = params::stabilization(c)
                        .tolerance(1e-8)
                        .concurrency_tag(CGAL::Parallel_if_available_tag())
                        .maximum_iterations(150);
    Eigen::VectorXd eta;
    const RL::Solve_report report = RL::Poisson_solver(space, 0, np).solve(load, eta);
    std::printf(report.converged ? " %7d" : "   >%4d", report.iterations);
    std::fflush(stdout);
  }
  std::printf("\n");
}

void tolerances(const char* name, const RL::Triangulated_surface_3& surface, int depth) {
  const RL::Spline_space_3 space(surface, space_options(depth, true, 2));
  const RL::Operators pure = operators(space, 0);
  const Eigen::VectorXd load =
      RL::assemble_load(space, [](const RL::Surface_point& p) { return p.point.x(); });
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(load.size());
  const double area = ones.dot(pure.mass * ones);
  RL::Solve_report report;
  const auto solution = [&](double tolerance) {
    Eigen::VectorXd eta;
    report = poisson_solver(space, default_stabilization(), 2, tolerance).solve(load, eta);
    return Eigen::VectorXd(eta.array() - ones.dot(pure.mass * eta) / area);
  };
  const Eigen::VectorXd converged = solution(1e-11);
  for(const double tolerance : {1e-2, 5e-3, 1e-3, 1e-4, 1e-5, 1e-6}) {
    const Eigen::VectorXd difference = solution(tolerance) - converged;
    const auto relative = [&](const RL::Sparse_matrix& a) {
      return std::sqrt(difference.dot(a * difference) / converged.dot(a * converged));
    };
    std::printf("%-18s %5d %8zu %9.0e %10.2e %10.2e %6d %10.2e\n", name, depth, space.dimension(),
                tolerance, relative(pure.mass), relative(pure.stiffness), report.iterations,
                report.relative_residual);
    std::fflush(stdout);
  }
}

} // namespace

int main(int argc, char* argv[]) {
  std::vector<std::string> meshes(argv + 1, argv + argc);
  if(meshes.empty())
    meshes = {"bunny_closed_70k", "armadillo", "fandisk_32k", "pulley_28k", "cow_5k8"};
  print_header(argc, argv);
  std::printf(
      "# sphere of 131,072 triangles\n# depth unknowns   factor   L2 error   H1 error  iter\n");
  const RL::Triangulated_surface_3 surface = sphere(7);
  for(int depth = 3; depth <= 5; ++depth)
    errors_on_the_sphere(surface, depth);
  std::printf("\n\n# iterations to 1e-8\n# %-16s %5s %8s", "mesh", "depth", "unknowns");
  for(double c : factors)
    std::printf(" %7.0e", c);
  std::printf("\n");
  for(const std::string& name : meshes)
    if(const auto mesh = find_mesh(name))
      for(int depth = 5; depth <= 8; ++depth)
        iterations(name.c_str(), *mesh, depth);
  std::printf(
      "\n\n# difference from the solution to 1e-11\n# %-16s %5s %8s %9s %10s %10s %6s %10s\n",
      "mesh", "depth", "unknowns", "tolerance", "L2", "H1", "iter", "residual");
  for(const std::string& name : meshes)
    if(const auto mesh = find_mesh(name))
      tolerances(name.c_str(), *mesh, 6);
}
