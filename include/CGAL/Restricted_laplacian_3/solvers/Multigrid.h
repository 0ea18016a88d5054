// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_MULTIGRID_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_MULTIGRID_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parallel_for.h>
#include <CGAL/Restricted_laplacian_3/solvers/Level_vectors.h>
#include <CGAL/Restricted_laplacian_3/solvers/galerkin_product.h>
#include <CGAL/Restricted_laplacian_3/solvers/internal/block_vectors.h>
#include <CGAL/Restricted_laplacian_3/solvers/internal/connected_components.h>
#include <CGAL/Restricted_laplacian_3/solvers/smoothers.h>

#include <Eigen/Dense>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Solvers
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

  /// What is added to the other eigenvalues, times the largest, below a level in single precision:
  /// the right-hand side carries rounding errors of 1e-7 then, and its part along an eigenvector
  /// whose eigenvalue is as small must not be amplified.
  static constexpr double single_precision_regularization = 1e-6;

  Pseudo_inverse() = default;

  Pseudo_inverse(const Eigen::SparseMatrix<double>& a, double regularization) {
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
      block.inverse = inverse(dense, regularization);
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

  static Eigen::MatrixXd inverse(const Eigen::MatrixXd& a, double regularization) {
    const Eigen::VectorXd scale =
        a.diagonal().unaryExpr([](double d) { return d > 0 ? 1 / std::sqrt(d) : 0.; });
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(scale.asDiagonal() * a *
                                                                scale.asDiagonal());
    const double largest = solver.eigenvalues().cwiseAbs().maxCoeff();
    const Eigen::VectorXd inverse =
        solver.eigenvalues().unaryExpr([largest, regularization](double value) {
          return value > relative_cutoff * largest ? 1 / (value + regularization * largest) : 0.;
        });
    const Eigen::MatrixXd vectors = scale.asDiagonal() * solver.eigenvectors();
    return vectors * inverse.asDiagonal() * vectors.transpose();
  }

  std::vector<Block> m_blocks;
};

} // namespace internal

