// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Distances between the vertices, triangle by triangle and as splines.

#include "catch.h"
#include "geodesic_shapes.h"
#include "shapes.h"
#include "special_shapes.h"
#include "test_meshes.h"

#include <CGAL/Restricted_laplacian_3/geodesics/Geodesic_function.h>
#include <CGAL/Restricted_laplacian_3/geodesics/Geodesic_solver.h>
#include <CGAL/Restricted_laplacian_3/input/read_surface.h>
#include <CGAL/Restricted_laplacian_3/problems/Geodesic_fitter.h>
#include <CGAL/Restricted_laplacian_3/surface/vertex_normals.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace RL = CGAL::Restricted_laplacian_3;

RL::Geodesic_function distance_from(const RL::Geodesic_solver& rays,
                                    const RL::Geodesic_sources& sources) {
  return RL::Geodesic_function(rays, rays.distances(sources));
}
/// places in a triangle: inside and on the sides
const std::vector<std::array<double, 3>> places = {
    {1. / 3, 1. / 3, 1. / 3}, {0.8, 0.15, 0.05}, {0.1, 0.2, 0.7}, {0, 0.5, 0.5}, {0.25, 0, 0.75}};

/// mean and worst relative error of what is farther than `near`
struct Errors_between {
  double mean = 0, worst = 0;

  template <class Function, class Distance>
  Errors_between(const RL::Triangulated_surface_3& surface, const Function& u, Distance&& distance,
                 double near) {
    int number = 0;
    for(std::size_t f = 0; f < surface.number_of_faces(); ++f)
      for(const auto& l : places) {
        const RL::Surface_location location{f, l};
        const double expected = distance(surface.surface_point(location).point);
        if(expected > near) {
          const double error = std::abs(u.value(location) / expected - 1);
          mean += error;
          worst = (std::max)(worst, error);
          ++number;
        }
      }
    mean /= number;
  }
};

double on_sphere(const RL::Point_3& p, const RL::Point_3& q) {
  const RL::Vector_3 a = p - CGAL::ORIGIN, b = q - CGAL::ORIGIN;
  return std::acos(std::clamp(a * b / (shapes::length(a) * shapes::length(b)), -1., 1.));
}

} // namespace

TEST_CASE("distances_in_triangles_are_exact_for_rays_from_one_point", "[geodesic_spline]") {
  const auto t = shapes::grid(9, [](double x, double y) { return RL::Point_3(x, y, 0.3 * x - y); });
  const RL::Geodesic_solver rays = shapes::geodesics(t);
  for(const RL::Surface_location& l :
      {RL::Surface_location{20, {1, 0, 0}}, RL::Surface_location{77, {0.2, 0.3, 0.5}}}) {
    RL::Geodesic_sources sources;
    sources.add_location(l);
    const RL::Point_3 source = rays.surface().surface_point(l).point;
    const RL::Geodesic_function d = distance_from(rays, sources);
    for(std::size_t f = 0; f < t.faces.size(); ++f)
      for(const auto& place : places) {
        const RL::Surface_location here{f, place};
        const RL::Vector_3 from = rays.surface().surface_point(here).point - source;
        CHECK(d.value(here) == Approx(shapes::length(from)).margin(1e-7));
        if(shapes::length(from) > 1e-3)
          CHECK(shapes::length(d.gradient(here) - from / shapes::length(from)) < 1e-6);
      }
    CHECK(shapes::length(d.gradient(l)) < 1e-6);
    CHECK(d.value(l) < 1e-7);
  }
}

TEST_CASE("distances_in_triangles_are_exact_for_parallel_rays", "[geodesic_spline]") {
  const int n = 10;
  const auto t = shapes::grid(n, [](double x, double y) { return RL::Point_3(x, y, 0); });
  const RL::Geodesic_solver rays = shapes::geodesics(t);
  RL::Geodesic_sources side;
  for(std::size_t f = 0; f < t.faces.size(); ++f)
    for(int k = 0; k < 3; ++k)
      if(rays.surface().point(f, k).x() == 0 && rays.surface().point(f, (k + 1) % 3).x() == 0) {
        RL::Surface_location from{f, {0, 0, 0}}, to{f, {0, 0, 0}};
        from.barycentric[k] = to.barycentric[(k + 1) % 3] = 1;
        side.add_segment(from, to);
      }
  const RL::Geodesic_function d = distance_from(rays, side);
  for(std::size_t f = 0; f < t.faces.size(); ++f) {
    const RL::Surface_location here{f, places[0]};
    const double x = rays.surface().surface_point(here).point.x();
    CHECK(d.value(here) == Approx(x).epsilon(1e-4));
    CHECK(shapes::length(d.gradient(here) - RL::Vector_3(1, 0, 0)) < 1e-2);
  }
}

