// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_INTERNAL_FIT_RESIDUAL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_INTERNAL_FIT_RESIDUAL_H

#include <CGAL/Restricted_laplacian_3/assembly/assemble.h>
#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/integration/internal/Cell_load.h>
#include <CGAL/Restricted_laplacian_3/splines/B_spline_1.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>
#include <CGAL/Restricted_laplacian_3/splines/internal/spline_evaluation.h>
#include <CGAL/Restricted_laplacian_3/surface/internal/function_components.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// What a function \f$f\f$ and a spline function \f$u\f$ differ by, for each component \f$k\f$.
struct Fit_residual {
  /// \f$\int (f_k - u_k)\, b_i\f$: a row for each element, a column for each component
  Eigen::MatrixXd loads;
  /// \f$\int (f_k - u_k)^2\f$, in units of the squared cell width
  Eigen::VectorXd squares;
  /// \f$\int \lvert \nabla_{\mathcal M} u_k \rvert^2\f$
  Eigen::VectorXd gradient_squares;
};

/// The 27 elements of a sheet with their coefficients.
template <int K> class Sheet_functions {
public:
  using Values = Eigen::Matrix<double, K, 1>;
  using Gradients = Eigen::Matrix<double, K, 3>;

  /// \param coefficients without columns they are 0
  Sheet_functions(const Spline_space_3& space, std::size_t sheet,
                  const Eigen::MatrixXd& coefficients) {
    const Cell_elements& elements = space.elements(space.depth(), sheet);
    m_coefficients.setZero();
    for(int i = 0; i < 27 && coefficients.cols() > 0; ++i)
      if(elements[i] != Spline_space_3::no_element)
        m_coefficients.col(i) = coefficients.row(elements[i]).transpose();
  }

  /// \param t local coordinate in the cell
  Values values(const std::array<double, 3>& t) const {
    return m_coefficients.lazyProduct(vector(element_values(t)));
  }

  /// \f$\nabla u_k\f$ times the cell width, a row for each component
  Gradients gradients(const std::array<double, 3>& t) const {
    Eigen::Matrix<double, 27, 3> derivatives;
    for(int axis = 0; axis < 3; ++axis)
      derivatives.col(axis) = vector(element_derivatives(t, axis));
    return m_coefficients.lazyProduct(derivatives);
  }

private:
  static Eigen::Map<const Eigen::Matrix<double, 27, 1>>
  vector(const std::array<double, 27>& values) {
    return Eigen::Map<const Eigen::Matrix<double, 27, 1>>(values.data());
  }

  Eigen::Matrix<double, K, 27> m_coefficients;
};

/// \param f as in `assemble_component_loads()`
/// \param coefficients of \f$u\f$ on the finest level; without columns, \f$u = 0\f$
/// \param with_gradients whether `gradient_squares` are computed; else they are 0
/// \throws Parameter_error if a value of `f` is not finite; names the face
template <class Function, class SurfaceIntegration>
Fit_residual fit_residual(const Spline_space_3& space, const SurfaceIntegration& integration,
                          const Function& f, const Eigen::MatrixXd& coefficients,
                          bool with_gradients) {
  constexpr int number = Components_of<Function>::number;
  using Squares = Eigen::Matrix<double, number, 1>;
  const int depth = space.depth();
  const double h = space.octree().cell_width(depth);
  const bool is_zero = coefficients.cols() == 0;
  // a function alone is integrated against elements, its difference to a spline is also squared
  const int degree = is_zero ? 6 + degree_on_triangles(f) : 12;
  std::vector<std::array<Squares, 2>> of_sheets(space.number_of_sheets(depth),
                                                {Squares::Zero(), Squares::Zero()});
  Fit_residual result;
  result.loads = sum_loads<number>(space, depth, h * h, [&](std::size_t sheet) {
    const Sheet_functions<number> u(space, sheet, coefficients);
    std::array<Cell_load, number> moments;
    Squares &squares = of_sheets[sheet][0], &gradient_squares = of_sheets[sheet][1];
    for_each_node_of_level(
        space, depth, sheet, integration, degree,
        [&](const std::array<double, 3>& t, const Surface_point& p, double weight) {
          Squares difference = components_at(f, p);
          if(!difference.allFinite())
            throw Parameter_error("f", "has a value that is not a finite number in face " +
                                           std::to_string(p.face));
          if(!is_zero)
            difference -= u.values(t);
          squares += weight * difference.cwiseAbs2();
          for(int k = 0; k < number; ++k)
            moments[k].add(t, weight * difference[k]);
          if(!with_gradients)
            return;
          const auto gradients = u.gradients(t);
          const Eigen::Vector3d normal(p.normal.x(), p.normal.y(), p.normal.z());
          gradient_squares +=
              weight * (gradients.rowwise().squaredNorm() - (gradients * normal).cwiseAbs2());
        });
    std::array<Cell_load::Load, number> loads = {};
    for(int k = 0; k < number; ++k)
      moments[k].add_values_to(loads[k]);
    return loads;
  });
  result.squares = result.gradient_squares = Eigen::VectorXd::Zero(number);
  for(const auto& [squares, gradient_squares] : of_sheets) {
    result.squares += squares;
    result.gradient_squares += gradient_squares;
  }
  return result;
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_ASSEMBLY_INTERNAL_FIT_RESIDUAL_H
