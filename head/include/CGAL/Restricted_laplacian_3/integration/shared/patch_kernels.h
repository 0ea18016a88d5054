// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_SHARED_PATCH_KERNELS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_SHARED_PATCH_KERNELS_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/vector_lanes.h>
#include <CGAL/Restricted_laplacian_3/integration/internal/Padded_rule.h>
#include <CGAL/Restricted_laplacian_3/integration/shared/sheet_kernels.h>

#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// The patch of a face, see `Surface_patches`, as a cell sees it: in units of its width.
struct Cell_patch {
  using Vector = std::array<double, 3>;

  std::array<Vector, 7> controls;
  /// local coordinates of the first corner of the face, and the ways from there to the two others
  Vector origin, u, v;
  /// the area of a fragment in barycentric coordinates of the face, over its own area
  double area_factor;
};

/// A triangle of a fragment: the last two barycentric coordinates of its corners in the face, and
/// its area in units of the squared cell width.
struct Patch_triangle {
  std::array<std::array<double, 2>, 3> corners;
  double area;
};

/// The nodes of a rule on a triangle of a fragment, moved to the patch.
struct alignas(64) Patch_nodes {
  static constexpr std::size_t capacity = 32;
  using Numbers = std::array<double, capacity>;

  /// number of nodes, and with those up to a multiple of four, whose weights are 0
  std::size_t size, padded_size;
  /// local coordinates in the cell, and unit normals
  std::array<Numbers, 3> positions, normals;
  /// areas in units of the squared cell width
  Numbers weights;
  /// the last two barycentric coordinates in the face
  std::array<Numbers, 2> places;
};

namespace plain {

inline void set_patch_nodes(const Cell_patch& patch, const Patch_triangle& triangle,
                            const Padded_rule& rule, Patch_nodes& nodes) {
  const auto& [p, q, r] = triangle.corners;
  for(std::size_t i = 0; i < rule.padded_size(); ++i) {
    const double b0 = rule.b0[i], b1 = rule.b1[i], b2 = rule.b2[i],
                 y = b0 * p[0] + b1 * q[0] + b2 * r[0], z = b0 * p[1] + b1 * q[1] + b2 * r[1],
                 x = 1 - y - z;
    const double xx = 3 * x * x, yy = 3 * y * y, zz = 3 * z * z, xy = 6 * x * y, yz = 6 * y * z,
                 zx = 6 * z * x;
    // of the controls in the patch, and in its derivatives along the two sides
    const std::array<double, 7> weights = {xx * y, yy * x, yy * z, zz * y, zz * x, xx * z, xy * z},
                                along_u = {xx - xy, xy - yy, yz, zz, -zz, -zx, zx - yz},
                                along_v = {-xy, -yy, yy, yz, zx - zz, xx - zx, xy - yz};
    Cell_patch::Vector u = patch.u, v = patch.v;
    for(int axis = 0; axis < 3; ++axis) {
      double position = patch.origin[axis] + y * patch.u[axis] + z * patch.v[axis];
      for(int k = 0; k < 7; ++k) {
        position += weights[k] * patch.controls[k][axis];
        u[axis] += along_u[k] * patch.controls[k][axis];
        v[axis] += along_v[k] * patch.controls[k][axis];
      }
      nodes.positions[axis][i] = position;
    }
    const std::array<double, 3> n = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                                     u[0] * v[1] - u[1] * v[0]};
    const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    for(int axis = 0; axis < 3; ++axis)
      nodes.normals[axis][i] = length > 0 ? n[axis] / length : 0;
    nodes.weights[i] = rule.weight[i] * triangle.area * patch.area_factor / 2 * length;
    nodes.places[0][i] = y;
    nodes.places[1][i] = z;
  }
}

inline void append(const Patch_nodes& nodes, double mass_weight, Moment_nodes& to,
                   Symmetric_tensor_3& normals) {
  for(std::size_t i = 0; i < nodes.size; ++i) {
    const double w = nodes.weights[i], x = nodes.normals[0][i], y = nodes.normals[1][i],
                 z = nodes.normals[2][i];
    const Symmetric_tensor_3 nn = {w * x * x, w * y * y, w * z * z,
                                   w * x * y, w * x * z, w * y * z};
    for(int k = 0; k < 6; ++k)
      normals[k] += nn[k];
    for(int axis = 0; axis < 3; ++axis)
      to.positions[axis][to.size] = nodes.positions[axis][i];
    to.factors[to.size++] = {nn[1] + nn[2], nn[0] + nn[2], nn[0] + nn[1],   -nn[3],
                             -nn[4],        -nn[5],        mass_weight * w, w};
  }
}

} // namespace plain

