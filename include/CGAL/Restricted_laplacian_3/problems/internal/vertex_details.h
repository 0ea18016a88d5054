// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_INTERNAL_VERTEX_DETAILS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_INTERNAL_VERTEX_DETAILS_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/integration/triangle_quadrature.h>
#include <CGAL/Restricted_laplacian_3/solvers/internal/block_vectors.h>
#include <CGAL/Restricted_laplacian_3/solvers/internal/conjugate_gradient.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>
#include <CGAL/Restricted_laplacian_3/surface/vector_fields.h>

#include <Eigen/Core>
#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// The problem of `integrate_gradient_field()` for the functions \f$x\f$ that are linear in each
/// triangle: \f$(S + M_w)\, x = \int \langle v, \nabla \phi_i \rangle + \int w\, g\, \phi_i\f$,
/// with the hat functions \f$\phi_i\f$ of the vertices.
template <int K> struct Vertex_system {
  Eigen::SparseMatrix<double> matrix;
  Eigen::Matrix<double, Eigen::Dynamic, K> loads;
  /// \f$\int \phi_i\f$, and \f$\int w\, \phi_i\f$
  Eigen::VectorXd integrals, weighted_integrals;
};

/// \param v vector field of `K` channels
/// \param weight,target `weight(p)` is a number, `target(p)` a column vector, read where the weight
/// is positive
/// \param degree of the cubature rule
template <int K, class Field, class Weight, class Target>
Vertex_system<K> vertex_system(const Triangulated_surface_3& surface, const Field& v,
                               const Weight& weight, const Target& target, int degree) {
  const auto n = static_cast<Eigen::Index>(surface.number_of_vertices());
  Vertex_system<K> system;
  system.loads.setZero(n, K);
  system.integrals = system.weighted_integrals = Eigen::VectorXd::Zero(n);
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(9 * surface.number_of_faces());
  const auto& rule = triangle_quadrature(degree);
  for(std::size_t f = 0; f < surface.number_of_faces(); ++f) {
    if(surface.is_degenerate(f))
      continue;
    const double area = surface.area(f);
    const Eigen::Matrix3d gradients = hat_gradients(surface, f);
    Eigen::Matrix<double, 3, K> mean_field = Eigen::Matrix<double, 3, K>::Zero(),
                                target_loads = Eigen::Matrix<double, 3, K>::Zero();
    Eigen::Matrix3d mass = Eigen::Matrix3d::Zero();
    Surface_location location;
    location.face = f;
    for(const Triangle_quadrature_node& node : rule) {
      location.barycentric = {node.b0, node.b1, node.b2};
      const Surface_point p = surface.surface_point(location);
      mean_field += node.weight * Channels_of<Field>::read(v(p));
      const double w = weight(p);
      if(!(w > 0))
        continue;
      const Eigen::Vector3d hats(node.b0, node.b1, node.b2);
      mass += node.weight * w * hats * hats.transpose();
      target_loads += node.weight * w * hats * target(p).transpose();
    }
    const Eigen::Matrix3d block = area * (gradients.transpose() * gradients + mass);
    const Eigen::Matrix<double, 3, K> loads =
        area * (gradients.transpose() * mean_field + target_loads);
    for(int i = 0; i < 3; ++i) {
      const auto row = static_cast<int>(surface.triangle(f)[i]);
      for(int j = 0; j < 3; ++j)
        entries.emplace_back(row, static_cast<int>(surface.triangle(f)[j]), block(i, j));
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
  bool converged = false;
  int iterations = 0;
  /// of the system scaled to a unit diagonal, relative to its right-hand side, for each channel
  std::vector<double> relative_residuals;
};

/// Solves the system by conjugate gradients, preconditioned with an incomplete Cholesky factor,
/// from the values of a spline. What these leave is of short waves, which an incomplete factor
/// damps fast: the multigrid method of the splines is the coarse correction of an auxiliary space.
///
/// Rows are scaled to a unit diagonal, so that needle triangles, whose cotangents are huge, do not
/// outweigh the others in the residual.
/// \param x values of the spline, and on return the solution; those that are not finite count as 0
/// at vertices that have an equation, and are left alone elsewhere
template <int K>
Vertex_details_report add_vertex_details(const Vertex_system<K>& system, double relative_tolerance,
                                         int maximum_iterations, Eigen::MatrixXd& x) {
  const Eigen::Index n = x.rows();
  Eigen::VectorXd scale(n);
  const Eigen::VectorXd diagonal = system.matrix.diagonal();
  for(Eigen::Index i = 0; i < n; ++i)
    scale[i] = diagonal[i] > 0 ? 1 / std::sqrt(diagonal[i]) : 0;
  Eigen::SparseMatrix<double> a = scale.asDiagonal() * system.matrix * scale.asDiagonal();
  Eigen::SparseMatrix<double> regular = a; // with ones in the rows of vertices without a face
  for(Eigen::Index i = 0; i < n; ++i)
    if(scale[i] == 0)
      regular.coeffRef(i, i) = 1;
  const Eigen::IncompleteCholesky<double, Eigen::Lower, Eigen::NaturalOrdering<int>> factor(
      regular);
  if(factor.info() != Eigen::Success)
    throw Numerical_error("the incomplete Cholesky factorization of the details failed");

  Block_vector<K> b = scale.asDiagonal() * system.loads, y(n, K);
  for(Eigen::Index i = 0; i < n; ++i)
    for(int k = 0; k < K; ++k)
      y(i, k) = scale[i] > 0 && std::isfinite(x(i, k)) ? x(i, k) / scale[i] : 0;
  const auto multiply = [&](const Block_vector<K>& p, Block_vector<K>& q) { q.noalias() = a * p; };
  const auto precondition = [&](const Block_vector<K>& p, Block_vector<K>& q) {
    q = factor.solve(p);
  };
  const auto project = [](Block_vector<K>&) {};
  const Block_row<K> norm = dot<K>(b, b).sqrt(), target = relative_tolerance * norm;
  Block_vector<K> r = b - a * y;
  Vertex_details_report report;
  conjugate_gradient<K>(multiply, precondition, project, r, y, target, report.iterations,
                        maximum_iterations);
  r = b - a * y;
  const Block_row<K> residual = dot<K>(r, r).sqrt();
  report.converged = true;
  for(int k = 0; k < K; ++k) {
    report.relative_residuals.push_back(norm[k] > 0 ? residual[k] / norm[k] : 0);
    // The residual of the recursion, which ends the iteration, differs by rounding.
    report.converged = report.converged && !(residual[k] > 1.1 * target[k]);
  }
  for(Eigen::Index i = 0; i < n; ++i)
    if(scale[i] > 0)
      x.row(i) = scale[i] * y.row(i);
  return report;
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_INTERNAL_VERTEX_DETAILS_H
