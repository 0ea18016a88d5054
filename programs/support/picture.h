// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_PROGRAMS_PICTURE_H
#define RESTRICTED_LAPLACIAN_3_PROGRAMS_PICTURE_H

// Draws a mesh, or points, with a color per vertex into a PNG file: parallel projection, a
// z-buffer, smooth shading except across sharp edges, and each pixel the mean of 2 x 2; beside it a
// bar with the colors of values.

#include "color_map.h"
#include "program.h"

#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>
#include <CGAL/Restricted_laplacian_3/textures/srgb.h>

#include <png.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iomanip>
#include <ios>
#include <limits>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace programs {

struct Picture_options {
  bool z_is_up = false;                  // else y
  std::optional<RL::Vector_3> from = {}; // where the viewer stands; else to the right and above
  int isolines = 0; // level lines divide the range of values into about that many bands
  int size = 1000;  // pixels of the longer side of what is shown
  std::optional<Color_scale> legend = {};
  std::vector<RL::Point_3> room_for = {}; // what the picture could show besides the surface
};

namespace internal {

using Vector = RL::Vector_3;

inline Vector unit(const Vector& v) {
  const double length = std::sqrt(v.squared_length());
  return length > 0 ? v / length : Vector(0, 0, 1);
}

// Coordinates of the picture: x to the right, y up, z toward the viewer, who stands to the right
// of the front and somewhat above it, unless told otherwise.
class View {
public:
  explicit View(const Picture_options& options) {
    const Vector right(1, 0, 0);
    const Vector up = options.z_is_up ? Vector(0, 0, 1) : Vector(0, 1, 0);
    const Vector front = options.z_is_up ? Vector(0, -1, 0) : Vector(0, 0, 1);
    const double azimuth = CGAL_PI / 6, elevation = CGAL_PI / 12;
    m_z = options.from
              ? unit(*options.from)
              : std::cos(elevation) * (std::cos(azimuth) * front + std::sin(azimuth) * right) +
                    std::sin(elevation) * up;
    // from straight above or below the front is at the bottom of the picture
    constexpr double smallest_sine = 1e-6;
    m_x = CGAL::cross_product(up, m_z);
    m_x = m_x.squared_length() > smallest_sine * smallest_sine ? unit(m_x) : right;
    m_y = CGAL::cross_product(m_z, m_x);
  }
  Vector operator()(const Vector& v) const { return {m_x * v, m_y * v, m_z * v}; }

private:
  Vector m_x, m_y, m_z;
};

// What the rasterizer knows about a corner of a triangle.
struct Corner {
  Vector position; // in pixels, z in the same unit
  Vector normal;
  Color color;  // in linear light
  double value; // of the function whose level lines are drawn
};
using Triangle = std::array<Corner, 3>;

// The image before it is reduced to pixels.
class Canvas {
public:
  Canvas(int width, int height)
    : m_width(width), m_height(height), m_depth(size(), -std::numeric_limits<float>::infinity()),
      m_color(size(), Color{1, 1, 1}) {}