#ifdef CGAL_RESTRICTED_LAPLACIAN_3_HAS_LANES
namespace lanes {

CGAL_RESTRICTED_LAPLACIAN_3_LANES_FUNCTION inline void
set_patch_nodes(const Cell_patch& patch, const Patch_triangle& triangle, const Padded_rule& rule,
                Patch_nodes& nodes) {
  const auto& [p, q, r] = triangle.corners;
  for(std::size_t i = 0; i < rule.padded_size(); i += 4) {
    const Lanes b0 = load(rule.b0.data() + i), b1 = load(rule.b1.data() + i),
                b2 = load(rule.b2.data() + i), y = b0 * p[0] + b1 * q[0] + b2 * r[0],
                z = b0 * p[1] + b1 * q[1] + b2 * r[1], x = 1 - y - z;
    const Lanes xx = 3 * x * x, yy = 3 * y * y, zz = 3 * z * z, xy = 6 * x * y, yz = 6 * y * z,
                zx = 6 * z * x;
    const Lanes weights[7] = {xx * y, yy * x, yy * z, zz * y, zz * x, xx * z, xy * z},
                along_u[7] = {xx - xy, xy - yy, yz, zz, -zz, -zx, zx - yz},
                along_v[7] = {-xy, -yy, yy, yz, zx - zz, xx - zx, xy - yz};
    Lanes u[3], v[3];
    for(int axis = 0; axis < 3; ++axis) {
      Lanes position = patch.origin[axis] + y * patch.u[axis] + z * patch.v[axis];
      u[axis] = along_u[0] * patch.controls[0][axis] + patch.u[axis];
      v[axis] = along_v[0] * patch.controls[0][axis] + patch.v[axis];
      position += weights[0] * patch.controls[0][axis];
      for(int k = 1; k < 7; ++k) {
        const double control = patch.controls[k][axis];
        position += weights[k] * control;
        u[axis] += along_u[k] * control;
        v[axis] += along_v[k] * control;
      }
      store(position, nodes.positions[axis].data() + i);
    }
    const Lanes n[3] = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                        u[0] * v[1] - u[1] * v[0]},
                squared = n[0] * n[0] + n[1] * n[1] + n[2] * n[2];
    Lanes length, inverse;
    for(int k = 0; k < 4; ++k) {
      length[k] = std::sqrt(squared[k]);
      inverse[k] = length[k] > 0 ? 1 / length[k] : 0;
    }
    for(int axis = 0; axis < 3; ++axis)
      store(n[axis] * inverse, nodes.normals[axis].data() + i);
    store(load(rule.weight.data() + i) * (triangle.area * patch.area_factor / 2) * length,
          nodes.weights.data() + i);
    store(y, nodes.places[0].data() + i);
    store(z, nodes.places[1].data() + i);
  }
}

CGAL_RESTRICTED_LAPLACIAN_3_LANES_FUNCTION inline void append(const Patch_nodes& nodes,
                                                              double mass_weight, Moment_nodes& to,
                                                              Symmetric_tensor_3& normals) {
  for(std::size_t i = 0; i < nodes.padded_size; i += 4) {
    const Lanes w = load(nodes.weights.data() + i), x = load(nodes.normals[0].data() + i),
                y = load(nodes.normals[1].data() + i), z = load(nodes.normals[2].data() + i);
    const Lanes nn[6] = {w * x * x, w * y * y, w * z * z, w * x * y, w * x * z, w * y * z};
    for(int k = 0; k < 6; ++k)
      normals[k] += (nn[k][0] + nn[k][1]) + (nn[k][2] + nn[k][3]);
    for(int axis = 0; axis < 3; ++axis)
      store(load(nodes.positions[axis].data() + i), to.positions[axis].data() + to.size + i);
    Lanes low[4], high[4];
    transpose(nn[1] + nn[2], nn[0] + nn[2], nn[0] + nn[1], -nn[3], low[0], low[1], low[2], low[3]);
    transpose(-nn[4], -nn[5], mass_weight * w, w, high[0], high[1], high[2], high[3]);
    for(int k = 0; k < 4; ++k) {
      double* const factors = to.factors[to.size + i + static_cast<std::size_t>(k)].data();
      store(low[k], factors);
      store(high[k], factors + 4);
    }
  }
  to.size += nodes.size;
}

} // namespace lanes
#endif

/// Moves the nodes of a rule on a triangle of a fragment to the patch.
inline void set_patch_nodes(const Cell_patch& patch, const Patch_triangle& triangle,
                            const Padded_rule& rule, Patch_nodes& nodes) {
  nodes.size = rule.size;
  nodes.padded_size = rule.padded_size();
  CGAL_RESTRICTED_LAPLACIAN_3_BEST(set_patch_nodes(patch, triangle, rule, nodes));
}

/// Adds nodes to others in the same cell; there must be place for them and those of weight 0.
/// \param mass_weight factor of the moments of the mass
/// \param normals receives the integral of \f$n n^T\f$
inline void append(const Patch_nodes& nodes, double mass_weight, Moment_nodes& to,
                   Symmetric_tensor_3& normals) {
  CGAL_RESTRICTED_LAPLACIAN_3_BEST(append(nodes, mass_weight, to, normals));
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_SHARED_PATCH_KERNELS_H
