// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// What someone adds who is new to the package, each in one place: a smoother, integrations over a
// stretched and over a curved surface, an interpolation between vertices, an application.

#include "catch.h"
#include "shapes.h"

#include <CGAL/Restricted_laplacian_3/assembly/assemble.h>
#include <CGAL/Restricted_laplacian_3/problems/Multigrid_preconditioner.h>
#include <CGAL/Restricted_laplacian_3/solve_poisson.h>
#include <CGAL/Restricted_laplacian_3/spectra/smallest_eigenpairs.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_function_3.h>
#include <CGAL/Restricted_laplacian_3/surface/surface_functions.h>

#include <Eigen/Geometry>
#include <Eigen/IterativeLinearSolvers>
#include <Eigen/LU>
#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
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

/// The nodes of a cubature, moved to a cubic patch over each triangle: the curved PN triangle of
/// Vlachos and others (2001), which touches the planes that are given at the vertices. A model of
/// SurfaceIntegration_3.
class Cubic_patches {
public:
  /// \param normals unit vectors, one for each vertex
  Cubic_patches(const RL::Spline_space_3& space, const std::vector<RL::Vector_3>& normals)
    : m_surface(space.surface()), m_nodes(space.integration()),
      m_width(space.octree().cell_width(space.depth())) {
    for(const RL::Vector_3& n : normals)
      m_normals.emplace_back(n.x(), n.y(), n.z());
  }

  void add_nodes(std::size_t sheet, int degree, RL::Integration_nodes& nodes) const {
    m_nodes.visit_nodes(sheet, degree, [&](const RL::Integration_node_block& block) {
      for(std::size_t i = 0; i < block.size; ++i) {
        RL::Surface_point p = block.points[i];
        const Eigen::Matrix3d corners = corners_of(p.face);
        Eigen::Matrix3d derivatives;
        const Eigen::Vector3d x = patch(corners, p, derivatives);
        const auto normal = [](const Eigen::Matrix3d& d) {
          return (d.col(1) - d.col(0)).cross(d.col(2) - d.col(0)).eval();
        };
        const Eigen::Vector3d n = normal(derivatives), flat = normal(corners);
        const Eigen::Vector3d unit = n.normalized();
        std::array<double, 3> position = block.position(i);
        for(int axis = 0; axis < 3; ++axis)
          position[axis] += (x[axis] - p.point[axis]) / m_width;
        p.point = RL::Point_3(x[0], x[1], x[2]);
        p.normal = RL::Vector_3(unit[0], unit[1], unit[2]);
        nodes.add(p, position, block.weights[i] * n.norm() / flat.norm());
      }
    });
  }

private:
  Eigen::Matrix3d corners_of(std::size_t face) const {
    Eigen::Matrix3d result;
    for(int i = 0; i < 3; ++i)
      for(int axis = 0; axis < 3; ++axis)
        result(axis, i) = m_surface.point(face, i)[axis];
    return result;
  }

  /// a point of the patch, and its derivatives by the three barycentric coordinates
  Eigen::Vector3d patch(const Eigen::Matrix3d& corners, const RL::Surface_point& p,
                        Eigen::Matrix3d& derivatives) const {
    const std::array<double, 3>& b = p.barycentric;
    const Eigen::Vector3d center = corners.rowwise().mean();
    Eigen::Vector3d x = Eigen::Vector3d::Zero(), middle = -center / 2;
    derivatives.setZero();
    const auto add = [&](const Eigen::Vector3d& control, int i, int j, int k, double factor) {
      const int other[] = {i, j, k};
      x += factor * b[i] * b[j] * b[k] * control;
      for(int e = 0; e < 3; ++e)
        derivatives.col(other[e]) +=
            factor * b[other[(e + 1) % 3]] * b[other[(e + 2) % 3]] * control;
    };
    for(int i = 0; i < 3; ++i) {
      add(corners.col(i), i, i, i, 1);
      for(int j = 0; j < 3; ++j)
        if(j != i) {
          const Eigen::Vector3d& n = m_normals[p.vertices[i]];
          const Eigen::Vector3d side = corners.col(j) - corners.col(i);
          const Eigen::Vector3d control = corners.col(i) + (side - side.dot(n) * n) / 3;
          add(control, i, i, j, 3);
          middle += control / 4; // of six
        }
    }
    add(middle, 0, 1, 2, 6);
    return x;
  }

  RL::Triangulated_surface_3 m_surface;
  RL::Surface_integration m_nodes;
  double m_width;
  std::vector<Eigen::Vector3d> m_normals;
};

/// Interpolates values and gradients at the vertices: quadratic along each edge. A model of
/// SurfaceFunction_3.
class Quadratic_interpolation {
public:
  Quadratic_interpolation(const RL::Triangulated_surface_3& surface, std::vector<double> values,
                          std::vector<RL::Vector_3> gradients)
    : m_surface(surface), m_values(std::move(values)), m_gradients(std::move(gradients)) {}

