// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_DIFFUSE_H
#define CGAL_RESTRICTED_LAPLACIAN_3_DIFFUSE_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/Progress.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parameters.h>
#include <CGAL/Restricted_laplacian_3/input/shared/function_on_surface.h>
#include <CGAL/Restricted_laplacian_3/problems/Diffusion_solver.h>
#include <CGAL/Restricted_laplacian_3/problems/shared/put_at_vertices.h>
#include <CGAL/Restricted_laplacian_3/problems/shared/space_of.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>

#include <CGAL/Real_timer.h>

#include <type_traits>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Problems
/// Diffuses functions on a surface: \f$\partial_t u = \Delta_{\mathcal M} u + g\f$ from
/// \f$u(0)\f$ to \f$u(t)\f$; with a material
/// \f$\rho\, \partial_t u = \mathrm{div}(D\, \nabla u) + \rho g\f$. See `Diffusion_solver`, which
/// does it for many functions with one setup.
///
/// To smooth data with a kernel of a full width at half maximum, take `diffusion_time(width)`.
/// \tparam Surface a model of `RestrictedSurface_3`
/// \param surface a mesh, a `soup()`, oriented points, or a `Spline_space_3`
/// \param initial \f$u(0)\f$: a function object that takes a `const Surface_point&`, or a model of
/// `ReadablePropertyMap` whose keys are vertices (linear in each triangle, or what `vertex_data`
/// says), halfedges of a mesh (linear, with the value of a halfedge at its target, in its face) or
/// faces of a mesh (constant in each). Values are numbers, `std::array`s of numbers, vectors of
/// Eigen of a fixed size, or 3D vectors or points of \cgal.
/// \param time \f$t\f$, positive, in units of squared length
/// \param u a model of `WritablePropertyMap` with vertices as keys and such a value, with as many
/// components, receives \f$u(t)\f$; NaN at vertices without a face of positive area
/// \param np optional named parameters:
/// \cgalNamedParamsBegin
///   \named_of_space
///   \named_accuracy
///   \named_of_surface
///   \named_vertex_data
///   \named_source_term
///   \named_boundary_values_of_diffusion
///   \named_tolerance{`1e-4`, of the functions, without their means}
///   \named_usual_stabilization
///   \named_maximum_iterations{`100` linear systems}
///   \named_progress
/// \cgalNamedParamsEnd
/// \return whether the iteration converged, the number of linear systems, the last change, times
/// \throws Input_error one of its derived classes names the face, vertex or parameter
/// \throws Canceled if `progress` returned `false`
template <class Surface, class Function, class VertexMap,
          class NamedParameters = parameters::Default_named_parameters,
          internal::Require_named_parameters<NamedParameters> = 0>
Solve_report diffuse(const Surface& surface, const Function& initial, double time, VertexMap u,
                     const NamedParameters& np = parameters::default_values()) {
  using namespace internal;
  CGAL::Real_timer timer;
  timer.start();
  progress_of(np)(0);
  const auto source = surface_source(surface);
  Spline_space_3 space = first_space_of(surface, np);
  const double space_seconds = timer.time();
  const Vertex_interpolation interpolation = vertex_interpolation(source, space.surface(), np);
  const auto on_surface = [&](const auto& f) {
    return components_on_surface(source, f, interpolation);
  };
  const auto given = on_surface(function_or_number(initial));
  const auto supply = on_surface(function_or_number(
      parameters::choose_parameter(parameters::get_parameter(np, internal_np::source_term), 0)));
  const auto on_boundary = on_surface(function_or_number(parameters::choose_parameter(
      parameters::get_parameter(np, internal_np::boundary_values), 0)));
  Diffusion_problem problem{given, time, {}, {}, np, progress_of(np).callback()};
  if constexpr(is_given_v<NamedParameters, internal_np::source_term_t>)
    problem.source = supply;
  if constexpr(is_given_v<NamedParameters, internal_np::boundary_values_t>)
    problem.boundary_values = on_boundary;
  Diffused_functions result;
  if constexpr(is_given_v<NamedParameters, internal_np::accuracy_t>)
    result =
        diffuse_to_accuracy(space, problem, parameters::get_parameter(np, internal_np::accuracy));
  else
    result = diffuse_in_space(space, problem);
  put_at_vertices(source, space, result.coefficients, u);
  result.space_seconds += space_seconds;
  return static_cast<const Solve_report&>(result);
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_DIFFUSE_H
