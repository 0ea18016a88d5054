// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_MOVED_INTEGRATION_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_MOVED_INTEGRATION_IMPL_H

#include <CGAL/Restricted_laplacian_3/basis/Tensor_basis_3.h>
#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/problems/Moved_integration.h>
#include <CGAL/Restricted_laplacian_3/surface/surface_functions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// The degree of a rule for each of the fragments in a cell: with many of them each is small, and
/// what is integrated nearly linear on it.
inline int degree_of_moved_fragments(std::size_t number, int degree) {
  const int sufficient = number > 16 ? 2 : number > 6 ? 4 : number > 2 ? 6 : 8;
  return (std::min)(degree, sufficient);
}

/// The derivatives along the axes of three functions with these coefficients, times the cell width:
/// a column for each axis.
inline Eigen::Matrix3d derivatives_of_positions(const Eigen::Matrix<double, 27, 3>& coefficients,
                                                const std::array<double, 3>& t) {
  using Piece = std::array<double, 3>;
  std::array<Piece, 3> values, slopes;
  for(int axis = 0; axis < 3; ++axis) {
    values[axis] = B_spline_1::values(t[axis]);
    slopes[axis] = B_spline_1::derivatives(t[axis]);
  }
  Eigen::Matrix3d result;
  for(int k = 0; k < 3; ++k) {
    double dx = 0, dy = 0, dz = 0;
    const double* c = coefficients.data() + 27 * k;
    for(int z = 0; z < 3; ++z) {
      double plane_x = 0, plane_y = 0, plane = 0;
      for(int y = 0; y < 3; ++y, c += 3) {
        const double line = values[0][0] * c[0] + values[0][1] * c[1] + values[0][2] * c[2],
                     slope = slopes[0][0] * c[0] + slopes[0][1] * c[1] + slopes[0][2] * c[2];
        plane_x += values[1][y] * slope;
        plane_y += slopes[1][y] * line;
        plane += values[1][y] * line;
      }
      dx += values[2][z] * plane_x;
      dy += values[2][z] * plane_y;
      dz += slopes[2][z] * plane;
    }
    result.row(k) << dx, dy, dz;
  }
  return result;
}

/// the area factor, and the metric of the moved surface, of a node with a unit normal
/// \param derivatives of the positions, a column for each axis of space
inline std::pair<double, Symmetric_tensor_3> moved_metric(const Eigen::Matrix3d& derivatives,
                                                          const Vector_3& normal) {
  const auto [u, v] = tangent_axes(normal);
  const Eigen::Vector3d e1(u.x(), u.y(), u.z()), e2(v.x(), v.y(), v.z());
  const Eigen::Vector3d a = derivatives * e1, b = derivatives * e2;
  constexpr double smallest = 1e-12;
  const double aa = a.squaredNorm(), bb = b.squaredNorm(), ab = a.dot(b), trace = (aa + bb) / 2,
               determinant = (std::max)(a.cross(b).squaredNorm(),
                                        (std::max)(smallest * trace * trace, 1e-300));
  const Eigen::Matrix3d d = (bb * e1 * e1.transpose() + aa * e2 * e2.transpose() -
                             ab * (e1 * e2.transpose() + e2 * e1.transpose())) /
                            determinant;
  return {std::sqrt(determinant), {d(0, 0), d(1, 1), d(2, 2), d(0, 1), d(0, 2), d(1, 2)}};
}

} // namespace internal

CGAL_RESTRICTED_LAPLACIAN_3_INLINE
Moved_integration::Moved_integration(const Spline_space_3& space, const Eigen::MatrixXd& positions,
                                     Moved_metric metric)
  : m_space(space), m_metric(metric) {
  if(positions.rows() != static_cast<Eigen::Index>(space.dimension()) || positions.cols() != 3)
    throw Parameter_error("positions", "do not have the size of the space, or three columns");
  if(!positions.allFinite())
    throw Parameter_error("positions", "are not finite");
  m_positions =
      std::make_shared<const Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>>(positions);
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void
Moved_integration::add_nodes(std::size_t sheet, int degree, Integration_nodes& nodes) const {
  const int depth = m_space.depth();
  const double h = m_space.octree().cell_width(depth);
  Eigen::Matrix<double, 27, 3> coefficients = Eigen::Matrix<double, 27, 3>::Zero();
  for_each_element(m_space.elements(depth, sheet), [&](int i, std::uint32_t element) {
    coefficients.row(i) = m_positions->row(element) / h;
  });
  const int own_degree = internal::degree_of_moved_fragments(
      m_space.surface().is_point_set() ? 1 : m_space.octree().faces(sheet).size(), degree);
  m_space.integration().visit_nodes(sheet, own_degree, [&](Integration_node_block& block) {
    for(std::size_t i = 0; i < block.size; ++i) {
      const Vector_3& n = block.points[i].normal;
      const auto [factor, metric] = internal::moved_metric(
          internal::derivatives_of_positions(coefficients, block.position(i)), n);
      block.weights[i] *= factor;
      block.metrics[i] = metric;
      if(m_metric == Moved_metric::conformal) {
        block.metrics[i] = tangent_projector(n);
        for(double& component : block.metrics[i])
          component /= factor;
      }
    }
    nodes.hand_on(block);
  });
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_MOVED_INTEGRATION_IMPL_H
