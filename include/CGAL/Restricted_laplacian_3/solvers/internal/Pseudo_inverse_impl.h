// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_INTERNAL_PSEUDO_INVERSE_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_INTERNAL_PSEUDO_INVERSE_IMPL_H

#include <CGAL/Restricted_laplacian_3/solvers/internal/Pseudo_inverse.h>

#include <CGAL/Restricted_laplacian_3/foundation/internal/symmetric_eigenpairs.h>
#include <CGAL/Restricted_laplacian_3/solvers/shared/connected_components.h>

#include <CGAL/assertions.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Pseudo_inverse::Pseudo_inverse(const Sparse_matrix& a,
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

template <int K> void Pseudo_inverse::apply(const Block_vector<K>& b, Block_vector<K>& x) const {
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

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Eigen::MatrixXd Pseudo_inverse::inverse(const Eigen::MatrixXd& a,
                                                                           double regularization) {
  const Eigen::VectorXd scale =
      a.diagonal().unaryExpr([](double d) { return d > 0 ? 1 / std::sqrt(d) : 0.; });
  const Eigen::MatrixXd scaled = scale.asDiagonal() * a * scale.asDiagonal();
  const Symmetric_eigenpairs pairs =
      symmetric_eigenpairs(scaled, "a matrix of the coarsest level of the multigrid hierarchy");
  const double largest = pairs.values.cwiseAbs().maxCoeff();
  const Eigen::VectorXd inverse = pairs.values.unaryExpr([largest, regularization](double value) {
    return value > relative_cutoff * largest ? 1 / (value + regularization * largest) : 0.;
  });
  const Eigen::MatrixXd vectors = scale.asDiagonal() * pairs.vectors;
  return vectors * inverse.asDiagonal() * vectors.transpose();
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_INTERNAL_PSEUDO_INVERSE_IMPL_H
