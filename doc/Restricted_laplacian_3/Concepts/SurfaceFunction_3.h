// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\headerfile Surface_location.h <CGAL/Restricted_laplacian_3/surface/Surface_location.h>
\ingroup PkgRestrictedLaplacian3Concepts
\cgalConcept

A function or a vector field on a surface, as a function object; a lambda will do. It is evaluated
at the nodes of integrals, which lie inside of triangles, and must return the same value for the same
location. If the space uses several threads, it is called from several threads at once.

What it returns depends on what takes it:

| Taken by | Values |
|----------|--------|
| `CGAL::Restricted_laplacian_3::assemble_load()`, `CGAL::Restricted_laplacian_3::solve_poisson()`, `CGAL::Restricted_laplacian_3::solve_screened_poisson()`, and all weights | numbers |
| `CGAL::Restricted_laplacian_3::assemble_component_loads()`, `CGAL::Restricted_laplacian_3::fit_function()` | numbers, `std::array`s of numbers, vectors of Eigen whose size is known at compile time, 3D vectors or points of \cgal |
| `CGAL::Restricted_laplacian_3::assemble_gradient_loads()`, `CGAL::Restricted_laplacian_3::integrate_gradient_field()` | 3D vectors of \cgal, `std::array`s of them, matrices of Eigen of three rows whose number of columns is known at compile time |

With `CGAL::Restricted_laplacian_3::Triangle_cubature` integrals are exact up to rounding if the function
is a polynomial of degree at most 6 on each triangle; models below, whose degree is lower, take fewer
nodes. The functions that take a mesh also take a property map in place of a function object.

\cgalRefines `CopyConstructible`

\cgalHasModel `CGAL::Restricted_laplacian_3::Linear_surface_function`
\cgalHasModel `CGAL::Restricted_laplacian_3::Function_of_degree`
\cgalHasModel `CGAL::Restricted_laplacian_3::Face_function`
\cgalHasModel `CGAL::Restricted_laplacian_3::Corner_vector_field`
*/
class SurfaceFunction_3 {
public:
  /*!
  the value at a location: a finite number, or finite components
  \param p face, barycentric coordinates, vertices, point and unit normal of the location
  */
  unspecified_type operator()(const CGAL::Restricted_laplacian_3::Surface_point& p) const;

  /*!
  optional: the degree, from 0 to 6, of the polynomials that the function is close to on each triangle;
  6 without it. The lower it is, the fewer nodes are evaluated.
  */
  int degree() const;
};
