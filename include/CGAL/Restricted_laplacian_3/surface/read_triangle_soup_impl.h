// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_READ_TRIANGLE_SOUP_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_READ_TRIANGLE_SOUP_IMPL_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/name_step.h>
#include <CGAL/Restricted_laplacian_3/surface/internal/Binary_reader.h>
#include <CGAL/Restricted_laplacian_3/surface/internal/Point_table.h>
#include <CGAL/Restricted_laplacian_3/surface/read_triangle_soup.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// What ends the reading of a file that is left to others.
struct Unreadable {};

inline void require_readable(bool condition) {
  if(!condition)
    throw Unreadable();
}

/// Reads a binary PLY file with vertices and faces first, in this order, as everybody writes them.
class Ply_reader {
public:
  using Triangle = Triangulated_surface_3::Triangle;

  Ply_reader(Binary_reader& in, std::vector<Point_3>& points, std::vector<Triangle>& triangles)
    : m_in(in), m_points(points), m_triangles(triangles) {}

  /// \throws Unreadable
  void read() {
    read_header();
    require_readable(m_elements.size() >= 2 &&
                     (m_elements[0].name == "vertex" || m_elements[0].name == "vertices") &&
                     (m_elements[1].name == "face" || m_elements[1].name == "faces"));
    read_vertices(m_elements[0]);
    read_faces(m_elements[1]);
  }

private:
  struct Property {
    std::string name, type;
    std::string type_of_count; // empty unless it is a list
  };
  struct Element {
    std::string name;
    std::size_t number = 0;
    std::vector<Property> properties;
  };

  /// in bytes; 0 if there is no such type
  static std::size_t size_of(const std::string& type) {
    static const std::map<std::string, std::size_t> sizes = {
        {"char", 1},  {"uchar", 1},   {"int8", 1},   {"uint8", 1},  {"short", 2}, {"ushort", 2},
        {"int16", 2}, {"uint16", 2},  {"int", 4},    {"uint", 4},   {"int32", 4}, {"uint32", 4},
        {"float", 4}, {"float32", 4}, {"double", 8}, {"float64", 8}};
    const auto size = sizes.find(type);
    return size == sizes.end() ? 0 : size->second;
  }

  void read_header() {
    bool is_binary = false;
    for(bool is_first = true;; is_first = false) {
      std::string text;
      require_readable(m_in.read_line(text));
      std::istringstream line(text);
      std::string keyword, word;
      line >> keyword;
      require_readable(is_first == (keyword == "ply"));
      if(keyword == "format") {
        line >> word;
        is_binary = word == "binary_little_endian" || word == "binary_big_endian";
        m_in.set_little_endian(word == "binary_little_endian");
      } else if(keyword == "element") {
        m_elements.emplace_back();
        require_readable(
            static_cast<bool>(line >> m_elements.back().name >> m_elements.back().number));
      } else if(keyword == "property" && !m_elements.empty()) {
        Property property;
        line >> property.type;
        if(property.type == "list") {
          line >> property.type_of_count >> property.type;
          // counts of one byte, as they are everywhere
          require_readable(size_of(property.type_of_count) == 1);
        }
        require_readable(line >> property.name && size_of(property.type) != 0);
        m_elements.back().properties.push_back(property);
      } else if(keyword == "end_header")
        break;
    }
    require_readable(is_binary);
  }

  void read_vertices(const Element& element) {
    std::size_t stride = 0, found = 0;
    std::array<std::size_t, 3> offsets = {};
    std::array<bool, 3> is_double = {};
    for(const Property& property : element.properties) {
      require_readable(property.type_of_count.empty());
      for(std::size_t axis = 0; axis < 3; ++axis)
        if(property.name == std::string(1, static_cast<char>('x' + axis))) {
          is_double[axis] = property.type == "double" || property.type == "float64";
          require_readable(is_double[axis] || property.type == "float" ||
                           property.type == "float32");
          offsets[axis] = stride;
          ++found;
        }
      stride += size_of(property.type);
    }
    require_readable(found == 3 && element.number <= (std::numeric_limits<std::uint32_t>::max)() &&
                     m_in.holds(element.number, stride));
    m_points.reserve(element.number);
    for(std::size_t i = 0; i < element.number; ++i) {
      const char* const vertex = m_in.next(stride);
      const auto coordinate = [&](std::size_t axis) {
        const char* const from = vertex + offsets[axis];
        return is_double[axis] ? m_in.number_at<double>(from) : m_in.number_at<float>(from);
      };
      m_points.emplace_back(coordinate(0), coordinate(1), coordinate(2));
    }
  }

