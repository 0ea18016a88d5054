// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SURFACE_PATCHES_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SURFACE_PATCHES_H

#include <CGAL/Restricted_laplacian_3/foundation/compiled.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>

#include <CGAL/assertions.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {
class Surface_edges;
} // namespace internal

/// \ingroup PkgRestrictedLaplacian3Dev
/// A smooth surface through the vertices of a triangulated one: a cubic B&eacute;zier triangle on
/// each face, in barycentric coordinates of the face.
///
/// The patch of a face is determined by its corners and the normals there, as a PN triangle
/// (A. Vlachos et al., *Curved PN triangles*, 2001), with two differences. The tangents of the curve
/// over an edge are as long as those of the cubic that is closest to a circular arc, \f$2 L / (1 +
/// \cos \varphi)\f$ for an edge of length \f$L\f$ and an angle \f$\varphi\f$ between edge and
/// tangent, so that the error of an arc is of order \f$L^6\f$ in place of \f$L^4\f$. And the
/// center of the patch is the mean of those of three such curves, from the corners to the middles
/// of the opposite sides. Two patches that share an edge share its curve.
///
/// *Normals* are means with the weights of `vertex_normals()`, corrected by the rule of chords as
/// those at boundaries there: where triangles are irregular, this makes them several times as
/// accurate. A vertex has one for each sector of faces between two creases: edges at which two normals differ by more than `Smooth_geometry::crease_angle`, edges
/// in `Smooth_geometry::creases`, and those with one face, or more than two. In a sector that meets
/// one plane part of the surface, only the faces of this part count: the normal is that of the
/// plane. (A part is plane if its faces lie in one plane, and one of them has three neighbors in
/// it; so strips of a cylinder are not.) Neighbors that are oriented against each other have
/// opposite normals.
///
/// *Creases and boundaries* are curves too: where two of their edges meet at less than the crease
/// angle, the tangent is that of the parabola through the three vertices. At their corners it is
/// orthogonal to the normals of both faces, or to that of the only one.
///
/// *Folds.* The patch of a face would fold, or nearly so, if its normal turned away from that of
/// the face; then the face, and with it its three edges, remains flat. Degenerate faces do as well.
///
/// Deviations from the flat face are what is stored: 168 bytes a face.
class Surface_patches {
public:
  /// A point of a patch, with the unit normal there, and the area that the patch would have if it
  /// were stretched over its face everywhere as it is there: its mean over the barycentric
  /// coordinates is the area of the patch.
  struct Patch_point {
    Point_3 point;
    Vector_3 normal;
    double area;
  };

  /// Takes \f$O(F \log F)\f$ time for \f$F\f$ faces.
  /// \param surface a surface of triangles; its points are kept, so it need not outlive this object
  /// \throws Parameter_error the crease angle is not from 0 to 180, or the vertex normals are not
  /// one for each vertex
  /// \throws Invalid_face_error the projection returned a point that is not finite
  Surface_patches(const Triangulated_surface_3& surface, const Smooth_geometry& geometry);

  /// whether the patch of a face is its triangle
  bool is_flat(std::size_t face) const { return m_is_flat[face] != 0; }
  /// number of faces that remain flat because their patch would fold
  std::size_t number_of_folded_faces() const { return m_number_of_folded_faces; }

  /// The vector from a point of a face to that of its patch.
  /// \param barycentric coordinates in the face
  Vector_3 deviation(std::size_t face, const std::array<double, 3>& barycentric) const;

  /// A point of the patch of a face.
  /// \param corners the points of the face
  /// \param barycentric coordinates in the face, which is not degenerate
  Patch_point evaluate(std::size_t face, const std::array<Point_3, 3>& corners,
                       const std::array<double, 3>& barycentric) const;

  /// The derivative of the patch along a line in barycentric coordinates.
  /// \param direction coordinates of the end of the line less those of its begin: their sum is 0
  Vector_3 derivative(std::size_t face, const std::array<Point_3, 3>& corners,
                      const std::array<double, 3>& barycentric,
                      const std::array<double, 3>& direction) const;

private:
  /// partial derivatives of the deviation by each coordinate
  std::array<Vector_3, 3> partial_derivatives(std::size_t face,
                                              const std::array<double, 3>& barycentric) const;

  /// Control points less those of the flat triangle: two of each side, at corner `i` and at the
  /// next, then that of the middle.
  using Controls = std::array<Vector_3, 7>;

  template <class Maker>
  void make_patches(const Triangulated_surface_3& surface, const internal::Surface_edges& edges,
                    const Maker& make);
  /// whether the patch of a face would fold
  bool folds(const Triangulated_surface_3& surface, std::size_t face) const;

  std::vector<Controls> m_controls;
  std::vector<char> m_is_flat;
  std::size_t m_number_of_folded_faces = 0;
};

} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/surface/Surface_patches_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SURFACE_PATCHES_H
