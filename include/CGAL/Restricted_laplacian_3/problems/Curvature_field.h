// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_CURVATURE_FIELD_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_CURVATURE_FIELD_H

#include <CGAL/Restricted_laplacian_3/foundation/compiled.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Progress.h>
#include <CGAL/Restricted_laplacian_3/foundation/parameters.h>
#include <CGAL/Restricted_laplacian_3/integration/Surface_integration.h>
#include <CGAL/Restricted_laplacian_3/problems/Function_fitter.h>
#include <CGAL/Restricted_laplacian_3/problems/stabilization.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_functions_3.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>
#include <CGAL/Restricted_laplacian_3/surface/Surface_location.h>

#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Fits
/// How `estimate_curvature()` works.
enum class Curvature_method {
  /// The derivative of a fit of normals that are given at the vertices and interpolated: the most
  /// accurate on smooth surfaces.
  normals,
  /// The same with the normals of the faces, which are constant on each face.
  face_normals,
  /// The Laplacian of the coordinates, in the weak form: the mean curvature only. Its integral over
  /// a region is that of the triangulation, whose curvature lives on the edges.
  coordinates
};

/// \ingroup PkgRestrictedLaplacian3Fits
/// The curvature of a surface at a point.
///
/// *Sign.* \f$\kappa\f$ is the derivative of the unit normal \f$n\f$ along a unit tangent vector
/// \f$t\f$, \f$\kappa = \langle \nabla_t n, t \rangle\f$: a sphere of radius \f$r\f$ has the
/// curvatures \f$+1 / r\f$ if its normals point outward, and \f$-1 / r\f$ if they point inward. The
/// Gaussian curvature does not depend on the orientation.
struct Surface_curvature {
  /// \f$H = (\kappa_1 + \kappa_2) / 2\f$, in units of 1 / length
  double mean = std::numeric_limits<double>::quiet_NaN();
  /// \f$K = \kappa_1 \kappa_2\f$, in units of 1 / area; NaN with `Curvature_method::coordinates`
  double gaussian = std::numeric_limits<double>::quiet_NaN();
  /// \f$\kappa_1 \ge \kappa_2\f$; NaN with `Curvature_method::coordinates`
  std::array<double, 2> principal_values = {std::numeric_limits<double>::quiet_NaN(),
                                            std::numeric_limits<double>::quiet_NaN()};
  /// unit tangent vectors, orthogonal to each other and to `normal`, each with either sign; the
  /// zero vectors with `Curvature_method::coordinates`
  std::array<Vector_3, 2> principal_directions = {Vector_3(0, 0, 0), Vector_3(0, 0, 0)};
  /// the fitted unit normal
  Vector_3 normal = Vector_3(0, 0, 0);
};

/// \ingroup PkgRestrictedLaplacian3Fits
/// The curvature of a surface as a function on it, see `estimate_curvature()`.
class Curvature_field {
public:
  /// \param space is copied, which costs nothing
  /// \param fit of normals, three components; or of normals and Laplacians of the coordinates, six
  Curvature_field(const Spline_space_3& space, const Function_fit& fit);

  /// the fitted functions: three components of the normal, not of unit length; with
  /// `Curvature_method::coordinates` followed by three of the Laplacian of the coordinates,
  /// \f$-2 H n\f$
  const Spline_functions_3& functions() const { return m_functions; }
  /// of the fit
  const Fit_report& report() const { return m_report; }

  /// the curvature at a location
  /// \throws Location_error if there is no such face, or if the location is not on the surface
  Surface_curvature operator()(const Surface_location& location) const {
    return at_locations(std::array<Surface_location, 1>{location}).front();
  }

  /// the curvatures at locations
  /// \param locations a range of `Surface_location`
  /// \throws Location_error if there is no such face, or if a location is not on the surface
  template <class LocationRange>
  std::vector<Surface_curvature> at_locations(const LocationRange& locations) const {
    return curvatures(m_functions.jets_at_locations(locations));
  }

  /// The curvatures at all vertices, in the order of `vertices(tm)`; NaN at vertices that have no
  /// face of positive area.
  std::vector<Surface_curvature> at_vertices() const;

private:
  std::vector<Surface_curvature> curvatures(const Spline_jets& jets) const;

  Spline_functions_3 m_functions;
  Fit_report m_report;
};

namespace internal {

/// The smoothing weight: waves about as long as cells are wide are smoothed away, and with them
/// most of the noise of a triangulation. It follows from the space alone: a weight that followed
/// from the faces would make the result depend on them. Nothing near boundaries, where the natural
/// condition would bend the normals, nor for points, whose normals come from no triangulation.
double curvature_smoothing_weight(const Spline_space_3& space);

template <class NamedParameters>
Function_fit_options curvature_options(const Spline_space_3& space, bool with_smoothing,
                                       const NamedParameters& np) {
  Function_fit_options options = np;
  if(!options.normal_stabilization)
    options.normal_stabilization = default_curvature_stabilization;
  if(!options.energy_tolerance)
    options.energy_tolerance = default_curvature_tolerance;
  if(with_smoothing)
    options.smoothing_weight = curvature_smoothing_weight(space);
  read_parameter(np, internal_np::smoothing_weight, options.smoothing_weight);
  options.refinement_steps = options.smoothing_weight > 0 ? 1 : 0;
  read_parameter(np, internal_np::refinement_steps, options.refinement_steps);
  return options;
}

/// Vertex normals interpolated linearly and renormalized: where they cancel, that of the face.
class Interpolated_normals {
public:
  explicit Interpolated_normals(std::vector<Vector_3> normals) : m_normals(std::move(normals)) {}

  Vector_3 operator()(const Surface_point& p) const {
    Vector_3 sum(0, 0, 0);
    for(int i = 0; i < 3; ++i)
      sum += p.barycentric[i] * m_normals[p.vertices[i]];
    const double length = std::sqrt(sum.squared_length());
    return length > smallest_length ? sum / length : p.normal;
  }

private:
  /// below, the direction is that of rounding errors
  static constexpr double smallest_length = 1e-8;
  std::vector<Vector_3> m_normals;
};

/// the curvature by the Laplacian of the coordinates, in the weak form
Function_fit fit_coordinate_laplacian(const Spline_space_3& space,
                                      const Function_fit_options& options,
                                      const Progress& progress);

/// the curvature by the derivative of the fit of a field of normals
Curvature_field curvature_of_field(const Spline_space_3& space,
                                   const Surface_function_view& normals,
                                   const Function_fit_options& options, const Progress& progress);

/// the same with the normals of the surface at the vertices, or of the faces
Curvature_field curvature_of_surface(const Spline_space_3& space, bool of_faces,
                                     const Function_fit_options& options, const Progress& progress);

} // namespace internal

} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/problems/Curvature_field_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_CURVATURE_FIELD_H
