// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "catch.h"
#include "shapes.h"

#include <CGAL/Restricted_laplacian_3/assembly/assemble.h>
#include <CGAL/Restricted_laplacian_3/estimate_curvature.h>
#include <CGAL/Restricted_laplacian_3/fit_function.h>
#include <CGAL/Restricted_laplacian_3/geodesic_distances.h>
#include <CGAL/Restricted_laplacian_3/integrate_gradient_field.h>
#include <CGAL/Restricted_laplacian_3/laplace_spectrum.h>
#include <CGAL/Restricted_laplacian_3/solve_poisson.h>

#include <CGAL/Surface_mesh.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

// Faces with more than three corners, and the kinds of surfaces that functions take.

namespace RL = CGAL::Restricted_laplacian_3;
namespace params = RL::parameters;
using shapes::Mesh;

namespace {

using Polygons = std::vector<std::vector<std::size_t>>;

struct Soup {
  std::vector<RL::Point_3> points;
  Polygons polygons;
};

/// The unit square with n cells on a side: squares, but for one hexagon of two of them in each
/// second row, and triangles in the last column.
Soup square(std::size_t n, double height) {
  Soup s;
  for(std::size_t j = 0; j <= n; ++j)
    for(std::size_t i = 0; i <= n; ++i) {
      const double x = double(i) / double(n), y = double(j) / double(n);
      s.points.emplace_back(x, y, height * std::sin(7 * x) * std::cos(5 * y));
    }
  const auto at = [&](std::size_t i, std::size_t j) { return j * (n + 1) + i; };
  for(std::size_t j = 0; j < n; ++j)
    for(std::size_t i = 0; i < n; ++i)
      if(i + 1 == n) {
        s.polygons.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
        s.polygons.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
      } else if(i == 0 && j % 2 == 1) {
        s.polygons.push_back(
            {at(0, j), at(1, j), at(2, j), at(2, j + 1), at(1, j + 1), at(0, j + 1)});
        ++i;
      } else
        s.polygons.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
  return s;
}

Mesh mesh_of(const Soup& s) {
  Mesh mesh;
  for(const RL::Point_3& p : s.points)
    mesh.add_vertex(p);
  for(const auto& polygon : s.polygons) {
    std::vector<Mesh::Vertex_index> corners;
    for(const std::size_t v : polygon)
      corners.emplace_back(static_cast<std::uint32_t>(v));
    REQUIRE(mesh.add_face(corners) != Mesh::null_face());
  }
  return mesh;
}

/// a number that neighbors do not share
double noise(std::size_t face, std::size_t corner = 0) {
  return std::sin(double(17 * face + 5 * corner));
}

template <class F> std::string message_of(F&& f) {
  try {
    static_cast<void>(f());
  } catch(const RL::Input_error& e) {
    return e.what();
  }
  return "";
}

} // namespace

