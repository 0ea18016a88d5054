// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_INTERNAL_FIT_RESIDUAL_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_INTERNAL_FIT_RESIDUAL_IMPL_H

#include <CGAL/Restricted_laplacian_3/assembly/internal/fit_residual.h>
#include <CGAL/Restricted_laplacian_3/assembly/internal/sheet_loads.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parallel_for.h>
#include <CGAL/Restricted_laplacian_3/splines/internal/Block_evaluation.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Fit_residual fit_residual(const Spline_space_3& space,
                                                             const Surface_function_view& f,
                                                             const Eigen::MatrixXd& coefficients) {
  constexpr std::size_t capacity = Integration_node_block::capacity;
  const int number = f.components(), depth = space.depth();
  const double h = space.octree().cell_width(depth);
  const bool is_zero = coefficients.cols() == 0;
  // a function alone is integrated against elements, its difference to a spline is also squared
  const int degree = is_zero ? 6 + f.degree() : 12;
  const Eigen::Index sheets = static_cast<Eigen::Index>(space.number_of_sheets(depth));
  // a column for each sheet
  Eigen::MatrixXd squares = Eigen::MatrixXd::Zero(number, sheets);
  Fit_residual result;
  result.loads =
      sum_loads(space, depth, number, h * h, [&](std::size_t sheet, Cell_load::Load* loads) {
        Block_evaluation<capacity> u(space, sheet, coefficients);
        std::vector<Cell_load> moments(number);
        std::vector<double> values(number * capacity);
        space.integration().visit_nodes(sheet, degree, [&](Integration_node_block& block) {
          f(block.points.data(), block.size, values.data());
          check_values(block, values.data(), number, "f");
          if(!is_zero)
            u.set_points(block.positions);
          for(int k = 0; k < number; ++k) {
            if(!is_zero) {
              const Node_values of_u = u.values(k);
              for(std::size_t i = 0; i < block.size; ++i)
                values[number * i + k] -= of_u[i];
            }
            const Node_values weighted = weighted_component(block, values.data(), number, k);
            for(std::size_t i = 0; i < block.size; ++i)
              squares(k, sheet) += weighted[i] * values[number * i + k];
            moments[k].add(block.positions, weighted);
          }
        });
        for(int k = 0; k < number; ++k)
          moments[k].add_values_to(loads[k]);
      });
  result.squares = squares.rowwise().sum();
  return result;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE std::vector<double>
gradient_residuals(const Spline_space_3& space, const Vector_field_view& v,
                   const Eigen::MatrixXd& coefficients) {
  constexpr int degree_of_rule = 2;
  constexpr std::size_t capacity = Integration_node_block::capacity, grain = 256;
  const int number = v.channels(), depth = space.depth();
  const double h = space.octree().cell_width(depth);
  const std::size_t number_of_sheets = space.number_of_sheets(depth);
  Eigen::MatrixXd squares =
      Eigen::MatrixXd::Zero(number, static_cast<Eigen::Index>(number_of_sheets));
  parallel_for(space.options().is_parallel, 0, number_of_sheets, grain,
               [&](std::size_t begin, std::size_t end) {
                 std::vector<double> values(v.components() * capacity);
                 for(std::size_t sheet = begin; sheet < end; ++sheet) {
                   Block_evaluation<capacity> u(space, sheet, coefficients);
                   space.integration().visit_nodes(
                       sheet, degree_of_rule, [&](Integration_node_block& block) {
                         v(block.points.data(), block.size, values.data());
                         u.set_points(block.positions);
                         for(int k = 0; k < number; ++k) {
                           const Node_values x = u.derivatives(k, 0), y = u.derivatives(k, 1),
                                             z = u.derivatives(k, 2);
                           for(std::size_t i = 0; i < block.size; ++i) {
                             const double* const w = values.data() + v.components() * i + 3 * k;
                             const double dx = x[i] / h - w[0], dy = y[i] / h - w[1],
                                          dz = z[i] / h - w[2];
                             const auto [fx, fy, fz] = product(block.metrics[i], dx, dy, dz);
                             squares(k, sheet) += block.weights[i] * (dx * fx + dy * fy + dz * fz);
                           }
                         }
                       });
                 }
               });
  std::vector<double> result;
  for(int k = 0; k < number; ++k)
    result.push_back(h * std::sqrt(squares.row(k).sum() / space.surface().area()));
  return result;
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_INTERNAL_FIT_RESIDUAL_IMPL_H
