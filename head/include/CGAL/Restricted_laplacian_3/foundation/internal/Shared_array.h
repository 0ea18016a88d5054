// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_INTERNAL_SHARED_ARRAY_H
#define CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_INTERNAL_SHARED_ARRAY_H

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// An array that does not change any more, and is shared by its copies.
template <class T> class Shared_array {
public:
  Shared_array() = default;
  /// takes the values of a vector
  explicit Shared_array(std::vector<T>&& values)
    : m_values(std::make_shared<const std::vector<T>>(std::move(values))), m_data(m_values->data()),
      m_size(m_values->size()) {}

  std::size_t size() const { return m_size; }
  bool empty() const { return m_size == 0; }
  const T& operator[](std::size_t i) const { return m_data[i]; }
  const T* begin() const { return m_data; }
  const T* end() const { return m_data + m_size; }

private:
  std::shared_ptr<const std::vector<T>> m_values;
  // of the vector: one step less on the way to a value
  const T* m_data = nullptr;
  std::size_t m_size = 0;
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_INTERNAL_SHARED_ARRAY_H
