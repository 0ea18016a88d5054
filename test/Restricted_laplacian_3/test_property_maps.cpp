// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Results do not depend on the types of the property maps, nor on types and order of the named
// parameters.

#include "mesh_types.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Restricted_laplacian_3/fit_function.h>
#include <CGAL/Restricted_laplacian_3/input/read_surface.h>
#include <CGAL/Restricted_laplacian_3/input/vertex_functions.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <vector>

// names of this package as a later CGAL may define them
namespace CGAL {
namespace internal_np {
enum cycle_t { cycle };
enum pose_t { pose };
enum smoother_t { smoother };
} // namespace internal_np
namespace parameters {
constexpr int cycle = 1, pose = 2, smoother = 3;
} // namespace parameters
} // namespace CGAL

namespace {

using namespace mesh_types;
using shapes::Mesh;
using Vertex = Mesh::Vertex_index;

/// a point map that computes points of another kernel when it is asked for them
struct Computed_point_map {
  using key_type = Vertex;
  using value_type = CGAL::Exact_predicates_exact_constructions_kernel::Point_3;
  using reference = CGAL::Exact_predicates_exact_constructions_kernel::Point_3;
  using category = boost::readable_property_map_tag;

  const std::vector<RL::Point_3>* points;

  friend value_type get(const Computed_point_map& map, Vertex v) {
    const RL::Point_3& p = (*map.points)[v];
    return {p.x(), p.y(), p.z()};
  }
};

/// a map that can only be written
struct Output_map {
  using key_type = Vertex;
  using value_type = double;
  using reference = void;
  using category = boost::writable_property_map_tag;

  std::vector<double>* values;

  friend void put(const Output_map& map, Vertex v, double value) { (*map.values)[v] = value; }
};

/// the connectivity of the surface with points that are not numbers
Mesh mesh_without_points() {
  Mesh mesh = shapes::mesh(surface());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for(Vertex v : mesh.vertices())
    mesh.point(v) = RL::Point_3(nan, nan, nan);
  return mesh;
}

} // namespace

TEST_CASE("points_come_from_the_vertex_point_map", "[mesh_types]") {
  Mesh mesh = mesh_without_points();
  const std::vector<RL::Point_3> points = surface().points;
  const auto check = [&mesh](const auto& map) {
    const auto np = params::depth(3).tolerance(1e-6).vertex_point_map(map);
    CHECK(solution(mesh, np) == expected_solution());
  };

  check(Computed_point_map{&points});

  std::map<Vertex, RL::Point_3> points_of;
  const auto single =
      mesh.add_property_map<Vertex, CGAL::Simple_cartesian<float>::Point_3>("v:single").first;
  for(Vertex v : mesh.vertices()) {
    const RL::Point_3& p = points[v];
    points_of[v] = p;
    single[v] = {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())};
  }
  check(boost::const_associative_property_map<std::map<Vertex, RL::Point_3>>(points_of));
  check(single);
}

TEST_CASE("parameters_may_come_in_any_order", "[mesh_types]") {
  const Mesh mesh = mesh_without_points();
  const std::vector<RL::Point_3> points = surface().points;
  const Computed_point_map map{&points};
  const double extent = RL::read_surface(mesh, params::vertex_point_map(map)).extent();
  const auto check = [&](const auto& np) {
    const RL::Spline_space_3 space(mesh, np);
    CHECK(space.surface().point(17) == points[17]);
    CHECK(space.depth() == 2);
    CHECK(space.octree().side() == 1.5 * extent);
    CHECK(space.is_paper_space());
    const RL::Poisson_solver_options options =
        RL::Poisson_solver(space, RL::assemble_operators(space), 0, np).options();
    CHECK(options.tolerance == 1e-4);
    CHECK(options.energy_tolerance == 0.25);
    CHECK(options.maximum_iterations == 7);
    CHECK(options.cycle == RL::Cycle::W);
    CHECK(options.smoothing_steps == 3);
    CHECK(options.stand_alone_multigrid);
  };
  // those of CGAL first, last, and among those of this package; the last value of a name counts
  const auto w = RL::Cycle::W;
  check(params::vertex_point_map(map)
            .depth(2)
            .cube_scale(1.5)
            .maximum_iterations(7)
            .paper(true)
            .tolerance(1e-4)
            .energy_tolerance(0.25)
            .cycle(w)
            .smoothing_steps(3)
            .stand_alone_multigrid(true));
  const auto solver = params::stand_alone_multigrid(true)
                          .smoothing_steps(3)
                          .cycle(w)
                          .tolerance(1e-4)
                          .energy_tolerance(0.25);
  check(solver.paper(true).depth(2).cube_scale(1.5).maximum_iterations(7).vertex_point_map(map));
  check(solver.depth(5).maximum_iterations(7).vertex_point_map(map).depth(2).paper(true).cube_scale(
      1.5));
  check(params::default_values()
            .vertex_point_map(map)
            .paper(true)
            .depth(2)
            .cycle(w)
            .smoothing_steps(3)
            .tolerance(1e-4)
            .energy_tolerance(0.25)
            .maximum_iterations(7)
            .cube_scale(1.5)
            .stand_alone_multigrid(true));
}

