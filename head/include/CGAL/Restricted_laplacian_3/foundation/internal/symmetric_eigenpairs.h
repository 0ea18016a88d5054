// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_INTERNAL_SYMMETRIC_EIGENPAIRS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_INTERNAL_SYMMETRIC_EIGENPAIRS_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>

#include <Eigen/Core>

#include <string>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// Eigenvalues, ascending, and orthonormal vectors, a column for each.
struct Symmetric_eigenpairs {
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;
};

/// The eigenpairs of a dense symmetric matrix, whose lower triangle is read. Eigen's solver takes
/// long to compile: this is the one place.
/// \param what the matrix, for the message: "the eigenvalues of `what` could not be computed"
/// \throws Numerical_error if the iteration for them does not converge, for example because of an
/// entry that is not a number
Symmetric_eigenpairs symmetric_eigenpairs(const Eigen::MatrixXd& a, const std::string& what);

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/foundation/internal/symmetric_eigenpairs_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_INTERNAL_SYMMETRIC_EIGENPAIRS_H
