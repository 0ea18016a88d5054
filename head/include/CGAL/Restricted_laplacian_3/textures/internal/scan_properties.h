// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_TEXTURES_INTERNAL_SCAN_PROPERTIES_H
#define CGAL_RESTRICTED_LAPLACIAN_3_TEXTURES_INTERNAL_SCAN_PROPERTIES_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parallel_for.h>
#include <CGAL/Restricted_laplacian_3/input/point_areas.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>
#include <CGAL/Restricted_laplacian_3/surface/shared/Nearest_points.h>
#include <CGAL/Restricted_laplacian_3/surface/shared/Point_neighborhood.h>
#include <CGAL/Restricted_laplacian_3/textures/srgb.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// of two equally good middle values the larger one; 0 if there are none
inline double median(std::vector<double> values) {
  if(values.empty())
    return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

inline Eigen::Vector3d eigen_vector(const Vector_3& v) { return {v.x(), v.y(), v.z()}; }
inline Eigen::Vector3d eigen_vector(const Rgb_color& c) { return {c[0], c[1], c[2]}; }

/// length of a vector whose square may overflow or vanish
inline double safe_length(const Vector_3& v) { return eigen_vector(v).stableNorm(); }

/// the median length of the sides of faces that are not degenerate
inline double median_side(const Triangulated_surface_3& surface) {
  std::vector<double> lengths;
  lengths.reserve(3 * surface.number_of_faces());
  for(std::size_t f = 0; f < surface.number_of_faces(); ++f)
    for(int i = 0; i < 3 && !surface.is_degenerate(f); ++i)
      lengths.push_back(safe_length(surface.point(f, (i + 1) % 3) - surface.point(f, i)));
  return median(std::move(lengths));
}

/// The distance of each vertex to the nearest vertex that is marked, infinite if none is.
inline std::vector<double> distances_to_marked(const Triangulated_surface_3& surface,
                                               const std::vector<char>& is_marked,
                                               bool is_parallel) {
  // coordinates whose squares neither overflow nor vanish
  const Point_3 center = surface.center();
  const double scale = 1 / surface.extent();
  const auto relative = [&](std::size_t v) {
    return CGAL::ORIGIN + (surface.point(v) - center) * scale;
  };
  std::vector<Point_3> marked;
  for(std::size_t v = 0; v < is_marked.size(); ++v)
    if(is_marked[v])
      marked.push_back(relative(v));
  std::vector<double> distances(is_marked.size(), std::numeric_limits<double>::infinity());
  if(marked.empty())
    return distances;
  const Nearest_points nearest(marked);
  parallel_for(is_parallel, 0, distances.size(), 1 << 10, [&](std::size_t begin, std::size_t end) {
    for(std::size_t v = begin; v < end; ++v) {
      const Point_3 p = relative(v);
      if(std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z()))
        distances[v] = safe_length(p - marked[nearest.nearest_to(p)]) * surface.extent();
    }
  });
  return distances;
}

/// What follows from the neighbors of the points of a set.
struct Scan_point_properties {
  double spacing = 0;
  std::vector<char> is_on_boundary;
  /// column \f$k\f$: gradient of channel \f$k\f$ in the tangent plane
  std::vector<Eigen::Matrix3d> gradients;
};

