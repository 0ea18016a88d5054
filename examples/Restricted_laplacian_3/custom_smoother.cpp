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

#include <cmath>
#include <cstddef>
#include <exception>
#include <functional>
#include <iostream>
#include <vector>

namespace RL = CGAL::Restricted_laplacian_3;
namespace params = CGAL::parameters;

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Sparse_matrix = Eigen::SparseMatrix<double>;

/// Jacobi's iteration with the sums of absolute values of the rows in place of the diagonal, which
/// converges for every matrix: x = x + D (b - A x). D is diagonal, so steps are their own
/// transposes. A model of MultigridSmoother_3.
class Jacobi_smoother {
public:
  Jacobi_smoother(const Sparse_matrix& a, const RL::Smoothing_patches&, bool is_parallel,
                  const std::function<void()>& matrix_is_read = {})
    : m_is_parallel(is_parallel), m_scale(RL::balancing_scale(a)),
      m_positions(RL::Level_positions::consecutive(a.cols())),
      m_matrix(RL::Level_matrix::of(a, m_positions, m_scale, m_positions, m_scale)),
      m_factors(m_positions.number_of_positions, 0.f) {
    for(int j = 0; j < a.cols(); ++j) {
      double sum = 0;
      for(Sparse_matrix::InnerIterator entry(a, j); entry; ++entry)
        sum += std::abs(m_scale[entry.row()] * entry.value() * m_scale[j]);
      if(sum > 0)
        m_factors[j] = static_cast<float>(1 / sum);
    }
    if(matrix_is_read)
      matrix_is_read();
  }

  const RL::Level_positions& positions() const { return m_positions; }
  const std::vector<double>& scale() const { return m_scale; }

  template <int K>
  void pre_smooth(const RL::Level_vectors<K>& b, RL::Level_vectors<K>& x, RL::Level_vectors<K>& r,
                  int steps) const {
    x.set_zero(m_positions.number_of_positions);
    r = b;
    for(int step = 0; step < steps; ++step) {
      add_scaled<K>(r, x);
      residual<K>(b, x, r);
    }
  }

  template <int K>
  void post_smooth(const RL::Level_vectors<K>& b, RL::Level_vectors<K>& x, int steps) const {
    RL::Level_vectors<K> r;
    for(int step = 0; step < steps; ++step) {
      residual<K>(b, x, r);
      add_scaled<K>(r, x);
    }
  }

  template <int K>
  void residual(const RL::Level_vectors<K>& b, const RL::Level_vectors<K>& x,
                RL::Level_vectors<K>& r) const {
    m_matrix.multiply<K, false>(m_is_parallel, x, r);
    for(std::size_t i = 0; i < r.size(); ++i)
      r.data()[i] = b.data()[i] - r.data()[i];
  }

private:
  template <int K> void add_scaled(const RL::Level_vectors<K>& r, RL::Level_vectors<K>& x) const {
    for(std::size_t i = 0; i < r.size(); ++i)
      x.data()[i] += m_factors[i / K] * r.data()[i];
  }

  bool m_is_parallel;
  std::vector<double> m_scale;
  RL::Level_positions m_positions;
  RL::Level_matrix m_matrix;
  std::vector<float> m_factors;
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
    const RL::Spline_space_3 space(mesh, params::octree_depth(5));
    const double alpha = 10 / space.surface().area();
    const RL::Operators operators = RL::assemble_operators(
        space, space.depth(), RL::Cubature(space), RL::default_normal_stabilization(space));
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
