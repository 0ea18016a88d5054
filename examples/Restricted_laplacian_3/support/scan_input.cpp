// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scan_input.h"

#include "color_map.h"
#include "mesh_input.h"
#include "point_set.h"
#include "program.h"

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/surface/read_point_set.h>

#include <CGAL/pca_estimate_normals.h>
#include <CGAL/property_map.h>
#include <CGAL/tags.h>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace examples {

namespace {

RL::Triangulated_surface_3 surface_of_scan(Point_set& points, const std::string& file) {
  if(!points.has_normal_map()) {
    // from the nearest points, to either side: a scan turns normals to its viewpoint
    constexpr unsigned int neighbors = 12;
    std::size_t i = 0;
    for(const RL::Point_3& p : points.points()) {
      require(std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z()),
              "'" + file + "': point " + std::to_string(i) +
                  " has a coordinate that is not finite");
      ++i;
    }
    points.add_normal_map();
    CGAL::pca_estimate_normals<CGAL::Parallel_if_available_tag>(
        points, neighbors,
        CGAL::parameters::point_map(points.point_map()).normal_map(points.normal_map()));
  }
  // the areas that points stand for do not matter
  return RL::read_point_set(
      points, RL::parameters::area_map(CGAL::Constant_property_map<Point_set::Index, double>(1)));
}

} // namespace

RL::Colored_scan read_scan(const std::string& file, const RL::Scan_pose& pose, bool is_parallel) {
  Point_set points = read_points(file);
  std::vector<Color> point_colors = colors(points, file);
  try {
    internal::Polygon_soup soup = internal::read_soup(file);
    const RL::Triangulated_surface_3 surface =
        soup.has_faces() ? internal::mesh_of(std::move(soup), file).surface
                         : surface_of_scan(points, file);
    return RL::Colored_scan(surface, std::move(point_colors), pose, RL::Point_3(0, 0, 0),
                            is_parallel);
  } catch(const RL::Input_error& e) {
    throw Error("'" + file + "': " + e.what());
  }
}

} // namespace examples
