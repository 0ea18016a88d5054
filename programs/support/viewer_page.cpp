// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "viewer_page.h"

#include "color_map.h"

#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <iterator>
#include <limits>
#include <ostream>
#include <sstream>
#include <string_view>
#include <system_error>

namespace programs {

namespace {

constexpr int coordinate_steps = 1 << 20;
// codes of values: three that are no number, then the numbers, in 24 bits
constexpr std::int32_t code_of_nan = 0, code_of_infinity = 1, code_of_minus_infinity = 2,
                       first_code = 3;
constexpr int value_steps = (1 << 24) - 1 - first_code;

constexpr std::string_view scene_mark = "<!-- scene -->";

// Integers as the viewer reads them (decode.js): differences from the one `stride` before, the sign
// in the lowest bit, then the lowest bytes of all of them, the second ones and so on. Neighbors in
// a file are mostly neighbors on the surface, so most of these bytes are 0, and what follows
// compresses them well.
class Integer_coder {
public:
  // returns how many bytes each number takes
  int add(const std::vector<std::int32_t>& numbers, std::size_t stride) {
    std::vector<std::uint32_t> codes(numbers.size());
    std::uint32_t all = 0;
    for(std::size_t i = 0; i < numbers.size(); ++i) {
      const std::int32_t difference = numbers[i] - (i < stride ? 0 : numbers[i - stride]);
      codes[i] = (static_cast<std::uint32_t>(difference) << 1) ^
                 (difference < 0 ? ~std::uint32_t(0) : std::uint32_t(0));
      all |= codes[i];
    }
    int planes = 0;
    for(; planes < 4 && (all >> (8 * planes)) != 0; ++planes)
      for(const std::uint32_t code : codes)
        m_bytes.push_back(static_cast<unsigned char>(code >> (8 * planes)));
    return planes;
  }

  std::vector<unsigned char> compressed() const {
    uLongf size = compressBound(static_cast<uLong>(m_bytes.size()));
    std::vector<unsigned char> result(size);
    constexpr int level = 6;
    if(compress2(result.data(), &size, m_bytes.data(), static_cast<uLong>(m_bytes.size()), level) !=
       Z_OK)
      throw std::bad_alloc();
    result.resize(size);
    return result;
  }

private:
  std::vector<unsigned char> m_bytes;
};

void write_base64(std::ostream& out, const std::vector<unsigned char>& bytes) {
  constexpr std::string_view digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for(std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t number = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for(std::size_t k = 0; k < 3; ++k)
      group = group << 8 | (k < number ? bytes[i + k] : 0U);
    for(std::size_t k = 0; k < 4; ++k)
      text += k <= number ? digits[group >> (18 - 6 * k) & 63U] : '=';
  }
  out << text;
}

// a string of JSON that ends no element of a page
std::string json(const std::string& text) {
  std::ostringstream out;
  out << '"' << std::hex << std::setfill('0');
  for(const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if(code < 0x20 || c == '"' || c == '\\' || c == '<' || c == '&')
      out << "\\u" << std::setw(4) << static_cast<int>(code);
    else
      out << c;
  }
  out << '"';
  return out.str();
}

bool is_finite(const RL::Point_3& p) {
  return std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z());
}

// `number` between `low` and `low + step * steps` in steps
std::int32_t step_number(double number, double low, double step, int steps) {
  if(!(step > 0))
    return 0;
  // the halves of numbers of both signs, of any size, do not overflow
  const double x = 2 * ((number / 2 - low / 2) / step);
  return static_cast<std::int32_t>(std::lround(std::clamp(x, 0., static_cast<double>(steps))));
}

class Scene_writer {
public:
  Scene_writer(std::ostream& out, Integer_coder& coder) : m_out(out), m_coder(coder) {
    m_out << std::setprecision(std::numeric_limits<double>::max_digits10);
  }

