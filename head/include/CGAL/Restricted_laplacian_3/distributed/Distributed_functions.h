// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_DISTRIBUTED_FUNCTIONS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_DISTRIBUTED_FUNCTIONS_H

#include <CGAL/Restricted_laplacian_3/distributed/Distributed_space.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>

#include <Eigen/Core>

#include <string>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Distributed
/// Some functions of a `Distributed_space`, each with a number: eigenfunctions with their
/// eigenvalues, or a solution with 0.
struct Distributed_functions {
  /// the numbers, the same on all ranks
  Eigen::VectorXd values;
  /// one column for each function: coefficients of the elements of `Distributed_space::part()`
  Eigen::MatrixXd coefficients;
};

/// \ingroup PkgRestrictedLaplacian3Distributed
/// Writes functions to a file, from which any number of ranks can read them, by `write_in_order()`.
///
/// The file begins with lines of text that tell which space it belongs to; numbers in double
/// precision follow: the values, then function by function the coefficients of all elements.
/// \param space the space
/// \param file its name, on a file system that all ranks see
/// \param functions as many values as columns, the same number on all ranks
/// \throws Distributed_error if the file cannot be written; then it is what it was
void save_functions(const Distributed_space& space, const std::string& file,
                    const Distributed_functions& functions);

/// \ingroup PkgRestrictedLaplacian3Distributed
/// Reads what `save_functions()` has written; each rank reads the coefficients of its elements.
/// \param space the space
/// \param file its name, on a file system that all ranks see
/// \throws Distributed_error if the file cannot be read, or if its functions are those of another
/// space
Distributed_functions load_functions(const Distributed_space& space, const std::string& file);

} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/distributed/Distributed_functions_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_DISTRIBUTED_FUNCTIONS_H
