// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_DIRICHLET_BOUNDARY_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_DIRICHLET_BOUNDARY_IMPL_H

#include <CGAL/Restricted_laplacian_3/assembly/Dirichlet_boundary.h>
#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/symmetric_eigenpairs.h>
#include <CGAL/Restricted_laplacian_3/integration/cubature.h>
#include <CGAL/Restricted_laplacian_3/integration/shared/sheet_integrals.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

namespace internal {

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

} // namespace internal

CGAL_RESTRICTED_LAPLACIAN_3_INLINE
Dirichlet_boundary::Dirichlet_boundary(const Spline_space_3& space)
  : Dirichlet_boundary(Boundary_integration(space)) {
  if(m_penalties.empty())
    throw Parameter_error("boundary_values", "are given, but the surface has no boundary");
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE
Dirichlet_boundary::Dirichlet_boundary(Boundary_integration boundary)
  : m_boundary(std::move(boundary)) {
  m_penalties.reserve(m_boundary.nodes().size());
  for_each_sheet(
      [&](std::size_t first, std::size_t last) { m_penalties.resize(last, penalty(first, last)); });
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void Dirichlet_boundary::add_to_matrix(Sparse_matrix& a) const {
  for_each_sheet([&](std::size_t first, std::size_t last) {
    internal::Cell_block block = {};
    for(std::size_t k = first; k < last; ++k) {
      const Boundary_integration::Node& node = m_boundary.nodes()[k];
      const auto [beta, flux] = m_penalties[k];
      const Tensor_basis_3::Values b = Tensor_basis_3::values(node.t),
                                   d = m_boundary.conormal_derivatives(node);
      for(int j = 0; j < Tensor_basis_3::size; ++j)
        for(int i = 0; i < Tensor_basis_3::size; ++i)
          block[Tensor_basis_3::size * j + i] +=
              node.weight * (beta * b[i] * b[j] - flux * (b[i] * d[j] + d[i] * b[j]));
    }
    const Cell_elements& elements = m_boundary.elements(m_boundary.nodes()[first]);
    for_each_element(elements, [&](int j, std::uint32_t column) {
      for_each_element(elements, [&](int i, std::uint32_t row) {
        a.coeffRef(row, column) += block[Tensor_basis_3::size * j + i];
      });
    });
  });
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Eigen::VectorXd
Dirichlet_boundary::load(const Surface_function_view& g) const {
  const Eigen::VectorXd values = this->values(g);
  Eigen::VectorXd load =
      Eigen::VectorXd::Zero(static_cast<Eigen::Index>(m_boundary.space().dimension()));
  for(std::size_t k = 0; k < m_penalties.size(); ++k) {
    const Boundary_integration::Node& node = m_boundary.nodes()[k];
    const Penalty& penalty = m_penalties[k];
    const Tensor_basis_3::Values b = Tensor_basis_3::values(node.t),
                                 d = m_boundary.conormal_derivatives(node);
    const double weighted = node.weight * values[static_cast<Eigen::Index>(k)];
    for_each_element(m_boundary.elements(node), [&](int i, std::uint32_t element) {
      load[element] += weighted * (penalty.beta * b[i] - penalty.flux * d[i]);
    });
  }
  return load;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE double
Dirichlet_boundary::mean(const Surface_function_view& g) const {
  const Eigen::VectorXd values = this->values(g);
  double sum = 0;
  for(std::size_t k = 0; k < m_penalties.size(); ++k)
    sum += m_boundary.nodes()[k].weight * values[static_cast<Eigen::Index>(k)];
  return length() > 0 ? sum / length() : 0;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE double
Dirichlet_boundary::root_mean_square_error(const Eigen::VectorXd& coefficients,
                                           const Surface_function_view& g) const {
  Eigen::VectorXd differences = -values(g);
  double sum = 0;
  for(std::size_t k = 0; k < m_penalties.size(); ++k) {
    const Boundary_integration::Node& node = m_boundary.nodes()[k];
    const Tensor_basis_3::Values b = Tensor_basis_3::values(node.t);
    double& difference = differences[static_cast<Eigen::Index>(k)];
    for_each_element(m_boundary.elements(node), [&](int i, std::uint32_t element) {
      difference += coefficients[element] * b[i];
    });
    sum += node.weight * difference * difference;
  }
  return std::sqrt(sum / length());
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void Dirichlet_boundary::for_each_sheet(
    internal::Function_view<void(std::size_t, std::size_t)> visit) const {
  const std::vector<Boundary_integration::Node>& nodes = m_boundary.nodes();
  for(std::size_t first = 0, last = 0; first < nodes.size(); first = last) {
    while(last < nodes.size() && nodes[last].sheet == nodes[first].sheet)
      ++last;
    visit(first, last);
  }
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Dirichlet_boundary::Penalty
Dirichlet_boundary::penalty(std::size_t first, std::size_t last) const {
  constexpr int size = Tensor_basis_3::size;
  const Spline_space_3& space = m_boundary.space();
  const std::vector<Boundary_integration::Node>& nodes = m_boundary.nodes();
  Eigen::MatrixXd fluxes = Eigen::MatrixXd::Zero(size, size);
  for(std::size_t k = first; k < last; ++k) {
    const Tensor_basis_3::Values d = m_boundary.conormal_derivatives(nodes[k]);
    for(int j = 0; j < size; ++j)
      for(int i = 0; i < size; ++i)
        fluxes(i, j) += nodes[k].weight * d[i] * d[j];
  }
  internal::Sheet_integrals integrals;
  integrals.clear();
  internal::add_sheet_integrals(space.surface(), space.integration_with_material(), nullptr,
                                nodes[first].sheet, integrals);
  internal::Cell_block block;
  internal::stiffness_block(integrals.moments, block);
  // a sheet without energy, by underflow, gets the largest penalty and no flux
  const double lambda = internal::largest_generalized_eigenvalue(
      fluxes, Eigen::Map<const Eigen::MatrixXd>(block.data(), size, size));
  const double largest =
      largest_penalty * integrals.mean_diffusion() / space.octree().cell_width(space.depth());
  const double beta = (std::min)(2 * lambda, largest);
  return {beta, beta < 2 * lambda ? std::sqrt(beta / (2 * lambda)) : 1};
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_DIRICHLET_BOUNDARY_IMPL_H
