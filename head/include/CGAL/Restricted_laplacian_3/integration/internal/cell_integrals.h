// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_INTERNAL_CELL_INTEGRALS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_INTERNAL_CELL_INTEGRALS_H

#include <CGAL/Restricted_laplacian_3/basis/B_spline_1.h>
#include <CGAL/Restricted_laplacian_3/basis/Tensor_basis_3.h>
#include <CGAL/Restricted_laplacian_3/integration/Integration_nodes.h>
#include <CGAL/Restricted_laplacian_3/octree/clip_to_cells.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// number of products of three Bernstein polynomials of degree 4, \f$5^3\f$
constexpr int number_of_moments = 125;

/// Moments of the surface in one cell.
///
/// On a cell all products of two elements or of their derivatives are polynomials of degree at most
/// 4 in each coordinate. So the 27 x 27 mass and stiffness blocks are linear functions of
/// \f[ m_{abc} = \int w\, B_a(t_x) B_b(t_y) B_c(t_z), \qquad
///     T^{kl}_{abc} = \int A_{kl}\, B_a(t_x) B_b(t_y) B_c(t_z), \quad
///     0 \le a, b, c \le 4, \f]
/// where \f$B_a\f$ are the Bernstein polynomials of degree 4, \f$t\f$ is the local coordinate,
/// \f$A\f$ the metric, \f$I - n n^T\f$ as a rule, and \f$w\f$ the weight of the mass; areas are
/// in units of the squared cell width. A node of a cubature rule costs 125 multiplications instead
/// of 2 x 27 x 27, the blocks are formed once per cell, and the moments of a parent follow from
/// those of its children.
///
/// Why Bernstein polynomials and not powers: an element whose support hardly reaches the surface
/// has entries many orders below those of its neighbors. In the Bernstein basis the spline pieces
/// have non-negative coefficients, so such entries are sums without cancellation and keep their
/// relative accuracy. With powers they would be the rounding errors of large numbers: the matrix
/// would no longer be positive semi-definite after scaling, and no smoother would converge.
///
/// The components of one moment are neighbors, so that they are multiplied and added as one or two
/// vectors of the processor: the six of the tensor (xx, yy, zz, xy, xz, yz), the mass, and the mass
/// without its weight.
struct alignas(64) Sheet_moments {
  static constexpr int components = 8, mass = 6, area = 7;
  using Component = std::array<double, number_of_moments>;
  /// moment \f$(a, b, c)\f$ has the number \f$a + 5 b + 25 c\f$
  std::array<std::array<double, components>, number_of_moments> values;

  void clear() { values.fill({}); }

  Component component(int k) const {
    Component result;
    for(int i = 0; i < number_of_moments; ++i)
      result[i] = values[i][k];
    return result;
  }

  /// the integral of a component: Bernstein polynomials sum to 1
  double sum(int k) const {
    double result = 0;
    for(const auto& value : values)
      result += value[k];
    return result;
  }
};

/// The integrals over a sheet of the finest level that matrices are made of.
struct Sheet_integrals {
  /// of the polynomials that moments are needed for: 12, or 10 if there will be no mass matrix
  int degree = 12;
  Sheet_moments moments;
  /// \f$\int n n^T\f$
  Symmetric_tensor_3 normals;
  /// half of the trace of \f$\int A\f$, if it is not that of the surface alone
  std::optional<double> diffusion;

  void clear() {
    moments.clear();
    normals.fill(0);
    diffusion.reset();
  }

  /// in units of the squared cell width
  double area() const { return normals[0] + normals[1] + normals[2]; }

  /// the mean over the sheet, by which the energy differs from that without a material
  double mean_diffusion() const { return diffusion && area() > 0 ? *diffusion / area() : 1; }

  void add_normal(const Vector_3& n, double area) {
    const Symmetric_tensor_3 nn = {n.x() * n.x(), n.y() * n.y(), n.z() * n.z(),
                                   n.x() * n.y(), n.x() * n.z(), n.y() * n.z()};
    for(int k = 0; k < 6; ++k)
      normals[k] += area * nn[k];
  }
};

/// Bernstein polynomials of degree 4 at \f$t\f$
inline std::array<double, 5> bernstein_4(double t) {
  const double u = 1 - t, t2 = t * t, u2 = u * u, tu = t * u;
  return {u2 * u2, 4 * tu * u2, 6 * tu * tu, 4 * tu * t2, t2 * t2};
}

/// \f$B_a(t_x) B_b(t_y) B_c(t_z)\f$, number \f$a + 5 b + 25 c\f$
inline Sheet_moments::Component bernstein_products(const std::array<double, 3>& t) {
  const auto x = bernstein_4(t[0]), y = bernstein_4(t[1]), z = bernstein_4(t[2]);
  Sheet_moments::Component result;
  std::size_t i = 0;
  for(int c = 0; c < 5; ++c)
    for(int b = 0; b < 5; ++b)
      for(int a = 0; a < 5; ++a)
        result[i++] = x[a] * (y[b] * z[c]);
  return result;
}

