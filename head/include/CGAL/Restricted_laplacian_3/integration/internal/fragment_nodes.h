// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_INTERNAL_FRAGMENT_NODES_H
#define CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_INTERNAL_FRAGMENT_NODES_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/vector_lanes.h>
#include <CGAL/Restricted_laplacian_3/integration/Integration_nodes.h>
#include <CGAL/Restricted_laplacian_3/integration/internal/Padded_rule.h>
#include <CGAL/Restricted_laplacian_3/integration/internal/cell_integrals.h>
#include <CGAL/Restricted_laplacian_3/integration/shared/Function_moments.h>
#include <CGAL/Restricted_laplacian_3/octree/clip_to_cells.h>
#include <CGAL/Restricted_laplacian_3/surface/Surface_location.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// What is linear on a fragment, at one of its corners: three local coordinates in the cell, three
/// barycentric ones in the triangle, three in space.
using Linear_values = std::array<double, 9>;

inline Linear_values linear_values(const Fragment_corner& corner, const std::array<int, 3>& cell,
                                   const std::array<Point_3, 3>& triangle) {
  const auto& b = corner.barycentric;
  Linear_values result;
  for(int axis = 0; axis < 3; ++axis) {
    result[axis] = corner.position[axis] - cell[axis];
    result[3 + axis] = b[axis];
    result[6 + axis] =
        b[0] * triangle[0][axis] + b[1] * triangle[1][axis] + b[2] * triangle[2][axis];
  }
  return result;
}

/// A triangle of a fragment, and what all of its nodes have in common.
struct Fragment_triangle {
  const Linear_values* corners[3];
  double area;
  Surface_point point; // but its place
  Symmetric_tensor_3 metric;
};

/// \param values those that are linear, at the node
inline void add_node(const Fragment_triangle& triangle, const Linear_values& values, double weight,
                     Integration_nodes& nodes) {
  Integration_node_block& block = nodes.open_block();
  const std::size_t i = block.size;
  for(int axis = 0; axis < 3; ++axis)
    block.positions[axis][i] = values[axis];
  block.weights[i] = block.areas[i] = weight;
  block.metrics[i] = triangle.metric;
  Surface_point& point = block.points[i];
  point.face = triangle.point.face;
  point.vertices = triangle.point.vertices;
  point.polygon = triangle.point.polygon;
  point.normal = triangle.point.normal;
  point.barycentric = {values[3], values[4], values[5]};
  point.point = Point_3(values[6], values[7], values[8]);
  nodes.close_node();
}

namespace plain {

inline void add_triangle_nodes(const Fragment_triangle& triangle, const Padded_rule& rule,
                               Integration_nodes& nodes) {
  const Linear_values &p = *triangle.corners[0], &q = *triangle.corners[1],
                      &r = *triangle.corners[2];
  for(std::size_t i = 0; i < rule.size; ++i) {
    Linear_values values;
    for(std::size_t k = 0; k < values.size(); ++k)
      values[k] = rule.b0[i] * p[k] + rule.b1[i] * q[k] + rule.b2[i] * r[k];
    add_node(triangle, values, rule.weight[i] * triangle.area, nodes);
  }
}

} // namespace plain

#ifdef CGAL_RESTRICTED_LAPLACIAN_3_HAS_LANES
namespace lanes {

/// four nodes at a time
CGAL_RESTRICTED_LAPLACIAN_3_LANES_FUNCTION inline void
add_triangle_nodes(const Fragment_triangle& triangle, const Padded_rule& rule,
                   Integration_nodes& nodes) {
  const Linear_values &p = *triangle.corners[0], &q = *triangle.corners[1],
                      &r = *triangle.corners[2];
  for(std::size_t first = 0; first < rule.size; first += 4) {
    const Lanes b0 = load(rule.b0.data() + first), b1 = load(rule.b1.data() + first),
                b2 = load(rule.b2.data() + first),
                weights = load(rule.weight.data() + first) * triangle.area;
    Lanes values[9];
    for(std::size_t k = 0; k < 9; ++k)
      values[k] = b0 * p[k] + b1 * q[k] + b2 * r[k];
    const std::size_t number = (std::min)(rule.size - first, std::size_t(4));
    for(std::size_t i = 0; i < number; ++i) {
      Linear_values of_node;
      for(std::size_t k = 0; k < 9; ++k)
        of_node[k] = values[k][i];
      add_node(triangle, of_node, weights[i], nodes);
    }
  }
}

} // namespace lanes
#endif

/// Adds the nodes of a rule on the triangles of a fragment, fanned out from its first corner.
/// \param triangle that the fragment is cut from
/// \param point what all nodes have in common: all but the place
inline void add_fragment_nodes(const Fragment& fragment, const std::array<int, 3>& cell,
                               const std::array<Point_3, 3>& triangle, const Surface_point& point,
                               const Padded_rule& rule, Integration_nodes& nodes) {
  std::array<Linear_values, Fragment::capacity> corners;
  for(std::size_t i = 0; i < fragment.size; ++i)
    corners[i] = linear_values(fragment.corners[i], cell, triangle);
  const auto position = [&corners](std::size_t i) {
    return std::array<double, 3>{corners[i][0], corners[i][1], corners[i][2]};
  };
  Fragment_triangle part{
      {&corners[0], nullptr, nullptr}, 0, point, tangent_projector(point.normal)};
  for(std::size_t i = 2; i < fragment.size; ++i) {
    part.corners[1] = &corners[i - 1];
    part.corners[2] = &corners[i];
    part.area = triangle_area(position(0), position(i - 1), position(i));
    CGAL_RESTRICTED_LAPLACIAN_3_BEST(add_triangle_nodes(part, rule, nodes));
  }
}

/// Adds a function that is linear on a fragment.
/// \param triangle,point as for `add_fragment_nodes()`
inline void add_fragment_function(const Fragment& fragment, const std::array<int, 3>& cell,
                                  const std::array<Point_3, 3>& triangle,
                                  const Surface_point& point, Function_moments& moments) {
  if(fragment.size < 3)
    return;
  std::array<std::array<double, 3>, Fragment::capacity> positions;
  std::array<Surface_point, Fragment::capacity> points;
  std::array<Symmetric_tensor_3, Fragment::capacity> metrics;
  std::fill_n(metrics.begin(), fragment.size, tangent_projector(point.normal));
  for(std::size_t i = 0; i < fragment.size; ++i) {
    const Linear_values corner = linear_values(fragment.corners[i], cell, triangle);
    positions[i] = {corner[0], corner[1], corner[2]};
    points[i] = point;
    points[i].barycentric = {corner[3], corner[4], corner[5]};
    points[i].point = Point_3(corner[6], corner[7], corner[8]);
  }
  const double* const values = moments.values_at(points.data(), fragment.size, metrics.data());
  const std::size_t number = moments.number_of_components();
  for(std::size_t i = 2; i < fragment.size; ++i) {
    const double area = triangle_area(positions[0], positions[i - 1], positions[i]);
    if(area > 0)
      moments.add({positions[0], positions[i - 1], positions[i]}, area,
                  {values, values + number * (i - 1), values + number * i});
  }
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_INTERNAL_FRAGMENT_NODES_H