TEST_CASE("distances_in_triangles_with_sources_are_those_from_them", "[geodesic_spline]") {
  const shapes::Triangles t = shapes::rectangle(1, 1);
  const RL::Geodesic_solver rays = shapes::geodesics(t);
  const RL::Surface_location middle{0, {0.5, 0.5, 0}};
  RL::Geodesic_sources sources;
  // between two vertices that are sources, and on the edge as a source
  sources.add_vertex(0);
  sources.add_vertex(1);
  CHECK(distance_from(rays, sources).value(middle) == Approx(0.5));
  sources.add_segment({0, {1, 0, 0}}, {0, {0, 1, 0}});
  CHECK(distance_from(rays, sources).value(middle) < 1e-9);
  // a segment inside, the other side of which is as near
  sources = {};
  sources.add_segment({0, {0.5, 0.3, 0.2}}, {0, {0.2, 0.3, 0.5}});
  const RL::Geodesic_function d = distance_from(rays, sources);
  CHECK(d.value({0, {0.35, 0.3, 0.35}}) < 1e-9);
  CHECK(d.value({0, {0.25, 0.5, 0.25}}) == Approx(0.2 * std::sqrt(0.5)));
  CHECK(d.value({0, {0.4, 0.2, 0.4}}) == Approx(0.1 * std::sqrt(0.5)));
}

TEST_CASE("ridges_of_distances_stay_sharp_in_triangles", "[geodesic_spline]") {
  const int n = 11;
  const auto t = shapes::grid(n, [](double x, double y) { return RL::Point_3(x, y, 0); });
  const RL::Geodesic_solver rays = shapes::geodesics(t);
  RL::Geodesic_sources two;
  two.add_location({3, {0.2, 0.3, 0.5}});
  two.add_location({190, {0.6, 0.3, 0.1}}, 1);
  const RL::Point_3 a = rays.surface().surface_point(two.segments()[0].from).point,
                    b = rays.surface().surface_point(two.segments()[1].from).point;
  const RL::Geodesic_function d = distance_from(rays, two);
  const auto distance = [&](const RL::Point_3& p) {
    return (std::min)(shapes::length(p - a), shapes::length(p - b));
  };
  // what is smooth across the ridge would round it off
  CHECK(Errors_between(rays.surface(), d, distance, 0).worst < 0.01);
}

TEST_CASE("distances_in_triangles_converge_with_order_two", "[geodesic_spline]") {
  const auto errors = [](int n) {
    const shapes::Triangles t = shapes::sphere(n);
    const RL::Geodesic_solver rays = shapes::geodesics(t);
    return Errors_between(
        rays.surface(), distance_from(rays, RL::Geodesic_sources::vertex(3)),
        [&](const RL::Point_3& p) { return on_sphere(p, t.points[3]); }, 0.1);
  };
  const Errors_between a = errors(3), b = errors(4), c = errors(5);
  CHECK(c.mean < 5e-4);
  CHECK(a.mean / b.mean > 3.3);
  CHECK(b.mean / c.mean > 3.3);
}

TEST_CASE("distances_in_triangles_are_those_of_the_corners_there", "[geodesic_spline]") {
  for(const shapes::Triangles& t : {shapes::bumpy_square(8, 0.4, 3, 5),
                                    shapes::box(1, 2, 0.1, 3, 7), shapes::ragged_square(8, 1, 2)}) {
    const RL::Geodesic_solver rays = shapes::geodesics(t);
    const RL::Geodesic_distances d = rays.distances(RL::Geodesic_sources::vertex(1));
    const RL::Geodesic_function u(rays, d);
    for(std::size_t f = 0; f < t.faces.size(); ++f) {
      for(int k = 0; k < 3; ++k) {
        RL::Surface_location corner{f, {0, 0, 0}};
        corner.barycentric[k] = 1;
        CHECK(u.value(corner) == Approx(d.distances[t.faces[f][k]]).margin(1e-9));
      }
      for(const auto& place : places) {
        const RL::Surface_location here{f, place};
        const RL::Point_3 p = rays.surface().surface_point(here).point;
        for(const std::uint32_t v : t.faces[f])
          CHECK(std::abs(u.value(here) - d.distances[v]) <=
                shapes::length(p - t.points[v]) * (1 + 1e-9));
        CHECK(shapes::length(u.gradient(here)) < 1.2001);
      }
    }
  }
}

