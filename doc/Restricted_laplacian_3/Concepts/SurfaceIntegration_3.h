// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\headerfile Integration_nodes.h <CGAL/Restricted_laplacian_3/integration/Integration_nodes.h>
\ingroup PkgRestrictedLaplacian3Concepts
\cgalConcept

A way to integrate over a surface, sheet by sheet of the finest level of an octree: by nodes on the
surface, each with a weight that is not negative, a unit normal, and a metric. All integrals are sums
over these nodes. The weights of all nodes on all sheets sum to the area of the surface, in units of
the squared cell width.

A surface is thus a set of positions, normals, weights and metrics, each in a cell: the nodes of a rule
on the parts of triangles, samples of a mesh, or the points of a point set. Nodes may be moved to a
curved surface nearby, and metrics may hold a diffusion tensor.

A space is given a model by `CGAL::Restricted_laplacian_3::Spline_space_3::integrated_by()`; all that is
computed in the space then integrates by it. If the space uses several threads, the member is called by
several threads at once.

\cgalHasModel `CGAL::Restricted_laplacian_3::Triangle_cubature`
\cgalHasModel `CGAL::Restricted_laplacian_3::Point_cubature`
\cgalHasModel `CGAL::Restricted_laplacian_3::Monte_carlo`
\cgalHasModel `CGAL::Restricted_laplacian_3::Weighted_integration`
\cgalHasModel `CGAL::Restricted_laplacian_3::Diffusion_integration`
*/
class SurfaceIntegration_3 {
public:
  /*!
  adds the nodes on a sheet of the finest level to `nodes`, see
  `CGAL::Restricted_laplacian_3::Integration_nodes::add()`.

  A node that lies on a wall between cells belongs to one of them only, and elements are evaluated by
  their polynomial pieces in that cell.
  \param sheet number of the sheet
  \param degree of the integrand on a plane, at most 12: the nodes may be those of a rule that is exact
  for it. With 12 the matrices are exact.
  \param nodes what takes the nodes
  */
  void add_nodes(std::size_t sheet, int degree,
                 CGAL::Restricted_laplacian_3::Integration_nodes& nodes) const;
};
