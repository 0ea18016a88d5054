// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_PATCHES_CURVED_SURFACE_IMPL_H
#define CGAL_RESTRICTED_LAPLACIAN_3_PATCHES_CURVED_SURFACE_IMPL_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/patches/curved_surface.h>
#include <CGAL/Restricted_laplacian_3/patches/internal/Smooth_sectors.h>
#include <CGAL/Restricted_laplacian_3/surface/Surface_patches.h>
#include <CGAL/Restricted_laplacian_3/surface/shared/Corner_groups.h>
#include <CGAL/Restricted_laplacian_3/surface/shared/Surface_edges.h>
#include <CGAL/Restricted_laplacian_3/surface/vertex_normals.h>

#include <CGAL/Kernel/global_functions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// the deviations of the two inner control points of the curve over an edge, from its lower vertex
using Edge_curve = std::array<Vector_3, 2>;

/// The first inner control point of the cubic over an edge, less that of the edge: along a unit
/// tangent. Zero if the tangent is far from the edge.
inline Vector_3 tangent_deviation(const Vector_3& edge, const Vector_3& tangent) {
  constexpr double least_cosine = 0.5;
  const double length = std::sqrt(edge.squared_length()), cosine = edge * tangent / length;
  if(!(cosine > least_cosine))
    return {0, 0, 0};
  return tangent * (2 * length / (3 * (1 + cosine))) - edge / 3;
}

/// The deviation of the center of a patch, in the mean of three curves: each from a corner to the
/// middle of the side opposite to it, with the tangents that the normals there give.
/// \param sides the deviations of the control points of the sides, at corner `i` and at the next
inline Vector_3 center_deviation(const std::array<Point_3, 3>& corners,
                                 const std::array<Vector_3, 3>& normals,
                                 const std::array<Edge_curve, 3>& sides) {
  Vector_3 sum(0, 0, 0);
  for(int i = 0; i < 3; ++i) {
    const int a = (i + 1) % 3, b = (i + 2) % 3;
    const Vector_3 edge = corners[b] - corners[a], of_middle = 3. / 8 * (sides[a][0] + sides[a][1]),
                   tangent = unit_or_zero(edge + 3. / 4 * (sides[a][1] - sides[a][0])),
                   mean_normal = normals[a] + normals[b],
                   normal = unit_or_zero(mean_normal - (mean_normal * tangent) * tangent),
                   chord = corners[a] + edge / 2 + of_middle - corners[i];
    const auto tangential = [&chord](const Vector_3& n) {
      return unit_or_zero(chord - (chord * n) * n);
    };
    // a cubic at 2/3 of its length
    sum += 2. / 3 * of_middle + 2. / 9 * tangent_deviation(chord, tangential(normals[i])) -
           4. / 9 * tangent_deviation(chord, tangential(normal));
  }
  return sum / 3;
}

inline bool has_degenerate_face(const Triangulated_surface_3& surface, const Surface_edges& edges,
                                std::size_t edge) {
  for(const Surface_edges::Side& side : edges.sides(edge))
    if(surface.is_degenerate(side.face))
      return true;
  return false;
}

/// Makes the curves over the edges of a surface from normals and creases.
class Edge_curves {
public:
  Edge_curves(const Triangulated_surface_3& surface, const Surface_edges& edges,
              const Smooth_sectors& sectors, const std::vector<Vector_3>& normals)
    : m_surface(surface), m_edges(edges), m_sectors(sectors), m_normals(normals) {
    find_tangents_of_creases();
  }

  Edge_curve operator()(std::size_t edge) const {
    const auto [a, b] = m_edges.ends(edge);
    if(m_surface.point(a) == m_surface.point(b))
      return {Vector_3(0, 0, 0), Vector_3(0, 0, 0)};
    return {deviation(edge, a, b), deviation(edge, b, a)};
  }

private:
  void find_tangents_of_creases() {
    const std::size_t n = m_surface.number_of_vertices();
    std::vector<std::array<std::uint32_t, 2>> neighbors(n);
    std::vector<std::uint32_t> counts(n, 0);
    for(std::size_t edge = 0; edge < m_edges.size(); ++edge)
      if(m_sectors.is_crease(edge))
        for(int end = 0; end < 2; ++end) {
          const std::uint32_t v = m_edges.ends(edge)[end];
          if(counts[v] < 2)
            neighbors[v][counts[v]] = m_edges.ends(edge)[1 - end];
          ++counts[v];
        }
    m_crease_tangents.assign(n, Vector_3(0, 0, 0));
    for(std::size_t v = 0; v < n; ++v) {
      if(counts[v] != 2)
        continue;
      const Vector_3 before = m_surface.point(v) - m_surface.point(neighbors[v][0]),
                     after = m_surface.point(neighbors[v][1]) - m_surface.point(v);
      const double l1 = std::sqrt(before.squared_length()), l2 = std::sqrt(after.squared_length());
      if(before * after > m_sectors.crease_cosine() * l1 * l2)
        m_crease_tangents[v] = unit_or_zero(before * (l2 / l1) + after * (l1 / l2));
    }
  }

