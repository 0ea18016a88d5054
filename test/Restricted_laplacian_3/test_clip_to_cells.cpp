// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Triangles are cut into fragments without loss, overlap or ambiguity, wherever they lie in the
// grid.

#include "catch.h"

#include <CGAL/Restricted_laplacian_3/octree/clip_to_cells.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <map>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace RL = CGAL::Restricted_laplacian_3;
using Point = std::array<double, 3>;
using Corners = std::array<Point, 3>;
using Cell = std::array<int, 3>;
using Fragments = std::vector<std::pair<Cell, RL::Fragment>>;

/// of an octree: `Octree_3::relative_wall_tolerance`, in units of the cell width
double wall_tolerance(int n) { return 1.5e-14 * n; }

RL::Cell_clipper clipper(int n) { return RL::Cell_clipper(n, wall_tolerance(n)); }

Fragments fragments(const Corners& corners, int n) {
  Fragments result;
  clipper(n)(corners, [&](const Cell& cell, const RL::Fragment& fragment) {
    result.emplace_back(cell, fragment);
  });
  return result;
}

RL::Fragment whole(const Corners& corners) {
  RL::Fragment result;
  for(int i = 0; i < 3; ++i)
    result.push_back({corners[i], {i == 0 ? 1. : 0., i == 1 ? 1. : 0., i == 2 ? 1. : 0.}});
  return result;
}

double longest_side(const Corners& corners) {
  double result = 0;
  for(int i = 0; i < 3; ++i)
    result = (std::max)(result, std::hypot(corners[i][0] - corners[(i + 1) % 3][0],
                                           corners[i][1] - corners[(i + 1) % 3][1],
                                           corners[i][2] - corners[(i + 1) % 3][2]));
  return result;
}

/// by how much the area of a triangle changes if its corners move by `distance`
double change_of_double_area(const Corners& corners, double distance) {
  return 3 * distance * longest_side(corners);
}

/// the point of a triangle with these barycentric coordinates
Point at(const Corners& corners, const Point& barycentric) {
  Point result = {0, 0, 0};
  for(int i = 0; i < 3; ++i)
    for(int axis = 0; axis < 3; ++axis)
      result[axis] += barycentric[i] * corners[i][axis];
  return result;
}

struct Case {
  std::string name;
  int n; // cells per side
  Corners corners;
};

