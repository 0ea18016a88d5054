// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scan_input.h"

#include "color_map.h"
#include "mesh_input.h"
#include "program.h"
#include "vertex_data.h"

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/input/read_surface.h>

#include <CGAL/pca_estimate_normals.h>
#include <CGAL/property_map.h>
#include <CGAL/tags.h>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace programs {

namespace {

using Point_with_normal = std::pair<RL::Point_3, RL::Vector_3>;

RL::Triangulated_surface_3 surface_of_scan(const std::vector<RL::Point_3>& points,
                                           const std::vector<RL::Vector_3>& normals,
                                           const std::string& file) {
  std::vector<Point_with_normal> scan(points.size());
  for(std::size_t i = 0; i < scan.size(); ++i) {
    scan[i].first = points[i];
    if(!normals.empty())
      scan[i].second = normals[i];
  }
  const auto point_map = CGAL::First_of_pair_property_map<Point_with_normal>();
  const auto normal_map = CGAL::Second_of_pair_property_map<Point_with_normal>();
  if(normals.empty()) {
    // from the nearest points, to either side: a scan turns normals to its viewpoint
    constexpr unsigned int neighbors = 12;
    for(std::size_t i = 0; i < points.size(); ++i)
      require(std::isfinite(points[i].x()) && std::isfinite(points[i].y()) &&
                  std::isfinite(points[i].z()),
              "'" + file + "': point " + std::to_string(i) +
                  " has a coordinate that is not finite");
    CGAL::pca_estimate_normals<CGAL::Parallel_if_available_tag>(
        scan, neighbors, CGAL::parameters::point_map(point_map).normal_map(normal_map));
  }
  // the areas that points stand for do not matter
  return RL::read_surface(scan,
                          RL::parameters::point_map(point_map)
                              .normal_map(normal_map)
                              .area_map(CGAL::Constant_property_map<Point_with_normal, double>(1)));
}

} // namespace

RL::Colored_scan read_scan(const std::string& file, const RL::Scan_pose& pose, bool is_parallel) {
  check_input(file);
  const internal::Vertex_properties properties = RL::read_vertex_properties(file);
  std::vector<Color> colors = internal::colors_of(properties, file);
  try {
    RL::Mesh_file mesh = internal::read_file(file);
    const RL::Triangulated_surface_3 surface =
        mesh.triangles.empty()
            ? surface_of_scan(mesh.points, internal::normals_of(properties), file)
            : internal::mesh_of(std::move(mesh), file).surface;
    return RL::Colored_scan(surface, std::move(colors), pose, RL::Point_3(0, 0, 0), is_parallel);
  } catch(const RL::File_error&) {
    throw; // it names the file
  } catch(const RL::Input_error& e) {
    throw Error("'" + file + "': " + e.what());
  }
}

} // namespace programs
