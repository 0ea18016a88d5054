// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "catch.h"
#include "point_shapes.h"
#include "shapes.h"
#include "special_shapes.h"

#include <CGAL/IO/Color.h>
#include <CGAL/Restricted_laplacian_3/input/read_surface.h>
#include <CGAL/Restricted_laplacian_3/stitch_colors.h>

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
using RL::Point_3;
using RL::Rgb_color;
using RL::Vector_3;

Rgb_color true_color(const Point_3& p) {
  return {0.5 + 0.2 * std::sin(3 * p.x() + p.y()), 0.5 + 0.2 * std::cos(4 * p.y() - p.z()),
          0.5 + 0.15 * std::sin(5 * p.z() * p.x())};
}

std::vector<Rgb_color> true_colors(const std::vector<Point_3>& points) {
  std::vector<Rgb_color> colors;
  for(const Point_3& p : points)
    colors.push_back(true_color(p));
  return colors;
}

const std::array<Vector_3, 6> stitch_directions = {
    {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}};
const std::array<double, 6> stitch_exposures = {1, 0.8, 1.2, 0.9, 1.15, 0.95};

/// the faces of a shape whose normals are within about 70 degrees of a direction
shapes::Triangles seen_from(const shapes::Triangles& t, const Vector_3& direction) {
  shapes::Triangles result;
  result.points = t.points;
  const RL::Triangulated_surface_3 surface = RL::read_surface(RL::soup(t.points, t.faces));
  for(std::size_t f = 0; f < surface.number_of_faces(); ++f)
    if(surface.normal(f) * direction > 0.35)
      result.faces.push_back(surface.triangle(f));
  return result;
}

/// `number` scans of a sphere, from the sides of a cube
std::vector<RL::Colored_scan> sphere_scans(int level, std::size_t number) {
  const shapes::Triangles t = shapes::sphere(level);
  std::vector<RL::Colored_scan> scans;
  for(std::size_t i = 0; i < number; ++i) {
    const shapes::Triangles seen = seen_from(t, stitch_directions[i]);
    std::vector<Rgb_color> colors = true_colors(seen.points);
    for(Rgb_color& c : colors)
      for(double& x : c)
        x *= stitch_exposures[i];
    scans.emplace_back(RL::read_surface(RL::soup(seen.points, seen.faces)), colors,
                       RL::Scan_pose(CGAL::IDENTITY), CGAL::ORIGIN + 4 * stitch_directions[i]);
  }
  return scans;
}

RL::Spline_space_3 stitch_space(const shapes::Triangles& t, int depth, bool is_parallel = false) {
  RL::Spline_space_options options;
  options.depth = depth;
  options.is_parallel = is_parallel;
  return RL::Spline_space_3(RL::read_surface(RL::soup(t.points, t.faces)), options);
}

RL::Color_stitcher stitcher_of(const RL::Spline_space_3& space,
                               const std::vector<RL::Colored_scan>& scans,
                               const RL::Color_stitching_options& options = {}) {
  RL::Color_stitcher stitcher(space, options);
  for(const RL::Colored_scan& scan : scans)
    stitcher.add(scan);
  return stitcher;
}

/// root mean square difference after one factor for all
double stitch_error(const std::vector<Rgb_color>& colors, const std::vector<Rgb_color>& truth) {
  double products = 0, squares = 0, error = 0;
  for(std::size_t v = 0; v < colors.size(); ++v)
    for(int k = 0; k < 3; ++k) {
      products += colors[v][k] * truth[v][k];
      squares += colors[v][k] * colors[v][k];
    }
  for(std::size_t v = 0; v < colors.size(); ++v)
    for(int k = 0; k < 3; ++k)
      error += std::pow(products / squares * colors[v][k] - truth[v][k], 2);
  return std::sqrt(error / static_cast<double>(3 * colors.size()));
}

template <class Body> std::string stitch_message(Body&& body) {
  try {
    body();
  } catch(const RL::Input_error& error) {
    return error.what();
  }
  return "no exception";
}

} // namespace

