// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_PROGRAMS_COLOR_MAP_H
#define RESTRICTED_LAPLACIAN_3_PROGRAMS_COLOR_MAP_H

// Colors for numbers.

#include "program.h"

#include <CGAL/Restricted_laplacian_3/textures/srgb.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace programs {

// Red, green and blue from 0 to 1, as files hold them: sRGB, not linear light.
using Color = RL::Rgb_color;

// Colors at evenly spaced numbers from 0 to 1, in bytes; they are linear between them. Lightness is
// about linear in both maps: equal differences look equally large.
using Color_map = std::array<std::array<int, 3>, 9>;

// blue, white, red
constexpr Color_map diverging_colors = {{{3, 70, 163},
                                         {45, 116, 195},
                                         {85, 162, 225},
                                         {166, 202, 235},
                                         {242, 242, 242},
                                         {243, 180, 167},
                                         {234, 115, 93},
                                         {190, 68, 58},
                                         {146, 8, 23}}};
// dark violet, blue, green, yellow
constexpr Color_map sequential_colors = {{{51, 16, 92},
                                          {53, 51, 118},
                                          {44, 82, 145},
                                          {44, 116, 147},
                                          {44, 148, 146},
                                          {76, 179, 127},
                                          {108, 209, 97},
                                          {190, 225, 83},
                                          {255, 239, 56}}};

// the color of `t`; gray if it is not a number
inline Color color_at(const Color_map& map, double t) {
  if(!std::isfinite(t))
    return {0.735, 0.735, 0.735};
  const double x = std::clamp(t, 0., 1.) * static_cast<double>(map.size() - 1);
  const std::size_t i = std::min(static_cast<std::size_t>(x), map.size() - 2);
  Color color;
  for(std::size_t k = 0; k < 3; ++k)
    color[k] = (map[i][k] + (x - static_cast<double>(i)) * (map[i + 1][k] - map[i][k])) / 255;
  return color;
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
};

// Which colors show which values: diverging ones, white for 0, if there are values of both signs,
// or only zeros; else sequential ones from the smallest to the largest value.
class Color_scale {
public:
  Color_scale(double low, double high) : m_low(low), m_high(high) {
    // differences this small, relative to the values, are rounding: paint a constant evenly
    constexpr double constant_tolerance = 1e-9;
    m_largest = std::max(std::abs(low), std::abs(high));
    m_is_diverging = m_largest == 0 || (low < 0 && high > 0);
    m_width = std::max(high - low, constant_tolerance * m_largest);
  }
  explicit Color_scale(const Value_range& range) : Color_scale(range.low, range.high) {}

  double low() const { return m_low; }
  double high() const { return m_high; }

  // of the nearer end beyond the range; gray if it is not a number
  Color operator()(double value) const {
    const double x = std::clamp(value, m_low, m_high);
    if(m_is_diverging)
      return color_at(diverging_colors, m_largest > 0 ? 0.5 + 0.5 * x / m_largest : 0.5 + 0 * x);
    return color_at(sequential_colors, (x - m_low) / m_width);
  }

  template <typename Range> std::vector<Color> colors(const Range& values) const {
    std::vector<Color> result;
    for(const double x : values)
      result.push_back((*this)(x));
    return result;
  }

private:
  double m_low, m_high, m_largest, m_width;
  bool m_is_diverging;
};

// of the scale from the smallest to the largest value
template <typename Range> std::vector<Color> value_colors(const Range& values) {
  return Color_scale(Value_range(values)).colors(values);
}

// Diverging colors that are full at the magnitude that a fraction of the values is below:
// curvatures have a few values that are much larger than all others.
inline Color_scale clipped_scale(const std::vector<double>& values, double fraction) {
  std::vector<double> magnitudes;
  for(const double x : values)
    if(std::isfinite(x))
      magnitudes.push_back(std::abs(x));
  if(magnitudes.empty())
    return {0, 0};
  const auto nth = magnitudes.begin() + static_cast<std::ptrdiff_t>(
                                            fraction * static_cast<double>(magnitudes.size() - 1));
  std::nth_element(magnitudes.begin(), nth, magnitudes.end());
  return {-*nth, *nth};
}

} // namespace programs

#endif // RESTRICTED_LAPLACIAN_3_PROGRAMS_COLOR_MAP_H
