// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_SPARSE_MATRIX_H
#define CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_SPARSE_MATRIX_H

#include <Eigen/SparseCore>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Operators
/// Type of all sparse matrices. Those of operators are symmetric and stored in full, so their
/// columns are their rows. Such a matrix is moved by `swap()`: `std::move()` copies it, as those of
/// Eigen 3.4 have no move constructor.
using Sparse_matrix = Eigen::SparseMatrix<double>;

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_SPARSE_MATRIX_H
