// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// The matrices are those of Eigen, so any solver can be put behind them. Here three: the solver of
// the package, a Cholesky factorization, and conjugate gradients with an incomplete one.

#include <CGAL/Restricted_laplacian_3/solve_poisson.h>

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <cmath>
#include <exception>
#include <iostream>
#include <stdexcept>

namespace RL = CGAL::Restricted_laplacian_3;
namespace params = RL::parameters;

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Sparse_matrix = Eigen::SparseMatrix<double>;

/// A back end: any solver with the interface of Eigen's, for S + alpha M.
///
/// With alpha = 0 the constants of each component of the surface are in the kernel of S, and the
/// solver has to know that; RL::Poisson_solver does.
template <class Eigen_solver> class Back_end {
public:
  explicit Back_end(const Sparse_matrix& a) {
    m_solver.compute(a);
    if(m_solver.info() != Eigen::Success)
      throw std::runtime_error("the factorization failed");
  }

  Eigen::VectorXd solve(const Eigen::VectorXd& b) const { return m_solver.solve(b); }

private:
  Eigen_solver m_solver;
};

void run(const Mesh& mesh) {
  const RL::Spline_space_3 space(mesh, params::depth(5));
  const double alpha = 10 / space.surface().area();

  // The stabilization is what makes the matrix well conditioned; without it, factorizations and
  // incomplete ones meet pivots that are rounding errors.
  const RL::Operators operators =
      RL::assemble_operators(space, space.depth(), RL::default_stabilization(space));
  const Sparse_matrix a = operators.stiffness + alpha * operators.mass;
  const Eigen::VectorXd b =
      RL::assemble_load(space, [](const RL::Surface_point& s) { return s.point.x(); });

  Eigen::VectorXd reference;
  const RL::Solve_report report =
      RL::make_poisson_solver(space, alpha, params::tolerance(1e-10)).solve(b, reference);
  if(!report.converged)
    throw std::runtime_error("the multigrid solver " + to_string(report.status));
  const auto norm = [&](const Eigen::VectorXd& x) { return std::sqrt(x.dot(operators.mass * x)); };
  const auto compare = [&](const char* name, const Eigen::VectorXd& x) {
    std::cout << name << ": differs by " << norm(x - reference) / norm(reference) << " in L2\n";
  };

  compare("SimplicialLDLT", Back_end<Eigen::SimplicialLDLT<Sparse_matrix>>(a).solve(b));
  using Incomplete_cholesky = Eigen::IncompleteCholesky<double>;
  compare("conjugate gradients",
          Back_end<Eigen::ConjugateGradient<Sparse_matrix, Eigen::Lower | Eigen::Upper,
                                            Incomplete_cholesky>>(a)
              .solve(b));
}

int main(int argc, char* argv[]) {
  Mesh mesh;
  if(argc != 2 || !CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(argv[1], mesh)) {
    std::cerr << "usage: solver_backends MESH\n";
    return 1;
  }
  try {
    run(mesh);
  } catch(const std::exception& e) {
    std::cerr << "solver_backends: " << e.what() << '\n';
    return 1;
  }
  return 0;
}
