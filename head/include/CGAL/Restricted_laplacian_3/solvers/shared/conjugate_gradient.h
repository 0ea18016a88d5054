// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_SHARED_CONJUGATE_GRADIENT_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_SHARED_CONJUGATE_GRADIENT_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/Function_view.h>
#include <CGAL/Restricted_laplacian_3/solvers/shared/block_vectors.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// `f(x, y)` makes \f$y = A x\f$ of a linear operator \f$A\f$
template <int K>
using Block_operator = Function_view<void(const Block_vector<K>&, Block_vector<K>&)>;

/// A system \f$A x = b\f$ and a preconditioner \f$B\f$.
template <int K> struct Preconditioned_operator {
  Block_operator<K> multiply;     ///< `multiply(p, q)`: \f$q = A p\f$
  Block_operator<K> precondition; ///< `precondition(r, z)`: \f$z = B r\f$
  /// `project(r)`: removes from a residual what is outside of the range of \f$A\f$
  Function_view<void(Block_vector<K>&)> project;
};

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

/// What the steps of conjugate gradients tell, column by column.
///
/// *The error.* In the norm of the energy, \f$e^T A\, e\f$, it is reduced by \f$\alpha\, r^T z\f$
/// by each step: what the last four steps reduced it by is an estimate of what it was before them.
///
/// *The preconditioner.* Of a cycle that converges on its own, all eigenvalues of \f$B A\f$ lie
/// between 0 and 2, so \f$\alpha \ge 1/2\f$ in exact arithmetic. Three smaller ones prove that it
/// amplifies.
template <int K> class Conjugate_gradient_record {
public:
  /// \param tolerance columns whose error, relative to the solution, is estimated as that small
  /// have converged; 0 for none
  explicit Conjugate_gradient_record(double tolerance = 0) : m_tolerance(tolerance) {}

  /// For least squares, where \f$ x^T A\, x - 2\, b^T x + s \f$ is minimized: columns have
  /// converged, too, if the error is small relative to the square root of that.
  /// \param squares \f$s\f$
  /// \param tolerance of the error; 0 for none
  void compare_with_least_squares(const Block_row<K>& squares, double tolerance) {
    m_squares = squares;
    m_least_squares_tolerance = tolerance;
  }

  /// \param energies \f$ x^T (b + r) \f$, which grows to \f$x^T A\, x\f$ of the solution by what
  /// the energy of the error shrinks
  void start(const Block_row<K>& energies) { m_energies = energies; }

  /// a step of a column, and what it reduced the energy by
  void add(int k, double alpha, double reduction) {
    m_reductions[k][m_numbers[k]++ % m_reductions[k].size()] = reduction;
    m_energies[k] += reduction;
    m_small_steps[k] += alpha < 0.5;
  }

  /// Directions may have a part along what `project` removes, a mean: it lengthens them, so a step
  /// ends short of the minimum, where the residual still has a part along its direction. Sums of
  /// reductions feel that where they are compared with what is left of a function.
  bool wants_exact_reductions() const { return m_least_squares_tolerance > 0; }

  /// what the last four steps reduced the energy of the error by, over that of the solution
  double squared_error(int k) const {
    double sum = 0;
    for(double reduction : m_reductions[k])
      sum += reduction;
    return sum > 0 && m_energies[k] > 0 ? sum / m_energies[k] : 0;
  }
  /// whether there was a step
  bool knows_error(int k) const { return m_numbers[k] > 0; }
  bool has_converged(int k) const {
    if(m_numbers[k] < static_cast<int>(m_reductions[k].size()))
      return false;
    const double square = squared_error(k),
                 misfit = m_energies[k] > 0 ? m_squares[k] / m_energies[k] - 1 : 0;
    const auto is_small = [square](double tolerance, double reference) {
      return tolerance > 0 && square <= tolerance * tolerance * reference;
    };
    return is_small(m_tolerance, 1) || is_small(m_least_squares_tolerance, misfit);
  }

  bool amplifies() const {
    return *std::max_element(m_small_steps.begin(), m_small_steps.end()) >= 3;
  }
  /// whether the iteration ends if the preconditioner is found to amplify
  bool ends_if_it_amplifies = false;

private:
  double m_tolerance, m_least_squares_tolerance = 0;
  std::array<std::array<double, 4>, K> m_reductions = {};
  std::array<int, K> m_numbers = {}, m_small_steps = {};
  Block_row<K> m_energies = Block_row<K>::Zero(), m_squares = Block_row<K>::Zero();
};

