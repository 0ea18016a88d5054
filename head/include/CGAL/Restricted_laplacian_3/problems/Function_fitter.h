// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_FUNCTION_FITTER_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_FUNCTION_FITTER_H

#include <CGAL/Restricted_laplacian_3/foundation/Sparse_matrix.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Progress.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parameters.h>
#include <CGAL/Restricted_laplacian_3/integration/Surface_integration.h>
#include <CGAL/Restricted_laplacian_3/problems/Poisson_solver.h>
#include <CGAL/Restricted_laplacian_3/problems/shared/search_depth.h>
#include <CGAL/Restricted_laplacian_3/solvers/Multigrid_solver.h>
#include <CGAL/Restricted_laplacian_3/solvers/Solve_report.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>
#include <CGAL/Restricted_laplacian_3/surface/Surface_function_view.h>

#include <Eigen/Core>

#include <cmath>
#include <deque>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Fits
/// What `fit_function()` did. Without smoothing, `estimated_error` is measured: the largest root
/// mean square error of a component, relative to its deviation from its mean.
struct Fit_report : Solve_report {
  /// \f$(\int (u_k - f_k)^2 / \mathrm{area})^{1/2}\f$ of each component, in units of \f$f\f$
  std::vector<double> root_mean_square_errors;
  /// the factor \f$c\f$ of the stabilization
  double stabilization = 0;

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

namespace internal {

struct Fit_residual;

} // namespace internal

/// \ingroup PkgRestrictedLaplacian3Options
/// The named parameters of a `Function_fitter`.
struct Function_fit_options {
  /// the default of `tolerance`
  static constexpr double default_tolerance = 1e-8;

  /// weight \f$w \ge 0\f$ of \f$\int \lvert \nabla u \rvert^2\f$, in units of length^2
  double smoothing = 0;
  /// how often what the fit leaves of \f$f\f$ is fitted and added
  int refinements = 0;
  /// factor \f$c\f$ of the stabilization; without a value `default_fit_stabilization()`
  std::optional<double> stabilization;
  /// estimated error in the norm of the energy, over the square root of what is minimized; without
  /// a value `default_fit_tolerance()`
  std::optional<double> energy_tolerance;
  /// of the linear systems
  Poisson_solver_options solver;

  /// the defaults
  Function_fit_options() = default;
  /// what is among named parameters, and the defaults else
  template <class NamedParameters, internal::Require_named_parameters<NamedParameters> = 0>
  Function_fit_options(const NamedParameters& np) : solver(np) {
    internal::read_parameter(np, internal_np::smoothing, smoothing);
    internal::read_parameter(np, internal_np::refinements, refinements);
    internal::read_parameter(np, internal_np::stabilization, stabilization);
    internal::read_parameter(np, internal_np::energy_tolerance, energy_tolerance);
    solver.energy_tolerance = 0; // relative to the solution
  }
};

/// \ingroup PkgRestrictedLaplacian3Fits
/// Fits functions on a surface by splines: set up once, it fits any number of functions, each a
/// number or a vector at each point. The fit of \f$f\f$ is the function \f$u\f$ of the space that
/// minimizes, for each component,
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
/// (iterated Tikhonov regularization).
///
/// *Stabilization.* The mass matrix is close to singular, see `assemble_operators()`: combinations
/// of elements that vary along the normal only nearly vanish on the surface. The term \f$c\, h N\f$
/// is added to \f$M\f$, and \f$\frac{c}{h} N\f$ to \f$S\f$, with a very small factor:
/// `default_fit_stabilization()`.
///
/// *End of the iteration.* Such combinations make residuals that no iteration reduces soon, but
/// they hardly change the function. The iteration ends when its estimated error, in the norm of the
/// energy \f$ (\int e^2 + w \lvert \nabla e \rvert^2)^{1/2} \f$, is a tenth of the square root of
/// what \f$u\f$ minimizes (`energy_tolerance`): in a least-squares problem errors add as squares,
/// so the root mean square error is larger than the least possible one by half a percent, or a few
/// times that where the iteration is slow, and the estimate too small. For a
/// function of the space what is minimized vanishes, and the iteration goes on to the
/// `tolerance` of the residual, or an error of 1e-8 of \f$u\f$. With smoothing, from
/// \f$w = h^2 / 1000\f$ on, the residual alone counts unless `energy_tolerance` is given. The
/// estimate is described with `Solve_report::relative_energy_error`, which a fit reports, too,
/// relative to \f$u\f$.
///
/// The systems are solved by conjugate gradients with a multigrid preconditioner, a
/// `Poisson_solver`, for up to eight components at a time.
class Function_fitter {
  using Options = Function_fit_options;

public:
  /// of the residual, relative to the right-hand side
  static constexpr double default_tolerance = Options::default_tolerance;

