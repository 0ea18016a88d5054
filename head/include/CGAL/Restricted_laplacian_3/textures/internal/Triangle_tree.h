// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_TEXTURES_INTERNAL_TRIANGLE_TREE_H
#define CGAL_RESTRICTED_LAPLACIAN_3_TEXTURES_INTERNAL_TRIANGLE_TREE_H

#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>

#include <CGAL/AABB_tree.h>
#include <CGAL/version.h>

#include <vector>

// CGAL 6 has trees in the plane, too; it warns of the former names.
#if CGAL_VERSION_NR < CGAL_VERSION_NUMBER(6, 0, 0)
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_triangle_primitive.h>
#else
#include <CGAL/AABB_traits_3.h>
#include <CGAL/AABB_triangle_primitive_3.h>
#endif

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

using Triangles_in_tree = std::vector<Double_kernel::Triangle_3>;

/// \cgal's tree of the triangles in a vector
#if CGAL_VERSION_NR < CGAL_VERSION_NUMBER(6, 0, 0)
using Triangle_tree = AABB_tree<AABB_traits<
    Double_kernel, AABB_triangle_primitive<Double_kernel, Triangles_in_tree::const_iterator>>>;
#else
using Triangle_tree = AABB_tree<AABB_traits_3<
    Double_kernel, AABB_triangle_primitive_3<Double_kernel, Triangles_in_tree::const_iterator>>>;
#endif

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_TEXTURES_INTERNAL_TRIANGLE_TREE_H
