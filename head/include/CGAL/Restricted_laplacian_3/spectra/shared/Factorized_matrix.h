// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_SHARED_FACTORIZED_MATRIX_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_SHARED_FACTORIZED_MATRIX_H

#include <CGAL/Restricted_laplacian_3/foundation/Sparse_matrix.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>

#include <Eigen/Core>

#include <cstddef>
#include <functional>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// A sparse symmetric positive definite matrix that is factorized once, by CHOLMOD where it is
/// there, and solved with often. Copies share it.
class Factorized_matrix {
public:
  /// \param a all of its entries are stored
  explicit Factorized_matrix(const Sparse_matrix& a);

  /// false if the matrix is not positive definite, up to rounding: there are no solutions then
  explicit operator bool() const { return static_cast<bool>(m_solve); }
  /// \f$A^{-1} b\f$, for each column; the same with and without threads
  Eigen::MatrixXd solve(const Eigen::MatrixXd& b, bool is_parallel) const;

  /// Up to which dimension a factor pays, of matrices of spline spaces: it takes a time that grows
  /// by the power 1.5, where multigrid takes one in proportion for each solution.
  /// \param has_many_solutions more than about a dozen
  static std::size_t largest_dimension(bool has_many_solutions);

private:
  std::function<Eigen::MatrixXd(const Eigen::MatrixXd&)> m_solve;
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/spectra/shared/Factorized_matrix_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_SHARED_FACTORIZED_MATRIX_H
