// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// CGAL's search alone, without its triangulations
#define CGAL_HOLE_FILLING_DO_NOT_USE_CDT2
#define CGAL_HOLE_FILLING_DO_NOT_USE_DT3

#include "catch.h"

#include <CGAL/Restricted_laplacian_3/surface/shared/divide_polygon.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <numeric>
#include <random>
#include <vector>

// The division of one polygon against CGAL's of the same, and by sums of areas.

namespace RL = CGAL::Restricted_laplacian_3;

namespace {

using Triangles = std::vector<RL::Triangulated_surface_3::Triangle>;
using Points = std::vector<RL::Point_3>;

/// A type of its own keeps this instance of CGAL's templates apart from others.
struct Part_of_hole {
  std::array<std::uint32_t, 3> corners;

  Part_of_hole(int i, int j, int k)
    : corners{std::uint32_t(i), std::uint32_t(j), std::uint32_t(k)} {}
};

Triangles divided(const Points& corners) {
  std::vector<std::uint32_t> polygon(corners.size());
  std::iota(polygon.begin(), polygon.end(), 0);
  return RL::internal::divided_polygon(corners, polygon);
}

Triangles divided_by_cgal(const Points& corners) {
  using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
  std::vector<Point> points;
  for(const RL::Point_3& p : corners)
    points.emplace_back(p.x(), p.y(), p.z());
  std::vector<Part_of_hole> parts;
  CGAL::Polygon_mesh_processing::triangulate_hole_polyline(
      points, std::back_inserter(parts),
      CGAL::parameters::use_2d_constrained_delaunay_triangulation(false).use_delaunay_triangulation(
          false));
  Triangles result;
  for(const Part_of_hole& part : parts)
    result.push_back(part.corners);
  return result;
}

/// the sum of the areas of a division of a polygon in the plane z = 0, and that of their amounts
std::array<double, 2> areas(const Points& corners, const Triangles& triangles) {
  std::array<double, 2> result = {0, 0};
  for(const auto& t : triangles) {
    const double area =
        CGAL::cross_product(corners[t[1]] - corners[t[0]], corners[t[2]] - corners[t[0]]).z() / 2;
    result[0] += area;
    result[1] += std::abs(area);
  }
  return result;
}

double area_of(const Points& corners) {
  double result = 0;
  for(std::size_t i = 0; i < corners.size(); ++i) {
    const RL::Point_3 &p = corners[i], &q = corners[(i + 1) % corners.size()];
    result += (p.x() * q.y() - p.y() * q.x()) / 2;
  }
  return result;
}

/// A polygon around the center with n corners, from half to one and a half away from it.
Points star(std::size_t n, double height, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(-0.5, 0.5);
  Points result;
  for(std::size_t i = 0; i < n; ++i) {
    const double angle = 2 * CGAL_PI * double(i) / double(n), r = 1 + number(random);
    result.emplace_back(r * std::cos(angle), r * std::sin(angle), height * number(random));
  }
  return result;
}

/// a double spiral of some turns
Points spiral(std::size_t n) {
  Points result;
  for(std::size_t i = 0; i < n; ++i) {
    const std::size_t k = i < n / 2 ? i : n - 1 - i; // out and back
    const double angle = 40 * double(k) / double(n), r = angle + (i < n / 2 ? 1.0 : 0.5);
    result.emplace_back(r * std::cos(angle), r * std::sin(angle), 0);
  }
  if(area_of(result) < 0)
    std::reverse(result.begin(), result.end());
  return result;
}

/// teeth on a bar, with all corners of the teeth on two lines
Points comb(std::size_t teeth) {
  Points result = {{0, -1, 0}, {double(2 * teeth), -1, 0}};
  for(std::size_t i = teeth; i-- > 0;)
    for(const auto& corner : {std::array<double, 2>{2, 0}, {2, 1}, {1, 1}, {1, 0}})
      result.emplace_back(double(2 * i) + corner[0], corner[1], 0);
  result.emplace_back(0, 0, 0);
  return result;
}

/// a square with corners along its sides, and square holes that slits join to its lower side
Points with_holes(std::size_t holes) {
  Points result;
  const double length = double(4 * holes);
  for(std::size_t i = 0; i < holes; ++i) {
    const double x = double(4 * i) + 1;
    for(const auto& corner :
        {std::array<double, 2>{0, 0}, {0, 1}, {0, 3}, {2, 3}, {2, 1}, {0, 1}, {0, 0}})
      result.emplace_back(x + corner[0], corner[1], 0);
  }
  result.emplace_back(length, 0, 0);
  for(std::size_t i = 1; i <= 10; ++i)
    result.emplace_back(length, 0.4 * double(i), 0);
  result.emplace_back(0, 4, 0);
  result.emplace_back(0, 0, 0);
  return result;
}

} // namespace

