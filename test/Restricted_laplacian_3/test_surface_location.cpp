// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Functions of a spline space, evaluated at locations given by CGAL's Polygon_mesh_processing.

#include "catch.h"
#include "special_shapes.h"

#include <CGAL/Restricted_laplacian_3/input/read_surface.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_function_3.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Random.h>
#include <CGAL/boost/graph/copy_face_graph.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <vector>

namespace {

namespace RL = CGAL::Restricted_laplacian_3;
namespace params = RL::parameters;
namespace PMP = CGAL::Polygon_mesh_processing;
using shapes::Mesh;

/// on all vertices and edges, and some in each face
std::vector<RL::Surface_location> locations(const Mesh& mesh) {
  const RL::Surface_location_converter<Mesh> convert(mesh);
  CGAL::Random random(1);
  std::vector<RL::Surface_location> result;
  for(Mesh::Vertex_index v : mesh.vertices())
    result.push_back(convert(PMP::locate_vertex<double>(v, mesh)));
  for(Mesh::Halfedge_index h : mesh.halfedges())
    if(!mesh.is_border(h))
      for(double t : {0.5, 0.3})
        result.push_back(convert(PMP::locate_on_halfedge(h, t, mesh)));
  const std::size_t in_each_face = 1 + 2000 / mesh.number_of_faces();
  for(Mesh::Face_index f : mesh.faces())
    for(std::size_t i = 0; i < in_each_face; ++i)
      result.push_back(convert(PMP::random_location_on_face<double>(f, mesh, random)));
  return result;
}

/// Calls `check(mesh, space)` for surfaces in general position, and for some all of whose faces,
/// edges or vertices lie in walls.
template <class Check> void for_each_space(Check&& check) {
  const auto run = [&check](const std::string& name, const shapes::Triangles& t, int depth,
                            double cube_scale) {
    INFO(name << ", depth " << depth << ", cube scale " << cube_scale);
    const Mesh mesh = shapes::mesh(t);
    check(mesh, RL::Spline_space_3(mesh, params::depth(depth).cube_scale(cube_scale)));
  };
  run("sphere", shapes::sphere(3), 4, 1.1);
  run("octahedron", shapes::sphere(0), 5, 1);
  for(double cube_scale : {1., 1.1, 2.}) {
    run("box", shapes::box(1, 1, 1, 3, 1), 4, cube_scale);
    run("flat box", shapes::box(1, 0.5, 0.25, 4, 1), 4, cube_scale);
    run("square", shapes::rectangle(1, 1), 4, cube_scale);
  }
  run("triangle", {{{0, 0, 0}, {1, 0.3, 0.2}, {0.1, 1, 0.4}}, {{0, 1, 2}}}, 6, 1.1);
}

/// u and its surface gradient are 1 and 0 at all locations
void check_ones(const RL::Spline_space_3& space, int level,
                const std::vector<RL::Surface_location>& locations) {
  const RL::Spline_function_3 u(space, Eigen::VectorXd::Ones(space.dimension(level)), level);
  double error = 0, gradient = 0;
  for(const RL::Surface_location& location : locations) {
    error = (std::max)(error, std::abs(u.value(location) - 1));
    gradient = (std::max)(gradient, std::sqrt(u.gradient(location).squared_length()));
  }
  INFO("level " << level);
  CHECK(error <= 1e-14);
  CHECK(gradient <= 1e-13 / space.octree().cell_width(level));
}

/// the point that an element is centered on
RL::Point_3 center(const RL::Spline_space_3& space, int level, std::size_t element) {
  const RL::Octree_3& octree = space.octree();
  const RL::Point_3 c = space.surface().center();
  const RL::Cell_3 cell = space.center(level, element);
  const double half = octree.side() / 2, h = octree.cell_width(level);
  return {c.x() - half + h * (cell.index[0] + 0.5), c.y() - half + h * (cell.index[1] + 0.5),
          c.z() - half + h * (cell.index[2] + 0.5)};
}

Eigen::VectorXd random_coefficients(std::size_t size, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Eigen::VectorXd result(size);
  for(double& x : result)
    x = uniform(generator);
  return result;
}

/// corners of all fragments: many of them lie on walls, edges and corners of cells
std::vector<RL::Surface_location> locations_on_walls(const RL::Octree_3& octree) {
  std::vector<RL::Surface_location> result;
  const int depth = octree.depth();
  for(std::size_t i = 0; i < octree.number_of_sheets(depth); ++i)
    for(std::uint32_t face : octree.faces(i)) {
      const RL::Fragment fragment = octree.fragment(octree.cell(depth, i), face);
      for(std::size_t k = 0; k < fragment.size; ++k) {
        RL::Surface_location location;
        location.face = face;
        location.barycentric = fragment.corners[k].barycentric;
        result.push_back(location);
      }
    }
  return result;
}

} // namespace

