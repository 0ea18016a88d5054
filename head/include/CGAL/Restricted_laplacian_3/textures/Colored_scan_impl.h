// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_TEXTURES_COLORED_SCAN_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_TEXTURES_COLORED_SCAN_IMPL_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/input/vertex_functions.h>
#include <CGAL/Restricted_laplacian_3/surface/shared/Surface_edges.h>
#include <CGAL/Restricted_laplacian_3/surface/vertex_normals.h>
#include <CGAL/Restricted_laplacian_3/textures/Colored_scan.h>
#include <CGAL/Restricted_laplacian_3/textures/internal/Scan_search.h>
#include <CGAL/Restricted_laplacian_3/textures/internal/scan_properties.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

namespace internal {

/// The linear part of a pose is a rotation times a scale up to this, relative to the scale: files
/// hold three decimals at least.
constexpr double pose_tolerance = 1e-2;

/// \throws Parameter_error unless the pose is a rotation, a uniform scale, and a translation
inline const Scan_pose& checked_pose(const Scan_pose& pose) {
  Eigen::Matrix3d linear;
  for(int i = 0; i < 3; ++i)
    for(int j = 0; j < 4; ++j) {
      if(!std::isfinite(pose.m(i, j)))
        throw Parameter_error("pose", "has an entry that is not a finite number");
      if(j < 3)
        linear(i, j) = pose.m(i, j);
    }
  const double largest = linear.cwiseAbs().maxCoeff();
  if(!(largest > 0))
    throw Parameter_error("pose", "is singular: it takes all points to one");
  linear /= largest;
  const Eigen::Matrix3d products = linear.transpose() * linear;
  const double squared_scale = products.trace() / 3;
  if((products - squared_scale * Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() >
     pose_tolerance * squared_scale)
    throw Parameter_error("pose", "is not a rotation with a uniform scale and a translation: its "
                                  "columns differ in length or are not orthogonal");
  if(linear.determinant() < 0)
    throw Parameter_error("pose", "is mirrored: its determinant is negative");
  return pose;
}

inline Triangulated_surface_3 placed(const Triangulated_surface_3& surface, const Scan_pose& pose) {
  std::vector<Point_3> points;
  points.reserve(surface.number_of_vertices());
  for(std::size_t v = 0; v < surface.number_of_vertices(); ++v)
    points.push_back(pose.transform(surface.point(v)));
  if(!surface.is_point_set()) {
    std::vector<Triangulated_surface_3::Triangle> triangles;
    triangles.reserve(surface.number_of_faces());
    for(std::size_t f = 0; f < surface.number_of_faces(); ++f)
      triangles.push_back(surface.triangle(f));
    return Triangulated_surface_3(std::move(points), std::move(triangles));
  }
  std::vector<Vector_3> normals;
  for(std::size_t i = 0; i < surface.number_of_vertices(); ++i)
    normals.push_back(pose.transform(surface.normal(i)));
  // Areas do not matter here, as long as their sum is that of something.
  const double area = (surface.extent() / 2) * (surface.extent() / 2);
  return Triangulated_surface_3(std::move(points), std::move(normals),
                                std::vector<double>(surface.number_of_vertices(), area));
}

inline std::vector<Rgb_color> checked_colors(std::vector<Rgb_color> colors, std::size_t size) {
  if(colors.size() != size)
    throw Parameter_error("colors", "has " + std::to_string(colors.size()) +
                                        " values, but the scan has " + std::to_string(size) +
                                        " vertices");
  for(std::size_t v = 0; v < size; ++v)
    for(double x : colors[v])
      if(!(x >= 0 && x <= 1))
        throw Invalid_vertex_error(v, "has a color that is not in 0 .. 1");
  return colors;
}

inline const Point_3& checked_viewpoint(const Point_3& viewpoint) {
  for(int axis = 0; axis < 3; ++axis)
    if(!std::isfinite(viewpoint[axis]))
      throw Parameter_error("viewpoint", "has a coordinate that is not a finite number");
  return viewpoint;
}

} // namespace internal

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Scan_pose scan_pose(const std::array<double, 16>& rows) {
  const auto& m = rows;
  if(!(m[12] == 0 && m[13] == 0 && m[14] == 0 && m[15] == 1))
    throw Parameter_error("pose", "has a last row other than 0 0 0 1");
  return internal::checked_pose(
      Scan_pose(m[0], m[1], m[2], m[3], m[4], m[5], m[6], m[7], m[8], m[9], m[10], m[11]));
}

struct Colored_scan::Data {
  /// A location whose nearest point is on the boundary belongs to the scan if it is not farther
  /// outside than this, in units of the spacing.
  static constexpr double boundary_tolerance = 0.1;

