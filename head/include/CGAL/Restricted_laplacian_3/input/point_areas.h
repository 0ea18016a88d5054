// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_INPUT_POINT_AREAS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_INPUT_POINT_AREAS_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>
#include <CGAL/Restricted_laplacian_3/surface/Surface_location.h>

#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \cond SKIP_IN_MANUAL
/// \ingroup PkgRestrictedLaplacian3Functions
/// How many neighbors `estimate_point_areas()` looks at unless told otherwise.
constexpr int default_number_of_neighbors = 16;
/// \endcond

/// \ingroup PkgRestrictedLaplacian3Functions
/// The area that each point of a set stands for, from the density of the points around it: the
/// Voronoi cell of the point among its `number_of_neighbors` nearest neighbors, in its tangent
/// plane.
///
/// Neighbors whose normals are more than 90 degrees away from that of the point are left out: they
/// are on the other side of something thin. A point on the border of an open surface is told by
/// half of the directions around it being empty; its cell reaches as far outwards as inwards. No
/// cell is larger than a disc of twice the local distance of points.
/// Points that are the same share their cell. A point without neighbors that agree has area 0.
///
/// \param points the points; some may be the same
/// \param normals of any length, oriented alike
/// \param number_of_neighbors at least 3
/// \param is_parallel whether several threads are used, if the program is linked with TBB; the
/// result is the same
/// \return areas in units of squared coordinates
/// \throws Invalid_point_error a coordinate or a normal is not finite, or a normal is zero
/// \throws Parameter_error `number_of_neighbors` is less than 3, or the vectors differ in length
/// Takes \f$O(n \log n)\f$ time for \f$n\f$ points.
std::vector<double> estimate_point_areas(const std::vector<Point_3>& points,
                                         const std::vector<Vector_3>& normals,
                                         int number_of_neighbors = default_number_of_neighbors,
                                         bool is_parallel = false);

} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/input/point_areas_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_INPUT_POINT_AREAS_H
