// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_INTERNAL_VERTEX_DETAILS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_INTERNAL_VERTEX_DETAILS_H

#include <CGAL/Restricted_laplacian_3/assembly/shared/linear_elements.h>
#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Function_view.h>
#include <CGAL/Restricted_laplacian_3/input/vertex_functions.h>
#include <CGAL/Restricted_laplacian_3/integration/triangle_quadrature.h>
#include <CGAL/Restricted_laplacian_3/solvers/Solve_report.h>
#include <CGAL/Restricted_laplacian_3/solvers/shared/block_vectors.h>
#include <CGAL/Restricted_laplacian_3/solvers/shared/conjugate_gradient.h>
#include <CGAL/Restricted_laplacian_3/surface/Surface_function_view.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>

#include <Eigen/Core>
#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// The problem of `integrate_gradient_field()` for the functions \f$x\f$ that are linear in each
/// triangle: \f$(S + M_w)\, x = \int \langle v, \nabla \phi_i \rangle + \int w\, g\, \phi_i\f$,
/// with the hat functions \f$\phi_i\f$ of the vertices.
struct Vertex_system {
  Eigen::SparseMatrix<double> matrix;
  Eigen::MatrixXd loads;
  /// \f$\int \phi_i\f$, and \f$\int w\, \phi_i\f$
  Eigen::VectorXd integrals, weighted_integrals;
};

/// \param evaluate `evaluate(points, number)` is called with the nodes of a triangle; then
/// `weight(i)` is a number for each of them, and `target(i)` are numbers for all channels, which
/// are read where the weight is positive
/// \param degree of the cubature rule
inline Vertex_system vertex_system(const Triangulated_surface_3& surface,
                                   const Vector_field_view& v,
                                   Function_view<void(const Surface_point*, std::size_t)> evaluate,
                                   Function_view<double(std::size_t)> weight,
                                   Function_view<const double*(std::size_t)> target, int degree) {
  const auto n = static_cast<Eigen::Index>(surface.number_of_vertices());
  const Eigen::Index channels = v.channels();
  Vertex_system system;
  system.loads.setZero(n, channels);
  system.integrals = system.weighted_integrals = Eigen::VectorXd::Zero(n);
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(9 * surface.number_of_faces());
  const auto& rule = triangle_quadrature(degree);
  std::vector<Surface_point> points(rule.size());
  Eigen::MatrixXd values(3 * channels, static_cast<Eigen::Index>(rule.size()));
  for(std::size_t f = 0; f < surface.number_of_faces(); ++f) {
    if(surface.is_degenerate(f))
      continue;
    const double area = surface.area(f);
    const Eigen::Matrix3d gradients = hat_gradients(surface, f);
    Surface_location location;
    location.face = f;
    for(std::size_t i = 0; i < rule.size(); ++i) {
      location.barycentric = {rule[i].b0, rule[i].b1, rule[i].b2};
      points[i] = surface.surface_point(location);
    }
    v(points.data(), points.size(), values.data());
    evaluate(points.data(), points.size());
    Eigen::MatrixXd mean_field = Eigen::MatrixXd::Zero(3, channels),
                    target_loads = Eigen::MatrixXd::Zero(3, channels);
    Eigen::Matrix3d mass = Eigen::Matrix3d::Zero();
    for(std::size_t i = 0; i < rule.size(); ++i) {
      const double fraction = rule[i].weight, w = weight(i);
      mean_field += fraction * Eigen::Map<const Eigen::MatrixXd>(
                                   values.col(static_cast<Eigen::Index>(i)).data(), 3, channels);
      if(!(w > 0))
        continue;
      const Eigen::Vector3d hats(rule[i].b0, rule[i].b1, rule[i].b2);
      mass += fraction * w * hats * hats.transpose();
      target_loads +=
          fraction * w * hats * Eigen::Map<const Eigen::RowVectorXd>(target(i), channels);
    }
    add_block(surface.triangle(f), linear_stiffness(surface, f) + area * mass, entries);
    const Eigen::MatrixXd loads = area * (gradients.transpose() * mean_field + target_loads);
    for(int i = 0; i < 3; ++i) {
      const auto row = static_cast<int>(surface.triangle(f)[i]);
      system.loads.row(row) += loads.row(i);
      system.integrals[row] += area / 3;
      system.weighted_integrals[row] += area * mass.row(i).sum();
    }
  }
  system.matrix.resize(n, n);
  system.matrix.setFromTriplets(entries.begin(), entries.end());
  return system;
}

/// What the iteration for details did.
struct Vertex_details_report {
  Solve_status status = Solve_status::converged;
  int iterations = 0;
  /// of the system scaled to a unit diagonal, relative to its right-hand side, for each channel
  std::vector<double> relative_residuals;
};

using Incomplete_cholesky =
    Eigen::IncompleteCholesky<double, Eigen::Lower, Eigen::NaturalOrdering<int>>;