  void read_faces(const Element& element) {
    const auto names_corners = [](const Property& property) {
      const std::string& type = property.type;
      return !property.type_of_count.empty() &&
             (property.name == "vertex_indices" || property.name == "vertex_index") &&
             (type == "int" || type == "int32" || type == "uint" || type == "uint32");
    };
    struct Part {
      bool is_list, holds_corners;
      std::size_t size;
    };
    std::vector<Part> parts;
    std::size_t number_of_lists_of_corners = 0, least_size = 0;
    for(const Property& property : element.properties) {
      const bool is_list = !property.type_of_count.empty(), holds_corners = names_corners(property);
      const std::size_t size = size_of(property.type);
      parts.push_back({is_list, holds_corners, size});
      number_of_lists_of_corners += holds_corners;
      least_size += is_list ? 1 + (holds_corners ? 3 * size : 0) : size;
    }
    require_readable(number_of_lists_of_corners == 1 && m_in.holds(element.number, least_size));
    m_triangles.reserve(element.number);
    for(std::size_t i = 0; i < element.number; ++i)
      for(const Part& part : parts) {
        std::size_t number = 1;
        if(part.is_list) {
          require_readable(m_in.holds(1, 1));
          number = static_cast<unsigned char>(*m_in.next(1));
        }
        require_readable(m_in.holds(number, part.size) && (!part.holds_corners || number == 3));
        const char* const from = m_in.next(number * part.size);
        if(!part.holds_corners)
          continue;
        Triangle triangle;
        for(std::size_t k = 0; k < 3; ++k) {
          triangle[k] = m_in.number_at<std::uint32_t>(from + part.size * k);
          require_readable(triangle[k] < m_points.size()); // negative numbers are not
        }
        m_triangles.push_back(triangle);
      }
  }

  Binary_reader& m_in;
  std::vector<Point_3>& m_points;
  std::vector<Triangle>& m_triangles;
  std::vector<Element> m_elements;
};

/// \throws Unreadable
inline void read_stl(Binary_reader& in, std::vector<Point_3>& points,
                     std::vector<Triangulated_surface_3::Triangle>& triangles) {
  constexpr std::size_t size_of_header = 80, size_of_triangle = 50, size_of_normal = 12;
  require_readable(in.holds(1, size_of_header + 4));
  const std::string header(in.next(size_of_header), size_of_header);
  in.set_little_endian(true);
  const std::size_t number = in.number_at<std::uint32_t>(in.next(4));
  require_readable(number <= (std::numeric_limits<std::uint32_t>::max)() / 3 &&
                   in.holds(number, size_of_triangle));
  // so do text files begin; this one is none if it ends where it should
  if(header.compare(0, 5, "solid") == 0)
    require_readable(!in.holds(1, number * size_of_triangle + 1));
  triangles.reserve(number);
  Point_table table(points);
  for(std::size_t i = 0; i < number; ++i) {
    const char* const from = in.next(size_of_triangle) + size_of_normal;
    Triangulated_surface_3::Triangle triangle;
    for(std::size_t k = 0; k < 3; ++k) {
      std::array<float, 3> p;
      for(std::size_t axis = 0; axis < 3; ++axis) {
        p[axis] = in.number_at<float>(from + 12 * k + 4 * axis);
        require_readable(std::isfinite(p[axis]));
      }
      triangle[k] = table.number_of(p);
    }
    triangles.push_back(triangle);
  }
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE bool
read_triangle_soup(const std::string& file, std::vector<Point_3>& points,
                   std::vector<Triangulated_surface_3::Triangle>& triangles,
                   const Progress& progress) {
  points.clear();
  triangles.clear();
  const auto ends_with = [&file](const std::string& ending) {
    return file.size() >= ending.size() &&
           std::equal(ending.rbegin(), ending.rend(), file.rbegin(), [](char a, char b) {
             return a == (b >= 'A' && b <= 'Z' ? b - 'A' + 'a' : b);
           });
  };
  const bool is_ply = ends_with(".ply");
  if(!is_ply && !ends_with(".stl"))
    return false;
  try {
    name_step("not enough memory to read the file", [&] {
      Binary_reader in(file, progress);
      if(is_ply)
        Ply_reader(in, points, triangles).read();
      else
        read_stl(in, points, triangles);
    });
  } catch(const Unreadable&) {
    std::vector<Point_3>().swap(points);
    std::vector<Triangulated_surface_3::Triangle>().swap(triangles);
    return false;
  }
  progress(1);
  return true;
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_READ_TRIANGLE_SOUP_IMPL_H
