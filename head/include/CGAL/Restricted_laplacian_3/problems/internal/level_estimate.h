// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_INTERNAL_LEVEL_ESTIMATE_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_INTERNAL_LEVEL_ESTIMATE_H

// Errors that are estimated from what changes from level to level.

#include <CGAL/Restricted_laplacian_3/problems/shared/values_over_surface.h>
#include <CGAL/Restricted_laplacian_3/solvers/Solve_report.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

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
  constexpr Eigen::Index columns_of_a_block = 8; // of functions that are evaluated at once
  report.estimated_error = std::numeric_limits<double>::quiet_NaN();
  report.is_estimate_trusted = false;
  if(coarser[0].rows() != x.rows() || !coarser[0].allFinite())
    return;
  double largest = 0;
  for(Eigen::Index first = 0; first < x.cols(); first += columns_of_a_block) {
    const Eigen::Index number = (std::min)(columns_of_a_block, x.cols() - first);
    const auto part = [&](const Eigen::MatrixXd& m) { return m.middleCols(first, number); };
    Eigen::MatrixXd functions(x.rows(), 3 * number);
    functions << part(x), part(x) - part(coarser[0]), part(coarser[0]) - part(coarser[1]);
    const Eigen::MatrixXd values =
        values_over_surface(space, functions,
                            (std::min)((std::max)(space.dimension(), least_number_of_places),
                                       largest_number_of_places));
    for(Eigen::Index i = 0; i < number; ++i)
      largest = (std::max)(
          largest, error_of_changes(relative_size(values.col(i), values.col(number + i)),
                                    relative_size(values.col(i), values.col(2 * number + i))));
  }
  report.estimated_error = largest;
  report.is_estimate_trusted = is_resolved(space);
}

/// The errors of solutions in spaces of one surface, each deeper than the one before, by what
/// changes from one to the next: for problems whose solver tells nothing of coarser levels.
class Space_changes {
public:
  /// the error of the worst of several solutions; NaN in the first space
  /// \param values see `values_over_surface()`: a column for each solution
  double error(const Eigen::MatrixXd& values) {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    double largest = m_values.size() > 0 ? 0 : unknown;
    m_changes.resize(static_cast<std::size_t>(values.cols()), unknown);
    for(Eigen::Index i = 0; i < values.cols() && m_values.size() > 0; ++i) {
      double& before = m_changes[static_cast<std::size_t>(i)];
      const double change = relative_size(values.col(i), values.col(i) - m_values.col(i));
      largest = (std::max)(largest, error_of_changes(change, std::exchange(before, change)));
    }
    m_values = values;
    return largest;
  }

private:
  Eigen::MatrixXd m_values; // of the solutions before
  std::vector<double> m_changes;
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_INTERNAL_LEVEL_ESTIMATE_H
