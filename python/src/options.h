// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_PYTHON_OPTIONS_H
#define RESTRICTED_LAPLACIAN_3_PYTHON_OPTIONS_H

// Options come as a dictionary, whose values may be None.

#include "module.h"

#include <CGAL/Restricted_laplacian_3/solvers/Multigrid_solver.h>

#include <cmath>
#include <optional>
#include <string>

namespace python {

inline std::optional<double> number_of(const nb::dict& options, const char* name) {
  if(!options.contains(name) || options[name].is_none())
    return {};
  return nb::cast<double>(options[name]);
}

inline std::optional<int> whole_number_of(const nb::dict& options, const char* name) {
  const std::optional<double> number = number_of(options, name);
  if(!number)
    return {};
  constexpr double largest = 1e9;
  if(!(*number >= -largest && *number <= largest && *number == std::floor(*number)))
    throw RL::Parameter_error(name, "must be a whole number, and is " + std::to_string(*number));
  return static_cast<int>(*number);
}

inline std::string text_of(const nb::dict& options, const char* name, const std::string& value) {
  if(!options.contains(name) || options[name].is_none())
    return value;
  return nb::cast<std::string>(options[name]);
}

inline RL::Poisson_solver_options solver_options(const nb::dict& options, int threads) {
  RL::Poisson_solver_options o;
  o.tolerance = number_of(options, "tolerance");
  o.energy_tolerance = number_of(options, "energy_tolerance").value_or(0);
  if(const auto limit = whole_number_of(options, "maximum_iterations"))
    o.maximum_iterations = *limit;
  o.cycle = text_of(options, "cycle", "v") == "w" ? RL::Cycle::W : RL::Cycle::V;
  o.smoother = text_of(options, "smoother", "patch") == "point" ? RL::Smoother_type::point
                                                                : RL::Smoother_type::patch;
  o.is_parallel = threads != 1;
  return o;
}

} // namespace python

#endif // RESTRICTED_LAPLACIAN_3_PYTHON_OPTIONS_H
