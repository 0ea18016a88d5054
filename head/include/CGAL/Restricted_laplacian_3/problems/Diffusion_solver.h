// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_DIFFUSION_SOLVER_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_DIFFUSION_SOLVER_H

#include <CGAL/Restricted_laplacian_3/assembly/Dirichlet_boundary.h>
#include <CGAL/Restricted_laplacian_3/foundation/Sparse_matrix.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parameters.h>
#include <CGAL/Restricted_laplacian_3/problems/Poisson_solver.h>
#include <CGAL/Restricted_laplacian_3/problems/shared/search_depth.h>
#include <CGAL/Restricted_laplacian_3/solvers/Solve_report.h>
#include <CGAL/Restricted_laplacian_3/spectra/shared/Factorized_matrix.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>
#include <CGAL/Restricted_laplacian_3/surface/Surface_function_view.h>

#include <Eigen/Core>

#include <functional>
#include <optional>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Problems
/// The time after which diffusion has spread a point to a width,
/// \f$t = w^2 / (16 \ln 2)\f$: on a plane, and with \f$D = \rho = 1\f$, it is a Gaussian with the
/// standard deviation \f$\sigma = \sqrt{2 t}\f$ then, whose full width at half maximum is
/// \f$w = \sqrt{8 \ln 2}\, \sigma\f$.
/// \param width \f$w\f$, a length, not negative
/// \return in units of squared length
double diffusion_time(double width);

/// \ingroup PkgRestrictedLaplacian3Options
/// How a `Diffusion_solver` works: the named parameters of its constructor.
struct Diffusion_options {
  /// largest error of the steps in time, relative to what differs from the mean
  static constexpr double default_tolerance = 1e-4;

  /// without a value `default_tolerance`
  std::optional<double> tolerance;
  /// factor \f$c\f$ of the stabilization; without a value `default_stabilization()`
  std::optional<double> stabilization;
  /// largest number of linear systems for each function
  int maximum_iterations = 100;
  /// whether the matrix is factorized, which takes more memory, instead of multigrid; without a
  /// value up to 150,000 unknowns, or 50,000 without CHOLMOD
  std::optional<bool> factorize;

  /// the defaults
  Diffusion_options() = default;
  /// what is among named parameters, and the defaults else
  template <class NamedParameters, internal::Require_named_parameters<NamedParameters> = 0>
  Diffusion_options(const NamedParameters& np) {
    internal::read_parameter(np, internal_np::tolerance, tolerance);
    internal::read_parameter(np, internal_np::stabilization, stabilization);
    internal::read_parameter(np, internal_np::maximum_iterations, maximum_iterations);
  }
};

/// \ingroup PkgRestrictedLaplacian3Problems
/// What diffusion makes of functions: their coefficients, to be evaluated by `Spline_functions_3`.
struct Diffused_functions : Solve_report {
  /// a column for each function
  Eigen::MatrixXd coefficients;
};

/// \ingroup PkgRestrictedLaplacian3Problems
/// Solves \f$\partial_t u = \Delta_{\mathcal M} u + g\f$ up to one time, for any number of initial
/// functions; with a material \f$\rho\, \partial_t u = \mathrm{div}(D\, \nabla u) + \rho g\f$.
///
/// There are no steps in time. \f$u(t) = e^{-t A}\, u(0)\f$ with \f$A = M^{-1} S\f$ is found in the
/// Krylov space of \f$(M + \gamma S)^{-1} M\f$ with \f$\gamma = t / 4\f$, by a Lanczos iteration:
/// the exponential function of the small matrix that it makes of \f$A\f$ \cgalCite{EH06}. Each
/// vector takes one screened Poisson problem, all of them with one Cholesky factor, or in large
/// spaces with one multigrid hierarchy. \f$5 + 3 n\f$ of them, or fewer, give \f$n\f$ digits,
/// however rough the function is and however many steps an explicit method would take. The
/// iteration ends when the last vector changes the result by less than the tolerance.
///
/// *Means.* Unless values are prescribed, the mean over each connected component of the surface,
/// with the density as weight, is kept up to rounding. What the tolerance is relative to is the
/// rest.
///
/// *Boundaries* have the natural condition \f$\partial_\nu u = 0\f$, unless values are prescribed.
class Diffusion_solver {
public:
  /// Assembles and sets up.
  /// \param space is copied, which costs nothing
  /// \param time \f$t\f$, positive, in units of squared length
  /// \param options named parameters, or the options themselves:
  /// \cgalNamedParamsBegin
  ///   \named_tolerance{`1e-4`, of the functions, without their means}
  ///   \named_usual_stabilization
  ///   \named_maximum_iterations{`100` linear systems}
  /// \cgalNamedParamsEnd
  /// \param boundary_values what \f$u\f$ is along the whole boundary, at all times; needed until
  /// the constructor returns; a null pointer: nothing is prescribed
  /// \throws Parameter_error if something is outside its domain
  Diffusion_solver(const Spline_space_3& space, double time, const Diffusion_options& options = {},
                   const Surface_function_view* boundary_values = nullptr);

