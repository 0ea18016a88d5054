// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "vertex_data.h"

#include "point_set.h"
#include "program.h"

#include <CGAL/Point_set_3/IO.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <iostream>
#include <set>
#include <sstream>
#include <streambuf>
#include <utility>

namespace examples {

namespace internal {

namespace {

const std::set<std::string> coordinates = {"x", "y", "z", "nx", "ny", "nz"};

// names and types of the properties of the vertices of a PLY file; lists are left out
std::vector<std::pair<std::string, std::string>> vertex_properties(const std::string& file) {
  std::vector<std::pair<std::string, std::string>> properties;
  std::ifstream in(file, std::ios::binary);
  bool is_in_vertices = false;
  for(std::string line, keyword, type, name; std::getline(in, line) && keyword != "end_header";) {
    std::istringstream words(line);
    words >> keyword >> type >> name;
    if(keyword == "element")
      is_in_vertices = type == "vertex" || type == "vertices";
    else if(keyword == "property" && is_in_vertices && type != "list")
      properties.emplace_back(name, type);
  }
  return properties;
}

} // namespace

std::map<std::string, std::string> coordinate_types(const std::string& file) {
  std::map<std::string, std::string> types;
  if(extension(file) != ".ply")
    return types;
  for(const auto& [name, type] : vertex_properties(file))
    if(coordinates.count(name) > 0)
      types[name] = type == "float32" ? "float" : type == "float64" ? "double" : type;
  for(const char* name : {"x", "y", "z"})
    require(types.count(name) > 0, "'" + file + "' has no vertex property '" + name + "'");
  for(const auto& [name, type] : types)
    require(type == "float" || type == "double",
            "'" + file + "': the vertex property '" + name + "' is neither float nor double");
  return types;
}

namespace {

// Catches what is written to the standard error stream: some of CGAL's readers say there why they
// fail.
class Error_stream_catcher {
public:
  Error_stream_catcher() : m_buffer(std::cerr.rdbuf(m_text.rdbuf())) {}
  ~Error_stream_catcher() { std::cerr.rdbuf(m_buffer); }
  Error_stream_catcher(const Error_stream_catcher&) = delete;
  Error_stream_catcher& operator=(const Error_stream_catcher&) = delete;

  std::string text() const { return m_text.str(); }

private:
  std::ostringstream m_text;
  std::streambuf* m_buffer;
};

// Copies the property of a name and a type, if there is one.
template <typename Number>
bool copy_property(Point_set& points, const std::string& name, std::vector<double>& values) {
  if(!points.has_property_map<Number>(name))
    return false;
  // that which is there; property_map() returns other types from CGAL 6 on
  const auto map = points.add_property_map<Number>(name).first;
  for(const Point_set::Index& i : points)
    values.push_back(static_cast<double>(map[i]));
  return true;
}

// The values of a property, empty if there is none of this name.
std::vector<double> property(Point_set& points, const std::string& name) {
  std::vector<double> values;
  const bool is_normal = name.size() == 2 && name[0] == 'n' && points.has_normal_map();
  if(name == "x" || name == "y" || name == "z")
    for(const RL::Point_3& p : points.points())
      values.push_back(p[name[0] - 'x']);
  else if(is_normal && name[1] >= 'x' && name[1] <= 'z')
    for(const RL::Vector_3& n : points.normals())
      values.push_back(n[name[1] - 'x']);
  else
    copy_property<double>(points, name, values) || copy_property<float>(points, name, values) ||
        copy_property<std::int32_t>(points, name, values) ||
        copy_property<std::uint32_t>(points, name, values) ||
        copy_property<std::int16_t>(points, name, values) ||
        copy_property<std::uint16_t>(points, name, values) ||
        copy_property<std::int8_t>(points, name, values) ||
        copy_property<std::uint8_t>(points, name, values);
  return values;
}

} // namespace

} // namespace internal

Point_set read_points(const std::string& file) {
  require(std::ifstream(file).good(), "cannot open '" + file + "'");
  const auto types = internal::coordinate_types(file);
  for(const auto& coordinate : types)
    require(coordinate.second == types.at("x"),
            "'" + file + "': coordinates and normals differ in their types");
  const internal::Error_stream_catcher catcher;
  Point_set points;
  const bool is_read = CGAL::IO::read_point_set(file, points);
  require(is_read, "cannot read the points of '" + file + "'. " + catcher.text());
  return points;
}

std::vector<std::pair<std::string, std::vector<double>>>
read_ply_properties(const std::string& file) {
  std::vector<std::pair<std::string, std::vector<double>>> result;
  if(extension(file) != ".ply")
    return result;
  Point_set points = read_points(file);
  const std::set<std::string> colors = {"red", "green", "blue", "alpha"};
  for(const auto& property : internal::vertex_properties(file)) {
    const std::string& name = property.first;
    if(internal::coordinates.count(name) > 0 || colors.count(name) > 0)
      continue;
    std::vector<double> values = internal::property(points, name);
    if(!values.empty())
      result.emplace_back(name, std::move(values));
  }
  return result;
}

std::vector<double> read_ply_property(const std::string& file, const std::string& name) {
  std::vector<double> values;
  if(extension(file) == ".ply") {
    Point_set points = read_points(file);
    values = internal::property(points, name);
  }
  require(!values.empty(),
          "'" + file + "' is not a PLY file with a vertex property '" + name + "'");
  return values;
}

namespace {

bool has_colors(Point_set& points) {
  for(const char* name : {"red", "green", "blue"})
    if(internal::property(points, name).empty())
      return false;
  return true;
}

} // namespace

std::vector<Color> colors(Point_set& points, const std::string& file) {
  require(has_colors(points), "'" + file +
                                  "' has no colors: it is not a PLY file with the vertex "
                                  "properties red, green and blue");
  std::vector<Color> result(points.size());
  std::size_t k = 0;
  for(const char* name : {"red", "green", "blue"}) {
    const double full = points.has_property_map<std::uint8_t>(name)    ? 255
                        : points.has_property_map<std::uint16_t>(name) ? 65535
                                                                       : 1;
    const std::vector<double> values = internal::property(points, name);
    for(std::size_t v = 0; v < values.size(); ++v) {
      require(std::isfinite(values[v]),
              "'" + file + "': the color of vertex " + std::to_string(v) + " is not finite");
      result[v][k] = values[v] / full;
    }
    ++k;
  }
  return result;
}

bool has_colors(const std::string& file) {
  if(extension(file) != ".ply")
    return false;
  Point_set points = read_points(file);
  return has_colors(points);
}
std::vector<Color> read_colors(const std::string& file) {
  Point_set points;
  if(extension(file) == ".ply")
    points = read_points(file);
  return colors(points, file);
}

} // namespace examples
