// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PATCHES_CURVED_SURFACE_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PATCHES_CURVED_SURFACE_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>
#include <CGAL/Restricted_laplacian_3/patches/Smooth_geometry.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Dev
/// The same surface with patches on its faces, see `Triangulated_surface_3::is_smooth()`: a smooth
/// surface through its vertices. If the geometry has a projection, the vertices are projected, too.
///
/// The patch of a face is determined by its corners and the normals there, as a PN triangle
/// (A. Vlachos et al., *Curved PN triangles*, 2001), with two differences. The tangents of the
/// curve over an edge are as long as those of the cubic that is closest to a circular arc, \f$2 L /
/// (1 + \cos \varphi)\f$ for an edge of length \f$L\f$ and an angle \f$\varphi\f$ between edge and
/// tangent, so that the error of an arc is of order \f$L^6\f$ in place of \f$L^4\f$. And the center
/// of the patch is the mean of those of three such curves, from the corners to the middles of the
/// opposite sides. Two patches that share an edge share its curve.
///
/// *Normals* are means with the weights of `vertex_normals()`, corrected by the rule of chords as
/// those at boundaries there: where triangles are irregular, this makes them several times as
/// accurate. A vertex has one for each sector of faces between two creases: edges at which two
/// normals differ by more than `Smooth_geometry::crease_angle`, edges in
/// `Smooth_geometry::creases`, and those with one face, or more than two. In a sector that meets
/// one plane part of the surface, only the faces of this part count: the normal is that of the
/// plane. (A part is plane if its faces lie in one plane, and one of them has three neighbors in
/// it; so strips of a cylinder are not. Several in one sector have a normal each.) Neighbors that
/// are oriented against each other have opposite normals.
///
/// *Creases and boundaries* are curves too: where two of their edges meet at less than the crease
/// angle, the tangent is that of the parabola through the three vertices. At their corners it is
/// orthogonal to the normals of both faces, or to that of the only one.
///
/// *Folds.* The patch of a face would fold, or nearly so, if its normal turned away from that of
/// the face; then the face, and with it its three edges, remains flat. Degenerate faces do as well.
///
/// Takes \f$O(F \log F)\f$ time for \f$F\f$ faces.
/// \param surface a surface of triangles
/// \param geometry normals and creases, or a projection
/// \throws Input_error the surface is a point set
/// \throws Invalid_vertex_error a vertex of a face is projected to what is not finite
/// \throws Parameter_error the crease angle is not from 0 to 180, or vertex normals or projected
/// points are not as many as they should be
/// \throws Invalid_face_error the projection returned a point that is not finite
Triangulated_surface_3 curved_surface(Triangulated_surface_3 surface,
                                      const Smooth_geometry& geometry = Smooth_geometry());

} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/patches/curved_surface_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_PATCHES_CURVED_SURFACE_H
