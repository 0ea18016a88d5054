// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Shortest paths on surfaces: straight where the surface unfolds, and as long as exact distances.

#include "catch.h"
#include "geodesic_shapes.h"
#include "shapes.h"
#include "special_shapes.h"

#include <CGAL/Restricted_laplacian_3/geodesic_distances.h>
#include <CGAL/Restricted_laplacian_3/geodesics/Geodesic_function.h>
#include <CGAL/Restricted_laplacian_3/geodesics/Geodesic_solver.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace {

namespace RL = CGAL::Restricted_laplacian_3;

/// that a path is one: its parts are joined, and as long as it says
void check_path(const RL::Triangulated_surface_3& surface, const RL::Surface_location& from,
                const RL::Geodesic_path& path) {
  const double tiny = 1e-9 * surface.extent();
  REQUIRE(path.points.size() == path.segments.size() + 1);
  CHECK(shapes::length(path.points.front() - surface.surface_point(from).point) <= tiny);
  double sum = 0;
  for(std::size_t i = 0; i < path.segments.size(); ++i) {
    const auto& segment = path.segments[i];
    CHECK(segment.from.face == segment.to.face);
    CHECK(shapes::length(surface.surface_point(segment.from).point - path.points[i]) <= tiny);
    CHECK(shapes::length(surface.surface_point(segment.to).point - path.points[i + 1]) <= tiny);
    sum += shapes::length(path.points[i + 1] - path.points[i]);
  }
  CHECK(path.length == Approx(sum).margin(tiny));
}

/// Paths from all vertices to one, beside exact distances.
struct Paths {
  double mean = 0, worst = 0; // what is too long, relative
  int number = 0, too_long = 0;

  Paths(const shapes::Triangles& t, std::size_t to,
        RL::Geodesic_method method = RL::Geodesic_method::fast) {
    const RL::Geodesic_solver rays = shapes::geodesics(t);
    const auto source = RL::Geodesic_sources::vertex(to);
    const std::vector<double> exact = rays.distances(source, RL::Geodesic_method::exact).distances;
    const RL::Geodesic_function d(rays, rays.distances(source, method));
    for(std::size_t v = 0; v < t.points.size(); ++v) {
      if(v == to || !std::isfinite(exact[v]))
        continue;
      CAPTURE(v, to);
      const RL::Surface_location from = rays.location(v);
      const RL::Geodesic_path path = d.shortest_path(from);
      check_path(rays.surface(), from, path);
      CHECK(shapes::length(path.points.back() - t.points[to]) <= 1e-9 * rays.surface().extent());
      const double error = path.length / exact[v] - 1;
      CHECK(error > -1e-8);
      mean += error;
      worst = (std::max)(worst, error);
      too_long += error > 1e-3;
      ++number;
    }
    mean /= number;
  }
};

} // namespace

