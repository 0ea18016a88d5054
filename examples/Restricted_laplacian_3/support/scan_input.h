// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_EXAMPLES_SCAN_INPUT_H
#define RESTRICTED_LAPLACIAN_3_EXAMPLES_SCAN_INPUT_H

// Reads colored scans from PLY files: meshes, or points with or without normals.

#include "colored_mesh.h"
#include "mesh_input.h"
#include "ply_property.h"
#include "point_input.h"
#include "program.h"

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/textures/Colored_scan.h>

#include <CGAL/pca_estimate_normals.h>
#include <CGAL/property_map.h>

#include <cmath>
#include <cstddef>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

namespace examples {

namespace internal {

// Normals from the nearest points, which may point to either side: a scan turns them to its
// viewpoint.
inline std::vector<RL::Vector_3> estimated_normals(const std::vector<RL::Point_3>& points) {
  constexpr unsigned int neighbors = 12;
  using Point_and_normal = std::pair<RL::Point_3, RL::Vector_3>;
  std::vector<Point_and_normal> pairs;
  for(const RL::Point_3& p : points)
    pairs.emplace_back(p, RL::Vector_3(0, 0, 1));
  CGAL::pca_estimate_normals<CGAL::Parallel_if_available_tag>(
      pairs, neighbors,
      CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Point_and_normal>())
          .normal_map(CGAL::Second_of_pair_property_map<Point_and_normal>()));
  std::vector<RL::Vector_3> normals;
  for(const Point_and_normal& pair : pairs)
    normals.push_back(pair.second);
  return normals;
}

inline RL::Triangulated_surface_3 read_scan_points(const std::string& file) {
  const bool has_normals = !ply_property_type(file, "nx").empty() &&
                           !ply_property_type(file, "ny").empty() &&
                           !ply_property_type(file, "nz").empty();
  Oriented_points input = read_ply_points(file, has_normals);
  for(std::size_t i = 0; i < input.points.size(); ++i)
    for(int axis = 0; axis < 3; ++axis)
      require(std::isfinite(input.points[i][axis]), "'" + file + "': point " + std::to_string(i) +
                                                        " has a coordinate that is not finite");
  if(!has_normals)
    input.normals = estimated_normals(input.points);
  // the areas that points stand for do not matter
  std::vector<double> areas(input.points.size(), 1);
  return RL::Triangulated_surface_3(std::move(input.points), std::move(input.normals),
                                    std::move(areas));
}

} // namespace internal

inline RL::Colored_scan read_scan(const std::string& file, const RL::Scan_pose& pose,
                                  bool is_parallel) {
  require(std::ifstream(file).good(), "cannot open '" + file + "'");
  std::vector<Color> colors = read_colors(file);
  try {
    const RL::Triangulated_surface_3 surface = internal::is_ply_without_faces(file)
                                                   ? internal::read_scan_points(file)
                                                   : read_mesh(file).surface;
    return RL::Colored_scan(surface, std::move(colors), pose, RL::Point_3(0, 0, 0), is_parallel);
  } catch(const RL::Input_error& e) {
    throw Error("'" + file + "': " + e.what());
  }
}

} // namespace examples

#endif // RESTRICTED_LAPLACIAN_3_EXAMPLES_SCAN_INPUT_H
