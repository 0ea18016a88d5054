// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "catch.h"
#include "point_shapes.h"
#include "shapes.h"
#include "special_shapes.h"

#include <CGAL/IO/Color.h>
#include <CGAL/Restricted_laplacian_3/input/read_surface.h>
#include <CGAL/Restricted_laplacian_3/textures/back_project_colors.h>
#include <CGAL/Restricted_laplacian_3/textures/internal/Labelling.h>
#include <CGAL/Restricted_laplacian_3/textures/internal/Scan_choice.h>
#include <CGAL/Restricted_laplacian_3/textures/internal/exposure_gains.h>
#include <CGAL/Restricted_laplacian_3/textures/internal/harmonic_fill.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace RL = CGAL::Restricted_laplacian_3;
namespace params = RL::parameters;
using RL::Point_3;
using RL::Rgb_color;
using RL::Vector_3;

const double scan_nan = std::numeric_limits<double>::quiet_NaN();

/// the square 0 .. 1 in the plane z = 0, in 2 n^2 triangles, its normal upwards
shapes::Triangles scan_plane(int n) {
  shapes::Triangles t;
  for(int j = 0; j <= n; ++j)
    for(int i = 0; i <= n; ++i)
      t.points.emplace_back(double(i) / n, double(j) / n, 0);
  for(std::uint32_t j = 0; j < std::uint32_t(n); ++j)
    for(std::uint32_t i = 0; i < std::uint32_t(n); ++i) {
      const std::uint32_t a = i + j * (n + 1), b = a + n + 1;
      t.faces.push_back({a, a + 1, b + 1});
      t.faces.push_back({a, b + 1, b});
    }
  return t;
}

RL::Triangulated_surface_3 scan_surface(const shapes::Triangles& t) {
  return RL::read_surface(RL::soup(t.points, t.faces));
}

/// linear in space
Rgb_color linear_color(const Point_3& p) {
  return {0.3 + 0.2 * p.x() + 0.1 * p.z(), 0.5 - 0.3 * p.y() + 0.1 * p.x(), 0.4};
}

template <class Points> std::vector<Rgb_color> linear_colors(const Points& points) {
  std::vector<Rgb_color> colors;
  for(const Point_3& p : points)
    colors.push_back(linear_color(p));
  return colors;
}

const RL::Scan_pose scan_identity = RL::Scan_pose(CGAL::IDENTITY);
const Point_3 scan_above(0.5, 0.5, 10);

} // namespace

TEST_CASE("samples_of_a_mesh_are_exact_for_linear_colors", "[stitch]") {
  const shapes::Triangles t = scan_plane(10);
  const RL::Colored_scan scan(scan_surface(t), linear_colors(t.points), scan_identity, scan_above);
  CHECK(scan.spacing() == Approx(0.1));
  RL::Colored_scan::Sampler sampler(scan);
  RL::Scan_sample s;
  for(const Point_3& p : {Point_3(0.43, 0.57, 0.02), Point_3(0.91, 0.13, -0.03)}) {
    REQUIRE(sampler(p, 0.05, s));
    const Rgb_color expected = linear_color(Point_3(p.x(), p.y(), 0));
    for(int k = 0; k < 3; ++k)
      CHECK(s.color[k] == Approx(expected[k]).epsilon(1e-13));
    Eigen::Matrix3d gradient;
    gradient << 0.2, 0.1, 0, 0, -0.3, 0, 0, 0, 0;
    CHECK((s.gradient - gradient).norm() < 1e-13);
    CHECK(s.distance == Approx(std::abs(p.z())));
    CHECK(s.normal == Vector_3(0, 0, 1));
    CHECK_FALSE(s.is_beyond_boundary);
  }
  CHECK(s.boundary_distance == Approx(0.09).epsilon(1e-12)); // linear between 0.1 and 0
  CHECK_FALSE(sampler(Point_3(0.5, 0.5, 0.051), 0.05, s));
  CHECK_FALSE(sampler(Point_3(100, 0.5, 0), 0.05, s));
  REQUIRE(sampler(Point_3(1.03, 0.5, 0), 0.05, s));
  CHECK(s.is_beyond_boundary);
  CHECK(s.distance == Approx(0.03));
  REQUIRE(sampler(Point_3(1.005, 0.5, 0), 0.05, s)); // less than a tenth of the spacing
  CHECK_FALSE(s.is_beyond_boundary);
  REQUIRE(sampler(Point_3(1, 0.5, 0.04), 0.05, s)); // over the boundary
  CHECK_FALSE(s.is_beyond_boundary);
  CHECK(s.boundary_distance == 0);
}

