// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "vertex_data.h"

#include "program.h"

#include <CGAL/Restricted_laplacian_3/files/read_mesh_file.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <set>
#include <utility>

namespace programs {

namespace internal {

namespace {

const RL::Vertex_property* find_property(const Vertex_properties& properties,
                                         const std::string& name) {
  for(const RL::Vertex_property& property : properties)
    if(property.name == name)
      return &property;
  return nullptr;
}

using Columns = std::array<const RL::Vertex_property*, 3>;

// whether three properties are there
bool find_columns(const Vertex_properties& properties, const std::array<const char*, 3>& names,
                  Columns& columns) {
  for(std::size_t k = 0; k < 3; ++k) {
    columns[k] = find_property(properties, names[k]);
    if(!columns[k])
      return false;
  }
  return true;
}

constexpr std::array<const char*, 3> names_of_colors = {"red", "green", "blue"};

} // namespace

std::vector<RL::Vector_3> normals_of(const Vertex_properties& properties) {
  std::vector<RL::Vector_3> normals;
  Columns n;
  if(find_columns(properties, {"nx", "ny", "nz"}, n))
    for(std::size_t v = 0; v < n[0]->values.size(); ++v)
      normals.emplace_back(n[0]->values[v], n[1]->values[v], n[2]->values[v]);
  return normals;
}

std::vector<Color> colors_of(const Vertex_properties& properties, const std::string& file) {
  Columns columns;
  require(find_columns(properties, names_of_colors, columns),
          "'" + file + "' has no colors: no vertex properties red, green and blue");
  std::vector<Color> result(columns[0]->values.size());
  for(std::size_t k = 0; k < 3; ++k) {
    const double full = columns[k]->type == "uint8"    ? 255
                        : columns[k]->type == "uint16" ? 65535
                                                       : 1;
    for(std::size_t v = 0; v < result.size(); ++v) {
      const double value = columns[k]->values[v];
      require(std::isfinite(value),
              "'" + file + "': the color of vertex " + std::to_string(v) + " is not finite");
      result[v][k] = value / full;
    }
  }
  return result;
}

std::vector<RL::Vertex_property> read_properties(const std::string& file) {
  check_input(file);
  return RL::read_vertex_properties(file);
}

} // namespace internal

std::vector<std::pair<std::string, std::vector<double>>>
read_vertex_values(const std::string& file) {
  static const std::set<std::string> others = {"x",  "y",   "z",     "nx",   "ny",
                                               "nz", "red", "green", "blue", "alpha"};
  std::vector<std::pair<std::string, std::vector<double>>> result;
  for(RL::Vertex_property& property : internal::read_properties(file))
    if(others.count(property.name) == 0)
      result.emplace_back(std::move(property.name), std::move(property.values));
  return result;
}

std::vector<double> read_vertex_property(const std::string& file, const std::string& name) {
  std::string names;
  for(RL::Vertex_property& property : internal::read_properties(file)) {
    if(property.name == name)
      return std::move(property.values);
    names += (names.empty() ? "" : ", ") + property.name;
  }
  throw Error("'" + file + "' has no vertex property '" + name +
              "'; there are: " + (names.empty() ? "none" : names));
}

bool has_vertex_property(const std::string& file, const std::string& name) {
  const std::vector<RL::Vertex_property> properties = internal::read_properties(file);
  return std::any_of(properties.begin(), properties.end(),
                     [&](const RL::Vertex_property& p) { return p.name == name; });
}

bool has_colors(const std::string& file) {
  internal::Columns columns;
  return internal::find_columns(internal::read_properties(file), internal::names_of_colors,
                                columns);
}

std::vector<Color> read_colors(const std::string& file) {
  return internal::colors_of(internal::read_properties(file), file);
}

} // namespace programs
