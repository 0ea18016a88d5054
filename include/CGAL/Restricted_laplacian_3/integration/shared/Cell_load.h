// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_SHARED_CELL_LOAD_H
#define CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_SHARED_CELL_LOAD_H

#include <CGAL/Restricted_laplacian_3/basis/B_spline_1.h>
#include <CGAL/Restricted_laplacian_3/basis/Tensor_basis_3.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/vector_lanes.h>
#include <CGAL/Restricted_laplacian_3/integration/Integration_nodes.h>

#include <array>
#include <cstddef>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// a number for each node of a block
using Node_values = std::array<double, Integration_node_block::capacity>;
/// their local coordinates, axis by axis
using Node_positions = std::array<Node_values, 3>;

/// \f$\int f B_a(t_x) B_b(t_y) B_c(t_z)\f$ with the Bernstein polynomials of degree 2, number
/// \f$a + 3 (b + 3 c)\f$, each as four sums that are left to be added.
using Cell_load_sums = std::array<std::array<double, 4>, Tensor_basis_3::size>;

namespace plain {

inline void add_load(const Node_positions& t, const Node_values& values, Cell_load_sums& sums) {
  const auto bernstein_2 = [](double t) {
    return std::array<double, 3>{(1 - t) * (1 - t), 2 * t * (1 - t), t * t};
  };
  for(std::size_t i = 0; i < values.size(); ++i) {
    const auto x = bernstein_2(t[0][i]), y = bernstein_2(t[1][i]), z = bernstein_2(t[2][i]);
    for(int c = 0; c < 3; ++c)
      for(int b = 0; b < 3; ++b)
        for(int a = 0; a < 3; ++a)
          sums[a + 3 * (b + 3 * c)][i % 4] += values[i] * x[a] * y[b] * z[c];
  }
}

} // namespace plain

#ifdef CGAL_RESTRICTED_LAPLACIAN_3_HAS_LANES
namespace lanes {

constexpr int groups_of_nodes = Integration_node_block::capacity / 4;

CGAL_RESTRICTED_LAPLACIAN_3_LANES_INLINE void bernstein_2(const Node_values& coordinates,
                                                          Lanes (&b)[3][groups_of_nodes]) {
  for(int g = 0; g < groups_of_nodes; ++g) {
    const Lanes t = load(coordinates.data() + 4 * g), u = 1 - t;
    b[0][g] = u * u;
    b[1][g] = 2 * t * u;
    b[2][g] = t * t;
  }
}

CGAL_RESTRICTED_LAPLACIAN_3_LANES_FUNCTION inline void
add_load(const Node_positions& t, const Node_values& values, Cell_load_sums& sums) {
  Lanes x[3][groups_of_nodes], y[3][groups_of_nodes], z[3][groups_of_nodes];
  bernstein_2(t[0], x);
  bernstein_2(t[1], y);
  bernstein_2(t[2], z);
  for(int c = 0; c < 3; ++c)
    for(int g = 0; g < groups_of_nodes; ++g)
      z[c][g] *= load(values.data() + 4 * g);
  for(int c = 0; c < 3; ++c)
    for(int b = 0; b < 3; ++b) {
      auto* const row = sums.data() + 3 * (b + 3 * c);
      Lanes s0 = load(row[0].data()), s1 = load(row[1].data()), s2 = load(row[2].data());
      for(int g = 0; g < groups_of_nodes; ++g) {
        const Lanes yz = y[b][g] * z[c][g];
        s0 += x[0][g] * yz;
        s1 += x[1][g] * yz;
        s2 += x[2][g] * yz;
      }
      store(s0, row[0].data());
      store(s1, row[1].data());
      store(s2, row[2].data());
    }
}

} // namespace lanes
#endif

/// adds the nodes of a block, with the values of a function there times the weights of the nodes
inline void add_load(const Node_positions& t, const Node_values& values, Cell_load_sums& sums) {
  CGAL_RESTRICTED_LAPLACIAN_3_BEST(add_load(t, values, sums));
}

/// Integrals of a function against the elements of a cell, \f$\int f b_i\f$ over the surface in the
/// cell, from its moments with the Bernstein polynomials of degree 2.
class Cell_load {
public:
  using Load = Tensor_basis_3::Values;

  Cell_load() : m_sums() {}

  /// adds the nodes of a block
  /// \param values of \f$f\f$ times the weights of the nodes; 0 where there is no node
  void add(const Node_positions& t, const Node_values& values) { add_load(t, values, m_sums); }

  /// adds \f$\int f b_i\f$
  void add_values_to(Load& load) const {
    const auto b = B_spline_1::bernstein_coefficients();
    add_contraction_to(b, b, b, load);
  }

  /// adds \f$\int f \partial_k b_i\f$, times the cell width
  void add_derivatives_to(int axis, Load& load) const {
    const auto b = B_spline_1::bernstein_coefficients(),
               d = B_spline_1::derivative_bernstein_coefficients();
    add_contraction_to(axis == 0 ? d : b, axis == 1 ? d : b, axis == 2 ? d : b, load);
  }

private:
  using Factor = std::array<std::array<double, 3>, 3>;

  void add_contraction_to(const Factor& x, const Factor& y, const Factor& z, Load& load) const {
    Load moments;
    for(std::size_t i = 0; i < moments.size(); ++i)
      moments[i] = (m_sums[i][0] + m_sums[i][1]) + (m_sums[i][2] + m_sums[i][3]);
    for(int k = 0; k < 3; ++k) {
      std::array<double, 9> plane = {};
      for(int c = 0; c < 3; ++c)
        for(int i = 0; i < 9; ++i)
          plane[i] += z[k][c] * moments[i + 9 * c];
      for(int j = 0; j < 3; ++j) {
        std::array<double, 3> line = {};
        for(int b = 0; b < 3; ++b)
          for(int a = 0; a < 3; ++a)
            line[a] += y[j][b] * plane[a + 3 * b];
        for(int i = 0; i < 3; ++i)
          load[i + 3 * (j + 3 * k)] += x[i][0] * line[0] + x[i][1] * line[1] + x[i][2] * line[2];
      }
    }
  }

  Cell_load_sums m_sums;
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_SHARED_CELL_LOAD_H
