// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Distances along surfaces.

#include "module.h"

#include <CGAL/Restricted_laplacian_3/geodesics/Geodesic_function.h>
#include <CGAL/Restricted_laplacian_3/geodesics/Geodesic_solver.h>
#include <CGAL/Restricted_laplacian_3/problems/Geodesic_fitter.h>

#include <nanobind/stl/optional.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
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

RL::Geodesic_solver make_solver(const RL::Triangulated_surface_3& surface,
                                std::optional<double> joining_tolerance) {
  const nb::gil_scoped_release release;
  return RL::Geodesic_solver(surface, joining_tolerance);
}

// How distances are computed: what all queries take.
struct Query {
  bool exact = false;
  std::optional<double> maximum_memory, maximum_distance;
  int threads = 1;
  nb::object progress;

  template <class Work> auto run(Work&& work) const {
    RL::Geodesic_options options(exact ? RL::Geodesic_method::exact : RL::Geodesic_method::fast);
    options.maximum_memory = maximum_memory;
    options.maximum_distance = maximum_distance;
    options.is_parallel = threads != 1;
    return python::run(threads, progress, [&](const std::function<bool(double)>& callback) {
      options.progress = callback;
      return work(options);
    });
  }
};

nb::tuple distances(const RL::Geodesic_solver& solver, const Integers& vertices,
                    const Integers& faces, const Rows& from, const Rows& to, bool boundary,
                    const Integers& labels, const Query& query) {
  const RL::Geodesic_sources sources = sources_of(vertices, faces, from, to, boundary, labels);
  RL::Geodesic_distances found =
      query.run([&](const auto& options) { return solver.distances(sources, options); });
  std::vector<double> directions;
  std::vector<std::int64_t> nearest;
  {
    const nb::gil_scoped_release release;
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

nb::object signed_distances(const RL::Geodesic_solver& solver, const Numbers& values,
                            const Query& query) {
  const std::vector<double> own(values.data(), values.data() + values.size());
  return array_of_rows(query.run([&](const auto& options) {
    return solver.signed_distances(own, options).distances;
  }),
                       1);
}

// vertices, and points in faces
struct Places {
  Places(const Integers& v, const Integers& faces, const Rows& barycentric)
    : vertices(v.data(), v.data() + v.size()) {
    check_width(barycentric, faces.size(), "barycentric");
    for(std::size_t i = 0; i < faces.size(); ++i)
      locations.push_back(location_of(faces.data()[i], barycentric.data() + 3 * i));
  }

  std::size_t size() const { return vertices.size() + locations.size(); }
  // each alone
  std::vector<RL::Geodesic_sources> sources() const {
    std::vector<RL::Geodesic_sources> result;
    for(const std::size_t v : vertices)
      result.push_back(RL::Geodesic_sources::vertex(v));
    for(const RL::Surface_location& location : locations)
      result.emplace_back().add_location(location);
    return result;
  }
  std::vector<RL::Surface_location> all_locations(const RL::Geodesic_solver& solver) const {
    std::vector<RL::Surface_location> result;
    for(const std::size_t v : vertices)
      result.push_back(solver.location(v));
    result.insert(result.end(), locations.begin(), locations.end());
    return result;
  }

  std::vector<std::size_t> vertices;
  std::vector<RL::Surface_location> locations;
};

// One row after the other; to all vertices, without targets.
nb::object distance_matrix(const RL::Geodesic_solver& solver, const Places& from,
                           const std::optional<Places>& to, const Query& query) {
  const std::vector<RL::Geodesic_sources> sources = from.sources();
  std::vector<double> found = query.run([&](const auto& options) {
    if(!to)
      return solver.distance_matrix(sources, options);
    return to->locations.empty()
               ? solver.distance_matrix(sources, to->vertices, options)
               : solver.distance_matrix(sources, to->all_locations(solver), options);
  });
  return array_of_rows(std::move(found), 1);
}

// (where rows begin, vertices, distances)
nb::tuple near_vertices(const RL::Geodesic_solver& solver, const Places& from,
                        double maximum_distance, const Query& query) {
  const std::vector<RL::Geodesic_sources> sources = from.sources();
  const std::vector<RL::Near_vertices> found = query.run([&](const auto& options) {
    return solver.near_vertices(sources, maximum_distance, options);
  });
  std::vector<std::int64_t> first = {0}, columns;
  std::vector<double> distances;
  for(const RL::Near_vertices& row : found) {
    columns.insert(columns.end(), row.vertices.begin(), row.vertices.end());
    distances.insert(distances.end(), row.distances.begin(), row.distances.end());
    first.push_back(static_cast<std::int64_t>(columns.size()));
  }
  return nb::make_tuple(array_of_rows(std::move(first), 1), array_of_rows(std::move(columns), 1),
                        array_of_rows(std::move(distances), 1));
}

// Distances with directions, as a function on the surface; `spline` is that of a space, or nothing.
class Distance_function {
public:
  explicit Distance_function(RL::Geodesic_function function) : m_function(std::move(function)) {}

  nb::object vertex_values() const {
    return array_of_rows(std::vector<double>(m_function.distances().distances), 1);
  }
  explicit Distance_function(RL::Geodesic_spline spline)
    : m_function(spline.function()), m_spline(std::move(spline)) {}

  nb::object values(const Integers& faces, const Rows& barycentric) const {
    return evaluate<1>(faces, barycentric, [this](const RL::Surface_location& l, double* value) {
      *value = m_spline ? m_spline->value(l) : m_function.value(l);
    });
  }
  nb::object gradients(const Integers& faces, const Rows& barycentric) const {
    return evaluate<3>(faces, barycentric, [this](const RL::Surface_location& l, double* value) {
      const RL::Vector_3 g = m_spline ? m_spline->gradient(l) : m_function.gradient(l);
      for(int axis = 0; axis < 3; ++axis)
        value[axis] = g[axis];
    });
  }
  nb::tuple shortest_path(std::int64_t face, const Rows& barycentric) const {
    check_width(barycentric, 1, "barycentric");
    RL::Geodesic_path path;
    {
      const nb::gil_scoped_release release;
      path = m_function.shortest_path(location_of(face, barycentric.data()));
    }
    return line(path);
  }
  nb::list isolines(double value) const {
    std::vector<RL::Geodesic_path> lines;
    {
      const nb::gil_scoped_release release;
      lines = m_function.isolines(value);
    }
    nb::list result;
    for(const RL::Geodesic_path& path : lines)
      result.append(line(path));
    return result;
  }

private:
  template <int K, class Evaluate>
  nb::object evaluate(const Integers& faces, const Rows& barycentric, Evaluate&& at) const {
    check_width(barycentric, faces.size(), "barycentric");
    std::vector<double> result(K * faces.size());
    {
      const nb::gil_scoped_release release;
      for(std::size_t i = 0; i < faces.size(); ++i)
        at(location_of(faces.data()[i], barycentric.data() + 3 * i), result.data() + K * i);
    }
    return array_of_rows(std::move(result), K);
  }

  // its points, the faces of its segments, and barycentric coordinates of both of their ends
  static nb::tuple line(const RL::Geodesic_path& path) {
    std::vector<double> points, from, to;
    std::vector<std::int64_t> faces;
    for(const RL::Point_3& p : path.points)
      for(int axis = 0; axis < 3; ++axis)
        points.push_back(p[axis]);
    for(const auto& segment : path.segments) {
      faces.push_back(static_cast<std::int64_t>(segment.from.face));
      from.insert(from.end(), segment.from.barycentric.begin(), segment.from.barycentric.end());
      to.insert(to.end(), segment.to.barycentric.begin(), segment.to.barycentric.end());
    }
    return nb::make_tuple(array_of_rows(std::move(points), 3), path.length,
                          array_of_rows(std::move(faces), 1), array_of_rows(std::move(from), 3),
                          array_of_rows(std::move(to), 3));
  }

  RL::Geodesic_function m_function;
  std::optional<RL::Geodesic_spline> m_spline;
};

Distance_function distance_function(const RL::Geodesic_solver& solver, const Integers& vertices,
                                    const Integers& faces, const Rows& from, const Rows& to,
                                    bool boundary, const Integers& labels, const Query& query,
                                    const RL::Geodesic_fitter* fitter) {
  const RL::Geodesic_sources sources = sources_of(vertices, faces, from, to, boundary, labels);
  RL::Geodesic_distances found =
      query.run([&](const auto& options) { return solver.distances(sources, options); });
  const nb::gil_scoped_release release;
  const RL::Geodesic_function function(solver, std::move(found));
  return fitter ? Distance_function(fitter->fit(function)) : Distance_function(function);
}

RL::Geodesic_fitter make_fitter(const RL::Spline_space_3& space, int threads) {
  RL::Geodesic_fit_options options;
  options.solver.is_parallel = true;
  return run(threads, nb::none(), [&](const auto&) { return RL::Geodesic_fitter(space, options); });
}

// whether each vertex has a face
nb::object have_faces(const RL::Geodesic_solver& solver) {
  std::vector<std::int64_t> result;
  for(std::size_t v = 0; v < solver.surface().number_of_vertices(); ++v)
    result.push_back(solver.has_face(v));
  return array_of_rows(std::move(result), 1);
}

nb::tuple location_of_vertex(const RL::Geodesic_solver& solver, std::int64_t v) {
  const RL::Surface_location location = solver.location(index_of(v));
  std::vector<double> barycentric(location.barycentric.begin(), location.barycentric.end());
  return nb::make_tuple(static_cast<std::int64_t>(location.face),
                        array_of_rows(std::move(barycentric), 3));
}

nb::object farthest_points(const RL::Geodesic_solver& solver, std::int64_t number,
                           const Integers& vertices, const Query& query) {
  if(number < 0)
    throw RL::Parameter_error("number", "must not be negative");
  std::vector<std::int64_t> result;
  RL::Geodesic_sources sources;
  for(std::size_t i = 0; i < vertices.size(); ++i)
    sources.add_vertex(index_of(vertices.data()[i]));
  for(const std::size_t v : query.run([&](const auto& options) {
        return solver.farthest_points(index_of(number), sources, options);
      }))
    result.push_back(static_cast<std::int64_t>(v));
  return array_of_rows(std::move(result), 1);
}

} // namespace

void add_distances(nb::module_& m) {
  nb::class_<Query>(m, "DistanceQuery")
      .def(
          "__init__",
          [](Query* query, bool exact, std::optional<double> maximum_memory,
             std::optional<double> maximum_distance, int threads, nb::object progress) {
            new(query) Query{exact, maximum_memory, maximum_distance, threads, std::move(progress)};
          },
          "exact"_a, "maximum_memory"_a.none(), "maximum_distance"_a.none(), "threads"_a,
          "progress"_a.none());
  nb::class_<Places>(m, "Places")
      .def(nb::init<const Integers&, const Integers&, const Rows&>(), "vertices"_a, "faces"_a,
           "barycentric"_a);
  nb::class_<RL::Geodesic_fitter>(m, "GeodesicFitter")
      .def_static("make", &make_fitter, "space"_a, "threads"_a);
  nb::class_<Distance_function>(m, "DistanceFunction")
      .def("vertex_values", &Distance_function::vertex_values)
      .def("values", &Distance_function::values, "faces"_a, "barycentric"_a)
      .def("gradients", &Distance_function::gradients, "faces"_a, "barycentric"_a)
      .def("shortest_path", &Distance_function::shortest_path, "face"_a, "barycentric"_a)
      .def("isolines", &Distance_function::isolines, "value"_a);
  nb::class_<RL::Geodesic_solver>(m, "GeodesicSolver")
      .def_static("make", &make_solver, "surface"_a, "joining_tolerance"_a.none())
      .def("distances", &distances, "vertices"_a, "faces"_a, "from_"_a, "to"_a, "boundary"_a,
           "labels"_a, "query"_a)
      .def("function", &distance_function, "vertices"_a, "faces"_a, "from_"_a, "to"_a, "boundary"_a,
           "labels"_a, "query"_a, "fitter"_a.none())
      .def("have_faces", &have_faces)
      .def("location", &location_of_vertex, "vertex"_a)
      .def("signed_distances", &signed_distances, "values"_a, "query"_a)
      .def("distance_matrix", &distance_matrix, "sources"_a, "targets"_a.none(), "query"_a)
      .def("near_vertices", &near_vertices, "sources"_a, "maximum_distance"_a, "query"_a)
      .def("farthest_points", &farthest_points, "number"_a, "vertices"_a, "query"_a);
}

} // namespace python
