// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Smooth patches on the faces of a surface: how near they come to surfaces whose points are known,
// what remains flat, and that neighbors meet.

#include "catch.h"
#include "shapes.h"
#include "special_shapes.h"

#include <CGAL/Restricted_laplacian_3/patches/curved_surface.h>
#include <CGAL/Restricted_laplacian_3/surface/Surface_patches.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <random>
#include <utility>
#include <vector>

namespace {

namespace RL = CGAL::Restricted_laplacian_3;

RL::Triangulated_surface_3 surface(const shapes::Triangles& t) {
  return RL::Triangulated_surface_3(t.points, t.faces);
}

/// calls `visit(face, barycentric)` at the points of a grid in each face, also on its sides
template <class Visitor>
void for_each_location(const RL::Triangulated_surface_3& s, Visitor visit) {
  constexpr int n = 6;
  for(std::size_t f = 0; f < s.number_of_faces(); ++f)
    for(int i = 0; i <= n; ++i)
      for(int j = 0; i + j <= n; ++j)
        visit(f, std::array<double, 3>{i / double(n), j / double(n), (n - i - j) / double(n)});
}

/// a torus around the z axis with random shifts of the vertices along it
shapes::Triangles torus(int n, double large, double small, double jitter) {
  shapes::Triangles t;
  std::mt19937 generator(7);
  const auto random = [&] { return jitter * (generator() * std::ldexp(2., -32) - 1); };
  const int m = n / 2;
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < m; ++j) {
      const double u = 2 * CGAL_PI * (i + random()) / n, v = 2 * CGAL_PI * (j + random()) / m,
                   r = large + small * std::cos(v);
      t.points.emplace_back(r * std::cos(u), r * std::sin(u), small * std::sin(v));
    }
  const auto number = [=](int i, int j) { return static_cast<std::uint32_t>(i % n * m + j % m); };
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < m; ++j) {
      t.faces.push_back({number(i, j), number(i + 1, j), number(i + 1, j + 1)});
      t.faces.push_back({number(i, j), number(i + 1, j + 1), number(i, j + 1)});
    }
  return t;
}

/// a tube without caps, or a strip of it, around the z axis: `n` quadrilaterals around, `m` along
shapes::Triangles tube(int n, int m, double angle) {
  shapes::Triangles t;
  for(int j = 0; j <= m; ++j)
    for(int i = 0; i <= n; ++i)
      t.points.emplace_back(std::cos(angle * i / n), std::sin(angle * i / n), 2. * j / m);
  const auto number = [=](int i, int j) { return static_cast<std::uint32_t>(j * (n + 1) + i); };
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < m; ++j) {
      t.faces.push_back({number(i, j), number(i + 1, j), number(i + 1, j + 1)});
      t.faces.push_back({number(i, j), number(i + 1, j + 1), number(i, j + 1)});
    }
  return t;
}

double distance_to_torus(const RL::Point_3& p, double large, double small) {
  return std::abs(std::hypot(std::hypot(p.x(), p.y()) - large, p.z()) - small);
}

} // namespace

TEST_CASE("patches_of_a_sphere_converge_fast") {
  // In the distance from the sphere, in normals, and in area. Flat triangles have the orders 2, 1
  // and 2, and a distance of 0.04 with the first.
  std::array<double, 3> last = {0, 0, 0};
  for(int n = 2; n <= 4; ++n) {
    const RL::Triangulated_surface_3 s = RL::curved_surface(surface(shapes::sphere(n)));
    CHECK(s.is_smooth());
    CHECK(s.patches().number_of_folded_faces() == 0);
    std::array<double, 3> errors = {0, 0, std::abs(s.area() / (4 * CGAL_PI) - 1)};
    for_each_location(s, [&](std::size_t face, const std::array<double, 3>& l) {
      const RL::Surface_point p = s.surface_point({face, l});
      const RL::Vector_3 radius = p.point - CGAL::ORIGIN;
      errors[0] = (std::max)(errors[0], std::abs(std::sqrt(radius.squared_length()) - 1));
      errors[1] =
          (std::max)(errors[1], std::sqrt(CGAL::cross_product(radius, p.normal).squared_length()));
    });
    INFO("division " << n << ": " << errors[0] << ' ' << errors[1] << ' ' << errors[2]);
    const std::array<double, 3> largest = {1e-5, 3e-4, 5e-6};
    const std::array<double, 3> orders = {3.8, 2.9, 5.5};
    for(int i = 0; i < 3; ++i) {
      if(n == 2)
        CHECK(errors[i] < largest[i]);
      else
        CHECK(std::log2(last[i] / errors[i]) > orders[i]);
    }
    last = errors;
  }
}