TEST_CASE("seams_of_overlapping_scans_vanish", "[stitch]") {
  const shapes::Triangles t = shapes::sphere(4);
  const RL::Spline_space_3 space = stitch_space(t, 4);
  const std::vector<Rgb_color> truth = true_colors(t.points);
  const std::vector<RL::Colored_scan> scans = sphere_scans(5, 6);
  struct Case {
    bool match_exposures;
    RL::Gradient_source source;
    bool details;
    double largest_error, smallest_ratio;
  };
  using Source = RL::Gradient_source;
  for(const Case& c : {Case{true, Source::back_projection, true, 2e-4, 100},
                       Case{true, Source::back_projection, false, 1e-2, 20},
                       Case{true, Source::scans, true, 9e-3, 20},
                       // the colors that pull are those of different exposures
                       Case{false, Source::back_projection, true, 3e-2, 20}}) {
    RL::Color_stitching_options options;
    options.match_exposures = c.match_exposures;
    options.gradients = c.source;
    options.details = c.details;
    RL::Color_stitcher stitcher = stitcher_of(space, scans, options);
    const RL::Stitched_colors r = stitcher.stitch();
    CHECK(r.converged);
    CHECK(r.uncovered_vertices == 0);
    CHECK(r.uncovered_area < 1e-12);
    CHECK(r.clamped_values == 0);
    CHECK(r.components_without_weight == 0);
    const RL::Vertex_colors nearest = stitcher.nearest_colors(), chosen = stitcher.chosen_colors();
    // across the transitions of the chosen scans
    const auto edges = RL::scan_transitions(space.surface(), stitcher.scans_of_vertices());
    const double of_truth = RL::mean_color_jump(edges, truth);
    CHECK(edges.size() > 100);
    CHECK(r.jump_before == RL::mean_color_jump(edges, chosen.colors));
    CHECK(r.jump_before - of_truth > 0.05);
    CHECK(std::abs(r.jump_after - of_truth) < (r.jump_before - of_truth) / c.smallest_ratio);
    // and of the nearest ones
    const auto others = RL::scan_transitions(space.surface(), nearest.scans);
    const double other_truth = RL::mean_color_jump(others, truth);
    CHECK(std::abs(RL::mean_color_jump(others, r.colors) - other_truth) <
          (RL::mean_color_jump(others, nearest.colors) - other_truth) / c.smallest_ratio);
    CHECK(stitch_error(nearest.colors, truth) > 0.05);
    CHECK(stitch_error(r.colors, truth) < c.largest_error);
    // exposures up to one factor
    for(std::size_t s = 0; s < 6; ++s)
      for(int k = 0; k < 3; ++k)
        if(c.match_exposures)
          CHECK(r.scans[s].gains[k] * stitch_exposures[s] ==
                Approx(r.scans[0].gains[k] * stitch_exposures[0]).epsilon(1e-3));
        else
          CHECK(r.scans[s].gains[k] == 1);
  }
}

TEST_CASE("what_scans_give_is_reported", "[stitch]") {
  const shapes::Triangles t = shapes::sphere(4);
  const RL::Spline_space_3 space = stitch_space(t, 3);
  RL::Color_stitcher stitcher = stitcher_of(space, sphere_scans(5, 6));
  CHECK(stitcher.scans_of_faces().empty());
  stitcher.choose();
  const RL::Triangulated_surface_3& surface = space.surface();
  std::array<double, 6> chosen = {};
  double largest = 0;
  for(std::size_t f = 0; f < surface.number_of_faces(); ++f) {
    const std::uint32_t s = stitcher.scans_of_faces()[f];
    REQUIRE(s < 6);
    chosen[s] += surface.area(f) / surface.area();
    // the scan is about the one that faces the triangle most
    largest = (std::max)(largest, std::acos(surface.normal(f) * stitch_directions[s]));
    for(std::uint32_t v : surface.triangle(f)) {
      const std::vector<std::uint32_t>& covered = stitcher.back_projection(s).vertices;
      CHECK(std::binary_search(covered.begin(), covered.end(), v));
    }
  }
  CHECK(largest < 1.1); // a corner of a cube is at 0.955
  for(std::size_t s = 0; s < 6; ++s) {
    const RL::Scan_usage& usage = stitcher.usages()[s];
    CHECK(usage.chosen_area == Approx(chosen[s]));
    CHECK(usage.chosen_area == Approx(1. / 6).epsilon(0.1));
    CHECK(usage.covered_area > usage.chosen_area);
    // at most a cap of the scan: cos = 0.35
    CHECK(usage.covered_area < 0.33);
    CHECK(usage.covered_area > 0.2);
    CHECK(usage.covered_vertices == stitcher.back_projection(s).vertices.size());
    CHECK(usage.smallest_distance < 1e-12);
    // those whose normal, about their place, is within 84 degrees of the direction to the viewpoint
    std::array<std::size_t, 2> facing = {};
    for(const Point_3& p : t.points) {
      const Vector_3 normal = p - CGAL::ORIGIN, view = 4 * stitch_directions[s] - normal;
      const double cosine = normal * view / std::sqrt(view.squared_length());
      facing[0] += cosine >= 0.12;
      facing[1] += cosine >= 0.08;
    }
    CHECK(usage.facing_vertices >= facing[0]);
    CHECK(usage.facing_vertices <= facing[1]);
  }
  // the nearest one of the scans that cover a vertex
  const RL::Vertex_colors nearest = stitcher.nearest_colors();
  std::vector<double> smallest(t.points.size(), 1), of_nearest(t.points.size(), 1);
  for(std::uint32_t s = 0; s < 6; ++s) {
    const RL::Back_projection& p = stitcher.back_projection(s);
    for(std::size_t i = 0; i < p.vertices.size(); ++i) {
      smallest[p.vertices[i]] = (std::min)(smallest[p.vertices[i]], p.distances[i]);
      if(nearest.scans[p.vertices[i]] == s) {
        of_nearest[p.vertices[i]] = p.distances[i];
        CHECK(nearest.colors[p.vertices[i]] == p.colors[i]);
      }
    }
  }
  CHECK(of_nearest == smallest);
  CHECK(*std::max_element(smallest.begin(), smallest.end()) < 0.1);
  // a scan may be added later
  stitcher.add(sphere_scans(5, 1).front());
  CHECK(stitcher.scans_of_faces().empty());
  CHECK(stitcher.stitch().scans.size() == 7);
}

