// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_INTERNAL_PRESCRIBED_ITERATION_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_INTERNAL_PRESCRIBED_ITERATION_H

#include <CGAL/Restricted_laplacian_3/assembly/Point_constraints.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Progress.h>
#include <CGAL/Restricted_laplacian_3/solvers/Multigrid_solver.h>
#include <CGAL/Restricted_laplacian_3/solvers/Solve_report.h>
#include <CGAL/Restricted_laplacian_3/solvers/shared/Mean_projection.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// Solves \f$A x = \ell + \sum_k \phi_k b(p_k)\f$ with fluxes \f$\phi_k = \lambda_k\f$ for which
/// values at points are met, and \f$\phi_k = w_k (g_k - u(p_k))\f$ for those that pull, by a solver
/// with the matrix \f$K = A + \sum_k w_k b(p_k) b(p_k)^T\f$.
///
/// Each step solves with \f$K\f$ for what is left, and adds \f$w_k (g_k - u(p_k))\f$ to
/// \f$\lambda_k\f$. Residuals are those of the equation above, relative to its right-hand side:
/// those with \f$K\f$ are relative to \f$w_k g_k\f$, which says nothing of the solution.
class Prescribed_iteration {
public:
  /// largest difference to a value that is to be met, over the size of the solution: the largest of
  /// the range of these values, the root of the energy, and 1e-6 of the values, below which there
  /// is rounding
  static constexpr double largest_miss = 1e-7;
  /// What is more contradicts itself, or is denser than the functions are; then values are met as
  /// well as they can be.
  static constexpr double largest_miss_of_converged = 1e-3;

  /// \param solver the solver for \f$K\f$
  /// \param load \f$\ell\f$
  /// \param constraints may be null
  /// \param guess a number around which the prescribed values are
  Prescribed_iteration(const Poisson_solver& solver, const Eigen::VectorXd& load,
                       const Point_constraints* constraints, double guess)
    : m_solver(solver), m_load(load), m_constraints(constraints) {
    if(constraints) {
      m_values = constraints->values();
      m_weights = constraints->weights();
    }
    m_exact.resize(m_values.size());
    for(Eigen::Index k = 0; k < m_values.size(); ++k)
      m_exact[k] = constraints->is_exact(static_cast<std::size_t>(k));
    m_fluxes = Eigen::VectorXd::Zero(m_values.size());
    const Mean_projection& means = solver.mean_projection();
    m_guess = Eigen::VectorXd::Constant(load.size(), guess);
    for(Eigen::Index i = 0; i < load.size(); ++i) {
      const int component = means.components()[static_cast<std::size_t>(i)];
      if(means.is_split_off(component) && !means.is_screened(component))
        m_guess[i] = 0; // there the mean is
    }
    m_x = m_guess;
    m_scale_of_load = projected_norm(m_load - product_without_weights(m_x));
    update();
  }

  Solve_report solve(double tolerance, const Progress& progress) {
    constexpr int largest_number_of_steps = 50;
    constexpr double least_gain = 0.5; // in a step that is worth another one
    Solve_report report;
    report.set_status(Solve_status::stalled);
    report.setup_seconds = m_solver.setup_seconds();
    report.relative_energy_error = 0;
    const double energy_tolerance = m_solver.options().energy_tolerance;
    for(int step = 0; step < largest_number_of_steps; ++step) {
      const double norm = m_step_load.norm(), residual_before = m_residual, miss_before = m_miss;
      if(!(norm > 0)) {
        report.set_status(Solve_status::converged);
        break;
      }
      const Progress of_progress = progress.part(part_done(step), part_done(step + 1));
      Eigen::VectorXd d;
      const Solve_report of_step = m_solver.solve(
          m_step_load, d, {tolerance_of_step(tolerance, norm), of_progress.callback()});
      m_x += d;
      m_fluxes += m_exact.cwiseProduct(m_weights).cwiseProduct(misses());
      update();
      report.iterations += of_step.iterations;
      report.solve_seconds += of_step.solve_seconds;
      const double size = root_of_energy(m_x - m_guess);
      report.relative_energy_error =
          size > 0 ? of_step.relative_energy_error * root_of_energy(d) / size : 0;
      const bool is_solved =
          m_residual <= (std::max)(tolerance * m_scale, rounding()) ||
          (energy_tolerance > 0 && report.relative_energy_error <= energy_tolerance);
      const double relative_miss =
          m_miss > 0 ? m_miss / (std::max)(size_of_values(), size / std::sqrt(diffusion())) : 0;
      if(is_solved &&
         (relative_miss <= largest_miss || (step > 0 && m_miss > least_gain * miss_before))) {
        report.set_status(relative_miss <= largest_miss_of_converged ? Solve_status::converged
                                                                     : Solve_status::stalled);
        break;
      }
      if(report.iterations >= m_solver.options().maximum_iterations) {
        report.set_status(Solve_status::iteration_limit);
        break;
      }
      if(!is_solved && !of_step.converged && !(m_residual <= least_gain * residual_before)) {
        report.set_status(of_step.status);
        break;
      }
    }
    progress(1);
    report.relative_residual = m_scale > 0 ? m_residual / m_scale : 0;
    report.relative_residuals = {report.relative_residual};
    report.constraint_error = m_miss;
    return report;
  }

