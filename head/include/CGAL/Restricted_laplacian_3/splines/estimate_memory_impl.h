// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_ESTIMATE_MEMORY_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_ESTIMATE_MEMORY_IMPL_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/memory.h>
#include <CGAL/Restricted_laplacian_3/octree/Octree_3.h>
#include <CGAL/Restricted_laplacian_3/splines/estimate_memory.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

// measured: maximum of the resident memory of `solve_poisson`, less that of the surface
constexpr double unknowns_per_sheet = 3, bytes_per_sheet = 7200, bytes_per_face = 6,
                 bytes_of_patch = 180;

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Memory_estimate
memory_of_space(const Triangulated_surface_3& surface, double dimension) {
  const auto faces = static_cast<double>(surface.number_of_faces());
  Memory_estimate result;
  result.dimension = dimension;
  result.surface = 24 * static_cast<double>(surface.number_of_vertices()) +
                   (surface.is_point_set() ? 44 : 20) * faces +
                   (surface.is_smooth() ? bytes_of_patch * faces : 0);
  result.solver = bytes_per_sheet / unknowns_per_sheet * dimension + bytes_per_face * faces;
  return result;
}

/// What all depths have in common.
class Memory_model {
public:
  Memory_model(const Triangulated_surface_3& surface, double cube_scale) : m_surface(surface) {
    const double side = checked_cube_scale(cube_scale) * surface.extent();
    for(std::size_t f = 0; f < surface.number_of_faces(); ++f) {
      const Vector_3 n = surface.normal(f);
      const double area = surface.area(f) / side / side;
      m_cells += area * (std::abs(n.x()) + std::abs(n.y()) + std::abs(n.z()));
      m_area += area;
      m_root_of_area += std::sqrt(area);
    }
  }

  Memory_estimate at(int depth) const {
    double sheets = std::ldexp(m_cells, 2 * depth);
    if(m_surface.is_point_set())
      sheets = (std::min)(sheets, static_cast<double>(m_surface.number_of_faces()));
    Memory_estimate result = memory_of_space(m_surface, unknowns_per_sheet * sheets);
    result.solver = (std::max)(result.solver, memory_to_cut(depth));
    return result;
  }

private:
  /// of what lives while the surface is cut into cells, window by window
  double memory_to_cut(int depth) const {
    constexpr double bytes_of_fragment = 140;
    const auto faces = static_cast<double>(m_surface.number_of_faces());
    // more than its first one has a small triangle for each wall, and a large one for its area
    const double fragments =
        faces + 3 * std::ldexp(m_root_of_area, depth) + 1.5 * std::ldexp(m_area, 2 * depth);
    const double windows =
        std::ceil(fragments / static_cast<double>(Octree_3::default_fragments_at_once));
    return bytes_per_face * faces + bytes_of_fragment * fragments / windows;
  }

  const Triangulated_surface_3& m_surface;
  // of a cube without divisions: number of cells that it would have, not a whole one; area; sum of
  // the roots of the areas of faces
  double m_cells = 0, m_area = 0, m_root_of_area = 0;
};

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void check_memory(const Triangulated_surface_3& surface,
                                                     int depth, double cube_scale, double maximum) {
  // what no octree can have is not a matter of memory
  if(depth < 1 || depth > maximum_octree_depth)
    return;
  const Memory_model model(surface, cube_scale);
  const auto total = [&](int d) { return model.at(d).total(); };
  if(!(total(depth) > maximum))
    return;
  std::string reason = "is " + std::to_string(depth) + ", which would take about " +
                       memory_text(total(depth)) + " of memory, and " + memory_text(maximum) +
                       " are there";
  int possible = depth - 1;
  while(possible > 0 && total(possible) > maximum)
    --possible;
  if(possible > 0)
    reason +=
        "; a depth of " + std::to_string(possible) + " would take " + memory_text(total(possible));
  else
    reason += "; the surface itself takes " + memory_text(memory_of_space(surface, 0).surface);
  throw Parameter_error("depth", reason);
}

} // namespace internal

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Memory_estimate
estimate_memory(const Triangulated_surface_3& surface, int depth, double cube_scale) {
  return internal::Memory_model(surface, cube_scale).at(depth);
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_ESTIMATE_MEMORY_IMPL_H