TEST_CASE("points_color_as_meshes_do", "[stitch]") {
  const shapes::Triangles t = shapes::sphere(4);
  const RL::Spline_space_3 space = stitch_space(t, 4);
  std::vector<RL::Colored_scan> scans;
  for(std::size_t i = 0; i < 6; ++i) {
    shapes::Oriented_points points;
    std::vector<Rgb_color> colors;
    for(const shapes::Oriented_point& p : shapes::sphere_points(12000))
      if(p.second * stitch_directions[i] > 0.35) {
        points.push_back(p);
        colors.push_back(true_color(p.first));
        for(double& x : colors.back())
          x *= stitch_exposures[i];
      }
    scans.emplace_back(
        points, CGAL::make_property_map(colors),
        params::viewpoint(CGAL::ORIGIN + 4 * stitch_directions[i])
            .point_map(CGAL::First_of_pair_property_map<shapes::Oriented_point>())
            .normal_map(CGAL::Second_of_pair_property_map<shapes::Oriented_point>()));
  }
  RL::Color_stitcher stitcher = stitcher_of(space, scans);
  const RL::Stitched_colors r = stitcher.stitch();
  CHECK(r.converged);
  CHECK(r.uncovered_vertices == 0);
  const std::vector<Rgb_color> truth = true_colors(t.points);
  CHECK(stitch_error(stitcher.nearest_colors().colors, truth) > 0.05);
  CHECK(stitch_error(r.colors, truth) < 2e-3);
}

TEST_CASE("uncovered_parts_are_filled_smoothly", "[stitch]") {
  const shapes::Triangles t = shapes::sphere(4);
  const RL::Spline_space_3 space = stitch_space(t, 4);
  // one scan from above: below, the values are between those on its border
  const shapes::Triangles seen = seen_from(t, Vector_3(0, 0, 1));
  const RL::Colored_scan scan(RL::read_surface(RL::soup(seen.points, seen.faces)),
                              true_colors(seen.points), RL::Scan_pose(CGAL::IDENTITY),
                              Point_3(0, 0, 8));
  RL::Color_stitcher stitcher = stitcher_of(space, {scan});
  const RL::Stitched_colors r = stitcher.stitch();
  CHECK(r.converged);
  CHECK(r.uncovered_area > 0.6);
  CHECK(r.uncovered_area == Approx(1 - r.scans[0].chosen_area));
  CHECK(r.uncovered_vertices > t.points.size() / 2);
  CHECK(r.seam_length == 0);
  CHECK(r.jump_before == 0);
  std::array<double, 3> low = {1, 1, 1}, high = {0, 0, 0};
  for(std::size_t v = 0; v < t.points.size(); ++v)
    if(stitcher.scans_of_vertices()[v] != RL::no_scan)
      for(int k = 0; k < 3; ++k) {
        low[k] = (std::min)(low[k], true_color(t.points[v])[k]);
        high[k] = (std::max)(high[k], true_color(t.points[v])[k]);
      }
  // covered parts keep their colors, and filled ones are harmonic: nearly constant far away
  std::array<double, 3> lowest = {1, 1, 1}, highest = {0, 0, 0};
  for(std::size_t v = 0; v < t.points.size(); ++v)
    for(int k = 0; k < 3; ++k) {
      const double x = r.colors[v][k];
      CHECK(x > low[k] - 1e-3);
      CHECK(x < high[k] + 1e-3);
      if(stitcher.scans_of_vertices()[v] != RL::no_scan)
        CHECK(std::abs(x - true_color(t.points[v])[k]) < 1e-3);
      else if(t.points[v].z() < -0.95) {
        lowest[k] = (std::min)(lowest[k], x);
        highest[k] = (std::max)(highest[k], x);
      }
    }
  for(int k = 0; k < 3; ++k)
    CHECK(highest[k] - lowest[k] < 0.2 * (high[k] - low[k]));
}

