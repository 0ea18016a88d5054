// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_EXAMPLES_COLOR_MAP_H
#define RESTRICTED_LAPLACIAN_3_EXAMPLES_COLOR_MAP_H

// Colors for numbers. Both maps are piecewise linear in the color space Oklab, in which equal
// distances look equally large: Bjorn Ottosson, "A perceptual color space for image processing",
// 2020, https://bottosson.github.io/posts/oklab/ (public domain).

#include "program.h"

#include <CGAL/Restricted_laplacian_3/textures/srgb.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace examples {

// Red, green and blue in [0, 1], in linear light: such colors may be averaged.
using Color = RL::Rgb_color;

// lightness, green to red, blue to yellow
using Oklab = std::array<double, 3>;

inline Color oklab_to_linear(const Oklab& lab) {
  const auto cube = [](double x) { return x * x * x; };
  const double l = cube(lab[0] + 0.3963377774 * lab[1] + 0.2158037573 * lab[2]);
  const double m = cube(lab[0] - 0.1055613458 * lab[1] - 0.0638541728 * lab[2]);
  const double s = cube(lab[0] - 0.0894841775 * lab[1] - 1.2914855480 * lab[2]);
  const Color color = {4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
                       -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
                       -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s};
  return {std::clamp(color[0], 0., 1.), std::clamp(color[1], 0., 1.), std::clamp(color[2], 0., 1.)};
}

// the sRGB byte of one component in linear light
inline std::uint8_t srgb_byte(double x) {
  return static_cast<std::uint8_t>(std::lround(255 * std::clamp(RL::linear_to_srgb(x), 0., 1.)));
}

// the color at `t` in [0, 1] between evenly spaced `anchors`
template <std::size_t n> Color interpolate_colors(const std::array<Oklab, n>& anchors, double t) {
  const double x = std::clamp(t, 0., 1.) * (n - 1);
  const std::size_t i = std::min(static_cast<std::size_t>(x), n - 2);
  Oklab lab;
  for(std::size_t k = 0; k < 3; ++k)
    lab[k] = anchors[i][k] + (x - i) * (anchors[i + 1][k] - anchors[i][k]);
  return oklab_to_linear(lab);
}

// Blue, white, red: t = 1/2 is neutral. Lightness is symmetric and changes linearly.
inline Color diverging_color(double t) {
  constexpr std::array<Oklab, 5> anchors = {{{0.42, -0.03, -0.16},
                                             {0.69, -0.05, -0.11},
                                             {0.96, 0, 0},
                                             {0.69, 0.13, 0.08},
                                             {0.42, 0.15, 0.07}}};
  return interpolate_colors(anchors, t);
}

// Dark violet, blue, green, yellow: lightness grows linearly.
inline Color sequential_color(double t) {
  constexpr std::array<Oklab, 5> anchors = {{{0.28, 0.06, -0.11},
                                             {0.445, -0.02, -0.11},
                                             {0.61, -0.09, -0.02},
                                             {0.775, -0.14, 0.11},
                                             {0.94, -0.04, 0.18}}};
  return interpolate_colors(anchors, t);
}

// The range of a set of values: of those that are finite.
struct Value_range {
  double low = 0, high = 0;

  template <typename Range> explicit Value_range(const Range& values) {
    bool is_first = true;
    for(const double x : values) {
      if(!std::isfinite(x))
        continue;
      low = is_first ? x : std::min(low, x);
      high = is_first ? x : std::max(high, x);
      is_first = false;
    }
  }
  double largest_magnitude() const { return std::max(std::abs(low), std::abs(high)); }
};

// The color of every value: diverging and centred at zero if there are values of both signs,
// sequential from the smallest to the largest value otherwise, grey where the value is not finite.
template <typename Range> std::vector<Color> value_colors(const Range& values) {
  // differences this small, relative to the values, are rounding: paint a constant evenly
  constexpr double constant_tolerance = 1e-9;
  const Value_range range(values);
  const double largest = range.largest_magnitude();
  const double width = std::max(range.high - range.low, constant_tolerance * largest);
  std::vector<Color> colors;
  for(const double x : values) {
    if(!std::isfinite(x))
      colors.push_back({0.5, 0.5, 0.5});
    else if(largest == 0)
      colors.push_back(diverging_color(0.5));
    else if(range.low < 0 && range.high > 0)
      colors.push_back(diverging_color(0.5 + 0.5 * x / largest));
    else
      colors.push_back(sequential_color((x - range.low) / width));
  }
  return colors;
}

// Diverging colors, white for 0, that are full at the magnitude that a fraction of the values is
// below: curvatures have a few values that are much larger than all others. Gray for NaN.
inline std::vector<Color> clipped_colors(const std::vector<double>& values, double fraction) {
  std::vector<double> magnitudes;
  for(const double x : values)
    if(std::isfinite(x))
      magnitudes.push_back(std::abs(x));
  double largest = 0;
  if(!magnitudes.empty()) {
    const auto nth =
        magnitudes.begin() +
        static_cast<std::ptrdiff_t>(fraction * static_cast<double>(magnitudes.size() - 1));
    std::nth_element(magnitudes.begin(), nth, magnitudes.end());
    largest = *nth;
  }
  std::vector<Color> colors;
  for(const double x : values)
    if(!std::isfinite(x))
      colors.push_back({0.5, 0.5, 0.5});
    else
      colors.push_back(diverging_color(largest > 0 ? 0.5 + 0.5 * x / largest : 0.5));
  return colors;
}

} // namespace examples

#endif // RESTRICTED_LAPLACIAN_3_EXAMPLES_COLOR_MAP_H
