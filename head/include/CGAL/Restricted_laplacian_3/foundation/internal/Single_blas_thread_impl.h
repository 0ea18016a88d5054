// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_INTERNAL_SINGLE_BLAS_THREAD_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_INTERNAL_SINGLE_BLAS_THREAD_IMPL_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/Single_blas_thread.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/operating_system.h>

#include <mutex>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// How the number of threads of the BLAS library is read and set. Which library that is, is decided
/// when a program is loaded, on Debian by an alternative: so these are looked up by their names.
struct Blas_library {
  int (*number)() = nullptr;
  void (*set_number)(int) = nullptr;

  Blas_library() {
    constexpr const char* names[][2] = {
        {"openblas_get_num_threads", "openblas_set_num_threads"},
        // that of Python's wheels
        {"scipy_openblas_get_num_threads", "scipy_openblas_set_num_threads"},
        {"MKL_Get_Max_Threads", "MKL_Set_Num_Threads"}};
    for(const auto& [get, set] : names) {
      void *const getter = loaded_function(get), *const setter = loaded_function(set);
      if(getter && setter) {
        number = reinterpret_cast<int (*)()>(getter);
        set_number = reinterpret_cast<void (*)(int)>(setter);
        return;
      }
    }
  }

  static const Blas_library& of_process() {
    static const Blas_library library;
    return library;
  }
};

CGAL_RESTRICTED_LAPLACIAN_3_INLINE int number_of_blas_threads() {
  const Blas_library& library = Blas_library::of_process();
  return library.number ? library.number() : 0;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void set_number_of_blas_threads(int number) {
  const Blas_library& library = Blas_library::of_process();
  if(library.set_number)
    library.set_number(number);
}

/// the `Single_blas_thread`s that exist
struct Single_blas_threads {
  std::mutex mutex;
  int number = 0;
  int number_of_threads_before = 0;

  static Single_blas_threads& of_process() {
    static Single_blas_threads threads;
    return threads;
  }
};

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Single_blas_thread::Single_blas_thread() {
  Single_blas_threads& all = Single_blas_threads::of_process();
  const std::lock_guard<std::mutex> lock(all.mutex);
  if(all.number++ > 0)
    return;
  all.number_of_threads_before = number_of_blas_threads();
  set_number_of_blas_threads(1);
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Single_blas_thread::~Single_blas_thread() {
  Single_blas_threads& all = Single_blas_threads::of_process();
  const std::lock_guard<std::mutex> lock(all.mutex);
  if(--all.number == 0)
    set_number_of_blas_threads(all.number_of_threads_before);
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_INTERNAL_SINGLE_BLAS_THREAD_IMPL_H
