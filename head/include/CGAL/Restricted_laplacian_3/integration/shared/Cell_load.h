// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_SHARED_CELL_LOAD_H
#define CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_SHARED_CELL_LOAD_H

#include <CGAL/Restricted_laplacian_3/basis/B_spline_1.h>
#include <CGAL/Restricted_laplacian_3/basis/Tensor_basis_3.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/vector_lanes.h>
#include <CGAL/Restricted_laplacian_3/integration/Integration_nodes.h>
#include <CGAL/Restricted_laplacian_3/integration/internal/Padded_rule.h>

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

/// The nodes of a rule on a triangle, for functions that are linear on it: Bernstein polynomials of
/// degree 2 of their local coordinates, those along z times the weights.
struct Linear_load_nodes {
  /// of the largest rule that is needed
  static constexpr std::size_t capacity = 12;
  using Values = std::array<std::array<double, capacity>, 3>;

  const Padded_rule* rule;
  Values x, y, z;
};

namespace plain {

inline std::array<double, 3> bernstein_2(double t) {
  return {(1 - t) * (1 - t), 2 * t * (1 - t), t * t};
}

inline void add_load(const Node_positions& t, const Node_values& values, Cell_load_sums& sums) {
  for(std::size_t i = 0; i < values.size(); ++i) {
    const auto x = bernstein_2(t[0][i]), y = bernstein_2(t[1][i]), z = bernstein_2(t[2][i]);
    for(int c = 0; c < 3; ++c)
      for(int b = 0; b < 3; ++b)
        for(int a = 0; a < 3; ++a)
          sums[a + 3 * (b + 3 * c)][i % 4] += values[i] * x[a] * y[b] * z[c];
  }
}

inline void set_linear_nodes(const std::array<std::array<double, 3>, 3>& corners, double area,
                             Linear_load_nodes& nodes) {
  const Padded_rule& rule = *nodes.rule;
  Linear_load_nodes::Values* const along[3] = {&nodes.x, &nodes.y, &nodes.z};
  for(std::size_t i = 0; i < rule.weight.size(); ++i)
    for(int axis = 0; axis < 3; ++axis) {
      const auto b = bernstein_2(rule.b0[i] * corners[0][axis] + rule.b1[i] * corners[1][axis] +
                                 rule.b2[i] * corners[2][axis]);
      for(int a = 0; a < 3; ++a)
        (*along[axis])[a][i] = axis == 2 ? rule.weight[i] * area * b[a] : b[a];
    }
}

inline void add_linear_load(const Linear_load_nodes& nodes, const std::array<double, 3>& values,
                            Cell_load_sums& sums) {
  const Padded_rule& rule = *nodes.rule;
  for(std::size_t i = 0; i < rule.weight.size(); ++i) {
    const double value = rule.b0[i] * values[0] + rule.b1[i] * values[1] + rule.b2[i] * values[2];
    for(int c = 0; c < 3; ++c)
      for(int b = 0; b < 3; ++b)
        for(int a = 0; a < 3; ++a)
          sums[a + 3 * (b + 3 * c)][i % 4] += value * nodes.x[a][i] * nodes.y[b][i] * nodes.z[c][i];
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

/// adds the products of values of polynomials along the three axes, those along z with the weights
/// \tparam groups of four nodes
template <int groups>
CGAL_RESTRICTED_LAPLACIAN_3_LANES_INLINE void
add_products(const Lanes (&x)[3][groups], const Lanes (&y)[3][groups], const Lanes (&z)[3][groups],
             Cell_load_sums& sums) {
  for(int c = 0; c < 3; ++c)
    for(int b = 0; b < 3; ++b) {
      auto* const row = sums.data() + 3 * (b + 3 * c);
      Lanes s0 = load(row[0].data()), s1 = load(row[1].data()), s2 = load(row[2].data());
      for(int g = 0; g < groups; ++g) {
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

CGAL_RESTRICTED_LAPLACIAN_3_LANES_FUNCTION inline void
add_load(const Node_positions& t, const Node_values& values, Cell_load_sums& sums) {
  Lanes x[3][groups_of_nodes], y[3][groups_of_nodes], z[3][groups_of_nodes];
  bernstein_2(t[0], x);
  bernstein_2(t[1], y);
  bernstein_2(t[2], z);
  for(auto& of_nodes : z)
    for(int g = 0; g < groups_of_nodes; ++g)
      of_nodes[g] *= load(values.data() + 4 * g);
  add_products(x, y, z, sums);
}

CGAL_RESTRICTED_LAPLACIAN_3_LANES_FUNCTION inline void
set_linear_nodes(const std::array<std::array<double, 3>, 3>& corners, double area,
                 Linear_load_nodes& nodes) {
  const Padded_rule& rule = *nodes.rule;
  Linear_load_nodes::Values* const along[3] = {&nodes.x, &nodes.y, &nodes.z};
  for(std::size_t i = 0; i < rule.weight.size(); i += 4) {
    const Lanes b0 = load(rule.b0.data() + i), b1 = load(rule.b1.data() + i),
                b2 = load(rule.b2.data() + i), weight = load(rule.weight.data() + i) * area;
    for(int axis = 0; axis < 3; ++axis) {
      const Lanes t = b0 * corners[0][axis] + b1 * corners[1][axis] + b2 * corners[2][axis],
                  u = 1 - t;
      const Lanes values[3] = {u * u, 2 * t * u, t * t};
      for(int a = 0; a < 3; ++a)
        store(axis == 2 ? weight * values[a] : values[a], (*along[axis])[a].data() + i);
    }
  }
}

/// \tparam groups of four nodes
template <int groups>
CGAL_RESTRICTED_LAPLACIAN_3_LANES_FUNCTION void
add_linear_load_of(const Linear_load_nodes& nodes, const std::array<double, 3>& values,
                   Cell_load_sums& sums) {
  const Padded_rule& rule = *nodes.rule;
  Lanes x[3][groups], y[3][groups], z[3][groups];
  for(int g = 0; g < groups; ++g) {
    const Lanes value = load(rule.b0.data() + 4 * g) * values[0] +
                        load(rule.b1.data() + 4 * g) * values[1] +
                        load(rule.b2.data() + 4 * g) * values[2];
    for(int a = 0; a < 3; ++a) {
      x[a][g] = load(nodes.x[a].data() + 4 * g);
      y[a][g] = load(nodes.y[a].data() + 4 * g);
      z[a][g] = load(nodes.z[a].data() + 4 * g) * value;
    }
  }
  add_products(x, y, z, sums);
}

CGAL_RESTRICTED_LAPLACIAN_3_LANES_FUNCTION inline void
add_linear_load(const Linear_load_nodes& nodes, const std::array<double, 3>& values,
                Cell_load_sums& sums) {
  if(nodes.rule->weight.size() == 8)
    add_linear_load_of<2>(nodes, values, sums);
  else
    add_linear_load_of<3>(nodes, values, sums);
}

} // namespace lanes
#endif

/// \param corners their local coordinates in the cell
/// \param area in units of the squared cell width
/// \param degree of what is integrated, from 5 to 7
inline Linear_load_nodes linear_load_nodes(const std::array<std::array<double, 3>, 3>& corners,
                                           double area, int degree) {
  Linear_load_nodes nodes;
  nodes.rule = &Padded_rule::of_degree(degree);
  CGAL_RESTRICTED_LAPLACIAN_3_BEST(set_linear_nodes(corners, area, nodes));
  return nodes;
}

/// adds a function that has these values at the corners of the triangle
inline void add_linear_load(const Linear_load_nodes& nodes, const std::array<double, 3>& values,
                            Cell_load_sums& sums) {
  CGAL_RESTRICTED_LAPLACIAN_3_BEST(add_linear_load(nodes, values, sums));
}

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

  /// adds a triangle on which \f$f\f$ is linear
  /// \param values at its corners
  void add(const Linear_load_nodes& nodes, const std::array<double, 3>& values) {
    add_linear_load(nodes, values, m_sums);
  }

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
