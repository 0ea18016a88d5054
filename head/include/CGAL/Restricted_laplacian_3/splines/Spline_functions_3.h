// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_SPLINE_FUNCTIONS_3_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_SPLINE_FUNCTIONS_3_H

#include <CGAL/Restricted_laplacian_3/basis/Tensor_basis_3.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Function_view.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <iterator>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

struct Sheet_point;
/// local coordinate &rarr; numbers for the elements
using Element_numbers = Function_view<Tensor_basis_3::Values(const std::array<double, 3>&)>;

} // namespace internal

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
/// (`concurrency_tag`).
class Spline_functions_3 {
public:
  /// \param space is copied, which costs nothing
  /// \param coefficients \f$H\f$: a row for each element of `level`, a column for each function;
  /// copied
  /// \param level from 0, the coarsest, to the depth of the space
  /// \throws Parameter_error if the number of rows is not `space.dimension(level)`, or if `level`
  /// is not from 0 to depth
  Spline_functions_3(const Spline_space_3& space,
                     const Eigen::Ref<const Eigen::MatrixXd>& coefficients, int level);
  /// The same on the finest level.
  Spline_functions_3(const Spline_space_3& space,
                     const Eigen::Ref<const Eigen::MatrixXd>& coefficients);

  /// the space, as given to the constructor
  const Spline_space_3& space() const { return m_space; }
  /// the level whose elements the coefficients belong to
  int level() const { return m_level; }
  /// \f$K\f$
  std::size_t number_of_functions() const {
    return static_cast<std::size_t>(m_coefficients.rows());
  }

  /// Values at all vertices: a row for each, in the order of `vertices(tm)`, and a column for each
  /// function; NaN at vertices that have no face of positive area, for they are not on the surface.
  /// (The same holds where all faces are needles that are thinner than rounding errors in the
  /// octree, unless a neighboring face is near.)
  Eigen::MatrixXd values_at_vertices() const;

  /// Values at locations: a row for each, a column for each function.
  /// \param locations a range of `Surface_location`, for example those of `sample_surface()`
  /// \throws Location_error if there is no such face, or if a location is not on the surface
  template <class LocationRange>
  Eigen::MatrixXd values_at_locations(const LocationRange& locations) const {
    return values_at({std::begin(locations), std::end(locations)});
  }

  /// Values and derivatives at all vertices, in the order of `vertices(tm)`; NaN at vertices that
  /// have no face of positive area.
  Spline_jets jets_at_vertices() const;

  /// Values and derivatives at locations.
  /// \param locations a range of `Surface_location`
  /// \throws Location_error if there is no such face, or if a location is not on the surface
  template <class LocationRange>
  Spline_jets jets_at_locations(const LocationRange& locations) const {
    return jets_at({std::begin(locations), std::end(locations)});
  }

private:
  /// so many points a thread takes
  static constexpr std::size_t points_at_once = 64;

  Eigen::MatrixXd values_at(const std::vector<Surface_location>& locations) const;

  Spline_jets jets_at(const std::vector<Surface_location>& locations) const;

  Spline_jets jets(const std::vector<internal::Sheet_point>& points) const;

  Eigen::MatrixXd values(const std::vector<internal::Sheet_point>& points) const;

  /// the functions with other values of the elements
  /// \param values_of local coordinate &rarr; numbers for the elements
  Eigen::MatrixXd sums(const std::vector<internal::Sheet_point>& points,
                       const internal::Element_numbers& values_of) const;

  /// the same for a few points, into rows of a matrix
  void write_sums(const internal::Sheet_point* points, std::size_t number_of_points,
                  const internal::Element_numbers& values_of, std::size_t first_row,
                  Eigen::MatrixXd& result) const;

  Spline_space_3 m_space;
  int m_level;
  Eigen::MatrixXd m_coefficients; // transposed: what a point needs of an element lies together
};

} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/splines/Spline_functions_3_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SPLINES_SPLINE_FUNCTIONS_3_H
