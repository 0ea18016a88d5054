// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_EXAMPLES_PLY_PROPERTY_H
#define RESTRICTED_LAPLACIAN_3_EXAMPLES_PLY_PROPERTY_H

// Reads one number per vertex from a PLY file, whatever its type.

#include "program.h"

#include <CGAL/IO/PLY.h>
#include <CGAL/IO/read_ply_points.h>
#include <CGAL/property_map.h>

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace examples {

namespace internal {

// The type that the header of a PLY file gives to a property of its vertices; empty if there is no
// such property.
inline std::string ply_property_type(const std::string& file, const std::string& property) {
  std::ifstream in(file, std::ios::binary);
  bool is_in_vertices = false;
  for(std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string keyword, type, name;
    words >> keyword >> type >> name;
    if(keyword == "end_header")
      break;
    if(keyword == "element")
      is_in_vertices = type == "vertex" || type == "vertices";
    else if(keyword == "property" && is_in_vertices && type != "list" && name == property)
      return type;
  }
  return {};
}

template <typename Number>
std::vector<double> read_ply_numbers(const std::string& file, const std::string& property) {
  std::ifstream in(file, std::ios::binary);
  std::vector<Number> numbers;
  const bool is_read = CGAL::IO::read_PLY_with_properties(
      in, std::back_inserter(numbers),
      std::make_pair(CGAL::Identity_property_map<Number>(),
                     CGAL::IO::PLY_property<Number>(property.c_str())));
  require(is_read, "cannot read the property '" + property + "' of '" + file + "'");
  return {numbers.begin(), numbers.end()};
}

} // namespace internal

// The values of a vertex property, in the order of the file.
inline std::vector<double> read_ply_property(const std::string& file, const std::string& property) {
  using namespace internal;
  const std::string type = ply_property_type(file, property);
  if(type == "double" || type == "float64")
    return read_ply_numbers<double>(file, property);
  if(type == "float" || type == "float32")
    return read_ply_numbers<float>(file, property);
  if(type == "int" || type == "int32")
    return read_ply_numbers<std::int32_t>(file, property);
  if(type == "uint" || type == "uint32")
    return read_ply_numbers<std::uint32_t>(file, property);
  if(type == "short" || type == "int16")
    return read_ply_numbers<std::int16_t>(file, property);
  if(type == "ushort" || type == "uint16")
    return read_ply_numbers<std::uint16_t>(file, property);
  if(type == "char" || type == "int8")
    return read_ply_numbers<std::int8_t>(file, property);
  if(type == "uchar" || type == "uint8")
    return read_ply_numbers<std::uint8_t>(file, property);
  throw Error("'" + file + "' is not a PLY file with a vertex property '" + property + "'");
}

} // namespace examples

#endif // RESTRICTED_LAPLACIAN_3_EXAMPLES_PLY_PROPERTY_H
