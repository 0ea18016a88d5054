// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "shapes.h"

#include <CGAL/Kernel_traits.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Bounded_normal_change_filter.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/GarlandHeckbert_plane_policies.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

namespace shapes {

Mesh read(const std::string& path) {
  Mesh result;
  if(!path.empty())
    CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(path, result);
  return result;
}

Mesh simplified(Mesh mesh, std::size_t vertices) {
  namespace SMS = CGAL::Surface_mesh_simplification;
  // A closed triangulation has 3 (vertices - Euler characteristic) edges, before and after.
  const std::size_t edges = mesh.number_of_edges() - 3 * (mesh.number_of_vertices() - vertices);
  const SMS::GarlandHeckbert_plane_policies<Mesh, CGAL::Kernel_traits<RL::Point_3>::Kernel>
      policies(mesh);
  // The predicates of CGAL have other names in 5.5 than later.
  const auto stop = [edges](const auto&, const auto&, std::size_t, std::size_t current) {
    return current <= edges;
  };
  SMS::edge_collapse(mesh, stop,
                     CGAL::parameters::get_cost(policies.get_cost())
                         .get_placement(policies.get_placement())
                         .filter(SMS::Bounded_normal_change_filter<>()));
  mesh.collect_garbage();
  return mesh;
}

} // namespace shapes
