// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "catch.h"
#include "shapes.h"
#include "special_shapes.h"

#include <CGAL/Restricted_laplacian_3/estimate_curvature.h>
#include <CGAL/Restricted_laplacian_3/input/read_surface.h>
#include <CGAL/Restricted_laplacian_3/integration/triangle_quadrature.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace RL = CGAL::Restricted_laplacian_3;
namespace params = RL::parameters;
using RL::Curvature_method;
using shapes::Mesh;

/// a torus around the z axis with radii 1 and 0.4, outward normals
shapes::Triangles curved_torus(int n) {
  shapes::Triangles t;
  const int m = 5 * n / 2;
  for(int i = 0; i < m; ++i)
    for(int j = 0; j < n; ++j) {
      const double u = 2 * CGAL_PI * i / m, v = 2 * CGAL_PI * j / n;
      const double radius = 1 + 0.4 * std::cos(v);
      t.points.emplace_back(radius * std::cos(u), radius * std::sin(u), 0.4 * std::sin(v));
    }
  const auto vertex = [&](int i, int j) { return static_cast<std::uint32_t>(i % m * n + j % n); };
  for(int i = 0; i < m; ++i)
    for(int j = 0; j < n; ++j) {
      t.faces.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
      t.faces.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
    }
  return t;
}

/// the graph of a function on [-1, 1] x [-1, 1], normals upward
template <class Function> shapes::Triangles curved_graph(int n, const Function& z) {
  shapes::Triangles t;
  for(int i = 0; i <= n; ++i)
    for(int j = 0; j <= n; ++j) {
      const double x = 2. * i / n - 1, y = 2. * j / n - 1;
      t.points.emplace_back(x, y, z(x, y));
    }
  const auto vertex = [n](int i, int j) { return static_cast<std::uint32_t>(i * (n + 1) + j); };
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < n; ++j) {
      t.faces.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
      t.faces.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
    }
  return t;
}

shapes::Triangles flipped(shapes::Triangles t) {
  for(auto& face : t.faces)
    std::swap(face[1], face[2]);
  return t;
}

template <class NamedParameters>
std::vector<RL::Surface_curvature> curvatures(const shapes::Triangles& t,
                                              const NamedParameters& np) {
  std::vector<RL::Surface_curvature> result(t.points.size());
  const RL::Fit_report report =
      RL::estimate_curvature(RL::soup(t.points, t.faces), CGAL::make_property_map(result), np);
  CHECK(report.converged);
  CHECK(report.iterations <= 15);
  return result;
}

std::vector<RL::Surface_curvature> curvatures(const shapes::Triangles& t, int depth,
                                              Curvature_method method = Curvature_method::normals) {
  return curvatures(t, params::depth(depth).method(method));
}

/// largest |value(i) - expected(i)|
template <class Value, class Expected>
double largest_difference(std::size_t number, Value&& value, Expected&& expected) {
  double result = 0;
  for(std::size_t i = 0; i < number; ++i) {
    const double difference = std::abs(value(i) - expected(i));
    result = difference <= result ? result : difference; // a NaN remains
  }
  return result;
}

} // namespace

TEST_CASE("spheres_have_the_curvature_of_their_orientation", "[curvature]") {
  const double r = 2;
  const shapes::Triangles outward = shapes::scaled(shapes::sphere(4), r);
  for(const Curvature_method method :
      {Curvature_method::normals, Curvature_method::face_normals, Curvature_method::coordinates})
    for(const double sign : {1., -1.}) {
      const auto c = curvatures(sign > 0 ? outward : flipped(outward), 3, method);
      for(std::size_t i = 0; i < c.size(); ++i) {
        CHECK(c[i].mean == Approx(sign / r).epsilon(0.05));
        const RL::Vector_3 radial = (outward.points[i] - CGAL::ORIGIN) / r;
        CHECK(c[i].normal * radial == Approx(sign).epsilon(1e-3));
        if(method == Curvature_method::coordinates) {
          CHECK(std::isnan(c[i].gaussian));
          CHECK(std::isnan(c[i].principal_values[0]));
          continue;
        }
        CHECK(c[i].gaussian == Approx(1 / (r * r)).epsilon(0.1));
        for(const double kappa : c[i].principal_values)
          CHECK(kappa == Approx(sign / r).epsilon(0.05));
      }
    }
}

