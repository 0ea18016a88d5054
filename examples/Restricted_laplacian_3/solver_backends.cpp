// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// The matrices are those of Eigen, so any solver can be put behind them. Here three: the solver of
// the package, a Cholesky factorization, and conjugate gradients with an incomplete one.

#include <CGAL/Restricted_laplacian_3/solve_poisson.h>

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Surface_mesh.h>

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCholesky>

#include <cmath>

namespace RL = CGAL::Restricted_laplacian_3;
using Matrix = RL::Sparse_matrix;

int main(int argc, char* argv[]) {
  CGAL::Surface_mesh<RL::Point_3> mesh;
  if(argc != 2 || !CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(argv[1], mesh)) {
    std::cerr << "usage: solver_backends MESH\n";
    return 1;
  }
  const RL::Spline_space_3 space(mesh, RL::parameters::depth(5));
  const double alpha = 10 / space.surface().area();

  // With alpha = 0 the constants of each component of the surface would be in the kernel, and the
  // solver would have to know; RL::Poisson_solver does. The stabilization is what makes the matrix
  // well conditioned: without it, factorizations meet pivots that are rounding errors.
  const RL::Operators operators =
      RL::assemble_operators(space, space.depth(), RL::default_stabilization(space));
  const Matrix a = operators.stiffness + alpha * operators.mass;
  const Eigen::VectorXd b =
      RL::assemble_load(space, [](const RL::Surface_point& s) { return s.point.x(); });

  Eigen::VectorXd reference;
  const RL::Poisson_solver solver(space, alpha, RL::parameters::tolerance(1e-10));
  if(!solver.solve(b, reference).converged)
    return 1;
  const auto norm = [&](const Eigen::VectorXd& x) { return std::sqrt(x.dot(operators.mass * x)); };
  const auto compare = [&](const char* name, const Eigen::VectorXd& x) {
    std::cout << name << ": differs by " << norm(x - reference) / norm(reference) << " in L2\n";
  };

  const Eigen::SimplicialLDLT<Matrix> factorization(a);
  compare("SimplicialLDLT", factorization.solve(b));
  const Eigen::ConjugateGradient<Matrix, Eigen::Lower | Eigen::Upper,
                                 Eigen::IncompleteCholesky<double>>
      gradients(a);
  compare("conjugate gradients", gradients.solve(b));
}
