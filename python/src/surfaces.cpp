// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Surfaces and spaces: what they are made of, matrices, loads, values.

#include "functions.h"

#include "../../programs/support/program.h"

#include <CGAL/Restricted_laplacian_3/assembly/assemble.h>
#include <CGAL/Restricted_laplacian_3/assembly/cotangent_operators.h>
#include <CGAL/Restricted_laplacian_3/files/read_mesh_file.h>
#include <CGAL/Restricted_laplacian_3/foundation/memory.h>
#include <CGAL/Restricted_laplacian_3/input/point_areas.h>
#include <CGAL/Restricted_laplacian_3/integration/Surface_material.h>
#include <CGAL/Restricted_laplacian_3/patches/curved_surface.h>
#include <CGAL/Restricted_laplacian_3/problems/Curvature_field.h>
#include <CGAL/Restricted_laplacian_3/problems/shared/space_of.h>
#include <CGAL/Restricted_laplacian_3/splines/Spline_functions_3.h>
#include <CGAL/Restricted_laplacian_3/splines/estimate_memory.h>
#include <CGAL/Restricted_laplacian_3/splines/evaluation_matrix.h>
#include <CGAL/Restricted_laplacian_3/splines/prolongation.h>
#include <CGAL/Restricted_laplacian_3/surface/shared/Surface_builder.h>
#include <CGAL/Restricted_laplacian_3/surface/vertex_normals.h>

#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>