TEST_CASE("what_distances_in_triangles_refuse", "[geodesic_spline]") {
  const shapes::Triangles t =
      shapes::joined(shapes::rectangle(1, 1), shapes::moved(shapes::rectangle(1, 1), {3, 0, 0}));
  const RL::Geodesic_solver rays = shapes::geodesics(t);
  const RL::Geodesic_distances found = rays.distances(RL::Geodesic_sources::vertex(0));
  const RL::Geodesic_function d(rays, found);
  CHECK(std::isinf(d.value({t.faces.size() - 1, places[0]})));
  CHECK(d.gradient({t.faces.size() - 1, places[0]}) == CGAL::NULL_VECTOR);
  CHECK_THROWS_AS(d.value({t.faces.size(), places[0]}), RL::Location_error);
  CHECK_THROWS_AS(d.gradient({0, {0.5, 0.6, 0.2}}), RL::Location_error);
  RL::Geodesic_distances other = found;
  other.sources = RL::Geodesic_sources::vertex(77);
  CHECK_THROWS_AS(RL::Geodesic_function(rays, other), RL::Invalid_vertex_error);
  other = found;
  other.distances.pop_back();
  CHECK_THROWS_AS(RL::Geodesic_function(rays, other), RL::Parameter_error);
  other = found;
  other.angles.clear();
  CHECK_THROWS_AS(RL::Geodesic_function(rays, other), RL::Parameter_error);
}

TEST_CASE("splines_of_distances_converge_on_a_sphere", "[geodesic_spline]") {
  const shapes::Triangles t = shapes::sphere(5);
  const RL::Geodesic_solver rays = shapes::geodesics(t);
  const RL::Geodesic_function d = distance_from(rays, RL::Geodesic_sources::vertex(3));
  // of the fit alone, against what is fitted, where neither source nor antipode is near
  std::vector<double> values, slopes;
  for(int depth : {3, 4, 5}) {
    const RL::Spline_space_3 space(rays.surface(), RL::parameters::depth(depth));
    const RL::Geodesic_spline u = RL::Geodesic_fitter(space).fit(d);
    CHECK(u.report().converged);
    CHECK(u.report().iterations <= 6);
    double value = 0, slope = 0;
    for(std::size_t f = 0; f < t.faces.size(); ++f) {
      const RL::Surface_location here{f, places[1]};
      if(std::abs(d.value(here) - CGAL_PI / 2) < 0.8) {
        value = (std::max)(value, std::abs(u.spline().value(here) - d.value(here)));
        slope = (std::max)(slope, shapes::length(u.spline().gradient(here) - d.gradient(here)));
      }
    }
    values.push_back(value);
    slopes.push_back(slope);
    const Errors_between errors(
        rays.surface(), u, [&](const RL::Point_3& p) { return on_sphere(p, t.points[3]); }, 0.06);
    CHECK(errors.mean < 1e-3);
    CHECK(errors.worst < 2e-2);
  }
  CAPTURE(values[0], values[1], values[2], slopes[0], slopes[1], slopes[2]);
  // the finest cells are as wide as two edges are long, and the spline sees the facets
  CHECK(values[0] / values[1] > 4);
  CHECK(values[2] < 1e-3);
  CHECK(slopes[0] < 0.04);
  CHECK(slopes[2] < 0.04);
}

