// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_TRIANGULATED_SURFACE_3_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_TRIANGULATED_SURFACE_3_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/Shared_array.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/compiled.h>
#include <CGAL/Restricted_laplacian_3/surface/Surface_location.h>
#include <CGAL/Restricted_laplacian_3/surface/Surface_patches.h>

#include <CGAL/assertions.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {

namespace internal {

/// \throws Invalid_point_error unless the coordinates are finite, and the normal is and not zero
void check_oriented_point(std::size_t i, const Point_3& point, const Vector_3& normal);

/// \throws Parameter_error unless so many faces and vertices can be numbered
void check_size_of_surface(std::size_t vertices, std::size_t faces);

/// Some of the triangles or points of a surface, whose bounding box is known: what takes part in
/// work that is divided. Normals and areas are those of points, and empty for triangles.
struct Part_of_surface {
  std::vector<Point_3> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<Vector_3> normals;
  std::vector<double> areas;
  bool is_point_set = false;
  /// of the whole surface
  Point_3 low, high;
};

/// Which polygons of a caller the triangles of a surface are parts of, if not each is one.
struct Polygons_of_surface {
  /// number of the polygon, for each triangle, ascending
  std::vector<std::uint32_t> numbers;
  /// positions of its corners among those of the polygon, for each triangle
  std::vector<std::array<std::uint32_t, 3>> corners;
  /// number of corners, for each polygon
  std::vector<std::uint32_t> sizes;
};

/// a vector that is finite and not zero, divided by its length, however long or short it is
Vector_3 unit_vector(const Vector_3& v);

/// Two unit vectors that are orthogonal to a unit vector and to each other; with it they form a
/// right-handed system.
std::array<Vector_3, 2> tangent_axes(const Vector_3& normal);

} // namespace internal

/// \ingroup PkgRestrictedLaplacian3Dev
/// The surface as all that follows sees it: points, index triples, unit normals and areas in double
/// precision, independent of the type of the mesh that it was read from.
///
/// It may also be given by oriented points, each with the area that it stands for. Such a point is
/// a face whose three corners are the point itself: face `i` and vertex `i` are point `i`, and a
/// function at a location on it is its value at the point. What needs more of a face than its
/// normal, its area and the values at its corners calls `require_triangles()`.
///
/// A surface of triangles may have a smooth patch on each face, see `curved_surface()`. Then points
/// at locations, normals there and areas are those of the patches; faces, corners and their normals
/// remain what they are.
///
/// Faces of a mesh or soup that have more than three corners are divided into triangles, which are
/// the faces here; `polygon()` tells which they are parts of.
///
/// Copies share all that is large: they cost nothing. A face takes 20 bytes, a vertex 24.
class Triangulated_surface_3 {
public:
  /// numbers of the three vertices of a triangle, counted from 0
  using Triangle = std::array<std::uint32_t, 3>;

  /// A triangle whose height over its longest side is below this fraction of that side is
  /// degenerate: the position of its third corner relative to the side is then rounding error of
  /// the coordinates (16 units in the last place of the side), and so is its normal.
  static constexpr double degenerate_height_tolerance = 3.6e-15;

  /// Longest side of the bounding box that is accepted: squares (areas) must neither overflow nor
  /// become subnormal.
  static constexpr double largest_extent = 1e100;
  /// shortest longest side of the bounding box that is accepted, for the same reason
  static constexpr double smallest_extent = 1e-100;

  /// Largest number of faces, and of vertices: the sides of faces are numbered with 32 bits.
  static constexpr std::size_t maximum_number_of_faces = 0xffffffff / 3;

  /// The triangles need not form a manifold, nor be oriented alike, nor differ from each other.
  /// \throws Empty_surface_error, Zero_area_error
  /// \throws Invalid_face_error a face names a vertex that does not exist
  /// \throws Invalid_vertex_error a vertex of a face is not finite
  /// \throws Parameter_error the extent is outside of `smallest_extent` to `largest_extent`, or
  /// there are more than `maximum_number_of_faces` faces or vertices
  Triangulated_surface_3(std::vector<Point_3> points, std::vector<Triangle> triangles);

