// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "point_input.h"

#include "program.h"
#include "vertex_data.h"

#include <CGAL/Restricted_laplacian_3/input/read_surface.h>

#include <CGAL/property_map.h>
#include <CGAL/tags.h>

#include <utility>
#include <vector>

namespace programs {

po::options_description point_options(Point_options& p, Common_options& o) {
  po::options_description options("Points", help_width);
  auto add = options.add_options();
  add("neighbors", po::value(&p.neighbors)->value_name("K")->default_value(p.neighbors),
      "number of neighbors of a point from which the area that it stands for is estimated");
  add("split", po::bool_switch(&o.space.split_point_set),
      "split elements by components of points that are linked by distance and normals");
  return options;
}

Mesh_input read_mesh_or_points(const std::string& file, int neighbors, const Callback& callback) {
  RL::Mesh_file mesh = internal::read_file(file, callback);
  if(!mesh.triangles.empty())
    return internal::mesh_of(std::move(mesh), file);
  require(!mesh.points.empty(), "'" + file + "' holds no point");
  const std::vector<RL::Vector_3> normals = internal::normals_of(RL::read_vertex_properties(file));
  require(!normals.empty(), "'" + file + "' has neither faces nor normals");
  const auto np = RL::parameters::normal_map(CGAL::make_property_map(normals))
                      .neighbors(neighbors)
                      .concurrency_tag(CGAL::Parallel_if_available_tag());
  try {
    return {RL::read_surface(mesh.points, np), false};
  } catch(const RL::Parameter_error&) {
    throw;
  } catch(const RL::Input_error& e) {
    throw Error("'" + file + "': " + e.what());
  }
}

Mesh_input read_mesh_or_points(const Common_options& o, const Point_options& p,
                               const po::variables_map& given, const Callback& callback) {
  Mesh_input input = read_mesh_or_points(o.mesh, p.neighbors, callback);
  if(!input.surface.is_point_set())
    require(given["neighbors"].defaulted() && !o.space.split_point_set,
            "--neighbors and --split need a set of points");
  return input;
}

} // namespace programs
