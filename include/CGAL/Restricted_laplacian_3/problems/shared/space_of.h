// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_SHARED_SPACE_OF_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_SHARED_SPACE_OF_H

#include <CGAL/Restricted_laplacian_3/input/shared/Surface_source.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>

#include <algorithm>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// of the time that a function takes on a surface, that of its space
constexpr double space_share = 0.15;

/// a space as a source: the numbers of the vertices of its surface are keys
inline Triangulated_source surface_source(const Spline_space_3& space) {
  return Triangulated_source(space.surface());
}

/// the space of a surface of the caller, made as named parameters say
template <class Surface, class NamedParameters>
Spline_space_3 space_of(const Surface& surface, const NamedParameters& np) {
  static_assert(!is_given_v<NamedParameters, internal_np::accuracy_t>,
                "accuracy is for Poisson problems, spectra, fits, gradients and curvature");
  return Spline_space_3(surface, np);
}
template <class NamedParameters>
Spline_space_3 space_of(const Spline_space_3& space, const NamedParameters&) {
  static_assert(!is_given_v<NamedParameters, internal_np::accuracy_t>,
                "accuracy chooses the depth: it needs a surface, not a space");
  return space;
}

/// the depth at which a search for an accuracy begins
inline int first_depth_of_search(const Triangulated_surface_3& surface,
                                 const Spline_space_options& options) {
  constexpr int default_first_depth = 4;
  if(!surface.is_point_set())
    return options.depth.value_or(default_first_depth);
  // Sums over few points do not determine functions on small cells; and without coarser spaces
  // there is no estimate.
  constexpr int levels_of_an_estimate = 2;
  const int deepest =
      default_depth(surface, options.cube_scale.value_or(options.default_cube_scale));
  if(options.depth)
    return (std::min)(*options.depth, deepest);
  return (std::min)(default_first_depth, (std::max)(deepest - levels_of_an_estimate, 1));
}

/// The space of a surface of the caller, or with an `accuracy` the first one of the search for it.
template <class Surface, class NamedParameters>
Spline_space_3 first_space_of(const Surface& surface, const NamedParameters& np) {
  if constexpr(std::is_same_v<Surface, Spline_space_3> ||
               !is_given_v<NamedParameters, internal_np::accuracy_t>)
    return space_of(surface, np);
  else {
    Triangulated_surface_3 triangles = read_surface(surface, np);
    Spline_space_options options(np);
    options.material = material_of(surface_source(surface), triangles, np);
    options.depth = first_depth_of_search(triangles, options);
    return Spline_space_3(std::move(triangles), options);
  }
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_SHARED_SPACE_OF_H