TEST_CASE("function_with_coefficients_one_is_one_everywhere", "[location]") {
  for_each_space([](const Mesh& mesh, const RL::Spline_space_3& space) {
    for(int level = 0; level <= space.depth(); ++level) {
      check_ones(space, level, locations(mesh));
      check_ones(space, level, locations_on_walls(space.octree()));
    }
  });
}

TEST_CASE("function_with_coefficients_one_is_one_on_stairs_in_walls", "[location]") {
  // Neighboring walls hold parts of the surface. Rounding puts points of one wall into the cells
  // between the two, in which the elements of the other wall act, but not all of those of this one.
  const Mesh mesh = shapes::mesh(shapes::stairs(8, 0.1));
  for(double cube_scale : {1., 2.})
    for(int depth = 1; depth <= 5; ++depth) {
      INFO("depth " << depth << ", cube scale " << cube_scale);
      const RL::Spline_space_3 space(mesh, params::depth(depth).cube_scale(cube_scale));
      for(int level = 0; level <= depth; ++level)
        check_ones(space, level, locations(mesh));
    }
}

TEST_CASE("cell_of_another_part_of_the_surface_is_not_taken", "[location]") {
  // The square lies in the last wall, so the elements one cell below it vanish on it; the triangle
  // touches its cells from below, and these elements do not vanish there.
  const shapes::Triangles t = {
      {{1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {1, 0, 1}, {0, 0, 0}, {0, 0.2, 0.3}, {0.5, 0.2, 0.2}},
      {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}}};
  const Mesh mesh = shapes::mesh(t);
  check_ones(RL::Spline_space_3(mesh, params::depth(1).cube_scale(1)), 1, locations(mesh));
}

TEST_CASE("function_can_be_evaluated_far_from_the_origin", "[location]") {
  // Rounding errors of the coordinates reach a considerable part of a cell, and so does the
  // distance in which vertices are taken to lie on a wall.
  for(double distance : {1e3, 1e6, 1e7, 1e8, 1e9})
    for(int depth : {3, 4, 6}) {
      INFO("distance " << distance << ", depth " << depth);
      for(const shapes::Triangles& t : {shapes::stairs(8, 0.1), shapes::sphere(2)}) {
        const RL::Vector_3 by(distance, 0.7 * distance, -0.3 * distance);
        const Mesh mesh = shapes::mesh(shapes::moved(t, by));
        const RL::Spline_space_3 space(mesh, params::depth(depth).cube_scale(1));
        const RL::Spline_function_3 u(space, Eigen::VectorXd::Ones(space.dimension()));
        double error = 0;
        REQUIRE_NOTHROW([&] {
          for(const RL::Surface_location& location : locations(mesh))
            error = (std::max)(error, std::abs(u.value(location) - 1));
        }());
        CHECK(error <= 1e-5);
      }
    }
}

TEST_CASE("linear_functions_of_space_are_reproduced", "[location]") {
  const RL::Vector_3 slope(1, -2, 0.5);
  const auto f = [&slope](const RL::Point_3& p) { return 3 + slope * (p - CGAL::ORIGIN); };
  for_each_space([&](const Mesh& mesh, const RL::Spline_space_3& space) {
    for(int level = 0; level <= space.depth(); ++level) {
      INFO("level " << level);
      Eigen::VectorXd coefficients(space.dimension(level));
      for(std::size_t i = 0; i < space.dimension(level); ++i)
        coefficients[i] = f(center(space, level, i));
      const RL::Spline_function_3 u(space, coefficients, level);
      double error = 0, gradient_error = 0;
      for(const auto& all : {locations(mesh), locations_on_walls(space.octree())})
        for(const RL::Surface_location& location : all) {
          const RL::Surface_point p = space.surface().surface_point(location);
          const RL::Vector_3 gradient = slope - (slope * p.normal) * p.normal;
          error = (std::max)(error, std::abs(u.value(location) - f(p.point)));
          gradient_error = (std::max)(
              gradient_error, std::sqrt((u.gradient(location) - gradient).squared_length()));
        }
      CHECK(error <= 2e-14);
      CHECK(gradient_error <= 1e-14 / space.octree().cell_width(level));
    }
  });
}

