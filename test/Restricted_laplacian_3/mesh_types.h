// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_TEST_MESH_TYPES_H
#define RESTRICTED_LAPLACIAN_3_TEST_MESH_TYPES_H

#include "catch.h"
#include "special_shapes.h"

#include <CGAL/Restricted_laplacian_3/input/vertex_functions.h>
#include <CGAL/Restricted_laplacian_3/solve_poisson.h>

#include <CGAL/boost/graph/copy_face_graph.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <vector>

/// \file
/// One surface in many mesh types.

namespace mesh_types {

namespace RL = CGAL::Restricted_laplacian_3;
namespace params = RL::parameters;

/// An ellipsoid without symmetry between the axes. Its coordinates are multiples of 2^-20, which
/// are numbers of single precision too, so that all kernels hold the same surface.
inline shapes::Triangles surface() {
  shapes::Triangles t = shapes::sphere(3);
  const auto rounded = [](double x) { return std::ldexp(std::round(std::ldexp(x, 20)), -20); };
  for(RL::Point_3& p : t.points)
    p = RL::Point_3(rounded(p.x() + 0.25), rounded(0.8 * p.y() - 0.125 * p.x()),
                    rounded(0.6 * p.z()));
  return t;
}

template <class Target> Target converted(const shapes::Mesh& mesh) {
  Target target;
  CGAL::copy_face_graph(mesh, target);
  return target;
}

inline double right_hand_side(const RL::Surface_point& p) {
  return p.point.x() + 2 * p.point.y() - p.point.z() * p.point.x();
}

/// For each vertex, in the order of `vertices(tm)`, the number of its point among those of
/// `surface()`. Copies and collections of garbage change the order.
inline std::vector<std::size_t> original_numbers(const RL::Triangulated_surface_3& read) {
  std::map<RL::Point_3, std::size_t> numbers;
  for(const RL::Point_3& p : surface().points)
    numbers.emplace(p, numbers.size());
  std::vector<std::size_t> result;
  for(std::size_t v = 0; v < read.number_of_vertices(); ++v) {
    const auto it = numbers.find(read.point(v));
    REQUIRE(it != numbers.end());
    result.push_back(it->second);
  }
  return result;
}

/// values of a vertex map in the order of `vertices(tm)`
template <class FaceGraph, class VertexMap>
std::vector<double> values(const FaceGraph& tm, const VertexMap& map) {
  std::vector<double> result;
  for(auto v : vertices(tm))
    result.push_back(get(map, v));
  return result;
}

/// solution of a Poisson problem at the vertices, in the order of `vertices(tm)`
template <class FaceGraph, class NamedParameters>
std::vector<double> solution(const FaceGraph& tm, const NamedParameters& np) {
  const auto u = get(CGAL::dynamic_vertex_property_t<double>(), tm);
  const RL::Solve_report report = RL::solve_poisson(tm, right_hand_side, u, np);
  CHECK(report.converged);
  return values(tm, u);
}

template <class FaceGraph> std::vector<double> solution(const FaceGraph& tm) {
  return solution(tm, params::depth(3).tolerance(1e-6));
}

/// the solution on a `Surface_mesh` of double precision
inline const std::vector<double>& expected_solution() {
  static const std::vector<double> result = solution(shapes::mesh(surface()));
  return result;
}

/// largest difference, relative to the largest expected value; infinite if there is a NaN
inline double relative_difference(const std::vector<double>& a,
                                  const std::vector<double>& expected) {
  REQUIRE(a.size() == expected.size());
  double difference = 0, scale = 0;
  for(std::size_t i = 0; i < a.size(); ++i) {
    if(!(std::abs(a[i] - expected[i]) <= difference))
      difference = std::isnan(a[i] - expected[i]) ? INFINITY : std::abs(a[i] - expected[i]);
    scale = (std::max)(scale, std::abs(expected[i]));
  }
  return difference / scale;
}

/// The surface, the load of a vertex function, and the solution are those of the `Surface_mesh` of
/// double precision.
template <class FaceGraph> void check_mesh_type(const FaceGraph& tm) {
  const shapes::Triangles expected = surface();
  const RL::Spline_space_3 space(tm, params::depth(3));
  const RL::Triangulated_surface_3& read = space.surface();
  REQUIRE(read.number_of_vertices() == expected.points.size());
  REQUIRE(read.number_of_faces() == expected.faces.size());
  const std::vector<std::size_t> numbers = original_numbers(read);

  // the first corner of a face depends on the type of the mesh, the orientation does not
  const auto starting_with_least = [](std::array<std::size_t, 3> f) {
    std::rotate(f.begin(), std::min_element(f.begin(), f.end()), f.end());
    return f;
  };
  std::set<std::array<std::size_t, 3>> faces, expected_faces;
  for(std::size_t f = 0; f < expected.faces.size(); ++f) {
    const auto &a = read.triangle(f), &b = expected.faces[f];
    faces.insert(starting_with_least({numbers[a[0]], numbers[a[1]], numbers[a[2]]}));
    expected_faces.insert(starting_with_least({b[0], b[1], b[2]}));
  }
  CHECK(faces == expected_faces);

  const auto map = get(CGAL::dynamic_vertex_property_t<double>(), tm);
  const auto function = [](const RL::Point_3& p) { return 1 + p.x() * p.y(); };
  std::size_t i = 0;
  for(auto v : vertices(tm))
    put(map, v, function(read.point(i++)));
  double integral = 0;
  for(const auto& f : expected.faces) {
    const RL::Point_3 &a = expected.points[f[0]], &b = expected.points[f[1]],
                      &c = expected.points[f[2]];
    integral +=
        std::sqrt(CGAL::squared_area(a, b, c)) / 3 * (function(a) + function(b) + function(c));
  }
  CHECK(RL::assemble_load(space, RL::vertex_function(tm, map)).sum() ==
        Approx(integral).epsilon(1e-13));

  const std::vector<double> u = solution(tm);
  std::vector<double> in_original_order(u.size());
  for(std::size_t v = 0; v < u.size(); ++v)
    in_original_order[numbers[v]] = u[v];
  CHECK(relative_difference(in_original_order, expected_solution()) <= 1e-9);
}

} // namespace mesh_types

#endif // RESTRICTED_LAPLACIAN_3_TEST_MESH_TYPES_H
