// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Values at vertices that are interpolated smoothly.

#include "catch.h"
#include "shapes.h"
#include "special_shapes.h"

#include <CGAL/Restricted_laplacian_3/fit_function.h>
#include <CGAL/Restricted_laplacian_3/integrate_gradient_field.h>
#include <CGAL/Restricted_laplacian_3/patches/curved_surface.h>
#include <CGAL/Restricted_laplacian_3/patches/smooth_vertex_data.h>
#include <CGAL/Restricted_laplacian_3/solve_poisson.h>
#include <CGAL/Restricted_laplacian_3/surface/shared/Surface_edges.h>

#include <CGAL/property_map.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <utility>
#include <vector>

namespace {

namespace RL = CGAL::Restricted_laplacian_3;
namespace params = RL::parameters;

RL::Triangulated_surface_3 surface_of(const shapes::Triangles& t) {
  return RL::Triangulated_surface_3(t.points, t.faces);
}

double random_number(std::mt19937& generator) { return generator() * std::ldexp(1., -32); }

/// a sphere whose vertices are moved along it by up to a part of the length of its edges
shapes::Triangles irregular_sphere(int n, double jitter) {
  shapes::Triangles t = shapes::sphere(n);
  std::mt19937 generator(7);
  const double length = jitter * std::sqrt(4 * CGAL_PI / static_cast<double>(t.points.size()));
  for(RL::Point_3& p : t.points) {
    std::array<double, 3> shift;
    for(double& x : shift)
      x = length * (2 * random_number(generator) - 1);
    const RL::Vector_3 v = p - CGAL::ORIGIN + RL::Vector_3(shift[0], shift[1], shift[2]);
    p = CGAL::ORIGIN + v / std::sqrt(v.squared_length());
  }
  return t;
}

template <class Function> auto values_at(const shapes::Triangles& t, const Function& f) {
  std::vector<std::decay_t<decltype(f(t.points[0]))>> values;
  for(const RL::Point_3& p : t.points)
    values.push_back(f(p));
  return values;
}

/// calls `visit(point)` at some points of all faces that are not degenerate
template <class Visitor>
void for_each_sample(const RL::Triangulated_surface_3& surface, Visitor&& visit) {
  constexpr int n = 6;
  for(std::size_t face = 0; face < surface.number_of_faces(); ++face)
    for(int i = 0; i <= n && !surface.is_degenerate(face); ++i)
      for(int j = 0; i + j <= n; ++j)
        visit(
            surface.surface_point({face, {i / double(n), j / double(n), (n - i - j) / double(n)}}));
}

double wave(const RL::Point_3& p) { return std::sin(3 * p.x() + p.y()) * std::cos(2 * p.z()); }

/// root mean square of the difference to the wave at the nearest point of the unit sphere
template <class Function>
double error_of(const RL::Triangulated_surface_3& surface, const Function& f) {
  double sum = 0;
  std::size_t count = 0;
  for_each_sample(surface, [&](const RL::Surface_point& p) {
    const RL::Vector_3 v = p.point - CGAL::ORIGIN;
    sum += std::pow(f(p) - wave(CGAL::ORIGIN + v / std::sqrt(v.squared_length())), 2);
    ++count;
  });
  return std::sqrt(sum / static_cast<double>(count));
}

struct Noise {
  double worst = 0;       // of values that are wrong by 1 at most
  double mean_square = 0; // of values of variance 1, independent of each other
};

/// by impulses at all vertices
Noise noise_of(const RL::Triangulated_surface_3& surface) {
  constexpr int at_once = 16;
  using Values = Eigen::Matrix<double, at_once, 1>;
  const std::size_t n = surface.number_of_vertices();
  std::vector<double> sums, squares;
  for(std::size_t first = 0; first < n; first += at_once) {
    std::vector<Values> values(n, Values::Zero());
    for(std::size_t k = 0; k < at_once && first + k < n; ++k)
      values[first + k][static_cast<Eigen::Index>(k)] = 1;
    const RL::Cubic_surface_function<Values> f(surface, std::move(values));
    std::size_t i = 0;
    for_each_sample(surface, [&](const RL::Surface_point& p) {
      const Values at_point = f(p);
      if(first == 0) {
        sums.push_back(0);
        squares.push_back(0);
      }
      sums[i] += at_point.cwiseAbs().sum();
      squares[i++] += at_point.squaredNorm();
    });
  }
  Noise result;
  result.worst = *std::max_element(sums.begin(), sums.end());
  for(double s : squares)
    result.mean_square += s / static_cast<double>(squares.size());
  return result;
}

} // namespace