TEST_CASE("nearest_points_are_those_of_all_triangles", "[stitch]") {
  const shapes::Triangles t = shapes::box(1, 0.7, 0.3, 60, 5);
  const RL::Triangulated_surface_3 surface = scan_surface(t);
  const RL::Colored_scan scan(surface, linear_colors(t.points), scan_identity, Point_3(5, 5, 5));
  RL::Colored_scan::Sampler sampler(scan);
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> uniform(-0.8, 0.8);
  int found = 0;
  for(int i = 0; i < 300; ++i) {
    const Point_3 q(uniform(generator), uniform(generator), uniform(generator));
    double nearest = std::numeric_limits<double>::infinity();
    for(std::size_t f = 0; f < surface.number_of_faces(); ++f)
      nearest = (std::min)(
          nearest, std::sqrt(CGAL::squared_distance(
                       q, CGAL::Simple_cartesian<double>::Triangle_3(
                              surface.point(f, 0), surface.point(f, 1), surface.point(f, 2)))));
    RL::Scan_sample s;
    const bool is_found = sampler(q, 0.3, s);
    CHECK(is_found == (nearest <= 0.3));
    found += is_found;
    if(is_found)
      CHECK(s.distance == Approx(nearest).epsilon(1e-10));
  }
  CHECK(found > 50);
  CHECK(found < 290);
}

TEST_CASE("points_of_a_scan_hold_linear_functions", "[stitch]") {
  std::vector<std::pair<Point_3, Vector_3>> points;
  std::vector<std::array<double, 3>> colors;
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> uniform(-0.01, 0.01);
  for(int j = 0; j <= 20; ++j)
    for(int i = 0; i <= 20; ++i) {
      const Point_3 p(i / 20. + uniform(generator), j / 20. + uniform(generator), 0);
      points.emplace_back(p, Vector_3(0, 0, i % 2 ? -2 : 1)); // turned to the viewpoint
      colors.push_back(linear_color(p));
    }
  using Point = std::pair<Point_3, Vector_3>;
  const RL::Colored_scan scan(points, CGAL::make_property_map(colors),
                              params::viewpoint(scan_above)
                                  .point_map(CGAL::First_of_pair_property_map<Point>())
                                  .normal_map(CGAL::Second_of_pair_property_map<Point>()));
  CHECK(scan.spacing() == Approx(0.05).epsilon(0.1));
  RL::Colored_scan::Sampler sampler(scan);
  RL::Scan_sample s;
  const Point_3 p(0.43, 0.57, 0.02);
  REQUIRE(sampler(p, 0.1, s));
  const Rgb_color expected = linear_color(Point_3(p.x(), p.y(), 0));
  for(int k = 0; k < 3; ++k)
    CHECK(s.color[k] == Approx(expected[k]).epsilon(1e-12));
  Eigen::Matrix3d gradient;
  gradient << 0.2, 0.1, 0, 0, -0.3, 0, 0, 0, 0;
  CHECK((s.gradient - gradient).norm() < 1e-11);
  CHECK(s.normal == Vector_3(0, 0, 1));
  CHECK_FALSE(s.is_beyond_boundary);
  CHECK(s.boundary_distance == Approx(0.43).epsilon(0.2));
  REQUIRE(sampler(Point_3(1.05, 0.5, 0), 0.1, s));
  CHECK(s.is_beyond_boundary);
}

