// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SHARED_CORNER_GROUPS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SHARED_CORNER_GROUPS_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>
#include <CGAL/Restricted_laplacian_3/surface/Surface_location.h>

#include <cstdint>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

class Triangulated_surface_3;

namespace internal {

/// Corners of faces that have a normal in common: all at a vertex, or those of a sector between
/// creases.
struct Corner_groups {
  struct Corner {
    std::uint32_t group;
    /// 1, or -1 if the face is oriented against its group
    signed char sign;
    /// whether the normal of the face counts
    bool counts;
  };

  /// three of each face
  std::vector<Corner> corners;
  /// the vertex of each group
  std::vector<std::uint32_t> vertices;
  /// Of each group, when the mean of the normals of its faces is corrected by the rule of chords:
  /// first where they lie to one side of the vertex, and then also elsewhere.
  enum class Correction : signed char { none, inside, at_boundary };
  std::vector<Correction> corrections;
};

/// The unit normals of groups: means with the weights of `vertex_normals()`, corrected by the rule
/// of chords where that is asked for. The zero vector where nothing counts.
std::vector<Vector_3> group_normals(const Triangulated_surface_3& surface,
                                    const Corner_groups& groups);

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SHARED_CORNER_GROUPS_H
