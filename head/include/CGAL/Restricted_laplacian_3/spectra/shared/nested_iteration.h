// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_SHARED_NESTED_ITERATION_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_SHARED_NESTED_ITERATION_H

#include <CGAL/Restricted_laplacian_3/spectra/internal/Column_panels.h>

#include <Eigen/Core>

#include <algorithm>

/// \file
/// How eigenvectors of one level become those of the next, see `multigrid_eigenpairs()`.

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// The largest eigenvalue below 0 that a surface of this area would have, were the distance of
/// two eigenvalues the same everywhere (Weyl's law).
inline double natural_shift(double area) { return -4 * 3.14159265358979323846 / area; }

/// A level with fewer unknowns for each vector has no vectors that are like those of the finest
/// level.
constexpr Eigen::Index unknowns_of_a_start_vector = 10;

/// Number of vectors that are carried along for `k` pairs, in full panels. The last pairs converge
/// the faster, the larger the gap is to the first eigenvalue beyond all vectors.
inline int number_of_carried_vectors(int k) {
  constexpr int smallest_number_of_guards = 8, pairs_of_a_guard = 3;
  const int guards = (std::max)(smallest_number_of_guards, k / pairs_of_a_guard);
  return (k + guards + panel_width - 1) / panel_width * panel_width;
}

/// of residuals: prolongated vectors of a coarser level are no better than its discretization
constexpr double tolerance_of_coarse_levels = 1e-2;

/// of the eigenvalues of the first level; what is wrong in them the next level sets right
constexpr double tolerance_of_start = 1e-6;

/// \f$\alpha\f$ of the matrices \f$S + \alpha M\f$ that precondition: half of the tenth eigenvalue
/// of the first level (of the last one, if there are fewer). This is small enough for a good
/// preconditioner of most pairs, but not of a singular matrix.
/// \param shift \f$\sigma\f$ of the first level or the finest, see `Eigenpairs`
inline double reaction_of_hierarchy(const Eigen::VectorXd& eigenvalues, double shift) {
  constexpr Eigen::Index eigenvalue_of_alpha = 9;
  return (std::max)(eigenvalues[(std::min)(eigenvalues.size() - 1, eigenvalue_of_alpha)] / 2,
                    -shift);
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_SHARED_NESTED_ITERATION_H
