// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_MEAN_CURVATURE_FLOW_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_MEAN_CURVATURE_FLOW_IMPL_H

#include <CGAL/Restricted_laplacian_3/assembly/Boundary_integration.h>
#include <CGAL/Restricted_laplacian_3/assembly/Point_constraints.h>
#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parallel_for.h>
#include <CGAL/Restricted_laplacian_3/problems/Function_fitter.h>
#include <CGAL/Restricted_laplacian_3/problems/Mean_curvature_flow.h>
#include <CGAL/Restricted_laplacian_3/problems/Poisson_solver.h>
#include <CGAL/Restricted_laplacian_3/problems/stabilization.h>
#include <CGAL/Restricted_laplacian_3/splines/evaluation_matrix.h>

#include <CGAL/Real_timer.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
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

} // namespace internal

CGAL_RESTRICTED_LAPLACIAN_3_INLINE
Mean_curvature_flow::Mean_curvature_flow(const Spline_space_3& space,
                                         const Mean_curvature_flow_options& options)
  : m_space(space), m_options(options) {
  const Triangulated_surface_3& surface = space.surface();
  surface.require_triangles("Mean_curvature_flow");
  if(!(options.tolerance > 0 && options.tolerance < 1))
    throw Parameter_error("tolerance", "is " + std::to_string(options.tolerance) +
                                           ", but must be between 0 and 1");
  m_is_closed = internal::boundary_sides(space).empty();
  if(!m_options.rescaling)
    m_options.rescaling = options.conformal ? Rescaling::area : Rescaling::none;
  if(m_options.rescaling == Rescaling::volume && !m_is_closed)
    throw Input_error("the surface has a boundary: there is no volume to be kept");
  m_first.resize(static_cast<Eigen::Index>(surface.number_of_vertices()), 3);
  for(std::size_t v = 0; v < surface.number_of_vertices(); ++v) {
    const Point_3& p = surface.point(v);
    m_first.row(static_cast<Eigen::Index>(v)) << p.x(), p.y(), p.z();
  }
  m_evaluation = evaluation_matrix(space);
  Function_fitter fitter(space.with_material({}));
  m_positions =
      fitter.fit([](const Surface_point& p) { return p.point - CGAL::ORIGIN; }).coefficients;
  m_at_vertices = at_vertices(m_positions);
  const internal::Moved_size size = internal::moved_size(space, m_first);
  m_first_area = size.area;
  m_first_volume = size.volume;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Eigen::MatrixXd
Mean_curvature_flow::at_vertices(const Eigen::MatrixXd& positions) const {
  Eigen::MatrixXd result = m_evaluation * positions;
  const Eigen::VectorXd ones =
      m_evaluation * Eigen::VectorXd::Ones(static_cast<Eigen::Index>(m_evaluation.cols()));
  for(Eigen::Index v = 0; v < result.rows(); ++v)
    if(ones[v] == 0)
      result.row(v) = m_first.row(v);
  return result;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void Mean_curvature_flow::measure(Flow_report& report) const {
  const internal::Moved_size size = internal::moved_size(m_space, m_at_vertices);
  report.area = size.area;
  report.volume = m_is_closed ? size.volume : 0;
  report.sphere_deviation = internal::moved_deviation_from_sphere(m_space, m_at_vertices, size);
  struct Quality {
    double distortion = 0, area = 0, largest = 1, angle = std::numeric_limits<double>::max();

    void operator+=(const Quality& other) {
      distortion += other.distortion;
      area += other.area;
      largest = (std::max)(largest, other.largest);
      angle = (std::min)(angle, other.angle);
    }
  };
  const Triangulated_surface_3& surface = m_space.surface();
  const Quality quality = internal::sum_over_moved_faces(
      m_space, m_at_vertices, Quality(),
      [&](std::size_t face, const Eigen::Matrix3d& moved, Quality& sum) {
        double angle = sum.angle;
        for(int i = 0; i < 3; ++i) {
          const Eigen::Vector3d u = moved.col((i + 1) % 3) - moved.col(i),
                                v = moved.col((i + 2) % 3) - moved.col(i);
          angle = (std::min)(angle, std::atan2(u.cross(v).norm(), u.dot(v)));
        }
        const auto [s1, s2] =
            internal::singular_values(internal::corners_of(m_first, surface.triangle(face)), moved);
        const double distortion =
            s2 > 0 ? (s1 / s2 + s2 / s1) / 2 : std::numeric_limits<double>::infinity();
        sum += Quality{surface.area(face) * distortion, surface.area(face), distortion, angle};
      });
  report.smallest_angle = quality.angle * 180 / std::acos(-1.);
  report.largest_distortion = quality.largest;
  report.mean_distortion = quality.area > 0 ? quality.distortion / quality.area : 1;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE std::string
Mean_curvature_flow::collapse(const Eigen::MatrixXd& after) const {
  if(!after.allFinite())
    return "positions left the range of numbers";
  if(m_options.conformal)
    return {}; // what shrinks there does so in all directions
  const Triangulated_surface_3& surface = m_space.surface();
  struct Collapsed {
    double area = 0, all = 0;
    std::size_t face = 0; // one of them

    void operator+=(const Collapsed& other) {
      if(other.area > 0)
        face = other.face;
      area += other.area;
      all += other.all;
    }
  };
  const Collapsed collapsed = internal::sum_over_moved_faces(
      m_space, after, Collapsed(),
      [&](std::size_t face, const Eigen::Matrix3d& corners, Collapsed& sum) {
        constexpr double smallest_part = 0.05;
        const auto values = internal::singular_values(
            internal::corners_of(m_first, surface.triangle(face)), corners);
        sum.all += surface.area(face);
        if(values[0] < smallest_part || values[1] < smallest_part)
          sum += Collapsed{surface.area(face), 0, face};
      });
  constexpr double largest_part = 1e-3; // single triangles may shrink, a neck is more
  return collapsed.area > largest_part * collapsed.all
             ? "the surface collapses near face " + std::to_string(surface.polygon(collapsed.face))
             : std::string();
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void
Mean_curvature_flow::rescale(Eigen::MatrixXd& positions, const Eigen::MatrixXd& at_vertices) const {
  if(m_options.rescaling == Rescaling::none)
    return;
  const internal::Moved_size size = internal::moved_size(m_space, at_vertices);
  const double scale = m_options.rescaling == Rescaling::area
                           ? std::sqrt(m_first_area / size.area)
                           : std::cbrt(m_first_volume / size.volume);
  const Eigen::RowVector3d center = size.centroid.transpose();
  if(std::isfinite(scale))
    positions = ((positions.rowwise() - center) * scale).rowwise() + center;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Flow_report Mean_curvature_flow::step(double time_step) {
  if(!(time_step > 0 && std::isfinite(time_step)))
    throw Parameter_error("time_step",
                          "is " + std::to_string(time_step) + ", but must be positive");
  CGAL::Real_timer timer;
  timer.start();
  const Spline_space_3 moved = m_space.with_material({}).integrated_by(Moved_integration(
      m_space, m_positions, m_options.conformal ? Moved_metric::conformal : Moved_metric::moved));
  std::vector<Point_constraints> constraints;
  if(!m_is_closed && m_options.fixed_boundary) {
    // a penalty for the distance from the first boundary, which is a fraction of a cell
    constexpr double penalty = 1e3;
    const double h = m_space.octree().cell_width(m_space.depth());
    const Boundary_integration boundary(m_space);
    constraints.assign(3, Point_constraints(m_space));
    for(const Boundary_integration::Node& node : boundary.nodes()) {
      const Point_3 p = m_space.surface().surface_point(node.location).point;
      for(int axis = 0; axis < 3; ++axis)
        constraints[axis].add(node.location, p[axis], penalty * node.weight / h);
    }
  }
  Sparse_matrix mass;
  internal::Elliptic_system system;
  system.elliptic.reaction = 1 / time_step;
  system.elliptic.stabilization = m_options.stabilization.value_or(default_stabilization(m_space));
  system.mass = &mass;
  system.constraints = constraints.empty() ? nullptr : constraints.data();
  Poisson_solver_options of_solver;
  of_solver.tolerance = m_options.tolerance;
  of_solver.is_parallel = m_space.options().is_parallel;
  const Poisson_solver solver(moved, system, of_solver);
  const double setup_seconds = timer.time();

  Eigen::MatrixXd b = mass.selfadjointView<Eigen::Upper>() * m_positions / time_step;
  for(std::size_t axis = 0; axis < constraints.size(); ++axis)
    b.col(static_cast<Eigen::Index>(axis)) += constraints[axis].load();
  Eigen::MatrixXd positions = m_positions;
  Solve_options how;
  how.has_first_guess = true;
  Flow_report report;
  static_cast<Solve_report&>(report) = solver.solve(b, positions, how);
  report.setup_seconds = setup_seconds;
  const Eigen::MatrixXd moved_vertices = at_vertices(positions);
  report.collapse = collapse(moved_vertices);
  if(report.collapse.empty()) {
    rescale(positions, moved_vertices);
    m_positions = std::move(positions);
    m_at_vertices = at_vertices(m_positions);
    m_time += time_step;
  }
  report.time = m_time;
  measure(report);
  return report;
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_MEAN_CURVATURE_FLOW_IMPL_H
