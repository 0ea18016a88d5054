// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_INTERNAL_BLOCK_EVALUATION_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_INTERNAL_BLOCK_EVALUATION_H

#include <CGAL/Restricted_laplacian_3/basis/B_spline_1.h>
#include <CGAL/Restricted_laplacian_3/basis/Tensor_basis_3.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// The functions \f$\sum_i H_{ik} b_i\f$ on one sheet of the finest level, at blocks of `N` points:
/// the loops over the points of a block are the innermost ones.
template <std::size_t N> class Block_evaluation {
public:
  using Values = std::array<double, N>;
  using Positions = std::array<Values, 3>;

  /// \param coefficients \f$H\f$; without columns there is no function
  Block_evaluation(const Spline_space_3& space, std::size_t sheet,
                   const Eigen::MatrixXd& coefficients)
    : m_coefficients(static_cast<std::size_t>(coefficients.cols()), Tensor_basis_3::Values{}) {
    for_each_element(space.elements(space.depth(), sheet), [&](int i, std::uint32_t element) {
      for(std::size_t k = 0; k < m_coefficients.size(); ++k)
        m_coefficients[k][i] = coefficients(element, static_cast<Eigen::Index>(k));
    });
  }

  std::size_t number_of_functions() const { return m_coefficients.size(); }

  /// \param t local coordinates in the cell, axis by axis
  void set_points(const Positions& t) {
    for(int axis = 0; axis < 3; ++axis)
      for(std::size_t j = 0; j < N; ++j) {
        const auto values = B_spline_1::values(t[axis][j]);
        const auto slopes = B_spline_1::derivatives(t[axis][j]);
        for(int p = 0; p < Tensor_basis_3::pieces; ++p) {
          m_values[axis][p][j] = values[p];
          m_slopes[axis][p][j] = slopes[p];
        }
      }
  }

  /// values of function `k` at the points
  Values values(std::size_t k) const {
    return sum(m_coefficients[k], m_values[0], m_values[1], m_values[2]);
  }
  /// derivatives of function `k` along an axis, times the cell width
  Values derivatives(std::size_t k, int axis) const {
    return sum(m_coefficients[k], (axis == 0 ? m_slopes : m_values)[0],
               (axis == 1 ? m_slopes : m_values)[1], (axis == 2 ? m_slopes : m_values)[2]);
  }

private:
  using Pieces = std::array<Values, Tensor_basis_3::pieces>;

  static Values sum(const Tensor_basis_3::Values& c, const Pieces& x, const Pieces& y,
                    const Pieces& z) {
    Values result = {};
    for(int pz = 0; pz < Tensor_basis_3::pieces; ++pz) {
      Values plane = {};
      for(int py = 0; py < Tensor_basis_3::pieces; ++py) {
        Values line = {};
        for(int px = 0; px < Tensor_basis_3::pieces; ++px) {
          const double coefficient = c[Tensor_basis_3::number(px, py, pz)];
          for(std::size_t j = 0; j < N; ++j)
            line[j] += coefficient * x[px][j];
        }
        for(std::size_t j = 0; j < N; ++j)
          plane[j] += line[j] * y[py][j];
      }
      for(std::size_t j = 0; j < N; ++j)
        result[j] += plane[j] * z[pz][j];
    }
    return result;
  }

  std::vector<Tensor_basis_3::Values> m_coefficients; // of each function
  std::array<Pieces, 3> m_values, m_slopes;           // of each axis
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_INTERNAL_BLOCK_EVALUATION_H
