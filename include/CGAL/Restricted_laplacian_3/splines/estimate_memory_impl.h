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

/// What all depths have in common.
class Memory_model {
public:
  Memory_model(const Triangulated_surface_3& surface, double cube_scale)
    : m_is_point_set(surface.is_point_set()),
      m_faces(static_cast<double>(surface.number_of_faces())),
      m_surface(24 * static_cast<double>(surface.number_of_vertices()) +
                (surface.is_point_set() ? 44 : 20) * m_faces +
                (surface.is_smooth() ? bytes_of_patch * m_faces : 0)) {
    const double side = checked_cube_scale(cube_scale) * surface.extent();
    for(std::size_t f = 0; f < surface.number_of_faces(); ++f) {
      const Vector_3 n = surface.normal(f);
      m_cells +=
          surface.area(f) / side / side * (std::abs(n.x()) + std::abs(n.y()) + std::abs(n.z()));
    }
  }

  Memory_estimate at(int depth) const {
    double sheets = std::ldexp(m_cells, 2 * depth);
    if(m_is_point_set)
      sheets = (std::min)(sheets, m_faces);
    Memory_estimate result;
    result.dimension = unknowns_per_sheet * sheets;
    result.surface = m_surface;
    result.solver = bytes_per_sheet * sheets + bytes_per_face * m_faces;
    return result;
  }

private:
  // measured: maximum of the resident memory of `solve_poisson`, less that of the surface
  static constexpr double unknowns_per_sheet = 3, bytes_per_sheet = 7200, bytes_per_face = 6,
                          bytes_of_patch = 180;

  bool m_is_point_set;
  double m_faces, m_surface;
  double m_cells = 0; // that a cube without divisions would have, not a whole number
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
    reason += "; the surface itself takes " + memory_text(model.at(1).surface);
  throw Parameter_error("octree_depth", reason);
}

} // namespace internal

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Memory_estimate
estimate_memory(const Triangulated_surface_3& surface, int depth, double cube_scale) {
  return internal::Memory_model(surface, cube_scale).at(depth);
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_ESTIMATE_MEMORY_IMPL_H