/// A matrix scaled to a unit diagonal.
struct Scaled_vertex_matrix {
  Eigen::SparseMatrix<double> a;
  Eigen::VectorXd scale; ///< 0 marks vertices without an equation
  Incomplete_cholesky factor;
};

/// `K` channels at once, of which the last ones may not exist
template <int K>
void solve_vertex_system(const Scaled_vertex_matrix& matrix, const Eigen::MatrixXd& loads,
                         double tolerance, int maximum_iterations, Eigen::MatrixXd& x,
                         Vertex_details_report& report) {
  const Eigen::SparseMatrix<double>& a = matrix.a;
  const Eigen::VectorXd& scale = matrix.scale;
  const Eigen::Index n = x.rows(), count = x.cols();
  Block_vector<K> b = Block_vector<K>::Zero(n, K), y = Block_vector<K>::Zero(n, K);
  b.leftCols(count) = scale.asDiagonal() * loads;
  for(Eigen::Index i = 0; i < n; ++i)
    for(Eigen::Index k = 0; k < count; ++k)
      y(i, k) = scale[i] > 0 && std::isfinite(x(i, k)) ? x(i, k) / scale[i] : 0;
  const auto multiply = [&](const Block_vector<K>& p, Block_vector<K>& q) { q.noalias() = a * p; };
  const auto precondition = [&](const Block_vector<K>& p, Block_vector<K>& q) {
    q = matrix.factor.solve(p);
  };
  const auto project = [](Block_vector<K>&) {};
  const Block_row<K> norm = dot<K>(b, b).sqrt(), target = tolerance * norm;
  Block_vector<K> r = b - a * y;
  int iterations = 0;
  Conjugate_gradient_record<K> record;
  conjugate_gradient<K>({multiply, precondition, project}, r, y, target, iterations,
                        maximum_iterations, record);
  report.iterations = (std::max)(report.iterations, iterations);
  r = b - a * y;
  const Block_row<K> residual = dot<K>(r, r).sqrt();
  for(Eigen::Index k = 0; k < count; ++k) {
    report.relative_residuals.push_back(norm[k] > 0 ? residual[k] / norm[k] : 0);
    // The residual of the recursion, which ends the iteration, differs by rounding.
    if(residual[k] > 1.1 * target[k])
      report.status = (std::max)(report.status, iterations < maximum_iterations
                                                    ? Solve_status::stalled
                                                    : Solve_status::iteration_limit);
  }
  for(Eigen::Index i = 0; i < n; ++i)
    if(scale[i] > 0)
      x.row(i) = scale[i] * y.row(i).leftCols(count);
}

/// Solves the system by conjugate gradients, preconditioned with an incomplete Cholesky factor,
/// from the values of a spline. What these leave is of short waves, which an incomplete factor
/// damps fast: the multigrid method of the splines is the coarse correction of an auxiliary space.
///
/// Rows are scaled to a unit diagonal, so that needle triangles, whose cotangents are huge, do not
/// outweigh the others in the residual.
/// \param x values of the spline, and on return the solution; those that are not finite count as 0
/// at vertices that have an equation, and are left alone elsewhere
inline Vertex_details_report add_vertex_details(const Vertex_system& system, double tolerance,
                                                int maximum_iterations, Eigen::MatrixXd& x) {
  const Eigen::Index n = x.rows();
  Scaled_vertex_matrix matrix;
  Eigen::VectorXd& scale = matrix.scale;
  scale.resize(n);
  const Eigen::VectorXd diagonal = system.matrix.diagonal();
  for(Eigen::Index i = 0; i < n; ++i)
    scale[i] = diagonal[i] > 0 ? 1 / std::sqrt(diagonal[i]) : 0;
  matrix.a = scale.asDiagonal() * system.matrix * scale.asDiagonal();
  Eigen::SparseMatrix<double> regular =
      matrix.a; // with ones in the rows of vertices without a face
  for(Eigen::Index i = 0; i < n; ++i)
    if(scale[i] == 0)
      regular.coeffRef(i, i) = 1;
  matrix.factor.compute(regular);
  if(matrix.factor.info() != Eigen::Success)
    throw Numerical_error("the incomplete Cholesky factorization of the details failed");
  Vertex_details_report report;
  // as many channels at a time as share a pass over the matrix
  constexpr int most = 4;
  for(Eigen::Index first = 0; first < x.cols(); first += most) {
    const Eigen::Index count = (std::min)(x.cols() - first, Eigen::Index(most));
    Eigen::MatrixXd channels = x.middleCols(first, count);
    const Eigen::MatrixXd loads = system.loads.middleCols(first, count);
    const auto solve = [&](auto size) {
      solve_vertex_system<decltype(size)::value>(matrix, loads, tolerance, maximum_iterations,
                                                 channels, report);
    };
    if(count == 1)
      solve(std::integral_constant<int, 1>());
    else
      solve(std::integral_constant<int, most>());
    x.middleCols(first, count) = channels;
  }
  return report;
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_INTERNAL_VERTEX_DETAILS_H
