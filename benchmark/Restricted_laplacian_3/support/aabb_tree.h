// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_BENCHMARK_AABB_TREE_H
#define RESTRICTED_LAPLACIAN_3_BENCHMARK_AABB_TREE_H

// CGAL's trees in space, whatever its version: CGAL 6 warns of the former names.

#include <CGAL/AABB_tree.h>
#include <CGAL/version.h>

#if CGAL_VERSION_NR < CGAL_VERSION_NUMBER(6, 0, 0)
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_triangle_primitive.h>
#else
#include <CGAL/AABB_traits_3.h>
#include <CGAL/AABB_triangle_primitive_3.h>
#endif

namespace benchmarks {

#if CGAL_VERSION_NR < CGAL_VERSION_NUMBER(6, 0, 0)
template <class Kernel, class Iterator>
using Triangle_primitive = CGAL::AABB_triangle_primitive<Kernel, Iterator>;
template <class Kernel, class Primitive>
using Aabb_tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;
#else
template <class Kernel, class Iterator>
using Triangle_primitive = CGAL::AABB_triangle_primitive_3<Kernel, Iterator>;
template <class Kernel, class Primitive>
using Aabb_tree = CGAL::AABB_tree<CGAL::AABB_traits_3<Kernel, Primitive>>;
#endif

} // namespace benchmarks

#endif // RESTRICTED_LAPLACIAN_3_BENCHMARK_AABB_TREE_H