TEST_CASE("vertices_are_covered_by_the_rules", "[stitch]") {
  const shapes::Triangles t = scan_plane(20);
  const RL::Triangulated_surface_3 surface = scan_surface(t);
  const auto scan_at = [&](double z, const Point_3& viewpoint) {
    shapes::Triangles moved = shapes::moved(t, Vector_3(0, 0, z));
    return RL::Colored_scan(scan_surface(moved), linear_colors(moved.points), scan_identity,
                            viewpoint);
  };
  const auto number = [&](const RL::Colored_scan& scan, const RL::Back_projection_options& o) {
    return RL::back_project_colors(surface, scan, o).vertices.size();
  };
  RL::Back_projection_options options;
  CHECK(number(scan_at(0.03, scan_above), options) == 441);
  CHECK(RL::back_project_colors(surface, scan_at(0.03, scan_above), options).gradients.size() ==
        441);
  options.with_gradients = false;
  CHECK(RL::back_project_colors(surface, scan_at(0.03, scan_above), options).gradients.empty());
  // distance
  options.maximum_distance = 0.029;
  CHECK(number(scan_at(0.03, scan_above), options) == 0);
  options.maximum_distance = 0.031;
  CHECK(number(scan_at(0.03, scan_above), options) == 441);
  // 4 spacings
  options.maximum_distance.reset();
  CHECK(number(scan_at(0.19, scan_above), options) == 441);
  CHECK(number(scan_at(0.21, scan_above), options) == 0);
  // facing: from below, and at a low angle
  CHECK(number(scan_at(0, Point_3(0.5, 0.5, -1)), options) == 0);
  CHECK(RL::back_project_colors(surface, scan_at(0, Point_3(0.5, 0.5, -1)), options)
            .number_of_facing_vertices == 0);
  CHECK(number(scan_at(0, Point_3(100.5, 0.5, 9.9)), options) == 0);
  CHECK(number(scan_at(0, Point_3(100.5, 0.5, 10.2)), options) == 441);
  options.oriented = false;
  CHECK(number(scan_at(0, Point_3(0.5, 0.5, -1)), options) == 441);
  // normals: a scan that is tilted around the y axis, by 50 and 70 degrees
  options = RL::Back_projection_options();
  options.maximum_distance = 1;
  for(const double angle : {50., 70.}) {
    const double c = std::cos(angle * CGAL_PI / 180), s = std::sin(angle * CGAL_PI / 180);
    const RL::Colored_scan tilted(surface, linear_colors(t.points),
                                  RL::scan_pose({c, 0, -s, 0, 0, 1, 0, 0, s, 0, c, 0, 0, 0, 0, 1}),
                                  Point_3(0.5, 0.5, 10));
    CHECK((number(tilted, options) > 0) == (angle < 60));
  }
}

TEST_CASE("quality_is_that_of_the_formula", "[stitch]") {
  const shapes::Triangles t = scan_plane(20);
  const RL::Triangulated_surface_3 surface = scan_surface(t);
  const shapes::Triangles moved = shapes::moved(t, Vector_3(0, 0, 0.02));
  const Point_3 viewpoint(0.5, 0.5, 2);
  const RL::Colored_scan scan(scan_surface(moved), linear_colors(moved.points), scan_identity,
                              viewpoint);
  RL::Back_projection_options options;
  options.maximum_distance = 0.1;
  options.boundary_width = 0.25;
  const RL::Back_projection projection = RL::back_project_colors(surface, scan, options);
  REQUIRE(projection.vertices.size() == 441);
  for(std::size_t v = 0; v < 441; ++v) {
    REQUIRE(projection.vertices[v] == v);
    const Point_3& p = t.points[v];
    const double b = (std::min)({p.x(), p.y(), 1 - p.x(), 1 - p.y()});
    const double facing = 2 / std::sqrt((viewpoint - p).squared_length());
    CHECK(projection.qualities[v] ==
          Approx((1 - 0.02 / 0.2) * facing * (std::min)(1., (b + 0.05) / 0.3)));
    CHECK(projection.distances[v] == Approx(0.02));
    const Rgb_color expected = linear_color(moved.points[v]);
    for(int k = 0; k < 3; ++k)
      CHECK(projection.colors[v][k] == Approx(expected[k]));
  }
}

TEST_CASE("poses_of_scans_are_undone", "[stitch]") {
  const shapes::Triangles t = scan_plane(10);
  const RL::Triangulated_surface_3 surface = scan_surface(t);
  // rotation by 120 degrees around (1, 1, 1), times 2.5, and a translation
  const RL::Scan_pose pose = RL::scan_pose({0, 0, 2.5, 1, 2.5, 0, 0, -2, 0, 2.5, 0, 3, 0, 0, 0, 1});
  shapes::Triangles in_scan = t;
  for(Point_3& p : in_scan.points)
    p = pose.inverse().transform(p);
  const RL::Colored_scan plain(surface, linear_colors(t.points), scan_identity, scan_above),
      posed(scan_surface(in_scan), linear_colors(t.points), pose,
            pose.inverse().transform(scan_above));
  const RL::Back_projection a = RL::back_project_colors(surface, plain),
                            b = RL::back_project_colors(surface, posed);
  REQUIRE(a.vertices == b.vertices);
  CHECK(a.vertices.size() == 121);
  for(std::size_t i = 0; i < a.vertices.size(); ++i) {
    CHECK(a.qualities[i] == Approx(b.qualities[i]).epsilon(1e-12));
    CHECK((a.gradients[i] - b.gradients[i]).norm() < 1e-10);
    for(int k = 0; k < 3; ++k)
      CHECK(a.colors[i][k] == Approx(b.colors[i][k]).epsilon(1e-12));
  }
  CHECK(std::sqrt(CGAL::squared_distance(posed.viewpoint(), scan_above)) < 1e-12);
}

