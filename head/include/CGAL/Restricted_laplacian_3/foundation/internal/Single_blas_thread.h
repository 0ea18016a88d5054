// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_INTERNAL_SINGLE_BLAS_THREAD_H
#define CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_INTERNAL_SINGLE_BLAS_THREAD_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// As long as one exists, the BLAS library that the process has loaded uses the thread only that
/// calls it, if it is OpenBLAS or MKL; others, as BLIS, have variables of the environment only.
///
/// Threads of a BLAS library wait for each other by spinning, and a solve with a factor makes
/// thousands of calls: beside other processes each may take as long as the scheduler lets a thread
/// wait. Besides, sums depend on the number of threads in their last digits.
///
/// The number of threads belongs to the process. The last one of those that exist restores what was
/// set before the first, which may be on any thread.
class Single_blas_thread {
public:
  Single_blas_thread();
  ~Single_blas_thread();
  Single_blas_thread(const Single_blas_thread&) = delete;
  Single_blas_thread& operator=(const Single_blas_thread&) = delete;
};

/// number of threads of the BLAS library, 0 if that is not known
int number_of_blas_threads();
/// sets it, if that is possible
void set_number_of_blas_threads(int number);

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/foundation/internal/Single_blas_thread_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_INTERNAL_SINGLE_BLAS_THREAD_H
