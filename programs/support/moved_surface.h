// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_PROGRAMS_MOVED_SURFACE_H
#define RESTRICTED_LAPLACIAN_3_PROGRAMS_MOVED_SURFACE_H

#include "surface_program.h"
#include "table.h"

#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace programs {

/// what a program writes that moved the vertices of a surface: where they are, a row for each, and
/// the moved surface with how far they moved
inline Outcome moved_outcome(const RL::Triangulated_surface_3& surface,
                             const Eigen::MatrixXd& positions) {
  std::vector<RL::Point_3> points;
  std::vector<RL::Triangulated_surface_3::Triangle> triangles;
  std::vector<double> displacements;
  for(std::size_t v = 0; v < surface.number_of_vertices(); ++v) {
    const auto p = positions.row(static_cast<Eigen::Index>(v));
    points.emplace_back(p[0], p[1], p[2]);
    displacements.push_back(std::sqrt((points[v] - surface.point(v)).squared_length()));
  }
  for(std::size_t f = 0; f < surface.number_of_faces(); ++f)
    triangles.push_back(surface.triangle(f));
  Outcome result = outcome(displacements);
  result.names = {"displacement"};
  result.moved_surface =
      std::make_shared<const RL::Triangulated_surface_3>(std::move(points), std::move(triangles));
  result.write_table = [positions](const std::string& file, const Summary& summary) {
    write_csv(file, summary, "vertex", {"x", "y", "z"}, positions);
  };
  return result;
}

} // namespace programs

#endif // RESTRICTED_LAPLACIAN_3_PROGRAMS_MOVED_SURFACE_H
