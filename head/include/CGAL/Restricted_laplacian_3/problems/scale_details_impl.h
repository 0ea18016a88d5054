// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_SCALE_DETAILS_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_SCALE_DETAILS_IMPL_H

#include <CGAL/Restricted_laplacian_3/assembly/assemble.h>
#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Progress.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parallel_for.h>
#include <CGAL/Restricted_laplacian_3/problems/Diffusion_solver.h>
#include <CGAL/Restricted_laplacian_3/problems/internal/Linear_signal.h>
#include <CGAL/Restricted_laplacian_3/problems/internal/solver_for_editing.h>
#include <CGAL/Restricted_laplacian_3/problems/scale_details.h>

#include <CGAL/Real_timer.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

constexpr double pi_of_details = 3.14159265358979323846;

/// the weight \f$\alpha = (2 \pi / \ell)^2\f$ of a wavelength
inline double weight_of_length(double length) {
  if(!(length > 0 && std::isfinite(length)))
    throw Parameter_error("length", "is " + std::to_string(length) + ", but must be positive");
  return 4 * pi_of_details * pi_of_details / (length * length);
}

/// The normals of the faces of a surface, as a filter sees them.
class Normal_filter {
public:
  Normal_filter(const Triangulated_surface_3& surface, bool is_parallel)
    : m_is_parallel(is_parallel) {
    const std::size_t number = surface.number_of_faces();
    normals.assign(number, Eigen::Vector3d::Zero());
    m_centers.resize(number);
    m_areas.assign(number, 0);
    m_triangles.reserve(number);
    std::vector<std::size_t> first(surface.number_of_vertices() + 1, 0);
    for(std::size_t face = 0; face < number; ++face) {
      m_triangles.push_back(surface.triangle(face));
      m_centers[face].setZero();
      if(surface.is_degenerate(face))
        continue;
      std::array<Eigen::Vector3d, 3> p;
      for(int i = 0; i < 3; ++i) {
        p[i] = eigen_vector(surface.point(face, i));
        m_centers[face] += p[i] / 3;
        ++first[m_triangles[face][i] + 1];
      }
      normals[face] = (p[1] - p[0]).cross(p[2] - p[0]).normalized();
      m_areas[face] = surface.area(face);
    }
    for(std::size_t v = 1; v < first.size(); ++v)
      first[v] += first[v - 1];
    m_faces_at.resize(first.back());
    m_first_at = first;
    for(std::size_t face = 0; face < number; ++face)
      if(m_areas[face] > 0)
        for(const std::uint32_t v : m_triangles[face])
          m_faces_at[first[v]++] = static_cast<std::uint32_t>(face);
    measure();
  }

  /// how far a step spreads along one axis: the mean square
  double spread() const { return m_spread; }

  /// one step
  /// \param chord difference of normals at which the weight is \f$e^{-1/2}\f$
  void step(double chord) {
    std::vector<Eigen::Vector3d> result(normals.size(), Eigen::Vector3d::Zero());
    parallel_for(m_is_parallel, 0, normals.size(), 1024, [&](std::size_t begin, std::size_t end) {
      for(std::size_t face = begin; face < end; ++face) {
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        for_each_neighbor(face, [&](std::uint32_t other, double weight) {
          const double square = (normals[face] - normals[other]).squaredNorm();
          sum += weight * std::exp(-square / (2 * chord * chord)) * normals[other];
        });
        if(sum.squaredNorm() > 0)
          result[face] = sum.normalized();
      }
    });
    normals.swap(result);
  }

  std::vector<Eigen::Vector3d> normals; // zero for a face without an area

private:
  /// Calls `visit(other, weight)` for each face that shares a vertex with a face, once for each
  /// such vertex, and for itself. Not by the centers of large fans, whose faces are neighbors of
  /// each other at their other vertices.
  template <class Visitor> void for_each_neighbor(std::size_t face, const Visitor& visit) const {
    constexpr std::size_t large = 100;
    if(!(m_areas[face] > 0))
      return;
    for(const std::uint32_t v : m_triangles[face]) {
      const std::size_t begin = m_first_at[v], end = m_first_at[v + 1];
      for(std::size_t i = begin; i < end && end - begin <= large; ++i) {
        const std::uint32_t other = m_faces_at[i];
        const double square = (m_centers[face] - m_centers[other]).squaredNorm();
        visit(other, m_areas[other] * std::exp(-square / (2 * m_distance * m_distance)));
      }
    }
  }

  /// the mean distance of neighbors, and the spread
  void measure() {
    double sum = 0, squares = 0;
    std::size_t number = 0;
    m_distance = 1;
    for(std::size_t face = 0; face < normals.size(); ++face)
      for_each_neighbor(face, [&](std::uint32_t other, double) {
        const double distance = (m_centers[face] - m_centers[other]).norm();
        sum += distance;
        number += distance > 0;
      });
    m_distance = number > 0 ? sum / static_cast<double>(number) : 1;
    double weights = 0;
    for(std::size_t face = 0; face < normals.size(); ++face) {
      double own_squares = 0, own_weights = 0;
      for_each_neighbor(face, [&](std::uint32_t other, double weight) {
        own_squares += weight * (m_centers[face] - m_centers[other]).squaredNorm();
        own_weights += weight;
      });
      if(own_weights > 0) {
        squares += m_areas[face] * own_squares / own_weights;
        weights += m_areas[face];
      }
    }
    m_spread = weights > 0 ? squares / weights / 2 : 0;
  }

