// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_SHARED_SHEET_KERNELS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_SHARED_SHEET_KERNELS_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/vector_lanes.h>
#include <CGAL/Restricted_laplacian_3/integration/internal/Padded_rule.h>
#include <CGAL/Restricted_laplacian_3/integration/internal/cell_integrals.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// The upper halves of the blocks of four sheets: entry \f$(i, j)\f$, \f$i \le j\f$, of sheet
/// number `lane` is `values[lane][element_pairs[i][j]]`.
struct alignas(64) Packed_blocks {
  static constexpr int lanes = 4;
  static constexpr int size = number_of_element_pairs;
  /// padded to whole groups of four
  static constexpr int padded_size = size + 2;
  std::array<std::array<double, padded_size>, lanes> values;
};

/// Where the parts of an entry of a block are in the results of the contractions, see
/// `stiffness_block()`: the sum of the diagonal components, and two parts of each other one.
struct Packed_entry {
  std::uint16_t diagonal;
  std::array<std::uint16_t, 2> xy, xz, yz;

  /// the last ones stand for nothing
  static const std::array<Packed_entry, Packed_blocks::padded_size>& table() {
    static const auto entries = [] {
      std::array<Packed_entry, Packed_blocks::padded_size> result = {};
      for(int j = 0; j < Tensor_basis_3::size; ++j)
        for(int i = 0; i <= j; ++i) {
          const auto [ix, iy, iz] = Tensor_basis_3::pieces_of(i);
          const auto [jx, jy, jz] = Tensor_basis_3::pieces_of(j);
          const int px = pair_number(ix, jx), py = pair_number(iy, jy), pz = pair_number(iz, jz);
          const int x = ix + 3 * jx, xt = jx + 3 * ix, y = iy + 3 * jy, yt = jy + 3 * iy,
                    z = iz + 3 * jz, zt = jz + 3 * iz;
          const auto number = [](int n) { return static_cast<std::uint16_t>(n); };
          result[element_pairs[i][j]] = {
              number(px + 6 * (py + 6 * pz)),
              {number(x + 9 * (y + 9 * pz)), number(xt + 9 * (yt + 9 * pz))},
              {number(x + 9 * (py + 6 * z)), number(xt + 9 * (py + 6 * zt))},
              {number(px + 6 * (y + 9 * z)), number(px + 6 * (yt + 9 * zt))}};
        }
      return result;
    }();
    return entries;
  }
};

/// A triangle of a fragment: local coordinates of its corners in the cell, and its area in units of
/// the squared cell width.
struct Cell_triangle {
  std::array<std::array<double, 3>, 3> corners;
  double area;
};

/// The triangles of a fragment that have an area, fanned out from its first corner.
struct Cell_triangles {
  std::size_t size = 0;
  std::array<Cell_triangle, Fragment::capacity> triangles;

  Cell_triangles(const Fragment& fragment, const std::array<int, 3>& cell) {
    const auto corner = [&](std::size_t i) {
      const auto& p = fragment.corners[i].position;
      return std::array<double, 3>{p[0] - cell[0], p[1] - cell[1], p[2] - cell[2]};
    };
    for(std::size_t i = 2; i < fragment.size; ++i) {
      Cell_triangle& t = triangles[size];
      t.corners = {corner(0), corner(i - 1), corner(i)};
      t.area = triangle_area(t.corners[0], t.corners[1], t.corners[2]);
      if(t.area > 0)
        ++size;
    }
  }
  const Cell_triangle* begin() const { return triangles.data(); }
  const Cell_triangle* end() const { return begin() + size; }
};

/// Nodes in a cell, and what each adds to the components of moments, times the products there.
struct alignas(64) Moment_nodes {
  static constexpr std::size_t capacity = 64;

  std::size_t size = 0;
  /// local coordinates, axis by axis
  std::array<std::array<double, capacity>, 3> positions = {};
  std::array<std::array<double, Sheet_moments::components>, capacity> factors;
};

