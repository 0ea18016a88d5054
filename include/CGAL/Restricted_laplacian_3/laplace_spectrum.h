// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_LAPLACE_SPECTRUM_H
#define CGAL_RESTRICTED_LAPLACIAN_3_LAPLACE_SPECTRUM_H

#include <CGAL/Restricted_laplacian_3/assembly/assemble.h>
#include <CGAL/Restricted_laplacian_3/assembly/cotangent_operators.h>
#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/parameters.h>
#include <CGAL/Restricted_laplacian_3/integration/surface_integration.h>
#include <CGAL/Restricted_laplacian_3/problems/multigrid_levels.h>
#include <CGAL/Restricted_laplacian_3/solvers/Solve_report.h>
#include <CGAL/Restricted_laplacian_3/spectra/eigenpairs.h>
#include <CGAL/Restricted_laplacian_3/spectra/multigrid_eigenpairs.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_function_3.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_functions_3.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>
#include <CGAL/Restricted_laplacian_3/splines/prolongation.h>

#include <CGAL/Real_timer.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Solvers
/// How `laplace_spectrum()` computes eigenpairs: by `multigrid_eigenpairs()`, by
/// `smallest_eigenpairs()`, or by the one of them that is faster.
enum class Eigensolver { automatic, multigrid, shift_invert };

/// \ingroup PkgRestrictedLaplacian3Solvers
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
  /// the algebraic problem: vectors of coefficients, residuals, shift and regularisation
  Eigenpairs pairs;
  /// convergence, iterations, largest residual, times
  Solve_report report;
};

/// \ingroup PkgRestrictedLaplacian3Solvers
/// The factor \f$c\f$ of the stabilisation of the stiffness matrix, see `assemble_operators()`,
/// that `laplace_spectrum()` uses unless told otherwise: 1e-5, and 0 in the space of the paper.
/// With it `multigrid_eigenpairs()` needs few iterations on any surface, while eigenvalues change
/// by no more than the discretisation changes them.
inline double default_spectrum_stabilization(const Spline_space_3& space) {
  return space.is_paper_space() ? 0 : 1e-5;
}

namespace internal {

/// sets eigenvalues and report
inline void take_pairs(Eigenpairs&& pairs, Laplace_spectrum& spectrum) {
  spectrum.pairs = std::move(pairs);
  spectrum.eigenvalues = spectrum.pairs.values;
  spectrum.report.converged = spectrum.pairs.converged;
  spectrum.report.iterations = spectrum.pairs.iterations;
  for(double residual : spectrum.pairs.residuals) {
    spectrum.report.relative_residuals.push_back(residual);
    spectrum.report.relative_residual = (std::max)(spectrum.report.relative_residual, residual);
  }
}

/// Whether `multigrid_eigenpairs()` is used. With fewer unknowns a factorisation is as fast.
inline bool uses_multigrid(const Spline_space_3& space, Eigensolver eigensolver,
                           double normal_stabilization) {
  constexpr std::size_t smallest_dimension = 5000;
  if(eigensolver == Eigensolver::multigrid && space.is_paper_space())
    throw Parameter_error("eigensolver", "must not be multigrid in the space of the paper, whose "
                                         "levels are not nested");
  return eigensolver == Eigensolver::multigrid ||
         (eigensolver == Eigensolver::automatic && !space.is_paper_space() &&
          normal_stabilization > 0 && space.dimension() >= smallest_dimension);
}

inline Eigenpairs multigrid_eigenpairs_of(const Spline_space_3& space, int coarsest,
                                          std::vector<Operators> operators, int k,
                                          const Multigrid_eigenpairs_options& options) {
  std::vector<Sparse_matrix> stiffness(operators.size()), mass(operators.size());
  for(std::size_t i = 0; i < operators.size(); ++i) {
    stiffness[i].swap(operators[i].stiffness);
    mass[i].swap(operators[i].mass);
  }
  Multigrid_levels levels = multigrid_levels(space, coarsest);
  return multigrid_eigenpairs(std::move(stiffness), std::move(mass),
                              std::move(levels.prolongations), std::move(levels.patches), k,
                              options);
}

} // namespace internal