TEST_CASE("back_projection_does_not_depend_on_the_scale", "[stitch]") {
  const shapes::Triangles t = shapes::sphere(3);
  const std::vector<Rgb_color> colors = linear_colors(t.points);
  const auto project = [&](double scale) {
    const shapes::Triangles scaled = shapes::scaled(t, scale);
    const RL::Colored_scan scan(scan_surface(scaled),
                                std::vector<Rgb_color>(colors.size(), Rgb_color{0.1, 0.2, 0.3}),
                                scan_identity, Point_3(5 * scale, 0, 0));
    return RL::back_project_colors(scan_surface(scaled), scan);
  };
  const std::vector<std::uint32_t> expected = project(1).vertices;
  CHECK(expected.size() > 30);
  for(const double scale : {1e-60, 1e60, 1e-99, 1e99})
    CHECK(project(scale).vertices == expected);
}

TEST_CASE("back_projection_does_not_depend_on_the_number_of_threads", "[stitch]") {
  const shapes::Triangles t = shapes::sphere(6), coarse = shapes::sphere(4);
  const RL::Triangulated_surface_3 surface = scan_surface(t);
  const RL::Colored_scan scan(scan_surface(coarse),
                              std::vector<Rgb_color>(coarse.points.size(), Rgb_color{1, 0, 0.5}),
                              scan_identity, Point_3(5, 0, 0));
  const RL::Back_projection serial = RL::Color_back_projector(surface)(scan),
                            parallel = RL::Color_back_projector(
                                surface,
                                params::concurrency_tag(CGAL::Parallel_if_available_tag()))(scan);
  CHECK(serial.vertices == parallel.vertices);
  CHECK(serial.qualities == parallel.qualities);
  CHECK(serial.distances == parallel.distances);
  // those of one point after the other
  std::size_t facing = 0;
  for(const Point_3& p : t.points) {
    const Vector_3 to_viewpoint = Point_3(5, 0, 0) - p;
    facing += (p - CGAL::ORIGIN) * to_viewpoint >= 0.1 * std::sqrt(to_viewpoint.squared_length());
  }
  CHECK(std::abs(static_cast<double>(serial.vertices.size()) - static_cast<double>(facing)) < 20);
  CHECK(std::is_sorted(serial.vertices.begin(), serial.vertices.end()));
}

TEST_CASE("pose_and_viewpoint_of_named_parameters_are_those_of_the_constructor", "[stitch]") {
  const shapes::Triangles t = scan_plane(4);
  const std::vector<Rgb_color> colors = linear_colors(t.points);
  const RL::Scan_pose pose = RL::scan_pose({0, 0, 2.5, 1, 2.5, 0, 0, -2, 0, 2.5, 0, 3, 0, 0, 0, 1});
  const auto np = params::pose(pose).viewpoint(Point_3(1, 2, 3));
  const RL::Colored_scan soup(RL::soup(t.points, t.faces), CGAL::make_property_map(colors), np);
  shapes::Mesh mesh = shapes::mesh(t);
  auto map = mesh.add_property_map<shapes::Mesh::Vertex_index, Rgb_color>("v:rgb").first;
  for(const auto v : mesh.vertices())
    map[v] = colors[v];
  const RL::Colored_scan of_mesh(mesh, map, np);
  for(const RL::Colored_scan& scan : {soup, of_mesh}) {
    CHECK(scan.viewpoint() == Point_3(8.5, 0.5, 8)); // 2.5 (z, x, y) + (1, -2, 3)
    CHECK(scan.spacing() == Approx(2.5 / 4));
    for(std::size_t v = 0; v < t.points.size(); ++v)
      CHECK(scan.surface().point(v) ==
            Point_3(1, 2.5 * t.points[v].x() - 2, 2.5 * t.points[v].y() + 3));
  }
}

