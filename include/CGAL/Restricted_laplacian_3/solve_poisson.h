// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SOLVE_POISSON_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SOLVE_POISSON_H

#include <CGAL/Restricted_laplacian_3/Poisson_solver.h>
#include <CGAL/Restricted_laplacian_3/Spline_function_3.h>
#include <CGAL/Restricted_laplacian_3/Spline_space_3.h>
#include <CGAL/Restricted_laplacian_3/assemble.h>
#include <CGAL/Restricted_laplacian_3/parameters.h>
#include <CGAL/Restricted_laplacian_3/prolongation.h>

#include <CGAL/Real_timer.h>

#include <cmath>
#include <string>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Restricted_laplacian_3 {

namespace internal {

template <class NamedParameters>
Poisson_solver_options poisson_solver_options(const NamedParameters& np) {
  using parameters::choose_parameter;
  using parameters::get_parameter;
  Poisson_solver_options options;
  options.relative_tolerance = choose_parameter(get_parameter(np, internal_np::relative_tolerance),
                                                options.relative_tolerance);
  options.maximum_iterations = choose_parameter(
      get_parameter(np, internal_np::number_of_iterations), options.maximum_iterations);
  options.cycle = choose_parameter(get_parameter(np, internal_np::cycle), options.cycle);
  options.smoothing_steps =
      choose_parameter(get_parameter(np, internal_np::smoothing_steps), options.smoothing_steps);
  options.stand_alone_multigrid = choose_parameter(
      get_parameter(np, internal_np::stand_alone_multigrid), options.stand_alone_multigrid);
  return options;
}

/// The coarsest level of a hierarchy: the finest one whose dense factorization takes no time that
/// counts. It is done for each connected component of the surface, which is a sheet of level 0.
inline int coarsest_multigrid_level(const Spline_space_3& space) {
  constexpr double largest_dense_dimension = 300;
  const double components = static_cast<double>(space.octree().number_of_sheets(0));
  int level = 0;
  while(level < space.depth() && static_cast<double>(space.dimension(level + 1)) <=
                                     largest_dense_dimension * std::sqrt(components))
    ++level;
  return level;
}

/// a function object on `Surface_point` is taken as it is, a vertex property map is interpolated
template <class FaceGraph, class Function>
auto surface_function(const FaceGraph& tm, const Function& f) {
  if constexpr(std::is_invocable_v<const Function&, const Surface_point&>)
    return f;
  else
    return vertex_function(tm, f);
}

template <class FaceGraph, class Function, class VertexMap, class NamedParameters>
Solve_report solve_poisson(const FaceGraph& tm, const Function& f, double alpha, VertexMap u,
                           const NamedParameters& np);

} // namespace internal

/// \ingroup PkgRestrictedLaplacian3Ref
/// A solver for \f$(S + \alpha M)\, \eta = b\f$ on the finest level of a space.
/// \param alpha screening weight, at least 0, in units of 1 / area
/// \param operators the matrices of the finest level of `space`
/// \param np optional named parameters:
/// - `relative_tolerance`: of the residual; default 1e-3
/// - `number_of_iterations`: at most; default 1000
/// - `cycle`: `Cycle::V` (default) or `Cycle::W`
/// - `smoothing_steps`: before, and again after the coarse correction; default 1
/// - `stand_alone_multigrid`: iterate cycles, instead of preconditioning conjugate gradients with
///   them; default `false`
/// \throws Parameter_error if a parameter is outside its domain
template <class NamedParameters = parameters::Default_named_parameters>
Poisson_solver make_poisson_solver(const Spline_space_3& space, const Operators& operators,
                                   double alpha = 0,
                                   const NamedParameters& np = parameters::default_values()) {
  if(!(alpha >= 0 && std::isfinite(alpha)))
    throw Parameter_error("alpha", "is " + std::to_string(alpha) +
                                       ", but must be a finite number that is not negative");
  const Eigen::VectorXd integrals =
      space.is_paper_space()
          ? assemble_element_integrals(space)
          : Eigen::VectorXd(operators.mass * Eigen::VectorXd::Ones(operators.mass.cols()));
  // The patterns are the same, so values can be added without a merge.
  Sparse_matrix a = operators.stiffness;
  if(alpha > 0)
    a.coeffs() += alpha * operators.mass.coeffs();
  return Poisson_solver(std::move(a),
                        prolongation_matrices(space, internal::coarsest_multigrid_level(space)),
                        integrals, alpha, internal::poisson_solver_options(np));
}

