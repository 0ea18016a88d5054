// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_INTERNAL_OBJECT_POOL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_INTERNAL_OBJECT_POOL_H

#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// Objects that the chunks of a parallel loop borrow one after the other: no more of them are made
/// than chunks run at the same time. So an array of the size of a problem costs time in proportion
/// to it, and not to its square, as one for each chunk would.
template <class T> class Object_pool {
public:
  /// calls `use(object)` with one that is free, or with the result of `make()`
  template <class Make, class Use> void borrow(Make&& make, Use&& use) {
    std::unique_ptr<T> object;
    {
      const std::lock_guard<std::mutex> lock(m_mutex);
      if(!m_free.empty()) {
        object = std::move(m_free.back());
        m_free.pop_back();
      }
    }
    if(!object)
      object = std::make_unique<T>(make());
    use(*object);
    const std::lock_guard<std::mutex> lock(m_mutex);
    m_free.push_back(std::move(object));
  }

private:
  std::mutex m_mutex;
  std::vector<std::unique_ptr<T>> m_free;
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_INTERNAL_OBJECT_POOL_H
