// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_CELL_INTEGRALS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_CELL_INTEGRALS_H

#include <CGAL/Restricted_laplacian_3/integration/triangle_quadrature.h>
#include <CGAL/Restricted_laplacian_3/octree/Octree_3.h>
#include <CGAL/Restricted_laplacian_3/splines/B_spline_1.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Dev
/// Moments of the surface in one cell.
///
/// On a cell all products of two elements or of their derivatives are polynomials of degree at most
/// 4 in each coordinate. So the 27 x 27 mass and stiffness blocks are linear functions of
/// \f[ m_{abc} = \int B_a(t_x) B_b(t_y) B_c(t_z), \qquad
///     T^{kl}_{abc} = \int (I - n n^T)_{kl}\, B_a(t_x) B_b(t_y) B_c(t_z), \quad
///     0 \le a, b, c \le 4, \f]
/// where \f$B_a\f$ are the Bernstein polynomials of degree 4 and \f$t\f$ is the local coordinate;
/// areas are in units of the squared cell width. A node of a cubature rule costs 125
/// multiplications instead of 2 x 27 x 27, the blocks are formed once per cell, and the moments of
/// a parent follow from those of its children.
///
/// Why Bernstein polynomials and not powers: an element whose support hardly reaches the surface
/// has entries many orders below those of its neighbours. In the Bernstein basis the spline pieces
/// have non-negative coefficients, so such entries are sums without cancellation and keep their
/// relative accuracy. With powers they would be the rounding errors of large numbers: the matrix
/// would no longer be positive semi-definite after scaling, and no smoother would converge.
struct Cell_moments {
  /// number of products of three Bernstein polynomials, \f$5^3\f$
  static constexpr int size = 125;
  /// number \f$a + 5 b + 25 c\f$
  using Moments = std::array<double, size>;
  /// tensor components xx, yy, zz, xy, xz, yz
  using Tensor_moments = std::array<Moments, 6>;

  /// \f$m\f$, in units of the squared cell width; not initialised, see `clear()`
  Moments mass;
  /// \f$T\f$, in the same units
  Tensor_moments tensor;

  /// sets all moments to 0
  void clear() {
    mass.fill(0);
    for(Moments& t : tensor)
      t.fill(0);
  }
};

