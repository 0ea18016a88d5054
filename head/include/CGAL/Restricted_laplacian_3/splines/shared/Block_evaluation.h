// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_SHARED_BLOCK_EVALUATION_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_SHARED_BLOCK_EVALUATION_H

#include <CGAL/Restricted_laplacian_3/basis/B_spline_1.h>
#include <CGAL/Restricted_laplacian_3/basis/Tensor_basis_3.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/vector_lanes.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// Numbers for each point of a block.
template <std::size_t N> using Block_values = std::array<double, N>;
/// The three pieces of the B-spline along an axis, or their derivatives, at the points of a block.
template <std::size_t N> using Block_pieces = std::array<Block_values<N>, Tensor_basis_3::pieces>;

namespace plain {

/// \f$\sum_{abc} c_{abc}\, x_a y_b z_c\f$ at each point
template <std::size_t N>
void tensor_sums(const Tensor_basis_3::Values& c, const Block_pieces<N>& x,
                 const Block_pieces<N>& y, const Block_pieces<N>& z, Block_values<N>& sums) {
  sums.fill(0);
  for(int pz = 0; pz < Tensor_basis_3::pieces; ++pz)
    for(int py = 0; py < Tensor_basis_3::pieces; ++py)
      for(int px = 0; px < Tensor_basis_3::pieces; ++px) {
        const double coefficient = c[Tensor_basis_3::number(px, py, pz)];
        for(std::size_t j = 0; j < N; ++j)
          sums[j] += coefficient * x[px][j] * y[py][j] * z[pz][j];
      }
}

} // namespace plain

#ifdef CGAL_RESTRICTED_LAPLACIAN_3_HAS_LANES
namespace lanes {

/// 39 fused operations for four points
template <std::size_t N>
CGAL_RESTRICTED_LAPLACIAN_3_LANES_FUNCTION void
tensor_sums(const Tensor_basis_3::Values& c, const Block_pieces<N>& x, const Block_pieces<N>& y,
            const Block_pieces<N>& z, Block_values<N>& sums) {
  static_assert(N % 4 == 0, "whole vectors");
  for(std::size_t j = 0; j < N; j += 4) {
    const Lanes x0 = load(x[0].data() + j), x1 = load(x[1].data() + j), x2 = load(x[2].data() + j);
    Lanes sum = {};
    for(int pz = 0; pz < Tensor_basis_3::pieces; ++pz) {
      Lanes plane = {};
      for(int py = 0; py < Tensor_basis_3::pieces; ++py) {
        const double* const line = c.data() + Tensor_basis_3::number(0, py, pz);
        plane += (line[0] * x0 + line[1] * x1 + line[2] * x2) * load(y[py].data() + j);
      }
      sum += plane * load(z[pz].data() + j);
    }
    store(sum, sums.data() + j);
  }
}

} // namespace lanes
#endif

/// The functions \f$\sum_i H_{ik} b_i\f$ on one sheet of the finest level, at blocks of `N` points.
template <std::size_t N> class Block_evaluation {
public:
  using Values = Block_values<N>;
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

  /// for `values()`
  /// \param t local coordinates in the cell, axis by axis
  void set_points(const Positions& t) { set_pieces(t, &B_spline_1::values, m_values); }
  /// for `derivatives()`, too
  void set_points_and_slopes(const Positions& t) {
    set_points(t);
    set_pieces(t, &B_spline_1::derivatives, m_slopes);
  }

  /// values of function `k` at the points
  Values values(std::size_t k) const {
    return sums(m_coefficients[k], m_values[0], m_values[1], m_values[2]);
  }
  /// derivatives of function `k` along an axis, times the cell width
  Values derivatives(std::size_t k, int axis) const {
    return sums(m_coefficients[k], (axis == 0 ? m_slopes : m_values)[0],
                (axis == 1 ? m_slopes : m_values)[1], (axis == 2 ? m_slopes : m_values)[2]);
  }

private:
  using Pieces = Block_pieces<N>;

  template <class Polynomials>
  static void set_pieces(const Positions& t, Polynomials&& polynomials,
                         std::array<Pieces, 3>& pieces) {
    for(int axis = 0; axis < 3; ++axis)
      for(std::size_t j = 0; j < N; ++j) {
        const auto values = polynomials(t[axis][j]);
        for(int p = 0; p < Tensor_basis_3::pieces; ++p)
          pieces[axis][p][j] = values[p];
      }
  }

  static Values sums(const Tensor_basis_3::Values& c, const Pieces& x, const Pieces& y,
                     const Pieces& z) {
    Values result;
    CGAL_RESTRICTED_LAPLACIAN_3_BEST(tensor_sums<N>(c, x, y, z, result));
    return result;
  }

  std::vector<Tensor_basis_3::Values> m_coefficients; // of each function
  std::array<Pieces, 3> m_values, m_slopes;           // of each axis
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_SHARED_BLOCK_EVALUATION_H