  double operator()(const RL::Surface_point& p) const {
    double sum = 0;
    for(int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3;
      const std::uint32_t a = p.vertices[i], b = p.vertices[j];
      // what the middle of the edge has above the mean of its ends
      const double bulge = (m_gradients[a] - m_gradients[b]) *
                           (m_surface.point(p.face, j) - m_surface.point(p.face, i)) / 8;
      sum += p.barycentric[i] * (m_values[a] + 4 * p.barycentric[j] * bulge);
    }
    return sum;
  }
  int degree() const { return 2; }

private:
  RL::Triangulated_surface_3 m_surface;
  std::vector<double> m_values;
  std::vector<RL::Vector_3> m_gradients;
};

/// Heat that flows on a surface, in implicit steps of Euler:
/// \f$(S + M / \tau)\, u_{k+1} = M / \tau\, u_k\f$.
class Heat_flow {
public:
  /// \param load of the function at the beginning
  Heat_flow(const RL::Spline_space_3& space, double tau, const Eigen::VectorXd& load)
    : m_mass(RL::assemble_mass_matrix(space)), m_tau(tau), m_load(load),
      m_solver(space, 1 / tau, params::tolerance(1e-10)) {}

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
  const RL::Spline_space_3 space(RL::soup(sphere.points, sphere.faces), params::depth(4));
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
  const RL::Spline_space_3 space(RL::soup(sphere.points, sphere.faces), params::depth(4)),
      other(RL::soup(ellipsoid.points, ellipsoid.faces), params::depth(4));
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

TEST_CASE("a_newcomers_curved_integration_is_more_accurate_than_the_mesh", "[newcomers]") {
  // nothing changes where the patches are plane
  const shapes::Triangles box = shapes::box(1, 0.7, 0.4, 3, 1);
  const RL::Spline_space_3 flat_space(RL::soup(box.points, box.faces), params::depth(3));
  const std::vector<RL::Vector_3> none(box.points.size(), RL::Vector_3(0, 0, 0));
  const RL::Operators flat = RL::assemble_operators(flat_space),
                      plane = RL::assemble_operators(
                          flat_space.integrated_by(Cubic_patches(flat_space, none)));
  CHECK((flat.stiffness - plane.stiffness).norm() <= 1e-12 * flat.stiffness.norm());
  CHECK((flat.mass - plane.mass).norm() <= 1e-12 * flat.mass.norm());

  const shapes::Triangles sphere = shapes::sphere(4);
  std::vector<RL::Vector_3> normals;
  for(const RL::Point_3& p : sphere.points)
    normals.push_back(p - CGAL::ORIGIN);
  const RL::Spline_space_3 space(RL::soup(sphere.points, sphere.faces), params::depth(4));
  const RL::Spline_space_3 curved = space.integrated_by(Cubic_patches(space, normals));
  // worst relative error of the eigenvalues 2, 2, 2, 6, ...; the area has another
  const auto errors = [](const RL::Spline_space_3& s) {
    const RL::Operators o = RL::assemble_operators(s, s.depth(), 1e-5);
    const Eigen::VectorXd values = RL::smallest_eigenpairs(o.stiffness, o.mass, 9).values;
    double worst = 0;
    for(int i = 1; i < 9; ++i)
      worst = (std::max)(worst, std::abs(values[i] / (i < 4 ? 2 : 6) - 1));
    return std::array<double, 2>{worst, std::abs(o.mass.sum() / (4 * CGAL_PI) - 1)};
  };
  const auto of_flat = errors(space), of_curved = errors(curved);
  INFO(of_flat[0] << ", " << of_flat[1] << "; curved " << of_curved[0] << ", " << of_curved[1]);
  CHECK(20 * of_curved[0] <= of_flat[0]);
  CHECK(100 * of_curved[1] <= of_flat[1]);
}

TEST_CASE("a_newcomers_interpolation_is_exact_for_quadratic_functions", "[newcomers]") {
  const shapes::Triangles t = shapes::sphere(2);
  const auto f = [](const RL::Point_3& p) { return p.x() * p.y() + p.z() * p.z() - p.x(); };
  std::vector<double> values;
  std::vector<RL::Vector_3> gradients;
  for(const RL::Point_3& p : t.points) {
    values.push_back(f(p));
    gradients.emplace_back(p.y() - 1, p.x(), 2 * p.z());
  }
  const RL::Spline_space_3 space(RL::soup(t.points, t.faces), params::depth(3));
  const Eigen::VectorXd expected = RL::assemble_load(
                            space, [&](const RL::Surface_point&p) { return f(p.point); }),
                        linear =
                            RL::assemble_load(space, RL::Linear_surface_function<double>(values)),
                        quadratic = RL::assemble_load(
                            space, Quadratic_interpolation(space.surface(), values, gradients));
  CHECK((quadratic - expected).norm() <= 1e-13 * expected.norm());
  CHECK((linear - expected).norm() >= 1e-3 * expected.norm());
  // to a solution: a function object is taken wherever a property map is
  const auto solve = [&](const auto& g) { return RL::solve_poisson(space, g).coefficients; };
  const Eigen::VectorXd u = solve([&](const RL::Surface_point& p) { return f(p.point); });
  CHECK((solve(Quadratic_interpolation(space.surface(), values, gradients)) - u).norm() <=
        1e-6 * u.norm());
}

TEST_CASE("a_newcomers_application_lets_heat_flow", "[newcomers]") {
  const shapes::Triangles sphere = shapes::sphere(5);
  const RL::Spline_space_3 space(RL::soup(sphere.points, sphere.faces), params::depth(4));
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
