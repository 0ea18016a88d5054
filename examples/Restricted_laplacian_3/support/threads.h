// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_EXAMPLES_THREADS_H
#define RESTRICTED_LAPLACIAN_3_EXAMPLES_THREADS_H

#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/info.h>
#endif

#include <algorithm>
#include <cstddef>

namespace examples {

// Bounds the number of threads as long as it exists; 0 stands for all processors.
class Thread_limit {
public:
#ifdef CGAL_LINKED_WITH_TBB
  explicit Thread_limit(int number)
    : m_number(number > 0 ? number : (std::max)(1, tbb::info::default_concurrency())),
      m_control(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(m_number)) {}
#else
  explicit Thread_limit(int) : m_number(1) {}
#endif

  int number() const { return m_number; }

private:
  int m_number;
#ifdef CGAL_LINKED_WITH_TBB
  tbb::global_control m_control;
#endif
};

} // namespace examples

#endif // RESTRICTED_LAPLACIAN_3_EXAMPLES_THREADS_H
