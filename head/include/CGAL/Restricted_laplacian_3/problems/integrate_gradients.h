// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_INTEGRATE_GRADIENTS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_INTEGRATE_GRADIENTS_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/Progress.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parameters.h>
#include <CGAL/Restricted_laplacian_3/problems/shared/search_depth.h>
#include <CGAL/Restricted_laplacian_3/solvers/Multigrid_solver.h>
#include <CGAL/Restricted_laplacian_3/solvers/Solve_report.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>
#include <CGAL/Restricted_laplacian_3/surface/Surface_function_view.h>

#include <Eigen/Core>

#include <functional>
#include <optional>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Gradients
/// What `integrate_gradient_field()` did.
struct Gradient_report : Solve_report {
  /// \f$(\int \lvert \nabla u_k - v_k \rvert^2 / \mathrm{area})^{1/2}\f$ for each channel, in units
  /// of \f$v\f$: the part of the field that is not a gradient, or that the space does not resolve.
  /// Of the spline, without `details`; measured by a rule of three nodes, in the metrics of
  /// the integration.
  std::vector<double> root_mean_square_residuals;
  /// number of connected components on which the weight vanishes everywhere, if one is given
  int components_without_weight = 0;
  /// number of iterations for `details`
  int details_iterations = 0;
  /// wall-clock seconds: `details`
  double details_seconds = 0;
};

/// \ingroup PkgRestrictedLaplacian3Gradients
/// The functions whose gradients fit a vector field: their coefficients, to be evaluated by
/// `Spline_function_3` or `Spline_functions_3`.
struct Gradient_fit : Gradient_report {
  /// a row for each element of the finest level, a column for each channel
  Eigen::MatrixXd coefficients;
};

namespace internal {

/// the tolerance of `integrate_gradient_field()`
constexpr double default_gradient_tolerance = 1e-5;

} // namespace internal

/// \ingroup PkgRestrictedLaplacian3Options
/// What pulls the solution to given values: targets \f$g\f$, a weight, and the mean where there are
/// none.
struct Gradient_screening {
  /// \f$g\f$, a component for each channel
  std::optional<Surface_function_view> target;
  /// \f$\alpha > 0\f$, in units of 1 / area; without weights there are only the gradients
  std::optional<double> weight;
  /// \f$\alpha \ge 0\f$ as a function, in place of the number
  std::optional<Surface_function_view> weight_function;
  /// what is wanted of the means of the channels; empty if nothing is
  Eigen::VectorXd mean;

  /// whether there is a weight
  bool has_weight() const { return weight || weight_function; }
  /// 0 if none is given
  Eigen::VectorXd mean_or_zero(int channels) const;

  /// \throws Parameter_error if something does not fit a field with so many channels, or is not
  /// finite or positive
  void check(int channels) const;
};

/// \ingroup PkgRestrictedLaplacian3Options
/// The named parameters of `integrate_gradient_field()`. Functions are referred to, and have to
/// outlive it.
struct Gradient_options {
  /// what pulls the solution
  Gradient_screening screening;
  /// factor \f$c\f$ of the stabilization; without a value `default_stabilization()`
  std::optional<double> stabilization;
  /// of the linear system; without a value its tolerance is 1e-5
  Poisson_solver_options solver;
  /// is told which part of the work is done, from 0 to 1; if it returns `false`, the computation
  /// ends with an exception
  std::function<bool(double)> progress;
};

/// \ingroup PkgRestrictedLaplacian3Problems
/// Integrates a vector field in a space, as the template of this name does.
/// \param space the space that the solution is in
/// \param v the field
/// \param options what the named parameters of the template say
/// \throws Parameter_error as there
/// \throws Canceled if `progress` returned `false`
Gradient_fit integrate_gradient_field(const Spline_space_3& space, const Vector_field_view& v,
                                      const Gradient_options& options);

namespace internal {

/// the tolerance of the linear system
inline double tolerance_of(const Poisson_solver_options& options) {
  return options.tolerance.value_or(default_gradient_tolerance);
}

/// a fit, with what is needed to keep its means when details are added
struct Gradient_solution {
  Gradient_fit fit;
  Eigen::MatrixXd means;       // of the components of the matrix, a row for each
  std::vector<int> components; // of the elements
  std::vector<char> is_screened;
};

Gradient_solution integrate_gradients(const Spline_space_3& space, const Vector_field_view& v,
                                      const Gradient_options& options, const Progress& progress);

/// Integrates a field in deeper and deeper spaces.
/// \param space the first one, and then that of the solution
/// \param accuracy the estimated error that ends the search, or the memory of the spaces does
/// \param integrated called for each space, unless it is empty
Gradient_solution integrate_gradients_to_accuracy(Spline_space_3& space, const Vector_field_view& v,
                                                  const Gradient_options& options, double accuracy,
                                                  const Progress& progress,
                                                  const Integrated_space& integrated = {});

/// corrects the values of a solution at the vertices
/// \param tolerance as for the splines, or larger
/// \throws Input_error if the surface is a point set
void add_details(const Spline_space_3& space, const Vector_field_view& v,
                 const Gradient_screening& screening, double tolerance, int maximum_iterations,
                 Gradient_solution& solution, Eigen::MatrixXd& values);

} // namespace internal

} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/problems/integrate_gradients_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_INTEGRATE_GRADIENTS_H
