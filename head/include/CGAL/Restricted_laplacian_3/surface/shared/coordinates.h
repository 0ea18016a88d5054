// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SHARED_COORDINATES_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SHARED_COORDINATES_H

#include <CGAL/Named_function_parameters.h>
#include <CGAL/number_utils.h>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// A model of `RestrictedLaplacianTraits_3` for all types that have members `x()`, `y()` and `z()`:
/// the points and vectors of all kernels of CGAL have them.
struct Coordinate_members {
  struct Compute_x_3 {
    template <class T> decltype(auto) operator()(const T& t) const { return t.x(); }
  };
  struct Compute_y_3 {
    template <class T> decltype(auto) operator()(const T& t) const { return t.y(); }
  };
  struct Compute_z_3 {
    template <class T> decltype(auto) operator()(const T& t) const { return t.z(); }
  };
  Compute_x_3 compute_x_3_object() const { return {}; }
  Compute_y_3 compute_y_3_object() const { return {}; }
  Compute_z_3 compute_z_3_object() const { return {}; }
};

/// The value of `geom_traits`.
template <class NamedParameters> auto geom_traits_of(const NamedParameters& np) {
  return parameters::choose_parameter(parameters::get_parameter(np, internal_np::geom_traits),
                                      Coordinate_members());
}

/// A point or vector of the caller as one of this package: the only place where coordinates are
/// read and become numbers of type `double`.
/// \tparam Own `Point_3`, `Vector_3`, or a vector of Eigen
template <class Own, class T, class GeomTraits = Coordinate_members>
Own with_coordinates_of(const T& t, const GeomTraits& traits = GeomTraits()) {
  return Own(CGAL::to_double(traits.compute_x_3_object()(t)),
             CGAL::to_double(traits.compute_y_3_object()(t)),
             CGAL::to_double(traits.compute_z_3_object()(t)));
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SHARED_COORDINATES_H
