// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_TEXTURES_BACK_PROJECT_COLORS_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_TEXTURES_BACK_PROJECT_COLORS_IMPL_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parallel_for.h>
#include <CGAL/Restricted_laplacian_3/surface/vertex_normals.h>
#include <CGAL/Restricted_laplacian_3/textures/back_project_colors.h>
#include <CGAL/Restricted_laplacian_3/textures/internal/scan_properties.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// \throws Parameter_error an option is outside its domain
inline Back_projection_options checked_options(const Back_projection_options& options) {
  const auto check = [](bool is_good, const char* name, double value, const char* domain) {
    if(!is_good)
      throw Parameter_error(name, "is " + std::to_string(value) + ", but must be " + domain);
  };
  const double facing = options.minimum_facing_cosine, angle = options.normal_angle;
  check(facing >= 0 && facing <= 1, "minimum_facing_cosine", facing, "in 0 .. 1");
  check(angle >= 0 && angle <= 180, "normal_angle", angle, "in 0 .. 180");
  const double distance = options.maximum_distance.value_or(1),
               width = options.boundary_width.value_or(0);
  check(distance > 0 && std::isfinite(distance), "maximum_distance", distance,
        "a positive finite number");
  check(width >= 0 && std::isfinite(width), "boundary_width", width,
        "a finite number that is not negative");
  return options;
}

inline double spacing_of(const Triangulated_surface_3& surface) {
  surface.require_triangles("the back-projection of colors");
  return internal::median_side(surface);
}

template <class T> void append(const std::vector<T>& from, std::vector<T>& to) {
  to.insert(to.end(), from.begin(), from.end());
}

} // namespace internal

CGAL_RESTRICTED_LAPLACIAN_3_INLINE
Color_back_projector::Color_back_projector(const Triangulated_surface_3& surface,
                                           const Options& options)
  : m_surface(&surface), m_options(internal::checked_options(options)),
    m_normals(vertex_normals(surface)), m_spacing(internal::spacing_of(surface)) {}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE double
Color_back_projector::maximum_distance(const Colored_scan& scan) const {
  constexpr double spacings = 4;
  return m_options.maximum_distance.value_or(spacings * (std::max)(m_spacing, scan.spacing()));
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Back_projection
Color_back_projector::operator()(const Colored_scan& scan) const {
  constexpr std::size_t grain = 1 << 12;
  const std::size_t n = m_surface->number_of_vertices();
  std::vector<Back_projection> parts(n / grain + 1);
  internal::parallel_for(
      m_options.is_parallel, 0, n, grain,
      [&](std::size_t begin, std::size_t end) { project(scan, begin, end, parts[begin / grain]); });
  Back_projection result;
  result.maximum_distance = maximum_distance(scan);
  for(Back_projection& part : parts) {
    internal::append(part.vertices, result.vertices);
    internal::append(part.colors, result.colors);
    internal::append(part.gradients, result.gradients);
    internal::append(part.distances, result.distances);
    internal::append(part.qualities, result.qualities);
    result.number_of_facing_vertices += part.number_of_facing_vertices;
  }
  return result;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE double
Color_back_projector::smallest_distance(const Colored_scan& scan) const {
  Colored_scan::Sampler sampler(scan);
  double smallest = std::numeric_limits<double>::infinity();
  Scan_sample sample;
  for(std::size_t v = 0; v < m_surface->number_of_vertices(); ++v)
    if(m_normals[v] != CGAL::NULL_VECTOR && sampler(m_surface->point(v), smallest, sample))
      smallest = (std::min)(smallest, sample.distance);
  return smallest;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE void
Color_back_projector::project(const Colored_scan& scan, std::size_t begin, std::size_t end,
                              Back_projection& result) const {
  constexpr double boundary_spacings = 10;
  const double distance = maximum_distance(scan), spacing = scan.spacing(),
               width = m_options.boundary_width.value_or(boundary_spacings * spacing),
               smallest_cosine = std::cos(m_options.normal_angle * CGAL_PI / 180);
  Colored_scan::Sampler sampler(scan);
  Scan_sample sample;
  for(std::size_t v = begin; v < end; ++v) {
    Vector_3 normal = m_normals[v];
    double facing = normal * internal::unit_or_zero((scan.viewpoint() - m_surface->point(v)) /
                                                    m_surface->extent());
    if(!m_options.oriented && facing < 0) {
      facing = -facing;
      normal = -normal;
    }
    if(!(facing >= m_options.minimum_facing_cosine && normal != CGAL::NULL_VECTOR))
      continue;
    ++result.number_of_facing_vertices;
    if(!sampler(m_surface->point(v), distance, sample) || sample.is_beyond_boundary ||
       !(sample.normal * normal >= smallest_cosine))
      continue;
    const double of_distance = 1 - sample.distance / (2 * distance),
                 of_boundary = sample.boundary_distance < width
                                   ? (sample.boundary_distance + spacing) / (width + spacing)
                                   : 1;
    result.vertices.push_back(static_cast<std::uint32_t>(v));
    result.colors.push_back(sample.color);
    if(m_options.with_gradients)
      result.gradients.push_back(sample.gradient);
    result.distances.push_back(sample.distance);
    result.qualities.push_back(of_distance * (std::min)(facing, 1.) * of_boundary);
  }
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Back_projection
back_project_colors(const Triangulated_surface_3& surface, const Colored_scan& scan,
                    const Back_projection_options& options) {
  return Color_back_projector(surface, options)(scan);
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_TEXTURES_BACK_PROJECT_COLORS_IMPL_H
