// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_FUNCTION_FITTER_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_FUNCTION_FITTER_H

#include <CGAL/Restricted_laplacian_3/assembly/assemble.h>
#include <CGAL/Restricted_laplacian_3/assembly/internal/fit_residual.h>
#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/parameters.h>
#include <CGAL/Restricted_laplacian_3/problems/make_poisson_solver.h>
#include <CGAL/Restricted_laplacian_3/solvers/Poisson_solver.h>
#include <CGAL/Restricted_laplacian_3/solvers/Solve_report.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>
#include <CGAL/Restricted_laplacian_3/surface/internal/function_components.h>

#include <CGAL/Real_timer.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <deque>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Fits
/// What `fit_function()` did.
struct Fit_report : Solve_report {
  /// \f$(\int (u_k - f_k)^2 / \mathrm{area})^{1/2}\f$ of each component, in units of \f$f\f$
  std::vector<double> root_mean_square_errors;
  /// the factor \f$c\f$ of the stabilisation, for each component
  std::vector<double> normal_stabilizations;

  /// \f$(\int \lvert u - f \rvert^2 / \mathrm{area})^{1/2}\f$, all components together
  double root_mean_square_error() const {
    double sum = 0;
    for(double error : root_mean_square_errors)
      sum += error * error;
    return std::sqrt(sum);
  }
};

/// \ingroup PkgRestrictedLaplacian3Fits
/// A fitted function: its coefficients, to be evaluated by `Spline_function_3` or
/// `Spline_functions_3`.
struct Function_fit : Fit_report {
  /// a row for each element of the finest level, a column for each component
  Eigen::MatrixXd coefficients;
};

/// \ingroup PkgRestrictedLaplacian3Fits
/// What a `Function_fitter` does unless told otherwise.
struct Function_fit_options {
  Function_fit_options() { solver.relative_tolerance = 1e-8; }

  /// weight \f$w \ge 0\f$ of \f$\int \lvert \nabla u \rvert^2\f$, in units of length^2
  double smoothing_weight = 0;
  /// how often what the fit leaves of \f$f\f$ is fitted and added
  int refinement_steps = 0;
  /// factor \f$c\f$ of the stabilisation; without a value it is chosen for each component
  std::optional<double> normal_stabilization;
  /// of the linear systems; the relative tolerance is 1e-8
  Poisson_solver_options solver;
};

namespace internal {

/// The factors of the stabilisation that are tried. With the first one the number of iterations
/// does not depend on the depth; the last one is as small as rounding permits.
constexpr std::array<double, 3> fit_stabilizations = {1e-4, 1e-5, 1e-14};
/// The energy of the stabilisation may be up to this fraction of what is minimised. Rough functions
/// are those whose root mean square error is above 1 % of their own root mean square.
constexpr double small_energy_of_smooth = 0.1, small_energy_of_rough = 0.5;
constexpr double squared_error_of_rough = 1e-4;
/// above this fraction the smallest factor is tried next
constexpr double large_stabilization_energy = 1;
/// of one solve with the smallest factor; what does not converge then gets the factor before it
constexpr int maximum_iterations_of_smallest = 60;

template <class NamedParameters>
Function_fit_options function_fit_options(const NamedParameters& np) {
  using parameters::choose_parameter;
  using parameters::get_parameter;
  Function_fit_options options;
  const double tolerance = options.solver.relative_tolerance;
  options.solver = poisson_solver_options(np);
  options.solver.relative_tolerance =
      choose_parameter(get_parameter(np, internal_np::relative_tolerance), tolerance);
  options.smoothing_weight =
      choose_parameter(get_parameter(np, internal_np::smoothing_weight), options.smoothing_weight);
  options.refinement_steps =
      choose_parameter(get_parameter(np, internal_np::refinement_steps), options.refinement_steps);
  if constexpr(is_given_v<NamedParameters, internal_np::normal_stabilization_t>)
    options.normal_stabilization = get_parameter(np, internal_np::normal_stabilization);
  return options;
}

} // namespace internal

