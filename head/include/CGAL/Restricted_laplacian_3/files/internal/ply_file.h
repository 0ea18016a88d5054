// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_FILES_INTERNAL_PLY_FILE_H
#define CGAL_RESTRICTED_LAPLACIAN_3_FILES_INTERNAL_PLY_FILE_H

#include <CGAL/Restricted_laplacian_3/files/internal/Byte_source.h>
#include <CGAL/Restricted_laplacian_3/files/internal/File_contents.h>
#include <CGAL/Restricted_laplacian_3/files/internal/Number_type.h>
#include <CGAL/Restricted_laplacian_3/files/internal/Text_source.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// The numbers behind the header of a binary PLY file.
class Binary_numbers {
public:
  explicit Binary_numbers(Byte_source& in) : m_in(in) {}

  /// bytes that a number takes at least
  static std::size_t least_size(Number_type type) { return size_of(type); }

  void begin(const File_place&) {}
  void end(const File_place&) {}

  double number(Number_type type, const File_place& place) {
    return number_at(m_in, next(type, place), type);
  }
  std::int64_t integer(Number_type type, const File_place& place) {
    return integer_at(m_in, next(type, place), type);
  }
  void skip(Number_type type, std::uintmax_t number, const File_place& place) {
    if(!m_in.holds(number, size_of(type)))
      fail("the file ends too early", place);
    m_in.skip(number * size_of(type));
  }

  [[noreturn]] void fail(const std::string& reason, const File_place& place) const {
    m_in.fail(reason, place);
  }

  const Byte_source& bytes() const { return m_in; }

private:
  const char* next(Number_type type, const File_place& place) {
    if(!m_in.holds(1, size_of(type)))
      fail("the file ends too early", place);
    return m_in.next(size_of(type));
  }

  Byte_source& m_in;
};

/// Those behind the header of a PLY file of text: a vertex, a face begins a line, and may go on in
/// the next ones.
class Text_numbers {
public:
  explicit Text_numbers(Text_source& in) : m_in(in) {}

  static std::size_t least_size(Number_type) { return 2; }

  void begin(const File_place& place) {
    if(!m_in.next_line())
      fail("the file ends too early", place);
  }
  void end(const File_place& place) {
    if(!m_in.is_at_end_of_line())
      fail("the line has more numbers than there are properties", place);
  }

  double number(Number_type, const File_place& place) {
    go_on(place);
    return m_in.number("a property", place);
  }
  std::int64_t integer(Number_type, const File_place& place) {
    go_on(place);
    return m_in.integer("a length or an index", place);
  }
  void skip(Number_type type, std::uintmax_t number, const File_place& place) {
    for(std::uintmax_t i = 0; i < number; ++i)
      this->number(type, place);
  }

  [[noreturn]] void fail(const std::string& reason, const File_place& place) const {
    m_in.fail(reason, place);
  }

  const Byte_source& bytes() const { return m_in.bytes(); }

private:
  void go_on(const File_place& place) {
    if(m_in.is_at_end_of_line() && !m_in.next_line())
      fail("the file ends too early", place);
  }

  Text_source& m_in;
};

/// Reads a PLY file.
class Ply_reader {
public:
  Ply_reader(Byte_source& in, File_contents& contents) : m_in(in), m_contents(contents) {}

  /// \throws File_error
  void read() {
    Text_source text(m_in, 0);
    read_header(text);
    if(m_is_text)
      read_elements(Text_numbers(text));
    else
      read_elements(Binary_numbers(m_in));
    if(m_is_text ? text.next_line() : m_in.bytes_left() > 0)
      m_contents.warnings.push_back("there is more in the file than its header says");
  }

private:
  struct Property {
    std::string name;
    Number_type type;
    std::optional<Number_type> type_of_length; // of a list
    std::size_t column = no_column;            // of a vertex: among the properties that are kept
    int axis = -1;                             // of a vertex: among the coordinates
  };
  struct Element {
    std::string name;
    std::uintmax_t number = 0;
    std::vector<Property> properties;

    bool is(const char* singular, const char* plural) const {
      return name == singular || name == plural;
    }
    bool has_lists() const {
      for(const Property& p : properties)
        if(p.type_of_length)
          return true;
      return false;
    }
  };

  static constexpr std::size_t no_column = static_cast<std::size_t>(-1);

  static bool names_corners(const Property& p) {
    return p.type_of_length && (p.name == "vertex_indices" || p.name == "vertex_index");
  }