  /// Oriented points. Points may coincide; normals need not have unit length, and are divided by
  /// their length here.
  /// \param points the points; their number is that of vertices and faces
  /// \param normals a normal for each point, of any length but 0
  /// \param areas the area that each point stands for, at least 0, in units of squared coordinates:
  /// areas of other units would change the weight of the stabilization, and with it the results
  /// \throws Empty_surface_error
  /// \throws Invalid_point_error names the first point that cannot be used
  /// \throws Zero_area_error all points are the same, or all areas 0
  /// \throws Parameter_error the extent is outside of `smallest_extent` to `largest_extent`, the
  /// sum of the areas is infinite, or the three vectors differ in length
  Triangulated_surface_3(std::vector<Point_3> points, std::vector<Vector_3> normals,
                         std::vector<double> areas);

  /// \cond
  // A part, of which there is at least one face; it may have area zero. Bounding box and extent are
  // those of the whole surface, so all that is computed for a face is as there.
  explicit Triangulated_surface_3(internal::Part_of_surface&& part);
  /// \endcond

  /// whether the surface is given by points
  bool is_point_set() const { return m_is_point_set; }

  /// whether the triangles are parts of polygons, some of which have more than three corners
  bool has_polygons() const { return m_polygons != nullptr; }
  /// Number of the face, of the mesh or soup that the surface was read from, that a face is a part
  /// of: of the same one, unless `has_polygons()`.
  std::uint32_t polygon(std::size_t face) const {
    CGAL_precondition(face < number_of_faces());
    return m_polygons ? m_polygons->numbers[face] : static_cast<std::uint32_t>(face);
  }
  /// number of faces of the mesh or soup
  std::size_t number_of_polygons() const {
    return m_polygons ? m_polygons->sizes.size() : number_of_faces();
  }
  /// number of corners of a face of the mesh or soup
  std::size_t size_of_polygon(std::size_t polygon) const {
    CGAL_precondition(polygon < number_of_polygons());
    return m_polygons ? m_polygons->sizes[polygon] : 3;
  }
  /// position of a corner of a face among those of its polygon
  std::size_t corner_of_polygon(std::size_t face, int corner) const {
    CGAL_precondition(face < number_of_faces() && corner >= 0 && corner < 3);
    return m_polygons ? m_polygons->corners[face][corner] : static_cast<std::size_t>(corner);
  }
  /// \cond
  void set_polygons(internal::Polygons_of_surface&& polygons) {
    m_polygons = std::make_shared<const internal::Polygons_of_surface>(std::move(polygons));
  }
  void set_polygons(const Triangulated_surface_3& other) { m_polygons = other.m_polygons; }
  /// \endcond

  /// \param who what cannot do without faces, for the message
  /// \throws Input_error if the surface is given by points
  void require_triangles(const std::string& who) const;

  /// number of points, also of those that no face uses
  std::size_t number_of_vertices() const { return m_points.size(); }
  /// number of triangles, degenerate ones included; of a point set, number of points
  std::size_t number_of_faces() const { return m_triangles.size(); }

  /// number of faces of area zero, up to `degenerate_height_tolerance`. They are left out of all
  /// integrals.
  std::size_t number_of_degenerate_faces() const { return m_number_of_degenerate_faces; }

  /// the point of a vertex
  const Point_3& point(std::size_t vertex) const {
    CGAL_precondition(vertex < m_points.size());
    return m_points[vertex];
  }
  /// the point of a corner of a face; `corner` is 0, 1 or 2
  const Point_3& point(std::size_t face, int corner) const {
    CGAL_precondition(corner >= 0 && corner < 3);
    return m_points[triangle(face)[corner]];
  }
  /// the vertices of a face
  const Triangle& triangle(std::size_t face) const {
    CGAL_precondition(face < m_triangles.size());
    return m_triangles[face];
  }

  /// Unit normal, of a triangle by the right-hand rule; the zero vector if it is degenerate. Those
  /// of triangles are not stored, but computed when they are asked for.
  Vector_3 normal(std::size_t face) const {
    CGAL_precondition(face < number_of_faces());
    return m_is_point_set ? m_normals[face] : scaled_normal(face).normal;
  }
  /// whether the area of a triangle is zero, up to `degenerate_height_tolerance`; points are not
  /// degenerate
  bool is_degenerate(std::size_t face) const { return area(face) == 0 && !m_is_point_set; }

  /// area of a face, of its patch if it has one; 0 if it is degenerate
  double area(std::size_t face) const {
    CGAL_precondition(face < m_areas.size());
    return m_areas[face];
  }
  /// area of the surface
  double area() const { return m_area; }

