// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_INTERNAL_LEVEL_ESTIMATE_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_INTERNAL_LEVEL_ESTIMATE_H

// Errors that are estimated from what changes from level to level.

#include <CGAL/Restricted_laplacian_3/solvers/Solve_report.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_functions_3.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>
#include <CGAL/Restricted_laplacian_3/surface/sample_surface.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// The error of the finest level if changes go on to become smaller by the same factor. The factor
/// is held within limits: on faceted surfaces errors fall fast until the facets are resolved, and
/// fourfold from then on, whatever was before.
/// \param last the change from the level before the finest one to the finest
/// \param before the change to the level before; NaN if it is not known
inline double error_of_changes(double last, double before) {
  constexpr double smallest_factor = 2, largest_factor = 4;
  const double factor =
      before > smallest_factor * last ? (std::min)(before / last, largest_factor) : smallest_factor;
  return last / (factor - 1);
}

/// Whether cells resolve the surface: only then the number of unknowns grows fourfold from a level
/// to the next. It grows less where parts of the surface that are near share cells.
inline bool is_resolved(const Spline_space_3& space) {
  constexpr double smallest_growth = 3.2, largest_growth = 4.6;
  if(space.depth() < 1 || space.is_paper_space())
    return false;
  const double growth = static_cast<double>(space.dimension()) /
                        static_cast<double>(space.dimension(space.depth() - 1));
  return growth >= smallest_growth && growth <= largest_growth;
}

constexpr std::size_t largest_number_of_places = 20000;

/// Values of functions at places that are spread over the surface by area: a row for each place, a
/// column for each function. The same places for the same surface and number.
inline Eigen::MatrixXd values_over_surface(const Spline_space_3& space,
                                           const Eigen::MatrixXd& coefficients,
                                           std::size_t number = largest_number_of_places) {
  const Spline_functions_3 functions(space, coefficients);
  if(space.surface().is_point_set())
    return functions.values_at_vertices();
  return functions.values_at_locations(
      sample_surface(space.surface(), number, 1, Sampling::stratified));
}

/// the root mean square of a part of a function, relative to that of the function without its mean
template <class Values, class Part> double relative_size(const Values& values, const Part& part) {
  // of a constant only rounding errors are left
  constexpr double smallest_deviation = 1e-9;
  const double deviation = (values.array() - values.mean()).matrix().norm(),
               size = (std::max)(deviation, smallest_deviation * values.norm());
  return size > 0 ? part.norm() / size : 0;
}

/// Sets the estimated error of solutions.
/// \param x a column for each solution
/// \param coarser the solutions of the level below the finest and of the one below that, as
/// functions of the finest level; NaN where they are not known
inline void estimate_error(const Spline_space_3& space, const Eigen::MatrixXd& x,
                           const std::array<Eigen::MatrixXd, 2>& coarser, Solve_report& report) {
  constexpr std::size_t least_number_of_places = 2000;
  const Eigen::Index number = x.cols();
  report.estimated_error = std::numeric_limits<double>::quiet_NaN();
  report.is_estimate_trusted = false;
  if(coarser[0].rows() != x.rows() || !coarser[0].allFinite())
    return;
  Eigen::MatrixXd functions(x.rows(), 3 * number);
  functions << x, x - coarser[0], coarser[0] - coarser[1];
  const Eigen::MatrixXd values = values_over_surface(
      space, functions,
      (std::min)((std::max)(space.dimension(), least_number_of_places), largest_number_of_places));
  double largest = 0;
  for(Eigen::Index i = 0; i < number; ++i)
    largest = (std::max)(
        largest, error_of_changes(relative_size(values.col(i), values.col(number + i)),
                                  relative_size(values.col(i), values.col(2 * number + i))));
  report.estimated_error = largest;
  report.is_estimate_trusted = is_resolved(space);
}

/// The errors of solutions in spaces of one surface, each a level deeper than the one before, by
/// what changes from one to the next: for problems whose solver tells nothing of coarser levels.
class Space_changes {
public:
  /// sets the estimated error of a solution
  void estimate_error(const Spline_space_3& space, const Eigen::VectorXd& coefficients,
                      Solve_report& report) {
    const Eigen::MatrixXd values = values_over_surface(space, coefficients);
    report.is_estimate_trusted = is_resolved(space);
    if(m_values.size() > 0) {
      const double change = relative_size(values, values - m_values);
      report.estimated_error = error_of_changes(change, m_change);
      m_change = change;
    }
    m_values = values;
  }

private:
  Eigen::MatrixXd m_values; // of the solution before
  double m_change = std::numeric_limits<double>::quiet_NaN();
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_INTERNAL_LEVEL_ESTIMATE_H
