// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_INTERNAL_SYMMETRIC_EIGENPAIRS_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_INTERNAL_SYMMETRIC_EIGENPAIRS_IMPL_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/symmetric_eigenpairs.h>

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>

#include <Eigen/Eigenvalues>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Symmetric_eigenpairs
symmetric_eigenpairs(const Eigen::MatrixXd& a, const std::string& what) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(a);
  if(solver.info() != Eigen::Success || !solver.eigenvalues().allFinite())
    throw Numerical_error("the eigenvalues of " + what + " could not be computed");
  return {solver.eigenvalues(), solver.eigenvectors()};
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_INTERNAL_SYMMETRIC_EIGENPAIRS_IMPL_H