TEST_CASE("smooth_data_are_of_third_order") {
  for(double jitter : {0., 0.25})
    for(bool is_smooth : {true, false}) {
      std::vector<double> errors, linear_errors;
      for(int n : {3, 4, 5}) {
        const shapes::Triangles t = irregular_sphere(n, jitter);
        RL::Triangulated_surface_3 surface = surface_of(t);
        if(is_smooth)
          surface = RL::curved_surface(surface);
        const std::vector<double> values = values_at(t, wave);
        errors.push_back(error_of(surface, RL::Cubic_surface_function<double>(surface, values)));
        linear_errors.push_back(error_of(surface, RL::Linear_surface_function<double>(values)));
      }
      CAPTURE(jitter);
      CAPTURE(is_smooth);
      CAPTURE(errors);
      CAPTURE(linear_errors);
      CHECK(errors[0] > 6.5 * errors[1]);
      CHECK(errors[1] > 6.5 * errors[2]);
      CHECK(linear_errors[2] > 15 * errors[2]);
    }
}

TEST_CASE("coordinates_of_a_smooth_surface_as_smooth_data") {
  // The cubics of coordinates are nearly the patches themselves, since their tangents are the same.
  std::vector<double> errors;
  for(int n : {3, 4}) {
    const shapes::Triangles t = shapes::sphere(n);
    const RL::Triangulated_surface_3 surface = RL::curved_surface(surface_of(t));
    const RL::Cubic_surface_function<Eigen::Vector3d> f(
        surface,
        values_at(t, [](const RL::Point_3& p) { return Eigen::Vector3d(p.x(), p.y(), p.z()); }));
    double largest = 0;
    for_each_sample(surface, [&](const RL::Surface_point& p) {
      largest = (std::max)(largest,
                           (f(p) - Eigen::Vector3d(p.point.x(), p.point.y(), p.point.z())).norm());
    });
    errors.push_back(largest);
  }
  CAPTURE(errors);
  CHECK(errors[0] < 3e-4);
  CHECK(errors[0] > 12 * errors[1]);
}

TEST_CASE("smooth_data_reproduce_linear_functions_on_planes") {
  shapes::Triangles t = shapes::ragged_square(9, 0, 3);
  const auto linear = [](const RL::Point_3& p) { return 3 * p.x() - 2 * p.y() + 0.5; };
  for(double scale : {1., 1e-20, 1e20}) {
    const RL::Triangulated_surface_3 surface = surface_of(shapes::scaled(t, scale));
    const RL::Cubic_surface_function<double> f(surface, values_at(t, linear));
    const RL::Linear_surface_function<double> expected(values_at(t, linear));
    double worst = 0;
    for_each_sample(surface, [&](const RL::Surface_point& p) {
      worst = (std::max)(worst, std::abs(f(p) - expected(p)));
    });
    CHECK(worst < 1e-12);
  }
  // Quadratic functions too, away from the boundary.
  const auto quadratic = [](const RL::Point_3& p) { return p.x() * p.y() - p.y() * p.y(); };
  const RL::Triangulated_surface_3 surface = surface_of(t);
  const RL::Cubic_surface_function<double> f(surface, values_at(t, quadratic));
  double worst = 0, worst_inside = 0;
  for_each_sample(surface, [&](const RL::Surface_point& p) {
    const double error = std::abs(f(p) - quadratic(p.point));
    worst = (std::max)(worst, error);
    if((std::max)(std::abs(p.point.x() - 0.5), std::abs(p.point.y() - 0.5)) < 0.2)
      worst_inside = (std::max)(worst_inside, error);
  });
  CHECK(worst_inside < 1e-12);
  CHECK(worst < 1e-2);
}

