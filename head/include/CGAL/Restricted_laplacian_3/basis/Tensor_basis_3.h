// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_BASIS_TENSOR_BASIS_3_H
#define CGAL_RESTRICTED_LAPLACIAN_3_BASIS_TENSOR_BASIS_3_H

#include <CGAL/Restricted_laplacian_3/basis/B_spline_1.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Dev
/// The basis on one cell: the products of three pieces of `B_spline_1`, one for each axis. They are
/// the elements centered on the cell and its 26 neighbors. Number
/// \f$i = p_x + 3 p_y + 9 p_z\f$ is the product of pieces \f$p_x, p_y, p_z\f$, and centered on the
/// neighbor at offset \f$(p_x - 1, p_y - 1, p_z - 1)\f$. All else in the package asks this class
/// how many they are and in which order.
struct Tensor_basis_3 {
  /// pieces along an axis
  static constexpr int pieces = 3;
  /// number of products
  static constexpr int size = pieces * pieces * pieces;
  /// a number for each product
  using Values = std::array<double, size>;

  /// number of the product of three pieces
  static constexpr int number(int x, int y, int z) { return x + pieces * (y + pieces * z); }
  /// the three pieces of a product
  static constexpr std::array<int, 3> pieces_of(int i) {
    return {i % pieces, i / pieces % pieces, i / (pieces * pieces)};
  }
  /// offset, in cells, of the center of an element from the cell
  static constexpr std::array<int, 3> offset(int i) {
    const auto p = pieces_of(i);
    return {p[0] - 1, p[1] - 1, p[2] - 1};
  }

  /// the products of numbers that are given for each piece along each axis
  template <class Number>
  static Values products(const std::array<std::array<Number, pieces>, 3>& factors) {
    Values result;
    std::size_t i = 0;
    for(int z = 0; z < pieces; ++z)
      for(int y = 0; y < pieces; ++y)
        for(int x = 0; x < pieces; ++x)
          result[i++] = factors[0][x] * factors[1][y] * factors[2][z];
    return result;
  }

  /// values at a local coordinate
  static Values values(const std::array<double, 3>& t) {
    return products<double>(
        {B_spline_1::values(t[0]), B_spline_1::values(t[1]), B_spline_1::values(t[2])});
  }

  /// derivatives along an axis at a local coordinate, times the cell width
  static Values derivatives(const std::array<double, 3>& t, int axis) {
    std::array<std::array<double, pieces>, 3> factors;
    for(int a = 0; a < 3; ++a)
      factors[a] = a == axis ? B_spline_1::derivatives(t[a]) : B_spline_1::values(t[a]);
    return products<double>(factors);
  }

  /// derivatives along the three axes at a local coordinate, times the cell width
  static std::array<Values, 3> gradients(const std::array<double, 3>& t) {
    return {derivatives(t, 0), derivatives(t, 1), derivatives(t, 2)};
  }

  /// Coefficients \f$c_i\f$ of a fine element in the coarse elements of a cell, see
  /// `B_spline_1::two_scale_coefficient()`: coarse element \f$i\f$ of `coarse_cell` contains
  /// \f$c_i\f$ times the fine element that is centered on the cell `fine_center` of the next finer
  /// level.
  static Values two_scale_coefficients(const std::array<int, 3>& fine_center,
                                       const std::array<int, 3>& coarse_cell) {
    std::array<std::array<double, pieces>, 3> factors;
    for(int axis = 0; axis < 3; ++axis)
      for(int p = 0; p < pieces; ++p)
        factors[axis][p] =
            B_spline_1::two_scale_coefficient(fine_center[axis] - 2 * (coarse_cell[axis] + p - 1));
    return products<double>(factors);
  }
};

namespace internal {

/// number of unordered pairs of products of `Tensor_basis_3`
constexpr int number_of_element_pairs = Tensor_basis_3::size * (Tensor_basis_3::size + 1) / 2;

constexpr auto make_element_pairs() {
  std::array<std::array<std::uint16_t, Tensor_basis_3::size>, Tensor_basis_3::size> result = {};
  std::uint16_t number = 0;
  for(int j = 0; j < Tensor_basis_3::size; ++j)
    for(int i = 0; i <= j; ++i)
      result[i][j] = result[j][i] = number++;
  return result;
}

/// The number of each unordered pair: symmetric blocks hold an entry for each.
inline constexpr auto element_pairs = make_element_pairs();

} // namespace internal

/// \ingroup PkgRestrictedLaplacian3Dev
/// The numbers of the elements that can act on a sheet, in the order of `Tensor_basis_3`;
/// `no_element` where there is none.
using Cell_elements = std::array<std::uint32_t, Tensor_basis_3::size>;

/// \ingroup PkgRestrictedLaplacian3Dev
/// stands for an element that does not exist
constexpr std::uint32_t no_element = (std::numeric_limits<std::uint32_t>::max)();

/// \ingroup PkgRestrictedLaplacian3Dev
/// Calls `visit(i, element)` for the elements that exist, `i` their number in the cell.
template <class Visitor> void for_each_element(const Cell_elements& elements, Visitor&& visit) {
  for(int i = 0; i < Tensor_basis_3::size; ++i)
    if(elements[i] != no_element)
      visit(i, elements[i]);
}

/// \ingroup PkgRestrictedLaplacian3Dev
/// The sum of numbers for the elements of a sheet, times the coefficients of those that exist: a
/// function where `values` are those of the elements.
/// \param elements those of the sheet
/// \param values a number for each of them
/// \param coefficients of all elements of the level, a vector
template <class Coefficients>
double combination(const Cell_elements& elements, const Tensor_basis_3::Values& values,
                   const Coefficients& coefficients) {
  double result = 0;
  for_each_element(
      elements, [&](int i, std::uint32_t element) { result += values[i] * coefficients[element]; });
  return result;
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_BASIS_TENSOR_BASIS_3_H
