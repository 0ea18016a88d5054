// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Distances along surfaces: against exact ones on spheres, planes, folded strips and cones, and on
// small surfaces against all straight ways from vertex to vertex.

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
#include <functional>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace {

namespace RL = CGAL::Restricted_laplacian_3;
using Distances = std::vector<double>;

const double infinity = std::numeric_limits<double>::infinity();

Distances from_vertex(const shapes::Triangles& t, std::size_t v) {
  return shapes::geodesics(t).distances(RL::Geodesic_sources::vertex(v)).distances;
}

/// Distances of all pairs of vertices of a small surface: a shortest way is made of ways that are
/// straight when the faces that they cross are unfolded. Tries all sequences of faces.
class All_ways {
public:
  explicit All_ways(const shapes::Triangles& t)
    : m_triangles(t), distances(t.points.size(), Distances(t.points.size(), infinity)) {
    for(std::size_t f = 0; f < t.faces.size(); ++f)
      for(int k = 0; k < 3; ++k)
        m_faces[std::minmax(t.faces[f][k], t.faces[f][(k + 1) % 3])].push_back(f);
    for(std::uint32_t v = 0; v < t.points.size(); ++v) {
      distances[v] = shapes::along_edges(t, v);
      for(double d : distances[v])
        if(std::isfinite(d))
          m_longest = (std::max)(m_longest, d);
    }
    for(std::size_t f = 0; f < t.faces.size(); ++f)
      for(int k = 0; k < 3; ++k) {
        const std::uint32_t v = t.faces[f][k], p = t.faces[f][(k + 1) % 3],
                            q = t.faces[f][(k + 2) % 3];
        const double a = side(v, p), b = side(v, q), c = side(p, q);
        see(v, p, a);
        see(v, q, b);
        const double cosine = (a * a + b * b - c * c) / (2 * a * b);
        const Point at_p{a, 0},
            at_q{b * cosine, b * std::sqrt((std::max)(0., 1 - cosine * cosine))};
        cross(v, f, p, q, at_p, at_q, at_p, at_q, 0);
      }
    const std::size_t n = t.points.size();
    for(std::size_t k = 0; k < n; ++k)
      for(std::size_t i = 0; i < n; ++i)
        for(std::size_t j = 0; j < n; ++j)
          distances[i][j] = (std::min)(distances[i][j], distances[i][k] + distances[k][j]);
  }

private:
  using Point = std::array<double, 2>;
  static double wedge(const Point& a, const Point& b) { return a[0] * b[1] - a[1] * b[0]; }

  double side(std::uint32_t p, std::uint32_t q) const {
    return shapes::length(m_triangles.points[p] - m_triangles.points[q]);
  }
  void see(std::uint32_t v, std::uint32_t w, double d) {
    distances[v][w] = (std::min)(distances[v][w], d);
    distances[w][v] = distances[v][w];
  }
  // from v at the origin through the edge p, q, between two directions
  void cross(std::uint32_t v, std::size_t from, std::uint32_t p, std::uint32_t q, const Point& at_p,
             const Point& at_q, const Point& right, const Point& left, int depth) {
    // not farther than along edges
    const double along = (at_p[0] - at_q[0]) * at_p[0] + (at_p[1] - at_q[1]) * at_p[1],
                 part = std::clamp(along / (side(p, q) * side(p, q)), 0., 1.);
    if(depth > 40 || !(wedge(right, left) > 1e-12) ||
       std::hypot(at_p[0] + part * (at_q[0] - at_p[0]), at_p[1] + part * (at_q[1] - at_p[1])) >
           m_longest)
      return;
    for(const std::size_t f : m_faces[std::minmax(p, q)]) {
      if(f == from)
        continue;
      std::uint32_t r = 0;
      for(const std::uint32_t w : m_triangles.faces[f])
        if(w != p && w != q)
          r = w;
      const double l = side(p, q), a = side(p, r), b = side(q, r),
                   x = (l * l + a * a - b * b) / (2 * l),
                   y = std::sqrt((std::max)(0., a * a - x * x));
      const Point u{(at_q[0] - at_p[0]) / l, (at_q[1] - at_p[1]) / l};
      // q is on the left: away from the origin is on the right of the way from p to q
      const Point at_r{at_p[0] + x * u[0] + y * u[1], at_p[1] + x * u[1] - y * u[0]};
      const double to_right = wedge(right, at_r), to_left = wedge(at_r, left);
      if(to_right >= -1e-12 && to_left >= -1e-12)
        see(v, r, std::hypot(at_r[0], at_r[1]));
      cross(v, f, p, r, at_p, at_r, right, to_left > 0 ? at_r : left, depth + 1);
      cross(v, f, r, q, at_r, at_q, to_right > 0 ? at_r : right, left, depth + 1);
    }
  }

  const shapes::Triangles& m_triangles;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::size_t>> m_faces;
  double m_longest = 0;

public:
  std::vector<Distances> distances;
};

/// the largest relative differences from all vertices to all
struct Differences {
  double fast = 0, exact = 0;

  explicit Differences(const shapes::Triangles& t) {
    const All_ways all(t);
    const RL::Geodesic_solver geodesics = shapes::geodesics(t);
    for(std::size_t v = 0; v < t.points.size(); ++v)
      for(const auto method : {RL::Geodesic_method::fast, RL::Geodesic_method::exact}) {
        double& worst = method == RL::Geodesic_method::fast ? fast : exact;
        const Distances found =
            geodesics.distances(RL::Geodesic_sources::vertex(v), method).distances;
        for(std::size_t w = 0; w < t.points.size(); ++w)
          if(v != w) {
            if(std::isinf(all.distances[v][w]))
              CHECK(std::isinf(found[w]));
            else
              worst = (std::max)(worst, std::abs(found[w] / all.distances[v][w] - 1));
          }
      }
  }
};

/// relative errors of all that is farther than 2 % of the largest distance
struct Errors {
  double mean = 0, worst = 0;

  Errors(const Distances& found, const Distances& expected) {
    const double largest = *std::max_element(expected.begin(), expected.end());
    int number = 0;
    for(std::size_t v = 0; v < found.size(); ++v)
      if(expected[v] > 0.02 * largest) {
        const double error = std::abs(found[v] / expected[v] - 1);
        mean += error;
        worst = (std::max)(worst, error);
        ++number;
      }
    mean /= number;
  }
};

Errors errors_on_sphere(int n) {
  const shapes::Triangles t = shapes::sphere(n);
  Distances expected;
  for(const RL::Point_3& p : t.points)
    expected.push_back(
        std::acos(std::clamp((p - CGAL::ORIGIN) * (t.points[3] - CGAL::ORIGIN), -1., 1.)));
  return Errors(from_vertex(t, 3), expected);
}

} // namespace

TEST_CASE("distances_are_those_of_all_ways_on_small_surfaces", "[geodesic]") {
  for(const shapes::Triangles& t : {shapes::box(1, 1, 1, 1, 3), shapes::box(1, 2, 0.1, 2, 7),
                                    shapes::rectangle(1, 2), shapes::stairs(3, 0.5)}) {
    const Differences differences(t);
    CHECK(differences.exact < 1e-9);
    CHECK(differences.fast < 1e-9);
  }
  for(unsigned seed = 1; seed <= 10; ++seed)
    for(const shapes::Triangles& t :
        {shapes::crumpled(shapes::sphere(1), 0.4, seed),
         shapes::crumpled(shapes::box(1, 1, 1, 2, seed), 0.3, seed),
         shapes::shared_soup(seed, 8, 12), shapes::shared_soup(seed, 30, 20)}) {
      CAPTURE(seed, t.points.size());
      const Differences differences(t);
      CHECK(differences.exact < 1e-7);
      CHECK(differences.fast < 1e-3);
    }
}

TEST_CASE("distances_on_spheres_converge_with_order_two", "[geodesic]") {
  const Errors a = errors_on_sphere(3), b = errors_on_sphere(4), c = errors_on_sphere(5);
  CHECK(c.worst < 1e-3);
  CHECK(a.mean / b.mean > 3.3);
  CHECK(b.mean / c.mean > 3.3);
  CHECK(b.mean / c.mean < 5);
}