  /// lower corner of the bounding box of the vertices that have a face
  const Point_3& bounding_box_min() const { return m_min; }
  /// upper corner of that bounding box
  const Point_3& bounding_box_max() const { return m_max; }
  /// center of that bounding box
  Point_3 center() const {
    return {m_min.x() / 2 + m_max.x() / 2, m_min.y() / 2 + m_max.y() / 2,
            m_min.z() / 2 + m_max.z() / 2};
  }
  /// longest side of the bounding box
  double extent() const { return m_extent; }

  /// whether the faces have patches
  bool is_smooth() const { return m_patches != nullptr; }
  /// the patches; requires `is_smooth()`
  const Surface_patches& patches() const {
    CGAL_precondition(is_smooth());
    return *m_patches;
  }
  /// Gives patches to the faces of a surface that has none, made for it; areas become those of the
  /// patches.
  void set_patches(std::shared_ptr<const Surface_patches> patches);

  /// The point at a location, with all that a `Surface_point` holds; on a smooth surface that of
  /// the patch, with the normal there.
  Surface_point surface_point(const Surface_location& location) const {
    Surface_point p;
    static_cast<Surface_location&>(p) = location;
    p.vertices = triangle(location.face);
    p.polygon = polygon(location.face);
    if(is_smooth() && !is_degenerate(location.face)) {
      set_patch_point(p);
      return p;
    }
    p.normal = normal(location.face);
    const Point_3 &a = m_points[p.vertices[0]], &b = m_points[p.vertices[1]],
                  &c = m_points[p.vertices[2]];
    p.point = internal::point_of_triangle(a, b, c, location.barycentric);
    return p;
  }

private:
  /// unit normal, and area in units of the squared extent; both 0 if a triangle is degenerate
  struct Scaled_normal {
    Vector_3 normal;
    double area;
  };
  Scaled_normal scaled_normal(std::size_t face) const;

  void compute_bounding_box();
  void set_bounding_box(const Point_3& low, const Point_3& high);

  void compute_areas();

  Zero_area_error zero_area_error() const;

  /// sets point and normal by the patch
  void set_patch_point(Surface_point& p) const;

  internal::Shared_array<Point_3> m_points;
  internal::Shared_array<Triangle> m_triangles;
  internal::Shared_array<Vector_3> m_normals; // of points
  internal::Shared_array<double> m_areas;
  Point_3 m_min, m_max;
  double m_extent = 0;
  double m_area = 0;
  std::size_t m_number_of_degenerate_faces = 0;
  bool m_is_point_set = false;
  std::shared_ptr<const Surface_patches> m_patches;
  std::shared_ptr<const internal::Polygons_of_surface> m_polygons;
};

// Inline, because it is called for each fragment of a face.
inline Triangulated_surface_3::Scaled_normal
Triangulated_surface_3::scaled_normal(std::size_t face) const {
  const Triangle& t = m_triangles[face];
  const double scale = 1 / m_extent;
  // The cross product is most accurate from the corner opposite to the longest side.
  std::array<Vector_3, 3> side;
  std::array<double, 3> squared;
  for(int i = 0; i < 3; ++i) {
    side[i] = (m_points[t[(i + 2) % 3]] - m_points[t[(i + 1) % 3]]) * scale;
    squared[i] = side[i].squared_length();
  }
  int corner = squared[1] > squared[0] ? 1 : 0;
  corner = squared[2] > squared[corner] ? 2 : corner;
  const Vector_3 product = CGAL::cross_product(side[(corner + 2) % 3], -side[(corner + 1) % 3]);
  const double length = std::sqrt(product.squared_length());
  // length = longest side x height over it
  if(!(length > degenerate_height_tolerance * squared[corner]))
    return {Vector_3(0, 0, 0), 0};
  return {product / length, length / 2};
}

namespace internal {

/// the point in the middle of a face
inline Surface_point center_of_face(const Triangulated_surface_3& surface, std::size_t face) {
  Surface_location center;
  center.face = face;
  center.barycentric.fill(1. / 3);
  return surface.surface_point(center);
}

} // namespace internal

} // namespace Restricted_laplacian_3
} // namespace CGAL

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_COMPILED
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3_impl.h>
#endif

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_TRIANGULATED_SURFACE_3_H
