// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_MULTIGRID_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_MULTIGRID_H

#include <CGAL/Restricted_laplacian_3/foundation/Sparse_matrix.h>
#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parallel_for.h>
#include <CGAL/Restricted_laplacian_3/solvers/Multigrid_levels.h>
#include <CGAL/Restricted_laplacian_3/solvers/galerkin_product.h>
#include <CGAL/Restricted_laplacian_3/solvers/internal/Constant_deflation.h>
#include <CGAL/Restricted_laplacian_3/solvers/internal/Level_vectors.h>
#include <CGAL/Restricted_laplacian_3/solvers/internal/Regularized_inverse.h>
#include <CGAL/Restricted_laplacian_3/solvers/internal/Smoother_adaptor.h>
#include <CGAL/Restricted_laplacian_3/solvers/internal/symmetric_halves.h>
#include <CGAL/Restricted_laplacian_3/solvers/shared/Symmetric_matrix.h>
#include <CGAL/Restricted_laplacian_3/solvers/shared/block_vectors.h>
#include <CGAL/Restricted_laplacian_3/solvers/smoothers.h>

#include <CGAL/assertions.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

// What the library has of the hierarchy with a smoother of the package: `prefix` is extern, or
// nothing where it is compiled.
#define CGAL_RESTRICTED_LAPLACIAN_3_MULTIGRID_OF_BLOCK(prefix, Smoother, K)                        \
  prefix template void Multigrid<Smoother>::apply<K>(const internal::Block_vector<K>&,             \
                                                     internal::Block_vector<K>&, Cycle, int,       \
                                                     Multigrid<Smoother>::Workspace<K>&) const;    \
  prefix template void Multigrid<Smoother>::apply<K>(                                              \
      std::size_t, const internal::Block_vector<K>&, internal::Block_vector<K>&, Cycle, int,       \
      Multigrid<Smoother>::Workspace<K>&) const;                                                   \
  prefix template void Multigrid<Smoother>::nested_iteration<K>(                                   \
      const internal::Block_vector<K>&, internal::Block_vector<K>&, Cycle, int,                    \
      Multigrid<Smoother>::Workspace<K>&, internal::Block_vector<K>*) const;
#define CGAL_RESTRICTED_LAPLACIAN_3_MULTIGRID_OF(prefix, Smoother)                                 \
  prefix template class Multigrid<Smoother>;                                                       \
  CGAL_RESTRICTED_LAPLACIAN_3_MULTIGRID_OF_BLOCK(prefix, Smoother, 1)                              \
  CGAL_RESTRICTED_LAPLACIAN_3_MULTIGRID_OF_BLOCK(prefix, Smoother, 8)