TEST_CASE("distances_on_unfolded_surfaces_are_exact", "[geodesic]") {
  const int n = 12;
  SECTION("plane") {
    const auto t =
        shapes::grid(n, [](double x, double y) { return RL::Point_3(x, y, 0.3 * x - y); });
    for(std::size_t source : {std::size_t(0), std::size_t(45)}) {
      Distances expected;
      for(const RL::Point_3& p : t.points)
        expected.push_back(shapes::length(p - t.points[source]));
      CHECK(Errors(from_vertex(t, source), expected).worst < 1e-9);
    }
  }
  SECTION("folded strip: a ray goes straight over creases") {
    const auto fold = [](double x, double y) {
      const double s = 12 * x; // pleats of the width 1/12, all at 60 degrees
      const double phase = s - std::floor(s / 2) * 2;
      return RL::Point_3(x / 2, y, std::sqrt(0.75) / 12 * (phase < 1 ? phase : 2 - phase));
    };
    const auto t = shapes::grid(n, fold),
               flat = shapes::grid(n, [](double x, double y) { return RL::Point_3(x, y, 0); });
    Distances expected;
    for(const RL::Point_3& p : flat.points)
      expected.push_back(shapes::length(p - flat.points[17]));
    CHECK(Errors(from_vertex(t, 17), expected).worst < 1e-9);
  }
  SECTION("a wall with an open end") {
    // the plane without the strip between two columns, up to the middle
    shapes::Triangles t = shapes::grid(n, [](double x, double y) { return RL::Point_3(x, y, 0); });
    std::vector<std::array<std::uint32_t, 3>> faces;
    for(const auto& f : t.faces) {
      const RL::Point_3 c = CGAL::centroid(t.points[f[0]], t.points[f[1]], t.points[f[2]]);
      if(!(c.x() > 0.5 && c.x() < 0.5 + 1. / n && c.y() < 0.5))
        faces.push_back(f);
    }
    t.faces = faces;
    const Distances found = from_vertex(t, 0);
    const RL::Point_3 source(0, 0, 0), first(0.5, 0.5, 0), second(0.5 + 1. / n, 0.5, 0);
    for(std::size_t v = 0; v < t.points.size(); ++v) {
      const RL::Point_3& p = t.points[v];
      double expected = shapes::length(p - source);
      if(p.x() > 0.5 && p.y() < p.x())
        expected = shapes::length(first - source) + shapes::length(p - first);
      if(p.x() > 0.5 + 1. / n - 1e-9 && p.y() < 0.5)
        expected = shapes::length(first - source) + shapes::length(second - first) +
                   shapes::length(p - second);
      CHECK(found[v] == Approx(expected).epsilon(1e-4));
    }
  }
  SECTION("cone, from its tip and from its side") {
    // k sectors of the angle 1.8 pi / k around the tip
    const int k = 40, rings = 10;
    const double sector = 1.8 * CGAL_PI / k;
    shapes::Triangles t;
    t.points.emplace_back(0, 0, 0);
    for(int r = 1; r <= rings; ++r)
      for(int i = 0; i < k; ++i) {
        // edges from the tip have the length r, and chords the angle of a sector
        const double chord = 2 * std::sin(sector / 2) / (2 * std::sin(CGAL_PI / k));
        t.points.emplace_back(r * chord * std::cos(2 * CGAL_PI * i / k),
                              r * chord * std::sin(2 * CGAL_PI * i / k),
                              r * std::sqrt(1 - chord * chord));
      }
    const auto at = [&](int r, int i) {
      return static_cast<std::uint32_t>(r == 0 ? 0 : 1 + k * (r - 1) + i % k);
    };
    for(int i = 0; i < k; ++i)
      for(int r = 0; r < rings; ++r) {
        t.faces.push_back({at(r, i), at(r + 1, i), at(r + 1, i + 1)});
        if(r > 0)
          t.faces.push_back({at(r, i), at(r + 1, i + 1), at(r, i + 1)});
      }
    const Distances from_tip = from_vertex(t, 0), from_side = from_vertex(t, at(5, 3));
    for(int r = 1; r <= rings; ++r)
      for(int i = 0; i < k; ++i) {
        CHECK(from_tip[at(r, i)] == Approx(r));
        // unfolded, the smaller way around
        const int turn = std::abs(i - 3);
        const double phi = sector * (std::min)(turn, k - turn);
        // rays at the rim would leave the cone: ways along it are longer than those unfolded
        const double expected = std::sqrt(r * r + 25. - 10 * r * std::cos(phi));
        if(r < rings && turn != 0)
          CHECK(from_side[at(r, i)] == Approx(expected).epsilon(1e-4));
      }
  }
}

TEST_CASE("distances_on_regular_meshes", "[geodesic]") {
  // Rays pass through many vertices, on lines of all slopes: from a corner, from the middle.
  using Shape = std::function<RL::Point_3(double, double)>;
  const std::vector<std::pair<const char*, Shape>> shapes = {
      {"flat", [](double x, double y) { return RL::Point_3(x, y, 0); }},
      {"large, away", [](double x, double y) { return RL::Point_3(1e6 * x + 7e6, 1e6 * y, -1e6); }},
      {"small, tilted",
       [](double x, double y) { return RL::Point_3(1e-6 * x, 0.6e-6 * y, 0.8e-6 * y); }},
      {"cylinder, cut open",
       [](double x, double y) { return RL::Point_3(std::cos(5 * x), std::sin(5 * x), y); }},
      {"staircase", [](double x, double y) {
         // as many steps up as on, each one square
         const double on = std::floor(19.5 * x + 1e-9), up = 39 * x - 2 * on;
         return RL::Point_3((on + (std::max)(0., up - 1)) / 39, y, (on + (std::min)(1., up)) / 39);
       }}};
  for(const auto& [name, shape] : shapes)
    for(const auto diagonals :
        {shapes::Diagonals::rising, shapes::Diagonals::falling, shapes::Diagonals::alternating})
      for(const int n : {39, 78}) {
        const shapes::Triangles t = shapes::grid(n, shape, diagonals);
        // unfolded into the plane
        const double width = n * shapes::length(t.points[1] - t.points[0]),
                     height = n * shapes::length(t.points[n + 1] - t.points[0]);
        const auto place = [&](std::size_t v) {
          return std::array<double, 2>{width * double(v % std::size_t(n + 1)) / n,
                                       height * double(v / std::size_t(n + 1)) / n};
        };
        const RL::Geodesic_solver geodesics = shapes::geodesics(t);
        for(const std::size_t source : {std::size_t(0), t.points.size() / 2})
          for(const auto method : {RL::Geodesic_method::fast, RL::Geodesic_method::exact}) {
            CAPTURE(name, n, int(diagonals), source, int(method));
            RL::Geodesic_options options(method);
            options.maximum_memory = 1e7;
            Distances expected;
            for(std::size_t v = 0; v < t.points.size(); ++v)
              expected.push_back(
                  std::hypot(place(v)[0] - place(source)[0], place(v)[1] - place(source)[1]));
            const Distances found =
                geodesics.distances(RL::Geodesic_sources::vertex(source), options).distances;
            CHECK(Errors(found, expected).worst < 1e-9);
          }
      }
}

TEST_CASE("distances_on_boxes_take_little_memory", "[geodesic]") {
  for(const int n : {10, 20, 40})
    for(const double thickness : {1., 0.1}) {
      // the same surface, triangulated in two ways
      const RL::Geodesic_solver one = shapes::geodesics(shapes::box(1, 1, thickness, n, 1)),
                                other = shapes::geodesics(shapes::box(1, 1, thickness, n, 2));
      RL::Geodesic_options fast, exact(RL::Geodesic_method::exact);
      fast.maximum_memory = exact.maximum_memory = 1e7;
      for(const std::size_t v : {std::size_t(0), std::size_t(2 * n)}) {
        CAPTURE(n, thickness, v);
        const RL::Geodesic_sources source = RL::Geodesic_sources::vertex(v);
        const Distances expected = one.distances(source, exact).distances;
        CHECK(Errors(other.distances(source, exact).distances, expected).worst < 1e-9);
        CHECK(Errors(one.distances(source, fast).distances, expected).worst < 5e-3);
      }
    }
}