TEST_CASE("shortest_paths_in_a_plane_are_straight", "[geodesic_path]") {
  const auto t = shapes::grid(9, [](double x, double y) { return RL::Point_3(x, y, 0.3 * x - y); });
  const RL::Geodesic_solver rays = shapes::geodesics(t);
  const auto point = [&](const RL::Surface_location& l) {
    return rays.surface().surface_point(l).point;
  };
  for(const RL::Surface_location& to :
      {RL::Surface_location{20, {0, 0, 1}}, RL::Surface_location{77, {0.2, 0.3, 0.5}},
       RL::Surface_location{150, {0, 0.4, 0.6}}}) {
    RL::Geodesic_sources sources;
    sources.add_location(to);
    const RL::Geodesic_function d(rays, rays.distances(sources));
    for(std::size_t f = 0; f < t.faces.size(); ++f)
      for(const auto& l : {std::array<double, 3>{0.2, 0.3, 0.5}, {0, 0.6, 0.4}, {0, 1, 0}}) {
        const RL::Surface_location from{f, l};
        CAPTURE(f, l[0], l[1], l[2]);
        const RL::Geodesic_path path = d.shortest_path(from);
        check_path(rays.surface(), from, path);
        const double expected = shapes::length(point(from) - point(to));
        CHECK(path.length == Approx(expected).epsilon(1e-9).margin(1e-9));
        CHECK(shapes::length(path.points.back() - point(to)) < 1e-9);
      }
  }
  SECTION("to the boundary, at a right angle") {
    const auto flat = shapes::grid(9, [](double x, double y) { return RL::Point_3(x, y, 0); });
    const RL::Geodesic_solver on_square = shapes::geodesics(flat);
    RL::Geodesic_sources boundary;
    boundary.add_boundary();
    const RL::Geodesic_function d(on_square, on_square.distances(boundary));
    for(std::size_t f = 0; f < flat.faces.size(); ++f) {
      const RL::Surface_location from{f, {0.2, 0.3, 0.5}};
      const RL::Point_3 p = on_square.surface().surface_point(from).point;
      const double expected =
          (std::min)((std::min)(p.x(), 1 - p.x()), (std::min)(p.y(), 1 - p.y()));
      CHECK(d.shortest_path(from).length == Approx(expected).epsilon(1e-6));
    }
  }
}

TEST_CASE("shortest_paths_are_as_long_as_exact_distances", "[geodesic_path]") {
  CHECK(Paths(shapes::box(1, 2, 0.1, 3, 7), 5).worst < 1e-8);
  CHECK(Paths(shapes::sphere(3), 3).worst < 1e-3);
  CHECK(Paths(shapes::bumpy_square(16, 0.4, 3, 5), 9).mean < 1e-4);
  int number = 0, too_long = 0;
  for(unsigned seed = 1; seed <= 10; ++seed)
    for(const shapes::Triangles& t : {shapes::crumpled(shapes::sphere(2), 0.2, seed),
                                      shapes::crumpled(shapes::box(1, 1, 1, 3, seed), 0.15, seed),
                                      shapes::bumpy_square(8, 0.5, 3, seed)})
      for(const auto method : {RL::Geodesic_method::fast, RL::Geodesic_method::exact}) {
        const Paths paths(t, seed, method);
        number += paths.number;
        too_long += paths.too_long;
        CHECK(paths.worst < 0.01);
      }
  CAPTURE(number);
  CHECK(too_long < 0.001 * number);
  // the strips of a few of these wind around the source
  for(const unsigned seed : {8u, 21u, 24u})
    for(const shapes::Triangles& t :
        {shapes::crumpled(shapes::sphere(4), 0.03, seed), shapes::bumpy_square(20, 0.5, 3, seed)}) {
      CHECK(Paths(t, seed, RL::Geodesic_method::fast).worst < 0.01);
      CHECK(Paths(t, seed, RL::Geodesic_method::exact).worst < 1e-3);
    }
}

TEST_CASE("shortest_paths_go_around_walls", "[geodesic_path]") {
  // the plane without the strip between two columns, up to the middle
  const int n = 12;
  shapes::Triangles t = shapes::grid(n, [](double x, double y) { return RL::Point_3(x, y, 0); });
  std::vector<std::array<std::uint32_t, 3>> faces;
  for(const auto& f : t.faces) {
    const RL::Point_3 c = CGAL::centroid(t.points[f[0]], t.points[f[1]], t.points[f[2]]);
    if(!(c.x() > 0.5 && c.x() < 0.5 + 1. / n && c.y() < 0.5))
      faces.push_back(f);
  }
  t.faces = faces;
  const RL::Geodesic_solver rays = shapes::geodesics(t);
  const RL::Geodesic_function d(rays, rays.distances(RL::Geodesic_sources::vertex(0)));
  const RL::Geodesic_path path = d.shortest_path(rays.location(n));
  const double there = std::sqrt(0.5), across = 1. / n, back = std::hypot(0.5 - across, 0.5);
  CHECK(path.length == Approx(there + across + back).epsilon(1e-9));
  // its two bends
  for(const double x : {0.5, 0.5 + across})
    CHECK(std::any_of(path.points.begin(), path.points.end(), [&](const RL::Point_3& p) {
      return shapes::length(p - RL::Point_3(x, 0.5, 0)) < 1e-9;
    }));
}

