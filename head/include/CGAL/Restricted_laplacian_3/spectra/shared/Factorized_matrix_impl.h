// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_SHARED_FACTORIZED_MATRIX_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_SHARED_FACTORIZED_MATRIX_IMPL_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/Single_blas_thread.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parallel_for.h>
#include <CGAL/Restricted_laplacian_3/spectra/shared/Factorized_matrix.h>
#include <CGAL/Restricted_laplacian_3/spectra/sparse_cholesky.h>

#include <cstddef>
#include <memory>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

#ifdef CGAL_RESTRICTED_LAPLACIAN_3_USE_CHOLMOD
using Available_cholesky = Cholmod_cholesky;
constexpr std::size_t dimension_for_few = 40000, dimension_for_many = 150000;
#else
using Available_cholesky = Eigen_simplicial_cholesky;
constexpr std::size_t dimension_for_few = 10000, dimension_for_many = 50000;
#endif

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Factorized_matrix::Factorized_matrix(const Sparse_matrix& a) {
  const Single_blas_thread single_thread;
  const auto factor = std::make_shared<Available_cholesky>();
#ifdef CGAL_RESTRICTED_LAPLACIAN_3_USE_CHOLMOD
  factor->order_by_amd();
#endif
  factor->compute(a);
  if(factor->info() == Eigen::Success)
    m_solve = [factor](const Eigen::MatrixXd& b) { return factor->solve(b); };
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Eigen::MatrixXd
Factorized_matrix::solve(const Eigen::MatrixXd& b, bool is_parallel) const {
  constexpr std::size_t columns_at_once = 8;
  const Single_blas_thread single_thread;
  Eigen::MatrixXd x(b.rows(), b.cols());
  parallel_for(is_parallel, 0, static_cast<std::size_t>(b.cols()), columns_at_once,
               [&](std::size_t begin, std::size_t end) {
                 const auto first = static_cast<Eigen::Index>(begin),
                            number = static_cast<Eigen::Index>(end - begin);
                 x.middleCols(first, number) = m_solve(b.middleCols(first, number));
               });
  return x;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE std::size_t
Factorized_matrix::largest_dimension(bool has_many_solutions) {
  return has_many_solutions ? dimension_for_many : dimension_for_few;
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_SHARED_FACTORIZED_MATRIX_IMPL_H
