// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_SHARED_SEARCH_DEPTH_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_SHARED_SEARCH_DEPTH_IMPL_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/problems/internal/level_estimate.h>
#include <CGAL/Restricted_laplacian_3/problems/shared/search_depth.h>
#include <CGAL/Restricted_laplacian_3/splines/estimate_memory.h>

#include <CGAL/Real_timer.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

class Depth_search {
public:
  Depth_search(Spline_space_3& space, double accuracy, const Depth_search_options& options)
    : m_space(space), m_accuracy(accuracy), m_options(options) {
    if(!(accuracy > 0 && accuracy < 1))
      throw Parameter_error("accuracy",
                            "is " + std::to_string(accuracy) + ", but must be between 0 and 1");
    while(space.dimension() < options.least_dimension && fits(space.depth() + 1))
      go_to(space.depth() + 1);
  }

  /// makes the next space, if there is one
  bool goes_on(const Found_in_space& found) {
    Solve_report& report = *found.report;
    if(found.values.size() > 0) {
      // both of these are estimates, and neither is smaller than the error by much
      report.estimated_error = std::fmin(report.estimated_error, m_changes.error(found.values));
      report.is_estimate_trusted = is_resolved(m_space);
    }
    add_times(report);
    const double estimate = report.estimated_error;
    const bool is_accurate = estimate <= m_accuracy;
    if(is_accurate && (report.is_estimate_trusted || is_deep()))
      return false;
    const bool is_hopeless = !is_accurate && cannot_be_reached(estimate);
    const int depth = m_space.depth() + (std::min)(number_of_steps(estimate), m_options.most_steps);
    if(is_hopeless || !(fits(depth) || fits(m_space.depth() + 1))) {
      if(!is_accurate)
        report.worsen_status(Solve_status::inaccurate);
      return false;
    }
    m_estimate = estimate;
    m_depth_of_estimate = m_space.depth();
    go_to(fits(depth) ? depth : m_space.depth() + 1);
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

  /// Whether the last two estimates, which are not among the first ones, say that what is missing
  /// takes more levels than there can be.
  bool cannot_be_reached(double estimate) {
    constexpr int smallest_depth = 6, most_hopeless_spaces = 2;
    const double gain = std::log(m_estimate / estimate) / (m_space.depth() - m_depth_of_estimate);
    const double missing_levels = std::log(estimate / m_accuracy) / (std::max)(gain, 1e-3);
    const bool is_hopeless = m_space.depth() >= smallest_depth && std::isfinite(missing_levels) &&
                             !fits(m_space.depth() + std::ceil(missing_levels));
    m_hopeless_spaces = is_hopeless ? m_hopeless_spaces + 1 : 0;
    return m_hopeless_spaces >= most_hopeless_spaces;
  }

  bool fits(double given) const {
    constexpr int largest_depth = 20;
    const Spline_space_options& o = m_space.options();
    if(given > largest_depth)
      return false;
    const int depth = static_cast<int>(given);
    // the sums over points do not determine functions on smaller cells
    if(m_space.surface().is_point_set() && depth > default_depth(m_space.surface(), *o.cube_scale))
      return false;
    const Memory_estimate needed = estimate_memory(m_space.surface(), depth, *o.cube_scale);
    return (std::max)(needed.total(),
                      needed.surface + needed.dimension * m_options.bytes_of_unknown) <=
           *o.maximum_memory;
  }

  void go_to(int depth) {
    CGAL::Real_timer timer;
    timer.start();
    Spline_space_options options = m_space.options();
    options.depth = depth;
    m_space = Spline_space_3(m_space.surface(), options);
    m_times.space_seconds += timer.time();
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
  Depth_search_options m_options;
  double m_estimate = std::numeric_limits<double>::quiet_NaN(); // of the space before
  int m_depth_of_estimate = 0;
  int m_hopeless_spaces = 0;
  Space_changes m_changes;
  Solve_report m_times;
};

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void
search_depth(Spline_space_3& space, double accuracy, const Progress& progress,
             const Depth_search_options& options,
             const std::function<Found_in_space(const Progress&)>& solve) {
  Depth_search search(space, accuracy, options);
  double begin = 0, end = 0; // nobody knows how many spaces will follow
  do {
    begin = end;
    end = (1 + begin) / 2;
  } while(search.goes_on(solve(progress.part(begin, end))));
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_SHARED_SEARCH_DEPTH_IMPL_H
