// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_SMALLEST_EIGENPAIRS_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_SMALLEST_EIGENPAIRS_IMPL_H

#include <CGAL/Restricted_laplacian_3/spectra/smallest_eigenpairs.h>

#if __has_include(<Spectra/SymEigsSolver.h>)
#include <CGAL/Restricted_laplacian_3/spectra/shift_invert_eigenpairs.h>
#include <CGAL/Restricted_laplacian_3/spectra/sparse_cholesky.h>
#else
#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/spectra/internal/eigenproblem.h>
#endif

namespace CGAL {
namespace Restricted_laplacian_3 {

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Eigenpairs smallest_eigenpairs(
    const Sparse_matrix& s, const Sparse_matrix& m, int k, const Eigenpairs_options& options) {
#if !__has_include(<Spectra/SymEigsSolver.h>)
  static_cast<void>(options);
  Sparse_matrix compressed_s = s, compressed_m = m;
  compressed_s.makeCompressed();
  compressed_m.makeCompressed();
  internal::check_eigenproblem(compressed_s, compressed_m, k);
  Eigenpairs pairs;
  if(!internal::is_solved_densely(compressed_s, compressed_m, k, pairs))
    throw Numerical_error("eigenpairs of matrices of this size need Spectra, without which this "
                          "was compiled");
  return pairs;
#elif defined(CGAL_RESTRICTED_LAPLACIAN_3_USE_CHOLMOD)
  return shift_invert_eigenpairs<Cholmod_cholesky>(s, m, k, options);
#else
  return shift_invert_eigenpairs<Eigen_simplicial_cholesky>(s, m, k, options);
#endif
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SPECTRA_SMALLEST_EIGENPAIRS_IMPL_H
