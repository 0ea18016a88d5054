// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_PROGRAMS_SURFACE_PROGRAM_H
#define RESTRICTED_LAPLACIAN_3_PROGRAMS_SURFACE_PROGRAM_H

// What happens around the work of a program on a surface: the command line and the surface are read
// before it, results are written and printed after it.

#include "color_map.h"
#include "command_line.h"
#include "mesh_input.h"
#include "mesh_output.h"
#include "point_input.h"
#include "program.h"
#include "refined_surface.h"
#include "space.h"
#include "table.h"
#include "viewer_page.h"

#include <CGAL/Restricted_laplacian_3/problems/shared/search_depth.h>
#include <CGAL/Restricted_laplacian_3/problems/shared/values_over_surface.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_functions_3.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>
#include <CGAL/Restricted_laplacian_3/surface/Surface_location.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>

#include <CGAL/Real_timer.h>

#include <Eigen/Core>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/info.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <iostream>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace programs {

// Bounds the number of threads as long as it exists; 0 stands for all processors.
class Thread_limit {
public:
#ifdef CGAL_LINKED_WITH_TBB
  explicit Thread_limit(int number)
    : m_number(number > 0 ? number : (std::max)(1, tbb::info::default_concurrency())),
      m_control(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(m_number)) {}
#else
  explicit Thread_limit(int) : m_number(1) {}
#endif

  int number() const { return m_number; }

private:
  int m_number;
#ifdef CGAL_LINKED_WITH_TBB
  tbb::global_control m_control;
#endif
};

// What --html shows, if it is more than what --output writes.
struct Page_contents {
  // at the vertices: a column for each name; those of `Outcome` if there is none
  std::vector<std::string> names;
  Eigen::MatrixXd values;
  // such values anywhere on the surface, for --refine
  Values_at values_at;
  // for each column, the values that have the first and the last color, if these are not the
  // smallest and the largest value; may be shorter
  std::vector<std::optional<std::pair<double, double>>> ranges;
  // for each column, where the vertices are while it is shown; or none
  std::vector<std::vector<RL::Point_3>> points;
  // the column that is shown first, and about how many isolines
  std::size_t first = 0;
  int isolines = 0;
  // colors at the vertices, to be shown before all columns
  std::vector<Color> colors;
  // lines on the surface
  std::vector<std::vector<RL::Point_3>> lines;
};

// What a program found.
struct Outcome {
  // at the vertices: a column for each name
  std::vector<std::string> names;
  Eigen::MatrixXd values;
  // the colors that show such values
  std::function<std::vector<Color>(const Eigen::MatrixXd& values)> paint;
  // such values anywhere on the surface, and the width of the cells, for --refine
  Values_at values_at;
  double cell_width = 0;
  Page_contents page;
  // in place of the surface, in --output and --html, if its vertices have moved
  std::shared_ptr<const RL::Triangulated_surface_3> moved_surface;
  // writes a table of something else; by default it is that of the values
  std::function<void(const std::string& file, const Summary& summary)> write_table;
  // writes more files
  std::function<void()> write_more;
  // prints more than the summary
  std::function<void(std::ostream&)> print;

  // takes values at locations from splines on a space
  void set_splines(const RL::Spline_space_3& space, Eigen::MatrixXd coefficients) {
    cell_width = space.octree().cell_width(space.depth());
    values_at = [splines = RL::Spline_functions_3(space, std::move(coefficients))](
                    const std::vector<RL::Surface_location>& locations) {
      return splines.values_at_locations(locations);
    };
  }
};

// one value at each vertex
inline Outcome outcome(const std::vector<double>& values) {
  Outcome result;
  result.names = {"value"};
  result.values =
      Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
  result.paint = [](const Eigen::MatrixXd& u) { return value_colors(u.col(0)); };
  return result;
}

// What a program works on, and where it says what it does and finds.
class Job {
public:
  Job(const Common_options& o, const RL::Triangulated_surface_3& surface, Summary& summary,
      const Progress& progress)
    : surface(surface), summary(summary), progress(progress), m_options(o) {
    m_timer.start();
  }

  // Makes the space that the options ask for, or the first one of a search, which replaces it.
  // `meaning` is what the number of connected components, if it is not 1, means for the result.
  RL::Spline_space_3 make_space(const std::string& meaning) {
    progress.show("building the spline space");
    const double start = seconds();
    RL::Spline_space_3 space = programs::make_space(surface, m_options);
    m_space_seconds = seconds() - start;
    m_meaning = meaning;
    if(!accuracy())
      add_space(summary, space, meaning);
    return space;
  }