TEST_CASE("smooth_data_do_not_see_across_creases") {
  // On a box, of a function that is linear on each side. With few triangles its sides are no plane
  // parts, so that it is the crease angle that tells them apart.
  const auto f = [](const RL::Point_3& p) { return p.x() + 2 * p.y() - 3 * p.z(); };
  for(int n : {1, 6}) {
    const shapes::Triangles t = shapes::box(1, 1, 1, n, 5);
    const RL::Triangulated_surface_3 surface = surface_of(t);
    const auto largest_error = [&](double crease_angle) {
      RL::Smooth_geometry geometry;
      geometry.crease_angle = crease_angle;
      const RL::Cubic_surface_function<double> cubic(surface, values_at(t, f), geometry);
      double worst = 0;
      for_each_sample(surface, [&](const RL::Surface_point& p) {
        worst = (std::max)(worst, std::abs(cubic(p) - f(p.point)));
      });
      return worst;
    };
    CHECK(largest_error(40) < 1e-12);
    if(n == 1)
      CHECK(largest_error(180) > 1e-3);
    else
      CHECK(largest_error(180) < 1e-12);
  }
}

TEST_CASE("smooth_data_are_continuous") {
  // an irregular sphere with a wing: an edge of three faces, and open ones
  shapes::Triangles t = irregular_sphere(2, 0.4);
  t.points.emplace_back(0, 0, 3);
  t.faces.push_back(
      {t.faces[0][0], t.faces[0][1], static_cast<std::uint32_t>(t.points.size() - 1)});
  for(bool is_smooth : {true, false}) {
    RL::Triangulated_surface_3 surface = surface_of(t);
    if(is_smooth)
      surface = RL::curved_surface(surface);
    const RL::Cubic_surface_function<double> f(surface, values_at(t, wave));
    const RL::Linear_surface_function<double> linear(values_at(t, wave));
    const RL::internal::Surface_edges edges(surface);
    double worst = 0, bend = 0;
    for(std::size_t edge = 0; edge < edges.size(); ++edge)
      for(double s : {0.2, 0.5, 0.9}) {
        std::vector<double> values;
        for(const auto& side : edges.sides(edge)) {
          RL::Surface_location place{side.face, {0, 0, 0}};
          const bool is_first = surface.triangle(side.face)[side.number] == edges.ends(edge)[0];
          place.barycentric[side.number] = is_first ? s : 1 - s;
          place.barycentric[(side.number + 1) % 3] = is_first ? 1 - s : s;
          values.push_back(f(surface.surface_point(place)));
          bend = (std::max)(bend, std::abs(values.back() - linear(surface.surface_point(place))));
        }
        for(double value : values)
          worst = (std::max)(worst, std::abs(value - values[0]));
      }
    CHECK(worst < 1e-14);
    CHECK(bend > 0.05);
  }
}

TEST_CASE("smooth_data_do_not_multiply_noise") {
  const auto squeezed = [](double x, double z) {
    shapes::Triangles t = shapes::sphere(2);
    for(RL::Point_3& p : t.points)
      p = RL::Point_3(x * p.x(), p.y(), z * p.z());
    return t;
  };
  const Noise irregular = noise_of(surface_of(irregular_sphere(2, 0.5)));
  CHECK(irregular.worst < 3);
  CHECK(irregular.mean_square < 1);

  // needles: the gradient from short edges is used on long ones
  std::vector<shapes::Triangles> meshes = {squeezed(1, 1e-6), squeezed(1e-3, 1e3),
                                           shapes::sphere(2), shapes::sphere(1)};
  std::mt19937 generator(5);
  for(RL::Point_3& p : meshes[2].points)
    p = CGAL::ORIGIN + std::pow(10., -6 * random_number(generator)) * (p - CGAL::ORIGIN);
  // a strip of needles of aspect 1e6, with a wide triangle at each end
  shapes::Triangles strip;
  for(int i = 0; i <= 20; ++i) {
    strip.points.emplace_back(1e-6 * i, 0, 0);
    strip.points.emplace_back(1e-6 * i, 1, 1e-7 * (i % 3));
    const auto a = static_cast<std::uint32_t>(2 * i);
    if(i < 20) {
      strip.faces.push_back({a, a + 2, a + 3});
      strip.faces.push_back({a, a + 3, a + 1});
    }
  }
  strip.points.emplace_back(-1, 0.5, 0);
  strip.faces.push_back({0, 1, 42});
  meshes.push_back(strip);
  for(const shapes::Triangles& t : meshes)
    for(bool is_smooth : {false, true}) {
      RL::Triangulated_surface_3 surface = surface_of(t);
      if(is_smooth)
        surface = RL::curved_surface(surface);
      CHECK(noise_of(surface).worst <= 6.6);
    }
}

