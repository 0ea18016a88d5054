// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_TEXTURES_BACK_PROJECT_COLORS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_TEXTURES_BACK_PROJECT_COLORS_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parameters.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>
#include <CGAL/Restricted_laplacian_3/textures/Colored_scan.h>
#include <CGAL/Restricted_laplacian_3/textures/srgb.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Colors
/// The scan of a face or vertex that has none.
constexpr std::uint32_t no_scan = (std::numeric_limits<std::uint32_t>::max)();

/// \ingroup PkgRestrictedLaplacian3Options
/// The named parameters of a `Color_back_projector`.
struct Back_projection_options {
  /// \f$D\f$: largest distance of a covered vertex from the scan; without a value four times the
  /// larger one of the spacings of scan and surface (`Colored_scan::spacing()`)
  std::optional<double> maximum_distance;
  /// smallest cosine of the angle \f$\theta\f$ between the normal of the surface and the direction
  /// to the viewpoint, from 0 to 1
  double minimum_facing_cosine = 0.1;
  /// largest angle between the normals of surface and scan in degrees, from 0 to 180
  double normal_angle = 60;
  /// \f$B\f$: distance from the boundary of the scan from which on it does not matter; without a
  /// value ten times the spacing of the scan
  std::optional<double> boundary_width;
  /// whether the normals of the surface point outwards; else they are turned to the viewpoint, and
  /// a thin plate may take colors from a scan of its other side
  bool oriented = true;
  /// whether gradients are computed
  bool with_gradients = true;
  /// whether several threads are used
  bool is_parallel = false;

  /// the defaults
  Back_projection_options() = default;
  /// what is among named parameters, and the defaults else
  template <class NamedParameters, internal::Require_named_parameters<NamedParameters> = 0>
  Back_projection_options(const NamedParameters& np) : is_parallel(internal::is_parallel(np)) {
    internal::read_parameter(np, internal_np::maximum_distance, maximum_distance);
    internal::read_parameter(np, internal_np::minimum_facing_cosine, minimum_facing_cosine);
    internal::read_parameter(np, internal_np::normal_angle, normal_angle);
    internal::read_parameter(np, internal_np::boundary_width, boundary_width);
    internal::read_parameter(np, internal_np::oriented, oriented);
    internal::read_parameter(np, internal_np::color_gradients, with_gradients);
  }
};

/// \ingroup PkgRestrictedLaplacian3Colors
/// The colors of a scan on a surface: of the vertices that it covers, in ascending order.
struct Back_projection {
  /// numbers of the covered vertices; those of what follows are the positions in this vector
  std::vector<std::uint32_t> vertices;
  /// of the nearest points of the scan, from 0 to 1
  std::vector<Rgb_color> colors;
  /// of the colors of the scan, in the tangent plane of the scan: column \f$k\f$ belongs to
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
/// Takes colors of scans to the vertices of a surface (paper, section 5.2). A scan *covers* a
/// vertex of the surface if
/// - the normal of the surface there faces the viewpoint, \f$\cos\theta \ge\f$
///   `minimum_facing_cosine`, where \f$\theta\f$ is its angle to the direction to the viewpoint,
/// - the nearest point of the scan is at a distance \f$d \le D\f$,
/// - the angle between the normals of surface and scan is at most `normal_angle`,
/// - the vertex is not beyond the boundary of the scan, see `Scan_sample`.
///
/// What hides a part of the surface from the viewpoint needs no test: a range scan does not come
/// near what it did not see. The *quality* of the color is
/// \f[ q = \left(1 - \frac{d}{2 D}\right) \cos\theta\,
///         \min\left(1, \frac{b + s}{B + s}\right), \f]
/// where \f$b\f$ is the distance of the nearest point from the boundary of the scan and \f$s\f$ the
/// spacing of the scan. It is positive where a scan covers the surface.
///
/// Construction takes \f$O(F \log F)\f$ time for \f$F\f$ faces, a scan of \f$n\f$ vertices
/// \f$O(\log n)\f$ for each vertex that faces its viewpoint.
class Color_back_projector {
  using Options = Back_projection_options;

public:
  /// \param surface has to outlive this object
  /// \param options named parameters, or the options themselves:
  /// \cgalNamedParamsBegin
  ///   \named_of_back_projection
  ///   \named_color_gradients
  ///   \named_concurrency_tag
  /// \cgalNamedParamsEnd
  /// \throws Parameter_error a parameter is outside its domain
  explicit Color_back_projector(const Triangulated_surface_3& surface,
                                const Options& options = Options());

  /// the surface that colors are taken to
  const Triangulated_surface_3& surface() const { return *m_surface; }
  /// the values of the named parameters, as given to the constructor
  const Options& options() const { return m_options; }

  /// \f$D\f$ of a scan
  double maximum_distance(const Colored_scan& scan) const;

  /// the colors of a scan on the surface
  Back_projection operator()(const Colored_scan& scan) const;

  /// The smallest distance of a vertex from a scan, also of those that it does not cover, to tell
  /// why it covers none.
  double smallest_distance(const Colored_scan& scan) const;

private:
  /// the vertices from `begin` to `end` - 1
  void project(const Colored_scan& scan, std::size_t begin, std::size_t end,
               Back_projection& result) const;

  const Triangulated_surface_3* m_surface;
  Options m_options;
  std::vector<Vector_3> m_normals;
  double m_spacing;
};

/// \ingroup PkgRestrictedLaplacian3Colors
/// The colors of one scan on a surface, see `Color_back_projector`.
/// \param surface a surface of triangles
/// \param scan the scan
/// \param options named parameters, or the options themselves:
/// \cgalNamedParamsBegin
///   \named_of_back_projection
///   \named_color_gradients
///   \named_concurrency_tag
/// \cgalNamedParamsEnd
/// \throws Parameter_error a parameter is outside its domain
Back_projection back_project_colors(const Triangulated_surface_3& surface, const Colored_scan& scan,
                                    const Back_projection_options& options = {});

} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/textures/back_project_colors_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_TEXTURES_BACK_PROJECT_COLORS_H
