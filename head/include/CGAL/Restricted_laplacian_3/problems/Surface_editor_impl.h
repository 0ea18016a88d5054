// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_SURFACE_EDITOR_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_SURFACE_EDITOR_IMPL_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/problems/Curvature_field.h>
#include <CGAL/Restricted_laplacian_3/problems/Surface_editor.h>
#include <CGAL/Restricted_laplacian_3/problems/internal/Linear_signal.h>
#include <CGAL/Restricted_laplacian_3/problems/internal/solver_for_editing.h>

#include <CGAL/Real_timer.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

inline const Spline_space_3& checked_space_to_edit(const Spline_space_3& space, double alpha) {
  space.surface().require_triangles("Surface_editor");
  if(!(alpha > 0 && std::isfinite(alpha)))
    throw Parameter_error("alpha", "is " + std::to_string(alpha) + ", but must be positive");
  return space;
}

/// a function in the vertices: in the corner of a face with an area, if there is one
inline Eigen::VectorXd values_in_corners(const Triangulated_surface_3& surface,
                                         const Surface_function_view& f, double elsewhere) {
  Eigen::VectorXd result =
      Eigen::VectorXd::Constant(static_cast<Eigen::Index>(surface.number_of_vertices()), elsewhere);
  std::vector<bool> is_known(surface.number_of_vertices(), false);
  for(std::size_t face = 0; face < surface.number_of_faces(); ++face)
    for(int i = 0; i < 3 && !surface.is_degenerate(face); ++i) {
      const std::uint32_t v = surface.triangle(face)[i];
      if(is_known[v])
        continue;
      is_known[v] = true;
      Surface_location corner;
      corner.face = face;
      corner.barycentric.fill(0);
      corner.barycentric[i] = 1;
      const Surface_point point = surface.surface_point(corner);
      f(&point, 1, &result[v]);
    }
  return result;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Spline_space_3 space_to_edit(const Spline_space_3& space,
                                                                double alpha,
                                                                const Editing_options& options) {
  checked_space_to_edit(space, alpha);
  if(options.anisotropic == 0)
    return space;
  if(!space.material().is_trivial())
    throw Parameter_error("anisotropic", "is given, but the space has a metric of its own");
  if(!(options.anisotropic > 0 && std::isfinite(options.anisotropic)))
    throw Parameter_error("anisotropic", "is " + std::to_string(options.anisotropic) +
                                             ", but must be a finite number that is not negative");
  return space.with_material(
      normal_metric(estimate_curvature(space), options.anisotropic / std::sqrt(alpha)));
}

} // namespace internal

CGAL_RESTRICTED_LAPLACIAN_3_INLINE
Surface_editor::Surface_editor(const Spline_space_3& space, double alpha,
                               const Editing_options& options, const Eigen::MatrixXd& signal)
  : m_space(internal::checked_space_to_edit(space, alpha)),
    m_solver(internal::solver_for_editing(space, alpha, options)) {
  CGAL::Real_timer timer;
  timer.start();
  const internal::Linear_signal x(space, signal);
  m_signal = x.values();
  m_gradient_loads = x.gradient_loads();
  const Eigen::MatrixXd loads = alpha * x.loads();
  m_setup.set_status(Solve_status::converged);
  m_setup.setup_seconds = m_solver.setup_seconds();
  m_setup.assembly_seconds = timer.time();
  m_smooth = internal::values_at_vertices_or(space, solve(loads, m_setup), m_signal);
  m_same = solve(loads + m_gradient_loads, m_setup);
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Eigen::MatrixXd
Surface_editor::solve(const Eigen::MatrixXd& loads, Solve_report& report) const {
  Eigen::MatrixXd x;
  const Solve_report of_systems = m_solver.solve(loads, x);
  report.worsen_status(of_systems.status);
  report.iterations += of_systems.iterations;
  report.relative_residual = (std::max)(report.relative_residual, of_systems.relative_residual);
  report.solve_seconds += of_systems.solve_seconds;
  return x;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Edited_signal Surface_editor::edit(double gradient_scale) const {
  if(!std::isfinite(gradient_scale))
    throw Parameter_error("gradient_scale", "is not a finite number");
  Edited_signal result{m_setup, {}};
  result.values = m_smooth + gradient_scale * (m_signal - m_smooth);
  return result;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Edited_signal
Surface_editor::edit(const Surface_function_view& gradient_scale) const {
  if(gradient_scale.components() != 1)
    throw Parameter_error("gradient_scale", "must be a number");
  const Triangulated_surface_3& surface = m_space.surface();
  const Eigen::VectorXd scales = internal::values_in_corners(surface, gradient_scale, 1);
  for(Eigen::Index v = 0; v < scales.size(); ++v)
    if(!std::isfinite(scales[v]))
      throw Parameter_error("gradient_scale", "is not finite at vertex " + std::to_string(v));
  Edited_signal result{m_setup, {}};
  const internal::Linear_signal x(m_space, m_signal);
  const Eigen::MatrixXd change =
      solve(x.gradient_loads(&gradient_scale) - m_gradient_loads, result);
  const Eigen::MatrixXd same = internal::values_at_vertices_or(m_space, m_same, m_signal),
                        zero = Eigen::MatrixXd::Zero(m_signal.rows(), m_signal.cols());
  result.values = same + scales.asDiagonal() * (m_signal - same) +
                  internal::values_at_vertices_or(m_space, change, zero);
  return result;
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_SURFACE_EDITOR_IMPL_H