TEST_CASE("components_without_scan_take_the_mean_of_the_others", "[stitch]") {
  const shapes::Triangles t = shapes::sphere(3);
  const shapes::Triangles two =
      shapes::joined(t, shapes::moved(shapes::scaled(t, 0.5), Vector_3(5, 1, 0)));
  const RL::Spline_space_3 space = stitch_space(two, 5);
  RL::Color_stitcher stitcher = stitcher_of(space, sphere_scans(4, 6));
  const RL::Stitched_colors r = stitcher.stitch();
  CHECK(r.converged);
  CHECK(r.components_without_weight == 1);
  CHECK(r.uncovered_vertices == t.points.size());
  const RL::Triangulated_surface_3& surface = space.surface();
  Rgb_color mean = {0, 0, 0};
  double area = 0;
  for(std::size_t f = 0; f < t.faces.size(); ++f) {
    area += surface.area(f);
    for(std::uint32_t v : surface.triangle(f))
      for(int k = 0; k < 3; ++k)
        mean[k] += surface.area(f) / 3 * r.colors[v][k];
  }
  for(std::size_t v = t.points.size(); v < two.points.size(); ++v)
    for(int k = 0; k < 3; ++k)
      CHECK(r.colors[v][k] == Approx(mean[k] / area).epsilon(1e-3));
}

TEST_CASE("scans_that_miss_the_surface_are_told", "[stitch]") {
  const shapes::Triangles t = shapes::sphere(3);
  const RL::Spline_space_3 space = stitch_space(t, 3);
  const RL::Colored_scan good = sphere_scans(3, 1).front();
  const auto moved_scan = [&](double x) {
    const shapes::Triangles seen = shapes::moved(seen_from(t, {1, 0, 0}), Vector_3(x, 0, 0));
    return RL::Colored_scan(RL::read_surface(RL::soup(seen.points, seen.faces)),
                            true_colors(t.points), RL::Scan_pose(CGAL::IDENTITY),
                            Point_3(50, 0, 0));
  };
  const auto stitch = [&](const std::vector<RL::Colored_scan>& scans) {
    return stitch_message([&] { stitcher_of(space, scans).stitch(); });
  };
  CHECK(stitch({good}) == "no exception");
  CHECK_THAT(stitch({}), Catch::Contains("no scan"));
  CHECK_THAT(stitch({moved_scan(20), moved_scan(10)}),
             Catch::Contains("no scan comes near the surface") && Catch::Contains("scan 1"));
  RL::Color_stitcher stitcher = stitcher_of(space, {good, moved_scan(20)});
  const RL::Stitched_colors r = stitcher.stitch();
  CHECK(r.scans[0].covered_vertices > 0);
  CHECK(r.scans[1].covered_vertices == 0);
  CHECK(r.scans[1].chosen_area == 0);
  // from (1, 0, 0) to the rim of the scan
  CHECK(r.scans[1].smallest_distance == Approx(19.4).epsilon(0.02));

  // a surface that is oriented inwards
  shapes::Triangles inwards = t;
  for(auto& f : inwards.faces)
    std::swap(f[1], f[2]);
  const RL::Spline_space_3 reversed = stitch_space(inwards, 3);
  CHECK_THAT(stitch_message([&] { stitcher_of(reversed, {good}).stitch(); }),
             Catch::Contains("scan"));
  RL::Color_stitching_options options;
  options.back_projection.oriented = false;
  RL::Color_stitcher turned = stitcher_of(reversed, {good}, options),
                     plain = stitcher_of(space, {good});
  turned.choose();
  plain.choose();
  CHECK(turned.scans_of_vertices() == plain.scans_of_vertices());
  const RL::Colored_scan inside(good.surface(), good.colors());
  CHECK_THAT(stitch({inside}), Catch::Contains("faces the viewpoint of no scan"));
}

