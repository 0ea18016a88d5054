// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_GEODESIC_FUNCTION_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_GEODESIC_FUNCTION_H

#include <CGAL/Restricted_laplacian_3/foundation/compiled.h>
#include <CGAL/Restricted_laplacian_3/surface/Geodesic_solver.h>
#include <CGAL/Restricted_laplacian_3/surface/Surface_function_view.h>
#include <CGAL/Restricted_laplacian_3/surface/Surface_location.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>

#include <cstddef>
#include <memory>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Distances
/// Distances along a surface as a function on it, from those of the vertices and the directions of
/// their rays, triangle by triangle; see \ref RL_theory_distances. It is continuous up to its
/// error, and a model of `SurfaceFunction_3`. Evaluations take constant time.
class Geodesic_function {
public:
  /// \ingroup PkgRestrictedLaplacian3Distances
  /// A distance, and its gradient.
  struct Value {
    /// in units of length; infinite where no source is reached
    double distance;
    /// tangent to the face, of about unit length, pointing away from the source; zero at sources
    /// and where none is reached
    Vector_3 gradient;
  };

  /// Linear in the number of vertices.
  /// \param solver is copied, which costs nothing
  /// \param distances what it found
  /// \throws Parameter_error if they are not those of the vertices of its surface
  Geodesic_function(const Geodesic_solver& solver, Geodesic_distances distances);

  /// the surface
  const Triangulated_surface_3& surface() const { return m_solver.surface(); }
  /// what the solver found
  const Geodesic_distances& distances() const { return *m_distances; }

  /// The distance at a location.
  /// \throws Location_error if there is no such face, or if the location is not in it
  double value(const Surface_location& location) const { return bounded(location).distance; }
  /// The gradient at a location. It jumps where rays from different sides meet.
  /// \throws Location_error as `value()`
  Vector_3 gradient(const Surface_location& location) const { return bounded(location).gradient; }
  /// the distance at a point of the surface
  double operator()(const Surface_point& point) const { return value(point); }

  /// \cond
  // At many points, of which many in a row are in the same face: what a fit takes, whose gradients
  // are not shortened by the bounds that values have.
  void evaluate(const Surface_point* points, std::size_t number, Value* values) const;
  /// \endcond

private:
  Value bounded(const Surface_location& location) const;

  Geodesic_solver m_solver;
  std::shared_ptr<const Geodesic_distances> m_distances;
};

} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/surface/Geodesic_function_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_GEODESIC_FUNCTION_H
