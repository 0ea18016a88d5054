// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_INTERNAL_FILTERED_SQUARES_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_INTERNAL_FILTERED_SQUARES_H

#include <Eigen/Core>

#include <algorithm>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// \f$\sum_i \phi_i(x)^2\, w_{ij}\f$: rows are points, columns those of `weights`; a row with NaN
/// values becomes NaN. In blocks of rows, so that the squares need no memory that counts.
inline Eigen::MatrixXd filtered_squares(const Eigen::Ref<const Eigen::MatrixXd>& values,
                                        const Eigen::MatrixXd& weights) {
  constexpr Eigen::Index block = 1024;
  Eigen::MatrixXd result(values.rows(), weights.cols());
  for(Eigen::Index first = 0; first < values.rows(); first += block) {
    const Eigen::Index size = (std::min)(block, values.rows() - first);
    result.middleRows(first, size).noalias() = values.middleRows(first, size).cwiseAbs2() * weights;
  }
  return result;
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_INTERNAL_FILTERED_SQUARES_H