  // Draws a triangle, with level lines at the multiples of `interval` unless that is zero.
  void draw(const Triangle& t, double interval) {
    const Vector &a = t[0].position, &b = t[1].position, &c = t[2].position;
    const double area = (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
    if(area == 0) // seen from its side
      return;
    // both sides of the surface are shown alike
    const double side = area > 0 ? 1 : -1;
    const int left = first(std::min({a.x(), b.x(), c.x()}));
    const int right = last(std::max({a.x(), b.x(), c.x()}), m_width);
    const int bottom = first(std::min({a.y(), b.y(), c.y()}));
    const int top = last(std::max({a.y(), b.y(), c.y()}), m_height);
    // change of the value from one pixel to the next
    const double dx =
        (t[1].value - t[0].value) * (c.y() - a.y()) - (t[2].value - t[0].value) * (b.y() - a.y());
    const double dy =
        (t[2].value - t[0].value) * (b.x() - a.x()) - (t[1].value - t[0].value) * (c.x() - a.x());
    const double slope = std::hypot(dx, dy) / std::abs(area);
    for(int y = bottom; y <= top; ++y)
      for(int x = left; x <= right; ++x) {
        const double px = x + 0.5, py = y + 0.5;
        const double v = ((px - a.x()) * (c.y() - a.y()) - (py - a.y()) * (c.x() - a.x())) / area;
        const double w = ((b.x() - a.x()) * (py - a.y()) - (b.y() - a.y()) * (px - a.x())) / area;
        const double u = 1 - v - w;
        if(u < 0 || v < 0 || w < 0)
          continue;
        const std::size_t pixel = static_cast<std::size_t>(y) * m_width + x;
        const float depth = static_cast<float>(u * a.z() + v * b.z() + w * c.z());
        if(depth <= m_depth[pixel])
          continue;
        m_depth[pixel] = depth;
        const double brightness =
            brighten(side * (u * t[0].normal + v * t[1].normal + w * t[2].normal));
        const double value = u * t[0].value + v * t[1].value + w * t[2].value;
        const double paint = is_on_line(value, slope, interval) ? 0.15 : 1;
        for(int k = 0; k < 3; ++k)
          m_color[pixel][k] =
              brightness * paint * (u * t[0].color[k] + v * t[1].color[k] + w * t[2].color[k]);
      }
  }

  // Fills a rectangle; `color` is in linear light.
  void fill(int left, int bottom, int right, int top, const Color& color) {
    for(int y = std::max(bottom, 0); y < std::min(top, m_height); ++y)
      for(int x = std::max(left, 0); x < std::min(right, m_width); ++x)
        m_color[static_cast<std::size_t>(y) * m_width + x] = color;
  }

  // Writes the image, reduced by `factor` in both directions.
  void write(const std::string& file, int factor) const {
    png_image image = {};
    image.version = PNG_IMAGE_VERSION;
    image.width = static_cast<png_uint_32>(m_width / factor);
    image.height = static_cast<png_uint_32>(m_height / factor);
    image.format = PNG_FORMAT_RGB;
    std::vector<std::uint8_t> bytes;
    bytes.reserve(PNG_IMAGE_SIZE(image));
    for(int y = m_height - factor; y >= 0; y -= factor) // the first row is the top
      for(int x = 0; x < m_width; x += factor)
        for(int k = 0; k < 3; ++k) {
          double sum = 0;
          for(int j = 0; j < factor; ++j)
            for(int i = 0; i < factor; ++i)
              sum += m_color[static_cast<std::size_t>(y + j) * m_width + x + i][k];
          const double color = RL::linear_to_srgb(std::clamp(sum / (factor * factor), 0., 1.));
          bytes.push_back(static_cast<std::uint8_t>(std::lround(255 * color)));
        }
    png_alloc_size_t length = PNG_IMAGE_PNG_SIZE_MAX(image);
    std::vector<char> png(length);
    const int is_made =
        png_image_write_to_memory(&image, png.data(), &length, 0, bytes.data(), 0, nullptr);
    require(is_made != 0, std::string("cannot make a picture: ") + image.message);
    write_file(file, [&](std::ostream& out) {
      out.write(png.data(), static_cast<std::streamsize>(length));
    });
  }

private:
  std::size_t size() const { return static_cast<std::size_t>(m_width) * m_height; }
  static int first(double x) { return std::max(0, static_cast<int>(std::floor(x))); }
  static int last(double x, int end) { return std::min(end - 1, static_cast<int>(std::ceil(x))); }

  // a lamp behind the left shoulder of the viewer, and light from everywhere
  static double brighten(const Vector& normal) {
    const Vector lamp(-0.37, 0.56, 0.74);
    return 0.35 + 0.65 * std::max(0., unit(normal) * lamp);
  }

  // whether a level line of constant width passes through a pixel
  static bool is_on_line(double value, double slope, double interval) {
    constexpr double half_width = 1.5;
    return interval > 0 &&
           std::abs(value - interval * std::round(value / interval)) < half_width * slope;
  }

  int m_width, m_height;
  std::vector<float> m_depth;
  std::vector<Color> m_color;
};

// for each vertex, the faces around it
inline std::vector<std::vector<std::uint32_t>>
faces_around_vertices(const RL::Triangulated_surface_3& surface) {
  std::vector<std::vector<std::uint32_t>> faces(surface.number_of_vertices());
  for(std::size_t f = 0; f < surface.number_of_faces(); ++f)
    for(const std::uint32_t vertex : surface.triangle(f))
      faces[vertex].push_back(static_cast<std::uint32_t>(f));
  return faces;
}

// The normal of a corner of a face: the mean over the faces around the vertex by area, less weight
// the more they turn away, so that sharp edges stay sharp. The faces may be oriented differently:
// the sign of the cosine turns their normals to the side of this one.
inline Vector corner_normal(const RL::Triangulated_surface_3& surface, std::size_t face,
                            const std::vector<std::uint32_t>& faces_around_vertex) {
  Vector sum(0, 0, 0);
  for(const std::uint32_t other : faces_around_vertex) {
    const double cosine = surface.normal(face) * surface.normal(other);
    sum += cosine * std::abs(cosine) * surface.area(other) * surface.normal(other);
  }
  return sum;
}

// The corners of the disc that shows a point: somewhat larger than the area that the point stands
// for, so that there are no holes between discs.
inline std::vector<RL::Point_3> disc(const RL::Triangulated_surface_3& surface, std::size_t point) {
  constexpr int size = 8;
  const double radius = 1.5 * std::sqrt(surface.area(point) / CGAL_PI);
  const Vector& n = surface.normal(point);
  const Vector u =
      unit(CGAL::cross_product(n, std::abs(n.x()) < 0.6 ? Vector(1, 0, 0) : Vector(0, 1, 0)));
  const Vector v = CGAL::cross_product(n, u);
  std::vector<RL::Point_3> corners;
  for(int i = 0; i < size; ++i) {
    const double angle = 2 * CGAL_PI * i / size;
    corners.push_back(surface.point(point) + radius * (std::cos(angle) * u + std::sin(angle) * v));
  }
  return corners;
}

// What numbers are written with, seven rows of five dots each, from above.
struct Glyph {
  char character;
  std::array<const char*, 7> rows;
};
constexpr int glyph_width = 5, glyph_height = 7;
constexpr std::array<Glyph, 14> glyphs = {{
    {'0', {" ### ", "#   #", "#  ##", "# # #", "##  #", "#   #", " ### "}},
    {'1', {"  #  ", " ##  ", "  #  ", "  #  ", "  #  ", "  #  ", " ### "}},
    {'2', {" ### ", "#   #", "    #", "   # ", "  #  ", " #   ", "#####"}},
    {'3', {"#####", "   # ", "  #  ", "   # ", "    #", "#   #", " ### "}},
    {'4', {"   # ", "  ## ", " # # ", "#  # ", "#####", "   # ", "   # "}},
    {'5', {"#####", "#    ", "#### ", "    #", "    #", "#   #", " ### "}},
    {'6', {"  ## ", " #   ", "#    ", "#### ", "#   #", "#   #", " ### "}},
    {'7', {"#####", "    #", "   # ", "  #  ", " #   ", " #   ", " #   "}},
    {'8', {" ### ", "#   #", "#   #", " ### ", "#   #", "#   #", " ### "}},
    {'9', {" ### ", "#   #", "#   #", " ####", "    #", "   # ", " ##  "}},
    {'-', {"     ", "     ", "     ", "#####", "     ", "     ", "     "}},
    {'+', {"     ", "  #  ", "  #  ", "#####", "  #  ", "  #  ", "     "}},
    {'.', {"     ", "     ", "     ", "     ", "     ", " ##  ", " ##  "}},
    {'e', {"     ", "     ", " ### ", "#   #", "#####", "#    ", " ### "}},
}};

inline std::string number_text(double x) {
  std::ostringstream text;
  text << std::setprecision(4) << x;
  return text.str();
}

// Writes a number whose lower left corner is given, with dots of `dot` pixels.
inline void draw_number(Canvas& canvas, int left, int bottom, int dot, const std::string& text) {
  for(const char c : text) {
    for(const Glyph& glyph : glyphs)
      for(int row = 0; row < glyph_height && glyph.character == c; ++row)
        for(int column = 0; column < glyph_width; ++column) {
          const int x = left + dot * column, y = bottom + dot * (glyph_height - 1 - row);
          if(glyph.rows[static_cast<std::size_t>(row)][column] == '#')
            canvas.fill(x, y, x + dot, y + dot, {0, 0, 0});
        }
    left += dot * (glyph_width + 1);
  }
}

// The bar of a color scale, with its ends, and 0 if that lies between them.
class Legend {
public:
  // \param size pixels of the longer side of the picture
  Legend(const Color_scale& scale, int size)
    : m_scale(scale), m_dot(std::max(1, size / 400)), m_bar_width(size / 40) {
    const double low = scale.low(), high = scale.high();
    m_marks = {low};
    if(low < 0 && high > 0)
      m_marks.push_back(0);
    if(high > low)
      m_marks.push_back(high);
  }