TEST_CASE("gradients_of_splines_of_distances_are_those_of_their_values", "[geodesic_spline]") {
  const auto t = shapes::grid(6, [](double x, double y) { return RL::Point_3(x, y, 0.2 * x * x); });
  const RL::Geodesic_solver rays = shapes::geodesics(t);
  const RL::Spline_space_3 space(rays.surface(), RL::parameters::depth(4));
  const RL::Geodesic_spline u =
      RL::Geodesic_fitter(space).fit(distance_from(rays, RL::Geodesic_sources::vertex(8)));
  const double h = space.octree().cell_width(4);
  int own = 0, blended = 0;
  for(std::size_t f = 0; f < t.faces.size(); ++f)
    for(const auto& place : {places[0], places[1], places[2]}) {
      const RL::Surface_location here{f, place};
      const double d = u.function().value(here);
      own += d < 3 * h;
      blended += d > 3 * h && d < 4 * h;
      CHECK((d >= 3 * h || u.value(here) == d));
      CHECK((d <= 4 * h || u.value(here) == u.spline().value(here)));
      if(d < h)
        continue;
      // along two directions in the face
      const double step = 1e-5;
      for(int k = 0; k < 2; ++k) {
        RL::Surface_location after = here, before = here;
        after.barycentric[k] += step;
        after.barycentric[2] -= step;
        before.barycentric[k] -= step;
        before.barycentric[2] += step;
        const RL::Vector_3 way =
            rays.surface().surface_point(after).point - rays.surface().surface_point(before).point;
        CHECK(u.value(after) - u.value(before) ==
              Approx(u.gradient(here) * way).margin(1e-4 * shapes::length(way)));
      }
    }
  CHECK((own > 5 && blended > 5));
}

TEST_CASE("splines_of_distances_leave_out_what_no_source_reaches", "[geodesic_spline]") {
  const shapes::Triangles one = shapes::sphere(3),
                          two = shapes::joined(one, shapes::moved(one, {2.05, 0, 0}));
  const RL::Geodesic_solver rays = shapes::geodesics(two);
  const RL::Spline_space_3 space(rays.surface(), RL::parameters::depth(5));
  const RL::Geodesic_spline u =
      RL::Geodesic_fitter(space).fit(distance_from(rays, RL::Geodesic_sources::vertex(3)));
  const auto distance = [&](const RL::Point_3& p) {
    return p.x() > 1.03 ? 0 : on_sphere(p, two.points[3]);
  };
  CHECK(Errors_between(rays.surface(), u, distance, 0.4).mean < 1e-2);
  const RL::Surface_location there{two.faces.size() - 1, places[0]};
  CHECK(std::isinf(u.value(there)));
  CHECK(u.gradient(there) == CGAL::NULL_VECTOR);
}

TEST_CASE("what_fits_of_distances_refuse_and_tell", "[geodesic_spline]") {
  const RL::Geodesic_solver rays = shapes::geodesics(shapes::sphere(3));
  const RL::Geodesic_function d = distance_from(rays, RL::Geodesic_sources::vertex(0));
  const RL::Spline_space_3 space(rays.surface(), RL::parameters::depth(4));
  const RL::Geodesic_fitter fitter(space);
  double last = 0;
  const RL::Geodesic_spline u = fitter.fit(d, [&](double done) {
    CHECK(done >= last);
    last = done;
    return true;
  });
  CHECK(last == 1);
  CHECK_THROWS_AS(fitter.fit(d, [](double) { return false; }), RL::Canceled);
  CHECK_THROWS_AS(fitter.fit(distance_from(shapes::geodesics(shapes::sphere(2)),
                                           RL::Geodesic_sources::vertex(0))),
                  RL::Parameter_error);
  // options count
  const RL::Geodesic_spline tight =
      RL::Geodesic_fitter(space, RL::parameters::tolerance(1e-10)).fit(d);
  CHECK(tight.report().relative_residual < 1e-10);
  CHECK(u.report().relative_residual > 1e-10);
  CHECK((tight.spline().coefficients() - u.spline().coefficients()).norm() > 0);
  RL::Geodesic_fit_options options;
  options.stabilization = 1;
  const RL::Geodesic_spline stiff = RL::Geodesic_fitter(space, options).fit(d);
  CHECK((stiff.spline().coefficients() - u.spline().coefficients()).norm() >
        1e-6 * u.spline().coefficients().norm());
  // the same on several threads
  const RL::Spline_space_3 parallel(
      rays.surface(), RL::parameters::depth(4).concurrency_tag(CGAL::Parallel_if_available_tag()));
  const RL::Geodesic_spline again =
      RL::Geodesic_fitter(parallel,
                          RL::parameters::concurrency_tag(CGAL::Parallel_if_available_tag()))
          .fit(d);
  CHECK(again.spline().coefficients() == u.spline().coefficients());
}

