// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_INTERNAL_REGULARIZED_INVERSE_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_INTERNAL_REGULARIZED_INVERSE_H

#include <CGAL/Restricted_laplacian_3/foundation/Sparse_matrix.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>
#include <CGAL/Restricted_laplacian_3/solvers/shared/block_vectors.h>

#include <Eigen/Core>

#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// An inverse of a symmetric positive semi-definite matrix, each of whose connected components is
/// small.
///
/// A component is scaled to a unit diagonal, \f$B = D A D\f$, and becomes
/// \f$(B + \epsilon \lVert B \rVert_\infty I)^{-1}\f$: combinations of elements that nearly vanish
/// on the surface, in which a coarse correction would only amplify rounding errors, are amplified
/// no more than that. Its constants, \f$v = D^{-1} 1\f$, are left out where they are in the kernel,
/// \f$v^T B\, v = 1^T A\, 1 = 0\f$ up to rounding: \f$v\f$ is mapped to 0.
class Regularized_inverse {
public:
  /// \f$\epsilon\f$ below a level in single precision: the right-hand side carries rounding errors
  /// of 1e-7 then, and its part along an eigenvector whose eigenvalue is as small must not be
  /// amplified.
  static constexpr double single_precision = 1e-6;
  /// \f$\epsilon\f$ else, and what \f$v^T B\, v\f$ is compared with: well above rounding errors
  static constexpr double double_precision = 1e-12;

  Regularized_inverse() = default;

  /// Takes time proportional to the cube of the size of a component.
  /// \param a what is below its diagonal is not read
  /// \param regularization \f$\epsilon\f$
  /// \throws Numerical_error if an entry is not a finite number, or too large
  Regularized_inverse(const Sparse_matrix& a, double regularization);

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
#include <CGAL/Restricted_laplacian_3/solvers/internal/Regularized_inverse_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_INTERNAL_REGULARIZED_INVERSE_H
