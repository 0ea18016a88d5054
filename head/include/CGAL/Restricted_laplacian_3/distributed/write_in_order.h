// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_WRITE_IN_ORDER_H
#define CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_WRITE_IN_ORDER_H

#include <CGAL/Restricted_laplacian_3/distributed/Communicator.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>

#include <string>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Distributed
/// Writes a file of what ranks have, one after the other, all at the same time. Until it is whole,
/// the file has another name, with `.part` at its end: so whoever finds the file finds all of it.
/// What is no regular file, a pipe or a device, is written by rank 0.
/// \param communicator the ranks
/// \param file its name, on a file system that all ranks see
/// \param parts of the file, each of which is in the order of ranks: all that is in the first part
/// of any rank comes before what is in the second part; there are as many on all ranks
/// \throws Distributed_error on all ranks if the file cannot be written; then it is what it was
void write_in_order(const Communicator& communicator, const std::string& file,
                    const std::vector<std::string>& parts);

} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/distributed/write_in_order_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_DISTRIBUTED_WRITE_IN_ORDER_H