TEST_CASE("colors_of_maps_are_read", "[stitch]") {
  shapes::Mesh mesh = shapes::mesh(scan_plane(3));
  using Vertex = shapes::Mesh::Vertex_index;
  auto bytes = mesh.add_property_map<Vertex, CGAL::IO::Color>("v:a").first;
  auto integers = mesh.add_property_map<Vertex, std::array<unsigned char, 3>>("v:b").first;
  auto vectors = mesh.add_property_map<Vertex, Vector_3>("v:c").first;
  auto eigen = mesh.add_property_map<Vertex, Eigen::Vector3f>("v:d", Eigen::Vector3f::Zero()).first;
  for(const Vertex v : mesh.vertices()) {
    const auto r = static_cast<unsigned char>(10 * v);
    bytes[v] = CGAL::IO::Color(r, 51, 255);
    integers[v] = {r, 51, 255};
    vectors[v] = Vector_3(r / 255., 0.2, 1);
    eigen[v] = Eigen::Vector3f(r / 255.f, 0.2f, 1);
  }
  const RL::Colored_scan a(mesh, bytes), b(mesh, integers), c(mesh, vectors), d(mesh, eigen);
  for(std::size_t v = 0; v < 16; ++v) {
    CHECK(a.colors()[v][0] == 10. * v / 255);
    CHECK(a.colors()[v][1] == Approx(0.2));
    CHECK(a.colors()[v][2] == 1);
    CHECK(b.colors()[v] == a.colors()[v]);
    for(int k = 0; k < 3; ++k) {
      CHECK(c.colors()[v][k] == Approx(a.colors()[v][k]));
      CHECK(d.colors()[v][k] == Approx(a.colors()[v][k]));
    }
  }
}

TEST_CASE("bad_scans_are_refused", "[stitch]") {
  const shapes::Triangles t = scan_plane(2);
  const RL::Triangulated_surface_3 surface = scan_surface(t);
  const std::vector<Rgb_color> colors = linear_colors(t.points);
  const auto scan = [&](const std::vector<Rgb_color>& c, const RL::Scan_pose& pose,
                        const Point_3& viewpoint = scan_above) {
    RL::Colored_scan(surface, c, pose, viewpoint);
  };
  CHECK_NOTHROW(scan(colors, scan_identity));
  CHECK_THROWS_WITH(scan({}, scan_identity), "colors has 0 values, but the scan has 9 vertices");
  for(const double x : {scan_nan, -0.01, 1.01, 255.}) {
    std::vector<Rgb_color> bad = colors;
    bad[4][2] = x;
    CHECK_THROWS_AS(scan(bad, scan_identity), RL::Invalid_vertex_error);
    CHECK_THROWS_WITH(scan(bad, scan_identity), "vertex 4 has a color that is not in 0 .. 1");
  }
  CHECK_THROWS_WITH(scan(colors, scan_identity, Point_3(0, scan_nan, 0)),
                    Catch::Contains("viewpoint"));
  const auto pose = [](std::array<double, 16> rows) { RL::scan_pose(rows); };
  CHECK_NOTHROW(pose({1, 0, 0, 5, 0, 1, 0, 6, 0, 0, 1, 7, 0, 0, 0, 1}));
  CHECK_THROWS_WITH(pose({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1}),
                    Catch::Contains("last row"));
  CHECK_THROWS_WITH(pose({1, 0, 0, 5, 0, 1, 0, 6, 0, 0, -1, 7, 0, 0, 0, 1}),
                    Catch::Contains("mirrored"));
  CHECK_THROWS_WITH(pose({0, 0, 0, 5, 0, 0, 0, 6, 0, 0, 0, 7, 0, 0, 0, 1}),
                    Catch::Contains("singular"));
  CHECK_THROWS_WITH(pose({1, 0.1, 0, 5, 0, 1, 0, 6, 0, 0, 1, 7, 0, 0, 0, 1}),
                    Catch::Contains("not a rotation"));
  CHECK_THROWS_WITH(pose({1, 0, 0, 5, 0, 1, 0, 6, 0, 0, 2, 7, 0, 0, 0, 1}),
                    Catch::Contains("not a rotation"));
  CHECK_THROWS_WITH(pose({1, 0, scan_nan, 5, 0, 1, 0, 6, 0, 0, 1, 7, 0, 0, 0, 1}),
                    Catch::Contains("finite"));
  CHECK_THROWS_AS(scan(colors, RL::Scan_pose(CGAL::SCALING, -1.)), RL::Parameter_error);
  CHECK_THROWS_AS(scan(colors, RL::Scan_pose(CGAL::TRANSLATION, Vector_3(0, scan_nan, 0))),
                  RL::Parameter_error);

  const auto with = [&](auto change) {
    RL::Back_projection_options options;
    change(options);
    RL::Color_back_projector(surface, options);
  };
  using O = RL::Back_projection_options;
  CHECK_NOTHROW(with([](O&) {}));
  CHECK_THROWS_WITH(with([](O& o) { o.maximum_distance = 0; }), Catch::Contains("maximum_dist"));
  CHECK_THROWS_WITH(with([](O& o) { o.maximum_distance = scan_nan; }), Catch::Contains("maximum"));
  CHECK_THROWS_WITH(with([](O& o) { o.boundary_width = -1; }), Catch::Contains("boundary_width"));
  CHECK_THROWS_WITH(with([](O& o) { o.minimum_facing_cosine = 1.1; }), Catch::Contains("facing"));
  CHECK_THROWS_WITH(with([](O& o) { o.normal_angle = -2; }), Catch::Contains("normal"));
  const RL::Triangulated_surface_3 points({Point_3(0, 0, 0), Point_3(1, 0, 0)},
                                          {Vector_3(0, 0, 1), Vector_3(0, 0, 1)}, {1, 1});
  CHECK_THROWS_WITH(RL::Color_back_projector(points), Catch::Contains("needs triangles"));
}