TEST_CASE("convex_polygons_in_a_plane_are_fans", "[polygons]") {
  const std::vector<RL::Point_3> points = {{0, 0, 0}, {2, 0, 0}, {3, 1, 0}, {2, 2, 0},
                                           {0, 2, 0}, {1, 0, 0}, {0, 0, 1}};
  const Polygons polygons = {{0, 6, 1}, {0, 1, 2, 3, 4}, {0, 5, 1, 3, 4}, {0, 1, 3, 6}};
  const RL::Triangulated_surface_3 s = RL::read_surface(RL::soup(points, polygons));
  REQUIRE(s.number_of_faces() == 1 + 3 + 3 + 2);
  CHECK(s.has_polygons());
  const std::vector<std::uint32_t> numbers = {0, 1, 1, 1, 2, 2, 2, 3, 3};
  for(std::size_t f = 0; f < numbers.size(); ++f) {
    CAPTURE(f);
    CHECK(s.polygon(f) == numbers[f]);
    CHECK(s.surface_point({f, {1, 0, 0}}).polygon == numbers[f]);
    CHECK_FALSE(s.is_degenerate(f)); // also not where three corners lie on a line
    for(int k = 0; k < 3; ++k)
      CHECK(polygons[s.polygon(f)][s.corner_of_polygon(f, k)] == s.triangle(f)[k]);
  }
  for(std::uint32_t k = 0; k < 3; ++k)
    CHECK((s.triangle(1 + k) == std::array<std::uint32_t, 3>{0, k + 1, k + 2}));
  CHECK(s.area(1) + s.area(2) + s.area(3) == Approx(5));
  CHECK(s.area(4) + s.area(5) + s.area(6) == Approx(4));
  // however large or small
  for(const double scale : {1e-90, 1e90}) {
    std::vector<RL::Point_3> scaled;
    for(const RL::Point_3& p : points)
      scaled.emplace_back(scale * p.x(), scale * p.y(), scale * p.z());
    const RL::Triangulated_surface_3 other = RL::read_surface(RL::soup(scaled, polygons));
    for(std::size_t f = 1; f < 4; ++f)
      CHECK(other.triangle(f) == s.triangle(f));
  }
  // a star around the center is convex at all corners
  std::vector<RL::Point_3> star;
  for(int i = 0; i < 5; ++i)
    star.emplace_back(std::cos(4 * CGAL_PI * i / 5), std::sin(4 * CGAL_PI * i / 5), 0);
  const RL::Triangulated_surface_3 once =
      RL::read_surface(RL::soup(star, Polygons{{0, 1, 2, 3, 4}}));
  CHECK(once.number_of_faces() == 3);
  // triangles alone need no numbers
  CHECK_FALSE(RL::read_surface(RL::soup(points, Polygons{{0, 1, 6}})).has_polygons());
}

TEST_CASE("the_division_of_a_bent_polygon_bends_least", "[polygons]") {
  // over a ridge from corner 1 to corner 3, and from corner 0 to corner 2
  for(const std::size_t first : {1, 0}) {
    std::vector<RL::Point_3> points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    for(const std::size_t i : {first, first + 2})
      points[i] = RL::Point_3(points[i].x(), points[i].y(), 0.2 + 0.3 * double(i));
    const RL::Triangulated_surface_3 s = RL::read_surface(RL::soup(points, Polygons{{0, 1, 2, 3}}));
    REQUIRE(s.number_of_faces() == 2);
    const auto bend = [&](std::size_t a, std::size_t b) { // of the division along a diagonal
      const auto normal = [&](std::size_t i, std::size_t j, std::size_t k) {
        const RL::Vector_3 n = CGAL::cross_product(points[j] - points[i], points[k] - points[i]);
        return n / std::sqrt(n.squared_length());
      };
      return normal(a, (a + 1) % 4, b) * normal(a, b, (b + 1) % 4);
    };
    CHECK(s.normal(0) * s.normal(1) == Approx((std::max)(bend(0, 2), bend(1, 3))));
    CHECK(bend(0, 2) != Approx(bend(1, 3)));
  }
}

