// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_SPLINE_FUNCTION_3_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_SPLINE_FUNCTION_3_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>
#include <CGAL/Restricted_laplacian_3/input/shared/Surface_source.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>

#include <Eigen/Core>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <iterator>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {
struct Sheet_point;
} // namespace internal

/// \ingroup PkgRestrictedLaplacian3Functions
/// The function \f$u = \sum_i \eta_i b_i\f$ on the surface of a spline space. It is \f$C^1\f$ along
/// the surface as far as the surface is. An evaluation takes a binary search among the cells, plus
/// 27 products.
class Spline_function_3 {
public:
  /// \param space is copied, which costs nothing
  /// \param coefficients \f$\eta\f$, one for each element of `level`
  /// \param level from 0, the coarsest, to the depth of the space
  /// \throws Parameter_error if the number of coefficients is not `space.dimension(level)`, or if
  /// `level` is not from 0 to depth
  Spline_function_3(const Spline_space_3& space, Eigen::VectorXd coefficients, int level);
  /// The same on the finest level.
  Spline_function_3(const Spline_space_3& space, Eigen::VectorXd coefficients);

  /// the space, as given to the constructor
  const Spline_space_3& space() const { return m_space; }
  /// the level whose elements the coefficients belong to
  int level() const { return m_level; }
  /// \f$\eta\f$
  const Eigen::VectorXd& coefficients() const { return m_coefficients; }

  /// \f$u\f$ at a location
  /// \throws Location_error if there is no such face, or if the location is not on the surface
  double value(const Surface_location& location) const;

  /// The surface gradient \f$\nabla_{\mathcal M} u = (I - n n^T) \nabla u\f$ at a location, where
  /// \f$n\f$ is the unit normal of its face; in units of \f$u\f$ over length.
  /// \throws Location_error as `value()`, and if the face is degenerate
  Vector_3 gradient(const Surface_location& location) const;

  /// Values at all vertices, in the order of `vertices(tm)`: NaN at those that have no face of
  /// positive area, for they are not on the surface. On several threads if the space was made so.
  std::vector<double> values_at_vertices() const;

private:
  const Triangulated_surface_3& surface() const { return m_space.surface(); }

  double value(const internal::Sheet_point& p) const;

  Spline_space_3 m_space;
  int m_level;
  Eigen::VectorXd m_coefficients;
};

/// \cond SKIP_IN_MANUAL
/// \ingroup PkgRestrictedLaplacian3Functions
/// Writes the values of a function at all vertices into a property map: NaN at vertices that have
/// no face of positive area.
/// \param u the function
/// \tparam Surface a model of `RestrictedSurface_3`
/// \param surface what the space of `u` was made from
/// \param map a model of `WritablePropertyMap` with vertices as keys and a number type as value
template <class Surface, class VertexMap>
void evaluate_at_vertices(const Spline_function_3& u, const Surface& surface, VertexMap map) {
  using Value = typename boost::property_traits<VertexMap>::value_type;
  const std::vector<double> values = u.values_at_vertices();
  const auto source = internal::surface_source(surface);
  std::size_t size = 0;
  source.for_each_vertex([&](std::size_t, const auto&) { ++size; });
  if(size != values.size())
    throw Parameter_error("surface", "is not what the space was made from");
  source.for_each_vertex([&](std::size_t i, const auto& v) {
    internal::put_value_at(map, v, static_cast<Value>(values[i]));
  });
}
/// \endcond

} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/splines/Spline_function_3_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_SPLINE_FUNCTION_3_H