  const Eigen::VectorXd& coefficients() const { return m_x; }

private:
  static double part_done(int step) { return 1 - std::ldexp(1., -step); }

  /// of the residual with K, whose size is `norm`
  double tolerance_of_step(double tolerance, double norm) const {
    // A step cannot meet values better than by this, and the fluxes are not known before.
    constexpr double smallest = 1e-4, largest = 0.1;
    if(m_values.size() == 0)
      return tolerance;
    return (std::min)(largest, (std::max)(smallest, tolerance * m_scale / norm));
  }

  /// of those to be met: their range, or 1e-6 of the largest
  double size_of_values() const {
    constexpr double smallest_range = 1e-6;
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for(Eigen::Index k = 0; k < m_values.size(); ++k)
      if(m_exact[k] != 0) {
        low = (std::min)(low, m_values[k]);
        high = (std::max)(high, m_values[k]);
      }
    return (std::max)(high - low, smallest_range * (std::max)(std::abs(low), std::abs(high)));
  }

  /// the largest one at values to be met
  double diffusion() const {
    const double weight = m_exact.cwiseProduct(m_weights).maxCoeff();
    return weight > 0 ? weight / Point_constraints::weight_of_exact : 1;
  }

  /// of a residual
  double rounding() const {
    constexpr double unit = 1e-15;
    return unit * (m_load.norm() + load_of(m_weights.cwiseProduct(m_values)).norm());
  }

  /// \f$g_k - u(p_k)\f$
  Eigen::VectorXd misses() const {
    if(!m_constraints)
      return m_values;
    return m_values - m_constraints->values_of(m_x);
  }

  Eigen::VectorXd load_of(const Eigen::VectorXd& fluxes) const {
    if(!m_constraints)
      return Eigen::VectorXd::Zero(m_load.size());
    return m_constraints->load(fluxes);
  }

  /// \f$K v\f$
  Eigen::VectorXd product(const Eigen::VectorXd& v) const {
    return m_solver.upper_half().selfadjointView<Eigen::Upper>() * v;
  }

  /// \f$A v\f$
  Eigen::VectorXd product_without_weights(const Eigen::VectorXd& v) const {
    if(!m_constraints)
      return product(v);
    return product(v) - load_of(m_weights.cwiseProduct(m_constraints->values_of(v)));
  }

  double root_of_energy(const Eigen::VectorXd& v) const {
    return std::sqrt((std::max)(0., v.dot(product(v))));
  }

  double projected_norm(const Eigen::VectorXd& v) const {
    Block_vector<1> projected = v;
    m_solver.mean_projection().project_load<1>(projected);
    return projected.norm();
  }

  /// what follows from the solution and the fluxes
  void update() {
    const Eigen::VectorXd missed = misses(), pull = m_weights.cwiseProduct(missed),
                          pull_of_others = pull - m_exact.cwiseProduct(pull),
                          flux_load = load_of(m_fluxes + pull_of_others),
                          residual = m_load + flux_load - product_without_weights(m_x);
    m_step_load = residual + load_of(m_exact.cwiseProduct(pull));
    m_residual = projected_norm(residual);
    m_scale = (std::max)(m_scale_of_load, flux_load.norm());
    m_miss = m_values.size() > 0 ? m_exact.cwiseProduct(missed).cwiseAbs().maxCoeff() : 0;
  }

  const Poisson_solver& m_solver;
  const Eigen::VectorXd& m_load;
  const Point_constraints* m_constraints;
  Eigen::VectorXd m_values, m_weights, m_exact; // g, w, 1 where a value is to be met
  Eigen::VectorXd m_guess, m_x, m_fluxes;       // lambda, 0 for values that pull
  Eigen::VectorXd m_step_load;                  // what the next step solves for
  double m_scale_of_load = 0, m_residual = 0, m_scale = 0, m_miss = 0;
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_INTERNAL_PRESCRIBED_ITERATION_H
