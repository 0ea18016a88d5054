// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_MULTIGRID_H
#define CGAL_RESTRICTED_LAPLACIAN_3_MULTIGRID_H

#include <CGAL/Restricted_laplacian_3/exceptions.h>
#include <CGAL/Restricted_laplacian_3/galerkin_product.h>
#include <CGAL/Restricted_laplacian_3/internal/block_vectors.h>
#include <CGAL/Restricted_laplacian_3/internal/connected_components.h>
#include <CGAL/Restricted_laplacian_3/internal/renumbering.h>
#include <CGAL/Restricted_laplacian_3/smoothers.h>

#include <Eigen/Dense>
#include <Eigen/SparseCore>

#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Ref
/// shape of a multigrid cycle: how often the next coarser level is visited
enum class Cycle { V = 1, W = 2 };

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

  explicit Pseudo_inverse(const Eigen::SparseMatrix<double>& a) {
    const auto [component, number] = connected_components(a);
    m_blocks.resize(number);
    std::vector<int> position(component.size());
    for(std::size_t i = 0; i < component.size(); ++i) {
      position[i] = static_cast<int>(m_blocks[component[i]].unknowns.size());
      m_blocks[component[i]].unknowns.push_back(static_cast<int>(i));
    }
    for(Block& block : m_blocks) {
      const Eigen::Index size = static_cast<Eigen::Index>(block.unknowns.size());
      Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(size, size);
      for(Eigen::Index j = 0; j < size; ++j)
        for(Eigen::SparseMatrix<double>::InnerIterator i(a, block.unknowns[j]); i; ++i)
          dense(position[i.row()], j) = i.value();
      block.inverse = inverse(dense);
    }
  }

  template <int K> void apply(const Block_vector<K>& b, Block_vector<K>& x) const {
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

private:
  struct Block {
    std::vector<int> unknowns;
    Eigen::MatrixXd inverse;
  };

  static Eigen::MatrixXd inverse(const Eigen::MatrixXd& a) {
    const Eigen::VectorXd scale =
        a.diagonal().unaryExpr([](double d) { return d > 0 ? 1 / std::sqrt(d) : 0.; });
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(scale.asDiagonal() * a *
                                                                scale.asDiagonal());
    const double largest = solver.eigenvalues().cwiseAbs().maxCoeff();
    const Eigen::VectorXd inverse = solver.eigenvalues().unaryExpr(
        [largest](double value) { return value > relative_cutoff * largest ? 1 / value : 0.; });
    const Eigen::MatrixXd vectors = scale.asDiagonal() * solver.eigenvectors();
    return vectors * inverse.asDiagonal() * vectors.transpose();
  }

  std::vector<Block> m_blocks;
};

} // namespace internal

