// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_BENCHMARK_VERTEX_NORMALS_H
#define RESTRICTED_LAPLACIAN_3_BENCHMARK_VERTEX_NORMALS_H

#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace benchmarks {

namespace RL = CGAL::Restricted_laplacian_3;

/// Vertex normals, the means of those of the faces around by area, and what follows from them.
struct Vertex_normals {
  std::vector<RL::Vector_3> at_vertex, gradients_of_face; ///< of a face: those of x, y and z
  std::vector<double> areas;                              ///< of vertices: a third of their faces
  Eigen::RowVector3d mean = Eigen::RowVector3d::Zero();

  explicit Vertex_normals(const RL::Triangulated_surface_3& surface)
    : at_vertex(surface.number_of_vertices(), RL::Vector_3(0, 0, 0)),
      gradients_of_face(3 * surface.number_of_faces(), RL::Vector_3(0, 0, 0)),
      areas(surface.number_of_vertices(), 0.) {
    for(std::size_t f = 0; f < surface.number_of_faces(); ++f)
      for(const std::uint32_t v : surface.triangle(f)) {
        at_vertex[v] += surface.area(f) * surface.normal(f);
        areas[v] += surface.area(f) / 3;
      }
    for(std::size_t v = 0; v < at_vertex.size(); ++v) {
      const double length = std::sqrt(at_vertex[v].squared_length());
      if(length > 0)
        at_vertex[v] = at_vertex[v] / length;
      for(int k = 0; k < 3; ++k)
        mean[k] += areas[v] * at_vertex[v][k] / surface.area();
    }
    for(std::size_t f = 0; f < surface.number_of_faces(); ++f)
      for(int i = 0; i < 3 && !surface.is_degenerate(f); ++i) {
        const RL::Vector_3 side = surface.point(f, (i + 2) % 3) - surface.point(f, (i + 1) % 3);
        const RL::Vector_3 gradient =
            CGAL::cross_product(surface.normal(f), side) / (2 * surface.area(f));
        for(int k = 0; k < 3; ++k)
          gradients_of_face[3 * f + k] += at_vertex[surface.triangle(f)[i]][k] * gradient;
      }
  }
};

} // namespace benchmarks

#endif // RESTRICTED_LAPLACIAN_3_BENCHMARK_VERTEX_NORMALS_H
