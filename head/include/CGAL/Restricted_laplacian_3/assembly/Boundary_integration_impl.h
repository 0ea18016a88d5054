// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_BOUNDARY_INTEGRATION_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_BOUNDARY_INTEGRATION_IMPL_H

#include <CGAL/Restricted_laplacian_3/assembly/Boundary_integration.h>
#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/integration/shared/line_rule.h>
#include <CGAL/Restricted_laplacian_3/octree/shared/wall_crossings.h>
#include <CGAL/Restricted_laplacian_3/surface/Surface_seams.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

namespace internal {

CGAL_RESTRICTED_LAPLACIAN_3_INLINE std::vector<Face_side>
boundary_sides(const Spline_space_3& space) {
  const Triangulated_surface_3& surface = space.octree().pieces();
  const double h = space.octree().cell_width(space.depth());
  std::vector<Face_side> sides =
      Surface_seams(surface, Octree_3::thin_face_height * h,
                    space.options().joining_tolerance.value_or(-1), {}, space.options().is_parallel)
          .lone_sides();
  sides.erase(std::remove_if(sides.begin(), sides.end(),
                             [&](const auto& side) { return surface.is_degenerate(side.face); }),
              sides.end());
  return sides;
}

/// a location on a side of a face up to rounding, which may have left something of the coordinate
/// of the corner opposite to it
inline Surface_location on_side(Surface_location location) {
  *std::min_element(location.barycentric.begin(), location.barycentric.end()) = 0;
  return location;
}

} // namespace internal

