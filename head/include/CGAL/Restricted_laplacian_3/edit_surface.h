// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_EDIT_SURFACE_H
#define CGAL_RESTRICTED_LAPLACIAN_3_EDIT_SURFACE_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/parameters.h>
#include <CGAL/Restricted_laplacian_3/input/shared/function_on_surface.h>
#include <CGAL/Restricted_laplacian_3/problems/Surface_editor.h>
#include <CGAL/Restricted_laplacian_3/problems/shared/put_positions.h>
#include <CGAL/Restricted_laplacian_3/problems/shared/space_of.h>

#include <CGAL/Real_timer.h>

#include <type_traits>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Problems
/// Edits a surface by the gradient of its positions: they minimize
/// \f$\int \lvert \nabla u - \beta \nabla x \rvert^2 + \alpha \lvert u - x \rvert^2\f$, see
/// `Surface_editor`, which does it for several \f$\beta\f$ with one setup, and for other signals.
/// \tparam Surface a model of `RestrictedSurface_3`, but of triangles or polygons
/// \param surface a mesh, a `soup()`, or a `Spline_space_3`
/// \param gradient_scale \f$\beta\f$: a number; or a function object that takes a
/// `const Surface_point&` and returns one, or a model of `ReadablePropertyMap` whose keys are
/// vertices (linear in each triangle)
/// \param alpha \f$\alpha\f$, positive, in units of 1 / area
/// \param positions a model of `WritablePropertyMap` with vertices as keys and 3D points of \cgal
/// as values receives the moved vertices; it may be the vertex-point map of a mesh
/// \param np optional named parameters:
/// \cgalNamedParamsBegin
///   \named_of_space
///   \named_of_surface
///   \named_anisotropic
///   \named_tolerance{`1e-4`, of the linear systems}
///   \named_usual_stabilization
/// \cgalNamedParamsEnd
/// \return whether all converged, the number of iterations, times
/// \throws Input_error one of its derived classes names the face, vertex or parameter
template <class Surface, class GradientScale, class VertexPointMap,
          class NamedParameters = parameters::Default_named_parameters,
          internal::Require_named_parameters<NamedParameters> = 0,
          internal::Require_property_map<VertexPointMap> = 0>
Solve_report edit_surface(const Surface& surface, const GradientScale& gradient_scale, double alpha,
                          VertexPointMap positions,
                          const NamedParameters& np = parameters::default_values()) {
  CGAL::Real_timer timer;
  timer.start();
  const Editing_options options(np);
  const auto source = internal::surface_source(surface);
  const Spline_space_3 space =
      internal::space_to_edit(internal::space_of(surface, np), alpha, options);
  const double space_seconds = timer.time();
  const Surface_editor editor(space, alpha, options);
  Edited_signal result;
  if constexpr(std::is_arithmetic_v<GradientScale>)
    result = editor.edit(static_cast<double>(gradient_scale));
  else {
    const auto scale = internal::numbers_on_surface(
        source, gradient_scale, internal::vertex_interpolation(source, space.surface(), np));
    result = editor.edit(Surface_function_view(scale));
  }
  internal::put_positions(source, result.values, positions);
  result.space_seconds = space_seconds;
  return static_cast<const Solve_report&>(result);
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_EDIT_SURFACE_H
