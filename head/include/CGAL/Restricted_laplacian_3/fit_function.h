// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_FIT_FUNCTION_H
#define CGAL_RESTRICTED_LAPLACIAN_3_FIT_FUNCTION_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/Progress.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parameters.h>
#include <CGAL/Restricted_laplacian_3/input/shared/function_on_surface.h>
#include <CGAL/Restricted_laplacian_3/problems/Function_fitter.h>
#include <CGAL/Restricted_laplacian_3/problems/shared/put_at_vertices.h>
#include <CGAL/Restricted_laplacian_3/problems/shared/space_of.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>

#include <CGAL/Real_timer.h>

#include <Eigen/Core>

#include <boost/property_map/property_map.hpp>

#include <string>
#include <type_traits>

namespace CGAL {
namespace Restricted_laplacian_3 {

namespace internal {

template <class Surface, class Function, class VertexMap, class NamedParameters>
Fit_report fit_function_on_surface(const Surface& surface, const Function& f, VertexMap u,
                                   const NamedParameters& np);

} // namespace internal

/// \ingroup PkgRestrictedLaplacian3Problems
/// Fits a function on a surface by a spline, see `Function_fitter`.
/// \tparam Surface a model of `RestrictedSurface_3`
/// \param surface a mesh, a `soup()`, oriented points, or a `Spline_space_3`
/// \param f a function object that takes a `const Surface_point&`, or a model of
/// `ReadablePropertyMap` whose keys are vertices (linear in each triangle, or what `vertex_data`
/// says), halfedges of a mesh (linear, with the value of a halfedge at its target, in its face) or
/// faces of a mesh (constant in each). Values are numbers, `std::array`s of numbers, vectors of
/// Eigen of a fixed size, or 3D vectors or points of \cgal.
/// \param u a model of `WritablePropertyMap` with vertices as keys and such a value, with as many
/// components, receives the values of the fit; NaN at vertices without a face of positive area
/// \param np optional named parameters:
/// \cgalNamedParamsBegin
///   \named_of_space
///   \named_accuracy
///   \named_of_surface
///   \named_vertex_data
///   \named_of_fits
///   \named_progress
/// \cgalNamedParamsEnd
/// \return whether the solver converged, iterations (of all solves together but those of refinement
/// steps), residuals, errors, times
/// \throws Input_error one of its derived classes names the face, vertex or parameter
/// \throws Canceled if `progress` returned `false`
template <class Surface, class Function, class VertexMap,
          class NamedParameters = parameters::Default_named_parameters,
          internal::Require_named_parameters<NamedParameters> = 0,
          internal::Require_property_map<VertexMap> = 0>
Fit_report fit_function(const Surface& surface, const Function& f, VertexMap u,
                        const NamedParameters& np = parameters::default_values()) {
  return internal::fit_function_on_surface(surface, f, u, np);
}

/// \ingroup PkgRestrictedLaplacian3Problems
/// Fits a function by a spline of a space: the least-squares projection \f$D \eta = \gamma\f$ of
/// the paper (section 5.3), if wanted with smoothing. See `Function_fitter`, which does the same
/// for many functions with one setup.
/// \param space the space that the fit is in
/// \param f a function object that takes a `const Surface_point&` and returns a number, a
/// `std::array` of numbers, a vector of Eigen of a fixed size, or a 3D vector or point of \cgal.
/// Integrated as in `assemble_load()`.
/// \param np optional named parameters:
/// \cgalNamedParamsBegin
///   \named_of_fits
///   \named_progress
///   \named_concurrency_tag
/// \cgalNamedParamsEnd
/// \return the coefficients, whether the solver converged, iterations (of all solves together but
/// those of refinement steps), residuals, errors, times
/// \throws Parameter_error if a parameter is outside its domain, or if a value of `f` is not finite
/// \throws Canceled if `progress` returned `false`
template <class NamedParameters = parameters::Default_named_parameters,
          internal::Require_named_parameters<NamedParameters> = 0>
Function_fit fit_function(const Spline_space_3& space, const Surface_function_view& f,
                          const NamedParameters& np = parameters::default_values()) {
  return Function_fitter(space, np).fit(f, internal::progress_of(np).callback());
}

namespace internal {

template <class Surface, class Function, class VertexMap, class NamedParameters>
Fit_report fit_function_on_surface(const Surface& surface, const Function& f, VertexMap u,
                                   const NamedParameters& np) {
  CGAL::Real_timer timer;
  timer.start();
  progress_of(np)(0);
  const auto source = surface_source(surface);
  Spline_space_3 space = first_space_of(surface, np);
  const double space_seconds = timer.time();
  const Vertex_interpolation interpolation = vertex_interpolation(source, space.surface(), np);
  const auto values = components_on_surface(source, f, interpolation);
  Function_fit fit;
  if constexpr(is_given_v<NamedParameters, internal_np::accuracy_t>)
    fit = fit_function_to_accuracy(
        space, values, np, parameters::get_parameter(np, internal_np::accuracy), progress_of(np));
  else
    fit = fit_function(space, values, np);
  put_at_vertices(source, space, fit.coefficients, u);
  fit.space_seconds += space_seconds;
  return static_cast<const Fit_report&>(fit);
}

} // namespace internal

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_FIT_FUNCTION_H
