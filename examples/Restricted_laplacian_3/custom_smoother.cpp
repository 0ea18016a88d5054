// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// A smoother of one's own in the multigrid hierarchy, compared with those of the package.

#include <CGAL/Restricted_laplacian_3/problems/Multigrid_preconditioner.h>
#include <CGAL/Restricted_laplacian_3/solve_poisson.h>

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>

#include <exception>
#include <iostream>

namespace RL = CGAL::Restricted_laplacian_3;
namespace params = RL::parameters;

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Sparse_matrix = Eigen::SparseMatrix<double>;

/// Jacobi's iteration x = x + D (b - A x), in which D is smaller than the inverse diagonal, by what
/// the rows of A, scaled to a diagonal of 1, sum to in absolute values: so it converges for every
/// matrix. D is diagonal, so a step is its own transpose. A model of MultigridSmoother_3.
class Jacobi_smoother {
public:
  Jacobi_smoother(const Sparse_matrix& a, const RL::Smoothing_patches&, bool /*is_parallel*/)
    : m_a(a) {
    // rows of elements that hardly reach the surface may be 0
    const Eigen::ArrayXd diagonal = a.diagonal();
    const Eigen::ArrayXd scale = (diagonal > 0).select(diagonal.rsqrt(), 0);
    const Eigen::ArrayXd sums = a.cwiseAbs() * scale.matrix();
    m_factors = (diagonal > 0).select(scale / sums, 0);
  }

  void smooth(const Eigen::MatrixXd& b, Eigen::MatrixXd& x) const {
    x += m_factors.asDiagonal() * (b - m_a * x);
  }
  void smooth_transposed(const Eigen::MatrixXd& b, Eigen::MatrixXd& x) const { smooth(b, x); }

private:
  const Sparse_matrix& m_a;
  Eigen::VectorXd m_factors;
};

/// iterations of conjugate gradients with a cycle of this smoother, to a residual of 1e-3
template <class Smoother>
void solve(const char* name, const RL::Spline_space_3& space, const Sparse_matrix& a,
           const Eigen::VectorXd& b) {
  using Preconditioner = RL::Multigrid_preconditioner<Smoother>;
  Eigen::ConjugateGradient<Sparse_matrix, Eigen::Lower | Eigen::Upper, Preconditioner> solver;
  solver.preconditioner() = Preconditioner(space, a);
  solver.setTolerance(1e-3);
  solver.compute(a);
  const Eigen::VectorXd x = solver.solve(b);
  std::cout << name << ": " << solver.iterations() << " iterations, residual " << solver.error()
            << '\n';
}

int main(int argc, char* argv[]) {
  Mesh mesh;
  if(argc != 2 || !CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(argv[1], mesh)) {
    std::cerr << "usage: custom_smoother MESH\n";
    return 1;
  }
  try {
    // alpha u - Laplacian u = x, with alpha = 10 / area
    const RL::Spline_space_3 space(mesh, params::depth(5));
    const double alpha = 10 / space.surface().area();
    const RL::Operators operators =
        RL::assemble_operators(space, space.depth(), RL::default_stabilization(space));
    const Sparse_matrix a = operators.stiffness + alpha * operators.mass;
    const Eigen::VectorXd b =
        RL::assemble_load(space, [](const RL::Surface_point& s) { return s.point.x(); });

    solve<Jacobi_smoother>("Jacobi", space, a, b);
    solve<RL::Gauss_seidel_smoother>("Gauss-Seidel", space, a, b);
    solve<RL::Patch_smoother>("patches", space, a, b);
  } catch(const std::exception& e) {
    std::cerr << "custom_smoother: " << e.what() << '\n';
    return 1;
  }
  return 0;
}