TEST_CASE("smooth_data_in_problems") {
  const shapes::Mesh mesh = shapes::mesh(irregular_sphere(4, 0.25));
  const auto np = params::depth(4).geometry(RL::Surface_geometry::smooth);
  const auto smooth = np.vertex_data(RL::Vertex_data::smooth);
  using Vertex = shapes::Mesh::Vertex_index;
  shapes::Mesh own = mesh;
  const auto numbers = own.add_property_map<Vertex, double>("v:number").first;
  const auto vectors = own.add_property_map<Vertex, std::array<double, 2>>("v:vector").first;
  for(Vertex v : own.vertices()) {
    numbers[v] = wave(own.point(v));
    vectors[v] = {numbers[v], own.point(v).x()};
  }
  const auto function = [](const RL::Surface_point& p) { return wave(p.point); };
  const auto largest_difference = [&](const auto& a, const auto& b) {
    double largest = 0;
    for(Vertex v : own.vertices())
      largest = (std::max)(largest, std::abs(a[v] - b[v]));
    return largest;
  };

  const auto exact = own.add_property_map<Vertex, double>("v:exact").first,
             by_smooth = own.add_property_map<Vertex, double>("v:smooth").first,
             by_linear = own.add_property_map<Vertex, double>("v:linear").first,
             by_object = own.add_property_map<Vertex, double>("v:object").first;
  REQUIRE(RL::solve_screened_poisson(own, function, 1, exact, np).converged);
  REQUIRE(RL::solve_screened_poisson(own, numbers, 1, by_smooth, smooth).converged);
  REQUIRE(RL::solve_screened_poisson(own, numbers, 1, by_linear, np).converged);
  CHECK(largest_difference(by_linear, exact) > 5e-4);
  CHECK(largest_difference(by_smooth, exact) < 1e-1 * largest_difference(by_linear, exact));

  // what the parameter means is what the function object is
  const RL::Spline_space_3 space(own, np);
  std::vector<double> values;
  for(Vertex v : own.vertices())
    values.push_back(numbers[v]);
  REQUIRE(RL::solve_screened_poisson(
              own, RL::Cubic_surface_function<double>(space.surface(), values), 1, by_object, np)
              .converged);
  CHECK(largest_difference(by_object, by_smooth) == 0);
  const auto again = own.add_property_map<Vertex, double>("v:again").first;
  REQUIRE(
      RL::solve_screened_poisson(own, numbers, 1, again, np.vertex_data(RL::Vertex_data::linear))
          .converged);
  CHECK(largest_difference(again, by_linear) == 0);

  const auto fit = own.add_property_map<Vertex, std::array<double, 2>>("v:fit").first,
             linear_fit = own.add_property_map<Vertex, std::array<double, 2>>("v:linear_fit").first;
  REQUIRE(RL::fit_function(own, vectors, fit, smooth).converged);
  REQUIRE(RL::fit_function(own, vectors, linear_fit, np).converged);
  double error = 0, linear_error = 0;
  for(Vertex v : own.vertices())
    for(int k = 0; k < 2; ++k) {
      error = (std::max)(error, std::abs(fit[v][k] - vectors[v][k]));
      linear_error = (std::max)(linear_error, std::abs(linear_fit[v][k] - vectors[v][k]));
    }
  CHECK(error < 0.25 * linear_error);

  // vector fields: the gradient of x * y, its part along the surface counts
  const auto field = own.add_property_map<Vertex, RL::Vector_3>("v:field").first;
  const auto product = own.add_property_map<Vertex, double>("v:product").first;
  for(Vertex v : own.vertices()) {
    const RL::Point_3& p = own.point(v);
    field[v] = RL::Vector_3(3 * p.y() * std::cos(3 * p.x()), std::sin(3 * p.x()), 0);
    product[v] = std::sin(3 * p.x()) * p.y();
  }
  const auto of_smooth = own.add_property_map<Vertex, double>("v:of_smooth").first,
             of_linear = own.add_property_map<Vertex, double>("v:of_linear").first;
  REQUIRE(RL::integrate_gradient_field(own, field, of_smooth, smooth).converged);
  REQUIRE(RL::integrate_gradient_field(own, field, of_linear, np).converged);
  CHECK(largest_difference(of_smooth, product) < 0.25 * largest_difference(of_linear, product));

  // soups
  const shapes::Triangles t = shapes::triangles(own);
  std::vector<double> of_soup(t.points.size());
  REQUIRE(RL::solve_screened_poisson(RL::soup(t.points, t.faces), CGAL::make_property_map(values),
                                     1, CGAL::make_property_map(of_soup), smooth)
              .converged);
  double largest = 0;
  for(Vertex v : own.vertices())
    largest = (std::max)(largest, std::abs(of_soup[v] - by_smooth[v]));
  CHECK(largest < 1e-10);
}

