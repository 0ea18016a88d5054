// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_INTERNAL_EXPLAIN_OUT_OF_MEMORY_H
#define CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_INTERNAL_EXPLAIN_OUT_OF_MEMORY_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>

#include <new>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// Does a step of the work, and names it if there is not enough memory for it.
/// \param message a literal
/// \return what `step` returns
/// \throws Out_of_memory with the message, in place of a `std::bad_alloc` that names no step
template <class Step> decltype(auto) explain_out_of_memory(const char* message, Step&& step) {
  try {
    return step();
  } catch(const Out_of_memory&) {
    throw;
  } catch(const std::bad_alloc&) {
    throw Out_of_memory(message);
  }
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_INTERNAL_EXPLAIN_OUT_OF_MEMORY_H