/// \ingroup PkgRestrictedLaplacian3Fits
/// Fits functions on a surface by splines: set up once, it fits any number of functions, each a
/// number or a vector at each point. The fit of \f$f\f$ is the function \f$u\f$ of the space that
/// minimises, for each component,
/// \f[ \int_{\mathcal M} (u - f)^2 + w \int_{\mathcal M} \lvert \nabla u \rvert^2, \qquad
///     (M + w S)\, \eta = \gamma, \qquad \gamma_i = \int_{\mathcal M} f\, b_i, \f]
/// for \f$w = 0\f$ the least-squares projection \f$D \eta = \gamma\f$ of the paper (section 5.3).
/// The weight \f$w\f$ is in units of length^2: an eigenfunction of the Laplacian with the
/// eigenvalue \f$\lambda\f$ is multiplied by \f$1 / (1 + w \lambda)\f$. As \f$w\f$ grows, \f$u\f$
/// tends to the mean of \f$f\f$ on each connected component of the surface. On boundaries the
/// natural condition holds: \f$u\f$ is drawn to \f$\partial u / \partial \nu = 0\f$ within about
/// \f$\sqrt w\f$ from them.
///
/// *Refinement.* Each refinement step fits what is left, \f$f - u\f$, and adds that to \f$u\f$.
/// After \f$n\f$ steps the factor is \f$1 - (w \lambda / (1 + w \lambda))^{n + 1}\f$: long waves
/// are kept much better, while the shortest ones are damped as before, up to the factor \f$n + 1\f$
/// (iterated Tikhonov regularisation).
///
/// *Stabilisation.* The mass matrix is close to singular, see `assemble_operators()`: combinations
/// of elements that vary along the normal only nearly vanish on the surface. The term \f$c\, h N\f$
/// is added to \f$M\f$, and \f$\frac{c}{h} N\f$ to \f$S\f$. Unless \f$c\f$ is given, it is the
/// first of 1e-4, 1e-5 and 1e-14, for each component, with which the energy of the stabilisation is
/// at most a tenth of what \f$u\f$ minimises, or half of it if the error of \f$u\f$ is above 1 % of
/// \f$f\f$ (root mean squares); 1e-5 is left out where it is larger than all of that. A
/// rough function, for example the normals of the faces, is far from the space: 1e-4 adds little to
/// its error, and the number of iterations does not depend on the depth. The error of a smooth
/// function would be that of the stabilisation. A smaller one takes more iterations, but then the
/// error is of the order \f$h^3\f$, and a function in the space is fitted up to about 1e-7 of its
/// size. Where 1e-14 does not converge within 60 iterations, as may happen on large plane faces,
/// 1e-5 is taken.
///
/// The systems are solved by conjugate gradients with a multigrid preconditioner, a
/// `Poisson_solver`, for up to eight components at a time.
/// \tparam SurfaceIntegration a model of `SurfaceIntegration_3`
template <class SurfaceIntegration = Cubature> class Function_fitter {
public:
  /// what the constructor takes
  using Options = Function_fit_options;

  /// \param space,integration have to outlive this object
  /// \param options smoothing, refinement, stabilisation and solver
  /// \throws Parameter_error if an option is outside its domain
  Function_fitter(const Spline_space_3& space, const SurfaceIntegration& integration,
                  const Options& options = Options())
    : m_space(&space), m_integration(&integration), m_options(checked(options)) {}

  /// the space, as given to the constructor
  const Spline_space_3& space() const { return *m_space; }
  /// the options, as given to the constructor
  const Options& options() const { return m_options; }

  /// Fits a function. Solvers are set up when they are needed first, and kept: not to be called by
  /// several threads at once. Setup takes time and memory proportional to the number of triangles
  /// (or samples) plus the number of elements.
  /// \param f a function object that takes a `const Surface_point&` and returns a number, a
  /// `std::array` of numbers, a vector of Eigen of a fixed size, or a 3D vector or point of \cgal.
  /// Integrated as in `assemble_load()`.
  /// \throws Parameter_error if a value of `f` is not finite
  template <class Function> Function_fit fit(const Function& f) {
    CGAL::Real_timer timer;
    timer.start();
    const double seconds_before = m_assembly_seconds + m_setup_seconds;
    Function_fit result;
    const Residual of_zero = residual(f, result);
    const double load_seconds = timer.time();

    if(m_options.normal_stabilization)
      project(of_zero.loads, *m_options.normal_stabilization, result);
    else
      fit_with_chosen_stabilization(f, of_zero, result);
    for(int step = 0; step < m_options.refinement_steps; ++step)
      refine(f, result);
    const Residual left = residual(f, result);
    for(Eigen::Index k = 0; k < left.squares.size(); ++k)
      result.root_mean_square_errors.push_back(std::sqrt(left.squares[k] * (unit() / area())));

    result.assembly_seconds = m_assembly_seconds + load_seconds;
    result.setup_seconds = m_setup_seconds;
    result.solve_seconds =
        timer.time() - load_seconds - (m_assembly_seconds + m_setup_seconds - seconds_before);
    return result;
  }

  /// The function whose loads are given, \f$\int u\, b_i = \gamma_i\f$ in the least-squares sense,
  /// smoothed and stabilised as a fit is; without refinement. The stabilisation is 1e-4 unless it
  /// is given.
  /// \param loads \f$\gamma\f$: a row for each element of the finest level, a column for each
  /// component
  /// \return a fit without errors
  /// \throws Parameter_error if the number of rows does not fit, or if an entry is not finite
  Function_fit project(const Eigen::MatrixXd& loads) {
    Function_fit result;
    project(loads, m_options.normal_stabilization.value_or(internal::fit_stabilizations[0]),
            result);
    result.assembly_seconds = m_assembly_seconds;
    return result;
  }

private:
  using Residual = internal::Fit_residual;
  using Components = std::vector<Eigen::Index>;

  static Options checked(const Options& options) {
    const double w = options.smoothing_weight;
    if(!(w >= 0 && std::isfinite(w)))
      throw Parameter_error("smoothing_weight",
                            "is " + std::to_string(w) +
                                ", but must be a finite number that is not negative");
    if(options.refinement_steps < 0)
      throw Parameter_error("refinement_steps", "must not be negative");
    if(options.normal_stabilization)
      internal::checked_normal_stabilization(*options.normal_stabilization);
    return options;
  }

  /// Matrices and loads are taken in units of the squared cell width.
  double unit() const {
    const double h = m_space->octree().cell_width(m_space->depth());
    return h * h;
  }
  double area() const { return m_space->surface().area(); }

  template <class Function>
  Residual residual(const Function& f, const Function_fit& fit, bool with_gradients = false) const {
    return internal::fit_residual(*m_space, *m_integration, f, fit.coefficients, with_gradients);
  }

  /// the solver with this stabilisation
  const Poisson_solver& solver(double normal_stabilization) {
    for(const auto& [c, solver] : m_solvers)
      if(c == normal_stabilization)
        return solver;
    CGAL::Real_timer timer;
    timer.start();
    internal::System_matrices system = internal::assemble_system(
        *m_space, internal::coarsest_assembled_level(*m_space), *m_integration, 1 / unit(),
        normal_stabilization, m_options.smoothing_weight / unit());
    Sparse_matrix finest;
    finest.swap(system.matrices.back());
    system.matrices.pop_back();
    m_integrals = system.integrals / unit();
    Poisson_solver_options options = m_options.solver;
    if(!m_options.normal_stabilization &&
       normal_stabilization == internal::fit_stabilizations.back())
      options.maximum_iterations =
          (std::min)(options.maximum_iterations, internal::maximum_iterations_of_smallest);
    // A 1 = M 1, as for the screened Poisson problem with the weight 1.
    m_solvers.emplace_back(normal_stabilization,
                           internal::poisson_solver(*m_space, std::move(finest),
                                                    std::move(system.matrices), m_integrals, 1,
                                                    options));
    const Poisson_solver& result = m_solvers.back().second;
    m_setup_seconds += result.setup_seconds();
    m_assembly_seconds += timer.time() - result.setup_seconds();
    return result;
  }

  void project(const Eigen::MatrixXd& loads, double normal_stabilization, Function_fit& result) {
    static_cast<Solve_report&>(result) =
        solver(normal_stabilization).solve(loads / unit(), result.coefficients);
    result.normal_stabilizations.assign(result.relative_residuals.size(), normal_stabilization);
  }

  template <class Function>
  void fit_with_chosen_stabilization(const Function& f, const Residual& of_zero,
                                     Function_fit& result) {
    const Eigen::MatrixXd loads = of_zero.loads / unit();
    result.coefficients.setZero(loads.rows(), loads.cols());
    result.relative_residuals.assign(loads.cols(), 0.);
    result.normal_stabilizations.assign(loads.cols(), 0.);
    std::vector<int> iterations(loads.cols(), 0);
    std::array<Components, internal::fit_stabilizations.size()> to_be_fitted;
    to_be_fitted[0].resize(loads.cols());
    std::iota(to_be_fitted[0].begin(), to_be_fitted[0].end(), Eigen::Index(0));
    const std::size_t last = to_be_fitted.size() - 1;
    for(std::size_t i = 0; i <= last; ++i) {
      if(to_be_fitted[i].empty())
        continue;
      const double c = internal::fit_stabilizations[i];
      const Poisson_solver& solver = this->solver(c);
      solve_roughly(solver, loads, to_be_fitted[i], result, iterations);
      Components accepted;
      Residual left;
      if(i < last)
        left = residual(f, result, m_options.smoothing_weight > 0);
      for(Eigen::Index k : to_be_fitted[i]) {
        const double energy =
            i < last ? relative_stabilization_energy(solver, k, of_zero, left, result) : 0;
        if(i == last || energy <= small_energy(of_zero.squares[k], left.squares[k]))
          accepted.push_back(k);
        else
          to_be_fitted[energy > internal::large_stabilization_energy ? last : i + 1].push_back(k);
      }
      reduce_residuals(solver, loads, accepted, result, iterations);
      for(Eigen::Index k : accepted)
        result.normal_stabilizations[k] = c;
    }
    fit_again_what_did_not_converge(to_be_fitted[last], loads, result, iterations);
    result.iterations = *std::max_element(iterations.begin(), iterations.end());
    result.relative_residual =
        *std::max_element(result.relative_residuals.begin(), result.relative_residuals.end());
    result.converged = has_converged(result.relative_residual);
  }

  /// A residual is the product of those of two solves, and may be rounded up.
  bool has_converged(double relative_residual) const {
    return relative_residual <= m_options.solver.relative_tolerance * (1 + 1e-12);
  }

  /// \param components those that were fitted with the smallest stabilisation
  void fit_again_what_did_not_converge(const Components& components, const Eigen::MatrixXd& loads,
                                       Function_fit& result, std::vector<int>& iterations) {
    Components slow;
    for(Eigen::Index k : components)
      if(!has_converged(result.relative_residuals[k]))
        slow.push_back(k);
    if(slow.empty())
      return;
    const double c = internal::fit_stabilizations[internal::fit_stabilizations.size() - 2];
    const Poisson_solver& solver = this->solver(c);
    solve_roughly(solver, loads, slow, result, iterations);
    reduce_residuals(solver, loads, slow, result, iterations);
    for(Eigen::Index k : slow)
      result.normal_stabilizations[k] = c;
  }

  /// solves for some components, well enough to compare energies
  void solve_roughly(const Poisson_solver& solver, const Eigen::MatrixXd& loads,
                     const Components& components, Function_fit& result,
                     std::vector<int>& iterations) const {
    constexpr double rough_tolerance = 1e-2;
    Eigen::MatrixXd x;
    const Solve_report report =
        solver.solve(columns(loads, components), x,
                     (std::max)(m_options.solver.relative_tolerance, rough_tolerance));
    for(std::size_t i = 0; i < components.size(); ++i) {
      result.coefficients.col(components[i]) = x.col(static_cast<Eigen::Index>(i));
      result.relative_residuals[components[i]] = report.relative_residuals[i];
      iterations[components[i]] += report.iterations;
    }
  }

  /// Reduces the residuals of some components by one factor for all of them, so that the largest
  /// one meets the tolerance.
  void reduce_residuals(const Poisson_solver& solver, const Eigen::MatrixXd& loads,
                        const Components& components, Function_fit& result,
                        std::vector<int>& iterations) const {
    double largest = 0;
    for(Eigen::Index k : components)
      largest = (std::max)(largest, result.relative_residuals[k]);
    if(!(largest > m_options.solver.relative_tolerance))
      return;
    const Eigen::MatrixXd residual =
        columns(loads, components) - solver.upper_half().template selfadjointView<Eigen::Upper>() *
                                         columns(result.coefficients, components);
    Eigen::MatrixXd correction;
    const Solve_report report =
        solver.solve(residual, correction, m_options.solver.relative_tolerance / largest);
    for(std::size_t i = 0; i < components.size(); ++i) {
      result.coefficients.col(components[i]) += correction.col(static_cast<Eigen::Index>(i));
      result.relative_residuals[components[i]] *= report.relative_residuals[i];
      iterations[components[i]] += report.iterations;
    }
  }

  /// The energy of the stabilisation, \f$\eta^T A \eta - \int u^2 + w \lvert \nabla u \rvert^2\f$,
  /// over \f$\int (u - f)^2 + w \lvert \nabla u \rvert^2\f$; 0 if both are. The mean of \f$u\f$ is
  /// taken off first, to which the stabilisation is blind.
  double relative_stabilization_energy(const Poisson_solver& solver, Eigen::Index k,
                                       const Residual& of_zero, const Residual& left,
                                       const Function_fit& fit) const {
    const auto eta_k = fit.coefficients.col(k);
    const double mean = m_space->is_paper_space() ? 0 : m_integrals.dot(eta_k) / m_integrals.sum();
    const Eigen::VectorXd eta = eta_k.array() - mean;
    const Eigen::VectorXd mass_eta =
        (of_zero.loads.col(k) - left.loads.col(k)) / unit() - mean * m_integrals;
    const Eigen::VectorXd a_eta =
        solver.upper_half().template selfadjointView<Eigen::Upper>() * eta;
    const double smoothing = m_options.smoothing_weight / unit() * left.gradient_squares[k];
    const double stabilization = eta.dot(a_eta - mass_eta) - smoothing;
    return stabilization > 0 ? stabilization / (left.squares[k] + smoothing) : 0;
  }

  /// \param function_square,error_square integrals of the squares of a function and of its error
  static double small_energy(double function_square, double error_square) {
    return error_square > internal::squared_error_of_rough * function_square
               ? internal::small_energy_of_rough
               : internal::small_energy_of_smooth;
  }

  /// fits what is left, each component with its stabilisation
  template <class Function> void refine(const Function& f, Function_fit& result) const {
    const Residual left = residual(f, result);
    for(const auto& [c, solver] : m_solvers) {
      Components components;
      for(Eigen::Index k = 0; k < left.loads.cols(); ++k)
        if(result.normal_stabilizations[k] == c)
          components.push_back(k);
      if(components.empty())
        continue;
      Eigen::MatrixXd x;
      const Solve_report report = solver.solve(columns(left.loads, components) / unit(), x);
      for(std::size_t i = 0; i < components.size(); ++i)
        result.coefficients.col(components[i]) += x.col(static_cast<Eigen::Index>(i));
      result.converged = result.converged && report.converged;
    }
  }

  static Eigen::MatrixXd columns(const Eigen::MatrixXd& matrix, const Components& numbers) {
    Eigen::MatrixXd result(matrix.rows(), static_cast<Eigen::Index>(numbers.size()));
    for(std::size_t i = 0; i < numbers.size(); ++i)
      result.col(static_cast<Eigen::Index>(i)) = matrix.col(numbers[i]);
    return result;
  }

  const Spline_space_3* m_space;
  const SurfaceIntegration* m_integration;
  Options m_options;
  Eigen::VectorXd m_integrals;                             // in units of unit()
  std::deque<std::pair<double, Poisson_solver>> m_solvers; // with their stabilisation
  double m_assembly_seconds = 0, m_setup_seconds = 0;
};

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_FUNCTION_FITTER_H
