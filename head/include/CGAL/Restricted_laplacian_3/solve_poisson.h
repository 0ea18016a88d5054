// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SOLVE_POISSON_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SOLVE_POISSON_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Progress.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parameters.h>
#include <CGAL/Restricted_laplacian_3/input/shared/function_on_surface.h>
#include <CGAL/Restricted_laplacian_3/problems/Poisson_problem.h>
#include <CGAL/Restricted_laplacian_3/problems/Poisson_solver.h>
#include <CGAL/Restricted_laplacian_3/problems/shared/space_of.h>
#include <CGAL/Restricted_laplacian_3/solvers/Solve_report.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_function_3.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>
#include <CGAL/Restricted_laplacian_3/surface/Surface_location.h>

#include <CGAL/Real_timer.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

namespace internal {

/// the values of `constraints` at the vertices
template <class Source, class NamedParameters>
std::vector<double> vertex_values(const Source& source, const Spline_space_3& space,
                                  const NamedParameters& np) {
  const auto values = parameters::get_parameter(np, internal_np::constraints);
  std::vector<double> result(space.surface().number_of_vertices());
  source.for_each_vertex([&](std::size_t i, const auto& v) {
    result[i] = static_cast<double>(value_at(values, v));
    if(std::isinf(result[i]))
      throw Parameter_error("constraints", "has an infinite value at vertex " + std::to_string(i));
  });
  return result;
}

/// whether a source, such as `Mesh_source`, has edges
template <class Source, class = void> struct Has_edges : std::false_type {};
template <class Source>
struct Has_edges<Source, std::void_t<typename Source::Halfedge>> : std::true_type {};

/// where the `boundary_values` among named parameters hold; empty: everywhere
template <class Source, class NamedParameters>
std::function<bool(const Surface_point&)>
has_boundary_value([[maybe_unused]] const Source& source,
                   [[maybe_unused]] const Triangulated_surface_3& surface,
                   [[maybe_unused]] const NamedParameters& np) {
  constexpr bool by_place = is_given_v<NamedParameters, internal_np::has_boundary_value_t>,
                 by_edge = is_given_v<NamedParameters, internal_np::edge_is_constrained_t>;
  static_assert(!(by_place && by_edge),
                "has_boundary_value and edge_is_constrained_map say the same");
  static_assert(!by_edge || Has_edges<Source>::value,
                "edge_is_constrained_map needs a mesh; else there is has_boundary_value");
  static_assert(!(by_place || by_edge) ||
                    is_given_v<NamedParameters, internal_np::boundary_values_t>,
                "has_boundary_value and edge_is_constrained_map need boundary_values");
  if constexpr(by_place)
    return parameters::get_parameter(np, internal_np::has_boundary_value);
  else if constexpr(by_edge) {
    const auto is_constrained = parameters::get_parameter(np, internal_np::edge_is_constrained);
    std::vector<bool> of_sides(3 * surface.number_of_faces());
    source.for_each_side(surface, [&](std::size_t i, const auto& e, bool is_at_boundary) {
      of_sides[i] = value_at(is_constrained, e);
      if(of_sides[i] && !is_at_boundary)
        throw Parameter_error("edge_is_constrained_map",
                              "marks an edge of face " + std::to_string(surface.polygon(i / 3)) +
                                  " that is not at the boundary");
    });
    return [of_sides = std::move(of_sides)](const Surface_point& p) {
      const auto opposite = std::min_element(p.barycentric.begin(), p.barycentric.end());
      return of_sides[3 * p.face +
                      static_cast<std::size_t>(opposite - p.barycentric.begin() + 1) % 3];
    };
  } else
    return {};
}

/// \param alpha a number, or a function on the surface, to which the problem refers
/// \param boundary_values a function, which counts only if it is among the named parameters
/// \param boundary_flux likewise
template <class Alpha, class BoundaryValues, class BoundaryFlux, class NamedParameters>
Poisson_problem poisson_problem(const Surface_function_view& f, const Alpha& alpha,
                                const BoundaryValues& boundary_values,
                                const BoundaryFlux& boundary_flux, const NamedParameters& np,
                                const Progress& progress) {
  Poisson_problem problem(f);
  if constexpr(std::is_arithmetic_v<Alpha>)
    problem.alpha = static_cast<double>(alpha);
  else
    problem.alpha_function = alpha;
  if constexpr(is_given_v<NamedParameters, internal_np::boundary_values_t>)
    problem.boundary_values = boundary_values;
  if constexpr(is_given_v<NamedParameters, internal_np::boundary_flux_t>)
    problem.boundary_flux = boundary_flux;
  read_parameter(np, internal_np::stabilization, problem.stabilization);
  read_parameter(np, internal_np::constraint_weight, problem.vertex_weight);
  problem.solver = Poisson_solver_options(np);
  problem.progress = progress.callback();
  return problem;
}

/// what is given for the boundary among named parameters, a number as a function; 0 if it is not
/// \param tag `boundary_values` or `boundary_flux`
template <class NamedParameters, class Tag> auto on_boundary(const NamedParameters& np, Tag tag) {
  return function_or_number(parameters::choose_parameter(parameters::get_parameter(np, tag), 0));
}

/// \param alpha a number, or a function on the surface
template <class Surface, class Function, class Alpha, class VertexMap, class NamedParameters>
Solve_report solve_poisson_on_surface(const Surface& surface, const Function& f, const Alpha& alpha,
                                      VertexMap u, const NamedParameters& np) {
  using Value = typename boost::property_traits<VertexMap>::value_type;
  const Progress progress = progress_of(np);
  CGAL::Real_timer timer;
  timer.start();
  progress(0);
  const auto source = surface_source(surface);
  const Spline_space_3 first = first_space_of(surface, np);
  const double space_seconds = timer.time();
  Spline_space_3 space = first;

  const Vertex_interpolation interpolation = vertex_interpolation(source, first.surface(), np);
  const auto right_hand_side = numbers_on_surface(source, f, interpolation);
  const auto weight = numbers_on_surface(source, alpha, interpolation);
  const auto values_on_boundary =
      numbers_on_surface(source, on_boundary(np, internal_np::boundary_values), interpolation);
  const auto flux =
      numbers_on_surface(source, on_boundary(np, internal_np::boundary_flux), interpolation);
  Poisson_problem problem = poisson_problem(right_hand_side, weight, values_on_boundary, flux, np,
                                            progress.part(space_share, 1));
  problem.has_boundary_value = has_boundary_value(source, first.surface(), np);
  if constexpr(is_given_v<NamedParameters, internal_np::constraints_t>)
    problem.vertex_values = vertex_values(source, space, np);
  Poisson_solutions solution;
  if constexpr(is_given_v<NamedParameters, internal_np::accuracy_t>)
    solution = solve_poisson_to_accuracy(space, problem,
                                         parameters::get_parameter(np, internal_np::accuracy));
  else
    solution = solve_poisson_problems(space, problem);
  solution.space_seconds += space_seconds;
  const std::vector<double> values =
      Spline_function_3(space, solution.coefficients.col(0)).values_at_vertices();
  source.for_each_vertex(
      [&](std::size_t i, const auto& v) { put_value_at(u, v, static_cast<Value>(values[i])); });
  return static_cast<const Solve_report&>(solution);
}

/// \param alpha a number, or a function object
template <class Alpha, class NamedParameters>
Poisson_solution solve_poisson_in_space(const Spline_space_3& space, const Surface_function_view& f,
                                        const Alpha& alpha, const NamedParameters& np) {
  static_assert(!is_given_v<NamedParameters, internal_np::constraints_t>,
                "constraints needs a mesh; for a space there is Point_constraints");
  const Progress progress = progress_of(np);
  progress(0);
  const auto values = on_boundary(np, internal_np::boundary_values);
  const auto flux = on_boundary(np, internal_np::boundary_flux);
  Poisson_problem problem = poisson_problem(f, alpha, values, flux, np, progress);
  problem.has_boundary_value = has_boundary_value(0, space.surface(), np);
  return solve_poisson_problem(space, problem);
}

/// refuses a weight that is a number and not positive
template <class Alpha> void check_weight(const Alpha& alpha) {
  if constexpr(std::is_arithmetic_v<Alpha>)
    check_screening_weight(static_cast<double>(alpha));
}

} // namespace internal