TEST_CASE("distances_from_many_sources_are_those_from_each", "[geodesic][threads]") {
  const RL::Geodesic_solver geodesics = shapes::geodesics(shapes::sphere(4));
  std::vector<RL::Geodesic_sources> sources;
  for(std::size_t v = 0; v < 12; ++v)
    sources.push_back(RL::Geodesic_sources::vertex(37 * v));
  sources[5].add_vertex(1000);
  for(const auto method : {RL::Geodesic_method::fast, RL::Geodesic_method::exact}) {
    RL::Geodesic_options options(method);
    Distances parts;
    options.progress = [&, caller = std::this_thread::get_id()](double part) {
      CHECK(caller == std::this_thread::get_id());
      parts.push_back(part);
      return true;
    };
    Distances expected;
    for(const RL::Geodesic_sources& from : sources) {
      const Distances d = geodesics.distances(from, options).distances;
      CHECK(parts.back() == 1);
      expected.insert(expected.end(), d.begin(), d.end());
    }
    for(const bool is_parallel : {false, true}) {
      options.is_parallel = is_parallel;
      parts.clear();
      CHECK(geodesics.distance_matrix(sources, options) == expected);
      CHECK(std::is_sorted(parts.begin(), parts.end()));
      CHECK(parts.back() == 1);
    }
  }
  CHECK(geodesics.distance_matrix({}).empty());
  CHECK_THROWS_AS(geodesics.distance_matrix({RL::Geodesic_sources()}), RL::Parameter_error);
}

TEST_CASE("distances_end_at_targets_and_at_a_maximum", "[geodesic]") {
  for(const shapes::Triangles& t :
      {shapes::crumpled(shapes::sphere(3), 0.2, 5), shapes::box(1, 1, 0.3, 8, 3),
       shapes::joined(shapes::sphere(3), shapes::moved(shapes::sphere(2), {3, 0, 0}))}) {
    const RL::Geodesic_solver geodesics = shapes::geodesics(t);
    const std::vector<RL::Geodesic_sources> sources = {RL::Geodesic_sources::vertex(0),
                                                       RL::Geodesic_sources::vertex(17)};
    const std::vector<std::size_t> targets = {33, 17, 5, 33, 60};
    for(const auto method : {RL::Geodesic_method::fast, RL::Geodesic_method::exact}) {
      // what comes later may shorten a way of the fast method, which is less than its error
      const double epsilon = method == RL::Geodesic_method::exact ? 0 : 1e-3;
      const Distances all = geodesics.distance_matrix(sources, method),
                      some = geodesics.distance_matrix(sources, targets, method);
      const std::size_t n = t.points.size();
      REQUIRE(some.size() == sources.size() * targets.size());
      for(std::size_t i = 0; i < sources.size(); ++i)
        for(std::size_t k = 0; k < targets.size(); ++k)
          CHECK((some[i * targets.size() + k] == all[i * n + targets[k]] ||
                 some[i * targets.size() + k] == Approx(all[i * n + targets[k]]).epsilon(epsilon)));
      for(const double maximum : {0., 0.3, 1.5}) {
        const std::vector<RL::Near_vertices> near =
            geodesics.near_vertices(sources, maximum, method);
        REQUIRE(near.size() == sources.size());
        RL::Geodesic_options options(method);
        options.maximum_distance = maximum;
        for(std::size_t i = 0; i < sources.size(); ++i) {
          const Distances row = geodesics.distances(sources[i], options).distances;
          std::size_t found = 0;
          for(std::size_t v = 0; v < n; ++v)
            if(std::isfinite(row[v])) {
              REQUIRE(found < near[i].vertices.size());
              CHECK(near[i].vertices[found] == v);
              CHECK(near[i].distances[found++] == row[v]);
              CHECK(row[v] <= maximum);
              CHECK(row[v] == Approx(all[i * n + v]).epsilon(epsilon));
            } else
              CHECK(all[i * n + v] > maximum * (1 - epsilon));
          CHECK(found == near[i].vertices.size());
        }
      }
    }
    CHECK_THROWS_AS(geodesics.near_vertices(sources, -1), RL::Parameter_error);
    CHECK_THROWS_AS(geodesics.distance_matrix(sources, std::vector<std::size_t>{t.points.size()}),
                    RL::Invalid_vertex_error);
    CHECK(geodesics.distance_matrix(sources, std::vector<std::size_t>()).empty());
  }
  // a vertex without a face
  shapes::Triangles t = shapes::sphere(2);
  t.points.emplace_back(1, 1, 1);
  const std::size_t lonely = t.points.size() - 1;
  const RL::Geodesic_solver geodesics = shapes::geodesics(t);
  CHECK((geodesics.has_face(lonely - 1) && !geodesics.has_face(lonely)));
  CHECK_THROWS_AS(geodesics.has_face(lonely + 1), RL::Invalid_vertex_error);
  const std::vector<RL::Geodesic_sources> sources = {RL::Geodesic_sources::vertex(3),
                                                     RL::Geodesic_sources::vertex(lonely)};
  const Distances all = geodesics.distance_matrix(sources),
                  some = geodesics.distance_matrix(sources, std::vector<std::size_t>{lonely, 7});
  CHECK((std::isinf(some[0]) && some[2] == 0 && std::isinf(some[3])));
  CHECK((std::isinf(all[lonely]) && all[2 * lonely + 1] == 0));
  CHECK(some[1] == Approx(all[7]).epsilon(1e-3));
}

TEST_CASE("distances_may_end_anywhere_in_faces", "[geodesic]") {
  // corners, a side, and the inside of faces
  std::vector<RL::Surface_location> places;
  for(const std::size_t face : {3, 40, 41, 90})
    for(const std::array<double, 3>& l :
        {std::array<double, 3>{0.2, 0.3, 0.5}, {0, 0.4, 0.6}, {0, 0, 1}, {0.5, 0.25, 0.25}})
      places.push_back({face, l});
  const std::size_t n = places.size();
  std::vector<RL::Geodesic_sources> sources = {RL::Geodesic_sources::vertex(17)};
  for(const RL::Surface_location& place : places)
    sources.emplace_back().add_location(place);
  sources.emplace_back().add_segment(places[0], places[3]);
  const auto in_plane = [](double x, double y) { return RL::Point_3(x, y, 0); };
  for(const shapes::Triangles& t :
      {shapes::grid(9, in_plane), shapes::crumpled(shapes::sphere(3), 0.2, 5),
       shapes::box(1, 1, 0.3, 8, 3), shapes::joined(shapes::sphere(2), shapes::sphere(2)),
       shapes::joined(shapes::sphere(1), shapes::moved(shapes::sphere(2), {3, 0, 0}))}) {
    const RL::Geodesic_solver geodesics = shapes::geodesics(t);
    const bool is_flat = std::all_of(t.points.begin(), t.points.end(),
                                     [](const RL::Point_3& p) { return p.z() == 0; });
    const auto at = [&](const RL::Surface_location& location) {
      return geodesics.surface().surface_point(location).point;
    };
    for(const auto method : {RL::Geodesic_method::fast, RL::Geodesic_method::exact}) {
      RL::Geodesic_options options(method);
      const Distances found = geodesics.distance_matrix(sources, places, options);
      options.is_parallel = true;
      CHECK(geodesics.distance_matrix(sources, places, options) == found);
      options.maximum_distance = 0.4;
      const Distances near = geodesics.distance_matrix(sources, places, options);
      REQUIRE(found.size() == sources.size() * n);
      REQUIRE(near.size() == found.size());
      const double epsilon = method == RL::Geodesic_method::exact ? 1e-9 : 2e-3;
      for(std::size_t i = 0; i < sources.size(); ++i) {
        const RL::Geodesic_function all(geodesics, geodesics.distances(sources[i], method));
        for(std::size_t k = 0; k < n; ++k) {
          const double d = found[i * n + k], expected = all.value(places[k]);
          if(std::isinf(expected))
            CHECK(std::isinf(d));
          else
            CHECK(d == Approx(expected).epsilon(epsilon).margin(1e-12));
          if(i > 0 && i <= n && k == i - 1)
            CHECK(d < 1e-12);
          if(is_flat && i > 0 && i <= n)
            CHECK(d == Approx(shapes::length(at(places[k]) - at(places[i - 1])))
                           .epsilon(epsilon)
                           .margin(1e-12));
          if(d > 0.4 * (1 + epsilon))
            CHECK(std::isinf(near[i * n + k]));
          else if(d < 0.4 * (1 - epsilon))
            CHECK(near[i * n + k] == Approx(d).epsilon(epsilon).margin(1e-12));
        }
      }
    }
    CHECK(geodesics.distance_matrix(sources, std::vector<RL::Surface_location>()).empty());
    CHECK_THROWS_AS(geodesics.distance_matrix(
                        sources, std::vector<RL::Surface_location>{{t.faces.size(), {1, 0, 0}}}),
                    RL::Location_error);
    CHECK_THROWS_AS(
        geodesics.distance_matrix(sources, std::vector<RL::Surface_location>{{0, {0.7, 0.7, 0}}}),
        RL::Location_error);
    RL::Geodesic_options negative;
    negative.maximum_distance = -1e-3;
    CHECK_THROWS_AS(geodesics.distance_matrix(sources, places, negative), RL::Parameter_error);
  }
}