TEST_CASE("polygons_give_what_their_triangles_give", "[polygons]") {
  const double height = GENERATE(0., 0.2);
  const Soup s = square(12, height);
  const Mesh mesh = mesh_of(s);
  const RL::Triangulated_surface_3 surface = RL::read_surface(mesh);
  REQUIRE(surface.has_polygons());
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for(std::size_t f = 0; f < surface.number_of_faces(); ++f)
    triangles.push_back(surface.triangle(f));
  const auto np = params::depth(4);
  const Eigen::VectorXd of_mesh = RL::laplace_spectrum(mesh, 8, np).eigenvalues,
                        of_triangles =
                            RL::laplace_spectrum(RL::soup(s.points, triangles), 8, np).eigenvalues;
  CHECK(of_mesh == of_triangles);
  if(height == 0)
    CHECK(of_mesh[1] == Approx(CGAL_PI * CGAL_PI).epsilon(1e-4));
  // corners of a mesh may begin elsewhere than those of a soup, and a square has two divisions
  const Eigen::VectorXd of_soup =
      RL::laplace_spectrum(RL::soup(s.points, s.polygons), 8, np).eigenvalues;
  CHECK((of_soup - of_mesh).cwiseAbs().maxCoeff() < (height == 0 ? 1e-8 : 0.1) * of_mesh[7]);

  std::vector<double> u(s.points.size()), v(s.points.size());
  const auto z = [](const RL::Surface_point& p) { return p.point.x() * p.point.y(); };
  static_cast<void>(
      RL::solve_poisson(RL::soup(s.points, triangles), z, CGAL::make_property_map(u), np));
  auto on_mesh = Mesh(mesh);
  const auto map = on_mesh.add_property_map<Mesh::Vertex_index, double>("u").first;
  static_cast<void>(RL::solve_poisson(on_mesh, z, map, np));
  for(const Mesh::Vertex_index i : on_mesh.vertices())
    CHECK(map[i] == u[i]);
  // a space is a surface, too, whose vertices are numbers
  const RL::Spline_space_3 space(mesh, np);
  CHECK(RL::solve_poisson(space, z, CGAL::make_property_map(v)).space_seconds < 1);
  CHECK(u == v);
}

TEST_CASE("values_on_faces_and_corners_are_those_of_the_polygons", "[polygons]") {
  const bool is_smooth = GENERATE(false, true);
  Mesh mesh = mesh_of(square(9, 0.1));
  const auto of_faces = mesh.add_property_map<Mesh::Face_index, double>("f").first;
  const auto of_corners = mesh.add_property_map<Mesh::Halfedge_index, double>("h").first;
  for(const Mesh::Face_index f : mesh.faces()) {
    of_faces[f] = noise(f);
    for(const Mesh::Halfedge_index h : mesh.halfedges_around_face(mesh.halfedge(f)))
      of_corners[h] = noise(f, mesh.target(h));
  }
  const auto np = params::depth(4).geometry(is_smooth ? RL::Surface_geometry::smooth
                                                      : RL::Surface_geometry::flat);
  const RL::Spline_space_3 space(mesh, np);
  const auto by_face = [](const RL::Surface_point& p) { return noise(p.polygon); };
  const auto by_corner = [](const RL::Surface_point& p) {
    double sum = 0;
    for(int k = 0; k < 3; ++k)
      sum += p.barycentric[k] * noise(p.polygon, p.vertices[k]);
    return sum;
  };
  std::vector<double> expected(mesh.num_vertices());
  const auto found = mesh.add_property_map<Mesh::Vertex_index, double>("u").first;
  const auto check = [&](double tolerance) {
    double largest = 0;
    for(const Mesh::Vertex_index v : mesh.vertices()) {
      CHECK(found[v] == Approx(expected[v]).margin(tolerance));
      largest = (std::max)(largest, std::abs(found[v]));
    }
    CHECK(largest > 10 * tolerance);
  };
  static_cast<void>(RL::solve_screened_poisson(
      space, by_face, 10., CGAL::make_property_map(expected), params::tolerance(1e-10)));
  static_cast<void>(RL::solve_screened_poisson(mesh, of_faces, 10., found, np.tolerance(1e-10)));
  check(1e-7);
  static_cast<void>(RL::fit_function(space, RL::function_of_degree(by_corner, 1),
                                     CGAL::make_property_map(expected)));
  static_cast<void>(RL::fit_function(mesh, of_corners, found, np));
  check(1e-9);
}

