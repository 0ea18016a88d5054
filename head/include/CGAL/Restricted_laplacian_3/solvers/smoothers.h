// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_SMOOTHERS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_SMOOTHERS_H

#include <CGAL/Restricted_laplacian_3/foundation/Sparse_matrix.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>
#include <CGAL/Restricted_laplacian_3/solvers/Multigrid_levels.h>
#include <CGAL/Restricted_laplacian_3/solvers/internal/Level_vectors.h>

#include <Eigen/Core>

#include <memory>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// What the smoothers of the package have in common: they relax groups of unknowns one after the
/// other, and keep the matrix in single precision, scaled and in an order of their own. `Multigrid`
/// finds out that a smoother has a layout, and has its vectors in it for a whole cycle.
///
/// With the layout go the functions `pre_smooth()`, `post_smooth()` and `residual()` for `K`
/// vectors, 1 or 8, of the matrix \f$D A D\f$ with the diagonal matrix `scale()`, at `positions()`.
/// \tparam Implementation keeps the matrix, and relaxes a group
template <class Implementation> class Group_smoother {
public:
  /// where unknowns are in the vectors of this level
  const Level_positions& positions() const;
  /// the diagonal of \f$D\f$, for each unknown
  const std::vector<double>& scale() const;

  /// starts from \f$x = 0\f$; on return \f$r = b - A x\f$
  template <int K>
  void pre_smooth(const Level_vectors<K>& b, Level_vectors<K>& x, Level_vectors<K>& r,
                  int steps) const;

  /// makes the transposes of the steps of `pre_smooth()`, from the given `x`
  template <int K>
  void post_smooth(const Level_vectors<K>& b, Level_vectors<K>& x, int steps) const;

  /// \f$r = b - A x\f$
  template <int K>
  void residual(const Level_vectors<K>& b, const Level_vectors<K>& x, Level_vectors<K>& r) const;

  /// number of colors of the patches
  std::size_t number_of_colors() const;
  /// Relaxes the groups of one color, in order or in reverse: for those who have a part of the
  /// unknowns, and must learn others between two colors.
  template <int K>
  void relax_color(std::size_t color, const Level_vectors<K>& b, Level_vectors<K>& x,
                   bool is_reversed) const;

  /// \name The concept
  /// Of `MultigridSmoother_3`; a step in single precision, so that corrections are accurate to
  /// about \f$10^{-6}\f$.
  /// @{
  void smooth(const Eigen::MatrixXd& b, Eigen::MatrixXd& x) const;
  void smooth_transposed(const Eigen::MatrixXd& b, Eigen::MatrixXd& x) const;
  /// @}

protected:
  explicit Group_smoother(std::shared_ptr<const Implementation> implementation)
    : m_implementation(std::move(implementation)) {}

private:
  /// relaxes the groups of all colors, in order or in reverse
  template <int K>
  void sweep(const Level_vectors<K>& b, Level_vectors<K>& x, bool is_reversed) const;
  void correct(const Eigen::MatrixXd& b, Eigen::MatrixXd& x, bool is_reversed) const;

  std::shared_ptr<const Implementation> m_implementation;
};

class Gauss_seidel_groups;
class Patch_groups;

} // namespace internal

/// \ingroup PkgRestrictedLaplacian3Solvers
/// Point Gauss-Seidel, in single precision. Unknowns are relaxed group by group (see
/// `Smoothing_patches`), and in a group by decreasing octave of the diagonal entry, see
/// `internal::order_by_octave_of_diagonal()`; in reverse after the coarse correction, which makes a
/// cycle a symmetric operator. A row whose diagonal entry is not positive is left out: its unknown
/// stays 0.
///
/// One sweep takes one pass over the matrix.
///
/// \cgalModels `MultigridSmoother_3`
class Gauss_seidel_smoother : public internal::Group_smoother<internal::Gauss_seidel_groups> {
public:
  /// \param a the matrix, see `MultigridSmoother_3`; what is below its diagonal is not read
  /// \param patches unknowns of a group are relaxed one after the other, groups of a color at the
  /// same time; there may be none
  /// \param is_parallel whether several threads are used; results do not depend on that
  Gauss_seidel_smoother(const Sparse_matrix& a, const Smoothing_patches& patches,
                        bool is_parallel = false);
};

/// \ingroup PkgRestrictedLaplacian3Solvers
/// Overlapping multiplicative Schwarz: the unknowns of each patch in turn are set to the solution
/// of their equations, the others fixed; in reverse order after the coarse correction, which makes
/// a cycle a symmetric operator.
///
/// Restricted splines are nearly dependent, which is why point Gauss-Seidel stalls; but a
/// combination that nearly vanishes on the surface does so on a few cells, and a patch that
/// contains its elements removes it at once. The usual patches are those of `smoothing_patches()`.
///
/// In single precision, with the inverses of the blocks stored: about 600 bytes an unknown for the
/// matrix and 400 for the inverses.
///
/// \cgalModels `MultigridSmoother_3`
class Patch_smoother : public internal::Group_smoother<internal::Patch_groups> {
public:
  /// \param a the matrix, see `MultigridSmoother_3`; what is below its diagonal is not read
  /// \param patches what is relaxed together
  /// \param is_parallel whether several threads are used; results do not depend on that
  Patch_smoother(const Sparse_matrix& a, const Smoothing_patches& patches,
                 bool is_parallel = false);
};

} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/solvers/smoothers_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_SMOOTHERS_H
