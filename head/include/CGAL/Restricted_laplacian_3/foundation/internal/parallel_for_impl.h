// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_INTERNAL_PARALLEL_FOR_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_INTERNAL_PARALLEL_FOR_IMPL_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/parallel_for.h>

// ThreadSanitizer does not see into TBB's library, which is not compiled for it, and takes each
// task that is handed on for a data race: there, threads of the standard library stand in.
#if defined(__SANITIZE_THREAD__)
#define CGAL_RESTRICTED_LAPLACIAN_3_STANDARD_THREADS
#elif defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define CGAL_RESTRICTED_LAPLACIAN_3_STANDARD_THREADS
#endif
#endif

#ifdef CGAL_LINKED_WITH_TBB
#include <atomic>
#include <exception>
#include <mutex>
#ifdef CGAL_RESTRICTED_LAPLACIAN_3_STANDARD_THREADS
#include <tbb/global_control.h>

#include <thread>
#include <vector>
#else
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#endif
#endif

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

#ifdef CGAL_LINKED_WITH_TBB
/// Calls a function for 0 .. n - 1, each of which is on the first thread that has time for it.
template <class Function> void on_all_threads(std::size_t n, const Function& function) {
#ifdef CGAL_RESTRICTED_LAPLACIAN_3_STANDARD_THREADS
  std::atomic<std::size_t> next(0);
  const auto work = [&] {
    for(std::size_t i = next++; i < n; i = next++)
      function(i);
  };
  std::vector<std::thread> others(
      tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism) - 1);
  for(std::thread& thread : others)
    thread = std::thread(work);
  work();
  for(std::thread& thread : others)
    thread.join();
#else
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, n, 1),
      [&](const tbb::blocked_range<std::size_t>& range) {
        for(std::size_t i = range.begin(); i != range.end(); ++i)
          function(i);
      },
      tbb::simple_partitioner());
#endif
}
#endif

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
    on_all_threads(number_of_chunks, [&](std::size_t chunk) {
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
    });
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

#undef CGAL_RESTRICTED_LAPLACIAN_3_STANDARD_THREADS

#endif // CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_INTERNAL_PARALLEL_FOR_IMPL_H
