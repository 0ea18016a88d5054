// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// The same surface gives the same result, whatever the type of the mesh and its kernel.

#include "mesh_types.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <cmath>
#include <limits>
#include <vector>

namespace {

using namespace mesh_types;
using shapes::Mesh;
using Vertex = Mesh::Vertex_index;
using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;

} // namespace

TEMPLATE_TEST_CASE("solution_does_not_depend_on_the_mesh_type", "[mesh_types]",
                   CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>,
                   CGAL::Surface_mesh<CGAL::Simple_cartesian<float>::Point_3>,
                   CGAL::Surface_mesh<Epick::Point_3>, CGAL::Surface_mesh<Epeck::Point_3>,
                   CGAL::Polyhedron_3<CGAL::Simple_cartesian<double>>,
                   CGAL::Polyhedron_3<CGAL::Simple_cartesian<float>>, CGAL::Polyhedron_3<Epick>,
                   (CGAL::Polyhedron_3<Epeck, CGAL::Polyhedron_items_with_id_3>)) {
  check_mesh_type(converted<TestType>(shapes::mesh(surface())));
}

TEST_CASE("removed_vertices_and_faces_do_not_count", "[mesh_types]") {
  const shapes::Triangles t = surface();
  Mesh mesh;
  std::vector<Vertex> kept;
  std::vector<Mesh::Face_index> waste;
  // before, between and after what stays
  const auto add_waste = [&] {
    const Vertex a = mesh.add_vertex(RL::Point_3(100, 0, 0)),
                 b = mesh.add_vertex(RL::Point_3(0, 100, 0)),
                 c = mesh.add_vertex(RL::Point_3(0, 0, 100));
    waste.push_back(mesh.add_face(a, b, c));
  };
  for(const RL::Point_3& p : t.points) {
    if(kept.size() % 10 == 0)
      add_waste();
    kept.push_back(mesh.add_vertex(p));
  }
  for(const auto& f : t.faces) {
    mesh.add_face(kept[f[0]], kept[f[1]], kept[f[2]]);
    if(f[0] % 10 == 0)
      add_waste();
  }
  for(Mesh::Face_index f : waste)
    CGAL::Euler::remove_face(halfedge(f, mesh), mesh);
  REQUIRE(mesh.has_garbage());
  REQUIRE(mesh.number_of_vertices() == t.points.size());
  check_mesh_type(mesh);

  const RL::Surface_location_converter<Mesh> converter(mesh);
  std::size_t i = 0;
  for(Mesh::Face_index f : mesh.faces())
    REQUIRE(converter(f, {1, 0, 0}).face == i++);

  mesh.collect_garbage();
  check_mesh_type(mesh);
}

TEST_CASE("vertices_without_a_face_get_no_value", "[mesh_types]") {
  const shapes::Triangles t = surface();
  Mesh mesh;
  mesh.add_vertex(RL::Point_3(0, 0, 0));
  for(const RL::Point_3& p : t.points)
    mesh.add_vertex(p);
  mesh.add_vertex(RL::Point_3(1e9, std::numeric_limits<double>::quiet_NaN(), 0));
  for(const auto& f : t.faces)
    mesh.add_face(Vertex(f[0] + 1), Vertex(f[1] + 1), Vertex(f[2] + 1));
  std::vector<double> values = solution(mesh);
  CHECK(std::isnan(values.front()));
  CHECK(std::isnan(values.back()));
  values.pop_back();
  values.erase(values.begin());
  CHECK(relative_difference(values, expected_solution()) == 0);
}