TEST_CASE("shortest_paths_cross_edges_with_three_faces", "[geodesic_path]") {
  const shapes::Triangles t = shapes::three_wings(8);
  const std::uint32_t size = 9 * 9;
  const std::size_t source = 5 + 2 * 9;
  const Paths paths(t, source);
  CHECK(paths.number > 3 * 60);
  CHECK(paths.worst < 1e-9);
  // unfolded
  const RL::Geodesic_solver rays = shapes::geodesics(t);
  const RL::Geodesic_function d(rays, rays.distances(RL::Geodesic_sources::vertex(source)));
  CHECK(d.shortest_path(rays.location(2 * size + 7 + 9 * 6)).length ==
        Approx(std::hypot(12. / 8, 4. / 8)));
}

TEST_CASE("shortest_paths_on_hostile_surfaces", "[geodesic_path]") {
  SECTION("soups, in which vertices have any number of fans") {
    int number = 0, too_long = 0;
    for(unsigned seed = 1; seed <= 60; ++seed) {
      CAPTURE(seed);
      const shapes::Triangles t = seed % 2
                                      ? shapes::shared_soup(seed, 12, 30)
                                      : shapes::crumpled(shapes::box(1, 1, 1, 3, seed), 0.5, seed);
      const Paths paths(t, t.faces[0][0]);
      number += paths.number;
      too_long += paths.too_long;
      CHECK(paths.worst < 0.05);
    }
    CAPTURE(number);
    CHECK(too_long < 0.002 * number);
  }
  SECTION("needles, faces of no area, vertices at the same place") {
    CHECK(Paths(shapes::needles(100), 3).worst < 1e-8);
    for(const std::size_t to : {0, 1, 3})
      CHECK(Paths(shapes::square_with_flat_faces(), to).worst < 1e-8);
  }
  SECTION("of any scale") {
    for(double scale : {1e-80, 1e80})
      CHECK(Paths(shapes::scaled(shapes::sphere(2), scale), 3).worst < 1e-2);
  }
}

TEST_CASE("shortest_paths_as_sources_and_where_there_are_none", "[geodesic_path]") {
  const shapes::Triangles one = shapes::sphere(2),
                          two = shapes::joined(one, shapes::moved(one, {3, 0, 0}));
  const RL::Geodesic_solver rays = shapes::geodesics(two);
  const RL::Geodesic_function d(rays, rays.distances(RL::Geodesic_sources::vertex(3)));
  const RL::Geodesic_path path = d.shortest_path(rays.location(40));
  RL::Geodesic_sources sources;
  for(const auto& segment : path.segments)
    sources.add_segment(segment.from, segment.to);
  const std::vector<double> from_path = rays.distances(sources).distances;
  CHECK((from_path[3] < 1e-9 && from_path[40] < 1e-9));
  // from a source
  const RL::Geodesic_path none = d.shortest_path(rays.location(3));
  CHECK((none.segments.empty() && none.points.size() == 1 && none.length == 0));
  CHECK_THROWS_AS(d.shortest_path(rays.location(two.points.size() - 1)), RL::Location_error);
  CHECK_THROWS_AS(d.shortest_path({two.faces.size(), {1, 0, 0}}), RL::Location_error);
  CHECK_THROWS_AS(d.shortest_path({0, {2, 0, 0}}), RL::Location_error);
  CHECK_THROWS_AS(rays.location(two.points.size()), RL::Invalid_vertex_error);
  shapes::Triangles lonely = one;
  lonely.points.emplace_back(0, 0, 0);
  CHECK_THROWS_AS(shapes::geodesics(lonely).location(one.points.size()), RL::Invalid_vertex_error);
}

