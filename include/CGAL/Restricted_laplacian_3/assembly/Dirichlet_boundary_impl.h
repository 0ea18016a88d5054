// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_DIRICHLET_BOUNDARY_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_DIRICHLET_BOUNDARY_IMPL_H

#include <CGAL/Restricted_laplacian_3/assembly/Dirichlet_boundary.h>
#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/symmetric_eigenpairs.h>
#include <CGAL/Restricted_laplacian_3/integration/cubature.h>
#include <CGAL/Restricted_laplacian_3/integration/shared/sheet_integrals.h>
#include <CGAL/Restricted_laplacian_3/octree/shared/wall_crossings.h>
#include <CGAL/Restricted_laplacian_3/surface/Surface_seams.h>

#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
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

/// the largest eigenvalue \f$\lambda\f$ of \f$A x = \lambda B x\f$ for positive semi-definite
/// matrices, on the complement of the kernel of \f$B\f$; infinity if \f$B\f$ is 0
/// \throws Numerical_error if there is none that is finite
inline double largest_generalized_eigenvalue(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  // functions with less energy than this, relative, vanish on the sheet
  constexpr double relative_cutoff = 1e-10;
  constexpr const char* what = "a matrix at the boundary";
  const Symmetric_eigenpairs of_b = symmetric_eigenpairs(b, what);
  const double cutoff = relative_cutoff * of_b.values.maxCoeff();
  const Eigen::Index rank = (of_b.values.array() > cutoff).count();
  if(rank == 0)
    return std::numeric_limits<double>::infinity();
  const Eigen::MatrixXd basis =
      of_b.vectors.rightCols(rank) * of_b.values.tail(rank).cwiseSqrt().cwiseInverse().asDiagonal();
  return symmetric_eigenpairs(basis.transpose() * a * basis, what).values.maxCoeff();
}

inline Eigen::Map<const Eigen::Matrix<double, Tensor_basis_3::size, 1>>
as_vector(const Tensor_basis_3::Values& values) {
  return Eigen::Map<const Eigen::Matrix<double, Tensor_basis_3::size, 1>>(values.data());
}

} // namespace internal