TEST_CASE("distances_from_a_set_are_those_from_its_nearest_member", "[geodesic]") {
  // Windows from points in faces end at vertices that have distances from elsewhere.
  for(unsigned seed = 200; seed < 240; ++seed) {
    std::mt19937 generator(seed);
    const auto random = [&] { return generator() * std::ldexp(1., -32); };
    shapes::Triangles t =
        seed % 2 != 0 ? shapes::crumpled(shapes::sphere(2), 0.1 + 0.3 * random(), seed)
                      : shapes::crumpled(shapes::box(1, 1, 1, 3, seed), 0.2 * random(), seed);
    if(seed % 4 == 0)
      for(RL::Point_3& p : t.points)
        p = RL::Point_3(p.x(), p.y(), 0.2 * p.z());
    const RL::Geodesic_solver geodesics = shapes::geodesics(t);
    const unsigned number = 2 + generator() % 5;
    RL::Geodesic_sources all;
    Distances expected(t.points.size(), std::numeric_limits<double>::infinity());
    for(unsigned i = 0; i < number; ++i) {
      RL::Geodesic_sources one;
      if(i % 3 == 2) {
        const std::size_t v = generator() % t.points.size();
        one.add_vertex(v);
        all.add_vertex(v);
      } else {
        double a = random(), b = random();
        if(a + b > 1) {
          a = 1 - a;
          b = 1 - b;
        }
        if(random() < 0.5) // close to an edge
          a *= 1e-3;
        const RL::Surface_location l{generator() % t.faces.size(), {1 - a - b, a, b}};
        one.add_location(l);
        all.add_location(l);
      }
      const Distances d = geodesics.distances(one, RL::Geodesic_method::exact).distances;
      for(std::size_t v = 0; v < d.size(); ++v)
        expected[v] = (std::min)(expected[v], d[v]);
    }
    CAPTURE(seed);
    CHECK(Errors(geodesics.distances(all, RL::Geodesic_method::exact).distances, expected).worst <
          1e-9);
  }
}

TEST_CASE("queries_of_distances_may_be_canceled", "[geodesic]") {
  const RL::Geodesic_solver geodesics = shapes::geodesics(shapes::sphere(5));
  const RL::Geodesic_sources source = RL::Geodesic_sources::vertex(0);
  for(const int calls : {1, 2}) {
    RL::Geodesic_options options;
    const auto cancel_at = [&] {
      options.progress = [&calls, n = 0](double) mutable { return ++n < calls; };
    };
    cancel_at();
    CHECK_THROWS_AS(geodesics.distances(source, options), RL::Canceled);
    cancel_at();
    CHECK_THROWS_AS(geodesics.distance_matrix({source, source}, options), RL::Canceled);
    cancel_at();
    CHECK_THROWS_AS(geodesics.farthest_points(3, source, options), RL::Canceled);
  }
}

TEST_CASE("memory_of_windows_is_limited", "[geodesic]") {
  const RL::Geodesic_solver geodesics = shapes::geodesics(shapes::sphere(4));
  const RL::Geodesic_sources source = RL::Geodesic_sources::vertex(0);
  for(const auto method : {RL::Geodesic_method::fast, RL::Geodesic_method::exact}) {
    RL::Geodesic_options options(method);
    options.maximum_memory = 5e6;
    const Distances found = geodesics.distances(source, options).distances;
    CHECK(found == geodesics.distances(source, method).distances);
    options.maximum_memory = 2e5;
    try {
      geodesics.distances(source, options);
      FAIL("more memory was taken");
    } catch(const RL::Parameter_error& e) {
      CHECK(e.parameter() == "maximum_memory");
      CHECK(std::string(e.what()) ==
            "maximum_memory is 0.2 MB: the windows of rays would take more than that");
    }
    for(const double wrong : {0., -1., std::nan("")}) {
      options.maximum_memory = wrong;
      CHECK_THROWS_AS(geodesics.distances(source, options), RL::Parameter_error);
    }
  }
}

TEST_CASE("directions_point_to_the_source", "[geodesic]") {
  const shapes::Triangles t = shapes::sphere(4);
  const RL::Geodesic_distances found =
      shapes::geodesics(t).distances(RL::Geodesic_sources::vertex(100));
  const RL::Vector_3 source = t.points[100] - CGAL::ORIGIN;
  CHECK(found.directions[100] == CGAL::NULL_VECTOR);
  double worst = 0;
  int known = 0;
  for(std::size_t v = 0; v < t.points.size(); ++v) {
    const RL::Vector_3 p = t.points[v] - CGAL::ORIGIN, d = found.directions[v];
    const RL::Vector_3 tangent = source - (source * p) * p;
    if(d == CGAL::NULL_VECTOR || source * p < -0.98)
      continue;
    ++known;
    CHECK(d.squared_length() == Approx(1));
    worst = (std::max)(worst, shapes::length(d - tangent / shapes::length(tangent)));
  }
  CHECK(known > 0.95 * static_cast<double>(t.points.size()));
  CHECK(worst < 0.1);
}

TEST_CASE("sources_may_be_points_segments_and_boundaries", "[geodesic]") {
  const int n = 12;
  const auto t = shapes::grid(n, [](double x, double y) { return RL::Point_3(x, y, 0); });
  const RL::Geodesic_solver geodesics = shapes::geodesics(t);
  const RL::Triangulated_surface_3& surface = geodesics.surface();
  const auto location = [](std::size_t face, double a, double b) {
    return RL::Surface_location{face, {a, b, 1 - a - b}};
  };
  const auto check = [&](const RL::Geodesic_sources& sources, auto&& expected, double tolerance) {
    const RL::Geodesic_distances found = geodesics.distances(sources);
    for(std::size_t v = 0; v < t.points.size(); ++v) {
      CAPTURE(v, t.points[v].x(), t.points[v].y());
      CHECK(found.distances[v] == Approx(expected(t.points[v])).epsilon(tolerance).margin(1e-6));
    }
  };
  for(const auto& l : {location(100, 0.2, 0.3), location(100, 0.5, 0.5), location(37, 0, 0.3),
                       location(37, 0.25, 0), location(50, 1, 0), location(50, 0, 0)}) {
    RL::Geodesic_sources sources;
    sources.add_location(l);
    const RL::Point_3 p = surface.surface_point(l).point;
    check(
        sources, [&](const RL::Point_3& q) { return shapes::length(p - q); }, 1e-9);
  }
  SECTION("segments in a face, along an edge, and over several faces") {
    const auto to_segment = [](const RL::Point_3& a, const RL::Point_3& b, const RL::Point_3& q) {
      const double s = std::clamp((q - a) * (b - a) / (b - a).squared_length(), 0., 1.);
      return shapes::length(q - (a + s * (b - a)));
    };
    for(const auto& [a, b] : {std::pair(location(130, 0.1, 0.2), location(130, 0.6, 0.3)),
                              std::pair(location(131, 0, 0.2), location(131, 0, 0.9)),
                              std::pair(location(131, 1, 0), location(131, 0, 1)),
                              std::pair(location(131, 0.3, 0), location(131, 0, 0.4))}) {
      RL::Geodesic_sources sources;
      sources.add_segment(a, b);
      const RL::Point_3 p = surface.surface_point(a).point, q = surface.surface_point(b).point;
      check(
          sources, [&, a = p, b = q](const RL::Point_3& r) { return to_segment(a, b, r); }, 2e-3);
    }
    RL::Geodesic_sources column;
    for(std::size_t f = 0; f < surface.number_of_faces(); ++f)
      for(int k = 0; k < 3; ++k)
        if(std::abs(surface.point(f, k).x() - 0.25) < 1e-9 &&
           std::abs(surface.point(f, (k + 1) % 3).x() - 0.25) < 1e-9) {
          RL::Surface_location from{f, {0, 0, 0}}, to{f, {0, 0, 0}};
          from.barycentric[k] = to.barycentric[(k + 1) % 3] = 1;
          column.add_segment(from, to);
        }
    check(
        column, [](const RL::Point_3& p) { return std::abs(p.x() - 0.25); }, 1e-3);
  }
  SECTION("the boundary") {
    RL::Geodesic_sources boundary;
    boundary.add_boundary();
    check(
        boundary,
        [](const RL::Point_3& p) {
          return (std::min)((std::min)(p.x(), 1 - p.x()), (std::min)(p.y(), 1 - p.y()));
        },
        1e-3);
    CHECK_THROWS_AS(shapes::geodesics(shapes::sphere(1)).distances(boundary), RL::Parameter_error);
  }
}

