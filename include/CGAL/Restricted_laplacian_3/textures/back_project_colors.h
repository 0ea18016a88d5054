// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_TEXTURES_BACK_PROJECT_COLORS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_TEXTURES_BACK_PROJECT_COLORS_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parallel_for.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>
#include <CGAL/Restricted_laplacian_3/surface/vertex_normals.h>
#include <CGAL/Restricted_laplacian_3/textures/Colored_scan.h>
#include <CGAL/Restricted_laplacian_3/textures/internal/scan_properties.h>
#include <CGAL/Restricted_laplacian_3/textures/srgb.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Colors
/// Which locations of a surface a scan covers, and how well, see `Color_back_projector`.
struct Back_projection_options {
  /// \f$D\f$: largest distance of a covered vertex from the scan; without a value four times the
  /// larger one of the spacings of scan and surface (`Colored_scan::spacing()`)
  std::optional<double> maximum_distance;
  /// smallest cosine of the angle \f$\theta\f$ between the normal of the surface and the direction
  /// to the viewpoint, from 0 to 1
  double minimum_facing_cosine = 0.1;
  /// smallest cosine of the angle between the normals of surface and scan, from -1 to 1
  double minimum_normal_cosine = 0.5;
  /// \f$B\f$: distance from the boundary of the scan from which on it does not matter; without a
  /// value ten times the spacing of the scan
  std::optional<double> boundary_width;
  /// whether the normals of the surface point outwards; else they are turned to the viewpoint, and
  /// a thin plate may take colours from a scan of its other side
  bool oriented_surface = true;
  /// whether gradients are computed
  bool with_gradients = true;
};

/// \ingroup PkgRestrictedLaplacian3Colors
/// The colours of a scan on a surface: of the vertices that it covers, in ascending order.
struct Back_projection {
  /// numbers of the covered vertices; those of what follows are the positions in this vector
  std::vector<std::uint32_t> vertices;
  /// of the nearest points of the scan, from 0 to 1
  std::vector<Rgb_color> colors;
  /// of the colours of the scan, in the tangent plane of the scan: column \f$k\f$ belongs to
  /// channel \f$k\f$; empty if they were not asked for
  std::vector<Eigen::Matrix3d> gradients;
  /// from the scan
  std::vector<double> distances;
  /// \f$q\f$, from 0 to 1
  std::vector<double> qualities;
  /// \f$D\f$ of this scan
  double maximum_distance = 0;
  /// the number of vertices that face the viewpoint, near the scan or not
  std::size_t number_of_facing_vertices = 0;
};

/// \ingroup PkgRestrictedLaplacian3Colors
/// Takes colours of scans to the vertices of a surface (paper, section 5.2). A scan *covers* a
/// vertex of the surface if
/// - the normal of the surface there faces the viewpoint, \f$\cos\theta \ge\f$
///   `minimum_facing_cosine`, where \f$\theta\f$ is its angle to the direction to the viewpoint,
/// - the nearest point of the scan is at a distance \f$d \le D\f$,
/// - the normals of surface and scan agree up to `minimum_normal_cosine`,
/// - the vertex is not beyond the boundary of the scan, see `Scan_sample`.
///
/// What hides a part of the surface from the viewpoint needs no test: a range scan does not come
/// near what it did not see. The *quality* of the colour is
/// \f[ q = \left(1 - \frac{d}{2 D}\right) \cos\theta\,
///         \min\left(1, \frac{b + s}{B + s}\right), \f]
/// where \f$b\f$ is the distance of the nearest point from the boundary of the scan and \f$s\f$ the
/// spacing of the scan. It is positive where a scan covers the surface.
///
/// Construction takes \f$O(F \log F)\f$ time for \f$F\f$ faces, a scan of \f$n\f$ vertices
/// \f$O(\log n)\f$ for each vertex that faces its viewpoint.
class Color_back_projector {
public:
  /// what the constructor takes
  using Options = Back_projection_options;

  /// \param surface has to outlive this object
  /// \param options which vertices a scan covers
  /// \param is_parallel whether several threads are used, if the program is linked with TBB; the
  /// result is the same
  /// \throws Parameter_error an option is outside its domain
  explicit Color_back_projector(const Triangulated_surface_3& surface,
                                const Options& options = Options(), bool is_parallel = false)
    : m_surface(&surface), m_options(checked(options)), m_is_parallel(is_parallel),
      m_normals(vertex_normals(surface)), m_spacing(spacing_of(surface)) {}

  /// the surface that colours are taken to
  const Triangulated_surface_3& surface() const { return *m_surface; }
  /// the options, as given to the constructor
  const Options& options() const { return m_options; }

