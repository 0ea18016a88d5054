// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_COTANGENT_OPERATORS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_COTANGENT_OPERATORS_H

#include <CGAL/Restricted_laplacian_3/assembly/assemble.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Operators
/// Stiffness and mass matrix of the piecewise linear functions on the triangulation, for
/// comparison: the cotangent Laplacian, with the sign and the units of `assemble_operators()`. One
/// row for each vertex, in the order of `vertices(tm)`; degenerate faces are left out, and a vertex
/// without any other face has an empty row.
///
/// For a triangle of area \f$A\f$ whose side opposite to corner \f$i\f$ is the vector \f$e_i\f$,
/// the stiffness block is \f$\langle e_i, e_j \rangle / (4 A)\f$, which is \f$-\frac12 \cot\f$ of
/// the angle at the third corner for \f$i \ne j\f$; the mass block is \f$A/12\,(1 +
/// \delta_{ij})\f$, or \f$A/3\,\delta_{ij}\f$ if it is lumped.
///
/// The package `Weights` of \cgal has cotangent weights too, but no consistent mass matrix, and an
/// interface that differs from version to version.
/// \throws Input_error the surface is a point set
Operators cotangent_operators(const Triangulated_surface_3& surface, bool lumped_mass = false);

} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/assembly/cotangent_operators_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_COTANGENT_OPERATORS_H
