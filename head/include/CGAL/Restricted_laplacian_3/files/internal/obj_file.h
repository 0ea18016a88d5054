// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_FILES_INTERNAL_OBJ_FILE_H
#define CGAL_RESTRICTED_LAPLACIAN_3_FILES_INTERNAL_OBJ_FILE_H

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

/// Reads the vertices and the polygons of an OBJ file, and the colors that many programs write
/// behind the coordinates.
class Obj_reader {
public:
  Obj_reader(Byte_source& in, File_contents& contents)
    : m_in(in, '#', true), m_contents(contents) {}

  /// \throws File_error
  void read() {
    std::string_view word;
    while(m_in.next_line()) {
      m_in.next_word(word);
      if(word == "v")
        read_vertex();
      else if(word == "f" || word == "fo")
        read_face();
      else if(!is_known(word) && m_contents.warnings.empty())
        m_contents.warnings.push_back("line " + std::to_string(m_in.line()) + " begins with '" +
                                      std::string(word.substr(0, 40)) +
                                      "', which OBJ files do not, and is passed over");
    }
    // indices may come before their vertices
    if(m_place_of_largest.line && m_largest >= m_contents.points.size())
      throw File_error(m_in.bytes().name(), m_place_of_largest,
                       "names vertex " + std::to_string(m_largest + 1) + ", of " +
                           std::to_string(m_contents.points.size()));
    add_colors();
  }

private:
  /// what is passed over: other data of vertices, lines, points, groups, materials, curves
  static bool is_known(std::string_view word) {
    static constexpr std::string_view known[] = {
        "vt",       "vn",         "vp",        "l",      "p",      "g",      "o",    "s",
        "mg",       "usemtl",     "mtllib",    "usemap", "maplib", "bevel",  "lod",  "c_interp",
        "d_interp", "shadow_obj", "trace_obj", "ctech",  "stech",  "cstype", "deg",  "bmat",
        "step",     "curv",       "curv2",     "surf",   "parm",   "trim",   "hole", "scrv",
        "sp",       "end",        "con",       "call",   "csh",    "vc"};
    return std::find(std::begin(known), std::end(known), word) != std::end(known);
  }

  void read_vertex() {
    if(m_contents.points.size() >= File_contents::maximum_number)
      m_in.fail("there are too many vertices");
    File_place place;
    place.vertex = m_contents.points.size();
    std::array<double, 7> numbers;
    std::size_t number = 0;
    for(; number < 7 && (number < 3 || !m_in.is_at_end_of_line()); ++number)
      numbers[number] = m_in.number("a coordinate", place);
    m_contents.points.emplace_back(numbers[0], numbers[1], numbers[2]);
    // a fourth number alone is a weight, a seventh an opacity
    if(number >= 6 && m_contents.wants_properties())
      m_colors.insert(m_colors.end(), numbers.begin() + 3, numbers.begin() + 6);
  }

  void read_face() {
    File_place place;
    place.face = m_contents.number_of_faces();
    m_corners.clear();
    for(std::string_view word; m_in.next_word(word);)
      m_corners.push_back(read_corner(word, place));
    if(m_corners.size() < 3)
      m_in.fail("has " + std::to_string(m_corners.size()) + " corners", place);
    m_contents.add_face(m_corners.data(), m_corners.size());
  }

  /// VERTEX, VERTEX/TEXTURE, VERTEX//NORMAL or VERTEX/TEXTURE/NORMAL
  std::uint32_t read_corner(std::string_view word, const File_place& place) {
    const auto index = integer_of(word.substr(0, word.find('/')));
    const std::size_t slash = word.find('/');
    if(!index || (slash != std::string_view::npos &&
                  word.find_first_not_of("0123456789-/", slash) != std::string_view::npos))
      m_in.fail("'" + std::string(word.substr(0, 40)) + "' is no corner of a face", place);
    const auto number = static_cast<std::int64_t>(m_contents.points.size());
    // from 1; negative ones are counted from the last vertex back
    const std::int64_t vertex = *index > 0 ? *index - 1 : *index + number;
    if(*index == 0 || vertex < 0 ||
       vertex >= static_cast<std::int64_t>(File_contents::maximum_number))
      m_in.fail("names vertex " + std::to_string(*index) + ", of " + std::to_string(number) +
                    " so far",
                place);
    if(!m_place_of_largest.line || static_cast<std::uintmax_t>(vertex) > m_largest) {
      m_largest = static_cast<std::uintmax_t>(vertex);
      m_place_of_largest = place;
      m_place_of_largest.line = m_in.line();
    }
    return static_cast<std::uint32_t>(vertex);
  }

  /// if all vertices have them
  void add_colors() {
    if(m_colors.empty() || m_colors.size() != 3 * m_contents.points.size())
      return;
    for(std::size_t k = 0; k < 3; ++k) {
      static constexpr const char* names[] = {"red", "green", "blue"};
      Vertex_property property{names[k], "float64", {}};
      for(std::size_t i = k; i < m_colors.size(); i += 3)
        property.values.push_back(m_colors[i]);
      m_contents.properties.push_back(std::move(property));
    }
  }

  Text_source m_in;
  File_contents& m_contents;
  std::vector<std::uint32_t> m_corners; // of a face
  std::vector<double> m_colors;
  std::uintmax_t m_largest = 0; // of the indices
  File_place m_place_of_largest;
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_FILES_INTERNAL_OBJ_FILE_H