  /// at the end `a` of an edge
  Vector_3 deviation(std::size_t edge, std::uint32_t a, std::uint32_t b) const {
    const Vector_3 chord = m_surface.point(b) - m_surface.point(a);
    // the sectors of the faces at the edge
    std::array<std::size_t, 2> groups = {0, 0};
    int count = 0;
    for(const Surface_edges::Side& side : m_edges.sides(edge)) {
      if(m_surface.is_degenerate(side.face))
        continue;
      const std::size_t begin = side.number, end = (side.number + 1) % 3,
                        corner = m_surface.triangle(side.face)[begin] == a ? begin : end,
                        group = m_sectors.groups().corners[3 * side.face + corner].group;
      if(count > 0 && (group == groups[0] || (count == 2 && group == groups[1])))
        continue;
      if(count == 2)
        return {0, 0, 0};
      groups[count++] = group;
    }
    if(count == 0)
      return {0, 0, 0};
    if(m_sectors.is_crease(edge) && m_crease_tangents[a] != CGAL::NULL_VECTOR) {
      Vector_3 t = m_crease_tangents[a];
      for(int k = 0; k < count; ++k)
        if(m_sectors.is_in_plane(groups[k]))
          t -= (t * m_normals[groups[k]]) * m_normals[groups[k]];
      return tangent_deviation(chord, unit_or_zero(t * chord < 0 ? -t : t));
    }
    const Vector_3& n = m_normals[groups[0]];
    if(count == 1)
      return tangent_deviation(chord, unit_or_zero(chord - (chord * n) * n));
    constexpr double least_sine = 0.1;
    const Vector_3 cross = CGAL::cross_product(n, m_normals[groups[1]]);
    if(!(cross.squared_length() > least_sine * least_sine))
      return {0, 0, 0};
    return tangent_deviation(chord, unit_or_zero(cross * chord < 0 ? -cross : cross));
  }

  const Triangulated_surface_3& m_surface;
  const Surface_edges& m_edges;
  const Smooth_sectors& m_sectors;
  const std::vector<Vector_3>& m_normals;
  std::vector<Vector_3> m_crease_tangents; // the zero vector where there is none
};

/// Makes patches from normals and creases.
class Patches_by_normals {
public:
  Patches_by_normals(const Triangulated_surface_3& surface, const Surface_edges& edges,
                     const Smooth_geometry& geometry)
    : m_surface(surface), m_sectors(surface, edges, geometry), m_normals(m_sectors.normals()),
      m_curves(surface, edges, m_sectors, m_normals) {}

  Edge_curve edge(std::size_t edge) const { return m_curves(edge); }

  /// of a face whose sides have these curves
  Vector_3 center(std::size_t face, const std::array<Edge_curve, 3>& sides) const {
    std::array<Vector_3, 3> normals;
    for(int i = 0; i < 3; ++i) {
      const Corner_groups::Corner& corner = m_sectors.groups().corners[3 * face + i];
      normals[i] = corner.sign * m_normals[corner.group];
    }
    return center_deviation(
        {m_surface.point(face, 0), m_surface.point(face, 1), m_surface.point(face, 2)}, normals,
        sides);
  }

private:
  const Triangulated_surface_3& m_surface;
  Smooth_sectors m_sectors;
  std::vector<Vector_3> m_normals;
  Edge_curves m_curves;
};

/// the projections of points
/// \throws Parameter_error if it returns another number of points
inline std::vector<Point_3> projected(const std::vector<Point_3>& points,
                                      const Smooth_geometry& geometry) {
  std::vector<Point_3> result = geometry.projection(points);
  if(result.size() != points.size())
    throw Parameter_error("geometry", "returns " + std::to_string(result.size()) + " points for " +
                                          std::to_string(points.size()));
  return result;
}

