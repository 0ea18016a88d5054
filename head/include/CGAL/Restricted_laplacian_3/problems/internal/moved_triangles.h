// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_INTERNAL_MOVED_TRIANGLES_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_INTERNAL_MOVED_TRIANGLES_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/parallel_for.h>
#include <CGAL/Restricted_laplacian_3/problems/Flow_report.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// the corners of a triangle, columns
inline Eigen::Matrix3d corners_of(const Eigen::MatrixXd& points,
                                  const std::array<std::uint32_t, 3>& triangle) {
  Eigen::Matrix3d result;
  for(int i = 0; i < 3; ++i)
    result.col(i) = points.row(triangle[i]).transpose();
  return result;
}

/// the area of a triangle with these corners
inline double area_of(const Eigen::Matrix3d& c) {
  return (c.col(1) - c.col(0)).cross(c.col(2) - c.col(0)).norm() / 2;
}

/// The sum of what `add(face, corners, sum)` adds for the faces that have an area, in chunks; so it
/// is the same with and without threads.
template <class Sum, class Add>
Sum sum_over_moved_faces(const Spline_space_3& space, const Eigen::MatrixXd& points,
                         const Sum& zero, const Add& add) {
  constexpr std::size_t grain = 4096;
  const Triangulated_surface_3& surface = space.surface();
  const std::size_t number = surface.number_of_faces();
  std::vector<Sum> sums((number + grain - 1) / grain, zero);
  parallel_for(space.options().is_parallel, 0, number, grain,
               [&](std::size_t begin, std::size_t end) {
                 for(std::size_t face = begin; face < end; ++face)
                   if(!surface.is_degenerate(face))
                     add(face, corners_of(points, surface.triangle(face)), sums[begin / grain]);
               });
  Sum result = zero;
  for(const Sum& sum : sums)
    result += sum;
  return result;
}

/// Area, volume inside, and centroid of the area of triangles.
struct Moved_size {
  double area = 0, volume = 0;
  Eigen::Vector3d centroid;
};

inline Moved_size moved_size(const Spline_space_3& space, const Eigen::MatrixXd& points) {
  const Eigen::Vector3d origin = points.colwise().mean().transpose();
  using Sums = Eigen::Matrix<double, 5, 1>;
  const Sums sums = sum_over_moved_faces<Sums>(
      space, points, Sums::Zero(), [&](std::size_t, const Eigen::Matrix3d& corners, Sums& sum) {
        const Eigen::Matrix3d c = corners.colwise() - origin;
        const double area = area_of(c);
        sum[0] += area;
        sum[1] += c.determinant() / 6;
        sum.tail<3>() += area * c.rowwise().mean();
      });
  Moved_size result;
  result.area = sums[0];
  result.volume = sums[1];
  result.centroid = origin + sums.tail<3>() / (sums[0] > 0 ? sums[0] : 1);
  return result;
}

/// The mean over triangles of the deviation of the distance from a center, relative to the mean of
/// that distance.
inline double moved_deviation_from_sphere(const Spline_space_3& space,
                                          const Eigen::MatrixXd& points, const Moved_size& size) {
  const auto mean_of = [&](const auto& term) {
    return sum_over_moved_faces<double>(
               space, points, 0,
               [&](std::size_t, const Eigen::Matrix3d& corners, double& sum) {
                 const Eigen::Array<double, 1, 3> distances =
                     (corners.colwise() - size.centroid).colwise().norm();
                 sum += area_of(corners) * term(distances).mean();
               }) /
           size.area;
  };
  const double mean = mean_of([](const auto& distances) { return distances; });
  return mean > 0 ? mean_of([&](const auto& distances) {
                      return Eigen::Array<double, 1, 3>((distances - mean).abs());
                    }) / mean
                  : 0;
}

/// The singular values, the larger one first, of the linear map of a triangle to another one.
inline std::array<double, 2> singular_values(const Eigen::Matrix3d& from,
                                             const Eigen::Matrix3d& to) {
  Eigen::Matrix2d g[2]; // the products of two sides
  const Eigen::Matrix3d* const triangles[2] = {&from, &to};
  for(int k = 0; k < 2; ++k) {
    Eigen::Matrix<double, 3, 2> sides;
    sides << triangles[k]->col(1) - triangles[k]->col(0),
        triangles[k]->col(2) - triangles[k]->col(0);
    g[k] = sides.transpose() * sides;
  }
  // squares: the eigenvalues of g0^-1 g1
  const double determinant = g[0].determinant();
  if(!(determinant > 0))
    return {1, 1};
  const double ratio = (std::max)(g[1].determinant() / determinant, 0.),
               half_trace = (g[0](0, 0) * g[1](1, 1) + g[0](1, 1) * g[1](0, 0) -
                             2 * g[0](0, 1) * g[1](0, 1)) /
                            (2 * determinant),
               root = std::sqrt((std::max)(half_trace * half_trace - ratio, 0.));
  const double larger = std::sqrt((std::max)(half_trace + root, 0.));
  return {larger, larger > 0 ? std::sqrt(ratio) / larger : 0};
}

/// the corners of a face of the first surface, columns
inline Eigen::Matrix3d first_corners(const Triangulated_surface_3& surface, std::size_t face) {
  Eigen::Matrix3d result;
  for(int i = 0; i < 3; ++i) {
    const Point_3& p = surface.point(face, i);
    result.col(i) << p.x(), p.y(), p.z();
  }
  return result;
}

/// Area, volume, angles and distortion of triangles.
inline void measure_moved(const Spline_space_3& space, const Eigen::MatrixXd& points,
                          bool is_closed, Flow_report& report) {
  const Moved_size size = moved_size(space, points);
  report.area = size.area;
  report.volume = is_closed ? size.volume : 0;
  report.sphere_deviation = moved_deviation_from_sphere(space, points, size);
  struct Quality {
    double distortion = 0, area = 0, largest = 1, angle = std::numeric_limits<double>::max();

    void operator+=(const Quality& other) {
      distortion += other.distortion;
      area += other.area;
      largest = (std::max)(largest, other.largest);
      angle = (std::min)(angle, other.angle);
    }
  };
  const Triangulated_surface_3& surface = space.surface();
  const Quality quality = sum_over_moved_faces(
      space, points, Quality(), [&](std::size_t face, const Eigen::Matrix3d& moved, Quality& sum) {
        double angle = sum.angle;
        for(int i = 0; i < 3; ++i) {
          const Eigen::Vector3d u = moved.col((i + 1) % 3) - moved.col(i),
                                v = moved.col((i + 2) % 3) - moved.col(i);
          angle = (std::min)(angle, std::atan2(u.cross(v).norm(), u.dot(v)));
        }
        const auto [s1, s2] = singular_values(first_corners(surface, face), moved);
        const double distortion =
            s2 > 0 ? (s1 / s2 + s2 / s1) / 2 : std::numeric_limits<double>::infinity();
        sum += Quality{surface.area(face) * distortion, surface.area(face), distortion, angle};
      });
  report.smallest_angle = quality.angle * 180 / std::acos(-1.);
  report.largest_distortion = quality.largest;
  report.mean_distortion = quality.area > 0 ? quality.distortion / quality.area : 1;
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_INTERNAL_MOVED_TRIANGLES_H
