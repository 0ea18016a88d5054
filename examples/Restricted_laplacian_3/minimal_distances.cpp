// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Restricted_laplacian_3/geodesic_distances.h>
#include <CGAL/Restricted_laplacian_3/input/read_surface.h>
#include <CGAL/Restricted_laplacian_3/problems/Geodesic_fitter.h>

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <iostream>
#include <vector>

namespace RL = CGAL::Restricted_laplacian_3;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

int main(int argc, char* argv[]) try {
  Mesh mesh;
  if(argc != 2 || !CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(argv[1], mesh)) {
    std::cerr << "usage: minimal_distances MESH\n";
    return 1;
  }
  // one query
  auto d = mesh.add_property_map<Mesh::Vertex_index, double>("v:distance").first;
  const Mesh::Vertex_index source = *vertices(mesh).begin();
  RL::geodesic_distances(mesh, source, d);
  std::cout << "the vertex that is farthest from the first one: "
            << *std::max_element(d.begin(), d.end()) << '\n';

  // many queries with one setup: four vertices far from each other, and their Voronoi regions
  const RL::Geodesic_solver solver(RL::read_surface(mesh));
  RL::Geodesic_sources sources;
  const std::vector<std::size_t> far = solver.farthest_points(4);
  for(std::size_t i = 0; i < far.size(); ++i)
    sources.add_vertex(far[i], static_cast<std::uint32_t>(i));
  const RL::Geodesic_distances nearest = solver.distances(sources);
  for(std::size_t i = 0; i < far.size(); ++i)
    std::cout << "vertex " << far[i] << " is the nearest for "
              << std::count(nearest.labels.begin(), nearest.labels.end(), i) << " vertices\n";

  // between the vertices: in the center of a face, as a spline
  const RL::Geodesic_distances from_first = solver.distances(RL::Geodesic_sources::vertex(0));
  const RL::Spline_space_3 space(mesh);
  const RL::Geodesic_fitter fitter(space);
  const RL::Geodesic_spline u = fitter.fit(RL::Geodesic_function(solver, from_first));
  const RL::Surface_location middle{num_faces(mesh) / 2, {1. / 3, 1. / 3, 1. / 3}};
  std::cout << "at the center of a face: " << u.value(middle) << ", gradient " << u.gradient(middle)
            << '\n';
} catch(const std::exception& e) {
  std::cerr << "minimal_distances: " << e.what() << '\n';
  return 1;
}