TEST_CASE("the_least_bent_division_is_that_of_cgal", "[polygons]") {
  for(const std::size_t n : {4, 5, 6, 7, 12, 30, 50})
    for(const double height : {0.1, 1.0})
      for(unsigned seed = 0; seed < (n < 20 ? 20u : 2u); ++seed) {
        CAPTURE(n, height, seed);
        Points corners = star(n, height, seed);
        const Triangles expected = divided_by_cgal(corners);
        CHECK(divided(corners) == expected);
        for(RL::Point_3& p : corners) // in any unit
          p = RL::Point_3(0x1p-300 * p.x(), 0x1p-300 * p.y(), 0x1p-300 * p.z());
        CHECK(divided(corners) == expected);
      }
}

TEST_CASE("polygons_with_many_corners_are_divided_without_overlap", "[polygons]") {
  std::vector<Points> polygons = {comb(3),      comb(20),      comb(300),      spiral(60),
                                  spiral(1000), with_holes(8), with_holes(100)};
  for(const std::size_t n : {51, 200, 20000})
    for(unsigned seed = 0; seed < 3; ++seed)
      polygons.push_back(star(n, 0, seed));
  for(std::size_t i = 0; i < polygons.size(); ++i)
    for(const bool is_turned : {false, true}) {
      Points corners = polygons[i];
      if(is_turned)
        std::reverse(corners.begin(), corners.end());
      CAPTURE(i, corners.size(), is_turned);
      const Triangles triangles = divided(corners);
      CHECK(triangles.size() + 2 == corners.size());
      const auto [sum, amount] = areas(corners, triangles);
      CHECK(sum == Approx(area_of(corners)));
      CHECK(amount == Approx(std::abs(area_of(corners))));
    }
  // corners along the lowest side of a triangle, whose highest one comes first
  Points triangle = {{30, 10, 0}};
  for(int i = 0; i <= 60; ++i)
    triangle.emplace_back(i, 0, 0);
  for(const auto& t : divided(triangle))
    CHECK(areas(triangle, {t})[0] > 0);
  // each corner of a bent one is in its place
  const Points bent = star(300, 0.3, 1);
  Points shadow;
  for(const RL::Point_3& p : bent)
    shadow.emplace_back(p.x(), p.y(), 0);
  CHECK(areas(bent, divided(bent))[1] == Approx(area_of(shadow)));
  // one that winds twice around meets itself
  Points twice;
  for(int i = 0; i < 101; ++i)
    twice.emplace_back((1 + 0.1 * (i % 2)) * std::cos(4 * CGAL_PI * i / 101),
                       std::sin(4 * CGAL_PI * i / 101), 0);
  CHECK(divided(twice).size() == 99);
  // and one whose corners are anywhere, everywhere: in no time all the same
  std::mt19937 random(1);
  std::uniform_real_distribution<double> number(0, 1);
  Points anywhere;
  for(int i = 0; i < 50000; ++i)
    anywhere.emplace_back(number(random), number(random), 0);
  CHECK(divided(anywhere).size() == 49998);
}