  int width() const {
    std::size_t longest = 0;
    for(const double mark : m_marks)
      longest = std::max(longest, number_text(mark).size());
    return 2 * m_bar_width + static_cast<int>(longest) * m_dot * (glyph_width + 1);
  }

  // draws the bar from `left` on, between two heights
  void draw(Canvas& canvas, int left, int bottom, int top) const {
    const int right = left + m_bar_width, text = m_dot * glyph_height, length = top - bottom;
    canvas.fill(left - m_dot, bottom - m_dot, right + m_dot, top + m_dot, {0, 0, 0});
    for(int y = bottom; y < top; ++y) {
      Color color = m_scale(value_at((y - bottom + 0.5) / length));
      for(double& component : color)
        component = RL::srgb_to_linear(component);
      canvas.fill(left, y, right, y + 1, color);
    }
    int last = std::numeric_limits<int>::min();
    for(const double mark : m_marks) {
      const double t = mark == m_scale.low() ? 0 : mark == m_scale.high() ? 1 : place_of(mark);
      const int y = bottom + static_cast<int>(std::lround(t * (length - text)));
      const bool is_end = t == 0 || t == 1;
      // numbers do not overlap; the ends matter more
      if(!is_end && (y < last + 2 * text || y > top - 3 * text))
        continue;
      draw_number(canvas, right + m_bar_width / 2, y, m_dot, number_text(mark));
      last = y;
    }
  }

private:
  double value_at(double t) const { return m_scale.low() + t * (m_scale.high() - m_scale.low()); }
  double place_of(double x) const { return (x - m_scale.low()) / (m_scale.high() - m_scale.low()); }

