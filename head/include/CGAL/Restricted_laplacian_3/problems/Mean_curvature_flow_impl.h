// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_MEAN_CURVATURE_FLOW_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_MEAN_CURVATURE_FLOW_IMPL_H

#include <CGAL/Restricted_laplacian_3/assembly/Boundary_integration.h>
#include <CGAL/Restricted_laplacian_3/assembly/Point_constraints.h>
#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/problems/Function_fitter.h>
#include <CGAL/Restricted_laplacian_3/problems/Mean_curvature_flow.h>
#include <CGAL/Restricted_laplacian_3/problems/Poisson_solver.h>
#include <CGAL/Restricted_laplacian_3/problems/internal/moved_triangles.h>
#include <CGAL/Restricted_laplacian_3/problems/stabilization.h>
#include <CGAL/Restricted_laplacian_3/splines/evaluation_matrix.h>

#include <CGAL/Real_timer.h>

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
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
        const auto values =
            internal::singular_values(internal::first_corners(surface, face), corners);
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
  // the penalty dominates the residual
  constexpr double with_penalty = 0.01;
  of_solver.tolerance = m_options.tolerance * (constraints.empty() ? 1 : with_penalty);
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
  internal::measure_moved(m_space, m_at_vertices, m_is_closed, report);
  return report;
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_MEAN_CURVATURE_FLOW_IMPL_H
