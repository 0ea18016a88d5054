// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_SURFACE_WINDOWS_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_SURFACE_WINDOWS_IMPL_H

#include <CGAL/Restricted_laplacian_3/octree/Surface_windows.h>
#include <CGAL/Restricted_laplacian_3/octree/shared/Faces_in_coarse_cells.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
CGAL_RESTRICTED_LAPLACIAN_3_INLINE
Surface_windows::Surface_windows(const Triangulated_surface_3& surface,
                                 const internal::Grid_vertices& vertices,
                                 std::size_t number_of_fragments, double margin, bool is_parallel)
  : m_level((std::min)(vertices.depth(), largest_level)), m_shift(3 * (vertices.depth() - m_level)),
    m_number_of_faces(surface.number_of_faces()),
    m_first_cells({0, std::uint64_t(1) << 3 * m_level}) {
  CGAL_precondition(number_of_fragments > 0);
  const internal::Faces_in_coarse_cells faces(surface, vertices, m_level, margin);
  std::vector<double> of_chunks(faces.number_of_chunks(), 0.);
  faces.for_each_chunk(is_parallel, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
    for(std::size_t face = begin; face < end; ++face)
      of_chunks[chunk] += faces.estimated_number_of_fragments(face);
  });
  for(double of_chunk : of_chunks)
    m_estimated_number_of_fragments += of_chunk;
  const double number_of_windows =
      std::ceil(m_estimated_number_of_fragments / static_cast<double>(number_of_fragments));
  if(number_of_windows > 1) {
    divide(faces, number_of_windows, is_parallel);
    distribute(faces, is_parallel);
  }
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void
Surface_windows::divide(const internal::Faces_in_coarse_cells& faces, double number_of_windows,
                        bool is_parallel) {
  // The fragments of a face are shared by its cells. Whole numbers have the same sum in any order.
  const std::uint64_t number_of_cells = m_first_cells.back();
  std::vector<std::atomic<std::uint64_t>> weights(number_of_cells);
  for(auto& weight : weights)
    weight.store(0, std::memory_order_relaxed);
  faces.for_each_chunk(is_parallel, [&](std::size_t, std::size_t begin, std::size_t end) {
    for(std::size_t face = begin; face < end; ++face) {
      double count = 0;
      faces.for_each_cell(face, [&](std::uint64_t) { ++count; });
      const auto weight = static_cast<std::uint64_t>(
          std::ceil(faces.estimated_number_of_fragments(face) / (std::max)(count, 1.)));
      faces.for_each_cell(face, [&](std::uint64_t cell) {
        weights[cell].fetch_add(weight, std::memory_order_relaxed);
      });
    }
  });
  double total = 0, sum = 0;
  for(const auto& weight : weights)
    total += static_cast<double>(weight);
  // A cell belongs to the equal part of the whole in which its middle lies.
  m_first_cells.pop_back();
  double last_part = 0;
  for(std::uint64_t cell = 0; cell < number_of_cells; ++cell) {
    const auto weight = static_cast<double>(weights[cell]);
    const double part = (std::min)(std::floor((sum + weight / 2) / total * number_of_windows),
                                   number_of_windows - 1);
    if(part > last_part && sum > 0)
      m_first_cells.push_back(cell);
    last_part = part;
    sum += weight;
  }
  m_first_cells.push_back(number_of_cells);
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void
Surface_windows::distribute(const internal::Faces_in_coarse_cells& faces, bool is_parallel) {
  const auto for_each_window = [&](std::size_t face, std::vector<std::size_t>& windows,
                                   const auto& visit) {
    windows.clear();
    faces.for_each_cell(face, [&](std::uint64_t cell) {
      const auto after = std::upper_bound(m_first_cells.begin(), m_first_cells.end(), cell);
      windows.push_back(static_cast<std::size_t>(after - m_first_cells.begin()) - 1);
    });
    std::sort(windows.begin(), windows.end());
    windows.erase(std::unique(windows.begin(), windows.end()), windows.end());
    for(std::size_t window : windows)
      visit(window);
  };
  // how many faces of each chunk are in each window; then where they begin
  std::vector<std::vector<std::size_t>> places(faces.number_of_chunks());
  faces.for_each_chunk(is_parallel, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
    places[chunk].assign(size(), 0);
    std::vector<std::size_t> windows;
    for(std::size_t face = begin; face < end; ++face)
      for_each_window(face, windows, [&](std::size_t window) { ++places[chunk][window]; });
  });
  std::size_t place = 0;
  for(std::size_t window = 0; window < size(); ++window) {
    m_first_faces.push_back(place);
    for(auto& of_chunk : places) {
      const std::size_t count = of_chunk[window];
      of_chunk[window] = place;
      place += count;
    }
  }
  m_first_faces.push_back(place);
  m_faces.resize(place);
  faces.for_each_chunk(is_parallel, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
    std::vector<std::size_t> windows;
    for(std::size_t face = begin; face < end; ++face)
      for_each_window(face, windows, [&](std::size_t window) {
        m_faces[places[chunk][window]++] = static_cast<std::uint32_t>(face);
      });
  });
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_OCTREE_SURFACE_WINDOWS_IMPL_H