TEST_CASE("curvature_of_the_torus", "[curvature]") {
  const shapes::Triangles torus = curved_torus(40);
  const auto c = curvatures(torus, 5);
  for(std::size_t i = 0; i < c.size(); ++i) {
    const RL::Point_3& p = torus.points[i];
    const double radius = std::hypot(p.x(), p.y()), second = (radius - 1) / (0.4 * radius);
    CHECK(c[i].principal_values[0] == Approx(2.5).epsilon(0.05));
    CHECK(c[i].principal_values[1] == Approx(second).margin(0.05));
    CHECK(c[i].mean == Approx((c[i].principal_values[0] + c[i].principal_values[1]) / 2));
    CHECK(c[i].gaussian == Approx(c[i].principal_values[0] * c[i].principal_values[1]));
    // the larger curvature is that of the meridians, the other one that of the parallels
    const RL::Vector_3 parallel(-p.y() / radius, p.x() / radius, 0);
    const auto& [first_direction, second_direction] = c[i].principal_directions;
    CHECK(std::abs(parallel * second_direction) == Approx(1).epsilon(5e-3));
    CHECK(std::abs(first_direction * second_direction) < 1e-12);
    CHECK(std::abs(first_direction * c[i].normal) < 1e-12);
    CHECK(first_direction.squared_length() == Approx(1));
  }
}

TEST_CASE("curvature_of_a_saddle_is_accurate_up_to_its_boundary", "[curvature]") {
  const shapes::Triangles saddle =
      curved_graph(40, [](double x, double y) { return (x * x - y * y) / 2; });
  const auto c = curvatures(saddle, 4);
  const auto squared_area = [&](std::size_t i) {
    const RL::Point_3& p = saddle.points[i];
    return 1 + p.x() * p.x() + p.y() * p.y();
  };
  // upward normals: curved upward is negative
  const auto mean = [&](std::size_t i) {
    const RL::Point_3& p = saddle.points[i];
    return (p.x() * p.x() - p.y() * p.y()) / (2 * std::pow(squared_area(i), 1.5));
  };
  const auto gaussian = [&](std::size_t i) { return -1 / std::pow(squared_area(i), 2); };
  // the principal curvatures are 1 and -1 in the middle
  CHECK(largest_difference(
            c.size(), [&](std::size_t i) { return c[i].mean; }, mean) < 0.03);
  CHECK(largest_difference(
            c.size(), [&](std::size_t i) { return c[i].gaussian; }, gaussian) < 0.04);
}

TEST_CASE("the_mean_curvature_vector_needs_its_boundary_term", "[curvature]") {
  const double r = 2; // an arc of a cylinder along the y axis, outward normals
  const shapes::Triangles arc =
      curved_graph(40, [&](double x, double) { return std::sqrt(r * r - x * x); });
  const RL::Spline_space_3 space(RL::soup(arc.points, arc.faces), params::depth(3));
  const double h = space.octree().cell_width(3);
  const Eigen::MatrixXd values =
      RL::estimate_curvature(space, params::method(Curvature_method::coordinates))
          .functions()
          .values_at_vertices();
  const auto by_normals = curvatures(arc, 3);
  for(std::size_t i = 0; i < arc.points.size(); ++i) {
    CHECK(by_normals[i].mean == Approx(1 / (2 * r)).margin(0.01));
    CHECK(by_normals[i].gaussian == Approx(0).margin(0.01));
    CHECK(std::abs(by_normals[i].principal_directions[1].y()) == Approx(1).epsilon(0.02));
    // -2 H n. The curvature of the triangulation lives on its edges, and the last ones are half an
    // edge away from the boundary. Without its term the error would be larger than 1 / h there.
    const RL::Point_3& p = arc.points[i];
    const Eigen::RowVector3d expected(-p.x() / (r * r), 0, -p.z() / (r * r));
    const bool is_at_boundary = (std::max)(std::abs(p.x()), std::abs(p.y())) > 1 - 2 * h;
    const double error = (values.row(static_cast<Eigen::Index>(i)).tail<3>() - expected).norm();
    CHECK(error < (is_at_boundary ? 0.6 : 0.05));
  }
}