  // Solves in a space, or, with an accuracy, in deeper and deeper ones.
  // \param solve does that in `space`, and shows its progress
  void search_depth(RL::Spline_space_3& space,
                    const std::function<RL::internal::Found_in_space()>& solve) {
    if(!accuracy()) {
      solve();
      return;
    }
    const RL::Solve_report* report = nullptr;
    RL::internal::search_depth(space, *accuracy(), {}, {}, [&](const auto&) {
      const RL::internal::Found_in_space found = solve();
      report = found.report;
      return found;
    });
    add_space_of_search(space, *report);
  }

  // Adds the last space of a search to the summary.
  void add_space_of_search(const RL::Spline_space_3& space, const RL::Solve_report& report) {
    m_space_seconds += report.space_seconds;
    add_space(summary, space, m_meaning);
  }

  // `text`, which ends with a preposition, and the number of unknowns, while a callback is called
  std::function<bool(double)> step(const std::string& text, const RL::Spline_space_3& space) const {
    return progress.step(text + ' ' + std::to_string(space.dimension()) +
                         (accuracy() ? " unknowns or more" : " unknowns"));
  }

  // that is searched for, if there is one
  std::optional<double> accuracy() const { return m_options.space.accuracy; }

  // Adds times and iterations of a solver to the summary. The space counts as setup.
  template <typename Report> void add_solve(const Report& report) {
    summary.add_detail("setup_seconds", m_space_seconds + report.setup_seconds);
    summary.add_detail("assembly_seconds", report.assembly_seconds);
    summary.add_detail("solve_seconds", report.solve_seconds);
    summary.add_detail("iterations", report.iterations);
    summary.add_detail("relative_residual", report.relative_residual);
    add_estimate(report);
    if(!report.converged)
      fail(report);
  }

  // says how a solver failed
  void fail(const RL::Solve_report& report) {
    std::ostringstream text;
    text << "the iteration " << to_string(report.status) << ", with ";
    if(report.status == RL::Solve_status::inaccurate && std::isnan(report.estimated_error))
      text << "an error that cannot be estimated: no two depths can be compared";
    else if(report.status == RL::Solve_status::inaccurate)
      text << "an estimated error of " << report.estimated_error;
    else
      text << "a relative residual of " << report.relative_residual << " after "
           << report.iterations << " iterations";
    fail(text.str());
  }

  // how large the error of the finite elements is, if that is known
  template <typename Report> void add_estimate(const Report& report) {
    if(!std::isnan(report.estimated_error))
      summary.add_explained("estimated_relative_error", report.estimated_error,
                            report.is_estimate_trusted
                                ? ""
                                : "  (not to be relied on: cells may not resolve the surface)");
  }

  // says in what the solver failed
  void fail(const std::string& what) { m_failure = what; }

  // since the surface was read
  double seconds() const { return m_timer.time(); }
  double space_seconds() const { return m_space_seconds; }
  // empty if the solver did not fail
  const std::string& failure() const { return m_failure; }

  const RL::Triangulated_surface_3& surface;
  Summary& summary;
  const Progress& progress;

private:
  const Common_options& m_options;
  CGAL::Real_timer m_timer;
  double m_space_seconds = 0;
  std::string m_meaning, m_failure;
};

// Writes the page of --html. `refined` is the surface to show in place of the other, if there is
// one.
inline void write_html(const std::string& program, const Common_options& o,
                       const RL::Triangulated_surface_3& surface, const Outcome& outcome,
                       const Refined_surface* refined) {
  const Page_contents& contents = outcome.page;
  const bool is_own = !contents.names.empty();
  const std::vector<std::string>& names = is_own ? contents.names : outcome.names;
  const Eigen::MatrixXd values =
      refined  ? values_at_vertices(*refined, is_own ? contents.values_at : outcome.values_at)
      : is_own ? contents.values
               : outcome.values;
  Viewer_page page;
  const std::string mesh = std::filesystem::path(o.mesh).filename().string();
  page.title = program + ' ' + mesh;
  page.first_field = contents.first;
  page.isolines = contents.isolines;
  Viewer_surface shown(mesh, refined ? refined->surface : surface);
  if(!contents.colors.empty() && !refined) {
    shown.fields.push_back({"color", {}, true, {}});
    for(const Color& color : contents.colors)
      shown.fields.back().values.insert(shown.fields.back().values.end(), color.begin(),
                                        color.end());
  }
  for(std::size_t k = 0; k < names.size(); ++k) {
    const auto column = values.col(static_cast<Eigen::Index>(k));
    shown.fields.push_back({names[k], {column.begin(), column.end()}, false, {}});
    if(k < contents.ranges.size())
      shown.fields.back().range = contents.ranges[k];
    if(k < contents.points.size())
      shown.fields.back().points = contents.points[k];
  }
  shown.lines = contents.lines;
  page.surfaces.push_back(std::move(shown));
  const std::string viewer = read_viewer(viewer_file());
  write_file(o.html, [&](std::ostream& out) { write_viewer_page(out, viewer, page); });
}