TEST_CASE("patches_of_an_irregular_torus") {
  const double large = 1, small = 0.4;
  const shapes::Triangles t = torus(96, large, small, 0.25);
  const RL::Triangulated_surface_3 flat = surface(t), smooth = RL::curved_surface(flat);
  double flat_error = 0, smooth_error = 0;
  for_each_location(flat, [&](std::size_t face, const std::array<double, 3>& l) {
    flat_error = (std::max)(flat_error,
                            distance_to_torus(flat.surface_point({face, l}).point, large, small));
    smooth_error = (std::max)(
        smooth_error, distance_to_torus(smooth.surface_point({face, l}).point, large, small));
  });
  CAPTURE(flat_error, smooth_error);
  CHECK(smooth_error < flat_error / 20);
  const double area = 4 * CGAL_PI * CGAL_PI * large * small;
  CHECK(std::abs(smooth.area() - area) < std::abs(flat.area() - area) / 100);

  SECTION("given normals are used, and turned around where they point inward") {
    RL::Smooth_geometry geometry;
    std::size_t v = 0;
    for(const RL::Point_3& p : t.points) {
      const double r = std::hypot(p.x(), p.y());
      const RL::Vector_3 n(p.x() - large * p.x() / r, p.y() - large * p.y() / r, p.z());
      // of any length and sign; some are missing
      if(v % 17 == 3)
        geometry.vertex_normals.emplace_back(0, 0, 0);
      else if(v % 17 == 5)
        geometry.vertex_normals.emplace_back(std::numeric_limits<double>::quiet_NaN(), 0, 0);
      else
        geometry.vertex_normals.push_back(v % 3 == 0 ? -n : 7 * n);
      ++v;
    }
    const RL::Triangulated_surface_3 given = RL::curved_surface(flat, geometry);
    double error = 0, of_normals = 0, of_estimated_normals = 0;
    for(std::size_t f = 0; f < flat.number_of_faces(); ++f) {
      const RL::Surface_location corner{f, {1, 0, 0}};
      const RL::Surface_point p = given.surface_point(corner);
      const double r = std::hypot(p.point.x(), p.point.y());
      const RL::Vector_3 n = RL::Vector_3(p.point.x() - large * p.point.x() / r,
                                          p.point.y() - large * p.point.y() / r, p.point.z()) /
                             small;
      if(p.vertices[0] % 17 != 3 && p.vertices[0] % 17 != 5)
        of_normals = (std::max)(of_normals, std::sqrt((n - p.normal).squared_length()));
      of_estimated_normals =
          (std::max)(of_estimated_normals,
                     std::sqrt((n - smooth.surface_point(corner).normal).squared_length()));
    }
    for_each_location(flat, [&](std::size_t face, const std::array<double, 3>& l) {
      error =
          (std::max)(error, distance_to_torus(given.surface_point({face, l}).point, large, small));
    });
    CAPTURE(error, of_normals, of_estimated_normals);
    CHECK(error < 1.2 * smooth_error);
    CHECK(of_normals < 1e-12);
    CHECK(of_estimated_normals > 1e-4);
  }
}

