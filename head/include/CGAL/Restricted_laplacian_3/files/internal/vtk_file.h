// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_FILES_INTERNAL_VTK_FILE_H
#define CGAL_RESTRICTED_LAPLACIAN_3_FILES_INTERNAL_VTK_FILE_H

#include <CGAL/Restricted_laplacian_3/files/internal/Byte_source.h>
#include <CGAL/Restricted_laplacian_3/files/internal/File_contents.h>
#include <CGAL/Restricted_laplacian_3/files/internal/Number_type.h>
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

/// Reads a legacy VTK file of PolyData, text or binary: points, polygons, strips of triangles and
/// data at points.
class Vtk_reader {
public:
  Vtk_reader(Byte_source& in, File_contents& contents)
    : m_bytes(in), m_in(in, 0), m_contents(contents) {}

  /// \throws File_error
  void read() {
    read_header();
    while(m_in.next_line()) {
      const std::string keyword = word("a keyword");
      if(keyword == "points")
        read_points();
      else if(keyword == "polygons" || keyword == "triangle_strips")
        keyword == "polygons" ? read_polygons() : read_strips();
      else if(keyword == "vertices" || keyword == "lines")
        read_cells([](const std::vector<std::uint32_t>&) {});
      else if(keyword == "point_data" || keyword == "cell_data")
        read_association(keyword == "point_data");
      else if(keyword == "metadata")
        skip_metadata();
      else if(!read_attribute(keyword))
        m_in.fail("'" + keyword.substr(0, 40) + "' is no keyword of VTK files of PolyData");
    }
    if(!m_has_points)
      m_in.fail("there are no points");
  }

private:
  void read_header() {
    m_in.next_line();
    const std::string first = m_in.rest_of_line();
    if(first.compare(0, 22, "# vtk DataFile Version") != 0)
      m_in.fail("a VTK file begins with '# vtk DataFile Version'");
    m_has_offsets =
        number_of(first.substr(22 + first.substr(22).find_first_not_of(" \t"))).value_or(0) >= 5.1;
    m_in.end_line();
    m_in.rest_of_line(); // the title
    m_in.end_line();
    if(!m_in.next_line())
      m_in.fail("'ASCII' or 'BINARY' is missing");
    const std::string format = word("the format");
    m_is_binary = format == "binary";
    if(!m_is_binary && format != "ascii")
      m_in.fail("'" + format.substr(0, 40) + "' is neither 'ASCII' nor 'BINARY'");
    m_bytes.set_little_endian(false);
    std::string keyword, type;
    if(m_in.next_line()) {
      keyword = word("'DATASET'");
      type = word("the kind of the data");
    }
    if(keyword != "dataset" || type != "polydata")
      m_in.fail("holds " + (type.empty() ? "nothing" : "a " + type.substr(0, 40)) +
                "; of VTK files only POLYDATA is read");
  }

  /// the next word of the line, in small letters
  std::string word(const char* what) {
    std::string_view view;
    if(!m_in.next_word(view))
      m_in.fail(std::string("the line ends where ") + what + " is expected");
    return lower(view);
  }

  std::string name() {
    std::string_view view;
    if(!m_in.next_word(view))
      m_in.fail("the line ends where a name is expected");
    // other letters than those of words are numbers
    std::string result;
    for(std::size_t i = 0; i < view.size(); ++i) {
      const auto digit = [&](std::size_t k) {
        const std::size_t value =
            std::string_view("0123456789abcdef").find(lower(view.substr(k, 1)));
        return value == std::string_view::npos ? 16u : static_cast<unsigned int>(value);
      };
      if(view[i] == '%' && i + 2 < view.size() && digit(i + 1) < 16 && digit(i + 2) < 16) {
        result += static_cast<char>(16 * digit(i + 1) + digit(i + 2));
        i += 2;
      } else
        result += view[i];
    }
    return result;
  }

  std::uintmax_t count(const char* what) {
    const std::int64_t number = m_in.integer(what);
    if(number < 0 || static_cast<std::uintmax_t>(number) > m_bytes.size())
      m_in.fail(std::string(what) + " is " + std::to_string(number) +
                ", which does not fit into the file");
    return static_cast<std::uintmax_t>(number);
  }

  Number_type type(const std::string& name) const {
    const auto found = number_type_of(name);
    if(!found)
      m_in.fail("numbers of type '" + name.substr(0, 40) + "' are not read");
    return *found;
  }