TEST_CASE("isolines_are_where_the_distance_has_their_value", "[geodesic_path]") {
  const auto check = [](const RL::Geodesic_function& d, double value, std::size_t closed,
                        std::size_t open, double tolerance) {
    std::size_t number_of_closed = 0;
    double sum = 0;
    const std::vector<RL::Geodesic_path> lines = d.isolines(value);
    for(const RL::Geodesic_path& line : lines) {
      REQUIRE(!line.segments.empty());
      check_path(d.surface(), line.segments[0].from, line);
      number_of_closed += shapes::length(line.points.front() - line.points.back()) < 1e-12;
      for(const auto& segment : line.segments)
        for(const auto& end : {segment.from, segment.to})
          CHECK(d.value(end) == Approx(value).epsilon(tolerance));
      sum += line.length;
    }
    CHECK(number_of_closed == closed);
    CHECK(lines.size() == closed + open);
    return sum;
  };
  SECTION("on a sphere") {
    const RL::Geodesic_solver rays = shapes::geodesics(shapes::sphere(4));
    const RL::Geodesic_function d(rays, rays.distances(RL::Geodesic_sources::vertex(3)));
    for(const double r : {0.3, 1.5, 2.5})
      CHECK(check(d, r, 1, 0, 1e-3) == Approx(2 * CGAL_PI * std::sin(r)).epsilon(0.03));
    CHECK(d.isolines(3.2).empty());
    for(const double r : {0., -1., std::nan(""), std::numeric_limits<double>::infinity()})
      CHECK_THROWS_AS(d.isolines(r), RL::Parameter_error);
  }
  SECTION("on a square, from a corner and from its middle") {
    const auto t = shapes::grid(20, [](double x, double y) { return RL::Point_3(x, y, 0); });
    const RL::Geodesic_solver rays = shapes::geodesics(t);
    const auto from = [&](std::size_t v) {
      return RL::Geodesic_function(rays, rays.distances(RL::Geodesic_sources::vertex(v)));
    };
    CHECK(check(from(0), 0.7, 0, 1, 1e-9) == Approx(CGAL_PI / 2 * 0.7).epsilon(1e-3));
    CHECK(check(from(220), 0.4, 1, 0, 1e-9) == Approx(2 * CGAL_PI * 0.4).epsilon(2e-3));
    check(from(220), 0.6, 0, 4, 1e-9);
    // two circles
    RL::Geodesic_sources two = RL::Geodesic_sources::vertex(5 + 21 * 10);
    two.add_vertex(15 + 21 * 10);
    check(RL::Geodesic_function(rays, rays.distances(two)), 0.2, 2, 0, 1e-9);
  }
  SECTION("where edges have three faces") {
    const RL::Geodesic_solver rays = shapes::geodesics(shapes::three_wings(8));
    const RL::Geodesic_function d(rays, rays.distances(RL::Geodesic_sources::vertex(3 + 9 * 4)));
    // a circle in one wing that is cut by the axis, and arcs in two others
    check(d, 0.45, 0, 3, 1e-9);
  }
}

TEST_CASE("shortest_paths_on_meshes", "[geodesic_path]") {
  const shapes::Mesh mesh = shapes::mesh(shapes::sphere(3));
  const shapes::Mesh::Vertex_index a(3), b(70);
  const RL::Geodesic_path path = RL::shortest_path(mesh, a, b);
  CHECK(path.points.front() ==
        RL::Point_3(mesh.point(a).x(), mesh.point(a).y(), mesh.point(a).z()));
  CHECK(path.points.back() == RL::Point_3(mesh.point(b).x(), mesh.point(b).y(), mesh.point(b).z()));
  shapes::Mesh own = mesh;
  auto distance = own.add_property_map<shapes::Mesh::Vertex_index, double>("v:d").first;
  RL::geodesic_distances(own, b, distance);
  CHECK(path.length == Approx(distance[a]).epsilon(1e-3));
}
