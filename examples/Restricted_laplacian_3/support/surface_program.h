// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_EXAMPLES_SURFACE_PROGRAM_H
#define RESTRICTED_LAPLACIAN_3_EXAMPLES_SURFACE_PROGRAM_H

// What happens around the work of a program on a surface: its input is read before, its results are
// written and printed after it.

#include "color_map.h"
#include "command_line.h"
#include "mesh_input.h"
#include "mesh_output.h"
#include "program.h"
#include "refined_surface.h"
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
#include <string>
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
  // prints more than the summary
  std::function<void(std::ostream&)> print;
  // in what the solver failed; empty if it did not
  std::string failure;

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
}

// Runs `read()`, which returns a `Mesh_input`, and `work(surface, summary, progress)`, which
// returns an `Outcome`. Returns the exit status of the program.
template <typename Read, typename Work>
int run_on_surface(const std::string& program, const Common_options& o, Read read, Work work) {
  const Progress progress(o.quiet, o.verbose || o.progress);
  const Thread_limit threads(o.threads);
  progress.show("reading " + o.mesh);
  const Mesh_input input = read();
  require(o.refine == 0 || !input.surface.is_point_set(), "--refine needs a mesh, not points");
  require(o.assembly == "cubature" || !input.surface.is_point_set(),
          "--assembly " + o.assembly + " needs a mesh with triangles, not points");
  Summary summary(input);
  summary.add_detail("threads", threads.number());
  CGAL::Real_timer timer;
  timer.start();
  const Outcome outcome = work(input.surface, summary, progress);
  summary.add("seconds", timer.time());

  progress.show("writing the results");
  write_results(o, summary, input.surface, outcome);
  progress.show("");
  if(!o.quiet) {
    summary.print(std::cout, o.verbose);
    if(outcome.print)
      outcome.print(std::cout);
  }
  if(!outcome.failure.empty()) {
    print_error(program, "the solver did not converge" + outcome.failure);
    return not_converged;
  }
  return success;
}

} // namespace examples

#endif // RESTRICTED_LAPLACIAN_3_EXAMPLES_SURFACE_PROGRAM_H