TEST_CASE("options_of_stitching_do_what_they_say", "[stitch]") {
  using Options = RL::Color_stitching_options;
  const shapes::Triangles t = shapes::sphere(3);
  const RL::Spline_space_3 space = stitch_space(t, 3);
  // coarser than the surface, and with an oblique and small one among them
  std::vector<RL::Colored_scan> scans = sphere_scans(2, 6);
  const Vector_3 oblique = Vector_3(1, 1, 0.5) / 1.5;
  shapes::Triangles small = seen_from(shapes::sphere(2), oblique);
  small.faces.erase(std::remove_if(small.faces.begin(), small.faces.end(),
                                   [&](const auto& f) {
                                     return (small.points[f[0]] - CGAL::ORIGIN) * oblique < 0.6;
                                   }),
                    small.faces.end());
  scans.emplace_back(RL::read_surface(RL::soup(small.points, small.faces)),
                     true_colors(small.points), RL::Scan_pose(CGAL::IDENTITY),
                     CGAL::ORIGIN + 4 * oblique);
  const RL::Stitched_colors by_default = stitcher_of(space, scans).stitch();
  CHECK(stitcher_of(space, scans).number_of_scans() == 7);
  CHECK(by_default.back_projection_seconds > 0);
  CHECK(by_default.choice_seconds > 0);
  for(std::size_t v = 0; v < scans[0].normals().size(); ++v)
    if(scans[0].normals()[v] != Vector_3(0, 0, 0))
      CHECK(scans[0].normals()[v] * (shapes::sphere(2).points[v] - CGAL::ORIGIN) > 0.95);

  // what is given by name is what an option says, and not the default
  const auto check = [&](const char* name, const auto& np, const auto& set) {
    INFO(name);
    Options options;
    set(options);
    const RL::Stitched_colors expected = stitcher_of(space, scans, options).stitch();
    std::vector<std::array<double, 3>> colors(t.points.size());
    const RL::Stitching_report report =
        RL::stitch_colors(RL::soup(t.points, t.faces), scans, CGAL::make_property_map(colors), np);
    CHECK(report.seam_length == expected.seam_length);
    bool differs = report.seam_length != by_default.seam_length;
    for(std::size_t s = 0; s < 7; ++s) {
      CHECK(report.scans[s].chosen_area == expected.scans[s].chosen_area);
      CHECK(report.scans[s].covered_area == expected.scans[s].covered_area);
      differs = differs || report.scans[s].covered_area != by_default.scans[s].covered_area ||
                report.scans[s].chosen_area != by_default.scans[s].chosen_area;
    }
    CHECK(differs);
  };
  const auto depth = params::depth(3);
  check("boundary_width", depth.boundary_width(0.05),
        [](Options& o) { o.back_projection.boundary_width = 0.05; });
  check("minimum_facing_cosine", depth.minimum_facing_cosine(0.6),
        [](Options& o) { o.back_projection.minimum_facing_cosine = 0.6; });
  check("normal_angle", depth.normal_angle(0.573),
        [](Options& o) { o.back_projection.normal_angle = 0.573; });
  check("maximum_distance", depth.maximum_distance(0.025),
        [](Options& o) { o.back_projection.maximum_distance = 0.025; });
  check("quality_smoothing_steps", depth.quality_smoothing_steps(200),
        [](Options& o) { o.quality_smoothing_steps = 200; });
  check("seam_weight", depth.seam_weight(10.), [](Options& o) { o.seam_weight = 10; });

  // 10 / area is the default of the weight
  Options options;
  options.alpha = RL::Color_stitcher::default_screening / space.surface().area();
  CHECK(RL::Color_stitcher::default_screening == 10);
  CHECK(stitcher_of(space, scans, options).stitch().colors == by_default.colors);
  *options.alpha *= 2;
  CHECK(stitcher_of(space, scans, options).stitch().colors != by_default.colors);
  // the larger one of two tolerances ends the iteration for the details
  options = Options();
  options.details_tolerance = 1e-9;
  options.solver.tolerance = 1e-9;
  const int exact = stitcher_of(space, scans, options).stitch().details_iterations;
  options.details_tolerance = 0.1;
  CHECK(stitcher_of(space, scans, options).stitch().details_iterations < exact);

  const RL::Back_projection bare = RL::back_project_colors(space.surface(), scans[0],
                                                           params::color_gradients(false)),
                            full = RL::back_project_colors(space.surface(), scans[0]);
  CHECK(bare.gradients.empty());
  CHECK(full.gradients.size() == full.vertices.size());
  CHECK(bare.colors == full.colors);
}

