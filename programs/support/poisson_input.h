// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_PROGRAMS_POISSON_INPUT_H
#define RESTRICTED_LAPLACIAN_3_PROGRAMS_POISSON_INPUT_H

// Which Poisson problem a program solves.

#include "command_line.h"
#include "program.h"

#include <boost/random/normal_distribution.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace programs {

struct Poisson_options {
  std::string rhs = "z", rhs_property;
  double alpha = 0;
};

inline void add_poisson_options(po::options_description& problem, Poisson_options& o) {
  auto add = problem.add_options();
  add("rhs", po::value(&o.rhs)->value_name("x|y|z|random")->default_value(o.rhs),
      "f: a coordinate, or independent normal random numbers at the vertices");
  add("rhs-property", po::value(&o.rhs_property)->value_name("NAME"),
      "f: a vertex property of MESH, a PLY file");
  add("alpha", po::value(&o.alpha)->value_name("A")->default_value(o.alpha),
      "screening weight, in units of 1 / area");
}

inline void check_poisson_options(const Poisson_options& o, const po::variables_map& given) {
  require_choice("rhs", o.rhs, {"x", "y", "z", "random"});
  require(given["rhs"].defaulted() || given.count("rhs-property") == 0,
          "give --rhs or --rhs-property, not both");
  require(o.alpha >= 0 && std::isfinite(o.alpha), "the argument of --alpha must not be negative");
}

// the numbers from `first` to `last` - 1 of a sequence
inline std::vector<double> random_values(std::size_t first, std::size_t last, long long seed) {
  // std::normal_distribution differs between standard libraries
  std::mt19937_64 generator(static_cast<std::uint64_t>(seed));
  boost::random::normal_distribution<double> distribution;
  for(std::size_t i = 0; i < first; ++i)
    distribution(generator);
  std::vector<double> values(last - first);
  for(double& value : values)
    value = distribution(generator);
  return values;
}

} // namespace programs

#endif // RESTRICTED_LAPLACIAN_3_PROGRAMS_POISSON_INPUT_H
