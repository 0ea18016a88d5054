// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_INTERNAL_DEPTH_SEARCH_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_INTERNAL_DEPTH_SEARCH_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Progress.h>
#include <CGAL/Restricted_laplacian_3/solvers/Solve_report.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>
#include <CGAL/Restricted_laplacian_3/splines/estimate_memory.h>

#include <CGAL/Real_timer.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <string>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// Makes one space after the other, each deeper than the one before, until a result has the
/// accuracy that is asked for, or the memory or the largest depth ends the search, or levels gain
/// hardly anything: as where values are prescribed at points, which change less and less of the
/// solution.
class Depth_search {
public:
  /// \param space the first one, and then that of the last result
  /// \param bytes_of_unknown what the results take, if that is more than a Poisson problem does
  /// \throws Parameter_error if the accuracy is not between 0 and 1
  Depth_search(Spline_space_3& space, double accuracy, const Progress& progress,
               double bytes_of_unknown = 0)
    : m_space(space), m_accuracy(accuracy), m_progress(progress),
      m_bytes_of_unknown(bytes_of_unknown) {
    if(!(accuracy > 0 && accuracy < 1))
      throw Parameter_error("accuracy",
                            "is " + std::to_string(accuracy) + ", but must be between 0 and 1");
  }

  /// of the work in the current space; nobody knows how many will follow
  Progress progress() const { return m_progress.part(1 - m_left, 1 - m_left / 2); }

  /// Makes the next space, if there is one.
  /// \param report of the result in the space; gets the status `inaccurate` if that is not accurate
  /// enough and there is no other space, and the times of all spaces
  /// \param most_steps how many levels deeper it may be
  bool goes_on(Solve_report& report, int most_steps = 2) {
    add_times(report);
    const bool is_accurate = report.estimated_error <= m_accuracy;
    if(is_accurate && (report.is_estimate_trusted || is_deep()))
      return false;
    const bool is_hopeless = !is_accurate && gains_nothing(report.estimated_error);
    const int depth =
        m_space.depth() + (std::min)(number_of_steps(report.estimated_error), most_steps);
    if(is_hopeless || !(fits(depth) || fits(m_space.depth() + 1))) {
      if(!is_accurate)
        report.worsen_status(Solve_status::inaccurate);
      return false;
    }
    CGAL::Real_timer timer;
    timer.start();
    Spline_space_options options = m_space.options();
    options.depth = fits(depth) ? depth : m_space.depth() + 1;
    m_space = Spline_space_3(m_space.surface(), options);
    m_times.space_seconds += timer.time();
    m_left /= 2;
    return true;
  }

private:
  /// Where cells do not resolve the surface, no estimate can be relied on; but a space that is as
  /// fine as the mesh is fine enough.
  bool is_deep() const {
    return m_space.depth() >= default_depth(m_space.surface(), *m_space.options().cube_scale);
  }

  /// The number of levels that are missing, rather too few than too many: one too few costs a
  /// third more, one too many three times as much.
  int number_of_steps(double estimate) const {
    constexpr double gain_of_a_level = 10;
    return estimate > gain_of_a_level * m_accuracy ? 2 : 1;
  }

  /// whether two levels that are not among the first have not reduced the estimate
  bool gains_nothing(double estimate) {
    constexpr int smallest_depth = 6, most_levels_without_gain = 2;
    constexpr double least_gain = 1.3;
    const bool has_gained = !(estimate * least_gain > m_estimate);
    m_estimate = estimate;
    if(has_gained || m_space.depth() < smallest_depth)
      m_levels_without_gain = 0;
    else
      ++m_levels_without_gain;
    return m_levels_without_gain >= most_levels_without_gain;
  }

  bool fits(int depth) const {
    constexpr int largest_depth = 20;
    const Spline_space_options& o = m_space.options();
    // the sums over points do not determine functions on smaller cells
    if(m_space.surface().is_point_set() && depth > default_depth(m_space.surface(), *o.cube_scale))
      return false;
    if(depth > largest_depth)
      return false;
    const Memory_estimate needed = estimate_memory(m_space.surface(), depth, *o.cube_scale);
    return (std::max)(needed.total(), needed.surface + needed.dimension * m_bytes_of_unknown) <=
           *o.maximum_memory;
  }

  void add_times(Solve_report& report) {
    m_times.assembly_seconds += report.assembly_seconds;
    m_times.setup_seconds += report.setup_seconds;
    m_times.solve_seconds += report.solve_seconds;
    report.space_seconds = m_times.space_seconds;
    report.assembly_seconds = m_times.assembly_seconds;
    report.setup_seconds = m_times.setup_seconds;
    report.solve_seconds = m_times.solve_seconds;
  }

  Spline_space_3& m_space;
  double m_accuracy;
  Progress m_progress;
  double m_bytes_of_unknown;
  double m_left = 1;
  double m_estimate = std::numeric_limits<double>::infinity(); // the last one
  int m_levels_without_gain = 0;
  Solve_report m_times;
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_INTERNAL_DEPTH_SEARCH_H