  Number_type read_type(Text_source& text) {
    std::string_view word;
    if(!text.next_word(word))
      text.fail("the line ends where the type of a property is expected");
    const auto type = number_type_of(std::string(word));
    if(!type)
      text.fail("'" + std::string(word) + "' is no type of PLY files");
    return *type;
  }

  std::string read_name(Text_source& text, const char* what) {
    std::string_view word;
    if(!text.next_word(word))
      text.fail(std::string("the line ends where ") + what + " is expected");
    return std::string(word);
  }

  void read_header(Text_source& text) {
    bool has_format = false;
    for(bool is_first = true;; is_first = false) {
      if(!text.next_line())
        text.fail("the header has no end ('end_header')");
      std::string_view word;
      text.next_word(word);
      if(is_first) {
        if(word != "ply")
          text.fail("a PLY file begins with 'ply', not with '" + std::string(word.substr(0, 40)) +
                    "'");
        continue;
      }
      if(word == "comment" || word == "obj_info")
        continue;
      if(word == "format") {
        const std::string format = read_name(text, "the format");
        m_is_text = format == "ascii";
        if(!m_is_text && format != "binary_little_endian" && format != "binary_big_endian")
          text.fail("'" + format + "' is no format of PLY files");
        m_in.set_little_endian(format == "binary_little_endian");
        has_format = true;
      } else if(word == "element") {
        m_elements.emplace_back();
        Element& element = m_elements.back();
        element.name = read_name(text, "the name of an element");
        const std::int64_t number = text.integer("the number of elements");
        if(number < 0)
          text.fail("the number of elements is negative");
        element.number = static_cast<std::uintmax_t>(number);
      } else if(word == "property") {
        if(m_elements.empty())
          text.fail("the property of no element");
        read_property(text, m_elements.back());
      } else if(word == "end_header")
        break;
      else
        text.fail("'" + std::string(word.substr(0, 40)) + "' does not belong to the header");
    }
    if(!has_format)
      text.fail("the header names no format");
    if(!m_is_text) {
      text.rest_of_line();
      text.end_line();
    }
  }

  void read_property(Text_source& text, Element& element) {
    Property property;
    std::string_view word;
    if(!text.next_word(word))
      text.fail("the line ends where the type of a property is expected");
    if(word == "list") {
      property.type_of_length = read_type(text);
      if(!is_integer(*property.type_of_length))
        text.fail("the length of a list is no integer");
      property.type = read_type(text);
    } else {
      const auto type = number_type_of(std::string(word));
      if(!type)
        text.fail("'" + std::string(word) + "' is no type of PLY files");
      property.type = *type;
    }
    property.name = read_name(text, "the name of a property");
    element.properties.push_back(property);
  }

  template <class Numbers> void read_elements(Numbers numbers) {
    // vertices may come behind the faces
    for(const Element& element : m_elements)
      if(element.is("vertex", "vertices"))
        m_number_of_vertices = element.number;
    bool has_vertices = false;
    for(Element& element : m_elements) {
      check_number(numbers, element);
      if(element.is("vertex", "vertices")) {
        if(has_vertices)
          numbers.fail("there are two lists of vertices", {});
        has_vertices = true;
        read_vertices(numbers, element);
      } else if(element.is("face", "faces"))
        read_faces(numbers, element);
      else if(element.is("tristrip", "tristrips"))
        read_strips(numbers, element);
      else
        skip_element(numbers, element);
    }
    if(!has_vertices)
      numbers.fail("there are no vertices", {});
  }

  /// whether so many elements can be there
  template <class Numbers> void check_number(Numbers& numbers, const Element& element) {
    std::size_t size = 0;
    for(const Property& p : element.properties) {
      size += Numbers::least_size(p.type_of_length ? *p.type_of_length : p.type);
      if(names_corners(p) && element.is("face", "faces"))
        size += 3 * Numbers::least_size(p.type);
    }
    if(element.properties.empty() && element.number > 0)
      numbers.fail("the element '" + element.name + "' has no properties", {});
    if(element.number > File_contents::maximum_number || !fits(numbers, element.number, size))
      numbers.fail("the " + std::to_string(element.number) + " elements '" + element.name +
                       "' do not fit into the " + std::to_string(numbers.bytes().bytes_left()) +
                       " bytes that are left",
                   {});
  }

  template <class Numbers>
  bool fits(const Numbers& numbers, std::uintmax_t number, std::size_t size) const {
    // the last line of a text need not end
    return size == 0 || number <= (numbers.bytes().bytes_left() + (m_is_text ? 1 : 0)) / size;
  }