/// \ingroup PkgRestrictedLaplacian3Ref
/// A multigrid hierarchy for a symmetric positive semi-definite matrix, and one cycle of it as a
/// linear operator that approximates the inverse.
///
/// Coarse matrices are the Galerkin products \f$A_l = P_l^T A_{l+1} P_l\f$, restriction is the
/// transpose of prolongation, the coarsest level is solved directly. With as many smoothing steps
/// before the coarse correction as after it the operator is symmetric positive semi-definite, so it
/// can precondition conjugate gradients. Knows matrices only, no surface.
///
/// *Numbering.* On each level but the coarsest the unknowns are renumbered by decreasing octave of
/// the diagonal entry, see `internal::order_by_octave_of_diagonal()`. All vectors passed to this
/// class are in this numbering; `order()` is its relation to that of the matrix it was made from.
///
/// \tparam Smoother a model of `MultigridSmoother_3`
template <class Smoother = Gauss_seidel_smoother> class Multigrid {
public:
  using Sparse_matrix = Eigen::SparseMatrix<double>;

  /// \param a the finest matrix, all of whose entries are stored
  /// \param prolongations from each level to the next finer one, coarsest first; may be empty
  /// \throws Parameter_error if the sizes do not fit
  Multigrid(Sparse_matrix a, std::vector<Sparse_matrix> prolongations)
    : m_prolongations(std::move(prolongations)), m_matrices(m_prolongations.size() + 1),
      m_coarse_inverse(coarsen(std::move(a))) {
    m_smoothers.reserve(m_prolongations.size());
    for(std::size_t level = 1; level < m_matrices.size(); ++level)
      m_smoothers.emplace_back(m_matrices[level]);
  }

  std::size_t number_of_levels() const { return m_matrices.size(); }
  /// matrix of a level, in the numbering of this class; 0 is the coarsest
  const Sparse_matrix& matrix(std::size_t level) const { return m_matrices[level]; }
  /// the finest matrix
  const Sparse_matrix& matrix() const { return m_matrices.back(); }
  /// unknown `i` of the finest level is unknown `order()[i]` of the matrix passed in
  const std::vector<int>& order() const { return m_order; }

  /// vectors of one cycle, kept between cycles
  template <int K> struct Workspace {
    struct Level {
      internal::Block_vector<K> b, x, r;
    };
    std::vector<Level> levels;
  };

  /// \f$ x \approx A^{-1} b \f$: one cycle that starts from 0
  /// \param steps number of smoothing steps before, and again after the coarse correction
  template <int K>
  void apply(const internal::Block_vector<K>& b, internal::Block_vector<K>& x, Cycle cycle,
             int steps, Workspace<K>& workspace) const {
    workspace.levels.resize(m_matrices.size());
    run<K>(m_matrices.size() - 1, b, x, cycle, steps, workspace);
  }

  /// A first guess by nested iteration: the coarsest problem is solved, then the solution of each
  /// level is prolongated to the next and improved by one cycle there, except on the finest. Takes
  /// about a third of the time of a cycle.
  template <int K>
  void nested_iteration(const internal::Block_vector<K>& b, internal::Block_vector<K>& x,
                        Cycle cycle, int steps, Workspace<K>& workspace) const {
    const std::size_t finest = m_matrices.size() - 1;
    workspace.levels.resize(m_matrices.size());
    std::vector<internal::Block_vector<K>> loads(m_matrices.size());
    loads[finest] = b;
    for(std::size_t level = finest; level > 0; --level)
      internal::restrict_to_coarse<K>(m_prolongations[level - 1], loads[level], loads[level - 1]);
    m_coarse_inverse.apply<K>(loads[0], x);
    for(std::size_t level = 1; level <= finest; ++level) {
      internal::Block_vector<K> fine =
          internal::Block_vector<K>::Zero(m_matrices[level].cols(), b.cols());
      internal::add_prolongated<K>(m_prolongations[level - 1], x, fine);
      x.swap(fine);
      if(level == finest)
        break;
      internal::Block_vector<K> r, correction;
      internal::residual<K>(m_matrices[level], loads[level], x, r);
      run<K>(level, r, correction, cycle, steps, workspace);
      x += correction;
    }
  }

private:
  /// the matrices of all levels; returns the coarsest
  const Sparse_matrix& coarsen(Sparse_matrix a) {
    if(a.rows() != a.cols())
      throw Parameter_error("a", "is not a square matrix");
    for(std::size_t level = m_prolongations.size(); level > 0; --level) {
      Sparse_matrix& prolongation = m_prolongations[level - 1];
      if(prolongation.rows() != a.cols())
        throw Parameter_error("prolongations", "do not fit the size of the matrix");
      const std::vector<int> order = internal::order_by_octave_of_diagonal(a);
      m_matrices[level] = internal::renumbered(a, order);
      prolongation = internal::renumbered_rows(prolongation, order);
      if(level < m_prolongations.size())
        m_prolongations[level] = internal::renumbered_columns(m_prolongations[level], order);
      else
        m_order = order;
      a = galerkin_product(m_matrices[level], prolongation);
    }
    if(m_prolongations.empty()) {
      m_order.resize(a.cols());
      std::iota(m_order.begin(), m_order.end(), 0);
    }
    m_matrices.front() = std::move(a);
    return m_matrices.front();
  }

  template <int K>
  void run(std::size_t level, const internal::Block_vector<K>& b, internal::Block_vector<K>& x,
           Cycle cycle, int steps, Workspace<K>& workspace) const {
    if(level == 0) {
      m_coarse_inverse.apply<K>(b, x);
      return;
    }
    const Smoother& smoother = m_smoothers[level - 1];
    auto& r = workspace.levels[level].r;
    auto& coarse = workspace.levels[level - 1];
    smoother.template pre_smooth<K>(m_matrices[level], b, x, r, steps);
    internal::restrict_to_coarse<K>(m_prolongations[level - 1], r, coarse.b);
    run<K>(level - 1, coarse.b, coarse.x, cycle, steps, workspace);
    internal::add_prolongated<K>(m_prolongations[level - 1], coarse.x, x);
    if(cycle == Cycle::W && level > 1) {
      // The second visit corrects what the first one left.
      internal::Block_vector<K> left;
      internal::residual<K>(m_matrices[level - 1], coarse.b, coarse.x, left);
      run<K>(level - 1, left, coarse.x, cycle, steps, workspace);
      internal::add_prolongated<K>(m_prolongations[level - 1], coarse.x, x);
    }
    smoother.template post_smooth<K>(m_matrices[level], b, x, steps);
  }

  std::vector<int> m_order;
  std::vector<Sparse_matrix> m_prolongations;
  std::vector<Sparse_matrix> m_matrices;
  internal::Pseudo_inverse m_coarse_inverse;
  std::vector<Smoother> m_smoothers;
};

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_MULTIGRID_H