  void write(const Viewer_page& page) {
    m_out << "{\"title\":" << json(page.title) << ",\"first\":" << page.first_field
          << ",\"isolines\":" << page.isolines << ",\"up\":\"" << page.up << "\",\"surfaces\":[";
    for(const Viewer_surface& surface : page.surfaces)
      write(surface, &surface == page.surfaces.data());
    m_out << "]}";
  }

private:
  void write(const Viewer_surface& s, bool is_first) {
    std::vector<std::int32_t> triangles;
    for(const auto& t : s.triangles)
      if(std::all_of(t.begin(), t.end(), [&](std::uint32_t v) { return is_finite(s.points[v]); }))
        for(const std::uint32_t v : t)
          triangles.push_back(static_cast<std::int32_t>(v));
    const std::size_t left_out = s.triangles.size() - triangles.size() / 3;
    m_out << (is_first ? "" : ",") << "{\"name\":" << json(s.name)
          << ",\"vertices\":" << s.points.size() << ",\"faces\":" << triangles.size() / 3
          << ",\"leftOut\":" << left_out;
    write_points(s, triangles);
    m_out << ",\"triangles\":{\"planes\":" << m_coder.add(triangles, 3) << '}';
    if(!s.normals.empty() && triangles.empty())
      write_normals(s);
    m_out << ",\"fields\":[";
    for(const Viewer_field& field : s.fields) {
      m_out << (&field == s.fields.data() ? "" : ",") << "{\"name\":" << json(field.name);
      if(field.is_color)
        write_colors(field);
      else
        write_values(field);
      if(!field.points.empty())
        m_out << ",\"positions\":{\"planes\":" << add_points(field.points) << '}';
      m_out << '}';
    }
    m_out << ']';
    if(!s.lines.empty())
      write_lines(s);
    m_out << '}';
  }

  // Coordinates in steps. A vertex without a face does not count for the box, if any has one.
  void write_points(const Viewer_surface& s, const std::vector<std::int32_t>& triangles) {
    std::array<double, 3> low = {0, 0, 0}, high = {0, 0, 0};
    bool is_first = true;
    const auto enclose = [&](const RL::Point_3& p) {
      for(int k = 0; k < 3; ++k) {
        low[k] = is_first ? p[k] : std::min(low[k], p[k]);
        high[k] = is_first ? p[k] : std::max(high[k], p[k]);
      }
      is_first = false;
    };
    const auto enclose_all = [&](const std::vector<RL::Point_3>& points) {
      for(const std::int32_t v : triangles)
        if(is_finite(points[static_cast<std::size_t>(v)]))
          enclose(points[static_cast<std::size_t>(v)]);
      if(triangles.empty())
        for(const RL::Point_3& p : points)
          if(is_finite(p))
            enclose(p);
    };
    enclose_all(s.points);
    for(const Viewer_field& field : s.fields)
      if(!field.points.empty())
        enclose_all(field.points);
    double step = 0;
    for(int k = 0; k < 3; ++k)
      step = std::max(step, high[k] / coordinate_steps - low[k] / coordinate_steps);
    m_low = low;
    m_step = step;
    std::array<std::int32_t, 3> extent;
    for(int k = 0; k < 3; ++k)
      extent[k] = step_number(high[k], low[k], step, coordinate_steps);
    m_out << ",\"positions\":{\"low\":[" << low[0] << ',' << low[1] << ',' << low[2]
          << "],\"step\":" << step << ",\"extent\":[" << extent[0] << ',' << extent[1] << ','
          << extent[2] << "],\"planes\":" << add_points(s.points) << '}';
  }

  int add_points(const std::vector<RL::Point_3>& points) {
    std::vector<std::int32_t> codes;
    for(const RL::Point_3& p : points)
      add_codes(p, codes);
    return m_coder.add(codes, 3);
  }

  void add_codes(const RL::Point_3& p, std::vector<std::int32_t>& codes) const {
    for(int k = 0; k < 3; ++k)
      codes.push_back(is_finite(p) ? step_number(p[k], m_low[k], m_step, coordinate_steps) : 0);
  }

