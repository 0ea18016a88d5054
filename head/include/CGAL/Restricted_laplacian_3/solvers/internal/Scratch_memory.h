// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_INTERNAL_SCRATCH_MEMORY_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_INTERNAL_SCRATCH_MEMORY_H

#include <boost/align/aligned_alloc.hpp>

#include <cstddef>
#include <memory>
#include <new>
#include <type_traits>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// Memory for large arrays of different types one after the other, with no values at first: what
/// another array has used costs less than what the system has to provide.
class Scratch_memory {
public:
  /// \param size number of bytes
  explicit Scratch_memory(std::size_t size = 0)
    : m_memory(size > 0 ? boost::alignment::aligned_alloc(64, size) : nullptr), m_size(size) {
    if(size > 0 && !m_memory)
      throw std::bad_alloc();
  }

  std::size_t size() const { return m_size; }

  /// the memory as an array of numbers, or of aggregates of numbers
  template <class T> T* as() const {
    static_assert(std::is_trivial_v<T>);
    return static_cast<T*>(m_memory.get());
  }

private:
  struct Free {
    void operator()(void* memory) const { boost::alignment::aligned_free(memory); }
  };
  std::unique_ptr<void, Free> m_memory;
  std::size_t m_size;
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SOLVERS_INTERNAL_SCRATCH_MEMORY_H
