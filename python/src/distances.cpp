// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Distances along surfaces.

#include "module.h"

#include <CGAL/Restricted_laplacian_3/surface/Geodesic_solver.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace python {
namespace {

using namespace nb::literals;
using Integers = nb::ndarray<const std::int64_t, nb::ndim<1>, nb::c_contig, nb::device::cpu>;

// What is negative, or does not exist, the library refuses.
std::size_t index_of(std::int64_t i) { return static_cast<std::size_t>(i); }

RL::Surface_location location_of(std::int64_t face, const double* barycentric) {
  return {index_of(face), {barycentric[0], barycentric[1], barycentric[2]}};
}

void check_width(const Rows& a, std::size_t rows, const char* name) {
  if(a.shape(0) != rows || a.shape(1) != 3)
    throw RL::Parameter_error(name, "must have three barycentric coordinates for each face");
}

// Labels are those of vertices, of segments, and of the boundary, one after the other.
RL::Geodesic_sources sources_of(const Integers& vertices, const Integers& faces, const Rows& from,
                                const Rows& to, bool boundary, const Integers& labels) {
  check_width(from, faces.size(), "barycentric");
  check_width(to, faces.size(), "barycentric");
  if(labels.size() != vertices.size() + faces.size() + (boundary ? 1 : 0))
    throw RL::Parameter_error("labels", "must have one number for each source");
  RL::Geodesic_sources sources;
  const std::int64_t* label = labels.data();
  const auto next_label = [&label] {
    if(*label < 0 || *label >= std::int64_t(RL::Geodesic_distances::no_label))
      throw RL::Parameter_error("labels", "must be numbers from 0 to 2^32 - 2");
    return static_cast<std::uint32_t>(*label++);
  };
  for(std::size_t i = 0; i < vertices.size(); ++i)
    sources.add_vertex(index_of(vertices.data()[i]), next_label());
  for(std::size_t i = 0; i < faces.size(); ++i) {
    const std::int64_t face = faces.data()[i];
    sources.add_segment(location_of(face, from.data() + 3 * i),
                        location_of(face, to.data() + 3 * i), next_label());
  }
  if(boundary)
    sources.add_boundary(next_label());
  return sources;
}

RL::Geodesic_solver make_solver(const RL::Triangulated_surface_3& surface) {
  const nb::gil_scoped_release release;
  return RL::Geodesic_solver(surface);
}

nb::tuple distances(const RL::Geodesic_solver& solver, const Integers& vertices,
                    const Integers& faces, const Rows& from, const Rows& to, bool boundary,
                    const Integers& labels, bool exact) {
  const RL::Geodesic_sources sources = sources_of(vertices, faces, from, to, boundary, labels);
  RL::Geodesic_distances found;
  std::vector<double> directions;
  std::vector<std::int64_t> nearest;
  {
    const nb::gil_scoped_release release;
    found =
        solver.distances(sources, exact ? RL::Geodesic_method::exact : RL::Geodesic_method::fast);
    for(const RL::Vector_3& d : found.directions)
      for(int axis = 0; axis < 3; ++axis)
        directions.push_back(d[axis]);
    for(const std::uint32_t label : found.labels)
      nearest.push_back(label == RL::Geodesic_distances::no_label ? -1 : std::int64_t(label));
  }
  return nb::make_tuple(array_of_rows(std::move(found.distances), 1),
                        array_of_rows(std::move(directions), 3),
                        array_of_rows(std::move(nearest), 1));
}

nb::object farthest_points(const RL::Geodesic_solver& solver, std::int64_t number,
                           const Integers& vertices) {
  if(number < 0)
    throw RL::Parameter_error("number", "must not be negative");
  std::vector<std::int64_t> result;
  RL::Geodesic_sources sources;
  for(std::size_t i = 0; i < vertices.size(); ++i)
    sources.add_vertex(index_of(vertices.data()[i]));
  {
    const nb::gil_scoped_release release;
    for(const std::size_t v : solver.farthest_points(index_of(number), sources))
      result.push_back(static_cast<std::int64_t>(v));
  }
  return array_of_rows(std::move(result), 1);
}

} // namespace

void add_distances(nb::module_& m) {
  nb::class_<RL::Geodesic_solver>(m, "GeodesicSolver")
      .def_static("make", &make_solver, "surface"_a)
      .def("distances", &distances, "vertices"_a, "faces"_a, "from_"_a, "to"_a, "boundary"_a,
           "labels"_a, "exact"_a)
      .def("farthest_points", &farthest_points, "number"_a, "vertices"_a);
}

} // namespace python