inline void write_results(const std::string& program, const Common_options& o,
                          const Summary& summary, const RL::Triangulated_surface_3& first_surface,
                          const Outcome& outcome) {
  const RL::Triangulated_surface_3& surface =
      outcome.moved_surface ? *outcome.moved_surface : first_surface;
  if(!o.csv.empty() && outcome.write_table)
    outcome.write_table(o.csv, summary);
  else if(!o.csv.empty())
    write_csv(o.csv, summary, "vertex", outcome.names, outcome.values);
  std::optional<Refined_surface> refined;
  if(o.refine > 0 && outcome.values_at)
    refined = refine(surface, outcome.cell_width / o.refine);
  if(!o.output.empty() && refined) {
    const Eigen::MatrixXd values = values_at_vertices(*refined, outcome.values_at);
    write_mesh(o.output, refined->surface, outcome.paint(values), outcome.names, values);
  } else if(!o.output.empty())
    write_mesh(o.output, surface, outcome.paint(outcome.values), outcome.names, outcome.values);
  if(!o.html.empty())
    write_html(program, o, surface, outcome, refined ? &*refined : nullptr);
  if(outcome.write_more)
    outcome.write_more();
}

// Reads the surface, lets `work` find what is asked for, and writes it. Returns the exit status.
template <typename Options>
int run_on_surface(const std::string& program, const Options& o, const po::variables_map& given,
                   Outcome (*work)(Job&, const Options&)) {
  const Progress progress(this_run().is_quiet, o.verbose || o.progress);
  const Thread_limit threads(o.threads);
  Mesh_input input = [&] {
    const Callback callback = progress.step("reading " + o.mesh);
    if constexpr(std::is_base_of_v<Point_options, Options>)
      return read_mesh_or_points(o, o, given, callback);
    else
      return read_mesh(o.mesh, callback);
  }();
  require(o.refine == 0 || !input.surface.is_point_set(), "--refine needs a mesh, not points");
  require(o.assembly == "cubature" || !input.surface.is_point_set(),
          "--assembly " + o.assembly + " needs a mesh with triangles, not points");
  input.surface = with_geometry(std::move(input.surface), o.space);
  Summary summary(input);
  summary.add_detail("threads", threads.number());
  Job job(o, input.surface, summary, progress);
  const Outcome outcome = work(job, o);
  summary.add("seconds", job.seconds());

  progress.show("writing the results");
  write_results(program, o, summary, input.surface, outcome);
  progress.show("");
  if(!this_run().is_quiet) {
    summary.print(std::cout, o.verbose);
    if(outcome.print)
      outcome.print(std::cout);
  }
  if(!job.failure().empty()) {
    print_error(program, "the solver did not converge: " + job.failure());
    return not_converged;
  }
  return success;
}

// A whole program on a surface: the body of its main().
// \param read_options reads the command line; returns false if there is nothing more to do
// \param work finds what the options ask for
template <typename Options>
int run_surface_program(const std::string& program, int argc, char* argv[],
                        bool (*read_options)(int, char*[], Options&, po::variables_map&),
                        Outcome (*work)(Job&, const Options&)) {
  return run_program(program, [&]() -> int {
    Options o;
    po::variables_map given;
    return read_options(argc, argv, o, given) ? run_on_surface(program, o, given, work)
                                              : static_cast<int>(success);
  });
}

} // namespace programs

#endif // RESTRICTED_LAPLACIAN_3_PROGRAMS_SURFACE_PROGRAM_H
