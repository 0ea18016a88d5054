// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_EXAMPLES_POINT_INPUT_H
#define RESTRICTED_LAPLACIAN_3_EXAMPLES_POINT_INPUT_H

// Reads oriented points: XYZ files with six numbers in each line, and PLY files without faces.

#include "command_line.h"
#include "mesh_input.h"
#include "ply_property.h"
#include "program.h"

#include <CGAL/Restricted_laplacian_3/splines/Spline_space_3.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>
#include <CGAL/Restricted_laplacian_3/surface/point_areas.h>

#include <cstddef>
#include <fstream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace examples {

struct Point_options {
  int neighbors = RL::default_number_of_neighbors;
};

inline po::options_description point_options(Point_options& p, Common_options& o) {
  po::options_description options("Points", help_width);
  auto add = options.add_options();
  add("neighbors", po::value(&p.neighbors)->value_name("K")->default_value(p.neighbors),
      "number of neighbors of a point from which the area that it stands for is estimated");
  add("split-points", po::bool_switch(&o.space.split_point_set),
      "split elements by components of points that are linked by distance and normals");
  return options;
}

const char* const about_points = R"(
In place of a mesh, a file .xyz with lines of six numbers, x y z nx ny nz, or a PLY file
without faces but with the properties nx, ny, nz of its vertices, is a set of points with
normals, and stands for a surface without any mesh. Normals must be oriented alike. Unless
--depth is given, the depth is the largest up to 6 that gives 50 points to a cell.
)";

namespace internal {

struct Oriented_points {
  std::vector<RL::Point_3> points;
  std::vector<RL::Vector_3> normals;
};

inline bool has_extension(const std::string& file, const std::string& extension) {
  return file.size() > extension.size() &&
         file.compare(file.size() - extension.size(), extension.size(), extension) == 0;
}

// whether a file is a PLY file that lists no face
inline bool is_ply_without_faces(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  std::string line;
  if(!has_extension(file, ".ply") || !std::getline(in, line) || line.rfind("ply", 0) != 0)
    return false;
  while(std::getline(in, line) && line.rfind("end_header", 0) != 0) {
    std::istringstream words(line);
    std::string keyword, name;
    std::size_t number = 0;
    if(words >> keyword >> name >> number && keyword == "element" && name == "face" && number > 0)
      return false;
  }
  return true;
}

inline Oriented_points read_xyz(const std::string& file) {
  std::ifstream in(file);
  Oriented_points result;
  std::size_t number = 0;
  for(std::string line; std::getline(in, line);) {
    ++number;
    if(line.find_first_not_of(" \t\r") == std::string::npos || line[0] == '#')
      continue;
    std::istringstream words(line);
    double x, y, z, nx, ny, nz;
    require(static_cast<bool>(words >> x >> y >> z),
            "'" + file + "': line " + std::to_string(number) + " is not a point");
    require(static_cast<bool>(words >> nx >> ny >> nz),
            "'" + file + "': line " + std::to_string(number) +
                " has no normal; points need normals, x y z nx ny nz");
    result.points.emplace_back(x, y, z);
    result.normals.emplace_back(nx, ny, nz);
  }
  return result;
}

// `with_normals`: else there are none
inline Oriented_points read_ply_points(const std::string& file, bool with_normals = true) {
  for(const char* name : {"x", "y", "z"})
    require(!ply_property_type(file, name).empty(),
            "'" + file + "' has no points: no vertex property '" + name + "'");
  const auto read = [&](const char* name) { return read_ply_property(file, name); };
  Oriented_points result;
  const std::vector<double> x = read("x"), y = read("y"), z = read("z");
  for(std::size_t i = 0; i < x.size(); ++i)
    result.points.emplace_back(x[i], y[i], z[i]);
  if(!with_normals)
    return result;
  for(const char* name : {"nx", "ny", "nz"})
    require(!ply_property_type(file, name).empty(),
            "'" + file + "' has neither faces nor normals: no vertex property '" + name + "'");
  const std::vector<double> nx = read("nx"), ny = read("ny"), nz = read("nz");
  for(std::size_t i = 0; i < nx.size(); ++i)
    result.normals.emplace_back(nx[i], ny[i], nz[i]);
  return result;
}

} // namespace internal

// A mesh, or a set of points, for which the depth is chosen if none is given.
inline Mesh_input read_mesh_or_points(Common_options& o, const Point_options& p,
                                      const po::variables_map& given) {
  const bool is_xyz = internal::has_extension(o.mesh, ".xyz");
  require(std::ifstream(o.mesh).good(), "cannot open '" + o.mesh + "'");
  if(!is_xyz && !internal::is_ply_without_faces(o.mesh)) {
    require(given["neighbors"].defaulted() && !o.space.split_point_set,
            "--neighbors and --split-points need a set of points");
    return read_mesh(o.mesh);
  }
  internal::Oriented_points input =
      is_xyz ? internal::read_xyz(o.mesh) : internal::read_ply_points(o.mesh);
  std::vector<double> areas =
      RL::estimate_point_areas(input.points, input.normals, p.neighbors, o.space.is_parallel);
  RL::Triangulated_surface_3 surface(std::move(input.points), std::move(input.normals),
                                     std::move(areas));
  if(given["depth"].defaulted()) {
    const double cube_scale = given.count("cube-scale") ? o.space.cube_scale
                              : o.space.paper_space     ? 1.2
                                                        : 1.1;
    o.space.octree_depth = RL::default_octree_depth_of_points(surface, cube_scale);
  }
  return {std::move(surface), false};
}

} // namespace examples

#endif // RESTRICTED_LAPLACIAN_3_EXAMPLES_POINT_INPUT_H
