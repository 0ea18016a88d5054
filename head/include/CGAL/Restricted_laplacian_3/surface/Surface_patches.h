// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SURFACE_PATCHES_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SURFACE_PATCHES_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>
#include <CGAL/Restricted_laplacian_3/surface/Surface_location.h>

#include <CGAL/assertions.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
/// \ingroup PkgRestrictedLaplacian3Dev
/// A point of a patch, with the unit normal there, and the area that the patch would have if it
/// were stretched over its face everywhere as it is there: its mean over the barycentric
/// coordinates is the area of the patch.
struct Patch_point {
  /// the point
  Point_3 point;
  /// the unit normal there
  Vector_3 normal;
  /// the area
  double area;
};

/// \ingroup PkgRestrictedLaplacian3Dev
/// A smooth surface through the vertices of a triangulated one: a cubic Bezier triangle on
/// each face, in barycentric coordinates of the face. Made by `curved_surface()`. Deviations from
/// the flat faces are what is stored: 168 bytes a face.
class Surface_patches {
public:
  /// What deviates from a flat triangle: its Bezier control points, but for the corners, less those
  /// of the triangle. Two of each side, at corner `i` and at the next, then that of the middle.
  using Controls = std::array<Vector_3, 7>;

  /// \param controls of each face
  /// \param number_of_folded_faces how many of those that are 0 would fold otherwise
  Surface_patches(std::vector<Controls> controls, std::size_t number_of_folded_faces);

  /// whether the patch of a face is its triangle
  bool is_flat(std::size_t face) const { return m_is_flat[face] != 0; }
  /// what the patch of a face has more than its triangle
  const Controls& controls(std::size_t face) const { return m_controls[face]; }
  /// number of faces that remain flat because their patch would fold
  std::size_t number_of_folded_faces() const { return m_number_of_folded_faces; }

  /// The vector from a point of a face to that of its patch.
  /// \param face the face
  /// \param barycentric coordinates in the face
  Vector_3 deviation(std::size_t face, const std::array<double, 3>& barycentric) const;

  /// A point of the patch of a face.
  /// \param face the face
  /// \param corners the points of the face
  /// \param barycentric coordinates in the face, which is not degenerate
  Patch_point evaluate(std::size_t face, const std::array<Point_3, 3>& corners,
                       const std::array<double, 3>& barycentric) const;

  /// The derivative of the patch along a line in barycentric coordinates.
  /// \param face,corners,barycentric as above
  /// \param direction coordinates of the end of the line less those of its begin: their sum is 0
  Vector_3 derivative(std::size_t face, const std::array<Point_3, 3>& corners,
                      const std::array<double, 3>& barycentric,
                      const std::array<double, 3>& direction) const;

private:
  /// partial derivatives of the deviation by each coordinate
  std::array<Vector_3, 3> partial_derivatives(std::size_t face,
                                              const std::array<double, 3>& barycentric) const;

  std::vector<Controls> m_controls;
  std::vector<char> m_is_flat;
  std::size_t m_number_of_folded_faces;
};

} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/surface/Surface_patches_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SURFACE_PATCHES_H