/// The tangential gradients that fit the differences of colors best: weighted least squares
/// around the weighted means, in the directions in which the points differ.
/// \param ways from a point to its neighbors in its tangent plane
/// \throws Numerical_error the eigenvectors of their moments are not found
inline Eigen::Matrix3d fitted_gradient(const std::vector<Eigen::Vector3d>& ways,
                                       const std::vector<Eigen::Vector3d>& colors) {
  constexpr double smallest_relative_eigenvalue = 1e-6;
  double radius = 0;
  for(const Eigen::Vector3d& way : ways)
    radius = (std::max)(radius, way.norm());
  if(!(radius > 0))
    return Eigen::Matrix3d::Zero();
  double sum_of_weights = 0;
  Eigen::Vector3d mean_way = Eigen::Vector3d::Zero(), mean_color = Eigen::Vector3d::Zero();
  const auto weight = [&](const Eigen::Vector3d& way) {
    return std::exp(-4 * way.squaredNorm() / (radius * radius));
  };
  for(std::size_t i = 0; i < ways.size(); ++i) {
    const double w = weight(ways[i]);
    sum_of_weights += w;
    mean_way += w * ways[i];
    mean_color += w * colors[i];
  }
  mean_way /= sum_of_weights;
  mean_color /= sum_of_weights;
  Eigen::Matrix3d a = Eigen::Matrix3d::Zero(), b = Eigen::Matrix3d::Zero();
  for(std::size_t i = 0; i < ways.size(); ++i) {
    const Eigen::Vector3d way = (ways[i] - mean_way) / radius;
    a += weight(ways[i]) * way * way.transpose();
    b += weight(ways[i]) * way * (colors[i] - mean_color).transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(a);
  if(solver.info() != Eigen::Success)
    throw Numerical_error("no eigenvectors were found for the gradients of the colors of a scan");
  Eigen::Matrix3d gradient = Eigen::Matrix3d::Zero();
  for(int i = 1; i < 3; ++i) // the first eigenvector is the normal
    if(solver.eigenvalues()[i] > smallest_relative_eigenvalue * solver.eigenvalues()[2]) {
      const Eigen::Vector3d e = solver.eigenvectors().col(i);
      gradient += e * (e.transpose() * b) / (solver.eigenvalues()[i] * radius);
    }
  return gradient;
}

/// Neighbors whose normals are more than 90 degrees away are left out.
/// \param normals of the points, of unit length, all to one side
inline Scan_point_properties scan_point_properties(const Triangulated_surface_3& surface,
                                                   const std::vector<Vector_3>& normals,
                                                   const std::vector<Rgb_color>& colors,
                                                   bool is_parallel) {
  constexpr double smallest_gap_at_boundary = 2.8; // as for areas of points
  constexpr double pi = 3.14159265358979323846;
  const std::size_t n = surface.number_of_vertices();
  Point_sites sites;
  sites.normals = normals;
  for(std::size_t i = 0; i < n; ++i)
    sites.points.push_back(CGAL::ORIGIN + (surface.point(i) - surface.center()) / surface.extent());
  const Nearest_points nearest(sites.points);
  Scan_point_properties result;
  result.is_on_boundary.assign(n, 0);
  result.gradients.assign(n, Eigen::Matrix3d::Zero());
  std::vector<double> spacings(n, 0);
  parallel_for(is_parallel, 0, n, 1 << 8, [&](std::size_t begin, std::size_t end) {
    std::vector<std::uint32_t> neighbors;
    std::vector<std::array<double, 2>> projected;
    std::vector<Eigen::Vector3d> ways, differences;
    for(std::size_t i = begin; i < end; ++i) {
      nearest.find(i, default_number_of_neighbors, neighbors);
      const Eigen::Vector3d normal = eigen_vector(sites.normals[i]);
      ways.assign(1, Eigen::Vector3d::Zero());
      differences.assign(1, Eigen::Vector3d::Zero());
      for(std::uint32_t j : neighbors)
        if(sites.normals[i] * sites.normals[j] > 0) {
          const Eigen::Vector3d way = eigen_vector(sites.points[j] - sites.points[i]);
          ways.push_back(way - way.dot(normal) * normal);
          differences.push_back(eigen_vector(colors[j]) - eigen_vector(colors[i]));
        }
      result.gradients[i] = fitted_gradient(ways, differences) / surface.extent();
      project_neighbors(sites, i, neighbors, projected);
      result.is_on_boundary[i] =
          projected.empty() || largest_gap(projected) > smallest_gap_at_boundary;
      if(!neighbors.empty()) {
        const Vector_3 farthest = sites.points[neighbors.back()] - sites.points[i];
        spacings[i] =
            std::sqrt(farthest.squared_length() * pi / static_cast<double>(neighbors.size()));
      }
    }
  });
  result.spacing = median(std::move(spacings)) * surface.extent();
  return result;
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_TEXTURES_INTERNAL_SCAN_PROPERTIES_H
