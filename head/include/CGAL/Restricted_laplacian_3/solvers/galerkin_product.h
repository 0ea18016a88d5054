// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_GALERKIN_PRODUCT_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_GALERKIN_PRODUCT_H

#include <CGAL/Restricted_laplacian_3/foundation/Sparse_matrix.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Dev
/// The coarse operator \f$P^T A P\f$ of a symmetric matrix \f$A\f$, column by column: with
/// \f$p = P e_j\f$, the sparse vector \f$A p\f$ is accumulated, then \f$P^T (A p)\f$. No product of
/// two matrices is stored. The rows of a column are sorted.
///
/// Takes time proportional to \f$\sum_j\f$ (entries of \f$A\f$ in the columns that column \f$j\f$
/// of \f$P\f$ meets), and the size of the result as memory, twice for a moment.
/// \throws Parameter_error if the sizes do not fit, or if the product has more than
/// \f$2^{31} - 1\f$ entries
Sparse_matrix galerkin_product(const Sparse_matrix& a, const Sparse_matrix& p,
                               bool is_parallel = false);

} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/solvers/galerkin_product_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_GALERKIN_PRODUCT_H
