// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_PROGRAMS_COLOR_ERROR_H
#define RESTRICTED_LAPLACIAN_3_PROGRAMS_COLOR_ERROR_H

// How far colors of a surface are from the truth.

#include "color_map.h"
#include "program.h"

#include <CGAL/Restricted_laplacian_3/stitch_colors.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace programs {

struct Color_error {
  double gain = 1; // the factor of the truth, one for all components, that fits the colors best
  double root_mean_square = 0;    // of the colors over `gain` against the truth
  double jump = 0, true_jump = 0; // mean_color_jump() of the colors over `gain`, and of the truth

  double seam_contrast() const { return jump - true_jump; }
};

// Integrals are sums over the vertices that have a scan, each with a third of the area of its
// faces. Root mean squares are over the three components. Jumps are at edges where scans meet.
inline Color_error color_error(const RL::Triangulated_surface_3& surface,
                               const RL::Vertex_colors& found, const std::vector<Color>& truth) {
  std::vector<double> weights(surface.number_of_vertices(), 0.);
  for(std::size_t f = 0; f < surface.number_of_faces(); ++f)
    for(const std::uint32_t v : surface.triangle(f))
      if(found.scans[v] != RL::no_scan)
        weights[v] += surface.area(f) / 3;
  double product = 0, square = 0, area = 0;
  for(std::size_t v = 0; v < weights.size(); ++v) {
    area += weights[v];
    for(std::size_t k = 0; k < 3 && weights[v] > 0; ++k) {
      product += weights[v] * found.colors[v][k] * truth[v][k];
      square += weights[v] * truth[v][k] * truth[v][k];
    }
  }
  Color_error result;
  if(square > 0 && product > 0)
    result.gain = product / square;
  double sum = 0;
  for(std::size_t v = 0; v < weights.size(); ++v)
    for(std::size_t k = 0; k < 3 && weights[v] > 0; ++k) {
      const double error = found.colors[v][k] / result.gain - truth[v][k];
      sum += weights[v] * error * error;
    }
  result.root_mean_square = std::sqrt(sum / (3 * area));
  const auto transitions = RL::scan_transitions(surface, found.scans);
  result.jump = RL::mean_color_jump(transitions, found.colors) / result.gain;
  result.true_jump = RL::mean_color_jump(transitions, truth);
  return result;
}

} // namespace programs

#endif // RESTRICTED_LAPLACIAN_3_PROGRAMS_COLOR_ERROR_H
