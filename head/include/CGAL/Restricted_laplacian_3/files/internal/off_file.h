// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_FILES_INTERNAL_OFF_FILE_H
#define CGAL_RESTRICTED_LAPLACIAN_3_FILES_INTERNAL_OFF_FILE_H

#include <CGAL/Restricted_laplacian_3/files/internal/Byte_source.h>
#include <CGAL/Restricted_laplacian_3/files/internal/File_contents.h>
#include <CGAL/Restricted_laplacian_3/files/internal/Text_source.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// Reads an OFF file of Geomview: `[ST][C][N][4][n]OFF [BINARY]`. The colors of faces are passed
/// over.
class Off_reader {
public:
  Off_reader(Byte_source& in, File_contents& contents)
    : m_bytes(in), m_in(in), m_contents(contents) {}

  /// \throws File_error
  void read() {
    read_header();
    std::uintmax_t vertices, faces;
    if(m_is_binary) {
      m_bytes.set_little_endian(false);
      vertices = binary_count("vertices");
      faces = binary_count("faces");
      binary_count("edges");
    } else
      read_counts(vertices, faces);
    if(m_has_weight)
      ++m_dimension;
    const std::size_t numbers =
        m_dimension + (m_has_normals ? 3 : 0) + (m_has_colors ? 3 : 0) + (m_has_texture ? 2 : 0);
    require_room(vertices, m_is_binary ? 4 * (numbers + (m_has_colors ? 1 : 0)) : 2 * numbers,
                 "vertices");
    require_room(faces, m_is_binary ? 20 : 8, "faces");
    m_contents.points.reserve(vertices);
    for(std::uintmax_t i = 0; i < vertices; ++i)
      read_vertex(i, numbers);
    add_properties();
    m_contents.triangles.reserve(faces);
    for(std::uintmax_t i = 0; i < faces; ++i)
      read_face(i);
    if(m_is_binary ? m_bytes.bytes_left() > 0 : m_in.next_line())
      m_contents.warnings.push_back("there is more in the file than its numbers of vertices and "
                                    "faces say");
  }

private:
  [[noreturn]] void fail(const std::string& reason, const File_place& place = {}) const {
    if(m_is_binary)
      m_bytes.fail(reason, place);
    m_in.fail(reason, place);
  }

  void read_header() {
    std::string_view word;
    if(!m_in.next_line() || !m_in.next_word(word))
      m_in.fail("is no OFF file: it has no words");
    // without the keyword the numbers come first
    if(const auto number = integer_of(word)) {
      m_first_count = *number;
      m_has_first_count = true;
      return;
    }
    std::string keyword(word);
    const auto takes = [&keyword](const std::string& prefix) {
      const bool is_there = keyword.compare(0, prefix.size(), prefix) == 0;
      if(is_there)
        keyword.erase(0, prefix.size());
      return is_there;
    };
    if(keyword.size() < 3 || keyword.compare(keyword.size() - 3, 3, "OFF") != 0)
      m_in.fail("an OFF file begins with 'OFF', not with '" + keyword.substr(0, 40) + "'");
    // in the order of the format, and in any other one
    for(bool has_more = true; has_more && keyword != "OFF";) {
      has_more = false;
      const auto take = [&](const char* prefix, bool& is_set) {
        if(keyword != "OFF" && takes(prefix))
          is_set = has_more = true;
      };
      take("ST", m_has_texture);
      take("C", m_has_colors);
      take("N", m_has_normals);
      take("4", m_has_weight);
      take("n", m_has_dimension);
    }
    if(keyword != "OFF")
      m_in.fail("'" + std::string(word.substr(0, 40)) + "' is no keyword of OFF files");
    if(!m_in.next_word(word)) {
      read_dimension();
      return;
    }
    if(word == "BINARY") {
      m_is_binary = true;
      m_in.rest_of_line();
      m_in.end_line();
      read_dimension();
    } else if(const auto number = integer_of(word); number && !m_has_dimension) {
      m_first_count = *number;
      m_has_first_count = true;
    } else
      m_in.fail("'" + std::string(word.substr(0, 40)) +
                "' stands where the number of vertices is "
                "expected");
  }

  void read_dimension() {
    if(!m_has_dimension)
      return;
    std::int64_t dimension;
    if(m_is_binary) {
      m_bytes.set_little_endian(false);
      dimension = static_cast<std::int64_t>(binary_count("dimensions"));
    } else {
      if(!m_in.next_line())
        m_in.fail("the dimension is missing");
      dimension = m_in.integer("the dimension");
    }
    if(dimension != 3)
      fail("has points of dimension " + std::to_string(dimension) + ", not 3");
  }

  void read_counts(std::uintmax_t& vertices, std::uintmax_t& faces) {
    if(!m_has_first_count) {
      if(!m_in.next_line())
        m_in.fail("the numbers of vertices and faces are missing");
      m_first_count = m_in.integer("the number of vertices");
    }
    vertices = count(m_first_count, "vertices");
    if(m_in.is_at_end_of_line() && !m_in.next_line())
      m_in.fail("the number of faces is missing");
    faces = count(m_in.integer("the number of faces"), "faces");
    // that of edges may be missing, and is never used
    m_in.rest_of_line();
  }