#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace python {
namespace {

using namespace nb::literals;
using Surface = RL::Triangulated_surface_3;

void check_three_columns(const Array& a, const char* name) {
  if(a.ndim() == 2 && a.shape(1) == 3)
    return;
  std::string shape;
  for(std::size_t i = 0; i < a.ndim(); ++i)
    shape += (i ? ", " : "") + std::to_string(a.shape(i));
  throw RL::Parameter_error(name, "has the shape (" + shape + "), but must have (n, 3)");
}

// points or vectors of the rows
template <class T> std::vector<T> read_rows(const Array& a, const char* name) {
  check_three_columns(a, name);
  std::vector<T> result;
  result.reserve(a.shape(0));
  const std::int64_t row = a.stride(0), column = a.stride(1);
  visit_numbers(a, name, [&](const auto* data) {
    for(std::size_t i = 0; i < a.shape(0); ++i, data += row)
      result.emplace_back(static_cast<double>(data[0]), static_cast<double>(data[column]),
                          static_cast<double>(data[2 * column]));
  });
  return result;
}

// the number of a vertex of a face
template <class Number>
std::uint32_t read_index(Number number, std::size_t face, std::size_t number_of_vertices) {
  if constexpr(std::is_floating_point_v<Number>)
    if(!(number == std::floor(number)))
      throw RL::Invalid_face_error(face, "names a vertex by a number that is not whole");
  if(!(number >= Number(0)) ||
     !(static_cast<double>(number) < static_cast<double>(number_of_vertices)))
    throw RL::Invalid_face_error(face, "names a vertex that does not exist");
  return static_cast<std::uint32_t>(number);
}

std::vector<Surface::Triangle> read_faces(const Array& a, std::size_t number_of_vertices) {
  check_three_columns(a, "F");
  std::vector<Surface::Triangle> result;
  result.reserve(a.shape(0));
  const std::int64_t row = a.stride(0), column = a.stride(1);
  visit_numbers(a, "F", [&](const auto* data) {
    for(std::size_t i = 0; i < a.shape(0); ++i, data += row)
      result.push_back({read_index(data[0], i, number_of_vertices),
                        read_index(data[column], i, number_of_vertices),
                        read_index(data[2 * column], i, number_of_vertices)});
  });
  return result;
}

// polygons: the numbers of their corners, and the corners in a row
Surface make_polygons(
    const Array& v, const Array& corners,
    const nb::ndarray<const std::int64_t, nb::ndim<1>, nb::c_contig, nb::device::cpu>& sizes) {
  RL::internal::Surface_builder builder;
  const std::vector<RL::Point_3> points = read_rows<RL::Point_3>(v, "V");
  builder.reserve(points.size(), sizes.size());
  for(const RL::Point_3& p : points)
    builder.add_point(p);
  std::vector<std::uint32_t> polygon;
  visit_numbers(corners, "F", [&](const auto* data) {
    for(std::size_t i = 0; i < sizes.size(); ++i) {
      polygon.clear();
      for(std::int64_t k = 0; k < sizes.data()[i]; ++k, data += corners.stride(0))
        polygon.push_back(read_index(*data, i, points.size()));
      builder.add_polygon(polygon);
    }
  });
  return std::move(builder).surface();
}

Surface make_surface(const Array& v, const Array& f) {
  std::vector<RL::Point_3> points = read_rows<RL::Point_3>(v, "V");
  std::vector<Surface::Triangle> faces = read_faces(f, points.size());
  const nb::gil_scoped_release release;
  return Surface(std::move(points), std::move(faces));
}

RL::Smooth_geometry smooth_geometry(double crease_angle,
                                    const std::optional<Array>& vertex_normals) {
  RL::Smooth_geometry geometry;
  geometry.crease_angle = crease_angle;
  if(vertex_normals)
    geometry.vertex_normals = read_rows<RL::Vector_3>(*vertex_normals, "vertex_normals");
  return geometry;
}

// the smooth surface through the vertices
Surface make_curved_surface(const Surface& surface, double crease_angle,
                            const std::optional<Array>& vertex_normals) {
  const RL::Smooth_geometry geometry = smooth_geometry(crease_angle, vertex_normals);
  const nb::gil_scoped_release release;
  return RL::curved_surface(surface, geometry);
}

// the surface to which a callable takes points, a row for each
Surface make_projected_surface(const Surface& surface, const nb::object& projection) {
  const Callable_function function(projection, 3, 0);
  RL::Smooth_geometry geometry;
  geometry.projection = [&function](const std::vector<RL::Point_3>& points) {
    std::vector<RL::Surface_point> given(points.size());
    for(std::size_t i = 0; i < points.size(); ++i)
      given[i].point = points[i];
    std::vector<double> found(3 * points.size());
    if(!points.empty())
      function(given.data(), given.size(), found.data());
    std::vector<RL::Point_3> projected;
    for(std::size_t i = 0; i < points.size(); ++i)
      projected.emplace_back(found[3 * i], found[3 * i + 1], found[3 * i + 2]);
    return projected;
  };
  const nb::gil_scoped_release release;
  return RL::curved_surface(surface, geometry);
}

void warn(const std::string& file, const std::vector<std::string>& warnings) {
  for(const std::string& warning : warnings)
    if(PyErr_WarnEx(PyExc_UserWarning, ("'" + file + "': " + warning).c_str(), 2) < 0)
      throw nb::python_error();
}

// numbers of the corners of the polygons, and the corners in a row
nb::tuple polygons_of(const Surface& surface) {
  std::vector<std::int64_t> sizes, corners;
  for(std::size_t face = 0, polygon = 0; polygon < surface.number_of_polygons(); ++polygon) {
    constexpr std::int64_t none = -1;
    std::vector<std::int64_t> vertices(surface.size_of_polygon(polygon), none);
    for(; face < surface.number_of_faces() && surface.polygon(face) == polygon; ++face)
      for(int k = 0; k < 3; ++k)
        vertices[surface.corner_of_polygon(face, k)] = surface.triangle(face)[k];
    for(std::size_t k = 1; k < vertices.size(); ++k)
      if(vertices[k] == none) // the point before once more
        vertices[k] = vertices[k - 1];
    sizes.push_back(static_cast<std::int64_t>(vertices.size()));
    corners.insert(corners.end(), vertices.begin(), vertices.end());
  }
  return nb::make_tuple(array_of_rows(std::move(corners), 1), array_of_rows(std::move(sizes), 1));
}

// the surface of a file; faces that are not triangles have been divided
Surface surface_of(const std::string& file, RL::Mesh_file& mesh) {
  if(mesh.triangles.empty())
    throw RL::File_error(file, {}, "holds no face");
  return Surface(std::move(mesh.points), std::move(mesh.triangles));
}

Surface read_mesh(const std::string& file, const nb::object& progress) {
  std::vector<std::string> warnings;
  Surface surface = run(1, progress, [&](const auto& callback) {
    RL::Mesh_file mesh = RL::read_mesh_file(file, RL::parameters::progress(callback));
    warnings = std::move(mesh.warnings);
    return surface_of(file, mesh);
  });
  warn(file, warnings);
  return surface;
}

// of bytes in memory, as if they were in a file of that name
Surface read_mesh_of_bytes(const std::string& file, const nb::bytes& bytes) {
  RL::Mesh_file mesh = RL::internal::read_mesh_file(file, {bytes.c_str(), bytes.size()});
  warn(file, mesh.warnings);
  return surface_of(file, mesh);
}

// names, types and values
nb::list read_vertex_properties(const std::string& file, const nb::object& progress) {
  std::vector<RL::Vertex_property> properties = run(1, progress, [&](const auto& callback) {
    return RL::read_vertex_properties(file, RL::parameters::progress(callback));
  });
  nb::list result;
  for(RL::Vertex_property& p : properties)
    result.append(nb::make_tuple(p.name, p.type, array_of_rows(std::move(p.values), 1)));
  return result;
}

Surface make_point_surface(const Array& v, const Array& n, const std::optional<Numbers>& areas,
                           int neighbors, int threads) {
  std::vector<RL::Point_3> points = read_rows<RL::Point_3>(v, "V");
  std::vector<RL::Vector_3> normals = read_rows<RL::Vector_3>(n, "normals");
  if(points.size() != normals.size())
    throw RL::Parameter_error("normals", "has " + std::to_string(normals.size()) +
                                             " rows, but must have " +
                                             std::to_string(points.size()));
  std::vector<double> own_areas;
  if(areas)
    own_areas.assign(areas->data(), areas->data() + areas->size());
  return run(threads, nb::none(), [&](const auto&) {
    if(!areas)
      own_areas = RL::estimate_point_areas(points, normals, neighbors, threads != 1);
    return Surface(std::move(points), std::move(normals), std::move(own_areas));
  });
}

RL::Spline_space_3 make_space(const Surface& surface, std::optional<int> depth,
                              std::optional<double> cube_scale,
                              std::optional<double> joining_tolerance, std::optional<bool> split,
                              bool paper, std::optional<double> maximum_memory, int threads) {
  RL::Spline_space_options o;
  o.depth = depth;
  o.cube_scale = cube_scale;
  o.joining_tolerance = joining_tolerance;
  o.paper = paper;
  o.maximum_memory = maximum_memory;
  if(split)
    o.split = o.split_point_set = *split;
  o.is_parallel = threads != 1;
  return run(threads, nb::none(), [&](const auto&) { return RL::Spline_space_3(surface, o); });
}

// The same space for another material. Callables are called for all nodes at once, in this space.
// With an anisotropy the diffusion follows the curvature of the surface.
RL::Spline_space_3 with_material(const RL::Spline_space_3& space,
                                 const std::shared_ptr<Function>& diffusion,
                                 const std::shared_ptr<Function>& density,
                                 std::optional<std::array<double, 2>> anisotropy) {
  if(!diffusion && !density && !anisotropy)
    return space.with_material({});
  RL::Surface_material material;
  if(anisotropy)
    run(space.options().is_parallel ? 0 : 1, nb::none(), [&](const auto&) {
      material.set_diffusion(
          RL::curvature_diffusion(RL::estimate_curvature(space.with_material({})), *anisotropy));
      return true;
    });
  if(diffusion) {
    check_function(*diffusion, space.surface(), "diffusion");
    material.set_diffusion(Shared_function{diffusion});
  }
  if(density) {
    check_function(*density, space.surface(), "density");
    material.set_density(Shared_function{density});
  }
  return recorded(space, {diffusion.get(), density.get()}).with_material(material);
}

template <class T, class Value>
nb::object array_of_faces(const Surface& surface, std::size_t width, Value&& value) {
  std::vector<T> result;
  result.reserve(width * surface.number_of_faces());
  for(std::size_t i = 0; i < surface.number_of_faces(); ++i)
    value(i, result);
  return array_of_rows(std::move(result), width);
}

nb::object normals_at_vertices(const Surface& surface) {
  std::vector<double> result;
  for(const RL::Vector_3& n : RL::vertex_normals(surface))
    for(int axis = 0; axis < 3; ++axis)
      result.push_back(n[axis]);
  return array_of_rows(std::move(result), 3);
}

// the area of a third of the faces around each vertex: the integrals of linear elements
nb::object areas_at_vertices(const Surface& surface) {
  std::vector<double> result(surface.number_of_vertices());
  for(std::size_t i = 0; i < surface.number_of_faces(); ++i)
    for(const std::uint32_t vertex : surface.triangle(i))
      result[vertex] += surface.area(i) / 3;
  return array_of_rows(std::move(result), 1);
}

std::vector<RL::Surface_location> read_locations(
    const nb::ndarray<const std::int64_t, nb::ndim<1>, nb::c_contig, nb::device::cpu>& faces,
    const Rows& barycentric) {
  if(barycentric.shape(1) != 3 || barycentric.shape(0) != faces.size())
    throw RL::Parameter_error("barycentric", "needs three columns, and a row for each face");
  std::vector<RL::Surface_location> result(faces.size());
  for(std::size_t i = 0; i < result.size(); ++i) {
    if(faces.data()[i] < 0)
      throw RL::Location_error("there is no face " + std::to_string(faces.data()[i]));
    result[i].face = static_cast<std::size_t>(faces.data()[i]);
    std::copy_n(barycentric.data() + 3 * i, 3, result[i].barycentric.begin());
  }
  return result;
}

using Locations = std::vector<RL::Surface_location>;

// a matrix at locations, or at the vertices if there are none; of values, or of derivatives
nb::tuple evaluation(const RL::Spline_space_3& space, const Locations* locations,
                     std::optional<int> axis, std::optional<int> level) {
  RL::Sparse_matrix m = [&] {
    const nb::gil_scoped_release release;
    return !locations && !axis ? RL::evaluation_matrix(space, level)
           : !locations        ? RL::derivative_matrix(space, *axis, level)
           : !axis             ? RL::evaluation_matrix(space, *locations, level)
                               : RL::derivative_matrix(space, *axis, *locations, level);
  }();
  return sparse_arrays(std::move(m));
}

Eigen::MatrixXd coefficients_of(const RL::Spline_space_3& space, const Rows& coefficients) {
  if(coefficients.shape(0) != space.dimension())
    throw RL::Parameter_error("coefficients", "has " + std::to_string(coefficients.shape(0)) +
                                                  " rows, but the dimension of the space is " +
                                                  std::to_string(space.dimension()));
  return matrix_of(coefficients);
}

nb::object values(const RL::Spline_space_3& space, const Rows& coefficients,
                  const Locations* locations, int threads) {
  const Eigen::MatrixXd h = coefficients_of(space, coefficients);
  return array_of_matrix(run(threads, nb::none(), [&](const auto&) -> Eigen::MatrixXd {
    const RL::Spline_functions_3 functions(space, h);
    return locations ? functions.values_at_locations(*locations) : functions.values_at_vertices();
  }));
}

// derivatives along the three axes
nb::tuple derivatives(const RL::Spline_space_3& space, const Rows& coefficients,
                      const Locations* locations, int threads) {
  const Eigen::MatrixXd h = coefficients_of(space, coefficients);
  RL::Spline_jets jets = run(threads, nb::none(), [&](const auto&) {
    const RL::Spline_functions_3 functions(space, h);
    return locations ? functions.jets_at_locations(*locations) : functions.jets_at_vertices();
  });
  return nb::make_tuple(array_of_matrix(std::move(jets.derivatives[0])),
                        array_of_matrix(std::move(jets.derivatives[1])),
                        array_of_matrix(std::move(jets.derivatives[2])));
}

} // namespace

