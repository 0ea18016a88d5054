// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_STITCH_COLORS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_STITCH_COLORS_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/parameters.h>
#include <CGAL/Restricted_laplacian_3/problems/shared/space_of.h>
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

template <class Surface, class VertexMap, class NamedParameters>
Stitching_report stitch_colors_on_surface(const Surface& surface,
                                          const std::vector<Colored_scan>& scans, VertexMap colors,
                                          const NamedParameters& np) {
  using Value = typename boost::property_traits<VertexMap>::value_type;
  CGAL::Real_timer timer;
  timer.start();
  const Progress progress = progress_of(np);
  progress(0);
  const auto source = surface_source(surface);
  const Spline_space_3 space = space_of(surface, np);
  const double space_seconds = timer.time();
  Color_stitcher stitcher(space, np);
  constexpr double end_of_scans = 0.5;
  for(std::size_t i = 0; i < scans.size(); ++i) {
    progress.part(space_share,
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
/// Colors a surface from several scans without visible seams, see `Color_stitcher`.
/// \tparam Surface a model of `RestrictedSurface_3`
/// \param surface a mesh, a `soup()`, or a `Spline_space_3` of such
/// \param scans at least one
/// \param colors a model of `WritablePropertyMap` with vertices as keys and a color as value:
/// `CGAL::IO::Color`, or a `std::array`, a vector of Eigen or a 3D vector of \cgal of three
/// components, from 0 to 1, or from 0 to 255 if they are integers
/// \param np optional named parameters:
/// \cgalNamedParamsBegin
///   \named_of_space
///   \named_of_surface
///   \named_of_stitching
///   \named_progress
/// \cgalNamedParamsEnd
/// \throws Input_error one of its derived classes names the face, vertex or parameter; or no scan
/// comes near the surface
/// \throws Canceled if `progress` returned `false`
template <class Surface, class VertexMap,
          class NamedParameters = parameters::Default_named_parameters,
          internal::Require_named_parameters<NamedParameters> = 0>
Stitching_report stitch_colors(const Surface& surface, const std::vector<Colored_scan>& scans,
                               VertexMap colors,
                               const NamedParameters& np = parameters::default_values()) {
  return internal::stitch_colors_on_surface(surface, scans, colors, np);
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_STITCH_COLORS_H
