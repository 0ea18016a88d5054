// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_READ_TRIANGLE_SOUP_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_READ_TRIANGLE_SOUP_H

#include <CGAL/Restricted_laplacian_3/foundation/compiled.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Progress.h>
#include <CGAL/Restricted_laplacian_3/foundation/parameters.h>
#include <CGAL/Restricted_laplacian_3/surface/Surface_location.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>

#include <string>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

namespace internal {

/// the function below
bool read_triangle_soup(const std::string& file, std::vector<Point_3>& points,
                        std::vector<Triangulated_surface_3::Triangle>& triangles,
                        const Progress& progress);

} // namespace internal

/// \ingroup PkgRestrictedLaplacian3Functions
/// Reads a binary PLY or STL file of triangles, piece by piece: beside the results it takes a few
/// megabytes, and for STL files about 10 bytes a vertex. The readers of \cgal make a list of
/// corners for each face, or a mesh. So a hundred million triangles can be read.
///
/// The results are those of `CGAL::IO::read_polygon_soup()`: points in the order of a PLY file, and
/// in STL files equal points as one, in the order in which they are met. Nothing is repaired.
///
/// Takes time linear in the length of the file.
/// \param file its name
/// \param points,triangles receive what is in the file; what the surface of
/// `Spline_space_3(Triangulated_surface_3(std::move(points), std::move(triangles)))` is made of
/// \param np optional named parameters:
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{callback}
///     \cgalParamDescription{called on and on with the part of the file that is read, from 0 to 1;
///     returns `false` to end the work}
///     \cgalParamType{a function object `bool(double)`}
///     \cgalParamDefault{none}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \return whether it could be read. `false`, and nothing in `points` and `triangles`, if there is
/// no such file, if it is of another format, if it has other faces than triangles, or if there is
/// something wrong with it: then `CGAL::IO::read_polygon_soup()` may be tried.
/// \throws Canceled if the callback returned `false`
template <class NamedParameters = parameters::Default_named_parameters>
bool read_triangle_soup(const std::string& file, std::vector<Point_3>& points,
                        std::vector<Triangulated_surface_3::Triangle>& triangles,
                        const NamedParameters& np = parameters::default_values()) {
  return internal::read_triangle_soup(file, points, triangles, internal::progress_of(np));
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/surface/read_triangle_soup_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_READ_TRIANGLE_SOUP_H
