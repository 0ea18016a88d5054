// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SURFACE_LOCATION_H
#define CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SURFACE_LOCATION_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace CGAL {
namespace Restricted_laplacian_3 {

namespace internal {

/// the kernel in which the package computes
using Double_kernel = CGAL::Simple_cartesian<double>;

} // namespace internal

/// \ingroup PkgRestrictedLaplacian3Functions
/// The points with which this package computes, those of `CGAL::Simple_cartesian<double>`. Points
/// of other kernels are converted with `CGAL::to_double()`.
using Point_3 = CGAL::Simple_cartesian<double>::Point_3;
/// \ingroup PkgRestrictedLaplacian3Functions
/// the vectors that belong to them
using Vector_3 = CGAL::Simple_cartesian<double>::Vector_3;

namespace internal {

/// the point of a triangle that has these barycentric coordinates
inline Point_3 point_of_triangle(const Point_3& a, const Point_3& b, const Point_3& c,
                                 const std::array<double, 3>& barycentric) {
  const auto& l = barycentric;
  return Point_3(l[0] * a.x() + l[1] * b.x() + l[2] * c.x(),
                 l[0] * a.y() + l[1] * b.y() + l[2] * c.y(),
                 l[0] * a.z() + l[1] * b.z() + l[2] * c.z());
}

} // namespace internal

/// \ingroup PkgRestrictedLaplacian3Functions
/// A location on the surface: a face and barycentric coordinates in it.
struct Surface_location {
  /// position of the face in the iteration over `faces(tm)`, counted from 0
  std::size_t face = 0;
  /// coordinates with respect to the vertices `source(h)`, `target(h)`, `target(next(h))`, where
  /// `h = halfedge(f, tm)`: the convention of \cgal's `PMP::Barycentric_coordinates`
  std::array<double, 3> barycentric = {1, 0, 0};
};

/// \ingroup PkgRestrictedLaplacian3Functions
/// A location on the surface with what a function of it may need. Functions and vector fields are
/// given to the package as function objects on `const Surface_point&`.
struct Surface_point : Surface_location {
  /// positions of the face's vertices in the iteration over `vertices(tm)`
  std::array<std::uint32_t, 3> vertices = {0, 0, 0};
  /// number of the face of the mesh or soup that the face, a triangle, is a part of, see
  /// `Triangulated_surface_3::polygon()`
  std::uint32_t polygon = 0;
  /// coordinates of the location
  Point_3 point;
  /// unit normal of the face, by the right-hand rule
  Vector_3 normal;
};

/// \cond SKIP_IN_MANUAL
/// \ingroup PkgRestrictedLaplacian3Functions
/// Converts locations of \cgal (face descriptor and barycentric coordinates) to `Surface_location`.
/// Construction is linear in the number of faces, conversion takes constant time.
template <class FaceGraph> class Surface_location_converter {
  using Face = typename boost::graph_traits<FaceGraph>::face_descriptor;
  using Index_map =
      typename boost::property_map<FaceGraph,
                                   CGAL::dynamic_face_property_t<std::size_t>>::const_type;

public:
  /// \param tm a mesh of triangles; is read here only
  /// \throws Invalid_face_error if a face is not a triangle
  explicit Surface_location_converter(const FaceGraph& tm)
    : m_index(get(CGAL::dynamic_face_property_t<std::size_t>(), tm)) {
    std::size_t i = 0;
    for(Face f : faces(tm)) {
      const auto h = halfedge(f, tm);
      if(next(next(next(h, tm), tm), tm) != h)
        throw Invalid_face_error(i, "is not a triangle, but barycentric coordinates refer to one");
      put(m_index, f, i++);
    }
  }

  /// a face and barycentric coordinates with respect to the vertices that `Surface_location` names
  Surface_location operator()(Face f, const std::array<double, 3>& barycentric) const {
    Surface_location location;
    location.face = get(m_index, f);
    location.barycentric = barycentric;
    return location;
  }

  /// the same as a pair, the form of \cgal's `PMP::Face_location`; coordinates are converted with
  /// `CGAL::to_double()`
  template <class FT>
  Surface_location operator()(const std::pair<Face, std::array<FT, 3>>& location) const {
    return (*this)(location.first,
                   {CGAL::to_double(location.second[0]), CGAL::to_double(location.second[1]),
                    CGAL::to_double(location.second[2])});
  }

private:
  Index_map m_index;
};
/// \endcond

} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_SURFACE_SURFACE_LOCATION_H