  Data(Triangulated_surface_3 world_surface, std::vector<Rgb_color> vertex_colors,
       const Point_3& world_viewpoint, bool is_parallel)
    : surface(std::move(world_surface)), colors(std::move(vertex_colors)),
      viewpoint(world_viewpoint), search(surface), normals(vertex_normals(surface)) {
    for(std::size_t v = 0; v < normals.size(); ++v)
      if(normals[v] * (viewpoint - surface.point(v)) < 0)
        normals[v] = -normals[v];
    if(surface.is_point_set()) {
      internal::Scan_point_properties properties =
          internal::scan_point_properties(surface, normals, colors, is_parallel);
      spacing = properties.spacing;
      point_gradients.swap(properties.gradients);
      boundary_distances =
          internal::distances_to_marked(surface, properties.is_on_boundary, is_parallel);
    } else {
      spacing = internal::median_side(surface);
      using Edges = internal::Surface_edges;
      boundary_distances = internal::distances_to_marked(
          surface, Edges(surface, Edges::Faces::not_degenerate).boundary_vertices(), is_parallel);
    }
  }

  void sample_at(const Surface_point& p, const Point_3& location, Scan_sample& sample) const {
    Eigen::Vector3d color = Eigen::Vector3d::Zero();
    Vector_3 normal = CGAL::NULL_VECTOR;
    sample.boundary_distance = 0;
    for(int i = 0; i < 3; ++i) {
      const double b = p.barycentric[i];
      if(b == 0)
        continue; // distances may be infinite
      color += b * internal::eigen_vector(colors[p.vertices[i]]);
      normal += b * normals[p.vertices[i]];
      sample.boundary_distance += b * boundary_distances[p.vertices[i]];
    }
    const Vector_3 way = location - p.point;
    sample.normal = internal::unit_or_zero(normal);
    sample.distance = internal::safe_length(way);
    const Vector_3 tangential = way - (way * sample.normal) * sample.normal;
    const double tangential_distance = internal::safe_length(tangential);
    if(surface.is_point_set()) {
      sample.gradient = point_gradients[p.face];
      color += sample.gradient.transpose() * internal::eigen_vector(tangential);
      sample.is_beyond_boundary =
          sample.boundary_distance <= 0 && tangential_distance > spacing / 2;
    } else {
      sample.gradient = gradient_in_face(p.face);
      sample.is_beyond_boundary = sample.boundary_distance <= boundary_tolerance * spacing &&
                                  tangential_distance > boundary_tolerance * spacing;
    }
    for(int k = 0; k < 3; ++k)
      sample.color[k] = std::clamp(color[k], 0., 1.);
  }

  /// of the linear interpolant of the colors in a triangle
  Eigen::Matrix3d gradient_in_face(std::size_t face) const {
    const Eigen::Matrix3d of_hats = internal::hat_gradients(surface, face);
    const auto color = [&](int corner) {
      return internal::eigen_vector(colors[surface.triangle(face)[corner]]);
    };
    return of_hats.col(1) * (color(1) - color(0)).transpose() +
           of_hats.col(2) * (color(2) - color(0)).transpose();
  }

  Triangulated_surface_3 surface;
  std::vector<Rgb_color> colors;
  Point_3 viewpoint;
  internal::Scan_search search;
  std::vector<Vector_3> normals;
  std::vector<double> boundary_distances;
  std::vector<Eigen::Matrix3d> point_gradients; // of a point set
  double spacing = 0;
};

CGAL_RESTRICTED_LAPLACIAN_3_INLINE
Colored_scan::Colored_scan(const Triangulated_surface_3& surface, std::vector<Rgb_color> colors,
                           const Scan_pose& pose, const Point_3& viewpoint, bool is_parallel)
  : m_data(std::make_shared<const Data>(
        internal::placed(surface, internal::checked_pose(pose)),
        internal::checked_colors(std::move(colors), surface.number_of_vertices()),
        internal::checked_pose(pose).transform(internal::checked_viewpoint(viewpoint)),
        is_parallel)) {}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE const Triangulated_surface_3& Colored_scan::surface() const {
  return m_data->surface;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE const std::vector<Rgb_color>& Colored_scan::colors() const {
  return m_data->colors;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE const Point_3& Colored_scan::viewpoint() const {
  return m_data->viewpoint;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE double Colored_scan::spacing() const { return m_data->spacing; }

CGAL_RESTRICTED_LAPLACIAN_3_INLINE const std::vector<Vector_3>& Colored_scan::normals() const {
  return m_data->normals;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE const std::vector<double>&
Colored_scan::boundary_distances() const {
  return m_data->boundary_distances;
}

CGAL_RESTRICTED_LAPLACIAN_3_INLINE bool Colored_scan::Sampler::operator()(const Point_3& location,
                                                                          double maximum_distance,
                                                                          Scan_sample& sample) {
  const auto nearest = m_data->search.find(location, maximum_distance, m_hint);
  if(nearest)
    m_data->sample_at(m_data->surface.surface_point(*nearest), location, sample);
  return nearest.has_value();
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_TEXTURES_COLORED_SCAN_IMPL_H