/// \ingroup PkgRestrictedLaplacian3Solvers
/// The `k` smallest eigenvalues and eigenfunctions of \f$-\Delta_{\mathcal M}\f$ on a spline space:
/// \f$S \eta = \lambda M \eta\f$ (paper, section 5.1), without values at the vertices: the member
/// `vertex_values` remains empty.
/// \param space the space; its finest level is used
/// \param k number of pairs, positive
/// \param integration a model of `SurfaceIntegration_3`
/// \param np optional named parameters:
/// - `eigensolver`: `Eigensolver::multigrid`, `Eigensolver::shift_invert`, or (default)
///   `Eigensolver::automatic`, which takes the former from 5,000 unknowns on
/// - `relative_tolerance`: for the residuals of `Eigensolver::multigrid`; default 1e-3, which
///   makes eigenvalues exact to about 1e-6. Those of `Eigensolver::shift_invert` are always near
///   1e-8.
/// - `number_of_iterations`: of `Eigensolver::multigrid` on a level, at most; default 100
/// - `normal_stabilization`: factor \f$c\f$ of `assemble_operators()`, for the stiffness matrix;
///   default `default_spectrum_stabilization()`
/// - `callback`: a function object that is called with the part of the eigensolver's work that is
///   done, from 0 to 1, and returns `false` to end it with a `Canceled` exception
/// \throws Parameter_error if a parameter is outside its domain
/// \throws Numerical_error if a factorisation fails
template <class SurfaceIntegration, class NamedParameters = parameters::Default_named_parameters,
          internal::Require_no_named_parameters<SurfaceIntegration> = 0>
Laplace_spectrum laplace_eigenpairs(const Spline_space_3& space, int k,
                                    const SurfaceIntegration& integration,
                                    const NamedParameters& np = parameters::default_values()) {
  using parameters::choose_parameter;
  using parameters::get_parameter;
  if(k < 1)
    throw Parameter_error("k", "is " + std::to_string(k) + ", but must be positive");
  const double stabilization = choose_parameter(
      get_parameter(np, internal_np::normal_stabilization), default_spectrum_stabilization(space));
  const std::function<bool(double)> callback =
      choose_parameter(get_parameter(np, internal_np::callback), std::function<bool(double)>());
  const bool is_multigrid = internal::uses_multigrid(
      space, choose_parameter(get_parameter(np, internal_np::eigensolver), Eigensolver::automatic),
      stabilization);

  Laplace_spectrum spectrum;
  CGAL::Real_timer timer;
  timer.start();
  const int coarsest = is_multigrid ? internal::coarsest_multigrid_level(space) : space.depth();
  std::vector<Operators> operators = assemble_operators(space, coarsest, space.depth(), integration,
                                                        stabilization, Stabilized::stiffness);
  spectrum.report.assembly_seconds = timer.time();
  if(is_multigrid) {
    Multigrid_eigenpairs_options options;
    options.relative_tolerance = choose_parameter(
        get_parameter(np, internal_np::relative_tolerance), options.relative_tolerance);
    options.maximum_iterations = choose_parameter(
        get_parameter(np, internal_np::number_of_iterations), options.maximum_iterations);
    options.is_parallel = space.options().is_parallel;
    options.callback = callback;
    internal::take_pairs(
        internal::multigrid_eigenpairs_of(space, coarsest, std::move(operators), k, options),
        spectrum);
  } else {
    Eigenpairs_options options;
    options.callback = callback;
    internal::take_pairs(smallest_eigenpairs(operators[0].stiffness, operators[0].mass, k, options),
                         spectrum);
  }
  spectrum.report.solve_seconds = timer.time() - spectrum.report.assembly_seconds;
  spectrum.area = space.surface().area();
  return spectrum;
}

