// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_MAP_TO_SPHERE_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_MAP_TO_SPHERE_IMPL_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Progress.h>
#include <CGAL/Restricted_laplacian_3/problems/internal/moved_triangles.h>
#include <CGAL/Restricted_laplacian_3/problems/map_to_sphere.h>

#include <Eigen/Core>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// vertices minus edges plus faces, of what has an area
inline std::ptrdiff_t euler_characteristic(const Triangulated_surface_3& surface) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  std::vector<char> is_used(surface.number_of_vertices());
  std::ptrdiff_t faces = 0;
  for(std::size_t face = 0; face < surface.number_of_faces(); ++face) {
    if(surface.is_degenerate(face))
      continue;
    ++faces;
    const auto& t = surface.triangle(face);
    for(int i = 0; i < 3; ++i) {
      is_used[t[i]] = 1;
      edges.push_back(std::minmax(t[i], t[(i + 1) % 3]));
    }
  }
  std::sort(edges.begin(), edges.end());
  const auto last = std::unique(edges.begin(), edges.end());
  return std::count(is_used.begin(), is_used.end(), 1) - (last - edges.begin()) + faces;
}

/// Moves points on the unit sphere by Moebius transformations until the mean with weights is in its
/// center (A. Baden, K. Crane, M. Kazhdan, *Moebius registration*, Computer Graphics Forum 37(5),
/// 2018): Newton's method, with steps that stay inside of the ball.
inline void center_on_sphere(const Eigen::VectorXd& weights, Eigen::MatrixXd& points) {
  constexpr int maximum_steps = 100;
  constexpr double tolerance = 1e-12, longest_step = 0.5;
  for(int step = 0; step < maximum_steps; ++step) {
    const Eigen::Vector3d mean = points.transpose() * weights;
    if(mean.norm() < tolerance)
      return;
    const Eigen::Matrix3d jacobian =
        2 * (Eigen::Matrix3d::Identity() - points.transpose() * weights.asDiagonal() * points);
    Eigen::Vector3d c = -jacobian.inverse() * mean;
    if(!c.allFinite())
      return;
    if(const double length = c.norm(); length > longest_step)
      c *= longest_step / length;
    for(Eigen::Index v = 0; v < points.rows(); ++v) {
      const Eigen::Vector3d x = points.row(v).transpose() + c;
      points.row(v) = ((1 - c.squaredNorm()) / x.squaredNorm() * x + c).transpose().normalized();
    }
  }
}

} // namespace internal

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Sphere_map map_to_sphere(const Spline_space_3& space,
                                                            const Sphere_map_options& options) {
  const Triangulated_surface_3& surface = space.surface();
  surface.require_triangles("map_to_sphere");
  if(!(options.tolerance > 0 && options.tolerance < 1))
    throw Parameter_error("tolerance", "is " + std::to_string(options.tolerance) +
                                           ", but must be between 0 and 1");
  if(options.maximum_iterations < 1)
    throw Parameter_error("maximum_iterations", "is " + std::to_string(options.maximum_iterations) +
                                                    ", but must be at least 1");
  if(space.number_of_sheets(0) != 1)
    throw Input_error("the surface has " + std::to_string(space.number_of_sheets(0)) +
                      " connected components: there is no map to a sphere");
  if(const std::ptrdiff_t characteristic = internal::euler_characteristic(surface);
     characteristic != 2)
    throw Input_error("the Euler characteristic of the surface is " +
                      std::to_string(characteristic) +
                      " and not 2: it has a boundary, holes or handles, or vertices at the same "
                      "place, and there is no map to a sphere");
  const internal::Progress progress(options.progress);
  progress(0);
  Mean_curvature_flow_options of_flow;
  of_flow.conformal = true;
  of_flow.stabilization = options.stabilization;
  Mean_curvature_flow flow(space, of_flow);
  constexpr double time_step = 0.02; // of the area
  Flow_report report;
  int steps = 0;
  double first_deviation = 1;
  for(; steps < options.maximum_iterations; ++steps) {
    report = flow.step(time_step * surface.area());
    if(!report.converged || !report.collapse.empty())
      break;
    if(steps == 0)
      first_deviation = (std::max)(report.sphere_deviation, 2 * options.tolerance);
    progress(std::clamp(std::log(report.sphere_deviation / first_deviation) /
                            std::log(options.tolerance / first_deviation),
                        0., 1.));
    if(report.sphere_deviation <= options.tolerance) {
      ++steps;
      break;
    }
  }
  Sphere_map result;
  static_cast<Flow_report&>(result) = report;
  result.iterations = steps;
  if(report.converged && report.sphere_deviation > options.tolerance)
    result.worsen_status(Solve_status::iteration_limit);

  // radially to the unit sphere, about the centroid
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(flow.vertex_positions().rows());
  for(std::size_t face = 0; face < surface.number_of_faces(); ++face)
    if(!surface.is_degenerate(face))
      for(const std::uint32_t v : surface.triangle(face))
        weights[v] += surface.area(face) / 3 / surface.area();
  const Eigen::RowVector3d centroid =
      internal::moved_size(space, flow.vertex_positions()).centroid.transpose();
  result.positions = flow.vertex_positions().rowwise() - centroid;
  for(Eigen::Index v = 0; v < weights.size(); ++v)
    if(const double length = result.positions.row(v).norm(); weights[v] > 0 && length > 0)
      result.positions.row(v) /= length;
    else
      result.positions.row(v) << 0, 0, 1;
  internal::center_on_sphere(weights, result.positions);
  internal::measure_moved(space, result.positions, true, result);
  result.sphere_deviation = report.sphere_deviation;
  std::array<std::size_t, 2> signs = {0, 0};
  for(std::size_t face = 0; face < surface.number_of_faces(); ++face)
    if(!surface.is_degenerate(face))
      ++signs[internal::corners_of(result.positions, surface.triangle(face)).determinant() > 0];
  result.folded_faces = (std::min)(signs[0], signs[1]);
  progress(1);
  return result;
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_MAP_TO_SPHERE_IMPL_H
