// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "binary_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <map>
#include <sstream>
#include <system_error>
#include <unordered_map>
#include <utility>

namespace examples {

namespace {

constexpr std::uint32_t most_points = (std::numeric_limits<std::uint32_t>::max)();

// Numbers one after the other, until there are no more.
class Byte_reader {
public:
  Byte_reader(const char* begin, const char* end, bool is_swapped)
    : m_next(begin), m_end(end), m_is_swapped(is_swapped) {}

  // whether there are so many bytes
  bool has(std::size_t number) const { return static_cast<std::size_t>(m_end - m_next) >= number; }
  const char* skip(std::size_t number) {
    const char* const from = m_next;
    m_next += number;
    return from;
  }
  template <typename Number> Number number_at(const char* from) const {
    std::array<char, sizeof(Number)> bytes;
    std::copy_n(from, bytes.size(), bytes.begin());
    if(m_is_swapped)
      std::reverse(bytes.begin(), bytes.end());
    Number result;
    std::memcpy(&result, bytes.data(), sizeof(Number));
    return result;
  }

private:
  const char *m_next, *m_end;
  bool m_is_swapped;
};

bool is_little_endian() {
  const std::uint16_t one = 1;
  char first;
  std::memcpy(&first, &one, 1);
  return first == 1;
}

struct Property {
  std::string name, type;
  std::string type_of_count; // empty unless it is a list
};

struct Element {
  std::string name;
  std::size_t number;
  std::vector<Property> properties;
};

// 0 if there is no such type
std::size_t size_of(const std::string& type) {
  static const std::map<std::string, std::size_t> sizes = {
      {"char", 1},  {"uchar", 1},   {"int8", 1},   {"uint8", 1},  {"short", 2}, {"ushort", 2},
      {"int16", 2}, {"uint16", 2},  {"int", 4},    {"uint", 4},   {"int32", 4}, {"uint32", 4},
      {"float", 4}, {"float32", 4}, {"double", 8}, {"float64", 8}};
  const auto size = sizes.find(type);
  return size == sizes.end() ? 0 : size->second;
}

struct Header {
  bool is_swapped = false;
  std::vector<Element> elements;
  std::size_t size = 0; // in bytes
};

// the header of a binary PLY file whose types are known
std::optional<Header> read_header(const std::string& bytes) {
  Header header;
  bool is_binary = false;
  std::size_t begin = 0;
  for(bool is_first = true;; is_first = false) {
    const std::size_t end = bytes.find('\n', begin);
    if(end == std::string::npos)
      return std::nullopt;
    std::istringstream line(bytes.substr(begin, end - begin));
    begin = end + 1;
    std::string keyword, word;
    line >> keyword;
    if(is_first != (keyword == "ply"))
      return std::nullopt;
    if(keyword == "format") {
      line >> word;
      is_binary = word == "binary_little_endian" || word == "binary_big_endian";
      header.is_swapped = (word == "binary_little_endian") != is_little_endian();
    } else if(keyword == "element") {
      header.elements.emplace_back();
      if(!(line >> header.elements.back().name >> header.elements.back().number))
        return std::nullopt;
    } else if(keyword == "property" && !header.elements.empty()) {
      Property property;
      line >> property.type;
      if(property.type == "list") {
        line >> property.type_of_count >> property.type;
        // counts of one byte, as they are everywhere
        if(size_of(property.type_of_count) != 1)
          return std::nullopt;
      }
      if(!(line >> property.name) || size_of(property.type) == 0)
        return std::nullopt;
      header.elements.back().properties.push_back(property);
    } else if(keyword == "end_header")
      break;
  }
  header.size = begin;
  return is_binary ? std::optional<Header>(header) : std::nullopt;
}

bool read_vertices(const Element& element, Byte_reader& in, std::vector<RL::Point_3>& points) {
  std::size_t stride = 0, found = 0;
  std::array<std::size_t, 3> offsets = {};
  std::array<bool, 3> is_double = {};
  for(const Property& property : element.properties) {
    if(!property.type_of_count.empty())
      return false;
    for(std::size_t axis = 0; axis < 3; ++axis)
      if(property.name == std::string(1, static_cast<char>('x' + axis))) {
        const bool is_float = property.type == "float" || property.type == "float32";
        is_double[axis] = property.type == "double" || property.type == "float64";
        if(!is_float && !is_double[axis])
          return false;
        offsets[axis] = stride;
        ++found;
      }
    stride += size_of(property.type);
  }
  if(found != 3 || element.number > most_points || !in.has(stride * element.number))
    return false;
  points.reserve(element.number);
  for(std::size_t i = 0; i < element.number; ++i) {
    const char* const vertex = in.skip(stride);
    const auto coordinate = [&](std::size_t axis) {
      const char* const from = vertex + offsets[axis];
      return is_double[axis] ? in.number_at<double>(from) : in.number_at<float>(from);
    };
    points.emplace_back(coordinate(0), coordinate(1), coordinate(2));
  }
  return true;
}

bool read_faces(const Element& element, Byte_reader& in, Triangle_soup& soup) {
  const auto names_corners = [](const Property& property) {
    const std::string& type = property.type;
    return !property.type_of_count.empty() &&
           (property.name == "vertex_indices" || property.name == "vertex_index") &&
           (type == "int" || type == "int32" || type == "uint" || type == "uint32");
  };
  const auto& properties = element.properties;
  if(std::count_if(properties.begin(), properties.end(), names_corners) != 1)
    return false;
  struct Part {
    bool is_list, holds_corners;
    std::size_t size;
  };
  std::vector<Part> parts;
  for(const Property& property : properties)
    parts.push_back(
        {!property.type_of_count.empty(), names_corners(property), size_of(property.type)});
  // a face without corners takes a byte
  if(!in.has(element.number))
    return false;
  soup.triangles.reserve(element.number);
  for(std::size_t i = 0; i < element.number; ++i)
    for(const Part& part : parts) {
      std::size_t number = 1;
      if(part.is_list) {
        if(!in.has(1))
          return false;
        number = static_cast<unsigned char>(*in.skip(1));
      }
      if(!in.has(number * part.size) || (part.holds_corners && number != 3))
        return false;
      const char* const from = in.skip(number * part.size);
      if(!part.holds_corners)
        continue;
      RL::Triangulated_surface_3::Triangle triangle;
      for(std::size_t k = 0; k < 3; ++k) {
        triangle[k] = in.number_at<std::uint32_t>(from + part.size * k);
        if(triangle[k] >= soup.points.size()) // so are negative ones
          return false;
      }
      soup.triangles.push_back(triangle);
    }
  return true;
}

std::optional<Triangle_soup> read_ply(const std::string& bytes) {
  const std::optional<Header> header = read_header(bytes);
  // vertices and faces first, in this order, as everybody writes them
  if(!header || header->elements.size() < 2 ||
     (header->elements[0].name != "vertex" && header->elements[0].name != "vertices") ||
     (header->elements[1].name != "face" && header->elements[1].name != "faces"))
    return std::nullopt;
  Byte_reader in(bytes.data() + header->size, bytes.data() + bytes.size(), header->is_swapped);
  Triangle_soup soup;
  if(!read_vertices(header->elements[0], in, soup.points) ||
     !read_faces(header->elements[1], in, soup))
    return std::nullopt;
  return soup;
}

std::optional<Triangle_soup> read_stl(const std::string& bytes) {
  constexpr std::size_t size_of_header = 80, size_of_triangle = 50;
  if(bytes.size() < size_of_header + 4 || bytes.compare(0, 5, "solid") == 0)
    return std::nullopt;
  Byte_reader in(bytes.data() + size_of_header, bytes.data() + bytes.size(), !is_little_endian());
  const std::size_t number = in.number_at<std::uint32_t>(in.skip(4));
  if(number > most_points / 3 || !in.has(size_of_triangle * number))
    return std::nullopt;
  Triangle_soup soup;
  soup.triangles.reserve(number);
  using Position = std::array<float, 3>;
  const auto hash = [](const Position& p) {
    std::size_t result = 0;
    for(const float x : p)
      result = result * 1000003 + std::hash<float>()(x); // the same for 0 and -0
    return result;
  };
  std::unordered_map<Position, std::uint32_t, decltype(hash)> numbers(number, hash);
  for(std::size_t i = 0; i < number; ++i) {
    const char* const from = in.skip(size_of_triangle);
    RL::Triangulated_surface_3::Triangle triangle;
    for(std::size_t k = 0; k < 3; ++k) {
      Position p;
      for(std::size_t axis = 0; axis < 3; ++axis) {
        p[axis] = in.number_at<float>(from + 12 + 12 * k + 4 * axis); // after the normal
        if(!std::isfinite(p[axis]))
          return std::nullopt;
      }
      const auto [place, is_new] =
          numbers.insert({p, static_cast<std::uint32_t>(soup.points.size())});
      if(is_new)
        soup.points.emplace_back(p[0], p[1], p[2]);
      triangle[k] = place->second;
    }
    soup.triangles.push_back(triangle);
  }
  return soup;
}

} // namespace

std::optional<Triangle_soup> read_binary_triangles(const std::string& file) {
  const std::string format = extension(file);
  std::error_code ignored;
  if((format != ".ply" && format != ".stl") || !std::filesystem::is_regular_file(file, ignored))
    return std::nullopt;
  std::ifstream in(file, std::ios::binary | std::ios::ate);
  const std::streamoff size = in.tellg();
  if(!in.good() || size <= 0)
    return std::nullopt;
  std::string bytes(static_cast<std::size_t>(size), '\0');
  in.seekg(0);
  if(!in.read(&bytes[0], size))
    return std::nullopt;
  return format == ".ply" ? read_ply(bytes) : read_stl(bytes);
}

} // namespace examples
