// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_MAP_TO_SPHERE_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_MAP_TO_SPHERE_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parameters.h>
#include <CGAL/Restricted_laplacian_3/problems/Mean_curvature_flow.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>

#include <Eigen/Core>

#include <cstddef>
#include <functional>
#include <optional>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Options
/// How `map_to_sphere()` works: the named parameters of `spherical_parameterization()`.
struct Sphere_map_options {
  /// how far the moved surface may be from a sphere when the flow ends, see
  /// `Flow_report::sphere_deviation`
  double tolerance = 1e-3;
  /// the largest number of steps, each of a fiftieth of the area
  int maximum_iterations = 200;
  /// factor \f$c\f$ of the stabilization; without a value `default_stabilization()`
  std::optional<double> stabilization;
  /// is told which part of the work is done, from 0 to 1; if it returns `false`, the computation
  /// ends with an exception
  std::function<bool(double)> progress;

  /// the defaults
  Sphere_map_options() = default;
  /// what is among named parameters, and the defaults else
  template <class NamedParameters, internal::Require_named_parameters<NamedParameters> = 0>
  Sphere_map_options(const NamedParameters& np) {
    internal::read_parameter(np, internal_np::tolerance, tolerance);
    internal::read_parameter(np, internal_np::maximum_iterations, maximum_iterations);
    internal::read_parameter(np, internal_np::stabilization, stabilization);
    internal::read_parameter(np, internal_np::progress, progress);
  }
};

/// \ingroup PkgRestrictedLaplacian3Problems
/// What `spherical_parameterization()` found. `converged` says whether the flow ended at a sphere;
/// the iterations are its steps, and area, volume, angles and distortion are those of the triangles
/// on the unit sphere.
struct Sphere_map_report : Flow_report {
  /// faces that are turned over on the sphere, or flat there: the map is one to one if there is
  /// none
  std::size_t folded_faces = 0;
};

/// \ingroup PkgRestrictedLaplacian3Problems
/// A map to the unit sphere.
struct Sphere_map : Sphere_map_report {
  /// where vertices are on the sphere, a row for each; the north pole for those without a face of
  /// positive area
  Eigen::MatrixXd positions;
};

/// \ingroup PkgRestrictedLaplacian3Problems
/// Maps the surface of a space to the unit sphere, see `spherical_parameterization()`.
/// \param space of a mesh; is copied, which costs nothing
/// \param options named parameters, or the options themselves
/// \throws Parameter_error if an option is outside its domain
/// \throws Input_error the surface has a boundary, several components, holes or handles
/// \throws Canceled if `progress` returned `false`
Sphere_map map_to_sphere(const Spline_space_3& space, const Sphere_map_options& options = {});

} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/problems/map_to_sphere_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_MAP_TO_SPHERE_H