/// Triangles in general position and in all special ones.
std::vector<Case> cases() {
  std::vector<Case> result;
  std::mt19937 generator(1);
  const auto real = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(generator);
  };
  const auto integer = [&](int low, int high) {
    return std::uniform_int_distribution<int>(low, high)(generator);
  };
  const auto random_point = [&](int n) { return Point{real(0, n), real(0, n), real(0, n)}; };
  const auto random_corners = [&](int n) {
    return Corners{random_point(n), random_point(n), random_point(n)};
  };
  const auto add = [&](const std::string& name, int n, const Corners& corners) {
    if(whole(corners).double_area() > 0)
      result.push_back({name, n, corners});
  };

  for(int n : {1, 2, 8, 64})
    for(int i = 0; i < 50; ++i) {
      add("random", n, random_corners(n));

      Corners c = random_corners(n);
      for(Point& p : c)
        for(double& x : p)
          x = std::round(x);
      add("corners of cells", n, c);

      c = random_corners(n);
      for(Point& p : c)
        for(double& x : p)
          x = std::round(2 * x) / 2;
      add("corners and midpoints of cells", n, c);

      const int axis = integer(0, 2), other = (axis + 1) % 3, wall = integer(0, n);
      c = random_corners(n);
      for(Point& p : c)
        p[axis] = wall;
      add("in a wall", n, c);
      for(Point& p : c)
        for(double& x : p)
          x = std::round(x);
      add("in a wall, corners of cells", n, c);

      c = random_corners(n);
      c[0][axis] = c[1][axis] = wall;
      add("a side in a wall", n, c);
      c[0][other] = c[1][other] = integer(0, n);
      add("a side in an edge of the grid", n, c);

      c = random_corners(n);
      for(Point& p : c)
        p[axis] = p[other];
      add("through edges of cells", n, c);
      for(Point& p : c) {
        p[other] = real(0, n - p[axis]);
        p[(axis + 2) % 3] = n - p[axis] - p[other];
      }
      add("through corners of cells", n, c);

      // walls missed by a rounding error, and by somewhat more than the tolerance
      for(double distance : {1e-16, 1e-15, 1e-10}) {
        c = random_corners(n);
        for(Point& p : c)
          p[axis] = (std::min)((std::max)(wall + n * distance * integer(-3, 3), 0.), double(n));
        add("close to a wall", n, c);
      }

      for(double size : {1e-3, 1e-6, 1e-9}) {
        Point center = random_point(n);
        if(i % 2 == 0)
          center[axis] = (std::min)((std::max)(wall, 1), (std::max)(n - 1, 1)) - (n == 1 ? 0.5 : 0);
        if(i % 4 == 0)
          for(double& x : center)
            x = (std::min)((std::max)(std::round(x), 0.001), n - 0.001);
        for(Point& p : c)
          for(int a = 0; a < 3; ++a)
            p[a] = (std::min)((std::max)(center[a] + size * real(-1, 1), 0.), double(n));
        add("tiny", n, c);
      }

      for(double width : {1e-3, 1e-6, 1e-9}) {
        c[0] = random_point(n);
        c[1] = random_point(n);
        for(int a = 0; a < 3; ++a)
          c[2][a] = (std::min)((std::max)(c[1][a] + width * real(-1, 1), 0.), double(n));
        add("needle", n, c);
      }
    }
  for(int i = 0; i < 8; ++i) {
    const double width = std::pow(10., -i), y = real(1, 1023);
    add("needle across many cells", 1024,
        {random_point(1), Point{1023.7, y, 1000.25}, Point{1023.7, y - width, 1000.25}});
    add("needle along a wall", 1024,
        {Point{0.3, 512, 0.5}, Point{1023.7, 512, 1000}, Point{1023.7, 512 - width, 1000}});
  }
  return result;
}

/// calls `check(case)`; what fails says where
template <class Check> void for_each_case(Check&& check) {
  static const std::vector<Case> all = cases();
  for(const Case& c : all) {
    const auto text = [&c](int i) {
      std::ostringstream out;
      out << std::setprecision(17) << c.corners[i][0] << " " << c.corners[i][1] << " "
          << c.corners[i][2];
      return out.str();
    };
    INFO(c.name << ", " << c.n << " cells a side: " << text(0) << ", " << text(1) << ", "
                << text(2));
    check(c);
  }
}

std::array<double, 2> range(const RL::Fragment& fragment, int axis) {
  std::array<double, 2> result = {fragment.corners[0].position[axis],
                                  fragment.corners[0].position[axis]};
  for(std::size_t i = 1; i < fragment.size; ++i) {
    result[0] = (std::min)(result[0], fragment.corners[i].position[axis]);
    result[1] = (std::max)(result[1], fragment.corners[i].position[axis]);
  }
  return result;
}

/// twice the area of a fragment in the plane of the barycentric coordinates, where that of its
/// triangle is 1; negative if it is turned over
double signed_barycentric_area(const RL::Fragment& fragment) {
  double sum = 0;
  for(std::size_t i = 0; i < fragment.size; ++i) {
    const Point &p = fragment.corners[i].barycentric,
                &q = fragment.corners[(i + 1) % fragment.size].barycentric;
    sum += p[1] * q[2] - p[2] * q[1];
  }
  return sum;
}

/// 1 if the convex fragment contains the point with margin `epsilon`, -1 if the point is farther
/// than that outside of it, 0 if neither is certain
int contains(const RL::Fragment& fragment, const Point& barycentric, double epsilon) {
  int result = 1;
  for(std::size_t i = 0; i < fragment.size; ++i) {
    const Point &p = fragment.corners[i].barycentric,
                &q = fragment.corners[(i + 1) % fragment.size].barycentric;
    const double u = q[1] - p[1], v = q[2] - p[2], length = std::hypot(u, v);
    if(length <= epsilon)
      continue;
    const double distance = (u * (barycentric[2] - p[2]) - v * (barycentric[1] - p[1])) / length;
    if(distance < -epsilon)
      return -1;
    if(distance <= epsilon)
      result = 0;
  }
  return result;
}