TEST_CASE("maps_get_the_colors_of_meshes_and_soups", "[stitch]") {
  const shapes::Triangles t = shapes::sphere(3);
  const std::vector<RL::Colored_scan> scans = sphere_scans(4, 6);
  shapes::Mesh mesh = shapes::mesh(t);
  auto map = mesh.add_property_map<shapes::Mesh::Vertex_index, CGAL::IO::Color>("v:color").first;
  const auto np = params::depth(3).linear_light(true);
  const RL::Stitching_report a = RL::stitch_colors(mesh, scans, map, np);
  CHECK(a.converged);
  auto numbers = mesh.add_property_map<shapes::Mesh::Vertex_index, Vector_3>("v:numbers").first;
  RL::stitch_colors(mesh, scans, numbers, np);
  std::vector<std::array<double, 3>> colors(t.points.size());
  const RL::Stitching_report b =
      RL::stitch_colors(RL::soup(t.points, t.faces), scans, CGAL::make_property_map(colors), np);
  CHECK(b.converged);
  CHECK(a.jump_after == Approx(b.jump_after).epsilon(0.05)); // ties are broken by the order
  for(const shapes::Mesh::Vertex_index v : mesh.vertices()) {
    CHECK(std::abs(map[v].red() - 255 * numbers[v].x()) < 0.501);
    CHECK(std::abs(map[v].green() - 255 * numbers[v].y()) < 0.501);
    CHECK(std::abs(map[v].blue() - 255 * numbers[v].z()) < 0.501);
    for(int k = 0; k < 3; ++k)
      CHECK(std::abs(colors[v][k] - numbers[v][static_cast<int>(k)]) < 0.01);
  }
  // named parameters arrive
  const auto message = [&](const auto& np) {
    return stitch_message([&] {
      RL::stitch_colors(RL::soup(t.points, t.faces), scans, CGAL::make_property_map(colors), np);
    });
  };
  CHECK_THAT(message(params::maximum_distance(-1.)), Catch::Contains("maximum_distance"));
  const auto chain = params::maximum_distance(-1.).concurrency_tag(CGAL::Sequential_tag());
  CHECK_THAT(message(chain), Catch::Contains("maximum_distance"));
  CHECK_THAT(message(params::seam_weight(-1.)), Catch::Contains("seam_weight"));
  CHECK_THAT(message(params::alpha(0.)), Catch::Contains("alpha"));
  CHECK_THAT(message(params::quality_smoothing_steps(-1)), Catch::Contains("quality_smoothing"));
  CHECK_THAT(message(params::boundary_width(-1.)), Catch::Contains("boundary_width is -1"));
  CHECK_THAT(message(params::minimum_facing_cosine(2.)),
             Catch::Contains("minimum_facing_cosine is 2"));
  CHECK_THAT(message(params::normal_angle(200.)), Catch::Contains("normal_angle is 200"));
  std::vector<std::array<std::uint32_t, 3>> inwards;
  for(const auto& f : t.faces)
    inwards.push_back({f[0], f[2], f[1]});
  const auto report = [&](const auto& faces, const auto& np) {
    return RL::stitch_colors(RL::soup(t.points, faces), scans, CGAL::make_property_map(colors), np);
  };
  CHECK_THAT(stitch_message([&] { report(inwards, np); }), Catch::Contains("no scan"));
  CHECK(report(inwards, np.oriented(false)).uncovered_vertices == 0);
  CHECK(a.scans[1].gains[0] != 1);
  CHECK(report(t.faces, np.match_exposures(false)).scans[1].gains[0] == 1);
  const RL::Spline_space_3 space = stitch_space(t, 3);
  for(const auto source : {RL::Gradient_source::scans, RL::Gradient_source::back_projection}) {
    report(t.faces, params::gradients(source).depth(3));
    RL::Color_stitching_options options;
    options.gradients = source;
    const RL::Stitched_colors expected = stitcher_of(space, scans, options).stitch();
    double difference = 0; // of two tolerances of the solver
    for(std::size_t v = 0; v < colors.size(); ++v)
      for(int k = 0; k < 3; ++k)
        difference = (std::max)(difference, std::abs(colors[v][k] - expected.colors[v][k]));
    CHECK(difference < 1e-3);
  }
}

