// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_MULTIGRID_LEVELS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_MULTIGRID_LEVELS_H

#include <CGAL/Restricted_laplacian_3/foundation/Sparse_matrix.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Number_lists.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Solvers
/// shape of a multigrid cycle: how often the next coarser level is visited
enum class Cycle { V = 1, W = 2 };

/// \ingroup PkgRestrictedLaplacian3Solvers
/// Sets of unknowns of one level that are relaxed together, in the order in which this is done.
///
/// Patches that follow each other form a *group*, groups that follow each other a *color*. No
/// unknown of a patch is coupled with one of a patch in another group of the same color, so groups
/// of a color can be relaxed at the same time, with the same result.
struct Smoothing_patches {
  /// the unknowns of each patch
  internal::Number_lists unknowns;
  /// how many patches there are
  std::size_t number_of_patches = 0;
  /// first patch of each group, and one more
  std::vector<std::uint32_t> groups = {0};
  /// first group of each color, and one more
  std::vector<std::uint32_t> colors = {0};
  /// For each unknown the number of a neighborhood; unknowns of one are stored together,
  /// neighborhoods by their numbers. It has no influence on results beyond rounding. May be empty.
  ///
  /// Rows of a neighborhood may be read when one of them is. So where a group has an unknown of a
  /// neighborhood, no unknown of that neighborhood is coupled with one of another group of the
  /// same color, nor belongs to one.
  std::vector<std::uint64_t> neighborhoods;
};

/// \cond SKIP_IN_MANUAL
/// \ingroup PkgRestrictedLaplacian3Solvers
/// What a multigrid hierarchy is made of besides the finest matrix. Matrices need not be
/// compressed. The functions that take it over leave it empty.
struct Multigrid_levels {
  /// from each level to the next finer one, coarsest first; none if there is one level only
  std::vector<Sparse_matrix> prolongations;
  /// of each level but the coarsest, coarsest first, for the smoother
  std::vector<Smoothing_patches> patches;
  /// matrices of each level but the finest, coarsest first, of the size of the columns of
  /// `prolongations`, or of each the half on and above the diagonal; if there are none, the
  /// Galerkin products are computed
  std::vector<Sparse_matrix> coarse_matrices;
};
/// \endcond

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_MULTIGRID_LEVELS_H
