// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_FILES_INTERNAL_GOCAD_FILE_H
#define CGAL_RESTRICTED_LAPLACIAN_3_FILES_INTERNAL_GOCAD_FILE_H

#include <CGAL/Restricted_laplacian_3/files/internal/Byte_source.h>
#include <CGAL/Restricted_laplacian_3/files/internal/File_contents.h>
#include <CGAL/Restricted_laplacian_3/files/internal/Text_source.h>

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// Reads the vertices and triangles of a GOCAD file of TSurf; several surfaces become one.
class Gocad_reader {
public:
  Gocad_reader(Byte_source& in, File_contents& contents) : m_in(in), m_contents(contents) {}

  /// \throws File_error
  void read() {
    std::string_view word;
    bool is_first = true;
    while(m_in.next_line()) {
      m_in.next_word(word);
      if(is_first && word != "GOCAD")
        m_in.fail("a GOCAD file begins with 'GOCAD', not with '" + std::string(word.substr(0, 40)) +
                  "'");
      is_first = false;
      if(word == "GOCAD")
        begin_surface();
      else if(word == "VRTX" || word == "PVRTX")
        read_vertex();
      else if(word == "ATOM" || word == "PATOM")
        read_copy();
      else if(word == "TRGL")
        read_triangle();
    }
  }

private:
  void begin_surface() {
    std::string_view type;
    if(!m_in.next_word(type) || lower(type) != "tsurf")
      m_in.fail("holds a " + std::string(type.substr(0, 40)) +
                "; of GOCAD files only TSurf is read");
    m_vertices.clear();
  }

  void read_vertex() {
    File_place place;
    place.vertex = m_contents.points.size();
    if(*place.vertex >= File_contents::maximum_number)
      m_in.fail("there are too many vertices");
    const std::int64_t name = m_in.integer("the number of a vertex", place);
    std::array<double, 3> p;
    for(double& x : p)
      x = m_in.number("a coordinate", place);
    add(name, static_cast<std::uint32_t>(m_contents.points.size()), place);
    m_contents.points.emplace_back(p[0], p[1], p[2]);
  }

  /// another number of a vertex
  void read_copy() {
    const std::int64_t name = m_in.integer("the number of a vertex");
    add(name, vertex({}), {});
  }

  void add(std::int64_t name, std::uint32_t vertex, const File_place& place) {
    if(!m_vertices.emplace(name, vertex).second)
      m_in.fail("there are two vertices " + std::to_string(name), place);
  }

  std::uint32_t vertex(const File_place& place) {
    const std::int64_t name = m_in.integer("the number of a vertex", place);
    const auto found = m_vertices.find(name);
    if(found == m_vertices.end())
      m_in.fail("names vertex " + std::to_string(name) + ", which is not there", place);
    return found->second;
  }

  void read_triangle() {
    File_place place;
    place.face = m_contents.number_of_faces();
    std::array<std::uint32_t, 3> corners;
    for(std::uint32_t& corner : corners)
      corner = vertex(place);
    m_contents.add_face(corners.data(), 3);
  }

  Text_source m_in;
  File_contents& m_contents;
  std::unordered_map<std::int64_t, std::uint32_t> m_vertices; // of the surface
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_FILES_INTERNAL_GOCAD_FILE_H
