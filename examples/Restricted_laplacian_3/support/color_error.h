// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_EXAMPLES_COLOR_ERROR_H
#define RESTRICTED_LAPLACIAN_3_EXAMPLES_COLOR_ERROR_H

// How far colors of a surface are from the truth.

#include "color_map.h"
#include "program.h"

#include <CGAL/Restricted_laplacian_3/Triangulated_surface_3.h>
#include <CGAL/Restricted_laplacian_3/stitch_colors.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace examples {

struct Color_error {
  double gain = 1; // of the truth: the factor, one for all components, that fits the colors best
  double root_mean_square = 0;    // of the colors against the truth times `gain`, and over it
  double jump = 0, true_jump = 0; // mean_color_jump(), the truth times `gain`, over `gain`
  double contrast() const { return jump - true_jump; } // of seams
};

// Integrals are sums over the vertices, each with a third of the area of its faces. Root mean
// squares are over the three components. `transitions` are edges where scans meet.
inline Color_error
color_error(const RL::Triangulated_surface_3& surface, const std::vector<Color>& colors,
            const std::vector<Color>& truth,
            const std::vector<std::pair<std::uint32_t, std::uint32_t>>& transitions) {
  std::vector<double> weights(surface.number_of_vertices(), 0.);
  for(std::size_t f = 0; f < surface.number_of_faces(); ++f)
    for(const std::uint32_t v : surface.triangle(f))
      weights[v] += surface.area(f) / 3;
  double product = 0, square = 0;
  for(std::size_t v = 0; v < weights.size(); ++v)
    for(std::size_t k = 0; k < 3 && weights[v] > 0; ++k) {
      product += weights[v] * colors[v][k] * truth[v][k];
      square += weights[v] * truth[v][k] * truth[v][k];
    }
  Color_error result;
  if(square > 0 && product > 0)
    result.gain = product / square;
  double sum = 0;
  for(std::size_t v = 0; v < weights.size(); ++v)
    for(std::size_t k = 0; k < 3 && weights[v] > 0; ++k) {
      const double error = colors[v][k] / result.gain - truth[v][k];
      sum += weights[v] * error * error;
    }
  result.root_mean_square = std::sqrt(sum / (3 * surface.area()));
  result.jump = RL::mean_color_jump(transitions, colors) / result.gain;
  result.true_jump = RL::mean_color_jump(transitions, truth);
  return result;
}

} // namespace examples

#endif // RESTRICTED_LAPLACIAN_3_EXAMPLES_COLOR_ERROR_H
