// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_GEODESIC_FITTER_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_GEODESIC_FITTER_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parameters.h>
#include <CGAL/Restricted_laplacian_3/geodesics/Geodesic_function.h>
#include <CGAL/Restricted_laplacian_3/problems/Poisson_solver.h>
#include <CGAL/Restricted_laplacian_3/solvers/Solve_report.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_function_3.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>
#include <CGAL/Restricted_laplacian_3/surface/Surface_location.h>

#include <functional>
#include <optional>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Distances
/// A spline that fits distances along a surface: smooth where the distance is, across edges, too.
/// Within three cells of a source, where the distance has a kink, it is the `Geodesic_function`
/// that was fitted, and up to four cells both are blended. A model of `SurfaceFunction_3`.
class Geodesic_spline {
public:
  /// \param function what was fitted
  /// \param spline the fit
  /// \param report of the solver
  Geodesic_spline(Geodesic_function function, Spline_function_3 spline, Solve_report report);

  /// The distance at a location; infinite where no source is reached.
  /// \throws Location_error if there is no such face, or if the location is not in it or not on the
  /// surface
  double value(const Surface_location& location) const;
  /// The gradient of `value()`, tangent to the face; zero where no source is reached. Where rays
  /// from different sides meet it changes within about two cells.
  /// \throws Location_error as `value()`, and if the face is degenerate
  Vector_3 gradient(const Surface_location& location) const;
  /// the distance at a point of the surface
  double operator()(const Surface_point& point) const { return value(point); }

  /// what was fitted
  const Geodesic_function& function() const { return m_function; }
  /// the fit alone; of no use near sources, and 0 where none is reached
  const Spline_function_3& spline() const { return m_spline; }
  /// of the solver
  const Solve_report& report() const { return m_report; }

private:
  struct Weight {
    double value, derivative; // by the distance
  };
  Weight weight_of_function(double distance) const;

  Geodesic_function m_function;
  Spline_function_3 m_spline;
  Solve_report m_report;
};

/// \ingroup PkgRestrictedLaplacian3Options
/// The named parameters of a `Geodesic_fitter`.
struct Geodesic_fit_options {
  /// factor \f$c\f$ of the stabilization; without a value `default_stabilization()`
  std::optional<double> stabilization;
  /// of the linear system; without a value its tolerance is 1e-4
  Poisson_solver_options solver;

  /// the defaults
  Geodesic_fit_options() = default;
  /// what is among named parameters, and the defaults else
  template <class NamedParameters, internal::Require_named_parameters<NamedParameters> = 0>
  Geodesic_fit_options(const NamedParameters& np) : solver(np) {
    internal::read_parameter(np, internal_np::stabilization, stabilization);
  }
};

/// \ingroup PkgRestrictedLaplacian3Distances
/// Makes splines of distances along a surface: set up once, it fits any number of them. The fit of
/// a distance \f$d\f$ with the gradient \f$g\f$, triangle by triangle, is the function \f$u\f$ of
/// the space that minimizes
/// \f[ \int_{\mathcal M} \lvert \nabla u - g \rvert^2 + \alpha \int_{\mathcal M} (u - d)^2, \qquad
///     (S + \alpha M)\, \eta = \gamma, \qquad
///     \gamma_i = \int_{\mathcal M} g \cdot \nabla b_i + \alpha \int_{\mathcal M} d\, b_i, \f]
/// with \f$\alpha = 1 / (20 h^2)\f$ and the width \f$h\f$ of the finest cells. Setup takes time and
/// memory proportional to the number of triangles plus the number of elements, a fit a part of
/// that.
class Geodesic_fitter {
public:
  /// of the residual, relative to the right-hand side
  static constexpr double default_tolerance = 1e-4;

  /// \param space is copied, which costs nothing
  /// \param options named parameters, or the options themselves:
  /// \cgalNamedParamsBegin
  ///   \named_usual_stabilization
  ///   \named_of_solver{`1e-4`}
  ///   \named_concurrency_tag
  /// \cgalNamedParamsEnd
  /// \throws Parameter_error if an option is outside its domain
  explicit Geodesic_fitter(const Spline_space_3& space, const Geodesic_fit_options& options = {});

  /// the space, as given to the constructor
  const Spline_space_3& space() const { return m_space; }

  /// Fits a distance. May be called by several threads at once.
  /// \param d distances on the surface of the space
  /// \param progress is told which part of the work is done, from 0 to 1; if it returns `false`,
  /// the computation ends with an exception
  /// \throws Parameter_error if `d` is of another surface
  /// \throws Canceled if `progress` returned `false`
  Geodesic_spline fit(const Geodesic_function& d,
                      const std::function<bool(double)>& progress = {}) const;

private:
  Spline_space_3 m_space;
  Poisson_solver m_solver;
};

} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/problems/Geodesic_fitter_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_GEODESIC_FITTER_H
