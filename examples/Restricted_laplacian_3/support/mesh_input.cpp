// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "mesh_input.h"

#include "program.h"
#include "vertex_data.h"

#include <CGAL/Restricted_laplacian_3/surface/read_triangle_soup.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/utility.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <utility>

namespace examples {

namespace internal {

Polygon_soup read_soup(const std::string& file, const Callback& callback) {
  Polygon_soup soup;
  require(std::ifstream(file).good(), "cannot open '" + file + "'");
  if(RL::read_triangle_soup(file, soup.points, soup.triangles, RL::parameters::callback(callback)))
    return soup;
  coordinate_types(file); // throws if CGAL cannot read them
  require(CGAL::IO::read_polygon_soup(file, soup.points, soup.polygons,
                                      CGAL::parameters::verbose(false)),
          "cannot read '" + file +
              "': not a valid file of a known format (off, obj, ply, stl, ts)");
  return soup;
}

namespace {

// Throws unless face number `i` is one. Vertices that no face uses may be anything.
template <typename Face>
void check_face(const std::vector<RL::Point_3>& points, const Face& face, std::size_t i,
                const std::string& file) {
  const auto fail = [&](const std::string& reason) {
    throw Error("'" + file + "': face " + std::to_string(i) + reason);
  };
  if(face.size() < 3)
    fail(" has fewer than three corners");
  for(const std::size_t vertex : face) {
    if(vertex >= points.size())
      fail(" names a vertex that does not exist");
    const RL::Point_3& p = points[vertex];
    if(!(std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z())))
      fail(": vertex " + std::to_string(vertex) + " has a coordinate that is not finite");
  }
}

// Appends the triangles of a polygon, which need not be plane, convex or free of
// self-intersections.
void triangulate(const std::vector<RL::Point_3>& points, Polygon polygon,
                 std::vector<RL::Triangulated_surface_3::Triangle>& triangles) {
  using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
  using Corners = CGAL::Triple<std::size_t, std::size_t, std::size_t>;
  std::vector<Corners> parts;
  if(polygon.size() > 3) {
    // a side from a vertex to itself is none
    polygon.erase(std::unique(polygon.begin(), polygon.end()), polygon.end());
    if(polygon.front() == polygon.back())
      polygon.pop_back();
    std::vector<Point> corners;
    for(const std::size_t vertex : polygon)
      corners.emplace_back(points[vertex].x(), points[vertex].y(), points[vertex].z());
    CGAL::Polygon_mesh_processing::triangulate_hole_polyline(corners, std::back_inserter(parts));
  }
  // a triangle, or a polygon that cannot be divided into triangles that all have an area: a fan
  if(parts.size() + 2 != polygon.size()) {
    parts.clear();
    for(std::size_t i = 2; i < polygon.size(); ++i)
      parts.push_back({0, i - 1, i});
  }
  const auto corner = [&](std::size_t i) { return static_cast<std::uint32_t>(polygon[i]); };
  for(const Corners& part : parts)
    triangles.push_back({corner(part.first), corner(part.second), corner(part.third)});
}

} // namespace

Mesh_input mesh_of(Polygon_soup soup, const std::string& file) {
  require(soup.has_faces(), "'" + file + "' holds no face");
  std::vector<RL::Triangulated_surface_3::Triangle> triangles = std::move(soup.triangles);
  for(std::size_t i = 0; i < triangles.size(); ++i)
    check_face(soup.points, triangles[i], i, file);
  bool is_triangulated = false;
  for(std::size_t i = 0; i < soup.polygons.size(); ++i) {
    check_face(soup.points, soup.polygons[i], i, file);
    is_triangulated = is_triangulated || soup.polygons[i].size() > 3;
    triangulate(soup.points, std::move(soup.polygons[i]), triangles);
  }
  return {RL::Triangulated_surface_3(std::move(soup.points), std::move(triangles)),
          is_triangulated};
}

} // namespace internal

Mesh_input read_mesh(const std::string& file, const Callback& callback) {
  return internal::mesh_of(internal::read_soup(file, callback), file);
}

} // namespace examples