  template <class Numbers> void read_vertices(Numbers& numbers, Element& element) {
    std::array<bool, 3> has_axis = {};
    for(Property& p : element.properties) {
      if(p.type_of_length)
        continue;
      for(int axis = 0; axis < 3; ++axis)
        if(p.name == std::string(1, static_cast<char>('x' + axis)) && !has_axis[axis]) {
          p.axis = axis;
          has_axis[axis] = true;
        }
      if(m_contents.wants_properties()) {
        p.column = m_contents.properties.size();
        m_contents.properties.push_back({p.name, name_of(p.type), {}});
        m_contents.properties.back().values.reserve(element.number);
      }
    }
    for(int axis = 0; axis < 3; ++axis)
      if(!has_axis[axis])
        numbers.fail("there is no vertex property '" +
                         std::string(1, static_cast<char>('x' + axis)) +
                         "'; there are: " + names_of(element),
                     {});
    m_contents.points.reserve(element.number);
    if constexpr(std::is_same_v<Numbers, Binary_numbers>)
      if(!element.has_lists()) {
        read_records(element);
        return;
      }
    for(std::uintmax_t i = 0; i < element.number; ++i) {
      File_place place;
      place.vertex = i;
      std::array<double, 3> coordinates;
      numbers.begin(place);
      for(const Property& p : element.properties)
        if(p.type_of_length)
          numbers.skip(p.type, read_length(numbers, p, place), place);
        else
          keep(p, numbers.number(p.type, place), coordinates);
      numbers.end(place);
      m_contents.points.emplace_back(coordinates[0], coordinates[1], coordinates[2]);
    }
  }

  /// binary vertices of one size, which are all there
  void read_records(const Element& element) {
    std::vector<std::pair<const Property*, std::size_t>> kept; // and where they are
    std::size_t size = 0;
    for(const Property& p : element.properties) {
      if(p.axis >= 0 || p.column != no_column)
        kept.emplace_back(&p, size);
      size += size_of(p.type);
    }
    for(std::uintmax_t i = 0; i < element.number; ++i) {
      const char* const record = m_in.next(size);
      std::array<double, 3> coordinates;
      for(const auto& [p, offset] : kept)
        keep(*p, number_at(m_in, record + offset, p->type), coordinates);
      m_contents.points.emplace_back(coordinates[0], coordinates[1], coordinates[2]);
    }
  }

  /// puts a number of a vertex where it belongs
  void keep(const Property& p, double value, std::array<double, 3>& coordinates) {
    if(p.axis >= 0)
      coordinates[static_cast<std::size_t>(p.axis)] = value;
    if(p.column != no_column)
      m_contents.properties[p.column].values.push_back(value);
  }

  static std::string names_of(const Element& element) {
    std::string names;
    for(const Property& p : element.properties)
      names += (names.empty() ? "" : ", ") + p.name;
    return names.empty() ? "none" : names;
  }

  template <class Numbers>
  std::uintmax_t read_length(Numbers& numbers, const Property& p, const File_place& place) {
    const std::int64_t length = numbers.integer(*p.type_of_length, place);
    if(length < 0)
      numbers.fail("the length of '" + p.name + "' is negative or too large", place);
    const auto result = static_cast<std::uintmax_t>(length);
    if(!fits(numbers, result, Numbers::least_size(p.type)))
      numbers.fail("the " + std::to_string(result) + " numbers of '" + p.name +
                       "' do not fit into the bytes that are left",
                   place);
    return result;
  }

  const Property& find_corners(const Element& element, const std::string& place) {
    const Property* found = nullptr;
    for(const Property& p : element.properties)
      if(names_corners(p)) {
        if(found)
          m_in.fail(place + " have two lists of vertices");
        found = &p;
      }
    if(!found)
      m_in.fail(place + " have no list 'vertex_indices' or 'vertex_index'; they have: " +
                names_of(element));
    if(!is_integer(found->type))
      m_in.fail("the indices of vertices are no integers");
    return *found;
  }

