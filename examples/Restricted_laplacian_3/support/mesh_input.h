// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_EXAMPLES_MESH_INPUT_H
#define RESTRICTED_LAPLACIAN_3_EXAMPLES_MESH_INPUT_H

// Reads a triangle mesh from a file in any format that CGAL knows, and remembers how its vertices
// correspond to those of the file.

#include "program.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <map>
#include <string>
#include <vector>

namespace examples {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;
using Values = Mesh::Property_map<Vertex, double>;

struct Mesh_input {
  Mesh mesh;
  // for each vertex of the file, a vertex of the mesh at the same place, or `Mesh::null_vertex()`
  std::vector<Vertex> vertex_of_file;
  // for each vertex of the mesh, in the order of its index, a vertex of the file at the same place
  std::vector<std::size_t> file_index;
  // whether the file does not hold an oriented manifold, and was cut and glued to become one
  bool is_repaired = false;
  // whether the file has faces that are not triangles
  bool is_triangulated = false;
};

namespace internal {

using Polygons = std::vector<std::vector<std::size_t>>;

inline void read_soup(const std::string& file, std::vector<Point>& points, Polygons& polygons) {
  require(std::ifstream(file).good(), "cannot open '" + file + "'");
  require(CGAL::IO::read_polygon_soup(file, points, polygons, CGAL::parameters::verbose(false)),
          "cannot read '" + file +
              "': not a valid file of a known format (off, obj, ply, stl, ts)");
  require(!polygons.empty(), "'" + file + "' holds no face");
  for(std::size_t i = 0; i < points.size(); ++i)
    if(!(std::isfinite(points[i].x()) && std::isfinite(points[i].y()) &&
         std::isfinite(points[i].z())))
      throw Error("'" + file + "': vertex " + std::to_string(i) +
                  " has a coordinate that is not finite");
  for(std::size_t i = 0; i < polygons.size(); ++i)
    for(const std::size_t vertex : polygons[i])
      if(vertex >= points.size())
        throw Error("'" + file + "': face " + std::to_string(i) +
                    " names a vertex that does not exist");
}

// Builds a mesh whose vertices are the points. Returns false if a face has a vertex twice, or does
// not fit to the others: more than two faces on an edge, or two that traverse it alike.
inline bool build_mesh(const std::vector<Point>& points, const Polygons& polygons, Mesh& mesh) {
  for(const Point& point : points)
    mesh.add_vertex(point);
  std::vector<Vertex> face;
  for(const std::vector<std::size_t>& polygon : polygons) {
    face.clear();
    for(const std::size_t i : polygon) {
      if(std::find(face.begin(), face.end(), Vertex(static_cast<Mesh::size_type>(i))) != face.end())
        return false;
      face.emplace_back(static_cast<Mesh::size_type>(i));
    }
    if(face.size() < 3 || mesh.add_face(face) == Mesh::null_face())
      return false;
  }
  return true;
}

// Repairing permutes, merges and duplicates vertices; places remain what they are.
inline void match_vertices_by_place(const std::vector<Point>& file_points, Mesh_input& input) {
  std::map<Point, std::size_t> first_in_file;
  for(std::size_t i = 0; i < file_points.size(); ++i)
    first_in_file.emplace(file_points[i], i);
  std::map<Point, Vertex> first_in_mesh;
  for(const Vertex v : input.mesh.vertices()) {
    first_in_mesh.emplace(input.mesh.point(v), v);
    input.file_index.push_back(first_in_file.at(input.mesh.point(v)));
  }
  for(const Point& p : file_points) {
    const auto found = first_in_mesh.find(p);
    input.vertex_of_file.push_back(found == first_in_mesh.end() ? Mesh::null_vertex()
                                                                : found->second);
  }
}

} // namespace internal

// Vertices keep the order of the file. Only if its faces do not form an oriented manifold, it is
// treated as a polygon soup: coincident points are merged, and the surface is cut along edges
// where more than two faces or opposite orientations meet.
inline Mesh_input read_mesh(const std::string& file) {
  namespace PMP = CGAL::Polygon_mesh_processing;
  Mesh_input input;
  std::vector<Point> points;
  internal::Polygons polygons;
  internal::read_soup(file, points, polygons);

  if(internal::build_mesh(points, polygons, input.mesh)) {
    for(const Vertex v : input.mesh.vertices()) {
      input.vertex_of_file.push_back(v);
      input.file_index.push_back(v.idx());
    }
  } else {
    const std::vector<Point> file_points = points;
    PMP::repair_polygon_soup(points, polygons);
    PMP::orient_polygon_soup(points, polygons);
    require(PMP::is_polygon_soup_a_polygon_mesh(polygons),
            "'" + file + "' cannot be repaired to a manifold");
    input.mesh = Mesh();
    PMP::polygon_soup_to_polygon_mesh(points, polygons, input.mesh);
    internal::match_vertices_by_place(file_points, input);
    input.is_repaired = true;
  }

  if(!CGAL::is_triangle_mesh(input.mesh)) {
    PMP::triangulate_faces(input.mesh);
    input.is_triangulated = true;
  }
  return input;
}

// The values of a property map of the vertices of the mesh, in the order of the file; NaN for
// vertices that repairing removed.
inline std::vector<double> values_in_file_order(const Mesh_input& input, const Values& map) {
  std::vector<double> values;
  for(const Vertex v : input.vertex_of_file)
    values.push_back(v == Mesh::null_vertex() ? std::nan("") : map[v]);
  return values;
}

} // namespace examples

#endif // RESTRICTED_LAPLACIAN_3_EXAMPLES_MESH_INPUT_H