/// \ingroup PkgRestrictedLaplacian3Ref
/// Solves the Poisson problem \f$\Delta_{\mathcal M} u = f\f$ on a surface (paper, equation 1), in
/// the form \f$S \eta = -\phi\f$ (the stiffness matrix \f$S\f$ is minus the matrix \f$L\f$ of the
/// paper).
///
/// On a closed surface, and on an open one with the natural boundary condition
/// \f$\partial u / \partial \nu = 0\f$, which holds here, a solution exists only if \f$f\f$ has
/// mean 0: its mean is subtracted. The solution has surface mean 0.
/// Both hold on each component of the surface, where two components that come within three cells of
/// each other count as one.
///
/// \tparam FaceGraph a model of `FaceListGraph`, all of whose faces are triangles
/// \param f a model of `ReadablePropertyMap` with the vertex descriptor as key and a number as
/// value, interpolated linearly; or a function object that takes a `const Surface_point&` and
/// returns a number
/// \param u a model of `WritablePropertyMap` with the vertex descriptor as key and a floating-point
/// number as value, receives the solution; NaN at vertices without a face of positive area
/// \param np optional named parameters: those of `Spline_space_3` and `make_poisson_solver()`
/// \return whether the solver converged, iterations, residual, times
/// \throws Input_error one of its derived classes names the face, vertex or parameter
///
/// Takes time and memory proportional to the number of triangles plus the number of elements, times
/// the number of iterations.
template <class FaceGraph, class Function, class VertexMap,
          class NamedParameters = parameters::Default_named_parameters>
Solve_report solve_poisson(const FaceGraph& tm, const Function& f, VertexMap u,
                           const NamedParameters& np = parameters::default_values()) {
  return internal::solve_poisson(tm, f, 0, u, np);
}

/// \ingroup PkgRestrictedLaplacian3Ref
/// Solves the screened Poisson problem \f$\alpha u - \Delta_{\mathcal M} u = f\f$, in the form
/// \f$(S + \alpha M)\, \eta = \phi\f$. Note the sign of \f$f\f$, which is not that of
/// `solve_poisson()`.
/// \param alpha positive, in units of 1 / area: multiply by the area to compare surfaces of
/// different size
///
/// All else is as in `solve_poisson()`.
template <class FaceGraph, class Function, class VertexMap,
          class NamedParameters = parameters::Default_named_parameters>
Solve_report solve_screened_poisson(const FaceGraph& tm, const Function& f, double alpha,
                                    VertexMap u,
                                    const NamedParameters& np = parameters::default_values()) {
  if(!(alpha > 0))
    throw Parameter_error("alpha", "is " + std::to_string(alpha) + ", but must be positive");
  return internal::solve_poisson(tm, f, alpha, u, np);
}

namespace internal {

template <class FaceGraph, class Function, class VertexMap, class NamedParameters>
Solve_report solve_poisson(const FaceGraph& tm, const Function& f, double alpha, VertexMap u,
                           const NamedParameters& np) {
  CGAL::Real_timer timer;
  timer.start();
  const Spline_space_3 space(tm, np);
  const double space_seconds = timer.time();
  const Eigen::VectorXd load = assemble_load(space, surface_function(tm, f));
  Operators operators = assemble_operators(space);
  const double assembly_seconds = timer.time() - space_seconds;
  const Poisson_solver solver = make_poisson_solver(space, operators, alpha, np);
  operators = Operators(); // the solver has its own copy

  Eigen::VectorXd coefficients;
  Solve_report report = solver.solve(alpha > 0 ? load : Eigen::VectorXd(-load), coefficients);
  report.space_seconds = space_seconds;
  report.assembly_seconds = assembly_seconds;
  evaluate_at_vertices(Spline_function_3(space, std::move(coefficients)), tm, u);
  return report;
}

} // namespace internal

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SOLVE_POISSON_H
