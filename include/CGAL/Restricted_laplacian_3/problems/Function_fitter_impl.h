// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_FUNCTION_FITTER_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_FUNCTION_FITTER_IMPL_H

#include <CGAL/Restricted_laplacian_3/assembly/internal/fit_residual.h>
#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Progress.h>
#include <CGAL/Restricted_laplacian_3/problems/Function_fitter.h>

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

inline Function_fit_options checked(const Function_fit_options& options) {
  const double w = options.smoothing_weight;
  if(!(w >= 0 && std::isfinite(w)))
    throw Parameter_error("smoothing_weight",
                          "is " + std::to_string(w) +
                              ", but must be a finite number that is not negative");
  if(options.refinement_steps < 0)
    throw Parameter_error("refinement_steps", "must not be negative");
  if(options.normal_stabilization)
    checked_normal_stabilization(*options.normal_stabilization);
  return options;
}

inline Eigen::MatrixXd columns(const Eigen::MatrixXd& matrix,
                               const std::vector<Eigen::Index>& numbers) {
  Eigen::MatrixXd result(matrix.rows(), static_cast<Eigen::Index>(numbers.size()));
  for(std::size_t i = 0; i < numbers.size(); ++i)
    result.col(static_cast<Eigen::Index>(i)) = matrix.col(numbers[i]);
  return result;
}

/// of the time that a fit takes, that of its solver; the rest is for solving
constexpr double end_of_setup = 0.6;

} // namespace internal

CGAL_RESTRICTED_LAPLACIAN_3_INLINE
Function_fitter::Function_fitter(const Spline_space_3& space,
                                 const Surface_integration_view& integration,
                                 const Options& options)
  : m_space(&space), m_integration(integration), m_options(internal::checked(options)) {}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Function_fitter::~Function_fitter() = default;
CGAL_RESTRICTED_LAPLACIAN_3_INLINE
Function_fitter::Function_fitter(Function_fitter&&) noexcept = default;
CGAL_RESTRICTED_LAPLACIAN_3_INLINE Function_fitter&
Function_fitter::operator=(Function_fitter&&) noexcept = default;

