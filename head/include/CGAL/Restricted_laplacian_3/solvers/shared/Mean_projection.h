// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_SHARED_MEAN_PROJECTION_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_SHARED_MEAN_PROJECTION_H

#include <CGAL/Restricted_laplacian_3/foundation/Sparse_matrix.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>
#include <CGAL/Restricted_laplacian_3/solvers/shared/block_vectors.h>

#include <Eigen/Core>
#include <Eigen/StdVector>

#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// The functions that are constant on one connected component of the graph of a matrix \f$A\f$ and
/// 0 on the others, as far as \f$A 1_c = w_c\f$ with given loads \f$w_c\f$. This holds for
/// \f$A = S + M_w\f$, \f$w\f$ the integrals of the elements with the weight of the mass matrix, if
/// constants are in the space. Where \f$w_c = 0\f$ they are in the kernel. Otherwise the weighted
/// mean of a solution on the component is known beforehand, \f$1_c^T b / 1_c^T w_c\f$, and both are
/// split off in the same way.
///
/// So the load of a solver is projected to mean 0 on these components, and the solution is shifted
/// to the mean that is known.
class Mean_projection {
public:
  /// \param constant_loads \f$w\f$, not negative
  Mean_projection(const Sparse_matrix& a, Eigen::VectorXd integrals,
                  const Eigen::VectorXd& constant_loads);

  int number_of_components() const { return static_cast<int>(m_sums.size()); }
  /// number of the component of each unknown
  const std::vector<int>& components() const { return m_component; }
  /// whether \f$A 1_c = w_c\f$ holds on a component
  bool is_split_off(int component) const { return m_is_split_off[component]; }
  /// whether \f$w_c \ne 0\f$
  bool is_screened(int component) const { return m_is_screened[component]; }
  /// The weights of the unknowns in the means on their components: \f$w_c\f$, or the integrals of
  /// the elements where it is 0.
  const Eigen::VectorXd& measures() const { return m_measures; }
  /// their sum on a component
  double sum_of_measures(int component) const { return m_sums[component]; }

  /// number of components whose constants are in the kernel
  int kernel_dimension() const;

  /// Subtracts the load of a constant on each component, so that the loads of the component sum to
  /// 0: the right-hand side of \f$f\f$ becomes that of \f$f\f$ minus its mean.
  template <int K> void project_load(Block_vector<K>& b) const;

  /// Shifts a solution on each component by a constant: to mean 0 if \f$w_c = 0\f$, else to the
  /// mean that solves the equation with the right-hand side \f$b\f$ before its projection.
  template <int K> void shift_solution(const Block_vector<K>& b, Block_vector<K>& x) const;

private:
  template <int K>
  using Block_rows = std::vector<Block_row<K>, Eigen::aligned_allocator<Block_row<K>>>;
  /// weighted sums over each component that is split off, over that of the measures; 0 for others
  template <int K, class Weight>
  Block_rows<K> means(const Block_vector<K>& v, Weight&& weight) const;

  Eigen::VectorXd m_measures;
  std::vector<int> m_component;
  std::vector<double> m_sums;
  std::vector<char> m_is_screened, m_is_split_off;
  int m_number = 0;
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/solvers/shared/Mean_projection_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_SHARED_MEAN_PROJECTION_H
