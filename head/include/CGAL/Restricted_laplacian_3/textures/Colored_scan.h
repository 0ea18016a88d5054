// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_TEXTURES_COLORED_SCAN_H
#define CGAL_RESTRICTED_LAPLACIAN_3_TEXTURES_COLORED_SCAN_H

#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parameters.h>
#include <CGAL/Restricted_laplacian_3/input/read_surface.h>
#include <CGAL/Restricted_laplacian_3/input/shared/Surface_source.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>
#include <CGAL/Restricted_laplacian_3/textures/shared/color_values.h>
#include <CGAL/Restricted_laplacian_3/textures/srgb.h>

#include <CGAL/Aff_transformation_3.h>
#include <CGAL/property_map.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <iterator>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

/// \ingroup PkgRestrictedLaplacian3Colors
/// Takes coordinates of a scan to those of the world.
using Scan_pose = CGAL::Aff_transformation_3<CGAL::Simple_cartesian<double>>;

/// \ingroup PkgRestrictedLaplacian3Colors
/// The pose that a matrix of four rows stands for, which takes columns \f$(x, y, z, 1)^T\f$ of the
/// scan's coordinates to those of the world.
/// \param rows the 16 entries, row by row
/// \throws Parameter_error the last row is not 0 0 0 1, as in a matrix that is transposed; an entry
/// is not finite; or the first three columns are not a rotation times a positive number, up to 1 %
Scan_pose scan_pose(const std::array<double, 16>& rows);

/// \cond SKIP_IN_MANUAL
/// \ingroup PkgRestrictedLaplacian3Colors
/// What a scan says of a location near it.
struct Scan_sample {
  /// at the nearest point of the scan, from 0 to 1
  Rgb_color color = {0, 0, 0};
  /// surface gradient of the color there, per length in the world: column \f$k\f$ is that of
  /// channel \f$k\f$
  Eigen::Matrix3d gradient = Eigen::Matrix3d::Zero();
  /// unit normal there, interpolated, to the side of the viewpoint; may be zero
  Vector_3 normal = CGAL::NULL_VECTOR;
  /// from the location to the nearest point of the scan
  double distance = 0;
  /// from that point to the boundary of the scan; infinite if it has none
  double boundary_distance = 0;
  /// whether the location is beyond the boundary: the nearest point is on it, and the way to it is
  /// not along the normal
  bool is_beyond_boundary = false;
};
/// \endcond

/// \ingroup PkgRestrictedLaplacian3Colors
/// A scan: a triangulated surface or a set of oriented points with a color at each vertex, placed
/// in the world, and the point that it was seen from.
///
/// Normals of a scan are turned to its viewpoint, so it does not matter how it is oriented.
///
/// *Colors* are linear in each triangle, and their gradients constant. A point of a point set
/// stands for the linear function in its tangent plane that takes its color, and whose gradient
/// fits the `default_number_of_neighbors` nearest neighbors best, with weights that fall with the
/// distance.
///
/// *Boundary* of a mesh: the vertices of sides that no other face shares; of a point set: points
/// whose neighbors leave nearly half of the directions in the tangent plane empty. Distances to it
/// are those to the nearest of these vertices or points, interpolated.
///
/// *Spacing*: the median length of the sides of the faces; of points the median of
/// \f$r \sqrt{\pi / k}\f$, where \f$r\f$ is the distance to the \f$k\f$-th neighbor.
///
/// Construction takes \f$O(n \log n)\f$ time. Copies share what is stored.
class Colored_scan {
public:
  /// \param surface in coordinates of the scan
  /// \param colors of its vertices or points, from 0 to 1
  /// \param pose takes coordinates of the scan to those of the world: a rotation, a translation,
  /// and possibly a positive scale
  /// \param viewpoint in coordinates of the scan
  /// \param is_parallel whether several threads are used, if the program is linked with TBB; the
  /// result is the same
  /// \throws Parameter_error the number of colors is not that of the vertices, `pose` is not a
  /// rotation with a scale and a translation, or `viewpoint` is not finite
  /// \throws Invalid_vertex_error the color of a vertex is not from 0 to 1
  /// \throws Input_error the surface in the world has coordinates that are not finite
  Colored_scan(const Triangulated_surface_3& surface, std::vector<Rgb_color> colors,
               const Scan_pose& pose = Scan_pose(CGAL::IDENTITY),
               const Point_3& viewpoint = Point_3(0, 0, 0), bool is_parallel = false);