std::map<Cell, double> double_areas(const Fragments& fragments) {
  std::map<Cell, double> result;
  for(const auto& [cell, fragment] : fragments)
    result[cell] = fragment.double_area();
  return result;
}

/// what rounding and moving points onto walls may change of twice an area
double area_tolerance(const Case& c) {
  return 1e-14 * whole(c.corners).double_area() +
         change_of_double_area(c.corners, wall_tolerance(c.n));
}

/// A triangle that is nearly parallel to a wall crosses it in a line whose place is as uncertain as
/// rounding errors over the slope: so much of twice the area may change its cell.
double uncertainty_of_crossings(const Case& c) {
  const RL::Fragment triangle = whole(c.corners);
  double result = 0;
  for(int axis = 0; axis < 3; ++axis) {
    const auto [low, high] = range(triangle, axis);
    if(high - low > wall_tolerance(c.n))
      result += 1e-15 * c.n / (high - low) * std::pow(longest_side(c.corners), 2);
  }
  return result;
}

} // namespace

TEST_CASE("fragments_sum_to_the_area", "[clip]") {
  for_each_case([](const Case& c) {
    double sum = 0, barycentric_sum = 0;
    for(const auto& [cell, fragment] : fragments(c.corners, c.n)) {
      sum += fragment.double_area();
      barycentric_sum += signed_barycentric_area(fragment);
    }
    const double area = whole(c.corners).double_area();
    REQUIRE(std::abs(sum - area) <= area_tolerance(c));
    if(c.name == "random")
      REQUIRE(std::abs(sum - area) <= 1e-13 * area);
    // Barycentric coordinates come out of the same cuts: they also cover the triangle once.
    const double displacement = area_tolerance(c) / area;
    REQUIRE(std::abs(barycentric_sum - 1) <= 1e-13 + displacement);
  });
}

TEST_CASE("fragments_lie_in_their_cells", "[clip]") {
  for_each_case([](const Case& c) {
    std::set<Cell> seen;
    bool has_area = true, is_inside = true, has_right_owner = true;
    std::size_t least_size = 3, largest_size = 3;
    for(const auto& [cell, fragment] : fragments(c.corners, c.n)) {
      REQUIRE(seen.insert(cell).second);
      least_size = (std::min)(least_size, fragment.size);
      largest_size = (std::max)(largest_size, fragment.size);
      has_area = has_area && fragment.double_area() > 0;
      for(int axis = 0; axis < 3; ++axis) {
        const auto [low, high] = range(fragment, axis);
        // without tolerance: an element must not be evaluated outside of its cell
        is_inside = is_inside && cell[axis] >= 0 && cell[axis] < c.n && low >= cell[axis] &&
                    high <= cell[axis] + 1;
        // half-open cells: what lies in a wall belongs to the upper cell, the last one is closed
        has_right_owner =
            has_right_owner && !(low == high && low < c.n && cell[axis] != std::floor(low));
      }
    }
    REQUIRE(has_area);
    REQUIRE(is_inside);
    REQUIRE(has_right_owner);
    REQUIRE(least_size == 3);
    REQUIRE(largest_size <= 9);
  });
}

TEST_CASE("triangle_in_a_wall_belongs_to_the_upper_cells", "[clip]") {
  const int n = 4;
  for(int axis = 0; axis < 3; ++axis)
    for(int wall = 0; wall <= n; ++wall)
      for(double rounding_error : {0., 1e-16, -1e-16, 4e-15, -4e-15}) {
        Corners corners;
        for(int i = 0; i < 3; ++i) {
          corners[i][axis] = wall + rounding_error * (i - 1);
          corners[i][(axis + 1) % 3] = i == 1 ? 3.5 : 0.5;
          corners[i][(axis + 2) % 3] = i == 2 ? 3.25 : 0.75;
        }
        const Fragments all = fragments(corners, n);
        CHECK(all.size() > 4);
        for(const auto& [cell, fragment] : all)
          CHECK(cell[axis] == (std::min)(wall, n - 1));
      }
}

