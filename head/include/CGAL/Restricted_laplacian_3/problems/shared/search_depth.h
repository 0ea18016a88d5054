// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_SHARED_SEARCH_DEPTH_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_SHARED_SEARCH_DEPTH_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/Progress.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>
#include <CGAL/Restricted_laplacian_3/solvers/Solve_report.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>

#include <Eigen/Core>

#include <cstddef>
#include <functional>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// a space with another way to integrate
using Integrated_space = std::function<Spline_space_3(const Spline_space_3&)>;

/// What was found in the space of a search.
struct Found_in_space {
  /// gets an estimate of the error, times of all spaces, and the status `inaccurate`
  Solve_report* report;
  /// What is compared with the spaces before, by `values_over_surface()`: a column for each
  /// function. Empty if the estimate that the report has needs no comparison.
  Eigen::MatrixXd values;
};

struct Depth_search_options {
  /// how many levels deeper the next space may be
  int most_steps = 2;
  /// what results take, if that is more than a Poisson problem does
  double bytes_of_unknown = 0;
  /// of the first space; with fewer there is nothing to be solved
  std::size_t least_dimension = 0;
};

/// Solves in one space after the other, each deeper than the one before, until the result has the
/// accuracy that is asked for, or the memory or the largest depth ends the search, or can be seen
/// to end it before: as where values are prescribed at points, which change less and less of the
/// solution.
/// \param space the first one, and then that of the last result
/// \param solve in `space`, which tells its progress
/// \throws Parameter_error if the accuracy is not between 0 and 1
void search_depth(Spline_space_3& space, double accuracy, const Progress& progress,
                  const Depth_search_options& options,
                  const std::function<Found_in_space(const Progress&)>& solve);

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/problems/shared/search_depth_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_SHARED_SEARCH_DEPTH_H