/// Makes patches that interpolate a projection: at the thirds of the edges, and at the centers.
class Patches_by_projection {
public:
  Patches_by_projection(const Triangulated_surface_3& surface, const Surface_edges& edges,
                        const Smooth_geometry& geometry) {
    std::vector<Point_3> points;
    std::vector<std::size_t> faces; // that points belong to
    const auto add = [&](std::size_t face, const Point_3& p) {
      points.push_back(p);
      faces.push_back(face);
    };
    for(std::size_t edge = 0; edge < edges.size(); ++edge) {
      m_first_of_edges.push_back(points.size());
      if(has_degenerate_face(surface, edges, edge))
        continue;
      const Point_3 &a = surface.point(edges.ends(edge)[0]),
                    &b = surface.point(edges.ends(edge)[1]);
      add(edges.sides(edge).front().face, a + (b - a) / 3);
      add(edges.sides(edge).front().face, b - (b - a) / 3);
    }
    for(std::size_t face = 0; face < surface.number_of_faces(); ++face) {
      m_of_faces.push_back(points.size());
      if(!surface.is_degenerate(face))
        add(face,
            CGAL::centroid(surface.point(face, 0), surface.point(face, 1), surface.point(face, 2)));
    }
    const std::vector<Point_3> found = projected(points, geometry);
    m_deviations.reserve(points.size());
    for(std::size_t i = 0; i < points.size(); ++i) {
      for(int axis = 0; axis < 3; ++axis)
        if(!std::isfinite(found[i][axis]))
          throw Invalid_face_error(surface.polygon(faces[i]),
                                   "has a point whose projection is not finite");
      m_deviations.push_back(found[i] - points[i]);
    }
  }

  /// of an edge without degenerate faces
  Edge_curve edge(std::size_t edge) const {
    const Vector_3 &first = m_deviations[m_first_of_edges[edge]],
                   &second = m_deviations[m_first_of_edges[edge] + 1];
    return {3 * first - 1.5 * second, 3 * second - 1.5 * first};
  }

  /// of a face that is not degenerate
  Vector_3 center(std::size_t face, const std::array<Edge_curve, 3>&) const {
    return m_deviations[m_of_faces[face]];
  }

private:
  std::vector<std::size_t> m_first_of_edges, m_of_faces; // in m_deviations
  std::vector<Vector_3> m_deviations;
};

/// whether the patch of a face would fold
inline bool folds(const Triangulated_surface_3& surface, std::size_t face,
                  const Surface_patches::Controls& controls) {
  // Area against the orientation of the face, or far less or more of it, at points of a grid.
  constexpr int grid = 4;
  constexpr double least_ratio = 0.2, largest_ratio = 5;
  // Derivatives along the sides change by at most six times the longest control: mostly too little.
  const Vector_3 u = surface.point(face, 1) - surface.point(face, 0),
                 v = surface.point(face, 2) - surface.point(face, 0);
  double longest = 0;
  for(const Vector_3& control : controls)
    longest = (std::max)(longest, control.squared_length());
  const double change = 6 * std::sqrt(longest),
               sides = std::sqrt(u.squared_length()) + std::sqrt(v.squared_length());
  if(change * (sides + change) < surface.area(face)) // half of |u x v|
    return false;
  const Surface_patches patch({controls}, 0);
  const std::array<Point_3, 3> corners = {surface.point(face, 0), surface.point(face, 1),
                                          surface.point(face, 2)};
  for(int i = 0; i <= grid; ++i)
    for(int j = 0; i + j <= grid; ++j) {
      const double x = i / double(grid), y = j / double(grid);
      const Patch_point p = patch.evaluate(0, corners, {x, y, 1 - x - y});
      const double ratio = p.area / surface.area(face);
      if(!(ratio * (p.normal * surface.normal(face)) >= least_ratio && ratio <= largest_ratio))
        return true;
    }
  return false;
}