TEST_CASE("barycentric_coordinates_reproduce_positions", "[clip]") {
  for_each_case([](const Case& c) {
    double least = 0, sum_error = 0, position_error = 0;
    for(const auto& [cell, fragment] : fragments(c.corners, c.n))
      for(std::size_t i = 0; i < fragment.size; ++i) {
        const Point& l = fragment.corners[i].barycentric;
        least = (std::min)({least, l[0], l[1], l[2]});
        sum_error = (std::max)(sum_error, std::abs(l[0] + l[1] + l[2] - 1));
        for(int axis = 0; axis < 3; ++axis)
          position_error = (std::max)(position_error, std::abs(at(c.corners, l)[axis] -
                                                               fragment.corners[i].position[axis]));
      }
    // a side is cut at one wall after the other, and so the error grows with their number
    REQUIRE(least >= -1e-15 * (1 + c.n));
    REQUIRE(sum_error <= 1e-15 * (1 + c.n));
    REQUIRE(position_error <= 4 * wall_tolerance(c.n));
  });
}

TEST_CASE("each_point_of_a_triangle_lies_in_one_fragment", "[clip]") {
  std::mt19937 generator(2);
  std::uniform_real_distribution<double> uniform(0, 1);
  int certain = 0, uncertain = 0;
  for_each_case([&](const Case& c) {
    // moving a point by the tolerance changes its barycentric coordinates by this
    const double height = whole(c.corners).double_area() / longest_side(c.corners);
    const double epsilon = 1e-12 + 10 * wall_tolerance(c.n) / height;
    if(epsilon > 1e-3)
      return;
    const Fragments all = fragments(c.corners, c.n);
    for(int k = 0; k < 20; ++k) {
      const double root = std::sqrt(uniform(generator)), v = uniform(generator);
      const Point l = {1 - root, root * (1 - v), root * v};
      int inside = 0, unknown = 0;
      Cell owner = {};
      for(const auto& [cell, fragment] : all) {
        const int answer = contains(fragment, l, epsilon);
        inside += answer == 1;
        unknown += answer == 0;
        if(answer == 1)
          owner = cell;
      }
      (unknown == 0 ? certain : uncertain) += 1;
      REQUIRE(inside + unknown >= 1);
      REQUIRE(inside <= 1);
      if(unknown != 0)
        continue;
      for(int axis = 0; axis < 3; ++axis) {
        const double x =
            l[0] * c.corners[0][axis] + l[1] * c.corners[1][axis] + l[2] * c.corners[2][axis];
        REQUIRE(x >= owner[axis] - 2 * wall_tolerance(c.n));
        REQUIRE(x <= owner[axis] + 1 + 2 * wall_tolerance(c.n));
      }
    }
  });
  CHECK(certain > 50 * uncertain);
}

TEST_CASE("order_of_the_corners_does_not_matter", "[clip]") {
  for_each_case([](const Case& c) {
    const std::map<Cell, double> expected = double_areas(fragments(c.corners, c.n));
    std::array<int, 3> order = {0, 1, 2};
    while(std::next_permutation(order.begin(), order.end())) {
      const Corners reordered = {c.corners[order[0]], c.corners[order[1]], c.corners[order[2]]};
      const std::map<Cell, double> areas = double_areas(fragments(reordered, c.n));
      REQUIRE(areas.size() == expected.size());
      auto it = areas.begin();
      double difference = 0;
      bool are_same_cells = true;
      for(const auto& [cell, area] : expected) {
        are_same_cells = are_same_cells && it->first == cell;
        difference = (std::max)(difference, std::abs(it++->second - area));
      }
      REQUIRE(are_same_cells);
      REQUIRE(difference <= area_tolerance(c));
    }
  });
}