TEST_CASE("directions_are_those_of_exact_rays", "[geodesic]") {
  for(const shapes::Triangles& t :
      {shapes::bumpy_square(24, 0.3, 3, 5), shapes::crumpled(shapes::sphere(3), 0.03, 2)}) {
    const RL::Geodesic_solver geodesics = shapes::geodesics(t);
    const auto source = RL::Geodesic_sources::vertex(77);
    const std::vector<RL::Vector_3> fast = geodesics.distances(source).directions,
                                    exact = geodesics.distances(source, RL::Geodesic_method::exact)
                                                .directions;
    std::size_t known = 0, far = 0;
    for(std::size_t v = 0; v < t.points.size(); ++v)
      if(fast[v] != CGAL::NULL_VECTOR && exact[v] != CGAL::NULL_VECTOR) {
        ++known;
        far += fast[v] * exact[v] < 0.98;
      }
    CHECK(known > 0.95 * static_cast<double>(t.points.size()));
    // where rays of two sides meet, the nearest may be either
    CAPTURE(known, far);
    CHECK(far < 0.03 * static_cast<double>(known));
  }
}

TEST_CASE("sources_are_what_was_added", "[geodesic]") {
  RL::Geodesic_sources sources;
  CHECK(sources.empty());
  sources.add_vertex(3, 4);
  sources.add_location({5, {0, 1, 0}}, 6);
  sources.add_segment({7, {1, 0, 0}}, {7, {0, 0, 1}}, 8);
  sources.add_boundary(9);
  CHECK(!sources.empty());
  CHECK(sources.vertices() == std::vector<std::pair<std::size_t, std::uint32_t>>{{3, 4}});
  CHECK(sources.boundaries() == std::vector<std::uint32_t>{9});
  REQUIRE(sources.segments().size() == 2);
  const RL::Geodesic_sources::Segment &point = sources.segments()[0],
                                      &segment = sources.segments()[1];
  CHECK((point.from.face == 5 && point.from.barycentric == point.to.barycentric));
  CHECK((point.label == 6 && segment.label == 8 && segment.from.face == segment.to.face));
  CHECK((segment.from.barycentric[0] == 1 && segment.to.barycentric[2] == 1));
}

TEST_CASE("labels_are_those_of_the_nearest_source", "[geodesic]") {
  shapes::Triangles t = shapes::grid(20, [](double x, double y) { return RL::Point_3(x, y, 0); });
  const std::size_t number = t.points.size();
  t = shapes::joined(t, shapes::moved(shapes::sphere(1), RL::Vector_3(5, 0, 0)));
  t.points.emplace_back(9, 9, 9); // with no face
  RL::Geodesic_sources sources;
  const std::vector<std::size_t> at = {0, 20, 230, 235};
  const std::vector<std::uint32_t> labels = {7, 1, 3, 3};
  for(std::size_t i = 0; i < at.size(); ++i)
    sources.add_vertex(at[i], labels[i]);
  const RL::Geodesic_distances found = shapes::geodesics(t).distances(sources);
  for(std::size_t v = 0; v < number; ++v) {
    std::map<std::uint32_t, double> nearest;
    for(std::size_t i = 0; i < at.size(); ++i) {
      const double d = shapes::length(t.points[v] - t.points[at[i]]);
      const auto [it, is_new] = nearest.insert({labels[i], d});
      it->second = (std::min)(it->second, d);
    }
    double least = infinity;
    for(const auto& [label, d] : nearest)
      least = (std::min)(least, d);
    CHECK(found.distances[v] == Approx(least).epsilon(1e-3).margin(1e-12));
    REQUIRE(nearest.count(found.labels[v]) == 1);
    CHECK(nearest[found.labels[v]] <= least * (1 + 1e-3));
  }
  for(std::size_t v = number; v < t.points.size(); ++v) {
    CHECK(std::isinf(found.distances[v]));
    CHECK(found.labels[v] == RL::Geodesic_distances::no_label);
  }
  CHECK(found.number_of_unreached_vertices == t.points.size() - number - 1);
}

TEST_CASE("distances_are_symmetric_and_form_triangles", "[geodesic]") {
  for(const shapes::Triangles& t :
      {shapes::bumpy_square(24, 0.3, 3, 5), shapes::ragged_square(20, 0.2, 3),
       shapes::crumpled(shapes::sphere(3), 0.03, 2)}) {
    std::mt19937 generator(4);
    const RL::Geodesic_solver geodesics = shapes::geodesics(t);
    std::vector<std::size_t> chosen;
    std::vector<Distances> from;
    for(int i = 0; i < 10; ++i) {
      chosen.push_back(generator() % t.points.size());
      from.push_back(geodesics.distances(RL::Geodesic_sources::vertex(chosen.back())).distances);
    }
    for(std::size_t i = 0; i < 10; ++i)
      for(std::size_t j = 0; j < i; ++j) {
        if(std::isinf(from[i][chosen[j]]) || chosen[i] == chosen[j])
          continue;
        CHECK(from[i][chosen[j]] == Approx(from[j][chosen[i]]).epsilon(3e-3));
        for(std::size_t k = 0; k < 10; ++k)
          CHECK(from[i][chosen[j]] <= (from[i][chosen[k]] + from[k][chosen[j]]) * (1 + 3e-3));
      }
  }
}

TEST_CASE("distances_do_not_depend_on_the_triangulation", "[geodesic]") {
  // The same bumpy surface refined in the planes of its faces, shuffled, and with faces turned
  // over.
  const shapes::Triangles coarse = shapes::bumpy_square(16, 0.3, 3, 5);
  const shapes::Triangles fine = shapes::split_in_four(shapes::split_in_four(coarse));
  shapes::Triangles turned = coarse;
  std::mt19937 generator(1);
  for(auto& f : turned.faces)
    if(generator() & 1u)
      std::swap(f[0], f[1]);
  std::shuffle(turned.faces.begin(), turned.faces.end(), generator);
  const auto source = RL::Geodesic_sources::vertex(40);
  const RL::Geodesic_distances found = shapes::geodesics(coarse).distances(source),
                               other = shapes::geodesics(turned).distances(source);
  const Distances &a = found.distances, b = from_vertex(fine, 40), &c = other.distances;
  std::size_t same_directions = 0;
  for(std::size_t v = 0; v < coarse.points.size(); ++v) {
    CHECK(b[v] == Approx(a[v]).epsilon(3e-3));
    CHECK(c[v] == Approx(a[v]).epsilon(1e-3));
    same_directions += shapes::length(found.directions[v] - other.directions[v]) < 0.05;
  }
  CHECK(same_directions > 0.95 * static_cast<double>(coarse.points.size()));
}