TEST_CASE("smooth_data_of_bad_meshes") {
  const auto np = params::depth(3).vertex_data(RL::Vertex_data::smooth);
  // one triangle, a degenerate one, one that is turned around, a double one
  shapes::Triangles t;
  t.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}, {5, 5, 5}};
  t.faces = {{0, 1, 2}};
  const auto error = [&] {
    const auto linear = [](const RL::Point_3& p) { return 2 * p.x() + p.y(); };
    const RL::Triangulated_surface_3 surface = surface_of(t);
    const RL::Cubic_surface_function<double> f(surface, values_at(t, linear));
    double worst = 0;
    for_each_sample(surface, [&](const RL::Surface_point& p) {
      worst = (std::max)(worst, std::abs(f(p) - linear(p.point)));
    });
    return worst;
  };
  CHECK(error() < 1e-14);
  t.faces.push_back({0, 1, 3});
  CHECK(error() < 1e-14);
  t.faces.push_back({1, 2, 3});
  CHECK(error() < 1e-14);
  t.faces.push_back({2, 1, 3});
  CHECK(error() < 1e-14);
  t.faces.push_back({2, 1, 1});
  CHECK(error() < 1e-14);

  // a fan with very many spokes: one ring, not the square of it
  t = shapes::Triangles();
  constexpr std::uint32_t spokes = 20000;
  t.points.emplace_back(0, 0, 0);
  for(std::uint32_t i = 0; i < spokes; ++i) {
    t.points.emplace_back(std::cos(2 * CGAL_PI * i / spokes), std::sin(2 * CGAL_PI * i / spokes),
                          0);
    t.faces.push_back({0, 1 + i, 1 + (i + 1) % spokes});
  }
  CHECK(error() < 1e-11);

  // a value that is no number names a face; a vertex without a face needs no value
  t = shapes::sphere(2);
  std::vector<double> values = values_at(t, wave), u(t.points.size());
  values[5] = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(RL::solve_screened_poisson(RL::soup(t.points, t.faces),
                                             CGAL::make_property_map(values), 1,
                                             CGAL::make_property_map(u), np),
                  RL::Parameter_error);
  values[5] = 0;
  t.points.emplace_back(9, 9, 9);
  values.push_back(std::numeric_limits<double>::quiet_NaN());
  u.resize(t.points.size());
  CHECK(RL::solve_screened_poisson(RL::soup(t.points, t.faces), CGAL::make_property_map(values), 1,
                                   CGAL::make_property_map(u), np)
            .converged);
  CHECK_THROWS_AS(RL::solve_screened_poisson(RL::soup(t.points, t.faces),
                                             CGAL::make_property_map(values), 1,
                                             CGAL::make_property_map(u), np.crease_angle(-1.)),
                  RL::Parameter_error);
}
