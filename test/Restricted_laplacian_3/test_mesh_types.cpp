// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// The same surface gives the same result, whatever the type of the mesh and its kernel.

#include "mesh_types.h"

#include <CGAL/Restricted_laplacian_3/input/read_surface.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <boost/property_map/function_property_map.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace {

using namespace mesh_types;
using shapes::Mesh;
using Vertex = Mesh::Vertex_index;
using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;

/// A point without members, as users have them, and what knows its coordinates. They are stored in
/// another order, and in another unit, so that nothing else can read them.
struct Plain_point {
  std::array<float, 3> zyx;
};

struct Plain_traits {
  template <int I> struct Compute {
    double scale;
    double operator()(const Plain_point& p) const { return scale * p.zyx[I]; }
  };
  using Compute_x_3 = Compute<2>;
  using Compute_y_3 = Compute<1>;
  using Compute_z_3 = Compute<0>;
  Compute_x_3 compute_x_3_object() const { return {unit}; }
  Compute_y_3 compute_y_3_object() const { return {unit}; }
  Compute_z_3 compute_z_3_object() const { return {unit}; }

  explicit Plain_traits(double unit) : unit(unit) {}
  double unit;
};

/// powers of two leave all digits as they are
Plain_point plain(const RL::Point_3& p, double unit) {
  return {{static_cast<float>(p.z() / unit), static_cast<float>(p.y() / unit),
           static_cast<float>(p.x() / unit)}};
}

std::vector<RL::Point_3> points_of(const RL::Triangulated_surface_3& surface) {
  std::vector<RL::Point_3> points;
  for(std::size_t v = 0; v < surface.number_of_vertices(); ++v)
    points.push_back(surface.point(v));
  return points;
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

TEST_CASE("traits_read_points_of_any_type", "[mesh_types]") {
  const double unit = 0.125;
  const Plain_traits traits(unit);
  const shapes::Triangles t = surface();
  const Mesh mesh = shapes::mesh(t);
  std::vector<Plain_point> plain_points;
  for(const RL::Point_3& p : t.points)
    plain_points.push_back(plain(p, unit));

  const auto map =
      boost::make_function_property_map<Vertex>([&](Vertex v) { return plain_points[v.idx()]; });
  const RL::Triangulated_surface_3 of_mesh =
      RL::read_surface(mesh, params::vertex_point_map(map).geom_traits(traits));
  CHECK((points_of(of_mesh) == t.points));
  const auto np = params::depth(3).tolerance(1e-6);
  CHECK(relative_difference(solution(mesh, np.vertex_point_map(map).geom_traits(traits)),
                            expected_solution()) == 0);

  const RL::Triangulated_surface_3 of_soup =
      RL::read_surface(RL::soup(plain_points, t.faces), params::geom_traits(traits));
  CHECK((points_of(of_soup) == t.points));
  const RL::Spline_space_3 space(RL::soup(plain_points, t.faces),
                                 params::depth(3).geom_traits(traits));
  CHECK((points_of(space.surface()) == t.points));

  // normals are vectors of the traits, too
  std::vector<Plain_point> plain_normals;
  for(std::size_t f = 0; f < t.points.size(); ++f)
    plain_normals.push_back(plain(CGAL::ORIGIN + of_mesh.normal(f), unit));
  const RL::Triangulated_surface_3 of_points = RL::read_surface(
      plain_points, params::normal_map(CGAL::make_property_map(plain_normals)).geom_traits(traits));
  CHECK((points_of(of_points) == t.points));
  for(std::size_t i = 0; i < t.points.size(); ++i)
    REQUIRE((of_points.normal(i) - of_mesh.normal(i)).squared_length() < 1e-12);
}

TEST_CASE("a_kernel_serves_as_traits", "[mesh_types]") {
  const shapes::Mesh mesh = shapes::mesh(surface());
  const auto check = [&](const auto& other, const auto& kernel) {
    CHECK((points_of(RL::read_surface(other, params::geom_traits(kernel))) ==
           points_of(RL::read_surface(other))));
  };
  check(mesh, CGAL::Simple_cartesian<double>());
  check(converted<CGAL::Surface_mesh<CGAL::Simple_cartesian<float>::Point_3>>(mesh),
        CGAL::Simple_cartesian<float>());
  check(converted<CGAL::Surface_mesh<Epick::Point_3>>(mesh), Epick());
  check(converted<CGAL::Surface_mesh<Epeck::Point_3>>(mesh), Epeck());
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