TEST_CASE("signed_distances_are_those_from_zeros", "[geodesic]") {
  // in a plane: from lines that pass through triangles, and from the sides of a grid
  const int n = 24;
  const shapes::Triangles t =
      shapes::grid(n, [](double x, double y) { return RL::Point_3(x, y, 0); });
  const RL::Geodesic_solver geodesics = shapes::geodesics(t);
  for(const double scale : {1e-200, 1., 1e200})
    for(const double place : {0.5, 0.31}) {
      Distances values;
      for(const RL::Point_3& p : t.points)
        values.push_back(scale * (p.x() - place));
      for(const auto method : {RL::Geodesic_method::fast, RL::Geodesic_method::exact}) {
        const Distances found = geodesics.signed_distances(values, method).distances;
        for(std::size_t v = 0; v < t.points.size(); ++v)
          CHECK(found[v] == Approx(t.points[v].x() - place)
                                .epsilon(method == RL::Geodesic_method::exact ? 1e-8 : 1e-4)
                                .margin(1e-12));
      }
    }
  // a jump between the largest numbers
  Distances jump, largest;
  for(const RL::Point_3& p : t.points) {
    jump.push_back(p.x() < 0.31 ? -1 : 1);
    largest.push_back(p.x() < 0.31 ? -1.7e308 : 1.7e308);
  }
  CHECK(geodesics.signed_distances(jump).distances ==
        geodesics.signed_distances(largest).distances);
  // a corner is a single zero, and a face of zeros is at its sides
  Distances values(t.points.size(), 1);
  values[5 + 5 * (n + 1)] = 0;
  const Distances from_corner = geodesics.signed_distances(values).distances;
  for(std::size_t v = 0; v < t.points.size(); ++v)
    CHECK(from_corner[v] == Approx(shapes::length(t.points[v] - t.points[5 + 5 * (n + 1)])));
  for(const std::uint32_t v : t.faces[100])
    values[v] = 0;
  CHECK(geodesics.signed_distances(values).distances[t.faces[100][1]] == 0);
  // on a sphere
  const shapes::Triangles sphere = shapes::sphere(4);
  values.clear();
  for(const RL::Point_3& p : sphere.points)
    values.push_back(p.z());
  const RL::Geodesic_solver on_sphere = shapes::geodesics(sphere);
  const Distances latitudes = on_sphere.signed_distances(values).distances;
  for(std::size_t v = 0; v < sphere.points.size(); ++v)
    CHECK(latitudes[v] == Approx(std::asin(sphere.points[v].z())).margin(5e-3));
  RL::Geodesic_options near;
  near.maximum_distance = 0.5;
  const Distances limited = on_sphere.signed_distances(values, near).distances;
  for(std::size_t v = 0; v < sphere.points.size(); ++v)
    CHECK((std::abs(latitudes[v]) < 0.5 ? limited[v] == Approx(latitudes[v])
                                        : std::isinf(limited[v]) && limited[v] * values[v] > 0));
  // of points alone, some twice, with zeros between them
  std::vector<RL::Point_3> points = t.points;
  points.insert(points.end(), t.points.begin(), t.points.begin() + 40);
  const RL::Geodesic_solver of_points(RL::Triangulated_surface_3(
      points, std::vector<RL::Vector_3>(points.size(), RL::Vector_3(0, 0, 1)),
      Distances(points.size(), 1)));
  values.clear();
  for(const RL::Point_3& p : points)
    values.push_back(p.x() - 0.31);
  const RL::Geodesic_distances between = of_points.signed_distances(values);
  CHECK(between.sources.empty());
  for(std::size_t v = 0; v < points.size(); ++v) {
    CHECK(between.distances[v] == Approx(points[v].x() - 0.31).epsilon(1e-3));
    CHECK(between.directions[v].x() * values[v] == Approx(-std::abs(values[v])).epsilon(1e-3));
  }
  CHECK_THROWS_WITH(of_points.signed_distances(Distances(points.size(), 1)),
                    Catch::Contains("nowhere"));
  // what has no zero
  CHECK_THROWS_WITH(geodesics.signed_distances(Distances(t.points.size(), 1)),
                    Catch::Contains("nowhere"));
  CHECK_THROWS_WITH(geodesics.signed_distances(Distances(3, 1)), Catch::Contains("3"));
  values.assign(t.points.size(), 1);
  for(const double bad :
      {std::numeric_limits<double>::quiet_NaN(), -std::numeric_limits<double>::infinity()}) {
    values[7] = bad;
    CHECK_THROWS_WITH(geodesics.signed_distances(values), Catch::Contains("vertex 7"));
  }
}

TEST_CASE("windows_do_not_multiply_where_rays_run_along_edges", "[geodesic]") {
  // Ways along edges are as long as those of rays then, at nearly all vertices: distances from
  // lines along the rows of a grid, from its boundary, and along a cylinder and a box.
  const int n = 120;
  const auto in_plane = [](double x, double y) { return RL::Point_3(x, y, 0); };
  const auto around = [](double x, double y) {
    return RL::Point_3(std::cos(2 * x), std::sin(2 * x), y);
  };
  const auto bent = [](double x, double y) { // twice by a right angle
    return x < 0.25   ? RL::Point_3(0.25, y, 0.25 - x)
           : x < 0.75 ? RL::Point_3(x, y, 0)
                      : RL::Point_3(0.75, y, x - 0.75);
  };
  const std::vector<std::function<RL::Point_3(double, double)>> surfaces = {in_plane, around, bent};
  RL::Geodesic_options options;
  options.maximum_memory = 240 * (2 * n * n); // that of few windows for each face
  for(const auto& surface : surfaces) {
    const RL::Geodesic_solver geodesics =
        shapes::geodesics(shapes::grid(n, surface, shapes::Diagonals::rising));
    for(const double place : {0.5, 0.503}) {
      CAPTURE(place);
      Distances values;
      for(int j = 0; j <= n; ++j)
        for(int i = 0; i <= n; ++i)
          values.push_back(static_cast<double>(j) / n - place);
      Distances found;
      REQUIRE_NOTHROW(found = geodesics.signed_distances(values, options).distances);
      for(std::size_t v = 0; v < values.size(); ++v)
        REQUIRE(found[v] == Approx(values[v]).epsilon(2e-4).margin(1e-9));
    }
    RL::Geodesic_sources boundary;
    boundary.add_boundary();
    CHECK_NOTHROW(geodesics.distances(boundary, options));
  }
}

TEST_CASE("distances_among_needles", "[geodesic]") {
  for(std::uint32_t seed = 1; seed <= 6; ++seed)
    for(const double stretch : {1., 10., 100.})
      for(const double amount : {1e-3, 3e-2}) {
        const RL::Geodesic_solver geodesics =
            shapes::geodesics(shapes::anyhow(12, stretch, amount, seed));
        const auto check = [&](const RL::Geodesic_sources& sources) {
          const Distances a = geodesics.distances(sources).distances,
                          b = geodesics.distances(sources, RL::Geodesic_method::exact).distances;
          for(std::size_t u = 0; u < a.size(); ++u)
            CHECK(a[u] == Approx(b[u]).epsilon(0.02));
        };
        for(std::uint32_t v = seed; v < 144; v += 7)
          check(RL::Geodesic_sources::vertex(v));
        RL::Geodesic_sources boundary;
        boundary.add_boundary();
        check(boundary);
        for(std::size_t f = seed; f < geodesics.surface().number_of_faces(); f += 40) {
          RL::Geodesic_sources segment;
          segment.add_segment({f, {0.5, 0.2, 0.3}}, {f, {0.2, 0.5, 0.3}});
          check(segment);
        }
      }
}

TEST_CASE("distances_do_not_depend_on_position_and_scale", "[geodesic]") {
  const shapes::Triangles t = shapes::bumpy_square(16, 0.3, 3, 5);
  const Distances found = from_vertex(t, 40);
  for(const double scale : {1e-90, 1e-9, 1e9, 1e90}) {
    const Distances scaled = from_vertex(shapes::scaled(t, scale), 40);
    for(std::size_t v = 0; v < t.points.size(); ++v)
      CHECK(scaled[v] / scale == Approx(found[v]).epsilon(1e-4));
  }
}

TEST_CASE("rays_go_on_in_each_face_of_an_edge", "[geodesic]") {
  const int n = 8;
  const shapes::Triangles t = shapes::three_wings(n);
  const std::uint32_t size = (n + 1) * (n + 1);
  const std::size_t source = 5 + 2 * (n + 1);
  const Distances found = from_vertex(t, source);
  const double x = 5. / n, y = 2. / n;
  for(std::uint32_t v = 0; v < t.points.size(); ++v) {
    const double i = double(v % size % (n + 1)) / n, j = double(v % size / (n + 1)) / n;
    if(i == 0 && v >= size)
      continue;
    const double across = v < size ? i - x : i + x;
    CHECK(found[v] == Approx(std::hypot(across, j - y)).epsilon(1e-9));
  }
}