  Color_scale m_scale;
  int m_dot, m_bar_width; // in pixels
  std::vector<double> m_marks;
};

} // namespace internal

// Draws a surface with one color and one value for each vertex; the values serve the level lines
// only. Points are drawn as discs, without level lines. The picture has the shape of what it shows.
inline void write_picture(const std::string& file, const RL::Triangulated_surface_3& surface,
                          const std::vector<Color>& colors, const std::vector<double>& values,
                          const Picture_options& options) {
  using internal::Vector;
  constexpr int samples = 2; // along each side of a pixel
  const internal::View view(options);
  const double infinity = std::numeric_limits<double>::infinity();
  std::array<double, 2> low = {infinity, infinity}, high = {-infinity, -infinity};
  const auto enclose = [&](const Vector& p) {
    low = {std::min(low[0], p.x()), std::min(low[1], p.y())};
    high = {std::max(high[0], p.x()), std::max(high[1], p.y())};
  };
  std::vector<Vector> positions(surface.number_of_vertices());
  for(std::size_t f = 0; f < surface.number_of_faces(); ++f)
    for(const std::uint32_t vertex : surface.triangle(f))
      enclose(positions[vertex] = view(surface.point(vertex) - CGAL::ORIGIN));
  for(const RL::Point_3& point : options.room_for)
    enclose(view(point - CGAL::ORIGIN));

  const double extent = std::max(high[0] - low[0], high[1] - low[1]);
  const int margin = options.size / 40;
  const double scale = samples * (options.size - 2 * margin) / extent;
  const auto side = [&](int axis) {
    const double length = std::ceil(scale * (high[axis] - low[axis]) / samples);
    return samples * (static_cast<int>(length) + 2 * margin);
  };
  std::optional<internal::Legend> legend;
  if(options.legend)
    legend.emplace(*options.legend, samples * options.size);
  const int width = side(0), height = side(1);
  internal::Canvas canvas(width + (legend ? samples * (legend->width() / samples) : 0), height);
  const Vector origin(low[0], low[1], 0);
  const Vector offset(samples * margin, samples * margin, 0);

  const Value_range range(values);
  // the half keeps lines away from the extrema of symmetric functions
  const double interval =
      options.isolines > 0 ? (range.high - range.low) / (options.isolines + 0.5) : 0;
  const auto faces_around = internal::faces_around_vertices(surface);
  const auto corner = [&](std::size_t face, std::size_t vertex, const Vector& position) {
    Color color = colors[vertex];
    for(double& component : color)
      component = RL::srgb_to_linear(component);
    return internal::Corner{scale * (position - origin) + offset,
                            view(internal::corner_normal(surface, face, faces_around[vertex])),
                            color, values[vertex]};
  };
  for(std::size_t f = 0; f < surface.number_of_faces(); ++f) {
    if(!surface.is_point_set()) {
      const auto& v = surface.triangle(f);
      canvas.draw({corner(f, v[0], positions[v[0]]), corner(f, v[1], positions[v[1]]),
                   corner(f, v[2], positions[v[2]])},
                  interval);
      continue;
    }
    std::vector<internal::Corner> corners;
    for(const RL::Point_3& p : internal::disc(surface, f))
      corners.push_back(corner(f, f, view(p - CGAL::ORIGIN)));
    for(std::size_t i = 2; i < corners.size(); ++i)
      canvas.draw({corners[0], corners[i - 1], corners[i]}, 0); // a disc has one value
  }
  if(legend)
    legend->draw(canvas, width, height / 4, height - height / 4);
  canvas.write(file, samples);
}

} // namespace programs

#endif // RESTRICTED_LAPLACIAN_3_PROGRAMS_PICTURE_H
