// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// What would fill the memory is refused before any work, and more than an int can number exactly
// from the limit on.

#include "catch.h"
#include "special_shapes.h"

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/explain_out_of_memory.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parameters.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/sum_counts.h>
#include <CGAL/Restricted_laplacian_3/foundation/memory.h>
#include <CGAL/Restricted_laplacian_3/patches/curved_surface.h>
#include <CGAL/Restricted_laplacian_3/problems/space_spectrum.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>
#include <CGAL/Restricted_laplacian_3/splines/estimate_memory.h>

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <limits>
#include <new>
#include <string>
#include <tuple>
#include <vector>

namespace {

namespace RL = CGAL::Restricted_laplacian_3;
namespace internal = CGAL::Restricted_laplacian_3::internal;

RL::Triangulated_surface_3 surface_of(const shapes::Triangles& t) {
  return RL::Triangulated_surface_3(t.points, t.faces);
}

RL::Spline_space_options options(int depth, double maximum_memory) {
  RL::Spline_space_options o;
  o.depth = depth;
  o.maximum_memory = maximum_memory;
  return o;
}

/// the message with which a space is refused; empty if it is not
std::string refusal(const RL::Triangulated_surface_3& surface,
                    const RL::Spline_space_options& options) {
  try {
    RL::Spline_space_3(surface, options);
    return "";
  } catch(const RL::Parameter_error& error) {
    CHECK(error.parameter() == "depth");
    return error.what();
  }
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

} // namespace

TEST_CASE("memory_of_the_machine_is_known", "[limits]") {
  const double memory = RL::memory_of_machine();
  CHECK(memory > 1e8);
#ifdef __linux__
  std::ifstream info("/proc/meminfo");
  std::string name;
  double kilobytes = 0;
  REQUIRE(info >> name >> kilobytes);
  REQUIRE(name == "MemTotal:");
  CHECK(memory <= 1024 * kilobytes);
#endif
  CHECK(internal::memory_text(0) == "0.0 MB");
  CHECK(internal::memory_text(9.96e6) == "10 MB");
  CHECK(internal::memory_text(123.4e6) == "123 MB");
  CHECK(internal::memory_text(1.26e9) == "1.3 GB");
  CHECK(internal::memory_text(24.4e9) == "24 GB");
}

TEST_CASE("the_number_of_unknowns_is_estimated_from_normals", "[limits]") {
  const auto check = [](const RL::Triangulated_surface_3& surface, int depth, double tolerance,
                        double cube_scale = 1.1) {
    RL::Spline_space_options o;
    o.depth = depth;
    o.cube_scale = cube_scale;
    const RL::Spline_space_3 space(surface, o);
    CHECK(RL::estimate_memory(surface, depth, cube_scale).dimension ==
          Approx(static_cast<double>(space.dimension())).epsilon(tolerance));
  };
  const RL::Triangulated_surface_3 sphere = surface_of(shapes::sphere(4));
  check(sphere, 5, 0.05);
  check(sphere, 7, 0.02);
  check(sphere, 6, 0.05, 2.5);
  check(surface_of(shapes::sphere(0)), 7, 0.02);
  check(surface_of(shapes::box(1, 0.5, 0.25, 4, 1)), 7, 0.1);
  shapes::Triangles tilted = shapes::rectangle(3, 1);
  for(RL::Point_3& p : tilted.points)
    p = p + RL::Vector_3(0, 0, 0.3 * p.x());
  check(surface_of(tilted), 7, 0.1);
  check(surface_of(shapes::rectangle(3, 1)), 7,
        0.4); // in a wall: two unknowns in a cell, not three
  check(RL::curved_surface(surface_of(shapes::sphere(3))), 6, 0.05);
  // points: never more cells than points
  std::vector<RL::Point_3> points;
  std::vector<RL::Vector_3> normals;
  for(std::size_t v = 0; v < sphere.number_of_vertices(); ++v) {
    points.push_back(sphere.point(v));
    normals.push_back(points.back() - CGAL::ORIGIN);
  }
  const std::vector<double> areas(points.size(),
                                  sphere.area() / static_cast<double>(points.size()));
  const RL::Triangulated_surface_3 cloud(points, normals, areas);
  check(cloud, 4, 0.15);
  CHECK(RL::estimate_memory(cloud, 12).dimension == 3 * points.size());
}

TEST_CASE("spaces_that_are_too_large_for_the_memory_are_refused", "[limits]") {
  const RL::Triangulated_surface_3 sphere = surface_of(shapes::sphere(3));
  const auto total = [&](int depth) {
    const RL::Memory_estimate estimate = RL::estimate_memory(sphere, depth);
    CHECK(estimate.total() == estimate.surface + estimate.solver);
    return estimate.total();
  };
  CHECK(total(6) > 3.9 * (total(5) - RL::estimate_memory(sphere, 5).surface));
  CHECK(refusal(sphere, options(5, total(5))).empty());
  const std::string message = refusal(sphere, options(5, 0.99 * total(5)));
  INFO(message);
  CHECK(contains(message, "depth is 5, which would take about " + internal::memory_text(total(5)) +
                              " of memory"));
  CHECK(contains(message, internal::memory_text(0.99 * total(5)) + " are there"));
  CHECK(contains(message, "a depth of 4 would take " + internal::memory_text(total(4))));
  CHECK(contains(refusal(sphere, options(9, total(5))), "a depth of 5 would take"));
  CHECK(contains(refusal(sphere, options(3, 1000)), "the surface itself takes"));
  for(int depth : {-3, 0, 21, 70, 1000000})
    CHECK(contains(refusal(sphere, options(depth, 1e6)), ", but must be in 1 .. 20"));
  // A square of 2^20 x 2^20 cells: before any work, with the memory of the machine.
  const RL::Triangulated_surface_3 square = surface_of(shapes::rectangle(1, 1));
  RL::Spline_space_options o;
  o.depth = 20;
  o.cube_scale = 1;
  CHECK(contains(refusal(square, o), "depth is 20"));
  CHECK(contains(refusal(RL::curved_surface(square), o), "depth is 20"));
  for(double maximum : {0., -1., std::numeric_limits<double>::quiet_NaN()})
    CHECK_THROWS_AS(RL::Spline_space_3(sphere, options(3, maximum)), RL::Parameter_error);
  CHECK(refusal(sphere, options(3, std::numeric_limits<double>::infinity())).empty());
  // as a named parameter
  CHECK_THROWS_AS(RL::Spline_space_3(sphere, RL::parameters::depth(4).maximum_memory(1e4)),
                  RL::Parameter_error);
}

TEST_CASE("memory_of_many_small_triangles_is_that_of_their_parts", "[limits]") {
  const RL::Triangulated_surface_3 sphere = surface_of(shapes::sphere(6));
  const auto faces = static_cast<double>(sphere.number_of_faces());
  // what is less than a part for each triangle cannot be right, whatever the depth
  const double least = 100 * faces, at_least_one = RL::estimate_memory(sphere, 1).solver;
  CHECK(at_least_one > least);
  CHECK(at_least_one < 2 * least);
  for(int depth = 2; depth < 9; ++depth)
    CHECK(RL::estimate_memory(sphere, depth).total() >
          RL::estimate_memory(sphere, depth - 1).total());
}

TEST_CASE("pairs_that_are_too_many_for_the_memory_are_refused", "[limits]") {
  const RL::Triangulated_surface_3 sphere = surface_of(shapes::sphere(6));
  const int depth = 3, k = 100;
  const double of_space = RL::estimate_memory(sphere, depth).total(),
               at_vertices = 8. * k * static_cast<double>(sphere.number_of_vertices());
  RL::Laplace_spectrum_options of_spectrum;
  const auto refusal_of_pairs = [&](double memory) -> std::string {
    const RL::Spline_space_3 space(sphere, options(depth, memory));
    bool is_called = false;
    of_spectrum.multigrid.progress = [&](double) { return is_called = true; };
    try {
      RL::laplace_spectrum(space, k, of_spectrum);
      return "";
    } catch(const RL::Parameter_error& error) {
      CHECK(error.parameter() == "count");
      CHECK_FALSE(is_called);
      return error.what();
    }
  };
  const double memory = of_space + at_vertices / 2;
  const std::string message = refusal_of_pairs(memory);
  INFO(message);
  CHECK(contains(message, "count is 100, which would take about "));
  CHECK(contains(message, "and " + internal::memory_text(memory) + " are there; "));
  CHECK(contains(message, " would fit; without values at the vertices they would take "));
  CHECK(refusal_of_pairs(2 * of_space + 2 * at_vertices).empty());
  // without values at the vertices they do fit
  const RL::Spline_space_3 space(sphere, options(depth, memory));
  CHECK(RL::laplace_eigenpairs(space, k).eigenvalues.size() == k);
  of_spectrum.eigenvalues_only = true;
  CHECK(refusal_of_pairs(memory).empty());
  // what fits is as said
  const int possible = std::stoi(message.substr(message.find("are there; ") + 11));
  CHECK(RL::laplace_spectrum(space, possible).vertex_values.cols() == possible);
  CHECK_THROWS_AS(RL::laplace_spectrum(space, possible + 1), RL::Parameter_error);
  // the matrices alone
  of_spectrum.eigenvalues_only = false;
  const RL::Spline_space_3 fine(sphere, options(6, RL::estimate_memory(sphere, 6).total()));
  try {
    RL::laplace_eigenpairs(fine, 1);
    FAIL("no exception");
  } catch(const RL::Parameter_error& error) {
    INFO(error.what());
    CHECK(contains(error.what(), "count is 1, which would take about "));
    CHECK(contains(error.what(), "; not even one would fit: choose a smaller depth"));
    CHECK_FALSE(contains(error.what(), "without values"));
  }
}

TEST_CASE("surfaces_have_as_many_faces_as_can_be_numbered", "[limits]") {
  constexpr std::size_t most = RL::Triangulated_surface_3::maximum_number_of_faces;
  CHECK(3 * most <= (std::numeric_limits<std::uint32_t>::max)());
  internal::check_size_of_surface(most, most);
  for(const auto& [vertices, faces, word] :
      {std::make_tuple(most + 1, most, " vertices"), {most, most + 1, " faces"}}) {
    std::string message;
    try {
      internal::check_size_of_surface(vertices, faces);
    } catch(const RL::Parameter_error& error) {
      message = error.what();
    }
    CHECK(message ==
          "surface has 1431655766" + std::string(word) + ", but can have at most 1431655765");
  }
}

TEST_CASE("a_step_without_memory_has_a_name", "[limits]") {
  const auto fails = []() -> int { throw std::bad_alloc(); };
  CHECK(internal::explain_out_of_memory("a", [] { return 7; }) == 7);
  try {
    internal::explain_out_of_memory(
        "the outer one", [&] { return internal::explain_out_of_memory("the step", fails); });
    FAIL("no exception");
  } catch(const std::bad_alloc& error) {
    CHECK(std::string(error.what()) == "the step");
    CHECK(dynamic_cast<const RL::Out_of_memory*>(&error) != nullptr);
  }
  CHECK_THROWS_AS(internal::explain_out_of_memory("a", [] { throw RL::Canceled(); }), RL::Canceled);
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
      internal::sum_counts(counts.data(), counts.size(), "depth", "matrix");
      FAIL("no exception");
    } catch(const RL::Parameter_error& error) {
      CHECK(error.parameter() == "depth");
      CHECK(std::string(error.what()) == "depth gives a matrix of more than 2^31 - 1 entries");
    }
  }
}
