// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_CUBATURE_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_CUBATURE_IMPL_H

#include <CGAL/Restricted_laplacian_3/integration/cubature.h>
#include <CGAL/Restricted_laplacian_3/integration/internal/fragment_nodes.h>
#include <CGAL/Restricted_laplacian_3/integration/shared/patch_kernels.h>
#include <CGAL/Restricted_laplacian_3/integration/shared/sheet_kernels.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Triangle_cubature::Triangle_cubature(const Octree_3& octree)
  : m_octree(&octree) {
  octree.surface().require_triangles("Triangle_cubature");
  if(octree.surface().is_smooth())
    throw Input_error("the surface is smooth, but Triangle_cubature integrates over flat faces");
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
  point.polygon = surface.polygon(face);
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
Triangle_cubature::add_moments(std::size_t sheet, const internal::Factors_of_face* factors,
                               internal::Sheet_integrals& integrals) const {
  const Triangulated_surface_3& surface = m_octree->pieces();
  const Cell_3 cell = m_octree->cell(m_octree->depth(), sheet);
  for(std::uint32_t face : m_octree->faces(sheet)) {
    const Fragment fragment = m_octree->fragment(cell, face);
    const Vector_3 normal = surface.normal(face);
    const double area = fragment.double_area() / 2;
    const internal::Face_factors of_face = factors ? (*factors)(face) : internal::Face_factors();
    internal::add_fragment(
        fragment, cell.index, of_face.metric ? *of_face.metric : tangent_projector(normal),
        integrals.moments, of_face.mass_weight, of_face.density, integrals.degree);
    integrals.add_normal(normal, area);
    if(const auto& a = of_face.metric)
      integrals.diffusion =
          integrals.diffusion.value_or(0) + area * ((*a)[0] + (*a)[1] + (*a)[2]) / 2;
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

/// A rule that is exact up to `degree`, or one of lower degree if a fragment is so small that it is
/// as good: polynomials of high degree on a cell are nearly of low degree on a small part of it.
/// \param size of the fragment along the axes, in units of the cell width
inline const Padded_rule& rule_for_size(double size, int degree) {
  const int sufficient = size < 0.3 ? 4 : size < 0.6 ? 6 : 8;
  return Padded_rule::of_degree((std::min)(degree, sufficient));
}

/// A piece of a patch that is not flat, and its fragment in a cell.
class Piece_of_patch {
public:
  Piece_of_patch(const Octree_3& octree, const Cell_3& cell, std::uint32_t piece)
    : m_octree(octree), m_face(octree.division()->face(piece)) {
    const Triangulated_surface_3& surface = octree.surface();
    const Divided_surface& division = *octree.division();
    const double h = octree.cell_width(octree.depth());
    const auto in_cells = [h](const Vector_3& v) {
      return Cell_patch::Vector{v.x() / h, v.y() / h, v.z() / h};
    };
    const Point_3& corner = surface.point(m_face, 0);
    const Surface_patches::Controls& controls = surface.patches().controls(m_face);
    for(std::size_t k = 0; k < controls.size(); ++k)
      m_patch.controls[k] = in_cells(controls[k]);
    m_patch.origin = octree.grid_coordinates(octree.depth(), corner);
    m_patch.u = in_cells(surface.point(m_face, 1) - corner);
    m_patch.v = in_cells(surface.point(m_face, 2) - corner);
    m_patch.area_factor = division.fraction(piece) * h * h / division.pieces().area(piece);
    for(int axis = 0; axis < 3; ++axis)
      m_patch.origin[axis] -= cell.index[axis];

    const Fragment fragment = octree.fragment(cell, piece);
    std::array<double, 3> low, high;
    for(std::size_t i = 0; i < fragment.size; ++i) {
      const Fragment_corner& c = fragment.corners[i];
      for(int axis = 0; axis < 3; ++axis) {
        const double t = m_positions[i][axis] = c.position[axis] - cell.index[axis];
        low[axis] = i == 0 ? t : (std::min)(low[axis], t);
        high[axis] = i == 0 ? t : (std::max)(high[axis], t);
      }
      const auto place = division.location(piece, c.barycentric).barycentric;
      m_places[i] = {place[1], place[2]};
    }
    m_number_of_corners = fragment.size;
    for(int axis = 0; axis < 3 && fragment.size > 0; ++axis)
      m_size = (std::max)(m_size, high[axis] - low[axis]);
  }

  /// calls `visit(nodes)` for the nodes of a rule on the triangles of the fragment
  /// \param degree of polynomials for which it is exact, or as good as exact
  template <class Visitor> void visit_nodes(int degree, Visitor&& visit) const {
    const Padded_rule& rule = rule_for_size(m_size, degree);
    Patch_nodes nodes;
    for(std::size_t i = 2; i < m_number_of_corners; ++i) {
      const Patch_triangle triangle = {
          {m_places[0], m_places[i - 1], m_places[i]},
          triangle_area(m_positions[0], m_positions[i - 1], m_positions[i])};
      if(!(triangle.area > 0))
        continue;
      set_patch_nodes(m_patch, triangle, rule, nodes);
      visit(nodes);
    }
  }

  /// adds nodes to those of a sheet
  void add(const Patch_nodes& patch_nodes, Integration_nodes& nodes) const {
    const Triangulated_surface_3& surface = m_octree.surface();
    const double h = m_octree.cell_width(m_octree.depth());
    const Point_3& corner = surface.point(m_face, 0);
    const auto& [x, y, z] = patch_nodes.positions;
    const auto& [nx, ny, nz] = patch_nodes.normals;
    Surface_point p;
    p.face = m_face;
    p.vertices = surface.triangle(m_face);
    p.polygon = surface.polygon(m_face);
    for(std::size_t i = 0; i < patch_nodes.size; ++i) {
      const double b1 = patch_nodes.places[0][i], b2 = patch_nodes.places[1][i];
      p.barycentric = {1 - b1 - b2, b1, b2};
      p.point = corner + h * Vector_3(x[i] - m_patch.origin[0], y[i] - m_patch.origin[1],
                                      z[i] - m_patch.origin[2]);
      p.normal = Vector_3(nx[i], ny[i], nz[i]);
      nodes.add(p, {x[i], y[i], z[i]}, patch_nodes.weights[i]);
    }
  }

private:
  const Octree_3& m_octree;
  std::size_t m_face;
  Cell_patch m_patch;
  // corners of the fragment: local coordinates, barycentric ones in the face
  std::size_t m_number_of_corners;
  std::array<std::array<double, 3>, Fragment::capacity> m_positions;
  std::array<std::array<double, 2>, Fragment::capacity> m_places;
  double m_size = 0;
};

/// adds the nodes of a piece that is a part of the surface itself
inline void add_flat_piece(const Octree_3& octree, const Cell_3& cell, std::uint32_t piece,
                           const Padded_rule& rule, Integration_nodes& nodes) {
  const Divided_surface& division = *octree.division();
  const auto name_face = [&](Integration_node_block& block) {
    for(std::size_t i = 0; i < block.size; ++i) {
      Surface_point& p = block.points[i];
      static_cast<Surface_location&>(p) = division.location(piece, p.barycentric);
      p.vertices = octree.surface().triangle(p.face);
      p.polygon = octree.surface().polygon(p.face);
      nodes.add(p, block.position(i), block.weights[i], block.metrics[i]);
    }
  };
  const Integration_nodes::Consumer consumer(name_face);
  Integration_nodes own(consumer);
  visit_fragment(octree, cell, piece,
                 [&](const auto&... fragment) { add_fragment_nodes(fragment..., rule, own); });
  own.flush();
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
  for(std::uint32_t piece : m_octree->faces(sheet)) {
    if(m_octree->division()->is_flat(piece)) {
      internal::add_flat_piece(*m_octree, cell, piece, rule, nodes);
      continue;
    }
    const internal::Piece_of_patch of_patch(*m_octree, cell, piece);
    of_patch.visit_nodes(degree,
                         [&](const internal::Patch_nodes& own) { of_patch.add(own, nodes); });
  }
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void
Patch_cubature::add_moments(std::size_t sheet, const internal::Factors_of_face* factors,
                            internal::Sheet_integrals& integrals) const {
  const Triangulated_surface_3& pieces = m_octree->pieces();
  const Cell_3 cell = m_octree->cell(m_octree->depth(), sheet);
  internal::Moment_nodes nodes;
  for(std::uint32_t piece : m_octree->faces(sheet)) {
    const double weight = factors ? (*factors)(m_octree->division()->face(piece)).mass_weight : 1;
    if(m_octree->division()->is_flat(piece)) {
      const Fragment fragment = m_octree->fragment(cell, piece);
      const Vector_3 normal = pieces.normal(piece);
      internal::add_fragment(fragment, cell.index, tangent_projector(normal), integrals.moments,
                             weight, 1, integrals.degree);
      integrals.add_normal(normal, fragment.double_area() / 2);
      continue;
    }
    internal::Piece_of_patch(*m_octree, cell, piece)
        .visit_nodes(integrals.degree, [&](const internal::Patch_nodes& own) {
          if(nodes.size + own.padded_size > internal::Moment_nodes::capacity) {
            internal::add_moments(nodes, integrals.moments);
            nodes.size = 0;
          }
          internal::append(own, weight, nodes, integrals.normals);
        });
  }
  internal::add_moments(nodes, integrals.moments);
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
