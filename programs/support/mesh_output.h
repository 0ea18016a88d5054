// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_PROGRAMS_MESH_OUTPUT_H
#define RESTRICTED_LAPLACIAN_3_PROGRAMS_MESH_OUTPUT_H

#include "color_map.h"
#include "program.h"

#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

namespace programs {

namespace internal {

inline int color_byte(double component) {
  return static_cast<int>(std::lround(255 * std::clamp(component, 0., 1.)));
}

// The header of a binary PLY file of vertices with colors and named values, and of triangles, or,
// if there are none, of points with normals behind the values.
inline std::string ply_header(std::uint64_t number_of_vertices, std::uint64_t number_of_faces,
                              const std::vector<std::string>& names) {
  std::ostringstream out;
  out << "ply\nformat binary_little_endian 1.0\n"
      << "element vertex " << number_of_vertices << '\n'
      << "property double x\nproperty double y\nproperty double z\n"
      << "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  for(const std::string& name : names)
    out << "property double " << name << '\n';
  if(number_of_faces > 0)
    out << "element face " << number_of_faces << '\n' << "property list uchar int vertex_indices\n";
  else
    out << "property double nx\nproperty double ny\nproperty double nz\n";
  out << "end_header\n";
  return out.str();
}

// Writes a binary PLY file of a surface with a color and some named values for each vertex: columns
// of a matrix; of points without faces, but with their normals. CGAL's writers of properties take
// manifold meshes, or points, and this surface may be neither. Like them it is for machines that
// store the lowest byte of a number first.
inline void write_ply(const std::string& file, const RL::Triangulated_surface_3& surface,
                      const std::vector<Color>& colors, const std::vector<std::string>& names,
                      const Eigen::MatrixXd& values) {
  write_file(file, [&](std::ostream& out) {
    const bool has_faces = !surface.is_point_set();
    out << ply_header(surface.number_of_vertices(), has_faces ? surface.number_of_faces() : 0,
                      names);

    const auto write = [&](auto number) {
      out.write(reinterpret_cast<const char*>(&number), sizeof number);
    };
    for(std::size_t v = 0; v < surface.number_of_vertices(); ++v) {
      for(int axis = 0; axis < 3; ++axis)
        write(surface.point(v)[axis]);
      for(const double component : colors[v])
        write(static_cast<std::uint8_t>(color_byte(component)));
      for(std::size_t k = 0; k < names.size(); ++k)
        write(values(static_cast<Eigen::Index>(v), static_cast<Eigen::Index>(k)));
      for(int axis = 0; axis < 3 && !has_faces; ++axis)
        write(surface.normal(v)[axis]);
    }
    for(std::size_t f = 0; f < surface.number_of_faces() && has_faces; ++f) {
      write(std::uint8_t(3));
      for(const std::uint32_t vertex : surface.triangle(f))
        write(vertex);
    }
  });
}

// Writes an OBJ file; colors are three numbers behind the coordinates, as most programs read them.
inline void write_obj(const std::string& file, const RL::Triangulated_surface_3& surface,
                      const std::vector<Color>& colors) {
  write_file(file, [&](std::ostream& out) {
    for(std::size_t v = 0; v < surface.number_of_vertices(); ++v) {
      out << 'v';
      for(int axis = 0; axis < 3; ++axis)
        out << ' ' << surface.point(v)[axis];
      for(const double component : colors[v])
        out << ' ' << color_byte(component) / 255.;
      out << '\n';
    }
    for(std::size_t f = 0; f < surface.number_of_faces() && !surface.is_point_set(); ++f) {
      out << 'f';
      for(const std::uint32_t vertex : surface.triangle(f))
        out << ' ' << vertex + std::size_t(1);
      out << '\n';
    }
  });
}

} // namespace internal

// Writes a surface with a color for each vertex, and into PLY files also named values, columns of a
// matrix. The end of the name of the file tells the format, see check_output().
inline void write_mesh(const std::string& file, const RL::Triangulated_surface_3& surface,
                       const std::vector<Color>& colors, const std::vector<std::string>& names = {},
                       const Eigen::MatrixXd& values = {}) {
  if(extension(file) == ".obj")
    internal::write_obj(file, surface, colors);
  else
    internal::write_ply(file, surface, colors, names, values);
}

} // namespace programs

#endif // RESTRICTED_LAPLACIAN_3_PROGRAMS_MESH_OUTPUT_H