  /// \f$D\f$ of a scan
  double maximum_distance(const Colored_scan& scan) const {
    constexpr double spacings = 4;
    return m_options.maximum_distance.value_or(spacings * (std::max)(m_spacing, scan.spacing()));
  }

  /// the colours of a scan on the surface
  Back_projection operator()(const Colored_scan& scan) const {
    constexpr std::size_t grain = 1 << 12;
    const std::size_t n = m_surface->number_of_vertices();
    std::vector<Back_projection> parts(n / grain + 1);
    internal::parallel_for(m_is_parallel, 0, n, grain, [&](std::size_t begin, std::size_t end) {
      project(scan, begin, end, parts[begin / grain]);
    });
    Back_projection result;
    result.maximum_distance = maximum_distance(scan);
    for(Back_projection& part : parts) {
      append(part.vertices, result.vertices);
      append(part.colors, result.colors);
      append(part.gradients, result.gradients);
      append(part.distances, result.distances);
      append(part.qualities, result.qualities);
      result.number_of_facing_vertices += part.number_of_facing_vertices;
    }
    return result;
  }

  /// The smallest distance of a vertex from a scan, also of those that it does not cover, to tell
  /// why it covers none.
  double smallest_distance(const Colored_scan& scan) const {
    Colored_scan::Sampler sampler(scan);
    double smallest = std::numeric_limits<double>::infinity();
    Scan_sample sample;
    for(std::size_t v = 0; v < m_surface->number_of_vertices(); ++v)
      if(m_normals[v] != CGAL::NULL_VECTOR && sampler(m_surface->point(v), smallest, sample))
        smallest = (std::min)(smallest, sample.distance);
    return smallest;
  }

private:
  static Options checked(const Options& options) {
    const auto check = [](bool is_good, const char* name, double value, const char* domain) {
      if(!is_good)
        throw Parameter_error(name, "is " + std::to_string(value) + ", but must be " + domain);
    };
    const double facing = options.minimum_facing_cosine, normal = options.minimum_normal_cosine;
    check(facing >= 0 && facing <= 1, "minimum_facing_cosine", facing, "in 0 .. 1");
    check(normal >= -1 && normal <= 1, "minimum_normal_cosine", normal, "in -1 .. 1");
    const double distance = options.maximum_distance.value_or(1),
                 width = options.boundary_width.value_or(0);
    check(distance > 0 && std::isfinite(distance), "maximum_distance", distance,
          "a positive finite number");
    check(width >= 0 && std::isfinite(width), "boundary_width", width,
          "a finite number that is not negative");
    return options;
  }

  static double spacing_of(const Triangulated_surface_3& surface) {
    surface.require_triangles("the back-projection of colours");
    return internal::median_side(surface);
  }

  template <class T> static void append(const std::vector<T>& from, std::vector<T>& to) {
    to.insert(to.end(), from.begin(), from.end());
  }

  /// the vertices from `begin` to `end` - 1
  void project(const Colored_scan& scan, std::size_t begin, std::size_t end,
               Back_projection& result) const {
    constexpr double boundary_spacings = 10;
    const double distance = maximum_distance(scan), spacing = scan.spacing(),
                 width = m_options.boundary_width.value_or(boundary_spacings * spacing);
    Colored_scan::Sampler sampler(scan);
    Scan_sample sample;
    for(std::size_t v = begin; v < end; ++v) {
      Vector_3 normal = m_normals[v];
      double facing = normal * internal::unit_or_zero((scan.viewpoint() - m_surface->point(v)) /
                                                      m_surface->extent());
      if(!m_options.oriented_surface && facing < 0) {
        facing = -facing;
        normal = -normal;
      }
      if(!(facing >= m_options.minimum_facing_cosine && normal != CGAL::NULL_VECTOR))
        continue;
      ++result.number_of_facing_vertices;
      if(!sampler(m_surface->point(v), distance, sample) || sample.is_beyond_boundary ||
         !(sample.normal * normal >= m_options.minimum_normal_cosine))
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

  const Triangulated_surface_3* m_surface;
  Options m_options;
  bool m_is_parallel;
  std::vector<Vector_3> m_normals;
  double m_spacing;
};

/// \ingroup PkgRestrictedLaplacian3Colors
/// The colours of one scan on a surface, see `Color_back_projector`.
inline Back_projection
back_project_colors(const Triangulated_surface_3& surface, const Colored_scan& scan,
                    const Back_projection_options& options = Back_projection_options(),
                    bool is_parallel = false) {
  return Color_back_projector(surface, options, is_parallel)(scan);
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_TEXTURES_BACK_PROJECT_COLORS_H
