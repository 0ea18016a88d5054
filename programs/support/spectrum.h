// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_PROGRAMS_SPECTRUM_H
#define RESTRICTED_LAPLACIAN_3_PROGRAMS_SPECTRUM_H

// What the programs that compute eigenfunctions have in common: options, progress, the summary.

#include "command_line.h"
#include "program.h"
#include "surface_program.h"

#include <CGAL/Restricted_laplacian_3/laplace_spectrum.h>

#include <cmath>
#include <optional>
#include <string>

namespace programs {

struct Eigensolver_options {
  std::string eigensolver = "auto";
  double tolerance = -1;     // the default
  double stabilization = -1; // the default
};

// `by_choice` is whether the user chooses the eigensolver
inline po::options_description eigensolver_options(Eigensolver_options& o, bool by_choice = true) {
  po::options_description options("Eigensolver", help_width);
  auto add = options.add_options();
  if(by_choice)
    add("eigensolver", po::value(&o.eigensolver)->value_name("NAME")->default_value(o.eigensolver),
        "multigrid, shift-invert (a factorization), or auto: the faster one");
  add("tolerance", po::value(&o.tolerance)->value_name("T"),
      (by_choice ? std::string("relative residual of multigrid") : "relative residual")
          .append("; errors of eigenvalues are about its square; default 0.001, or 0.0025 where "
                  "only eigenvalues are needed")
          .c_str());
  add("stabilization", po::value(&o.stabilization)->value_name("C"),
      by_choice
          ? "factor of the stabilization by normal derivatives; default 0.00001, or 0 with --paper"
          : "factor of the stabilization by normal derivatives; default 0.00001");
  return options;
}

inline void check_eigensolver_options(const Eigensolver_options& o, const po::variables_map& given,
                                      bool is_paper) {
  require_choice("eigensolver", o.eigensolver, {"auto", "multigrid", "shift-invert"});
  require(o.eigensolver != "multigrid" || !is_paper, "--eigensolver multigrid excludes --paper");
  require(given.count("tolerance") == 0 || (o.tolerance > 0 && o.tolerance < 1),
          "the argument of --tolerance must be in (0, 1)");
  require_effect(given, {"tolerance"}, o.eigensolver != "shift-invert",
                 "--eigensolver multigrid or auto");
  require_not_negative(given, "stabilization");
}

// says how many of the eigenvalues were found, if not all
inline void check_number(Job& job, const RL::Eigenpairs& pairs, int count) {
  if(!pairs.converged)
    job.fail("it found " + std::to_string(pairs.values.size()) + " of " + std::to_string(count) +
             " eigenvalues, and the iteration " + to_string(pairs.status) +
             "; --eigensolver shift-invert, or another depth or count, may find them");
}

struct Spectrum : RL::Laplace_spectrum {
  explicit Spectrum(const RL::Spline_space_3& space) : space(space) {}

  RL::Spline_space_3 space;
};

// The smallest eigenpairs of the surface, without values at the vertices.
inline Spectrum solve_spectrum(int count, bool eigenvalues_only, const Eigensolver_options& o,
                               Job& job) {
  RL::Laplace_spectrum_options options;
  options.eigensolver = o.eigensolver == "multigrid"      ? RL::Eigensolver::multigrid
                        : o.eigensolver == "shift-invert" ? RL::Eigensolver::shift_invert
                                                          : RL::Eigensolver::automatic;
  options.eigenvalues_only = eigenvalues_only;
  if(o.stabilization >= 0)
    options.stabilization = o.stabilization;
  if(o.tolerance > 0)
    options.multigrid.tolerance = o.tolerance;
  Spectrum spectrum(job.make_space("each has the eigenvalue 0"));
  options.multigrid.progress = job.step("computing eigenvalues of", spectrum.space);
  RL::Laplace_spectrum& found = spectrum;
  if(const std::optional<double> accuracy = job.accuracy()) {
    found = RL::internal::laplace_eigenpairs_to_accuracy(spectrum.space, count, options, *accuracy);
    job.add_space_of_search(spectrum.space, found.report);
    if(!found.report.converged)
      job.fail(found.report);
  } else
    found = RL::laplace_eigenpairs(spectrum.space, count, options);
  job.summary.add_detail("setup_seconds", job.space_seconds()); // the space counts as setup
  job.summary.add_detail("assembly_seconds", spectrum.report.assembly_seconds);
  job.summary.add_detail("solve_seconds", spectrum.report.solve_seconds);
  job.summary.add_detail("eigensolver", spectrum.eigensolver == RL::Eigensolver::multigrid
                                            ? "multigrid"
                                            : "shift-invert");
  job.summary.add_detail("iterations", spectrum.report.iterations);
  job.summary.add_detail("relative_residual", spectrum.report.relative_residual);
  job.add_estimate(spectrum.report);
  return spectrum;
}

} // namespace programs

#endif // RESTRICTED_LAPLACIAN_3_PROGRAMS_SPECTRUM_H
