// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_INTEGRATION_NODES_H
#define CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_INTEGRATION_NODES_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/Function_view.h>
#include <CGAL/Restricted_laplacian_3/surface/Surface_location.h>

#include <array>
#include <cstddef>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Operators
/// A symmetric 3 x 3 tensor: its components xx, yy, zz, xy, xz, yz.
using Symmetric_tensor_3 = std::array<double, 6>;

/// \cond SKIP_IN_MANUAL
/// \ingroup PkgRestrictedLaplacian3Operators
/// \f$I - n n^T\f$, the projector to the plane that is orthogonal to a unit vector: the tangent
/// metric of a surface. The diagonal is written without cancellation, \f$1 - n_x^2 = n_y^2 +
/// n_z^2\f$.
inline Symmetric_tensor_3 tangent_projector(const Vector_3& n) {
  const double xx = n.x() * n.x(), yy = n.y() * n.y(), zz = n.z() * n.z();
  return {yy + zz, xx + zz, xx + yy, -n.x() * n.y(), -n.x() * n.z(), -n.y() * n.z()};
}
/// \endcond

namespace internal {

/// \f$A\, v\f$
inline std::array<double, 3> product(const Symmetric_tensor_3& a, double x, double y, double z) {
  return {a[0] * x + a[3] * y + a[4] * z, a[3] * x + a[1] * y + a[5] * z,
          a[4] * x + a[5] * y + a[2] * z};
}

} // namespace internal

/// \cond SKIP_IN_MANUAL
/// \ingroup PkgRestrictedLaplacian3Operators
/// \f$P D P\f$ with \f$P = I - n n^T\f$: the part of a tensor that acts in the plane orthogonal to
/// a unit vector.
inline Symmetric_tensor_3 tangential_part(const Symmetric_tensor_3& d, const Vector_3& n) {
  // P D P = D - n q^T - q n^T with q = D n - (n^T D n / 2) n
  const auto [dx, dy, dz] = internal::product(d, n.x(), n.y(), n.z());
  const double half = (dx * n.x() + dy * n.y() + dz * n.z()) / 2;
  const double qx = dx - half * n.x(), qy = dy - half * n.y(), qz = dz - half * n.z();
  return {d[0] - 2 * n.x() * qx,          d[1] - 2 * n.y() * qy,
          d[2] - 2 * n.z() * qz,          d[3] - n.x() * qy - qx * n.y(),
          d[4] - n.x() * qz - qx * n.z(), d[5] - n.y() * qz - qy * n.z()};
}
/// \endcond

/// \cond SKIP_IN_MANUAL
/// \ingroup PkgRestrictedLaplacian3Operators
/// Some nodes of an integral over a sheet, array by array.
struct Integration_node_block {
  /// most nodes of a block
  static constexpr std::size_t capacity = 32;

  /// number of nodes
  std::size_t size = 0;
  /// where they are on the surface, with the unit normal there
  std::array<Surface_point, capacity> points;
  /// local coordinates in the cell of the sheet, axis by axis; 0 beyond `size`
  std::array<std::array<double, capacity>, 3> positions;
  /// the areas that they stand for, times the density, in units of the squared width of the finest
  /// cells; 0 beyond `size`
  std::array<double, capacity> weights;
  /// the areas themselves
  std::array<double, capacity> areas;
  /// the metrics \f$A\f$ of the energy \f$\int \nabla u^T A\, \nabla v\f$ there
  std::array<Symmetric_tensor_3, capacity> metrics;

  /// local coordinates of a node
  std::array<double, 3> position(std::size_t i) const {
    return {positions[0][i], positions[1][i], positions[2][i]};
  }
};
/// \endcond

/// \ingroup PkgRestrictedLaplacian3Operators
/// Takes the nodes of an integral over a sheet, one after the other, from a model of
/// `SurfaceIntegration_3`, and hands them on in blocks.
class Integration_nodes {
public:
  /// what takes a block; it may change what is in it
  using Consumer = internal::Function_view<void(Integration_node_block&)>;

  /// \param consumer is called with each full block, and must outlive this object
  explicit Integration_nodes(const Consumer& consumer) : m_consumer(consumer) {}

  /// Adds a node.
  /// \param point its place on the surface, with the unit normal \f$n\f$ there
  /// \param position local coordinate in the cell of the sheet: in \f$[0,1]^3\f$, or a little
  /// outside; elements are evaluated by their polynomial pieces in that cell, wherever it lies
  /// \param weight the area that it stands for, at least 0, in units of the squared width of the
  /// finest cells; or this area times a density
  /// \param metric \f$A\f$: \f$I - n n^T\f$ for the Laplace-Beltrami operator
  void add(const Surface_point& point, const std::array<double, 3>& position, double weight,
           const Symmetric_tensor_3& metric) {
    add(point, position, weight, metric, weight);
  }
  /// The same where the weight is an area times a density, with the area itself, by which the
  /// stabilization goes.
  void add(const Surface_point& point, const std::array<double, 3>& position, double weight,
           const Symmetric_tensor_3& metric, double area) {
    const std::size_t i = m_block.size;
    m_block.points[i] = point;
    for(int axis = 0; axis < 3; ++axis)
      m_block.positions[axis][i] = position[axis];
    m_block.weights[i] = weight;
    m_block.areas[i] = area;
    m_block.metrics[i] = metric;
    close_node();
  }
  /// The same with the metric \f$I - n n^T\f$.
  void add(const Surface_point& point, const std::array<double, 3>& position, double weight) {
    add(point, position, weight, tangent_projector(point.normal));
  }

  /// \cond
  // To write a node in place: number `size` of the block, all that `add()` takes; then close it.
  Integration_node_block& open_block() { return m_block; }
  void close_node() {
    if(++m_block.size == Integration_node_block::capacity)
      flush();
  }
  /// \endcond

  /// \cond
  // Hands on a block that another one was filled with, as it is; `size` nodes in it are set, and
  // the rest is 0 as `flush()` leaves it.
  void hand_on(Integration_node_block& block) {
    flush();
    m_consumer(block);
  }
  /// \endcond

  /// hands on what is left; called by who made this object
  void flush() {
    if(m_block.size == 0)
      return;
    for(std::size_t i = m_block.size; i < Integration_node_block::capacity; ++i) {
      for(auto& along_axis : m_block.positions)
        along_axis[i] = 0;
      m_block.weights[i] = 0;
    }
    m_consumer(m_block);
    m_block.size = 0;
  }

private:
  Consumer m_consumer;
  Integration_node_block m_block;
};

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_INTEGRATION_NODES_H
