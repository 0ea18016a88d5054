// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_BENCHMARK_SIMPLIFY_H
#define RESTRICTED_LAPLACIAN_3_BENCHMARK_SIMPLIFY_H

// QSlim, and how far it moves a surface.

#include <CGAL/Restricted_laplacian_3/input/read_surface.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/distance.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Bounded_normal_change_filter.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/GarlandHeckbert_plane_policies.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>
#include <CGAL/boost/graph/helpers.h>

#include <cstddef>
#include <stdexcept>
#include <string>

namespace benchmarks {

namespace RL = CGAL::Restricted_laplacian_3;
using Mesh = CGAL::Surface_mesh<RL::Point_3>;

/// \throws std::runtime_error if the mesh is not a closed surface of one component
inline void require_watertight(Mesh mesh) {
  if(!CGAL::is_closed(mesh) || !CGAL::is_triangle_mesh(mesh) || !CGAL::is_valid_polygon_mesh(mesh))
    throw std::runtime_error("the mesh is not watertight");
  const auto component = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:component").first;
  const std::size_t number = CGAL::Polygon_mesh_processing::connected_components(mesh, component);
  if(number != 1)
    throw std::runtime_error("the mesh has " + std::to_string(number) + " components");
}

/// Edges are collapsed in the order of the quadrics of Garland and Heckbert, none that would turn
/// over a triangle, until so many vertices are left.
/// \pre the mesh is closed and connected
inline Mesh simplified(Mesh mesh, std::size_t vertices) {
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
  require_watertight(mesh);
  return mesh;
}

/// what distinguishes a surface from another one that stands for it
struct Geometric_change {
  Geometric_change(const Mesh& mesh, const Mesh& original) {
    namespace PMP = CGAL::Polygon_mesh_processing;
    area = PMP::area(mesh) / PMP::area(original) - 1;
    volume = PMP::volume(mesh) / PMP::volume(original) - 1;
    hausdorff =
        PMP::approximate_symmetric_Hausdorff_distance<CGAL::Sequential_tag>(mesh, original) /
        RL::read_surface(original).extent();
  }
  double area, volume;
  double hausdorff; // both ways, over the longest side of the bounding box
};

} // namespace benchmarks

#endif // RESTRICTED_LAPLACIAN_3_BENCHMARK_SIMPLIFY_H