TEST_CASE("edges_of_polygons_are_constrained", "[polygons]") {
  Mesh mesh = mesh_of(square(8, 0));
  auto is_constrained = mesh.add_property_map<Mesh::Edge_index, bool>("c", false).first;
  for(const Mesh::Edge_index e : mesh.edges())
    is_constrained[e] =
        mesh.point(mesh.vertex(e, 0)).x() == 0 && mesh.point(mesh.vertex(e, 1)).x() == 0;
  const auto u = mesh.add_property_map<Mesh::Vertex_index, double>("u").first;
  const auto x = [](const RL::Surface_point& p) { return p.point.x(); };
  // u'' = x, u(0) = 1, u'(1) = 0
  static_cast<void>(RL::solve_poisson(
      mesh, x, u,
      params::depth(5).boundary_values(1).edge_is_constrained_map(is_constrained).tolerance(1e-8)));
  for(const Mesh::Vertex_index v : mesh.vertices()) {
    const double t = mesh.point(v).x();
    CHECK(u[v] == Approx(1 + t * t * t / 6 - t / 2).margin(2e-4));
  }
  for(const Mesh::Edge_index e : mesh.edges())
    if(!mesh.is_border(e) && !is_constrained[e]) {
      is_constrained[e] = true;
      break;
    }
  CHECK_THAT(message_of([&] {
               return RL::solve_poisson(
                   mesh, x, u,
                   params::depth(3).boundary_values(1).edge_is_constrained_map(is_constrained));
             }),
             Catch::Contains("not at the boundary"));
}

TEST_CASE("errors_name_the_polygon", "[polygons]") {
  Soup s = square(6, 0);
  const std::size_t bad = s.polygons.size() - 3;
  std::vector<double> u(s.points.size());
  const auto solve = [&](const auto& f) {
    return message_of([&] {
      return RL::solve_poisson(RL::soup(s.points, s.polygons), f, CGAL::make_property_map(u),
                               params::depth(3));
    });
  };
  const std::string name = "face " + std::to_string(bad);
  const std::string message = solve([&](const RL::Surface_point& p) {
    return p.polygon == bad ? std::numeric_limits<double>::quiet_NaN() : p.point.x();
  });
  CHECK(message.substr((std::max)(message.size(), name.size()) - name.size()) == name);
  const auto x = [](const RL::Surface_point& p) { return p.point.x(); };
  const auto good = s.polygons[bad];
  s.polygons[bad] = {0, 1};
  CHECK_THAT(solve(x), Catch::Contains(name + " has fewer than three corners"));
  s.polygons[bad] = {0, 1, 2, 49};
  CHECK_THAT(solve(x), Catch::Contains(name + " names a vertex that does not exist"));
  s.polygons[bad].clear();
  CHECK_THAT(solve(x), Catch::Contains(name + " has fewer than three corners"));
  // what has no area does not count
  for(const auto& polygon :
      Polygons{{3, 3, 3, 3}, {3, 4, 3, 4}, {0, 0, 1, 1}, {0, 1, 2, 3, 2, 1}}) {
    s.polygons[bad] = polygon;
    CHECK(solve(x).empty());
  }
  s.polygons[bad] = good;
  CHECK(solve(x).empty());
  // barycentric coordinates are those of triangles
  const Mesh mesh = mesh_of(s);
  CHECK_THAT(message_of([&] { RL::Surface_location_converter<Mesh> converter(mesh); }),
             Catch::Contains("is not a triangle"));
}

