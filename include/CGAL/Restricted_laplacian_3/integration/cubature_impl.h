// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_CUBATURE_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_CUBATURE_IMPL_H

#include <CGAL/Restricted_laplacian_3/integration/cubature.h>
#include <CGAL/Restricted_laplacian_3/integration/internal/fragment_nodes.h>
#include <CGAL/Restricted_laplacian_3/integration/shared/sheet_kernels.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Triangle_cubature::Triangle_cubature(const Octree_3& octree)
  : m_octree(&octree) {
  octree.surface().require_triangles("Triangle_cubature");
}

namespace internal {

/// Calls `visit(fragment, cell, triangle, point)` for the fragments of a sheet: the cell that owns
/// it, the triangle that it is cut from, and what all points on it have in common.
template <class Visitor>
void for_each_fragment(const Octree_3& octree, std::size_t sheet, Visitor&& visit) {
  const Triangulated_surface_3& surface = octree.surface();
  const Cell_3 cell = octree.cell(octree.depth(), sheet);
  for(std::uint32_t face : octree.faces(sheet)) {
    Surface_point point;
    point.face = face;
    point.vertices = surface.triangle(face);
    point.normal = surface.normal(face);
    visit(octree.fragment(cell, face), cell.index,
          std::array<Point_3, 3>{surface.point(face, 0), surface.point(face, 1),
                                 surface.point(face, 2)},
          point);
  }
}

} // namespace internal

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void
Triangle_cubature::add_nodes(std::size_t sheet, int degree, Integration_nodes& nodes) const {
  const internal::Padded_rule& rule = internal::Padded_rule::of_degree(degree);
  internal::for_each_fragment(*m_octree, sheet, [&](const auto&... fragment) {
    internal::add_fragment_nodes(fragment..., rule, nodes);
  });
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void
Triangle_cubature::add_moments(std::size_t sheet, const internal::Face_weight* weight,
                               internal::Sheet_integrals& integrals) const {
  const Triangulated_surface_3& surface = m_octree->surface();
  const Cell_3 cell = m_octree->cell(m_octree->depth(), sheet);
  for(std::uint32_t face : m_octree->faces(sheet)) {
    const Fragment fragment = m_octree->fragment(cell, face);
    const Vector_3& normal = surface.normal(face);
    internal::add_fragment(fragment, cell.index, tangent_projector(normal), integrals.moments,
                           weight ? (*weight)(face) : 1, integrals.degree);
    integrals.add_normal(normal, fragment.double_area() / 2);
  }
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void
Triangle_cubature::add_linear_function(std::size_t sheet,
                                       internal::Function_moments& moments) const {
  internal::for_each_fragment(*m_octree, sheet, [&](const auto&... fragment) {
    internal::add_fragment_function(fragment..., moments);
  });
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Point_cubature::Point_cubature(const Octree_3& octree)
  : m_octree(&octree) {
  if(!octree.surface().is_point_set())
    throw Input_error("the surface consists of triangles, but Point_cubature needs points");
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void Point_cubature::add_nodes(std::size_t sheet, int /*degree*/,
                                                                  Integration_nodes& nodes) const {
  const int depth = m_octree->depth();
  const double h = m_octree->cell_width(depth);
  const Triangulated_surface_3& surface = m_octree->surface();
  const Cell_3 cell = m_octree->cell(depth, sheet);
  Surface_location location;
  for(std::uint32_t point : m_octree->faces(sheet)) {
    location.face = point;
    std::array<double, 3> t = m_octree->grid_coordinates(depth, surface.point(point));
    for(int axis = 0; axis < 3; ++axis)
      t[axis] -= cell.index[axis];
    nodes.add(surface.surface_point(location), t, surface.area(point) / h / h);
  }
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Surface_integration default_integration(const Octree_3& octree) {
  if(octree.surface().is_point_set())
    return Point_cubature(octree);
  return Triangle_cubature(octree);
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_CUBATURE_IMPL_H
