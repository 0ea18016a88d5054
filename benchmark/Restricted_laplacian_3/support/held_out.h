// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_BENCHMARK_HELD_OUT_H
#define RESTRICTED_LAPLACIAN_3_BENCHMARK_HELD_OUT_H

// Which surface do the vertices of a mesh lie on? Some are taken away: how far are they from a
// surface that is made of the others?

#include "aabb_tree.h"

#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace benchmarks {

namespace RL = CGAL::Restricted_laplacian_3;
using Mesh = CGAL::Surface_mesh<RL::Point_3>;

/// A mesh without some of its vertices, and those.
struct Held_out {
  Mesh mesh;
  std::vector<RL::Point_3> points;
};

/// Takes away vertices inside the smooth parts, of which no two are neighbors, and triangulates
/// their places: all that it meets, in their order.
/// \param crease_angle between normals of faces, in degrees: no vertex on or beside such an edge
inline Held_out held_out(Mesh mesh, double crease_angle) {
  namespace PMP = CGAL::Polygon_mesh_processing;
  Held_out result;
  const double cosine = std::cos(crease_angle * CGAL_PI / 180);
  const auto is_smooth = [&](Mesh::Halfedge_index h) {
    return !mesh.is_border(h) && !mesh.is_border(mesh.opposite(h)) &&
           PMP::compute_face_normal(mesh.face(h), mesh) *
                   PMP::compute_face_normal(mesh.face(mesh.opposite(h)), mesh) >
               cosine;
  };
  std::vector<char> is_kept(mesh.num_vertices(), 0);
  const std::vector<Mesh::Vertex_index> all(mesh.vertices().begin(), mesh.vertices().end());
  for(const auto v : all) {
    if(is_kept[v] || mesh.is_isolated(v))
      continue;
    bool is_inside = true;
    std::vector<Mesh::Vertex_index> ring;
    for(const auto h : mesh.halfedges_around_target(mesh.halfedge(v))) {
      is_inside = is_inside && is_smooth(h) && is_smooth(mesh.prev(h));
      ring.push_back(mesh.source(h));
    }
    // an edge that is there already would be made again
    for(std::size_t i = 0; i < ring.size(); ++i)
      for(std::size_t j = i + 2; j < ring.size(); ++j)
        is_inside = is_inside && ((i == 0 && j + 1 == ring.size()) ||
                                  mesh.halfedge(ring[i], ring[j]) == Mesh::null_halfedge());
    if(!is_inside)
      continue;
    for(const auto u : ring)
      is_kept[u] = 1;
    result.points.push_back(mesh.point(v));
    const auto h = CGAL::Euler::remove_center_vertex(mesh.halfedge(v), mesh);
    PMP::triangulate_face(mesh.face(h), mesh);
  }
  mesh.collect_garbage();
  result.mesh = std::move(mesh);
  return result;
}

/// Distances of points to a surface, whose faces are divided into `n` x `n` flat pieces with
/// corners on their patches.
inline std::vector<double> distances(const std::vector<RL::Point_3>& points,
                                     const RL::Triangulated_surface_3& surface, int n) {
  using Kernel = CGAL::Kernel_traits<RL::Point_3>::Kernel;
  using Triangles = std::vector<Kernel::Triangle_3>;
  using Primitive = Triangle_primitive<Kernel, Triangles::const_iterator>;
  using Tree = Aabb_tree<Kernel, Primitive>;
  Triangles pieces;
  for(std::size_t f = 0; f < surface.number_of_faces(); ++f) {
    if(surface.is_degenerate(f))
      continue;
    const auto point = [&](int i, int j) {
      RL::Surface_location location;
      location.face = f;
      location.barycentric = {1 - double(i + j) / n, double(i) / n, double(j) / n};
      return surface.surface_point(location).point;
    };
    for(int i = 0; i < n; ++i)
      for(int j = 0; i + j < n; ++j) {
        pieces.emplace_back(point(i, j), point(i + 1, j), point(i, j + 1));
        if(i + j + 2 <= n)
          pieces.emplace_back(point(i + 1, j), point(i + 1, j + 1), point(i, j + 1));
      }
  }
  const Tree tree(pieces.begin(), pieces.end());
  std::vector<double> result;
  for(const RL::Point_3& p : points)
    result.push_back(std::sqrt(tree.squared_distance(p)));
  return result;
}

} // namespace benchmarks

#endif // RESTRICTED_LAPLACIAN_3_BENCHMARK_HELD_OUT_H
