// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_INTERNAL_PARALLEL_FOR_H
#define CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_INTERNAL_PARALLEL_FOR_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/Function_view.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>

#include <cstddef>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// Calls `body(b, e)` for the chunks \f$[b, e)\f$, of `grain` numbers each (the last one may be
/// shorter), of \f$[\mathrm{begin}, \mathrm{end})\f$: at once on several threads if `is_parallel`,
/// and if the package was compiled with TBB, else in ascending order.
///
/// The chunks are the same in both cases, and for any number of threads. So what is computed for
/// each chunk by itself, a sum for instance, is the same to the last bit.
///
/// If chunks throw, the exception of the first of them in ascending order is thrown, as without
/// threads; other chunks may have been run, also after it.
void parallel_for(bool is_parallel, std::size_t begin, std::size_t end, std::size_t grain,
                  Function_view<void(std::size_t, std::size_t)> body);

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/foundation/internal/parallel_for_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_INTERNAL_PARALLEL_FOR_H