/// Matrices and loads are taken in units of the squared cell width.
CGAL_RESTRICTED_LAPLACIAN_3_INLINE double Function_fitter::unit() const {
  const double h = m_space->octree().cell_width(m_space->depth());
  return h * h;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Function_fitter::Residual
Function_fitter::residual(const Surface_function_view& f, const Function_fit& fit,
                          bool with_gradients) const {
  return internal::fit_residual(*m_space, m_integration, f, fit.coefficients, with_gradients);
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Function_fit
Function_fitter::fit(const Surface_function_view& f, const std::function<bool(double)>& callback) {
  CGAL::Real_timer timer;
  timer.start();
  const double seconds_before = m_assembly_seconds + m_setup_seconds;
  // a refinement takes about a fifth of the fit
  const double refinements = 0.2 * m_options.refinement_steps, end_of_fit = 1 / (1 + refinements);
  const Progress progress(callback);
  progress(0);
  Function_fit result;
  const Residual of_zero = residual(f, result);
  const double load_seconds = timer.time();

  const Progress of_fit = progress.part(0.1 * end_of_fit, end_of_fit);
  if(m_options.normal_stabilization)
    project(of_zero.loads, *m_options.normal_stabilization, of_fit, result);
  else
    fit_with_chosen_stabilization(f, of_zero, of_fit, result);
  const Progress of_refinements = progress.part(end_of_fit, 1);
  for(int step = 0; step < m_options.refinement_steps; ++step)
    refine(f,
           of_refinements.part(static_cast<double>(step) / m_options.refinement_steps,
                               (step + 1.) / m_options.refinement_steps),
           result);
  progress(1);
  const Residual left = residual(f, result);
  for(Eigen::Index k = 0; k < left.squares.size(); ++k)
    result.root_mean_square_errors.push_back(
        std::sqrt(left.squares[k] * (unit() / m_space->surface().area())));

  result.assembly_seconds = m_assembly_seconds + load_seconds;
  result.setup_seconds = m_setup_seconds;
  result.solve_seconds =
      timer.time() - load_seconds - (m_assembly_seconds + m_setup_seconds - seconds_before);
  return result;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Function_fit Function_fitter::project(
    const Eigen::MatrixXd& loads, const std::function<bool(double)>& callback) {
  Function_fit result;
  project(loads, m_options.normal_stabilization.value_or(internal::Fit_stabilization::factors[0]),
          Progress(callback), result);
  result.assembly_seconds = m_assembly_seconds;
  return result;
}

/// the solver with this stabilization
CGAL_RESTRICTED_LAPLACIAN_3_INLINE const Poisson_solver&
Function_fitter::solver(double normal_stabilization, const Progress& progress) {
  for(const auto& [c, solver] : m_solvers)
    if(c == normal_stabilization)
      return solver;
  CGAL::Real_timer timer;
  timer.start();
  using internal::Fit_stabilization;
  internal::Poisson_solver_options options = m_options.solver;
  if(!m_options.normal_stabilization)
    options.energy_tolerance = 0; // stages are compared by their residuals
  if(!m_options.normal_stabilization && normal_stabilization == Fit_stabilization::factors.back())
    options.maximum_iterations =
        (std::min)(options.maximum_iterations, Fit_stabilization::maximum_iterations_of_smallest);
  // The matrix M + w S in units of the squared cell width.
  internal::Elliptic_operator elliptic;
  elliptic.reaction = 1 / unit();
  elliptic.diffusion = m_options.smoothing_weight / unit();
  elliptic.normal_stabilization = normal_stabilization;
  m_solvers.emplace_back(normal_stabilization,
                         internal::elliptic_solver(*m_space, m_integration, elliptic, options,
                                                   progress, &m_integrals));
  const Poisson_solver& result = m_solvers.back().second;
  m_setup_seconds += result.setup_seconds();
  m_assembly_seconds += timer.time() - result.setup_seconds();
  return result;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void Function_fitter::project(const Eigen::MatrixXd& loads,
                                                                 double normal_stabilization,
                                                                 const Progress& progress,
                                                                 Function_fit& result) {
  const Poisson_solver& solver =
      this->solver(normal_stabilization, progress.part(0, internal::end_of_setup));
  static_cast<Solve_report&>(result) =
      solver.solve(loads / unit(), result.coefficients, m_options.solver.relative_tolerance,
                   progress.part(internal::end_of_setup, 1).callback());
  result.normal_stabilizations.assign(result.relative_residuals.size(), normal_stabilization);
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void
Function_fitter::fit_with_chosen_stabilization(const Surface_function_view& f,
                                               const Residual& of_zero, const Progress& progress,
                                               Function_fit& result) {
  using internal::Fit_stabilization;
  const Eigen::MatrixXd loads = of_zero.loads / unit();
  result.coefficients.setZero(loads.rows(), loads.cols());
  result.relative_residuals.assign(loads.cols(), 0.);
  result.normal_stabilizations.assign(loads.cols(), 0.);
  std::vector<int> iterations(loads.cols(), 0);
  std::array<Components, Fit_stabilization::factors.size()> to_be_fitted;
  to_be_fitted[0].resize(loads.cols());
  std::iota(to_be_fitted[0].begin(), to_be_fitted[0].end(), Eigen::Index(0));
  const std::size_t last = to_be_fitted.size() - 1;
  for(std::size_t i = 0; i <= last; ++i) {
    if(to_be_fitted[i].empty())
      continue;
    const double c = Fit_stabilization::factors[i];
    const double number = static_cast<double>(to_be_fitted.size());
    const Progress of_factor =
        progress.part(static_cast<double>(i) / number, static_cast<double>(i + 1) / number);
    const Poisson_solver& solver = this->solver(c, of_factor.part(0, internal::end_of_setup));
    const Progress of_solver = of_factor.part(internal::end_of_setup, 1);
    solve_roughly(solver, loads, to_be_fitted[i], of_solver.part(0, 0.4), result, iterations);
    Components accepted;
    Residual left;
    if(i < last)
      left = residual(f, result, m_options.smoothing_weight > 0);
    for(Eigen::Index k : to_be_fitted[i]) {
      std::size_t next = i;
      if(i < last)
        next = Fit_stabilization::next(
            i, relative_stabilization_energy(solver, k, of_zero, left, result), of_zero.squares[k],
            left.squares[k]);
      (next == i ? accepted : to_be_fitted[next]).push_back(k);
    }
    reduce_residuals(solver, loads, accepted, of_solver.part(0.4, 1), result, iterations);
    for(Eigen::Index k : accepted)
      result.normal_stabilizations[k] = c;
  }
  fit_again_what_did_not_converge(to_be_fitted[last], loads, progress, result, iterations);
  result.iterations = *std::max_element(iterations.begin(), iterations.end());
  result.relative_residual =
      *std::max_element(result.relative_residuals.begin(), result.relative_residuals.end());
  result.set_status(has_converged(result.relative_residual) ? Solve_status::converged
                    : !(result.relative_residual <= 1)      ? Solve_status::diverged
                    : result.iterations < m_options.solver.maximum_iterations
                        ? Solve_status::stalled
                        : Solve_status::iteration_limit);
}

/// A residual is the product of those of two solves, and may be rounded up.
CGAL_RESTRICTED_LAPLACIAN_3_INLINE bool
Function_fitter::has_converged(double relative_residual) const {
  return relative_residual <= m_options.solver.relative_tolerance * (1 + 1e-12);
}

/// \param components those that were fitted with the smallest stabilization
CGAL_RESTRICTED_LAPLACIAN_3_INLINE void Function_fitter::fit_again_what_did_not_converge(
    const Components& components, const Eigen::MatrixXd& loads, const Progress& progress,
    Function_fit& result, std::vector<int>& iterations) {
  const auto& factors = internal::Fit_stabilization::factors;
  Components slow;
  for(Eigen::Index k : components)
    if(!has_converged(result.relative_residuals[k]))
      slow.push_back(k);
  if(slow.empty())
    return;
  const double c = factors[factors.size() - 2];
  const Poisson_solver& solver = this->solver(c, progress);
  solve_roughly(solver, loads, slow, progress, result, iterations);
  reduce_residuals(solver, loads, slow, progress, result, iterations);
  for(Eigen::Index k : slow)
    result.normal_stabilizations[k] = c;
}

/// solves for some components, well enough to compare energies
CGAL_RESTRICTED_LAPLACIAN_3_INLINE void
Function_fitter::solve_roughly(const Poisson_solver& solver, const Eigen::MatrixXd& loads,
                               const Components& components, const Progress& progress,
                               Function_fit& result, std::vector<int>& iterations) const {
  constexpr double rough_tolerance = 1e-2;
  Eigen::MatrixXd x;
  const Solve_report report = solver.solve(
      internal::columns(loads, components), x,
      (std::max)(m_options.solver.relative_tolerance, rough_tolerance), progress.callback());
  for(std::size_t i = 0; i < components.size(); ++i) {
    result.coefficients.col(components[i]) = x.col(static_cast<Eigen::Index>(i));
    result.relative_residuals[components[i]] = report.relative_residuals[i];
    iterations[components[i]] += report.iterations;
  }
}

/// Reduces the residuals of some components by one factor for all of them, so that the largest
/// one meets the tolerance.
CGAL_RESTRICTED_LAPLACIAN_3_INLINE void
Function_fitter::reduce_residuals(const Poisson_solver& solver, const Eigen::MatrixXd& loads,
                                  const Components& components, const Progress& progress,
                                  Function_fit& result, std::vector<int>& iterations) const {
  double largest = 0;
  for(Eigen::Index k : components)
    largest = (std::max)(largest, result.relative_residuals[k]);
  if(!(largest > m_options.solver.relative_tolerance))
    return;
  const Eigen::MatrixXd residual =
      internal::columns(loads, components) - solver.upper_half().selfadjointView<Eigen::Upper>() *
                                                 internal::columns(result.coefficients, components);
  Eigen::MatrixXd correction;
  const Solve_report report = solver.solve(
      residual, correction, m_options.solver.relative_tolerance / largest, progress.callback());
  for(std::size_t i = 0; i < components.size(); ++i) {
    result.coefficients.col(components[i]) += correction.col(static_cast<Eigen::Index>(i));
    result.relative_residuals[components[i]] *= report.relative_residuals[i];
    iterations[components[i]] += report.iterations;
  }
}

/// The energy of the stabilization, \f$\eta^T A \eta - \int u^2 + w \lvert \nabla u \rvert^2\f$,
/// over \f$\int (u - f)^2 + w \lvert \nabla u \rvert^2\f$; 0 if both are. The mean of \f$u\f$ is
/// taken off first, to which the stabilization is blind.
CGAL_RESTRICTED_LAPLACIAN_3_INLINE double
Function_fitter::relative_stabilization_energy(const Poisson_solver& solver, Eigen::Index k,
                                               const Residual& of_zero, const Residual& left,
                                               const Function_fit& fit) const {
  const auto eta_k = fit.coefficients.col(k);
  const double mean = m_space->is_paper_space() ? 0 : m_integrals.dot(eta_k) / m_integrals.sum();
  const Eigen::VectorXd eta = eta_k.array() - mean;
  const Eigen::VectorXd mass_eta =
      (of_zero.loads.col(k) - left.loads.col(k)) / unit() - mean * m_integrals;
  const Eigen::VectorXd a_eta = solver.upper_half().selfadjointView<Eigen::Upper>() * eta;
  const double smoothing = m_options.smoothing_weight / unit() * left.gradient_squares[k];
  const double stabilization = eta.dot(a_eta - mass_eta) - smoothing;
  return stabilization > 0 ? stabilization / (left.squares[k] + smoothing) : 0;
}

/// fits what is left, each component with its stabilization
CGAL_RESTRICTED_LAPLACIAN_3_INLINE void Function_fitter::refine(const Surface_function_view& f,
                                                                const Progress& progress,
                                                                Function_fit& result) const {
  progress(0);
  const Residual left = residual(f, result);
  for(const auto& [c, solver] : m_solvers) {
    Components components;
    for(Eigen::Index k = 0; k < left.loads.cols(); ++k)
      if(result.normal_stabilizations[k] == c)
        components.push_back(k);
    if(components.empty())
      continue;
    Eigen::MatrixXd x;
    const Solve_report report =
        solver.solve(internal::columns(left.loads, components) / unit(), x,
                     solver.options().relative_tolerance, progress.callback());
    for(std::size_t i = 0; i < components.size(); ++i)
      result.coefficients.col(components[i]) += x.col(static_cast<Eigen::Index>(i));
    result.worsen_status(report.status);
  }
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_FUNCTION_FITTER_IMPL_H