TEST_CASE("distances_on_meshes_as_splines", "[geodesic_spline][shared]") {
  const std::string path = shared_mesh("bimba_5k.ply");
  if(path.empty())
    SKIP_TEST("bimba_5k.ply");
  const shapes::Triangles t = shapes::triangles(shapes::read(path));
  const RL::Geodesic_solver rays = shapes::geodesics(t);
  const auto source = RL::Geodesic_sources::vertex(0);
  const std::vector<double> exact = rays.distances(source, RL::Geodesic_method::exact).distances;
  const RL::Spline_space_3 space(rays.surface(), RL::parameters::depth(7));
  const RL::Geodesic_spline u = RL::Geodesic_fitter(space).fit(distance_from(rays, source));
  const double largest = *std::max_element(exact.begin(), exact.end());
  double sum = 0, worst = 0;
  int number = 0;
  for(std::size_t f = 0; f < t.faces.size(); ++f)
    for(int k = 0; k < 3; ++k) {
      RL::Surface_location corner{f, {0, 0, 0}};
      corner.barycentric[k] = 1;
      const double d = exact[t.faces[f][k]];
      if(d > 0.02 * largest) {
        const double error = std::abs(u.value(corner) / d - 1);
        sum += error;
        worst = (std::max)(worst, error);
        ++number;
      }
    }
  CHECK(sum / number < 5e-4);
  CHECK(worst < 0.012);
}

