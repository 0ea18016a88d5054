// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_INTERNAL_PARALLEL_FOR_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_INTERNAL_PARALLEL_FOR_IMPL_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/parallel_for.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>

#include <atomic>
#include <exception>
#include <mutex>
#endif

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void
parallel_for(bool is_parallel, std::size_t begin, std::size_t end, std::size_t grain,
             Function_view<void(std::size_t, std::size_t)> body) {
  if(begin >= end)
    return;
  grain = (std::max)(grain, std::size_t(1));
  const std::size_t number_of_chunks = (end - begin - 1) / grain + 1;
  const auto run = [&](std::size_t chunk) {
    const std::size_t b = begin + chunk * grain;
    body(b, b + (std::min)(grain, end - b));
  };
#ifdef CGAL_LINKED_WITH_TBB
  if(is_parallel && number_of_chunks > 1) {
    std::atomic<std::size_t> first_failure(number_of_chunks);
    std::exception_ptr exception;
    std::mutex mutex;
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, number_of_chunks, 1),
        [&](const tbb::blocked_range<std::size_t>& chunks) {
          for(std::size_t chunk = chunks.begin(); chunk != chunks.end(); ++chunk) {
            // Those before a failure have to run: one of them may be the first to fail.
            if(chunk > first_failure)
              return;
            try {
              run(chunk);
            } catch(...) {
              const std::lock_guard<std::mutex> lock(mutex);
              if(chunk < first_failure) {
                first_failure = chunk;
                exception = std::current_exception();
              }
            }
          }
        },
        tbb::simple_partitioner());
    if(exception)
      std::rethrow_exception(exception);
    return;
  }
#else
  static_cast<void>(is_parallel);
#endif
  for(std::size_t chunk = 0; chunk < number_of_chunks; ++chunk)
    run(chunk);
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_INTERNAL_PARALLEL_FOR_IMPL_H