/// The same computations without vectors: for other compilers and older processors, and what the
/// vectors are compared with in tests.
namespace plain {

inline void add_fragment(const Fragment& fragment, const std::array<int, 3>& cell,
                         const Symmetric_tensor_3& metric, Sheet_moments& moments,
                         double mass_weight, double density, int degree) {
  Sheet_moments::Component own = {};
  const Padded_rule& rule = Padded_rule::of_degree(degree);
  for(const auto& [corners, area] : Cell_triangles(fragment, cell))
    for(std::size_t node = 0; node < rule.size; ++node) {
      std::array<double, 3> t;
      for(int axis = 0; axis < 3; ++axis)
        t[axis] = rule.b0[node] * corners[0][axis] + rule.b1[node] * corners[1][axis] +
                  rule.b2[node] * corners[2][axis];
      const auto products = bernstein_products(t);
      for(int i = 0; i < number_of_moments; ++i)
        own[i] += rule.weight[node] * area * products[i];
    }
  for(int i = 0; i < number_of_moments; ++i) {
    for(int k = 0; k < 6; ++k)
      moments.values[i][k] += metric[k] * own[i];
    moments.values[i][Sheet_moments::mass] += mass_weight * density * own[i];
    moments.values[i][Sheet_moments::area] += density * own[i];
  }
}

inline void add_moments(const Moment_nodes& nodes, Sheet_moments& moments) {
  for(std::size_t node = 0; node < nodes.size; ++node) {
    const auto products = bernstein_products(
        {nodes.positions[0][node], nodes.positions[1][node], nodes.positions[2][node]});
    for(int i = 0; i < number_of_moments; ++i)
      for(int k = 0; k < Sheet_moments::components; ++k)
        moments.values[i][k] += nodes.factors[node][k] * products[i];
  }
}

inline void add_child_moments(const Sheet_moments& child, int octant, Sheet_moments& parent) {
  for(int k = 0; k < Sheet_moments::components; ++k)
    add_child_component(child, k, octant, parent);
}

/// \param block_of `mass_block()` or `stiffness_block()`
template <class BlockOf>
void packed_blocks(const std::array<const Sheet_moments*, 4>& sheets, BlockOf&& block_of,
                   Packed_blocks& blocks) {
  Cell_block block;
  for(int lane = 0; lane < Packed_blocks::lanes; ++lane) {
    block_of(*sheets[lane], block);
    for(int j = 0; j < Tensor_basis_3::size; ++j)
      for(int i = 0; i <= j; ++i)
        blocks.values[lane][element_pairs[i][j]] = block[Tensor_basis_3::size * j + i];
  }
}

inline void stiffness_blocks(const std::array<const Sheet_moments*, 4>& sheets,
                             Packed_blocks& blocks) {
  packed_blocks(sheets, stiffness_block, blocks);
}

inline void mass_blocks(const std::array<const Sheet_moments*, 4>& sheets, Packed_blocks& blocks) {
  packed_blocks(sheets, mass_block, blocks);
}

} // namespace plain

#ifdef CGAL_RESTRICTED_LAPLACIAN_3_HAS_LANES

