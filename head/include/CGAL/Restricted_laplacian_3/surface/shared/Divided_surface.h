// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SHARED_DIVIDED_SURFACE_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SHARED_DIVIDED_SURFACE_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>
#include <CGAL/Restricted_laplacian_3/surface/Surface_patches.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// The patches of a smooth surface, divided into pieces that are nearly flat: a surface of flat
/// triangles whose corners lie on the patches, and from which the patches deviate by no more than a
/// tolerance. What is cut into fragments, and joined to sheets, are the pieces.
///
/// An edge is divided by its own curve alone, so that pieces of neighbors meet. The first vertices
/// are those of the surface.
class Divided_surface {
public:
  /// \param surface a smooth surface
  /// \param tolerance in the unit of the coordinates
  Divided_surface(const Triangulated_surface_3& surface, double tolerance);

  /// the pieces
  const Triangulated_surface_3& pieces() const { return m_pieces; }

  /// the face of which a piece is a part
  std::size_t face(std::size_t piece) const { return m_faces[piece]; }
  /// whether a piece belongs to a flat patch, so that it is a part of the surface itself
  bool is_flat(std::size_t piece) const { return m_is_flat[piece] != 0; }
  /// the location on the surface of a point of a piece
  Surface_location location(std::size_t piece, const std::array<double, 3>& barycentric) const {
    Surface_location result;
    result.face = m_faces[piece];
    for(int i = 0; i < 2; ++i)
      result.barycentric[i] = barycentric[0] * m_corners[piece][0][i] +
                              barycentric[1] * m_corners[piece][1][i] +
                              barycentric[2] * m_corners[piece][2][i];
    result.barycentric[2] = 1 - result.barycentric[0] - result.barycentric[1];
    return result;
  }
  /// the area of a piece as a fraction of that of its face, in barycentric coordinates
  double fraction(std::size_t piece) const {
    const auto& c = m_corners[piece];
    return (c[1][0] - c[0][0]) * (c[2][1] - c[0][1]) - (c[1][1] - c[0][1]) * (c[2][0] - c[0][0]);
  }
  /// the location on the pieces of a location on the surface: the piece in whose inside it lies
  /// deepest
  Surface_location on_pieces(const Surface_location& location) const;

private:
  friend class Patch_divider;

  std::vector<std::uint32_t> m_first_pieces; // of faces, and one more
  std::vector<std::uint32_t> m_faces;
  std::vector<char> m_is_flat;
  // two barycentric coordinates in the face
  std::vector<std::array<std::array<double, 2>, 3>> m_corners;
  Triangulated_surface_3 m_pieces; // made after the others
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/surface/shared/Divided_surface_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SHARED_DIVIDED_SURFACE_H
