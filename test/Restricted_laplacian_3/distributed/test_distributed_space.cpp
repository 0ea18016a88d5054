// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// The parts of a space on several processes, against the whole space, which each of them makes,
// too.

#include "../catch.h"
#include "../special_shapes.h"
#include "../test_meshes.h"
#include "slices.h"

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Restricted_laplacian_3/distributed/Distributed_space.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace RL = CGAL::Restricted_laplacian_3;
using shapes::Triangles;

RL::Spline_space_options options_of(int depth) {
  RL::Spline_space_options options;
  options.depth = depth;
  return options;
}

void check_sheets(const RL::Distributed_space& space, const RL::Spline_space_3& whole, int level) {
  const RL::Octree_3 &octree = space.part().octree(), &all = whole.octree();
  const std::size_t first = space.level(level).first_sheet, n = octree.number_of_sheets(level);
  REQUIRE(space.number_of_sheets(level) == all.number_of_sheets(level));
  REQUIRE(first + n <= all.number_of_sheets(level));
  bool are_equal = true;
  for(std::size_t sheet = 0; sheet < n; ++sheet) {
    are_equal &= octree.cell(level, sheet) == all.cell(level, first + sheet);
    for(int i = 0; i < 27; ++i) {
      const int dx = i % 3 - 1, dy = i / 3 % 3 - 1, dz = i / 9 - 1;
      are_equal &= octree.meets_element(level, sheet, dx, dy, dz) ==
                   all.meets_element(level, first + sheet, dx, dy, dz);
    }
    if(level > 0)
      are_equal &= octree.parent(level, sheet) + space.level(level - 1).first_sheet ==
                   all.parent(level, first + sheet);
  }
  CHECK(are_equal);
  const std::uint64_t total = space.communicator().sum(static_cast<std::uint64_t>(n));
  CHECK(total == (level > space.gathered_level() ? 1 : space.communicator().size()) *
                     all.number_of_sheets(level));
  if(level == space.depth()) {
    are_equal = true;
    for(std::size_t sheet = 0; sheet < n; ++sheet) {
      const auto faces = octree.faces(sheet), expected = all.faces(first + sheet);
      REQUIRE(faces.size() == expected.size());
      for(std::size_t i = 0; i < faces.size(); ++i)
        are_equal &= space.surface_part().faces[faces[i]] == expected[i];
    }
    CHECK(are_equal);
  }
}

void check_elements(const RL::Distributed_space& space, const RL::Spline_space_3& whole,
                    int level) {
  const RL::Distributed_level& of_level = space.level(level);
  REQUIRE(space.dimension(level) == whole.dimension(level));
  CHECK(of_level.number_of_split_elements == whole.number_of_split_elements(level));
  REQUIRE(of_level.elements.size() == space.part().dimension(level));
  bool are_equal = true;
  for(std::size_t sheet = 0; sheet < space.part().number_of_sheets(level); ++sheet) {
    const RL::Cell_elements &part = space.part().elements(level, sheet),
                            &all = whole.elements(level, of_level.first_sheet + sheet);
    for(std::size_t i = 0; i < part.size(); ++i)
      are_equal &= part[i] == RL::no_element ? all[i] == RL::no_element
                                             : of_level.elements[part[i]] == all[i];
  }
  for(std::size_t i = 0; i < space.part().dimension(level); ++i) {
    are_equal &= i == 0 || of_level.elements[i - 1] < of_level.elements[i];
    are_equal &= space.part().center(level, i) == whole.center(level, of_level.elements[i]);
    const auto [sheet, position] = space.part().slot(level, i);
    are_equal &= space.part().elements(level, sheet)[position] == i;
  }
  if(level > space.gathered_level()) {
    // those that a rank owns are centered in its cells, or nearest to them
    const auto rank = static_cast<std::size_t>(space.communicator().rank());
    const auto [first, last] = space.ranges().cells(rank, level);
    REQUIRE(of_level.first_elements.size() == space.ranges().size() + 1);
    for(std::size_t i = of_level.first_elements[rank]; i < of_level.first_elements[rank + 1]; ++i) {
      RL::Cell_3 center = whole.center(level, i);
      for(int& x : center.index)
        x = (std::min)((std::max)(x, 0), (1 << level) - 1);
      are_equal &= center.key() >= first && center.key() < last;
    }
  }
  CHECK(are_equal);
}

