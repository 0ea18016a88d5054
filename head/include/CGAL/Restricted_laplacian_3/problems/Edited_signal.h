// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_EDITED_SIGNAL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_EDITED_SIGNAL_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/parameters.h>
#include <CGAL/Restricted_laplacian_3/solvers/Solve_report.h>

#include <Eigen/Core>

#include <functional>
#include <optional>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Problems
/// What smoothing, sharpening and editing make of a signal.
struct Edited_signal : Solve_report {
  /// a row for each vertex, a column for each component: for positions the moved vertices
  Eigen::MatrixXd values;
};

/// \ingroup PkgRestrictedLaplacian3Options
/// How surfaces and signals are smoothed and edited: the named parameters of `smooth_surface()`,
/// `sharpen_surface()` and `edit_surface()`.
struct Editing_options {
  /// of the linear systems, or the steps of the filter
  double tolerance = 1e-4;
  /// factor of the stabilization; without a value `default_stabilization()`
  std::optional<double> stabilization;
  /// creases whose normals turn by more than this angle are kept, in degrees; without a value none
  std::optional<double> crease_angle;
  /// how far editing follows curvature: `normal_metric()` with this number over
  /// \f$\sqrt\alpha\f$ as weight
  double anisotropic = 0;
  /// is told which part of the work is done, from 0 to 1; if it returns `false`, the computation
  /// ends with an exception
  std::function<bool(double)> progress;

  /// the defaults
  Editing_options() = default;
  /// what is among named parameters, and the defaults else
  template <class NamedParameters, internal::Require_named_parameters<NamedParameters> = 0>
  Editing_options(const NamedParameters& np) {
    internal::read_parameter(np, internal_np::tolerance, tolerance);
    internal::read_parameter(np, internal_np::stabilization, stabilization);
    internal::read_parameter(np, internal_np::crease_angle, crease_angle);
    internal::read_parameter(np, internal_np::anisotropic, anisotropic);
    internal::read_parameter(np, internal_np::progress, progress);
  }
};

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_EDITED_SIGNAL_H
