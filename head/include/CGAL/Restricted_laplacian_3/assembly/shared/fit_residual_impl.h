// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_SHARED_FIT_RESIDUAL_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_SHARED_FIT_RESIDUAL_IMPL_H

#include <CGAL/Restricted_laplacian_3/assembly/shared/fit_residual.h>
#include <CGAL/Restricted_laplacian_3/assembly/shared/sheet_loads.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Function_view.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parallel_for.h>
#include <CGAL/Restricted_laplacian_3/splines/shared/Block_evaluation.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// below this fraction of what was subtracted from each other, squares have fewer than four digits
constexpr double smallest_accurate_square = 1e-10;

/// the area of the surface, or the integral of its density
inline double weighted_area(const Spline_space_3& space) {
  if(space.material().is_trivial())
    return space.surface().area();
  constexpr int degree_of_rule = 2;
  const double h = space.octree().cell_width(space.depth());
  double sum = 0;
  for(std::size_t sheet = 0; sheet < space.number_of_sheets(space.depth()); ++sheet)
    space.integration_with_material().visit_nodes(sheet, degree_of_rule,
                                                  [&](Integration_node_block& block) {
                                                    for(std::size_t i = 0; i < block.size; ++i)
                                                      sum += block.weights[i];
                                                  });
  return h * h * sum;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE std::vector<double>
Fit_residual::root_means(const Spline_space_3& space) const {
  const double h = space.octree().cell_width(space.depth()), area = weighted_area(space);
  std::vector<double> result;
  for(const double square : squares)
    result.push_back(h * std::sqrt(square / area));
  return result;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void
Fit_residual::subtract(const Spline_space_3& space, const Sparse_matrix& mass,
                       const Eigen::MatrixXd& coefficients) {
  const double h = space.octree().cell_width(space.depth());
  const Eigen::VectorXd diagonal = mass.diagonal();
  for(Eigen::Index k = 0; k < coefficients.cols(); ++k) {
    const auto eta = coefficients.col(k);
    const Eigen::VectorXd residual = loads.col(k) - mass.selfadjointView<Eigen::Upper>() * eta;
    // the terms of the products are that large, even if they cancel
    const double largest = (std::max)(squares[k], diagonal.dot(eta.cwiseAbs2()) / (h * h));
    squares[k] = (std::max)(squares[k] - eta.dot(loads.col(k) + residual) / (h * h), 0.);
    loads.col(k) = residual;
    are_accurate = are_accurate && !(squares[k] < smallest_accurate_square * largest);
  }
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Fit_residual fit_residual(const Spline_space_3& space,
                                                             const Surface_function_view& f) {
  const int number = f.components(), depth = space.depth();
  const double h = space.octree().cell_width(depth);
  const Eigen::Index sheets = static_cast<Eigen::Index>(space.number_of_sheets(depth));
  // a column for each sheet
  Eigen::MatrixXd squares(number, sheets);
  Fit_residual result;
  result.loads =
      sum_loads(space, depth, number, h * h, [&](std::size_t sheet, Cell_load::Load* loads) {
        Function_moments moments(f, "f");
        add_function(space, depth, sheet, moments);
        for(int k = 0; k < number; ++k) {
          moments[k].add_values_to(loads[k]);
          squares(k, static_cast<Eigen::Index>(sheet)) = moments.square(k);
        }
      });
  result.squares = squares.rowwise().sum();
  return result;
}

/// The square roots of the means of `number` functions on the surface, whose weights sum to `area`.
/// \param add_sheet adds their integrals over a sheet to as many numbers, in units of the squared
/// cell width; sheets are visited on several threads, and added in their order
inline std::vector<double>
root_means(const Spline_space_3& space, double area, int number,
           Function_view<void(std::size_t, Eigen::Ref<Eigen::VectorXd>)> add_sheet) {
  constexpr std::size_t grain = 256;
  const double h = space.octree().cell_width(space.depth());
  const std::size_t sheets = space.number_of_sheets(space.depth());
  // a column for each sheet
  Eigen::MatrixXd integrals = Eigen::MatrixXd::Zero(number, static_cast<Eigen::Index>(sheets));
  parallel_for(space.options().is_parallel, 0, sheets, grain,
               [&](std::size_t begin, std::size_t end) {
                 for(std::size_t sheet = begin; sheet < end; ++sheet)
                   add_sheet(sheet, integrals.col(static_cast<Eigen::Index>(sheet)));
               });
  std::vector<double> result;
  for(int k = 0; k < number; ++k)
    result.push_back(h * std::sqrt(integrals.row(k).sum() / area));
  return result;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE std::vector<double>
fit_errors(const Spline_space_3& space, const Surface_function_view& f,
           const Eigen::MatrixXd& coefficients) {
  constexpr int degree_of_rule = 8;
  constexpr std::size_t capacity = Integration_node_block::capacity;
  const int number = f.components();
  return root_means(space, weighted_area(space), number,
                    [&](std::size_t sheet, Eigen::Ref<Eigen::VectorXd> squares) {
                      Block_evaluation<capacity> u(space, sheet, coefficients);
                      std::vector<double> values(number * capacity);
                      space.integration_with_material().visit_nodes(
                          sheet, degree_of_rule, [&](Integration_node_block& block) {
                            f(block.points.data(), block.size, values.data());
                            u.set_points(block.positions);
                            for(int k = 0; k < number; ++k) {
                              const Node_values of_u = u.values(k);
                              for(std::size_t i = 0; i < block.size; ++i) {
                                const double difference = values[number * i + k] - of_u[i];
                                squares[k] += block.weights[i] * difference * difference;
                              }
                            }
                          });
                    });
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE std::vector<double>
gradient_residuals(const Spline_space_3& space, const Vector_field_view& v,
                   const Eigen::MatrixXd& coefficients) {
  constexpr int degree_of_rule = 2;
  constexpr std::size_t capacity = Integration_node_block::capacity;
  const int number = v.channels();
  const double h = space.octree().cell_width(space.depth());
  return root_means(space, space.surface().area(), number,
                    [&](std::size_t sheet, Eigen::Ref<Eigen::VectorXd> squares) {
                      Block_evaluation<capacity> u(space, sheet, coefficients);
                      std::vector<double> values(v.components() * capacity);
                      space.integration_with_material().visit_nodes(
                          sheet, degree_of_rule, [&](Integration_node_block& block) {
                            v(block.points.data(), block.size, values.data());
                            u.set_points_and_slopes(block.positions);
                            for(int k = 0; k < number; ++k) {
                              const Node_values x = u.derivatives(k, 0), y = u.derivatives(k, 1),
                                                z = u.derivatives(k, 2);
                              for(std::size_t i = 0; i < block.size; ++i) {
                                const double* const w = values.data() + v.components() * i + 3 * k;
                                const double dx = x[i] / h - w[0], dy = y[i] / h - w[1],
                                             dz = z[i] / h - w[2];
                                const auto [fx, fy, fz] = product(block.metrics[i], dx, dy, dz);
                                squares[k] += block.weights[i] * (dx * fx + dy * fy + dz * fz);
                              }
                            }
                          });
                    });
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_SHARED_FIT_RESIDUAL_IMPL_H
