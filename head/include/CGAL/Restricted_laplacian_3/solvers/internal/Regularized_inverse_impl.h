// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_INTERNAL_REGULARIZED_INVERSE_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_INTERNAL_REGULARIZED_INVERSE_IMPL_H

#include <CGAL/Restricted_laplacian_3/solvers/internal/Regularized_inverse.h>

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/solvers/internal/Symmetric_inverse.h>
#include <CGAL/Restricted_laplacian_3/solvers/shared/connected_components.h>

#include <CGAL/assertions.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Regularized_inverse::Regularized_inverse(const Sparse_matrix& a,
                                                                            double regularization) {
  const auto [component, number] = connected_components(a);
  m_blocks.resize(static_cast<std::size_t>(number));
  std::vector<int> position(component.size());
  for(std::size_t i = 0; i < component.size(); ++i) {
    position[i] = static_cast<int>(m_blocks[component[i]].unknowns.size());
    m_blocks[component[i]].unknowns.push_back(static_cast<int>(i));
  }
  for(Block& block : m_blocks) {
    const Eigen::Index size = static_cast<Eigen::Index>(block.unknowns.size());
    Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(size, size);
    for(Eigen::Index j = 0; j < size; ++j)
      for(Sparse_matrix::InnerIterator i(a, block.unknowns[j]); i && i.row() <= i.col(); ++i)
        dense(j, position[i.row()]) = dense(position[i.row()], j) = i.value();
    block.inverse = inverse(dense, regularization);
  }
}

template <int K>
void Regularized_inverse::apply(const Block_vector<K>& b, Block_vector<K>& x) const {
  x.resize(b.rows(), K);
  Block_vector<K> part;
  for(const Block& block : m_blocks) {
    part.resize(block.inverse.cols(), K);
    for(std::size_t i = 0; i < block.unknowns.size(); ++i)
      part.row(i) = b.row(block.unknowns[i]);
    part = block.inverse * part;
    for(std::size_t i = 0; i < block.unknowns.size(); ++i)
      x.row(block.unknowns[i]) = part.row(i);
  }
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Eigen::MatrixXd
Regularized_inverse::inverse(const Eigen::MatrixXd& a, double regularization) {
  const Eigen::Index size = a.cols(), stride = (size + 3) / 4 * 4;
  const Eigen::VectorXd diagonal = a.diagonal();
  const Eigen::VectorXd scale =
      diagonal.unaryExpr([](double d) { return d > 0 ? 1 / std::sqrt(d) : 0.; });
  Eigen::MatrixXd scaled = Eigen::MatrixXd::Zero(stride, stride);
  scaled.topLeftCorner(size, size) = scale.asDiagonal() * a * scale.asDiagonal();
  const double norm = scaled.cwiseAbs().rowwise().sum().maxCoeff();
  if(!std::isfinite(norm) || !a.allFinite())
    throw Numerical_error("a matrix of the coarsest level of the multigrid hierarchy has entries "
                          "that are not finite numbers, or too large");
  const double shift = regularization * norm;
  for(Eigen::Index i = 0; i < size; ++i)
    scaled(i, i) = diagonal[i] > 0 ? scaled(i, i) + shift : 0;
  // The eigenvalue of the constants is moved from 0 to 1, and their part taken out in the end.
  const bool has_constants =
      norm > 0 && std::abs(a.sum()) <= double_precision * norm * diagonal.sum();
  Eigen::VectorXd constants = Eigen::VectorXd::Zero(stride);
  if(has_constants) {
    constants.head(size) = (diagonal.cwiseMax(0) / diagonal.cwiseMax(0).sum()).cwiseSqrt();
    scaled += constants * constants.transpose();
  }
  Symmetric_inverse()(scaled.data(), static_cast<int>(size), static_cast<int>(stride), shift / 2);
  // The lower triangle by rows is the upper one by columns.
  scaled.triangularView<Eigen::StrictlyLower>() = scaled.transpose().eval();
  if(has_constants)
    scaled -= constants * constants.transpose() / (1 + shift);
  return scale.asDiagonal() * scaled.topLeftCorner(size, size) * scale.asDiagonal();
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_INTERNAL_REGULARIZED_INVERSE_IMPL_H