/// \param make the deviations of the curve over an edge, and of the center of a face
template <class Maker>
Surface_patches make_patches(const Triangulated_surface_3& surface, const Surface_edges& edges,
                             const Maker& make) {
  const Vector_3 zero(0, 0, 0);
  // What is below this fraction of an edge is rounding error of coordinates.
  constexpr double flat_tolerance = 1e-6;
  const auto set_to_zero_if_tiny = [&](Vector_3& d, double squared_length) {
    if(!(d.squared_length() > flat_tolerance * flat_tolerance * squared_length))
      d = zero;
  };
  std::vector<Edge_curve> curves(edges.size());
  std::vector<std::array<std::uint32_t, 3>> edges_of_faces(surface.number_of_faces());
  for(std::size_t edge = 0; edge < edges.size(); ++edge) {
    for(const Surface_edges::Side& side : edges.sides(edge))
      edges_of_faces[side.face][side.number] = static_cast<std::uint32_t>(edge);
    curves[edge] =
        has_degenerate_face(surface, edges, edge) ? Edge_curve{zero, zero} : make.edge(edge);
    const auto [a, b] = edges.ends(edge);
    for(Vector_3& d : curves[edge])
      set_to_zero_if_tiny(d, (surface.point(b) - surface.point(a)).squared_length());
  }

  std::vector<char> is_flat_inside(surface.number_of_faces());
  for(std::size_t face = 0; face < is_flat_inside.size(); ++face)
    is_flat_inside[face] = surface.is_degenerate(face);
  const auto controls_of = [&](std::size_t face) {
    Surface_patches::Controls c;
    std::array<Edge_curve, 3> sides;
    Vector_3 sum = zero;
    for(int i = 0; i < 3; ++i) {
      const std::uint32_t edge = edges_of_faces[face][i];
      const bool is_ascending = edges.ends(edge)[0] == surface.triangle(face)[i];
      for(int k = 0; k < 2; ++k) {
        c[2 * i + k] = sides[i][k] = curves[edge][is_ascending ? k : 1 - k];
        sum += sides[i][k];
      }
    }
    c[6] = zero;
    if(!is_flat_inside[face]) {
      c[6] = 4.5 * make.center(face, sides) - sum / 2;
      set_to_zero_if_tiny(c[6], surface.area(face));
    }
    return c;
  };

  // A face that folds takes its edges with it, and these may make neighbors fold.
  std::vector<Surface_patches::Controls> controls(surface.number_of_faces());
  std::size_t number_of_folded_faces = 0;
  std::vector<std::uint32_t> to_do(surface.number_of_faces());
  std::iota(to_do.begin(), to_do.end(), 0u);
  while(!to_do.empty()) {
    std::vector<std::uint32_t> next;
    for(std::uint32_t face : to_do) {
      controls[face] = controls_of(face);
      if(is_flat_inside[face] || !folds(surface, face, controls[face]))
        continue;
      is_flat_inside[face] = 1;
      ++number_of_folded_faces;
      next.push_back(face);
    }
    const std::vector<std::uint32_t> folded = next;
    for(std::uint32_t face : folded)
      for(std::uint32_t edge : edges_of_faces[face]) {
        curves[edge] = {zero, zero};
        for(const Surface_edges::Side& side : edges.sides(edge))
          next.push_back(side.face);
      }
    std::sort(next.begin(), next.end());
    next.erase(std::unique(next.begin(), next.end()), next.end());
    to_do.swap(next);
  }
  return Surface_patches(std::move(controls), number_of_folded_faces);
}

} // namespace internal

CGAL_RESTRICTED_LAPLACIAN_3_INLINE Triangulated_surface_3
curved_surface(Triangulated_surface_3 surface, const Smooth_geometry& geometry) {
  surface.require_triangles("a smooth geometry");
  if(geometry.projection) {
    std::vector<Point_3> points;
    std::vector<Triangulated_surface_3::Triangle> triangles;
    for(std::size_t v = 0; v < surface.number_of_vertices(); ++v)
      points.push_back(surface.point(v));
    points = internal::projected(points, geometry);
    for(std::size_t f = 0; f < surface.number_of_faces(); ++f)
      triangles.push_back(surface.triangle(f));
    Triangulated_surface_3 result(std::move(points), std::move(triangles));
    result.set_polygons(surface);
    surface = std::move(result);
  }
  const internal::Surface_edges edges(surface);
  surface.set_patches(std::make_shared<const Surface_patches>(
      geometry.projection
          ? internal::make_patches(surface, edges,
                                   internal::Patches_by_projection(surface, edges, geometry))
          : internal::make_patches(surface, edges,
                                   internal::Patches_by_normals(surface, edges, geometry))));
  return surface;
}

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_PATCHES_CURVED_SURFACE_IMPL_H
