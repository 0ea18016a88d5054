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
#include "table.h"

#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>

#include <Eigen/Core>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/info.h>
#endif

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iostream>
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
  // at the vertices: a column for each name, and colors
  std::vector<std::string> names;
  Eigen::MatrixXd values;
  std::vector<Color> colors;
  // writes a table of something else; by default it is that of the values
  std::function<void(const std::string& file, const Summary& summary)> write_table;
  // prints more than the summary
  std::function<void(std::ostream&)> print;
  // in what the solver failed; empty if it did not
  std::string failure;
};

// one value at each vertex
inline Outcome outcome(const std::vector<double>& values) {
  Outcome result;
  result.names = {"value"};
  result.values =
      Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
  result.colors = value_colors(values);
  return result;
}

inline void write_results(const Common_options& o, const Summary& summary,
                          const RL::Triangulated_surface_3& surface, const Outcome& outcome) {
  if(!o.csv.empty() && outcome.write_table)
    outcome.write_table(o.csv, summary);
  else if(!o.csv.empty())
    write_csv(o.csv, summary, "vertex", outcome.names, outcome.values);
  if(!o.output.empty())
    write_mesh(o.output, surface, outcome.colors, outcome.names, outcome.values);
}

// Runs `read()`, which returns a `Mesh_input`, and `work(surface, summary, progress)`, which
// returns an `Outcome`. Returns the exit status of the program.
template <typename Read, typename Work>
int run_on_surface(const std::string& program, const Common_options& o, Read read, Work work) {
  const Progress progress(o.quiet);
  const Thread_limit threads(o.threads);
  progress.show("reading " + o.mesh);
  const Mesh_input input = read();
  Summary summary(input);
  summary.add("threads", threads.number());
  const Outcome outcome = work(input.surface, summary, progress);

  progress.show("writing the results");
  write_results(o, summary, input.surface, outcome);
  progress.show("");
  if(!o.quiet) {
    summary.print(std::cout);
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
