// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_SPLINE_FUNCTION_3_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_SPLINE_FUNCTION_3_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parallel_for.h>
#include <CGAL/Restricted_laplacian_3/splines/B_spline_1.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>
#include <CGAL/Restricted_laplacian_3/splines/internal/spline_evaluation.h>

#include <Eigen/Core>

#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <iterator>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Functions
/// The function \f$u = \sum_i \eta_i b_i\f$ on the surface of a spline space. It is \f$C^1\f$ along
/// the surface as far as the surface is. An evaluation takes a binary search among the cells, plus
/// 27 products.
class Spline_function_3 {
public:
  /// \param space has to outlive this object
  /// \param coefficients \f$\eta\f$, one for each element of `level`
  /// \param level from 0, the coarsest, to the depth of the space
  /// \throws Parameter_error if the number of coefficients is not `space.dimension(level)`, or if
  /// `level` is not from 0 to depth
  Spline_function_3(const Spline_space_3& space, Eigen::VectorXd coefficients, int level)
    : m_space(&space), m_level(space.checked_level(level)),
      m_coefficients(std::move(coefficients)) {
    if(static_cast<std::size_t>(m_coefficients.size()) != space.dimension(level))
      throw Parameter_error("coefficients", "has " + std::to_string(m_coefficients.size()) +
                                                " entries, but the dimension of the space is " +
                                                std::to_string(space.dimension(level)));
  }
  /// The same on the finest level.
  Spline_function_3(const Spline_space_3& space, Eigen::VectorXd coefficients)
    : Spline_function_3(space, std::move(coefficients), space.depth()) {}

  /// the space, as given to the constructor
  const Spline_space_3& space() const { return *m_space; }
  /// the level whose elements the coefficients belong to
  int level() const { return m_level; }
  /// \f$\eta\f$
  const Eigen::VectorXd& coefficients() const { return m_coefficients; }

  /// \f$u\f$ at a location
  /// \throws Location_error if there is no such face, or if the location is not on the surface
  double value(const Surface_location& location) const {
    return value(internal::locate_on_surface(*m_space, m_level, location));
  }

  /// The surface gradient \f$\nabla_{\mathcal M} u = (I - n n^T) \nabla u\f$ at a location, where
  /// \f$n\f$ is the unit normal of its face; in units of \f$u\f$ over length.
  /// \throws Location_error as `value()`, and if the face is degenerate
  Vector_3 gradient(const Surface_location& location) const {
    const internal::Sheet_point p = internal::locate_on_surface(*m_space, m_level, location);
    if(surface().is_degenerate(location.face))
      throw Location_error("face " + std::to_string(location.face) +
                           " is degenerate: it has no tangent plane");
    std::array<std::array<double, 3>, 3> b, d;
    for(int axis = 0; axis < 3; ++axis) {
      b[axis] = B_spline_1::values(p.t[axis]);
      d[axis] = B_spline_1::derivatives(p.t[axis]);
    }
    using internal::element_values;
    const Vector_3 in_space = Vector_3(sum(p.sheet, element_values(d[0], b[1], b[2])),
                                       sum(p.sheet, element_values(b[0], d[1], b[2])),
                                       sum(p.sheet, element_values(b[0], b[1], d[2]))) /
                              m_space->octree().cell_width(m_level);
    const Vector_3& n = surface().normal(location.face);
    return in_space - (in_space * n) * n;
  }

  /// Values at all vertices, in the order of `vertices(tm)`: NaN at those that have no face of
  /// positive area, for they are not on the surface. On several threads if the space was made so.
  std::vector<double> values_at_vertices() const {
    const std::vector<internal::Sheet_point> points = internal::locate_vertices(*m_space, m_level);
    std::vector<double> values(points.size());
    constexpr std::size_t grain = 1024;
    internal::parallel_for(m_space->options().is_parallel, 0, points.size(), grain,
                           [&](std::size_t begin, std::size_t end) {
                             for(std::size_t v = begin; v < end; ++v)
                               values[v] = value(points[v]);
                           });
    return values;
  }

private:
  const Triangulated_surface_3& surface() const { return m_space->surface(); }

  double value(const internal::Sheet_point& p) const {
    return p.sheet == internal::Sheet_point::not_on_surface
               ? std::numeric_limits<double>::quiet_NaN()
               : sum(p.sheet, internal::element_values(p.t));
  }

  double sum(std::size_t sheet, const std::array<double, 27>& values) const {
    const Cell_elements& elements = m_space->elements(m_level, sheet);
    double result = 0;
    for(int i = 0; i < 27; ++i)
      if(elements[i] != Spline_space_3::no_element)
        result += values[i] * m_coefficients[elements[i]];
    return result;
  }

  const Spline_space_3* m_space;
  int m_level;
  Eigen::VectorXd m_coefficients;
};

/// \ingroup PkgRestrictedLaplacian3Functions
/// Writes the values of a function at all vertices into a property map: NaN at vertices that have
/// no face of positive area.
/// \param u the function
/// \param tm the mesh that the space of `u` was made from
/// \param map a model of `WritablePropertyMap` with the vertex descriptor as key and a number type
/// as value
template <class FaceGraph, class VertexMap>
void evaluate_at_vertices(const Spline_function_3& u, const FaceGraph& tm, VertexMap map) {
  using Value = typename boost::property_traits<VertexMap>::value_type;
  const std::vector<double> values = u.values_at_vertices();
  const auto range = vertices(tm);
  if(static_cast<std::size_t>(std::distance(range.begin(), range.end())) != values.size())
    throw Parameter_error("tm", "is not the mesh that the space was made from");
  std::size_t i = 0;
  for(auto v : range)
    put(map, v, static_cast<Value>(values[i++]));
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_SPLINE_FUNCTION_3_H
