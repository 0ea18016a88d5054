// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_GEODESICS_GEODESIC_FUNCTION_H
#define CGAL_RESTRICTED_LAPLACIAN_3_GEODESICS_GEODESIC_FUNCTION_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>
#include <CGAL/Restricted_laplacian_3/geodesics/Geodesic_solver.h>
#include <CGAL/Restricted_laplacian_3/surface/Surface_function_view.h>
#include <CGAL/Restricted_laplacian_3/surface/Surface_location.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Distances
/// A line on a surface.
struct Geodesic_path {
  /// its parts, each in one face, from the first point to the last; sources may be made of them.
  /// None on a surface given by points, whose triangles only the solver knows.
  std::vector<Geodesic_sources::Segment> segments;
  /// its points, one more than segments; the last one is the first one again if it is closed
  std::vector<Point_3> points;
  /// in units of length
  double length = 0;
};

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

  /// Linear in the number of vertices, and nearly so in that of the sources.
  /// \param solver is copied, which costs nothing
  /// \param distances what it found
  /// \throws Parameter_error if they are not those of the vertices of its surface
  Geodesic_function(const Geodesic_solver& solver, Geodesic_distances distances);

  /// the surface
  const Triangulated_surface_3& surface() const;
  /// what the solver found
  const Geodesic_distances& distances() const;

  /// The distance at a location.
  /// \throws Location_error if there is no such face, or if the location is not in it
  double value(const Surface_location& location) const { return bounded(location).distance; }
  /// The gradient at a location. It jumps where rays from different sides meet.
  /// \throws Location_error as `value()`
  Vector_3 gradient(const Surface_location& location) const { return bounded(location).gradient; }
  /// the distance at a point of the surface
  double operator()(const Surface_point& point) const { return value(point); }

  /// The shortest path from a location to the nearest source. A search down the distance finds the
  /// faces that it leads through; then it is straightened, in these and around their vertices,
  /// until it is shortest among the paths close by (\ref RL_theory_distances). So its length is not
  /// less than the exact distance, and as a rule equal to it; of two paths about equally long it
  /// may be the other one. Takes time about proportional to the number of faces that it crosses.
  /// \throws Location_error as `value()`, and if no source is reached
  /// \throws Numerical_error if no path is found, which only surfaces made for that can cause
  Geodesic_path shortest_path(const Surface_location& from) const;

  /// The lines on which the distance has a value: closed, or from boundary to boundary, or to edges
  /// with more than two faces. They are straight in each face, between those points of its sides at
  /// which the distance has the value; what is smaller than a face is not seen. Linear in the
  /// number of faces.
  /// \param value of the distance, in units of length, larger than 0
  /// \throws Parameter_error if the value is not
  std::vector<Geodesic_path> isolines(double value) const;

  /// \cond
  // At many points, of which many in a row are in the same face: what a fit takes, whose gradients
  // are not shortened by the bounds that values have.
  void evaluate(const Surface_point* points, std::size_t number, Value* values) const;
  /// \endcond

private:
  Value bounded(const Surface_location& location) const;

  struct Impl;
  std::shared_ptr<const Impl> m_impl;
};

} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/geodesics/Geodesic_function_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_GEODESICS_GEODESIC_FUNCTION_H