  /// Reads so many numbers, and gives each to `keep`.
  template <class Keep>
  void read_numbers(std::uintmax_t number, Number_type type, const char* what, Keep&& keep) {
    const std::size_t size = m_is_binary ? size_of(type) : 2;
    if(m_is_binary)
      begin_binary();
    if(number > (m_bytes.bytes_left() + (m_is_binary ? 0 : 1)) / size)
      m_in.fail("the " + std::to_string(number) + " numbers of " + what + " do not fit into the " +
                std::to_string(m_bytes.bytes_left()) + " bytes that are left");
    for(std::uintmax_t i = 0; i < number; ++i)
      if(m_is_binary)
        keep(number_at(m_bytes, m_bytes.next(size), type));
      else {
        if(m_in.is_at_end_of_line() && !m_in.next_line())
          m_in.fail(std::string("the file ends too early: it has ") + std::to_string(i) + " of " +
                    std::to_string(number) + " numbers of " + what);
        keep(m_in.number(what));
      }
  }

  /// bytes begin behind the line
  void begin_binary() {
    m_in.rest_of_line();
    m_in.end_line();
  }

  /// an index, or a length, which is exact in a double
  std::uint32_t index_of(double value, const char* what) const {
    if(!(value >= 0 && value <= static_cast<double>(File_contents::maximum_number)) ||
       value != static_cast<double>(static_cast<std::uint32_t>(value)))
      m_in.fail(std::string(what) + " is " + std::to_string(value));
    return static_cast<std::uint32_t>(value);
  }

  void read_points() {
    if(m_has_points)
      m_in.fail("there are two lists of points");
    m_has_points = true;
    const std::uintmax_t number = count("the number of points");
    if(number > File_contents::maximum_number)
      m_in.fail("there are too many points");
    std::array<double, 3> p;
    std::size_t axis = 0;
    read_numbers(3 * number, type(word("the type of the points")), "points", [&](double x) {
      p[axis++] = x;
      if(axis == 3) {
        m_contents.points.emplace_back(p[0], p[1], p[2]);
        axis = 0;
      }
    });
  }

  /// The cells behind a keyword, each to `keep`. Before version 5.1 the number of corners stands
  /// before the corners of each; from then on where they begin comes first, and then all corners.
  template <class Keep> void read_cells(Keep&& keep) {
    const std::uintmax_t number = count("the number of cells"),
                         size = count("the size of the cells");
    std::vector<std::uint32_t> corners;
    if(!m_has_offsets) {
      std::uintmax_t remaining = 0, cells = 0;
      read_numbers(size, Number_type::int32, "cells", [&](double value) {
        if(remaining == 0) {
          remaining = index_of(value, "the number of corners");
          ++cells;
        } else {
          corners.push_back(index_of(value, "the number of a point"));
          --remaining;
        }
        if(remaining == 0) {
          keep(corners);
          corners.clear();
        }
      });
      if(remaining > 0 || cells != number)
        m_in.fail("the cells do not have the size that stands before them");
      return;
    }
    if(number == 0)
      return;
    std::vector<std::uint32_t> offsets;
    expect_line("offsets");
    read_numbers(number, type(word("the type of the offsets")), "offsets", [&](double value) {
      offsets.push_back(index_of(value, "an offset"));
      if(offsets.back() > size || (offsets.size() > 1 && offsets.back() < offsets.end()[-2]))
        m_in.fail("the offsets do not grow up to " + std::to_string(size));
    });
    if(offsets.front() != 0 || offsets.back() != size)
      m_in.fail("the offsets do not reach from 0 to " + std::to_string(size));
    expect_line("connectivity");
    std::size_t cell = 1;
    const auto finish = [&] {
      for(; cell < offsets.size() && offsets[cell] - offsets[cell - 1] == corners.size(); ++cell) {
        keep(corners);
        corners.clear();
      }
    };
    finish();
    read_numbers(size, type(word("the type of the corners")), "corners", [&](double value) {
      corners.push_back(index_of(value, "the number of a point"));
      finish();
    });
  }

  void expect_line(const char* keyword) {
    if(!m_in.next_line() || word("a keyword") != keyword)
      m_in.fail(std::string("'") + keyword + "' is expected");
  }

  void read_polygons() {
    read_cells([this](const std::vector<std::uint32_t>& corners) {
      if(corners.size() < 3)
        fail_at_face("has " + std::to_string(corners.size()) + " corners");
      add_face(corners.data(), corners.size());
    });
  }

  void read_strips() {
    read_cells([this](const std::vector<std::uint32_t>& corners) {
      for(std::size_t k = 2; k < corners.size(); ++k) {
        const std::uint32_t triangle[] = {corners[k - 2 + k % 2], corners[k - 1 - k % 2],
                                          corners[k]};
        add_face(triangle, 3);
      }
    });
  }

  void add_face(const std::uint32_t* corners, std::size_t number) {
    for(std::size_t k = 0; k < number; ++k)
      if(!m_has_points || corners[k] >= m_contents.points.size())
        fail_at_face("names vertex " + std::to_string(corners[k]) + ", of " +
                     std::to_string(m_contents.points.size()));
    m_contents.add_face(corners, number);
  }

  [[noreturn]] void fail_at_face(const std::string& reason) const {
    File_place place;
    place.face = m_contents.number_of_faces();
    if(m_is_binary)
      m_bytes.fail(reason, place);
    m_in.fail(reason, place);
  }

