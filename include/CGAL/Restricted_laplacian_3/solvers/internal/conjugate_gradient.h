// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_INTERNAL_CONJUGATE_GRADIENT_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_INTERNAL_CONJUGATE_GRADIENT_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/Function_view.h>
#include <CGAL/Restricted_laplacian_3/solvers/internal/block_vectors.h>

#include <cmath>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// `f(x, y)` makes \f$y = A x\f$ of a linear operator \f$A\f$
template <int K>
using Block_operator = Function_view<void(const Block_vector<K>&, Block_vector<K>&)>;

/// scalar products of corresponding columns
template <int K> Block_row<K> dot(const Block_vector<K>& x, const Block_vector<K>& y) {
  return x.cwiseProduct(y).colwise().sum().array();
}

/// `numerator / denominator`, 0 where the denominator is not positive: a column whose search
/// direction vanished has converged, or cannot be improved
template <int K>
Block_row<K> safe_quotient(const Block_row<K>& numerator, const Block_row<K>& denominator) {
  Block_row<K> result;
  for(int k = 0; k < K; ++k)
    result[k] = denominator[k] > 0 ? numerator[k] / denominator[k] : 0.;
  return result;
}

/// Preconditioned conjugate gradients for `K` right-hand sides at once, each with its own
/// coefficients: the iterates of a column are those of a solve of its own. Columns that have
/// converged stand still.
///
/// \param multiply `multiply(p, q)`: \f$q = A p\f$
/// \param precondition `precondition(r, z)`: \f$z = B r\f$, symmetric positive semi-definite
/// \param project `project(r)`: removes from the residual what is outside of the range of \f$A\f$
/// \param r the residual of the initial `x`, on return the recursively updated residual
/// \param target norms of the residuals at which the columns have converged
/// \param iterations counts on from its value up to `maximum_iterations`
template <int K>
void conjugate_gradient(Block_operator<K> multiply, Block_operator<K> precondition,
                        Function_view<void(Block_vector<K>&)> project, Block_vector<K>& r,
                        Block_vector<K>& x, const Block_row<K>& target, int& iterations,
                        int maximum_iterations) {
  Block_vector<K> z, p, q;
  Block_row<K> rho = Block_row<K>::Zero();
  for(bool first = true; iterations < maximum_iterations; ++iterations, first = false) {
    const Block_row<K> norm = dot<K>(r, r).sqrt();
    // written so that a NaN ends the iteration
    if(!(norm > target).any())
      return;
    precondition(r, z);
    const Block_row<K> next_rho = dot<K>(r, z);
    if(first)
      p = z;
    else {
      const Block_row<K> beta = safe_quotient<K>(next_rho, rho);
      p = z + p * beta.matrix().asDiagonal();
    }
    rho = next_rho;
    multiply(p, q);
    Block_row<K> curvature = dot<K>(p, q);
    // Where the cycle has left the range of numbers, the solution stays as it is.
    for(int k = 0; k < K; ++k)
      if(!std::isfinite(curvature[k]) || !std::isfinite(rho[k])) {
        curvature[k] = 0;
        p.col(k).setZero();
        q.col(k).setZero();
      }
    Block_row<K> alpha = safe_quotient<K>(rho, curvature);
    alpha = (norm > target).select(alpha, 0);
    if((alpha == 0).all())
      return;
    x += p * alpha.matrix().asDiagonal();
    r -= q * alpha.matrix().asDiagonal();
    project(r);
  }
}

/// The iteration \f$ x \leftarrow x + B (b - A x) \f$; parameters as in `conjugate_gradient()`.
template <int K>
void stationary_iteration(Block_operator<K> multiply, Block_operator<K> precondition,
                          Function_view<void(Block_vector<K>&)> project, Block_vector<K>& r,
                          Block_vector<K>& x, const Block_row<K>& target, int& iterations,
                          int maximum_iterations) {
  Block_vector<K> z, q;
  for(; iterations < maximum_iterations; ++iterations) {
    const Block_row<K> norm = dot<K>(r, r).sqrt();
    if(!(norm > target).any())
      return;
    precondition(r, z);
    multiply(z, q);
    if(!q.allFinite())
      return;
    x += z;
    r -= q;
    project(r);
  }
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_INTERNAL_CONJUGATE_GRADIENT_H
