// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "point_input.h"

#include "point_set.h"
#include "program.h"

#include <CGAL/Restricted_laplacian_3/surface/read_point_set.h>

#include <CGAL/tags.h>

#include <utility>

namespace examples {

po::options_description point_options(Point_options& p, Common_options& o) {
  po::options_description options("Points", help_width);
  auto add = options.add_options();
  add("neighbors", po::value(&p.neighbors)->value_name("K")->default_value(p.neighbors),
      "number of neighbors of a point from which the area that it stands for is estimated");
  add("split-points", po::bool_switch(&o.space.split_point_set),
      "split elements by components of points that are linked by distance and normals");
  return options;
}

Mesh_input read_mesh_or_points(const std::string& file, int neighbors, const Callback& callback) {
  const std::string format = extension(file);
  if(format != ".xyz") {
    internal::Polygon_soup soup = internal::read_soup(file, callback);
    if(format != ".ply" || soup.has_faces())
      return internal::mesh_of(std::move(soup), file);
  }
  const Point_set points = read_points(file);
  require(!points.empty(), "'" + file + "' holds no point");
  require(points.has_normal_map(), "'" + file + "' has neither faces nor normals");
  const auto np = RL::parameters::number_of_neighbors(neighbors).concurrency_tag(
      CGAL::Parallel_if_available_tag());
  return {RL::read_point_set(points, np), false};
}

Mesh_input read_mesh_or_points(const Common_options& o, const Point_options& p,
                               const po::variables_map& given, const Callback& callback) {
  Mesh_input input = read_mesh_or_points(o.mesh, p.neighbors, callback);
  if(!input.surface.is_point_set())
    require(given["neighbors"].defaulted() && !o.space.split_point_set,
            "--neighbors and --split-points need a set of points");
  return input;
}

} // namespace examples