TEST_CASE("curvature_of_ragged_scans_ends_by_its_own_error", "[curvature]") {
  // a noisy graph without a third of its triangles
  std::uint32_t state = 1;
  const auto random = [&state] {
    state = 1664525 * state + 1013904223;
    return (state >> 8) / double(1 << 24);
  };
  shapes::Triangles scan = curved_graph(
      80, [&](double x, double y) { return 0.2 * std::sin(3 * x * y) + 0.02 * random(); });
  const auto is_lost = [&](const std::array<std::uint32_t, 3>&) { return random() < 0.33; };
  scan.faces.erase(std::remove_if(scan.faces.begin(), scan.faces.end(), is_lost), scan.faces.end());
  const RL::Spline_space_3 space(RL::soup(scan.points, scan.faces), params::depth(5));
  const RL::Curvature_field field = RL::estimate_curvature(space),
                            solved = RL::estimate_curvature(space, params::energy_tolerance(0.));
  CHECK(field.report().converged);
  CHECK(field.report().iterations <= 15);
  CHECK(field.report().iterations < solved.report().iterations);
  CHECK(solved.report().relative_residual <= RL::Function_fitter::default_tolerance);
  double difference = 0, sum = 0;
  const auto ours = field.at_vertices(), exact = solved.at_vertices();
  for(std::size_t i = 0; i < exact.size(); ++i)
    if(std::isfinite(exact[i].mean)) {
      difference += std::pow(ours[i].mean - exact[i].mean, 2);
      sum += std::pow(exact[i].mean, 2);
    }
  CHECK(std::sqrt(difference / sum) < 1e-3);
}

TEST_CASE("curvature_of_planes_is_zero", "[curvature]") {
  const shapes::Triangles rectangle = shapes::rectangle(2, 1);
  for(const Curvature_method method :
      {Curvature_method::normals, Curvature_method::face_normals, Curvature_method::coordinates})
    for(const RL::Surface_curvature& c : curvatures(rectangle, 3, method)) {
      CHECK(std::abs(c.mean) < 1e-5);
      CHECK(c.normal.z() == Approx(1));
    }
}

TEST_CASE("curvature_follows_motions_and_scales", "[curvature]") {
  const shapes::Triangles torus = curved_torus(16);
  const auto unit = curvatures(torus, 4);
  const double largest = 3;
  const auto compare = [&](const shapes::Triangles& other, double length, double tolerance) {
    const auto c = curvatures(other, 4);
    CHECK(largest_difference(
              c.size(), [&](std::size_t i) { return length * c[i].mean; },
              [&](std::size_t i) { return unit[i].mean; }) < tolerance * largest);
    CHECK(largest_difference(
              c.size(), [&](std::size_t i) { return length * length * c[i].gaussian; },
              [&](std::size_t i) { return unit[i].gaussian; }) < tolerance * largest * largest);
  };
  for(const double length : {1e-50, 3., 1e50})
    compare(shapes::scaled(torus, length), length, 1e-6);
  compare(shapes::moved(torus, {1e3, -2e3, 5e2}), 1, 1e-6);
  shapes::Triangles turned = torus; // by 90 degrees: the grid is the same
  for(RL::Point_3& p : turned.points)
    p = RL::Point_3(p.y(), p.z(), p.x());
  compare(turned, 1, 1e-6);
  for(RL::Point_3& p : turned.points) // any other motion turns the grid too
    p = RL::Point_3(0.6 * p.x() - 0.8 * p.y(), 0.8 * p.x() + 0.6 * p.y(), p.z());
  compare(turned, 1, 0.1);
}

