// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_SPLINE_FUNCTIONS_3_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_SPLINE_FUNCTIONS_3_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parallel_for.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>
#include <CGAL/Restricted_laplacian_3/splines/internal/spline_evaluation.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Functions
/// Values and derivatives of several functions at several points: a row for each point, a column
/// for each function.
struct Spline_jets {
  /// values of the functions
  Eigen::MatrixXd values;
  /// derivatives along \f$x\f$, \f$y\f$ and \f$z\f$, in units of the function over length. They
  /// are those of the splines in space: the part along a tangent plane of the surface is that of
  /// the surface gradient, the part along the normal has no meaning on the surface.
  std::array<Eigen::MatrixXd, 3> derivatives;
};

/// \ingroup PkgRestrictedLaplacian3Functions
/// Several functions \f$u_k = \sum_i H_{ik} b_i\f$ on the surface of a spline space, for example
/// eigenfunctions, the columns of `Eigenpairs::vectors`. They are evaluated together: the point is
/// located, and the 27 elements are evaluated there, once for all of them. Each value is that of a
/// `Spline_function_3`, to the last bit unless the program is compiled for a processor with fused
/// multiplication and addition.
///
/// \f$N\f$ points and \f$K\f$ functions take \f$N\f$ binary searches among the cells plus
/// \f$27 N K\f$ products, on several threads if the space was made so
/// (`Spline_space_options::is_parallel`).
class Spline_functions_3 {
public:
  /// \param space has to outlive this object
  /// \param coefficients \f$H\f$: a row for each element of `level`, a column for each function;
  /// copied
  /// \param level from 0, the coarsest, to the depth of the space
  /// \throws Parameter_error if the number of rows is not `space.dimension(level)`, or if `level`
  /// is not from 0 to depth
  Spline_functions_3(const Spline_space_3& space,
                     const Eigen::Ref<const Eigen::MatrixXd>& coefficients, int level)
    : m_space(&space), m_level(space.checked_level(level)) {
    if(static_cast<std::size_t>(coefficients.rows()) != space.dimension(level))
      throw Parameter_error("coefficients", "has " + std::to_string(coefficients.rows()) +
                                                " rows, but the dimension of the space is " +
                                                std::to_string(space.dimension(level)));
    m_coefficients = coefficients.transpose();
  }
  /// The same on the finest level.
  Spline_functions_3(const Spline_space_3& space,
                     const Eigen::Ref<const Eigen::MatrixXd>& coefficients)
    : Spline_functions_3(space, coefficients, space.depth()) {}

  /// the space, as given to the constructor
  const Spline_space_3& space() const { return *m_space; }
  /// the level whose elements the coefficients belong to
  int level() const { return m_level; }
  /// \f$K\f$
  std::size_t number_of_functions() const {
    return static_cast<std::size_t>(m_coefficients.rows());
  }

  /// Values at all vertices: a row for each, in the order of `vertices(tm)`, and a column for each
  /// function; NaN at vertices that have no face of positive area, for they are not on the surface.
  Eigen::MatrixXd values_at_vertices() const {
    const std::vector<internal::Sheet_point> points = internal::locate_vertices(*m_space, m_level);
    return values(points.size(), [&](std::size_t i) { return points[i]; });
  }

  /// Values at locations: a row for each, a column for each function.
  /// \param locations a range of `Surface_location`, for example those of `sample_surface()`
  /// \throws Location_error if there is no such face, or if a location is not on the surface
  template <class LocationRange>
  Eigen::MatrixXd values_at_locations(const LocationRange& locations) const {
    const std::vector<Surface_location> copy(std::begin(locations), std::end(locations));
    return values(copy.size(), [&](std::size_t i) {
      return internal::locate_on_surface(*m_space, m_level, copy[i]);
    });
  }

  /// Values and derivatives at all vertices, in the order of `vertices(tm)`; NaN at vertices that
  /// have no face of positive area.
  Spline_jets jets_at_vertices() const {
    const std::vector<internal::Sheet_point> points = internal::locate_vertices(*m_space, m_level);
    return jets(points.size(), [&](std::size_t i) { return points[i]; });
  }

  /// Values and derivatives at locations.
  /// \param locations a range of `Surface_location`
  /// \throws Location_error if there is no such face, or if a location is not on the surface
  template <class LocationRange>
  Spline_jets jets_at_locations(const LocationRange& locations) const {
    const std::vector<Surface_location> copy(std::begin(locations), std::end(locations));
    return jets(copy.size(), [&](std::size_t i) {
      return internal::locate_on_surface(*m_space, m_level, copy[i]);
    });
  }

private:
  using Index = Eigen::Index;

  template <class PointOf> Spline_jets jets(std::size_t number, PointOf&& point_of) const {
    const double width = m_space->octree().cell_width(m_level);
    Spline_jets result;
    result.values = values(number, point_of);
    for(int axis = 0; axis < 3; ++axis)
      result.derivatives[axis] = sums(number, point_of,
                                      [axis](const std::array<double, 3>& t) {
                                        return internal::element_derivatives(t, axis);
                                      }) /
                                 width;
    return result;
  }

  /// \param point_of number of a point &rarr; `Sheet_point`
  template <class PointOf> Eigen::MatrixXd values(std::size_t number, PointOf&& point_of) const {
    return sums(number, point_of,
                [](const std::array<double, 3>& t) { return internal::element_values(t); });
  }

  /// the functions with other values of the elements
  /// \param values_of local coordinate &rarr; numbers for the 27 elements
  template <class PointOf, class ValuesOf>
  Eigen::MatrixXd sums(std::size_t number, PointOf&& point_of, ValuesOf&& values_of) const {
    Eigen::MatrixXd result(static_cast<Index>(number), m_coefficients.rows());
    if(m_coefficients.rows() == 0)
      return result; // no function: no memory to take parts of
    // Values of a chunk are gathered point by point, and stored column by column: the rows of the
    // result are far apart in memory.
    constexpr std::size_t grain = 64;
    internal::parallel_for(
        m_space->options().is_parallel, 0, number, grain, [&](std::size_t begin, std::size_t end) {
          const Index size = static_cast<Index>(end - begin);
          Eigen::MatrixXd chunk(m_coefficients.rows(), size);
          for(Index i = 0; i < size; ++i)
            evaluate(point_of(begin + static_cast<std::size_t>(i)), values_of, chunk.col(i));
          result.middleRows(static_cast<Index>(begin), size) = chunk.transpose();
        });
    return result;
  }

  template <class ValuesOf>
  void evaluate(const internal::Sheet_point& p, ValuesOf&& values_of,
                Eigen::MatrixXd::ColXpr result) const {
    if(p.sheet == internal::Sheet_point::not_on_surface) {
      result.setConstant(std::numeric_limits<double>::quiet_NaN());
      return;
    }
    const Cell_elements& elements = m_space->elements(m_level, p.sheet);
    const std::array<double, 27> values = values_of(p.t);
    result.setZero();
    for(int i = 0; i < 27; ++i)
      if(elements[i] != Spline_space_3::no_element)
        result += values[i] * m_coefficients.col(elements[i]);
  }

  const Spline_space_3* m_space;
  int m_level;
  Eigen::MatrixXd m_coefficients; // transposed: what a point needs of an element lies together
};

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_SPLINE_FUNCTIONS_3_H
