// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_INTERNAL_CELL_LOAD_H
#define CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_INTERNAL_CELL_LOAD_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/vector_lanes.h>
#include <CGAL/Restricted_laplacian_3/splines/B_spline_1.h>

#include <array>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// Nodes on the surface in a cell, and the values of a function there times the weights of the
/// nodes; a value of 0 stands for no node.
struct Cell_load_nodes {
  static constexpr int size = 32;
  std::array<std::array<double, size>, 3> t;
  std::array<double, size> value;
};

/// \f$\int f B_a(t_x) B_b(t_y) B_c(t_z)\f$ with the Bernstein polynomials of degree 2, number
/// \f$a + 3 (b + 3 c)\f$, each as four sums that are left to be added.
using Cell_load_sums = std::array<std::array<double, 4>, 27>;

namespace plain {

inline void add_nodes(const Cell_load_nodes& nodes, Cell_load_sums& sums) {
  const auto bernstein_2 = [](double t) {
    return std::array<double, 3>{(1 - t) * (1 - t), 2 * t * (1 - t), t * t};
  };
  for(int i = 0; i < Cell_load_nodes::size; ++i) {
    const auto x = bernstein_2(nodes.t[0][i]), y = bernstein_2(nodes.t[1][i]),
               z = bernstein_2(nodes.t[2][i]);
    for(int c = 0; c < 3; ++c)
      for(int b = 0; b < 3; ++b)
        for(int a = 0; a < 3; ++a)
          sums[a + 3 * (b + 3 * c)][i % 4] += nodes.value[i] * x[a] * y[b] * z[c];
  }
}

} // namespace plain

#ifdef CGAL_RESTRICTED_LAPLACIAN_3_HAS_LANES
namespace lanes {

constexpr int groups_of_nodes = Cell_load_nodes::size / 4;

CGAL_RESTRICTED_LAPLACIAN_3_LANES_INLINE void
bernstein_2(const std::array<double, Cell_load_nodes::size>& coordinates,
            Lanes (&b)[3][groups_of_nodes]) {
  for(int g = 0; g < groups_of_nodes; ++g) {
    const Lanes t = load(coordinates.data() + 4 * g), u = 1 - t;
    b[0][g] = u * u;
    b[1][g] = 2 * t * u;
    b[2][g] = t * t;
  }
}

CGAL_RESTRICTED_LAPLACIAN_3_LANES_FUNCTION inline void add_nodes(const Cell_load_nodes& nodes,
                                                                 Cell_load_sums& sums) {
  Lanes x[3][groups_of_nodes], y[3][groups_of_nodes], z[3][groups_of_nodes];
  bernstein_2(nodes.t[0], x);
  bernstein_2(nodes.t[1], y);
  bernstein_2(nodes.t[2], z);
  for(int c = 0; c < 3; ++c)
    for(int g = 0; g < groups_of_nodes; ++g)
      z[c][g] *= load(nodes.value.data() + 4 * g);
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

inline void add_nodes(const Cell_load_nodes& nodes, Cell_load_sums& sums) {
#ifdef CGAL_RESTRICTED_LAPLACIAN_3_HAS_LANES
  if(processor_has_lanes())
    return lanes::add_nodes(nodes, sums);
#endif
  plain::add_nodes(nodes, sums);
}

/// Integrals of a function against the 27 elements of a cell, \f$\int f b_i\f$ over the surface
/// in the cell, from its moments with the Bernstein polynomials of degree 2. Nodes are collected,
/// and added to the moments together.
class Cell_load {
public:
  using Load = std::array<double, 27>;

  Cell_load() : m_sums() {}

  /// adds a node: local coordinate, value times weight
  void add(const std::array<double, 3>& t, double value) {
    for(int axis = 0; axis < 3; ++axis)
      m_nodes.t[axis][m_size] = t[axis];
    m_nodes.value[m_size++] = value;
    if(m_size == Cell_load_nodes::size)
      flush();
  }

  /// adds \f$\int f b_i\f$
  void add_values_to(Load& load) {
    const auto b = B_spline_1::bernstein_coefficients();
    add_contraction_to(b, b, b, load);
  }

  /// adds \f$\int f \partial_k b_i\f$, times the cell width
  void add_derivatives_to(int axis, Load& load) {
    const auto b = B_spline_1::bernstein_coefficients(),
               d = B_spline_1::derivative_bernstein_coefficients();
    add_contraction_to(axis == 0 ? d : b, axis == 1 ? d : b, axis == 2 ? d : b, load);
  }

private:
  using Factor = std::array<std::array<double, 3>, 3>;

  void flush() {
    for(; m_size < Cell_load_nodes::size; ++m_size) {
      for(int axis = 0; axis < 3; ++axis)
        m_nodes.t[axis][m_size] = 0;
      m_nodes.value[m_size] = 0;
    }
    add_nodes(m_nodes, m_sums);
    m_size = 0;
  }

  void add_contraction_to(const Factor& x, const Factor& y, const Factor& z, Load& load) {
    if(m_size > 0)
      flush();
    std::array<double, 27> moments;
    for(int i = 0; i < 27; ++i)
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

  int m_size = 0; // number of nodes that are not yet in the sums
  Cell_load_nodes m_nodes;
  Cell_load_sums m_sums;
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_INTERNAL_CELL_LOAD_H