inline double triangle_area(const std::array<double, 3>& p, const std::array<double, 3>& q,
                            const std::array<double, 3>& r) {
  const double ux = q[0] - p[0], uy = q[1] - p[1], uz = q[2] - p[2];
  const double vx = r[0] - p[0], vy = r[1] - p[1], vz = r[2] - p[2];
  const double cx = uy * vz - uz * vy, cy = uz * vx - ux * vz, cz = ux * vy - uy * vx;
  return std::sqrt(cx * cx + cy * cy + cz * cz) / 2;
}

/// Contracts moments with one factor per axis:
/// \f$ r_{ijk} = \sum_{abc} X_{ia} Y_{jb} Z_{kc}\, m_{abc} \f$, number \f$i + N_x (j + N_y k)\f$.
template <std::size_t NX, std::size_t NY, std::size_t NZ>
void contract(const std::array<std::array<double, 5>, NX>& x,
              const std::array<std::array<double, 5>, NY>& y,
              const std::array<std::array<double, 5>, NZ>& z,
              const Sheet_moments::Component& moments, std::array<double, NX * NY * NZ>& result) {
  for(std::size_t k = 0; k < NZ; ++k) {
    std::array<double, 25> plane = {};
    for(int c = 0; c < 5; ++c)
      for(int i = 0; i < 25; ++i)
        plane[i] += z[k][c] * moments[i + 25 * c];
    for(std::size_t j = 0; j < NY; ++j) {
      std::array<double, 5> line = {};
      for(int b = 0; b < 5; ++b)
        for(int a = 0; a < 5; ++a)
          line[a] += y[j][b] * plane[a + 5 * b];
      for(std::size_t i = 0; i < NX; ++i) {
        double sum = 0;
        for(int a = 0; a < 5; ++a)
          sum += x[i][a] * line[a];
        result[i + NX * (j + NY * k)] = sum;
      }
    }
  }
}

using Pair_polynomials = std::array<std::array<double, 5>, 6>;
using Ordered_pair_polynomials = std::array<std::array<double, 5>, 9>;

/// number of the unordered pair (i, j) of pieces of `B_spline_1`
constexpr int pair_number(int i, int j) {
  return i <= j ? i * (5 - i) / 2 + j : j * (5 - j) / 2 + i;
}

/// Bernstein coefficients, of degree 4, of the product of two polynomials given by their Bernstein
/// coefficients of degree 2: \f$ r_k = \sum_{i + j = k} \binom{2}{i} \binom{2}{j} / \binom{4}{k}\,
/// p_i q_j \f$
constexpr std::array<double, 5> product(const std::array<double, 3>& p,
                                        const std::array<double, 3>& q) {
  const double two[3] = {1, 2, 1}, four[5] = {1, 4, 6, 4, 1};
  std::array<double, 5> result = {};
  for(int i = 0; i < 3; ++i)
    for(int j = 0; j < 3; ++j)
      result[i + j] += two[i] * two[j] / four[i + j] * p[i] * q[j];
  return result;
}

using Pieces = std::array<std::array<double, 3>, 3>;

/// products of the unordered pairs of pieces
constexpr Pair_polynomials pair_products(const Pieces& p) {
  Pair_polynomials result = {};
  for(int i = 0; i < 3; ++i)
    for(int j = i; j < 3; ++j)
      result[pair_number(i, j)] = product(p[i], p[j]);
  return result;
}

/// products of a piece of `p`, number \f$i\f$, and one of `q`, number \f$j\f$, in place
/// \f$i + 3 j\f$
constexpr Ordered_pair_polynomials ordered_pair_products(const Pieces& p, const Pieces& q) {
  Ordered_pair_polynomials result = {};
  for(int i = 0; i < 3; ++i)
    for(int j = 0; j < 3; ++j)
      result[i + 3 * j] = product(p[i], q[j]);
  return result;
}

/// Bernstein coefficients of the products of two pieces, of two derivatives, of a derivative (first
/// index of the ordered pair) with a piece, and the other way round
struct Spline_products {
  static constexpr Pieces pieces = B_spline_1::bernstein_coefficients(),
                          slopes = B_spline_1::derivative_bernstein_coefficients();
  static constexpr Pair_polynomials values = pair_products(pieces),
                                    derivatives = pair_products(slopes);
  static constexpr Ordered_pair_polynomials mixed = ordered_pair_products(slopes, pieces),
                                            transposed = ordered_pair_products(pieces, slopes);
};