namespace lanes {

// ---- contraction along one axis; structural zeros of the factors cost nothing

template <std::size_t N> using Factor = std::array<std::array<double, 5>, N>;

struct Value_products {
  static constexpr Factor<6> table = pair_products(B_spline_1::bernstein_coefficients());
};
struct Derivative_products {
  static constexpr Factor<6> table = pair_products(B_spline_1::derivative_bernstein_coefficients());
};
struct Mixed_products {
  static constexpr Factor<9> table = ordered_pair_products(
      B_spline_1::derivative_bernstein_coefficients(), B_spline_1::bernstein_coefficients());
};
struct Transposed_mixed_products {
  static constexpr Factor<9> table = ordered_pair_products(
      B_spline_1::bernstein_coefficients(), B_spline_1::derivative_bernstein_coefficients());
};
struct Lower_child {
  static constexpr Factor<5> table = lower_child_factor();
};
struct Upper_child {
  static constexpr Factor<5> table = upper_child_factor();
};

template <class F, std::size_t N, std::size_t... K>
CGAL_RESTRICTED_LAPLACIAN_3_LANES_INLINE Lanes row_product(const Lanes* m,
                                                           std::index_sequence<K...>) {
  Lanes sum = {};
  ((F::table[N][K] != 0 ? void(sum += F::table[N][K] * m[K]) : void()), ...);
  return sum;
}

template <class F, std::size_t... N>
CGAL_RESTRICTED_LAPLACIAN_3_LANES_INLINE void contract_line(const Lanes* in, int stride, Lanes* out,
                                                            std::index_sequence<N...>) {
  const Lanes m[5] = {in[0], in[stride], in[2 * stride], in[3 * stride], in[4 * stride]};
  ((out[static_cast<int>(N) * stride] = row_product<F, N>(m, std::make_index_sequence<5>())), ...);
}

/// `in` is `outer` x 5 x `inner`, `out` is `outer` x (rows of `F`) x `inner`, the last index runs
/// first.
template <class F>
CGAL_RESTRICTED_LAPLACIAN_3_LANES_FUNCTION void contract_axis(const Lanes* in, int outer, int inner,
                                                              Lanes* out) {
  constexpr int rows = static_cast<int>(F::table.size());
  for(int o = 0; o < outer; ++o)
    for(int i = 0; i < inner; ++i)
      contract_line<F>(in + 5 * o * inner + i, inner, out + rows * o * inner + i,
                       std::make_index_sequence<static_cast<std::size_t>(rows)>());
}

// ---- moments of fragments

/// Bernstein polynomials of degree 4 of four coordinates
CGAL_RESTRICTED_LAPLACIAN_3_LANES_INLINE void bernstein_4(const Lanes& t, Lanes& b0, Lanes& b1,
                                                          Lanes& b2, Lanes& b3, Lanes& b4) {
  const Lanes u = 1 - t, t2 = t * t, u2 = u * u, tu = t * u, tu4 = 4 * tu;
  b0 = u2 * u2;
  b1 = tu4 * u2;
  b2 = 6 * tu * tu;
  b3 = tu4 * t2;
  b4 = t2 * t2;
}

/// Adds \f$\int B_a B_b B_c\f$ over a triangle; the sum over the components of a vector is left to
/// the caller. 32 nodes take 125 x 8 fused operations of vectors, plus 25 x 8 products of the
/// factors of two axes: the accumulators are loaded and stored only once for all nodes.
/// \tparam groups of 4 nodes each
template <int groups>
CGAL_RESTRICTED_LAPLACIAN_3_LANES_FUNCTION void add_triangle(const Cell_triangle& triangle,
                                                             const Padded_rule& rule, Lanes* sums) {
  const auto& [p, q, r] = triangle.corners;
  Lanes x[5][groups], y[5][groups], z[5][groups];
  for(int g = 0; g < groups; ++g) {
    const Lanes b0 = load(rule.b0.data() + 4 * g), b1 = load(rule.b1.data() + 4 * g),
                b2 = load(rule.b2.data() + 4 * g),
                weight = load(rule.weight.data() + 4 * g) * triangle.area;
    bernstein_4(b0 * p[0] + b1 * q[0] + b2 * r[0], x[0][g], x[1][g], x[2][g], x[3][g], x[4][g]);
    bernstein_4(b0 * p[1] + b1 * q[1] + b2 * r[1], y[0][g], y[1][g], y[2][g], y[3][g], y[4][g]);
    bernstein_4(b0 * p[2] + b1 * q[2] + b2 * r[2], z[0][g], z[1][g], z[2][g], z[3][g], z[4][g]);
    for(auto& of_nodes : z)
      of_nodes[g] *= weight;
  }
  for(int c = 0; c < 5; ++c)
    for(int b = 0; b < 5; ++b) {
      Lanes yz[groups];
      for(int g = 0; g < groups; ++g)
        yz[g] = y[b][g] * z[c][g];
      Lanes* row = sums + 5 * (b + 5 * c);
      Lanes s0 = row[0], s1 = row[1], s2 = row[2], s3 = row[3], s4 = row[4];
      for(int g = 0; g < groups; ++g) {
        s0 += x[0][g] * yz[g];
        s1 += x[1][g] * yz[g];
        s2 += x[2][g] * yz[g];
        s3 += x[3][g] * yz[g];
        s4 += x[4][g] * yz[g];
      }
      row[0] = s0;
      row[1] = s1;
      row[2] = s2;
      row[3] = s3;
      row[4] = s4;
    }
}

CGAL_RESTRICTED_LAPLACIAN_3_LANES_FUNCTION inline void
add_fragment(const Fragment& fragment, const std::array<int, 3>& cell,
             const Symmetric_tensor_3& metric, Sheet_moments& moments, double mass_weight,
             double density, int degree) {
  // padded to whole groups of four
  Lanes sums[number_of_moments + 3] = {};
  const bool is_small = degree <= 10;
  const Padded_rule& rule = Padded_rule::of_degree(is_small ? 10 : 12);
  for(const Cell_triangle& triangle : Cell_triangles(fragment, cell))
    is_small ? add_triangle<6>(triangle, rule, sums) : add_triangle<8>(triangle, rule, sums);
  const Lanes low = {metric[0], metric[1], metric[2], metric[3]},
              high = {metric[4], metric[5], mass_weight * density, density};
  for(int i = 0; i < number_of_moments; i += 4) {
    Lanes four;
    sum_components(sums[i], sums[i + 1], sums[i + 2], sums[i + 3], four);
    for(int j = 0; j < 4 && i + j < number_of_moments; ++j) {
      double* to = moments.values[i + j].data();
      store(load(to) + four[j] * low, to);
      store(load(to + 4) + four[j] * high, to + 4);
    }
  }
}

/// 125 x 2 fused operations of vectors for each node, whose eight factors are two vectors: eight
/// times as many as for a node of a triangle, whose metric all nodes share.
CGAL_RESTRICTED_LAPLACIAN_3_LANES_FUNCTION inline void add_moments(const Moment_nodes& nodes,
                                                                   Sheet_moments& moments) {
  constexpr std::size_t capacity = Moment_nodes::capacity, groups = capacity / 4;
  Lanes x[5][groups], y[5][groups], z[5][groups];
  for(std::size_t g = 0; 4 * g < nodes.size; ++g) {
    const auto& [tx, ty, tz] = nodes.positions;
    bernstein_4(load(tx.data() + 4 * g), x[0][g], x[1][g], x[2][g], x[3][g], x[4][g]);
    bernstein_4(load(ty.data() + 4 * g), y[0][g], y[1][g], y[2][g], y[3][g], y[4][g]);
    bernstein_4(load(tz.data() + 4 * g), z[0][g], z[1][g], z[2][g], z[3][g], z[4][g]);
  }
  for(int c = 0; c < 5; ++c)
    for(int b = 0; b < 5; ++b) {
      double products[5][capacity];
      for(std::size_t g = 0; 4 * g < nodes.size; ++g) {
        const Lanes yz = y[b][g] * z[c][g];
        for(int a = 0; a < 5; ++a)
          store(x[a][g] * yz, products[a] + 4 * g);
      }
      Lanes low[5], high[5];
      auto* const row = moments.values.data() + 5 * (b + 5 * c);
      for(int a = 0; a < 5; ++a) {
        low[a] = load(row[a].data());
        high[a] = load(row[a].data() + 4);
      }
      for(std::size_t node = 0; node < nodes.size; ++node) {
        const double* const factors = nodes.factors[node].data();
        const Lanes f = load(factors), g = load(factors + 4);
        for(int a = 0; a < 5; ++a) {
          low[a] += products[a][node] * f;
          high[a] += products[a][node] * g;
        }
      }
      for(int a = 0; a < 5; ++a) {
        store(low[a], row[a].data());
        store(high[a], row[a].data() + 4);
      }
    }
}

// ---- coarser levels

CGAL_RESTRICTED_LAPLACIAN_3_LANES_FUNCTION inline void
add_child_moments(const Sheet_moments& child, int octant, Sheet_moments& parent) {
  constexpr int n = 2 * number_of_moments;
  Lanes a[n], b[n];
  for(int i = 0; i < n; ++i)
    a[i] = load(child.values[0].data() + 4 * i);
  octant & 1 ? contract_axis<Upper_child>(a, 25, 2, b) : contract_axis<Lower_child>(a, 25, 2, b);
  octant & 2 ? contract_axis<Upper_child>(b, 5, 10, a) : contract_axis<Lower_child>(b, 5, 10, a);
  octant & 4 ? contract_axis<Upper_child>(a, 1, 50, b) : contract_axis<Lower_child>(a, 1, 50, b);
  double* to = parent.values[0].data();
  for(int i = 0; i < n; ++i)
    store(load(to + 4 * i) + 0.25 * b[i], to + 4 * i);
}

// ---- blocks of four sheets, one in each component of a vector

/// four components of the moments, from number `first`, of four sheets
CGAL_RESTRICTED_LAPLACIAN_3_LANES_INLINE void
gather_components(const std::array<const Sheet_moments*, 4>& sheets, int first, Lanes (*to)[125]) {
  for(int i = 0; i < number_of_moments; ++i)
    transpose(load(sheets[0]->values[i].data() + first), load(sheets[1]->values[i].data() + first),
              load(sheets[2]->values[i].data() + first), load(sheets[3]->values[i].data() + first),
              to[0][i], to[1][i], to[2][i], to[3][i]);
}

/// four entries, from number `first`, of the blocks of four sheets
CGAL_RESTRICTED_LAPLACIAN_3_LANES_INLINE void store_columns(const Lanes (&rows)[4], int first,
                                                            Packed_blocks& blocks) {
  Lanes a, b, c, d;
  transpose(rows[0], rows[1], rows[2], rows[3], a, b, c, d);
  store(a, blocks.values[0].data() + first);
  store(b, blocks.values[1].data() + first);
  store(c, blocks.values[2].data() + first);
  store(d, blocks.values[3].data() + first);
}

CGAL_RESTRICTED_LAPLACIAN_3_LANES_FUNCTION inline void
stiffness_blocks(const std::array<const Sheet_moments*, 4>& sheets, Packed_blocks& blocks) {
  Lanes m[8][125];
  gather_components(sheets, 0, m);
  gather_components(sheets, 4, m + 4);
  Lanes one[25 * 9], two[5 * 54], xx[216], yy[216], zz[216], xy[486], xz[486], yz[486];
  contract_axis<Derivative_products>(m[0], 25, 1, one);
  contract_axis<Value_products>(one, 5, 6, two);
  contract_axis<Value_products>(two, 1, 36, xx);
  contract_axis<Value_products>(m[1], 25, 1, one);
  contract_axis<Derivative_products>(one, 5, 6, two);
  contract_axis<Value_products>(two, 1, 36, yy);
  contract_axis<Value_products>(m[2], 25, 1, one);
  contract_axis<Value_products>(one, 5, 6, two);
  contract_axis<Derivative_products>(two, 1, 36, zz);
  for(int i = 0; i < 216; ++i)
    xx[i] += yy[i] + zz[i];
  // The axis with fewer products first.
  contract_axis<Value_products>(m[3], 1, 25, one);
  contract_axis<Transposed_mixed_products>(one, 6, 5, two);
  contract_axis<Mixed_products>(two, 54, 1, xy);
  contract_axis<Value_products>(m[4], 5, 5, one);
  contract_axis<Transposed_mixed_products>(one, 1, 30, two);
  contract_axis<Mixed_products>(two, 54, 1, xz);
  contract_axis<Value_products>(m[5], 25, 1, one);
  contract_axis<Mixed_products>(one, 5, 6, two);
  contract_axis<Transposed_mixed_products>(two, 1, 54, yz);
  const auto& entries = Packed_entry::table();
  for(int i = 0; i < Packed_blocks::padded_size; i += 4) {
    Lanes row[4];
    for(int k = 0; k < 4; ++k) {
      const Packed_entry& e = entries[i + k];
      row[k] = xx[e.diagonal] + (xy[e.xy[0]] + xy[e.xy[1]]) + (xz[e.xz[0]] + xz[e.xz[1]]) +
               (yz[e.yz[0]] + yz[e.yz[1]]);
    }
    store_columns(row, i, blocks);
  }
}

CGAL_RESTRICTED_LAPLACIAN_3_LANES_FUNCTION inline void
mass_blocks(const std::array<const Sheet_moments*, 4>& sheets, Packed_blocks& blocks) {
  Lanes m[4][125], one[25 * 6], two[5 * 36], values[216];
  gather_components(sheets, 4, m);
  contract_axis<Value_products>(m[2], 25, 1, one);
  contract_axis<Value_products>(one, 5, 6, two);
  contract_axis<Value_products>(two, 1, 36, values);
  const auto& entries = Packed_entry::table();
  for(int i = 0; i < Packed_blocks::padded_size; i += 4) {
    const Lanes row[4] = {values[entries[i].diagonal], values[entries[i + 1].diagonal],
                          values[entries[i + 2].diagonal], values[entries[i + 3].diagonal]};
    store_columns(row, i, blocks);
  }
}

} // namespace lanes