TEST_CASE("exposures_in_linear_light_are_found_and_values_outside_are_counted", "[stitch]") {
  const shapes::Triangles t = shapes::sphere(3);
  const RL::Spline_space_3 space = stitch_space(t, 3);
  std::vector<RL::Colored_scan> scans;
  const std::array<double, 2> exposures = {1, 0.6};
  for(std::size_t i = 0; i < 2; ++i) {
    const shapes::Triangles seen = seen_from(t, i == 0 ? Vector_3(1, 0, 0) : Vector_3(0.6, 0.8, 0));
    std::vector<Rgb_color> colors = true_colors(seen.points);
    for(Rgb_color& c : colors)
      for(double& x : c)
        x = RL::linear_to_srgb(exposures[i] * RL::srgb_to_linear(x));
    scans.emplace_back(RL::read_surface(RL::soup(seen.points, seen.faces)), colors,
                       RL::Scan_pose(CGAL::IDENTITY), CGAL::ORIGIN + Vector_3(4, i * 4., 0));
  }
  RL::Color_stitching_options options;
  options.linear_light = true;
  const RL::Stitched_colors r = stitcher_of(space, scans, options).stitch();
  for(int k = 0; k < 3; ++k)
    CHECK(r.scans[1].gains[k] * exposures[1] ==
          Approx(r.scans[0].gains[k] * exposures[0]).epsilon(1e-3));
  // colors come back as they are given
  RL::Color_stitcher one = stitcher_of(space, {scans[0]}, options);
  const RL::Stitched_colors back = one.stitch();
  const RL::Vertex_colors of_scan = one.nearest_colors();
  for(std::size_t v = 0; v < t.points.size(); ++v)
    if(one.scans_of_vertices()[v] != RL::no_scan)
      for(int k = 0; k < 3; ++k) {
        CHECK(std::abs(back.colors[v][k] - of_scan.colors[v][k]) < 2e-3);
        CHECK(std::abs(back.colors[v][k] - true_color(t.points[v])[k]) < 0.02);
      }
  // in encoded values they are not one factor
  options.linear_light = false;
  const RL::Stitched_colors encoded = stitcher_of(space, scans, options).stitch();
  CHECK(encoded.scans[1].gains[0] / encoded.scans[0].gains[0] < 1.5);

  // A ramp beside a constant, with a step between them: its end is above 1 after.
  std::vector<RL::Colored_scan> ramp;
  for(std::size_t i = 0; i < 2; ++i) {
    std::vector<Rgb_color> colors;
    for(const Point_3& p : t.points) {
      const double x = i == 0 ? 0.9 : std::clamp(0.1 + 1.3 * (p.y() - 0.4), 0., 1.);
      colors.push_back({x, 0.5, 0.5});
    }
    colors.resize(scans[i].colors().size(), Rgb_color{0.5, 0.5, 0.5});
    ramp.emplace_back(scans[i].surface(), colors, RL::Scan_pose(CGAL::IDENTITY),
                      scans[i].viewpoint());
  }
  options.match_exposures = false;
  const RL::Stitched_colors clamped = stitcher_of(space, ramp, options).stitch();
  CHECK(clamped.clamped_values > 0);
  const auto number_of_ones = static_cast<std::size_t>(std::count_if(
      clamped.colors.begin(), clamped.colors.end(), [](const Rgb_color& c) { return c[0] == 1; }));
  CHECK(clamped.clamped_values <= number_of_ones); // not those that are hardly above 1
  CHECK(number_of_ones < t.points.size() / 10);

  // two exposures of one gray
  std::vector<RL::Colored_scan> bright;
  for(double x : {0.9, 0.45})
    bright.emplace_back(scans[x < 0.5 ? 1 : 0].surface(),
                        std::vector<Rgb_color>(t.points.size(), Rgb_color{x, x, x == 0.9 ? 1 : x}),
                        RL::Scan_pose(CGAL::IDENTITY), scans[x < 0.5 ? 1 : 0].viewpoint());
  const RL::Stitched_colors gray = stitcher_of(space, bright).stitch();
  const double gain = std::sqrt(2.);
  CHECK(gray.scans[1].gains[0] == Approx(gain));
  CHECK(gray.scans[0].gains[0] == Approx(1 / gain));
  CHECK(gray.clamped_values == 0);
  for(const Rgb_color& c : gray.colors) {
    CHECK(c[0] == Approx(0.9 / gain).epsilon(1e-6));
    CHECK(c[2] <= 1);
  }
}

