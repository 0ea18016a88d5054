// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_BENCHMARK_MESH_CURVATURE_H
#define RESTRICTED_LAPLACIAN_3_BENCHMARK_MESH_CURVATURE_H

// What the curvatures of the package are compared with: M. Meyer, M. Desbrun, P. Schroeder and
// A. H. Barr, "Discrete differential-geometry operators for triangulated 2-manifolds", 2003.

#include <CGAL/Restricted_laplacian_3/assembly/cotangent_operators.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>
#include <CGAL/Restricted_laplacian_3/surface/shared/Surface_edges.h>
#include <CGAL/Restricted_laplacian_3/surface/vertex_normals.h>

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace benchmarks {

namespace RL = CGAL::Restricted_laplacian_3;

struct Mesh_curvature {
  /// the cotangent Laplacian of the coordinates, and angle defects, over mixed areas; NaN on the
  /// boundary, where neither is defined
  std::vector<double> mean, gaussian;

  explicit Mesh_curvature(const RL::Triangulated_surface_3& surface) {
    const std::size_t n = surface.number_of_vertices();
    std::vector<double> areas(n, 0.), angles(n, 0.);
    for(std::size_t f = 0; f < surface.number_of_faces(); ++f)
      if(!surface.is_degenerate(f))
        add_face(surface, f, areas, angles);
    Eigen::MatrixXd points(static_cast<Eigen::Index>(n), 3);
    for(std::size_t v = 0; v < n; ++v)
      for(int k = 0; k < 3; ++k)
        points(static_cast<Eigen::Index>(v), k) = surface.point(v)[k];
    // S x is the integral of 2 H n
    const Eigen::MatrixXd vectors = RL::cotangent_operators(surface).stiffness * points;
    const std::vector<RL::Vector_3> normals = RL::vertex_normals(surface);
    for(std::size_t v = 0; v < n; ++v) {
      const auto vector = vectors.row(static_cast<Eigen::Index>(v));
      const RL::Vector_3 twice_mean(vector[0], vector[1], vector[2]);
      const double sign = twice_mean * normals[v] < 0 ? -1 : 1;
      mean.push_back(sign * std::sqrt(twice_mean.squared_length()) / (2 * areas[v]));
      gaussian.push_back((2 * CGAL_PI - angles[v]) / areas[v]);
    }
    const std::vector<char> is_on_boundary =
        RL::internal::Surface_edges(surface).boundary_vertices();
    for(std::size_t v = 0; v < n; ++v)
      if(is_on_boundary[v])
        mean[v] = gaussian[v] = std::numeric_limits<double>::quiet_NaN();
  }

private:
  static void add_face(const RL::Triangulated_surface_3& surface, std::size_t f,
                       std::vector<double>& areas, std::vector<double>& angles) {
    double angle[3], squared[3]; // of the corners, and of the sides opposite to them
    for(int i = 0; i < 3; ++i) {
      const RL::Vector_3 a = surface.point(f, (i + 1) % 3) - surface.point(f, i),
                         b = surface.point(f, (i + 2) % 3) - surface.point(f, i);
      angle[i] = std::atan2(std::sqrt(CGAL::cross_product(a, b).squared_length()), a * b);
      squared[i] = (a - b).squared_length();
    }
    const bool is_obtuse =
        angle[0] > CGAL_PI / 2 || angle[1] > CGAL_PI / 2 || angle[2] > CGAL_PI / 2;
    for(int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      angles[surface.triangle(f)[i]] += angle[i];
      areas[surface.triangle(f)[i]] +=
          is_obtuse ? surface.area(f) / (angle[i] > CGAL_PI / 2 ? 2 : 4)
                    : (squared[j] / std::tan(angle[j]) + squared[k] / std::tan(angle[k])) / 8;
    }
  }
};

} // namespace benchmarks

#endif // RESTRICTED_LAPLACIAN_3_BENCHMARK_MESH_CURVATURE_H