CGAL_RESTRICTED_LAPLACIAN_3_INLINE
Dirichlet_boundary::Dirichlet_boundary(const Spline_space_3& space) : m_space(space) {
  add_sides([](const Surface_point&) { return true; });
  if(m_nodes.empty())
    throw Parameter_error("boundary_values", "are given, but the surface has no boundary");
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE
Dirichlet_boundary::Dirichlet_boundary(
    const Spline_space_3& space, const std::function<bool(const Surface_point&)>& is_prescribed)
  : m_space(space) {
  add_sides(is_prescribed);
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void
Dirichlet_boundary::add_sides(const std::function<bool(const Surface_point&)>& is_prescribed) {
  for(const internal::Face_side& side : internal::boundary_sides(m_space))
    if(is_prescribed(middle(side.face, side.number)))
      add_side(side.face, side.number);
  std::stable_sort(m_nodes.begin(), m_nodes.end(),
                   [](const Node& a, const Node& b) { return a.sheet < b.sheet; });
  for_each_sheet([&](std::size_t first, std::size_t last) { set_beta(first, last); });
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void Dirichlet_boundary::add_to_matrix(Sparse_matrix& a) const {
  for_each_sheet([&](std::size_t first, std::size_t last) {
    Eigen::Matrix<double, Tensor_basis_3::size, Tensor_basis_3::size> block;
    block.setZero();
    for(std::size_t k = first; k < last; ++k) {
      const Node& node = m_nodes[k];
      const Tensor_basis_3::Values values = Tensor_basis_3::values(node.t),
                                   derivatives = conormal_derivatives(node);
      const auto b = internal::as_vector(values), d = internal::as_vector(derivatives);
      block += node.weight * (node.beta * b * b.transpose() -
                              node.flux * (b * d.transpose() + d * b.transpose()));
    }
    for_each_element(elements(m_nodes[first]), [&](int j, std::uint32_t column) {
      for_each_element(elements(m_nodes[first]),
                       [&](int i, std::uint32_t row) { a.coeffRef(row, column) += block(i, j); });
    });
  });
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Eigen::VectorXd
Dirichlet_boundary::load(const Surface_function_view& g) const {
  Eigen::VectorXd load = Eigen::VectorXd::Zero(m_space.dimension());
  for(const Node& node : m_nodes) {
    const Tensor_basis_3::Values b = Tensor_basis_3::values(node.t), d = conormal_derivatives(node);
    const double weighted = node.weight * value(g, node);
    for_each_element(elements(node), [&](int i, std::uint32_t element) {
      load[element] += weighted * (node.beta * b[i] - node.flux * d[i]);
    });
  }
  return load;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Eigen::MatrixXd Dirichlet_boundary::conormal_loads() const {
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

CGAL_RESTRICTED_LAPLACIAN_3_INLINE double
Dirichlet_boundary::mean(const Surface_function_view& g) const {
  double sum = 0;
  for(const Node& node : m_nodes)
    sum += node.weight * value(g, node);
  return m_length > 0 ? sum / m_length : 0;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Surface_point Dirichlet_boundary::middle(std::size_t face,
                                                                            int side) const {
  Surface_location location;
  location.face = face;
  location.barycentric.fill(0);
  location.barycentric[side] = location.barycentric[(side + 1) % 3] = 0.5;
  if(const internal::Divided_surface* const division = m_space.octree().division())
    location = division->location(face, location.barycentric);
  return m_space.surface().surface_point(location);
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE double
Dirichlet_boundary::root_mean_square_error(const Eigen::VectorXd& coefficients,
                                           const Surface_function_view& g) const {
  double sum = 0;
  for(const Node& node : m_nodes) {
    const Tensor_basis_3::Values b = Tensor_basis_3::values(node.t);
    double difference = -value(g, node);
    for_each_element(elements(node), [&](int i, std::uint32_t element) {
      difference += coefficients[element] * b[i];
    });
    sum += node.weight * difference * difference;
  }
  return std::sqrt(sum / m_length);
}

/// cuts a side of a face at the walls of the finest cells
CGAL_RESTRICTED_LAPLACIAN_3_INLINE void Dirichlet_boundary::add_side(std::size_t face, int side) {
  // 7 nodes integrate degree 13, products of elements along a line have degree 12
  using Rule = boost::math::quadrature::gauss<double, 7>;
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
  node.beta = node.flux = 0;
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
    for(std::size_t k = 0; k < Rule::abscissa().size(); ++k) {
      add(Rule::abscissa()[k], Rule::weights()[k]);
      if(Rule::abscissa()[k] != 0)
        add(-Rule::abscissa()[k], Rule::weights()[k]);
    }
  }
}

/// From a side of a piece of a patch to the curve over it: sets the location on the surface, the
/// weight and the conormal.
CGAL_RESTRICTED_LAPLACIAN_3_INLINE void
Dirichlet_boundary::move_to_patch(std::size_t piece, int side, Node& node) const {
  const internal::Divided_surface& division = *m_space.octree().division();
  const Triangulated_surface_3 &surface = m_space.surface(), &pieces = division.pieces();
  std::array<double, 3> begin = {0, 0, 0}, end = {0, 0, 0};
  begin[side] = end[(side + 1) % 3] = 1;
  const std::array<double, 3> from = division.location(piece, begin).barycentric,
                              to = division.location(piece, end).barycentric;
  node.location = division.location(piece, node.location.barycentric);
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
Dirichlet_boundary::sheet_of_piece(const Surface_location& begin,
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
                        std::to_string(division ? division->face(begin.face) : begin.face) +
                        " lies on no part of the surface");
}

/// conormal derivatives of the elements of the cell at a node
CGAL_RESTRICTED_LAPLACIAN_3_INLINE Tensor_basis_3::Values
Dirichlet_boundary::conormal_derivatives(const Node& node) const {
  const double h = m_space.octree().cell_width(m_space.depth());
  const auto gradients = Tensor_basis_3::gradients(node.t);
  Tensor_basis_3::Values result;
  for(std::size_t i = 0; i < result.size(); ++i)
    result[i] = (node.conormal.x() * gradients[0][i] + node.conormal.y() * gradients[1][i] +
                 node.conormal.z() * gradients[2][i]) /
                h;
  return result;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE double Dirichlet_boundary::value(const Surface_function_view& g,
                                                                    const Node& node) const {
  const Surface_point point = m_space.surface().surface_point(node.location);
  double result;
  g(&point, 1, &result);
  if(!std::isfinite(result))
    throw Parameter_error("boundary_values", "have a value that is not a finite number in face " +
                                                 std::to_string(point.face));
  return result;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void Dirichlet_boundary::for_each_sheet(
    internal::Function_view<void(std::size_t, std::size_t)> visit) const {
  for(std::size_t first = 0, last = 0; first < m_nodes.size(); first = last) {
    while(last < m_nodes.size() && m_nodes[last].sheet == m_nodes[first].sheet)
      ++last;
    visit(first, last);
  }
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void Dirichlet_boundary::set_beta(std::size_t first,
                                                                     std::size_t last) {
  constexpr int size = Tensor_basis_3::size;
  Eigen::MatrixXd boundary = Eigen::MatrixXd::Zero(size, size);
  for(std::size_t k = first; k < last; ++k) {
    const Tensor_basis_3::Values derivatives = conormal_derivatives(m_nodes[k]);
    const auto d = internal::as_vector(derivatives);
    boundary += m_nodes[k].weight * d * d.transpose();
  }
  internal::Sheet_integrals integrals;
  integrals.clear();
  internal::add_sheet_integrals(m_space.surface(), m_space.integration(), nullptr,
                                m_nodes[first].sheet, integrals);
  internal::Cell_block block;
  internal::stiffness_block(integrals.moments, block);
  // a sheet without energy, by underflow, gets the largest penalty and no flux
  const double lambda = internal::largest_generalized_eigenvalue(
      boundary, Eigen::Map<const Eigen::MatrixXd>(block.data(), size, size));
  const double largest = largest_penalty / m_space.octree().cell_width(m_space.depth());
  const double beta = (std::min)(2 * lambda, largest);
  for(std::size_t k = first; k < last; ++k) {
    m_nodes[k].beta = beta;
    m_nodes[k].flux = beta < 2 * lambda ? std::sqrt(beta / (2 * lambda)) : 1;
  }
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_DIRICHLET_BOUNDARY_IMPL_H
