// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_SHARED_SPACE_OF_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_SHARED_SPACE_OF_H

#include <CGAL/Restricted_laplacian_3/input/shared/Surface_source.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>

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
  return Spline_space_3(surface, np);
}
template <class NamedParameters>
Spline_space_3 space_of(const Spline_space_3& space, const NamedParameters&) {
  return space;
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_SHARED_SPACE_OF_H
