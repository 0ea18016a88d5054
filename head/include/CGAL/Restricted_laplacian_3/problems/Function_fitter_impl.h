// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_FUNCTION_FITTER_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_FUNCTION_FITTER_IMPL_H

#include <CGAL/Restricted_laplacian_3/assembly/shared/fit_residual.h>
#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Progress.h>
#include <CGAL/Restricted_laplacian_3/problems/Function_fitter.h>
#include <CGAL/Restricted_laplacian_3/problems/shared/values_over_surface.h>

#include <CGAL/Real_timer.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

namespace internal {

inline Function_fit_options checked(Function_fit_options options) {
  if(!options.solver.tolerance)
    options.solver.tolerance = Function_fit_options::default_tolerance;
  const double w = options.smoothing;
  if(!(w >= 0 && std::isfinite(w)))
    throw Parameter_error("smoothing", "is " + std::to_string(w) +
                                           ", but must be a finite number that is not negative");
  if(options.refinements < 0)
    throw Parameter_error("refinements", "must not be negative");
  if(options.energy_tolerance && !(*options.energy_tolerance >= 0 && *options.energy_tolerance < 1))
    throw Parameter_error("energy_tolerance", "must be from 0 to 1, and less than that");
  if(options.stabilization)
    checked_normal_stabilization(*options.stabilization);
  return options;
}

/// Error in the norm of the energy, relative to the solution, that nobody needs less of: that of
/// functions of the space, where what is minimized vanishes.
constexpr double smallest_error_of_fits = 1e-8;

/// The root mean squares of the components of a function without their means, or what rounding
/// leaves of the functions if these are larger.
/// \param whole what there is to fit
inline std::vector<double> deviations(const Spline_space_3& space, const Fit_residual& whole) {
  constexpr double rounding = 1e-9;
  std::vector<double> result = whole.root_means(space);
  for(std::size_t k = 0; k < result.size(); ++k) {
    // the splines sum to 1
    const double mean =
        whole.loads.col(static_cast<Eigen::Index>(k)).sum() / space.surface().area();
    const double square = (result[k] - mean) * (result[k] + mean);
    result[k] = (std::max)(std::sqrt((std::max)(square, 0.)), rounding * result[k]);
  }
  return result;
}

/// of the time that a fit takes, that of its solver; the rest is for solving
constexpr double end_of_setup = 0.6;

} // namespace internal

CGAL_RESTRICTED_LAPLACIAN_3_INLINE
Function_fitter::Function_fitter(const Spline_space_3& space, const Options& options)
  : m_space(space), m_options(internal::checked(options)) {}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Function_fitter::~Function_fitter() = default;
CGAL_RESTRICTED_LAPLACIAN_3_INLINE
Function_fitter::Function_fitter(Function_fitter&&) noexcept = default;
CGAL_RESTRICTED_LAPLACIAN_3_INLINE Function_fitter&
Function_fitter::operator=(Function_fitter&&) noexcept = default;

