// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_EXAMPLES_MESH_OUTPUT_H
#define RESTRICTED_LAPLACIAN_3_EXAMPLES_MESH_OUTPUT_H

// Writes colored meshes.

#include "color_map.h"
#include "program.h"

#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <string>
#include <vector>

namespace examples {

namespace internal {

// the bytes of a number, in the order of the machine
template <typename Number> void write_bytes(std::ostream& out, Number number) {
  out.write(reinterpret_cast<const char*>(&number), sizeof number);
}

} // namespace internal

// red, green and blue as files hold them
using Color_bytes = std::array<std::uint8_t, 3>;

// Writes a binary PLY file of a surface with a color and some named values for each vertex: columns
// of a matrix; of points without faces, but with their normals. Like the writers of CGAL it is for
// machines that store the lowest byte of a number first.
inline void write_mesh(const std::string& file, const RL::Triangulated_surface_3& surface,
                       const std::vector<Color_bytes>& colors,
                       const std::vector<std::string>& names, const Eigen::MatrixXd& values) {
  using internal::write_bytes;
  write_file(file, [&](std::ostream& out) {
    out << "ply\nformat binary_little_endian 1.0\n"
        << "element vertex " << surface.number_of_vertices() << '\n'
        << "property double x\nproperty double y\nproperty double z\n"
        << "property uchar red\nproperty uchar green\nproperty uchar blue\n";
    for(const std::string& name : names)
      out << "property double " << name << '\n';
    if(surface.is_point_set())
      out << "property double nx\nproperty double ny\nproperty double nz\n";
    else
      out << "element face " << surface.number_of_faces() << '\n'
          << "property list uchar int vertex_indices\n";
    out << "end_header\n";
    for(std::size_t v = 0; v < surface.number_of_vertices(); ++v) {
      for(int axis = 0; axis < 3; ++axis)
        write_bytes(out, surface.point(v)[axis]);
      for(const std::uint8_t component : colors[v])
        write_bytes(out, component);
      for(std::size_t k = 0; k < names.size(); ++k)
        write_bytes(out, values(static_cast<Eigen::Index>(v), static_cast<Eigen::Index>(k)));
      for(int axis = 0; axis < 3 && surface.is_point_set(); ++axis)
        write_bytes(out, surface.normal(v)[axis]);
    }
    for(std::size_t f = 0; f < surface.number_of_faces() && !surface.is_point_set(); ++f) {
      write_bytes(out, std::uint8_t(3));
      for(const std::uint32_t vertex : surface.triangle(f))
        write_bytes(out, vertex);
    }
  });
}

// The same with colors in linear light.
inline void write_mesh(const std::string& file, const RL::Triangulated_surface_3& surface,
                       const std::vector<Color>& colors, const std::vector<std::string>& names,
                       const Eigen::MatrixXd& values) {
  std::vector<Color_bytes> bytes;
  for(const Color& c : colors)
    bytes.push_back({srgb_byte(c[0]), srgb_byte(c[1]), srgb_byte(c[2])});
  write_mesh(file, surface, bytes, names, values);
}

// The same with one value, and colors that show it.
inline void write_mesh(const std::string& file, const RL::Triangulated_surface_3& surface,
                       const std::vector<double>& values) {
  write_mesh(
      file, surface, value_colors(values), {"value"},
      Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size())));
}

} // namespace examples

#endif // RESTRICTED_LAPLACIAN_3_EXAMPLES_MESH_OUTPUT_H
