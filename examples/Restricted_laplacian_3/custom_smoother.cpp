// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// A smoother of one's own in the multigrid hierarchy, compared with those of the package.

#include <CGAL/Restricted_laplacian_3/problems/Multigrid_preconditioner.h>
#include <CGAL/Restricted_laplacian_3/solve_poisson.h>

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Surface_mesh.h>

#include <Eigen/IterativeLinearSolvers>

namespace RL = CGAL::Restricted_laplacian_3;
using Matrix = RL::Sparse_matrix;

/// Jacobi's iteration x = x + D (b - A x), which converges if the entries of D are 1 / (sum of the
/// absolute values of a row). A model of MultigridSmoother_3.
class Jacobi_smoother {
public:
  Jacobi_smoother(const Matrix& a, const RL::Smoothing_patches&, bool) : m_a(a) {
    const Eigen::ArrayXd sums = a.cwiseAbs() * Eigen::VectorXd::Ones(a.cols());
    m_factors = (sums > 0).select(1 / sums, 0);
  }
  void smooth(const Eigen::MatrixXd& b, Eigen::MatrixXd& x) const {
    x += m_factors.asDiagonal() * (b - m_a * x);
  }
  void smooth_transposed(const Eigen::MatrixXd& b, Eigen::MatrixXd& x) const { smooth(b, x); }

private:
  const Matrix& m_a;
  Eigen::VectorXd m_factors;
};

/// iterations of conjugate gradients with a cycle of a smoother, to a residual of 1e-3
template <class Preconditioner>
void solve(const char* name, const RL::Spline_space_3& space, const Matrix& a,
           const Eigen::VectorXd& b) {
  Eigen::ConjugateGradient<Matrix, Eigen::Lower | Eigen::Upper, Preconditioner> solver;
  solver.preconditioner() = Preconditioner(space, a);
  solver.setTolerance(1e-3).compute(a).solve(b).eval();
  std::cout << name << ": " << solver.iterations() << " iterations\n";
}

int main(int argc, char* argv[]) {
  CGAL::Surface_mesh<RL::Point_3> mesh;
  if(argc != 2 || !CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(argv[1], mesh)) {
    std::cerr << "usage: custom_smoother MESH\n";
    return 1;
  }
  // alpha u - Laplacian u = x, with alpha = 10 / area
  const RL::Spline_space_3 space(mesh, RL::parameters::depth(5));
  const RL::Operators o = RL::assemble_operators(space, 5, RL::default_stabilization(space));
  const Matrix a = o.stiffness + 10 / space.surface().area() * o.mass;
  const auto b = RL::assemble_load(space, [](const RL::Surface_point& s) { return s.point.x(); });
  solve<RL::Multigrid_preconditioner<Jacobi_smoother>>("Jacobi", space, a, b);
  solve<RL::Multigrid_preconditioner<RL::Gauss_seidel_smoother>>("Gauss-Seidel", space, a, b);
  solve<RL::Multigrid_preconditioner<RL::Patch_smoother>>("patches", space, a, b);
}
