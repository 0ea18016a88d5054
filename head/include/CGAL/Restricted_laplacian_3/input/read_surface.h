// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_INPUT_READ_SURFACE_H
#define CGAL_RESTRICTED_LAPLACIAN_3_INPUT_READ_SURFACE_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/parameters.h>
#include <CGAL/Restricted_laplacian_3/input/shared/Surface_source.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Dev
/// Reads a surface of the caller. Vertices are numbered in the order of `vertices(tm)`, of the
/// points of a soup or of a range of points; faces in the order of `faces(tm)` or of the polygons
/// of a soup, those with more than three corners as several triangles, see
/// `Triangulated_surface_3::polygon()`.
///
/// \tparam Surface a model of `RestrictedSurface_3`
/// \param surface a mesh, a `soup()`, or oriented points
/// \param np optional named parameters:
/// \cgalNamedParamsBegin
///   \named_of_surface
///   \named_concurrency_tag
/// \cgalNamedParamsEnd
/// \throws Invalid_face_error a face has fewer than three corners, or names a point that does not
/// exist
/// \throws Input_error also what the constructors of `Triangulated_surface_3`,
/// `curved_surface()` and `estimate_point_areas()` throw; a `CGAL::Point_set_3` has no normals
template <class Surface, class NamedParameters = parameters::Default_named_parameters,
          internal::Require_named_parameters<NamedParameters> = 0>
Triangulated_surface_3 read_surface(const Surface& surface,
                                    const NamedParameters& np = parameters::default_values()) {
  return internal::read_source(internal::surface_source(surface), np);
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_INPUT_READ_SURFACE_H