CGAL_RESTRICTED_LAPLACIAN_3_INLINE
Boundary_integration::Boundary_integration(const Spline_space_3& space)
  : Boundary_integration(space, [](const Surface_point&) { return true; }) {}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Boundary_integration::Boundary_integration(
    const Spline_space_3& space, const std::function<bool(const Surface_point&)>& contains)
  : m_space(space) {
  for(const internal::Face_side& side : internal::boundary_sides(m_space))
    if(contains(middle(side.face, side.number)))
      add_side(side.face, side.number);
  std::stable_sort(m_nodes.begin(), m_nodes.end(),
                   [](const Node& a, const Node& b) { return a.sheet < b.sheet; });
  set_flux_directions();
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void Boundary_integration::set_flux_directions() {
  const std::vector<Surface_point> points = this->points();
  std::vector<Symmetric_tensor_3> tensors(points.size());
  m_space.material().diffusion_at(points.data(), points.size(), tensors.data());
  for(std::size_t k = 0; k < m_nodes.size(); ++k) {
    const Vector_3& n = m_nodes[k].conormal;
    const auto [x, y, z] = internal::product(tensors[k], n.x(), n.y(), n.z());
    m_nodes[k].flux_direction = m_space.material().is_trivial() ? n : Vector_3(x, y, z);
  }
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE std::vector<Surface_point> Boundary_integration::points() const {
  std::vector<Surface_point> result;
  result.reserve(m_nodes.size());
  for(const Node& node : m_nodes)
    result.push_back(m_space.surface().surface_point(node.location));
  return result;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Eigen::VectorXd
Boundary_integration::values(const Surface_function_view& g, const char* name) const {
  if(g.components() != 1)
    throw Parameter_error(name, "have " + std::to_string(g.components()) +
                                    " components, but must be numbers");
  const std::vector<Surface_point> points = this->points();
  Eigen::VectorXd result(static_cast<Eigen::Index>(points.size()));
  if(!points.empty())
    g(points.data(), points.size(), result.data());
  for(Eigen::Index k = 0; k < result.size(); ++k)
    if(!std::isfinite(result[k]))
      throw Parameter_error(name, "have a value that is not a finite number in face " +
                                      std::to_string(points[static_cast<std::size_t>(k)].polygon));
  return result;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Eigen::VectorXd
Boundary_integration::load(const Surface_function_view& flux) const {
  const Eigen::VectorXd values = this->values(flux, "boundary_flux");
  Eigen::VectorXd load = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(m_space.dimension()));
  for(std::size_t k = 0; k < m_nodes.size(); ++k) {
    const Tensor_basis_3::Values b = Tensor_basis_3::values(m_nodes[k].t);
    const double weighted = m_nodes[k].weight * values[static_cast<Eigen::Index>(k)];
    for_each_element(elements(m_nodes[k]),
                     [&](int i, std::uint32_t element) { load[element] += weighted * b[i]; });
  }
  return load;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Eigen::MatrixXd Boundary_integration::conormal_loads() const {
  Eigen::MatrixXd loads = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(m_space.dimension()), 3);
  for(const Node& node : m_nodes) {
    const Tensor_basis_3::Values b = Tensor_basis_3::values(node.t);
    const Eigen::RowVector3d conormal(node.conormal.x(), node.conormal.y(), node.conormal.z());
    for_each_element(elements(node), [&](int i, std::uint32_t element) {
      loads.row(element) += node.weight * b[i] * conormal;
    });
  }
  return loads;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Surface_point Boundary_integration::middle(std::size_t face,
                                                                              int side) const {
  Surface_location location;
  location.face = face;
  location.barycentric.fill(0);
  location.barycentric[side] = location.barycentric[(side + 1) % 3] = 0.5;
  if(const internal::Divided_surface* const division = m_space.octree().division())
    location = internal::on_side(division->location(face, location.barycentric));
  return m_space.surface().surface_point(location);
}

/// cuts a side of a face at the walls of the finest cells
CGAL_RESTRICTED_LAPLACIAN_3_INLINE void Boundary_integration::add_side(std::size_t face, int side) {
  const Octree_3& octree = m_space.octree();
  const Triangulated_surface_3& surface = octree.pieces();
  const int depth = octree.depth(), other = (side + 1) % 3;
  const Point_3 &p = surface.point(face, side), &q = surface.point(face, other);
  const std::vector<double> cuts = internal::wall_crossings(octree.grid_coordinates(depth, p),
                                                            octree.grid_coordinates(depth, q));
  const double length = std::sqrt((q - p).squared_length());
  if(length == 0)
    return;
  Node node;
  // the face lies to the left of its sides, seen from the tip of its normal
  node.conormal = CGAL::cross_product((q - p) / length, surface.normal(face));
  const auto location_at = [&](double s) {
    Surface_location location;
    location.face = face;
    location.barycentric.fill(0);
    location.barycentric[side] = 1 - s;
    location.barycentric[other] = s;
    return location;
  };
  for(std::size_t i = 1; i < cuts.size(); ++i) {
    const double center = (cuts[i] + cuts[i - 1]) / 2, half = (cuts[i] - cuts[i - 1]) / 2;
    if(half == 0)
      continue;
    node.sheet = sheet_of_piece(location_at(cuts[i - 1]), location_at(cuts[i]));
    const Cell_3 cell = octree.cell(depth, node.sheet);
    const auto add = [&](double s, double weight) {
      node.location = location_at(center + half * s);
      node.weight = weight * half * length;
      if(octree.division())
        move_to_patch(face, side, node);
      const auto z =
          octree.grid_coordinates(depth, m_space.surface().surface_point(node.location).point);
      for(int axis = 0; axis < 3; ++axis)
        node.t[axis] = z[axis] - cell.index[axis];
      m_length += node.weight;
      m_nodes.push_back(node);
    };
    // products of elements along a line have degree 12
    for(const auto& [s, weight] : internal::line_rule)
      add(s, weight);
  }
}

/// From a side of a piece of a patch to the curve over it: sets the location on the surface, the
/// weight and the conormal.
CGAL_RESTRICTED_LAPLACIAN_3_INLINE void
Boundary_integration::move_to_patch(std::size_t piece, int side, Node& node) const {
  const internal::Divided_surface& division = *m_space.octree().division();
  const Triangulated_surface_3 &surface = m_space.surface(), &pieces = division.pieces();
  std::array<double, 3> begin = {0, 0, 0}, end = {0, 0, 0};
  begin[side] = end[(side + 1) % 3] = 1;
  const std::array<double, 3> from = division.location(piece, begin).barycentric,
                              to = division.location(piece, end).barycentric;
  node.location = internal::on_side(division.location(piece, node.location.barycentric));
  const std::size_t face = node.location.face;
  if(surface.patches().is_flat(face))
    return;
  const Vector_3 tangent = surface.patches().derivative(
      face, {surface.point(face, 0), surface.point(face, 1), surface.point(face, 2)},
      node.location.barycentric, {to[0] - from[0], to[1] - from[1], to[2] - from[2]});
  const double length = std::sqrt(tangent.squared_length()),
               of_piece =
                   std::sqrt((pieces.point(piece, (side + 1) % 3) - pieces.point(piece, side))
                                 .squared_length());
  node.weight *= length / of_piece;
  node.conormal =
      CGAL::cross_product(tangent / length, surface.surface_point(node.location).normal);
}

/// The sheet of a piece of a side, between two walls. A short one at a corner of a cell, or at the
/// tip of a needle, may have lost its fragment to rounding: then a sheet of the same face that
/// touches it serves, or else the one that lies nearest to it along the line from its middle into
/// the face.
CGAL_RESTRICTED_LAPLACIAN_3_INLINE std::size_t
Boundary_integration::sheet_of_piece(const Surface_location& begin,
                                     const Surface_location& end) const {
  const int depth = m_space.depth();
  const std::size_t none = m_space.octree().number_of_sheets(depth);
  const auto sheet_at = [&](const Surface_location& location) {
    const Octree_3& octree = m_space.octree();
    return octree.locate(depth, octree.pieces().surface_point(location).point, location.face).first;
  };
  const auto between = [](const Surface_location& a, const Surface_location& b, double s) {
    Surface_location result = a;
    for(int i = 0; i < 3; ++i)
      result.barycentric[i] = (1 - s) * a.barycentric[i] + s * b.barycentric[i];
    return result;
  };
  const Surface_location middle = between(begin, end, 0.5);
  for(const Surface_location& location : {middle, begin, end})
    if(const std::size_t sheet = sheet_at(location); sheet != none)
      return sheet;
  Surface_location inside = middle;
  inside.barycentric.fill(1. / 3);
  for(double s = 1e-12; s <= 1; s *= 10)
    if(const std::size_t sheet = sheet_at(between(middle, inside, s)); sheet != none)
      return sheet;
  const internal::Divided_surface* const division = m_space.octree().division();
  throw Numerical_error("the boundary at face " +
                        std::to_string(m_space.surface().polygon(
                            division ? division->face(begin.face) : begin.face)) +
                        " lies on no part of the surface");
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Tensor_basis_3::Values
Boundary_integration::conormal_derivatives(const Node& node) const {
  const double h = m_space.octree().cell_width(m_space.depth());
  const auto gradients = Tensor_basis_3::gradients(node.t);
  Tensor_basis_3::Values result;
  for(std::size_t i = 0; i < result.size(); ++i)
    result[i] =
        (node.flux_direction.x() * gradients[0][i] + node.flux_direction.y() * gradients[1][i] +
         node.flux_direction.z() * gradients[2][i]) /
        h;
  return result;
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_BOUNDARY_INTEGRATION_IMPL_H