TEST_CASE("gradient_is_tangential_and_agrees_with_differences", "[location]") {
  for_each_space([](const Mesh& mesh, const RL::Spline_space_3& space) {
    const RL::Spline_function_3 u(space, random_coefficients(space.dimension(), 1));
    const double h = space.octree().cell_width(space.depth());
    double error = 0, normal_part = 0;
    CGAL::Random random(2);
    const RL::Surface_location_converter<Mesh> convert(mesh);
    const std::size_t in_each_face = 1 + 500 / mesh.number_of_faces();
    for(Mesh::Face_index f : mesh.faces())
      for(std::size_t k = 0; k < in_each_face; ++k) {
        const RL::Surface_location at =
            convert(PMP::random_location_on_face<double>(f, mesh, random));
        const RL::Vector_3 gradient = u.gradient(at);
        normal_part = (std::max)(normal_part, std::abs(gradient * space.surface().normal(at.face)));
        for(int corner = 0; corner < 3; ++corner) {
          const RL::Vector_3 side = space.surface().point(at.face, (corner + 1) % 3) -
                                    space.surface().point(at.face, corner);
          // along the side, as far as the face and one cell allow
          const double step = 1e-5 * h / std::sqrt(side.squared_length());
          RL::Surface_location upper = at, lower = at;
          upper.barycentric[corner] -= step;
          upper.barycentric[(corner + 1) % 3] += step;
          lower.barycentric[corner] += step;
          lower.barycentric[(corner + 1) % 3] -= step;
          if((std::min)(upper.barycentric[corner], lower.barycentric[(corner + 1) % 3]) < 0)
            continue;
          const double difference = (u.value(upper) - u.value(lower)) / (2 * step);
          error = (std::max)(error, std::abs(gradient * side - difference) * h /
                                        std::sqrt(side.squared_length()));
        }
      }
    CHECK(normal_part * h <= 1e-14);
    CHECK(error <= 1e-5); // where the second derivative jumps
  });
}

TEST_CASE("value_at_a_vertex_or_edge_is_the_same_from_all_faces", "[location]") {
  for_each_space([](const Mesh& mesh, const RL::Spline_space_3& space) {
    const RL::Surface_location_converter<Mesh> convert(mesh);
    const RL::Spline_function_3 u(space, random_coefficients(space.dimension(), 3));
    std::vector<double> at_vertices(mesh.number_of_vertices());
    RL::evaluate_at_vertices(
        u, mesh,
        boost::make_iterator_property_map(at_vertices.begin(), get(boost::vertex_index, mesh)));
    double difference = 0;
    for(Mesh::Halfedge_index h : mesh.halfedges()) {
      if(mesh.is_border(h))
        continue;
      const double at_source = u.value(convert(PMP::locate_on_halfedge(h, 0., mesh)));
      difference = (std::max)(difference, std::abs(at_source - at_vertices[mesh.source(h)]));
      const Mesh::Halfedge_index other = mesh.opposite(h);
      if(!mesh.is_border(other))
        difference = (std::max)(
            difference, std::abs(u.value(convert(PMP::locate_on_halfedge(h, 0.3, mesh))) -
                                 u.value(convert(PMP::locate_on_halfedge(other, 0.7, mesh)))));
    }
    CHECK(difference <= 1e-13);
  });
}

TEMPLATE_TEST_CASE("converted_locations_are_the_points_of_cgal", "[location]", Mesh,
                   CGAL::Polyhedron_3<CGAL::Simple_cartesian<double>>,
                   CGAL::Polyhedron_3<CGAL::Exact_predicates_exact_constructions_kernel>) {
  TestType mesh;
  CGAL::copy_face_graph(shapes::mesh(shapes::box(1, 0.8, 0.5, 2, 1)), mesh);
  using Point = typename boost::property_traits<
      typename boost::property_map<TestType, CGAL::vertex_point_t>::type>::value_type;
  using FT = typename CGAL::Kernel_traits<Point>::Kernel::FT;
  const RL::Triangulated_surface_3 surface = RL::read_surface(mesh);
  const RL::Surface_location_converter<TestType> convert(mesh);
  CGAL::Random random(4);
  for(auto f : faces(mesh)) {
    const auto location = PMP::random_location_on_face<FT>(f, mesh, random);
    const Point expected = PMP::construct_point(location, mesh);
    const RL::Point_3 p = surface.surface_point(convert(location)).point;
    CHECK(p.x() == Approx(CGAL::to_double(expected.x())).margin(1e-15));
    CHECK(p.y() == Approx(CGAL::to_double(expected.y())).margin(1e-15));
    CHECK(p.z() == Approx(CGAL::to_double(expected.z())).margin(1e-15));
    CHECK(convert(f, {0.25, 0.25, 0.5}).face == convert(location).face);
  }
}