TEST_CASE("chains_are_named_parameters_of_cgal_and_take_them", "[mesh_types]") {
  const Mesh mesh = mesh_without_points();
  const std::vector<RL::Point_3> points = surface().points;
  const Computed_point_map map{&points};
  // a chain of CGAL alone
  CHECK(RL::read_surface(mesh, CGAL::parameters::vertex_point_map(map)).point(17) == points[17]);
  // a function of CGAL
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(
      mesh, params::depth(2).vertex_point_map(map).cube_scale(1.2));
  CHECK(box.x_span() > 0);
  // what cannot be copied, or shall not be, is passed by reference
  int calls = 0;
  auto callback = [&calls](double) { return ++calls > 0; };
  const auto np = params::progress(std::ref(callback)).depth(1);
  CHECK(params::get_parameter(np, RL::internal_np::progress)(0.5));
  CHECK(calls == 1);
}

TEST_CASE("types_of_parameters_may_differ_from_those_of_the_defaults", "[mesh_types]") {
  const Mesh mesh = shapes::mesh(surface());
  const auto dimension = [&mesh](const auto& np) {
    return RL::Spline_space_3(mesh, np).dimension();
  };
  const std::size_t expected = dimension(params::depth(3).cube_scale(2.));
  CHECK(dimension(params::depth(std::size_t(3)).cube_scale(2)) == expected);
  CHECK(dimension(params::depth(short(3)).cube_scale(2.f)) == expected);
  CHECK(RL::Spline_space_3(mesh).depth() == 5);
}

TEST_CASE("solution_is_written_into_any_writable_map", "[mesh_types]") {
  Mesh mesh = shapes::mesh(surface());
  const std::vector<double> expected = solution(mesh, params::depth(3));

  const auto single = mesh.add_property_map<Vertex, float>("v:single").first;
  static_cast<void>(RL::solve_poisson(mesh, right_hand_side, single, params::depth(3)));
  for(Vertex v : mesh.vertices())
    REQUIRE(single[v] == static_cast<float>(expected[v]));

  std::map<Vertex, double> associative;
  static_cast<void>(RL::solve_poisson(
      mesh, right_hand_side, boost::associative_property_map<std::map<Vertex, double>>(associative),
      params::depth(3)));
  REQUIRE(associative.size() == expected.size());
  for(const auto& [v, value] : associative)
    REQUIRE(value == expected[v]);

  std::vector<double> written(expected.size());
  static_cast<void>(
      RL::solve_poisson(mesh, right_hand_side, Output_map{&written}, params::depth(3)));
  CHECK(written == expected);
}

TEST_CASE("right_hand_side_is_read_from_any_readable_map", "[mesh_types]") {
  Mesh mesh = shapes::mesh(surface());
  const auto of_float = mesh.add_property_map<Vertex, float>("v:float").first;
  const auto of_int = mesh.add_property_map<Vertex, int>("v:int").first;
  std::map<Vertex, double> associative;
  for(Vertex v : mesh.vertices()) {
    of_int[v] = static_cast<int>(v) % 7;
    of_float[v] = static_cast<float>(of_int[v]);
    associative[v] = of_int[v];
  }
  const auto solve = [&mesh](const auto& f) {
    std::vector<double> result(mesh.number_of_vertices());
    static_cast<void>(RL::solve_poisson(mesh, f, Output_map{&result}, params::depth(3)));
    return result;
  };
  const std::vector<double> expected = solve(RL::vertex_function(mesh, of_int));
  CHECK(solve(of_int) == expected);
  CHECK(solve(of_float) == expected);
  CHECK(solve(boost::const_associative_property_map<std::map<Vertex, double>>(associative)) ==
        expected);
}

TEST_CASE("functions_are_read_by_vertex_corner_and_face", "[mesh_types]") {
  Mesh mesh = shapes::mesh(surface());
  const auto by_vertex = mesh.add_property_map<Vertex, double>("v:f").first;
  const auto by_halfedge = mesh.add_property_map<Mesh::Halfedge_index, double>("h:f").first;
  const auto by_face = mesh.add_property_map<Mesh::Face_index, float>("f:f").first;
  for(Vertex v : mesh.vertices())
    by_vertex[v] = static_cast<int>(v) % 7;
  for(const auto f : mesh.faces()) {
    by_face[f] = static_cast<float>(static_cast<int>(f) % 5);
    for(const auto h : CGAL::halfedges_around_face(mesh.halfedge(f), mesh))
      by_halfedge[h] = by_vertex[mesh.target(h)] + by_face[f];
  }
  const auto np = params::depth(3).tolerance(1e-9);
  const auto solve = [&](const auto& f) {
    std::vector<double> result(mesh.number_of_vertices());
    CHECK(RL::solve_screened_poisson(mesh, f, 2, Output_map{&result}, np).converged);
    return result;
  };
  const auto fit = [&](const auto& f) {
    std::vector<double> result(mesh.number_of_vertices());
    // the error of a fit may be as large as what it leaves, unless that does not count
    CHECK(RL::fit_function(mesh, f, Output_map{&result},
                           params::depth(3).tolerance(1e-9).energy_tolerance(0).stabilization(1e-3))
              .converged);
    return result;
  };
  const auto check = [&](const auto& operation) {
    const std::vector<double> of_vertices = operation(by_vertex), of_faces = operation(by_face),
                              of_corners = operation(by_halfedge);
    double largest = 0, error = 0;
    for(std::size_t i = 0; i < of_corners.size(); ++i) {
      largest = (std::max)(largest, std::abs(of_corners[i]));
      error = (std::max)(error, std::abs(of_vertices[i] + of_faces[i] - of_corners[i]));
    }
    CHECK(error <= 1e-6 * largest);
    // constant on each face, as a function object
    const std::vector<double> expected = operation(RL::Face_function<double>([&] {
      std::vector<double> values;
      for(const auto f : mesh.faces())
        values.push_back(by_face[f]);
      return values;
    }()));
    CHECK(of_faces == expected);
  };
  check(solve);
  check(fit);
}
