// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_SPLINE_SPACE_3_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_SPLINE_SPACE_3_IMPL_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/explain_out_of_memory.h>
#include <CGAL/Restricted_laplacian_3/foundation/memory.h>
#include <CGAL/Restricted_laplacian_3/integration/cubature.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>
#include <CGAL/Restricted_laplacian_3/splines/estimate_memory.h>
#include <CGAL/Restricted_laplacian_3/splines/shared/Element_numbering.h>
#include <CGAL/Restricted_laplacian_3/splines/shared/default_depth.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

CGAL_RESTRICTED_LAPLACIAN_3_INLINE int default_depth(const Triangulated_surface_3& surface,
                                                     double cube_scale) {
  const double side = internal::checked_cube_scale(cube_scale) * surface.extent();
  if(surface.is_point_set())
    return internal::depth_of_points(internal::cells_of_points(surface, side),
                                     surface.number_of_vertices());
  return internal::depth_of_edges(internal::sum_of_edges(surface) / side,
                                  surface.number_of_faces());
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE
Spline_space_3::Spline_space_3(Triangulated_surface_3 surface, const Options& options)
  : m_options(checked(surface, options)),
    m_octree(std::make_shared<const Octree_3>(make_octree(std::move(surface), m_options))),
    m_integration(default_integration(*m_octree)), m_with_material(m_integration) {
  set_integration(m_integration);
  internal::explain_out_of_memory("not enough memory for the elements of the space", [&] {
    std::vector<internal::Level_elements> levels;
    for(int level = 0; level <= depth(); ++level)
      levels.push_back(number_elements(m_octree->level_data(level)));
    m_levels = std::make_shared<const std::vector<internal::Level_elements>>(std::move(levels));
  });
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE
Spline_space_3::Spline_space_3(const Options& options, Octree_3&& octree,
                               std::vector<internal::Level_elements>&& levels)
  : m_options(options), m_octree(std::make_shared<const Octree_3>(std::move(octree))),
    m_levels(std::make_shared<const std::vector<internal::Level_elements>>(std::move(levels))),
    m_integration(default_integration(*m_octree)), m_with_material(m_integration) {
  set_integration(m_integration);
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE internal::Level_elements
Spline_space_3::number_elements(const internal::Octree_level& level) const {
  return internal::Element_numbering(level, is_split(), is_paper_space(), m_options.is_parallel)();
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE int
Spline_space_3::checked_level(std::optional<int> level) const {
  const int l = level.value_or(depth());
  if(l < 0 || l > depth())
    throw Parameter_error("level", "is " + std::to_string(l) + ", but must be in 0 .. " +
                                       std::to_string(depth()));
  return l;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Octree_3
Spline_space_3::make_octree(Triangulated_surface_3&& surface, const Options& o) {
  internal::check_memory(surface, *o.depth, *o.cube_scale, *o.maximum_memory);
  const bool is_split = splits(surface, o);
  return internal::explain_out_of_memory("not enough memory for the octree", [&] {
    return Octree_3(std::move(surface), *o.depth, *o.cube_scale, is_split,
                    o.joining_tolerance.value_or(-1), o.is_parallel);
  });
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Spline_space_3::Options
Spline_space_3::checked(const Triangulated_surface_3& surface, Options options) {
  constexpr double default_cube_scale_of_paper = 1.2;
  if(!options.cube_scale)
    options.cube_scale = options.paper ? default_cube_scale_of_paper : options.default_cube_scale;
  if(!options.depth)
    options.depth = default_depth(surface, *options.cube_scale);
  if(!options.maximum_memory)
    options.maximum_memory = memory_of_machine();
  if(!(*options.maximum_memory > 0))
    throw Parameter_error("maximum_memory", "is " + std::to_string(*options.maximum_memory) +
                                                ", but must be a positive number");
  options.split = options.split && !options.paper;
  options.split_point_set = options.split_point_set && !options.paper;
  const double tolerance = options.joining_tolerance.value_or(0);
  if(!(tolerance >= 0 && std::isfinite(tolerance)))
    throw Parameter_error("joining_tolerance",
                          "is " + std::to_string(tolerance) +
                              ", but must be a finite number that is not negative");
  return options;
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_SPLINE_SPACE_3_IMPL_H