  /// \param space is copied, which costs nothing
  /// \param options named parameters, or the options themselves:
  /// \cgalNamedParamsBegin
  ///   \named_of_fits
  ///   \named_concurrency_tag
  /// \cgalNamedParamsEnd
  /// \throws Parameter_error if an option is outside its domain
  Function_fitter(const Spline_space_3& space, const Options& options = Options());
  ~Function_fitter();
  /// takes the solvers over
  Function_fitter(Function_fitter&&) noexcept;
  /// takes the solvers over
  Function_fitter& operator=(Function_fitter&&) noexcept;

  /// the space, as given to the constructor
  const Spline_space_3& space() const { return m_space; }
  /// the values of the named parameters, as given to the constructor
  const Options& options() const { return m_options; }

  /// Fits a function. Solvers are set up when they are needed first, and kept: not to be called by
  /// several threads at once. Setup takes time and memory proportional to the number of triangles
  /// (or samples) plus the number of elements.
  /// \param f a function object that takes a `const Surface_point&` and returns a number, a
  /// `std::array` of numbers, a vector of Eigen of a fixed size, or a 3D vector or point of \cgal.
  /// Integrated as in `assemble_load()`.
  /// \param progress is told which part of the work is done, from 0 to 1; if it returns `false`,
  /// the computation ends with an exception
  /// \throws Parameter_error if a value of `f` is not finite
  /// \throws Canceled if `progress` returned `false`
  Function_fit fit(const Surface_function_view& f,
                   const std::function<bool(double)>& progress = {});

  /// The function whose loads are given, \f$\int u\, b_i = \gamma_i\f$ in the least-squares sense,
  /// smoothed and stabilized as a fit is; without refinement. The stabilization is
  /// `default_projection_stabilization` unless it is given, and the residual ends the iteration.
  /// \param loads \f$\gamma\f$: a row for each element of the finest level, a column for each
  /// component
  /// \param progress as above
  /// \return a fit without errors
  /// \throws Parameter_error if the number of rows does not fit, or if an entry is not finite
  /// \throws Canceled if `progress` returned `false`
  Function_fit project(const Eigen::MatrixXd& loads,
                       const std::function<bool(double)>& progress = {});

private:
  using Progress = internal::Progress;

  double unit() const;
  const Poisson_solver& solver(double stabilization, const Progress& progress, bool is_mass_needed);
  const Sparse_matrix& mass();
  double stabilization() const;
  double energy_tolerance() const;
  Solve_report fit_residual(const Progress& progress, internal::Fit_residual& residual,
                            Eigen::MatrixXd& coefficients);

  Spline_space_3 m_space;
  Options m_options;
  std::deque<std::pair<double, Poisson_solver>> m_solvers; // with their stabilization
  Sparse_matrix m_mass;                                    // upper half; empty until needed
  double m_assembly_seconds = 0, m_setup_seconds = 0;
};

namespace internal {

/// Fits a function in deeper and deeper spaces.
/// \param space the first one, and then that of the fit
/// \param accuracy the error that ends the search, or the memory of the spaces does
/// \param integrated called for each space, unless it is empty
Function_fit fit_function_to_accuracy(Spline_space_3& space, const Surface_function_view& f,
                                      const Function_fit_options& options, double accuracy,
                                      const Progress& progress,
                                      const Integrated_space& integrated = {});

} // namespace internal

} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/problems/Function_fitter_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_FUNCTION_FITTER_H