TEST_CASE("distances_of_points_without_faces", "[geodesic_spline]") {
  const auto points = [](const shapes::Triangles& t, const std::vector<RL::Vector_3>& normals) {
    return RL::Triangulated_surface_3(t.points, normals, std::vector<double>(t.points.size(), 1.));
  };
  SECTION("on a sphere, as a spline, too") {
    const shapes::Triangles t = shapes::sphere(4);
    std::vector<RL::Vector_3> normals;
    for(const RL::Point_3& p : t.points)
      normals.push_back(p - CGAL::ORIGIN);
    const RL::Triangulated_surface_3 surface(
        t.points, normals,
        std::vector<double>(t.points.size(), 4 * CGAL_PI / static_cast<double>(t.points.size())));
    const RL::Geodesic_solver rays(surface);
    const RL::Geodesic_function d = distance_from(rays, RL::Geodesic_sources::vertex(3));
    const RL::Spline_space_3 space(surface, RL::parameters::depth(4));
    const RL::Geodesic_spline u = RL::Geodesic_fitter(space).fit(d);
    for(std::size_t i = 0; i < t.points.size(); ++i) {
      const RL::Surface_location here = rays.location(i);
      CHECK((here.face == i && d.value(here) == d.distances().distances[i]));
      const double expected = on_sphere(t.points[i], t.points[3]);
      CHECK(d.value(here) == Approx(expected).epsilon(4e-3).margin(1e-9));
      CHECK(u.value(here) == Approx(expected).epsilon(2e-2).margin(1e-9));
      if(expected > 0.8 && expected < 2.8)
        CHECK(shapes::length(u.gradient(here) - d.gradient(here)) < 0.2);
    }
    const RL::Geodesic_path path = d.shortest_path(rays.location(100));
    CHECK(path.length == Approx(d.value(rays.location(100))).epsilon(1e-3));
    CHECK((path.segments.empty() && path.points.front() == t.points[100] &&
           path.points.back() == t.points[3]));
    // points as locations are sources
    RL::Geodesic_sources location;
    location.add_location({3, {1, 0, 0}});
    CHECK(rays.distances(location).distances == d.distances().distances);
    const std::vector<double> found =
        rays.distance_matrix({location}, std::vector<RL::Surface_location>{{100, {1, 0, 0}}});
    CHECK((found.size() == 1 && found[0] == Approx(d.value(rays.location(100)))));
    CHECK_THROWS_AS(d.value({t.points.size(), {1, 0, 0}}), RL::Location_error);
  }
  SECTION("both sides of a thin plate: around its rim") {
    const double thickness = 0.02;
    shapes::Triangles t =
        shapes::grid(30, [&](double x, double y) { return RL::Point_3(x, y, thickness); });
    std::vector<RL::Vector_3> normals(t.points.size(), RL::Vector_3(0, 0, 1));
    for(const RL::Point_3& p :
        shapes::grid(30, [](double x, double y) { return RL::Point_3(x, y, 0); }).points) {
      t.points.push_back(p);
      normals.emplace_back(0, 0, -1);
    }
    const RL::Geodesic_solver rays(points(t, normals));
    const std::size_t middle = 15 + 31 * 15;
    const std::vector<double> d = rays.distances(RL::Geodesic_sources::vertex(middle)).distances;
    CHECK(d[middle + 15] == Approx(0.5));
    // over the rim, or not at all
    CHECK(d[961 + middle] > 0.99);
  }
  SECTION("in a plane, some twice, at any scale") {
    for(const double scale : {1e-80, 1., 1e80}) {
      shapes::Triangles t = shapes::grid(8, [&](double x, double y) {
        return RL::Point_3(scale * x, scale * y, scale * 0.3 * x);
      });
      t.points.insert(t.points.end(), t.points.begin(), t.points.begin() + 20);
      const RL::Geodesic_solver rays(
          points(t, std::vector<RL::Vector_3>(t.points.size(), RL::Vector_3(-0.3, 0, 1))));
      const std::vector<double> d = rays.distances(RL::Geodesic_sources::vertex(85)).distances;
      for(std::size_t i = 0; i < t.points.size(); ++i)
        CHECK(d[i] / scale ==
              Approx(shapes::length((t.points[i] - t.points[85]) / scale)).margin(1e-9));
    }
  }
  SECTION("regular: the same from each solver of one process") {
    // squares with two diagonals of one length, and many sides of one length
    shapes::Triangles t;
    for(int i = 0; i <= 40; ++i)
      for(int j = 0; j <= 40; ++j)
        t.points.emplace_back(i, j, i % 2 == j % 2 ? 0.5 : 0);
    const std::vector<RL::Vector_3> normals(t.points.size(), RL::Vector_3(0, 0, 1));
    std::vector<double> expected;
    std::vector<std::unique_ptr<char[]>> between; // other memory, other addresses
    for(int i = 0; i < 6; ++i) {
      const std::vector<double> d = RL::Geodesic_solver(points(t, normals))
                                        .distances(RL::Geodesic_sources::vertex(0))
                                        .distances;
      if(i == 0)
        expected = d;
      const bool is_same = d == expected;
      CHECK((is_same && *std::max_element(d.begin(), d.end()) < 70));
      between.push_back(std::make_unique<char[]>(12345));
    }
  }
  SECTION("one whose normal is opposite to all others is at infinity") {
    shapes::Triangles t = shapes::grid(8, [](double x, double y) { return RL::Point_3(x, y, 0); });
    std::vector<RL::Vector_3> normals(t.points.size(), RL::Vector_3(0, 0, 1));
    t.points.emplace_back(0.5, 0.5, 0.1);
    normals.emplace_back(0, 0, -1);
    const RL::Geodesic_solver rays(points(t, normals));
    const std::vector<double> d = rays.distances(RL::Geodesic_sources::vertex(0)).distances;
    CHECK(d.back() == std::numeric_limits<double>::infinity());
    CHECK(*std::max_element(d.begin(), d.end() - 1) == Approx(std::sqrt(2.)));
    CHECK_THROWS_AS(rays.location(t.points.size() - 1), RL::Invalid_vertex_error);
  }
  SECTION("too few") {
    for(const auto& p : {std::vector<RL::Point_3>{{0, 0, 0}, {1, 0, 0}},
                         std::vector<RL::Point_3>{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {5, 0, 0}}}) {
      const shapes::Triangles t{p, {}};
      CHECK_THROWS_AS(RL::Geodesic_solver(
                          points(t, std::vector<RL::Vector_3>(p.size(), RL::Vector_3(0, 0, 1)))),
                      RL::Input_error);
    }
  }
}

TEST_CASE("distances_on_meshes_as_points", "[geodesic_spline][shared]") {
  const std::string path = shared_mesh("anchor_8k.ply");
  if(path.empty())
    SKIP_TEST("anchor_8k.ply");
  const RL::Triangulated_surface_3 mesh = RL::read_surface(shapes::read(path));
  std::vector<RL::Point_3> points;
  for(std::size_t v = 0; v < mesh.number_of_vertices(); ++v)
    points.push_back(mesh.point(v));
  const RL::Triangulated_surface_3 of_points(points, RL::vertex_normals(mesh),
                                             std::vector<double>(points.size(), 1.));
  const auto source = RL::Geodesic_sources::vertex(0);
  const std::vector<double> expected = RL::Geodesic_solver(mesh).distances(source).distances,
                            found = RL::Geodesic_solver(of_points).distances(source).distances;
  const double largest = *std::max_element(expected.begin(), expected.end());
  for(std::size_t v = 0; v < points.size(); ++v)
    if(expected[v] > 0.02 * largest)
      CHECK(found[v] == Approx(expected[v]).epsilon(0.1));
}
