// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// The same surface gives the same result, whatever the type of the mesh, the kernel, the property
// maps and the order of the named parameters.

#include "mesh_types.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <boost/property_map/property_map.hpp>

#include <limits>
#include <map>

namespace {

using namespace mesh_types;
using shapes::Mesh;
using Vertex = Mesh::Vertex_index;
using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;

/// a point map that computes points of another kernel when it is asked for them
struct Computed_point_map {
  using key_type = Vertex;
  using value_type = Epeck::Point_3;
  using reference = Epeck::Point_3;
  using category = boost::readable_property_map_tag;

  const std::vector<RL::Point_3>* points;

  friend value_type get(const Computed_point_map& map, Vertex v) {
    const RL::Point_3& p = (*map.points)[v];
    return {p.x(), p.y(), p.z()};
  }
};

/// a map that can only be written
struct Output_map {
  using key_type = Vertex;
  using value_type = double;
  using reference = void;
  using category = boost::writable_property_map_tag;

  std::vector<double>* values;

  friend void put(const Output_map& map, Vertex v, double value) { (*map.values)[v] = value; }
};

/// the connectivity of the surface with points that are not numbers
Mesh mesh_without_points() {
  Mesh mesh = shapes::mesh(surface());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for(Vertex v : mesh.vertices())
    mesh.point(v) = RL::Point_3(nan, nan, nan);
  return mesh;
}

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

TEST_CASE("points_come_from_the_vertex_point_map", "[mesh_types]") {
  const Mesh mesh = mesh_without_points();
  const std::vector<RL::Point_3> points = surface().points;

  const Computed_point_map computed{&points};
  CHECK(relative_difference(
            solution(mesh, params::vertex_point_map(computed).number_of_iterations(9)),
            RL::read_surface(mesh, params::vertex_point_map(computed)).points()) == 0);
}