TEST_CASE("scans_of_few_points_and_bad_triangles_do_no_harm", "[stitch]") {
  const RL::Triangulated_surface_3 surface = scan_surface(scan_plane(4));
  const RL::Triangulated_surface_3 two({Point_3(0.5, 0.5, 0), Point_3(0.6, 0.5, 0)},
                                       {Vector_3(0, 0, 1), Vector_3(0, 0, 1)}, {1, 1});
  const RL::Colored_scan of_points(two, {{0.1, 0.2, 0.3}, {0.2, 0.2, 0.3}}, scan_identity,
                                   scan_above);
  const RL::Back_projection p = RL::back_project_colors(surface, of_points);
  REQUIRE(p.vertices == std::vector<std::uint32_t>{12}); // the one at the first point
  CHECK(p.colors[0][0] == Approx(0.1));

  shapes::Triangles t = scan_plane(4);
  t.points.emplace_back(scan_nan, 0, 0); // no face names it
  t.points.emplace_back(0.125, 0, 0);
  t.faces.push_back({0, 1, 26}); // in a line
  t.faces.push_back({3, 3, 4});  // a corner twice
  t.faces.push_back({0, 1, 6});  // a face twice
  const RL::Colored_scan bad(scan_surface(t),
                             std::vector<Rgb_color>(t.points.size(), Rgb_color{0.5, 0.5, 0.5}),
                             scan_identity, scan_above);
  const RL::Back_projection q = RL::back_project_colors(scan_surface(t), bad);
  CHECK(q.vertices.size() == 25);
  for(std::size_t i = 0; i < q.vertices.size(); ++i) {
    CHECK(q.colors[i] == Rgb_color{0.5, 0.5, 0.5});
    CHECK(q.qualities[i] > 0);
    CHECK(q.qualities[i] <= 1);
    CHECK(q.gradients[i].norm() < 1e-12);
  }
}

namespace {

RL::Back_projection choice_projection(const RL::Triangulated_surface_3& surface, unsigned seed) {
  RL::Back_projection projection;
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(-0.1, 0.1);
  for(std::uint32_t v = 0; v < surface.number_of_vertices(); ++v) {
    projection.vertices.push_back(v);
    const double x = surface.point(v).x();
    projection.qualities.push_back((seed == 1 ? 0.7 - 0.4 * x : 0.3 + 0.4 * x) +
                                   uniform(generator));
  }
  return projection;
}

double choice_energy(const RL::Triangulated_surface_3& surface,
                     const std::vector<RL::Back_projection>& scans,
                     const std::vector<std::uint32_t>& choice, double seam_weight) {
  const auto sides = RL::internal::shared_sides(surface);
  double length = 0, sum = 0;
  for(const auto& side : sides)
    length += side.length;
  for(const auto& side : sides)
    if(choice[side.face] != choice[side.other])
      sum += seam_weight * side.length * static_cast<double>(sides.size()) / length;
  for(std::size_t f = 0; f < choice.size(); ++f) {
    double quality = 1;
    for(std::uint32_t v : surface.triangle(f))
      quality = (std::min)(quality, scans[choice[f]].qualities[v]);
    sum += surface.area(f) / surface.area() * static_cast<double>(choice.size()) * (1 - quality);
  }
  return sum;
}

} // namespace

TEST_CASE("the_chosen_scan_is_the_best_where_seams_cost_nothing", "[stitch]") {
  const RL::Triangulated_surface_3 surface = scan_surface(scan_plane(20));
  std::vector<RL::Back_projection> scans = {choice_projection(surface, 1),
                                            choice_projection(surface, 2)};
  scans[1].vertices.erase(scans[1].vertices.begin() + 210); // a vertex in the middle
  scans[1].qualities.erase(scans[1].qualities.begin() + 210);
  const std::vector<std::uint32_t> choice =
      RL::internal::Scan_choice(surface, scans, 0, 0, false).scans_of_faces();
  for(std::size_t f = 0; f < choice.size(); ++f) {
    std::array<double, 2> quality = {1, 1};
    for(std::uint32_t v : surface.triangle(f)) {
      quality[0] = (std::min)(quality[0], scans[0].qualities[v]);
      quality[1] = (std::min)(quality[1], v == 210  ? -1
                                          : v < 210 ? scans[1].qualities[v]
                                                    : scans[1].qualities[v - 1]);
    }
    CHECK(choice[f] == (quality[1] > quality[0] ? 1 : 0));
  }
}