  template <class Numbers> void read_faces(Numbers& numbers, const Element& element) {
    if(element.number == 0)
      return;
    const Property& corners = find_corners(element, "faces");
    // as nearly everybody writes them
    const bool is_usual =
        !m_is_text && size_of(*corners.type_of_length) == 1 && size_of(corners.type) == 4;
    std::vector<std::uint32_t> polygon;
    if(m_contents.polygons.empty())
      m_contents.triangles.reserve(m_contents.triangles.size() + element.number);
    for(std::uintmax_t i = 0; i < element.number; ++i) {
      File_place place;
      place.face = m_contents.number_of_faces();
      numbers.begin(place);
      for(const Property& p : element.properties) {
        if(&p != &corners) {
          numbers.skip(p.type, p.type_of_length ? read_length(numbers, p, place) : 1, place);
          continue;
        }
        if(is_usual && read_triangle())
          continue;
        const std::uintmax_t length = read_length(numbers, p, place);
        if(length < 3)
          numbers.fail("has " + std::to_string(length) + " corners", place);
        polygon.clear();
        for(std::uintmax_t k = 0; k < length; ++k)
          polygon.push_back(corner(numbers, numbers.integer(p.type, place), place));
        m_contents.add_face(polygon.data(), polygon.size());
      }
      numbers.end(place);
    }
  }

  /// The next 13 bytes as a triangle; \return whether they are one, otherwise they stay.
  bool read_triangle() {
    constexpr std::size_t size = 1 + 3 * 4;
    if(!m_in.holds(1, size))
      return false;
    const char* const from = m_in.front(size).data();
    std::array<std::uint32_t, 3> corners;
    for(std::size_t k = 0; k < 3; ++k)
      corners[k] = m_in.number_at<std::uint32_t>(from + 1 + 4 * k);
    const std::uintmax_t vertices = m_number_of_vertices;
    if(*from != 3 || corners[0] >= vertices || corners[1] >= vertices || corners[2] >= vertices)
      return false;
    m_in.take(size);
    m_contents.add_face(corners.data(), 3);
    return true;
  }

  /// strips of triangles, which turn around in each; -1 ends a strip
  template <class Numbers> void read_strips(Numbers& numbers, const Element& element) {
    if(element.number == 0)
      return;
    const Property& indices = find_corners(element, "strips");
    for(std::uintmax_t i = 0; i < element.number; ++i) {
      File_place place;
      place.face = m_contents.number_of_faces();
      numbers.begin(place);
      for(const Property& p : element.properties) {
        const std::uintmax_t length = p.type_of_length ? read_length(numbers, p, place) : 1;
        if(&p != &indices) {
          numbers.skip(p.type, length, place);
          continue;
        }
        std::array<std::uint32_t, 3> last = {};
        std::size_t in_strip = 0;
        for(std::uintmax_t k = 0; k < length; ++k) {
          const std::int64_t index = numbers.integer(p.type, place);
          if(index == -1) {
            in_strip = 0;
            continue;
          }
          last = {last[1], last[2], corner(numbers, index, place)};
          ++in_strip;
          if(in_strip < 3)
            continue;
          const bool is_turned = in_strip % 2 == 0;
          const std::array<std::uint32_t, 3> triangle = {last[is_turned ? 1 : 0],
                                                         last[is_turned ? 0 : 1], last[2]};
          // a corner twice is how strips turn
          if(last[0] != last[1] && last[1] != last[2] && last[2] != last[0])
            m_contents.add_face(triangle.data(), 3);
          place.face = m_contents.number_of_faces();
        }
      }
      numbers.end(place);
    }
  }

  template <class Numbers> void skip_element(Numbers& numbers, const Element& element) {
    if(!m_is_text && !element.has_lists()) {
      std::size_t size = 0;
      for(const Property& p : element.properties)
        size += size_of(p.type);
      m_in.skip(element.number * size);
      return;
    }
    for(std::uintmax_t i = 0; i < element.number; ++i) {
      numbers.begin({});
      for(const Property& p : element.properties)
        numbers.skip(p.type, p.type_of_length ? read_length(numbers, p, {}) : 1, {});
      numbers.end({});
    }
  }

  template <class Numbers>
  std::uint32_t corner(Numbers& numbers, std::int64_t index, const File_place& place) {
    if(index < 0 || static_cast<std::uintmax_t>(index) >= m_number_of_vertices)
      numbers.fail("names vertex " + std::to_string(index) + ", of " +
                       std::to_string(m_number_of_vertices),
                   place);
    return static_cast<std::uint32_t>(index);
  }

  Byte_source& m_in;
  File_contents& m_contents;
  std::vector<Element> m_elements;
  std::uintmax_t m_number_of_vertices = 0;
  bool m_is_text = false;
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_FILES_INTERNAL_PLY_FILE_H