TEST_CASE("distances_on_hostile_surfaces", "[geodesic]") {
  SECTION("one triangle") {
    const Distances d =
        from_vertex(shapes::Triangles{{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}}, {{0, 1, 2}}}, 1);
    CHECK(d == Distances{1, 0, std::sqrt(5.)});
  }
  SECTION("a strip of needles of the aspect 1e4") {
    const shapes::Triangles t = shapes::needles(200);
    for(std::size_t source : {std::size_t(0), std::size_t(201)}) {
      const Distances d = from_vertex(t, source);
      for(std::size_t v = 0; v < t.points.size(); ++v)
        CHECK(d[v] == Approx(shapes::length(t.points[v] - t.points[source])).epsilon(1e-8));
    }
  }
  SECTION("faces of no area") {
    const shapes::Triangles t = shapes::square_with_flat_faces();
    const Distances d = from_vertex(t, 0);
    for(std::size_t v = 0; v < t.points.size(); ++v)
      CHECK(d[v] == Approx(shapes::length(t.points[v] - t.points[0])).margin(1e-12));
  }
  SECTION("rows of no height") {
    for(const double height : {0., 1e-15, 1e-13, 1e-10})
      for(const double shift : {0., 0.3, 0.5}) {
        CAPTURE(height, shift);
        const shapes::Triangles t = shapes::square_with_flat_row(8, shift, height);
        const RL::Geodesic_solver geodesics = shapes::geodesics(t);
        for(const auto method : {RL::Geodesic_method::fast, RL::Geodesic_method::exact})
          for(std::size_t source = 0; source < t.points.size(); ++source) {
            const Distances d =
                geodesics.distances(RL::Geodesic_sources::vertex(source), method).distances;
            for(std::size_t v = 0; v < t.points.size(); ++v) {
              CAPTURE(source, v, method == RL::Geodesic_method::exact);
              CHECK(d[v] == Approx(shapes::length(t.points[v] - t.points[source])).margin(1e-8));
            }
          }
        const RL::Surface_location middle{50, {0.2, 0.3, 0.5}};
        const RL::Point_3 p = geodesics.surface().surface_point(middle).point;
        RL::Geodesic_sources sources;
        sources.add_location(middle);
        const Distances d = geodesics.distances(sources).distances;
        for(std::size_t v = 0; v < t.points.size(); ++v)
          CHECK(d[v] == Approx(shapes::length(t.points[v] - p)).margin(1e-8));
      }
  }
  SECTION("a square far from the origin") {
    const shapes::Triangles t = shapes::moved(
        shapes::grid(12, [](double x, double y) { return RL::Point_3(x, y, 0); }), {1e8, -1e8, 0});
    for(std::size_t source = 0; source < t.points.size(); source += 5) {
      const Distances d =
          shapes::geodesics(t)
              .distances(RL::Geodesic_sources::vertex(source), RL::Geodesic_method::exact)
              .distances;
      for(std::size_t v = 0; v < t.points.size(); ++v)
        CHECK(d[v] == Approx(shapes::length(t.points[v] - t.points[source])).margin(1e-7));
    }
  }
  SECTION("random soups: no more than along edges, no less than straight through space") {
    for(unsigned seed = 1; seed <= 200; ++seed) {
      CAPTURE(seed);
      const shapes::Triangles t = seed % 2
                                      ? shapes::shared_soup(seed, 12, 30)
                                      : shapes::crumpled(shapes::box(1, 1, 1, 3, seed), 0.5, seed);
      const std::size_t source = seed % t.points.size();
      const Distances d = from_vertex(t, source), edges = shapes::along_edges(t, source);
      for(std::size_t v = 0; v < t.points.size(); ++v) {
        CHECK((std::isinf(d[v]) == std::isinf(edges[v]) && d[v] <= edges[v] * (1 + 1e-9)));
        CHECK(d[v] >= shapes::length(t.points[v] - t.points[source]) * (1 - 1e-3));
      }
    }
  }
}

TEST_CASE("faces_may_be_there_twice", "[geodesic]") {
  const shapes::Triangles once = shapes::sphere(3);
  const std::size_t n = once.faces.size();
  shapes::Triangles twice = once, alone;
  for(std::size_t f = 0; f < n; ++f) {
    const auto [a, b, c] = once.faces[f];
    twice.faces.push_back(f % 2 ? std::array<std::uint32_t, 3>{c, b, a}
                                : std::array<std::uint32_t, 3>{b, c, a});
  }
  for(const auto& f : twice.faces) {
    const auto first = static_cast<std::uint32_t>(alone.points.size());
    for(std::uint32_t v : f)
      alone.points.push_back(twice.points[v]);
    alone.faces.push_back({first, first + 1, first + 2});
  }
  const RL::Geodesic_solver solver = shapes::geodesics(once), of_both = shapes::geodesics(twice),
                            of_alone(RL::Triangulated_surface_3(alone.points, alone.faces), 1e-9);
  for(const auto method : {RL::Geodesic_method::fast, RL::Geodesic_method::exact}) {
    RL::Geodesic_options options(method);
    options.maximum_memory = 1e7;
    const auto distances = [&](const RL::Geodesic_solver& s, const RL::Surface_location& a,
                               const RL::Surface_location& b) {
      RL::Geodesic_sources sources;
      sources.add_segment(a, b);
      return s.distances(sources, options).distances;
    };
    for(const std::size_t f : {std::size_t(10), std::size_t(11)}) {
      const RL::Surface_location a{f, {0.2, 0.5, 0.3}}, b{f, {0.6, 0.3, 0.1}};
      const auto in_twin = [&](RL::Surface_location l) {
        const auto [x, y, z] = l.barycentric;
        l.face += n;
        l.barycentric = f % 2 ? std::array<double, 3>{z, y, x} : std::array<double, 3>{y, z, x};
        return l;
      };
      const Distances expected = distances(solver, a, b);
      for(const RL::Surface_location& end : {b, a}) {
        const Distances of_one = distances(solver, a, end),
                        d = distances(of_both, in_twin(a), in_twin(end)),
                        joined = distances(of_alone, in_twin(a), in_twin(end));
        for(std::size_t v = 0; v < of_one.size(); ++v)
          CHECK(d[v] == Approx(of_one[v]).epsilon(1e-8));
        for(std::size_t i = 0; i < joined.size(); ++i)
          CHECK(joined[i] == Approx(of_one[twice.faces[i / 3][i % 3]]).epsilon(1e-6));
      }
      const RL::Geodesic_distances from =
          of_both.distances(RL::Geodesic_sources::vertex(7), options);
      const RL::Geodesic_function function(of_both, from);
      CHECK(function.value(in_twin(a)) == Approx(function.value(a)).epsilon(1e-12));
      CHECK(function.shortest_path(in_twin(a)).length == Approx(function.value(a)).epsilon(1e-3));
    }
  }
}

TEST_CASE("bad_sources_of_distances_are_named", "[geodesic]") {
  const shapes::Triangles t = shapes::rectangle(1, 1);
  const RL::Geodesic_solver geodesics = shapes::geodesics(t);
  CHECK_THROWS_AS(geodesics.distances(RL::Geodesic_sources()), RL::Parameter_error);
  try {
    geodesics.distances(RL::Geodesic_sources::vertex(77));
    FAIL("no exception");
  } catch(const RL::Invalid_vertex_error& e) {
    CHECK(e.vertex() == 77);
  }
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for(const RL::Surface_location& l :
      {RL::Surface_location{99, {1, 0, 0}}, RL::Surface_location{0, {nan, 0, 0}},
       RL::Surface_location{0, {1.5, -0.5, 0}}, RL::Surface_location{0, {0.5, 0.5, 0.5}}}) {
    RL::Geodesic_sources sources;
    sources.add_location(l);
    CHECK_THROWS_AS(geodesics.distances(sources), RL::Location_error);
  }
  RL::Geodesic_sources sources;
  CHECK_THROWS_AS(sources.add_segment({0, {1, 0, 0}}, {1, {1, 0, 0}}), RL::Location_error);
}

TEST_CASE("farthest_points_are_far", "[geodesic]") {
  const shapes::Triangles t = shapes::sphere(3);
  const RL::Geodesic_solver geodesics = shapes::geodesics(t);
  const std::vector<std::size_t> two = geodesics.farthest_points(2);
  REQUIRE(two.size() == 2);
  CHECK(shapes::length(t.points[two[0]] - t.points[two[1]]) == Approx(2).epsilon(1e-3));
  const std::vector<std::size_t> six =
      geodesics.farthest_points(6, RL::Geodesic_sources::vertex(0));
  CHECK(std::set<std::size_t>(six.begin(), six.end()).size() == 6);
  // nowhere closer than half of the largest distance from all of them
  RL::Geodesic_sources all = RL::Geodesic_sources::vertex(0);
  for(std::size_t v : six)
    all.add_vertex(v);
  const Distances d = geodesics.distances(all).distances;
  const double covered = *std::max_element(d.begin(), d.end());
  for(std::size_t i = 0; i < 6; ++i)
    for(std::size_t j = 0; j < i; ++j)
      CHECK(2 * std::asin(shapes::length(t.points[six[i]] - t.points[six[j]]) / 2) >=
            covered * 0.99);
  CHECK(geodesics.farthest_points(100000).size() == t.points.size());
  CHECK(geodesics.farthest_points(0).empty());
}