TEST_CASE("stitching_does_not_depend_on_the_number_of_threads", "[stitch][threads]") {
  const shapes::Triangles t = shapes::sphere(5); // more triangles than a thread takes at once
  const std::vector<RL::Colored_scan> scans = sphere_scans(4, 5);
  const RL::Spline_space_3 serial = stitch_space(t, 4, false), parallel = stitch_space(t, 4, true);
  for(const auto source : {RL::Gradient_source::scans, RL::Gradient_source::back_projection}) {
    RL::Color_stitching_options options;
    options.gradients = source;
    const RL::Stitched_colors a = stitcher_of(serial, scans, options).stitch(),
                              b = stitcher_of(parallel, scans, options).stitch();
    CHECK(a.colors == b.colors);
    CHECK(a.uncovered_vertices > 0);
  }
  const shapes::Triangles seen = seen_from(t, {1, 0, 0});
  const RL::Triangulated_surface_3 surface = RL::read_surface(RL::soup(seen.points, seen.faces));
  const RL::Colored_scan c(surface, true_colors(t.points), RL::Scan_pose(CGAL::IDENTITY),
                           Point_3(4, 0, 0), false),
      d(surface, true_colors(t.points), RL::Scan_pose(CGAL::IDENTITY), Point_3(4, 0, 0), true);
  CHECK(c.boundary_distances() == d.boundary_distances());
}

TEST_CASE("stitching_survives_bad_triangles_and_scales", "[stitch]") {
  shapes::Triangles t = shapes::sphere(3);
  const std::vector<RL::Colored_scan> scans = sphere_scans(4, 6);
  const RL::Stitched_colors good = stitcher_of(stitch_space(t, 3), scans).stitch();
  const std::size_t n = t.points.size();
  t.points.emplace_back(7, 7, 7); // no face names it
  t.faces.push_back({0, 0, 1});
  t.faces.push_back({3, 3, 3});
  t.faces.push_back(t.faces[5]); // three triangles at its sides
  const RL::Stitched_colors bad = stitcher_of(stitch_space(t, 3), scans).stitch();
  CHECK(bad.converged);
  for(std::size_t v = 0; v < n; ++v)
    for(int k = 0; k < 3; ++k)
      CHECK(std::abs(bad.colors[v][k] - good.colors[v][k]) < 0.02);
  CHECK(bad.colors[n] == Rgb_color{0, 0, 0});
  for(const double scale : {1e-40, 1e40}) {
    std::vector<RL::Colored_scan> scaled;
    for(const RL::Colored_scan& scan : scans)
      scaled.emplace_back(scan.surface(), scan.colors(), RL::Scan_pose(CGAL::SCALING, scale),
                          scan.viewpoint());
    const RL::Stitched_colors r =
        stitcher_of(stitch_space(shapes::scaled(shapes::sphere(3), scale), 3), scaled).stitch();
    CHECK(r.converged);
    for(std::size_t v = 0; v < n; ++v)
      for(int k = 0; k < 3; ++k)
        CHECK(std::abs(r.colors[v][k] - good.colors[v][k]) < 1e-4);
  }
  // one triangle
  const RL::Triangulated_surface_3 one({Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0, 1, 0)},
                                       {{0, 1, 2}});
  const RL::Colored_scan scan(one, {{0.1, 0.2, 0.3}, {0.4, 0.5, 0.6}, {0.7, 0.8, 0.9}},
                              RL::Scan_pose(CGAL::IDENTITY), Point_3(0.3, 0.3, 2));
  RL::Spline_space_options options;
  options.depth = 2;
  const RL::Spline_space_3 space(one, options);
  const RL::Stitched_colors r = stitcher_of(space, {scan}).stitch();
  for(std::size_t v = 0; v < 3; ++v)
    for(int k = 0; k < 3; ++k)
      CHECK(r.colors[v][k] == Approx(scan.colors()[v][k]).epsilon(1e-4));
}

TEST_CASE("jumps_are_means_over_transitions", "[stitch]") {
  const RL::Triangulated_surface_3 two(
      {Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(1, 1, 0), Point_3(0, 1, 0)},
      {{0, 1, 2}, {0, 2, 3}});
  const auto edges = RL::scan_transitions(two, {0, 1, 0, RL::no_scan});
  using Edge = std::pair<std::uint32_t, std::uint32_t>;
  REQUIRE(edges == std::vector<Edge>{{0, 1}, {1, 2}});
  const std::vector<Rgb_color> colors = {{0, 0, 0}, {0.3, 0, 0.4}, {0.3, 0.2, 0.4}, {1, 1, 1}};
  CHECK(RL::mean_color_jump(edges, colors) == Approx((0.5 + 0.2) / 2));
  CHECK(RL::mean_color_jump({}, colors) == 0);
  CHECK_THROWS_AS(RL::mean_color_jump({{0, 4}}, colors), RL::Parameter_error);
  CHECK_THROWS_AS(RL::scan_transitions(two, {0, 1}), RL::Parameter_error);
}