TEST_CASE("derivatives_of_patches") {
  const RL::Triangulated_surface_3 s = RL::curved_surface(surface(torus(24, 1, 0.4, 0.2)));
  for(std::size_t f = 0; f < s.number_of_faces(); f += 13) {
    const std::array<RL::Point_3, 3> corners = {s.point(f, 0), s.point(f, 1), s.point(f, 2)};
    const std::array<double, 3> l = {0.2, 0.5, 0.3};
    const RL::Patch_point p = s.patches().evaluate(f, corners, l);
    CHECK(p.point == s.surface_point({f, l}).point);
    // by differences
    constexpr double e = 1e-6;
    std::array<RL::Vector_3, 2> differences, derivatives;
    for(int i = 0; i < 2; ++i) {
      std::array<double, 3> before = l, after = l, direction = {-1, 0, 0};
      direction[i + 1] = 1;
      for(int k = 0; k < 3; ++k) {
        before[k] -= e * direction[k];
        after[k] += e * direction[k];
      }
      differences[i] =
          (s.surface_point({f, after}).point - s.surface_point({f, before}).point) / (2 * e);
      derivatives[i] = s.patches().derivative(f, corners, l, direction);
      CHECK(std::sqrt((differences[i] - derivatives[i]).squared_length()) < 1e-9);
    }
    const RL::Vector_3 cross = CGAL::cross_product(differences[0], differences[1]);
    CHECK(std::sqrt(cross.squared_length()) / 2 == Approx(p.area).epsilon(1e-6));
    CHECK(cross * p.normal == Approx(2 * p.area).epsilon(1e-6));
    CHECK((s.patches().deviation(f, l) -
           (p.point - RL::Triangulated_surface_3({corners[0], corners[1], corners[2]}, {{0, 1, 2}})
                          .surface_point({0, l})
                          .point))
              .squared_length() < 1e-30);
  }
}

TEST_CASE("patches_meet_along_edges") {
  // also where orientations change, and at creases
  shapes::Triangles t = torus(24, 1, 0.4, 0.25);
  for(std::size_t f = 0; f < t.faces.size(); f += 3)
    std::swap(t.faces[f][0], t.faces[f][1]);
  RL::Smooth_geometry geometry;
  geometry.crease_angle = 25;
  const RL::Triangulated_surface_3 s = RL::curved_surface(surface(t), geometry);
  std::map<std::pair<std::uint32_t, std::uint32_t>, RL::Point_3> points;
  int count = 0;
  for(std::size_t f = 0; f < s.number_of_faces(); ++f)
    for(int i = 0; i < 3; ++i) {
      const std::uint32_t a = s.triangle(f)[i], b = s.triangle(f)[(i + 1) % 3];
      std::array<double, 3> l = {0, 0, 0};
      l[a < b ? i : (i + 1) % 3] = 0.3;
      l[a < b ? (i + 1) % 3 : i] = 0.7;
      const RL::Point_3 p = s.surface_point({f, l}).point;
      const auto [it, is_new] = points.insert({std::minmax(a, b), p});
      if(!is_new) {
        ++count;
        CHECK(std::sqrt((p - it->second).squared_length()) < 1e-15);
      }
    }
  CHECK(2 * static_cast<std::size_t>(count) == 3 * t.faces.size());
}

TEST_CASE("faces_oriented_against_each_other_have_the_same_patches") {
  shapes::Triangles t = torus(24, 1, 0.4, 0.25);
  const RL::Triangulated_surface_3 oriented = RL::curved_surface(surface(t));
  for(std::size_t f = 0; f < t.faces.size(); f += 3)
    std::swap(t.faces[f][0], t.faces[f][1]);
  const RL::Triangulated_surface_3 mixed = RL::curved_surface(surface(t));
  double largest = 0;
  for_each_location(oriented, [&](std::size_t f, const std::array<double, 3>& l) {
    std::array<double, 3> m = l;
    if(f % 3 == 0)
      std::swap(m[0], m[1]);
    largest = (std::max)(largest,
                         (oriented.surface_point({f, l}).point - mixed.surface_point({f, m}).point)
                             .squared_length());
  });
  CHECK(std::sqrt(largest) < 1e-14);
}

