// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_PROGRAMS_COLOR_PATTERN_H
#define RESTRICTED_LAPLACIAN_3_PROGRAMS_COLOR_PATTERN_H

// Colors for meshes that have none.

#include "color_map.h"
#include "program.h"

#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace programs {

// Waves of several lengths, in units of the longest side of the mesh, with soft stripes.
inline std::vector<Color> color_pattern(const RL::Triangulated_surface_3& surface) {
  std::vector<Color> colors;
  for(std::size_t v = 0; v < surface.number_of_vertices(); ++v) {
    const RL::Vector_3 p = 2 * CGAL_PI * (surface.point(v) - surface.center()) / surface.extent();
    const double slow = std::sin(1.3 * p.x() + 0.7 * std::sin(2.1 * p.y()) + 0.5 * p.z()),
                 stripes = std::tanh(3 * std::sin(5 * p.y() + 1.5 * std::sin(3 * p.x() + p.z()))),
                 fine = std::sin(9 * p.x()) * std::sin(9 * p.y()) * std::sin(9 * p.z());
    const auto level = [](double x) { return std::clamp(x, 0.05, 0.8); };
    colors.push_back({level(0.45 + 0.15 * slow + 0.18 * stripes + 0.08 * fine),
                      level(0.4 - 0.12 * slow + 0.15 * stripes + 0.08 * fine),
                      level(0.35 + 0.05 * slow - 0.2 * stripes + 0.08 * fine)});
  }
  return colors;
}

} // namespace programs

#endif // RESTRICTED_LAPLACIAN_3_PROGRAMS_COLOR_PATTERN_H
