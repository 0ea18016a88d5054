// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_SURFACE_EDITOR_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_SURFACE_EDITOR_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>
#include <CGAL/Restricted_laplacian_3/problems/Edited_signal.h>
#include <CGAL/Restricted_laplacian_3/problems/Poisson_solver.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>
#include <CGAL/Restricted_laplacian_3/surface/Surface_function_view.h>

#include <Eigen/Core>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Problems
/// Edits the positions of a surface, or another signal \f$x\f$ at its vertices, by its gradient:
/// the result \f$u\f$ minimizes
///
/// \f[ \int_{\mathcal M} \lvert \nabla u - \beta \nabla x \rvert^2
///      + \alpha \lvert u - x \rvert^2 \f]
/// \cgalCite{CK11}. Waves of the length \f$\lambda\f$ are multiplied by
/// \f$(\alpha + \beta k^2) / (\alpha + k^2)\f$ with \f$k = 2 \pi / \lambda\f$: what is much longer
/// than \f$2 \pi / \sqrt\alpha\f$ remains, what is much shorter is multiplied by \f$\beta\f$. So
/// \f$\beta = 0\f$ smooths, \f$\beta = 1\f$ changes nothing, and \f$\beta = 2\f$ doubles details.
///
/// Splines carry what is larger than their cells. What is smaller is multiplied by \f$\beta\f$, as
/// the formula has it in the limit. With a material \f$\lvert \cdot \rvert^2\f$ is measured by
/// \f$D\f$ and \f$\rho\f$, see `normal_metric()`.
class Surface_editor {
public:
  /// Assembles, and solves two systems for each component.
  /// \param space of a surface of triangles; is copied, which costs nothing
  /// \param alpha \f$\alpha\f$, positive, in units of 1 / area
  /// \param options named parameters, or the options themselves:
  /// \cgalNamedParamsBegin
  ///   \named_tolerance{`1e-4`, of the linear systems}
  ///   \named_usual_stabilization
  /// \cgalNamedParamsEnd
  /// \param signal \f$x\f$: a row for each vertex, a column for each component; if it is empty, the
  /// positions
  /// \throws Parameter_error if something is outside its domain
  Surface_editor(const Spline_space_3& space, double alpha, const Editing_options& options = {},
                 const Eigen::MatrixXd& signal = {});

  /// The result for a number \f$\beta\f$. No system has to be solved.
  /// \throws Parameter_error if it is not finite
  Edited_signal edit(double gradient_scale) const;

  /// The result for a function \f$\beta\f$: one system for each component.
  /// \param gradient_scale a function object that takes a `const Surface_point&` and returns a
  /// number
  /// \throws Parameter_error if a value is not finite; names the face
  Edited_signal edit(const Surface_function_view& gradient_scale) const;

  /// the space
  const Spline_space_3& space() const { return m_space; }

private:
  Eigen::MatrixXd solve(const Eigen::MatrixXd& loads, Solve_report& report) const;

  Spline_space_3 m_space;
  Eigen::MatrixXd m_signal, m_gradient_loads;
  Poisson_solver m_solver;
  // the results for 0, at the vertices, and for 1 as splines
  Eigen::MatrixXd m_smooth, m_same;
  Solve_report m_setup;
};

namespace internal {

/// The space with the metric that options ask for: with `anisotropic` \f$F\f$ `normal_metric()`
/// with the weight \f$F / \sqrt\alpha\f$.
Spline_space_3 space_to_edit(const Spline_space_3& space, double alpha,
                             const Editing_options& options);

} // namespace internal

} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/problems/Surface_editor_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_SURFACE_EDITOR_H
