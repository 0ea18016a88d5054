// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_FILES_INTERNAL_STL_FILE_H
#define CGAL_RESTRICTED_LAPLACIAN_3_FILES_INTERNAL_STL_FILE_H

#include <CGAL/Restricted_laplacian_3/files/internal/Byte_source.h>
#include <CGAL/Restricted_laplacian_3/files/internal/File_contents.h>
#include <CGAL/Restricted_laplacian_3/files/internal/Point_table.h>
#include <CGAL/Restricted_laplacian_3/files/internal/Text_source.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// Reads an STL file. Equal points are one, in the order in which they are met.
class Stl_reader {
public:
  Stl_reader(Byte_source& in, File_contents& contents)
    : m_in(in), m_contents(contents), m_table(contents.points) {}

  /// A binary file has 84 bytes, of which the last four tell the number of triangles, and 50 for
  /// each of these. How it begins tells nothing.
  /// \throws File_error
  void read() {
    const std::string_view front = m_in.front(1024);
    const bool is_text = front.find('\0') == std::string_view::npos;
    if(front.size() >= size_of_header) {
      m_in.set_little_endian(true);
      const std::uintmax_t number = m_in.number_at<std::uint32_t>(front.data() + 80);
      const std::uintmax_t size = size_of_header + number * size_of_triangle;
      if(m_in.size() == size || (m_in.size() > size && !is_text)) {
        read_binary(number);
        return;
      }
      if(!is_text)
        m_in.fail("is neither text nor binary STL: its " + std::to_string(number) +
                  " triangles would take " + std::to_string(size) + " bytes, and it has " +
                  std::to_string(m_in.size()));
    } else if(!is_text)
      m_in.fail("is neither text nor binary STL: that has 84 bytes at least, this " +
                std::to_string(m_in.size()));
    Text_source text(m_in);
    read_text(text);
  }

private:
  static constexpr std::size_t size_of_header = 84, size_of_triangle = 50, size_of_normal = 12;

  void read_binary(std::uintmax_t number) {
    if(number > File_contents::maximum_number / 3)
      m_in.fail("has too many triangles");
    m_in.skip(size_of_header);
    m_contents.triangles.reserve(number);
    for(std::uintmax_t i = 0; i < number; ++i) {
      const char* const from = m_in.next(size_of_triangle) + size_of_normal;
      Triangulated_surface_3::Triangle triangle;
      for(std::size_t k = 0; k < 3; ++k) {
        std::array<float, 3> p;
        for(std::size_t axis = 0; axis < 3; ++axis)
          p[axis] = m_in.number_at<float>(from + 12 * k + 4 * axis);
        if(!(std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2])))
          fail_at_face("has a coordinate that is not finite");
        triangle[k] = m_table.number_of(Point_3(p[0], p[1], p[2]));
      }
      m_contents.triangles.push_back(triangle);
    }
    if(m_in.bytes_left() > 0)
      m_contents.warnings.push_back("there are " + std::to_string(m_in.bytes_left()) +
                                    " bytes more than the " + std::to_string(number) +
                                    " triangles take");
  }

  [[noreturn]] void fail_at_face(const std::string& reason) const {
    File_place place;
    place.face = m_contents.number_of_faces();
    m_in.fail(reason, place);
  }

  void read_text(Text_source& text) {
    std::string word = "a line";
    // whatever stands above
    do {
      if(!text.next_line() || !next(text, word))
        text.fail("is no STL file: no line of it begins with 'solid'");
    } while(word != "solid");
    text.rest_of_line(); // its name
    while(next(text, word)) {
      if(word == "facet")
        read_facet(text);
      else if(word == "solid" || word == "endsolid")
        text.rest_of_line();
      else
        text.fail("'" + word.substr(0, 40) + "' stands where a facet is expected");
    }
  }

  void read_facet(Text_source& text) {
    File_place place;
    place.face = m_contents.number_of_faces();
    std::string word;
    // the normal is that of the corners, whatever stands there
    for(int number_of_words = 0; word != "outer"; ++number_of_words)
      if(!next(text, word) || number_of_words == 5)
        text.fail("'outer loop' is expected", place);
    expect(text, "loop", place);
    std::vector<std::uint32_t> corners;
    for(;;) {
      if(!next(text, word))
        text.fail("the file ends in a facet", place);
      if(word == "endloop")
        break;
      if(word != "vertex")
        text.fail("'" + word.substr(0, 40) + "' stands where a vertex is expected", place);
      std::array<double, 3> p;
      for(double& x : p) {
        x = text.number("a coordinate", place);
        if(!std::isfinite(x))
          text.fail("has a coordinate that is not finite", place);
      }
      corners.push_back(m_table.number_of(Point_3(p[0], p[1], p[2])));
    }
    expect(text, "endfacet", place);
    if(corners.size() < 3)
      text.fail("has " + std::to_string(corners.size()) + " corners", place);
    m_contents.add_face(corners.data(), corners.size());
  }

  /// the next word in small letters
  static bool next(Text_source& text, std::string& word) {
    std::string_view view;
    if(!text.next_word_of_lines(view))
      return false;
    word = lower(view);
    return true;
  }

  static void expect(Text_source& text, const char* expected, const File_place& place) {
    std::string word;
    if(!next(text, word))
      text.fail("the file ends in a facet", place);
    if(word != expected)
      text.fail("'" + word.substr(0, 40) + "' stands where '" + expected + "' is expected", place);
  }

  Byte_source& m_in;
  File_contents& m_contents;
  Point_table m_table;
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_FILES_INTERNAL_STL_FILE_H