TEST_CASE("triangles_meet_in_the_same_points_along_a_common_side", "[clip]") {
  // points of the fragments on the side opposite to corner 2
  const auto points_on_side = [](const Corners& corners, int n) {
    std::set<Point> result;
    for(const auto& [cell, fragment] : fragments(corners, n))
      for(std::size_t i = 0; i < fragment.size; ++i)
        if(fragment.corners[i].barycentric[2] == 0)
          result.insert(fragment.corners[i].position);
    return result;
  };
  std::mt19937 generator(3);
  for_each_case([&](const Case& c) {
    if(c.n > 64)
      return;
    std::uniform_real_distribution<double> uniform(0, c.n);
    const Corners neighbor = {c.corners[1], c.corners[0],
                              Point{uniform(generator), uniform(generator), uniform(generator)}};
    const std::set<Point> points = points_on_side(c.corners, c.n);
    REQUIRE(points.size() >= 2);
    REQUIRE(points == points_on_side(neighbor, c.n));
  });
}

TEST_CASE("fragment_of_one_cell_is_that_of_all_cells", "[clip]") {
  for_each_case([](const Case& c) {
    double sum = 0, difference = 0;
    bool is_inside = true;
    for(const auto& [cell, expected] : fragments(c.corners, c.n)) {
      const RL::Fragment fragment = clipper(c.n).fragment(c.corners, cell);
      sum += fragment.double_area();
      difference =
          (std::max)(difference, std::abs(fragment.double_area() - expected.double_area()));
      for(int axis = 0; axis < 3 && fragment.size != 0; ++axis)
        is_inside = is_inside && range(fragment, axis)[0] >= cell[axis] &&
                    range(fragment, axis)[1] <= cell[axis] + 1;
    }
    REQUIRE(is_inside);
    REQUIRE(std::abs(sum - whole(c.corners).double_area()) <= area_tolerance(c));
    REQUIRE(difference <= area_tolerance(c) + uncertainty_of_crossings(c));
  });
}

TEST_CASE("cells_that_own_nothing_of_a_triangle_get_no_area", "[clip]") {
  for_each_case([](const Case& c) {
    if(c.n > 8)
      return;
    const std::map<Cell, double> owners = double_areas(fragments(c.corners, c.n));
    double area = 0;
    Cell cell;
    for(cell[2] = 0; cell[2] < c.n; ++cell[2])
      for(cell[1] = 0; cell[1] < c.n; ++cell[1])
        for(cell[0] = 0; cell[0] < c.n; ++cell[0]) {
          if(owners.count(cell) == 1)
            continue;
          // what lies in a wall is found from both sides: only owners may be asked for it
          const RL::Fragment fragment = clipper(c.n).fragment(c.corners, cell);
          bool is_in_wall = fragment.size == 0;
          for(int axis = 0; axis < 3 && !is_in_wall; ++axis)
            is_in_wall = range(fragment, axis)[0] == range(fragment, axis)[1];
          if(!is_in_wall)
            area += fragment.double_area();
        }
    REQUIRE(area <= area_tolerance(c) + uncertainty_of_crossings(c));
  });
}

TEST_CASE("triangles_without_area_have_no_fragments", "[clip]") {
  for(const Corners& corners : {Corners{Point{1.5, 1.5, 1.5}, {1.5, 1.5, 1.5}, {1.5, 1.5, 1.5}},
                                {Point{0, 0, 0}, {4, 4, 4}, {2, 2, 2}},
                                {Point{1, 0.5, 1}, {1, 3.5, 1}, {1, 3.5, 1}},
                                {Point{0, 2, 0}, {4, 2, 0}, {3, 2, 0}}})
    CHECK(fragments(corners, 4).empty());
}

TEST_CASE("no_corner_of_a_fragment_is_lost", "[clip]") {
  RL::Fragment fragment;
  for(std::size_t i = 0; i < RL::Fragment::capacity; ++i)
    fragment.push_back({});
  CHECK(fragment.size == RL::Fragment::capacity);
  CHECK_THROWS_AS(fragment.push_back({}), RL::Numerical_error);
}
