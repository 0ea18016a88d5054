// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_MONTE_CARLO_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_MONTE_CARLO_IMPL_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Number_lists.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parallel_for.h>
#include <CGAL/Restricted_laplacian_3/integration/Monte_carlo.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

namespace internal {

/// Samples of the surface that are uniform by area; those of a smooth surface are on its pieces,
/// over which the area of the patches hardly varies.
inline std::vector<Surface_location> sample_patches(const Octree_3& octree, std::size_t number,
                                                    std::uint64_t seed, Sampling sampling) {
  std::vector<Surface_location> samples = sample_surface(octree.pieces(), number, seed, sampling);
  if(octree.division())
    for(Surface_location& location : samples)
      location = octree.division()->location(location.face, location.barycentric);
  return samples;
}

} // namespace internal

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Monte_carlo::Monte_carlo(const Octree_3& octree,
                                                            std::size_t number_of_samples,
                                                            std::uint64_t seed, Sampling sampling)
  : Monte_carlo(octree, internal::sample_patches(octree, number_of_samples, seed, sampling)) {}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE
Monte_carlo::Monte_carlo(const Octree_3& octree, const std::vector<Surface_location>& samples)
  : m_octree(&octree) {
  const int depth = m_octree->depth();
  const double h = m_octree->cell_width(depth);
  m_weight = m_octree->surface().area() / static_cast<double>(samples.size()) / (h * h);
  const std::size_t number_of_sheets = m_octree->number_of_sheets(depth);

  std::vector<std::size_t> sheet_of_sample(samples.size());
  std::vector<std::array<double, 3>> positions(samples.size());
  internal::parallel_for(
      octree.is_parallel(), 0, samples.size(), 1 << 12, [&](std::size_t begin, std::size_t end) {
        for(std::size_t k = begin; k < end; ++k) {
          std::tie(sheet_of_sample[k], positions[k]) = octree.locate(depth, samples[k]);
          if(sheet_of_sample[k] == number_of_sheets)
            throw Location_error("a sample is not on the surface");
        }
      });
  internal::group_by_key(
      number_of_sheets, samples.size(), [&](std::size_t k) { return sheet_of_sample[k]; },
      [&](std::size_t k) -> Sample {
        return {positions[k], samples[k]};
      },
      m_first, m_samples);
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void Monte_carlo::add_nodes(std::size_t sheet, int /*degree*/,
                                                               Integration_nodes& nodes) const {
  for(std::size_t k = m_first[sheet]; k < m_first[sheet + 1]; ++k)
    nodes.add(m_octree->surface().surface_point(m_samples[k].location), m_samples[k].position,
              m_weight);
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_MONTE_CARLO_IMPL_H
