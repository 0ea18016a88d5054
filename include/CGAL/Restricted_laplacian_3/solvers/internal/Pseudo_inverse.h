// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_INTERNAL_PSEUDO_INVERSE_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_INTERNAL_PSEUDO_INVERSE_H

#include <CGAL/Restricted_laplacian_3/foundation/Sparse_matrix.h>
#include <CGAL/Restricted_laplacian_3/foundation/compiled.h>
#include <CGAL/Restricted_laplacian_3/solvers/shared/block_vectors.h>

#include <Eigen/Core>

#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// The pseudo-inverse of a symmetric positive semi-definite matrix, each of whose connected
/// components is small.
///
/// A component is scaled to a unit diagonal first; eigenvalues of the scaled block below
/// `relative_cutoff` times the largest are treated as 0. They belong to the kernel (constants) and
/// to combinations of elements that nearly vanish on the surface, in which a coarse correction
/// would only amplify rounding errors.
class Pseudo_inverse {
public:
  static constexpr double relative_cutoff = 1e-12;

  /// What is added to the other eigenvalues, times the largest, below a level in single precision:
  /// the right-hand side carries rounding errors of 1e-7 then, and its part along an eigenvector
  /// whose eigenvalue is as small must not be amplified.
  static constexpr double single_precision_regularization = 1e-6;

  Pseudo_inverse() = default;

  /// \param a what is below its diagonal is not read
  /// \param regularization see `single_precision_regularization`
  /// \throws Numerical_error if the eigenvalues of a component cannot be computed, because its
  /// entries are not finite numbers, or too large
  Pseudo_inverse(const Sparse_matrix& a, double regularization);

  /// \tparam K is 1 or 8
  template <int K> void apply(const Block_vector<K>& b, Block_vector<K>& x) const;

private:
  struct Block {
    std::vector<int> unknowns;
    Eigen::MatrixXd inverse;
  };

  static Eigen::MatrixXd inverse(const Eigen::MatrixXd& a, double regularization);

  std::vector<Block> m_blocks;
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/solvers/internal/Pseudo_inverse_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_INTERNAL_PSEUDO_INVERSE_H
