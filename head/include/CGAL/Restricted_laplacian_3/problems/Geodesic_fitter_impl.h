// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_GEODESIC_FITTER_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_GEODESIC_FITTER_IMPL_H

#include <CGAL/Restricted_laplacian_3/assembly/shared/sheet_loads.h>
#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Progress.h>
#include <CGAL/Restricted_laplacian_3/integration/Integration_nodes.h>
#include <CGAL/Restricted_laplacian_3/integration/shared/Cell_load.h>
#include <CGAL/Restricted_laplacian_3/problems/Geodesic_fitter.h>
#include <CGAL/Restricted_laplacian_3/problems/stabilization.h>

#include <CGAL/Real_timer.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <utility>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// \f$\alpha\f$ of a `Geodesic_fitter`: a wave of 28 cells weighs as much by its values as by its
/// gradients, \f$2 \pi / \sqrt{0.05} = 28\f$; longer ones by their values
inline double weight_of_distances(const Spline_space_3& space) {
  const double h = space.octree().cell_width(space.depth());
  return 0.05 / (h * h);
}

inline Poisson_solver geodesic_fit_solver(const Spline_space_3& space,
                                          Geodesic_fit_options options) {
  if(!options.solver.tolerance)
    options.solver.tolerance = Geodesic_fitter::default_tolerance;
  Elliptic_system system;
  system.elliptic.reaction = weight_of_distances(space);
  system.elliptic.stabilization = options.stabilization.value_or(default_stabilization(space));
  return Poisson_solver(space, system, options.solver);
}

/// \f$\int g \cdot \nabla b_i + \alpha \int d\, b_i\f$
inline Eigen::MatrixXd geodesic_loads(const Spline_space_3& space, const Geodesic_function& d,
                                      double alpha) {
  // Neither the distance nor its gradient is a polynomial: three nodes on a piece of a triangle in
  // a cell resolve them as well as the space does.
  constexpr int degree = 2;
  const double h = space.octree().cell_width(space.depth());
  return sum_loads(space, space.depth(), 1, h, [&](std::size_t sheet, Cell_load::Load* load) {
    std::array<Cell_load, 4> moments; // three of the gradient, one of the distance
    std::array<Geodesic_function::Value, Integration_node_block::capacity> values;
    space.integration().visit_nodes(sheet, degree, [&](Integration_node_block& block) {
      d.evaluate(block.points.data(), block.size, values.data());
      std::array<Node_values, 4> weighted = {};
      for(std::size_t i = 0; i < block.size; ++i) {
        const auto& [distance, g] = values[i];
        if(std::isinf(distance))
          continue;
        const auto flux = product(block.metrics[i], g.x(), g.y(), g.z());
        for(std::size_t k = 0; k < 3; ++k)
          weighted[k][i] = block.weights[i] * flux[k];
        weighted[3][i] = block.weights[i] * alpha * h * distance;
      }
      for(std::size_t k = 0; k < 4; ++k)
        moments[k].add(block.positions, weighted[k]);
    });
    for(int axis = 0; axis < 3; ++axis)
      moments[axis].add_derivatives_to(axis, *load);
    moments[3].add_values_to(*load);
  });
}

} // namespace internal

CGAL_RESTRICTED_LAPLACIAN_3_INLINE
Geodesic_spline::Geodesic_spline(Geodesic_function function, Spline_function_3 spline,
                                 Solve_report report)
  : m_function(std::move(function)), m_spline(std::move(spline)), m_report(std::move(report)) {}

/// 1 up to three cells, 0 from four on, and a cubic between
CGAL_RESTRICTED_LAPLACIAN_3_INLINE Geodesic_spline::Weight
Geodesic_spline::weight_of_function(double distance) const {
  const double h = m_spline.space().octree().cell_width(m_spline.level()),
               t = std::clamp(4 - distance / h, 0., 1.);
  return {t * t * (3 - 2 * t), 6 * t * (t - 1) / h};
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE double
Geodesic_spline::value(const Surface_location& location) const {
  const double d = m_function.value(location), w = weight_of_function(d).value;
  if(std::isinf(d) || w == 1)
    return d;
  return w * d + (1 - w) * m_spline.value(location);
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Vector_3
Geodesic_spline::gradient(const Surface_location& location) const {
  const double d = m_function.value(location);
  const Weight w = weight_of_function(d);
  if(std::isinf(d))
    return CGAL::NULL_VECTOR;
  const Vector_3 of_spline = m_spline.gradient(location);
  if(w.value == 0)
    return of_spline;
  const double jump = w.derivative != 0 ? d - m_spline.value(location) : 0;
  return (w.value + w.derivative * jump) * m_function.gradient(location) +
         (1 - w.value) * of_spline;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE
Geodesic_fitter::Geodesic_fitter(const Spline_space_3& space, const Geodesic_fit_options& options)
  : m_space(space.with_material({})), m_solver(internal::geodesic_fit_solver(m_space, options)) {}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Geodesic_spline Geodesic_fitter::fit(
    const Geodesic_function& d, const std::function<bool(double)>& callback) const {
  const Triangulated_surface_3 &surface = m_space.surface(), &of_d = d.surface();
  if(surface.number_of_faces() != of_d.number_of_faces() ||
     surface.number_of_vertices() != of_d.number_of_vertices())
    throw Parameter_error("d", "is not a distance on the surface of the space");
  CGAL::Real_timer timer;
  timer.start();
  const internal::Progress progress(callback);
  progress(0);
  const Eigen::MatrixXd loads =
      internal::geodesic_loads(m_space, d, internal::weight_of_distances(m_space));
  const double assembly_seconds = timer.time();
  Eigen::MatrixXd x;
  Solve_options options;
  options.progress = progress.part(0.5, 1).callback();
  Solve_report report = m_solver.solve(loads, x, options);
  report.assembly_seconds = assembly_seconds;
  return Geodesic_spline(d, Spline_function_3(m_space, x.col(0)), report);
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_GEODESIC_FITTER_IMPL_H
