// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// What someone adds who is new to the package, each in one place: a smoother, an integration, an
// application.

#include "catch.h"
#include "shapes.h"

#include <CGAL/Restricted_laplacian_3/problems/Multigrid_preconditioner.h>
#include <CGAL/Restricted_laplacian_3/solve_poisson.h>

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>

#include <utility>

namespace {

namespace RL = CGAL::Restricted_laplacian_3;
namespace params = CGAL::parameters;

/// Two steps whose product is smallest on the upper three quarters of the range of eigenvalues of
/// A, scaled to a diagonal of 1: Chebyshev's polynomial. A model of MultigridSmoother_3.
class Chebyshev_smoother {
public:
  Chebyshev_smoother(const RL::Sparse_matrix& a, const RL::Smoothing_patches&, bool)
    : m_a(a), m_inverse_diagonal(a.diagonal().size()) {
    const Eigen::ArrayXd diagonal = a.diagonal();
    m_inverse_diagonal = (diagonal > 0).select(diagonal.inverse(), 0);
    const Eigen::ArrayXd scale = m_inverse_diagonal.array().sqrt();
    m_largest = (scale * (a.cwiseAbs() * scale.matrix()).array()).maxCoeff();
  }

  void smooth(const Eigen::MatrixXd& b, Eigen::MatrixXd& x) const {
    const double center = 0.625 * m_largest, half_width = 0.375 * m_largest;
    for(double node : {-0.70710678118654752, 0.70710678118654752})
      x += m_inverse_diagonal.asDiagonal() * (b - m_a * x) / (center + half_width * node);
  }
  // a polynomial in a symmetric matrix
  void smooth_transposed(const Eigen::MatrixXd& b, Eigen::MatrixXd& x) const { smooth(b, x); }

private:
  const RL::Sparse_matrix& m_a;
  Eigen::VectorXd m_inverse_diagonal;
  double m_largest;
};

struct Solution {
  Eigen::VectorXd x;
  int iterations;
};

template <class Preconditioner>
Solution solve(Preconditioner&& preconditioner, const RL::Sparse_matrix& a,
               const Eigen::VectorXd& b) {
  Eigen::ConjugateGradient<RL::Sparse_matrix, Eigen::Lower | Eigen::Upper, Preconditioner> cg;
  cg.preconditioner() = std::move(preconditioner);
  cg.setTolerance(1e-8);
  cg.compute(a);
  const Eigen::VectorXd x = cg.solve(b);
  return {x, static_cast<int>(cg.iterations())};
}

} // namespace

TEST_CASE("a_newcomers_smoother_makes_a_hierarchy", "[newcomers]") {
  const shapes::Triangles sphere = shapes::sphere(4);
  const RL::Spline_space_3 space(sphere.points, sphere.faces, params::octree_depth(4));
  const RL::Operators o = RL::assemble_operators(space, 4, RL::Cubature(space), 0.1);
  const RL::Sparse_matrix a = o.stiffness + o.mass;
  const Eigen::VectorXd b =
      RL::assemble_load(space, [](const RL::Surface_point& p) { return p.point.x(); });
  const Solution by_chebyshev =
                     solve(RL::Multigrid_preconditioner<Chebyshev_smoother>(space, a), a, b),
                 by_points =
                     solve(RL::Multigrid_preconditioner<RL::Gauss_seidel_smoother>(space, a), a, b),
                 by_diagonal = solve(Eigen::DiagonalPreconditioner<double>(a), a, b);
  INFO(by_chebyshev.iterations << ", " << by_points.iterations << ", " << by_diagonal.iterations);
  CHECK(by_chebyshev.iterations <= 2 * by_points.iterations);
  CHECK(2 * by_chebyshev.iterations <= by_diagonal.iterations);
  const Eigen::VectorXd difference = by_chebyshev.x - by_points.x;
  CHECK(difference.dot(o.mass * difference) <= 1e-12 * by_points.x.dot(o.mass * by_points.x));
}
