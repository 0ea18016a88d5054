// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_TEST_MATRICES_H
#define RESTRICTED_LAPLACIAN_3_TEST_MATRICES_H

#include <CGAL/Restricted_laplacian_3/assembly/assemble.h>

/// largest difference of the entries, relative to the largest entry of `b`
inline double relative_difference(const CGAL::Restricted_laplacian_3::Sparse_matrix& a,
                                  const CGAL::Restricted_laplacian_3::Sparse_matrix& b) {
  return CGAL::Restricted_laplacian_3::Sparse_matrix(a - b).coeffs().abs().maxCoeff() /
         b.coeffs().abs().maxCoeff();
}

#endif // RESTRICTED_LAPLACIAN_3_TEST_MATRICES_H