TEST_CASE("gradients_curvature_and_distances_of_polygons", "[polygons]") {
  const Soup s = square(10, 0);
  const auto soup = RL::soup(s.points, s.polygons);
  std::vector<double> linear;
  for(const RL::Point_3& p : s.points)
    linear.push_back(3 * p.x() - 2 * p.y());
  const auto gradients = RL::vertex_gradients(soup, CGAL::make_property_map(linear));
  const RL::Triangulated_surface_3 surface = RL::read_surface(soup);
  for(std::size_t f = 0; f < surface.number_of_faces(); ++f)
    CHECK((gradients(surface.surface_point({f, {1, 0, 0}})) - Eigen::Vector3d(3, -2, 0)).norm() <
          1e-12);
  std::vector<double> u(s.points.size());
  static_cast<void>(RL::integrate_gradient_field(soup, gradients, CGAL::make_property_map(u),
                                                 params::depth(4).mean(0.5).tolerance(1e-8)));
  for(std::size_t i = 0; i < u.size(); ++i)
    CHECK(u[i] == Approx(linear[i]).margin(1e-5));

  std::vector<RL::Surface_curvature> curvature(s.points.size());
  static_cast<void>(
      RL::estimate_curvature(soup, CGAL::make_property_map(curvature), params::depth(4)));
  for(const RL::Surface_curvature& c : curvature)
    CHECK(std::abs(c.mean) < 1e-6);

  // a soup has numbers of points as sources
  static_cast<void>(RL::geodesic_distances(soup, 0, CGAL::make_property_map(u)));
  for(std::size_t i = 0; i < u.size(); ++i)
    CHECK(u[i] == Approx(std::hypot(s.points[i].x(), s.points[i].y())).margin(1e-12));
  const std::vector<std::size_t> ends = {0, 10};
  static_cast<void>(RL::geodesic_distances(soup, ends, CGAL::make_property_map(u)));
  for(std::size_t i = 0; i < u.size(); ++i)
    CHECK(u[i] ==
          Approx(std::hypot((std::min)(s.points[i].x(), 1 - s.points[i].x()), s.points[i].y()))
              .margin(1e-12));
  CHECK(RL::shortest_path(soup, 0, 120).length == Approx(std::sqrt(2.)));
}

TEST_CASE("a_projected_surface_keeps_its_polygons", "[polygons]") {
  const Soup s = square(7, 0);
  const Mesh mesh = mesh_of(s);
  const auto bowl = [](const RL::Point_3& p) {
    return RL::Point_3(p.x(), p.y(), p.x() * p.x() + p.y() * p.y());
  };
  const RL::Triangulated_surface_3 flat = RL::read_surface(mesh),
                                   bent = RL::read_surface(mesh, params::geometry(bowl));
  REQUIRE(bent.is_smooth());
  REQUIRE(bent.has_polygons());
  for(std::size_t f = 0; f < flat.number_of_faces(); ++f)
    CHECK(bent.polygon(f) == flat.polygon(f));
}

TEST_CASE("points_and_normals_become_a_surface", "[polygons]") {
  std::vector<RL::Point_3> points;
  std::vector<RL::Vector_3> normals;
  std::vector<std::pair<RL::Point_3, RL::Vector_3>> pairs;
  for(int i = 0; i < 2000; ++i) { // a spiral on a sphere
    const double z = 1 - (2 * i + 1) / 2000., r = std::sqrt(1 - z * z), t = 2.399963 * i;
    points.emplace_back(r * std::cos(t), r * std::sin(t), z);
    normals.push_back(2 * (points.back() - CGAL::ORIGIN));
    pairs.emplace_back(points.back(), normals.back());
  }
  const auto np = params::depth(3);
  const Eigen::VectorXd values =
      RL::laplace_spectrum(RL::point_set(points, normals), 4, np).eigenvalues;
  CHECK(values ==
        RL::laplace_spectrum(
            pairs, 4,
            np.point_map(CGAL::First_of_pair_property_map<std::pair<RL::Point_3, RL::Vector_3>>())
                .normal_map(
                    CGAL::Second_of_pair_property_map<std::pair<RL::Point_3, RL::Vector_3>>()))
            .eigenvalues);
  CHECK(values[1] == Approx(2).epsilon(0.02));
  std::vector<double> z, u(points.size());
  for(const RL::Point_3& p : points)
    z.push_back(p.z());
  static_cast<void>(RL::solve_poisson(RL::point_set(points, normals), CGAL::make_property_map(z),
                                      CGAL::make_property_map(u), np));
  CHECK(u[0] == Approx(-0.5).epsilon(0.05)); // Laplacian z = -2 z
  normals.pop_back();
  CHECK_THAT(message_of([&] { RL::point_set(points, normals); }),
             Catch::Contains("are 1999, but there are 2000 points"));
  // what is temporary is kept
  const auto kept =
      RL::soup(std::vector<RL::Point_3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, Polygons{{0, 1, 2}});
  CHECK(RL::read_surface(kept).area() == Approx(0.5));
}