  std::uintmax_t count(std::int64_t number, const char* what) const {
    if(number < 0 || static_cast<std::uintmax_t>(number) > File_contents::maximum_number)
      fail("the number of " + std::string(what) + " is " + std::to_string(number));
    return static_cast<std::uintmax_t>(number);
  }

  std::uintmax_t binary_count(const char* what) { return count(binary_integer({}), what); }

  std::int32_t binary_integer(const File_place& place) {
    if(!m_bytes.holds(1, 4))
      m_bytes.fail("the file ends too early", place);
    return m_bytes.number_at<std::int32_t>(m_bytes.next(4));
  }

  void require_room(std::uintmax_t number, std::size_t size, const char* what) const {
    if(number > (m_bytes.bytes_left() + 1) / size)
      fail("the " + std::to_string(number) + " " + what + " do not fit into the " +
           std::to_string(m_bytes.bytes_left()) + " bytes that are left");
  }

  double coordinate(const File_place& place) {
    if(!m_is_binary)
      return m_in.number("a coordinate", place);
    if(!m_bytes.holds(1, 4))
      m_bytes.fail("the file ends too early", place);
    return m_bytes.number_at<float>(m_bytes.next(4));
  }

  /// \param least how many numbers there are at least; a color may have one more
  void read_vertex(std::uintmax_t i, std::size_t least) {
    File_place place;
    place.vertex = i;
    if(!m_is_binary && !m_in.next_line())
      m_in.fail("the file ends too early", place);
    std::array<double, 13> numbers;
    std::size_t number = 0;
    for(; number < least; ++number)
      numbers[number] = coordinate(place);
    if(m_has_colors && (m_is_binary || !m_in.is_at_end_of_line()))
      numbers[number++] = coordinate(place);
    if(m_has_weight)
      for(std::size_t k = 0; k < 3; ++k)
        numbers[k] /= numbers[3];
    m_contents.points.emplace_back(numbers[0], numbers[1], numbers[2]);
    if(!m_contents.wants_properties())
      return;
    // behind the coordinates: normal, color, place in a texture
    const double* from = numbers.data() + m_dimension;
    if(m_has_normals) {
      m_normals.insert(m_normals.end(), from, from + 3);
      from += 3;
    }
    if(m_has_colors) {
      m_colors.insert(m_colors.end(), from, from + 3);
      from = numbers.data() + number - (m_has_texture ? 2 : 0);
    }
    if(m_has_texture)
      m_texture.insert(m_texture.end(), from, from + 2);
  }

  void add_properties() {
    add_columns(m_normals, {"nx", "ny", "nz"}, "float64");
    // from 0 to 1, or integers up to 255
    const bool is_integer =
        !m_colors.empty() && *std::max_element(m_colors.begin(), m_colors.end()) > 1;
    add_columns(m_colors, {"red", "green", "blue"}, is_integer ? "uint8" : "float64");
    add_columns(m_texture, {"s", "t"}, "float64");
  }

  void add_columns(const std::vector<double>& values, const std::vector<const char*>& names,
                   const char* type) {
    if(values.empty())
      return;
    for(std::size_t k = 0; k < names.size(); ++k) {
      Vertex_property property{names[k], type, {}};
      for(std::size_t i = k; i < values.size(); i += names.size())
        property.values.push_back(values[i]);
      m_contents.properties.push_back(std::move(property));
    }
  }

  void read_face(std::uintmax_t i) {
    File_place place;
    place.face = i;
    if(!m_is_binary && !m_in.next_line())
      m_in.fail("the file ends too early", place);
    const std::int64_t size =
        m_is_binary ? binary_integer(place) : m_in.integer("the number of corners", place);
    if(size < 3)
      fail("has " + std::to_string(size) + " corners", place);
    if(static_cast<std::uintmax_t>(size) > (m_bytes.bytes_left() + 1) / (m_is_binary ? 4 : 2))
      fail("its " + std::to_string(size) + " corners do not fit into the bytes that are left",
           place);
    m_corners.clear();
    for(std::int64_t k = 0; k < size; ++k) {
      const std::int64_t corner =
          m_is_binary ? binary_integer(place) : m_in.integer("the number of a vertex", place);
      if(corner < 0 || static_cast<std::uintmax_t>(corner) >= m_contents.points.size())
        fail("names vertex " + std::to_string(corner) + ", of " +
                 std::to_string(m_contents.points.size()),
             place);
      m_corners.push_back(static_cast<std::uint32_t>(corner));
    }
    m_contents.add_face(m_corners.data(), m_corners.size());
    if(!m_is_binary)
      return; // the rest of the line may be a color
    const std::int64_t colors = binary_integer(place);
    if(colors < 0 || !m_bytes.holds(static_cast<std::uintmax_t>(colors), 4))
      fail("its color does not fit into the bytes that are left", place);
    m_bytes.skip(4 * static_cast<std::uintmax_t>(colors));
  }

  Byte_source& m_bytes;
  Text_source m_in;
  File_contents& m_contents;
  bool m_has_texture = false, m_has_colors = false, m_has_normals = false, m_has_weight = false,
       m_has_dimension = false, m_is_binary = false, m_has_first_count = false;
  std::int64_t m_first_count = 0;
  std::size_t m_dimension = 3;
  std::vector<double> m_normals, m_colors, m_texture; // of vertices, if they are wanted
  std::vector<std::uint32_t> m_corners;               // of a face
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_FILES_INTERNAL_OFF_FILE_H