void add_surfaces(nb::module_& m) {
  nb::class_<Surface>(m, "Surface")
      .def_static("of_triangles", &make_surface, "V"_a, "F"_a)
      .def_static("of_polygons", &make_polygons, "V"_a, "corners"_a, "sizes"_a)
      .def_static("of_file", &read_mesh, "file"_a, "progress"_a.none())
      .def_static("of_bytes", &read_mesh_of_bytes, "file"_a, "bytes"_a)
      .def_static("of_points", &make_point_surface, "V"_a, "normals"_a, "areas"_a.none(),
                  "neighbors"_a, "threads"_a)
      .def("curved", &make_curved_surface, "crease_angle"_a, "vertex_normals"_a.none())
      .def("projected", &make_projected_surface, "projection"_a)
      .def_prop_ro(
          "number_of_folded_faces",
          [](const Surface& s) { return s.is_smooth() ? s.patches().number_of_folded_faces() : 0; })
      .def_prop_ro("number_of_vertices", &Surface::number_of_vertices)
      .def_prop_ro("number_of_faces", &Surface::number_of_faces)
      .def_prop_ro("number_of_degenerate_faces", &Surface::number_of_degenerate_faces)
      .def_prop_ro("is_point_set", &Surface::is_point_set)
      .def_prop_ro("area", nb::overload_cast<>(&Surface::area, nb::const_))
      .def_prop_ro("has_polygons", &Surface::has_polygons)
      .def_prop_ro("number_of_polygons", &Surface::number_of_polygons)
      .def("polygons", &polygons_of)
      .def("polygons_of_faces",
           [](const Surface& s) {
             return array_of_faces<std::int64_t>(
                 s, 1, [&](std::size_t i, auto& result) { result.push_back(s.polygon(i)); });
           })
      .def("corners_of_polygons",
           [](const Surface& s) {
             return array_of_faces<std::int64_t>(s, 3, [&](std::size_t i, auto& result) {
               for(int k = 0; k < 3; ++k)
                 result.push_back(static_cast<std::int64_t>(s.corner_of_polygon(i, k)));
             });
           })
      .def("faces",
           [](const Surface& s) {
             return array_of_faces<std::int64_t>(s, 3, [&](std::size_t i, auto& result) {
               for(const std::uint32_t vertex : s.triangle(i))
                 result.push_back(vertex);
             });
           })
      .def("face_areas",
           [](const Surface& s) {
             return array_of_faces<double>(
                 s, 1, [&](std::size_t i, auto& result) { result.push_back(s.area(i)); });
           })
      .def("face_normals",
           [](const Surface& s) {
             return array_of_faces<double>(s, 3, [&](std::size_t i, auto& result) {
               for(int axis = 0; axis < 3; ++axis)
                 result.push_back(s.normal(i)[axis]);
             });
           })
      .def("points",
           [](const Surface& s) {
             std::vector<double> result;
             for(std::size_t v = 0; v < s.number_of_vertices(); ++v)
               for(int axis = 0; axis < 3; ++axis)
                 result.push_back(s.point(v)[axis]);
             return array_of_rows(std::move(result), 3);
           })
      .def("cotangent_operators",
           [](const Surface& s, bool lumped_mass) {
             RL::Operators o = run(1, nb::none(), [&](const auto&) {
               return RL::cotangent_operators(s, lumped_mass);
             });
             return nb::make_tuple(sparse_arrays(std::move(o.stiffness)),
                                   sparse_arrays(std::move(o.mass)));
           })
      .def("vertex_areas", &areas_at_vertices)
      .def("vertex_normals", &normals_at_vertices);

  m.def("read_vertex_properties", &read_vertex_properties, "file"_a, "progress"_a.none());
  nb::list suffixes;
  for(const std::string& suffix : RL::internal::mesh_file_suffixes())
    suffixes.append(suffix);
  m.attr("mesh_suffixes") = suffixes;
  m.attr("default_neighbors") = RL::default_number_of_neighbors;

  nb::class_<Function>(m, "Function").def_prop_ro("components", &Function::components);
  m.def(
      "smooth_function",
      [](const Surface& surface, double crease_angle, const std::optional<Array>& vertex_normals,
         const Rows& values) -> std::shared_ptr<Function> {
        const RL::Smooth_geometry geometry = smooth_geometry(crease_angle, vertex_normals);
        const nb::gil_scoped_release release;
        return std::make_shared<Smooth_array_function>(surface, geometry, values);
      },
      "surface"_a, "crease_angle"_a, "vertex_normals"_a.none(), "values"_a);
  m.def("array_function",
        [](const Rows& values, const std::string& at) -> std::shared_ptr<Function> {
          return std::make_shared<Array_function>(values, at == "vertices"  ? At::vertices
                                                          : at == "corners" ? At::corners
                                                                            : At::faces);
        });
  m.def("callable_function",
        [](nb::object callable, int components, int degree) -> std::shared_ptr<Function> {
          return std::make_shared<Callable_function>(std::move(callable), components, degree);
        });

  m.def("estimate_memory", [](const Surface& surface, int depth, double cube_scale) {
    const RL::Memory_estimate estimate = RL::estimate_memory(surface, depth, cube_scale);
    return nb::make_tuple(estimate.dimension, estimate.surface, estimate.solver);
  });
  m.def(
      "first_depth_of_search",
      [](const Surface& surface, std::optional<int> depth) {
        RL::Spline_space_options o;
        o.depth = depth;
        return RL::internal::first_depth_of_search(surface, o);
      },
      "surface"_a, "depth"_a.none());
  m.def("memory_of_machine", &RL::memory_of_machine);

  nb::class_<Locations>(m, "Locations");
  m.def("locations", &read_locations);

  using Space = RL::Spline_space_3;
  nb::class_<Space>(m, "Space")
      .def_static("make", &make_space, "surface"_a, "depth"_a.none(), "cube_scale"_a.none(),
                  "joining_tolerance"_a.none(), "split"_a.none(), "paper"_a,
                  "maximum_memory"_a.none(), "threads"_a)
      .def("with_material", &with_material, "diffusion"_a.none(), "density"_a.none(),
           "anisotropy"_a.none())
      .def_prop_ro("depth", &Space::depth)
      .def_prop_ro("dimension", nb::overload_cast<>(&Space::dimension, nb::const_))
      .def("dimension_of_level",
           [](const Space& s, int level) { return s.dimension(s.checked_level(level)); })
      .def_prop_ro("cell_width", [](const Space& s) { return s.octree().cell_width(s.depth()); })
      .def_prop_ro("components", [](const Space& s) { return s.number_of_sheets(0); })
      .def("surface", [](const Space& s) { return s.surface(); })
      .def(
          "operators",
          [](const Space& s, double stabilization, std::optional<int> level, bool with_mass,
             int threads, const nb::object& progress) {
            const int l = s.checked_level(level);
            std::vector<RL::Operators> o = run(threads, progress, [&](const auto& callback) {
              return RL::assemble_operators_of_levels(s, l, l, stabilization,
                                                      with_mass ? RL::Stabilized::stiffness_and_mass
                                                                : RL::Stabilized::stiffness,
                                                      callback);
            });
            return nb::make_tuple(sparse_arrays(std::move(o[0].stiffness)),
                                  sparse_arrays(std::move(o[0].mass)));
          },
          "stabilization"_a, "level"_a.none(), "with_mass"_a, "threads"_a, "progress"_a.none())
      .def("prolongation",
           [](const Space& s, int level) {
             return sparse_arrays(RL::prolongation_matrix(s, level));
           })
      .def("integrals",
           [](const Space& s, int threads) {
             return array_of_matrix(run(threads, nb::none(), [&](const auto&) {
               return RL::assemble_element_integrals(s);
             }));
           })
      .def("loads",
           [](const Space& s, const Function& f, int threads) {
             check_function(f, s.surface(), "f");
             return array_of_matrix(run(threads, nb::none(), [&](const auto&) {
               return RL::assemble_component_loads(recorded(s, {&f}), f);
             }));
           })
      .def("gradient_loads",
           [](const Space& s, const Function& f, int threads) {
             check_function(f, s.surface(), "v");
             return array_of_matrix(run(threads, nb::none(), [&](const auto&) {
               return RL::assemble_gradient_loads(recorded(s, {&f}), f);
             }));
           })
      .def("evaluation", &evaluation, "locations"_a.none(), "axis"_a.none(), "level"_a.none())
      .def("values", &values, "coefficients"_a, "locations"_a.none(), "threads"_a)
      .def("derivatives", &derivatives, "coefficients"_a, "locations"_a.none(), "threads"_a);
}

} // namespace python