TEST_CASE("a_box_remains_a_box") {
  const RL::Triangulated_surface_3 flat = surface(shapes::box(1, 2, 3, 4, 1)),
                                   s = RL::curved_surface(flat);
  for(std::size_t f = 0; f < s.number_of_faces(); ++f)
    CHECK(s.patches().is_flat(f));
  CHECK(s.area() == flat.area());
}

TEST_CASE("creases_and_boundaries_are_curves") {
  // a cylinder without caps: its rims are circles
  const double angle = 2;
  const RL::Triangulated_surface_3 s = RL::curved_surface(surface(tube(16, 8, angle)));
  double error = 0, height_error = 0;
  for_each_location(s, [&](std::size_t f, const std::array<double, 3>& l) {
    const RL::Point_3 p = s.surface_point({f, l}).point;
    error = (std::max)(error, std::abs(std::hypot(p.x(), p.y()) - 1));
    for(int i = 0; i < 3; ++i)
      if(l[i] == 0 && s.point(f, (i + 1) % 3).z() == 0 && s.point(f, (i + 2) % 3).z() == 0)
        height_error = (std::max)(height_error, std::abs(p.z()));
  });
  CAPTURE(error, height_error);
  CHECK(error < 2e-4); // flat: 2e-3
  CHECK(height_error < 2e-6);
  CHECK(std::abs(s.area() - 2 * angle) < 2e-4);
}

TEST_CASE("the_boundary_of_a_disc_is_round") {
  // normals say nothing about it
  shapes::Triangles t;
  const std::uint32_t n = 24;
  t.points.emplace_back(0, 0, 0);
  for(std::uint32_t i = 0; i < n; ++i) {
    const double a = 2 * CGAL_PI * i / n;
    t.points.emplace_back(std::cos(a), std::sin(a), 0);
    t.faces.push_back({0, 1 + i, 1 + (i + 1) % n});
  }
  const RL::Triangulated_surface_3 flat = surface(t), s = RL::curved_surface(flat);
  CHECK(std::abs(flat.area() / CGAL_PI - 1) > 1e-2);
  CHECK(std::abs(s.area() / CGAL_PI - 1) < 1e-6);
  double error = 0;
  for_each_location(s, [&](std::size_t f, const std::array<double, 3>& l) {
    const RL::Point_3 p = s.surface_point({f, l}).point;
    CHECK(p.z() == 0);
    if(l[0] == 0) // the side opposite to the center
      error = (std::max)(error, std::abs(std::hypot(p.x(), p.y()) - 1));
  });
  CHECK(error < 1e-6);
}

