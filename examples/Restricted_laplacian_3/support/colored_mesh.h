// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_EXAMPLES_COLORED_MESH_H
#define RESTRICTED_LAPLACIAN_3_EXAMPLES_COLORED_MESH_H

// Colors of vertices in files: red, green and blue, from 0 to 1, as they are stored. They are not
// in linear light.

#include "color_map.h"
#include "mesh_output.h"
#include "ply_property.h"
#include "program.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace examples {

// what stands for 1 in a color of some type
inline double full_intensity(const std::string& ply_type) {
  if(ply_type == "uchar" || ply_type == "uint8")
    return 255;
  if(ply_type == "ushort" || ply_type == "uint16")
    return 65535;
  return 1;
}

inline bool has_colors(const std::string& file) {
  return !internal::ply_property_type(file, "red").empty() &&
         !internal::ply_property_type(file, "green").empty() &&
         !internal::ply_property_type(file, "blue").empty();
}

// The colors of the vertices of a PLY file.
inline std::vector<Color> read_colors(const std::string& file) {
  require(has_colors(file), "'" + file +
                                "' has no colors: it is not a PLY file with the vertex "
                                "properties red, green and blue");
  std::vector<Color> colors;
  const std::array<const char*, 3> names = {"red", "green", "blue"};
  for(std::size_t k = 0; k < 3; ++k) {
    const double full = full_intensity(internal::ply_property_type(file, names[k]));
    const std::vector<double> values = read_ply_property(file, names[k]);
    colors.resize(values.size());
    for(std::size_t v = 0; v < values.size(); ++v) {
      require(std::isfinite(values[v]),
              "'" + file + "': the color of vertex " + std::to_string(v) + " is not finite");
      colors[v][k] = values[v] / full;
    }
  }
  return colors;
}

// the bytes of colors between 0 and 1, without a conversion
inline std::vector<Color_bytes> to_bytes(const std::vector<Color>& colors) {
  std::vector<Color_bytes> bytes;
  const auto byte = [](double x) {
    return static_cast<std::uint8_t>(std::lround(255 * std::clamp(x, 0., 1.)));
  };
  for(const Color& c : colors)
    bytes.push_back({byte(c[0]), byte(c[1]), byte(c[2])});
  return bytes;
}

} // namespace examples

#endif // RESTRICTED_LAPLACIAN_3_EXAMPLES_COLORED_MESH_H
