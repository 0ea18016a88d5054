// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// What would fill the memory, or more than an int can number, is refused, exactly from the limit
// on.

#include "catch.h"
#include "special_shapes.h"

#include <CGAL/Restricted_laplacian_3/foundation/internal/sum_counts.h>
#include <CGAL/Restricted_laplacian_3/octree/Octree_3.h>
#include <CGAL/Restricted_laplacian_3/octree/internal/Finest_sheets.h>
#include <CGAL/Restricted_laplacian_3/octree/internal/Points_in_grid.h>
#include <CGAL/Restricted_laplacian_3/octree/internal/Triangles_in_grid.h>

#include <cstddef>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace {

namespace RL = CGAL::Restricted_laplacian_3;
namespace internal = CGAL::Restricted_laplacian_3::internal;

constexpr int depth = 3;
constexpr std::size_t no_limit = (std::numeric_limits<std::size_t>::max)();

/// the surface of an octree in its finest grid, with other limits than those of the octree
std::unique_ptr<internal::Surface_in_grid> in_grid(const RL::Octree_3& octree,
                                                   const internal::Octree_limits& limits) {
  const RL::Triangulated_surface_3& surface = octree.surface();
  const RL::Cell_clipper clipper(1 << depth, 1e-14);
  internal::Grid_input input = {
      surface, nullptr, {surface, {surface.center(), octree.side()}, depth, clipper},
      true,    limits,  false};
  if(surface.is_point_set())
    return std::make_unique<internal::Points_in_grid>(std::move(input));
  return std::make_unique<internal::Triangles_in_grid>(std::move(input), octree.cell_width(depth),
                                                       clipper, RL::Octree_3::thin_face_height, -1);
}

/// whether the surface is refused with these limits; with a word on the depth
bool is_refused(const RL::Octree_3& octree, std::size_t sheets, std::size_t fragments) {
  const internal::Octree_limits limits = {depth, sheets, fragments};
  try {
    const auto surface = in_grid(octree, limits);
    const auto join = [&](const internal::Cell_fragment* f, std::uint32_t size,
                          internal::Sheet_scratch& scratch) { surface->join(f, size, scratch); };
    internal::group_into_sheets(surface->fragments(), join, limits, false);
    return false;
  } catch(const RL::Parameter_error& error) {
    CHECK(error.parameter() == "octree_depth");
    CHECK(std::string(error.what()).find("octree_depth is 3") == 0);
    return true;
  }
}

} // namespace

TEST_CASE("octrees_are_refused_from_their_limits_on", "[limits]") {
  const shapes::Triangles sphere = shapes::sphere(2),
                          two = shapes::joined(sphere, shapes::scaled(sphere, 0.99));
  std::vector<RL::Vector_3> normals;
  for(const RL::Point_3& p : sphere.points)
    normals.push_back(p - CGAL::ORIGIN);
  for(const RL::Octree_3& octree :
      {RL::Octree_3(RL::Triangulated_surface_3(sphere.points, sphere.faces), depth, 1.1),
       // two sheets in a cell: more sheets than cells
       RL::Octree_3(RL::Triangulated_surface_3(two.points, two.faces), depth, 1.1),
       RL::Octree_3(RL::Triangulated_surface_3(sphere.points, normals,
                                               std::vector<double>(normals.size(), 1.)),
                    depth, 1.1)}) {
    const std::size_t sheets = octree.number_of_sheets(depth);
    const std::size_t fragments = in_grid(octree, {depth, no_limit, no_limit})->fragments().size();
    INFO(sheets << " sheets, " << fragments << " fragments");
    CHECK_FALSE(is_refused(octree, sheets, fragments));
    CHECK(is_refused(octree, sheets - 1, fragments));
    CHECK(is_refused(octree, sheets, fragments - 1));
    CHECK(is_refused(octree, 0, fragments));
    CHECK(is_refused(octree, sheets, 0));
  }
  // A square of 16384 x 16384 cells has 2^28 of them, which its area tells before any work.
  const shapes::Triangles square = shapes::rectangle(1, 1);
  const RL::Triangulated_surface_3 surface(square.points, square.faces);
  CHECK_THROWS_AS(RL::Octree_3(surface, 14, 1), RL::Parameter_error);
  static_assert(RL::Octree_3::maximum_number_of_sheets == 1 << 23, "the manual says so");
  static_assert(RL::Octree_3::maximum_number_of_fragments == 1 << 26, "the manual says so");
}

TEST_CASE("matrices_have_at_most_as_many_entries_as_an_int_can_number", "[limits]") {
  constexpr int largest = (std::numeric_limits<int>::max)();
  std::vector<int> counts = {3, 0, largest - 5, 2};
  CHECK(internal::sum_counts(counts.data(), counts.size(), "a", "matrix") == largest);
  CHECK(counts == std::vector<int>{3, 3, largest - 2, largest});
  // sums that an int, and one that 32 bits without a sign cannot hold
  for(const std::vector<int>& too_many :
      {std::vector<int>{3, 0, largest - 5, 3}, {largest, largest, 2}, {largest, largest, 3, 0}}) {
    counts = too_many;
    try {
      internal::sum_counts(counts.data(), counts.size(), "octree_depth", "matrix");
      FAIL("no exception");
    } catch(const RL::Parameter_error& error) {
      CHECK(error.parameter() == "octree_depth");
      CHECK(std::string(error.what()) ==
            "octree_depth gives a matrix of more than 2^31 - 1 entries");
    }
  }
}
