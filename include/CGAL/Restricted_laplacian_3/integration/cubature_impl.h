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

/// Calls `visit(fragment, cell, triangle, point)` for the fragment of a face or piece in a cell:
/// with the triangle that it is cut from, and what all points on it have in common.
template <class Visitor>
void visit_fragment(const Octree_3& octree, const Cell_3& cell, std::uint32_t face,
                    Visitor&& visit) {
  const Triangulated_surface_3& surface = octree.pieces();
  Surface_point point;
  point.face = face;
  point.vertices = surface.triangle(face);
  point.normal = surface.normal(face);
  visit(octree.fragment(cell, face), cell.index,
        std::array<Point_3, 3>{surface.point(face, 0), surface.point(face, 1),
                               surface.point(face, 2)},
        point);
}

/// The same for all fragments of a sheet.
template <class Visitor>
void for_each_fragment(const Octree_3& octree, std::size_t sheet, Visitor&& visit) {
  const Cell_3 cell = octree.cell(octree.depth(), sheet);
  for(std::uint32_t face : octree.faces(sheet))
    visit_fragment(octree, cell, face, visit);
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
  const Triangulated_surface_3& surface = m_octree->pieces();
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

namespace internal {

/// Moves nodes on a flat piece to its patch.
class Patch_nodes {
public:
  Patch_nodes(const Octree_3& octree, std::uint32_t piece)
    : m_surface(octree.surface()), m_division(*octree.division()), m_piece(piece),
      m_face(m_division.face(piece)),
      m_is_flat(m_surface.patches().is_flat(m_face)), m_corners{m_surface.point(m_face, 0),
                                                                m_surface.point(m_face, 1),
                                                                m_surface.point(m_face, 2)},
      m_area_factor(m_division.fraction(piece) / m_division.pieces().area(piece)),
      m_h(octree.cell_width(octree.depth())) {}

  bool is_flat() const { return m_is_flat; }
  std::size_t face() const { return m_face; }

  void move(Integration_node_block& block) const {
    for(std::size_t i = 0; i < block.size; ++i) {
      Surface_point& p = block.points[i];
      static_cast<Surface_location&>(p) = m_division.location(m_piece, p.barycentric);
      p.vertices = m_surface.triangle(m_face);
      if(m_is_flat)
        continue;
      const Patch_point on_patch = m_surface.patches().evaluate(m_face, m_corners, p.barycentric);
      for(int axis = 0; axis < 3; ++axis)
        block.positions[axis][i] += (on_patch.point[axis] - p.point[axis]) / m_h;
      block.weights[i] *= on_patch.area * m_area_factor;
      block.metrics[i] = tangent_projector(on_patch.normal);
      p.point = on_patch.point;
      p.normal = on_patch.normal;
    }
  }

private:
  const Triangulated_surface_3& m_surface;
  const Divided_surface& m_division;
  std::uint32_t m_piece;
  std::size_t m_face;
  bool m_is_flat;
  std::array<Point_3, 3> m_corners;
  double m_area_factor, m_h;
};

/// calls `visit(block)` for the nodes of a piece in a cell, moved to its patch
template <class Visitor>
void visit_patch_nodes(const Octree_3& octree, const Cell_3& cell, std::uint32_t piece,
                       const Patch_nodes& patch, const Padded_rule& rule, Visitor&& visit) {
  const auto move = [&](Integration_node_block& block) {
    patch.move(block);
    visit(block);
  };
  const Integration_nodes::Consumer consumer(move);
  Integration_nodes nodes(consumer);
  visit_fragment(octree, cell, piece,
                 [&](const auto&... fragment) { add_fragment_nodes(fragment..., rule, nodes); });
  nodes.flush();
}

} // namespace internal

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Patch_cubature::Patch_cubature(const Octree_3& octree)
  : m_octree(&octree) {
  if(!octree.surface().is_smooth())
    throw Input_error("the surface is not smooth, but Patch_cubature needs patches");
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void Patch_cubature::add_nodes(std::size_t sheet, int degree,
                                                                  Integration_nodes& nodes) const {
  const internal::Padded_rule& rule = internal::Padded_rule::of_degree(degree);
  const Cell_3 cell = m_octree->cell(m_octree->depth(), sheet);
  for(std::uint32_t piece : m_octree->faces(sheet))
    internal::visit_patch_nodes(*m_octree, cell, piece, internal::Patch_nodes(*m_octree, piece),
                                rule, [&](const Integration_node_block& block) {
                                  for(std::size_t i = 0; i < block.size; ++i)
                                    nodes.add(block.points[i], block.position(i), block.weights[i],
                                              block.metrics[i]);
                                });
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void
Patch_cubature::add_moments(std::size_t sheet, const internal::Face_weight* weight,
                            internal::Sheet_integrals& integrals) const {
  const Triangulated_surface_3& pieces = m_octree->pieces();
  const internal::Padded_rule& rule = internal::Padded_rule::of_degree(12);
  const Cell_3 cell = m_octree->cell(m_octree->depth(), sheet);
  for(std::uint32_t piece : m_octree->faces(sheet)) {
    const internal::Patch_nodes patch(*m_octree, piece);
    const double factor = weight ? (*weight)(patch.face()) : 1;
    if(patch.is_flat()) {
      const Fragment fragment = m_octree->fragment(cell, piece);
      const Vector_3& normal = pieces.normal(piece);
      internal::add_fragment(fragment, cell.index, tangent_projector(normal), integrals.moments,
                             factor, integrals.degree);
      integrals.add_normal(normal, fragment.double_area() / 2);
      continue;
    }
    internal::visit_patch_nodes(
        *m_octree, cell, piece, patch, rule, [&](Integration_node_block& block) {
          std::array<double, Integration_node_block::capacity> factors;
          factors.fill(factor);
          internal::add_node_moments(block, factors.data(), integrals.moments);
          for(std::size_t i = 0; i < block.size; ++i)
            integrals.add_normal(block.points[i].normal, block.weights[i]);
        });
  }
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
  if(octree.surface().is_smooth())
    return Patch_cubature(octree);
  return Triangle_cubature(octree);
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_CUBATURE_IMPL_H
