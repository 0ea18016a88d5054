// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_INTERNAL_NUMBER_VIEW_H
#define CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_INTERNAL_NUMBER_VIEW_H

#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// Ascending numbers: those of a list, or all from 0 to size - 1.
class Number_view {
public:
  /// all numbers below `size`
  explicit Number_view(std::size_t size) : m_list(nullptr), m_size(size) {}
  /// those of a list, which must outlive the view
  Number_view(const std::uint32_t* list, std::size_t size) : m_list(list), m_size(size) {}

  /// how many
  std::size_t size() const { return m_size; }
  /// number `i` of them
  std::size_t operator[](std::size_t i) const { return m_list ? m_list[i] : i; }

private:
  const std::uint32_t* m_list;
  std::size_t m_size;
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_INTERNAL_NUMBER_VIEW_H