  /// What functions become.
  /// \param initial \f$u(0)\f$: a function object that takes a `const Surface_point&` and returns a
  /// number, a `std::array` of numbers, a vector of Eigen of a fixed size, or a 3D vector or point
  /// of \cgal
  /// \param source \f$g\f$, which does not change in time, with as many components; a null pointer:
  /// 0
  /// \param progress is told which part of the work is done, from 0 to 1; if it returns `false`,
  /// the computation ends with an exception
  /// \throws Parameter_error if a value is not finite; names the face
  /// \throws Canceled if `progress` returned `false`
  Diffused_functions diffuse(const Surface_function_view& initial,
                             const Surface_function_view* source = nullptr,
                             const std::function<bool(double)>& progress = {}) const;

  /// The same for functions given by \f$\int \rho\, u(0)\, b_i\f$, and \f$\int \rho\, g\, b_i\f$ or
  /// an empty matrix: a row for each element, a column for each function.
  Diffused_functions diffuse_loads(const Eigen::MatrixXd& initial, const Eigen::MatrixXd& source,
                                   const std::function<bool(double)>& progress = {}) const;

  /// \cond
  // What a filter of low pass makes of functions, f(A) with f = 1 / (1 + (lambda / alpha)^2) and
  // alpha = 4 / t. They are given by their loads and those of their gradients, the integrals of
  // <grad x, grad b_i>, and by what of these is due to the boundary; f(0) = 1, so means remain.
  Diffused_functions low_pass(const Eigen::MatrixXd& loads, const Eigen::MatrixXd& gradient_loads,
                              const Eigen::MatrixXd& boundary_loads,
                              const std::function<bool(double)>& progress = {}) const;
  /// \endcond

  /// \f$M\f$ times coefficients: loads of what was found, to go on from there
  Eigen::MatrixXd loads_of(const Eigen::MatrixXd& coefficients) const;

  /// the space
  const Spline_space_3& space() const { return m_space; }
  /// \f$t\f$
  double time() const { return m_time; }
  /// wall-clock seconds that matrices and hierarchy took
  double setup_seconds() const { return m_setup_seconds; }

private:
  class Krylov_spaces;

  /// sets up the solver of \f$(S + M / \gamma)\, x = b\f$
  void set_up(const Diffusion_options& options, const Dirichlet_boundary* boundary);
  /// solves it for each column, and reports how
  Eigen::MatrixXd solve(const Eigen::MatrixXd& b, Solve_report& report) const;
  /// of many functions: more take more memory
  Eigen::Index functions_at_once() const { return m_factor ? 16 : 8; }
  /// calls `body(k)` for the columns of matrices, on several threads if the space is so
  template <class Body> void for_each_column(std::size_t number, const Body& body) const;
  /// the means over the components of functions given by their loads
  Eigen::MatrixXd means_of(const Eigen::MatrixXd& loads) const;
  /// adds `sign` times `factors`, numbers of the elements, times the value of each component
  void add_constants(const Eigen::MatrixXd& of_components, double sign,
                     const Eigen::VectorXd& factors, Eigen::MatrixXd& to) const;

  Spline_space_3 m_space;
  double m_time, m_tolerance;
  int m_most_vectors;
  Sparse_matrix m_mass; // its upper half
  Eigen::VectorXd m_integrals, m_boundary_load;
  std::vector<int> m_component; // of each element
  int m_number_of_components = 0;
  double m_setup_seconds = 0;
  // one of both
  std::optional<Poisson_solver> m_multigrid;
  std::optional<internal::Factorized_matrix> m_factor;
};

namespace internal {

/// What is diffused on a surface, and how. Functions are referred to, and have to outlive it.
struct Diffusion_problem {
  Surface_function_view initial;
  double time;
  std::optional<Surface_function_view> source, boundary_values;
  Diffusion_options options;
  std::function<bool(double)> progress;
};

Diffused_functions diffuse_in_space(const Spline_space_3& space, const Diffusion_problem& problem);

/// The same in deeper and deeper spaces.
/// \param space the first one, and then that of the result
/// \param accuracy the estimated error that ends the search
/// \param integrated called for each space, unless it is empty
Diffused_functions diffuse_to_accuracy(Spline_space_3& space, const Diffusion_problem& problem,
                                       double accuracy, const Integrated_space& integrated = {});

} // namespace internal

} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/problems/Diffusion_solver_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_DIFFUSION_SOLVER_H
