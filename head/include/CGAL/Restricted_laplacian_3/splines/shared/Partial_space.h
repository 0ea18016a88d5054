// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_SHARED_PARTIAL_SPACE_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_SHARED_PARTIAL_SPACE_H

#include <CGAL/Restricted_laplacian_3/octree/Octree_3.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>
#include <CGAL/Restricted_laplacian_3/splines/shared/Level_elements.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// For those who make a part of a space: what its constructors do.
class Partial_space {
public:
  /// options with defaults, also those that depend on the surface
  /// \throws Parameter_error if one is outside its domain
  static Spline_space_options checked(const Triangulated_surface_3& surface,
                                      const Spline_space_options& options) {
    return Spline_space_3::checked(surface, options);
  }

  /// whether elements are split, by checked options
  static bool is_split(const Triangulated_surface_3& surface, const Spline_space_options& options) {
    return Spline_space_3::splits(surface, options);
  }

  /// \param levels of which there are as many as the octree has
  static Spline_space_3 make(const Spline_space_options& options, Octree_3&& octree,
                             std::vector<Level_elements>&& levels) {
    return Spline_space_3(options, std::move(octree), std::move(levels));
  }
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_SHARED_PARTIAL_SPACE_H
