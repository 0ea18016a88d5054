// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_SHARED_PUT_POSITIONS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_SHARED_PUT_POSITIONS_H

#include <CGAL/Restricted_laplacian_3/surface/shared/coordinates.h>

#include <boost/property_map/property_map.hpp>

#include <Eigen/Core>

#include <cstddef>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// positions, a row for each vertex, into a property map of points
template <class Source, class VertexPointMap>
void put_positions(const Source& source, const Eigen::MatrixXd& positions, VertexPointMap map) {
  using Point = typename boost::property_traits<VertexPointMap>::value_type;
  source.for_each_vertex([&](std::size_t i, const auto& v) {
    const auto p = positions.row(static_cast<Eigen::Index>(i));
    put_value_at(map, v, Point(p[0], p[1], p[2]));
  });
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_PROBLEMS_SHARED_PUT_POSITIONS_H