TEST_CASE("seams_become_short", "[stitch]") {
  const RL::Triangulated_surface_3 surface = scan_surface(scan_plane(40));
  const std::vector<RL::Back_projection> scans = {choice_projection(surface, 1),
                                                  choice_projection(surface, 2)};
  using Choice = RL::internal::Scan_choice;
  const Choice rough(surface, scans, 0, 0, false), shorter(surface, scans, 0, 0.05, false),
      smooth(surface, scans, 5, 0.05, false);
  CHECK(rough.seam_length() > 4); // the shortest seam has the length 1
  CHECK(shorter.seam_length() < rough.seam_length() / 2);
  CHECK(smooth.seam_length() < 1.6);
  CHECK(choice_energy(surface, scans, shorter.scans_of_faces(), 0.05) <
        choice_energy(surface, scans, rough.scans_of_faces(), 0.05));
  // the scan of a vertex is one of its faces
  const std::vector<std::uint32_t> of_vertices = rough.scans_of_vertices();
  std::vector<std::set<std::uint32_t>> of_faces(of_vertices.size());
  for(std::size_t f = 0; f < surface.number_of_faces(); ++f)
    for(std::uint32_t v : surface.triangle(f))
      of_faces[v].insert(rough.scans_of_faces()[f]);
  for(std::size_t v = 0; v < of_vertices.size(); ++v)
    CHECK(of_faces[v].count(of_vertices[v]) == 1);
}

namespace {

using Label_edge = RL::internal::Labelling::Edge;

double label_energy(const std::vector<std::vector<double>>& costs,
                    const std::vector<Label_edge>& edges,
                    const std::vector<std::uint32_t>& labels) {
  double sum = 0;
  for(std::size_t i = 0; i < costs.size(); ++i)
    sum += costs[i][labels[i]];
  for(const Label_edge& edge : edges)
    if(labels[edge.i] != labels[edge.j])
      sum += edge.cost;
  return sum;
}

/// the labels, each 0 or 1, that a number stands for
std::vector<std::uint32_t> labels_of_bits(std::size_t n, unsigned bits) {
  std::vector<std::uint32_t> labels(n);
  for(std::size_t i = 0; i < n; ++i)
    labels[i] = bits >> i & 1;
  return labels;
}

} // namespace

TEST_CASE("two_labels_are_the_cheapest_and_no_expansion_of_more_is_cheaper", "[stitch]") {
  const double infinity = std::numeric_limits<double>::infinity();
  const std::size_t n = 10;
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> uniform(0, 1);
  for(const std::size_t number_of_labels : {2, 4})
    for(int graph = 0; graph < 20; ++graph) {
      std::vector<std::vector<double>> costs(n);
      for(auto& of_vertex : costs) {
        for(std::size_t label = 0; label < number_of_labels; ++label)
          of_vertex.push_back(uniform(generator) < 0.1 ? infinity : uniform(generator));
        of_vertex[generator() % number_of_labels] = 0.5;
      }
      std::vector<Label_edge> edges;
      for(std::uint32_t i = 0; i < n; ++i)
        for(std::uint32_t j = i + 1; j < n; ++j)
          if(uniform(generator) < 0.4) // in weak and strong graphs, and twice
            edges.push_back({i, j, uniform(generator) * (graph % 4 + 1) / 8});
      edges.push_back(edges.front());
      const RL::internal::Labelling labelling(costs, edges);
      const std::vector<std::uint32_t>& labels = labelling.labels();
      REQUIRE(labels.size() == n);
      const double found = label_energy(costs, edges, labels);
      CHECK(found < infinity);
      double smallest = infinity;
      for(std::uint32_t label = 0; label < number_of_labels; ++label)
        for(unsigned bits = 0; bits < 1u << n; ++bits) {
          std::vector<std::uint32_t> others = labels_of_bits(n, bits);
          if(number_of_labels > 2) // those that take the label
            for(std::size_t i = 0; i < n; ++i)
              others[i] = others[i] ? label : labels[i];
          smallest = (std::min)(smallest, label_energy(costs, edges, others));
        }
      CHECK(found == Approx(smallest).epsilon(1e-9));
    }
}

