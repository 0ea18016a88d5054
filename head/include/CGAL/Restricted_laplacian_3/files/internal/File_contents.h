// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_FILES_INTERNAL_FILE_CONTENTS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_FILES_INTERNAL_FILE_CONTENTS_H

#include <CGAL/Restricted_laplacian_3/files/Vertex_property.h>
#include <CGAL/Restricted_laplacian_3/surface/Surface_location.h>
#include <CGAL/Restricted_laplacian_3/surface/Triangulated_surface_3.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// What a file says of a mesh, or of points, in its order.
class File_contents {
public:
  using Triangle = Triangulated_surface_3::Triangle;
  using Polygon = std::vector<std::uint32_t>;

  /// \param wants_properties whether properties of vertices are kept
  explicit File_contents(bool wants_properties) : m_wants_properties(wants_properties) {}

  static constexpr std::uintmax_t maximum_number =
      (std::numeric_limits<std::uint32_t>::max)() - std::uintmax_t(1);

  std::vector<Point_3> points;
  /// the faces, if all are triangles; otherwise none
  std::vector<Triangle> triangles;
  /// the faces, if one of them is no triangle; otherwise none
  std::vector<Polygon> polygons;
  /// empty if they are not wanted
  std::vector<Vertex_property> properties;
  /// what was passed over
  std::vector<std::string> warnings;

  bool wants_properties() const { return m_wants_properties; }
  std::size_t number_of_faces() const { return triangles.size() + polygons.size(); }

  /// appends a face of at least three corners
  void add_face(const std::uint32_t* corners, std::size_t number) {
    if(number == 3 && polygons.empty()) {
      triangles.push_back({corners[0], corners[1], corners[2]});
      return;
    }
    if(polygons.empty()) {
      for(const Triangle& t : triangles)
        polygons.emplace_back(t.begin(), t.end());
      std::vector<Triangle>().swap(triangles);
    }
    polygons.emplace_back(corners, corners + number);
  }

private:
  bool m_wants_properties;
};

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_FILES_INTERNAL_FILE_CONTENTS_H
