// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_FLOW_REPORT_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_FLOW_REPORT_H

#include <CGAL/Restricted_laplacian_3/solvers/Solve_report.h>

#include <string>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Problems
/// What a step of a `Mean_curvature_flow` did: of the linear systems, and of the triangles whose
/// corners are the moved vertices.
struct Flow_report : Solve_report {
  /// since the beginning, in units of squared length
  double time = 0;
  /// of the triangles
  double area = 0;
  /// inside of the triangles, signed; 0 for an open surface
  double volume = 0;
  /// in degrees
  double smallest_angle = 0;
  /// \f$(\sigma_1 / \sigma_2 + \sigma_2 / \sigma_1) / 2\f$ of the singular values of the map from
  /// the first triangles to the moved ones: its mean over the first surface; 1 if the map is
  /// conformal
  double mean_distortion = 1;
  /// the largest one
  double largest_distortion = 1;
  /// how far the surface is from a sphere: the mean over it of the deviation of the distance from
  /// its centroid, relative to the mean of this distance
  double sphere_deviation = 0;
  /// why the flow has ended: the surface remains that before the step; empty if it can go on
  std::string collapse;
};

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_FLOW_REPORT_H