TEST_CASE("linear_functions_are_filled_in", "[stitch]") {
  shapes::Triangles t = scan_plane(8);
  for(Point_3& p : t.points)
    p = Point_3(p.x() + 0.05 * std::sin(7 * p.y()), p.y(), 0);
  const RL::Triangulated_surface_3 surface = scan_surface(t);
  const std::vector<char> is_on_boundary = RL::internal::Surface_edges(surface).boundary_vertices();
  Eigen::MatrixXd exact(81, 2), values(81, 2);
  for(Eigen::Index v = 0; v < 81; ++v) {
    const Point_3& p = surface.point(static_cast<std::size_t>(v));
    exact.row(v) << 1 + p.x() - 2 * p.y(), 3 * p.y();
  }
  values = exact;
  for(Eigen::Index v = 0; v < 81; ++v)
    if(!is_on_boundary[static_cast<std::size_t>(v)])
      values.row(v) << -1, 1e3;
  RL::internal::fill_harmonically(surface, is_on_boundary, values);
  CHECK((values - exact).cwiseAbs().maxCoeff() < 1e-13);
}

TEST_CASE("fills_that_rounding_makes_singular_are_refused", "[stitch]") {
  // The squares of both long sides, and minus their product, are 1 to the last bit.
  const RL::Triangulated_surface_3 needle(
      {Point_3(0, 0, 0), Point_3(0, 1e-8, 0), Point_3(1, 5e-9, 0)}, {{0, 1, 2}});
  Eigen::MatrixXd values = Eigen::MatrixXd::Zero(3, 3);
  CHECK_THROWS_AS(RL::internal::fill_harmonically(needle, {0, 0, 1}, values), RL::Numerical_error);
  CHECK_NOTHROW(RL::internal::fill_harmonically(needle, {0, 1, 1}, values));
}

TEST_CASE("exposures_are_found_from_overlaps", "[stitch]") {
  // Scans 0 .. 3 overlap in a row, scan 4 overlaps with none. Some colors are wrong.
  const std::array<double, 5> exposures = {0.5, 0.8, 0.7, 0.6, 0.9};
  std::vector<RL::Back_projection> scans(5);
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> uniform(0.3, 0.9);
  std::vector<Rgb_color> truth;
  for(int v = 0; v < 1000; ++v)
    truth.push_back({uniform(generator), uniform(generator), uniform(generator)});
  for(std::uint32_t s = 0; s < 5; ++s)
    for(std::uint32_t v = s == 4 ? 950 : 150 * s; v < (s == 4 ? 1000 : 150 * s + 250); ++v) {
      Rgb_color c = truth[v];
      for(int k = 0; k < 3; ++k)
        c[k] *= v % 5 == 0 ? uniform(generator) : exposures[s] * (k == 1 ? 0.9 : 1);
      scans[s].vertices.push_back(v);
      scans[s].colors.push_back(c);
      scans[s].qualities.push_back(0.5);
    }
  const std::vector<Rgb_color> gains = RL::internal::exposure_gains(scans);
  for(int k = 0; k < 3; ++k) {
    double product = 1;
    for(int s = 0; s < 4; ++s) {
      product *= gains[s][k];
      CHECK(gains[s][k] * exposures[s] == Approx(gains[0][k] * exposures[0]).epsilon(1e-6));
    }
    CHECK(product == Approx(1).epsilon(1e-6));
    CHECK(gains[4][k] == 1);
  }
  // badly seen or cut off: no ratio is left
  for(double& q : scans[1].qualities)
    q = 0.05;
  for(Rgb_color& c : scans[3].colors)
    c = {1, 0, 1};
  for(const Rgb_color& gain : RL::internal::exposure_gains(scans))
    CHECK(gain == Rgb_color{1, 1, 1});
}

TEST_CASE("srgb_is_inverted", "[stitch]") {
  CHECK(RL::srgb_to_linear(0) == 0);
  CHECK(RL::srgb_to_linear(1) == Approx(1));
  CHECK(RL::srgb_to_linear(0.5) == Approx(0.21404114048));
  for(int i = 0; i <= 1000; ++i) {
    const double x = i / 1000.;
    CHECK(RL::linear_to_srgb(RL::srgb_to_linear(x)) == Approx(x).margin(1e-7));
    const double h = 1e-6;
    if(std::abs(x - 0.04045) > 1e-3)
      CHECK(RL::internal::srgb_to_linear_derivative(x) ==
            Approx((RL::srgb_to_linear(x + h) - RL::srgb_to_linear(x - h)) / (2 * h)));
  }
}