  // how many points each line has, and the points
  void write_lines(const Viewer_surface& s) {
    std::vector<std::int32_t> sizes, codes;
    for(const std::vector<RL::Point_3>& line : s.lines) {
      sizes.push_back(static_cast<std::int32_t>(line.size()));
      for(const RL::Point_3& p : line)
        add_codes(p, codes);
    }
    m_out << ",\"lines\":{\"number\":" << sizes.size()
          << ",\"sizes\":{\"planes\":" << m_coder.add(sizes, 1)
          << "},\"points\":{\"number\":" << codes.size() / 3
          << ",\"planes\":" << m_coder.add(codes, 3) << "}}";
  }

  void write_normals(const Viewer_surface& s) {
    std::vector<std::int32_t> codes;
    for(const RL::Vector_3& n : s.normals) {
      const double length = std::sqrt(n.squared_length());
      for(int k = 0; k < 3; ++k) {
        const double x = n[k] / length;
        codes.push_back(std::isfinite(x) ? static_cast<std::int32_t>(std::lround(127 * x)) : 0);
      }
    }
    m_out << ",\"normals\":{\"planes\":" << m_coder.add(codes, 3) << '}';
  }

  void write_values(const Viewer_field& field) {
    const Value_range range(field.values);
    const double step = range.high / value_steps - range.low / value_steps;
    std::vector<std::int32_t> codes;
    for(const double x : field.values)
      codes.push_back(std::isnan(x)   ? code_of_nan
                      : std::isinf(x) ? (x > 0 ? code_of_infinity : code_of_minus_infinity)
                                      : first_code + step_number(x, range.low, step, value_steps));
    const auto shown = field.range.value_or(std::pair(range.low, range.high));
    m_out << ",\"kind\":\"numbers\",\"low\":" << range.low << ",\"high\":" << range.high
          << ",\"range\":[" << shown.first << ',' << shown.second
          << "],\"planes\":" << m_coder.add(codes, 1);
  }

  void write_colors(const Viewer_field& field) {
    std::vector<std::int32_t> codes;
    for(const double x : field.values)
      codes.push_back(static_cast<std::int32_t>(
          std::lround(255 * (std::isfinite(x) ? std::clamp(x, 0., 1.) : 0.5))));
    m_out << ",\"kind\":\"colors\",\"planes\":" << m_coder.add(codes, 3);
  }

  std::ostream& m_out;
  Integer_coder& m_coder;
  // of the coordinates of the surface that is written
  std::array<double, 3> m_low = {0, 0, 0};
  double m_step = 0;
};

Error no_viewer() {
  return Error(
      "this build has no viewer for HTML pages: install Node.js and npm (on Debian: nodejs "
      "npm), and build the package again");
}

} // namespace

Viewer_surface::Viewer_surface(std::string surface_name, const RL::Triangulated_surface_3& surface)
  : name(std::move(surface_name)) {
  for(std::size_t v = 0; v < surface.number_of_vertices(); ++v)
    points.push_back(surface.point(v));
  for(std::size_t f = 0; f < surface.number_of_faces(); ++f)
    if(surface.is_point_set())
      normals.push_back(surface.normal(f));
    else
      triangles.push_back(surface.triangle(f));
}

void write_viewer_page(std::ostream& out, const std::string& bundle, const Viewer_page& page) {
  const std::size_t mark = bundle.find(scene_mark);
  require(mark != std::string::npos, "the viewer for HTML pages is damaged: build it again");
  Integer_coder coder;
  std::ostringstream scene;
  Scene_writer(scene, coder).write(page);
  out << bundle.substr(0, mark) << "<script id=\"scene\" type=\"application/json\">" << scene.str()
      << "</script>\n<script id=\"data\" type=\"text/plain\">";
  write_base64(out, coder.compressed());
  out << "</script>" << bundle.substr(mark + scene_mark.size());
}

std::string read_viewer(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  if(!in.good())
    throw no_viewer();
  return {std::istreambuf_iterator<char>(in), {}};
}

void check_viewer(const std::string& file) {
  std::error_code ignored;
  if(!std::filesystem::is_regular_file(file, ignored))
    throw no_viewer();
}

} // namespace programs
