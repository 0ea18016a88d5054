// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_LAPLACE_SPECTRUM_H
#define CGAL_RESTRICTED_LAPLACIAN_3_LAPLACE_SPECTRUM_H

#include <CGAL/Restricted_laplacian_3/assembly/assemble.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parameters.h>
#include <CGAL/Restricted_laplacian_3/input/read_surface.h>
#include <CGAL/Restricted_laplacian_3/integration/cubature.h>
#include <CGAL/Restricted_laplacian_3/problems/shared/space_of.h>
#include <CGAL/Restricted_laplacian_3/problems/space_spectrum.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>

#include <CGAL/Real_timer.h>

#include <type_traits>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Problems
/// The smallest eigenvalues and eigenfunctions of \f$-\Delta_{\mathcal M}\f$ on a surface, with
/// the natural boundary condition if it is open.
/// \tparam Surface a model of `RestrictedSurface_3`
/// \param surface a mesh, a `soup()`, or oriented points
/// \param count number of pairs, positive
/// \param np optional named parameters:
/// \cgalNamedParamsBegin
///   \named_of_space
///   \named_accuracy
///   \named_of_surface
///   \named_of_spectrum
/// \cgalNamedParamsEnd
/// \throws Input_error one of its derived classes names the face, vertex or parameter
/// \throws Canceled if `progress` returned `false`
template <class Surface, class NamedParameters = parameters::Default_named_parameters,
          internal::Require_named_parameters<NamedParameters> = 0,
          std::enable_if_t<!std::is_same_v<Surface, Spline_space_3>, int> = 0>
Laplace_spectrum laplace_spectrum(const Surface& surface, int count,
                                  const NamedParameters& np = parameters::default_values()) {
  CGAL::Real_timer timer;
  timer.start();
  Spline_space_3 space = internal::first_space_of(surface, np);
  const double space_seconds = timer.time();
  Laplace_spectrum spectrum;
  if constexpr(internal::is_given_v<NamedParameters, internal_np::accuracy_t>)
    spectrum = internal::laplace_spectrum_to_accuracy(
        space, count, np, parameters::get_parameter(np, internal_np::accuracy));
  else
    spectrum = laplace_spectrum(space, count, np);
  spectrum.report.space_seconds += space_seconds;
  return spectrum;
}

/// \ingroup PkgRestrictedLaplacian3Problems
/// The smallest eigenvalues and eigenvectors of the cotangent Laplacian of the triangulation,
/// for comparison.
/// \tparam Surface a model of `RestrictedSurface_3`
/// \param surface a mesh or a `soup()`; not points, which have no triangles
/// \param count number of pairs, positive
/// \param np optional named parameters:
/// \cgalNamedParamsBegin
///   \named_of_surface
///   \named_lumped_mass
/// \cgalNamedParamsEnd
/// \throws Input_error one of its derived classes names the face, vertex or parameter
template <class Surface, class NamedParameters = parameters::Default_named_parameters>
Laplace_spectrum cotangent_spectrum(const Surface& surface, int count,
                                    const NamedParameters& np = parameters::default_values()) {
  CGAL::Real_timer timer;
  timer.start();
  const Triangulated_surface_3 triangles = read_surface(surface, np);
  const double space_seconds = timer.time();
  bool lumped_mass = false;
  internal::read_parameter(np, internal_np::lumped_mass, lumped_mass);
  Laplace_spectrum spectrum = internal::cotangent_eigenpairs(triangles, count, lumped_mass);
  spectrum.report.space_seconds = space_seconds;
  return spectrum;
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_LAPLACE_SPECTRUM_H
