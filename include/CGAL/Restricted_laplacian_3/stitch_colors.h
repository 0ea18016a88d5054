// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_STITCH_COLORS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_STITCH_COLORS_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/parameters.h>
#include <CGAL/Restricted_laplacian_3/problems/shared/Surface_source.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>
#include <CGAL/Restricted_laplacian_3/textures/Color_stitcher.h>
#include <CGAL/Restricted_laplacian_3/textures/Colored_scan.h>
#include <CGAL/Restricted_laplacian_3/textures/back_project_colors.h>
#include <CGAL/Restricted_laplacian_3/textures/shared/color_values.h>

#include <CGAL/Real_timer.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

namespace internal {

template <class Source, class PropertyMap, class NamedParameters>
Stitching_report stitch_colors(const Source& source, const std::vector<Colored_scan>& scans,
                               PropertyMap colors, const NamedParameters& np) {
  using Value = typename boost::property_traits<PropertyMap>::value_type;
  CGAL::Real_timer timer;
  timer.start();
  const Progress progress = progress_of(np);
  progress(0);
  const Spline_space_3 space = source.space(np);
  const double space_seconds = timer.time();
  Color_stitcher stitcher(space, np);
  constexpr double end_of_scans = 0.5;
  for(std::size_t i = 0; i < scans.size(); ++i) {
    progress.part(part_of_space,
                  end_of_scans)(static_cast<double>(i) / static_cast<double>(scans.size()));
    stitcher.add(scans[i]);
  }
  Stitched_colors result = stitcher.stitch(progress.part(end_of_scans, 1).callback());
  result.space_seconds = space_seconds;
  source.for_each_vertex([&](std::size_t i, const auto& v) {
    put_value_at(colors, v, make_color<Value>(result.colors[i]));
  });
  return static_cast<const Stitching_report&>(result);
}

} // namespace internal

/// \ingroup PkgRestrictedLaplacian3Colors
/// Colors a mesh from several scans without visible seams, see `Color_stitcher`.
/// \tparam FaceGraph a model of `FaceListGraph` and `VertexListGraph`, all of whose faces are
/// triangles
/// \param tm the surface
/// \param scans at least one
/// \param colors a model of `WritablePropertyMap` with the vertex descriptor as key and a color as
/// value: `CGAL::IO::Color`, or a `std::array`, a vector of Eigen or a 3D vector of \cgal of three
/// components, from 0 to 1, or from 0 to 255 if they are integers
/// \param np optional named parameters:
/// \cgalNamedParamsBegin
///   \named_of_space
///   \named_of_mesh
///   \named_of_stitching
///   \named_progress
/// \cgalNamedParamsEnd
/// \throws Input_error one of its derived classes names the face, vertex or parameter; or no scan
/// comes near the surface
/// \throws Canceled if `progress` returned `false`
template <class FaceGraph, class VertexMap,
          class NamedParameters = parameters::Default_named_parameters,
          internal::Require_named_parameters<NamedParameters> = 0>
Stitching_report stitch_colors(const FaceGraph& tm, const std::vector<Colored_scan>& scans,
                               VertexMap colors,
                               const NamedParameters& np = parameters::default_values()) {
  return internal::stitch_colors(internal::Mesh_source<FaceGraph>(tm), scans, colors, np);
}

/// \ingroup PkgRestrictedLaplacian3Colors
/// Colors a triangle soup, which need not be a manifold, from several scans.
/// \param points a range of 3D points
/// \param triangles a range of ranges of three indices into `points`
/// \param scans at least one
/// \param colors a model of `WritablePropertyMap` with the index of a point as key, a
/// `std::size_t`, and a color as value, as for a mesh
/// \param np optional named parameters:
/// \cgalNamedParamsBegin
///   \named_of_space
///   \named_of_stitching
///   \named_progress
///   \named_geom_traits
/// \cgalNamedParamsEnd
/// \throws Input_error one of its derived classes names the face, vertex or parameter; or no scan
/// comes near the surface
/// \throws Canceled if `progress` returned `false`
template <class PointRange, class TriangleRange, class IndexMap,
          class NamedParameters = parameters::Default_named_parameters,
          internal::Require_named_parameters<NamedParameters> = 0>
Stitching_report stitch_colors(const PointRange& points, const TriangleRange& triangles,
                               const std::vector<Colored_scan>& scans, IndexMap colors,
                               const NamedParameters& np = parameters::default_values()) {
  return internal::stitch_colors(
      internal::Soup_source<PointRange, TriangleRange>(points, triangles), scans, colors, np);
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_STITCH_COLORS_H