/// Along an axis, for a child of parity 0, \f$t_{parent} = t/2\f$ and
/// \f$ B_n(t/2) = 2^{-k} \sum_{k \ge n} \binom{k}{n} B_k(t) \f$ (de Casteljau subdivision, again
/// without cancellation).
constexpr std::array<std::array<double, 5>, 5> lower_child_factor() {
  return {{{1, 1. / 2, 1. / 4, 1. / 8, 1. / 16},
           {0, 1. / 2, 2. / 4, 3. / 8, 4. / 16},
           {0, 0, 1. / 4, 3. / 8, 6. / 16},
           {0, 0, 0, 1. / 8, 4. / 16},
           {0, 0, 0, 0, 1. / 16}}};
}

/// the mirror image, for a child of parity 1
constexpr std::array<std::array<double, 5>, 5> upper_child_factor() {
  std::array<std::array<double, 5>, 5> result = {};
  for(int i = 0; i < 5; ++i)
    for(int j = 0; j < 5; ++j)
      result[i][j] = lower_child_factor()[4 - i][4 - j];
  return result;
}

/// Adds the moments of a child to those of its parent, whose area unit is four times that of the
/// child: of one component.
inline void add_child_component(const Sheet_moments& child, int k, int octant,
                                Sheet_moments& parent) {
  static constexpr auto lower = lower_child_factor(), upper = upper_child_factor();
  Sheet_moments::Component shifted;
  contract(octant & 1 ? upper : lower, octant >> 1 & 1 ? upper : lower,
           octant >> 2 & 1 ? upper : lower, child.component(k), shifted);
  for(int i = 0; i < number_of_moments; ++i)
    parent.values[i][k] += 0.25 * shifted[i];
}

/// The moments of the stabilization of a sheet of the finest level. It adds to the stiffness block
/// the integral over the *volume* of the cell of \f$c\, \nabla b_i^T A\, \nabla b_j\f$: the block
/// of the tensor moments \f$c\, A_{kl} \int B_a B_b B_c = c\, A_{kl} / 125\f$, with
/// \f[ A = \min(1, a / a_0)\, \bigl(N + q\, \max(0, 1 - a / a_0)\, I\bigr), \f]
/// \f$N\f$ the average of \f$n n^T\f$ over the sheet, \f$a\f$ its area in units of the squared cell
/// width.
///
/// *Tiny sheets* are those below \f$a_0\f$. The surface itself has no more energy than \f$a\f$ in
/// such a cell: a penalty that did not shrink with it would tie the elements of neighboring cells
/// together. On a piece of the diameter \f$d \ll 1\f$ all functions are nearly constant: what is
/// linear along the surface has \f$d^2\f$ of the scaled diagonal, what is quadratic has
/// \f$d^4\f$, which single precision does not see. So the whole gradient is penalized there, by a
/// fraction \f$q\f$.
///
/// *Walls.* Where a sheet lies in a wall between cells, the elements that act on it do not sum to 1
/// in the volume, but do on the wall, together with their derivatives across: there it is the
/// integral over the face of the cell. In two walls or three, at an edge or a corner of a box, it
/// is the mean of the integrals over their faces.
class Sheet_stabilization {
public:
  /// \f$a_0\f$: a larger one changes the operator on more sheets, a smaller one leaves some for
  /// which the penalty is too large
  static constexpr double tiny_area = 0.03;
  /// \f$q\f$: enough for single precision to see, and small beside the penalty along the normal,
  /// so that it does not show in the error of the solution
  static constexpr double part_of_tangents = 0.1;

  /// Of each axis, -1 if a part of the sheet lies in the lower wall across it, 1 if in the upper
  /// one, else 0. If one of them is not 0, all of the sheet lies in walls.
  using Walls = std::array<int, 3>;

  Sheet_stabilization(const Sheet_integrals& integrals, double stabilization, const Walls& walls) {
    const double area = integrals.area();
    if(!(area > 0)) // no sample in the cell
      return;
    const double size = (std::min)(area / tiny_area, 1.);
    for(int k = 0; k < 6; ++k)
      m_tensor[k] = stabilization * size *
                    (integrals.normals[k] / area + (k < 3 ? part_of_tangents * (1 - size) : 0));
    const auto number_of_walls = 3 - std::count(walls.begin(), walls.end(), 0);
    if(number_of_walls == 0) {
      m_factors.fill(1. / number_of_moments);
      return;
    }
    // Of the five polynomials along an axis one is not 0 in a wall.
    for(int i = 0; i < number_of_moments; ++i) {
      const std::array<int, 3> number = {i % 5, i / 5 % 5, i / 25};
      for(int axis = 0; axis < 3; ++axis)
        if(walls[axis] != 0 && number[axis] == (walls[axis] < 0 ? 0 : 4))
          m_factors[i] += 1. / 25 / static_cast<double>(number_of_walls);
    }
  }