/// \ingroup PkgRestrictedLaplacian3Problems
/// Solves the Poisson problem \f$\Delta_{\mathcal M} u = f\f$ on a surface (paper, equation 1), in
/// the form \f$S \eta = -\phi\f$ (the stiffness matrix \f$S\f$ is minus the matrix \f$L\f$ of the
/// paper).
///
/// On a closed surface, and on an open one with the natural boundary condition
/// \f$\partial u / \partial \nu = 0\f$, which holds where no other is given, a solution exists only
/// if \f$f\f$ has mean 0: its mean is subtracted, and the solution has surface mean 0. Both hold on
/// each connected component of the surface (not split into components if `split` is
/// `false`: then two that come within three cells of each other count as one). Components on which
/// values are prescribed are solved as they are.
///
/// \tparam Surface a model of `RestrictedSurface_3`
/// \param surface a mesh, a `soup()`, oriented points, or a `Spline_space_3`
/// \param f a function object that takes a `const Surface_point&` and returns a number; or a model
/// of `ReadablePropertyMap` with a number as value. Its keys are vertices: \f$f\f$ is linear in
/// each triangle, or what `vertex_data` says; halfedges of a mesh: linear, with the value of a
/// halfedge at its target, in its face; or faces of a mesh: \f$f\f$ is constant in each.
/// \param u a model of `WritablePropertyMap` with vertices as keys and a floating-point number as
/// value, receives the solution; NaN at vertices without a face of positive area
/// \param np optional named parameters:
/// \cgalNamedParamsBegin
///   \named_of_space
///   \named_accuracy
///   \named_of_surface
///   \named_vertex_data
///   \named_of_poisson
/// \cgalNamedParamsEnd
/// \return whether the solver converged, iterations, residual, times
/// \throws Input_error one of its derived classes names the face, vertex or parameter
/// \throws Canceled if `progress` returned `false`
///
/// Takes time and memory proportional to the number of triangles plus the number of elements, times
/// the number of iterations.
template <class Surface, class Function, class VertexMap,
          class NamedParameters = parameters::Default_named_parameters,
          internal::Require_named_parameters<NamedParameters> = 0,
          internal::Require_property_map<VertexMap> = 0>
