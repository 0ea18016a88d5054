// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESTRICTED_LAPLACIAN_3_PROGRAMS_VIRTUAL_SCANNER_H
#define RESTRICTED_LAPLACIAN_3_PROGRAMS_VIRTUAL_SCANNER_H

// Range images with colors of a surface, as a camera that also measures depth takes them.

#include "color_map.h"
#include "program.h"

#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>
#include <CGAL/Restricted_laplacian_3/surface/vertex_normals.h>
#include <CGAL/Restricted_laplacian_3/textures/Colored_scan.h>
#include <CGAL/Restricted_laplacian_3/textures/internal/Triangle_tree.h>
#include <CGAL/Restricted_laplacian_3/textures/srgb.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/number_utils.h>

#include <boost/random/normal_distribution.hpp>
#include <boost/random/uniform_01.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

namespace programs {

// A camera with a square picture. In its frame the eye is at the origin, x points to the right of
// the picture, y downward and z forward.
struct Camera {
  RL::Scan_pose to_world;
  double tangent;       // of half the field of view
  int resolution = 512; // pixels along each side
};

// What changes from scan to scan: the exposure, a factor for each color component, and a lamp of
// some strength beside the camera, with light from everywhere for the rest.
struct Lighting {
  Color gain = {1, 1, 1};
  double lamp = 0;                       // 0: light from everywhere only; 1: the lamp only
  RL::Vector_3 lamp_direction{0, 0, -1}; // toward the lamp, of length 1, in the camera's frame
  bool in_linear_light = false;          // whether factors apply to linear light
};

// The mesh of a range image in the frame of its camera, or its points with normals.
struct Virtual_scan {
  RL::Triangulated_surface_3 surface;
  std::vector<Color> colors; // from 0 to 1
  std::size_t clamped;       // values of components that were larger than 1
};

// `number` directions, spread evenly over the sphere along a spiral (spherical Fibonacci lattice).
inline std::vector<RL::Vector_3> spread_directions(int number) {
  std::vector<RL::Vector_3> directions;
  const double golden_angle = CGAL_PI * (3 - std::sqrt(5.));
  for(int i = 0; i < number; ++i) {
    const double y = 1 - (2 * i + 1.) / number;
    const double r = std::sqrt(std::max(0., 1 - y * y));
    directions.emplace_back(r * std::cos(golden_angle * i), y, r * std::sin(golden_angle * i));
  }
  return directions;
}

// A camera that sees all of a ball, from a direction seen from its center.
inline Camera camera_around(const RL::Point_3& center, double radius, RL::Vector_3 direction,
                            double field_of_view, int resolution) {
  const auto unit = [](const RL::Vector_3& v) { return v / std::sqrt(v.squared_length()); };
  direction = unit(direction);
  const double half_angle = field_of_view / 2;
  const RL::Point_3 eye = center + radius / std::sin(half_angle) * direction;
  const RL::Vector_3 z = -direction;
  const RL::Vector_3 up = std::abs(z.y()) < 0.99 ? RL::Vector_3(0, 1, 0) : RL::Vector_3(0, 0, 1);
  const RL::Vector_3 x = unit(CGAL::cross_product(z, up)), y = CGAL::cross_product(z, x);
  return {RL::Scan_pose(x.x(), y.x(), z.x(), eye.x(), x.y(), y.y(), z.y(), eye.y(), x.z(), y.z(),
                        z.z(), eye.z()),
          std::tan(half_angle), resolution};
}

// Cameras around a surface that see all of it.
inline std::vector<Camera> cameras_around(const RL::Triangulated_surface_3& surface, int number,
                                          double field_of_view, int resolution) {
  double squared_radius = 0; // around the center of the bounding box
  for(std::size_t f = 0; f < surface.number_of_faces(); ++f)
    for(int i = 0; i < 3; ++i)
      squared_radius =
          std::max(squared_radius, CGAL::squared_distance(surface.center(), surface.point(f, i)));
  std::vector<Camera> cameras;
  for(const RL::Vector_3& direction : spread_directions(number))
    cameras.push_back(camera_around(surface.center(), std::sqrt(squared_radius), direction,
                                    field_of_view, resolution));
  return cameras;
}

// Random numbers that do not depend on the standard library.
class Random {
public:
  explicit Random(long long seed) : m_generator(static_cast<std::uint64_t>(seed)) {}