/// \ingroup PkgRestrictedLaplacian3Solvers
/// A multigrid hierarchy for a symmetric positive semi-definite matrix, and one cycle of it as a
/// linear operator that approximates the inverse.
///
/// Coarse matrices are the Galerkin products \f$A_l = P_l^T A_{l+1} P_l\f$, restriction is the
/// transpose of prolongation, the coarsest level is solved directly. With as many smoothing steps
/// before the coarse correction as after it the operator is symmetric positive semi-definite, up to
/// rounding, so it can precondition conjugate gradients. Knows matrices only, no surface.
///
/// *Precision.* A cycle computes in single precision, on matrices that are scaled to diagonals near
/// 1, but for the coarsest level; vectors come and go in double precision and in the numbering of
/// the matrix. What a cycle returns is accurate to about \f$10^{-6}\f$ at best, which does not
/// limit the accuracy of an iteration that it preconditions.
///
/// \tparam Smoother a model of `MultigridSmoother_3`
template <class Smoother = Patch_smoother> class Multigrid {
public:
  /// all entries of a matrix, column by column, in double precision
  using Sparse_matrix = Eigen::SparseMatrix<double>;

  /// an empty hierarchy
  Multigrid() : m_is_parallel(false), m_size(0) {}

  /// \param a the finest matrix, all of whose entries are stored
  /// \param prolongations from each level to the next finer one, coarsest first; may be empty
  /// \param patches of each level but the coarsest, coarsest first, for the smoother
  /// \param coarse_matrices of each level but the finest, coarsest first; if there are none, they
  /// are computed as Galerkin products
  /// \param is_parallel whether several threads are used; results do not depend on that
  /// \param matrix_is_read called when `a` is no longer read: it may be given up then, to make room
  /// for the rest of the setup
  /// \throws Parameter_error if the sizes do not fit
  Multigrid(const Sparse_matrix& a, std::vector<Sparse_matrix> prolongations,
            std::vector<Smoothing_patches> patches, bool is_parallel = false,
            std::vector<Sparse_matrix> coarse_matrices = {},
            const std::function<void()>& matrix_is_read = {})
    : m_is_parallel(is_parallel), m_size(a.cols()) {
    check_sizes(a, prolongations, patches, coarse_matrices);
    const std::size_t finest = prolongations.size();
    if(coarse_matrices.empty()) {
      coarse_matrices.resize(finest);
      for(std::size_t level = finest; level > 0; --level)
        galerkin_product(level == finest ? a : coarse_matrices[level], prolongations[level - 1],
                         is_parallel)
            .swap(coarse_matrices[level - 1]);
    }
    // What a level no longer needs makes room for the next finer one, which takes most.
    m_levels.resize(finest + 1);
    m_smoothers.reserve(finest);
    set_coarsest(finest == 0 ? a : coarse_matrices[0]);
    if(finest == 0 && matrix_is_read)
      matrix_is_read();
    for(std::size_t level = 1; level <= finest; ++level) {
      Sparse_matrix().swap(coarse_matrices[level - 1]);
      if(level < finest)
        m_smoothers.emplace_back(coarse_matrices[level], patches[level - 1], is_parallel);
      else
        m_smoothers.emplace_back(a, patches[level - 1], is_parallel, matrix_is_read);
      patches[level - 1] = Smoothing_patches();
      set_transfer(level, prolongations[level - 1]);
      Sparse_matrix().swap(prolongations[level - 1]);
    }
  }

  /// number of levels, the coarsest and the finest included; 0 if the hierarchy is empty
  std::size_t number_of_levels() const { return m_levels.size(); }
  /// number of rows of the finest matrix
  Eigen::Index size() const { return m_size; }
  /// the smoother of a level; 0 is the coarsest, which has none
  const Smoother& smoother(std::size_t level) const { return m_smoothers[level - 1]; }

  /// \ingroup PkgRestrictedLaplacian3Solvers
  /// vectors of one cycle, kept between cycles
  template <int K> struct Workspace {
    struct Level {
      Level_vectors<K> b, x, r, left;
    };
    /// vectors of each level
    std::vector<Level> levels;
    /// right-hand side of the coarsest level
    internal::Block_vector<K> coarse_b;
    /// solution of the coarsest level
    internal::Block_vector<K> coarse_x;
  };

  /// \f$ x \approx A^{-1} b \f$: one cycle that starts from 0
  /// \param b \f$K\f$ right-hand sides
  /// \param x the solutions; its old content does not matter
  /// \param cycle shape of the cycle
  /// \param steps number of smoothing steps before, and again after the coarse correction
  /// \param workspace vectors that are reused, of one thread only
  template <int K>
  void apply(const internal::Block_vector<K>& b, internal::Block_vector<K>& x, Cycle cycle,
             int steps, Workspace<K>& workspace) const {
    apply<K>(m_levels.size() - 1, b, x, cycle, steps, workspace);
  }

  /// The same for the matrix of a level; 0 is the coarsest.
  template <int K>
  void apply(std::size_t level, const internal::Block_vector<K>& b, internal::Block_vector<K>& x,
             Cycle cycle, int steps, Workspace<K>& workspace) const {
    if(level == 0) {
      m_coarse_inverse.apply<K>(b, x);
      return;
    }
    workspace.levels.resize(m_levels.size());
    auto& vectors = workspace.levels[level];
    const internal::Block_row<K> scale = import_load<K>(level, b, vectors.b);
    run<K>(level, vectors.b, vectors.x, cycle, steps, workspace);
    export_solution<K>(level, vectors.x, scale, x);
  }

  /// A first guess by nested iteration: the coarsest problem is solved, then the solution of each
  /// level is prolongated to the next and improved by one cycle there, except on the finest. Takes
  /// about a third of the time of a cycle.
  template <int K>
  void nested_iteration(const internal::Block_vector<K>& b, internal::Block_vector<K>& x,
                        Cycle cycle, int steps, Workspace<K>& workspace) const {
    const std::size_t finest = m_levels.size() - 1;
    if(finest == 0) {
      m_coarse_inverse.apply<K>(b, x);
      return;
    }
    workspace.levels.resize(m_levels.size());
    std::vector<Level_vectors<K>> loads(m_levels.size());
    const internal::Block_row<K> scale = import_load<K>(finest, b, loads[finest]);
    for(std::size_t level = finest; level > 0; --level)
      m_levels[level].restriction.template multiply<K, false>(m_is_parallel, loads[level],
                                                              loads[level - 1]);
    Level_vectors<K> solution, fine, correction;
    solve_coarsest<K>(loads[0], solution, workspace);
    for(std::size_t level = 1;; ++level) {
      m_levels[level].prolongation.template multiply<K, false>(m_is_parallel, solution, fine);
      solution.swap(fine);
      if(level == finest)
        break;
      auto& left = workspace.levels[level].left;
      smoother(level).template residual<K>(loads[level], solution, left);
      run<K>(level, left, correction, cycle, steps, workspace);
      add<K>(correction, solution);
    }
    export_solution<K>(finest, solution, scale, x);
  }

private:
  struct Level {
    Level_matrix prolongation, restriction; // from and to the next coarser level
  };

  static void check_sizes(const Sparse_matrix& a, const std::vector<Sparse_matrix>& prolongations,
                          const std::vector<Smoothing_patches>& patches,
                          const std::vector<Sparse_matrix>& coarse_matrices) {
    if(a.rows() != a.cols())
      throw Parameter_error("a", "is not a square matrix");
    Eigen::Index size = a.cols();
    for(std::size_t level = prolongations.size(); level > 0; --level) {
      if(prolongations[level - 1].rows() != size)
        throw Parameter_error("prolongations", "do not fit the size of the matrix");
      size = prolongations[level - 1].cols();
      if(!coarse_matrices.empty() &&
         (coarse_matrices.size() != prolongations.size() ||
          coarse_matrices[level - 1].cols() != size || coarse_matrices[level - 1].rows() != size))
        throw Parameter_error("coarse_matrices", "do not fit the prolongations");
    }
    if(patches.size() != prolongations.size())
      throw Parameter_error("patches", "are not given for each level but the coarsest");
  }

  void set_coarsest(const Sparse_matrix& a) {
    m_coarse_inverse = internal::Pseudo_inverse(
        a, m_levels.size() == 1 ? 0 : internal::Pseudo_inverse::single_precision_regularization);
    m_coarse_scale = balancing_scale(a);
    m_coarse_positions = Level_positions::consecutive(static_cast<std::size_t>(a.cols()));
  }

  const Level_positions& positions(std::size_t level) const {
    return level == 0 ? m_coarse_positions : smoother(level).positions();
  }
  const std::vector<double>& scale(std::size_t level) const {
    return level == 0 ? m_coarse_scale : smoother(level).scale();
  }

  /// With \f$A\f$ replaced by \f$D A D\f$ the prolongation is \f$D^{-1} P D_c\f$.
  void set_transfer(std::size_t level, const Sparse_matrix& p) {
    std::vector<double> inverse_scale = scale(level);
    for(double& s : inverse_scale)
      s = 1 / s;
    const std::vector<double>& coarse_scale = scale(level - 1);
    m_levels[level].restriction = Level_matrix::of_transpose(p, positions(level - 1), coarse_scale,
                                                             positions(level), inverse_scale);
    m_levels[level].prolongation =
        Level_matrix::of(p, positions(level), inverse_scale, positions(level - 1), coarse_scale);
  }

  /// scales the columns to largest entry 1, returns the factors
  template <int K>
  internal::Block_row<K> import_load(std::size_t level, const internal::Block_vector<K>& from,
                                     Level_vectors<K>& to) const {
    const std::vector<double>& d = scale(level);
    const std::vector<std::uint32_t>& position = positions(level).of_unknown;
    internal::Block_row<K> largest = internal::Block_row<K>::Zero();
    for(std::size_t i = 0; i < d.size(); ++i)
      largest = largest.max((d[i] * internal::row<K>(from, i)).abs());
    const internal::Block_row<K> factor =
        largest.unaryExpr([](double x) { return x > 0 ? std::ldexp(1., std::ilogb(x)) : 1.; });
    const internal::Block_row<K> inverse = factor.inverse();
    to.set_zero(positions(level).number_of_positions);
    internal::parallel_for(
        m_is_parallel, 0, d.size(), conversion_grain, [&](std::size_t begin, std::size_t end) {
          for(std::size_t i = begin; i < end; ++i) {
            const internal::Block_row<K> value = internal::row<K>(from, i) * inverse * d[i];
            float* const place = to.position(position[i]);
            for(int c = 0; c < K; ++c)
              place[c] = static_cast<float>(value[c]);
          }
        });
    return factor;
  }

  template <int K>
  void export_solution(std::size_t level, const Level_vectors<K>& from,
                       const internal::Block_row<K>& factor, internal::Block_vector<K>& to) const {
    const std::vector<double>& d = scale(level);
    const std::vector<std::uint32_t>& position = positions(level).of_unknown;
    to.resize(static_cast<Eigen::Index>(d.size()), K);
    internal::parallel_for(m_is_parallel, 0, d.size(), conversion_grain,
                           [&](std::size_t begin, std::size_t end) {
                             for(std::size_t i = begin; i < end; ++i) {
                               const float* const place = from.position(position[i]);
                               for(int c = 0; c < K; ++c)
                                 to(i, c) = place[c] * d[i] * factor[c];
                             }
                           });
  }

  template <int K> static void add(const Level_vectors<K>& from, Level_vectors<K>& to) {
    for(std::size_t i = 0; i < from.size(); ++i)
      to.data()[i] += from.data()[i];
  }

  template <int K>
  void solve_coarsest(const Level_vectors<K>& b, Level_vectors<K>& x,
                      Workspace<K>& workspace) const {
    const Eigen::Index size = static_cast<Eigen::Index>(m_coarse_scale.size());
    workspace.coarse_b.resize(size, K);
    x.set_zero(m_coarse_positions.number_of_positions);
    for(Eigen::Index i = 0; i < size; ++i)
      for(int c = 0; c < K; ++c)
        workspace.coarse_b(i, c) = b.position(i)[c] / m_coarse_scale[i];
    m_coarse_inverse.apply<K>(workspace.coarse_b, workspace.coarse_x);
    for(Eigen::Index i = 0; i < size; ++i)
      for(int c = 0; c < K; ++c)
        x.position(i)[c] = static_cast<float>(workspace.coarse_x(i, c) / m_coarse_scale[i]);
  }

  template <int K>
  void run(std::size_t level, const Level_vectors<K>& b, Level_vectors<K>& x, Cycle cycle,
           int steps, Workspace<K>& workspace) const {
    if(level == 0) {
      solve_coarsest<K>(b, x, workspace);
      return;
    }
    const Smoother& smoother = this->smoother(level);
    const Level& transfer = m_levels[level];
    auto& r = workspace.levels[level].r;
    auto& coarse = workspace.levels[level - 1];
    smoother.template pre_smooth<K>(b, x, r, steps);
    transfer.restriction.template multiply<K, false>(m_is_parallel, r, coarse.b);
    run<K>(level - 1, coarse.b, coarse.x, cycle, steps, workspace);
    transfer.prolongation.template multiply<K, true>(m_is_parallel, coarse.x, x);
    if(cycle == Cycle::W && level > 1) {
      // The second visit corrects what the first one left.
      Level_vectors<K> left;
      this->smoother(level - 1).template residual<K>(coarse.b, coarse.x, left);
      run<K>(level - 1, left, coarse.x, cycle, steps, workspace);
      transfer.prolongation.template multiply<K, true>(m_is_parallel, coarse.x, x);
    }
    smoother.template post_smooth<K>(b, x, steps);
  }

  static constexpr std::size_t conversion_grain = 16384;

  bool m_is_parallel;
  Eigen::Index m_size;
  std::vector<Level> m_levels;
  std::vector<Smoother> m_smoothers;
  internal::Pseudo_inverse m_coarse_inverse;
  Level_positions m_coarse_positions;
  std::vector<double> m_coarse_scale;
};

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_MULTIGRID_H