Solve_report solve_poisson(const Surface& surface, const Function& f, VertexMap u,
                           const NamedParameters& np = parameters::default_values()) {
  return internal::solve_poisson_on_surface(surface, f, 0, u, np);
}

/// \ingroup PkgRestrictedLaplacian3Problems
/// Solves the Poisson problem \f$\Delta_{\mathcal M} u = f\f$ in a space, with its integration.
/// \param space the space that the solution is in
/// \param f a function object that takes a `const Surface_point&` and returns a number; integrated
/// as in `assemble_load()`
/// \param np optional named parameters, where `boundary_values` are a number or a function object;
/// prescribed values at points are those of `Point_constraints`:
/// \cgalNamedParamsBegin
///   \named_of_poisson
///   \named_concurrency_tag
/// \cgalNamedParamsEnd
/// \return the coefficients, whether the solver converged, iterations, residual, times
/// \throws Parameter_error if a parameter is outside its domain, or if a value of `f` is not finite
/// \throws Canceled if `progress` returned `false`
template <class NamedParameters = parameters::Default_named_parameters,
          internal::Require_named_parameters<NamedParameters> = 0>
Poisson_solution solve_poisson(const Spline_space_3& space, const Surface_function_view& f,
                               const NamedParameters& np = parameters::default_values()) {
  return internal::solve_poisson_in_space(space, f, 0, np);
}

