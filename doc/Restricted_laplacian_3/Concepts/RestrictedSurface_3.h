// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\headerfile soup.h <CGAL/Restricted_laplacian_3/input/soup.h>
\ingroup PkgRestrictedLaplacian3Concepts
\cgalConcept

What all functions of the package take as a surface. Its *vertices* are the keys of property maps:

| Model | Vertices | Other keys |
|-------|----------|------------|
| a model of `FaceListGraph` and `VertexListGraph`, for example `CGAL::Surface_mesh` or `CGAL::Polyhedron_3` | vertex descriptors | face descriptors: constant on each face; halfedge descriptors: the value at the target, in the face; edge descriptors |
| `CGAL::Restricted_laplacian_3::soup()` | indices of the points, `std::size_t` | |
| `CGAL::Restricted_laplacian_3::point_set()` | positions of the points, `std::size_t` | |
| a model of `ConstRange` of oriented points, for example `CGAL::Point_set_3`, or a vector of pairs with `point_map` and `normal_map` | its elements; or their positions, `std::size_t`, if a map does not take elements | |
| `CGAL::Restricted_laplacian_3::Spline_space_3`, `CGAL::Restricted_laplacian_3::Triangulated_surface_3` | numbers of vertices, `std::size_t` | |

Faces may have any number of corners. Those with more than three are divided into triangles: a convex one
in a plane into a fan, which changes nothing; another one with up to 50 corners such that the largest angle
between neighbors is least, as the function `triangulate_hole_polyline()` of \cgal does; one with more corners
by its shadow in the plane of two axes. Values on a face are those of all its triangles, and errors name the face of the mesh or soup. The
surface need not be closed, orientable or of one component; a soup need not be a manifold.

A set of points stands for a surface without faces. What needs triangles (smooth geometry, details,
gradients of linear functions) refuses it.

A function that takes a `Spline_space_3` makes no other: named parameters that describe a surface or a space
have no effect then.
*/
class RestrictedSurface_3 {};