  double uniform() { return m_distribution(m_generator); }
  template <typename T> void shuffle(std::vector<T>& values) {
    for(std::size_t i = values.size(); i > 1; --i)
      std::swap(values[i - 1],
                values[static_cast<std::size_t>(uniform() * static_cast<double>(i))]);
  }

private:
  std::mt19937_64 m_generator;
  boost::random::uniform_01<double> m_distribution;
};

// Exposures from 1 / (1 + range) to 1, of equal ratios, in random order.
inline std::vector<double> spread_exposures(int number, double range, Random& random) {
  std::vector<double> result;
  for(int i = 0; i < number; ++i)
    result.push_back(std::pow(1 + range, number > 1 ? i / (number - 1.) - 1 : 0.));
  random.shuffle(result);
  return result;
}

// For each exposure, factors of the components that differ by the factor 1 + `tint` at most, and a
// lamp beside the camera at random that gives the part `lamp` of the light.
inline std::vector<Lighting> make_lightings(const std::vector<double>& exposures, double tint,
                                            double lamp, Random& random) {
  constexpr double largest_angle = 0.6; // of the lamp from the camera
  std::vector<Lighting> result;
  for(const double exposure : exposures) {
    Lighting lighting;
    for(double& factor : lighting.gain)
      factor = exposure * std::pow(1 + tint, random.uniform() - 0.5);
    const double angle = largest_angle * random.uniform(),
                 direction = 2 * CGAL_PI * random.uniform();
    lighting.lamp = lamp;
    lighting.lamp_direction = RL::Vector_3(std::sin(angle) * std::cos(direction),
                                           std::sin(angle) * std::sin(direction), -std::cos(angle));
    result.push_back(lighting);
  }
  return result;
}

class Virtual_scanner {
  using Kernel = CGAL::Kernel_traits<RL::Point_3>::Kernel;

public:
  // how steep a triangle of a scan may be: the cosine of the angle of its normal to the ray
  static constexpr double smallest_cosine = 0.17;

  // `surface` and `colors`, from 0 to 1 at its vertices, must outlive this object.
  Virtual_scanner(const RL::Triangulated_surface_3& surface, const std::vector<Color>& colors)
    : m_surface(surface), m_colors(colors), m_vertex_normals(RL::vertex_normals(surface)) {
    for(std::size_t f = 0; f < surface.number_of_faces(); ++f)
      if(!surface.is_degenerate(f)) {
        m_triangles.emplace_back(surface.point(f, 0), surface.point(f, 1), surface.point(f, 2));
        m_faces.push_back(f);
      }
    m_tree.insert(m_triangles.begin(), m_triangles.end());
    m_tree.build();
  }

  // One range image. Depths get normal noise of the standard deviation `noise`, in units of the
  // width of a pixel on the surface.
  Virtual_scan scan(const Camera& camera, const Lighting& lighting, bool as_points, double noise,
                    std::uint64_t seed) const {
    Image image(camera.resolution);
    std::mt19937_64 generator(seed);
    boost::random::normal_distribution<double> normal;
    std::size_t clamped = 0;
    for(int row = 0; row < camera.resolution; ++row)
      for(int column = 0; column < camera.resolution; ++column) {
        const RL::Vector_3 ray = pixel_ray(camera, row, column);
        Hit hit;
        if(!find_hit(camera, ray, hit))
          continue;
        const double error = noise > 0 ? noise * normal(generator) : 0;
        const double depth = hit.depth * (1 + error * 2 * camera.tangent / camera.resolution);
        image.pixel(row, column) = static_cast<int>(image.points.size());
        image.points.push_back(CGAL::ORIGIN + depth * ray);
        image.normals.push_back(hit.normal);
        image.areas.push_back(pixel_area(camera, ray, hit));
        image.colors.push_back(expose(color(hit), lighting, smooth_normal(camera, hit), clamped));
      }
    return as_points ? points_of(std::move(image), clamped) : mesh_of(image, clamped);
  }

private:
  struct Hit {
    std::size_t face;
    double depth;                      // along z
    RL::Vector_3 normal;               // of the face, in the camera's frame, toward the eye
    std::array<double, 3> barycentric; // in the face
  };