  /// \tparam Surface a model of `RestrictedSurface_3`
  /// \param surface a mesh, a `soup()`, or oriented points; read here only
  /// \param color_map a model of `ReadablePropertyMap` with vertices as keys and as value
  /// `CGAL::IO::Color`, or a `std::array`, a vector of Eigen or a 3D vector of \cgal of three
  /// components: from 0 to 1, or from 0 to 255 if they are integers
  /// \param np optional named parameters:
  /// \cgalNamedParamsBegin
  ///   \named_pose
  ///   \named_viewpoint
  ///   \named_of_surface
  ///   \named_concurrency_tag
  /// \cgalNamedParamsEnd
  /// \throws Input_error as above, and what `read_surface()` throws
  template <class Surface, class ColorMap,
            class NamedParameters = parameters::Default_named_parameters,
            internal::Require_named_parameters<NamedParameters> = 0,
            std::enable_if_t<!std::is_same_v<Surface, Triangulated_surface_3>, int> = 0>
  Colored_scan(const Surface& surface, const ColorMap& color_map,
               const NamedParameters& np = parameters::default_values())
    : Colored_scan(read(surface, np), colors_of(surface, color_map), pose_of(np), viewpoint_of(np),
                   internal::is_parallel(np)) {}

  /// in coordinates of the world
  const Triangulated_surface_3& surface() const;
  /// of the vertices
  const std::vector<Rgb_color>& colors() const;
  /// in coordinates of the world
  const Point_3& viewpoint() const;
  /// typical distance of vertices or points
  double spacing() const;
  /// of the vertices, to the side of the viewpoint; zero where faces have none
  const std::vector<Vector_3>& normals() const;
  /// of each vertex to the boundary; infinite if there is none
  const std::vector<double>& boundary_distances() const;

private:
  struct Data;

public:
  /// \ingroup PkgRestrictedLaplacian3Colors
  /// Takes samples of a scan. Locations that follow each other are found faster if they are near
  /// each other. Every thread needs a sampler of its own; the scan must outlive it.
  class Sampler {
  public:
    /// a sampler for one thread; takes constant time
    explicit Sampler(const Colored_scan& scan) : m_data(scan.m_data.get()) {}

    /// \return whether the scan comes within `maximum_distance` of the location; else the sample
    /// is left as it is
    bool operator()(const Point_3& location, double maximum_distance, Scan_sample& sample);

  private:
    const Data* m_data;
    std::optional<std::pair<Point_3, std::size_t>> m_hint; // of internal::Scan_search
  };

private:
  template <class NamedParameters> static Scan_pose pose_of(const NamedParameters& np) {
    Scan_pose pose(CGAL::IDENTITY);
    internal::read_parameter(np, internal_np::pose, pose);
    return pose;
  }
  template <class NamedParameters> static Point_3 viewpoint_of(const NamedParameters& np) {
    Point_3 viewpoint(0, 0, 0);
    internal::read_parameter(np, internal_np::viewpoint, viewpoint);
    return viewpoint;
  }

  template <class Surface, class NamedParameters>
  static Triangulated_surface_3 read(const Surface& surface, const NamedParameters& np) {
    if constexpr(internal::is_range_v<Surface>) { // areas are not needed
      using Unit_areas = CGAL::Constant_property_map<std::size_t, double>;
      return read_surface(
          surface,
          parameters::Named_parameters<Unit_areas, internal_np::area_map_t, NamedParameters>(
              Unit_areas(1), np));
    } else
      return read_surface(surface, np);
  }

  template <class Surface, class ColorMap>
  static std::vector<Rgb_color> colors_of(const Surface& surface, const ColorMap& map) {
    std::vector<Rgb_color> colors;
    internal::surface_source(surface).for_each_vertex([&](std::size_t, const auto& v) {
      colors.push_back(internal::read_color(internal::value_at(map, v)));
    });
    return colors;
  }

  std::shared_ptr<const Data> m_data;
};

} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/textures/Colored_scan_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_TEXTURES_COLORED_SCAN_H