TEST_CASE("distances_go_into_property_maps", "[geodesic]") {
  shapes::Mesh mesh = shapes::mesh(shapes::sphere(2));
  auto d = mesh.add_property_map<shapes::Mesh::Vertex_index, double>("v:d").first;
  const shapes::Mesh::Vertex_index a(3), b(7);
  RL::geodesic_distances(mesh, a, d);
  const double from_a = d[b];
  CHECK(d[a] == 0);
  RL::geodesic_distances(mesh, std::vector<shapes::Mesh::Vertex_index>{a, b}, d);
  CHECK((d[a] == 0 && d[b] == 0));
  RL::geodesic_distances(mesh, RL::Geodesic_sources::vertex(7), d);
  CHECK(d[a] == Approx(from_a).epsilon(1e-4));
}

TEST_CASE("distances_go_over_joined_boundaries", "[geodesic]") {
  const auto distances = [](const shapes::Triangles& t, double tolerance,
                            const RL::Geodesic_sources& sources) {
    return RL::Geodesic_solver(RL::Triangulated_surface_3(t.points, t.faces), tolerance)
        .distances(sources);
  };
  const auto from = RL::Geodesic_sources::vertex(0);
  SECTION("each triangle has vertices of its own") {
    const shapes::Triangles whole = shapes::crumpled(shapes::sphere(2), 0.02, 3);
    shapes::Triangles soup;
    std::vector<std::uint32_t> original;
    std::mt19937 generator(1);
    for(auto f : whole.faces) {
      for(std::uint32_t& v : f) {
        original.push_back(v);
        const auto noise = [&] { return 1e-9 * (generator() * std::ldexp(1., -32)); };
        soup.points.push_back(whole.points[v] + RL::Vector_3(noise(), noise(), noise()));
        v = static_cast<std::uint32_t>(soup.points.size() - 1);
      }
      soup.faces.push_back(f);
    }
    const Distances expected = from_vertex(whole, original[0]);
    const RL::Geodesic_distances found = distances(soup, 1e-8, from),
                                 apart = distances(soup, 0, from);
    for(std::size_t v = 0; v < soup.points.size(); ++v)
      CHECK(found.distances[v] == Approx(expected[original[v]]).margin(1e-7));
    CHECK(found.number_of_unreached_vertices == 0);
    CHECK(apart.number_of_unreached_vertices == soup.points.size() - 3);
  }
  SECTION("T-junctions: two grids of different widths side by side") {
    const shapes::Triangles left = shapes::grid(
                                6, [](double x, double y) { return RL::Point_3(x, y, 0); }),
                            right = shapes::grid(
                                7, [](double x, double y) { return RL::Point_3(1 + x, y, 0); });
    const shapes::Triangles t = shapes::joined(left, right);
    const RL::Geodesic_solver rays(RL::Triangulated_surface_3(t.points, t.faces), 1e-9);
    const auto check = [&](const RL::Geodesic_sources& sources, const RL::Point_3& p) {
      const RL::Geodesic_function d(rays, rays.distances(sources));
      for(std::size_t v = 0; v < t.points.size(); ++v)
        CHECK(d.distances().distances[v] == Approx(shapes::length(t.points[v] - p)).margin(1e-7));
      for(std::size_t f = 0; f < t.faces.size(); ++f)
        for(const auto& l : {std::array<double, 3>{0.2, 0.3, 0.5}, {0.9, 0.06, 0.04}}) {
          const RL::Surface_location here{f, l};
          const RL::Vector_3 away = rays.surface().surface_point(here).point - p;
          CHECK(d.value(here) == Approx(shapes::length(away)).margin(1e-7));
          if(shapes::length(away) > 1e-3)
            CHECK(shapes::length(d.gradient(here) - away / shapes::length(away)) < 1e-5);
          const RL::Geodesic_path path = d.shortest_path(here);
          CHECK(path.length == Approx(shapes::length(away)).margin(1e-9));
          for(std::size_t i = 0; i < path.segments.size(); ++i) {
            const auto& s = path.segments[i];
            CHECK(shapes::length(rays.surface().surface_point(s.from).point - path.points[i]) <
                  1e-9);
            CHECK(shapes::length(rays.surface().surface_point(s.to).point - path.points[i + 1]) <
                  1e-9);
          }
        }
      // one arc over both grids
      const std::vector<RL::Geodesic_path> lines = d.isolines(0.3);
      CHECK(lines.size() == 1);
      CHECK((lines[0].points.front().x() < 1) != (lines[0].points.back().x() < 1));
    };
    check(RL::Geodesic_sources::vertex(6), t.points[6]);
    RL::Geodesic_sources inside;
    // in a face at the seam
    std::size_t face = 0;
    for(std::size_t f = 0; f < t.faces.size(); ++f)
      if(f < left.faces.size() && rays.surface().point(f, 0).x() == 1)
        face = f;
    inside.add_location({face, {0.5, 0.2, 0.3}});
    check(inside, rays.surface().surface_point(inside.segments()[0].from).point);
    // a segment through the parts of a face
    RL::Geodesic_sources segment;
    segment.add_segment({face, {1, 0, 0}}, {face, {0, 0.5, 0.5}});
    const RL::Geodesic_distances found = rays.distances(segment);
    const RL::Point_3 a = rays.surface().surface_point(segment.segments()[0].from).point,
                      b = rays.surface().surface_point(segment.segments()[0].to).point;
    for(std::size_t v = 0; v < t.points.size(); ++v) {
      const double s = std::clamp((t.points[v] - a) * (b - a) / (b - a).squared_length(), 0., 1.);
      CHECK(found.distances[v] ==
            Approx(shapes::length(t.points[v] - (a + s * (b - a)))).epsilon(5e-3).margin(1e-9));
    }
    // what is joined is no boundary
    RL::Geodesic_sources boundary;
    boundary.add_boundary();
    CHECK(rays.distances(boundary).distances[6] == 0);
    CHECK(rays.distances(boundary).distances[6 + 7 * 3] == Approx(0.5));
  }
  SECTION("a third wing along edges that have two faces, as wide, wider, or narrower") {
    const shapes::Triangles two =
        shapes::grid(4, [](double x, double y) { return RL::Point_3(x, y, 0); });
    for(const int n : {2, 4, 6}) {
      const shapes::Triangles wing =
          shapes::grid(n, [](double x, double y) { return RL::Point_3(0.5, y, x); });
      const Distances d =
          distances(shapes::joined(two, wing), 0, RL::Geodesic_sources::vertex(10)).distances;
      for(std::size_t v = 0; v < wing.points.size(); ++v) { // unfolded, from (0, 0.5)
        const RL::Point_3& p = wing.points[v];
        CHECK(d[25 + v] == Approx(std::hypot(0.5 + p.z(), p.y() - 0.5)).epsilon(1e-6));
      }
    }
  }
  SECTION("a tolerance longer than most edges") {
    const shapes::Triangles t = shapes::bumpy_square(128, 0.3, 3, 5);
    const Distances joined = distances(t, 0.01, from).distances, apart = from_vertex(t, 0);
    for(std::size_t v = 0; v < t.points.size(); ++v) {
      CHECK(std::isfinite(joined[v]));
      CHECK(joined[v] <= apart[v] + 0.1); // vertices move by the tolerance
    }
  }
  SECTION("bad tolerances") {
    const shapes::Triangles t = shapes::rectangle(1, 1);
    for(double bad : {-1., 0.02, std::nan(""), infinity})
      CHECK_THROWS_AS(distances(t, bad, from), RL::Parameter_error);
  }
  SECTION("named parameter") {
    shapes::Mesh mesh = shapes::mesh(
        shapes::joined(shapes::rectangle(1, 1), shapes::moved(shapes::rectangle(1, 1), {1, 0, 0})));
    auto d = mesh.add_property_map<shapes::Mesh::Vertex_index, double>("v:d").first;
    const shapes::Mesh::Vertex_index a(0), b(5);
    RL::geodesic_distances(mesh, a, d, RL::parameters::joining_tolerance(1e-9));
    CHECK(d[b] == Approx(2));
    CHECK(RL::shortest_path(mesh, a, b, RL::parameters::joining_tolerance(1e-9)).length ==
          Approx(2));
    RL::geodesic_distances(mesh, a, d);
    CHECK(std::isinf(d[b]));
  }
}