  struct Image {
    explicit Image(int resolution)
      : resolution(resolution), pixels(static_cast<std::size_t>(resolution) * resolution, -1) {}

    int& pixel(int row, int column) {
      return pixels[static_cast<std::size_t>(row) * resolution + column];
    }

    int resolution;
    std::vector<int> pixels; // the point of each pixel, or -1
    std::vector<RL::Point_3> points;
    std::vector<RL::Vector_3> normals;
    std::vector<double> areas;
    std::vector<Color> colors;
  };

  // through the center of a pixel, with z = 1
  static RL::Vector_3 pixel_ray(const Camera& camera, int row, int column) {
    const double pixel = 2 * camera.tangent / camera.resolution;
    return {(column + 0.5) * pixel - camera.tangent, (row + 0.5) * pixel - camera.tangent, 1};
  }

  bool find_hit(const Camera& camera, const RL::Vector_3& ray, Hit& hit) const {
    const RL::Point_3 eye = camera.to_world(RL::Point_3(0, 0, 0));
    const RL::Vector_3 direction = camera.to_world(ray);
    const auto triangle = m_tree.first_intersected_primitive(Kernel::Ray_3(eye, direction));
    if(!triangle)
      return false;
    hit.face = m_faces[static_cast<std::size_t>(*triangle - m_triangles.begin())];
    const RL::Vector_3 n = m_surface.normal(hit.face);
    const double slope = n * direction;
    if(slope == 0)
      return false; // the ray lies in the face
    hit.depth = n * (m_surface.point(hit.face, 0) - eye) / slope;
    hit.normal = camera.to_world.inverse()(slope < 0 ? n : -n);
    const RL::Point_3 point = eye + hit.depth * direction;
    double sum = 0;
    for(int i = 0; i < 3; ++i) {
      const RL::Vector_3 a = m_surface.point(hit.face, (i + 1) % 3) - point,
                         b = m_surface.point(hit.face, (i + 2) % 3) - point;
      sum += hit.barycentric[i] = std::max(0., CGAL::cross_product(a, b) * n);
    }
    for(double& x : hit.barycentric)
      x /= sum;
    return hit.depth > 0;
  }

  // of the part of the surface that a pixel shows
  static double pixel_area(const Camera& camera, const RL::Vector_3& ray, const Hit& hit) {
    const double width = hit.depth * 2 * camera.tangent / camera.resolution;
    return width * width / std::max(std::abs(hit.normal * ray), smallest_cosine);
  }

  // interpolated linearly in the face
  Color color(const Hit& hit) const {
    Color sum = {0, 0, 0};
    for(int i = 0; i < 3; ++i)
      for(std::size_t k = 0; k < 3; ++k)
        sum[k] += hit.barycentric[i] * m_colors[m_surface.triangle(hit.face)[i]][k];
    return sum;
  }

  // The normal for shading: that of the vertices, interpolated in the face, of length 1, in the
  // camera's frame and to the side of the normal of the face.
  RL::Vector_3 smooth_normal(const Camera& camera, const Hit& hit) const {
    RL::Vector_3 sum(0, 0, 0);
    for(int i = 0; i < 3; ++i)
      sum += hit.barycentric[i] * m_vertex_normals[m_surface.triangle(hit.face)[i]];
    if(!(sum.squared_length() > 0))
      return hit.normal;
    const RL::Vector_3 normal = camera.to_world.inverse()(sum / std::sqrt(sum.squared_length()));
    return normal * hit.normal < 0 ? -normal : normal;
  }