void check_space(const std::string& name, const RL::Triangulated_surface_3& surface,
                 const RL::Spline_space_options& options) {
  INFO(name << ", depth " << *options.depth);
  const RL::Communicator communicator;
  const RL::Distributed_surface distributed(communicator, slice_of(surface, communicator));
  CHECK(distributed.number_of_faces() == surface.number_of_faces());
  CHECK(distributed.number_of_vertices() == surface.number_of_vertices());
  CHECK(distributed.number_of_degenerate_faces() == surface.number_of_degenerate_faces());
  CHECK(std::abs(distributed.area() - surface.area()) <= 1e-12 * surface.area());
  CHECK(distributed.is_point_set() == surface.is_point_set());
  CHECK(distributed.first_vertices().size() == static_cast<std::size_t>(communicator.size()) + 1);
  CHECK(distributed.communicator().size() == communicator.size());
  CHECK(RL::default_depth(distributed, 1.1) == RL::default_depth(surface, 1.1));
  const RL::Distributed_space space(distributed, options);
  CHECK(std::abs(space.area() - surface.area()) <= 1e-12 * surface.area());
  const RL::Spline_space_3 whole(surface, options);
  for(int level = 0; level <= *options.depth; ++level) {
    INFO("level " << level);
    check_sheets(space, whole, level);
    check_elements(space, whole, level);
  }
}

RL::Triangulated_surface_3 surface_of(const Triangles& t) {
  return RL::Triangulated_surface_3(t.points, t.faces);
}

} // namespace

TEST_CASE("parts_of_a_space_are_those_of_the_whole", "[shapes]") {
  std::mt19937 generator(11);
  std::uniform_real_distribution<double> uniform(0, 1);
  Triangles soup;
  for(int i = 0; i < 180; ++i)
    soup.points.emplace_back(uniform(generator), uniform(generator), uniform(generator));
  for(std::uint32_t i = 0; i < 60; ++i)
    soup.faces.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  const std::vector<std::pair<std::string, Triangles>> surfaces = {
      {"sphere", shapes::sphere(3)},
      {"box", shapes::box(1, 1, 0.05, 3, 1)},
      {"stairs", shapes::stairs(8, 0.1)},
      {"soup", soup},
      {"one triangle", {{{0, 0, 0}, {1, 0.2, 0}, {0.3, 1, 0.1}}, {{0, 1, 2}}}}};
  for(const auto& [name, t] : surfaces)
    for(int depth : {1, 2, 4, 6}) {
      if(depth == 6 && name != "stairs" && name != "soup")
        continue;
      RL::Spline_space_options options = options_of(depth);
      check_space(name, surface_of(t), options);
      // touches the walls of the domain cube: elements outside the grid
      options.cube_scale = 1;
      check_space(name + ", cube of scale 1", surface_of(t), options);
      if(depth > 4)
        continue;
      options.split = false;
      check_space(name + ", unsplit", surface_of(t), options);
      options.paper = true;
      check_space(name + ", space of the paper", surface_of(t), options);
    }
}

TEST_CASE("parts_of_a_space_of_joined_and_degenerate_faces", "[shapes]") {
  Triangles t = shapes::sphere(3);
  // torn into single faces that are joined again, some of them without area
  Triangles torn;
  for(const auto& f : t.faces) {
    const auto first = static_cast<std::uint32_t>(torn.points.size());
    for(std::uint32_t v : f)
      torn.points.push_back(t.points[v]);
    torn.faces.push_back({first, first + 1, first + 2});
    torn.faces.push_back({first, first + 1, first});
  }
  RL::Spline_space_options options = options_of(5);
  check_space("torn", surface_of(torn), options);
  options.joining_tolerance = 1e-9;
  check_space("joined", surface_of(torn), options);
}

TEST_CASE("parts_of_a_space_of_points", "[shapes]") {
  std::mt19937 generator(5);
  std::normal_distribution<double> normal;
  std::vector<RL::Point_3> points;
  std::vector<RL::Vector_3> normals;
  for(int i = 0; i < 3000; ++i) {
    const RL::Vector_3 v(normal(generator), normal(generator), normal(generator));
    normals.push_back(v / std::sqrt(v.squared_length()));
    points.push_back(CGAL::ORIGIN + normals.back());
  }
  const RL::Triangulated_surface_3 surface(points, normals, std::vector<double>(3000, 1.));
  for(int depth : {2, 4, 5})
    check_space("points", surface, options_of(depth));
}

