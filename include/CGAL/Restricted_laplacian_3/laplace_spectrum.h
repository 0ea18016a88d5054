// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_LAPLACE_SPECTRUM_H
#define CGAL_RESTRICTED_LAPLACIAN_3_LAPLACE_SPECTRUM_H

#include <CGAL/Restricted_laplacian_3/Solve_report.h>
#include <CGAL/Restricted_laplacian_3/Spline_function_3.h>
#include <CGAL/Restricted_laplacian_3/Spline_functions_3.h>
#include <CGAL/Restricted_laplacian_3/Spline_space_3.h>
#include <CGAL/Restricted_laplacian_3/assemble.h>
#include <CGAL/Restricted_laplacian_3/cotangent_operators.h>
#include <CGAL/Restricted_laplacian_3/eigenpairs.h>
#include <CGAL/Restricted_laplacian_3/parameters.h>

#include <CGAL/Real_timer.h>

#include <Eigen/Core>

#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Ref
/// The low end of the spectrum of the Laplace-Beltrami operator.
struct Laplace_spectrum {
  /// \f$\lambda\f$ with \f$-\Delta u = \lambda u\f$, ascending, in units of 1 / area; the first is
  /// 0
  Eigen::VectorXd eigenvalues;
  /// Values of the eigenfunctions at the vertices: one column for each eigenvalue, rows in the
  /// order of `vertices(tm)`; NaN at vertices without a face of positive area. Their mean squares
  /// over the surface are 1 / area.
  Eigen::MatrixXd vertex_values;
  /// of the surface
  double area = 0;
  /// the algebraic problem: vectors of coefficients, residuals, shift and regularization
  Eigenpairs pairs;
  /// convergence, restarts, largest residual, times
  Solve_report report;
};

namespace internal {

inline Laplace_spectrum spectrum_of(const Operators& operators, int k) {
  CGAL::Real_timer timer;
  timer.start();
  Laplace_spectrum spectrum;
  spectrum.pairs = smallest_eigenpairs(operators.stiffness, operators.mass, k);
  spectrum.eigenvalues = spectrum.pairs.values;
  spectrum.report.converged = spectrum.pairs.converged;
  spectrum.report.iterations = spectrum.pairs.iterations;
  for(double residual : spectrum.pairs.residuals) {
    spectrum.report.relative_residuals.push_back(residual);
    spectrum.report.relative_residual = (std::max)(spectrum.report.relative_residual, residual);
  }
  spectrum.report.solve_seconds = timer.time();
  return spectrum;
}

} // namespace internal

/// \ingroup PkgRestrictedLaplacian3Ref
/// The `k` smallest eigenvalues and eigenfunctions of \f$-\Delta_{\mathcal M}\f$ on a spline space:
/// \f$S \eta = \lambda M \eta\f$ (paper, section 5.1), see `smallest_eigenpairs()`.
inline Laplace_spectrum laplace_spectrum(const Spline_space_3& space, int k) {
  CGAL::Real_timer timer;
  timer.start();
  const Operators operators = assemble_operators(space);
  const double assembly_seconds = timer.time();
  Laplace_spectrum spectrum = internal::spectrum_of(operators, k);
  spectrum.report.assembly_seconds = assembly_seconds;
  spectrum.vertex_values = Spline_functions_3(space, spectrum.pairs.vectors).values_at_vertices();
  spectrum.area = space.surface().area();
  return spectrum;
}

namespace internal {

template <class MakeSpace> Laplace_spectrum laplace_spectrum(MakeSpace&& make_space, int k) {
  CGAL::Real_timer timer;
  timer.start();
  const Spline_space_3 space = make_space();
  const double space_seconds = timer.time();
  Laplace_spectrum spectrum = Restricted_laplacian_3::laplace_spectrum(space, k);
  spectrum.report.space_seconds = space_seconds;
  return spectrum;
}

} // namespace internal

/// \ingroup PkgRestrictedLaplacian3Ref
/// The `k` smallest eigenvalues and eigenfunctions of \f$-\Delta_{\mathcal M}\f$ on a surface, with
/// the natural boundary condition if it is open.
/// \tparam FaceGraph a model of `FaceListGraph`, all of whose faces are triangles
/// \param np optional named parameters: those of `Spline_space_3`
/// \throws Input_error one of its derived classes names the face, vertex or parameter
template <class FaceGraph, class NamedParameters = parameters::Default_named_parameters,
          internal::Require_named_parameters<NamedParameters> = 0>
Laplace_spectrum laplace_spectrum(const FaceGraph& tm, int k,
                                  const NamedParameters& np = parameters::default_values()) {
  return internal::laplace_spectrum([&] { return Spline_space_3(tm, np); }, k);
}

/// \ingroup PkgRestrictedLaplacian3Ref
/// The same on a triangle soup, which need not be a manifold, nor orientable.
/// \param points a range of 3D points
/// \param triangles a range of ranges of three indices into `points`
template <class PointRange, class TriangleRange,
          class NamedParameters = parameters::Default_named_parameters,
          std::enable_if_t<!std::is_arithmetic_v<TriangleRange>, int> = 0>
Laplace_spectrum laplace_spectrum(const PointRange& points, const TriangleRange& triangles, int k,
                                  const NamedParameters& np = parameters::default_values()) {
  return internal::laplace_spectrum([&] { return Spline_space_3(points, triangles, np); }, k);
}

/// \ingroup PkgRestrictedLaplacian3Ref
/// The same with the cotangent Laplacian of the triangulation, for comparison.
/// \param np optional named parameters:
/// - `lumped_mass`: whether the mass matrix is diagonal; default `false`
/// - `vertex_point_map`: default `get_const_property_map(CGAL::vertex_point, tm)`
template <class FaceGraph, class NamedParameters = parameters::Default_named_parameters>
Laplace_spectrum cotangent_spectrum(const FaceGraph& tm, int k,
                                    const NamedParameters& np = parameters::default_values()) {
  CGAL::Real_timer timer;
  timer.start();
  const Triangulated_surface_3 surface = read_surface(tm, np);
  const double space_seconds = timer.time();
  const Operators operators = cotangent_operators(
      surface,
      parameters::choose_parameter(parameters::get_parameter(np, internal_np::lumped_mass), false));
  const double assembly_seconds = timer.time() - space_seconds;
  Laplace_spectrum spectrum = internal::spectrum_of(operators, k);
  spectrum.report.space_seconds = space_seconds;
  spectrum.report.assembly_seconds = assembly_seconds;
  spectrum.area = surface.area();
  spectrum.vertex_values = spectrum.pairs.vectors;
  const Eigen::VectorXd diagonal = operators.mass.diagonal();
  for(Eigen::Index v = 0; v < diagonal.size(); ++v)
    if(diagonal[v] == 0)
      spectrum.vertex_values.row(v).setConstant(std::numeric_limits<double>::quiet_NaN());
  return spectrum;
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_LAPLACE_SPECTRUM_H
