// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Pages that show functions on surfaces, and what they show between the vertices.

#include "module.h"

#include "../../programs/support/program.h"
#include "../../programs/support/refined_surface.h"
#include "../../programs/support/viewer_page.h"

#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>

#include <algorithm>
#include <optional>
#include <sstream>
#include <string>
#include <utility>

namespace python {
namespace {

using namespace nb::literals;
using Page = programs::Viewer_page;
using Faces = nb::ndarray<const std::uint32_t, nb::ndim<2>, nb::c_contig, nb::device::cpu>;

template <class T> std::vector<T> read_rows(const Rows& a) {
  std::vector<T> result;
  for(std::size_t i = 0; i < a.shape(0); ++i)
    result.emplace_back(a(i, 0), a(i, 1), a(i, 2));
  return result;
}

// Arrays have been checked by the caller.
void add_surface(Page& page, const std::string& name, const Rows& points,
                 const std::optional<Faces>& faces, const std::optional<Rows>& normals) {
  programs::Viewer_surface& s = page.surfaces.emplace_back();
  s.name = name;
  s.points = read_rows<RL::Point_3>(points);
  for(std::size_t i = 0; faces && i < faces->shape(0); ++i)
    s.triangles.push_back({(*faces)(i, 0), (*faces)(i, 1), (*faces)(i, 2)});
  if(normals)
    s.normals = read_rows<RL::Vector_3>(*normals);
}

// a line on the surface that was added last
void add_line(Page& page, const Rows& points) {
  page.surfaces.back().lines.push_back(read_rows<RL::Point_3>(points));
}

// a field of the surface that was added last
void add_field(Page& page, const std::string& name, const Numbers& values, bool is_color,
               std::optional<std::pair<double, double>> range,
               const std::optional<Rows>& positions) {
  page.surfaces.back().fields.push_back(
      {name,
       {values.data(), values.data() + values.size()},
       is_color,
       range,
       positions ? read_rows<RL::Point_3>(*positions) : std::vector<RL::Point_3>()});
}

std::string html(const Page& page, const std::string& viewer_file) {
  const nb::gil_scoped_release release;
  try {
    std::ostringstream out;
    programs::write_viewer_page(out, programs::read_viewer(viewer_file), page);
    return out.str();
  } catch(const programs::Error& e) {
    throw RL::Input_error(e.what());
  }
}

// points, faces, for each point its location, the face, or -1, and coordinates there; and for each
// face the one that it is part of
nb::tuple refined(const RL::Triangulated_surface_3& surface, double longest_side) {
  surface.require_triangles("refining");
  std::vector<double> points, barycentric;
  std::vector<std::int64_t> faces, at, parents;
  {
    const nb::gil_scoped_release release;
    const programs::Refined_surface fine = programs::refine(surface, longest_side);
    for(std::size_t v = 0; v < fine.locations.size(); ++v) {
      for(int axis = 0; axis < 3; ++axis)
        points.push_back(fine.surface.point(v)[axis]);
      at.push_back(fine.is_located[v] ? static_cast<std::int64_t>(fine.locations[v].face) : -1);
      for(const double b : fine.locations[v].barycentric)
        barycentric.push_back(b);
    }
    for(std::size_t f = 0; f < fine.surface.number_of_faces(); ++f)
      for(const std::uint32_t v : fine.surface.triangle(f))
        faces.push_back(v);
    parents.assign(fine.parents.begin(), fine.parents.end());
  }
  return nb::make_tuple(array_of_rows(std::move(points), 3), array_of_rows(std::move(faces), 3),
                        array_of_rows(std::move(at), 1), array_of_rows(std::move(barycentric), 3),
                        array_of_rows(std::move(parents), 1));
}

} // namespace

void add_views(nb::module_& m) {
  nb::class_<Page>(m, "Page")
      .def(
          "__init__",
          [](Page* page, const std::string& title, int isolines, const std::string& up,
             std::size_t first) {
            new(page) Page;
            page->title = title;
            page->isolines = isolines;
            page->up = up[0];
            page->first_field = first;
          },
          "title"_a, "isolines"_a, "up"_a, "first"_a)
      .def("add_surface", &add_surface, "name"_a, "points"_a, "faces"_a.none(), "normals"_a.none())
      .def("add_line", &add_line, "points"_a)
      .def("add_field", &add_field, "name"_a, "values"_a, "is_color"_a, "range"_a.none(),
           "positions"_a.none())
      .def("html", &html, "viewer_file"_a);
  m.def("refined", &refined, "surface"_a, "longest_side"_a);
}

} // namespace python
