// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_GEODESICS_INTERNAL_RAY_WINDOWS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_GEODESICS_INTERNAL_RAY_WINDOWS_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/memory.h>
#include <CGAL/Restricted_laplacian_3/geodesics/internal/ray_waves.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// The windows that are on their way, by numbers; those of windows taken out are given again.
class Ray_windows {
public:
  /// \param maximum_memory in bytes
  /// \param memory_elsewhere what is taken of it already
  /// \param memory_of_window what each window takes elsewhere
  Ray_windows(double maximum_memory, std::size_t memory_elsewhere, std::size_t memory_of_window)
    : m_maximum_memory(maximum_memory), m_memory_elsewhere(memory_elsewhere),
      m_memory_of_window(sizeof(Ray_window) + sizeof(std::uint32_t) + memory_of_window) {}

  Ray_window& operator[](std::uint32_t i) { return m_windows[i]; }

  /// \return its number
  /// \throws Parameter_error if that takes more memory than permitted
  std::uint32_t add(const Ray_window& w) {
    if(m_free.empty()) {
      if(m_windows.size() == m_windows.capacity())
        grow();
      m_windows.push_back(w);
      return static_cast<std::uint32_t>(m_windows.size() - 1);
    }
    const std::uint32_t i = m_free.back();
    m_free.pop_back();
    m_windows[i] = w;
    return i;
  }

  Ray_window take(std::uint32_t i) {
    m_free.push_back(i);
    return m_windows[i];
  }

private:
  /// makes room for twice as many windows, if that is permitted
  void grow() {
    constexpr std::size_t least_room = 1024;
    const std::size_t room = (std::max)(least_room, 2 * m_windows.size());
    // windows exist twice while they are moved
    if(static_cast<double>(m_memory_elsewhere) +
           static_cast<double>(room * m_memory_of_window + m_windows.size() * sizeof(Ray_window)) >
       m_maximum_memory)
      throw Parameter_error("maximum_memory",
                            "is " + memory_text(m_maximum_memory) +
                                ": the windows of rays would take more than that");
    m_windows.reserve(room);
  }

  double m_maximum_memory;
  std::size_t m_memory_elsewhere, m_memory_of_window;
  std::vector<Ray_window> m_windows;
  std::vector<std::uint32_t> m_free;
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_GEODESICS_INTERNAL_RAY_WINDOWS_H
