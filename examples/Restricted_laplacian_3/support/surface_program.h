// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_EXAMPLES_SURFACE_PROGRAM_H
#define RESTRICTED_LAPLACIAN_3_EXAMPLES_SURFACE_PROGRAM_H

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
#include <cstddef>
#include <functional>
#include <iostream>
#include <memory>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace examples {

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

  // Makes the space that the options ask for. `meaning` is what the number of connected components,
  // if it is not 1, means for the result.
  RL::Spline_space_3 make_space(const std::string& meaning) {
    progress.show("building the spline space");
    const double start = seconds();
    RL::Spline_space_3 space = examples::make_space(surface, m_options);
    m_space_seconds = seconds() - start;
    add_space(summary, space, meaning);
    return space;
  }

  // `text`, which ends with a preposition, and the number of unknowns, while a callback is called
  std::function<bool(double)> step(const std::string& text, const RL::Spline_space_3& space) const {
    return progress.step(text + ' ' + std::to_string(space.dimension()) + " unknowns");
  }

  // Adds times and iterations of a solver to the summary. The space counts as setup.
  template <typename Report> void add_solve(const Report& report) {
    summary.add_detail("setup_seconds", m_space_seconds + report.setup_seconds);
    summary.add_detail("assembly_seconds", report.assembly_seconds);
    summary.add_detail("solve_seconds", report.solve_seconds);
    summary.add_detail("iterations", report.iterations);
    summary.add_detail("relative_residual", report.relative_residual);
    if(report.converged)
      return;
    std::ostringstream text;
    text << "the iteration " << to_string(report.status) << ", with a relative residual of "
         << report.relative_residual << " after " << report.iterations << " iterations";
    fail(text.str());
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
  std::string m_failure;
};

inline void write_results(const Common_options& o, const Summary& summary,
                          const RL::Triangulated_surface_3& surface, const Outcome& outcome) {
  if(!o.csv.empty() && outcome.write_table)
    outcome.write_table(o.csv, summary);
  else if(!o.csv.empty())
    write_csv(o.csv, summary, "vertex", outcome.names, outcome.values);
  if(o.refine > 0 && outcome.values_at) {
    const Refined_surface refined = refine(surface, outcome.cell_width / o.refine);
    const Eigen::MatrixXd values = values_at_vertices(refined, outcome.values_at);
    write_mesh(o.output, refined.surface, outcome.paint(values), outcome.names, values);
  } else if(!o.output.empty())
    write_mesh(o.output, surface, outcome.paint(outcome.values), outcome.names, outcome.values);
  if(outcome.write_more)
    outcome.write_more();
}

// Reads the surface, lets `work` find what is asked for, and writes it. Returns the exit status.
template <typename Options>
int run_on_surface(const std::string& program, const Options& o, const po::variables_map& given,
                   Outcome (*work)(Job&, const Options&)) {
  const Progress progress(o.quiet, o.verbose || o.progress);
  const Thread_limit threads(o.threads);
  progress.show("reading " + o.mesh);
  const Mesh_input input = [&] {
    if constexpr(std::is_base_of_v<Point_options, Options>)
      return read_mesh_or_points(o, o, given);
    else
      return read_mesh(o.mesh);
  }();
  require(o.refine == 0 || !input.surface.is_point_set(), "--refine needs a mesh, not points");
  require(o.assembly == "cubature" || !input.surface.is_point_set(),
          "--assembly " + o.assembly + " needs a mesh with triangles, not points");
  Summary summary(input);
  summary.add_detail("threads", threads.number());
  Job job(o, input.surface, summary, progress);
  const Outcome outcome = work(job, o);
  summary.add("seconds", job.seconds());

  progress.show("writing the results");
  write_results(o, summary, input.surface, outcome);
  progress.show("");
  if(!o.quiet) {
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

} // namespace examples

#endif // RESTRICTED_LAPLACIAN_3_EXAMPLES_SURFACE_PROGRAM_H