TEST_CASE("planes_beside_smooth_parts_remain_planes") {
  // A quarter of a cylinder between two planes that touch it, all in squares. The planes have
  // vertices inside, the strips of the cylinder do not.
  shapes::Triangles t;
  const int n = 5, around = 6;
  std::vector<std::array<double, 2>> profile;
  for(int i = 0; i < n; ++i)
    profile.push_back({-1. + i / double(n), 1});
  for(int i = 0; i <= around; ++i) {
    const double a = CGAL_PI / 2 * i / around;
    profile.push_back({std::sin(a), std::cos(a)});
  }
  for(int i = 1; i <= n; ++i)
    profile.push_back({1, -i / double(n)});
  const auto columns = static_cast<std::uint32_t>(profile.size());
  for(std::uint32_t j = 0; j <= 4; ++j)
    for(const auto& p : profile)
      t.points.emplace_back(p[0], p[1], j / 2.);
  for(std::uint32_t j = 0; j < 4; ++j)
    for(std::uint32_t i = 0; i + 1 < columns; ++i) {
      const std::uint32_t a = j * columns + i, b = a + 1, c = b + columns, d = a + columns;
      t.faces.push_back({a, b, c});
      t.faces.push_back({a, c, d});
    }
  const RL::Triangulated_surface_3 s = RL::curved_surface(surface(t));
  double of_planes = 0, of_cylinder = 0;
  int number_of_planes = 0;
  for_each_location(s, [&](std::size_t f, const std::array<double, 3>& l) {
    const RL::Surface_point p = s.surface_point({f, l});
    const RL::Vector_3& n = s.normal(f);
    if((std::max)(std::abs(n.x()), std::abs(n.y())) > 1 - 1e-12) {
      ++number_of_planes;
      of_planes = (std::max)(of_planes, std::abs(1 - (p.normal * n)));
      of_planes = (std::max)(of_planes, std::abs((std::max)(p.point.x(), p.point.y()) - 1));
    } else {
      of_cylinder = (std::max)(of_cylinder, std::abs(std::hypot(p.point.x(), p.point.y()) - 1));
    }
  });
  CAPTURE(of_planes, of_cylinder);
  CHECK(number_of_planes > 0);
  CHECK(of_planes < 1e-6);
  CHECK(of_cylinder < 2e-4); // flat: 8.6e-3
}

TEST_CASE("planes_that_meet_at_a_small_angle_remain_planes") {
  // a roof whose ridge is no crease, and a pyramid, in whose tip four planes meet
  for(bool is_pyramid : {false, true})
    for(double slope : {0.02, 0.15}) {
      const shapes::Triangles t = shapes::grid(8, [=](double x, double y) {
        const double z = std::abs(x - 0.5) + (is_pyramid ? std::abs(y - 0.5) : 0);
        return RL::Point_3(x, y, -slope * z);
      });
      const RL::Triangulated_surface_3 s = RL::curved_surface(surface(t));
      double largest = 0;
      for(std::size_t f = 0; f < s.number_of_faces(); ++f) {
        bool is_inside = true; // the boundary is a curve where it bends little
        for(int i = 0; i < 3; ++i)
          is_inside = is_inside && s.point(f, i).y() > 0 && s.point(f, i).y() < 1 &&
                      s.point(f, i).x() > 0 && s.point(f, i).x() < 1;
        for(const RL::Vector_3& control : s.patches().controls(f))
          if(is_inside)
            largest = (std::max)(largest, control.squared_length());
      }
      CHECK(largest < 1e-20);
    }
}

TEST_CASE("patches_that_would_fold_are_flat") {
  // normals that have nothing to do with the surface
  const shapes::Triangles t = shapes::sphere(2);
  const RL::Triangulated_surface_3 flat = surface(t);
  RL::Smooth_geometry geometry;
  std::mt19937 generator(5);
  const auto random = [&] { return generator() * std::ldexp(2., -32) - 1; };
  for(std::size_t v = 0; v < t.points.size(); ++v)
    geometry.vertex_normals.emplace_back(random(), random(), random());
  const RL::Triangulated_surface_3 s = RL::curved_surface(flat, geometry);
  CHECK(s.patches().number_of_folded_faces() > 0);
  std::size_t number_of_flat_faces = 0;
  for(std::size_t f = 0; f < s.number_of_faces(); ++f)
    number_of_flat_faces += s.patches().is_flat(f) ? 1 : 0;
  CHECK(number_of_flat_faces >= s.patches().number_of_folded_faces());
  for_each_location(s, [&](std::size_t f, const std::array<double, 3>& l) {
    const RL::Surface_point p = s.surface_point({f, l});
    CHECK(p.normal * s.normal(f) > 0);
    CHECK(std::abs(p.normal.squared_length() - 1) < 1e-12);
  });
}