namespace internal {

/// Components of \f$I - n n^T\f$ in the order of `Cell_moments::tensor`. The diagonal is written
/// without cancellation: \f$1 - n_x^2 = n_y^2 + n_z^2\f$.
inline std::array<double, 6> tangent_projector(const Vector_3& n) {
  const double xx = n.x() * n.x(), yy = n.y() * n.y(), zz = n.z() * n.z();
  return {yy + zz, xx + zz, xx + yy, -n.x() * n.y(), -n.x() * n.z(), -n.y() * n.z()};
}

/// Bernstein polynomials of degree 4 at \f$t\f$
inline std::array<double, 5> bernstein_4(double t) {
  const double u = 1 - t, t2 = t * t, u2 = u * u, tu = t * u;
  return {u2 * u2, 4 * tu * u2, 6 * tu * tu, 4 * tu * t2, t2 * t2};
}

/// adds `weight` \f$B_a(t_x) B_b(t_y) B_c(t_z)\f$
inline void add_node(const std::array<double, 3>& t, double weight,
                     Cell_moments::Moments& moments) {
  const auto x = bernstein_4(t[0]), y = bernstein_4(t[1]), z = bernstein_4(t[2]);
  std::array<double, 25> xy;
  for(int b = 0; b < 5; ++b)
    for(int a = 0; a < 5; ++a)
      xy[a + 5 * b] = x[a] * y[b];
  for(int c = 0; c < 5; ++c) {
    const double factor = weight * z[c];
    double* row = moments.data() + 25 * c;
    for(int i = 0; i < 25; ++i)
      row[i] += factor * xy[i];
  }
}

inline void add_scaled(const Cell_moments::Moments& from, double factor,
                       Cell_moments::Moments& to) {
  for(int i = 0; i < Cell_moments::size; ++i)
    to[i] += factor * from[i];
}

inline double triangle_area(const std::array<double, 3>& p, const std::array<double, 3>& q,
                            const std::array<double, 3>& r) {
  const double ux = q[0] - p[0], uy = q[1] - p[1], uz = q[2] - p[2];
  const double vx = r[0] - p[0], vy = r[1] - p[1], vz = r[2] - p[2];
  const double cx = uy * vz - uz * vy, cy = uz * vx - ux * vz, cz = ux * vy - uy * vx;
  return std::sqrt(cx * cx + cy * cy + cz * cz) / 2;
}

/// Calls `visit(t, barycentric, weight)` for the nodes of a cubature rule on the triangles of a
/// fragment, fanned out from its first corner; `t` is the local coordinate in the cell, weights are
/// in units of the squared cell width.
template <class Visitor>
void for_each_node(const Fragment& fragment, const std::array<int, 3>& cell,
                   const std::vector<Triangle_quadrature_node>& rule, Visitor&& visit) {
  if(fragment.size < 3)
    return;
  const auto local = [&](std::size_t corner) {
    std::array<double, 3> t;
    for(int axis = 0; axis < 3; ++axis)
      t[axis] = fragment.corners[corner].position[axis] - cell[axis];
    return t;
  };
  std::array<std::array<double, 3>, 3> t;
  t[0] = local(0);
  t[2] = local(1);
  const auto& l0 = fragment.corners[0].barycentric;
  for(std::size_t i = 2; i < fragment.size; ++i) {
    t[1] = t[2];
    t[2] = local(i);
    const double area = triangle_area(t[0], t[1], t[2]);
    const auto &l1 = fragment.corners[i - 1].barycentric, &l2 = fragment.corners[i].barycentric;
    for(const Triangle_quadrature_node& node : rule) {
      std::array<double, 3> p, l;
      for(int axis = 0; axis < 3; ++axis) {
        p[axis] = node.b0 * t[0][axis] + node.b1 * t[1][axis] + node.b2 * t[2][axis];
        l[axis] = node.b0 * l0[axis] + node.b1 * l1[axis] + node.b2 * l2[axis];
      }
      visit(p, l, node.weight * area);
    }
  }
}

/// Contracts moments with one factor per axis:
/// \f$ r_{ijk} = \sum_{abc} X_{ia} Y_{jb} Z_{kc}\, m_{abc} \f$, number \f$i + N_x (j + N_y k)\f$.
template <std::size_t NX, std::size_t NY, std::size_t NZ>
void contract(const std::array<std::array<double, 5>, NX>& x,
              const std::array<std::array<double, 5>, NY>& y,
              const std::array<std::array<double, 5>, NZ>& z, const Cell_moments::Moments& moments,
              std::array<double, NX * NY * NZ>& result) {
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

} // namespace internal

/// \ingroup PkgRestrictedLaplacian3Dev
/// Adds the moments of a fragment of a triangle.
/// \param fragment a fragment in coordinates of the grid
/// \param cell the cell that owns the fragment
/// \param normal unit normal of the triangle; only \f$n n^T\f$ is used, so its sign does not matter
/// \param moments what is added to
inline void add_fragment(const Fragment& fragment, const std::array<int, 3>& cell,
                         const Vector_3& normal, Cell_moments& moments) {
  Cell_moments::Moments own;
  own.fill(0);
  internal::for_each_node(fragment, cell, triangle_quadrature(12),
                          [&own](const std::array<double, 3>& t, const std::array<double, 3>&,
                                 double weight) { internal::add_node(t, weight, own); });
  const auto projector = internal::tangent_projector(normal);
  internal::add_scaled(own, 1, moments.mass);
  for(int k = 0; k < 6; ++k)
    internal::add_scaled(own, projector[k], moments.tensor[k]);
}

/// \ingroup PkgRestrictedLaplacian3Dev
/// Adds one sample of the surface: local coordinate in the cell; unit normal; weight in units of
/// the squared cell width.
inline void add_sample(const std::array<double, 3>& t, const Vector_3& normal, double weight,
                       Cell_moments& moments) {
  Cell_moments::Moments own;
  own.fill(0);
  internal::add_node(t, weight, own);
  const auto projector = internal::tangent_projector(normal);
  internal::add_scaled(own, 1, moments.mass);
  for(int k = 0; k < 6; ++k)
    internal::add_scaled(own, projector[k], moments.tensor[k]);
}

namespace internal {

inline double sum(const Cell_moments::Moments& moments) {
  double result = 0;
  for(double value : moments)
    result += value;
  return result;
}

/// The area of the surface in a cell, in units of the squared cell width: half the trace of
/// \f$\int I - n n^T\f$. The moments of the mass may have a weight, which those of the tensor have
/// not.
inline double surface_area(const Cell_moments& moments) {
  return (sum(moments.tensor[0]) + sum(moments.tensor[1]) + sum(moments.tensor[2])) / 2;
}

/// The moments of the stabilisation of a finest cell. It adds to the stiffness block the integral
/// over the *volume* of the cell of \f$c\, \nabla b_i^T A\, \nabla b_j\f$, \f$A\f$ the average of
/// \f$n n^T\f$ over the surface in the cell: the block of the tensor moments
/// \f$c\, A_{kl} \int B_a B_b B_c = c\, A_{kl} / 125\f$. All are equal, so one of them is returned
/// for each component.
///
/// With \f$\tau_{kl}\f$ the sums of the tensor moments, \f$\int n_x^2 = (\tau_{yy} + \tau_{zz} -
/// \tau_{xx}) / 2\f$: the identity does not enter, whose part would cancel.
inline std::array<double, 6> stabilization_moments(const Cell_moments& moments,
                                                   double normal_stabilization) {
  std::array<double, 6> tau;
  for(int k = 0; k < 6; ++k)
    tau[k] = sum(moments.tensor[k]);
  const double area = (tau[0] + tau[1] + tau[2]) / 2;
  if(!(area > 0)) // no sample in the cell
    return {0, 0, 0, 0, 0, 0};
  const double factor = normal_stabilization / (Cell_moments::size * area);
  std::array<double, 6> result;
  for(int k = 0; k < 3; ++k)
    result[k] = factor * (std::max)(area - tau[k], 0.);
  for(int k = 3; k < 6; ++k)
    result[k] = -factor * tau[k];
  return result;
}

/// The same with the integral over the surface in place of that over the volume,
/// \f$c / a \int \nabla b_i^T n n^T \nabla b_j\f$, \f$a\f$ the area: component `k` of moment `i`,
/// where `factor` is \f$c / a\f$.
inline std::array<double, 6> surface_stabilization_moments(const Cell_moments& moments,
                                                           double factor, int i) {
  const auto& t = moments.tensor;
  const double trace = (t[0][i] + t[1][i] + t[2][i]) / 2;
  return {factor * (std::max)(trace - t[0][i], 0.),
          factor * (std::max)(trace - t[1][i], 0.),
          factor * (std::max)(trace - t[2][i], 0.),
          -factor * t[3][i],
          -factor * t[4][i],
          -factor * t[5][i]};
}

} // namespace internal

/// \ingroup PkgRestrictedLaplacian3Dev
/// Adds the moments of a child to those of its parent, each times `factor`.
inline void add_child_moments(const Cell_moments::Moments& child, int octant, double factor,
                              Cell_moments::Moments& parent) {
  static constexpr auto lower = internal::lower_child_factor(),
                        upper = internal::upper_child_factor();
  const auto& x = octant & 1 ? upper : lower;
  const auto& y = octant >> 1 & 1 ? upper : lower;
  const auto& z = octant >> 2 & 1 ? upper : lower;
  Cell_moments::Moments shifted;
  internal::contract(x, y, z, child, shifted);
  internal::add_scaled(shifted, factor, parent);
}

/// \ingroup PkgRestrictedLaplacian3Dev
/// Adds the moments of a child to those of its parent, whose area unit is four times that of the
/// child.
inline void add_child_moments(const Cell_moments& child, int octant, Cell_moments& parent) {
  add_child_moments(child.mass, octant, 0.25, parent.mass);
  for(int k = 0; k < 6; ++k)
    add_child_moments(child.tensor[k], octant, 0.25, parent.tensor[k]);
}

/// \ingroup PkgRestrictedLaplacian3Dev
/// A symmetric 27 x 27 block: entry \f$27 i + j\f$, elements numbered as in `Cell_elements`.
using Cell_block = std::array<double, 27 * 27>;

/// \ingroup PkgRestrictedLaplacian3Dev
/// \f$\int b_i b_j\f$ over the surface in one cell, in units of the squared cell width.
inline void mass_block(const Cell_moments& moments, Cell_block& block) {
  const auto& v = internal::Spline_products::values;
  std::array<double, 216> values;
  internal::contract(v, v, v, moments.mass, values);
  std::size_t entry = 0;
  for(int iz = 0; iz < 3; ++iz)
    for(int iy = 0; iy < 3; ++iy)
      for(int ix = 0; ix < 3; ++ix)
        for(int jz = 0; jz < 3; ++jz)
          for(int jy = 0; jy < 3; ++jy) {
            const int row = 6 * (internal::pair_number(iy, jy) + 6 * internal::pair_number(iz, jz));
            for(int jx = 0; jx < 3; ++jx)
              block[entry++] = values[internal::pair_number(ix, jx) + row];
          }
}

/// \ingroup PkgRestrictedLaplacian3Dev
/// \f$\int \nabla b_i^T (I - n n^T) \nabla b_j\f$ over the surface in one cell; it has no unit.
inline void stiffness_block(const Cell_moments::Tensor_moments& tensor, Cell_block& block) {
  const auto& v = internal::Spline_products::values;
  const auto& d = internal::Spline_products::derivatives;
  const auto& m = internal::Spline_products::mixed;
  const auto& mt = internal::Spline_products::transposed;
  std::array<double, 216> xx, yy, zz;
  std::array<double, 486> xy, xz, yz;
  internal::contract(d, v, v, tensor[0], xx);
  internal::contract(v, d, v, tensor[1], yy);
  internal::contract(v, v, d, tensor[2], zz);
  // d_x b_i d_y b_j and so on; its transpose is the entry with i and j exchanged
  internal::contract(m, mt, v, tensor[3], xy);
  internal::contract(m, v, mt, tensor[4], xz);
  internal::contract(v, m, mt, tensor[5], yz);

  std::size_t entry = 0;
  for(int iz = 0; iz < 3; ++iz)
    for(int iy = 0; iy < 3; ++iy)
      for(int ix = 0; ix < 3; ++ix)
        for(int jz = 0; jz < 3; ++jz)
          for(int jy = 0; jy < 3; ++jy) {
            const int py = internal::pair_number(iy, jy), pz = internal::pair_number(iz, jz);
            const int y = iy + 3 * jy, yt = jy + 3 * iy, z = iz + 3 * jz, zt = jz + 3 * iz;
            for(int jx = 0; jx < 3; ++jx) {
              const int px = internal::pair_number(ix, jx), x = ix + 3 * jx, xt = jx + 3 * ix;
              const int p = px + 6 * (py + 6 * pz);
              // Sums of an entry with its transpose first: the block is symmetric to the last bit.
              block[entry++] = xx[p] + yy[p] + zz[p] +
                               (xy[x + 9 * (y + 9 * pz)] + xy[xt + 9 * (yt + 9 * pz)]) +
                               (xz[x + 9 * (py + 6 * z)] + xz[xt + 9 * (py + 6 * zt)]) +
                               (yz[px + 6 * (y + 9 * z)] + yz[px + 6 * (yt + 9 * zt)]);
            }
          }
}

/// \ingroup PkgRestrictedLaplacian3Dev
/// The same from all moments, of which the mass is not read.
inline void stiffness_block(const Cell_moments& moments, Cell_block& block) {
  stiffness_block(moments.tensor, block);
}

/// \ingroup PkgRestrictedLaplacian3Dev
/// \f$\int b_i\f$ over the surface in one cell, in units of the squared cell width: Bernstein
/// polynomials of degree 2 are combinations, without negative coefficients, of those of degree 4.
inline std::array<double, 27> element_integrals(const Cell_moments& moments) {
  static const auto pieces = [] {
    std::array<std::array<double, 5>, 3> result;
    const auto b = B_spline_1::bernstein_coefficients();
    for(int i = 0; i < 3; ++i)
      result[i] = internal::product(b[i], {1, 1, 1});
    return result;
  }();
  std::array<double, 27> integrals;
  internal::contract(pieces, pieces, pieces, moments.mass, integrals);
  return integrals;
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_INTEGRATION_CELL_INTEGRALS_H