/// \ingroup PkgRestrictedLaplacian3Solvers
/// A multigrid hierarchy for a symmetric positive semi-definite matrix, and one cycle of it as a
/// linear operator that approximates the inverse.
///
/// Coarse matrices are the Galerkin products \f$A_l = P_l^T A_{l+1} P_l\f$, restriction is the
/// transpose of prolongation, the coarsest level is solved directly. With as many smoothing steps
/// before the coarse correction as after it the operator is symmetric positive semi-definite, up to
/// rounding, so it can precondition conjugate gradients. Knows matrices only, no surface.
///
/// *Memory.* The matrices go into the hierarchy, which keeps of each level what the smoother and
/// the transfer to the next level need. Each matrix is given up as soon as it is no longer read.
///
/// *Precision.* A cycle computes in single precision, on matrices that are scaled to diagonals near
/// 1, but for the coarsest level; vectors come and go in double precision and in the numbering of
/// the matrix. What a cycle returns is accurate to about \f$10^{-6}\f$ at best, which does not
/// limit the accuracy of an iteration that it preconditions.
///
/// \tparam Smoother a model of `MultigridSmoother_3`
template <class Smoother = Patch_smoother> class Multigrid {
public:
  /// a matrix, column by column, in double precision
  using Sparse_matrix = Restricted_laplacian_3::Sparse_matrix;

  /// an empty hierarchy
  Multigrid() : m_is_parallel(false), m_is_below_finer_levels(false), m_size(0) {}

  /// \param a the finest matrix; what is below its diagonal is not read, and need not be stored. It
  /// is empty afterwards.
  /// \param levels what else the hierarchy is made of
  /// \param is_parallel whether several threads are used; results do not depend on that
  /// \param is_matrix_kept whether `finest_matrix()` is needed
  /// \param is_below_finer_levels whether right-hand sides come from finer levels in single
  /// precision: what lies in them along the kernel is a rounding error, and removed
  /// \throws Parameter_error if the sizes do not fit, or if there is something below the diagonal
  /// of a matrix, but not as much as above
  /// \throws Numerical_error if a matrix of the coarsest level is not one of finite numbers
  Multigrid(Sparse_matrix&& a, Multigrid_levels levels, bool is_parallel = false,
            bool is_matrix_kept = false, bool is_below_finer_levels = false)
    : m_is_parallel(is_parallel), m_is_below_finer_levels(is_below_finer_levels), m_size(a.cols()) {
    const std::size_t finest = levels.prolongations.size();
    check_sizes(a, levels);
    levels.patches.resize(finest);
    std::vector<Sparse_matrix>& matrices = levels.coarse_matrices;
    if(matrices.empty()) {
      matrices.resize(finest);
      if(finest > 0 && !internal::has_both_halves(a, "a"))
        internal::whole(a).swap(a);
      for(std::size_t level = finest; level > 0; --level)
        galerkin_product(level == finest ? a : matrices[level], levels.prolongations[level - 1],
                         is_parallel)
            .swap(matrices[level - 1]);
    }
    matrices.emplace_back();
    matrices.back().swap(a);
    // What a level no longer needs makes room for the next finer one, which takes most.
    m_levels.resize(finest + 1);
    m_smoothers.reserve(finest);
    set_coarsest(matrices[0]);
    for(std::size_t level = 0; level <= finest; ++level) {
      take_matrix(level, matrices[level], level > 0 ? &levels.patches[level - 1] : nullptr,
                  level == finest && is_matrix_kept);
      if(level == 0)
        continue;
      levels.patches[level - 1] = Smoothing_patches();
      set_transfer(level, levels.prolongations[level - 1]);
      Sparse_matrix().swap(levels.prolongations[level - 1]);
    }
  }

  /// the same with a copy of the matrix
  Multigrid(const Sparse_matrix& a, Multigrid_levels levels, bool is_parallel = false,
            bool is_matrix_kept = false)
    : Multigrid(Sparse_matrix(a), std::move(levels), is_parallel, is_matrix_kept) {}

  /// number of levels, the coarsest and the finest included; 0 if the hierarchy is empty
  std::size_t number_of_levels() const { return m_levels.size(); }
  /// number of rows of the finest matrix
  Eigen::Index size() const { return m_size; }
  /// the smoother of a level; 0 is the coarsest, which has none
  const Smoother& smoother(std::size_t level) const {
    if constexpr(has_layout)
      return level_smoother(level);
    else
      return level_smoother(level).smoother();
  }
  /// half of the finest matrix, for products with it; empty unless the constructor was told to keep
  /// it
  const internal::Symmetric_matrix& finest_matrix() const { return m_finest_matrix; }

  /// \ingroup PkgRestrictedLaplacian3Solvers
  /// vectors of one cycle, kept between cycles
  template <int K> struct Workspace {
    struct Level {
      internal::Level_vectors<K> b, x, r, residual;
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
    CGAL_precondition(!m_levels.empty());
    apply<K>(m_levels.size() - 1, b, x, cycle, steps, workspace);
  }

  /// The same for the matrix of a level; 0 is the coarsest.
  template <int K>
  void apply(std::size_t level, const internal::Block_vector<K>& b, internal::Block_vector<K>& x,
             Cycle cycle, int steps, Workspace<K>& workspace) const {
    CGAL_precondition(level < m_levels.size() && steps >= 0);
    if(level == 0) {
      m_coarse_inverse.apply<K>(b, x);
      return;
    }
    CGAL_precondition(b.rows() == static_cast<Eigen::Index>(scale(level).size()));
    workspace.levels.resize(m_levels.size());
    auto& vectors = workspace.levels[level];
    const internal::Block_row<K> scale = import_load<K>(level, b, vectors.b);
    if(m_is_below_finer_levels)
      m_levels[level].deflation.template remove_from<K>(vectors.b);
    run<K>(level, vectors.b, vectors.x, cycle, steps, workspace);
    export_solution<K>(level, vectors.x, scale, x);
  }

  /// A first guess by nested iteration: the coarsest problem is solved, then the solution of each
  /// level is prolongated to the next and improved by one cycle there, except on the finest. Takes
  /// about a third of the time of a cycle.
  /// \param b,x,cycle,steps,workspace as of `apply()`; `x` is that of the level below
  /// \param coarser receives the solution of the level below that one; empty if there is none
  template <int K>
  void nested_iteration(const internal::Block_vector<K>& b, internal::Block_vector<K>& x,
                        Cycle cycle, int steps, Workspace<K>& workspace,
                        internal::Block_vector<K>* coarser = nullptr) const {
    CGAL_precondition(!m_levels.empty() && b.rows() == m_size);
    const std::size_t finest = m_levels.size() - 1;
    if(coarser)
      coarser->resize(0, K);
    if(finest == 0) {
      m_coarse_inverse.apply<K>(b, x);
      return;
    }
    workspace.levels.resize(m_levels.size());
    std::vector<internal::Level_vectors<K>> loads(m_levels.size());
    const internal::Block_row<K> scale = import_load<K>(finest, b, loads[finest]);
    for(std::size_t level = finest; level > 0; --level)
      restrict_load<K>(level, loads[level], loads[level - 1]);
    internal::Level_vectors<K> solution, fine, correction;
    solve_coarsest<K>(loads[0], solution, workspace);
    for(std::size_t level = 1;; ++level) {
      m_levels[level].prolongation.template multiply<K, false>(m_is_parallel, solution, fine);
      solution.swap(fine);
      if(level == finest)
        break;
      if(coarser && level + 1 == finest) {
        m_levels[finest].prolongation.template multiply<K, false>(m_is_parallel, solution, fine);
        export_solution<K>(finest, fine, scale, *coarser);
      }
      auto& residual = workspace.levels[level].residual;
      level_smoother(level).template residual<K>(loads[level], solution, residual);
      run<K>(level, residual, correction, cycle, steps, workspace);
      add<K>(correction, solution);
    }
    export_solution<K>(finest, solution, scale, x);
  }

private:
  struct Level {
    internal::Level_matrix prolongation, restriction; // from and to the next coarser level
    internal::Constant_deflation deflation; // of levels above the coarsest and below finer ones
  };

  static constexpr bool has_layout = internal::Has_layout<Smoother>::value;
  using Level_smoother =
      std::conditional_t<has_layout, Smoother, internal::Smoother_adaptor<Smoother>>;

  static void check_sizes(const Sparse_matrix& a, const Multigrid_levels& levels) {
    if(a.rows() != a.cols())
      throw Parameter_error("a", "is not a square matrix");
    Eigen::Index size = a.cols();
    for(std::size_t level = levels.prolongations.size(); level > 0; --level) {
      if(levels.prolongations[level - 1].rows() != size)
        throw Parameter_error("prolongations", "do not fit the size of the matrix");
      size = levels.prolongations[level - 1].cols();
      if(!levels.coarse_matrices.empty() &&
         (levels.coarse_matrices.size() != levels.prolongations.size() ||
          levels.coarse_matrices[level - 1].cols() != size ||
          levels.coarse_matrices[level - 1].rows() != size))
        throw Parameter_error("coarse_matrices", "do not fit the prolongations");
    }
    static_cast<void>(internal::has_both_halves(a, "a"));
    for(const Sparse_matrix& coarse : levels.coarse_matrices)
      static_cast<void>(internal::has_both_halves(coarse, "coarse_matrices"));
    if(!levels.patches.empty() && levels.patches.size() != levels.prolongations.size())
      throw Parameter_error("patches", "are not given for each level but the coarsest");
  }

  const Level_smoother& level_smoother(std::size_t level) const {
    CGAL_precondition(level > 0 && level < m_levels.size());
    return m_smoothers[level - 1];
  }

  /// Makes the smoother of a level, if there are patches. A smoother with a layout reads one half
  /// of the matrix, so the other one is given up first: what it makes of it takes the most memory.
  void take_matrix(std::size_t level, Sparse_matrix& a, const Smoothing_patches* patches,
                   bool is_kept) {
    if constexpr(has_layout) {
      internal::Symmetric_matrix half;
      half.take_half_of(a);
      if(patches) {
        m_smoothers.emplace_back(half.upper_half(), *patches, m_is_parallel);
        set_deflation(level, half.upper_half());
      }
      if(is_kept)
        m_finest_matrix.swap(half);
    } else {
      if(is_kept) {
        Sparse_matrix copy = a;
        m_finest_matrix.take_half_of(copy);
      }
      if(patches) {
        m_smoothers.emplace_back(internal::whole(a), *patches, m_is_parallel);
        set_deflation(level, a);
      }
    }
    Sparse_matrix().swap(a);
  }

  void set_deflation(std::size_t level, const Sparse_matrix& a) {
    if(level + 1 < m_levels.size() || m_is_below_finer_levels)
      m_levels[level].deflation = internal::Constant_deflation(a, positions(level), scale(level));
  }

  void set_coarsest(const Sparse_matrix& a) {
    using Inverse = internal::Regularized_inverse;
    m_coarse_inverse =
        Inverse(a, m_levels.size() == 1 && !m_is_below_finer_levels ? Inverse::double_precision
                                                                    : Inverse::single_precision);
    m_coarse_scale = internal::balancing_scale(a);
    m_coarse_positions = internal::Level_positions::consecutive(static_cast<std::size_t>(a.cols()));
  }

  const internal::Level_positions& positions(std::size_t level) const {
    return level == 0 ? m_coarse_positions : level_smoother(level).positions();
  }
  const std::vector<double>& scale(std::size_t level) const {
    return level == 0 ? m_coarse_scale : level_smoother(level).scale();
  }

  /// With \f$A\f$ replaced by \f$D A D\f$ the prolongation is \f$D^{-1} P D_c\f$.
  void set_transfer(std::size_t level, const Sparse_matrix& p) {
    std::vector<double> inverse_scale = scale(level);
    for(double& s : inverse_scale)
      s = 1 / s;
    const std::vector<double>& coarse_scale = scale(level - 1);
    internal::parallel_for(m_is_parallel, 0, 2, 1, [&](std::size_t which, std::size_t) {
      if(which == 0)
        m_levels[level].restriction = internal::Level_matrix::of_transpose(
            p, positions(level - 1), coarse_scale, positions(level), inverse_scale);
      else
        m_levels[level].prolongation = internal::Level_matrix::of(
            p, positions(level), inverse_scale, positions(level - 1), coarse_scale);
    });
  }

  /// scales the columns to largest entry 1, returns the factors
  template <int K>
  internal::Block_row<K> import_load(std::size_t level, const internal::Block_vector<K>& from,
                                     internal::Level_vectors<K>& to) const {
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
  void export_solution(std::size_t level, const internal::Level_vectors<K>& from,
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

  template <int K>
  static void add(const internal::Level_vectors<K>& from, internal::Level_vectors<K>& to) {
    for(std::size_t i = 0; i < from.size(); ++i)
      to.data()[i] += from.data()[i];
  }

  template <int K>
  void solve_coarsest(const internal::Level_vectors<K>& b, internal::Level_vectors<K>& x,
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

  /// the load of the next coarser level
  template <int K>
  void restrict_load(std::size_t level, const internal::Level_vectors<K>& fine,
                     internal::Level_vectors<K>& coarse) const {
    m_levels[level].restriction.template multiply<K, false>(m_is_parallel, fine, coarse);
    m_levels[level - 1].deflation.template remove_from<K>(coarse);
  }

  template <int K>
  void run(std::size_t level, const internal::Level_vectors<K>& b, internal::Level_vectors<K>& x,
           Cycle cycle, int steps, Workspace<K>& workspace) const {
    if(level == 0) {
      solve_coarsest<K>(b, x, workspace);
      return;
    }
    const Level_smoother& smoother = level_smoother(level);
    const Level& transfer = m_levels[level];
    auto& r = workspace.levels[level].r;
    auto& coarse = workspace.levels[level - 1];
    smoother.template pre_smooth<K>(b, x, r, steps);
    restrict_load<K>(level, r, coarse.b);
    run<K>(level - 1, coarse.b, coarse.x, cycle, steps, workspace);
    transfer.prolongation.template multiply<K, true>(m_is_parallel, coarse.x, x);
    if(cycle == Cycle::W && level > 1) {
      // The second visit corrects what the first one left.
      internal::Level_vectors<K> residual;
      level_smoother(level - 1).template residual<K>(coarse.b, coarse.x, residual);
      m_levels[level - 1].deflation.template remove_from<K>(residual);
      run<K>(level - 1, residual, coarse.x, cycle, steps, workspace);
      transfer.prolongation.template multiply<K, true>(m_is_parallel, coarse.x, x);
    }
    smoother.template post_smooth<K>(b, x, steps);
  }

  static constexpr std::size_t conversion_grain = 16384;

  bool m_is_parallel, m_is_below_finer_levels;
  Eigen::Index m_size;
  std::vector<Level> m_levels;
  std::vector<Level_smoother> m_smoothers;
  internal::Symmetric_matrix m_finest_matrix;
  internal::Regularized_inverse m_coarse_inverse;
  internal::Level_positions m_coarse_positions;
  std::vector<double> m_coarse_scale;
};

#ifdef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
CGAL_RESTRICTED_LAPLACIAN_3_MULTIGRID_OF(extern, Patch_smoother)
CGAL_RESTRICTED_LAPLACIAN_3_MULTIGRID_OF(extern, Gauss_seidel_smoother)
#endif

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_MULTIGRID_H