  bool m_is_parallel;
  std::vector<Triangulated_surface_3::Triangle> m_triangles;
  std::vector<Eigen::Vector3d> m_centers;
  std::vector<double> m_areas;
  std::vector<std::uint32_t> m_faces_at; // around each vertex
  std::vector<std::size_t> m_first_at;
  double m_distance = 1, m_spread = 0;
};

/// The rotation that takes a unit vector to another one, by the shortest way, transposed and less
/// the identity: what it changes of the gradients of coordinates.
inline Eigen::Matrix3d turn_of_gradients(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  constexpr double opposite = 1e-6;
  const double cosine = from.dot(to);
  if(from.squaredNorm() == 0 || to.squaredNorm() == 0 || !(1 + cosine > opposite))
    return Eigen::Matrix3d::Zero();
  const Eigen::Vector3d axis = from.cross(to);
  Eigen::Matrix3d cross;
  cross << 0, -axis[2], axis[1], axis[2], 0, -axis[0], -axis[1], axis[0], 0;
  return (cross + cross * cross / (1 + cosine)).transpose();
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Spline_space_3
space_for_details(const Spline_space_3& space, bool has_depth, const Editing_options& options) {
  const Triangulated_surface_3& surface = space.surface();
  surface.require_triangles("smooth_surface");
  if(has_depth || !options.crease_angle)
    return space;
  const double of_face = surface.area() / static_cast<double>(surface.number_of_faces()),
               edge = std::sqrt(4 / std::sqrt(3.) * of_face);
  constexpr int largest_depth = 10; // more would be by mistake
  Spline_space_options deeper = space.options();
  deeper.depth = space.depth();
  while(*deeper.depth < largest_depth && space.octree().cell_width(*deeper.depth) > edge / 2)
    ++*deeper.depth;
  return *deeper.depth == space.depth() ? space : Spline_space_3(surface, deeper);
}

} // namespace internal

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Edited_signal scale_details(const Spline_space_3& space,
                                                               double length, double factor,
                                                               const Editing_options& options,
                                                               const Eigen::MatrixXd& signal) {
  space.surface().require_triangles("scale_details");
  const double alpha = internal::weight_of_length(length);
  if(!std::isfinite(factor))
    throw Parameter_error("factor", "is not a finite number");
  CGAL::Real_timer timer;
  timer.start();
  const internal::Linear_signal x(space, signal);
  Diffusion_options of_filter;
  of_filter.tolerance = options.tolerance;
  of_filter.stabilization = options.stabilization;
  const Diffusion_solver filter(space, 4 / alpha, of_filter);
  const double setup_seconds = timer.time();
  const Eigen::MatrixXd loads = x.loads(), gradient_loads = x.gradient_loads(),
                        flux_loads = x.flux_loads();
  Edited_signal result;
  const double assembly_seconds = timer.time() - setup_seconds;
  const Diffused_functions smooth =
      filter.low_pass(loads, gradient_loads, flux_loads, options.progress);
  static_cast<Solve_report&>(result) = smooth;
  result.assembly_seconds = assembly_seconds;
  const Eigen::MatrixXd values =
      internal::values_at_vertices_or(space, smooth.coefficients, x.values());
  result.values = values + factor * (x.values() - values);
  return result;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Edited_signal
smooth_between_creases(const Spline_space_3& space, double length, const Editing_options& options) {
  const Triangulated_surface_3& surface = space.surface();
  surface.require_triangles("smooth_between_creases");
  constexpr double attached = 4; // the positions remain over this many lengths
  const double alpha = internal::weight_of_length(attached * length);
  const double angle = options.crease_angle.value_or(180);
  if(!(angle > 0 && angle <= 180))
    throw Parameter_error("crease_angle", "is " + std::to_string(angle) +
                                              ", but must be between 0 and 180 degrees");
  CGAL::Real_timer timer;
  timer.start();
  const internal::Progress progress(options.progress);
  progress(0);
  internal::Normal_filter filter(surface, space.options().is_parallel);
  const std::vector<Eigen::Vector3d> first = filter.normals;
  // a Gaussian that halves waves of the length
  const double deviation = length * std::sqrt(2 * std::log(2.)) / (2 * internal::pi_of_details),
               chord = std::sin(angle / 2 * internal::pi_of_details / 180);
  constexpr double most_steps = 1000;
  const double steps =
      filter.spread() > 0
          ? std::clamp(std::round(deviation * deviation / filter.spread()), 1., most_steps)
          : 0;
  for(int i = 0; i < static_cast<int>(steps); ++i) {
    filter.step(chord);
    progress(0.5 * (i + 1) / steps);
  }
  std::vector<Eigen::Matrix3d> turns(first.size());
  for(std::size_t face = 0; face < turns.size(); ++face)
    turns[face] = internal::turn_of_gradients(first[face], filter.normals[face]);
  const auto turn = [&](const Surface_point& p) -> const Eigen::Matrix3d& { return turns[p.face]; };
  const Eigen::MatrixXd loads = assemble_gradient_loads(space, function_of_degree(turn, 0));
  Edited_signal result;
  const double assembly_seconds = timer.time();
  const Poisson_solver solver = internal::solver_for_editing(space, alpha, options);
  Eigen::MatrixXd change;
  static_cast<Solve_report&>(result) = solver.solve(loads, change);
  result.assembly_seconds = assembly_seconds;
  const internal::Linear_signal x(space, {});
  result.values = x.values() + internal::values_at_vertices_or(
                                   space, change, Eigen::MatrixXd::Zero(x.values().rows(), 3));
  progress(1);
  return result;
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_SCALE_DETAILS_IMPL_H