/// \ingroup PkgRestrictedLaplacian3Problems
/// Solves the screened Poisson problem \f$\alpha u - \Delta_{\mathcal M} u = f\f$, in the form
/// \f$(S + \alpha M)\, \eta = \phi\f$. Note the sign of \f$f\f$, which is not that of
/// `solve_poisson()`.
///
/// With \f$f = \alpha g\f$ the solution minimizes
/// \f$ \int \lvert \nabla u \rvert^2 + \alpha (u - g)^2 \f$: it is pulled toward \f$g\f$ where
/// \f$\alpha\f$ is large, a soft constraint.
/// \tparam Surface a model of `RestrictedSurface_3`
/// \param surface a mesh, a `soup()`, oriented points, or a `Spline_space_3`
/// \param f the right-hand side, given as in `solve_poisson()`
/// \param alpha in units of 1 / area: a positive number (multiply by the area to compare surfaces
/// of different size); or weights that are not negative, given as `f` is
/// \param u a model of `WritablePropertyMap` with vertices as keys and a floating-point number as
/// value, receives the solution; NaN at vertices without a face of positive area
/// \param np optional named parameters:
/// \cgalNamedParamsBegin
///   \named_of_space
///   \named_accuracy
///   \named_of_surface
///   \named_vertex_data
///   \named_of_poisson
/// \cgalNamedParamsEnd
/// \return whether the solver converged, iterations, residual, times
/// \throws Input_error one of its derived classes names the face, vertex or parameter
/// \throws Canceled if `progress` returned `false`
template <class Surface, class Function, class Alpha, class VertexMap,
          class NamedParameters = parameters::Default_named_parameters,
          internal::Require_named_parameters<NamedParameters> = 0,
          internal::Require_property_map<VertexMap> = 0>
Solve_report solve_screened_poisson(const Surface& surface, const Function& f, const Alpha& alpha,
                                    VertexMap u,
                                    const NamedParameters& np = parameters::default_values()) {
  internal::check_weight(alpha);
  return internal::solve_poisson_on_surface(surface, f, alpha, u, np);
}

/// \ingroup PkgRestrictedLaplacian3Problems
/// Solves the screened Poisson problem \f$\alpha u - \Delta_{\mathcal M} u = f\f$ in a space, with
/// its integration.
/// \param space the space that the solution is in
/// \param f the right-hand side: a function object that takes a `const Surface_point&` and returns
/// a number; integrated as in `assemble_load()`
/// \param alpha in units of 1 / area: a positive number; or a function object like `f`, whose
/// values are not negative
/// \param np optional named parameters, where `boundary_values` are a number or a function object;
/// prescribed values at points are those of `Point_constraints`:
/// \cgalNamedParamsBegin
///   \named_of_poisson
///   \named_concurrency_tag
/// \cgalNamedParamsEnd
/// \return the coefficients, whether the solver converged, iterations, residual, times
/// \throws Parameter_error if a parameter is outside its domain, or if a value of a function is not
/// finite
/// \throws Canceled if `progress` returned `false`
template <class Alpha, class NamedParameters = parameters::Default_named_parameters,
          internal::Require_named_parameters<NamedParameters> = 0>
Poisson_solution solve_screened_poisson(const Spline_space_3& space, const Surface_function_view& f,
                                        const Alpha& alpha,
                                        const NamedParameters& np = parameters::default_values()) {
  internal::check_weight(alpha);
  return internal::solve_poisson_in_space(space, f, alpha, np);
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SOLVE_POISSON_H
