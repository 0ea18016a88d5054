// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_SHARED_PUT_AT_VERTICES_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_SHARED_PUT_AT_VERTICES_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/input/shared/function_on_surface.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_functions_3.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>
#include <CGAL/Restricted_laplacian_3/surface/shared/function_components.h>

#include <Eigen/Core>

#include <boost/property_map/property_map.hpp>

#include <string>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// the values of spline functions at all vertices, into a property map of numbers or vectors
template <class Source, class PropertyMap>
void put_at_vertices(const Source& source, const Spline_space_3& space,
                     const Eigen::MatrixXd& coefficients, PropertyMap map) {
  using Components = Function_components<typename boost::property_traits<PropertyMap>::value_type>;
  if(coefficients.cols() != Components::number)
    throw Parameter_error("u", "has " + std::to_string(Components::number) +
                                   " components, but the function has " +
                                   std::to_string(coefficients.cols()));
  put_rows(source, Spline_functions_3(space, coefficients).values_at_vertices(), map);
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_SHARED_PUT_AT_VERTICES_H
