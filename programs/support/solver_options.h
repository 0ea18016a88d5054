// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_PROGRAMS_SOLVER_OPTIONS_H
#define RESTRICTED_LAPLACIAN_3_PROGRAMS_SOLVER_OPTIONS_H

// The options of linear solvers.

#include "command_line.h"
#include "program.h"
#include "table.h"

#include <CGAL/Restricted_laplacian_3/foundation/internal/parameters.h>
#include <CGAL/Restricted_laplacian_3/solvers/Solve_report.h>

#include <optional>
#include <sstream>
#include <string>

namespace programs {

struct Solver_options {
  // without an energy tolerance for solvers that have none
  explicit Solver_options(double tolerance, bool has_energy_tolerance = true)
    : tolerance(tolerance), has_energy_tolerance(has_energy_tolerance) {}

  double tolerance;
  bool has_energy_tolerance;
  double energy_tolerance = -1, stabilization = -1; // the default
};

// `default_stabilization` is what the text of --help says about it.
inline po::options_description solver_options(Solver_options& o,
                                              const std::string& default_stabilization) {
  po::options_description solver("Solver", help_width);
  auto add = solver.add_options();
  std::ostringstream tolerance; // with no more digits than it needs
  tolerance << o.tolerance;
  add("tolerance",
      po::value(&o.tolerance)->value_name("T")->default_value(o.tolerance, tolerance.str()),
      "norm of the residual, relative to that of the right-hand side");
  if(o.has_energy_tolerance)
    add("energy-tolerance", po::value(&o.energy_tolerance)->value_name("T"),
        "estimated error in the norm of the energy at which the iteration ends, too: relative to "
        "the solution, in fits to what they leave; 0: only the residual counts");
  add("stabilization", po::value(&o.stabilization)->value_name("C"),
      ("factor of the stabilization by normal derivatives; " + default_stabilization).c_str());
  return solver;
}

inline void check_solver_options(const Solver_options& o, const po::variables_map& given) {
  require(o.tolerance > 0 && o.tolerance < 1, "the argument of --tolerance must be in (0, 1)");
  require_not_negative(given, "energy-tolerance");
  require(o.energy_tolerance < 1, "the argument of --energy-tolerance must be less than 1");
  require_not_negative(given, "stabilization");
}

// what is given for an option, negative if it is not
inline std::optional<double> given_number(double x) {
  return x < 0 ? std::nullopt : std::optional<double>(x);
}

// the named parameters that they stand for
inline auto solver_parameters(const Solver_options& o) {
  return RL::parameters::tolerance(o.tolerance)
      .energy_tolerance(given_number(o.energy_tolerance))
      .stabilization(given_number(o.stabilization))
      .concurrency_tag(CGAL::Parallel_if_available_tag());
}

} // namespace programs

#endif // RESTRICTED_LAPLACIAN_3_PROGRAMS_SOLVER_OPTIONS_H