TEST_CASE("mean_curvature_of_a_fold_is_that_of_its_edge", "[curvature]") {
  // two planes that meet along the y axis: piecewise linear
  const double angle = 0.3;
  const shapes::Triangles fold =
      curved_graph(24, [&](double x, double) { return -std::tan(angle / 2) * std::abs(x); });
  const RL::Spline_space_3 space(RL::soup(fold.points, fold.faces), params::depth(5));
  const double h = space.octree().cell_width(5);
  for(const Curvature_method method :
      {Curvature_method::face_normals, Curvature_method::coordinates}) {
    const RL::Curvature_field field = RL::estimate_curvature(space, params::method(method));
    double sum = 0, largest_outside = 0;
    std::vector<RL::Surface_location> locations;
    std::vector<double> weights;
    for(std::size_t f = 0; f < fold.faces.size(); ++f)
      for(const RL::Triangle_quadrature_node& node : RL::triangle_quadrature(12)) {
        RL::Surface_location location;
        location.face = f;
        location.barycentric = {node.b0, node.b1, node.b2};
        locations.push_back(location);
        weights.push_back(node.weight * space.surface().area(f));
      }
    const auto c = field.at_locations(locations);
    for(std::size_t i = 0; i < c.size(); ++i) {
      sum += weights[i] * c[i].mean;
      if(std::abs(space.surface().surface_point(locations[i]).point.x()) > 4 * h)
        largest_outside = std::max(largest_outside, std::abs(c[i].mean));
    }
    // half of the angle of the bend, times the length of the edge
    CHECK(sum == Approx(angle / 2 * 2).epsilon(0.02));
    CHECK(largest_outside < 0.02 * angle / h);
  }
}

TEST_CASE("curvature_on_meshes_with_given_normals", "[curvature]") {
  Mesh mesh = shapes::mesh(shapes::sphere(3));
  auto c = mesh.add_property_map<Mesh::Vertex_index, RL::Surface_curvature>("c").first;
  auto n = mesh.add_property_map<Mesh::Vertex_index, RL::Vector_3>("n").first;
  for(Mesh::Vertex_index v : vertices(mesh))
    n[v] = 5 * (CGAL::ORIGIN - mesh.point(v)); // inward, not of unit length
  n[*vertices(mesh).begin()] = RL::Vector_3(0, 0, 0);
  RL::estimate_curvature(mesh, c, params::depth(3));
  for(Mesh::Vertex_index v : vertices(mesh))
    CHECK(c[v].mean == Approx(1).epsilon(0.05));
  RL::estimate_curvature(mesh, c, params::depth(3).vertex_normal_map(n));
  for(Mesh::Vertex_index v : vertices(mesh))
    CHECK(c[v].mean == Approx(-1).epsilon(0.1));
  n[*vertices(mesh).begin()] = RL::Vector_3(0, std::numeric_limits<double>::quiet_NaN(), 0);
  CHECK_THROWS_AS(RL::estimate_curvature(mesh, c, params::depth(3).vertex_normal_map(n)),
                  RL::Invalid_vertex_error);
}

TEST_CASE("curvature_of_several_components_and_bad_faces", "[curvature]") {
  shapes::Triangles two = shapes::joined(
      shapes::sphere(3), shapes::moved(flipped(shapes::scaled(shapes::sphere(3), 0.5)), {2, 0, 0}));
  const std::size_t half = two.points.size() / 2;
  // a face without area, a vertex without a face
  two.faces.push_back({0, 0, 1});
  two.points.emplace_back(100, 0, 0);
  const auto c = curvatures(two, 5);
  for(std::size_t i = 0; i < 2 * half; ++i)
    CHECK(c[i].mean == Approx(i < half ? 1. : -2.).epsilon(0.1));
  CHECK(std::isnan(c.back().mean));
  CHECK(std::isnan(c.back().gaussian));
}

