// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// What someone adds who is new to the package, each in one place: a smoother, an integration, an
// application.

#include "catch.h"
#include "shapes.h"

#include <CGAL/Restricted_laplacian_3/assembly/assemble.h>
#include <CGAL/Restricted_laplacian_3/problems/Multigrid_preconditioner.h>
#include <CGAL/Restricted_laplacian_3/solve_poisson.h>
#include <CGAL/Restricted_laplacian_3/spectra/smallest_eigenpairs.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_function_3.h>

#include <Eigen/Geometry>
#include <Eigen/IterativeLinearSolvers>
#include <Eigen/LU>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace {

namespace RL = CGAL::Restricted_laplacian_3;
namespace params = RL::parameters;

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

/// The nodes of a cubature with the metric of the surface that is stretched along the axes. A model
/// of SurfaceIntegration_3: nothing but weights and metrics has to know of the other surface.
class Stretched_surface {
public:
  Stretched_surface(const RL::Surface_integration& nodes, const RL::Vector_3& factors)
    : m_nodes(nodes), m_factors(factors.x(), factors.y(), factors.z()) {}

  void add_nodes(std::size_t sheet, int degree, RL::Integration_nodes& nodes) const {
    m_nodes.visit_nodes(sheet, degree, [&](const RL::Integration_node_block& block) {
      for(std::size_t i = 0; i < block.size; ++i) {
        const RL::Vector_3& n = block.points[i].normal;
        // T, an orthonormal basis of the tangents, and G = (F T)^T (F T): the metric is
        // T G^-1 T^T
        const Eigen::Vector3d normal(n.x(), n.y(), n.z()), side = normal.unitOrthogonal();
        Eigen::Matrix<double, 3, 2> t, stretched;
        t << side, normal.cross(side);
        stretched = m_factors.asDiagonal() * t;
        const Eigen::Matrix2d g = stretched.transpose() * stretched;
        const Eigen::Matrix3d a = t * g.inverse() * t.transpose();
        nodes.add(block.points[i], block.position(i), block.weights[i] * std::sqrt(g.determinant()),
                  {a(0, 0), a(1, 1), a(2, 2), a(0, 1), a(0, 2), a(1, 2)});
      }
    });
  }

private:
  RL::Surface_integration m_nodes;
  Eigen::Vector3d m_factors;
};

/// Heat that flows on a surface, in implicit steps of Euler:
/// \f$(S + M / \tau)\, u_{k+1} = M / \tau\, u_k\f$.
class Heat_flow {
public:
  /// \param load of the function at the beginning
  Heat_flow(const RL::Spline_space_3& space, double tau, const Eigen::VectorXd& load)
    : m_mass(RL::assemble_mass_matrix(space)), m_tau(tau), m_load(load),
      m_solver(RL::make_poisson_solver(space, 1 / tau, params::relative_tolerance(1e-10))) {}

  Eigen::VectorXd step() {
    Eigen::VectorXd u;
    static_cast<void>(m_solver.solve(m_load / m_tau, u));
    m_load = m_mass * u;
    return u;
  }
  double heat() const { return m_load.sum(); }

private:
  RL::Sparse_matrix m_mass;
  double m_tau;
  Eigen::VectorXd m_load;
  RL::Poisson_solver m_solver;
};

} // namespace

TEST_CASE("a_newcomers_smoother_makes_a_hierarchy", "[newcomers]") {
  const shapes::Triangles sphere = shapes::sphere(4);
  const RL::Spline_space_3 space(sphere.points, sphere.faces, params::octree_depth(4));
  const RL::Operators o = RL::assemble_operators(space, 4, 0.1);
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

TEST_CASE("a_newcomers_integration_gives_the_spectrum_of_another_surface", "[newcomers]") {
  const RL::Vector_3 factors(1, 0.8, 1.3);
  const shapes::Triangles sphere = shapes::sphere(4);
  shapes::Triangles ellipsoid = sphere;
  for(RL::Point_3& p : ellipsoid.points)
    p = RL::Point_3(factors.x() * p.x(), factors.y() * p.y(), factors.z() * p.z());
  const RL::Spline_space_3 space(sphere.points, sphere.faces, params::octree_depth(4)),
      other(ellipsoid.points, ellipsoid.faces, params::octree_depth(4));
  const RL::Operators stretched = RL::assemble_operators(
                          space.integrated_by(Stretched_surface(space.integration(), factors))),
                      direct = RL::assemble_operators(other, 4);
  // mass matrices sum to areas
  CHECK(stretched.mass.sum() == Approx(direct.mass.sum()).epsilon(1e-12));
  const Eigen::VectorXd values =
                            RL::smallest_eigenpairs(stretched.stiffness, stretched.mass, 16).values,
                        expected =
                            RL::smallest_eigenpairs(direct.stiffness, direct.mass, 16).values;
  INFO(values.transpose() << ", expected " << expected.transpose());
  CHECK((values - expected).cwiseAbs().maxCoeff() <= 1e-4 * expected[15]);
  CHECK(expected[1] < 0.95 * expected[3]); // on the sphere they are equal
}

TEST_CASE("a_newcomers_application_lets_heat_flow", "[newcomers]") {
  const shapes::Triangles sphere = shapes::sphere(5);
  const RL::Spline_space_3 space(sphere.points, sphere.faces, params::octree_depth(4));
  // z is an eigenfunction with the eigenvalue 2
  constexpr double tau = 0.1;
  constexpr int steps = 5;
  Heat_flow flow(space, tau, RL::assemble_load(space, [](const RL::Surface_point& p) {
                   return 1 + p.point.z();
                 }));
  const double heat = flow.heat();
  CHECK(heat == Approx(space.surface().area()).epsilon(1e-12));
  Eigen::VectorXd u;
  for(int k = 0; k < steps; ++k)
    u = flow.step();
  CHECK(flow.heat() == Approx(heat).epsilon(1e-9));
  const double left = std::pow(1 + 2 * tau, -steps);
  const std::vector<double> values = RL::Spline_function_3(space, u).values_at_vertices();
  double error = 0;
  for(std::size_t v = 0; v < values.size(); ++v)
    error = (std::max)(error, std::abs(values[v] - (1 + left * sphere.points[v].z())));
  INFO("error " << error << ", part of z that is left " << left);
  CHECK(error <= 2e-3 * left);
}