  static Color expose(Color color, const Lighting& lighting, const RL::Vector_3& normal,
                      std::size_t& clamped) {
    const double light =
        1 - lighting.lamp + lighting.lamp * std::max(0., normal * lighting.lamp_direction);
    for(std::size_t k = 0; k < 3; ++k) {
      const double factor = light * lighting.gain[k];
      double value = lighting.in_linear_light
                         ? RL::linear_to_srgb(factor * RL::srgb_to_linear(color[k]))
                         : factor * color[k];
      clamped += value > 1;
      color[k] = std::min(value, 1.);
    }
    return color;
  }

  // Two triangles between four pixels, of three pixels one, unless they are too steep: those join
  // parts of the surface that lie behind each other.
  static Virtual_scan mesh_of(Image& image, std::size_t clamped) {
    std::vector<RL::Triangulated_surface_3::Triangle> triangles;
    std::vector<int> number(image.points.size(), -1);
    const auto add = [&](int a, int b, int c) {
      if(a < 0 || b < 0 || c < 0 || is_steep(image.points[a], image.points[b], image.points[c]))
        return;
      triangles.push_back({static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b),
                           static_cast<std::uint32_t>(c)});
    };
    for(int row = 0; row + 1 < image.resolution; ++row)
      for(int column = 0; column + 1 < image.resolution; ++column) {
        // around the square, as the eye sees it counterclockwise
        const int a = image.pixel(row, column), b = image.pixel(row + 1, column),
                  c = image.pixel(row + 1, column + 1), d = image.pixel(row, column + 1);
        const bool cut_ac = b < 0 || d < 0 ||
                            (a >= 0 && c >= 0 &&
                             CGAL::squared_distance(image.points[a], image.points[c]) <
                                 CGAL::squared_distance(image.points[b], image.points[d]));
        if(cut_ac) {
          add(a, b, c);
          add(a, c, d);
        } else {
          add(a, b, d);
          add(b, c, d);
        }
      }
    return without_lonely_points(image, std::move(triangles), clamped);
  }

  static bool is_steep(const RL::Point_3& a, const RL::Point_3& b, const RL::Point_3& c) {
    const RL::Vector_3 normal = CGAL::cross_product(b - a, c - a);
    const RL::Vector_3 ray = CGAL::centroid(a, b, c) - CGAL::ORIGIN;
    const double slope = -(normal * ray);
    return !(slope > 0 && slope * slope > smallest_cosine * smallest_cosine *
                                              normal.squared_length() * ray.squared_length());
  }

  static Virtual_scan
  without_lonely_points(const Image& image,
                        std::vector<RL::Triangulated_surface_3::Triangle> triangles,
                        std::size_t clamped) {
    constexpr std::uint32_t none = -1;
    std::vector<std::uint32_t> numbers(image.points.size(), none);
    for(const auto& triangle : triangles)
      for(const std::uint32_t v : triangle)
        numbers[v] = 0;
    std::vector<RL::Point_3> points;
    std::vector<Color> colors;
    for(std::size_t v = 0; v < numbers.size(); ++v)
      if(numbers[v] != none) {
        numbers[v] = static_cast<std::uint32_t>(points.size());
        points.push_back(image.points[v]);
        colors.push_back(image.colors[v]);
      }
    for(auto& triangle : triangles)
      for(std::uint32_t& v : triangle)
        v = numbers[v];
    require(!triangles.empty(), "a scan sees nothing; --resolution may be too small");
    return {RL::Triangulated_surface_3(std::move(points), std::move(triangles)), std::move(colors),
            clamped};
  }

  static Virtual_scan points_of(Image image, std::size_t clamped) {
    require(!image.points.empty(), "a scan sees nothing; --resolution may be too small");
    return {RL::Triangulated_surface_3(std::move(image.points), std::move(image.normals),
                                       std::move(image.areas)),
            std::move(image.colors), clamped};
  }

  const RL::Triangulated_surface_3& m_surface;
  const std::vector<Color>& m_colors;
  std::vector<RL::Vector_3> m_vertex_normals;
  RL::internal::Triangles_in_tree m_triangles;
  std::vector<std::size_t> m_faces; // of the surface, for each triangle
  RL::internal::Triangle_tree m_tree;
};

} // namespace programs

#endif // RESTRICTED_LAPLACIAN_3_PROGRAMS_VIRTUAL_SCANNER_H
