// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgRestrictedLaplacian3Concepts
\cgalConcept

What the named parameter `geom_traits` has to know of points, and of vectors where normals are given:
their coordinates. They are converted to `double`, once, when a surface is read; the package
computes with `CGAL::Simple_cartesian<double>` and needs no predicates or constructions of others.

\cgalHasModel All models of the concept `Kernel`

\sa `CGAL::Restricted_laplacian_3::read_surface()`
\sa `RestrictedSurface_3`
*/
class RestrictedLaplacianTraits_3 {
public:
  /*!
  A function object whose operator takes a point, or a vector, and returns its first coordinate, a
  number type of \cgal, for example `double`: `CGAL::to_double()` converts it.
  */
  typedef unspecified_type Compute_x_3;
  /*!
  the same for the second coordinate
  */
  typedef unspecified_type Compute_y_3;
  /*!
  the same for the third coordinate
  */
  typedef unspecified_type Compute_z_3;

  /*!
  the function object
  */
  Compute_x_3 compute_x_3_object() const;
  /*!
  the function object
  */
  Compute_y_3 compute_y_3_object() const;
  /*!
  the function object
  */
  Compute_z_3 compute_z_3_object() const;
};