TEST_CASE("a_projection_gives_the_surface_itself") {
  RL::Smooth_geometry geometry;
  geometry.set_projection([](const RL::Point_3& p) {
    const RL::Vector_3 v = p - CGAL::ORIGIN;
    return CGAL::ORIGIN + v / std::sqrt(v.squared_length());
  });
  // vertices beside the sphere
  shapes::Triangles t = shapes::sphere(3);
  for(std::size_t v = 0; v < t.points.size(); ++v)
    t.points[v] = CGAL::ORIGIN + (t.points[v] - CGAL::ORIGIN) * (1 + 1e-2 * std::sin(double(v)));
  const RL::Triangulated_surface_3 s = RL::curved_surface(surface(t), geometry);
  double error = 0;
  for_each_location(s, [&](std::size_t f, const std::array<double, 3>& l) {
    const RL::Surface_point p = s.surface_point({f, l});
    error = (std::max)(error, std::abs(std::sqrt((p.point - CGAL::ORIGIN).squared_length()) - 1));
  });
  CAPTURE(error);
  CHECK(error < 4e-5);
  CHECK(std::abs(s.area() / (4 * CGAL_PI) - 1) < 2e-5);

  geometry.set_projection([](const RL::Point_3& p) {
    return p.x() > 0.9 ? RL::Point_3(p.x(), p.y(), std::numeric_limits<double>::infinity()) : p;
  });
  CHECK_THROWS_AS(RL::curved_surface(surface(shapes::sphere(3)), geometry), RL::Input_error);

  geometry.projection = [](const std::vector<RL::Point_3>& points) {
    return std::vector<RL::Point_3>(points.begin(), points.begin() + 1);
  };
  CHECK_THROWS_AS(RL::curved_surface(surface(shapes::sphere(1)), geometry), RL::Parameter_error);
}

TEST_CASE("patches_of_bad_meshes") {
  SECTION("parameters") {
    const RL::Triangulated_surface_3 s = surface(shapes::sphere(1));
    RL::Smooth_geometry geometry;
    geometry.crease_angle = -1;
    CHECK_THROWS_AS(RL::curved_surface(s, geometry), RL::Parameter_error);
    geometry.crease_angle = 40;
    geometry.vertex_normals.resize(3);
    CHECK_THROWS_AS(RL::curved_surface(s, geometry), RL::Parameter_error);
  }
  SECTION("one triangle, and degenerate ones") {
    shapes::Triangles t;
    t.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.5, 0, 0}};
    t.faces = {{0, 1, 2}, {0, 3, 1}, {0, 0, 1}, {2, 2, 2}};
    const RL::Triangulated_surface_3 s = RL::curved_surface(surface(t));
    CHECK(s.area() == 0.5);
    for(std::size_t f = 0; f < 4; ++f)
      CHECK(s.patches().is_flat(f));
  }
  SECTION("needles") {
    shapes::Triangles t = torus(24, 1, 0.4, 0.25);
    for(RL::Point_3& p : t.points)
      p = RL::Point_3(p.x(), p.y(), 1e-6 * p.z());
    const RL::Triangulated_surface_3 s = RL::curved_surface(surface(t));
    for_each_location(s, [&](std::size_t f, const std::array<double, 3>& l) {
      const RL::Surface_point p = s.surface_point({f, l});
      CHECK(std::isfinite(p.point.x() + p.point.y() + p.point.z()));
      if(!s.is_degenerate(f))
        CHECK(p.normal * s.normal(f) > 0);
    });
  }
  SECTION("huge and tiny") {
    const shapes::Triangles unit = shapes::sphere(2);
    const double deviation = std::abs(RL::curved_surface(surface(unit)).area());
    for(double scale : {1e-90, 1e90}) {
      shapes::Triangles t = unit;
      for(RL::Point_3& p : t.points)
        p = CGAL::ORIGIN + (p - CGAL::ORIGIN) * scale;
      CHECK(RL::curved_surface(surface(t)).area() / scale / scale ==
            Approx(deviation).epsilon(1e-12));
    }
  }
}
