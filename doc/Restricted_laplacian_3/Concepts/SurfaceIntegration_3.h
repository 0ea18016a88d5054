// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\headerfile surface_integration.h <CGAL/Restricted_laplacian_3/integration/surface_integration.h>
\ingroup PkgRestrictedLaplacian3Concepts
\cgalConcept

A way to integrate over a surface, sheet by sheet of the finest level of an octree: by nodes on the
surface, each with a weight that is not negative. All integrals are sums over the same nodes. The
weights of all nodes on all sheets sum to the area of the surface, in units of the squared cell width.

A surface is thus a set of positions, normals and weights, each in a cell: the nodes of a rule on the
parts of triangles, samples of a mesh, or the points of a point set.

The functions that assemble matrices and right-hand sides take a model as argument. If the space
uses several threads, they call its members from several threads at once.

\cgalHasModel `CGAL::Restricted_laplacian_3::Cubature`
\cgalHasModel `CGAL::Restricted_laplacian_3::Monte_carlo`
\cgalHasModel `CGAL::Restricted_laplacian_3::Weighted_integration`
*/
class SurfaceIntegration_3 {
public:
  /*!
  adds the moments of a sheet of the finest level to `moments`, which need not be 0 before: for a
  node at the local coordinate \f$t\f$ with weight \f$w\f$ and unit normal \f$n\f$,
  \f$w\, B_a(t_x) B_b(t_y) B_c(t_z)\f$ to the mass, and that times \f$I - n n^T\f$ to the tensor.
  */
  void add_moments(std::size_t sheet, CGAL::Restricted_laplacian_3::Cell_moments& moments) const;

  /*!
  calls `visit(t, location, weight)` for all nodes on a sheet of the finest level.

  `t` is the local coordinate in the cell, a `std::array<double, 3>`, in \f$[0,1]^3\f$ up to
  rounding; `location` is the same place as a `CGAL::Restricted_laplacian_3::Surface_location`;
  `weight` is in units of the squared cell width. A node that lies on a wall between cells belongs
  to one of them only, and elements are evaluated by their polynomial pieces in that cell.
  */
  template <class Visitor> void for_each_node(std::size_t sheet, Visitor&& visit) const;
};