/// Preconditioned conjugate gradients for `K` right-hand sides at once, each with its own
/// coefficients: the iterates of a column are those of a solve of its own. Columns that have
/// converged stand still.
///
/// \param a with a preconditioner that is symmetric and positive semi-definite
/// \param r the residual of the initial `x`, on return the recursively updated residual
/// \param target norms of the residuals at which the columns have converged
/// \param iterations counts on from its value up to `maximum_iterations`
/// \param record is told each step; columns that have converged by it stand still, too
template <int K>
void conjugate_gradient(const Preconditioned_operator<K>& a, Block_vector<K>& r, Block_vector<K>& x,
                        const Block_row<K>& target, int& iterations, int maximum_iterations,
                        Conjugate_gradient_record<K>& record) {
  Block_vector<K> z, p, q;
  // the product of the residual with the search direction is rho but for rounding, or a mean in it
  Block_row<K> rho = Block_row<K>::Zero(), slope = rho;
  for(bool first = true; iterations < maximum_iterations; ++iterations, first = false) {
    const Block_row<K> norm = dot<K>(r, r).sqrt();
    // written so that a NaN ends the iteration
    std::array<bool, K> is_wanted;
    for(int k = 0; k < K; ++k)
      is_wanted[k] = norm[k] > target[k] && !record.has_converged(k);
    if(std::none_of(is_wanted.begin(), is_wanted.end(), [](bool is) { return is; }) ||
       (record.ends_if_it_amplifies && record.amplifies()))
      return;
    a.precondition(r, z);
    const Block_row<K> next_rho = dot<K>(r, z);
    if(first)
      p = z;
    else {
      const Block_row<K> beta = safe_quotient<K>(next_rho, rho);
      p = z + p * beta.matrix().asDiagonal();
      slope *= beta;
    }
    slope += next_rho;
    rho = next_rho;
    a.multiply(p, q);
    Block_row<K> curvature = dot<K>(p, q);
    // Where the cycle has left the range of numbers, the solution stays as it is.
    for(int k = 0; k < K; ++k)
      if(!std::isfinite(curvature[k]) || !std::isfinite(rho[k])) {
        curvature[k] = 0;
        p.col(k).setZero();
        q.col(k).setZero();
      }
    Block_row<K> alpha = safe_quotient<K>(rho, curvature);
    for(int k = 0; k < K; ++k)
      if(!is_wanted[k])
        alpha[k] = 0;
    if((alpha == 0).all())
      return;
    x += p * alpha.matrix().asDiagonal();
    r -= q * alpha.matrix().asDiagonal();
    a.project(r);
    Block_row<K> reduction = alpha * slope;
    slope = record.wants_exact_reductions() ? dot<K>(r, p) : Block_row<K>(Block_row<K>::Zero());
    reduction += alpha * slope;
    for(int k = 0; k < K; ++k)
      if(alpha[k] != 0)
        record.add(k, alpha[k], reduction[k]);
  }
}

/// The iteration \f$ x \leftarrow x + B (b - A x) \f$; parameters as in `conjugate_gradient()`.
/// Ends where a residual grows to a hundred times what it was at first.
template <int K>
void stationary_iteration(const Preconditioned_operator<K>& a, Block_vector<K>& r,
                          Block_vector<K>& x, const Block_row<K>& target, int& iterations,
                          int maximum_iterations) {
  constexpr double largest_growth = 100;
  Block_vector<K> z, q;
  const Block_row<K> limit = largest_growth * dot<K>(r, r).sqrt();
  for(; iterations < maximum_iterations; ++iterations) {
    const Block_row<K> norm = dot<K>(r, r).sqrt();
    if(!(norm > target).any() || (norm > limit).any())
      return;
    a.precondition(r, z);
    a.multiply(z, q);
    if(!q.allFinite())
      return;
    x += z;
    r -= q;
    a.project(r);
  }
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_SHARED_CONJUGATE_GRADIENT_H