/// Matrices and loads are taken in units of the squared cell width.
CGAL_RESTRICTED_LAPLACIAN_3_INLINE double Function_fitter::unit() const {
  const double h = m_space.octree().cell_width(m_space.depth());
  return h * h;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Function_fit
Function_fitter::fit(const Surface_function_view& f, const std::function<bool(double)>& callback) {
  CGAL::Real_timer timer;
  timer.start();
  const double seconds_before = m_assembly_seconds + m_setup_seconds;
  // a refinement takes about a tenth of the fit
  const double steps = m_options.refinements, end_of_fit = 1 / (1 + 0.1 * steps);
  const Progress progress(callback);
  progress(0);
  internal::Fit_residual residual = internal::fit_residual(m_space, f);
  const std::vector<double> deviations = internal::deviations(m_space, residual);
  const double load_seconds = timer.time();

  Function_fit result;
  static_cast<Solve_report&>(result) =
      fit_residual(progress.part(0.1 * end_of_fit, end_of_fit), residual, result.coefficients);
  result.stabilization = stabilization();
  const Progress of_refinements = progress.part(end_of_fit, 1);
  for(int step = 0; step < m_options.refinements; ++step) {
    Eigen::MatrixXd x;
    const Solve_report report =
        fit_residual(of_refinements.part(step / steps, (step + 1) / steps), residual, x);
    result.coefficients += x;
    result.worsen_status(report.status);
  }
  progress(1);
  result.root_mean_square_errors = residual.are_accurate
                                       ? residual.root_means(m_space)
                                       : internal::fit_errors(m_space, f, result.coefficients);
  // a function that is smoothed is not approximated
  if(m_options.smoothing == 0 && !m_space.is_paper_space()) {
    result.estimated_error = 0;
    result.is_estimate_trusted = true;
    for(std::size_t k = 0; k < deviations.size(); ++k)
      if(deviations[k] > 0)
        result.estimated_error =
            (std::max)(result.estimated_error, result.root_mean_square_errors[k] / deviations[k]);
  }

  result.assembly_seconds = m_assembly_seconds + load_seconds;
  result.setup_seconds = m_setup_seconds;
  result.solve_seconds =
      timer.time() - load_seconds - (m_assembly_seconds + m_setup_seconds - seconds_before);
  return result;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Function_fit Function_fitter::project(
    const Eigen::MatrixXd& loads, const std::function<bool(double)>& callback) {
  const double c = m_options.stabilization.value_or(default_projection_stabilization);
  const Progress progress(callback);
  const Poisson_solver& solver = this->solver(c, progress.part(0, internal::end_of_setup), false);
  Function_fit result;
  static_cast<Solve_report&>(result) = solver.solve(
      loads / unit(), result.coefficients,
      {*m_options.solver.tolerance, progress.part(internal::end_of_setup, 1).callback()});
  result.stabilization = c;
  result.assembly_seconds = m_assembly_seconds;
  return result;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE double Function_fitter::stabilization() const {
  return m_options.stabilization.value_or(default_fit_stabilization(m_space, m_options.smoothing));
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE double Function_fitter::energy_tolerance() const {
  return m_options.energy_tolerance.value_or(
      internal::default_fit_tolerance(m_space, m_options.smoothing));
}

/// the solver with this stabilization
/// \param is_mass_needed whether the mass matrix is assembled with those of the solver
CGAL_RESTRICTED_LAPLACIAN_3_INLINE const Poisson_solver&
Function_fitter::solver(double stabilization, const Progress& progress, bool is_mass_needed) {
  for(const auto& [c, solver] : m_solvers)
    if(c == stabilization)
      return solver;
  CGAL::Real_timer timer;
  timer.start();
  Poisson_solver_options options = m_options.solver;
  if(energy_tolerance() > 0)
    options.energy_tolerance = internal::smallest_error_of_fits;
  // The matrix M + w S in units of the squared cell width.
  internal::Elliptic_system system;
  system.elliptic.reaction = 1 / unit();
  system.elliptic.diffusion = m_options.smoothing / unit();
  system.elliptic.stabilization = stabilization;
  system.mass = is_mass_needed && m_mass.cols() == 0 ? &m_mass : nullptr;
  m_solvers.emplace_back(stabilization, Poisson_solver(m_space, system, options, progress));
  const Poisson_solver& result = m_solvers.back().second;
  m_setup_seconds += result.setup_seconds();
  m_assembly_seconds += timer.time() - result.setup_seconds();
  return result;
}

/// the mass matrix without stabilization, or its upper half
CGAL_RESTRICTED_LAPLACIAN_3_INLINE const Sparse_matrix& Function_fitter::mass() {
  if(m_mass.cols() == 0) {
    internal::Elliptic_operator elliptic;
    elliptic.diffusion = 0;
    elliptic.reaction = 1;
    internal::assemble_system(m_space, m_space.depth(), elliptic,
                              internal::Stored_entries::upper_half)
        .matrices.back()
        .swap(m_mass);
  }
  return m_mass;
}

/// Fits what is left of a function, and subtracts that from it.
/// \param coefficients receives those of the fit
CGAL_RESTRICTED_LAPLACIAN_3_INLINE Solve_report Function_fitter::fit_residual(
    const Progress& progress, internal::Fit_residual& residual, Eigen::MatrixXd& coefficients) {
  const Poisson_solver& solver =
      this->solver(stabilization(), progress.part(0, internal::end_of_setup), true);
  Solve_options options(*m_options.solver.tolerance,
                        progress.part(internal::end_of_setup, 1).callback());
  options.least_squares = {residual.squares, energy_tolerance()};
  const Solve_report report = solver.solve(residual.loads / unit(), coefficients, options);
  residual.subtract(m_space, mass(), coefficients);
  return report;
}

namespace internal {

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Function_fit fit_function_to_accuracy(
    Spline_space_3& space, const Surface_function_view& f, const Function_fit_options& options,
    double accuracy, const Progress& progress, const Integrated_space& integrated) {
  Function_fit fit;
  search_depth(space, accuracy, progress, {}, [&](const Progress& part) {
    fit = Function_fitter(integrated ? integrated(space) : space, options).fit(f, part.callback());
    Found_in_space found;
    found.report = &fit;
    if(options.smoothing > 0)
      found.values = values_over_surface(space, fit.coefficients);
    return found;
  });
  return fit;
}

} // namespace internal

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_FUNCTION_FITTER_IMPL_H