TEST_CASE("ranges_have_about_the_same_weight", "[shapes]") {
  const RL::Communicator communicator;
  const RL::Triangulated_surface_3 surface = surface_of(shapes::sphere(4));
  const RL::Distributed_surface distributed(communicator, slice_of(surface, communicator));
  const RL::Octree_3 octree(surface, 7, 1.1);
  const RL::Rank_ranges ranges = distributed.balanced_ranges(octree);
  REQUIRE(ranges.size() == static_cast<std::size_t>(communicator.size()));
  CHECK(ranges.level() == 4);
  std::vector<double> sheets(ranges.size());
  for(std::size_t sheet = 0; sheet < octree.number_of_sheets(7); ++sheet)
    ++sheets[ranges.owner(7, octree.cell(7, sheet).key())];
  const double mean = static_cast<double>(octree.number_of_sheets(7)) / communicator.size();
  for(double number : sheets)
    CHECK(number <= 1.1 * mean);

  // the faces that meet the cells of this rank, and come near to them
  const RL::Surface_part part = distributed.part(octree, ranges, 1);
  const auto rank = static_cast<std::size_t>(communicator.rank());
  std::vector<char> is_there(surface.number_of_faces(), 0);
  for(std::uint32_t face : part.faces)
    is_there[face] = 1;
  bool are_there = true;
  for(std::size_t sheet = 0; sheet < octree.number_of_sheets(7); ++sheet)
    if(ranges.is_near(rank, 7, octree.cell(7, sheet).key(), 1))
      for(std::uint32_t face : octree.faces(sheet))
        are_there &= is_there[face] == 1;
  CHECK(are_there);
  CHECK((communicator.size() == 1 || part.faces.size() < 0.8 * surface.number_of_faces()));
  CHECK(communicator.concatenation(distributed.points()).size() == surface.number_of_vertices());
  CHECK(distributed.slice().faces.size() == slice_of(surface, communicator).triangles.size());
}

TEST_CASE("all_ranks_see_what_is_wrong_with_a_surface", "[shapes]") {
  const RL::Communicator communicator;
  const auto message = [&](const Triangles& t) {
    // rank 0 has all that is right, the last one what is wrong
    RL::Surface_slice slice;
    const bool is_last = communicator.rank() == communicator.size() - 1;
    if(is_last)
      slice.points = t.points;
    if(is_last)
      slice.triangles = t.faces;
    try {
      const RL::Distributed_surface surface(communicator, slice);
    } catch(const RL::Distributed_error& error) {
      return std::string(error.what());
    }
    return std::string("nothing");
  };
  const auto expected = [](const Triangles& t) {
    try {
      surface_of(t);
    } catch(const std::exception& error) {
      return std::string(error.what());
    }
    return std::string("nothing");
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Triangles> bad = {{},
                                      {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 3}}},
                                      {{{0, 0, 0}, {1, 0, 0}, {0, nan, 0}}, {{0, 1, 2}}},
                                      {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}, {0, 2, 1}}},
                                      {{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, {{0, 1, 2}}}};
  for(const Triangles& t : bad) {
    REQUIRE(expected(t) != "nothing");
    CHECK(message(t) == expected(t));
  }
  CHECK(message({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {nan, 0, 0}}, {{0, 1, 2}}}) == "nothing");
}

TEST_CASE("parts_of_spaces_of_real_meshes", "[meshes]") {
  for(const std::string name :
      {"pulley_28k.ply", "moebius.ply", "cessna_soup_14k.ply", "rgbd5_scan1.ply"}) {
    const std::string path = shared_mesh(name);
    if(path.empty()) {
      SKIP_PART(name << " is not there");
      continue;
    }
    std::vector<RL::Point_3> points;
    std::vector<std::vector<std::size_t>> faces;
    REQUIRE(CGAL::IO::read_polygon_soup(path, points, faces));
    check_space(name, RL::read_surface(RL::soup(points, faces)), options_of(6));
  }
}