#endif // CGAL_RESTRICTED_LAPLACIAN_3_HAS_LANES

/// Adds the moments of a fragment of a triangle.
/// \param fragment in coordinates of the grid
/// \param cell the cell that owns the fragment
/// \param metric the same on all of the fragment
/// \param mass_weight factor of the moments of the mass; the others do not have it
/// \param density factor of both
/// \param degree 12, or 10 if there will be no mass matrix
inline void add_fragment(const Fragment& fragment, const std::array<int, 3>& cell,
                         const Symmetric_tensor_3& metric, Sheet_moments& moments,
                         double mass_weight, double density, int degree) {
  CGAL_RESTRICTED_LAPLACIAN_3_BEST(
      add_fragment(fragment, cell, metric, moments, mass_weight, density, degree));
}

/// Adds nodes.
inline void add_moments(const Moment_nodes& nodes, Sheet_moments& moments) {
  CGAL_RESTRICTED_LAPLACIAN_3_BEST(add_moments(nodes, moments));
}

/// Adds the nodes of a block.
/// \param mass_weights a factor for each node, or null
inline void add_node_moments(const Integration_node_block& block, const double* mass_weights,
                             Sheet_moments& moments) {
  Moment_nodes nodes;
  static_assert(Integration_node_block::capacity <= Moment_nodes::capacity);
  nodes.size = block.size;
  for(int axis = 0; axis < 3; ++axis)
    std::copy_n(block.positions[axis].begin(), nodes.size, nodes.positions[axis].begin());
  for(std::size_t i = 0; i < block.size; ++i) {
    const double weight = block.weights[i];
    for(int k = 0; k < 6; ++k)
      nodes.factors[i][k] = weight * block.metrics[i][k];
    nodes.factors[i][Sheet_moments::mass] = mass_weights ? weight * mass_weights[i] : weight;
    nodes.factors[i][Sheet_moments::area] = weight;
  }
  add_moments(nodes, moments);
}

/// Adds the moments of a child to those of its parent, whose area unit is four times that of the
/// child.
inline void add_child_moments(const Sheet_moments& child, int octant, Sheet_moments& parent) {
  CGAL_RESTRICTED_LAPLACIAN_3_BEST(add_child_moments(child, octant, parent));
}

/// the blocks of `stiffness_block()` of four sheets
inline void stiffness_blocks(const std::array<const Sheet_moments*, 4>& sheets,
                             Packed_blocks& blocks) {
  CGAL_RESTRICTED_LAPLACIAN_3_BEST(stiffness_blocks(sheets, blocks));
}

/// the blocks of `mass_block()` of four sheets
inline void mass_blocks(const std::array<const Sheet_moments*, 4>& sheets, Packed_blocks& blocks) {
  CGAL_RESTRICTED_LAPLACIAN_3_BEST(mass_blocks(sheets, blocks));
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_SHARED_SHEET_KERNELS_H