  /// component `k` of moment `i`
  double operator()(int i, int k) const { return m_factors[i] * m_tensor[k]; }

private:
  Symmetric_tensor_3 m_tensor = {0, 0, 0, 0, 0, 0};
  Sheet_moments::Component m_factors = {};
};

/// A symmetric 27 x 27 block: entry \f$27 i + j\f$, elements numbered as in `Cell_elements`.
using Cell_block = std::array<double, Tensor_basis_3::size * Tensor_basis_3::size>;

/// Where the products of one factor of two elements stand in `Spline_products`.
struct Factor_pair {
  int symmetric;  // in those that are equal for both orders, 6
  int ordered;    // in those that are not, 9
  int transposed; // in the same, with the elements exchanged
};

/// Sets every entry of a block to `value(x, y, z)`, the pairs of factors of its two elements.
template <class Value> void fill_block(Cell_block& block, Value&& value) {
  static constexpr auto pair = [](int i, int j) {
    return Factor_pair{pair_number(i, j), i + 3 * j, j + 3 * i};
  };
  std::size_t entry = 0;
  for(int iz = 0; iz < 3; ++iz)
    for(int iy = 0; iy < 3; ++iy)
      for(int ix = 0; ix < 3; ++ix)
        for(int jz = 0; jz < 3; ++jz)
          for(int jy = 0; jy < 3; ++jy) {
            const Factor_pair y = pair(iy, jy), z = pair(iz, jz);
            for(int jx = 0; jx < 3; ++jx)
              block[entry++] = value(pair(ix, jx), y, z);
          }
}

/// \f$\int b_i b_j\f$ over the surface in one cell, in units of the squared cell width.
inline void mass_block(const Sheet_moments& moments, Cell_block& block) {
  const auto& v = Spline_products::values;
  std::array<double, 216> values;
  contract(v, v, v, moments.component(Sheet_moments::mass), values);
  fill_block(block, [&](const Factor_pair& x, const Factor_pair& y, const Factor_pair& z) {
    return values[x.symmetric + 6 * (y.symmetric + 6 * z.symmetric)];
  });
}

/// \f$\int \nabla b_i^T A\, \nabla b_j\f$ over the surface in one cell; it has no unit.
inline void stiffness_block(const Sheet_moments& moments, Cell_block& block) {
  const auto& v = Spline_products::values;
  const auto& d = Spline_products::derivatives;
  const auto& m = Spline_products::mixed;
  const auto& mt = Spline_products::transposed;
  std::array<double, 216> xx, yy, zz;
  std::array<double, 486> xy, xz, yz;
  contract(d, v, v, moments.component(0), xx);
  contract(v, d, v, moments.component(1), yy);
  contract(v, v, d, moments.component(2), zz);
  // d_x b_i d_y b_j and so on; its transpose is the entry with i and j exchanged
  contract(m, mt, v, moments.component(3), xy);
  contract(m, v, mt, moments.component(4), xz);
  contract(v, m, mt, moments.component(5), yz);

  fill_block(block, [&](const Factor_pair& x, const Factor_pair& y, const Factor_pair& z) {
    const int p = x.symmetric + 6 * (y.symmetric + 6 * z.symmetric);
    // Sums of an entry with its transpose first: the block is symmetric to the last bit.
    return xx[p] + yy[p] + zz[p] +
           (xy[x.ordered + 9 * (y.ordered + 9 * z.symmetric)] +
            xy[x.transposed + 9 * (y.transposed + 9 * z.symmetric)]) +
           (xz[x.ordered + 9 * (y.symmetric + 6 * z.ordered)] +
            xz[x.transposed + 9 * (y.symmetric + 6 * z.transposed)]) +
           (yz[x.symmetric + 6 * (y.ordered + 9 * z.ordered)] +
            yz[x.symmetric + 6 * (y.transposed + 9 * z.transposed)]);
  });
}

/// \f$\int b_i\f$ over the surface in one cell, in units of the squared cell width: Bernstein
/// polynomials of degree 2 are combinations, without negative coefficients, of those of degree 4.
/// \param component `Sheet_moments::mass`, or `area` for the integrals without a weight
inline Tensor_basis_3::Values element_integrals(const Sheet_moments& moments, int component) {
  static const auto pieces = [] {
    std::array<std::array<double, 5>, 3> result;
    const auto b = B_spline_1::bernstein_coefficients();
    for(int i = 0; i < 3; ++i)
      result[i] = product(b[i], {1, 1, 1});
    return result;
  }();
  Tensor_basis_3::Values integrals;
  contract(pieces, pieces, pieces, moments.component(component), integrals);
  return integrals;
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_INTERNAL_CELL_INTEGRALS_H