TEST_CASE("both_sides_of_a_thin_shell_have_their_curvature", "[curvature]") {
  const shapes::Triangles shell =
      shapes::joined(shapes::sphere(4), flipped(shapes::scaled(shapes::sphere(4), 0.95)));
  const std::size_t half = shell.points.size() / 2;
  const auto c = curvatures(shell, 3); // a cell is several times as wide as the shell is thick
  for(std::size_t i = 0; i < shell.points.size(); ++i)
    CHECK(c[i].mean == Approx(i < half ? 1. : -1 / 0.95).epsilon(0.05));
}

TEST_CASE("vertex_normals_of_spheres_and_boundaries", "[curvature]") {
  // triangles of any shape
  shapes::Triangles sphere = shapes::sphere(3);
  for(RL::Point_3& p : sphere.points) {
    const RL::Vector_3 v(p.x() + 0.4 * p.y() * p.z(), p.y(), 0.3 * p.z());
    p = CGAL::ORIGIN + v / std::sqrt(v.squared_length());
  }
  const auto normals = RL::vertex_normals(RL::read_surface(RL::soup(sphere.points, sphere.faces)));
  for(std::size_t i = 0; i < normals.size(); ++i)
    CHECK((normals[i] - (sphere.points[i] - CGAL::ORIGIN)).squared_length() < 1e-20);

  const shapes::Triangles bowl =
      curved_graph(20, [](double x, double y) { return (x * x + 0.5 * y * y) / 2; });
  const auto of_bowl = RL::vertex_normals(RL::read_surface(RL::soup(bowl.points, bowl.faces)));
  for(std::size_t i = 0; i < of_bowl.size(); ++i) {
    const RL::Point_3& p = bowl.points[i];
    const RL::Vector_3 n(-p.x(), -0.5 * p.y(), 1);
    CHECK((of_bowl[i] - n / std::sqrt(n.squared_length())).squared_length() < 4e-3 * 4e-3);
  }

  // both sides of one face: normals cancel
  const std::vector<RL::Point_3> corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const std::vector<std::array<int, 3>> faces = {{0, 1, 2}, {0, 2, 1}};
  for(const RL::Vector_3& n : RL::vertex_normals(RL::read_surface(RL::soup(corners, faces))))
    CHECK(n == CGAL::NULL_VECTOR);
}

TEST_CASE("curvature_of_hostile_input", "[curvature]") {
  std::vector<RL::Surface_curvature> c(3);
  const auto map = CGAL::make_property_map(c);
  const std::vector<std::array<int, 3>> faces = {{0, 1, 2}};
  const std::vector<RL::Point_3> triangle = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  RL::estimate_curvature(RL::soup(triangle, faces), map);
  for(const RL::Surface_curvature& value : c)
    CHECK(std::abs(value.mean) < 1e-5);
  // normals that cancel at all vertices: those of the faces are taken
  RL::estimate_curvature(RL::soup(triangle, std::vector<std::array<int, 3>>{{0, 1, 2}, {0, 2, 1}}),
                         map);
  const std::vector<RL::Point_3> line = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  CHECK_THROWS_AS(RL::estimate_curvature(RL::soup(line, faces), map), RL::Zero_area_error);
  const std::vector<std::array<int, 3>> none;
  CHECK_THROWS_AS(RL::estimate_curvature(RL::soup(triangle, none), map), RL::Empty_surface_error);
  CHECK_THROWS_AS(RL::estimate_curvature(RL::soup(triangle, faces), map, params::smoothing(-1.)),
                  RL::Parameter_error);
}