  void read_association(bool is_of_points) {
    m_number_of_tuples = count("the number of values");
    m_is_of_points = is_of_points;
    if(is_of_points && m_number_of_tuples != m_contents.points.size())
      m_in.fail("there are " + std::to_string(m_number_of_tuples) + " values at " +
                std::to_string(m_contents.points.size()) + " points");
  }

  /// the data behind a keyword; \return whether it is known
  bool read_attribute(const std::string& keyword) {
    static const std::vector<std::string> normals = {"nx", "ny", "nz"},
                                          colors = {"red", "green", "blue", "alpha"},
                                          texture = {"s", "t"};
    if(keyword == "scalars") {
      const std::string its_name = name();
      const Number_type its_type = type(word("the type of the values"));
      const std::uintmax_t components =
          m_in.is_at_end_of_line() ? 1 : count("the number of components");
      expect_line("lookup_table");
      m_in.rest_of_line(); // its name
      read_array(its_name, {}, components, m_number_of_tuples, its_type, m_is_of_points);
    } else if(keyword == "color_scalars") {
      const std::string its_name = name();
      read_array(its_name, colors, count("the number of components"), m_number_of_tuples,
                 m_is_binary ? Number_type::uint8 : Number_type::float32, m_is_of_points);
    } else if(keyword == "lookup_table") {
      const std::string its_name = name();
      read_array(its_name, {}, 4, count("the length of the table"),
                 m_is_binary ? Number_type::uint8 : Number_type::float32, false);
    } else if(keyword == "texture_coordinates") {
      const std::string its_name = name();
      const std::uintmax_t components = count("the number of components");
      read_array(its_name, texture, components, m_number_of_tuples,
                 type(word("the type of the values")), m_is_of_points);
    } else if(keyword == "field") {
      name();
      read_field(count("the number of arrays"));
    } else {
      const std::uintmax_t components =
          keyword == "vectors" || keyword == "normals"                                      ? 3
          : keyword == "tensors"                                                            ? 9
          : keyword == "tensors6"                                                           ? 6
          : keyword == "global_ids" || keyword == "pedigree_ids" || keyword == "edge_flags" ? 1
                                                                                            : 0;
      if(components == 0)
        return false;
      const std::string its_name = name();
      read_array(its_name, keyword == "normals" ? normals : std::vector<std::string>(), components,
                 m_number_of_tuples, type(word("the type of the values")), m_is_of_points);
    }
    return true;
  }

  void read_field(std::uintmax_t number_of_arrays) {
    for(std::uintmax_t i = 0; i < number_of_arrays; ++i) {
      std::string its_name;
      do {
        if(!m_in.next_line())
          m_in.fail("the file ends too early: it has " + std::to_string(i) + " of " +
                    std::to_string(number_of_arrays) + " arrays");
        its_name = name();
        if(lower(its_name) == "metadata" && m_in.is_at_end_of_line())
          skip_metadata();
        else
          break;
      } while(true);
      const std::uintmax_t components = count("the number of components"),
                           tuples = count("the number of values");
      read_array(its_name, {}, components, tuples, type(word("the type of the values")),
                 m_is_of_points && tuples == m_number_of_tuples);
    }
  }

  /// \param names of the components; by default numbers behind that of the array
  void read_array(const std::string& its_name, const std::vector<std::string>& names,
                  std::uintmax_t components, std::uintmax_t tuples, Number_type its_type,
                  bool is_kept) {
    if(components > 0 && tuples > m_bytes.size() / components)
      m_in.fail("the values of '" + its_name + "' do not fit into the file");
    is_kept = is_kept && m_contents.wants_properties() && components > 0;
    const std::size_t first = m_contents.properties.size();
    for(std::size_t k = 0; k < components && is_kept; ++k)
      m_contents.properties.push_back({k < names.size()  ? names[k]
                                       : components == 1 ? its_name
                                                         : its_name + '_' + std::to_string(k),
                                       name_of(its_type),
                                       {}});
    std::uintmax_t i = 0;
    read_numbers(components * tuples, its_type, "values", [&](double value) {
      if(is_kept)
        m_contents.properties[first + static_cast<std::size_t>(i++ % components)].values.push_back(
            value);
    });
  }

  /// up to a blank line
  void skip_metadata() {
    m_in.rest_of_line();
    while(m_in.end_line())
      if(m_in.rest_of_line().find_first_not_of(" \t") == std::string::npos)
        return;
  }

  Byte_source& m_bytes;
  Text_source m_in;
  File_contents& m_contents;
  bool m_is_binary = false, m_has_points = false, m_has_offsets = false;
  // of the data at points or cells
  bool m_is_of_points = false;
  std::uintmax_t m_number_of_tuples = 0;
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_FILES_INTERNAL_VTK_FILE_H