/// \ingroup PkgRestrictedLaplacian3Problems
/// The `k` smallest eigenvalues and eigenfunctions of \f$-\Delta_{\mathcal M}\f$ on a spline space.
/// Parameters and exceptions are those of `laplace_eigenpairs()`.
template <class SurfaceIntegration, class NamedParameters = parameters::Default_named_parameters,
          internal::Require_no_named_parameters<SurfaceIntegration> = 0>
Laplace_spectrum laplace_spectrum(const Spline_space_3& space, int k,
                                  const SurfaceIntegration& integration,
                                  const NamedParameters& np = parameters::default_values()) {
  Laplace_spectrum spectrum = laplace_eigenpairs(space, k, integration, np);
  spectrum.vertex_values = Spline_functions_3(space, spectrum.pairs.vectors).values_at_vertices();
  return spectrum;
}

/// \ingroup PkgRestrictedLaplacian3Problems
/// The same by cubature.
template <class NamedParameters = parameters::Default_named_parameters,
          internal::Require_named_parameters<NamedParameters> = 0>
Laplace_spectrum laplace_spectrum(const Spline_space_3& space, int k,
                                  const NamedParameters& np = parameters::default_values()) {
  return laplace_spectrum(space, k, Cubature(space), np);
}

namespace internal {

template <class MakeSpace, class NamedParameters>
Laplace_spectrum laplace_spectrum_of(MakeSpace&& make_space, int k, const NamedParameters& np) {
  CGAL::Real_timer timer;
  timer.start();
  const Spline_space_3 space = make_space();
  const double space_seconds = timer.time();
  Laplace_spectrum spectrum = laplace_spectrum(space, k, np);
  spectrum.report.space_seconds = space_seconds;
  return spectrum;
}

} // namespace internal

/// \ingroup PkgRestrictedLaplacian3Problems
/// The `k` smallest eigenvalues and eigenfunctions of \f$-\Delta_{\mathcal M}\f$ on a surface, with
/// the natural boundary condition if it is open.
/// \tparam FaceGraph a model of `FaceListGraph`, all of whose faces are triangles
/// \param tm the surface, a mesh or a range of oriented points
/// \param k number of pairs, positive
/// \param np optional named parameters: those of `Spline_space_3` and of `laplace_eigenpairs()`
/// \throws Input_error one of its derived classes names the face, vertex or parameter
template <class FaceGraph, class NamedParameters = parameters::Default_named_parameters,
          internal::Require_named_parameters<NamedParameters> = 0>
Laplace_spectrum laplace_spectrum(const FaceGraph& tm, int k,
                                  const NamedParameters& np = parameters::default_values()) {
  return internal::laplace_spectrum_of([&] { return Spline_space_3(tm, np); }, k, np);
}

/// \ingroup PkgRestrictedLaplacian3Problems
/// The same on a triangle soup, which need not be a manifold, nor orientable.
/// \param points a range of 3D points
/// \param triangles a range of ranges of three indices into `points`
/// \param k number of pairs, positive
/// \param np as above, without the vertex point map
template <class PointRange, class TriangleRange,
          class NamedParameters = parameters::Default_named_parameters,
          std::enable_if_t<!std::is_arithmetic_v<TriangleRange>, int> = 0>
Laplace_spectrum laplace_spectrum(const PointRange& points, const TriangleRange& triangles, int k,
                                  const NamedParameters& np = parameters::default_values()) {
  return internal::laplace_spectrum_of([&] { return Spline_space_3(points, triangles, np); }, k,
                                       np);
}

/// \ingroup PkgRestrictedLaplacian3Problems
/// The same with the cotangent Laplacian of the triangulation, for comparison.
/// \param tm the surface, a mesh of triangles
/// \param k number of pairs, positive
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
  Laplace_spectrum spectrum;
  internal::take_pairs(smallest_eigenpairs(operators.stiffness, operators.mass, k), spectrum);
  spectrum.report.space_seconds = space_seconds;
  spectrum.report.assembly_seconds = assembly_seconds;
  spectrum.report.solve_seconds = timer.time() - space_seconds - assembly_seconds;
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
